"""Untrusted YAML -> plain data, with the line and column of every key. Every mistake is a Problem.

The text is read as a stream of events under budgets: reading stops at the first event deeper than `DEPTH`, so
hostile nesting is never parsed; no alias is followed and no tag is obeyed. Scalars are those of YAML 1.2:
`no`, `on`, `12:30`, `017` and dates are text, `1e5` is a number. Infinite and undefined
numbers (`.inf`, `.nan`, `1e999`) stay text, so every number of the data is finite.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import field, replace
from typing import Any

import yaml

from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.records import dataclass
from tmm_report.yamlread.commas import Item, is_left_out, is_plain, meant, rejoined
from tmm_report.yamlread.marks import MARKS, composed
from tmm_report.yamlread.opening import file_label, larger, opened, stream

__all__ = [
    "BYTES", "DEPTH", "DIGITS", "EVENTS", "MARKS", "Document", "OfFile", "Path", "Place", "composed",
    "file_label", "loads", "located", "opened", "read", "stream",
]  # fmt: skip

BYTES = 256 * 1024
DEPTH = 16
EVENTS = 20_000
DIGITS = 40  # the longest text of a number

Path = tuple[str | int, ...]
Place = tuple[int, int]


class OfFile(tuple[int, int]):
    """A place of another file than the document's."""

    file: str

    def __new__(cls, place: Place, file: str) -> OfFile:
        made = super().__new__(cls, place)
        made.file = file
        return made


_PARSER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # only its events are used
_INT = re.compile(r"[-+]?(0|[1-9][0-9]*)")
_FLOAT = re.compile(r"[-+]?(\.[0-9]+|(0|[1-9][0-9]*)(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
_WORDS: dict[str, bool | None] = {"": None, "~": None, "null": None, "Null": None, "NULL": None}
_WORDS |= {"true": True, "True": True, "TRUE": True, "false": False, "False": False, "FALSE": False}
_CONTROL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufffe\uffff]")
_UTF8 = Message(N_("save the file as UTF-8"))


@dataclass(frozen=True)
class Document:
    """A read file. Keys are always text; values are dict, list, str, int, float, bool or None.

    `places`: path -> (line, column), counted from 1, of the key (in a list: of the item). `raw`: path ->
    a value that was not quoted, as it was written: `1.10` and `true` for those who want them as text.
    """

    data: Any
    places: Mapping[Path, Place] = field(default_factory=dict)
    raw: Mapping[Path, str] = field(default_factory=dict)
    commas: Mapping[Path, str] = field(default_factory=dict)
    """Lists in which a comma may be a decimal one, as they would be written then."""


def located(problem: Problem, places: Mapping[Path, Place], file: str) -> Problem:
    """The problem with file, line and column of its key, or of the nearest key around it."""
    if problem.line is not None:
        return problem if problem.file else _printable(problem, file)
    path = problem.path
    around = (path[:n] for n in range(len(path), -1, -1))
    place = next((places[part] for part in around if part in places), (None, None))
    file = place.file if isinstance(place, OfFile) else file
    return replace(_printable(problem, file), line=place[0], column=place[1])


def read(path: str | os.PathLike[str], soft: list[Problem] | None = None) -> Document:
    """Read a regular file; see `loads`. Links, devices, pipes and folders are refused, never waited on."""
    file = file_label(path)
    return loads(opened(path, file, BYTES), file, soft)


def loads(source: str | bytes, file: str = "", soft: list[Problem] | None = None) -> Document:
    """Parse one YAML document of at most 256 kB, 16 levels and 20 000 events.

    Raises ProblemError. Mistakes after which reading can go on (a key twice) are added to `soft` when it is
    given and raised at the end when it is not.
    """
    problems: list[Problem] = [] if soft is None else soft
    try:
        document = _document(_text(source), problems)
    except ProblemError as error:
        raise ProblemError([_printable(problem, file) for problem in [*problems, *error.problems]]) from None
    problems[:] = [_printable(problem, file) for problem in problems]
    if soft is None and problems:
        raise ProblemError(problems)
    return document


