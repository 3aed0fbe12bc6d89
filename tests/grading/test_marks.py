"""A work marked cell by cell: what decides, what follows from a wrong value, what a mistake costs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import solved
from exhaustive import many

from tmm_report.course import solve
from tmm_report.grading import rubric as rubrics
from tmm_report.grading.expected import expected
from tmm_report.grading.marks import digest, grade
from tmm_report.grading.model import RIGHT, Answered, Answers, Rule
from tmm_report.grading.rubric import Rubric
from tmm_report.judging.diagnose.variants import prepared
from tmm_report.loading import loads

VARIANTS = Path(__file__).parents[2] / "variants"


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


@pytest.mark.exhaustive
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


@pytest.mark.exhaustive
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


@pytest.mark.exhaustive
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


# ---------------------------------------------------------------- points that nobody earned


def everything(asked, value) -> dict:
    """All that is asked by positions answered with one and the same number."""
    return {name: np.full(len(one.rows), value) for name, one in asked.items() if one.by_position}


@pytest.mark.exhaustive
@pytest.mark.parametrize("value", many([0.0, 1.0, 1234.5, 1e300]))
@pytest.mark.parametrize("name", ["compressor", "press", "forging", "crank_rocker"])
def test_one_number_in_every_cell_earns_next_to_nothing(name, value):
    """Of a press all forces but two are nothing beside the greatest: noughts in all cells had half of the points."""
    own = expected(solved(name))
    found = marked(own, everything(own, value), name=name, keep=lambda column: own[column].by_position)
    assert found.points < 8


def test_a_nought_among_numbers_is_still_right(asked):
    name = ("outputs_table", "V_B")
    values = np.round(asked[name].values, 1)
    found = marked(asked, {name: values})
    assert found.columns[name].rules[0] is Rule.ZERO and found.points == 100


def test_a_wrong_column_keeps_its_noughts(asked):
    name = ("outputs_table", "V_B")
    assert marked(asked, {name: -asked[name].values}).columns[name].rules[0] in RIGHT


def test_nothing_follows_from_one_number_all_along(asked):
    """R_12 = R_01 = 7777 N everywhere: made up, not taken further."""
    changes = {("reactions_table", key): np.full(13, 7777.0) for key in ("R_12", "R_01")}
    found = marked(asked, changes, keep=without_components)
    assert Rule.CARRIED not in found.columns["reactions_table", "R_01"].rules


def test_weights_are_not_read_off_a_plan_however_coarse_its_scale(asked):
    name = ("loads_table", "G_2")
    found = marked(asked, {name: np.zeros(13)}, scales={"mu_F": 1e6})
    assert set(found.columns[name].rules) == {Rule.OFF}


@pytest.mark.exhaustive
def test_numbers_of_another_variant_do_not_follow_from_each_other(asked):
    """They are consistent, as they would be with a datum read wrongly; but they are somebody's."""
    text = (VARIANTS / "compressor.yaml").read_text("utf-8").replace("A: 100 mm", "A: 112 mm")
    other = expected(solve(loads(text)))
    changes = {name: other[name].values for name in asked if asked[name].by_position}
    own = marked(asked, changes, keep=without_components)
    known = grade(
        solved("compressor"), answered(asked, changes, keep=without_components), Rubric(), asked,
        prepared({"petrov": other}),
    )  # fmt: skip
    assert [cause.kind for cause in known.causes] == ["variant"] and known.would == (100.0,)
    assert known.points < 60 < own.points


# ---------------------------------------------------------------- points that nobody should lose


def test_who_numbers_the_positions_from_1_to_12_has_position_0_in_the_last_row(asked):
    answers = answered(asked)
    for one in answers.columns.values():
        if len(one.values) == 13:
            one.values[0], one.given[0] = np.nan, False
    assert grade(solved("compressor"), answers, Rubric(), asked).points == 100


@pytest.mark.exhaustive
def test_millimetres_in_all_columns_are_named_though_velocities_follow_from_places():
    own = expected(solved("quick_return"))
    names = [name for name, one in own.items() if one.by_position and one.unit in ("m", "m/s", "m/s²")]
    changes = {name: own[name].values * 1000 for name in names if without_components(name)}
    found = marked(own, changes, name="quick_return", keep=without_components)
    assert [cause.kind for cause in found.causes] == ["mm for m"] and found.would == (100.0,)


def test_a_mistake_is_named_where_it_was_made_and_not_where_it_was_taken_further():
    """All reactions twice too great: the first is the mistake, and of the others those that follow are not named."""
    own = expected(solved("shaper"))
    names = [name for name, one in own.items() if name[0] == "reactions_table" and name[1][:2] == "R_"]
    changes = {name: own[name].values * 2 for name in names}
    found = marked(own, changes, name="shaper", keep=without_components)
    (cause,) = found.causes
    assert cause.kind == "factor" and ("reactions_table", "R_34") in cause.names
    sizes = [name for name in names if without_components(name)]
    followed = [name for name in sizes if all(found.columns[name].carried)]
    assert followed and not set(followed) & set(cause.names)


def test_a_force_along_the_stroke_follows_from_a_wrong_moment():
    """Where a slider drives: the solution itself is right; who has the reduced moment wrong and goes on rightly loses
    that one column."""
    own = expected(solved("slider_drives"))
    assert marked(own, name="slider_drives").points == 100
    moment, force = ("balancing_table", "M_bal"), ("drive_table", "F_stroke")
    wrong = {name: own[name].values * 1.2 for name in (moment, force)}
    found = marked(own, wrong, name="slider_drives")
    assert set(found.columns[force].carried) == {"M_bal"}
    assert Rule.OFF in found.columns[moment].rules
