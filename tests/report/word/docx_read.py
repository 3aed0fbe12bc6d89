"""A file for word processors read back: its parts, and what Word would reckon in it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from io import BytesIO
from xml.etree.ElementTree import Element, fromstring
from zipfile import ZipFile

from tmm_report.report.word.sections import NAMESPACES

W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
M = "{http://schemas.openxmlformats.org/officeDocument/2006/math}"
R = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}"
WP = "{http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing}"
A = "{http://schemas.openxmlformats.org/drawingml/2006/main}"


_PREFIX = {space: name for name, space in NAMESPACES.items()}
ORDER = {  # of what a note has in them (ECMA-376, part 1, annex A)
    "w:pPr": "w:pStyle w:keepNext w:keepLines w:pageBreakBefore w:framePr w:numPr w:tabs w:suppressAutoHyphens "
    "w:spacing w:ind w:jc w:outlineLvl w:rPr w:sectPr",
    "w:rPr": "w:rFonts w:b w:i w:caps w:sz w:szCs w:lang",
    "w:sectPr": "w:headerReference w:footerReference w:type w:pgSz w:pgMar w:cols w:vAlign w:titlePg",
    "w:style": "w:name w:basedOn w:next w:qFormat w:pPr w:rPr w:tblPr",
    "w:styles": "w:docDefaults w:style", "w:docDefaults": "w:rPrDefault w:pPrDefault",
    "w:numbering": "w:abstractNum w:num", "w:abstractNum": "w:multiLevelType w:lvl", "w:numPr": "w:ilvl w:numId",
    "w:lvl": "w:start w:numFmt w:pStyle w:suff w:lvlText w:lvlJc",
    "w:settings": "w:autoHyphenation w:doNotHyphenateCaps w:updateFields w:compat m:mathPr w:themeFontLang "
    "w:decimalSymbol w:listSeparator",
    "w:sdt": "w:sdtPr w:sdtContent", "w:docPartObj": "w:docPartGallery w:docPartUnique",
    "w:tbl": "w:tblPr w:tblGrid w:tr", "w:tr": "w:trPr w:tc", "w:trPr": "w:cantSplit w:tblHeader",
    "w:tblPr": "w:tblW w:jc w:tblInd w:tblBorders w:tblLayout w:tblCellMar",
    "w:tblBorders": "w:top w:left w:bottom w:right w:insideH w:insideV",
    "w:tblCellMar": "w:top w:left w:bottom w:right", "w:tcPr": "w:tcW w:tcBorders w:vAlign",
    "m:mathPr": "m:mathFont m:brkBin m:defJc", "m:r": "m:rPr m:t", "m:f": "m:num m:den", "m:func": "m:fName m:e",
    "m:bar": "m:barPr m:e", "m:d": "m:dPr m:e", "m:dPr": "m:begChr m:endChr", "m:rad": "m:radPr m:deg m:e",
    "m:limLow": "m:e m:lim", "m:nary": "m:naryPr m:sub m:sup m:e", "m:naryPr": "m:chr m:limLoc",
    "m:sSub": "m:e m:sub", "m:sSup": "m:e m:sup", "m:sSubSup": "m:e m:sub m:sup",
    "wp:inline": "wp:extent wp:docPr wp:cNvGraphicFramePr a:graphic",
    "wp:anchor": "wp:simplePos wp:positionH wp:positionV wp:extent wp:effectExtent wp:wrapNone wp:docPr "
    "wp:cNvGraphicFramePr a:graphic",
    "pic:pic": "pic:nvPicPr pic:blipFill pic:spPr", "pic:nvPicPr": "pic:cNvPr pic:cNvPicPr",
    "pic:blipFill": "a:blip a:stretch", "pic:spPr": "a:xfrm a:prstGeom", "a:xfrm": "a:off a:ext",
}  # fmt: skip
FREE = frozenset((  # behind their properties, or before those of the last section
    "w:body", "w:sdtContent", "w:tc", "w:p", "w:r", "w:hyperlink", "w:hdr", "w:ftr",
    "m:oMath", "m:e", "m:num", "m:den", "m:sub", "m:sup", "m:deg", "m:lim", "m:fName",
))  # fmt: skip


def disordered(root: Element) -> list[tuple[str, list[str]]]:
    """Elements whose children stand in no order that Word would open, or are none that are known of it."""
    found = []
    for node in root.iter():
        name, inner = _named(node), list(map(_named, node))
        if len(set(inner)) < 2:
            continue
        if name in FREE:
            last = name == "w:body"
            held = inner.count(f"{name}Pr") == (inner[0] == f"{name}Pr") and inner.count("w:sectPr") == last
            good = held and (inner[-1] == "w:sectPr") == last
        else:
            order = ORDER.get(name, "").split()
            good = set(inner) <= set(order) and inner == sorted(inner, key=order.index)
        if not good:
            found.append((name, inner))
    return found


def _named(node: Element) -> str:
    space, _, name = node.tag[1:].rpartition("}")
    return f"{_PREFIX.get(space, space)}:{name}"


def parts_of(file: bytes) -> dict[str, bytes]:
    with ZipFile(BytesIO(file)) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def document_of(file: bytes) -> Element:
    return fromstring(parts_of(file)["word/document.xml"])


def text_of(node: Element) -> str:
    """What is printed of it: text and mathematics, without what the word processor numbers itself."""
    return "".join(one.text or "" for one in node.iter() if one.tag in (f"{W}t", f"{M}t"))


def style_of(paragraph: Element) -> str:
    found = paragraph.find(f"{W}pPr/{W}pStyle")
    return "" if found is None else found.get(f"{W}val", "")


def commands(root: Element) -> Iterator[tuple[str, str]]:
    """What its fields say, and what stands there."""
    for one in root.iter(f"{W}fldSimple"):
        yield " ".join(one.get(f"{W}instr", "").split()), text_of(one)
    for one in root.iter(f"{W}instrText"):
        yield " ".join((one.text or "").split()), ""


def marks(root: Element) -> dict[str, tuple[str, Element]]:
    """Bookmarks: the text in each, and the paragraph that it is in."""
    found: dict[str, tuple[str, Element]] = {}
    for paragraph in root.iter(f"{W}p"):
        open_now: dict[str, list[str]] = {}
        names: dict[str, str] = {}
        for one in paragraph.iter():
            if one.tag == f"{W}bookmarkStart":
                names[one.get(f"{W}id", "")] = one.get(f"{W}name", "")
                open_now[one.get(f"{W}id", "")] = []
            elif one.tag == f"{W}bookmarkEnd":
                number = one.get(f"{W}id", "")
                assert names[number] not in found, names[number]
                found[names[number]] = ("".join(open_now.pop(number)), paragraph)
            elif one.tag in (f"{W}t", f"{M}t"):
                for texts in open_now.values():
                    texts.append(one.text or "")
        assert not open_now
    return found


class Reckoner:
    """What Word makes of the numbers of a document: its own counts of headings, lists and sequences."""

    def __init__(self, root: Element):
        self.heads = [0, 0, 0]
        self.lists = 0
        self.sequences: dict[str, int] = {}
        self.begun: set[str] = set()  # sequences that the heading before starts anew
        self.said: list[tuple[str, str, str]] = []  # command, what Word reckons, what stands there
        self.numbers: dict[int, str] = {}  # of paragraphs
        for paragraph in root.iter(f"{W}p"):
            self._counted(paragraph)
            for field in paragraph.iter(f"{W}fldSimple"):
                command = " ".join(field.get(f"{W}instr", "").split())
                if command.startswith(("SEQ", "STYLEREF")):
                    self.said.append((command, self._reckoned(command), text_of(field)))

    def _counted(self, paragraph: Element) -> None:
        style = style_of(paragraph)
        if style == "Reference":
            self.lists += 1
            self.numbers[id(paragraph)] = str(self.lists)
        if not re.fullmatch("Heading[123]", style) or paragraph.find(f"{W}pPr/{W}numPr") is not None:
            return
        level = int(style[-1])
        self.heads = [*self.heads[: level - 1], self.heads[level - 1] + 1, *[0] * (3 - level)]
        self.numbers[id(paragraph)] = ".".join(map(str, self.heads[:level]))
        if level == 1:
            self.begun = set(self.sequences)

    def _reckoned(self, command: str) -> str:
        if command.startswith("STYLEREF"):
            return str(self.heads[0])
        name = command.split()[1]
        again = re.search(r"\\r (\d+)", command)
        if again:
            self.sequences[name] = int(again[1])
        elif "\\s 1" in command and name in self.begun:
            self.sequences[name] = 1
        else:
            self.sequences[name] = self.sequences.get(name, 0) + 1
        self.begun.discard(name)
        return str(self.sequences[name])
