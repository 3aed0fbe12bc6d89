"""The parts of an XLSX workbook, XML files in a ZIP archive, walked as streams of events under budgets.

A document type, which every attack by entities needs, ends the reading before the first entity is declared.
"""

from __future__ import annotations

import io
import posixpath
import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any
from xml.parsers import expat

from tmm_report.intake import archive
from tmm_report.intake.archive import Member
from tmm_report.problems import N_, Message, ProblemError, mistake, shown

BYTES = 5 * 2**20  # of the file
UNPACKED = 20 * 2**20  # of all its parts
ELEMENTS = 1_000_000  # of XML, in all parts that are read
TAG = 2**20  # bytes from one element to the next

_HUGE = re.compile(rb"<[^<]{%d}" % TAG)
_OLD = b"\xd0\xcf\x11\xe0"  # what workbooks begin with that are encrypted, or in the format before XLSX


class Enough(Exception):
    """All that is to be read of a part was read."""


class Reader:
    """Passes over everything."""

    def start(self, name: str, attributes: dict[str, str]) -> None: ...

    def end(self, name: str) -> None: ...

    def text(self, text: str) -> None: ...


def local(name: str) -> str:
    return name.rpartition(":")[2] if ":" in name else name


class _Attributes(Reader):
    def __init__(self, element: str):
        self.element, self.found = element, list[dict[str, str]]()

    def start(self, name: str, attributes: dict[str, str]) -> None:
        if local(name) == self.element:
            self.found.append(attributes)


class Parts:
    """The parts of a workbook by their paths, and what is left of the budget of elements."""

    def __init__(self, label: str, content: bytes):
        self.label, self.left, self.unread = label, ELEMENTS, UNPACKED
        if content.startswith(_OLD):
            right = Message(N_("save it as .xlsx without a password"))
            raise self.refused(N_("the workbook has a password or an old format"), right)
        if len(content) > BYTES:
            raise self.refused(N_("the file is larger than %(limit)s kB"), limit=BYTES // 1024)
        self.stream = io.BytesIO(content)
        self.members = self.listed()

    def listed(self) -> dict[str, Member]:
        """The parts by their paths in lower case, as the names of parts are compared."""
        found, problems = archive.members(
            self.stream, self.label, lambda name: not name.endswith("/"), each=UNPACKED, total=UNPACKED
        )
        if problems:
            raise ProblemError(problems)
        return {member.name.lower(): member for member in found}

    def refused(self, text: str, right: Message | None = None, **values: Any) -> ProblemError:
        return ProblemError([replace(mistake(text, (), right, **values), file=self.label)])

    def main(self) -> str:
        """The path of the workbook's own part."""
        for kind, path in self.relations("").values():
            if kind.endswith("/officeDocument"):
                return path
        raise self.refused(N_("this is not a workbook"))

    def relations(self, part: str) -> dict[str, tuple[str, str]]:
        """Id -> (kind, path) of the parts that a part refers to; those outside the file are not among them."""
        folder, name = posixpath.split(part)
        found = {}
        for relation in self.attributes(posixpath.join(folder, "_rels", f"{name}.rels"), "Relationship"):
            target = posixpath.normpath(posixpath.join("/", folder, relation.get("Target", ""))).lstrip("/")
            if relation.get("TargetMode") != "External":
                found[relation.get("Id", "")] = relation.get("Type", ""), target
        return found

    def attributes(self, path: str, element: str) -> list[dict[str, str]]:
        """The attributes of each element of a name in a part."""
        collected = _Attributes(element)
        self.walk(path, collected)
        return collected.found

    def walk(self, path: str, reader: Reader) -> None:
        """Hand the events of a part to a reader's `start`, `end`, `text`. A part that is missing has none."""
        member = self.members.get(path.lower())
        if member is None:
            return
        self.unread -= member.size
        if self.unread < 0:
            raise self.refused(N_("the workbook reads its parts again and again, as no honest one does"))
        data = archive.content(self.stream, member, f"{self.label}:{shown(path, 200)}")
        if _HUGE.search(data):
            raise self.refused(N_("the workbook is broken: its part %(part)s"), part=shown(path))
        parser = expat.ParserCreate()
        parser.buffer_text = True
        parser.StartDoctypeDeclHandler = self.doctype
        parser.StartElementHandler = self.counted(reader.start)
        parser.EndElementHandler, parser.CharacterDataHandler = reader.end, reader.text
        try:
            parser.Parse(data, True)
        except Enough:
            return
        except (expat.ExpatError, ValueError, LookupError):
            raise self.refused(N_("the workbook is broken: its part %(part)s"), part=shown(path)) from None

    def doctype(self, *_: Any) -> None:
        raise self.refused(N_("the workbook declares a document type, as no honest one does"))

    def counted(self, start: Callable[[str, dict[str, str]], None]) -> Callable[[str, dict[str, str]], None]:
        """The handler of elements within the budget; it also bounds what the parser keeps of open elements."""

        def counting(name: str, attributes: dict[str, str]) -> None:
            self.left -= 1
            if self.left < 0:
                raise self.refused(N_("the workbook has too many cells"))
            start(name, attributes)

        return counting
