"""How the notes of all ready variants read: sources, words (references, scales: `tests/lint/test_shipped_notes.py`)."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element

import pytest
from exhaustive import many
from notes import NAMES, note

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "page"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
from messages import merged, messages
from note import read, text_of

from tmm_report.languages import LANGUAGES

QUICK = ["compressor-ru", "governor_servo-en"]
NOTES = [*QUICK, *sorted({f"{name}-{language}" for name in NAMES for language in LANGUAGES} - {*QUICK})]
each = pytest.mark.parametrize("name", many(NOTES, len(QUICK)))


def page(name: str) -> Element:
    variant, _, language = name.rpartition("-")
    return read(note(variant, "html", language)["note.html"].decode()).root


@each
def test_every_note_cites_its_sources_within_its_sentences(name):
    root = page(name)
    cited = [node for node in root.iter("a") if (node.get("href") or "").startswith("#source")]
    assert cited and not [node for node in root.iter("p") if text_of(node).strip().startswith("[")]


WRONG = {  # what the terms of the course are not called: ISO 1122 and IFToMM in English, usage in Russian
    "en": r"swing centre|frequency of rotation|height of the head|active means|The calculation follows|insensitivity"
    r"|(?i:working (?:diameter|circle)|shortening of the tip|coefficient of non-uniformity|thickness of the tooth)"
    r"|(?i:\bsatellites?\b(?![:)]))",  # but the key of a variant is called so
    "ru": r"активное средство|амортизатор|коэффициент\w* виброизоляции|Расчёт ведётся|Формула строения"
    r"|(?i:демпфирование лежит|частота оборотов)|—",
}


@pytest.mark.parametrize("language", LANGUAGES)
def test_wrong_words_do_not_come_back(language):
    """In no text of the program, whatever note says it; a note in the other language is read by the same catalogue."""
    said = [form for entry in messages(merged("ru")) for form in _forms(entry, language)]
    assert len(said) > 5000
    assert not [text for text in said if re.search(WRONG[language], text)]


def _forms(entry: Any, language: str) -> tuple[str, ...]:
    text = entry.id if language == "en" else entry.string
    return (text,) if isinstance(text, str) else tuple(text or ())
