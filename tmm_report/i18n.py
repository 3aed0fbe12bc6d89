"""The language of the note: gettext catalogues and the decimal sign. Message ids are in English."""

from __future__ import annotations

import struct
from functools import cache, lru_cache

from tmm_report.languages import FALLBACK, SIGNS, DecimalSign, language
from tmm_report.records import dataclass
from tmm_report.resources import data_root

DOMAIN = "tmm_report"


def NP_(context: str, text: str) -> str:
    """Mark a short word for translation in its context ("unit", "index") without translating it here."""
    return text


@dataclass(frozen=True)
class Translator:
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

    def gettext(self, text: str) -> str:
        return _translated(self.language, text, text) if text else ""

    def pgettext(self, context: str, text: str) -> str:
        return _translated(self.language, f"{context}\x04{text}", text)


class _Catalogue:
    """A compiled catalogue (.mo). Its texts are read as they are asked for: a note has one in ten of them, and reading
    them all, as the standard library does, takes 8 ms.

    The file begins with seven numbers of four bytes, of which the third counts the texts; the fourth and the fifth say
    where the lengths and places of the ids stand, and those of the translations.
    """

    def __init__(self, data: bytes):
        _, _, count, ids, texts = struct.unpack_from("<5I", data)
        self._data = data
        self._texts = struct.unpack_from(f"<{2 * count}I", data, texts)
        places = struct.unpack_from(f"<{2 * count}I", data, ids)
        self._at = {
            data[at : at + length]: n
            for n, (length, at) in enumerate(zip(places[::2], places[1::2], strict=True))
        }

    def text(self, of: str) -> str | None:
        """The translation of an id; None where there is none."""
        n = self._at.get(of.encode(errors="surrogatepass"))
        if n is None:
            return None
        length, at = self._texts[2 * n : 2 * n + 2]
        return self._data[at : at + length].decode()


@lru_cache(maxsize=8192)
def _translated(code: str, of: str, otherwise: str) -> str:
    return (None if language(code).ids else _catalogue(code).text(of)) or otherwise


@cache
def _catalogue(code: str) -> _Catalogue:
    folder = data_root() / "templates" / "locale" / code / "LC_MESSAGES"
    return _Catalogue((folder / f"{DOMAIN}.mo").read_bytes())
