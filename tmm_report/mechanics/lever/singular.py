"""Singular positions of every group over the cycle, found as exact driver angles and told apart.

limit      the links stretch to their utmost and beyond it the group cannot be assembled: its margin, the square of the
           sine of its transmission angle, passes through zero
change     two assemblies meet and both go on: the margin touches zero (parallelogram, rod equal to crank)
parallel   two guides become parallel and their crossing runs away

A change point is passed straight on: of the two continuations the smooth one keeps the motion's velocities finite.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.roots import bracketed, slope
from tmm_report.mechanics.lever.cams.replacing_dyad import CamDyad
from tmm_report.mechanics.lever.dyads import ROUNDING, Dyad, State, margin, reach
from tmm_report.mechanics.lever.high_class.newton import HigherGroup, Run
from tmm_report.mechanics.lever.motion import Linkage, drive, known_motion, positions
from tmm_report.records import dataclass

Array = Any

SEARCH = 720  # brackets of the search over a turn
STEP = 0.007  # rad, of the differences by which minima are found
FULL_TURN = 2 * np.pi
SOON = 0.05  # a margin that nowhere falls below this has no zero between the brackets
ONE = 1e-7  # rad: minima as near as this are one
HAIR = 1e-9  # rad, beside an end of the groups before


@dataclass(frozen=True, eq=False)
class Critical:
    """Singular positions of one group over a full turn: driver angles, rad, ascending.

    `gaps`: intervals in which the group cannot be assembled though those before it can; the second end may exceed a
    turn. `reach`: of a dyad of kind 1–3, least and greatest distance that its lengths must bridge (see
    `dyads.reach`), m. `run`: of a group above class II, how far it goes from position 0.
    """

    group: Dyad | HigherGroup
    changes: tuple[float, ...] = ()
    limits: tuple[float, ...] = ()
    parallel: tuple[float, ...] = ()
    gaps: tuple[tuple[float, float], ...] = ()
    reach: tuple[float, float] | None = None
    run: Run | None = None


def criticals(linkage: Linkage, told_at: float, begins: bool = True) -> tuple[Linkage, tuple[Critical, ...]]:
    """Singular positions of all groups, and the linkage that passes smoothly through its change points.

    The stated assemblies hold at driver angle `told_at`, rad (just after it, if it is a change point), or where the
    sketch was made. `begins`: whether position 0 is there, from which groups above class II are followed. Of many
    variants at once, (V, 1), nothing is looked for.
    """
    if linkage.axes:
        return linkage, ()
    grid = (np.arange(SEARCH + 1) - 0.5) * (FULL_TURN / SEARCH)
    sense = 1 if float(linkage.mechanism.driver.omega) > 0 else -1
    found: list[Critical] = []
    edges: list[float] = []  # of the intervals in which the groups before do not exist
    before = replace(linkage, groups=())
    with np.errstate(invalid="ignore", divide="ignore"):
        s = drive(linkage, grid)
        for group in linkage.groups:
            if isinstance(group, CamDyad):  # the law says where the follower is: it always closes, in one way
                critical = Critical(group)
            elif isinstance(group, Dyad):
                critical = _of_dyad(before, group, grid, s, edges)
                if critical.changes:
                    at = told_at if group.told_at is None else group.told_at
                    passed, corner = _passed(critical.changes, at, sense)
                    smooth = replace(group, changes=passed, corner=corner, told_at=at, sense=sense)
                    critical = replace(critical, group=smooth)
            else:
                walls = tuple(gap for one in found for gap in one.gaps)
                if walls or any(
                    new is not old for new, old in zip(before.groups, linkage.groups, strict=False)
                ):
                    group = replace(group, known=(known_motion(before),), walls=walls)
                if begins:
                    group = group.beginning(told_at, float(linkage.mechanism.driver.sweep))
                critical = _of_higher(group)
            critical.group.place(s)
            found.append(critical)
            edges += [np.mod(end, FULL_TURN) for gap in critical.gaps for end in gap]
            before = replace(before, groups=(*before.groups, critical.group))
    return before, tuple(found)


def regular(linkage: Linkage, count: int) -> Array:
    """Of `count` variants solved together, which keep away from singular positions all round, (count,) of bool: of
    their groups `criticals` finds nothing."""
    grid = (np.arange(SEARCH + 1) - 0.5) * (FULL_TURN / SEARCH)
    found = np.ones(count, dtype=bool)
    with np.errstate(invalid="ignore", divide="ignore"):
        s = drive(linkage, grid)
        for group in linkage.groups:
            if not isinstance(group, Dyad):
                return np.zeros(count, dtype=bool)
            found &= np.broadcast_to(margin(s, group), (count, grid.size)).min(axis=-1) >= SOON
            group.place(s)
    return found


def _passed(changes: tuple[float, ...], told_at: float, sense: int) -> tuple[tuple[float, ...], float | None]:
    """The change points that are passed smoothly, and the one that is not: of an odd number the last before the turn is
    over, or the next turn would begin in the other assembly."""
    if len(changes) % 2 == 0:
        return changes, None
    after = np.mod(sense * (np.array(changes) - told_at), FULL_TURN)
    after = np.where(after < 1e-9, FULL_TURN, after)
    last = int(np.argmax(after))
    return changes[:last] + changes[last + 1 :], changes[last]


def _of_dyad(before: Linkage, d: Dyad, grid: Array, s: State, edges: list[float]) -> Critical:
    def of(phi: Array) -> Array:
        return margin(positions(before, phi), d)

    values = np.broadcast_to(margin(s, d), grid.shape)
    low = _minima(of, grid, values)
    at_low = of(low) if low.size else low
    touching = np.abs(at_low) <= ROUNDING
    zeros = _distinct(low[touching])
    if d.kind > 3:
        return Critical(d, parallel=zeros)
    # a dip below zero between two grid points has both its ends there
    inner = [low[(at_low < 0) & ~touching]]
    # and so has the rest of a cell in which a group before begins or ends to exist
    inner += [_within(np.array(edges), grid) + hair for hair in (-HAIR, HAIR)]
    where = np.sort(np.concatenate([grid, *inner]))
    limits = _crossings(of, where, of(where)) if where.size > grid.size else _crossings(of, grid, values)
    gaps = _gaps(of, np.array([*limits, *edges]))
    span = _reach(before, d, grid, s) if gaps else None
    return Critical(d, changes=zeros, limits=tuple(limits.tolist()), gaps=gaps, reach=span)


def _distinct(angles: Array) -> tuple[float, ...]:
    """Angles of the first turn, rad, ascending, each once: one at 0 may have been found at the end of the turn too."""
    found = np.sort(np.mod(angles, FULL_TURN))
    after = np.diff(np.append(found, found[:1] + FULL_TURN))
    return tuple(found[after > ONE].tolist())


def _within(angles: Array, grid: Array) -> Array:
    """Angles of the first turn, rad, as those of the turn that the grid goes over."""
    return np.where(angles > grid[-1], angles - FULL_TURN, angles)


def _minima(of: Callable[[Array], Array], grid: Array, values: Array) -> Array:
    """Where the margin is least beside its neighbours and near zero; after a turn the grid begins anew."""
    grid, values = np.append(grid, grid[1] + FULL_TURN), np.append(values, values[1])
    middle, left, right = values[1:-1], values[:-2], values[2:]
    near = np.flatnonzero((middle <= left) & (middle < right) & (np.abs(middle) < SOON)) + 1
    if not near.size:
        return np.array([])

    def rate(phi: Array) -> Array:
        return slope(of, phi, STEP)

    low, high = grid[near - 1], grid[near + 1]
    first, last = rate(low), rate(high)
    inside = (first < 0) & (last > 0)
    found = bracketed(rate, low[inside], high[inside], first[inside], noise=1e-15)[0]
    return np.where(found < grid[-2], found, found - FULL_TURN)


def _crossings(of: Callable[[Array], Array], grid: Array, values: Array) -> Array:
    """Where the margin passes through zero, rad within a turn."""
    signs = np.where(values == 0, 1.0, np.sign(values))
    at = np.flatnonzero(signs[:-1] * signs[1:] < 0)
    # touching zero, rounding may look like two crossings
    at = at[(np.abs(values[at]) > ROUNDING) | (np.abs(values[at + 1]) > ROUNDING)]
    if not at.size:
        return np.array([])
    found, _ = bracketed(of, grid[at], grid[at + 1], values[at], noise=0.0)
    return np.sort(np.mod(found, FULL_TURN))


def _gaps(of: Callable[[Array], Array], edges: Array) -> tuple[tuple[float, float], ...]:
    """Intervals with a negative margin, between the angles at which it, or a group before, begins and ends to exist."""
    start = distinct(edges) if edges.size else np.array([0.0])
    end = np.append(start[1:], start[0] + FULL_TURN)
    negative = np.broadcast_to(of((start + end) / 2), start.shape) < -ROUNDING
    return tuple((float(a), float(b)) for a, b, lost in zip(start, end, negative, strict=True) if lost)


def _reach(before: Linkage, d: Dyad, grid: Array, s: State) -> tuple[float, float]:
    """Exact least and greatest distance over the turn that a dyad's lengths must bridge, m."""

    def of(phi: Array) -> Array:
        return np.broadcast_to(reach(positions(before, phi), d) ** 2, np.shape(phi))

    values = np.broadcast_to(reach(s, d) ** 2, grid.shape)
    rates = slope(of, grid, STEP)
    at = np.flatnonzero(rates[:-1] * rates[1:] < 0)
    extremes = values
    if at.size:
        found, _ = bracketed(lambda x: slope(of, x, STEP), grid[at], grid[at + 1], rates[at], noise=0.0)
        extremes = np.concatenate([values, of(found)])
    return float(np.sqrt(np.nanmin(extremes))), float(np.sqrt(np.nanmax(extremes)))


