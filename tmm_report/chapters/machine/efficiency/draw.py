"""The block scheme of machines joined in series and in parallel, mm of paper."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

from tmm_report.chapters.machine.efficiency.given import Module
from tmm_report.chapters.machine.efficiency.solve import Found, Part
from tmm_report.figures.drawing import DASHED, NORMAL, THICK, Arrow, Drawing, Item, Pen, Text, line, polygon
from tmm_report.figures.lettering import Symbol

Numbers = Callable[[float], str]

BOX = complex(17.0, 10.0)  # width and height of a module
GAP = 6.0  # between modules of a chain: an arrow
FORK = 7.0  # between the trunk and the branches
APART = 5.0  # of branches
LEAD = 7.0  # of the input and the output
WIDE = 145.0  # of a row of a chain, with the gap before it
FRAME = 2.0  # of a group about its parts
LETTER = 2.6
FRAMED = Pen(0.25, "blue", DASHED.dash)


class Laid(NamedTuple):
    """Primitives of a part whose input is at 0 and output at `wide`; what it takes above and below."""

    items: tuple[Item, ...]
    wide: float
    above: float
    below: float

    def moved(self, by: complex) -> list[Item]:
        return [item.moved(by) for item in self.items]


def scheme(found: Found, num: Numbers, title: str = "") -> Drawing:
    """The whole with its input and output powers."""
    rows = _rows(found.whole, num)
    items: list[Item] = [Arrow(-LEAD + 0j, 0j, THICK), Text(-LEAD + 3.5j, (Symbol("P"),), align=-1)]
    start = 0j
    for k, row in enumerate(rows):
        if k:
            end, low = start + rows[k - 1].wide, 1j * (rows[k - 1].below + APART)
            start -= low + 1j * (APART + row.above)
            items += _turned(end, end - low, start)
        items += row.moved(start)
    end = start + rows[-1].wide
    items += [Arrow(end, end + LEAD, THICK), Text(end + LEAD + 3.5j, (Symbol("ηP"),), align=1)]
    return Drawing(tuple(items), title)


def _rows(whole: Part, num: Numbers) -> list[Laid]:
    """A chain in rows of the width of the paper, of anything else one row."""
    if isinstance(whole.node, Module) or whole.node.kind != "series":
        return [_laid(whole, num, framed=False)]
    rows: list[list[Part]] = [[]]
    wide = 0.0
    for part in whole.parts:
        more = GAP + _laid(part, num).wide
        if rows[-1] and wide + more > WIDE:
            rows.append([])
            wide = 0.0
        rows[-1].append(part)
        wide += more
    return [_chain(row, num) for row in rows]


def _turned(end: complex, low: complex, start: complex) -> list[Item]:
    """From the end of a row on the level of `low` back to the start of the next one."""
    corners = [end, end + LEAD, low + LEAD, complex(start.real - LEAD, low.imag), start - LEAD]
    return [*(line(*two, THICK) for two in pairwise(corners)), Arrow(start - LEAD, start, THICK, 2.5)]


def _laid(part: Part, num: Numbers, framed: bool = True) -> Laid:
    if isinstance(part.node, Module):
        return _box(part, num)
    laid = _chain(part.parts, num) if part.node.kind == "series" else _branches(part, num)
    return _framed(part, laid) if framed else laid


def _box(part: Part, num: Numbers) -> Laid:
    half = BOX.imag / 2
    corners = (-1j * half, BOX.real - 1j * half, BOX.real + 1j * half, 1j * half)
    middle = complex(BOX.real / 2)
    items: list[Item] = [
        polygon(corners, NORMAL),
        Text(middle + 2.4j, (part.index,), align=0),
        Text(middle - 2.4j, (Symbol("η", part.index), " = " + num(part.efficiency)), LETTER, 0),
    ]
    return Laid(tuple(items), BOX.real, half, half)


def _framed(part: Part, laid: Laid) -> Laid:
    """A dashed frame with the letter of the group."""
    wide = laid.wide + 2 * FRAME
    above, below = laid.above + FRAME, laid.below + FRAME
    corners = (-1j * below, wide - 1j * below, wide + 1j * above, 1j * above)
    letter = Text(complex(1.2, above + 2.4), (part.index,), LETTER, colour="blue")
    inner = [
        line(0j, complex(FRAME), THICK),
        *laid.moved(complex(FRAME)),
        line(complex(wide - FRAME), complex(wide), THICK),
    ]
    return Laid((polygon(corners, FRAMED), *inner, letter), wide, above + 4.4, below)


def _chain(parts: Sequence[Part], num: Numbers) -> Laid:
    items: list[Item] = []
    at, above, below = 0.0, 0.0, 0.0
    for k, inner in enumerate(parts):
        if k:
            items.append(Arrow(complex(at), complex(at + GAP), THICK, 2.5))
            at += GAP
        laid = _laid(inner, num)
        items += laid.moved(complex(at))
        at, above, below = at + laid.wide, max(above, laid.above), max(below, laid.below)
    return Laid(tuple(items), at, above, below)


def _branches(part: Part, num: Numbers) -> Laid:
    """Stacked from the top down about the trunk, each with its share of the input or output beside the fork."""
    laid = [_laid(inner, num) for inner in part.parts]
    tall = sum(one.above + one.below for one in laid) + APART * (len(laid) - 1)
    wide = max(one.wide for one in laid)
    items: list[Item] = []
    top, heights = tall / 2, []
    by_input = getattr(part.node, "by", "input") == "input"
    for one, inner in zip(laid, part.parts, strict=True):
        y = 1j * (top - one.above)
        heights.append(y.imag)
        start, end = FORK + (wide - one.wide) / 2, FORK + (wide + one.wide) / 2
        share = Text(1.0 + y + 2.2j, (num(float(inner.node.share or 0.0)),), LETTER, -1)
        items += one.moved(start + y)
        items += [Arrow(y, start + y, THICK, 2.5), line(end + y, wide + 2 * FORK + y, THICK)]
        items.append(share if by_input else share.moved(complex(wide + FORK)))
        top -= one.above + one.below + APART
    for x in (0.0, wide + 2 * FORK):
        items.append(line(complex(x, heights[-1]), complex(x, heights[0]), THICK))
    return Laid(tuple(items), wide + 2 * FORK, tall / 2, tall / 2)
