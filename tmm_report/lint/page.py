"""What the HTML of a note says, in the order of its pages: references, what is numbered, numbers, tables, drawings.

A note is well-formed, so that the standard library's own reader of XML takes it, five times as fast as its reader of
HTML. Only <main> is read: no declaration of a type of document, and so no entity, can stand in it.
"""

from __future__ import annotations

import re
from itertools import islice
from typing import NamedTuple
from xml.etree.ElementTree import Element, ParseError, fromstring

from tmm_report.profiles import Margins, Text
from tmm_report.records import dataclass
from tmm_report.report.paper.sheets import USUAL, Paper

DEEPEST = 100  # elements within one another: mathematics has some twenty


class Unread(Exception):
    """What is no note of this program's: why, and at which line."""

    def __init__(self, reason: str, line: int | None = None):
        super().__init__(reason)
        self.reason, self.line = reason, line


class Step(NamedTuple):
    """Something is referred to, or stands here. `name`: as its caption, its number or its heading calls it."""

    stands: bool
    anchor: str
    name: str = ""


class Number(NamedTuple):
    """A number that says where it stands in the results. `within`: the last anchor before it; `key`, `row`, `table`,
    `by`, `unit`, `size`: see `quantity.ref`."""

    text: str
    within: str
    node: Element
    key: str
    row: str
    table: str
    by: str
    unit: str
    size: str
    cell: bool  # it stands in a table

    @property
    def column(self) -> tuple[str, str, str, str]:
        """What it shares with others that are the same at other places."""
        return self.key, self.table, self.by, self.unit


class Spot(NamedTuple):
    """An element, and the last anchor before it or on it."""

    anchor: str
    node: Element


class Picture(NamedTuple):
    anchor: str
    svg: Element
    caption: str
    sheet: str  # the class of the sheet of its own, "" for none


@dataclass(frozen=True, eq=False)
class Page:
    """`paper`: what the note is printed on; `names`: of each anchor what stands there is called."""

    language: str
    paper: Paper
    root: Element
    steps: list[Step]
    names: dict[str, str]
    numbers: list[Number]
    tables: list[Spot]
    formulas: list[Spot]
    pictures: list[Picture]
    targets: dict[str, str]  # what a link leads to, and the anchor before the first such link

    def name(self, anchor: str) -> str:
        """What stands at an anchor as the note calls it."""
        return self.names.get(anchor) or anchor


_SVG = ' xmlns="http://www.w3.org/2000/svg"'
_MAIN = re.compile(r"<main>.*</main>", re.S)
_LANGUAGE = re.compile(r'<html lang="([a-z]{2})"')
_CAPTION = re.compile(r"^(.{1,40}?) [–—] ")


def read(html: str) -> Page:
    """Raises Unread."""
    main = _MAIN.search(html)
    if main is None:
        raise Unread("<main>")
    try:
        root = fromstring(main[0].replace(_SVG, ""))
    except ParseError as error:
        line = 1 + html.count("\n", 0, main.start()) + error.position[0] - 1
        raise Unread(str(error).partition(":")[0], line) from None
    _see_shallow(root)
    language = _LANGUAGE.search(html[:200])
    page = Page(
        language[1] if language else "", _paper(html[: main.start()]), root, [], {}, [], [], [], [], {}
    )
    _walk(page)
    return page


def _paper(head: str) -> Paper:
    """The paper as the style in the head of the note says it."""
    size, sides = _LETTERS.search(head), _MARGINS.search(head)
    if size is None or sides is None:
        return USUAL
    top, right, bottom, left = map(float, sides.groups())
    margins, text = Margins(left, right, top, bottom), Text(float(size[1]), 1.0, 0.0, 0.0)
    return Paper(margins, text)


_SIZE = r"(\d{1,3}(?:\.\d{1,3})?)"
_LETTERS = re.compile(rf"^body {{ font-size: {_SIZE}pt", re.M)
_MARGINS = re.compile(rf"^@page {{\s+margin: {_SIZE}mm {_SIZE}mm {_SIZE}mm {_SIZE}mm;", re.M)


