"""What is printed closes: every joint is looked at again, from the places of both links that it joins."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.checks.open_cycle import Gap, listed_angles
from tmm_report.mechanics.calculus.vectors import cross, if_known
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.cams.replacing_dyad import CamDyad
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_, Message

Array = Any
CLOSED = 1e-9  # of the largest length of the mechanism: how far the two places of a joint may be apart


def unclosed(motion: Motion, group: Dyad | HigherGroup, size: float) -> Array:
    """Where a joint of the group is in two places, or a sliding link beside its guide, (P,) of bool.

    A link that replaces a cam pair is another in every position: its group has no lengths to keep.
    """
    if isinstance(group, CamDyad):
        return np.zeros(motion.shape, dtype=bool)
    apart = np.zeros(motion.shape)
    for pair in (*group.group.outer, *group.group.inner):
        for gap in _gaps(motion, pair):
            apart = np.fmax(apart, np.abs(gap))
    return apart > CLOSED * size


def _gaps(motion: Motion, pair: Pair) -> Iterator[Array]:
    """How far both links of a pair are from where it has them, m: of a pivot the vector from one place to the other; of
    a guide the distance of the sliding link's line from it, and how far the line turns away at the size of a unit."""
    s, (one, other) = motion.state, pair.links
    first, second = (s.world(link, pair.at[link]) for link in (one, other))
    if pair.kind == "R":
        yield second - first
        return
    t, u = s.u[one] * pair.along[one], s.u[other] * pair.along[other]
    yield cross(t, second - first)
    yield cross(t, u) * np.maximum(np.abs(second - first), 1e-300)


def size_of(motion: Motion) -> float:
    """The largest length of the mechanism: of its links and of its frame, m."""
    arms = [
        np.max(np.abs(one - other))
        for link in motion.linkage.mechanism.links.values()
        for one, other in combinations([np.asarray(at) for at in link.points.values()], 2)
    ]
    return float(max(arms, default=1.0)) or 1.0


def all_closed(*motions: Motion) -> bool:
    """Whether every joint of the motions is in one place, of many variants at once."""
    return not any(
        unclosed(motion, group, size_of(motion)).any()
        for motion in motions
        for group in motion.linkage.groups
    )


def leave_out_unclosed(motion: Motion) -> list[tuple[Dyad | HigherGroup, Array]]:
    """Take from the motion the positions in which a group does not close; the groups, and where they do not."""
    s, lost, found = motion.state, np.zeros(motion.shape, dtype=bool), []
    size = size_of(motion)
    for group in motion.linkage.groups:
        bad = unclosed(motion, group, size)
        if bad.any():
            found.append((group, bad & ~lost))
            lost = lost | bad
            for cached in ("closes", "sines"):
                vars(motion).pop(cached, None)
        if lost.any():
            for part in (s.r, s.u, s.v, s.w, s.a, s.e, s.iw, s.ie):
                part.update({link: if_known(~lost, part[link]) for link in group.links})
    return found


def told(lost: list[tuple[Dyad | HigherGroup, Array]], turned: Array) -> list[Gap]:
    """The positions that were left out, as gaps of their groups."""
    return [_told(group, turned[bad]) for group, bad in lost if bad.any()]


def _told(group: Dyad | HigherGroup, turned: Array) -> Gap:
    where = {"group": group.group.label, "angles": listed_angles(turned)}
    why = Message(OPEN, where)
    links = {"links": ", ".join(group.links)}
    return Gap(group.group.label, group.links, (), why, Message(OTHER, links), jam=why)


OPEN = N_(
    "at the angle of rotation φ = %(angles)s the joints of group %(group)s do not close to 1e-9 of the largest "
    "length, and the positions are left out"
)
OTHER = N_("other lengths of links %(links)s keep it away from what cannot be solved")
