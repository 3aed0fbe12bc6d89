"""The swing of a link that turns another by a mesh whose ratio is no whole number: its angle is told from the middle.

An angle is known but for full turns, and a wheel with teeth in another ratio would not come back with them. A link that
swings less than a turn has a middle from which its angle never reaches 180°; one that makes full turns has none.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.motion import Linkage, positions
from tmm_report.mechanics.lever.wheels.coupled import Coupled, Root
from tmm_report.problems import N_, Message, ProblemError, mistake

Array = Any
SAMPLES = 720  # over a turn of the driving link


def with_middles(linkage: Linkage) -> Linkage:
    """The linkage, the wheels of its last group with the middles of the swings that turn them. Raises ProblemError of
    one that makes full turns."""
    last = linkage.groups[-1]
    if not any(_needs(root) for wheel in last.group.wheels for root in wheel.roots):
        return linkage
    bare = replace(last, group=replace(last.group, wheels=()))
    before = replace(linkage, groups=(*linkage.groups[:-1], bare))
    s = positions(before, np.linspace(0, 2 * np.pi, SAMPLES, endpoint=False))
    wheels = tuple(
        replace(wheel, roots=tuple(_swung(root, wheel, s.u) for root in wheel.roots))
        for wheel in last.group.wheels
    )
    held = replace(last, group=replace(last.group, wheels=wheels))
    structure = linkage.structure
    groups = tuple(held.group if group is last.group else group for group in structure.groups)
    return replace(
        linkage,
        structure=replace(structure, groups=groups),
        groups=(*linkage.groups[:-1], held),
    )


def _needs(root: Root) -> bool:
    """Whether the angle of the wheel is told by that of a turning link, but for full turns of it."""
    return root.way is None and not root.leads and not root.whole


def _swung(root: Root, wheel: Coupled, turns: Mapping[str, Array]) -> Root:
    """The root with the middle of its swing, where that is needed."""
    return replace(root, middle=_middle(turns[root.link], root, wheel)) if _needs(root) else root


def _middle(u: Array, root: Root, wheel: Coupled) -> complex:
    """The direction from which the link's angle goes equally far both ways, unit complex."""
    u = np.atleast_1d(u)
    there = np.isfinite(u)
    if not there.any():
        return 1 + 0j
    if not there.all():  # begin behind a gap
        u = np.roll(u, -int(np.flatnonzero(~there)[-1]) - 1)
        u = u[np.isfinite(u)]
    angles = np.unwrap(np.angle(u))
    whole_turn = there.all() and abs(angles[-1] - angles[0]) > np.pi
    if whole_turn or np.ptp(angles) > 2 * np.pi - 1e-6:
        key, _, number = wheel.mesh.name.partition(" ")
        text = N_(
            "link %(by)s makes full turns, and link %(link)s does not come back with them: the motion does not repeat "
            "with every turn of the driving link, and such a cycle is not offered"
        )
        right = Message(N_("radii or teeth in a whole ratio such as 1:1 or 2:1"))
        path = ("mechanism", key, int(number))
        raise ProblemError([mistake(text, path, right, by=root.link, link=wheel.link)])
    return complex(np.exp(0.5j * (angles.min() + angles.max())))
