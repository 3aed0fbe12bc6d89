"""What a table of so many positions makes of functions whose extremes and integrals are known."""

import numpy as np
import pytest

from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.rivals import counts
from tmm_report.mechanics.rivals.counts import COUNTS, Counted, Wanted, counted

TURN = 2 * np.pi
OVER = panels(TURN)


def table(*functions):
    """At equal steps, of functions of the angle."""
    return lambda count: np.array([of(np.arange(count + 1) * (TURN / count)) for of in functions])


def single(function):
    return lambda count: table(function)(count)[0]


def test_the_greatest_of_a_table_is_short_by_how_far_the_nearest_position_is():
    def wave(x):
        return 2 * np.exp(1j * x) * np.cos(x / 2 - 0.05)  # greatest at 0.1 rad

    found = counts.greatest("v", OVER, wave(OVER.x)[None], table(wave))
    for count in (12, 24, 100):
        off = 0.1 - round(0.1 / (TURN / count)) * (TURN / count)
        assert found.error(count) == pytest.approx(1 - np.cos(off / 2), rel=1e-6)


def test_the_worst_of_several_vectors_counts_and_one_that_is_nothing_does_not():
    rows = [lambda x: np.cos(x), lambda x: 1e-3 * np.cos(x - 0.1), lambda x: 1e-16 * np.cos(x - 0.2)]
    found = counts.greatest("v", OVER, np.array([of(OVER.x) for of in rows]), table(*rows))
    assert found.error(12) == pytest.approx(1 - np.cos(0.1), rel=1e-6)


def test_least_and_greatest_are_judged_by_the_larger_of_them():
    def wave(x):
        return 3 + np.cos(x - 0.1)

    found = counts.extremes("J", OVER, wave(OVER.x), single(wave))
    assert found.exact == pytest.approx([2, 4])
    assert found.error(12) == pytest.approx((1 - np.cos(0.1)) / 4, rel=1e-6)


def test_integrals_and_means_are_sums_over_the_positions_but_the_last():
    def wave(x):
        return 1 + np.cos(12 * x)

    for make in (counts.total, counts.mean):
        found = make("A", OVER, wave(OVER.x), single(wave))
        assert found.error(12) == pytest.approx(1.0)  # twelve positions, all of them on the crests
        assert found.error(24) < 1e-14


def test_a_work_that_is_nothing_is_not_asked_for():
    found = counts.total("A", OVER, np.cos(OVER.x), single(np.cos))
    assert not found.known
    assert counted([found]).errors == {}


def test_excess_work_of_a_sine_by_trapezia():
    """A = M(1 − cos φ) swings by 2M; the sum of trapezia by (h/2)cot(h/2) of it."""
    moment, inertia = (lambda x: 5 + 40 * np.sin(x)), (lambda x: 0.3 + 0 * x)
    functions = moment(OVER.x), inertia(OVER.x)
    found = counts.unevenness("δ", OVER, functions, table(moment, inertia), 20.0)
    assert found.exact == pytest.approx([80.0])
    for count in (12, 24, 36):
        h = TURN / count
        assert found.error(count) == pytest.approx(1 - h / 2 / np.tan(h / 2), rel=1e-9)


def test_the_links_that_swing_take_part_in_the_excess():
    """With J = a cos φ and the same moment, A − Jω²/2 = const − (M + aω²/2) cos φ."""
    moment, inertia = (lambda x: 40 * np.sin(x)), (lambda x: 0.3 + 0.1 * np.cos(x))
    found = counts.unevenness("δ", OVER, (moment(OVER.x), inertia(OVER.x)), table(moment, inertia), 20.0)
    assert found.exact == pytest.approx([2 * (40 + 0.1 * 200)])
    assert found.error(360) < 1e-4


# ---------------------------------------------------------------- how many are enough


def of_errors(*rows, accuracy=0.01):
    return Counted(COUNTS, accuracy, {f"q{k}": row for k, row in enumerate(rows)})


def test_enough_is_the_least_count_from_which_on_all_are_within():
    lucky = (0.001, 0.05, 0.009, 0.004, 0.001)
    assert of_errors(lucky).enough == {"q0": 36}
    assert of_errors(lucky, accuracy=0.06).recommended == 12
    assert of_errors(lucky, (0.02, 0.02, 0.02, 0.01, 0.001)).recommended == 72
    assert of_errors(lucky, (0.02, 0.02, 0.02, 0.02, 0.02)).recommended is None
    assert of_errors(lucky, (float("nan"),) * 5).recommended is None
    assert of_errors().recommended == 12


def test_a_course_is_content_with_one_percent():
    def of(count):
        return np.array([1 + 0.5 / count])

    wanted = Wanted("x", np.ones(1), np.ones(1), of, lambda values: values)
    found = counted([wanted])
    assert found.accuracy == 0.01
    assert found.errors["x"] == pytest.approx([0.5 / count for count in COUNTS])
    assert found.recommended == 72
    assert counted([wanted], accuracy=0.1).recommended == 12