def swept(linkage: Linkage, critical: Critical, first: float, last: float) -> Critical:
    """The same of a dyad, its `reach` that of the driver's angles from `first` to `last` alone, rad, ascending."""
    d = critical.group
    if not isinstance(d, Dyad) or critical.reach is None:
        return critical
    before = replace(linkage, groups=linkage.groups[: list(linkage.groups).index(d)])
    grid = np.linspace(first, last, SEARCH + 1)
    with np.errstate(invalid="ignore", divide="ignore"):
        return replace(critical, reach=_reach(before, d, grid, positions(before, grid)))


def _of_higher(group: HigherGroup) -> Critical:
    """What the branch of a group above class II has met; gaps of the groups before it are told with them."""
    branch = group.branches[0]
    run, changes = branch.run, tuple(sorted(float(np.mod(x, FULL_TURN)) for x in branch.changes))
    if run.lost is None:
        return Critical(group, changes=changes, run=run)
    first, last = sorted(run.zero + run.sense * x for x in run.lost)
    ends = [x for x, blocked in zip(branch.limits, run.blocked, strict=True) if x is not None and not blocked]
    own = ends[:1] if run.overlaps or run.sweep < FULL_TURN else ends
    return Critical(
        group,
        changes=changes,
        limits=tuple(sorted(float(np.mod(x, FULL_TURN)) for x in own)),
        gaps=_without(first, last, group.walls),
        run=run,
    )


def _without(
    first: float, last: float, walls: Sequence[tuple[float, float]]
) -> tuple[tuple[float, float], ...]:
    """The interval without the walls in it, from within the first turn, ascending."""
    off = FULL_TURN * np.floor(first / FULL_TURN)
    left = [(first - off, last - off)]
    for low, high in walls:
        for turn in (-FULL_TURN, 0.0, FULL_TURN):
            a, b = low + turn, high + turn
            left = [
                part for x, y in left for part in ((x, min(y, a)), (max(x, b), y)) if part[1] - part[0] > 1e-9
            ]
    return tuple(sorted(left))
