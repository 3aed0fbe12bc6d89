"""The language of the note: gettext catalogues and the decimal sign. Message ids are in English."""

from __future__ import annotations

import gettext
from dataclasses import dataclass
from functools import cache

from tmm_report.resources import data_root

DOMAIN = "tmm_report"


def NP_(context: str, text: str) -> str:
    """Mark a short word for translation in its context ("unit", "index") without translating it here."""
    return text


@dataclass(frozen=True)
class Translator:
    """`language`: "en", "ru"; `decimal_sign`: "comma" or "point", left out it follows the language.

    Hashable, so that printed symbols and units can be cached by it. Raises FileNotFoundError, on the first
    text, for a language without a catalogue.
    """

    language: str = "en"
    decimal_sign: str | None = None

    @property
    def decimal(self) -> str:
        sign = self.decimal_sign or ("point" if self.language == "en" else "comma")
        return "," if sign == "comma" else "."

    def gettext(self, text: str) -> str:
        return _catalogue(self.language).gettext(text) if text else ""

    def pgettext(self, context: str, text: str) -> str:
        return _catalogue(self.language).pgettext(context, text)

    def ngettext(self, one: str, many: str, count: int) -> str:
        return _catalogue(self.language).ngettext(one, many, count)


@cache
def _catalogue(language: str) -> gettext.NullTranslations:
    if language == "en":
        return gettext.NullTranslations()
    folder = data_root() / "templates" / "locale"
    return gettext.translation(DOMAIN, localedir=folder, languages=[language])
