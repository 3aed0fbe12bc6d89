"""Questions asked backwards: what is found, solved forwards, gives what was demanded; closed forms, where there are."""

import json
import math
from functools import cache

import numpy as np
import pytest
from conftest import path_of
from notes import render

from tmm_report import backwards, course, loading, solve
from tmm_report.chapters.find.solve import MOST
from tmm_report.results import tables, values
from tmm_report.stack import solve_many
from tmm_report.yamlread import loads as data_of

ACCELERATION = """language: en
dynamics:
  parts: [{name: disc, inertia: 2 kg*m^2}, {name: drum, ratio: 0.5, inertia: 4 kg*m^2, moment: 30 N*m}]
  motor: {constant: 100 N*m}
  start: {speed: 20}
"""
HOIST = """language: en
dynamics:
  parts: [{name: drum, inertia: 40 kg*m^2, moment: 300 N*m}, {name: rotor, ratio: 10, inertia: 0.2 kg*m^2}]
  motor: {constant: 60 N*m, ratio: 10}
  start: {speed: 10}
"""
PIVOT = """language: en
contacts:
  - {name: step, kind: pivot, outer: 50 mm, inner: 10 mm, coefficient: 0.12, load: 40 kN, speed: 30 rpm}
"""
RAILS = """language: en
engine:
  speed: 300 rpm
  crank_radius: 300 mm
  rod_length: 3 m
  reciprocating: 260 kg
  rotating: 180 kg
  inline: {cranks: [0, 90 deg], spacing: 0.6 m, bank: 90 deg}
  counterweights: {share: 0.5, radius: 800 mm}
"""


def read_text(name):
    return path_of(name).read_text("utf-8")


def asked(text, find):
    """A variant's text with the question."""
    return f"{text}\nfind: {find}\n"


@cache
def results_of(text, find):
    return solve(loading.loads(asked(text, find)))


def number_of(results, key):
    """A single number of the results, or of a table `name.column.pick`."""
    singles = {value.key: value.value for value in values(results)}
    if key in singles:
        return singles[key]
    name, column, *pick = key.split(".")
    numbers = next(table for table in tables(results) if table.name == name)[column].numbers()
    if pick and not pick[0].isdecimal():
        return {"max": np.nanmax, "min": np.nanmin}[pick[0]](numbers)
    return numbers[int(pick[0]) if pick else 0]


def forwards(text, found, key):
    """The demanded number of the variant that states what was found."""
    document = data_of(text)
    unknown = found.given.unknown
    return number_of(solve(loading.loads(json.dumps(unknown.put(document.data, found.number)))), key)


# what is asked of which variant, and the number that answers, if there is a closed form
CASES = {
    "torque for an acceleration": (
        ACCELERATION,
        "{unknown: {dynamics.motor.constant: 20 .. 200 N*m}, so_that: {dynamics_start.epsilon.0: 10 rad/s^2}}",
        3 * 10 + 15,
    ),
    "inertia for a time of the start": (
        ACCELERATION,
        "{unknown: {dynamics.parts.disc.inertia: 0.5 .. 20}, so_that: {dynamics_t_start: 2 s}}",
        85 * 2 / 20 - 1,
    ),
    "friction for an insensitivity": (
        "governor_porter",
        "{unknown: {governor.sleeve.friction: 0.1 N .. 20 N}, so_that: {governor_equilibrium.epsilon.max: 2 %}}",
        None,
    ),
    "stiffness for the speed at the upper stop": (
        "governor_spring",
        "{unknown: {governor.spring.stiffness: 20 kN/m .. 100 kN/m}, so_that: {omega_h: 1030 rpm}}",
        None,
    ),
    "radius of a pivot for a pressure": (
        PIVOT,
        "{unknown: {contacts.step.outer: 20 mm .. 90 mm}, so_that: {contacts_1.p_mean: at most 8 MPa}}",
        None,
    ),
    "share of the balanced mass": (
        RAILS,
        "{unknown: {engine.counterweights.share: 0 .. 1}, so_that: {engine_greatest.after.0: 60 kN}}",
        None,
    ),
    "flywheel for a rim": (
        "punch_press",
        "{unknown: {flywheel.delta: 0.01 .. 0.1}, so_that: {D: 0.8 m}, choose: last}",
        None,
    ),
    "inertia of a link for the greatest moment": (
        "slider_crank_offset",
        "{unknown: {mechanism.links.3.mass: 5 kg .. 100 kg}, so_that: {M_bal_max: 400 N*m}}",
        None,
    ),
}


def text_of(name):
    if name == "governor_spring":
        text = read_text("governor_servo").replace(
            "  choose: {spring: [970 rpm, 1030 rpm]}", "  spring: {stiffness: 60 kN/m, force: 2400 N}"
        )
        return text
    return name if "\n" in name else read_text(name)


@pytest.mark.parametrize("case", CASES)
def test_what_is_found_solved_forwards_gives_what_was_demanded(case):
    name, find, right = CASES[case]
    text = text_of(name)
    results = results_of(text, find)
    found = results.find
    assert found.sound and found.solved < 250
    key = found.target.key + (f".{found.target.pick}" if found.target.pick else "")
    assert forwards(text, found, key) == pytest.approx(found.level, rel=1e-9)
    assert number_of(results, key) == pytest.approx(found.level, rel=1e-9)
    if right is not None:
        assert found.size(found.chosen.at) == pytest.approx(right, rel=1e-9)


