"""In which languages the tests read notes.

What a language may have wrong of its own (words, letters, units, signs, references in its order of words) is read in
EVERY one, in the HTML that says all, which a test run makes once: `notes.note`. What is dear and by templates alike in
all of them (LaTeX, Typst, Word, the browser, shorter notes) is read in those of LAID_OUT, the languages of the command
line: one with a catalogue, one without. Each language is laid out once in every format by
`tests/languages/test_letters_of_languages.py`.
"""

from __future__ import annotations

from tmm_report.languages import LANGUAGES

EVERY = [*LANGUAGES]
LAID_OUT = [code for code, row in LANGUAGES.items() if row.messages]


def notes_in(languages: list[str], names: list[str], first: list[str]) -> list[str]:
    """Parameters "variant-language", those of `first` before the others."""
    return [*first, *sorted({f"{name}-{language}" for name in names for language in languages} - {*first})]