def _see_shallow(root: Element) -> None:
    level = [root]
    for _ in range(DEEPEST):
        level = [child for node in level for child in node]
        if not level:
            return
    raise Unread(f"> {DEEPEST}")


def _walk(page: Page) -> None:
    anchor, last = "", ("", 0)
    sheets = {
        id(one): div.get("class", "")
        for div in page.root.iter("div")
        if _is(div, "sheet") or _is(div, "sideways")
        for one in div.iter("figure")
    }
    cells = {one for cell in page.root.iter("td") for one in cell.iter()}
    for node in page.root.iter():
        tag, own = node.tag, node.get("id")
        if own:
            anchor = own
            name = _named(node)
            page.names[own] = name
            page.steps.append(Step(True, own, name))
        if tag == "a":
            last = _referred(page, node, anchor, last)
        elif tag == "div" and node.get("class") == "formula":
            page.formulas.append(Spot(anchor, node))
        elif tag == "table":
            page.tables.append(Spot(anchor, node))
        elif tag == "figure":
            svg, caption = node.find("svg"), node.find("figcaption")
            if svg is not None:
                page.pictures.append(Picture(anchor, svg, said(caption), sheets.get(id(node), "")))
        if (key := node.get("data-q")) is not None and tag != "g":
            row, table, by, unit, size = (
                node.get(f"data-{name}", "") for name in ("k", "t", "by", "u", "abs")
            )
            inside = node in cells
            page.numbers.append(Number(written(node), anchor, node, key, row, table, by, unit, size, inside))


def _is(node: Element, name: str) -> bool:
    return name in (node.get("class") or "").split()


def _named(node: Element) -> str:
    """What an element with an anchor is called: by its caption, its number in brackets, or its heading."""
    if node.tag == "figure":
        caption = node.find("figcaption")
    elif node.tag == "div" and _is(node, "table"):
        caption = next((p for p in node.iter("p") if _is(p, "caption")), None)
    elif node.tag == "div":
        caption = next((div for div in node.iter("div") if _is(div, "number")), None)
    else:
        return said(node)[:60]
    text = said(caption)
    match = _CAPTION.match(text)
    return match[1] if match else text[:40]


def _referred(page: Page, node: Element, anchor: str, last: tuple[str, int]) -> tuple[str, int]:
    """A link's target, and those between it and the last one, where the two are the ends of a range."""
    target = (node.get("href") or "").removeprefix("#")
    page.targets.setdefault(target, anchor)
    inner, last = between(target, last, (node.tail or "").startswith("–"))
    page.steps.extend(Step(False, one) for one in (*inner, target))
    return last


_END = re.compile(r"(\D*(?:\d+\.)*)(\d+)")


def between(target: str, last: tuple[str, int], goes_on: bool) -> tuple[list[str], tuple[str, int]]:
    """The anchors within a range that ends with this one; and, where one begins with it, its own beginning."""
    match = _END.fullmatch(target)
    if match is None:
        return [], ("", 0)
    number = int(match[2])
    first = last[1] + 1 if last[0] == match[1] and number - last[1] < 1000 else number
    inner = [f"{match[1]}{k}" for k in range(first, number)]
    return inner, (match[1], number) if goes_on else ("", 0)


def said(node: Element | None) -> str:
    """The text of an element on one line."""
    return "" if node is None else re.sub(r"\s+", " ", "".join(node.itertext())).strip()


def written(node: Element) -> str:
    """A number as text: that of its element, a power of ten with its sign: −1,35·10^-5."""
    if node.tag != "mrow":
        return (node.text or "") if len(node) == 0 else said(node)
    return "".join(_power(child) if child.tag == "msup" else said(child) for child in node)


def _power(node: Element) -> str:
    return "^".join(map(said, node)).replace("−", "-")


ROWS, CELLS = 5000, 200  # of a table: what is beyond them is not looked at


def rows(table: Element) -> list[list[Element]]:
    """The cells of a table row by row, without its head."""
    found = ([*islice(row.iter("td"), CELLS)] for row in islice(table.iter("tr"), ROWS))
    return [cells for cells in found if cells]


def heads(table: Element) -> list[Element]:
    return [*islice(table.iter("th"), CELLS)]
