"""Plain data -> YAML that people read, with holes left for what is written in later; read again it is the same data.

Foreign text is never structure: what is not plainly a word or a number with a unit goes into double quotes, with
everything in it that a reader of YAML might take for its own escaped.
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from tmm_report.yamlread import Path

WIDTH = 96  # what fits into a line is written in braces
HOLE = 8  # characters that a value written in later may take
OPEN = 3  # levels of keys that stand each on a line of their own

Piece = str | Path
"""A part of a text, or the path of a value that is written in its place later."""

_PLAIN = re.compile(r"-?[^\W_](?:[\w .^*/·²³⁴°%+-]*[\w.²³⁴°%])?")
_NUMBER = re.compile(r"[-+]?\.?[0-9][0-9.]*([eE][-+]?[0-9]+)?")
_WORDS = frozenset({"null", "Null", "NULL", "true", "True", "TRUE", "false", "False", "FALSE"})


def pieces(data: Any, raw: Mapping[Path, str] | None = None, holes: Collection[Path] = ()) -> list[Piece]:
    """The text of the data in parts; for each path of `holes` the path itself stands in the list.

    `raw`: numbers as they were written, by their paths.
    """
    writer = _Writer(raw or {}, frozenset(holes))
    return _joined(writer.block(data, (), ""))


def scalar(value: str | int | float | bool | None) -> str:
    """A single value, fit for any place of a text."""
    if value is None or isinstance(value, bool):
        return {None: "null", True: "true", False: "false"}[value]
    if isinstance(value, str):
        return value if _is_plain(value) and value not in _WORDS else quoted(value)
    return repr(value)


def flow(items: list[str]) -> str:
    """A list of values that are text already."""
    return f"[{', '.join(items)}]"


def quoted(text: str) -> str:
    """The text in double quotes: what is not seen when printed is escaped."""
    return "".join(c if c.isprintable() else _escaped(c) for c in json.dumps(text, ensure_ascii=False))


def _is_plain(text: str) -> bool:
    return len(text) <= 200 and bool(_PLAIN.fullmatch(text)) and not _NUMBER.fullmatch(text)


def _escaped(char: str) -> str:
    return f"\\u{ord(char):04X}" if ord(char) < 0x10000 else f"\\U{ord(char):08X}"


def _key(text: str) -> str:
    """Keys are always text, so that numbers and words need no quotes."""
    plain = re.fullmatch(r"[^\W_][\w *'-]*", text) and not text.endswith(" ") and len(text) <= 100
    return text if plain else quoted(text)


def _joined(parts: Iterator[Piece]) -> list[Piece]:
    """Neighbouring texts made one."""
    found: list[Piece] = []
    for part in parts:
        if found and isinstance(part, str) and isinstance(found[-1], str):
            found[-1] += part
        else:
            found.append(part)
    return found


class _Writer:
    """What all parts of a text share: the numbers as written, and the holes."""

    def __init__(self, raw: Mapping[Path, str], holes: frozenset[Path]):
        self.raw, self.holes = raw, holes

    def block(self, value: Any, path: Path, lead: str) -> Iterator[Piece]:
        """Lines of a value; `lead` begins the first of them, blanks of the same width the others."""
        blank = " " * len(lead)
        if self.is_flow(value, path):
            yield lead
            yield from self.inline(value, path)
            yield "\n"
        elif isinstance(value, dict):
            for n, (key, item) in enumerate(value.items()):
                yield from self.pair(key, item, (*path, key), blank if n else lead)
        else:
            for n, item in enumerate(value):
                yield from self.block(item, (*path, n), (blank if n else lead) + "- ")

    def pair(self, key: str, item: Any, path: Path, lead: str) -> Iterator[Piece]:
        yield f"{lead}{_key(key)}:"
        if self.is_flow(item, path):
            yield from self.block(item, path, " ")
        else:
            yield "\n"
            yield from self.block(item, path, " " * len(lead) + "  ")

    def is_flow(self, value: Any, path: Path) -> bool:
        """Whether a value goes into the line of its key."""
        if path in self.holes or not value or not isinstance(value, dict | list):
            return True
        flat = not any(isinstance(item, dict | list) for item in value)
        if len(path) < (OPEN if isinstance(value, dict) else 1):
            return False
        length = sum(len(piece) if isinstance(piece, str) else HOLE for piece in self.inline(value, path))
        return length <= WIDTH or (isinstance(value, list) and flat)

    def inline(self, value: Any, path: Path) -> Iterator[Piece]:
        if path in self.holes:
            yield path
        elif isinstance(value, dict):
            yield "{"
            for n, (key, item) in enumerate(value.items()):
                yield f"{', ' if n else ''}{_key(key)}: "
                yield from self.inline(item, (*path, key))
            yield "}"
        elif isinstance(value, list):
            yield "["
            for n, item in enumerate(value):
                yield ", " if n else ""
                yield from self.inline(item, (*path, n))
            yield "]"
        else:
            number = isinstance(value, int | float) and not isinstance(value, bool)
            yield self.raw[path] if number and path in self.raw else scalar(value)
