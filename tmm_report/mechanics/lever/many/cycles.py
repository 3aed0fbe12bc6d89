"""The cycles of many variants of one mechanism, searched together: each finds what it finds alone, to the last bit.

The variants are one `Cycle` whose linkage holds `Each` number; what is found is a list with an item a variant.
Variants that come near to a singular position are not searched so (see `singular.regular`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.brackets import changes_of_sign, dips, opened
from tmm_report.mechanics.calculus.roots import Finder, bracketed, interpolated
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.cycle import (
    Cycle,
    Extreme,
    Quantity,
    Rate,
    extreme_angle,
    least_and_greatest,
    noise_of,
)
from tmm_report.mechanics.lever.mechanism import ZeroAngle, ZeroExtreme
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.problems import ProblemError

Array = Any


def zeros(whole: Linkage, linkages: Sequence[Linkage]) -> list[float | None]:
    """Angle of the driving link in position 0 of every variant, rad; None where there is no such position."""
    zero = whole.mechanism.driver.zero
    if isinstance(zero, ZeroAngle):
        return [float(x) for x in np.ravel(zero.angle)]
    return _extreme_angles(whole, zero, len(linkages)) if zero.point else [_alone(x) for x in linkages]


def _alone(linkage: Linkage) -> float | None:
    zero = linkage.mechanism.driver.zero
    try:
        return extreme_angle(linkage, zero) if isinstance(zero, ZeroExtreme) else None
    except ProblemError:
        return None


def _extreme_angles(whole: Linkage, zero: ZeroExtreme, count: int) -> list[float | None]:
    """`cycle.extreme_angle` of a point."""
    start, point = Cycle(whole, 0.0), str(zero.point)
    roots = [
        row
        for (row,) in roots_of(start, count, [lambda m: dot(m.velocity(point), zero.direction)], bracketed)
    ]
    at, _ = filled(roots)
    reached = np.broadcast_to(dot(start.motion(at).place(point), zero.direction), at.shape)
    moving = moves(
        start, count, lambda m: dot(m.velocity(point), zero.direction), lambda m: m.velocity(point)
    )
    return [
        float(start.phi(own[np.argmax(row[: own.size])])) if own.size and turns else None
        for own, row, turns in zip(roots, reached, moving, strict=True)
    ]


def moves(cycle: Cycle, count: int, rate: Quantity, size: Quantity) -> Array:
    """Of every variant `Cycle.moves`, (count,) of bool."""
    motion = cycle.search[1]
    rates, sizes = (_largest(np.abs(of(motion)), count) for of in (rate, size))
    return rates > 1e-9 * sizes


def _largest(values: Array, count: int) -> Array:
    """Of values that broadcast to (..., count, P) each variant's largest, (count,)."""
    values = np.broadcast_to(values, np.broadcast_shapes(values.shape, (count, 1)))
    others = tuple(axis for axis in range(values.ndim) if axis != values.ndim - 2)
    return np.nanmax(values, axis=others, initial=0.0)


def roots_of(
    cycle: Cycle, count: int, rates: Sequence[Rate], finder: Finder = interpolated
) -> list[list[Array]]:
    """Of each of `count` variants the roots of several rates, as `Cycle.roots_of` finds them."""
    grid = cycle.search[0]
    values = [np.broadcast_to(cycle.searched(rate), (count, grid.size)) for rate in rates]
    sizes = [np.nanmax(np.abs(rows), axis=-1, initial=0.0, keepdims=True) for rows in values]
    over = [_brackets(grid, rows) for rows in values]
    pairs = _pairs(cycle, rates, values, sizes)
    low, high, starts, real = (
        [np.concatenate([b[k], p[k]], axis=-1) for b, p in zip(over, pairs, strict=True)] for k in range(4)
    )
    # what fills up a row is done at once
    noise = [
        np.where(of, noise_of(rate) * size, np.inf) for rate, size, of in zip(rates, sizes, real, strict=True)
    ]
    sampled, parts = _sampler(cycle, rates, low)
    found = left = np.concatenate(low, axis=-1)
    if found.size:
        ends = (np.concatenate(part, axis=-1) for part in (high, starts, noise))
        found, left = finder(sampled, found, *ends)
    each = zip(
        np.split(found, parts, axis=-1), np.split(left, parts, axis=-1), sizes, starts, real, strict=True
    )
    kept = [
        (own, of & (np.abs(rest) <= np.maximum(1e-6 * size, 1e-2 * np.abs(start))))
        for own, rest, size, start, of in each
    ]
    return [[cycle.within(own[v][good[v]]) for own, good in kept] for v in range(count)]


