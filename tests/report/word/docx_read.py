"""A file for word processors read back: its parts, and what Word would reckon in it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from io import BytesIO
from xml.etree.ElementTree import Element, fromstring
from zipfile import ZipFile

W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
M = "{http://schemas.openxmlformats.org/officeDocument/2006/math}"
R = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}"
WP = "{http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing}"
A = "{http://schemas.openxmlformats.org/drawingml/2006/main}"


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
