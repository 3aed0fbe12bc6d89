"""The text of a note of every chapter as it was last approved, in the languages of messages: tools/golden.py."""

from __future__ import annotations

import difflib
import runpy
from pathlib import Path

import pytest
from conftest import solved
from note import steady
from notes import NAMES
from reading import CHOSEN, html, results

from tmm_report.course import LEVER, OTHERS, chapters

GOLDEN = Path(__file__).resolve().parents[1] / "golden"
TEXTS = sorted(path.name.removesuffix(".txt") for path in GOLDEN.glob("*.txt"))
TOOL = runpy.run_path(str(GOLDEN.parents[1] / "tools" / "golden.py"))
SHOWN = 60  # changed lines that are told


def changes(old: list[str], new: list[str]) -> list[str]:
    """Lines that came and went, with one line around them."""
    return list(difflib.unified_diff(steady(old), steady(new), "approved", "now", lineterm="", n=1))


@pytest.mark.parametrize(
    ("name", "language"), [text.split(".") for text in TEXTS if text.split(".")[0] in CHOSEN]
)
def test_the_text_is_the_approved_one(name, language):
    approved = (GOLDEN / f"{name}.{language}.txt").read_text("utf-8").splitlines()
    found = changes(approved, html(name, language).words)
    assert not found, "\n".join(found[:SHOWN])


@pytest.mark.parametrize("name", [name for name in TOOL["READ_IN_ALL"] if name in CHOSEN])
def test_numbers_are_called_as_they_were_approved(name):
    """Letter, unit and meaning of every number of results.json, of which the note prints a part."""
    approved = (GOLDEN / f"{name}.numbers").read_text("utf-8").splitlines()
    found = changes(sorted(approved), sorted(TOOL["called"](results(name, TOOL["CALLED_IN"]))))
    assert not found, "\n".join(found[:SHOWN])


@pytest.mark.skipif(len(CHOSEN) < len(NAMES), reason="looks at a few variants")
def test_a_note_of_every_chapter_is_approved_in_every_language():
    for language in TOOL["APPROVED"]:
        own = [solved(text.split(".")[0]) for text in TEXTS if text.endswith(language)]
        seen = {name for one in own for name, _ in chapters(one)}
        assert {*LEVER, *OTHERS} - seen == set()
