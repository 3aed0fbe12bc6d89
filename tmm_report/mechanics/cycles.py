"""The cycles of many variants of one mechanism, searched together: each finds what it finds alone, to the last bit.

The variants are one `Cycle` whose linkage holds `Each` number; what is found is a list with an item a variant.
Variants that come near to a singular position are not searched so (see `singular.regular`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tmm_report.mechanics.cycle import (
    NOISE,
    STEP_NOISE,
    Cycle,
    Extreme,
    Quantity,
    Rate,
    Slope,
    changes_of_sign,
    extreme_angle,
    least_and_greatest,
)
from tmm_report.mechanics.mechanism import ZeroAngle, ZeroExtreme
from tmm_report.mechanics.motion import Linkage
from tmm_report.mechanics.planar import dot
from tmm_report.mechanics.roots import Finder, bracketed, interpolated
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
    levels = [STEP_NOISE if isinstance(rate, Slope) else NOISE for rate in rates]
    turns = [filled([changes_of_sign(row) for row in rows]) for rows in values]
    starts = [np.take_along_axis(rows, at, axis=-1) for rows, (at, _) in zip(values, turns, strict=True)]
    # what fills up a row is done at once
    noise = [
        np.where(real, level * size, np.inf)
        for level, size, (_, real) in zip(levels, sizes, turns, strict=True)
    ]
    parts = np.cumsum([at.shape[-1] for at, _ in turns])[:-1]

    def sampled(x: Array) -> Array:
        return np.concatenate(cycle.sampled(rates, np.split(x, parts, axis=-1)), axis=-1)

    at = np.concatenate([at for at, _ in turns], axis=-1)
    ends = np.concatenate(starts, axis=-1), np.concatenate(noise, axis=-1)
    found, left = finder(sampled, grid[at], grid[at + 1], *ends) if at.size else (grid[at], grid[at])
    kept = [
        (own, real & (np.abs(rest) <= 1e-6 * size))
        for own, rest, size, (_, real) in zip(
            np.split(found, parts, axis=-1), np.split(left, parts, axis=-1), sizes, turns, strict=True
        )
    ]
    return [[cycle.within(own[v][good[v]]) for own, good in kept] for v in range(count)]


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
