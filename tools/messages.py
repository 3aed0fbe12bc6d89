"""Refresh the translations: `python tools/messages.py` after any change of a text (needs babel).

Collects the message ids of the program and the templates (tools/wording/texts.py), takes their translations from the
language's two catalogues, writes .po and .mo of each, and lists what is still untranslated or does not use the terms of
the language's glossary (exit code 1).
"""

from __future__ import annotations

import re
import sys
from datetime import UTC, datetime
from pathlib import Path

import yaml
from babel.messages.catalog import Catalog, Message
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po
from wording.texts import domain, extracted

from tmm_report.i18n import DOMAINS, Domain
from tmm_report.languages import LANGUAGES

ROOT = Path(__file__).resolve().parent.parent
LOCALE = ROOT / "templates" / "locale"
VALUES = re.compile(r"%\(\w+\)")
UNDATED = datetime(2000, 1, 1, tzinfo=UTC)  # a date would change the file at every run


def po_file(language: str, of: Domain) -> Path:
    return LOCALE / language / "LC_MESSAGES" / f"{of}.po"


def known(language: str) -> list[Catalog]:
    """The translations there are: none for a language whose catalogues are being begun."""
    found = []
    for file in (po_file(language, of) for of in DOMAINS):
        if file.is_file():
            with file.open("rb") as text:
                found.append(read_po(text, locale=language))
    return found


def merged(language: str, of: Domain | None = None) -> Catalog:
    """Every text of a catalogue, or of both, with its translation, or with an empty one.

    A text that has moved from one to the other brings its translation.
    """
    catalogue = _empty(language)
    for file, message, context in extracted():
        catalogue.add(message, locations=[(file, 0)], context=context)
    for entry in messages(catalogue):
        if of is not None and of != domain_of(entry):
            catalogue.delete(entry.id, entry.context)
    translated = known(language)
    for entry in messages(catalogue):
        found = [one for known in translated if (one := known.get(entry.id, entry.context)) and _filled(one)]
        if found:
            entry.string = found[0].string
    return catalogue


def domain_of(entry: Message) -> Domain:
    """That of the files in which a text stands."""
    found = {domain(file) for file, _ in entry.locations}
    return next(one for one in DOMAINS if one in found)


def _empty(language: str) -> Catalog:
    found = Catalog(
        locale=language,
        header_comment="# Written by tools/messages.py; translations may be edited here.",
        project="tmm-report",
        version="",
        msgid_bugs_address="-",
        last_translator="-",
        language_team="-",
        charset="utf-8",
        creation_date=UNDATED,
        revision_date=UNDATED,
        fuzzy=False,
    )
    if rule := LANGUAGES[language].plurals:  # Babel would have it otherwise
        found.mime_headers = [("Plural-Forms", rule)]
    return found


def messages(catalogue: Catalog) -> list[Message]:
    return [entry for entry in catalogue if entry.id]


def _filled(entry: Message) -> bool:
    return all(entry.string) if isinstance(entry.string, tuple) else bool(entry.string)


def missing(catalogue: Catalog) -> list[str]:
    return [str(entry.id) for entry in messages(catalogue) if not _filled(entry)]


def glossary(language: str) -> dict[str, list[str]]:
    """English term -> what it may be called: see the head of the Russian file. Without a file there is none."""
    file = LOCALE / language / "glossary.yaml"
    terms = yaml.safe_load(file.read_text("utf-8")) if file.is_file() else {}
    return {term: [said] if isinstance(said, str) else said for term, said in terms.items()}


def misnamed(catalogue: Catalog, terms: dict[str, list[str]]) -> list[str]:
    """Translations in which a thing of the glossary is called otherwise, and terms that no text has.

    A term that stands in the translation as it is in English is a key of a variant there; a part of a compound
    (slider-crank) is not the term. Books and standards are called as they were published.
    """
    wrong = []
    worded = [(entry, _words(entry.id)) for entry in messages(catalogue) if not published(entry)]
    for term, names in terms.items():
        named = re.compile(rf"(?<![\w-]){re.escape(term)}(?![\w-])", re.I)
        texts = [entry for entry, words in worded if named.search(words)]
        wrong += [
            f"{term!r} is not called {' or '.join(names)}: {as_forms(entry.string)[0]!r}"
            for entry in texts
            if _filled(entry)
            and not any(_called(name, form) for name in [*names, term] for form in as_forms(entry.string))
        ]
        wrong += [] if texts else [f"{term!r} is in no text"]
    return wrong


def published(entry: Message) -> bool:
    """Whether a text is a book's or standard's entry in the list of sources."""
    return {file for file, _ in entry.locations} == {"tmm_report/report/sources.py"}


def as_forms(text: str | tuple[str, ...] | list[str]) -> list[str]:
    """The forms of a text that depends on a number, or the only one."""
    return [text] if isinstance(text, str) else list(text)


def _words(text: str | tuple[str, ...]) -> str:
    """What an id says, a line a form: the names of its values are not words."""
    return "\n".join(VALUES.sub("", form) for form in as_forms(text))


def _called(name: str, text: str) -> bool:
    """Whether a text has the name, with any endings where the name is inflected; a value may be joined to its last
    word, as in Kazakh: "жетекші %(link)s-буын" is a "жетекші буын|"."""
    words = (word.partition("|") for word in name.split())
    pattern = r"\s+(?:%\(\w+\)\w-)?".join(
        re.escape(stem) + (r"\w*" if bar else r"\b") for stem, bar, _ in words
    )
    return re.search(rf"\b{pattern}", text, re.I) is not None


def write(language: str, of: Domain, catalogue: Catalog) -> None:
    po = po_file(language, of)
    po.parent.mkdir(parents=True, exist_ok=True)
    with po.open("wb") as file:
        write_po(file, catalogue, width=110, sort_output=True, no_location=True)
    for entry in messages(catalogue):
        if not _filled(entry):  # the program then says it in English
            catalogue.delete(entry.id, entry.context)
    with po.with_suffix(".mo").open("wb") as file:
        write_mo(file, catalogue)


def main() -> int:
    wrong = []
    for row in (row for row in LANGUAGES.values() if not row.ids):
        language = row.code
        for of in DOMAINS if row.messages else DOMAINS[:1]:
            catalogue = merged(language, of)
            wrong += [f"{language}, {of}: untranslated: {text}" for text in missing(catalogue)]
            write(language, of, catalogue)
        terms = glossary(language)
        found = misnamed(merged(language), terms) if terms else ["no glossary.yaml"]
        wrong += [f"{language}: {text}" for text in found]
    print("\n".join(wrong) or "every message is translated")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
