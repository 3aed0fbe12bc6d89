"""The motion where two assemblies of a group meet, from its neighbours: there the closed forms divide what is next to
nothing by what is next to nothing.

Near a change point, where the closeness of a group is s, its poses lose ε/s, velocities ε/s² and accelerations ε/s³ to
rounding. The motion itself goes through it smoothly, from one assembly into the other: so what it is there is
interpolated from both sides, on the sheet that goes straight through. In a corner, where the assembly is kept, each of
the two sides has such a sheet of its own, and the motion a limit from each side.

What is interpolated is taken only where the sheet does pass: its joints are closed, and the poses that are solved are
off it by no more than rounding. Elsewhere (links that run away, assemblies that only nearly meet) the motion stays as
it is solved, and in a singular position without rates.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import comb
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, if_known
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.dyads import Dyad, State
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.motion import SINGULAR, Motion, solve
from tmm_report.records import dataclass

Array = Any
Group = Dyad | HigherGroup

BESIDE = 5e-3  # closeness below which a position beside a change point is taken from its neighbours
POSED = 1e-5  # closeness from which poses are solved more exactly than the neighbours tell them
AT = 1e-8  # rad: a position as near to a corner is in it
STEPS = 0.03 * 0.5 ** np.arange(14)  # rad, of the neighbours
EACH = 8  # neighbours on either side
AGREED = 1e-6  # of the largest value: by how much two steps may differ, or there is no limit
ENOUGH = 1e-11  # of the largest value: steps that agree so well need no smaller ones
WORSE = 4.0  # times the best agreement
CLOSED = (
    1e-9  # of the largest arm, or of a unit vector: by how much joints of what is interpolated may be open
)
MARGIN = 4e-14  # rounding of s²: poses of a closeness s are solved to this over s
ORDERS = np.arange(1.0, EACH + 1)
MIDDLE = np.array(
    [-((-1) ** k) * comb(2 * EACH, EACH - k) / comb(2 * EACH, EACH) for k in range(1, EACH + 1)]
)
"""The value in the middle from its neighbours, order 2 EACH: f ≈ Σ c_k (f(x + kh) + f(x − kh))."""
NAMES = ("r", "u", "v", "w", "a", "e")
POSES = NAMES[:2]


def settle(motion: Motion, side: Array = -1, alone: bool = False) -> Array:
    """Replace the motion at change points by its limit, where there is none by nan; the mask of the latter, (..., P).

    Groups behind such a one are solved anew from there. In a corner there are two limits: `side`, (..., P) of ±1, is
    the one whose poses are taken, before it in the sense of rotation or after it; velocities are nan unless both
    agree, or `alone` that side is asked for.
    """
    s, linkage = motion.state, motion.linkage
    lost = np.zeros(motion.shape, dtype=bool)
    taken = False
    for k, group in enumerate(linkage.groups):
        with np.errstate(invalid="ignore", divide="ignore"):
            if taken:
                group.place(s)
                group.move(s)
            sine = (
                np.broadcast_to(group.closeness(s), motion.shape)
                if taken
                else motion.sines[group.group.label]
            )
        # a change point in which a link has no length to be placed by has no sine either
        near = (sine <= BESIDE) | ~np.isfinite(sine) if group.meetings else sine <= SINGULAR
        if near.any():
            exists, moves = _take_limits(motion, k, near, sine, np.broadcast_to(side, motion.shape), alone)
            motion.limits[group.group.label] = moves
            with np.errstate(invalid="ignore"):
                singular = ~(sine > SINGULAR) | _in_corner(group, motion.phi)
            lost, taken = lost | (near & singular & ~moves), taken or bool(exists.any())
        if lost.any():
            for rates in (s.v, s.w, s.a, s.e, s.iw, s.ie):
                for link in group.links:
                    rates[link] = if_known(~lost, rates[link])
    if taken:
        for cached in ("sines", "closes"):
            vars(motion).pop(cached, None)
    return lost


def meets(groups: Sequence[Group]) -> bool:
    """Whether assemblies of any of the groups meet, so that a motion is to be settled."""
    return any(group.meetings for group in groups)


@dataclass(frozen=True, eq=False)
class _Limits:
    """Poses and rates of a group's links, by field and link, (N,); whether these are limits, and those of poses."""

    values: dict[tuple[str, str], Array]
    moves: Array
    posed: Array


