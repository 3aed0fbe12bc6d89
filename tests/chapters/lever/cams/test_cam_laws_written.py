"""Laws of a cam as the note writes them out: every piece of a graph, every shape, in a rise and in a return."""

import json
from pathlib import Path

import pytest
from note import read
from reading import wrong
from test_against_results import wrong_cells, wrong_formulas

from tmm_report import render
from tmm_report.course import loads, solve
from tmm_report.mechanics.cams.shapes import NAMED

TEXT = Path(__file__).parents[3].joinpath("cases/explain/graph_cam.yaml").read_text("utf-8")
STARTS = (18, 42, 66, 72, 88, 102)  # deg of the law at position 0
GRAPH = TEXT[TEXT.index("        - rise:") : TEXT.index("        - {dwell: 40 deg}")]


def written(text):
    """Formulas and cells of a variant's note that are wrong, and how many laws it writes out."""
    results = solve(loads(text))
    note = read(render(results, "html")["note.html"].decode())
    document = json.loads(render(results, "json")["results.json"])
    wrong([*wrong_cells(note, document), *wrong_formulas(note, document)])
    return results.lever.cam.cams[0]


@pytest.mark.parametrize("start", STARTS)
def test_every_piece_of_a_graph(start):
    """Turned by its start, the law's first position comes into each of its pieces in turn."""
    found = written(TEXT.replace("      lift:", f"      start: -{start} deg\n      lift:"))
    assert found.samples and found.pieces


def test_the_starts_come_into_every_piece():
    numbers = set()
    for start in STARTS:
        found = solve(
            loads(TEXT.replace("      lift:", f"      start: -{start} deg\n      lift:"))
        ).lever.cam.cams[0]
        numbers |= {found.number_of(one) for one in found.samples if one.phase.kind == "rise"}
    assert numbers == set(range(len(found.pieces)))


@pytest.mark.parametrize("law", NAMED)
def test_every_shape(law):
    text = TEXT.replace(GRAPH, f"        - {{rise: 110 deg, law: {law}}}\n")
    text = text.replace("law: parabolic, ratio: 1.8", f"law: {law}")
    assert [one.phase.law.name for one in written(text).samples] == [law, law]
