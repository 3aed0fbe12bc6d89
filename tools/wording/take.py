"""Take translations in: `python tools/wording/take.py LANGUAGE FILE...` (needs babel).

A FILE is JSON: {id: translation}, of a text that depends on a number {id: [forms]}, of a word in a context
{"context\\u0004word": translation}. What is right goes into the language's note.po; what is wrong is told with its
file and left out (exit code 1): values or markup lost, other spaces at the ends, letters of another language, a form
too few, a term of the glossary called otherwise. What is still missing is counted; `python tools/messages.py` then
makes the .mo.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from babel.messages.catalog import Catalog, Message

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from messages import as_forms, glossary, merged, messages, misnamed, missing, published, write

from tmm_report.languages import FALLBACK, LANGUAGES, language

BETWEEN = "\x04"  # a context and its word, as in gettext's own files
VALUE = re.compile(r"%\(\w+\)[^a-zA-Z%]*[a-zA-Z]|%%")
MARKUP = re.compile(r"<[^>]*>|&\w+;|\\[A-Za-z]+|[{}$_^|]|\n")
ENGLISH = re.compile(r"\b[a-z]{4,}\b")


def wrong(entry: Message, said: list[str], code: str) -> Iterator[str]:
    """What is wrong with the forms of a translation."""
    ids = list(entry.id) if isinstance(entry.id, tuple) else [entry.id]
    many = ids[-1]
    if not all(isinstance(form, str) and form.strip() for form in said):
        yield "empty"
        return
    for form in said:
        if sorted(VALUE.findall(form)) not in [sorted(VALUE.findall(one)) for one in ids]:
            yield f"values: {VALUE.findall(many)} became {VALUE.findall(form)}"
        if sorted(MARKUP.findall(form)) != sorted(MARKUP.findall(many)):
            yield f"markup: {MARKUP.findall(many)} became {MARKUP.findall(form)}"
        if (form[0].isspace(), form[-1].isspace()) != (many[0].isspace(), many[-1].isspace()):
            yield "spaces at the ends"
        if not published(entry) and (foreign := foreign_letters(form, code)):
            yield f"letters of another language: {foreign}"
        in_english = published(entry) and "(in Russian)" not in many  # such a title stays as it is
        left = entry.context is None and form == many and len(ENGLISH.findall(VALUE.sub("", many))) > 1
        if left and not in_english:
            yield "left in English"


def foreign_letters(text: str, code: str) -> str:
    """Cyrillic letters that the language has not, and letters of two scripts in one word."""
    own = language(code).alphabet
    strange = {char for char in text.lower() if "\u0400" <= char <= "\u052f" and own and char not in own}
    mixed = re.findall(
        r"\b(?=\w*[A-Za-z])(?=\w*[\u0400-\u052f])[A-Za-z\u0400-\u052f]+\b", VALUE.sub(" ", text)
    )
    return " ".join([*sorted(strange), *mixed])


def taken(code: str, files: list[Path], catalogue: Catalog) -> Iterator[str]:
    """Put the right ones into a catalogue; what is wrong with the others."""
    asked = {(entry.context, as_forms(entry.id)[0]): entry for entry in messages(catalogue)}
    for file in files:
        for key, given in json.loads(file.read_text("utf-8")).items():
            context, _, id = key.rpartition(BETWEEN)
            entry = asked.get((context or None, id))
            said = as_forms(given)
            if entry is None:
                yield f"{file.name}: no such text: {key!r}"
                continue
            needed = catalogue.num_plurals if isinstance(entry.id, tuple) else 1
            found = [*wrong(entry, said, code)]
            if len(said) != needed:
                found.append(f"{len(said)} forms, and {needed} are needed")
            yield from (f"{file.name}: {what}: {id!r} -> {said[0]!r}" for what in found)
            if not found:
                entry.string = tuple(said) if isinstance(entry.id, tuple) else said[0]


def main(code: str, names: list[str]) -> int:
    row = LANGUAGES.get(code)
    if row is None or row.code == FALLBACK or not names:
        print(__doc__)
        return 2
    catalogue = merged(code, "note")
    told = [*taken(code, [Path(name) for name in names], catalogue)]
    terms = glossary(code)
    told += [f"glossary: {text}" for text in misnamed(catalogue, terms) if "is in no text" not in text]
    lost, every = len(missing(catalogue)), len(messages(catalogue))  # writing leaves only what is translated
    write(code, "note", catalogue)
    print("\n".join(told))
    print(f"{code}: {lost} of {every} are missing, {len(told)} are wrong")
    return 1 if told or lost else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if sys.argv[1:] else "", sys.argv[2:]))
