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

from tmm_report.figures.lettering import lettered
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import X_PART, Y_PART
from tmm_report.quantity.symbols import GREEK, Symbol
from tmm_report.records import dataclass

NAMED = 4  # so many symbols of a kind are named one by one; of more only the first two and the last
LETTERS = "ijkl"  # what stands for names where several differ


class Meant(NamedTuple):
    """A symbol with its meaning: a message, or words that are ready. `section`: number of that which says so."""

    sign: Symbol
    meaning: Message | Markup
    unit: str
    section: str = ""


class Line(NamedTuple):
    """A line of the list, ready to print."""

    symbols: Markup
    meaning: Markup
    unit: str


@dataclass
class SymbolList:
    """Symbols in the order in which the note uses them, each meaning once."""

    _found: dict[tuple[Symbol, str], Meant] = field(default_factory=dict)

    def add(self, sign: Symbol, meaning: Message | Markup, unit: str, section: str = "") -> None:
        """Lengths of drawn segments name themselves by their ends, projections by their axes; a thing of which more is
        said than what it is, as by which method it was found, is that thing."""
        projection = isinstance(meaning, Message) and meaning.text in (X_PART, Y_PART)
        if sign.kind != "segment" and not projection:
            meant = Meant(sign, thing(meaning), unit, section)
            self._found.setdefault((sign, str(meant.meaning)), meant)

    def meanings(self, page: Any) -> dict[Symbol, list[Meant]]:
        """What each symbol stands for, in the unit of its first use; a fuller wording stands for the shorter one, which
        begins it, in the same unit."""
        found: dict[Symbol, dict[Markup, Meant]] = {}
        for one in self._found.values():
            found.setdefault(one.sign, {}).setdefault(_words(one, page), one)
        return {
            sign: [
                one
                for words, one in said.items()
                if not any(
                    other is not one and other.unit == one.unit and longer.startswith(words)
                    for longer, other in said.items()
                )
            ]
            for sign, said in found.items()
        }

    def lines(self, page: Any) -> list[Line]:
        """Latin letters first, then Greek ones, each symbol once: one that has a second meaning in another chapter has
        a line of its own. `page`: how they are printed."""
        groups: dict[tuple[Any, ...], list[Meant]] = {}
        twice: dict[Symbol, list[Meant]] = {}
        for sign, said in self.meanings(page).items():
            if len(said) > 1:
                twice[sign] = said
                continue
            (one,) = said
            groups.setdefault((sign.base, *_kind(one.meaning, page), one.unit), []).append(one)
        ordered = [sorted(group, key=lambda one: _order(one.sign, page.tr)) for group in groups.values()]
        lines = [(group[0].sign, _line(group, page)) for group in ordered]
        lines += [(sign, _apart(said, page)) for sign, said in twice.items()]
        return [line for _, line in sorted(lines, key=lambda one: _order(one[0], page.tr))]


def thing(meaning: Message | Markup) -> Message | Markup:
    said = isinstance(meaning, Message) and meaning.text.startswith("%(of)s") and meaning.values["of"]
    return thing(said) if isinstance(said, Message) else meaning


def _kind(meaning: Message | Markup, page: Any) -> tuple[str, ...]:
    """What meanings have alike that differ only by names of points or links; what is said in words is no such name."""
    if not isinstance(meaning, Message):
        return (str(meaning),)
    values = (value for value in meaning.values.values() if not isinstance(value, Symbol))
    texts = (str(page.text(_shown(value, page))) for value in values)
    return (meaning.text, *(text for text in texts if " " in text))


def _words(one: Meant, page: Any) -> Markup:
    return Markup(page.message(one.meaning)) if isinstance(one.meaning, Message) else one.meaning


def _apart(said: Sequence[Meant], page: Any) -> Line:
    """Of a symbol with several meanings: each with its unit and the section that means it."""
    texts = []
    for one in said:
        meaning = page.listed([_words(one, page), *([page.unit(one.unit)] if one.unit else [])])
        where = N_("%(meaning)s (section %(n)s)")
        texts.append(page.t(where, meaning=meaning, n=one.section) if one.section else meaning)
    return Line(page.sym(said[0].sign), page.listed(texts, "; "), "")


def _order(sign: Symbol, tr: Translator) -> tuple[bool, str, str, str, list[tuple[int, ...] | int], str]:
    """As in an index: m_2 before m_10, words of indices as they are printed by the alphabet of the note's language."""
    letter = sign.base.rstrip("'′″‴")
    plain = unicodedata.normalize("NFKD", GREEK.get(letter, letter))
    printed = re.split(r"(\d+)", lettered(sign, tr.in_index).sub)
    index = [int(one) if one.isdecimal() else tr.collation(one) for one in printed]
    return (not plain[:1].isascii(), plain.lower(), plain, sign.base, index, sign.sup)


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
