"""Notes of the textbook problems of machines, read as those of the ready variants are: every printed number is that of
the results, every formula gives what it prints, and LaTeX says the same."""

import json
from pathlib import Path
from unittest.mock import patch

import pytest
from note import read
from notes import render
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans
from test_arithmetic import wrong_results
from test_latex_says_the_same import other_cells, other_formulas

from tmm_report import loading, solve
from tmm_report.report.formats import Tex

PROBLEMS = (
    "clutch_for_pressure", "conical_pivot_for_pressure", "fan_on_deflected_isolators", "geared_start",
    "linkage_of_three_pairs", "rim_for_stress", "shifts_by_quality", "helical_pair_by_distance",
    "ring_measured_between_pins", "reverted_reducer",
)  # fmt: skip


@pytest.mark.parametrize("name", PROBLEMS)
def test_the_note_says_what_the_results_say(name):
    results = solve(loading.load(Path(__file__).parent / f"{name}.yaml"))
    page = read(render(results, "html")["note.html"].decode())
    document = json.loads(render(results, "json")["results.json"])
    with patch.object(Tex, "picture", lambda self, picture, anchor: ""):
        text = render(results, "tex")["note.tex"].decode()
    assert document["values"] and page.formulas
    wrong([
        *wrong_cells(page, document), *wrong_formulas(page, document), *wrong_spans(page, document), *unmarked(page),
        *wrong_results(page), *other_cells(page, text), *other_formulas(page, text),
    ])  # fmt: skip
