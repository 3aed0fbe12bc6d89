"""What the macros of Word write, finished: the elements n:… become those of WordprocessingML, and each text gets a run.

    n:mark      a bookmark about what it holds          n:grid, n:row, n:cell    a table; widths in twips
    n:field     what the word processor reckons         n:end                    a section of the document ends here
    n:ref       a reference to a bookmark               n:link, n:page           a line of the contents, its page

A text that stands in no paragraph gets one, and a paragraph within another stands behind it, so that the document can
be opened whatever a department's template writes. Source: ECMA-376, part 1, 17.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from xml.etree.ElementTree import Element, SubElement, fromstring, register_namespace, tostring

from tmm_report.report.formats.docx import bookmark
from tmm_report.report.word.sections import NAMESPACES, Setup, W, element, section

_N, _M = "{tmm-report}", f"{{{NAMESPACES['m']}}}"
WORD_2013 = (
    "http://schemas.microsoft.com/office/word/2012/wordml"  # a choice for Word names it: never an element
)
_BLOCKS = frozenset((f"{W}p", f"{W}sdt", f"{_N}grid", f"{_N}end"))
_BLANKS = re.compile(r"[ \t\r\n]+")
for _name, _space in NAMESPACES.items():
    register_namespace(_name, _space)


def finished(text: str, setup: Setup) -> bytes:
    """The main part of the file. Raises ParseError for what is no XML."""
    root = fromstring(text)
    body = root[0]
    work = _Work(root)
    blocks = list(work.sections(work.blocks(body), setup))
    body.clear()
    body.extend(blocks)
    made = tostring(root, encoding="UTF-8", xml_declaration=True)
    return made.replace(b"<w:document ", f'<w:document xmlns:w15="{WORD_2013}" '.encode(), 1)


class _Work:
    """Of one document. `marks`: names of its bookmarks, and whether a paragraph's own number is meant by it."""

    def __init__(self, root: Element):
        self.marks = {
            bookmark(one.get("name", "")): one.get("counted") == "yes" for one in root.iter(f"{_N}mark")
        }
        self.placed: list[str] = []

    # ------------------------------------------------------------ sections

    def sections(self, blocks: Iterable[Element], setup: Setup) -> Iterator[Element]:
        """Blocks of the body, with the layout of its pages where a section ends: in its last paragraph."""
        before, layout, last = "", None, None
        for block in blocks:
            if block.tag == f"{_N}end":
                if last is not None and layout is None:  # else there is nothing that could end
                    kind = block.get("kind", "")
                    foot = list(self.blocks(block))
                    layout = section(block, setup, goes_on="columns" in (kind, before))
                    setup.keep(foot)
                    before = kind
                continue
            if last is not None:
                yield from _ended(last, layout)
                layout = None
            last = block
        if last is not None:
            yield last
        yield section(element("end"), setup) if layout is None else layout

    # ------------------------------------------------------------ blocks

    def blocks(self, parent: Element) -> Iterator[Element]:
        """The paragraphs and tables in a container; what stands loose between them in paragraphs of its own."""
        loose = element("p", element("pPr", element("pStyle", val="BodyText")))
        held = loose
        held[-1].tail = parent.text
        last: Element | None = None
        for node in parent:
            if node.tag not in _BLOCKS:
                held.append(node)
                continue
            made = [*self._paragraph(held), *self._block(node)]
            held = element("p", element("pPr", element("pStyle", val="BodyText")))
            held[-1].tail, node.tail = node.tail, None
            for one in made:
                yield from _apart(last, one)
                yield one
                last = one
        for one in self._paragraph(held):
            yield from _apart(last, one)
            yield one

    def _block(self, node: Element) -> Iterator[Element]:
        if node.tag == f"{W}p":
            yield from self._paragraph(node)
        elif node.tag == f"{_N}grid":
            yield self._table(node)
        elif node.tag == f"{W}sdt":
            content = node[-1]
            inner = [one for one in self.blocks(content) if one.tag != f"{_N}end"]
            content.clear()
            content.extend(inner)
            yield node
        else:
            yield node

    def _paragraph(self, node: Element) -> Iterator[Element]:
        """A paragraph with runs, or several where others stand in it; none where it says nothing."""
        style = node[0]
        style.tail, text = None, (style.tail or "").lstrip(" \t\r\n")
        parts: list[Element] = _runs(text)
        for k, child in enumerate(node[1:], 1):
            tail = child.tail or ""
            tail, child.tail = tail.rstrip(" \t\r\n") if k == len(node) - 1 else tail, None
            if child.tag in _BLOCKS:
                yield from _filled(style, parts)
                yield from self._block(child)
                parts = _runs(tail.lstrip(" \t\r\n"))
            else:
                parts += [*self._inline(child), *_runs(tail)]
        yield from _filled(style, parts)

    def _inline(self, node: Element, capitals: bool = False) -> list[Element]:
        """What stands in a line."""
        if node.tag == f"{W}r" or node.tag.startswith(_M):
            return [node]
        inner = _runs(node.text or "", capitals)
        kind = node.tag.removeprefix(_N)
        for child in node:
            inner += [
                *self._inline(child, capitals or kind == "capitals"),
                *_runs(child.tail or "", capitals),
            ]
        if kind == "capitals":
            for run in inner:
                _capitals(run)
        name = bookmark(node.get("name") or node.get("to") or node.get("of") or "")
        match kind:
            case "mark" if name not in self.placed:
                self.placed.append(name)
                number = str(len(self.placed))
                return [
                    element("bookmarkStart", id=number, name=name),
                    *inner,
                    element("bookmarkEnd", id=number),
                ]
            case "field":
                return [element("fldSimple", *inner, instr=f" {node.get('says')} ")]
            case "ref" if name in self.marks:
                command = f" REF {name} \\r \\h " if self.marks[name] else f" REF {name} \\h "
                return [element("fldSimple", *inner, instr=command)]
            case "page":
                return [element("fldSimple", *_runs(" "), instr=f" PAGEREF {name} \\h ")]
            case "link":
                return [element("hyperlink", *inner, anchor=name, history="1")]
        return inner

    # ------------------------------------------------------------ tables

    def _table(self, grid: Element) -> Element:
        """A table of fixed widths. One that is not `long` stays on one page; the head of the other is repeated."""
        widths = [int(one) for one in grid.get("widths", "").split()]
        lined, long = grid.get("lines") == "yes", grid.get("long") == "yes"
        how = [element("tblW", w=str(sum(widths)), type="dxa"), element("jc", val="center")]
        if lined:
            sides = ("top", "left", "bottom", "right", "insideH", "insideV")
            how.append(element("tblBorders", *(_line(side) for side in sides)))
        room = "57" if lined else grid.get("room", "0")
        how += [
            element("tblLayout", type="fixed"),
            element("tblCellMar", *(element(side, w=room, type="dxa") for side in ("left", "right"))),
        ]
        columns = element("tblGrid", *(element("gridCol", w=str(width)) for width in widths))
        table = element("tbl", element("tblPr", *how), columns)
        rows = list(grid)
        for k, row in enumerate(rows):
            kept = lined and (k < 2 and len(rows) > 2 if long else k < len(rows) - 1)
            table.append(self._row(row, widths, grid.get("align", "center"), kept))
        return table

    def _row(self, row: Element, widths: list[int], align: str, kept: bool) -> Element:
        made = element("tr", element("trPr", element("cantSplit")))
        if row.get("head") == "yes":
            SubElement(made[0], f"{W}tblHeader")
        for cell, width in zip(row, widths, strict=True):
            blocks = [one for one in self.blocks(cell) if one.tag != f"{_N}end"]
            if not blocks or blocks[-1].tag != f"{W}p":
                blocks.append(element("p", element("pPr", element("pStyle", val="TableText"))))
            for block in blocks if kept else ():
                _keep(block)
            how = element("tcPr", element("tcW", w=str(width), type="dxa"))
            if cell.get("rule") == "yes":
                how.append(element("tcBorders", _line("bottom")))
            how.append(element("vAlign", val=align))
            made.append(element("tc", how, *blocks))
        return made


