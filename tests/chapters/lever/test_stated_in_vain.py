"""Whatever is stated and has no effect is told, with what would give it one."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import LEVERS
from edge_variants import PUMP, ROCKER, found, refused
from notes import render

from tmm_report import course, loading
from tmm_report.problems import ProblemError


def doubted(text: str) -> dict[str, str]:
    """What is doubted, by the keys."""
    return {problem.key: problem.sentence(str) for problem in course.doubts(found(text))}


def at(point: str, law: str, more: str = "") -> str:
    return f"loads:\n  forces:\n    - {{at: {point}, direction: left, {law}{more}}}\n"


RANGE = ROCKER.replace("rad/s,", "rad/s, range: 60 deg,")


HEAVY = PUMP + "friction: {pivots: {coefficient: 0.1, diameter: 20 mm}}\n"
VAIN = "it needs the reactions, and there is no block loads"


@pytest.mark.exhaustive
def test_masses_and_friction_without_loads_are_told_how_to_be_asked_for():
    said = doubted(HEAVY)
    assert "no force analysis is made; loads: {gravity: 9.81 m/s^2}" in said["mechanism.links.2.mass"]
    assert VAIN in said["friction"]
    note = render(found(HEAVY), "html")["note.html"].decode()
    assert "no force analysis is made" in note and VAIN in note
    assert doubted(HEAVY + "loads: {gravity: 9.81 m/s^2}\n") == {}


@pytest.mark.parametrize(
    ("text", "key"),
    (
        (PUMP + "positions: {force_plan: 3}", "positions.force_plan"),
        (PUMP + "drawing: {scales: {force: 20}}", "drawing.scales.force"),
        (PUMP + "drawing: {force: 100 mm}", "drawing.force"),
        (
            PUMP.replace("90 rpm,", "90 rpm, gear: {radius: 60 mm, at: -90 deg},"),
            "mechanism.driver.gear",
        ),
        (PUMP.replace("{x: {through: Q}}", "{x: {through: Q}, y: {through: O}}"), "mechanism.guides.y"),
        (PUMP.replace("S1: 50 mm}}", "S1: 50 mm}, mass_centre: S1}"), "mechanism.links.1.mass_centre"),
        (PUMP + "loads: {}\ndrawing: {scales: {force: {1-9: 20}}}", "drawing.scales.force.1-9"),
        (
            PUMP + "loads: {forces: [{at: C, direction: along motion, constant: 1 N}]}",
            "loads.forces.0.direction",
        ),
        (
            PUMP + "loads: {moments: [{on: 5, direction: against motion, constant: 1 N*m}]}",
            "loads.moments.0.direction",
        ),
        (
            RANGE + at("T", "by_angle: [[0, 1 N], [70 deg, 2 N], [90 deg, 3 N]]"),
            "loads.forces.0.by_angle.2.0",
        ),
        (ROCKER + "loads: {}\nfriction: {guides: {coefficient: 0.1}}", "friction.guides"),
        (PUMP + "loads: {}\nfriction: {}", "friction"),
    ),
    ids=lambda part: part if "\n" not in part else "",
)
def test_what_has_no_effect_is_doubted(text, key):
    assert key in doubted(text)


def test_a_line_to_an_angle_beyond_the_range_has_an_effect():
    stated = RANGE.replace("mass_centre: T", "mass_centre: T, inertia: 0")
    assert doubted(stated + at("T", "by_angle: [[0, 1 N], [70 deg, 2 N]]")) == {}


@pytest.mark.exhaustive
def test_where_nothing_acts_the_note_says_so_and_prints_no_quotient_of_nothing():
    text = PUMP.replace(", mass: 4 kg, mass_centre: S2, inertia: 0.0533 kg*m^2", "").replace(
        ", mass: 12 kg", ""
    )
    text += "loads: {}\nfriction: {pivots: {coefficient: 0.1, diameter: 20 mm}}"
    assert "nothing acts on the mechanism" in doubted(text)["loads"]
    with np.errstate(all="raise"):
        note = render(found(text), "html")["note.html"].decode()
    assert "there is no efficiency" in note


def test_a_point_of_one_link_alone_is_no_joint_with_friction():
    joints = "loads: {}\nfriction: {joints: {%s: {coefficient: 0.1, diameter: 20 mm}}}"
    assert "S2 is no pivot: it is a point of link 2 alone" in refused(PUMP + joints % "S2")
    assert "Q is no pivot: it is a point of the frame alone" in refused(PUMP + joints % "Q")
    assert found(PUMP + joints % "B").lever.friction is not None


def test_no_ready_variant_states_something_in_vain():
    told = [problem.text() for path in LEVERS for problem in loading.load(path).doubts]
    assert [line for line in told if "effect" in line or "loads" in line or "no mass" in line] == []


def test_a_sketch_that_nothing_asks_and_a_group_stated_twice():
    both = PUMP + "  sketch: {B: [400 mm, 100 mm], A: [100 mm, 0]}\n"
    assert "the sketch has no effect" in doubted(both)["mechanism.sketch"]
    assert doubted(both.replace("B: left of A-C, ", "")).keys() == {"mechanism.links.2.mass"}
    with pytest.raises(ProblemError, match=r"II2\(2,3\) is stated twice: by B and by 2-3"):
        found(PUMP.replace("D: right}", "D: right, 2-3: '+'}"))


def test_a_point_at_the_pivot_of_the_driving_link_says_nothing_of_a_sketch():
    sketched = PUMP.replace("  assembly: {B: left of A-C, D: right}\n", "").replace(
        "A: 100 mm", "P0: 0, A: 100 mm"
    )
    sketched += "  sketch: {P0: [0, 0], A: [100 mm, 0], B: [400 mm, 150 mm], D: [700 mm, 140 mm]}\n"
    plain = sketched.replace("P0: [0, 0], ", "")
    place = [found(text).lever.kinematics.table.place("D") for text in (sketched, plain)]
    assert place[0] == pytest.approx(place[1])


GEARS = """
language: en
drive:
  speed: 1000 rpm
  stages:
    - {kind: spur, ratio: -2, module: 4 mm, teeth: [17, 34]}
