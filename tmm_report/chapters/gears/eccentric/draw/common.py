"""Pens and signs that both drawings of an eccentric epicyclic mechanism have."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tmm_report.figures.drawing import Arrow, Item, Pen, Text, line
from tmm_report.figures.lettering import Parts

Numbers = Callable[[float], str]  # a number as the note writes it

FINE = 0.01  # mm of paper that a drawn tooth may leave the true curve
CENTRES = Pen(0.18, "red", (3.0, 0.8, 0.5, 0.8))
MEASURE = Pen(0.13)


def measured(start: complex, end: complex, text: Parts, within: bool = False) -> Iterator[Item]:
    """A dimension line with arrows, from outside where it is short; the text beyond its right end, or over the middle
    of a line that has room for it within."""
    along = (end - start) / abs(end - start)
    short = abs(end - start) < 9
    if not short:
        yield Arrow(start, end, MEASURE, 2.2)
        yield Arrow(end, start, MEASURE, 2.2)
    else:
        yield line(start, end, MEASURE)
        yield Arrow(start - 9 * along, start, MEASURE, 2.2)
        yield Arrow(end + 9 * along, end, MEASURE, 2.2)
    if within and not short:
        yield Text((start + end) / 2 + 2.4j, text, align=0)
    else:
        yield Text(end + (2.5 + 2.2j if short else 2), text)


def plain(wheel: str) -> str:
    """The number of a wheel as it is lettered."""
    return wheel.replace("'", "′")
