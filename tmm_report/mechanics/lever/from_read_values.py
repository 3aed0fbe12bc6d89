"""Steps of a solution taken anew from numbers that need not be its own: one group at a time, everything else given.

A group above class II cannot be followed from its own rates alone: `place`, `velocities` and `accelerations` solve it
for known links that stand and move otherwise than in the motion it was followed over. Arrays are (..., P), SI.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.dyads import Dyad, State
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.forces.reactions import Load, Reaction
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.loop_equations import newton, solve_each

Array = Any
Group = Dyad | HigherGroup


def place(s: State, group: Group) -> None:
    """Add the poses of the links to the state; nan where the group cannot be assembled. Of a group above class II
    the assembly is that of its branch at the driver's angle `s.phi`, however the known links stand."""
    with np.errstate(invalid="ignore", divide="ignore"):
        if isinstance(group, Dyad):
            group.place(s)
        else:
            group.loops.place(s, newton(group.loops, s, group.branches[0].guess(np.asarray(s.phi))))


def velocities(s: State, group: HigherGroup) -> Array:
    """Add the velocities of the links to the state, from those of the known links; the rates of q, (..., P, k)."""
    loops = group.loops
    q = loops.read(s)
    rate = -solve_each(loops.jacobian(s, q), loops.known_rate(s, q))
    loops.move(s)
    return rate


def accelerations(s: State, group: HigherGroup, rate: Array) -> None:
    """Add the angular accelerations of the links and the accelerations of their reference points to the state.

    Normal and Coriolis accelerations are those of `rate`, which need not be what the known links make of it.
    """
    loops = group.loops
    q = loops.read(s)
    second = -solve_each(loops.jacobian(s, q), loops.bend(s, q, rate))
    for link in group.links:
        root = loops.directions[link].root
        if isinstance(root, int):
            s.turn(link, rate[..., root], second[..., root])
        else:
            s.turn_with(link, root)
    known = loops._known(s, loops._links, q.shape[:-1], 2)
    second_of = loops._second(s, loops.vectors(s, q), rate, second)
    bent = known + loops._sum(*second_of, loops._links)
    for k, link in enumerate(group.links):
        s.a[link] = bent[k]


def balance(s: State, group: Group, loads: Mapping[str, Load]) -> tuple[Reaction, ...]:
    """Reactions of a group under the loads of its links, the outer ones first."""
    with np.errstate(invalid="ignore", divide="ignore"):
        outer, inner = statics._solve_group(s, group, loads)
    return (*outer, *inner)


def passed_on(s: State, load: Load, reaction: Reaction) -> Load:
    """The load of the link on which a solved group hangs, with the group's outer reaction turned round."""
    rest = {reaction.pair.links[0]: load}
    statics._pass_on(s, rest, reaction)
    return rest[reaction.pair.links[0]]
