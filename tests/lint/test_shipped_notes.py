"""The norm control of all shipped variants in every language: nothing is named."""

from __future__ import annotations

from pathlib import Path

import pytest
from exhaustive import many
from notes import NAMES, note
from spoken import EVERY, LAID_OUT, notes_in

from tmm_report.lint.checks import look
from tmm_report.lint.made import Made

QUICK = ["compressor-ru", "governor_servo-en"]
NOTES = notes_in(LAID_OUT, NAMES, QUICK)
OTHERS = [code for code in EVERY if code not in LAID_OUT]


def named(files: dict[str, bytes]) -> list[str]:
    return [one.text() for one in look(Made(files, Path())).told]


@pytest.mark.parametrize("name", many(NOTES, len(QUICK)))
def test_nothing_is_named(name):
    """As it is made by itself, and as it says all."""
    variant, _, language = name.rpartition("-")
    numbers = note(variant, "json", language)
    whole = note(variant, "html", language) | note(variant, "tex", language)
    usual = note(variant, "html", language, None)
    assert not named(numbers | whole)
    assert not named(numbers | usual)


@pytest.mark.parametrize(
    "name", many(notes_in(OTHERS, NAMES, [f"compressor-{code}" for code in OTHERS]), len(OTHERS))
)
def test_nothing_is_named_in_the_page(name):
    variant, _, language = name.rpartition("-")
    assert not named(note(variant, "json", language) | note(variant, "html", language))
