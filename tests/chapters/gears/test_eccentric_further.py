"""Eccentric mechanism: sets near the ratio by brute force, paths by Willis another way, masses of the satellites."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import render

from tmm_report import course, loading
from tmm_report.chapters.gears.eccentric.given import Point
from tmm_report.chapters.gears.eccentric.paths import traced
from tmm_report.chapters.gears.eccentric.solve import mechanism as eccentric
from tmm_report.chapters.gears.eccentric.solve import near_ratio as near
from tmm_report.chapters.gears.eccentric.steps import steps
from tmm_report.mechanics.gears.pair_sizes import least_teeth
from tmm_report.mechanics.gears.trains import Member, Mesh, Train, speeds
from tmm_report.problems import ProblemError

BASE = {"module": 0.002, "ratio": Fraction(4), "eccentricity": 0.018, "t": 10}


def stated(**changes):
    return eccentric.Given(**{**BASE, **changes})


# --- sets near the ratio


@pytest.mark.parametrize("u, E, tolerance", [("4", 18, 0.02), ("7/2", 7, 0.03), ("5", 11, 0.005)])
def test_sets_near_the_ratio_are_all_there_are(u, E, tolerance):
    found = near.near_sets(stated(), Fraction(u), E, tolerance)
    u, least = float(Fraction(u)), least_teeth(stated().rack)
    wanted = {
        (sun, (ring - sun + E) // 2, ring)
        for ring in range(least, found.ring + 1)
        for sun in range(least, ring)
        if abs(ring / sun - u) <= tolerance * u * (1 + 1e-9)
        and (ring - sun + E) % 2 == 0
        and (ring - sun - E) // 2 >= 6
    }
    family = found.judged.family
    listed = zip(
        family.sun.tolist(), family.satellites[:, 0].astype(int).tolist(), family.ring.tolist(), strict=True
    )
    assert set(listed) == wanted and len(found.ratio) == len(wanted)


def test_each_set_has_its_deviation_and_the_best_stand_first():
    found = near.near_sets(stated(), Fraction(4), 18, 0.02)
    family, held = found.judged.family, found.judged.held
    assert (
        found.deviation == pytest.approx(family.ring / family.sun / 4 - 1)
        and np.abs(found.deviation).max() <= 0.02 + 1e-12
    )
    order = list(zip(-held, family.ring, np.abs(found.deviation), strict=True))
    assert order == sorted(order)
    assert {(34, 136), (26, 104)} <= set(zip(family.sun.tolist(), family.ring.tolist(), strict=True))


@pytest.fixture(scope="module")
def found():
    return eccentric.solve(stated(tolerance=0.01, width=0.03, density=7800.0))


@pytest.mark.exhaustive
def test_the_sets_of_the_family_are_judged_alike_in_both_lists(found):
    listed = {
        int(sun): held
        for sun, held, off in zip(
            found.nearby.judged.family.sun, found.nearby.judged.held, found.nearby.deviation, strict=True
        )
        if off == 0
    }
    family = dict(zip(found.judged.family.sun.tolist(), found.judged.held.tolist(), strict=True))
    assert listed == family


def test_a_wide_search_is_bounded_to_the_smallest_rings():
    found = near.near_sets(stated(ring_up_to=2000), Fraction(6, 5), 18, 0.1)
    assert len(found.ratio) == near.MOST and found.ring < 2000


@pytest.mark.exhaustive
def test_teeth_within_the_tolerance_of_the_stated_ratio_are_taken():
    """27, 49 and 107 teeth: 3.963 in the place of 4."""
    near_by = {"t": None, "eccentricity": None, "teeth": (27, 49, 107)}
    found = eccentric.solve(stated(tolerance=0.01, **near_by))
    assert (found.sun, found.largest, found.ring) == (27, 49, 107) and found.e == pytest.approx(0.018)
    with pytest.raises(ProblemError):
        eccentric.solve(stated(tolerance=0.005, **near_by))


# --- paths


def by_willis(wheel, theta, sun=34, ring=136, e=0.018):
    """Place and turn of the wheel's axis from that which stands still, of a train solved as any other."""
    members = (
        Member("1", "wheel", sun, 0.034), Member("3", "ring", ring, 0.136),
        Member("5", "satellite", 42, 0.042, carried_by="H"), Member("H", "carrier"),
    )  # fmt: skip
    train = Train(members, (Mesh("1", "5", "H"), Mesh("5", "3", "H", internal=True)))
    own, still = ("3", "1") if wheel == "ring" else ("1", "3")
    speed = speeds(train, {still: 0.0, "H": 1.0})
    axis = e if wheel == "ring" else -e
    return axis * np.exp(1j * theta), float(speed[own]) * theta


