"""A note as a reader sees it: tables with heads and cells, formulas with their sides, numbers with their marks.

Nothing of the program is used. A mark is what an element says of the place of its number in results.json.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple
from xml.etree.ElementTree import Element, fromstring

from printed import LEAST, Printed, Unit, number, unit

_SVG = re.compile(r"<svg.*?</svg>", re.S)
_BAR = re.compile(r'<svg class="bar".*?</svg>')  # a length to measure, no drawing of the mechanism
_AGAIN = re.compile(
    r'<math class="again"[^>]*><mo [^>]*>[^<]*</mo></math><br/>'
)  # a sign repeated at a line's end
_CROSS = '<math><mo form="infix">×</mo>'  # with which a product goes on in the next line
_KEPT = re.compile(r"<nobr>(.*?)</nobr>", re.S)  # that no line ends beside a formula
_MAIN = re.compile(r"<main>.*</main>", re.S)


class Mark(NamedTuple):
    """The data attributes of an element: key, row, table, column that is read of rows, unit of print, magnitude."""

    key: str
    row: int | None
    table: str
    by: str
    unit: str
    size: bool

    def __str__(self) -> str:
        place = f"{self.table}." if self.table else ""
        return f"{place}{self.key}{'' if self.row is None else f'[{self.row}]'}{'.' + self.by if self.by else ''}"


def mark_of(node: Element) -> Mark | None:
    key = node.get("data-q")
    if key is None:
        return None
    row = node.get("data-k")
    return Mark(
        key,
        None if row is None else int(row),
        node.get("data-t", ""),
        node.get("data-by", ""),
        node.get("data-u", ""),
        node.get("data-abs") == "1",
    )


# --- mathematics ---

_INDEXED = ("msub", "msubsup")


class Figure(NamedTuple):
    """A number of a formula with its mark; `degrees`: a degree sign follows."""

    printed: Printed
    mark: Mark | None
    text: str
    degrees: bool = False


def text_of(node: Element) -> str:
    """What an element says, without the bars above letters."""
    own = node.text or ""
    if node.tag == "mo" and own == "‾":
        own = ""
    return own + "".join(text_of(child) + (child.tail or "") for child in node)


def children(node: Element) -> list[Element]:
    """Without the spaces."""
    return [child for child in node if child.tag not in ("mspace", "wbr")]


def whole_number(node: Element) -> Figure | None:
    """The number that an element is: <mn>, or a row of its sign, digits and power of ten."""
    if node.tag == "mrow" and len(node) == 1:  # above or below the line of a fraction
        return whole_number(node[0])
    if node.tag == "mn":
        text = node.text or ""
    elif node.tag == "mrow" and (len(node) > 1 or mark_of(node) is not None):
        text = _row_text(node)
    else:
        return None
    printed = number(text)
    return None if printed is None else Figure(printed, mark_of(node), text)


def _row_text(node: Element) -> str:
    """The row of a number as text: −1,35·10^-5; other rows give what is no number."""
    parts = []
    for child in node:
        if child.tag == "msup" and text_of(child[0]) == "10":
            parts.append("10^" + text_of(child[1]).replace("−", "-"))
        elif child.tag in ("mn", "mo") and child.get("form") is None:
            parts.append(child.text or "")
        else:
            return "?"
    return "".join(parts)


def figures(nodes: list[Element]) -> Iterator[Figure]:
    """The numbers in order, without those in indices and powers."""
    for k, node in enumerate(nodes):
        found = whole_number(node)
        if found is not None:
            follows = nodes[k + 1] if k + 1 < len(nodes) else None
            degrees = follows is not None and follows.tag == "mtext" and follows.text == "°"
            yield found._replace(degrees=degrees)
        elif node.tag in _INDEXED or node.tag in ("msup", "munder", "mover"):
            yield from figures(children(node)[:1]) if node.tag == "msup" else ()
        else:
            yield from figures(children(node))


def symbols(nodes: list[Element]) -> Iterator[str]:
    """The symbols in order: letters with their indices; "l_OA", "ω_1^2", "ab" under a bar."""
    for node in nodes:
        if whole_number(node) is not None:
            continue
        if node.tag in _INDEXED or node.tag in ("mi", "mover") or (node.tag == "msup" and _letter(node[0])):
            yield symbol_text(node)
        elif node.tag == "msup":
            yield from symbols(children(node)[:1])
        elif node.tag not in ("mo", "mn", "mtext"):
            yield from symbols(children(node))


def _letter(node: Element) -> bool:
    return node.tag in ("mi", "mover") or (node.tag == "mrow" and len(node) == 1 and _letter(node[0]))


def symbol_text(node: Element) -> str:
    """v_BA, a_BA^n: index below and above as text."""
    if node.tag == "msub":
        return f"{text_of(node[0])}_{text_of(node[1])}"
    if node.tag == "msup":
        return f"{text_of(node[0])}^{text_of(node[1])}"
    if node.tag == "msubsup":
        return f"{text_of(node[0])}_{text_of(node[1])}^{text_of(node[2])}"
    if node.tag in ("math", "mrow", "span") and len(children(node)) == 1:
        return symbol_text(children(node)[0])
    if node.tag in ("math", "mrow", "span"):
        return "".join(symbol_text(child) for child in children(node))
    return text_of(node)


@dataclass(frozen=True, eq=False)
class Formula:
    """`sides`: what stands between the signs of equality; `unit`: printed after the last."""

    where: str
    sides: list[list[Element]]
    unit_text: str
    display: bool

    @cached_property
    def text(self) -> str:
        return " = ".join("".join(text_of(node) for node in side) for side in self.sides) + self.unit_text

    @property
    def symbol(self) -> str:
        return "".join(symbol_text(node) for node in self.sides[0])

    @cached_property
    def names(self) -> list[str]:
        """What each side is called: one that is a sum or a product is named by nothing."""
        return ["".join(symbol_text(node) for node in side) for side in self.sides]

    @cached_property
    def numbers(self) -> list[list[Figure]]:
        """Of each side, its numbers."""
        return [list(figures(side)) for side in self.sides]

    @property
    def unit(self) -> Unit | None:
        return unit(self.unit_text)

    @property
    def result(self) -> Printed | None:
        """The number at the end."""
        last = self.sides[-1]
        found = whole_number(last[0]) if len(last) == 1 else None
        return None if found is None else found.printed


RELATIONS = {"=": "=", "≈": "=", ">": ">", "<": "<", "≥": ">", "≤": "<", "⩾": ">", "⩽": "<"}


def formulas_of(maths: list[Element], where: str, display: bool) -> list[tuple[str, Formula]]:
    """What is printed side by side, cut at signs of comparison: the sign in front and a formula."""
    nodes = [node for math in maths for node in children(math)]
    cut: list[tuple[str, list[list[Element]]]] = [("", [[]])]
    for node in nodes:
        relation = RELATIONS.get(node.text or "", "") if node.tag == "mo" else ""
        if relation == "=":
            cut[-1][1].append([])
        elif relation:
            cut.append((relation, [[]]))
        else:
            cut[-1][1][-1].append(node)
    return [(relation, formula_of(sides, where, display)) for relation, sides in cut]


def formula_of(sides: list[list[Element]], where: str, display: bool) -> Formula:
    unit_text = ""
    if len(sides[-1]) > 1 and sides[-1][-1].tag == "mtext":
        last = sides[-1][-1].text or ""
        if unit(last) is not None:
            unit_text = last
            sides[-1] = sides[-1][:-1]
    return Formula(where, sides, unit_text, display)


# --- tables ---


@dataclass(frozen=True, eq=False)
class Cell:
    node: Element

    @cached_property
    def text(self) -> str:
        return text_of(self.node).strip()

    @property
    def mark(self) -> Mark | None:
        return mark_of(self.node)

    @cached_property
    def printed(self) -> Printed | None:
        return number(self.text) if len(self.node) == 0 else None


@dataclass(frozen=True, eq=False)
class Head:
    """Symbol and unit of a column or a row; a word has neither. `unit`: None where none is printed."""

    text: str
    symbol: str
    unit_text: str

    @property
    def unit(self) -> Unit | None:
        return unit(self.unit_text) if self.unit_text else None


def head_of(node: Element) -> Head:
    maths = list(node.iter("math"))
    symbol = symbol_text(maths[0]) if maths else ""
    outside = (node.text or "") + "".join(child.tail or "" for child in node)
    parts = [part.strip() for part in re.split(r"[,;]", outside.replace("\N{NO-BREAK SPACE}", " "))]
    units = [part for part in parts[1:] if part and unit(part) is not None]
    return Head(text_of(node).strip(), symbol, units[0] if units else "")


@dataclass(frozen=True, eq=False)
class Table:
    where: str
    caption: str
    heads: list[Head]
    rows: list[list[Cell]]
    words: bool

    def column(self, j: int) -> list[Cell]:
        return [row[j] for row in self.rows]

    def numbers(self, j: int) -> list[Printed]:
        """Raises ValueError for a column with other cells."""
        found = [cell.printed for cell in self.column(j)]
        if any(x is None for x in found):
            raise ValueError(f"{self.where}, column {j + 1}: not all cells are numbers")
        return [x for x in found if x is not None]

    def places(self, j: int) -> int:
        """Decimals of a column: those of the cell that has most."""
        return max((cell.printed.places for cell in self.column(j) if cell.printed), default=0)

    def whole(self, j: int) -> bool:
        """Whether a column of numbers is rounded to whole ones: its largest has its digits without decimals."""
        cells = [cell.printed for cell in self.column(j) if cell.printed]
        return not self.words and not self.places(j) and any(cell.digits >= LEAST for cell in cells)

    def aligned(self, j: int, cell: Cell) -> bool:
        """Whether a number has the decimals of its column's largest, not its own: in a table with text only where three
        digits are left of it, in a column of whole numbers of one column of the results, the largest with its digits.
        """
        if not self.words:
            return True
        numbers = [(one.printed, one.mark) for one in self.column(j) if one.printed]
        kinds = {(mark.table, mark.key, mark.by, mark.unit) if mark else None for _, mark in numbers}
        largest = max((printed.digits for printed, _ in numbers), default=0)
        few = cell.printed is None or cell.printed.digits < 3
        return len(kinds) == 1 and None not in kinds and not self.places(j) and largest >= LEAST and not few


@dataclass(frozen=True, eq=False)
class Note:
    root: Element
    drawings: dict[str, str]  # anchor of a figure -> svg

    @cached_property
    def tables(self) -> list[Table]:
        return list(_tables(self.root))

    @cached_property
    def formulas(self) -> list[Formula]:
        """All that has a sign of equality, displayed or in running text, in order."""
        return [formula for formula in self.maths if len(formula.sides) > 1]

    @cached_property
    def maths(self) -> list[Formula]:
        return [formula for chain in self.chains for _, formula in chain]

    @cached_property
    def chains(self) -> list[list[tuple[str, Formula]]]:
        """Formulas that stand side by side with signs of comparison between them."""
        return list(_maths(self.root, "", False))

    @property
    def comparisons(self) -> Iterator[tuple[str, str, bool]]:
        """Where, what and whether it holds: a comparison of two printed numbers."""
        for chain in self.chains:
            for (_, left), (relation, right) in itertools.pairwise(chain):
                one, other = left.result, right.result
                if one is not None and other is not None:
                    more = one.value >= other.value if relation == ">" else one.value <= other.value
                    yield left.where, f"{left.text} {relation} {right.text}", more

    @cached_property
    def marked(self) -> list[Element]:
        return [node for node in self.root.iter() if node.get("data-q") is not None]

    @cached_property
    def words(self) -> list[str]:
        """The text, then the letters, units and words of each drawing, in the order in which they were put there."""
        return [
            *_lines(self.root),
            *(f"{name}: {' | '.join(lettered(svg))}" for name, svg in self.drawings.items()),
        ]


def lettered(svg: str) -> list[str]:
    """What is written in a drawing, but for plain numbers: of a diagram the letters and units of its axes."""
    texts = ("".join(node.itertext()).strip() for node in fromstring(svg).iter() if node.tag.endswith("text"))
    return [text for text in texts if not re.fullmatch(r"[-−+]?[\d.,]*°?", text)]


def steady(lines: list[str]) -> list[str]:
    """The lines with 0 for what rounding leaves, below 1e-7: its digits are other ones on every processor, or none."""
    return [re.sub(r"\d+(?:[.,]\d+)?·10⁻(?:[¹²][⁰¹²³⁴⁵⁶⁷⁸⁹]|[⁸⁹])", "0", line) for line in lines]


def _tables(root: Element) -> Iterator[Table]:
    anchor, part = "", 0
    for box in root.iter("div"):
        if not (box.get("class") or "").startswith("table "):
            continue
        anchor, part = (box.get("id") or anchor), (part + 1 if box.get("id") is None else 1)
        caption = text_of(box.find("p"))  # type: ignore[arg-type]
        table = next(box.iter("table"))
        heads = [head_of(cell) for cell in table.iter("th")]
        rows = [[Cell(cell) for cell in row] for row in table.find("tbody")]  # type: ignore[union-attr]
        yield Table(f"{anchor}.{part}", caption, heads, rows, table.get("class") == "words")


def _maths(node: Element, where: str, display: bool) -> Iterator[list[tuple[str, Formula]]]:
    """Neighbouring `math` elements, parted by places where a line may break, are one formula."""
    where = node.get("id") or where
    display = display or node.get("class") == "math"
    run: list[Element] = []
    for child in node:
        if child.tag == "math":
            run.append(child)
        elif child.tag != "wbr":
            yield from _taken(run, where, display)
            yield from _maths(child, where, display)
        if child.tail:
            yield from _taken(run, where, display)
    yield from _taken(run, where, display)


def _taken(run: list[Element], where: str, display: bool) -> Iterator[list[tuple[str, Formula]]]:
    if run:
        yield formulas_of(run, where, display)
        run.clear()


_BLOCKS = {"p", "h1", "h2", "h3", "li", "tr", "figcaption"}


def _lines(root: Element) -> Iterator[str]:
    """The text of the note, a line for each paragraph, heading, item, row and formula."""
    for node in root.iter():
        formula = node.tag == "div" and (node.get("class") or "") == "formula"
        if node.tag == "tr":
            yield " | ".join(_plain(cell) for cell in node)
        elif node.tag in _BLOCKS or formula:
            yield _plain(node)


def _plain(node: Element) -> str:
    return re.sub(r"\s+", " ", _written(node)).strip()


def _written(node: Element) -> str:
    """Text in which indices, powers and fractions can be told."""
    if node.tag == "mspace":
        return " "
    if node.tag == "mfrac":
        return f"({_written(node[0])})/({_written(node[1])})"
    if node.tag == "msqrt":
        return "√(" + _inside(node) + ")"
    if node.tag == "msub":
        return f"{_written(node[0])}_{_written(node[1])}"
    if node.tag == "msup":
        return f"{_written(node[0])}^{_written(node[1])}"
    if node.tag == "msubsup":
        return f"{_written(node[0])}_{_written(node[1])}^{_written(node[2])}"
    if node.tag == "munder":
        return f"{_written(node[0])} [{_written(node[1])}]"
    return _inside(node)


def _inside(node: Element) -> str:
    return (node.text or "") + "".join(_written(child) + (child.tail or "") for child in node)


def read(html: str) -> Note:
    """A note of HTML; its drawings are kept as text."""
    match = _MAIN.search(_KEPT.sub(r"\1", html.replace("\N{WORD JOINER}", "")))
    if match is None:
        raise ValueError("a note has a <main>")
    drawings: dict[str, str] = {}

    def keep(svg: re.Match[str]) -> str:
        drawings[f"{len(drawings) + 1}"] = svg[0]
        return "<svg/>"

    text = _AGAIN.sub("<wbr/>", _SVG.sub(keep, _BAR.sub("", match[0]))).replace(
        _CROSS, _CROSS.replace("×", "·")
    )
    root = fromstring(text.replace("″", "′′"))  # one sign for what is two
    return Note(root, _by_anchor(root, drawings))


def _by_anchor(root: Element, drawings: dict[str, str]) -> dict[str, str]:
    found = {}
    texts = iter(drawings.values())
    for figure in root.iter("figure"):
        for _ in figure.iter("svg"):
            found[figure.get("id") or ""] = next(texts)
    return found
