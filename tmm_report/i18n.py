"""The language of the note: gettext catalogues and the decimal sign. Message ids are in English."""

from __future__ import annotations

import gettext
from functools import cache
from typing import NamedTuple

from tmm_report.languages import FALLBACK, SIGNS, DecimalSign, language
from tmm_report.resources import data_root

DOMAIN = "tmm_report"


def NP_(context: str, text: str) -> str:
    """Mark a short word for translation in its context ("unit", "index") without translating it here."""
    return text


class Translator(NamedTuple):
    """`language`: a code of `languages`; `decimal_sign`: left out, it follows the language.

    Hashable, so that printed symbols and units can be cached by it. Raises ProblemError, on the first use, for a
    language that there is not.
    """

    language: str = FALLBACK
    decimal_sign: DecimalSign | None = None

    @property
    def decimal(self) -> str:
        return SIGNS[self.decimal_sign or language(self.language).decimal]

    @property
    def babel_options(self) -> str:
        """Of LaTeX's package babel."""
        return language(self.language).babel_options

    @property
    def letters(self) -> str:
        """Of appendices."""
        return language(self.language).letters

    @property
    def cited(self) -> str:
        """Between sources that are cited together."""
        return language(self.language).cited

    def gettext(self, text: str) -> str:
        return _catalogue(self.language).gettext(text) if text else ""

    def pgettext(self, context: str, text: str) -> str:
        return _catalogue(self.language).pgettext(context, text)

    def in_index(self, word: str) -> str:
        """A word of an index."""
        return self.pgettext("index", word)

    def ngettext(self, one: str, many: str, count: int) -> str:
        return _catalogue(self.language).ngettext(one, many, count)


@cache
def _catalogue(code: str) -> gettext.NullTranslations:
    if language(code).ids:
        return gettext.NullTranslations()
    folder = data_root() / "templates" / "locale"
    return gettext.translation(DOMAIN, localedir=folder, languages=[code])
