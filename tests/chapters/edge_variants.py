"""A pump and a rocker without loads, to be written on; what is found of a text, and what is said of one refused."""

from __future__ import annotations

from functools import cache

import pytest

from tmm_report import course, loading, solve
from tmm_report.problems import ProblemError

PUMP = """
language: en
mechanism:
  frame: {O: [0, 0], C: [380 mm, -120 mm], Q: [0, 140 mm]}
  guides: {x: {through: Q}}
  links:
    1: {points: {O: 0, A: 100 mm, S1: 50 mm}}
    2: {points: {A: 0, B: 400 mm, S2: 200 mm}, mass: 4 kg, mass_centre: S2, inertia: 0.0533 kg*m^2}
    3: {points: {C: 0, B: 280 mm}}
    4: {points: {B: 0, D: 350 mm}}
    5: {points: [D], slides: x, mass: 12 kg}
  driver: {link: 1, speed: 90 rpm, zero: {point: D, extreme: right}}
  assembly: {B: left of A-C, D: right}
"""
ROCKER = """
language: en
mechanism:
  frame: {O: [0, 0], C: [0.3, 0]}
  links:
    1: {points: {O: 0, A: 0.1}}
    2: {points: {A: 0, B: 0.3}}
    3: {points: {C: 0, B: 0.2, T: 0.3}, mass: 1 kg, mass_centre: T}
  driver: {link: 1, speed: 10 rad/s, zero: {angle: 1.0}}
  assembly: {B: left of A-C}
"""


@cache
def found(text: str) -> course.Results:
    return solve(loading.loads(text, "v"))


def refused(text: str) -> str:
    with pytest.raises(ProblemError) as error:
        loading.loads(text, "v")
    return "\n".join(problem.text() for problem in error.value.problems)


def forces(text: str):
    return found(text).lever.kinetostatics.table