def _printable(problem: Problem, file: str) -> Problem:
    path = tuple(shown(part) if isinstance(part, str) else part for part in problem.path)
    return replace(problem, path=path, file=problem.file or file)


def _text(source: str | bytes) -> str:
    size = len(source) if isinstance(source, bytes) else len(source.encode("utf-8", "surrogatepass"))
    if size > BYTES:
        raise ProblemError([larger(BYTES)])
    text = _decoded(source) if isinstance(source, bytes) else source
    text = text.removeprefix("\ufeff")
    if bad := _CONTROL.search(text):
        raise _stop(N_("a control character is not allowed"), _place(text, bad.start()), right=_UTF8)
    return text


def _decoded(source: bytes) -> str:
    if source.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise _stop(N_("the file is in UTF-16"), (1, 1), right=_UTF8)
    try:
        return source.decode("utf-8")
    except UnicodeDecodeError as error:
        place = _place(source[: error.start].decode("utf-8"), error.start)
        raise _stop(N_("the file is not in UTF-8"), place, right=_UTF8) from None


def _place(text: str, index: int) -> Place:
    before = text[:index]
    return before.count("\n") + 1, len(before) - before.rfind("\n")


def _stop(
    text: str, place: Place, path: Path = (), right: Message | None = None, **values: Any
) -> ProblemError:
    problem = mistake(text, path, right, **values)
    return ProblemError([replace(problem, line=place[0], column=place[1])])


def _document(text: str, soft: list[Problem]) -> Document:
    composer = _Composer(_events(text), soft)
    try:
        data = composer.document()
    except yaml.YAMLError as error:
        raise _syntax(error, text) from None
    return Document(data, composer.places, composer.raw, composer.commas)


def _events(text: str) -> Iterator[Any]:
    """The parser's events, lazily: what lies beyond a refused event is never parsed."""
    for count, event in enumerate(yaml.parse(text, Loader=_PARSER)):
        if count > EVENTS:
            raise _stop(N_("the file has too many values"), _start(event))
        yield event


def _start(event: Any) -> Place:
    return event.start_mark.line + 1, event.start_mark.column + 1


def _syntax(error: yaml.YAMLError, text: str) -> ProblemError:
    from tmm_report.yamlread.slips import slip  # only a broken text needs it

    found = slip(error, text)
    problem = Problem(found.wrong, found.right)
    return ProblemError([replace(problem, line=found.place[0], column=found.place[1])])


