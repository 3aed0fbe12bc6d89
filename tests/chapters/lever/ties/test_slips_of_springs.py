"""What may be said wrong of springs and dampers is told at its place, with what would be right, in both languages."""

from __future__ import annotations

import pytest

from tmm_report import loading
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError

TEXT = """language: en
mechanism:
  frame: {O: [0, 0], C: [350 mm, 0], K: [600 mm, 300 mm]}
  links:
    1: {points: {O: 0, A: 60 mm}}
    2: {points: {A: 0, B: 350 mm, S: 175 mm}, mass: 2 kg, mass_centre: S}
    3: {points: {C: 0, B: 200 mm, F: 300 mm}}
  driver: {link: 1, speed: 120 rpm}
  assembly: {B: left of A-C}
positions: {table: 12}
loads:
  springs:
    - {between: [F, K], stiffness: 2 kN/m, free_length: 200 mm}
  dampers:
    - {between: [S, K], viscosity: 300 N*s/m}
"""
SPRING, DAMPER = "loads.springs.0", "loads.dampers.0"
ENDS, FREE = "[F, K]", "free_length: 200 mm"
SLIPS = [  # right, wrong, where, what is said
    (ENDS, "[F, Q]", f"{SPRING}.between.1", "no link has the point Q"),
    (ENDS, "[F, F]", f"{SPRING}.between", "both ends are at the point F"),
    (ENDS, "[C, K]", f"{SPRING}.between", "are fixed"),
    (ENDS, "[F, B]", f"{SPRING}.between", "both on link 3: their distance never changes"),
    (ENDS, "[C, F]", f"{SPRING}.between", "both on link 3"),
    (ENDS, "[F]", f"{SPRING}.between", "a value of the list is missing"),
    ("2 kN/m", "-2 kN/m", f"{SPRING}.stiffness", "must be greater than zero"),
    ("2 kN/m", "0", f"{SPRING}.stiffness", "must be greater than zero"),
    ("2 kN/m", "2 kN", f"{SPRING}.stiffness", "is a force (kN); expected: a stiffness"),
    ("300 N*s/m", "-1", f"{DAMPER}.viscosity", "must be greater than zero"),
    ("300 N*s/m", "300 N/m", f"{DAMPER}.viscosity", "expected: a damping"),
    (FREE, "free_length: -1 mm", f"{SPRING}.free_length", "is negative"),
    (FREE, f"{FREE}, preload: 150 N", SPRING, "a free length or a preload, not both; either free_length"),
    (", " + FREE, "", SPRING, "needs its free length or a preload; either free_length"),
    (FREE, f"{FREE}, at_position: 3", SPRING, "say where a spring has its preload"),
    (FREE, "preload: 1 N, at_position: 3, at_length: 1 mm", SPRING, "one of them is enough"),
    (FREE, "preload: 1 N, at_position: 99", f"{SPRING}.at_position", "positions 0 to 12"),
    (FREE, f"{FREE}, on: {{B: 3}}", f"{SPRING}.on.B", "is none of the two"),
    (FREE, f"{FREE}, on: {{F: 2}}", f"{SPRING}.on.F", "the point F is not on link 2; known: 3"),
    (FREE, f"{FREE}, on: {{F: 8}}", f"{SPRING}.on.F", "there is no link 8"),
    (FREE, f"{FREE}, on: {{F: 0}}", f"{SPRING}.on.F", "the frame takes every force"),
    (FREE, "length: 200 mm", f"{SPRING}.length", "free_length, that under a preload at_length"),
    ("viscosity", "by_speed: 3, viscosity", f"{DAMPER}.by_speed", "are linear"),
    ("positions:", "dynamics: {}\npositions:", DAMPER, "which dynamics looks for"),
]  # fmt: skip


def problems(text: str):
    with pytest.raises(ProblemError) as caught:
        loading.loads(text)
    return {problem.key: problem for problem in caught.value.problems}


@pytest.mark.parametrize(("right", "wrong", "key", "words"), SLIPS)
def test_a_slip_is_told_at_its_place_in_both_languages(right, wrong, key, words):
    assert TEXT.count(right) == 1
    told = problems(TEXT.replace(right, wrong))
    assert words in told[key].text()
    line = TEXT[: TEXT.index(right)].count("\n") + 1
    assert told[key].line == line if right != "positions:" else 17
    assert told[key].text(Translator("ru").gettext) != told[key].text()


def test_the_text_itself_is_right():
    given = loading.loads(TEXT).lever.loads
    assert [(force.at, force.of) for force in given.forces] == [("F", "c1"), ("S", "b1")]
