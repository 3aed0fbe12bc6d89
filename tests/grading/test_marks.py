"""A work marked cell by cell: what decides, what follows from a wrong value, what a mistake costs."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import solved

from tmm_report.grading import rubric as rubrics
from tmm_report.grading.expected import expected
from tmm_report.grading.marks import digest, grade
from tmm_report.grading.model import RIGHT, Answered, Answers, Rule
from tmm_report.grading.rubric import Rubric


@pytest.fixture(scope="module")
def asked():
    return expected(solved("compressor"))


def answered(asked, changes=None, scales=None, keep=lambda name: True) -> Answers:
    """The right numbers to five digits, some changed: {(table, key): values}."""
    changes = changes or {}
    columns = {}
    for name, one in asked.items():
        if keep(name):
            values = np.array(changes.get(name, one.values), dtype=float)
            columns[name] = Answered(values, np.isfinite(values), ("",) * len(values), ("",) * len(values))
    return Answers("x", columns, scales or {})


def marked(asked, changes=None, rubric=None, name="compressor", **more):
    return grade(solved(name), answered(asked, changes, **more), rubric or Rubric(), asked)


def test_the_solution_itself_is_full_marks(variant_name, request):
    own = expected(solved(variant_name))
    found = marked(own, name=variant_name)
    assert found.points == found.worth == 100 and not found.causes
    rules = [rule for column in found.columns.values() for rule in column.rules]
    assert set(rules) <= {*RIGHT, Rule.NOT_ASKED}


@pytest.fixture(params=["compressor", "eccentric", "hay_press", "crank_rocker", "chebyshev_conveyor"])
def variant_name(request):
    return request.param


def test_nothing_handed_in_is_no_points(asked):
    found = grade(solved("compressor"), Answers("x", {}), Rubric(), asked)
    assert found.points == 0 and not found.causes
    assert {rule for column in found.columns.values() for rule in column.rules} <= {
        Rule.NO_ANSWER,
        Rule.NOT_ASKED,
    }


def test_a_wrong_cell_costs_what_it_is_worth_and_no_more(asked):
    values = asked["rates_table", "v_C"].values.copy()
    values[3] *= 1.2
    found = marked(asked, {("rates_table", "v_C"): values})
    column = found.columns["rates_table", "v_C"]
    assert column.rules[3] is Rule.OFF and found.points == pytest.approx(100 - column.worth[3], abs=0.01)


def test_magnitudes_of_a_plan_are_taken_where_signs_are_free_and_refused_where_strict(asked):
    name = ("rates_table", "w_2")
    changes = {name: np.abs(asked[name].values)}
    free = marked(asked, changes)
    assert free.columns[name].judged.magnitudes and free.points == 100
    strict = marked(asked, changes, rubrics.loads("signs: strict"))
    assert Rule.SIGN in strict.columns[name].rules and strict.points < 100


def test_a_velocity_of_an_output_without_its_sign_is_wrong(asked):
    name = ("outputs_table", "V_B")
    found = marked(asked, {name: np.abs(asked[name].values)})
    assert found.columns[name].rules[8] is Rule.SIGN


def test_teeth_are_right_or_wrong(asked):
    name = ("stage2_wheels", "z")
    found = marked(asked, {name: [14, 29]})  # 3.5 % too many
    assert found.columns[name].rules == (Rule.EXACT, Rule.OFF)


def test_a_students_own_scale_says_what_can_be_read_and_a_hostile_one_says_nothing(asked):
    name = ("rates_table", "v_BA")
    values = asked[name].values.copy()
    values[0] = values[0] + 0.11  # 1 mm at 0.12 (m/s)/mm, nothing at 0.02
    values[3] = asked[name].values[3] + 0.11  # where it is nearly nothing
    fine = marked(asked, {name: values}, scales={"mu_v": 0.02}).columns[name]
    coarse = marked(asked, {name: values}, scales={"mu_v": 0.12}).columns[name]
    assert fine.rules[3] is Rule.OFF and coarse.rules[3] in RIGHT
    everything = {one: np.zeros(len(asked[one].rows)) for one in asked if one[0] == "rates_table"}
    hostile = marked(asked, everything, scales={"mu_v": 1e8, "mu_a": 1e8})
    assert Rule.OFF in hostile.columns["rates_table", "v_A"].rules and hostile.points < 90


def without_components(name) -> bool:
    return not name[1].endswith(("_x", "_y"))


def test_what_follows_from_a_wrong_velocity_is_carried_and_the_velocity_is_not(asked):
    """A student who has v_BA a fifth too great, and from it the normal acceleration (v²/l) and ω, right as it goes."""
    changes = {
        ("rates_table", key): asked["rates_table", key].values * factor
        for key, factor in (("v_BA", 1.2), ("w_2", 1.2), ("a_BA_n", 1.44))
    }
    found = marked(asked, changes, keep=without_components)
    rules = {key: found.columns["rates_table", key].rules[2] for key in ("v_BA", "w_2", "a_BA_n")}
    assert rules == {"v_BA": Rule.OFF, "w_2": Rule.CARRIED, "a_BA_n": Rule.CARRIED}
    assert found.columns["rates_table", "w_2"].carried[2] == "v_BA"
    none = marked(asked, changes, rubrics.loads("carried: 0"), keep=without_components)
    assert none.points < found.points < 100


def test_two_wrong_values_do_not_excuse_each_other(asked):
    """Both ends of a chain by the same wrong factor: one of them at least is the mistake."""
    changes = {("rates_table", key): asked["rates_table", key].values * 1.3 for key in ("v_BA", "w_2")}
    found = marked(asked, changes, keep=without_components)
    rules = [found.columns["rates_table", key].rules[2] for key in ("v_BA", "w_2")]
    assert rules.count(Rule.OFF) == 1


def test_a_named_mistake_may_keep_a_share_of_its_points(asked):
    name = ("outputs_table", "S_B")
    changes = {name: asked[name].values * 1000}
    found = marked(asked, changes)
    assert [cause.kind for cause in found.causes] == ["mm for m"] and found.would == (100.0,)
    half = marked(asked, changes, rubrics.loads("named: 0.5"))
    lost = 100 - found.points
    assert half.points == pytest.approx(100 - lost / 2, abs=0.02)


def test_a_digest_keeps_the_cells_that_are_asked_or_answered(asked):
    found = digest(marked(asked))
    assert found.points == 100 and found.cells["rates_table", "v_B", "7"][1] == "limit"
    assert found.right["rates_table", "v_B", "7"] == pytest.approx(4.4437, abs=1e-4)
    assert found.columns["rates_table", "v_B"][0] == pytest.approx(found.columns["rates_table", "v_B"][1])
