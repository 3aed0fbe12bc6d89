"""The textbook's formulas beside the roots: each worked again by hand, and where it is exact the root is it."""

import math

import numpy as np
import pytest
from notes import render
from test_find import ACCELERATION, CASES, PIVOT, number_of, results_of, text_of

from tmm_report import course, loading, solve
from tmm_report.chapters.find.closed import Known, NotThereError
from tmm_report.chapters.find.target import Target
from tmm_report.problems import Message
from tmm_report.quantity.formula import Var
from tmm_report.quantity.model import Book, Quantity, Table
from tmm_report.quantity.symbols import Symbol
from tmm_report.results import values

HOIST = """language: en
dynamics:
  parts: [{name: drum, inertia: 40 kg*m^2, moment: %s N*m}, {name: rotor, on: motor, inertia: 0.2 kg*m^2}]
  motor: {constant: 60 N*m, ratio: 10, efficiency: %s}
  start: {speed: 10}
"""
WHEEL = """language: en
flywheel:
  %s
  speed: 90 rpm
  resisting: {table: [[0 deg, 100 N*m], [180 deg, 100 N*m], [180 deg, 900 N*m], [360 deg, 900 N*m]]}
  own: 2 kg*m^2
  %s
"""
W = math.pi * 400  # greatest excess work, J: the half of the turn at 400 N·m from the mean


def closed(text, find):
    found = results_of(text, find).find
    assert found.sound and found.closed is not None
    return found.size(found.chosen.at), found.closed.number