def _take_limits(
    motion: Motion, number: int, near: Array, sine: Array, side: Array, alone: bool
) -> tuple[Array, Array]:
    """Put the limits of poses and rates of the group with this number into the state at the positions `near`; where
    there are poses, and where there are rates, (..., P)."""
    exists, moves = np.zeros(motion.shape, dtype=bool), np.zeros(motion.shape, dtype=bool)
    if motion.linkage.axes:
        return exists, moves
    s, phi = motion.state, np.broadcast_to(motion.phi, motion.shape)[near]
    found = _limits(motion, number, phi, side[near])
    group = motion.linkage.groups[number]
    inside = _in_corner(group, phi)
    other = _limits(motion, number, phi, -side[near]) if inside.any() else found
    passes = found.posed & _passes(motion, group, (found.values, other.values), near, sine)
    if not group.meetings:  # places may agree on both sides of where the links run away, but rates do not
        passes &= found.moves
    good = found.moves & passes
    if not alone and inside.any():
        scales = _scales(motion, found.values)
        for key, values in found.values.items():
            with np.errstate(invalid="ignore"):
                same = np.abs(values - other.values[key]) <= AGREED * scales[key[0]]
            good = good & (~inside | same)
    exists[near], moves[near] = passes, good
    for (name, link), values in found.values.items():
        reference = group.references[link]
        if name in "rva" and reference.kind == "R" and reference in group.group.outer:
            continue  # a joint on a link known before moves as that link does
        part = getattr(s, name)
        whole = np.array(np.broadcast_to(part[link], motion.shape), dtype=values.dtype)
        # poses that lose no more than rounding over the sine stay as they are solved
        taken = exists & ~(sine > POSED) if name in ("r", "u") else moves
        whole[taken] = values[taken[near]]
        part[link] = whole
    for link in group.links:
        with np.errstate(invalid="ignore", divide="ignore"):  # of positions that cannot be assembled
            s.u[link] = s.u[link] / np.abs(s.u[link])
        s.turn(link, s.w[link], s.e[link])
    return exists, moves


def _passes(
    motion: Motion, group: Group, found: Sequence[dict[tuple[str, str], Array]], near: Array, sine: Array
) -> Array:
    """Whether poses (N,) from the neighbours of the positions `near` are those of the sheet that passes there: joints
    closed, and the poses that are solved, where they are, no farther from them than their rounding; in a corner, where
    rounding says on which side they are, from these or those of the other side, both `found`."""
    s, shape = motion.state, motion.shape
    values = found[0]
    scale = _scales(motion, values)["r"]
    poses: dict[str, tuple[Array, Array]] = {}
    passes = np.ones(int(near.sum()), dtype=bool)
    with np.errstate(invalid="ignore", divide="ignore"):
        rounding = MARGIN / np.broadcast_to(sine, shape)[near]
        off = [np.zeros(passes.shape) for _ in found]
        for pair in (*group.group.outer, *group.group.inner):
            for link in pair.links:
                r, u = (np.broadcast_to(part[link], shape)[near] for part in (s.r, s.u))
                if link in group.links:
                    reference = group.references[link]
                    carried = reference.kind == "R" and reference in group.group.outer
                    for row, each in zip(off, found, strict=True):
                        apart = np.abs(each["u", link] - u)
                        if not carried:
                            apart = np.fmax(apart, np.abs(each["r", link] - r) / scale)
                        row[:] = np.fmax(row, apart)
                    r, u = r if carried else values["r", link], values["u", link]
                    passes &= np.abs(np.abs(u) - 1) <= CLOSED
                poses[link] = r, u
            passes &= _gap(s, pair, poses, scale) <= CLOSED
        return np.asarray(passes & ~(np.fmin.reduce(off) > rounding))


def _gap(s: State, pair: Pair, poses: dict[str, tuple[Array, Array]], scale: float) -> Array:
    """How far a joint is open, of the size of the arms, (N,)."""
    first, second = pair.links
    places = {
        link: r + u * (pair.at[link] - s.o[link]) for link, (r, u) in poses.items() if link in pair.links
    }
    size = np.maximum.reduce([scale, *(np.max(np.abs(pair.at[link] - s.o[link])) for link in pair.links)])
    gap = (places[second] - places[first]) / size
    if pair.kind == "R":
        return np.abs(gap)
    one, other = (poses[link][1] * pair.along[link] for link in pair.links)
    return np.maximum(np.abs(cross(one, gap)), np.abs(cross(one, other)))


def _in_corner(group: Group, phi: Array) -> Array:
    """Which driver angles lie in the group's corner, bool."""
    if not isinstance(group, Dyad) or group.corner is None:
        return np.zeros(np.shape(phi), dtype=bool)
    return np.asarray(np.abs(_apart(phi, group.corner)) < AT)