def _line(side: str) -> Element:
    return element(side, val="single", sz="4", space="0", color="000000")


def _keep(block: Element) -> None:
    """On the page of the next block."""
    if block.tag == f"{W}p":
        block[0].insert(1, element("keepNext"))


def _apart(last: Element | None, one: Element) -> Iterator[Element]:
    """What stands between a table and what follows: two that touch would be one, and text would touch it."""
    if last is None or last.tag != f"{W}tbl":
        return
    if last[0].find(f"{W}tblBorders") is not None:
        yield element("p", element("pPr", element("pStyle", val="AfterTable")))
    elif one.tag == f"{W}tbl":
        yield element("p", element("pPr", element("pStyle", val="Between")))


def _ended(last: Element, layout: Element | None) -> Iterator[Element]:
    """The last block of a section with its layout: not in a paragraph with a bookmark, which LibreOffice would lose."""
    if layout is None:
        yield last
    elif last.tag == f"{W}p" and last.find(f"{W}bookmarkStart") is None:
        last[0].append(layout)
        yield last
    else:
        yield last
        yield element("p", element("pPr", element("pStyle", val="Between"), layout))


def _filled(style: Element, parts: list[Element]) -> Iterator[Element]:
    """A paragraph of such a style; none where a paragraph of the text says nothing."""
    if parts or style[0].get(f"{W}val") != "BodyText":
        yield element("p", element("pPr", *style), *parts)


def _runs(text: str, capitals: bool = False) -> list[Element]:
    """A text as a run, its blanks as one."""
    if not text:
        return []
    said = element("t")
    said.set("{http://www.w3.org/XML/1998/namespace}space", "preserve")
    said.text = _BLANKS.sub(" ", text)
    run = element("r", said)
    if capitals:
        _capitals(run)
    return [run]


def _capitals(run: Element) -> None:
    if run.tag == f"{W}r" and run[0].tag != f"{W}rPr":
        run.insert(0, element("rPr", element("caps")))