# unknown, demand, the answer by hand; what is exact in it
EXACT = {
    "flywheel for a wanted inertia": (
        WHEEL % ("delta: 1/30", "disc: {width: 0.2}"),
        "{unknown: {flywheel.delta: 0.005 .. 0.3}, so_that: {J_fl: 300}}",
        W / (302 * (3 * math.pi) ** 2),
    ),
    "flywheel for a disc": (
        WHEEL % ("delta: 1/30", "disc: {width: 0.2}\n  ratio: 3"),
        "{unknown: {flywheel.delta: 0.005 .. 0.3}, so_that: {flywheel_D: 600 mm}}",
        W / ((9 * math.pi * 7850 * 0.2 * 0.6**5 / 32 + 2) * (3 * math.pi) ** 2),
    ),
    "flywheel for a rim": (
        WHEEL % ("delta: 1/30", "rim: {height: 0.12, width: 1.4, spokes: 0.1}"),
        "{unknown: {flywheel.delta: 0.002 .. 0.3}, so_that: {flywheel_D: 900 mm}}",
        W
        / (
            (math.pi * 7850 * 1.4 * 0.12**2 * (1 + 0.12**2) * 0.9**5 / (4 * 0.9) + 2)
            * (3 * math.pi) ** 2
        ),
    ),
    "inertia of a flywheel for its unevenness": (
        WHEEL % ("wheel: {inertia: 100 kg*m^2}", ""),
        "{unknown: {flywheel.wheel.inertia: 10 .. 900}, so_that: {flywheel_delta: 0.05}}",
        W / (0.05 * (3 * math.pi) ** 2) - 2,
    ),
    "torque for an acceleration": (*CASES["torque for an acceleration"][:2], 3 * 10 + 15),
    "torque through a gear": (
        ACCELERATION.replace("{constant: 100 N*m}", "{constant: 100 N*m, ratio: 4, efficiency: 0.9}"),
        CASES["torque for an acceleration"][1].replace("20 .. 200", "2 .. 200"),
        (3 * 10 + 15) / (4 * 0.9),
    ),
    "best ratio of a hoist": (
        HOIST % (300, 0.9),
        "{unknown: {dynamics.motor.ratio: 6 .. 60}, greatest: dynamics_start.epsilon.0}",
        300 / 54 + math.sqrt((300 / 54) ** 2 + 40 / 0.2),
    ),
    "best ratio without a load": (
        HOIST % (0, 1),
        "{unknown: {dynamics.motor.ratio: 6 .. 60}, greatest: dynamics_start.epsilon.0}",
        math.sqrt(40 / 0.2),
    ),
    "outer radius of a pivot": (
        PIVOT,
        "{unknown: {contacts.step.outer: 20 mm .. 90 mm}, so_that: {contacts_1.p_mean: at most 8 MPa}}",
        math.sqrt(40e3 / (math.pi * 8e6) + 0.01**2),
    ),
    "inner radius of a pivot": (
        PIVOT,
        "{unknown: {contacts.step.inner: 1 mm .. 45 mm}, so_that: {contacts_1.p_mean: 8 MPa}}",
        math.sqrt(0.05**2 - 40e3 / (math.pi * 8e6)),
    ),
    "load of a pivot": (
        PIVOT,
        "{unknown: {contacts.step.load: 1 kN .. 90 kN}, so_that: {contacts_1.p_mean: 8 MPa}}",
        8e6 * math.pi * (0.05**2 - 0.01**2),
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", EXACT)
def test_formula_root_and_the_answer_by_hand_agree(case):
    text, find, right = EXACT[case]
    root, formula = closed(text, find)
    assert formula == pytest.approx(right, rel=1e-9)
    assert root == pytest.approx(right, rel=1e-5 if "greatest" in find else 1e-8)  # a peak is flat


def test_friction_for_an_insensitivity():
    """ω± = √((E ± F)/A) of the least E give (ω₊ − ω₋)/ω = ε: squared, F = E ε √(1 − ε²/4)."""
    name, find, _ = CASES["friction for an insensitivity"]
    root, formula = closed(text_of(name), find)
    results = results_of(text_of(name), find)
    (least,) = [number_of(results, "governor_equilibrium.E.min")]
    assert math.sqrt(least + formula) - math.sqrt(least - formula) == pytest.approx(0.02 * math.sqrt(least))
    assert root == pytest.approx(formula, rel=1e-9)


def test_a_formula_that_leaves_something_out_is_told_with_its_difference():
    """The press's moment of inertia varies: the textbook takes its mean."""
    results = solve(loading.load("variants/press_flywheel.yaml"))
    found = results.find
    assert found.closed.leaves and found.closed.number == pytest.approx(found.size(found.chosen.at), rel=0.1)
    numbers = {one.key: one.value for one in values(results)}
    x = numbers["find_x"]
    assert numbers["find_closed_off"] == pytest.approx(100 * (x - found.closed.number) / x)
    constant = numbers["flywheel_J_fl"] + numbers["flywheel_J_own"] + numbers["flywheel_J_mean"]
    right = numbers["flywheel_A_ex"] / (constant * numbers["flywheel_omega_m"] ** 2)
    assert found.closed.number == pytest.approx(right, rel=1e-6)


def test_no_formula_whose_numbers_depend_on_the_unknown():
    """The inner radius is sought of a pivot by the moment; and a motor's moment whose speed law is no constant."""
    find = "{unknown: {contacts.step.inner: 1 mm .. 45 mm}, so_that: {contacts_1.M_wear: 130 N*m}}"
    assert results_of(PIVOT, find).find.closed is None
    twice = HOIST.replace("{name: rotor, on: motor,", "{name: rotor, ratio: 10,") % (300, 1)
    find = "{unknown: {dynamics.motor.ratio: 6 .. 12}, greatest: dynamics_start.epsilon.0}"
    assert results_of(twice, find).find.closed is None


@pytest.mark.parametrize(
    ("part", "words"),
    [
        ("{name: rotor, on: motor, ratio: 3, inertia: 1}", "ratio of the motor"),
        ("{name: rotor, on: motor, inertia: 1, offset: 1 m, mass: 1}", "ratio of the motor"),
    ],
)
def test_a_part_on_the_motor_has_no_ratio_of_its_own(part, words):
    text = f"language: en\ndynamics: {{parts: [{part}], motor: {{constant: 5, ratio: 2}}}}\n"
    with pytest.raises(course.ProblemError, match=words):
        loading.loads(text)
    with pytest.raises(course.ProblemError, match="no motor"):
        loading.loads(text.replace(", motor: {constant: 5, ratio: 2}", "").replace(" ratio: 3,", ""))


def test_a_part_on_the_motor_turns_as_the_motor_does():
    one = number_of(solve(loading.loads(HOIST % (300, 1))), "dynamics_J")
    assert one == pytest.approx(40 + 0.2 * 10**2, rel=1e-12)


# --- letters


LETTERS = {
    "flywheel for a wanted inertia": "delta",
    "torque for an acceleration": "M_mot",
    "best ratio of a hoist": "i_dr",
    "outer radius of a pivot": "R",
    "load of a pivot": "Q",
}


@pytest.mark.parametrize("case", LETTERS)
def test_the_unknown_has_the_letter_of_its_own_number(case):
    results = results_of(*EXACT[case][:2])
    (found,) = [one for one in values(results) if one.key == "find_x"]
    assert str(found.quantity.symbol) == LETTERS[case]
    note = render(results, "html")["note.html"].decode()
    assert "has a formula" in note


def test_an_unknown_without_a_number_of_its_own_is_called_x():
    find = "{unknown: {dynamics.start.within: 1 % .. 9 %}, so_that: {dynamics_t_start: 1 s}}"
    text = ACCELERATION.replace("{constant: 100 N*m}", "{shunt: {moment: 40 N*m, speed: 20, no_load: 21}}")
    results = results_of(text.replace("start: {speed: 20}", "start: {within: 2 %}"), find)
    (found,) = [one for one in values(results) if one.key == "find_x"]
    assert str(found.quantity.symbol) == "x_seek"


# --- what a formula may take


def known(first, second):
    """Of a variant with one single number and one table of two rows, at two values of the unknown."""
    unit, meaning = Quantity("n", Symbol("n"), "N", Message("n")), Message("t")
    books = [
        Book.of([Table("t_1", meaning, (unit.column(np.array([3.0, of])),))], [unit.value(of)])
        for of in (first, second)
    ]
    return Known(Target("t", "t_1.y", unit, "1", meaning), (books[0], books[1]), Var("y", 1.0))


TAKEN = {
    "a single number": lambda k: k.of("n"),
    "one that may be missing": lambda k: k.any("n"),
    "beside the demanded one": lambda k: k.beside("n"),
    "the least": lambda k: k.least("t_1", "n"),
    "the last row": lambda k: k.row("t_1", "n", -1),
}


@pytest.mark.parametrize("case", TAKEN)
def test_a_formula_takes_no_number_that_depends_on_the_unknown(case):
    assert TAKEN[case](known(2.0, 2.0)).number == 2.0
    with pytest.raises(NotThereError):
        TAKEN[case](known(2.0, 2.001))
    with pytest.raises(NotThereError):
        known(2.0, 2.0).of("m")
    assert known(2.0, 2.0).any("m") is None and known(0.0, 0.0).any("n") is None
