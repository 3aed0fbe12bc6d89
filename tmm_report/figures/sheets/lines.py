"""Lines of GOST 2.303 for those of a note: black, main or thin, and of what is broken always thin."""

from __future__ import annotations

from dataclasses import replace

from tmm_report.figures.primitives import Arc, Arrow, Circle, Item, Path, Pen, Text

MAIN = 0.6  # mm: s of GOST 2.303
HALF, THIN = 0.3, 0.2  # s/2 and s/3, between which thin lines are
BOLD = 0.38  # mm: what is at least as wide in a note is a main line
LIGHT = 0.26  # what is at most as wide in it is as thin as may be
DASHED, CENTRE, PHANTOM = (4.0, 1.5), (8.0, 1.2, 0.6, 1.2), (8.0, 1.5, 0.5, 1.5, 0.5, 1.5)
LONG, SHORT = (8.0, 2.0), (2.0, 1.0)  # dashed lines are from the one to the other


def larger(item: Item, times: float) -> Item:
    match item:
        case Path():
            strokes = tuple(tuple(times * z for z in stroke) for stroke in item.strokes)
            return replace(item, strokes=strokes, held=frozenset(), pen=_pen(item.pen), fill=_fill(item.fill))
        case Circle():
            return replace(
                item,
                centre=times * item.centre,
                radius=_radius(item, times),
                pen=_pen(item.pen),
                fill=_fill(item.fill),
            )
        case Arc():
            return replace(item, centre=times * item.centre, radius=times * item.radius, pen=ruled(item.pen))
        case Arrow():
            return replace(item, start=times * item.start, end=times * item.end, pen=ruled(item.pen))
        case Text():
            raise TypeError("letters have their own way")


def _radius(item: Circle, times: float) -> float:
    """A dot, which has no line, is a sign and not a size."""
    return item.radius if item.pen is None else times * item.radius


def _pen(pen: Pen | None) -> Pen | None:
    return None if pen is None else ruled(pen)


def ruled(pen: Pen) -> Pen:
    """The line of GOST 2.303 for that of a note: black, main or thin, and of what is broken always thin."""
    if not pen.dash:
        return Pen(MAIN if pen.width >= BOLD else THIN if pen.width <= LIGHT else HALF)
    if len(pen.dash) == 2:  # curves of one graph are told from one another by these
        return Pen(HALF, dash=LONG if pen.dash[0] >= 4 else DASHED if pen.dash[0] >= 1.8 else SHORT)
    return Pen(HALF, dash=CENTRE if len(pen.dash) == 4 else PHANTOM)


def _fill(fill: str) -> str:
    return fill if fill in ("", "white", "pale", "grey") else "black"
