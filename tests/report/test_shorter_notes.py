"""Notes of the usual depth and short ones: what they print is right, in both formats, whatever they leave out."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from exhaustive import many
from notes import note

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "page"))
from reading import CHOSEN, html, results, wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans
from test_arithmetic import wrong_results
from test_latex_says_the_same import other_cells, other_formulas

QUICK = [name for name in ("crank_rocker", "compressor") if name in CHOSEN]
NAMES = many([*QUICK, *(name for name in CHOSEN if name not in QUICK)], len(QUICK))
each = pytest.mark.parametrize("depth", ["short", "course"])


@each
@pytest.mark.parametrize("name", NAMES)
def test_numbers_are_those_of_the_results(name, depth):
    note, document = html(name, depth=depth), results(name)
    found = [*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_spans(note, document)]
    wrong([*found, *unmarked(note)])


@each
@pytest.mark.parametrize("name", NAMES)
def test_formulas_give_what_they_print(name, depth):
    wrong(list(wrong_results(html(name, depth=depth))))


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", QUICK)
def test_latex_says_the_same(name):
    page, text = html(name, depth="course"), note(name, "tex", depth="course")["note.tex"].decode()
    wrong([*other_cells(page, text), *other_formulas(page, text)])
