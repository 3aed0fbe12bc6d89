"""A class of thirty, a shaper's variants, one planted thing in each work: what a fair teacher would give and say."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
from exhaustive import many

from tmm_report import course, loading
from tmm_report.grading import rubric as rubrics
from tmm_report.grading.expected import expected, reversed_reactions
from tmm_report.grading.handed_in.answers import read
from tmm_report.grading.marks import grade

CLASS = Path(__file__).parents[1] / "cases" / "class"


@cache
def marked(id: str, folder: Path = CLASS):
    results = course.solve(loading.load(folder / "handout" / f"{id}.yaml"))
    handed = next(path for path in (folder / "answers").iterdir() if path.stem == id)
    files = sorted(handed.iterdir()) if handed.is_dir() else [handed]
    asked, rubric = expected(results), rubrics.load(folder / "rubric.yaml")
    contents = [(file.name, file.read_bytes()) for file in files]
    return grade(results, read(contents, id, asked, reversed_reactions(results), rubric.asks), rubric, asked)


FAIR = {
    "st01": 100, "st03": 100, "st04": 100, "st05": 100, "st08": 100, "st30": 100,
    "st02": 100, "st07": 100,
    "st11": 97.7, "st12": 97.7, "st13": 99.8, "st14": 97.6, "st15": 98,
}  # fmt: skip


@pytest.mark.parametrize("id", many(FAIR, 5))
def test_points_are_those_of_a_fair_teacher(id):
    assert marked(id).points == pytest.approx(FAIR[id], abs=0.5)


@pytest.mark.exhaustive
def test_every_rate_as_for_rpm_taken_for_rad_per_second_costs_the_first_column_alone():
    found = marked("k1", CLASS / "compressor")
    assert found.points == pytest.approx(96.67, abs=0.01)
    lost = {key for (_, key), column in found.columns.items() if (column.worth - column.points).sum() > 0.01}
    assert lost == {"v_A"}


NAMED = {  # what was planted -> how it is named
    "st02": [("sense", "")], "st06": [], "st07": [("sense", "")],
    "st09": [("mm for m", "1000")], "st10": [("mm for m", "1000"), ("rpm for rad/s", "9.549")],
    "st11": [("speed", "9.549")], "st12": [("factor", "2")], "st13": [], "st14": [("coriolis", "0.5")],
    "st15": [("weight for mass", "9.81")], "st16": [("swapped", ""), ("swapped", "")], "st17": [("rows", "4, 5")],
    "st18": [("assembly", "4-5")], "st19": [("reversed", "rotation")],
    "st26": [("factor", "2"), ("radius for diameter", "0.5"), ("turns for radians", "0.1592")],
    "st28": [("shifted", "-1")],
    "st01": [], "st03": [], "st04": [], "st05": [], "st08": [], "st27": [], "st30": [],
}  # fmt: skip


@pytest.mark.parametrize("id", many(NAMED, 6))
def test_what_was_planted_is_named_and_nothing_else(id):
    assert sorted((cause.kind, cause.detail) for cause in marked(id).causes) == sorted(NAMED[id])


@pytest.mark.exhaustive
@pytest.mark.parametrize("id", ["st18", "st19"])
def test_another_assembly_or_rotation_costs_the_first_column_alone(id):
    found = marked(id)
    lost = {key for (_, key), column in found.columns.items() if (column.worth - column.points).sum() > 0.01}
    assert lost == {"S_D"}