def test_a_pivot_by_its_closed_form():
    find = CASES["radius of a pivot for a pressure"][1]
    found = results_of(PIVOT, find).find
    right = math.sqrt(40e3 / (math.pi * 8e6) + 0.01**2)
    assert found.size(found.chosen.at) == pytest.approx(right, rel=1e-11)
    slope = -40e3 * 2 * right / (math.pi * (right**2 - 0.01**2) ** 2)
    assert found.slopes[0] == pytest.approx(slope, rel=1e-9)


def test_the_best_ratio_of_a_hoist():
    """ε = (u M − Q)/(J + J_m u²): greatest where u² M − 2 Q u − M J/J_m = 0, of a motor with its rotor at one ratio;
    here the rotor's inertia stands on the main shaft, and only the motor's ratio is free, so that the end is best."""
    find = "{unknown: {dynamics.motor.ratio: 6 .. 12}, greatest: dynamics_start.epsilon.0}"
    found = results_of(HOIST, find).find
    assert found.number == pytest.approx(12)
    find = "{unknown: {dynamics.parts.rotor.ratio: 2 .. 12}, least: dynamics_t_start}"
    found = results_of(HOIST, find).find
    assert found.number == pytest.approx(2)


def test_sensitivity_is_the_slope_of_a_closed_form():
    """Of the start: t = J ω/(M − Q)."""
    find = "{unknown: {dynamics.motor.constant: 20 .. 200 N*m}, so_that: {dynamics_t_start: 1 s}}"
    (slope,) = results_of(ACCELERATION, find).find.slopes
    moment = 3 * 20 + 15
    assert slope == pytest.approx(-3 * 20 / (moment - 15) ** 2, rel=1e-8)


def test_several_roots_and_which_is_chosen():
    """The force along the rails is the greatest of two over the turn, nearly alike for shares above and below 1/2."""
    find = CASES["share of the balanced mass"][1].removesuffix("}") + ", choose: %s}"
    first, last, second = (results_of(RAILS, find % which).find for which in ("first", "last", "2"))
    assert len(first.sought.roots) == 2 and first.number < 0.5 < last.number == second.number
    assert first.number + last.number == pytest.approx(1, abs=1e-2)
    assert first.slopes[0] < 0 < first.slopes[1]
    with pytest.raises(course.ProblemError, match="there is no root 9"):
        results_of(RAILS, find % 9)


def test_a_demand_that_cannot_be_met_says_how_near_it_comes():
    find = "{unknown: {contacts.step.outer: 20 mm .. 90 mm}, so_that: {contacts_1.p_mean: 1 MPa}}"
    results = results_of(PIVOT, find)
    found = results.find
    assert not found.sound and not course.sound(results)
    assert found.number == pytest.approx(90)
    assert found.chosen.value == pytest.approx(40e3 / (math.pi * (0.09**2 - 0.01**2)))
    note = render(results, "html")["note.html"].decode()
    assert "cannot be met" in note


def test_a_demand_met_all_over_the_range():
    find = "{unknown: {contacts.step.outer: 50 mm .. 90 mm}, so_that: {contacts_1.p_mean: at most 80 MPa}}"
    found = results_of(PIVOT, find).find
    assert found.sound and found.within and found.number == pytest.approx(50)


def test_values_that_cannot_be_solved_are_left_out_and_told():
    """An outer radius below the inner one."""
    find = "{unknown: {contacts.step.outer: 2 mm .. 90 mm}, so_that: {contacts_1.p_mean: 8 MPa}}"
    found = results_of(PIVOT, find).find
    assert found.sound and found.reason is not None
    ((low, high),) = found.sought.lost
    assert low == 0 and found.size(high) == pytest.approx(0.01, rel=1e-6)


def test_the_table_of_roots_is_of_the_results():
    """What is left is what the number is, less what is wanted; the first root is the one that is taken."""
    results = results_of(RAILS, CASES["share of the balanced mass"][1])
    table = next(one for one in tables(results) if one.name == "find_roots")
    assert table["y"].values - 60e3 == pytest.approx(table["residual"].values, abs=1e-12)
    assert list(table["number"].values) == [1, 2]
    numbers = {one.key: one.value for one in values(results)}
    assert numbers["find_x"] == table["x"].values[0] and numbers["find_count"] == 2


def test_many_at_once_find_what_each_finds_alone():
    name, find, _ = CASES["inertia of a link for the greatest moment"]
    texts = [asked(read_text(name), find.replace("400 N*m", f"{level} N*m")) for level in (350, 400)]
    together = solve_many([loading.loads(text) for text in texts])
    alone = [backwards.solve(loading.loads(text)) for text in texts]
    assert [one.find.number for one in together] == [one.find.number for one in alone]
    assert all(one.find.solved <= MOST for one in together)


@pytest.mark.parametrize("fmt", ["html", "tex", "json", "csv"])
@pytest.mark.parametrize("case", ["flywheel for a rim", "share of the balanced mass"])
def test_every_format_of_the_note(case, fmt):
    name, find, _ = CASES[case]
    files = render(results_of(text_of(name), find), fmt, "ru")
    assert all(files.values())
