"""The norm control of all shipped variants: nothing is named in any language."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import read
from exhaustive import many
from notes import note
from spoken import EVERY, OTHERS, notes_in

from tmm_report.lint.checks import look
from tmm_report.lint.made import Made

QUICK = ["compressor-ru", "governor_servo-en", *(f"compressor-{code}" for code in OTHERS)]


def named(files: dict[str, bytes]) -> list[str]:
    return [one.text() for one in look(Made(files, Path())).told]


@pytest.mark.parametrize("name", many(notes_in(EVERY, QUICK), len(QUICK)))
def test_nothing_is_named(name):
    """As the note says all; in the variant's own language also in LaTeX, and as it is made by itself."""
    variant, _, language = name.rpartition("-")
    numbers, whole = note(variant, "json", language), note(variant, "html", language)
    if language == read(variant).language:
        whole |= note(variant, "tex", language)
        assert not named(numbers | note(variant, "html", language, None))
    assert not named(numbers | whole)
