"""Where a long formula breaks: before a relation or a sign, which stands at the end of the line, too.

A formula comes in pieces, each beginning with its relation or sign. A piece that no line holds is cut on: before its
products, whose dot becomes a cross there, then within brackets.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import accumulate, pairwise
from xml.etree.ElementTree import Element, fromstring, tostring

from tmm_report.report.paper import measure
from tmm_report.report.paper.sheets import USUAL

LINE = USUAL.line  # em: what a line of formulas holds beside its number
_SHORT = 24  # letters that always stand on one line
_FULL = 0.45  # of a line: one that is so full may end before a relation, though more has room

# --- MathML ---

_HEAD = "<math>"
_MARKUP = re.compile(r"<[^>]+>")
_SIGN = re.compile(r'<mo form="infix">([^<]+|&lt;)</mo>')
_AGAIN = '<math class="again" aria-hidden="true">{}</math><br/>'


def broken(text: str, line: float = LINE) -> tuple[str, float]:
    """A displayed formula of neighbouring `math` elements on lines that hold it, and to what share of its size it is
    reduced, where one of its pieces cannot be cut. `line`: what a line holds, ems."""
    if len(_MARKUP.sub("", text)) <= _SHORT or _wide(text) <= line:
        return text, 1.0
    pieces = [cut for piece in text.split("<wbr/>") for cut in _cut(piece, line)]
    share = min(1.0, line / max(map(_wide, pieces)))
    first, *others = _lines(pieces, line / share)
    return "<wbr/>".join(first) + "".join(map(_next, others)), share


def _next(line: Sequence[str]) -> str:
    """The end of a line with the sign of the next, and that. A product is broken at a cross."""
    text = "<wbr/>".join(line)
    sign = _sign_of(text)
    if sign is None:
        return f"<br/>{text}"
    twice = sign[0].replace("·", "×")
    return _AGAIN.format(twice) + text.replace(sign[0], twice, 1)


def _wide(text: str) -> float:
    return sum(map(measure.mathematics, text.split("<wbr/>")))


def _sign_of(piece: str) -> re.Match[str] | None:
    return _SIGN.match(piece.removeprefix(_HEAD))


def _lines(pieces: Sequence[str], room: float) -> list[list[str]]:
    """Pieces line by line."""
    ends = [0, *accumulate(shared(list(map(_wide, pieces)), list(map(_is_relation, pieces)), room))]
    return [list(pieces[start:end]) for start, end in pairwise(ends)]


def shared(widths: Sequence[float], relations: Sequence[bool], room: float) -> list[int]:
    """How many pieces go on each line: as many as it holds with the sign that is repeated, or up to a relation.
    `relations`: whether a piece begins with one."""
    counts: list[int] = []
    at = 0
    while at < len(widths):
        fit = _fitting(widths[at:], room)
        count = fit
        if at + fit < len(widths):
            before = [k for k in range(1, fit + 1) if relations[at + k]]
            full = [k for k in before if sum(widths[at : at + k]) >= _FULL * room]
            count = full[-1] if full else fit
        counts.append(count)
        at += count
    return counts


def _fitting(widths: Sequence[float], room: float) -> int:
    """How many pieces a line holds, at least one."""
    if sum(widths) <= room:
        return len(widths)
    taken, count = 0.0, 0
    while count < len(widths) and taken + widths[count] <= room - 1.0:  # em of the repeated sign
        taken, count = taken + widths[count], count + 1
    return max(count, 1)


def _is_relation(piece: str) -> bool:
    sign = _sign_of(piece)
    return sign is not None and sign[1] not in "+−·"


def _cut(piece: str, line: float) -> Iterator[str]:
    """A piece that a line holds, or what it can be cut into."""
    if _wide(piece) <= line - 1.0:
        yield piece
        return
    row: list[Element] = []
    for node in _flat(fromstring(piece)):
        if _breaks(node) and len(row) > (1 if row and _breaks(row[0]) else 0):
            yield _written(row)
            row = []
        row.append(node)
    yield _written(row)


def _flat(row: Element) -> Iterator[Element]:
    """What stands in a row, brackets and their contents one after another."""
    for node in row:
        if node.tag == "mrow" and not node.attrib and (len(node) > 2 or node[0].get("form") == "prefix"):
            yield from _flat(node)
        else:
            yield node


def _breaks(node: Element) -> bool:
    return node.tag == "mo" and node.get("form") == "infix"


def _written(row: Sequence[Element]) -> str:
    math = Element("math")
    math.extend(row)
    return tostring(math, encoding="unicode").replace(" />", "/>")


# --- LaTeX ---

TEX = 30.0 / 34.0  # of a line: TeX breaks lines itself; a piece that may be longer is cut for it


def pieces(latex: str) -> list[str]:
    """A formula cut before its relations and signs outside all braces and brackets: a line may break there."""
    return [*_parted(latex, _cuts(" (?=[=+-])"))]


def finer(piece: str, line: float = LINE) -> list[str]:
    """A piece cut before its products, if no line holds it: these begin with the sign of multiplication."""
    return [piece] if measure.latex(piece) <= TEX * line else [*_parted(piece, _cuts(r"(?=\\cdot )"))]


@cache
def _cuts(mark: str) -> re.Pattern[str]:
    return re.compile(rf"\\left(?![a-z])|\\right(?![a-z])|(?<!\\)[{{}}]|(?P<cut>{mark})")


def _parted(latex: str, cuts: re.Pattern[str]) -> Iterator[str]:
    depth, start = 0, 0
    for mark in cuts.finditer(latex):
        if mark["cut"] is None:
            depth += 1 if mark[0] in ("{", "\\left") else -1
        elif depth == 0:
            yield latex[start : mark.start()]
            start = mark.end()
    yield latex[start:]