def _sampler(
    cycle: Cycle, rates: Sequence[Rate], places: Sequence[Array]
) -> tuple[Callable[[Array], Array], Array]:
    """The rates as one function of all their places side by side, and where these are to be parted."""
    parts = np.cumsum([x.shape[-1] for x in places])[:-1]
    return lambda x: np.concatenate(cycle.sampled(rates, np.split(x, parts, axis=-1)), axis=-1), parts


def _brackets(grid: Array, rows: Array) -> tuple[Array, Array, Array, Array]:
    """Both ends of the brackets of a rate (count, P), its values at the low ends, and which do not fill up a row."""
    at, real = filled([changes_of_sign(row) for row in rows])
    return grid[at], grid[at + 1], np.take_along_axis(rows, at, axis=-1), real


def _pairs(
    cycle: Cycle, rates: Sequence[Rate], values: Sequence[Array], sizes: Sequence[Array]
) -> list[tuple[Array, Array, Array, Array]]:
    """Brackets of roots that lie by twos within a step of the search, as `Cycle` finds them."""
    grid = cycle.search[0]
    if cycle.closed:
        grid = np.append(grid, grid[1] + cycle.sweep)
        values = [np.concatenate([rows, rows[:, 1:2]], axis=-1) for rows in values]
    found = []
    for rate, rows, size in zip(rates, values, sizes, strict=True):
        at, real = filled([np.flatnonzero(row) for row in dips(rows, 1e3 * noise_of(rate) * size)])
        found.append((np.maximum(at, 1), real))
    three = [
        np.stack([np.take_along_axis(rows, at + k, axis=-1) for k in (-1, 0, 1)])
        for rows, (at, _) in zip(values, found, strict=True)
    ]
    sampled, parts = _sampler(cycle, rates, [at for at, _ in found])
    at, real = (np.concatenate(part, axis=-1) for part in zip(*found, strict=True))
    if not real.any():
        none = np.zeros((len(real), 0))
        return [(none, none, none, none.astype(bool))] * len(rates)
    *ends, good = opened(sampled, grid, np.concatenate(three, axis=-1), at, real)
    both = (*(np.concatenate(part, axis=-1) for part in ends), np.concatenate([good, good], axis=-1))
    return list(zip(*(_halves(part, parts) for part in both), strict=True))


def _halves(both: Array, parts: Array) -> list[Array]:
    """Of two rows side by side, (..., 2K), the parts of each rate side by side."""
    first, second = (np.split(half, parts, axis=-1) for half in np.split(both, 2, axis=-1))
    return [np.concatenate([a, b], axis=-1) for a, b in zip(first, second, strict=True)]


def extremes_of(
    cycle: Cycle, values: Sequence[Quantity], still: Sequence[Sequence[Array]]
) -> list[list[tuple[Extreme, Extreme]]]:
    """Of each variant the least and the greatest of several values, as `Cycle.extremes_of` finds them; `still`: of each
    variant the angles turned at which each value stands still."""
    ends = [0.0] if cycle.closed else [0.0, cycle.sweep]
    where = [[np.concatenate([roots, ends]) for roots in own] for own in still]
    found = cycle.sampled(values, [filled(rows)[0] for rows in zip(*where, strict=True)])
    return [
        [least_and_greatest(row[v, : x.size], x) for row, x in zip(found, own, strict=True)]
        for v, own in enumerate(where)
    ]


def filled(rows: Sequence[Array]) -> tuple[Array, Array]:
    """Rows of unequal length as one array, filled up with zeros, and where it holds theirs."""
    lengths = np.array([row.size for row in rows])
    real = np.arange(lengths.max()) < lengths[:, None]
    whole = np.zeros(real.shape, dtype=rows[0].dtype)
    whole[real] = np.concatenate(rows)
    return whole, real
