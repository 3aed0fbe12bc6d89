"""Notes of ready variants, made once a test run, and the programs that look at them."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import NoReturn

import pytest
from conftest import ALL_FILES, read, solved
from once import once

from tmm_report import render as of_depth
from tmm_report.commands.files import for_typst
from tmm_report.course import Depth, Results

VARIANTS = Path(__file__).parent.parent / "variants"
NAMES = sorted(path.stem for path in ALL_FILES)


def render(
    results: Results, fmt: str = "html", language: str | None = None, depth: Depth = "full"
) -> dict[str, bytes]:
    """The note that says all, or the numbers: what a shorter one leaves out is judged, too."""
    if fmt == "typst":
        return {"note.typst": for_typst(results, language, depth)}
    return of_depth(results, fmt, language, depth)


def static(page: str) -> str:
    """A note in HTML as it is where scripts are off: without what moves it on the screen."""
    body, begins, behind = page.rpartition("<style>\n/* The living page")
    assert begins and behind.count("<script") == 2, "the living page stands behind the text of a note"
    return body + behind.rpartition("</script>\n")[2]


def note(name: str, fmt: str, language: str | None = None, depth: Depth | None = "full") -> dict[str, bytes]:
    """Files of the note of a ready variant; in its own language where none is stated; of no `depth`: as it is made by
    itself."""
    variant = read(name)
    return rendered(name, fmt, language or variant.language, depth or variant.note.depth)


@once
def rendered(name: str, fmt: str, language: str, depth: Depth) -> dict[str, bytes]:
    return render(solved(name), fmt, language, depth)


def program(*names: str) -> str:
    """Path of the first of these programs that is installed; without one the test is skipped, but never in CI."""
    found = next((path for path in map(shutil.which, names) if path), None)
    if found is None:
        absent(f"none of {', '.join(names)} is installed")
    return found


def absent(reason: str) -> NoReturn:
    """Something that a test needs is not there: it is skipped, but never in CI."""
    if os.environ.get("CI"):
        pytest.fail(reason)
    pytest.skip(reason)
