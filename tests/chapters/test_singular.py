"""Singular positions: nothing made of rounding errors passes for a velocity, a reaction or a moment."""

from __future__ import annotations

import json

import numpy as np
import pytest

from tmm_report import render, solve
from tmm_report.problems import ProblemError
from tmm_report.variant import loads

PARALLELOGRAM = """\
language: en
mechanism:
  frame: {O: [0, 0], C: [300 mm, 0]}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 300 mm}, mass: 2 kg, mass_centre: B, inertia: 0.01}
    3: {points: {C: 0, B: 100 mm}}
  driver: {link: 1, period: 1 s, rotation: clockwise}
  sketch: {A: [0, 100 mm], B: [300 mm, 100 mm]}
loads:
  moments: [{on: 3, direction: against motion, constant: 5}]
friction: {pivots: {coefficient: 0.1, diameter: 20 mm}}
positions: {plans: [0, 2], force_plan: [2, 6]}
"""


@pytest.fixture(scope="module")
def parallelogram():
    return solve(loads(PARALLELOGRAM))


def test_singular_positions_are_named_and_left_out(parallelogram):
    assert parallelogram.kinematics.singular == (0, 6, 12)
    assert parallelogram.plans.singular == (0,) and parallelogram.force_plans.singular == (6,)
    for values in parallelogram.kinematics.values.values():
        regular = np.delete(values, [0, 6, 12])
        assert np.isfinite(regular).all()
    driven = [
        values for key, values in parallelogram.kinematics.values.items() if key in ("v_B", "w_3", "a_BA_t")
    ]
    assert all(np.isnan(values[[0, 6, 12]]).all() for values in driven)


def test_no_huge_number_anywhere(parallelogram):
    assert parallelogram.kinetostatics.agrees
    document = json.loads(render(parallelogram, "json")["results.json"])
    numbers = [
        x
        for t in document["tables"].values()
        for c in t["columns"]
        for x in c["values"]
        if isinstance(x, float)
    ]
    assert len(numbers) > 1000 and max(map(abs, numbers)) < 1e5
    balancing = document["tables"]["balancing_table"]["columns"]
    assert balancing[2]["key"] == "M_bal" and balancing[2]["values"][6] is None


def test_the_note_says_so(parallelogram):
    text = render(parallelogram, "html")["note.html"].decode()
    assert "At positions 0, 6, 12 a group is in a singular position" in text


@pytest.mark.parametrize("ratio, digits", [(0.5, 15), (0.999, 14), (1 - 1e-9, 11)])
def test_digits_that_remain_near_a_dead_point(ratio, digits):
    """Rod and crank all but equal: the rod stands across the guide when the crank does."""
    text = f"""\
mechanism:
  frame: {{O: [0, 0]}}
  guides: {{x: {{through: O}}}}
  links:
    1: {{points: {{O: 0, A: {ratio!r}}}}}
    2: {{points: {{A: 0, B: 1}}}}
    3: {{points: [B], slides: x}}
  driver: {{link: 1, speed: 10, rotation: counter-clockwise}}
  assembly: {{B: right}}
"""
    found = solve(loads(text)).kinematics
    assert found.digits == digits and found.singular == ()
    expected = (
        -10
        * ratio
        * (
            np.sin(found.turned)
            + ratio * np.sin(2 * found.turned) / 2 / np.sqrt(1 - (ratio * np.sin(found.turned)) ** 2)
        )
    )
    error = np.abs(found.values["v_B"].real - expected) / np.abs(expected).max()
    assert error.max() < 10.0 ** (1 - digits)


def test_parallel_guides_do_not_meet():
    """A tangent mechanism at a right angle: the slot never crosses the guide, and that is said."""
    text = """\
mechanism:
  frame: {O: [0, 0], Q: [400 mm, 0]}
  guides: {slot: {through: O, link: 1}, y: {through: Q, angle: 90 deg}}
  links:
    1: {points: {O: 0}}
    2: {points: [A], slides: slot}
    3: {points: [A], slides: y}
  driver: {link: 1, speed: 1, rotation: counter-clockwise, zero: {angle: 30 deg}, range: 120 deg}
"""
    with pytest.raises(
        ProblemError, match=r"II2\(2,3\) cannot be assembled at 1 of 13 positions, e.g. at 60.0°"
    ):
        solve(loads(text))
