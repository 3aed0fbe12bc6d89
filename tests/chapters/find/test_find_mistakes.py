"""Mistakes of the block find: each one message with its key and its cure."""

import pytest

from tmm_report import loading, solve
from tmm_report.problems import ProblemError

TEXT = """language: en
dynamics:
  parts: [{name: disc, inertia: 2 kg*m^2}, {name: drum, ratio: 0.5, inertia: 4 kg*m^2, moment: 30 N*m}]
  motor: {constant: 100 N*m}
  start: {speed: 20}
"""
GOOD = "so_that: {dynamics_t_start: 2 s}"
M = "dynamics.motor.constant: 20 .. 200 N*m"
# what stands under `unknown`: its key, its range, what is said
UNKNOWN = {
    "no such block": ("flywheel.delta", "1 .. 2", "there is no flywheel in the file"),
    "no such key": ("dynamics.motr.constant", "1 .. 2", "did you mean motor"),
    "no such item": ("dynamics.parts.7.inertia", "1 .. 2", "numbered 0 … 1"),
    "no number": ("dynamics.motor", "1 .. 2", "go on to one of constant"),
    "a name": ("dynamics.parts.0.name", "1 .. 2", "is no number"),
    "beyond a number": ("dynamics.motor.constant.x", "1 .. 2", "a number has no parts"),
    "empty range": ("dynamics.motor.constant", "20 .. 20", "is empty"),
    "range backwards": ("dynamics.motor.constant", "200 .. 20", "goes backwards"),
    "no range": ("dynamics.motor.constant", "200", "is not a range"),
    "another unit": ("dynamics.motor.constant", "1 mm .. 2 mm", "moment of force"),
    "units of two kinds": ("dynamics.motor.constant", "1 mm .. 2 N*m", "does not measure"),
    "below what may stand there": ("dynamics.parts.0.inertia", "-1 .. 2", "-1"),
}
# the block, the key that is told, what is said
DOOR = {
    case: (f"{{unknown: {{{key}: {span}}}, {GOOD}}}", f"find.unknown.{key}", words)
    for case, (key, span, words) in UNKNOWN.items()
} | {
    "two unknowns": (f"{{unknown: {{{M}, dynamics.parts.0.inertia: 1 .. 2}}, {GOOD}}}", "find", "demands: 1"),
    "two demands": (f"{{unknown: {{{M}}}, so_that: {{dynamics_t_start: 2 s, dynamics_J: 2}}}}", "find", "demands: 2"),
    "two kinds of demand": (f"{{unknown: {{{M}}}, {GOOD}, least: dynamics_J}}", "find", "demands: 2"),
    "no demand": (f"{{unknown: {{{M}}}}}", "find", "nothing is demanded"),
    "no unknown": (f"{{{GOOD}}}", "find.unknown", ""),
    "no value": (f"{{unknown: {{{M}}}, so_that: {{dynamics_t_start: long}}}}", "find.so_that.dynamics_t_start", "long"),
    "a word of others": (f"{{unknown: {{{M}}}, minimize: dynamics_J}}", "find.minimize", "least"),
}  # fmt: skip
SOLVING = {
    "unknown result": ("so_that: {dynamics_t_stert: 2 s}", "find.so_that.dynamics_t_stert", "dynamics_t_start"),
    "not unique": ("so_that: {start: 2 s}", "find.so_that.start", "may be several numbers"),
    "unit of the demand": ("so_that: {dynamics_t_start: 2 m}", "find.so_that.dynamics_t_start", "does not measure"),
    "no such table": ("so_that: {dynamics_begin.t.max: 2 s}", "find.so_that.dynamics_begin.t.max", "no table"),
    "no such column": ("so_that: {dynamics_start.x.max: 2 s}", "find.so_that.dynamics_start.x.max", "no such column"),
    "a whole column": ("so_that: {dynamics_start.t: 2 s}", "find.so_that.dynamics_start.t", ".max"),
    "a column of words": ("so_that: {dynamics_works.acting.0: 2}", "find.so_that.dynamics_works.acting.0", "no number"),
    "what does not depend on it": ("so_that: {dynamics_J: 3}", "find.so_that.dynamics_J", "does not depend"),
    "best of what is not there": ("greatest: dynamics_x", "find.greatest", "results.json"),
}  # fmt: skip


def told(text):
    with pytest.raises(ProblemError) as caught:
        solve(loading.loads(text, "v.yaml"))
    return caught.value.problems


@pytest.mark.parametrize("case", DOOR)
def test_a_mistake_is_told_once_at_the_door(case):
    find, key, words = DOOR[case]
    with pytest.raises(ProblemError) as caught:
        loading.loads(f"{TEXT}find: {find}\n", "v.yaml")
    (problem,) = caught.value.problems
    assert problem.key == key and words in problem.text()
    assert problem.file == "v.yaml" and problem.line == 6


@pytest.mark.parametrize("case", SOLVING)
def test_a_mistake_in_the_demand_is_told_with_its_place(case):
    demand, key, words = SOLVING[case]
    (problem,) = told(f"{TEXT}find: {{unknown: {{{M}}}, {demand}}}\n")
    assert problem.key == key and words in problem.text()
    assert problem.line == 6 and problem.right is not None


def test_whole_numbers_are_not_sought():
    text = "language: en\nflywheel: {delta: 1/30, turns: 2, speed: 90 rpm, resisting: {mean: 10}, positions: 24}\n"
    find = "find: {unknown: {flywheel.positions: 24 .. 48}, least: J_fl}\n"
    with pytest.raises(ProblemError, match="whole number"):
        loading.loads(text + find)


def test_a_range_in_which_nothing_can_be_solved():
    text = (
        "language: en\ncontacts: [{kind: pivot, outer: 90 mm, inner: 80 mm, coefficient: 0.1, load: 4 kN}]\n"
    )
    find = "find: {unknown: {contacts.0.outer: 10 mm .. 20 mm}, so_that: {contacts_1.p_mean: 1 MPa}}\n"
    (problem,) = told(text + find)
    assert "with no value of the range" in problem.text()
