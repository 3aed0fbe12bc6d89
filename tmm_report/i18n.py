"""The language of the note and of messages: gettext catalogues and the decimal sign. Message ids are in English.

A language has two catalogues: `note`, whatever reaches paper or is handed in, and `messages`, what the command line
says. In which a text stands says tools/messages.py by its file. What is not found in the one is looked for in the
other, which is read only then.
"""

from __future__ import annotations

import gettext
from functools import cache, cached_property
from pathlib import Path
from typing import Literal, NamedTuple, Protocol, get_args

from tmm_report.languages import FALLBACK, SIGNS, DecimalSign, collation, language, spoken
from tmm_report.resources import data_root

Domain = Literal["note", "messages"]
DOMAINS: tuple[Domain, ...] = get_args(Domain)


def NP_(context: str, text: str) -> str:
    """Mark a short word for translation in its context ("unit", "index") without translating it here."""
    return text


class Words(Protocol):
    def __call__(self, text: str, /) -> str: ...


class Translator(NamedTuple):
    """`language`: a code of `languages`; `decimal_sign`: left out, it follows the language; `words`: puts the own words
    of a department into a text, hashable as the rest.

    Hashable, so that printed symbols and units can be cached by it. Raises ProblemError, on the first use, for a
    language that there is not.
    """

    language: str = FALLBACK
    decimal_sign: DecimalSign | None = None
    words: Words | None = None

    @property
    def decimal(self) -> str:
        return SIGNS[self.decimal_sign or language(self.language).decimal]

    @property
    def babel_options(self) -> str:
        """Of LaTeX's package babel."""
        return language(self.language).babel_options

    @property
    def babel_provided(self) -> str:
        """The name of a language that babel takes from its locale file; "" where it has one of its own."""
        return language(self.language).babel_provided

    @property
    def proofed(self) -> str:
        """The language and country by which a text processor checks the words."""
        return language(self.language).proofed

    @property
    def letters(self) -> str:
        """Of appendices."""
        return language(self.language).letters

    def collation(self, text: str) -> tuple[int, ...]:
        """By what words are put into their order."""
        return collation(self.language, text)

    @property
    def cited(self) -> str:
        """Between sources that are cited together."""
        return language(self.language).cited

    def gettext(self, text: str) -> str:
        found = catalogue(self.language).gettext(text) if text else ""
        return self.words(found) if self.words is not None else found

    def pgettext(self, context: str, text: str) -> str:
        return catalogue(self.language).pgettext(context, text)

    def in_index(self, word: str) -> str:
        """A word of an index."""
        return self.pgettext("index", word)

    def ngettext(self, one: str, many: str, count: int) -> str:
        found = catalogue(self.language).ngettext(one, many, count)
        return self.words(found) if self.words is not None else found


def said(code: str, text: str) -> str:
    """A text in the words of the command line."""
    return catalogue(spoken(code), "messages").gettext(text) if text else ""


@cache
def catalogue(code: str, domain: Domain = "note") -> gettext.NullTranslations:
    """The texts of a language, those of `domain` first. Raises ProblemError for a language that there is not."""
    if language(code).ids:
        return gettext.NullTranslations()
    found = _read(code, domain)
    found.add_fallback(_Other(code, next(one for one in DOMAINS if one != domain)))
    return found


def _read(code: str, domain: Domain) -> gettext.NullTranslations:
    """A catalogue, or what `hatch_build.py` made of it. Raises FileNotFoundError where there is none."""
    file = folder() / code / "LC_MESSAGES" / f"{domain}.mo"
    if file.is_file():
        return gettext.translation(domain, localedir=folder(), languages=[code])
    import lzma

    with lzma.open(f"{file}.xz") as packed:
        return gettext.GNUTranslations(packed)  # type: ignore[arg-type]


def folder() -> Path:
    return data_root() / "templates" / "locale"


class _Other(gettext.NullTranslations):
    """The other domain, read when a text is first looked for in it."""

    def __init__(self, code: str, domain: Domain):
        super().__init__()
        self.code, self.domain = code, domain

    @cached_property
    def texts(self) -> gettext.NullTranslations:
        code = spoken(self.code) if self.domain == "messages" else self.code
        if language(code).ids:
            return gettext.NullTranslations()
        return _read(code, self.domain)

    def gettext(self, message: str) -> str:
        return self.texts.gettext(message)

    def ngettext(self, one: str, many: str, count: int) -> str:
        return self.texts.ngettext(one, many, count)

    def pgettext(self, context: str, message: str) -> str:
        # words in a context are of the note, and most of what is asked here is a letter that needs no translation
        return message if self.domain == "messages" else self.texts.pgettext(context, message)
