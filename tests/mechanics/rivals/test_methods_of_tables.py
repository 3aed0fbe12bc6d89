"""Rates from tables of positions: orders of convergence, tables with ends and with gaps, mechanisms of all kinds."""

import numpy as np
import pytest
from conftest import solved
from schemes import SCHEMES, four_bar, linkage
from scipy.interpolate import CubicSpline

from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.rivals import tables
from tmm_report.mechanics.rivals.tables import DIFFERENCES, FOURIER, SPLINE, TABLES, rates, unwrapped

KEYS = {one.key: one for one in TABLES}
TURN = 2 * np.pi
RULES = {"differences": DIFFERENCES, "spline": SPLINE, "fourier": FOURIER}


def orders(errors):
    """Of errors at counts that double: how many times the error halves twice as well."""
    errors = np.array(errors)
    return np.log2(errors[:-1] / errors[1:])


# ---------------------------------------------------------------- a function that repeats


def around(rule, count):
    """Largest errors of both derivatives of exp(sin x) at `count` steps of a turn."""
    x = np.arange(count + 1) * (2 * np.pi / count)
    y = np.exp(np.sin(x))
    slope, bend = rates(y, x[1], True, rule)
    return np.abs(slope - np.cos(x) * y).max(), np.abs(bend - (np.cos(x) ** 2 - np.sin(x)) * y).max()


@pytest.mark.parametrize(("name", "slope", "bend"), [("differences", 2, 2), ("spline", 4, 2)])
def test_errors_of_a_repeating_function_fall_by_the_order_of_the_rule(name, slope, bend):
    found = np.array([around(RULES[name], count) for count in (48, 96, 192)])
    assert orders(found[:, 0]) == pytest.approx([slope] * 2, abs=0.15)
    assert orders(found[:, 1]) == pytest.approx([bend] * 2, abs=0.15)


def test_a_trigonometric_sum_has_all_digits_as_soon_as_it_has_all_harmonics():
    assert around(FOURIER, 12)[0] > 1e-5
    assert max(around(FOURIER, 36)) < 1e-12


@pytest.mark.parametrize("count", [12, 13])
def test_a_trigonometric_sum_is_exact_up_to_half_of_its_positions(count):
    x = np.arange(count + 1) * (2 * np.pi / count)
    y = 0.5 + np.cos(5 * x) - 2 * np.sin(3 * x)
    slope, bend = rates(y, x[1], True, FOURIER)
    assert slope == pytest.approx(-5 * np.sin(5 * x) - 6 * np.cos(3 * x), abs=1e-12)
    assert bend == pytest.approx(-25 * np.cos(5 * x) + 18 * np.sin(3 * x), abs=1e-11)


def test_the_highest_harmonic_of_an_even_table_is_neither_forward_nor_backward():
    x = np.arange(13) * (TURN / 12)
    values = (1 + 2j) * np.cos(6 * x)
    slope, bend = rates(values, x[1], True, FOURIER)
    assert slope == pytest.approx(0.0, abs=1e-12)
    assert bend == pytest.approx(-36 * values, abs=1e-11)


def test_the_periodic_spline_is_that_of_the_library():
    x = np.linspace(0, 2 * np.pi, 15)
    y = np.exp(np.cos(x + 1))
    y[-1] = y[0]
    other = CubicSpline(x, y, bc_type="periodic")
    slope, bend = rates(y, x[1], True, SPLINE)
    assert slope == pytest.approx(other(x, 1), abs=1e-13)
    assert bend == pytest.approx(other(x, 2), abs=1e-12)


@pytest.mark.parametrize("rule", RULES.values(), ids=RULES)
def test_an_angle_that_gains_full_turns_has_their_rate_everywhere(rule):
    x = np.linspace(0, 2 * np.pi, 25)
    slope, bend = rates(3 * x + 0.2, x[1], True, rule)
    assert slope == pytest.approx(3.0, abs=1e-13)
    assert bend == pytest.approx(0.0, abs=1e-12)


def test_vectors_have_the_rates_of_both_their_components():
    x = np.linspace(0, 2 * np.pi, 25)
    values = np.exp(1j * x) + 0.3 * np.exp(-2j * x)
    for rule in RULES.values():
        both = rates(values, x[1], True, rule)
        parts = (rates(part, x[1], True, rule) for part in (values.real, values.imag))
        for whole, along, across in zip(both, *parts, strict=True):
            assert whole == pytest.approx(along + 1j * across, abs=1e-12)


# ---------------------------------------------------------------- a function with ends


def along(rule, count):
    x = np.linspace(0, 2, count + 1)
    slope, bend = rates(np.exp(x), x[1], False, rule)
    return np.abs(slope - np.exp(x)).max(), np.abs(bend - np.exp(x)).max()


@pytest.mark.parametrize(("name", "slope", "bend"), [("differences", 2, 2), ("spline", 3, 2)])
def test_errors_of_a_function_with_ends_fall_by_the_order_of_the_rule(name, slope, bend):
    found = np.array([along(RULES[name], count) for count in (80, 160, 320)])
    assert orders(found[:, 0]) == pytest.approx([slope] * 2, abs=0.15)
    assert orders(found[:, 1]) == pytest.approx([bend] * 2, abs=0.15)


