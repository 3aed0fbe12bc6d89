"""Rivals are judged by one measure: errors relative to the largest value, none of rounding; the cheapest that does."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import groupby, pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.rivals import cost
from tmm_report.mechanics.rivals.choice import FLOOR, rounded
from tmm_report.mechanics.rivals.forces import FORCES
from tmm_report.mechanics.rivals.model import Method, Pair, Trial
from tmm_report.mechanics.rivals.motion.every import MOTIONS
from tmm_report.mechanics.rivals.trials import (
    ROUNDING,
    SAME,
    Judged,
    Rivals,
    cheapest,
    error_of,
    errors_of,
    interleaved,
    over,
    pareto,
    run_off,
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
    if best is not None:
        equal = [one for one in good if one.seconds <= SAME * min(other.seconds for other in good)]
        assert best in equal and worst(best.errors) <= max(ROUNDING, min(worst(one.errors) for one in equal))


def test_what_finds_only_a_part_or_loses_positions_is_never_chosen():
    whole = Trial(way("whole"), 12, 2.0, {"reaction": 1e-9, "moment": 1e-9})
    part = Trial(way("part"), 12, 1.0, {"moment": 1e-16})
    lost = Trial(way("lost"), 12, 0.5, {"reaction": math.nan, "moment": 1e-16})
    assert cheapest([part, lost, whole], 1e-6) is whole and pareto([part, lost, whole]) == [whole]


def test_of_two_rounding_errors_the_smaller_is_no_better():
    assert [one.method.key for one in pareto([trial("quick", 1, 3e-16), trial("slow", 2, 1e-16)])] == [
        "quick"
    ]


def test_a_method_stands_with_the_fewest_steps_that_hold():
    """More steps cost no less: that they seemed quicker once is chance."""
    rough, few, many = (trial("panels", *one) for one in ((1.0, 1e-3, 6), (1.0, 1e-9, 12), (0.5, 1e-14, 36)))
    other = trial("points", 1.02, 1e-12, 100)
    assert cheapest([rough, few, many], 1e-6) is few
    assert cheapest([rough, few, many], 1e-12) is many
    assert cheapest([rough, few, many, other], 1e-6) is other


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
    assert [name for name, _ in groupby(order)][:6] == ["a", "b"] * 3


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
    assert found.kinds == ("all",)
    assert [found.counts(one) for one in found.rows] == [(12,), (36,), (12, 36)] * 2
    assert found.front == {
        2,
        5,
    }  # one front for one task: neither is both quicker and more accurate at all of it
    assert any(one is found.best for one in found.rows)  # its time is printed


def test_a_count_that_is_a_setting_is_a_candidate():
    """A start-up: few steps will do, and the method that chooses its own is dearer."""
    few, many = trial("adams", 0.6, 8e-6, 100), trial("adams", 2.4, 3e-8, 400)
    found = Judged("start_up", (few, many, trial("lsoda", 1.2, 1e-7, 0)), (), 1e-5, ())
    assert found.best is few and found.counts(found.rows[2]) == ()
    assert replace(found, accuracy=1e-6).best.method.key == "lsoda"
    assert found.front == {0, 1, 2}


@pytest.mark.parametrize("noise", [0.97, 1.0, 1.03])
def test_of_equal_times_the_more_accurate_is_named_whatever_noise_likes(noise):
    closed, fourier = trial("groups", 1.0, 1e-15), trial("fourier", noise, 1e-12)
    for order in ([closed, fourier], [fourier, closed]):
        assert cheapest(order, 1e-6) is closed
    assert cheapest([closed, trial("fourier", 0.5, 1e-12)], 1e-6).method.key == "fourier"


def test_the_time_of_a_method_is_its_own_and_not_that_of_what_else_runs(monkeypatch):
    """A clock that other programs disturb in every round but one: the least is that of the method alone."""
    now, disturbed = 0.0, iter([3.0, 5.0, 0.0, 9.0, 4.0] * 40)
    monkeypatch.setattr("tmm_report.mechanics.rivals.trials.clock", lambda: now)

    def run():
        nonlocal now
        now += 0.25 + next(disturbed)

    assert interleaved([run], 60.0) == [pytest.approx(0.25)]


def test_who_may_be_the_cheapest_is_timed_again(monkeypatch):
    """A first reading that noise has spoilt does not name the winner; what is far off, or misses, is not run again."""
    now, ran = 0.0, []
    monkeypatch.setattr("tmm_report.mechanics.rivals.trials.clock", lambda: now)

    def method(key: str, seconds: float):
        def run(scene, count):
            nonlocal now
            now, _ = now + seconds, ran.append(key)

        return Method(key, key, run)

    quick, slow, far, off = (
        method(*one) for one in (("quick", 1.0), ("slow", 1.3), ("far", 9.0), ("off", 0.1))
    )
    first = [Trial(quick, 12, 1.5, {"all": 0.0}), Trial(slow, 12, 1.3, {"all": 0.0})]
    first += [Trial(far, 12, 9.0, {"all": 0.0}), Trial(off, 12, 0.1, {"all": 1.0})]
    rivals = Rivals((quick, slow, far, off), None, lambda count, found: {"all": 0.0}, (12,))
    judged = Judged("motion", tuple(first), (), 1e-6, (12,))
    assert judged.best.method is slow
    again = run_off(rivals, judged, 10.0)
    assert again.best.method is quick and again.best.seconds == pytest.approx(1.0)
    assert set(ran) == {"quick", "slow"}


def test_quick_methods_are_run_several_times_a_reading(monkeypatch):
    calls, ticks = [0, 0], iter(range(10**6))
    monkeypatch.setattr("tmm_report.mechanics.rivals.trials.clock", lambda: 1e-5 * next(ticks))

    def run():
        calls[0] += 1

    assert interleaved([run], 0.01)[0] > 0
    assert calls[0] > 50


def test_a_method_that_takes_its_own_steps_is_tried_once():
    own = Method("own", "own", lambda scene, count: count, counted=False)
    fixed = Method("fixed", "fixed", lambda scene, count: count)
    found = tried(Rivals((own, fixed), None, lambda count, found: {"all": 0.0}, (10, 20)))
    assert [(one.method.key, one.count) for one in found] == [("own", 0), ("fixed", 10), ("fixed", 20)]
