"""Notes of the usual depth and short ones: what they print is right, in both formats, whatever they leave out."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path

import pytest
from conftest import read as variant
from conftest import solved
from exhaustive import many

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "page"))
from note import Note, read
from reading import CHOSEN, results, wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans
from test_arithmetic import wrong_results
from test_latex_says_the_same import other_cells, other_formulas

from tmm_report import render

QUICK = [name for name in ("crank_rocker", "compressor") if name in CHOSEN]
NAMES = many([*QUICK, *(name for name in CHOSEN if name not in QUICK)], len(QUICK))
each = pytest.mark.parametrize("depth", ["short", "course"])


@cache
def written(name: str, fmt: str, depth: str) -> str:
    return render(solved(name), fmt, variant(name).language, depth)[f"note.{fmt}"].decode()


@cache
def html(name: str, depth: str) -> Note:
    return read(written(name, "html", depth))


@each
@pytest.mark.parametrize("name", NAMES)
def test_numbers_are_those_of_the_results(name, depth):
    note, document = html(name, depth), results(name)
    found = [*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_spans(note, document)]
    wrong([*found, *unmarked(note)])


@each
@pytest.mark.parametrize("name", NAMES)
def test_formulas_give_what_they_print(name, depth):
    wrong(list(wrong_results(html(name, depth))))


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", QUICK)
def test_latex_says_the_same(name):
    note, text = html(name, "course"), written(name, "tex", "course")
    wrong([*other_cells(note, text), *other_formulas(note, text)])
