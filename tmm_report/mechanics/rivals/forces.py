"""Forces of a mechanism in several ways: groups, one system for all links, virtual work, force plans.

All take the same motion, that by groups, and the same loads; only what is done with them differs. (Artobolevsky,
Theory of mechanisms and machines, ch. 13; Levitsky, ch. 7; Nikravesh, Computer-aided analysis of mechanical systems)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.forces.reactions import Load, Reaction, Statics
from tmm_report.mechanics.lever.loop_equations import solve_each
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.force_plans import no_plans, plans
from tmm_report.mechanics.rivals.model import ForceMethod, Loaded, Method
from tmm_report.mechanics.rivals.paper import ACCURACIES
from tmm_report.problems import N_

Array = Any
Loads = Mapping[str, Load]


def groups(motion: Motion, loads: Loads) -> Statics:
    """The program's own way: group by group from the farthest, of a dyad in closed form."""
    return statics.solve(motion, loads)


# ---------------------------------------------------------------- one system for all links


def system(motion: Motion, loads: Loads) -> Statics:
    """Three equations of equilibrium for each of n moving links, moments about its reference point and over the size of
    the mechanism: two unknowns of every pair and the balancing moment, 2p + 1 = 3n. Knows nothing of groups.

    Unknown of a pivot is the force of its first link on the second, of a guide the normal force and the moment."""
    with np.errstate(invalid="ignore", divide="ignore"):
        A, b, size = _equations(motion, loads)
        return _read(motion, solve_each(A, b), size)


def _equations(motion: Motion, loads: Loads) -> tuple[Array, Array, float]:
    s, scheme, pairs = motion.state, motion.linkage.mechanism, motion.linkage.structure.pairs
    rows = {link: 3 * k for k, link in enumerate(scheme.moving)}
    count, size = 3 * len(rows), _size(motion)
    A, b = np.zeros((*motion.shape, count, count)), np.zeros((*motion.shape, count))
    for link, k in rows.items():
        load = loads[link]
        b[..., k], b[..., k + 1], b[..., k + 2] = -load.force.real, -load.force.imag, -load.moment / size
    for n, pair in enumerate(pairs):
        for row, column, coefficient in _coefficients(s, pair, rows, size):
            A[..., row, 2 * n + column] = coefficient
    A[..., rows[scheme.driver.link] + 2, -1] = 1.0
    return A, b, size


def _size(motion: Motion) -> float:
    """Of the mechanism, m: the largest distance of a point from its link's origin."""
    links = motion.linkage.mechanism.links.values()
    sizes = (np.max(np.abs(at)) for link in links for at in link.points.values())
    return float(max(sizes, default=0.0)) or 1.0


def _coefficients(
    s: State, pair: Pair, rows: Mapping[str, int], size: float
) -> Iterator[tuple[int, int, Array]]:
    """Row, column (0 or 1 of the pair) and value of what the pair adds to the equations of its moving links."""
    at, along = _place(s, pair)
    units = (1 + 0j, 1j) if along is None else (1j * along,)
    for sign, link in zip((-1, 1), pair.links, strict=True):
        if link == FRAME:
            continue
        k = rows[link]
        for column, unit in enumerate(units):
            yield k, column, sign * np.real(unit)
            yield k + 1, column, sign * np.imag(unit)
            yield k + 2, column, sign * cross(at - s.r[link], unit) / size
        if along is not None:
            yield k + 2, 1, float(sign)


def _read(motion: Motion, x: Array, size: float) -> Statics:
    """Reactions and the balancing moment from the solution (..., P, 2p + 1)."""
    s, structure = motion.state, motion.linkage.structure
    reactions = {}
    for n, pair in enumerate(structure.pairs):
        at, along = _place(s, pair)
        first, second = x[..., 2 * n], x[..., 2 * n + 1]
        force, couple = (first + 1j * second, 0.0) if along is None else (first * 1j * along, second * size)
        reactions[pair.key] = Reaction(pair, force, couple, at, along)
    moment, driver = x[..., -1] * size, motion.linkage.mechanism.driver
    if driver.gear:  # in place of the moment the teeth push, in the frame's reaction as with groups
        whole = reactions[structure.driver_pair.key]
        pushed = driver.gear.force(moment, driver.omega)
        reactions[structure.driver_pair.key] = Reaction(whole.pair, whole.force - pushed, 0.0, whole.at)
    return Statics(reactions, moment)


def _place(s: State, pair: Pair) -> tuple[Array, Array | None]:
    """World place at which a pair's reaction is taken, and of a guide its direction."""
    at = s.world(pair.slider or pair.links[1], pair.at[pair.slider or pair.links[1]])
    carrier = pair.other(pair.slider)
    return at, None if pair.kind == "R" else s.u[carrier] * pair.along[carrier]


# ---------------------------------------------------------------- virtual work


def virtual_work(motion: Motion, loads: Loads) -> Statics:
    """The balancing moment alone: with ideal pairs the powers of all loads, inertia among them, and its own are nothing
    together. No reaction is found."""
    s = motion.state
    power = np.zeros(motion.shape)
    for link, load in loads.items():
        power = power + dot(load.force, s.v[link] + 0j) + load.moment * s.w[link]
    with np.errstate(invalid="ignore", divide="ignore"):
        return Statics({}, -power / s.w[motion.linkage.mechanism.driver.link])


# ---------------------------------------------------------------- the methods


def _run(way: Any, scene: Loaded, count: int) -> Statics:
    motion = scene.cycle.motion(scene.cycle.once(count))
    found: Statics = way(motion, scene.loads(motion))
    return found


FORCES: tuple[ForceMethod, ...] = (
    Method("groups", N_("groups, from the farthest one"), partial(_run, groups)),
    Method("system", N_("one system of equations for all links"), partial(_run, system)),
    Method("virtual_work", N_("virtual work: the balancing moment alone"), partial(_run, virtual_work)),
    *(
        Method(
            f"drawing_{accuracy:g}",
            N_("force polygons"),
            partial(_run, partial(plans, accuracy=accuracy)),
            no_plans,
            f"{accuracy:g} mm",
        )
        for accuracy in ACCURACIES
    ),
)


def force_method(key: str) -> ForceMethod:
    """Raises KeyError."""
    return next(one for one in FORCES if one.key == key)
