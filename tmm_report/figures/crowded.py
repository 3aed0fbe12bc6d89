"""What is on a drawing, for labels that seek a free place: its lines on a grid of small cells, and the lettering.

How much lies in a box is asked of sums over the grid, so that a thousand places are looked at as fast as one. A box is
taken for the cells that it touches: what the grid calls clear is clear.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace
from typing import Any

import numpy as np

from tmm_report.figures.primitives import Box
from tmm_report.records import dataclass

CELL = 0.3  # mm
MOST = 4e6  # cells: those of a drawing of many metres are larger
_STEP = 5 / 6  # of a cell: how close to one another a line is felt
_WHOLE = 8  # a line of normal width, for each mm of it

Array = Any


@dataclass(eq=False)
class Ground:
    """`corner` (2,), mm, is that of the grid, `cell` the side of its cells, mm; `ink` (X, Y): weight of the lines in
    each cell; `sums` (X + 1, Y + 1): of all cells to the left and below; `taken`: boxes of lettering; `leaders`: lines
    drawn to labels so far."""

    corner: Array
    ink: Array
    sums: Array
    cell: float = CELL
    taken: list[Box] = field(default_factory=list)
    leaders: list[tuple[complex, complex]] = field(default_factory=list)

    def copy(self) -> Ground:
        """With the same lines, to put other lettering on."""
        return replace(self, taken=list(self.taken), leaders=list(self.leaders))

    def covered(self, boxes: Array) -> Array:
        """Weight of the lines in each box (N, 4), (N,)."""
        last = np.array(self.ink.shape)
        low = np.clip(np.floor((boxes[:, :2] - self.corner) / self.cell), 0, last).astype(int)
        high = np.clip(np.ceil((boxes[:, 2:] - self.corner) / self.cell), 0, last).astype(int)
        (x0, y0), (x1, y1) = low.T, high.T
        return self.sums[x1, y1] - self.sums[x0, y1] - self.sums[x1, y0] + self.sums[x0, y0]

    def across(self, start: complex, end: complex) -> int:
        """Weight of what a line from one place to another goes over."""
        count = 2 + int(abs(end - start) / self.cell)
        places = start + (end - start) * np.linspace(0.0, 1.0, count)
        cells = np.floor((np.stack([places.real, places.imag], axis=1) - self.corner) / self.cell).astype(int)
        inside = ((cells >= 0) & (cells < self.ink.shape)).all(axis=1)
        return int(self.ink[cells[inside, 0], cells[inside, 1]].sum())

    def free(self, boxes: Array) -> Array:
        """Whether neither lettering nor a leader is in each of the boxes (N, 4), (N,)."""
        found = ~overlapping(boxes, np.array(self.taken).reshape(-1, 4))
        left = np.nonzero(found)[0]
        if len(left) and self.leaders:
            found[left] = ~cut(boxes[left][:, None], np.array(self.leaders)).any(axis=1)
        return found

    def crossed(self, leaders: Array) -> Array:
        """How many boxes of lettering each of the leaders (N, 2), complex, goes through, (N,)."""
        return cut(np.array(self.taken).reshape(1, -1, 4), leaders[:, None]).sum(axis=1)


def ground(lines: Array, low: Array, high: Array) -> Ground:
    """Of lines (M, 5): x, y of the start, x, y of the end, weight; `low`, `high` (2,): corners of all there is, mm."""
    cell = max(CELL, float(np.sqrt(np.prod(high - low) / MOST)))
    shape = np.ceil((high - low) / cell).astype(int) + 1
    step = _STEP * cell
    counts = 1 + np.ceil(np.hypot(lines[:, 2] - lines[:, 0], lines[:, 3] - lines[:, 1]) / step).astype(int)
    of = np.repeat(np.arange(len(lines)), counts)
    share = (np.arange(len(of)) - np.repeat(np.cumsum(counts) - counts, counts)) / np.maximum(counts - 1, 1)[
        of
    ]
    x = ((lines[of, 0] + share * (lines[of, 2] - lines[of, 0]) - low[0]) / cell).astype(int)
    y = ((lines[of, 1] + share * (lines[of, 3] - lines[of, 1]) - low[1]) / cell).astype(int)
    weights = np.ceil(_WHOLE * step * lines[of, 4])
    ink = np.bincount(x * shape[1] + y, weights, shape[0] * shape[1]).astype(np.int64).reshape(shape)
    sums = np.zeros(shape + 1, np.int64)
    np.cumsum(np.cumsum(ink, axis=0), axis=1, out=sums[1:, 1:])
    return Ground(low, ink, sums, cell)


def overlapping(boxes: Array, others: Array) -> Array:
    """Whether each box (N, 4) has some area in common with one of the others (M, 4), (N,)."""
    return overlapped(boxes, others).any(axis=1)


def overlapped(boxes: Array, others: Array) -> Array:
    """Which of the others (M, 4) each box (N, 4) has some area in common with, (N, M)."""
    one, other = boxes[:, None], others
    wide = np.minimum(one[..., 2], other[:, 2]) - np.maximum(one[..., 0], other[:, 0])
    tall = np.minimum(one[..., 3], other[:, 3]) - np.maximum(one[..., 1], other[:, 1])
    return (wide > 0) & (tall > 0)


def areas(boxes: Array, others: Sequence[Box]) -> Array:
    """Area that each box (N, 4) shares with the others together, (N,), mm²."""
    total = np.zeros(len(boxes))
    for x0, y0, x1, y1 in others:
        wide = np.minimum(boxes[:, 2], x1) - np.maximum(boxes[:, 0], x0)
        tall = np.minimum(boxes[:, 3], y1) - np.maximum(boxes[:, 1], y0)
        total += np.clip(wide, 0, None) * np.clip(tall, 0, None)
    return total


def cut(boxes: Array, segments: Array) -> Array:
    """Whether segments (..., 2), complex, go through boxes (..., 4)."""
    outside, low, high = _shares(boxes, segments)
    return ~outside & (low < high)


def within(boxes: Array, segment: Array) -> list[tuple[float, float]]:
    """From which to which share of its length a segment (2,) is in each of the boxes (N, 4) that it goes through."""
    outside, low, high = np.broadcast_arrays(*_shares(boxes, segment))
    inside = ~outside & (low < high)
    return list(zip(low[inside].tolist(), high[inside].tolist(), strict=True))


def _shares(boxes: Array, segments: Array) -> tuple[Array, Array, Array]:
    """Whether each segment passes beside the box, and else from which to which share of it lies within, where the one
    is less than the other."""
    low: Array = 0.0
    high: Array = 1.0
    start, by = segments[..., 0], segments[..., 1] - segments[..., 0]
    outside: Array = False
    for at, along, least, most in (
        (start.real, by.real, boxes[..., 0], boxes[..., 2]),
        (start.imag, by.imag, boxes[..., 1], boxes[..., 3]),
    ):
        still = np.abs(along) < 1e-9
        outside = outside | (still & ~((least < at) & (at < most)))
        safe = np.where(still, 1.0, along)
        t1, t2 = (least - at) / safe, (most - at) / safe
        low = np.where(still, low, np.maximum(low, np.minimum(t1, t2)))
        high = np.where(still, high, np.minimum(high, np.maximum(t1, t2)))
    return outside, low, high
