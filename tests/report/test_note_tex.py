"""The LaTeX note as pdflatex sets it: no error, no missing glyph, no undefined reference, nothing too wide."""

from __future__ import annotations

import re
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest
from browser import wide_results
from exhaustive import many
from notes import NAMES, VARIANTS, note, program, render
from typesetting import set_by_tex, typeset

from tmm_report import solve
from tmm_report.chapters.title.given import Title
from tmm_report.commands.pdf import bare, compiled
from tmm_report.lint import paper
from tmm_report.lint.made import Made
from tmm_report.loading import loads

NOTES = many(["eccentric-en", "compressor-ru", "shaper-ru", "hoist_drive-ru", "scissor_lift-ru"], quick=0)


@pytest.fixture(params=NOTES)
def log(request) -> str:
    name, language = request.param.split("-")
    return typeset(name, language)[0]


def test_no_errors(log):
    assert not re.findall(r"^!.*|^.*:\d+: .*rror.*", log, re.M)


def test_no_missing_glyphs(log):
    assert not re.findall(r"Missing character.*|.*not loadable.*|.*undefined in font.*", log)


def test_no_undefined_references(log):
    assert not re.findall(r".*(?:undefined|multiply.defined|Rerun to get).*", log)


def test_no_overfull_boxes(log):
    assert overfull(log) == []


def overfull(log: str) -> list[str]:
    """What stands out of its line or page, as the norm control reads it."""
    return [one.text() for one in paper.overfull(Made({"note.log": log.encode()}, Path()))]


@pytest.mark.exhaustive
def test_nothing_of_a_wide_note_is_wider_than_the_text():
    """Long names and numbers, more columns than a page holds."""
    files = render(wide_results(), "tex", "ru")
    assert b"\\NoteTimes{" in files["note.tex"] and b"\\allowbreak{}" in files["note.tex"]
    assert overfull(set_by_tex(files)[0]) == []


@pytest.mark.exhaustive
def test_pdf_is_the_same_twice():
    _, pdf = typeset("eccentric", "en")
    assert compiled(note("eccentric", "tex", "en"))["note.pdf"] == pdf


@pytest.mark.exhaustive
def test_page_numbers_found_with_empty_drawings_are_those_of_the_whole_note():
    files = note("eccentric", "tex", "en")
    drawn = {file for file in files if file.startswith("figures/")}
    assert len(drawn) > 1 and {file for file, text in bare(files).items() if text != files[file]} == drawn
    assert all(len(bare(files)[file]) < 1000 < len(files[file]) for file in drawn)
    assert set_by_tex(files, whole=True)[1] == typeset("eccentric", "en")[1]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_every_figure_is_written_and_used(name):
    files = note(name, "tex")
    used = set(re.findall(r"figures/[\w.-]+", files["note.tex"].decode()))
    assert used == {file for file in files if file.startswith("figures/")}


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_every_sign_can_be_set(name):
    """A letter that pdflatex has no glyph for is printed as a question mark; the notes ask no questions."""
    files = note(name, "tex")
    assert [file for file, text in files.items() if file.endswith(".tex") and b"?" in text] == []


@pytest.mark.exhaustive
def test_letters_of_every_language_of_the_users_are_set(tmp_path):
    """Of Kazakh and Ukrainian names no letter is lost, in text, bold, and as the name of a point.

    The topic stands on the title page and in the introduction, the student on the title page."""
    letters = "ӘәҒғҚқҢңӨөҰұҮүҺһЇїЄєҐґ"  # і shares its glyph with the Latin one
    text = (VARIANTS / "slider_crank_offset.yaml").read_text(encoding="utf-8").partition("\nloads:")[0]
    variant = loads(re.sub(r"\bB\b", "Қ", text))
    assert "Қ" in variant.lever.mechanism.point_names
    found = solve(replace(variant, title=Title(topic=letters, student=letters)))
    program("pdflatex")
    (tmp_path / "note.pdf").write_bytes(compiled(render(found, "tex", "ru"))["note.pdf"])
    command = [program("pdftotext"), "-layout", str(tmp_path / "note.pdf"), "-"]
    printed = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=True).stdout
    assert printed.count(letters) == 3 and "?" not in printed and printed.count("Қ") > 10
