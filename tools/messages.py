"""Refresh the translations: `python tools/messages.py` after any change of a text (needs babel).

Collects the message ids of the program and the templates, takes their translations from the language's .po, writes
.po and .mo, and lists what is still untranslated or does not use the terms of the language's glossary (exit code 1).
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from datetime import UTC, datetime
from functools import cache
from pathlib import Path

import typer
import yaml
from babel.messages.catalog import Catalog, Message
from babel.messages.extract import DEFAULT_KEYWORDS, extract_from_dir
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po

from tmm_report.cli import app
from tmm_report.languages import LANGUAGES

ROOT = Path(__file__).resolve().parent.parent
LOCALE = ROOT / "templates" / "locale"
KEYWORDS = {**DEFAULT_KEYWORDS, "N_": None, "t": None, "count": (1, 2), "NP_": ((1, "c"), 2)}
JINJA = {"silent": "false"}  # the templates' delimiters go here when they are not Jinja's own
SOURCES: tuple[tuple[str, str, str, dict[str, str]], ...] = (
    ("tmm_report", "**.py", "python", {}),
    ("templates", "**.j2", "jinja2", JINJA),
)
VALUES = re.compile(r"%\(\w+\)")
UNDATED = datetime(2000, 1, 1, tzinfo=UTC)  # a date would change the file at every run


@cache
def extracted() -> tuple[tuple[str, str | tuple[str, ...], str | None], ...]:
    """(file, message id, context) of every text of the program and its templates."""
    return (*_extracted(), *_of_the_command_line())


def _extracted() -> Iterator[tuple[str, str | tuple[str, ...], str | None]]:
    for folder, pattern, method, options in SOURCES:
        found = extract_from_dir(
            ROOT / folder, [(pattern, method)], {pattern: options}, KEYWORDS, directory_filter=lambda _: True
        )
        for file, _, message, _, context in found:
            if message:
                yield f"{folder}/{Path(file).as_posix()}", message, context


def _of_the_command_line() -> Iterator[tuple[str, str, None]]:
    """Help of the commands and of their options."""
    group = typer.main.get_group(app)
    for command in (group, *group.commands.values()):
        for one in (command, *command.params):
            if help_of := getattr(one, "help", None):
                yield "tmm_report/cli.py", help_of, None


def po_file(language: str) -> Path:
    return LOCALE / language / "LC_MESSAGES" / "tmm_report.po"


def known(language: str) -> Catalog:
    """The translations there are: none for a language whose catalogue is being begun."""
    if not po_file(language).is_file():
        return Catalog(locale=language)
    with po_file(language).open("rb") as file:
        return read_po(file, locale=language)


def merged(language: str) -> Catalog:
    """Every message of the program with its translation, or with an empty one."""
    catalogue = Catalog(
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
    translated = known(language)
    for file, message, context in extracted():
        catalogue.add(message, locations=[(file, 0)], context=context)
    for entry in messages(catalogue):
        found = translated.get(entry.id, entry.context)
        if found and _filled(found):
            entry.string = found.string
    return catalogue


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

    A term that stands in the translation as it is in English is a key of a variant there.
    """
    wrong = []
    worded = [(entry, _words(entry.id)) for entry in messages(catalogue)]
    for term, names in terms.items():
        named = re.compile(rf"\b{re.escape(term)}\b", re.I)
        texts = [entry for entry, words in worded if named.search(words)]
        wrong += [
            f"{term!r} is not called {' or '.join(names)}: {_forms(entry.string)[0]!r}"
            for entry in texts
            if _filled(entry)
            and not any(_called(name, form) for name in [*names, term] for form in _forms(entry.string))
        ]
        wrong += [] if texts else [f"{term!r} is in no text"]
    return wrong


def _forms(text: str | tuple[str, ...] | list[str]) -> list[str]:
    """The forms of a text that depends on a number, or the only one."""
    return [text] if isinstance(text, str) else list(text)


def _words(text: str | tuple[str, ...]) -> str:
    """What an id says, a line a form: the names of its values are not words."""
    return "\n".join(VALUES.sub("", form) for form in _forms(text))


def _called(name: str, text: str) -> bool:
    """Whether a text has the name, with any endings where the name is inflected."""
    words = (word.partition("|") for word in name.split())
    pattern = r"\s+".join(re.escape(stem) + (r"\w*" if bar else r"\b") for stem, bar, _ in words)
    return re.search(rf"\b{pattern}", text, re.I) is not None


def write(language: str, catalogue: Catalog) -> None:
    po = po_file(language)
    po.parent.mkdir(parents=True, exist_ok=True)
    with po.open("wb") as file:
        write_po(file, catalogue, width=110, sort_output=True, no_location=True)
    with po.with_suffix(".mo").open("wb") as file:
        write_mo(file, catalogue)


def main() -> int:
    wrong = []
    for language in (row.code for row in LANGUAGES.values() if not row.ids):
        catalogue = merged(language)
        write(language, catalogue)
        found = [f"untranslated: {text}" for text in missing(catalogue)]
        found += misnamed(catalogue, glossary(language)) if glossary(language) else ["no glossary.yaml"]
        wrong += [f"{language}: {text}" for text in found]
    print("\n".join(wrong) or "every message is translated")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
