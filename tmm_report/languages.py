"""The languages of the note and of messages, a row a language. Everything that lists languages takes them from here.

A language is its row here, and its files in templates/: locale/<code>/LC_MESSAGES/note.po and messages.po (with the .mo
that tools/messages.py makes of each; the plural rule stands in their heads), locale/<code>/glossary.yaml and
new/<code>.yaml.
"""

from __future__ import annotations

import os
import re
from typing import Literal

from tmm_report.problems import N_, Message, Problem, ProblemError, shown
from tmm_report.records import dataclass

DecimalSign = Literal["comma", "point"]
SIGNS: dict[DecimalSign, str] = {"comma": ",", "point": "."}


@dataclass(frozen=True)
class Language:
    """One language.

    `code`: ISO 639-1, that of --lang, of the key `language` and of HTML. `babel`: its name in LaTeX, `beside`: the
    language whose words a note has beside its own. `ids`: its texts are the message ids, without a catalogue.
    `messages`: the command line speaks it, too; else it speaks the user's language or FALLBACK. `provided`: babel has
    it as a locale file alone, and the words of the note are not hyphenated. `alphabet`: its small letters in their
    order, where they are not Latin; `plurals`: gettext's rule, where Babel's is not meant. `profile`: how its
    notes look, unless a variant says. `proofed`: language and country by which Word checks the words. `letters`: of
    appendices, in their order (GOST 7.32: without those that are taken for digits or for others); `cited`: between
    sources that are cited together (GOST R 7.0.5: a semicolon).
    """

    code: str
    name: str
    decimal: DecimalSign
    babel: str
    beside: str = "english"
    ids: bool = False
    messages: bool = True
    provided: bool = False
    profile: str = "gost"
    alphabet: str = ""
    plurals: str = ""
    proofed: str = "en-GB"
    letters: str = "ABCDEFGHJKLMNPQRSTUVWXYZ"
    cited: str = ",\N{NO-BREAK SPACE}"

    @property
    def babel_options(self) -> str:
        return self.beside if self.provided else f"{self.beside},main={self.babel}"

    @property
    def babel_provided(self) -> str:
        return self.babel if self.provided else ""


LANGUAGES = {
    row.code: row
    for row in (
        Language(
            "ru",
            "русский",
            "comma",
            babel="russian",
            proofed="ru-RU",
            letters="АБВГДЕЖИКЛМНПРСТУФХЦШЩЭЮЯ",
            cited=";\N{NO-BREAK SPACE}",
            alphabet="абвгдеёжзийклмнопрстуфхцчшщъыьэюя",
        ),
        Language(
            "uk",
            "українська",
            "comma",
            babel="ukrainian",
            proofed="uk-UA",
            messages=False,
            provided=True,
            profile="dstu",
            letters="АБВГДЕЖИКЛМНПРСТУФХЦШЩЮЯ",
            alphabet="абвгґдеєжзиіїйклмнопрстуфхцчшщьюя",
        ),
        Language(
            "kk",
            "қазақша",
            "comma",
            babel="kazakh",
            proofed="kk-KZ",
            messages=False,
            provided=True,
            profile="kz",
            plurals="nplurals=1; plural=0;",
            letters="АБВГДЕЖИКЛМНПРСТУФХЦШЩЭЮЯ",
            cited=";\N{NO-BREAK SPACE}",
            alphabet="аәбвгғдеёжзийкқлмнңоөпрстуұүфхһцчшщъыіьэюя",
        ),
        Language("en", "English", "point", babel="english", beside="russian", ids=True),
    )
}
_STATED = re.compile(r"""^[\ufeff{ ]*["']?language["']?[ ]*:[ ]*["']?(\w+)""", re.M)
LATIN = "abcdefghijklmnopqrstuvwxyz"
DEFAULT = "ru"  # of a variant that states none
FALLBACK = "en"  # of messages, where the user's language is not among ours


def language(code: str) -> Language:
    """The row of a language. Raises ProblemError with the languages there are."""
    if code in LANGUAGES:
        return LANGUAGES[code]
    wrong = Message(N_("there is no language %(code)s"), {"code": shown(code) or "''"})
    right = Message(N_("known: %(words)s"), {"words": ", ".join(LANGUAGES)})
    raise ProblemError([Problem(wrong, right)])


def collation(code: str, text: str) -> tuple[int, ...]:
    """By what words of a language are put into their order: Latin letters first, then its own, then all others."""
    letters = LATIN + language(code).alphabet
    return tuple(
        letters.index(char) if char in letters else len(letters) + ord(char) for char in text.lower()
    )


def stated_in(text: str | bytes) -> str:
    """The code that a variant's text states with the key `language`, however broken the text is; "" if it states none.

    It is found by its line alone, as what cannot be read is told in this language, too.
    """
    found = _STATED.search(text if isinstance(text, str) else text.decode("utf-8", "replace"))
    return found[1] if found and found[1] in LANGUAGES else ""


def of_locale(name: str) -> str:
    """The code of a system's language, such as "ru_RU.UTF-8" or "Russian_Russia.1251"; FALLBACK for a foreign one."""
    word = re.split(r"[_.@-]", name.lower())[0]
    spoken = (row for row in LANGUAGES.values() if row.messages)
    return next((row.code for row in spoken if word in (row.code, row.babel)), FALLBACK)


def users() -> str:
    """The user's language, from the environment."""
    import locale

    names = [os.environ.get(name, "") for name in ("LC_ALL", "LC_MESSAGES", "LANG")]
    return of_locale(next((name for name in names if name), "") or (locale.getlocale()[0] or ""))


def spoken(code: str) -> str:
    """The language in which the command line speaks of a variant in this one."""
    return code if language(code).messages else users()
