"""Formulas of Office Math in lines: how wide they are, and where a long one breaks.

A formula comes in pieces parted by NEXT (`quantity.notations.omml`). A line is a formula of its own,
for LibreOffice breaks none. As in the other notes it breaks before a relation or a sign, which stands at the end of
the line, too; a product at a cross in place of its dot.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from itertools import accumulate, chain, pairwise
from xml.etree.ElementTree import Element, fromstring, register_namespace, tostring

from tmm_report.quantity.notations.omml import NEXT, leaning
from tmm_report.report.paper.lines import shared
from tmm_report.report.paper.measure import italic, letters, spaces

OFFICE_MATH = "http://schemas.openxmlformats.org/officeDocument/2006/math"
_NS = f"{{{OFFICE_MATH}}}"
_RELATIONS = frozenset("=≤≥≈≠→≪≫⩽⩾<>")
_SIGNS = frozenset("+−·")
_INDEX = (1.0, 0.7, 0.55)  # sizes of indices and of their own
_GAP, _ROOT, _TALL = (
    0.05,
    1.2,
    1.9,
)  # em behind an index, of the sign of a root; a bracket as tall as what is in it
register_namespace("m", OFFICE_MATH)


def _read(text: str) -> list[list[Element]]:
    """The elements of each piece."""
    row = "".join(f"<m:e>{piece}</m:e>" for piece in text.split(NEXT))
    return [list(piece) for piece in fromstring(f'<m:row xmlns:m="{OFFICE_MATH}">{row}</m:row>')]


def _kind(node: Element) -> str:
    return node.tag.removeprefix(_NS)


# --- widths ---


@lru_cache(maxsize=4096)
def wide(text: str) -> float:
    """A whole formula, in ems of the text around it."""
    return sum(map(_all, _read(text)))


def _all(nodes: Iterable[Element], level: int = 0) -> float:
    return sum(_wide(node, level) for node in nodes)


def _wide(node: Element, level: int) -> float:
    size = _INDEX[min(level, 2)]
    match _kind(node):
        case "r":
            return size * _run(node)
        case "f":
            return max(_all(part, level) for part in node) + 0.1
        case "sSub" | "sSup" | "sSubSup":
            base, *indices = node
            return _all(base, level) + max(_all(one, level + 1) for one in indices) + _GAP
        case "limLow":
            base, note = node
            return max(_all(base, level), _all(note, level + 1))
        case "rad":
            return _all(node[-1], level) + size * _ROOT
        case "d":
            tall = any(_kind(inner) in ("f", "rad") for inner in node[-1].iter())
            return _all(node[-1], level) + 2 * size * letters("(", "math") * (_TALL if tall else 1.0)
        case "func":
            return _all(node[0], level) + _all(node[1], level) + 0.17 * size
        case "nary":
            sub, sup, body = node[1:]
            return size + max(_all(sub, level + 1), _all(sup, level + 1)) + _all(body, level)
        case name if name.endswith("Pr"):
            return 0.0
    return _all(node, level)


def _run(node: Element) -> float:
    """Of one in its own size: words and numbers stand upright."""
    text = _said(node)
    if node.find(f"{_NS}rPr") is not None or text[:1].isdigit():
        return letters(text, "math")
    return sum(letters(italic(sign), "math") + spaces(sign) for sign in text)


def _said(node: Element) -> str:
    return "".join(one.text or "" for one in node.iter(f"{_NS}t"))


# --- lines ---

# beside a sign at the end of a line: LibreOffice shows an error where a term is missing
NOTHING = "\N{ZERO WIDTH SPACE}"


def in_line(text: str) -> str:
    """A formula within a sentence: an `m:oMath` a piece, as a line may break between them."""
    first, *others = text.split(NEXT)
    return _math(first) + "".join(_math(leaning(NOTHING) + piece) for piece in others)


def _math(text: str) -> str:
    return f"<m:oMath>{text}</m:oMath>"


def broken(text: str, line: float) -> list[str]:
    """A displayed formula as one `m:oMath` a line. `line`: what a line holds, ems; a piece that cannot be cut may be
    wider."""
    if wide(text) <= line:
        return [_math(text.replace(NEXT, ""))]
    pieces = [cut for piece in _read(text) for cut in _cut(piece, line)]
    widths = [_all(piece) for piece in pieces]
    ends = [0, *accumulate(shared(widths, [_sign(one) in _RELATIONS for one in pieces], line))]
    lines = [list(chain(*pieces[start:end])) for start, end in pairwise(ends)]
    signs = ["", *(_sign(one).replace("·", "×") for one in lines[1:]), ""]
    return [_written(one, *two) for one, two in zip(lines, pairwise(signs), strict=True)]


def _sign(piece: Sequence[Element]) -> str:
    """The relation or sign that a piece begins with."""
    said = _said(piece[0]) if piece and _kind(piece[0]) == "r" else ""
    return said if said in _RELATIONS | _SIGNS else ""


def _cut(piece: list[Element], line: float) -> Iterator[list[Element]]:
    """A piece that a line holds, or its terms and factors; the sign of the first term stays with its relation."""
    if _all(piece) <= line - 1.0:
        yield piece
        return
    row: list[Element] = []
    for node in piece:
        if len(row) > bool(_sign(row)) and _kind(node) == "r" and _said(node) in _SIGNS:
            yield row
            row = []
        row.append(node)
    yield row


def _written(row: Sequence[Element], before: str, after: str) -> str:
    """A line that begins with the sign `before` and ends with the next line's."""
    terms = row[1:] if before else row
    text = "".join(tostring(one, encoding="unicode") for one in terms)
    text = text.replace(f' xmlns:m="{OFFICE_MATH}"', "").replace(" />", "/>")
    first = leaning(NOTHING) + leaning(before) if before else ""
    last = leaning(after) + leaning(NOTHING) if after else ""
    return _math(first + text + last)