"""


@pytest.mark.parametrize(
    "block", ("positions: {table: 12}", "allow_partial: true", "drawing: {accuracy: 0.1 mm}")
)
def test_blocks_of_a_mechanism_that_there_is_not(block):
    key = block.split(":")[0]
    variant = loading.loads(GEARS + block, "v")
    assert [problem.key for problem in variant.doubts] == [key]


def test_a_machine_of_links_without_masses_is_refused():
    weightless = PUMP.replace(", mass: 4 kg, mass_centre: S2, inertia: 0.0533 kg*m^2", "").replace(
        ", mass: 12 kg", ""
    )
    with pytest.raises(ProblemError, match="nothing in the machine has a moment of inertia or a mass"):
        found(weightless + "dynamics: {}")


@pytest.mark.parametrize(
    "motor", ("series: {power: 0, speed: 80, stall: 9}", "shunt: {power: 0, speed: 80, no_load: 90}")
)
def test_a_motor_without_power_is_refused(motor):
    said = refused(f"language: en\ndynamics: {{motor: {{{motor}}}, parts: [{{inertia: 1}}]}}")
    assert "dynamics.motor" in said and "power" in said


SHAKEN = "vibration: {mass: 90, stiffness: 9 kN/m, mechanism: right}\n"


@pytest.mark.parametrize(
    "block", [SHAKEN, "dynamics: {parts: [{name: rotor, inertia: 2}], start: {speed: 9}}\n"]
)
def test_masses_that_another_chapter_uses_are_not_called_useless(block):
    """Of a block that needs no loads."""
    said = [one.text() for one in loading.loads(PUMP + block).doubts]
    assert not any("no force analysis is made" in text for text in said)
    assert any("no force analysis is made" in one.text() for one in loading.loads(PUMP).doubts)
