"""The norm control of all shipped variants in both languages: nothing is named."""

from __future__ import annotations

from pathlib import Path

import pytest
from exhaustive import many
from notes import NAMES, note

from tmm_report.languages import LANGUAGES
from tmm_report.lint.checks import look
from tmm_report.lint.made import Made

QUICK = ["compressor-ru", "governor_servo-en"]
NOTES = [*QUICK, *sorted({f"{name}-{language}" for name in NAMES for language in LANGUAGES} - {*QUICK})]


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