@pytest.mark.parametrize("count", [4, 5, 6, 7, 20])
def test_the_spline_with_ends_is_that_of_the_library(count):
    x = np.linspace(1, 2, count)
    y = np.sin(5 * x)
    other = CubicSpline(x, y)
    slope, bend = rates(y, x[1] - x[0], False, SPLINE)
    assert slope == pytest.approx(other(x, 1), abs=1e-11)
    assert bend == pytest.approx(other(x, 2), abs=1e-9)


def test_three_values_make_a_parabola_and_two_a_line():
    x = np.array([0.0, 0.5, 1.0])
    for rule in (DIFFERENCES, SPLINE):
        slope, bend = rates(x**2 + x, 0.5, False, rule)
        assert slope == pytest.approx(2 * x + 1)
        assert bend == pytest.approx(2.0)
        slope, bend = rates(3 * x[:2], 0.5, False, rule)
        assert slope == pytest.approx(3.0)
        assert np.isnan(bend).all()


def test_a_gap_parts_a_turn_into_stretches_one_of_them_across_its_end():
    x = np.linspace(0, 2 * np.pi, 73)
    values = np.sin(x)
    values[20:30] = np.nan
    slope, bend = rates(values, x[1], True, SPLINE)
    known = np.isfinite(values)
    assert np.isnan(slope[20:30]).all()
    assert np.abs(slope - np.cos(x))[known].max() < 1e-3
    assert np.abs(bend + values)[known].max() < 2e-2
    assert np.isnan(rates(values, x[1], True, FOURIER)[0]).all()  # no sum goes through a gap


def test_angles_are_unwrapped_on_both_sides_of_a_gap():
    angle = np.linspace(3.0, 10.0, 20)
    turns = np.exp(1j * angle)
    assert unwrapped(turns) == pytest.approx(angle, abs=1e-12)
    turns[8] = np.nan
    found = unwrapped(turns)
    assert np.isnan(found[8])
    for part in (slice(0, 8), slice(9, 20)):
        assert np.diff(found[part]) == pytest.approx(np.diff(angle[part]), abs=1e-12)


# ---------------------------------------------------------------- mechanisms


def worst(cycle, key, count):
    """Relative errors of velocities and accelerations of all points."""
    exact = cycle.motion(cycle.once(count))
    found = KEYS[key].run(cycle, count)
    assert np.abs(found.places - exact.places).max() < 1e-12 * np.abs(exact.places).max()
    pairs = ((found.velocities, exact.velocities), (found.accelerations, exact.accelerations))
    return [np.abs(own - true).max() / np.abs(true).max() for own, true in pairs]


@pytest.mark.parametrize("name", sorted(SCHEMES))
def test_tables_of_every_dyad_come_to_the_motion_by_groups(name):
    cycle = Cycle(linkage(SCHEMES[name](), 1), 0.4)
    assert max(worst(cycle, "fourier", 100)) < 1e-6
    rough, fine = (np.array(worst(cycle, "differences", count)) for count in (360, 720))
    assert rough / fine == pytest.approx([4, 4], abs=0.3)
    assert worst(cycle, "spline", 720)[0] < 1e-5


@pytest.mark.parametrize("name", ["compressor", "quick_return", "press", "engine_four_stroke", "loom"])
def test_tables_of_ready_variants_come_to_their_motion(name):
    """Clockwise and counter-clockwise, cycles of one turn and of two, classes II to IV."""
    cycle = solved(name).lever.kinematics.cycle
    assert max(worst(cycle, "fourier", 144)) < 1e-9
    assert max(worst(cycle, "spline", 720)) < 1e-4


def test_a_swing_has_a_table_with_ends():
    cycle = solved("elliptic_trammel").lever.kinematics.cycle
    assert not cycle.closed
    rough, fine = (np.array(worst(cycle, "spline", count)) for count in (50, 100))
    assert (rough / fine > 3.5).all()
    assert "swings" in KEYS["fourier"].refuses(cycle).text


def test_a_mechanism_that_closes_over_part_of_a_turn_has_rates_there_alone():
    cycle = cycle_of(linkage(four_bar((2.6, 1, 1, 1, 1, 1)), 1))
    exact = cycle.motion(cycle.once(360))
    known = exact.closes
    assert 10 < known.sum() < 350
    inner = exact.sines["II2(2,3)"] > 0.4  # beside a limit rates grow without bound
    for key in ("differences", "spline"):
        found = KEYS[key].run(cycle, 360)
        assert (np.isnan(found.velocity("B")) == ~known).all()
        off = np.abs(found.velocity("B") - exact.velocity("B"))[inner]
        assert off.max() < 2e-3 * np.abs(exact.velocity("B"))[inner].max()
    assert "all round" in KEYS["fourier"].refuses(cycle).text


def test_cams_are_refused_in_words():
    cycle = solved("cam_press").lever.kinematics.cycle
    assert all("cam" in one.refuses(cycle).text for one in TABLES)


def test_many_variants_are_each_as_alone():
    k = [np.array([[1.0], [0.97], [1.05]]) * np.ones((3, 1)) for _ in range(6)]
    together = Cycle(linkage(four_bar(k), 1), 0.4)
    for one in TABLES:
        whole = one.run(together, 24)
        for v in range(3):
            single = Cycle(linkage(four_bar([float(x[v, 0]) for x in k]), 1), 0.4)
            alone = one.run(single, 24)
            assert whole.accelerations[:, v] == pytest.approx(alone.accelerations, rel=1e-12, abs=1e-10)


def test_what_is_asked_of_tables_in_courses_is_twelve_to_a_hundred():
    assert tables.COUNTS == (12, 36, 72, 100)
