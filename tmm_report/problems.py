"""What went wrong, as data: a user's mistake is a Problem and never a stack trace; a bug keeps its trace.

Texts are gettext message ids with named values, translated only where they are printed (`Problem.text`).
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Mapping
from dataclasses import field
from typing import Any

from tmm_report.records import dataclass


def N_(text: str) -> str:
    """Mark a message for translation without translating it here."""
    return text


LANGUAGE = N_("this is said in: en")


class Rendered:
    """What a sentence holds that every language writes in its own way."""

    def render(self, translate: Callable[[str], str]) -> str:
        """As the language of a catalogue writes it."""
        raise NotImplementedError


def language_of(translate: Callable[[str], str]) -> str:
    """The code of a catalogue's language."""
    return translate(LANGUAGE).rpartition(" ")[2]


class Called(Rendered, str):
    """A name that a variant gives in several languages: itself as it gives it first; `by`: all of them, by the codes of
    the languages.

    Of two that begin alike each is itself, so that what is kept of one is not said of the other.
    """

    by: Mapping[str, str]

    def __new__(cls, by: Mapping[str, str]) -> Called:
        name = super().__new__(cls, next(iter(by.values())))
        name.by = by
        return name

    def __reduce__(self) -> tuple[Any, ...]:
        return Called, (self.by,)

    def __hash__(self) -> int:
        return hash((str(self), *self.by.items()))

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Called):
            return self.by == other.by
        return str(self) == other

    def __ne__(self, other: object) -> bool:
        return not self == other

    def render(self, translate: Callable[[str], str]) -> str:
        """The name in the language of a catalogue; as it is given first where it has none in that."""
        return self.by.get(language_of(translate), str(self))


def in_language(name: object, translate: Callable[[str], str]) -> str:
    """A text as it is; of a name in several languages that of the catalogue."""
    return name.render(translate) if isinstance(name, Called) else str(name)


@dataclass(frozen=True)
class Message(Rendered):
    """A translatable sentence: `text % values` once `text` is translated."""

    text: str
    values: Mapping[str, Any] = field(default_factory=dict)

    def __str__(self) -> str:
        return self.render(str)

    def render(self, translate: Callable[[str], str]) -> str:
        values = {k: v.render(translate) if isinstance(v, Rendered) else v for k, v in self.values.items()}
        return translate(self.text) % values if values else translate(self.text).replace("%%", "%")


WARNING = N_("warning: %(what)s")


@dataclass(frozen=True)
class Problem:
    """One mistake of the user: where it is, what is wrong, what would be right.

    `doubt`: it looks odd and may be meant so: what is solved all the same.
    """

    wrong: Message
    right: Message | None = None
    path: tuple[str | int, ...] = ()
    file: str = ""
    line: int | None = None
    column: int | None = None
    doubt: bool = False

    @property
    def key(self) -> str:
        return ".".join(str(part) for part in self.path)

    def text(self, translate: Callable[[str], str] = str) -> str:
        """`file:line:column: key: what is wrong; what would be right`, on one line."""
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part not in (None, ""))
        parts = [part for part in (place, self.key) if part]
        sentence = self.sentence(translate)
        if self.doubt:
            sentence = Message(WARNING, {"what": sentence}).render(translate)
        return ": ".join([*parts, sentence])

    @property
    def said(self) -> Message:
        """What is wrong and what would be right, without the place."""
        if self.right is None:
            return self.wrong
        return Message(N_("%(wrong)s; %(right)s"), {"wrong": self.wrong, "right": self.right})

    def sentence(self, translate: Callable[[str], str] = str) -> str:
        """The same in words."""
        return self.said.render(translate)


class ProblemError(Exception):
    """A user's mistakes, all of them at once. Raised by reading and by solving; printed only by the cli.

    `language`: that of the file that they are in, "" where it states none.
    """

    def __init__(self, problems: list[Problem], language: str = ""):
        super().__init__("\n".join(problem.text() for problem in problems))
        self.problems, self.language = problems, language


def mistake(
    text: str, path: tuple[str | int, ...] = (), right: Message | None = None, **values: Any
) -> Problem:
    """A Problem in one call: `mistake(N_("no link %(name)s"), ("loads",), name="7")`."""
    return Problem(wrong=Message(text, values), right=right, path=path)


def doubt(
    text: str, path: tuple[str | int, ...] = (), right: Message | None = None, **values: Any
) -> Problem:
    """What looks odd and is solved all the same: `mistake`, told as a warning, the exit code unchanged."""
    return Problem(wrong=Message(text, values), right=right, path=path, doubt=True)


def shown(value: object, limit: int = 40) -> str:
    """A foreign text fit for a message: no control, format or direction characters, at most `limit` long."""
    text = str(value)[: limit + 1]
    if len(text) <= limit and text.isascii() and text.isprintable():
        return text
    clean = "".join("\N{REPLACEMENT CHARACTER}" if _hidden(char) else char for char in text)
    return clean if len(text) <= limit else clean[: limit - 1] + "…"


def _hidden(char: str) -> bool:
    category = unicodedata.category(char)
    return category.startswith("C") or category in ("Zl", "Zp")
