"""Mechanisms of unusual size, weight and speed that are right as they stand: nobody is asked whether they are meant."""

from __future__ import annotations

import pytest

from tmm_report import loading

SLIDER_CRANK = """
mechanism:
  frame: {{O: [0, 0]}}
  guides: {{x: {{through: O}}}}
  links:
    1: {{points: {{O: 0, A: {crank}}}}}
    2: {{points: {{A: 0, B: {rod}}}, mass: {light}, mass_centre: A, inertia: 0}}
    3: {{points: [B], slides: x, mass: {heavy}}}
  driver: {{link: 1, speed: {speed}, zero: {{point: B, extreme: right}}}}
  assembly: {{B: right}}
loads:
  forces: [{{name: F, at: B, direction: left, {load}}}]
"""
USUAL = {"crank": "0.1", "rod": "0.4", "light": "2", "heavy": "3", "speed": "10", "load": "constant: 100 N"}


def doubts(**stated):
    return [one.text() for one in loading.loads(SLIDER_CRANK.format(**USUAL | stated)).doubts]


@pytest.mark.parametrize(
    "stated",
    [
        {"crank": "1 mm", "rod": "3 mm", "light": "2e-6 kg", "heavy": "1e-6 kg", "speed": "60 rpm"},
        {"crank": "1 mm", "rod": "3 mm", "light": "0.02 g", "heavy": "0.01 g", "speed": "6"},
        {"crank": "3 m", "rod": "12 m", "light": "2 t", "heavy": "3 t", "speed": "0.5"},
        {"crank": "150 mm", "rod": "900 mm", "light": "300 kg", "heavy": "5 t", "speed": "60 rpm"},
        {"crank": "60 mm", "rod": "400 mm", "light": "40 kg", "heavy": "5 t", "speed": "60 rpm"},
        {"crank": "5 mm", "rod": "40 mm", "light": "20 g", "heavy": "10 g", "speed": "12000 rpm"},
        {"crank": "2 mm", "rod": "250 mm", "speed": "1450 rpm"},
        {"load": "piston_diameter: 100 mm, constant: 0.5 kPa"},
        {"load": "piston_diameter: 100 mm, constant: -300 Pa"},
        {"load": "piston_diameter: 100 mm, constant: 32 MPa"},
    ],
    ids=lambda stated: " ".join(stated.values()),
)
def test_what_is_unusual_and_right_is_not_asked_back(stated):
    assert doubts(**stated) == []


@pytest.mark.parametrize(
    ("stated", "meant"),
    [
        ({"load": "piston_diameter: 100 mm, constant: 0.5"}, "0.5 MPa?"),
        ({"heavy": "3000"}, "3000 g?"),
        ({"crank": "1 mm", "rod": "3 mm", "light": "2e-9", "heavy": "1e-6", "speed": "6"}, "2e-09 t?"),
    ],
)
def test_what_missed_its_unit_in_such_a_mechanism_still_is(stated, meant):
    (line,) = doubts(**stated)
    assert line.endswith(meant)
