"""Which way positive numbers point is told, and whoever holds another sense throughout loses nothing by it."""

from __future__ import annotations

import re

import numpy as np
import pytest
from conftest import solved

from tmm_report.grading import rubric as rubrics
from tmm_report.grading.expected import expected
from tmm_report.grading.handed_in.answers import read
from tmm_report.grading.handed_in.template import template
from tmm_report.grading.marks import grade
from tmm_report.grading.model import Answered, Answers, Rule
from tmm_report.grading.rubric import Rubric
from tmm_report.grading.senses import lines, told

TABLES = ("outputs_table", "rates_table", "loads_table", "reactions_table", "balancing_table")


def work(name, turned, spoilt=None):
    """The right numbers, some columns with the opposite sign."""
    columns = {}
    for key, one in expected(solved(name)).items():
        if key[0] in TABLES and not re.search(r"_[xy]$|^x_|^alpha_|^M_(lever|power|\d)|^t$", key[1]):
            values = one.values * (-1.0 if turned(key, one) else 1.0)
            if spoilt and key[1] == spoilt:
                values[3] *= 2
            columns[key] = Answered(values, np.isfinite(values), ("",) * len(values), ("",) * len(values))
    return Answers("x", columns)


def marked(name, turned, rubric=None, spoilt=None):
    return grade(solved(name), work(name, turned, spoilt), rubric or Rubric(), expected(solved(name)))


def of_outputs(key, one):
    return key[0] == "outputs_table"


def turns(key, one):
    return key[0] != "outputs_table" and one.signed and one.unit in ("rad/s", "rad/s²", "N·m")


@pytest.mark.parametrize("name", ["shaper", "compressor", "press", "crank_rocker", "slotter"])
@pytest.mark.parametrize("turned", [of_outputs, turns])
def test_another_sense_held_throughout_costs_nothing_and_is_told(name, turned):
    found = marked(name, turned)
    assert found.points == marked(name, lambda key, one: False).points
    assert found.causes and {cause.kind for cause in found.causes} == {"sense"}


def test_or_a_mark_each_where_the_rubric_says_so():
    rubric = rubrics.loads("senses: 1")
    found = marked("shaper", of_outputs, rubric)
    kept = len(found.causes)
    assert kept and found.points == 100 - kept and found.would == (101.0 - kept,) * kept


def test_one_column_alone_with_the_opposite_sign_is_a_mistake():
    for key in ("V_D", "w_3"):
        found = marked("shaper", lambda name, one, key=key: name[1] == key)
        assert found.points < 100 and [cause.kind for cause in found.causes] == ["sign"]


def test_strict_signs_are_asked_as_they_are_told():
    found = marked("shaper", of_outputs, rubrics.loads("signs: strict"))
    assert found.points < 100 and "sense" not in {cause.kind for cause in found.causes}


def test_a_slip_in_a_work_of_another_sense_is_charged_alone():
    found = marked("shaper", turns, spoilt="w_3")
    wrong = [
        (name, k)
        for name, column in found.columns.items()
        for k, rule in enumerate(column.rules)
        if rule in (Rule.OFF, Rule.SIGN)
    ]
    assert wrong == [(("rates_table", "w_3"), 3)]


def test_the_sheet_says_which_way_is_positive():
    from tmm_report.i18n import Translator

    results = solved("shaper")
    said = lines(results, lambda text: text)
    (travel,) = [one for one in results.lever.kinematics.travels if one.output.kind == "slider"]
    way = "to the right" if travel.output.direction.real > 0 else "to the left"
    assert f"S_D, V_D, A_D: positive {way}" in said and any("counter-clockwise" in one for one in said)
    assert len(said) == len(list(told(results)))
    asked, rubric = expected(results), Rubric()
    worth = rubrics.worth(rubric, asked, True)
    for suffix in (".csv", ".yaml", ".xlsx"):
        files = template(asked, worth, suffix, Translator("en"), senses=said)
        if suffix != ".xlsx":
            assert any(said[0] in content.decode("utf-8") for content in files.values())
        contents = [(f"sheet{end}", content) for end, content in files.items()]
        blank = read(contents, "x", asked)
        assert not blank.notes, [str(note) for note in blank.notes]


def test_another_axis_is_no_excuse_for_another_motion():
    """Velocities alone turned round: the accelerations would have to be so, too."""
    found = marked("shaper", lambda key, one: key[1] in ("V_D", "A_D"))
    assert "sense" not in {cause.kind for cause in found.causes}