@settings(max_examples=20, deadline=None)
@given(st.sampled_from(["sun", "ring"]), st.floats(0.001, 0.2), st.floats(-7, 7), st.floats(0, 6.3))
def test_a_path_is_that_of_a_wheel_turned_by_willis(wheel, radius, angle, theta):
    path = traced("A", Point(radius, angle, wheel=wheel), 34, 136, 0.018)
    axis, turn = by_willis(wheel, theta)
    assert path.at(np.array(theta)) == pytest.approx(axis + radius * np.exp(1j * (turn + angle)), abs=1e-12)


def test_a_path_is_rolled_by_the_satellite_that_both_wheels_share():
    """The pitch point of the ring with the largest satellite moves as the satellite does there: no slip."""
    sun, ring, e, z, m = 34, 136, 0.018, 60, 0.002
    h = 1e-6
    contact = e + m * ring / 2  # of the ring and the largest satellite, from O1
    path = traced("A", Point(contact - e), sun, ring, e)
    of_ring = (path.at(np.array(h)) - path.at(np.array(-h))) / (2 * h)
    centre, spin = m * (sun + z) / 2, 1 + sun / z  # the satellite rolls round the sun, which stands still
    of_satellite = 1j * centre + spin * 1j * (contact - centre)
    assert of_ring == pytest.approx(of_satellite, abs=1e-9)


@pytest.mark.parametrize("wheel, turns", [("ring", 4), ("sun", 1)])
def test_a_path_closes_after_whole_turns_and_not_before(wheel, turns):
    path = traced("A", Point(0.05, 1.0, wheel=wheel), 34, 136, 0.018)
    start = complex(path.at(np.array(0.0)))
    ends = [abs(complex(path.at(np.array(2 * math.pi * n))) - start) for n in range(1, turns + 1)]
    assert path.turns == turns and ends[-1] < 1e-12 and all(gap > 1e-4 for gap in ends[:-1])


# --- masses


@pytest.mark.exhaustive
def test_the_smallest_satellite_saves_its_share_of_the_largest(found):
    """A disc of 120 mm, 30 mm wide, of steel: 2.646 kg; of 84 mm: 0.49 of it."""
    largest, middle, smallest, _ = found.masses.each[found.row]
    assert largest == pytest.approx(math.pi * 0.06**2 * 0.03 * 7800)
    assert smallest / largest == pytest.approx((42 / 60) ** 2) and middle / largest == pytest.approx(
        (51 / 60) ** 2
    )
    assert found.masses.saving[found.row] == pytest.approx(largest - smallest)
    assert found.masses.held[found.row] == pytest.approx(largest + 2 * middle + smallest)


def test_a_middle_satellite_of_half_a_tooth_has_no_mass():
    found = eccentric.solve(stated(eccentricity=0.017, width=0.03, density=7800.0))
    assert np.isnan(found.masses.each[:, 1]).all() and np.isfinite(found.masses.held).all()


def test_satellites_of_half_a_tooth_save_nothing():
    """The set holds the middle ones alone: nothing is said of the masses of the largest and the smallest."""
    text = "language: en\neccentric: {ratio: 53/27, eccentricity: 3 mm, module: 2 mm, satellites: [middle], "
    results = course.solve(loading.loads(text + "width: 20 mm, density: 7800 kg/m^3}"))
    made = steps(results.eccentric)
    assert made.masses.computed() == ["m4"] and "saved_share" not in made.s
    page = render(results, "html")["note.html"].decode()
    assert "hold" in page and "saves" not in page


# --- what is refused

TEXT = "eccentric: {{ratio: 4, eccentricity: 18 mm, module: 2 mm, {}}}"


@pytest.mark.parametrize(
    "more, key",
    [
        ("width: 30 mm", "eccentric"),
        ("density: 7800 kg/m^3", "eccentric"),
        ("tolerance: 50 %", "tolerance"),
        ("points: {A: {wheel: moon, radius: 5 mm}}", "wheel"),
        ("points: {A: {wheel: sun}}", "radius"),
    ],
)
def test_what_cannot_be_is_refused_in_its_place(more, key):
    with pytest.raises(ProblemError) as error:
        loading.loads(TEXT.format(more))
    (problem,) = error.value.problems
    assert problem.path[-1] == key and (problem.right or "out of range" in str(problem.wrong))
