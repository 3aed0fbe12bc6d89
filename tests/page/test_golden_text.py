"""The text of four notes, word by word and number by number, as it was last approved: `python tools/golden.py`."""

from __future__ import annotations

import difflib
from pathlib import Path

import pytest
from note import steady
from reading import CHOSEN, html

GOLDEN = Path(__file__).resolve().parents[1] / "golden"
TEXTS = sorted(path.name.removesuffix(".txt") for path in GOLDEN.glob("*.txt"))
SHOWN = 60  # changed lines that are told


def changes(old: list[str], new: list[str]) -> list[str]:
    """Lines that came and went, with one line around them."""
    return list(difflib.unified_diff(steady(old), steady(new), "approved", "now", lineterm="", n=1))


@pytest.mark.parametrize("text", [text for text in TEXTS if text.split(".")[0] in CHOSEN])
def test_the_text_is_the_approved_one(text):
    name, language = text.split(".")
    approved = (GOLDEN / f"{text}.txt").read_text("utf-8").splitlines()
    found = changes(approved, html(name, language).words)
    assert not found, "\n".join(found[:SHOWN])


def test_four_notes_are_approved():
    assert len({text.split(".")[0] for text in TEXTS}) >= 4
    assert {text.split(".")[1] for text in TEXTS} == {"ru", "en"}