def _apart(phi: Array, other: Array) -> Array:
    """How far driver angles are beyond others, rad, -π … π."""
    return np.angle(np.exp(1j * (phi - other)))


def _limits(motion: Motion, number: int, phi: Array, side: Array) -> _Limits:
    """The limits at driver angles `phi`, (N,), each from its neighbours on the sheet that goes smoothly through; of a
    position in a corner on that of the `side`. Steps are halved as long as two agree ever better."""
    best: dict[tuple[str, str], Array] = {}
    off: dict[tuple[str, str], Array] = {}
    last: dict[tuple[str, str], Array] = {}
    left = np.ones(phi.shape, dtype=bool)
    for step in STEPS:
        new = _middle(motion, number, phi[left], side[left], step)
        scales = _scales(motion, new)
        open_ = np.zeros(left.sum(), dtype=bool)
        for key, values in new.items():
            if key not in last:
                last[key], best[key] = (np.full(phi.shape, np.nan, dtype=values.dtype) for _ in range(2))
                off[key] = np.full(phi.shape, np.inf)
            apart = np.abs(values - last[key][left]) / scales[key[0]]
            better = apart < off[key][left]
            at = np.flatnonzero(left)[better]
            best[key][at], off[key][at] = values[better], apart[better]
            last[key][left] = values
            # once rounding makes neighbours differ more than their distance does, smaller steps are worse
            open_ |= (off[key][left] > ENOUGH) & ~(
                (off[key][left] <= AGREED) & (apart > WORSE * off[key][left])
            )
        left[left] = open_
        if not left.any():
            break
    found = {key: np.where(off[key] <= AGREED, values, np.nan) for key, values in best.items()}
    return _Limits(
        found,
        np.logical_and.reduce([off[key] <= AGREED for key in found]),
        np.logical_and.reduce([off[key] <= AGREED for key in found if key[0] in POSES]),
    )


def _middle(
    motion: Motion, number: int, phi: Array, side: Array, step: float
) -> dict[tuple[str, str], Array]:
    """Poses and rates of the group's links at `phi`, (N,), from neighbours at so large steps, rad."""
    offsets = step * np.concatenate([ORDERS, -ORDERS])[:, None]
    angles = phi + offsets
    groups = tuple(_sheet(group, phi, angles, side) for group in motion.linkage.groups[: number + 1])
    beside = solve(replace(motion.linkage, groups=groups), angles, motion.omega).state
    found: dict[tuple[str, str], Array] = {}
    for name in NAMES:
        for link in groups[number].links:
            values = np.broadcast_to(getattr(beside, name)[link], angles.shape)
            # not by tensordot: threads of its library cost more than so short sums
            found[name, link] = ((values[:EACH] + values[EACH:]) * MIDDLE[:, None]).sum(axis=0)
    return found


def _scales(motion: Motion, values: dict[tuple[str, str], Array]) -> dict[str, float]:
    """The largest of each kind of values, beside which another is nothing."""
    omega = float(np.max(np.abs(motion.omega)))
    scales = dict.fromkeys(("r", "u", "v", "a"), 1e-300) | {"w": omega, "e": omega**2}
    for (name, _), each in values.items():
        finite = np.abs(each)[np.isfinite(each)]
        scales[name] = max(scales[name], float(finite.max(initial=0.0)))
    return scales


def _sheet(group: Group, phi: Array, angles: Array, side: Array) -> Group:
    """The group at `angles`, (..., N), on the sheets that go smoothly through `phi`, (N,), and all change points; in a
    corner that of the `side`."""
    if not isinstance(group, Dyad) or not group.meetings:
        return group
    meetings = np.array(group.meetings)
    off = _apart(phi, meetings[:, None])
    nearest = np.argmin(np.abs(off), axis=0)
    at = np.take_along_axis(off, nearest[None], axis=0)[0]
    # in a change point itself rounding would tell on which side it is
    aside = np.where(np.abs(at) < AT, 2 * AT * group.sense * side, at)
    anchor = phi - at + aside
    signs = np.broadcast_to(group.root(anchor), phi.shape)
    way = angles - anchor
    passed = np.zeros(angles.shape, dtype=bool)
    for meeting in meetings:
        beyond = _apart(meeting, anchor)
        passed ^= (np.abs(beyond) < np.abs(way)) & (beyond * way > 0)
    return replace(group, held=np.where(passed, -signs, signs))
