"""The brake whose shoes swing on arms: vectors and moments about the pivot, what is chosen, what locks, mistakes."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report import course, loading
from tmm_report.chapters.machine.governor.draw.brake import brake
from tmm_report.figures.drawing import Circle
from tmm_report.mechanics.machine.governor.brake import Brake, Lever
from tmm_report.problems import ProblemError

LEVER = Lever(0.04, math.radians(100), math.radians(80), 0.03, True)
BRAKE = Brake(0.4, 0.045, 0.001, 0.07, 0.25, 4000.0, 60.0, 2, LEVER)
TEXT = (
    "language: en\ngovernor:\n  brake: {mass: 0.4 kg, radius: 45 mm, gap: 1 mm, drum: 70 mm, friction: 0.25, "
    "spring: {stiffness: 4 kN/m, force: 60 N}, moment: 2 N*m, inertia: 0.02 kg*m^2, "
    "arm: {pivot: 40 mm, shoe: 100 deg, mass_centre: 80 deg, spring: 30 mm, ahead: shoe}}\n"
)


def solved(*changes):
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return course.solve(loading.loads(text)).governor.brake


def pressed(brake: Brake, omega: float) -> float:
    """Normal force of one shoe, N, by vectors: the disc turns counter-clockwise, its pivot is at (a, 0); the shoe is
    before it, or behind."""
    lever, side = brake.lever, 1 if brake.lever.drawn_on else -1
    pivot = complex(lever.pivot)
    touch = brake.drum * np.exp(1j * side * lever.shoe)
    centre = brake.at_contact * np.exp(1j * side * lever.mass_centre)

    def about(at, force):
        return ((at - pivot).conjugate() * force).imag

    inertia = about(centre, brake.mass * omega**2 * centre)
    outward, along = touch / abs(touch), 1j * touch / abs(touch)
    normal, friction = about(touch, -outward), about(touch, -brake.friction * along)
    closing = -math.copysign(brake.spring * lever.spring, inertia)
    return -(inertia + closing) / (normal + friction)


@settings(max_examples=60)
@given(
    st.floats(0.2, 0.8),
    st.floats(0.2, 2.8),
    st.floats(0.2, 2.8),
    st.floats(0.05, 0.4),
    st.booleans(),
    st.floats(1.05, 4),
)
def test_moments_about_the_pivot_by_vectors(part, shoe, centre, friction, drawn_on, faster):
    lever = Lever(part * 0.07, shoe, centre, 0.03, drawn_on)
    brake = replace(BRAKE, lever=lever, friction=friction, gap=0.01 * lever.normal)
    if brake.locks:
        return
    omega = faster * brake.contact
    assert pressed(brake, brake.contact) == pytest.approx(0.0, abs=1e-9 * brake.spring)
    moment = 2 * friction * pressed(brake, omega) * brake.drum
    assert float(brake.moment(omega)) == pytest.approx(moment, rel=1e-9)
    assert moment > 0


def test_a_small_swing_moves_the_shoe_by_its_gap():
    """The arm turned by the angle: its shoe goes outwards by the gap, its mass centre as far as told."""
    pivot, tiny = complex(LEVER.pivot), replace(BRAKE, gap=1e-7)
    for angle, told, radius in (
        (LEVER.shoe, 1e-7, BRAKE.drum),
        (LEVER.mass_centre, tiny.at_contact - tiny.radius, BRAKE.radius),
    ):
        at = radius * np.exp(1j * angle)
        moved = pivot + (at - pivot) * np.exp(-1j * tiny.swing)
        assert abs(moved) - radius == pytest.approx(told, rel=1e-4)


def test_a_shoe_locks_where_its_normal_force_would_be_infinite():
    limit = LEVER.normal / LEVER.tangential(BRAKE.drum)
    assert not replace(BRAKE, friction=limit * (1 - 1e-9)).locks and replace(BRAKE, friction=limit).locks
    assert replace(BRAKE, friction=limit * (1 - 1e-9)).K > 1e7 * BRAKE.K
    assert not replace(BRAKE, friction=1.0).turned_back().locks


def test_the_sense_of_rotation_matters():
    on, off = solved(), solved(("ahead: shoe", "ahead: pivot"))
    assert on.s.number("held") < off.s.number("held")
    assert on.s.number("back") == pytest.approx(off.s.number("held"), rel=1e-12)
    assert off.s.number("back") == pytest.approx(on.s.number("held"), rel=1e-12)
    assert "back" not in solved(("friction: 0.25", "friction: 0.6"), ("ahead: shoe", "ahead: pivot")).s


def test_shoes_that_press_by_their_moment_hold_the_driving_moment():
    found = solved()
    pressing = found.s.number("pressing")
    assert 2 * 0.25 * pressing * 0.07 == pytest.approx(2.0, rel=1e-12)
    assert pressed(found.shoes, found.s.number("held")) == pytest.approx(pressing, rel=1e-9)


@pytest.mark.parametrize("arm", [True, False])
@pytest.mark.parametrize(("key", "stated"), [("mass", "mass: 0.4 kg, "), ("spring", ", force: 60 N")])
def test_what_is_chosen_for_the_speed_that_was_held_is_what_was_stated(key, stated, arm):
    start = TEXT.index(", arm: {")
    drop = () if arm else ((TEXT[start : TEXT.index("}", start) + 1], ""),)
    whole = solved(*drop)
    held = whole.s.number("held")
    found = solved(*drop, (stated, ""), ("moment: 2", f"choose: {{{key}: {held} rad/s}}, moment: 2"))
    for name in ("m", "F_0", "F", "contact", "K", "held", "pressing"):
        assert found.s.number(name) == pytest.approx(whole.s.number(name), rel=1e-9), name
    assert found.s.has_formula("m" if key == "mass" else "F_0")


@pytest.mark.parametrize(
    ("changes", "path", "words"),
    [
        ((("friction: 0.25", "friction: 0.6"),), "arm.ahead", "friction below 0.5119"),
        ((("pivot: 40 mm", "pivot: 80 mm"),), "arm.pivot", "is not within the drum"),
        ((("gap: 1 mm", "gap: 9 mm"),), "gap", "a gap of 7.8785 mm at most"),
        ((("mass: 0.4 kg, ", ""),), "mass", "the shoes have no mass"),
        ((("moment: 2", "choose: {mass: 600 rpm}, moment: 2"),), "choose.mass", "stated, too"),
        ((("moment: 2", "choose: {spring: 600 rpm}, moment: 2"),), "choose.spring", "stated, too"),
        ((("moment: 2", "choose: {}, moment: 2"),), "choose", "exactly one of: mass, spring"),
        (
            ((", force: 60 N", ""), ("moment: 2", "choose: {spring: 200 rpm}, moment: 2")),
            "choose.spring",
            "shoes of more than",
        ),
        (
            ((", force: 60 N", ""), ("4 kN/m", "90 kN/m"), ("moment: 2", "choose: {spring: 600 rpm}, moment: 2")),
            "spring.stiffness",
            "a stiffness below",
        ),
        ((("ahead: shoe", "ahead: left"),), "arm.ahead", "pivot, shoe"),
        ((("shoe: 100 deg", "shoe: 190 deg"),), "arm.shoe", "1 … 175 deg"),
    ],
)  # fmt: skip
def test_mistakes_are_told_at_their_places(changes, path, words):
    with pytest.raises(ProblemError) as told:
        solved(*changes)
    (problem,) = told.value.problems
    assert ".".join(map(str, problem.path)) == f"governor.brake.{path}"
    assert words in str(told.value)


def test_what_is_told_to_be_enough_is_enough():
    assert solved(("friction: 0.25", "friction: 0.5118")).s.number("held") > 0
    assert solved(("gap: 1 mm", "gap: 7.87 mm")).s.number("held") > 0


def test_the_scheme_has_the_pivots_where_they_are_stated():
    """The drawn disc turns counter-clockwise: a shoe that goes before its pivot has it clockwise of itself."""
    for ahead, side in (("shoe", -1), ("pivot", 1)):
        found = solved(("ahead: shoe", f"ahead: {ahead}"))
        circles = [one for one in brake(found).items if isinstance(one, Circle) and 0 < one.radius < 2]
        angles = sorted(float(np.angle(one.centre)) for one in circles)
        stated = side * math.radians(100)
        wanted = [float(np.angle(np.exp(1j * (stated + turn)))) for turn in (0, math.pi)]
        assert angles == pytest.approx(sorted(wanted))
