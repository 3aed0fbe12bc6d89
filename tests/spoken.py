"""In which languages the tests read notes.

What a language may have wrong of its own (words, letters, units, signs, references in its order of words) is read in
the HTML that says all, which a test run makes once: `notes.note`. A note is read so in LAID_OUT, the languages of the
command line, one with a catalogue, one without; and in one of the others by turns: what a template or the program says
by itself is wrong in any of them, and each of their texts is read in its catalogue (`tests/languages`). What is dear
and by templates alike in all (LaTeX, shorter notes) is read in the variant's own language or in those of LAID_OUT;
Typst, Word and the browser by some notes. Each language is laid out once in every format by
`tests/languages/test_letters_of_languages.py`.
"""

from __future__ import annotations

from notes import NAMES

from tmm_report.languages import LANGUAGES

EVERY = [*LANGUAGES]
LAID_OUT = [code for code, row in LANGUAGES.items() if row.messages]
OTHERS = [code for code in EVERY if code not in LAID_OUT]


def read_in(name: str) -> list[str]:
    """The languages in which the note of a ready variant is read."""
    return [*LAID_OUT, OTHERS[NAMES.index(name) % len(OTHERS)]]


def notes_in(languages: list[str], first: list[str]) -> list[str]:
    """Parameters "variant-language", those of `first` before the others."""
    found = {f"{name}-{language}" for name in NAMES for language in read_in(name) if language in languages}
    return [*first, *sorted(found - {*first})]
