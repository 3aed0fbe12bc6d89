"""Every kind of offence, planted in the note of a shipped variant, is named by its key at its file, and no other."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from notes import note
from offences import HTML, OFFENCES, PDF, Files, Offence, pages

from tmm_report.lint import sheets
from tmm_report.lint.checks import CHECKS, look
from tmm_report.lint.made import Made

NAME = "governor_spring"
LINES = b"100 700 300 10 re f 100 650 300 10 re f 100 600 300 10 re f"


@pytest.fixture(scope="module")
def files() -> Files:
    return note(NAME, "html", "ru") | note(NAME, "tex", "ru") | note(NAME, "json", "ru")


def found(files: Files) -> list[tuple[str, str, str]]:
    """Key, file and words of all that is named."""
    told = look(Made(files, Path())).told
    return [(str(one.path[0]), one.file, one.sentence()) for one in told]


def test_the_note_itself_has_nothing_to_mend(files):
    assert not found(files)


@pytest.mark.parametrize("offence", OFFENCES, ids=[offence.name for offence in OFFENCES])
def test_an_offence_is_named(files, offence: Offence):
    if offence.file == PDF and shutil.which("pdftoppm") is None:
        pytest.skip("no pdftoppm")
    named = found(offence.plant(files))
    assert {(check, file) for check, file, _ in named} == {(offence.check, offence.file)}
    assert 1 <= len(named) <= 3


def test_every_check_names_an_offence(files):
    """Run alone, one check after another; and there are more than twenty kinds."""
    made = [Made(one.plant(files), Path()) for one in OFFENCES]
    silent = [check for check in CHECKS if not any(True for one in made for _ in check(one))]
    assert silent == [] or (silent == [sheets.empty] and shutil.which("pdftoppm") is None)
    assert len(OFFENCES) > 20 and len({offence.check for offence in OFFENCES}) >= 13


def test_findings_say_the_line(files):
    """That of the figure's own element, counted here."""
    offence = next(one for one in OFFENCES if one.check == "scale")
    planted = offence.plant(files)
    lines = planted[HTML].decode().splitlines()
    (problem,) = look(Made(planted, Path())).told
    assert problem.line == 1 + next(k for k, line in enumerate(lines) if 'id="figure2"' in line)


@pytest.mark.skipif(shutil.which("pdftoppm") is None, reason="no pdftoppm")
def test_a_page_of_few_lines_is_no_empty_one(files):
    assert not found(files | {PDF: pages(LINES, LINES)})
    assert len(found(files | {PDF: pages(LINES, b"", b"", LINES)})) == 2
    assert [file for _, file, _ in found(files | {"note-print.pdf": pages(b"", LINES)})] == ["note-print.pdf"]
