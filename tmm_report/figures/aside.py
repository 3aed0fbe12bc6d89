"""Vectors that lie upon one another on one line: drawn side by side, so that each is seen and can be measured."""

from __future__ import annotations

from collections.abc import Sequence

SPACING = 1.3  # mm between neighbours; of a drawing all on one line each has room for its letters
NEAR = 0.4  # mm: vectors of one direction no further apart than this lie upon one another
OVERLAP = 1.5  # mm: what two vectors share at least to be drawn apart; those that only touch need not be

Segment = tuple[complex, complex]


def asides(segments: Sequence[Segment], rooms: Sequence[float] = ()) -> list[float]:
    """How far each segment is drawn to the left of itself, mm (below zero: to the right); one before another keeps the
    line. Segments are no shorter than a hair. `rooms`: what the letters of each need across it, mm."""
    lanes, lines = _lanes(segments)
    return [_spacing(line, lanes, lines, rooms) * lane for lane, line in zip(lanes, lines, strict=True)]


def lie_upon(one: Segment, other: Segment) -> bool:
    """Whether two segments share a part of their length, seen across no gap."""
    long, short = (one, other) if abs(one[1] - one[0]) >= abs(other[1] - other[0]) else (other, one)
    start, length = long[0], abs(long[1] - long[0])
    unit = (long[1] - start) / length
    first, last = (short[0] - start) / unit, (short[1] - start) / unit
    low, high = max(0.0, min(first.real, last.real)), min(length, max(first.real, last.real))
    if high - low < OVERLAP:
        return False
    slope = (last.imag - first.imag) / (last.real - first.real)
    gaps = [abs(first.imag + slope * (x - first.real)) for x in (low, high)]
    return max(gaps) <= NEAR


def same_way(one: Segment, other: Segment) -> int:
    """1 for segments of one sense, -1 for opposite ones: the left of one is the right of the other."""
    return 1 if ((one[1] - one[0]) * (other[1] - other[0]).conjugate()).real > 0 else -1


def _lanes(segments: Sequence[Segment]) -> tuple[list[int], list[int]]:
    """Of each segment its lane, counted to its left, and the line it is on: the number of the first that lies there."""
    lanes: list[int] = []
    lines: list[int] = []
    for i, one in enumerate(segments):
        upon = [j for j in range(i) if lie_upon(one, segments[j])]
        taken = {lanes[j] * same_way(segments[j], one) for j in upon}
        lanes.append(next(lane for lane in _outwards(len(segments)) if lane not in taken))
        first = min((lines[j] for j in upon), default=i)
        joined = {lines[j] for j in upon}
        lines = [first if line in joined else line for line in lines] + [first]
    return lanes, lines


def _spacing(line: int, lanes: list[int], lines: list[int], rooms: Sequence[float]) -> float:
    """Between the neighbours on a line: close, but where there is nothing beside the line at all."""
    own = [i for i, other in enumerate(lines) if other == line]
    if len(own) <= 2 or len(own) < len(lanes) or not rooms:
        return SPACING
    return max(SPACING, *(rooms[i] for i in own))


def _outwards(count: int) -> list[int]:
    """0, 1, -1, 2, -2 …"""
    return [0, *(lane for size in range(1, count + 1) for lane in (size, -size))]
