"""Rivals are judged by one measure: errors relative to the largest value, none of rounding; the cheapest that does."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.methods import cost
from tmm_report.mechanics.methods.choice import FLOOR, rounded
from tmm_report.mechanics.methods.forces import FORCES
from tmm_report.mechanics.methods.model import Method, Pair, Trial
from tmm_report.mechanics.methods.motions import MOTIONS
from tmm_report.mechanics.methods.trials import (
    ROUNDING,
    Judged,
    Rivals,
    cheapest,
    error_of,
    errors_of,
    interleaved,
    over,
    pareto,
    trials,
    tried,
    worst,
)
from tmm_report.problems import Message


def way(key: str, run=lambda scene, count: count, refuses=lambda scene: None) -> Method:
    return Method(key, key, run, refuses)


def trial(key: str, seconds: float, error: float, count: int = 12) -> Trial:
    return Trial(way(key), count, seconds, {"all": error})


some = st.floats(1e-15, 1.0)
lists = st.lists(st.tuples(some, some), min_size=1, max_size=12).map(
    lambda rows: [trial(str(k), *row) for k, row in enumerate(rows)]
)


# --- the front and the cheapest


@given(lists)
def test_nobody_on_the_front_is_beaten_and_all_others_are(found):
    front = pareto(found)
    for one in found:
        error = max(ROUNDING, worst(one.errors))
        beaten = any(
            other is not one and other.seconds <= one.seconds and max(ROUNDING, worst(other.errors)) <= error
            for other in found
        )
        assert beaten or any(one is other for other in front)
    errors = [worst(one.errors) for one in front]
    assert [one.seconds for one in front] == sorted(one.seconds for one in front)
    assert all(later < earlier for earlier, later in pairwise(errors))


@given(lists, some)
def test_the_cheapest_holds_the_accuracy_and_no_cheaper_one_does(found, accuracy):
    best = cheapest(found, accuracy)
    good = [one for one in found if worst(one.errors) <= accuracy]
    assert (best is None) == (not good)
    assert best is None or best.seconds == min(one.seconds for one in good)


def test_what_finds_only_a_part_or_loses_positions_is_never_chosen():
    whole = Trial(way("whole"), 12, 2.0, {"reaction": 1e-9, "moment": 1e-9})
    part = Trial(way("part"), 12, 1.0, {"moment": 1e-16})
    lost = Trial(way("lost"), 12, 0.5, {"reaction": math.nan, "moment": 1e-16})
    assert cheapest([part, lost, whole], 1e-6) is whole and pareto([part, lost, whole]) == [whole]


def test_of_two_rounding_errors_the_smaller_is_no_better():
    assert [one.method.key for one in pareto([trial("quick", 1, 3e-16), trial("slow", 2, 1e-16)])] == [
        "quick"
    ]


def test_over_several_counts_times_add_up_and_the_largest_error_counts():
    found = [trial("a", 1.0, 1e-3, 12), trial("a", 2.0, 1e-5, 36), trial("b", 1.0, 1e-9, 12)]
    (one,) = over(found, (12, 36))  # b was not tried at 36
    assert (one.method.key, one.count, one.seconds, worst(one.errors)) == ("a", 48, 3.0, 1e-3)


# --- errors


def test_an_error_is_relative_to_the_largest_value_of_its_row():
    exact = Pair(np.array([[1.0, -4.0], [100.0, 50.0]]), np.zeros((2, 2)))
    assert error_of(exact, np.array([[1.0, -4.1], [100.0, 50.5]])) == pytest.approx(0.1 / 4)


@pytest.mark.parametrize("origin", [0, 1e3, 1e3j])
def test_an_error_of_a_place_is_relative_to_the_longest_way_wherever_the_mechanism_is_drawn(origin):
    places = origin + np.array([[0, 2, 4j, 1], [3, 3, 3, 3]])
    off = np.zeros((2, 4))
    off[1, 2] = 0.1
    exact = {"place": Pair(places, np.zeros((2, 4)))}
    assert errors_of(exact, {"place": places + off})["place"] == pytest.approx(0.1 / 4)
    assert math.isnan(errors_of(exact, {"place": np.where(off, np.nan, places)})["place"])


def test_a_point_that_hardly_moves_is_not_measured():
    exact = Pair(np.array([[1.0, 2.0], [1e-17, 2e-17]]), np.zeros((2, 2)))
    assert error_of(exact, np.array([[1.0, 2.0], [0.0, 0.0]])) == 0.0


def test_a_lost_position_is_no_small_error():
    exact = Pair(np.array([[1.0, 2.0]]), np.zeros((1, 2)))
    assert math.isnan(error_of(exact, np.array([[1.0, np.nan]])))


@given(st.floats(1e-300, 0.99))
def test_a_rounded_error_is_never_smaller_and_has_one_digit(error):
    told = rounded(error)
    assert told >= error * (1 - 1e-5) and f"{told:.0e}" == f"{told:.6e}".replace(".000000", "")
    assert told == FLOOR if error <= FLOOR else told <= 2 * error * (1 + 1e-9)


def test_no_error_at_all_is_told_as_rounding_and_nothing_found_as_nothing():
    assert rounded(0.0) == FLOOR and math.isnan(rounded(math.nan))


# --- runs


def test_what_breaks_down_is_told_and_not_timed():
    def breaks(scene, count):
        raise ArithmeticError("it diverges")

    rivals = Rivals([way("good"), way("bad", breaks)], None, lambda count, found: {"all": 0.0}, (12, 36))
    found = trials(rivals, 0.01)
    assert [(one.method.key, one.broken) for one in found] == [("good", None), ("bad", "it diverges")] * 2
    assert all(math.isfinite(one.seconds) == (one.broken is None) for one in found)


def test_what_refuses_is_not_run():
    why = Message("it cannot")
    rivals = Rivals(
        [way("good"), way("not", refuses=lambda scene: why)], None, lambda count, found: {"all": 0.0}, (12,)
    )
    assert [one.method.key for one in tried(rivals)] == ["good"]
    assert [(method.key, said) for method, said in rivals.refused] == [("not", why)]


def test_rivals_take_turns():
    order: list[str] = []
    interleaved([lambda: order.append("a"), lambda: order.append("b")], 5.0)
    assert order[:6] == ["a", "b"] * 3


# --- the table of costs


def test_the_table_knows_every_method_and_no_other():
    assert {method.key for method in MOTIONS} == set(cost.MOTION) == set(cost.FOLLOWED)
    assert {method.key for method in FORCES} == set(cost.FORCES)


def test_a_cost_grows_with_links_and_positions():
    for one in (*cost.MOTION.values(), *cost.FOLLOWED.values(), *cost.FORCES.values()):
        assert 0 < one.of(3, 12) < one.of(3, 100) and one.of(3, 12) < one.of(9, 12)


def test_the_cheapest_holds_the_accuracy_at_all_the_counts_asked_together():
    quick = [trial("quick", 1.0, 1e-7, 12), trial("quick", 1.0, 1e-3, 36)]
    slow = [trial("slow", 3.0, 1e-9, count) for count in (12, 36)]
    found = Judged("motion", (*quick, *slow), (), 1e-6, (12, 36))
    assert found.best is not None and found.best.method.key == "slow" and found.best.seconds == 6.0
    assert found.front == {0, 2} and found.kinds == ("all",)
