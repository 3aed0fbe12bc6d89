"""The comparison of a student's number with the solution, cell by cell."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.grading.model import RIGHT, Asked, Rule
from tmm_report.judging.judge import default_floor, deviation, judge, takes_magnitudes
from tmm_report.problems import Message
from tmm_report.quantity.model import Quantity

NUMBERS = st.floats(-1e6, 1e6, allow_nan=False)
FLOORS = st.floats(0, 1e3)
POWERS = st.integers(-20, 20)


def asked(*values: float, unit: str = "m/s", **more) -> Asked:
    rows = tuple(map(str, range(len(values))))
    more = {"by_position": len(values) > 1, **more}
    return Asked(
        "table",
        Quantity("v_B", None, unit, Message("v")),
        np.array(values, dtype=float),
        rows,
        "kinematics",
        **more,
    )


def rule(a: float, g: float, floor: float = 0.0, **more) -> Rule:
    return judge(asked(a, **more), np.array([g]), np.array([True]), floor=floor).rules[0]


def rules(column: Asked, *mine: float, **how) -> list[Rule]:
    return list(judge(column, np.array(mine), np.isfinite(mine), **how).rules)


@given(NUMBERS, FLOORS)
def test_a_number_agrees_with_itself(a, floor):
    assert rule(a, a, floor) in RIGHT


@given(NUMBERS, NUMBERS, FLOORS)
def test_which_of_the_two_is_the_students_does_not_matter(a, g, floor):
    assert rule(a, g, floor) is rule(g, a, floor)


@given(NUMBERS, NUMBERS, FLOORS, POWERS)
def test_a_change_of_unit_changes_no_verdict(a, g, floor, power):
    by = 2.0**power
    assert rule(a, g, floor) is rule(a * by, g * by, floor * by)


@given(NUMBERS, FLOORS)
def test_what_is_no_number_is_never_right(a, floor):
    for missing in (np.nan, np.inf, -np.inf):
        assert rule(a, missing, floor) is Rule.NO_ANSWER


@given(NUMBERS, st.floats(0, 1e6), st.floats(0, 1), st.sampled_from((-1, 1)), FLOORS)
def test_what_is_nearer_on_the_same_side_is_judged_no_worse(a, far, part, side, floor):
    if rule(a, a + side * far, floor) in RIGHT:
        assert rule(a, a + side * far * part, floor) in RIGHT


@given(NUMBERS, NUMBERS, FLOORS)
def test_the_deviation_in_one_number_says_the_same(a, g, floor):
    one = float(deviation(np.array(a), np.array(g), 5.0, floor))
    assert (one <= 1) == (rule(a, g, floor) in RIGHT)


def test_the_difference_has_the_sign_of_the_excess_in_magnitude():
    given = np.array([103.0, -103.0, 97.0])
    delta = judge(asked(100, -100, 100), given, np.ones(3, dtype=bool)).delta
    assert delta == pytest.approx([200 * 3 / 203, 200 * 3 / 203, -200 * 3 / 197])


def test_the_limit_is_the_courses():
    assert rule(39, 41) is Rule.LIMIT  # 200 * 2/80 = 5 %
    assert rule(39, 41.1) is Rule.OFF
    assert rules(asked(39), 41.1, limit=6.0) == [Rule.LIMIT]


def test_a_large_negative_answer_is_wrong_though_the_formula_gives_a_small_number():
    assert rule(1.0, -1000.0) is Rule.SIGN
    assert rule(1e-9, -1.0) is Rule.SIGN


def test_near_zero_the_floor_decides():
    column = asked(50.0, 3.0, 0.1, 0.1, 0.5, 3.0)  # floor: 50/50 = 1
    assert rules(column, 50.0, 3.9, -0.4, 2.0, -0.9, -0.9) == [
        *(Rule.LIMIT, Rule.FLOOR, Rule.ZERO),
        *(Rule.OFF, Rule.ZERO, Rule.SIGN),
    ]
    assert rules(column, 50.0, 3.9, 0.1, 0.1, 0.5, 3.0, floor=0.5)[1] is Rule.OFF


def test_single_values_have_no_floor_but_the_rounding_of_the_solution():
    assert default_floor(asked(50.0)) == pytest.approx(50e-9)
    assert rules(asked(1e-16), 0.0) == [Rule.ZERO]
    assert rules(asked(5.0, 2e-16, by_position=False), 5.0, 0.0) == [Rule.LIMIT, Rule.ZERO]


def test_a_blank_is_no_answer_and_where_the_solution_has_nothing_nothing_is_asked():
    judged = judge(asked(1.0, np.nan, 2.0), np.array([np.nan, 5.0, 2.0]), np.array([True, True, False]))
    assert judged.rules == (Rule.NO_ANSWER, Rule.NOT_ASKED, Rule.NO_ANSWER)
    assert np.isnan(judged.delta).all()


def test_angles_are_compared_on_the_circle():
    column = asked(359.5, 3.5, 0.5, 180.0, 90.0, unit="deg", angle=True)
    assert rules(column, 0.5, 362.0, -0.5, -180.0, 30.0, floor=2.0) == [
        *(Rule.LIMIT, Rule.FLOOR, Rule.ZERO),
        *(Rule.LIMIT, Rule.OFF),
    ]
    turned = rules(asked(6.2, unit="rad", angle=True), 6.2 - 4 * np.pi)
    assert turned == [Rule.LIMIT]


@given(st.floats(1, 359), st.integers(-3, 3))
def test_full_turns_change_no_verdict_of_an_angle(a, turns):
    assert rules(asked(a, unit="deg", angle=True), a + 360.0 * turns) == [Rule.LIMIT]


def test_whole_numbers_are_right_or_wrong():
    assert rules(asked(112, whole=True), 112.0) == [Rule.EXACT]
    assert rules(asked(112, whole=True), 113.0) == [Rule.OFF]


def test_magnitudes_are_compared_with_magnitudes():
    column, mine = asked(-10.0, 10.0, 0.1), (10.0, 10.1, 0.0)
    assert rules(column, *mine)[0] is Rule.SIGN
    assert set(rules(column, *mine, magnitudes=True)) <= set(RIGHT)
    assert takes_magnitudes(column, np.array(mine))


def test_a_column_with_a_negative_number_is_none_of_magnitudes():
    column = asked(-10.0, 10.0, -5.0)
    assert not takes_magnitudes(column, np.array([10.0, -10.0, 5.0]))
    assert not takes_magnitudes(asked(10.0, 5.0, -0.01), np.array([10.0, 5.0, 0.01]))  # that is 0 of a plan
    assert not takes_magnitudes(column, np.array([np.nan, 10.0, np.nan]))