class _Composer:
    """Events -> data. It holds the stream's state: the places met so far and the soft mistakes."""

    def __init__(self, events: Iterator[Any], soft: list[Problem]):
        self.events, self.soft = events, soft
        self.places: dict[Path, Place] = {(): (1, 1)}
        self.raw: dict[Path, str] = {}
        self.commas: dict[Path, str] = {}

    def document(self) -> Any:
        next(self.events)  # the start of the stream
        if isinstance(next(self.events), yaml.StreamEndEvent):
            return None
        data = self.node(next(self.events), ())
        next(self.events)  # the end of the document
        if not isinstance(event := next(self.events), yaml.StreamEndEvent):
            right = Message(N_("one file, one document"))
            raise _stop(N_("a second document begins here"), _start(event), right=right)
        return data

    def node(self, event: Any, path: Path) -> Any:
        """The value that begins with the event. It consumes the value's events up to its end."""
        self.refuse_references(event, path)
        if isinstance(event, yaml.ScalarEvent):
            return self.scalar(event, path)
        if len(path) >= DEPTH:
            raise _stop(N_("nested deeper than %(limit)s levels"), _start(event), limit=DEPTH)
        if isinstance(event, yaml.MappingStartEvent):
            return self.mapping(path, bool(event.flow_style))
        return self.sequence(path, bool(event.flow_style))

    def refuse_references(self, event: Any, path: Path) -> None:
        if isinstance(event, yaml.AliasEvent) or event.anchor is not None:
            raise _stop(N_("anchors (&) and aliases (*) are not allowed"), _start(event), path, _WRITE_OUT)
        if event.tag is not None:
            raise _stop(N_("the tag %(tag)s is not allowed"), _start(event), path, tag=shown(event.tag))

    def sequence(self, path: Path, flow: bool) -> list[Any]:
        items: list[Any] = []
        plain: list[Any] = []
        while not isinstance(event := next(self.events), yaml.SequenceEndEvent):
            here = (*path, len(items))
            self.places[here] = _start(event)
            items.append(self.node(event, here))
            if flow and is_plain(event):
                plain.append(event)
        if len(plain) == len(items) and (text := rejoined(plain)):
            self.commas[path] = text
        return items

    def mapping(self, path: Path, flow: bool) -> dict[str, Any]:
        items: dict[str, Any] = {}
        last: tuple[str, Any] | None = None  # the key before, and the event of its value
        while not isinstance(event := next(self.events), yaml.MappingEndEvent):
            key = self.key(event, path)
            value = next(self.events)
            if flow and is_left_out(value, event) and (item := meant(key, event, last)):
                self.slip(item, (*path, item.key), _start(event), items)
                continue
            here = (*path, key)
            if key in items:
                self.soft.append(self.duplicate(here, _start(event)))
                self.node(value, (*path, f"{key} (2)"))  # the first one's places stay
                continue
            self.places[here] = _start(event)
            items[key] = self.node(value, here)
            last = (key, value) if is_plain(value) else None
        return items

    def slip(self, meant: Item, path: Path, place: Place, items: dict[str, Any]) -> None:
        """Read what was meant, and keep the mistake."""
        if not meant.joined and meant.key in items:
            self.soft.append(self.duplicate(path, place))
            return
        self.places.setdefault(path, place)
        problem = Problem(meant.wrong, meant.right, path)
        self.soft.append(replace(problem, line=self.places[path][0], column=self.places[path][1]))
        items[meant.key] = self.plain(meant.value, path, place)

    def key(self, event: Any, path: Path) -> str:
        self.refuse_references(event, path)
        if not isinstance(event, yaml.ScalarEvent):
            raise _stop(N_("a key must be a single word"), _start(event), path)
        if event.value == "<<" and event.implicit[0]:
            raise _stop(N_("merge keys (<<) are not allowed"), _start(event), path, _WRITE_OUT)
        return _checked_text(event, path)

    def duplicate(self, path: Path, place: Place) -> Problem:
        text = N_("the key is written twice, on lines %(first)s and %(second)s")
        problem = mistake(text, path, Message(N_("keep one")), first=self.places[path][0], second=place[0])
        return replace(problem, line=place[0], column=place[1])

    def scalar(self, event: Any, path: Path) -> Any:
        text = _checked_text(event, path)
        return self.plain(text, path, _start(event)) if event.implicit[0] else text

    def plain(self, text: str, path: Path, place: Place) -> Any:
        """What a text without quotes is."""
        self.raw[path] = text
        if text in _WORDS:
            return _WORDS[text]
        if not _FLOAT.fullmatch(text):
            return text
        if len(text) > DIGITS:
            raise _stop(N_("the number %(number)s is too long"), place, path, number=shown(text))
        if _INT.fullmatch(text):
            return int(text)
        return float(text) if math.isfinite(float(text)) else text


_WRITE_OUT = Message(N_("write the values out"))


def _checked_text(event: Any, path: Path) -> str:
    """The scalar's text in the composed form (NFC), so that й typed in two ways is one letter."""
    if bad := _CONTROL.search(event.value):  # from an escape in quotes
        text = N_("the character U+%(code)s is not allowed")
        raise _stop(text, _start(event), path, code=f"{ord(bad.group()):04X}")
    try:
        return composed(event.value)
    except ValueError:
        text = N_("more than %(limit)s marks stand upon one letter")
        raise _stop(text, _start(event), path, limit=MARKS) from None
