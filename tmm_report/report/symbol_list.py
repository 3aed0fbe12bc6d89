"""The list of symbols of a note: gathered while it is written, ordered and put together at the end.

What differs only by names of points or links is one line: v_A, v_B, v_S2 – velocity of points A, B, S2.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator, Sequence
from dataclasses import field
from typing import Any, NamedTuple

from markupsafe import Markup

from tmm_report.problems import Message
from tmm_report.quantity.model import X_PART, Y_PART
from tmm_report.quantity.symbols import GREEK, Symbol
from tmm_report.records import dataclass

NAMED = 4  # so many symbols of a kind are named one by one; of more only the first two and the last
LETTERS = "ijkl"  # what stands for names where several differ


class Meant(NamedTuple):
    """A symbol with its meaning: a message, or words that are ready."""

    sign: Symbol
    meaning: Message | Markup
    unit: str


class Line(NamedTuple):
    """A line of the list, ready to print."""

    symbols: Markup
    meaning: Markup
    unit: str


@dataclass
class SymbolList:
    """Symbols in the order in which the note uses them, each meaning once."""

    _found: dict[tuple[Symbol, str, str], Meant] = field(default_factory=dict)

    def add(self, sign: Symbol, meaning: Message | Markup, unit: str) -> None:
        """Lengths of drawn segments name themselves by their ends, projections by their axes."""
        projection = isinstance(meaning, Message) and meaning.text in (X_PART, Y_PART)
        if sign.kind != "segment" and not projection:
            self._found.setdefault((sign, str(meaning), unit), Meant(sign, meaning, unit))

    def lines(self, page: Any) -> list[Line]:
        """Latin letters first, then Greek ones; `page`: how they are printed."""
        groups: dict[tuple[str, str, str], list[Meant]] = {}
        for one in self._found.values():
            text = one.meaning.text if isinstance(one.meaning, Message) else str(one.meaning)
            groups.setdefault((one.sign.base, text, one.unit), []).append(one)
        for group in groups.values():
            group.sort(key=lambda one: _order(one.sign))
        ordered = sorted(groups.values(), key=lambda group: _order(group[0].sign))
        return _once([_line(group, page) for group in ordered])


def _once(lines: Sequence[Line]) -> list[Line]:
    """Each meaning of a symbol once, in the unit of its first use; a fuller wording stands for the shorter one."""
    lines = list({(line.symbols, line.meaning): line for line in reversed(lines)}.values())[::-1]
    alike: dict[tuple[Markup, str], list[Line]] = {}
    for line in lines:
        alike.setdefault((line.symbols, line.unit), []).append(line)
    return [
        line
        for line in lines
        if not any(
            other is not line and other.meaning.startswith(line.meaning)
            for other in alike[line.symbols, line.unit]
        )
    ]


def _order(sign: Symbol) -> tuple[bool, str, str, list[str | int], str]:
    """As in an index: m_2 before m_10."""
    greek = sign.base in GREEK
    plain = unicodedata.normalize("NFKD", GREEK.get(sign.base, sign.base))
    index = [int(one) if one.isdecimal() else one for one in re.split(r"(\d+)", sign.sub)]
    return (greek or not plain[:1].isascii(), plain.lower(), plain, index, sign.sup)


def _line(group: Sequence[Meant], page: Any) -> Line:
    signs = list(dict.fromkeys(one.sign for one in group))
    meanings = [one.meaning for one in group if isinstance(one.meaning, Message)]
    meaning = _together(meanings, len(signs), page) if meanings else group[0].meaning
    return Line(page.listed(_some(signs, page.sym)), page.text(meaning), group[0].unit)


def _some(signs: Sequence[Symbol], written: Callable[[Symbol], Markup]) -> Iterator[Markup | str]:
    if len(signs) <= NAMED:
        yield from map(written, signs)
        return
    yield from (written(signs[0]), written(signs[1]), "…", written(signs[-1]))


def _together(meanings: Sequence[Message], signs: int, page: Any) -> Markup:
    """One message for all: the value that differs listed, or letters in the place of several that do."""
    first = meanings[0]
    differing = [
        name
        for name, value in first.values.items()
        if any(str(m.values[name]) != str(value) for m in meanings)
    ]
    if not differing:
        return Markup(page.message(first))
    if len(differing) == 1 and signs <= NAMED:
        (name,) = differing
        values = {str(m.values[name]): m.values[name] for m in meanings}
        return Markup(
            page.t(
                first.text,
                **{**_said(first, page), name: page.listed(_shown(v, page) for v in values.values())},
            )
        )
    letters = {name: page.sym(LETTERS[k % len(LETTERS)]) for k, name in enumerate(differing)}
    return Markup(page.t(first.text, **{**_said(first, page), **letters}))


def _said(message: Message, page: Any) -> dict[str, Any]:
    return {name: _shown(value, page) for name, value in message.values.items()}


def _shown(value: Any, page: Any) -> Any:
    """A value of a message as it is printed."""
    if isinstance(value, Message):
        return page.message(value)
    return page.sym(value) if isinstance(value, Symbol) else value
