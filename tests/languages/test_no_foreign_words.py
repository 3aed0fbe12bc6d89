"""A note in a language has no word of another: each is of its catalogue, of its profile, of the variant, or a sign."""

from __future__ import annotations

import html
import re
from functools import cache
from gettext import GNUTranslations

import pytest
from catalogues import LATIN_UNIT, messages
from exhaustive import many
from notes import VARIANTS, note, static
from spoken import EVERY, notes_in

from tmm_report.i18n import DOMAINS, folder
from tmm_report.languages import LANGUAGES
from tmm_report.profiles import NAMES as PROFILES
from tmm_report.profiles import shipped

SIGNS = {*"sin cos tan tg arctg arcsin arccos inv max min exp sign const mini".split()}  # noqa: SIM905
"""Signs of functions, and of what is greatest."""
WORD = re.compile(r"[A-Za-z\u0400-\u052f]{3,}")
CAPITALS = re.compile(r"[A-Z]+")  # points, pairs of a group, Roman numbers
QUICK = ["compressor-uk", "compressor-kk", "hoist_drive-kk"]
PAGES = notes_in([code for code in EVERY if not LANGUAGES[code].ids], QUICK)


def seen(page: str) -> set[str]:
    """Words of a note, in its drawings, too."""
    bare = re.sub(r"(?s)<(script|style).*?</\1>|<annotation.*?</annotation>", " ", static(page))
    names = re.findall(r'(?:title|alt|aria-label)="([^"]*)"', bare)
    return set(WORD.findall(html.unescape(" ".join([re.sub(r"<[^>]*>", " ", bare), *names]))))


@cache
def known(code: str, sources: bool = True) -> set[str]:
    """Words of a language's notes; with those of the sources, which are called as they were published."""
    tool = messages()
    said = [
        form
        for entry in tool["messages"](tool["merged"](code, "note"))
        for form in tool["as_forms"](entry.string or "")
        if sources or not tool["published"](entry)
    ]
    said += [word for name in PROFILES for word in shipped(name).words.get(code, {}).values()]
    return set(WORD.findall(re.sub(r"%\(\w+\)\w", " ", " ".join(said))))


@pytest.mark.parametrize("name", many(PAGES, 3))
def test_a_note_has_no_foreign_word(name):
    variant, _, code = name.rpartition("-")
    own = known(code) | SIGNS
    others = "|".join(one for one in EVERY if one != code)
    text = (VARIANTS / f"{variant}.yaml").read_text("utf-8")
    stated = set(WORD.findall(re.sub(rf"\b({others}): [^,}}\n]+", "", text)))
    large = {word.upper() for word in own | stated} | {word.capitalize() for word in own}
    foreign = seen(note(variant, "html", code)["note.html"].decode()) - own - stated - large
    assert {word for word in foreign if not CAPITALS.fullmatch(word)} == set()


@pytest.mark.parametrize("code", [row.code for row in LANGUAGES.values() if row.alphabet])
def test_a_catalogue_has_no_letter_of_another_language(code):
    letters = set(LANGUAGES[code].alphabet)
    strange = {
        word
        for word in known(code, sources=False)
        if set(re.findall("[\u0400-\u052f]", word.lower())) - letters
    }
    assert strange == set()


@pytest.mark.parametrize("code", [row.code for row in LANGUAGES.values() if row.alphabet])
def test_a_catalogue_has_units_in_the_letters_of_its_language(code):
    """In the pieces of a variant that a message says, too: the program reads them so."""
    said = [text for of in DOMAINS if (file := folder() / code / "LC_MESSAGES" / f"{of}.mo").is_file()
            for text in GNUTranslations(file.open("rb"))._catalog.values()]  # fmt: skip
    assert len(said) > 1000
    assert [text for text in said if LATIN_UNIT.search(text)] == []
