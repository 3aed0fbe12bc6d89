"""Diagrams against millimetres of a stroke and degrees of a swing: the same as against its parts."""

import math

import pytest

from tmm_report import course, loading
from tmm_report.problems import ProblemError

TEXT = """
language: en
mechanism:
  frame: {O: [0, 0], C: [300 mm, -40 mm]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 60 mm}}
    2: {points: {A: 0, B: 240 mm}, mass: 2 kg, inertia: m*l^2/12}
    3: {points: [B], mass: 5 kg, slides: x}
    4: {points: {A: 0, D: 260 mm}, mass: 2 kg, inertia: m*l^2/12}
    5: {points: {C: 0, D: 150 mm}, mass: 2 kg, inertia: m*l^2/12}
  driver: {link: 1, speed: 100 rpm, zero: {point: B, extreme: left}}
  assembly: {B: right, D: left of A-C}
loads:
  gravity: 0
CURVES
  forces: [{at: B, direction: left, FORCE}]
  moments: [{on: 5, direction: against motion, MOMENT}]
"""
NO = "constant: 0"
FORCE = "by_displacement: {zero: left, forward: FORWARD, back: BACK}"
MOMENT = "by_displacement: {zero: clockwise, forward: FORWARD, back: [[0, 0], [1, 0]]}"


def loaded(force=NO, moment=NO, curves="  curves: {}"):
    text = TEXT.replace("FORCE", force).replace("MOMENT", moment).replace("CURVES", curves)
    return course.solve(loading.loads(text)).lever


def told(*of, **other):
    with pytest.raises(ProblemError) as caught:
        loaded(*of, **other)
    return [f"{problem.key}: {problem.text()}" for problem in caught.value.problems]


def drawn(text, forward, back=""):
    return text.replace("FORWARD", forward).replace("BACK", back)


def test_a_force_by_the_way_of_its_slider():
    """The stroke of a slider-crank in line is twice its crank: 120 mm."""
    lengths = (
        "[[0, 0], [40 mm, 2 kN], [9 cm, 2.5 kN], [0.12 m, 1 kN]]",
        "[[120 mm, 100 N], [30 mm, 0], [0, 0]]",
    )
    parts = f"[[0, 0], [{1 / 3!r}, 2 kN], [0.75, 2.5 kN], [1, 1 kN]]", "[[0, 0], [0.25, 0], [1, 100 N]]"
    found, plain = (loaded(drawn(FORCE, *one)).kinetostatics for one in (lengths, parts))
    assert found.table.balancing == pytest.approx(plain.table.balancing, rel=1e-9, abs=1e-9)
    assert abs(plain.table.balancing).max() > 50


def test_a_moment_by_the_angle_of_its_rocker():
    """The swing between the positions in which crank and rod lie in one line."""
    far = math.hypot(0.3, 0.04)
    ends = [math.acos((0.15**2 + far**2 - r**2) / (2 * 0.15 * far)) for r in (0.2, 0.32)]
    swing = math.degrees(ends[1] - ends[0])
    degrees = f"[[0, 5 N*m], [20 deg, 25 N*m], [{swing!r} deg, 30 N*m]]"
    found = loaded(moment=drawn(MOMENT, degrees)).kinetostatics
    plain = loaded(moment=drawn(MOMENT, f"[[0, 5 N*m], [{20 / swing!r}, 25 N*m], [1, 30 N*m]]")).kinetostatics
    assert found.table.balancing == pytest.approx(plain.table.balancing, rel=1e-9, abs=1e-9)
    assert abs(plain.table.balancing).max() > 5


def test_one_curve_for_all_in_lengths():
    curves = "  curves: {p: {forward: [[0, 0], [60 mm, 1], [120 mm, 0.4]], back: [[0, 0], [1, 0]]}}"
    found = loaded("by_displacement: {zero: left, curve: p, of: 2 kN}", curves=curves).kinetostatics
    plain = loaded(drawn(FORCE, "[[0, 0], [0.5, 2 kN], [1, 0.8 kN]]", "[[0, 0], [1, 0]]")).kinetostatics
    assert found.table.balancing == pytest.approx(plain.table.balancing, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(
    ("forward", "cure"),
    [
        (
            "[[0, 1 kN], [150 mm, 1 kN]]",
            "goes to 150 mm, the stroke is 120 mm; state it to the end of the stroke",
        ),
        ("[[0, 1 kN], [20 mm, 3 kN], [40 mm, 1 kN]]", "nothing is stated from"),
        ("[[0, 1 kN], [0.4, 3 kN], [120 mm, 1 kN]]", "all of them as parts, 0 … 1, or all with a unit"),
        ("[[0, 1 kN], [40 deg, 3 kN]]", "40 deg is an angle"),
        ("[[-3 mm, 1 kN], [40 mm, 3 kN]]", "-3 mm is a length"),
    ],
)
def test_what_cannot_be_is_told(forward, cure):
    (line,) = told(drawn(FORCE, forward, "[[0, 0], [1, 0]]"))
    assert line.startswith("loads.forces.0.by_displacement.forward")
    assert cure in line


def test_a_point_that_does_not_move_that_way_has_no_stroke():
    (line,) = told(drawn(FORCE.replace("left", "up"), "[[0, 0], [90 mm, 1 kN]]", "[[0, 0], [1, 0]]"))
    assert line.startswith("loads.forces.0.by_displacement.zero") and "does not move that way" in line


def test_a_bare_number_is_a_part():
    (line,) = told(drawn(FORCE, "[[0, 0], [2, 1 kN]]", "[[0, 0], [1, 0]]"))
    assert "2 is out of range: a plain number from 0 … 1" in line


def test_a_rounded_end_is_the_end():
    """A printed stroke is rounded: 119.5 mm of 120 mm, and 120.9 mm."""
    for end in ("119.5 mm", "120.9 mm"):
        found = loaded(drawn(FORCE, f"[[0, 1 kN], [{end}, 1 kN]]", "[[0, 0], [1, 0]]")).kinetostatics
        plain = loaded(drawn(FORCE, "[[0, 1 kN], [1, 1 kN]]", "[[0, 0], [1, 0]]")).kinetostatics
        assert found.table.balancing == pytest.approx(plain.table.balancing, rel=1e-9, abs=1e-9)


def test_a_mechanism_that_is_not_assembled_yet_may_be_looked_at():
    """Its ways of assembly are asked for before the stroke is known."""
    text = TEXT.replace("FORCE", drawn(FORCE, "[[0, 0], [120 mm, 1 kN]]", "[[0, 0], [1, 0]]"))
    text = text.replace("MOMENT", NO).replace("CURVES", "  curves: {}").replace("B: right, ", "")
    variant = loading.loads(text)
    with pytest.raises(ProblemError, match="can be assembled in two ways"):
        course.solve(variant)
