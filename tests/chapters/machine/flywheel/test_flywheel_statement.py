"""What is stated wrong of a flywheel is told once, and what no machine has is refused."""

from __future__ import annotations

import re

import numpy as np
import pytest
from conftest import solved
from test_flywheel_input import LEVER, LOADS, told

from tmm_report import course, loading, render
from tmm_report.chapters.machine.flywheel.draw import places
from tmm_report.chapters.machine.flywheel.quantities import book

LOAD = "resisting: {table: [[0, 0], [90 deg, 800], [180 deg, 0]]}"
ALONE = "delta: 1/30, speed: 100 rpm, " + LOAD


def found(keys: str):
    return course.solve(loading.loads(f"flywheel: {{{keys}}}")).flywheel


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ("delta: 0, speed: 10, " + LOAD, "infinitely heavy"),
        ("delta: -1/30, speed: 10, " + LOAD, "the greatest speed is never below the least"),
        ("delta: 1/0, speed: 10, " + LOAD, "divided by zero"),
        ("delta: 0.1, speed: 0, " + LOAD, "flywheel.speed"),
        ("delta: 0.1, speed: 10, resisting: {table: [[0, 2, 3], [90 deg, 4]]}", "too many values"),
        ("delta: 0.1, speed: 10, resisting: {constant: 4 kg}", "flywheel.resisting.constant"),
    ],
)
def test_what_is_wrong_in_itself_is_not_told_to_be_missing(keys, words):
    text = told(f"flywheel: {{{keys}}}")
    assert words in text and len(text.splitlines()) == 1


@pytest.mark.parametrize(
    ("inertia", "words"),
    [
        ("{table: [[0, 2], [90 deg, 5], [90 deg, 1], [360 deg, 2]]}",
         "at 90 deg the moment of inertia jumps from 5 to 1 kg·m²"),
        ("{table: [[0, 2], [90 deg, 5], [360 deg, 3]]}", "at 360 deg the moment of inertia jumps from 3 to 2"),
        ("{mean: 1, harmonics: [{order: 2, cos: 2}]}", "at 90 deg the moment of inertia would be -1 kg·m²"),
    ],
)  # fmt: skip
def test_a_moment_of_inertia_neither_jumps_nor_is_negative(inertia, words):
    assert words in told(f"flywheel: {{{ALONE}, inertia: {inertia}}}")


def test_a_moment_of_inertia_may_just_reach_nothing():
    wheel = found(ALONE + ", inertia: {mean: 1, harmonics: [{order: 2, cos: 1}]}")
    assert wheel.proof.delta == pytest.approx(1 / 30, rel=1e-6)


@pytest.mark.parametrize(
    ("shape", "words", "limit"),
    [
        ("rim: {diameter: %s}", "spokes have no room", lambda s: s.number("k_h") <= 0.6 + 1e-9),
        (
            "disc: {diameter: %s}",
            "that is a shaft, no wheel",
            lambda s: s.number("k_b") <= 2 + 1e-9,
        ),
    ],
)
def test_a_diameter_too_small_for_the_inertia_is_refused_with_one_that_is_not(shape, words, limit):
    text = told(f"flywheel: {{{ALONE}, {shape % '50 mm'}}}")
    assert words in text
    least = text.rsplit("a diameter of ", 1)[1].removesuffix(" or more")
    assert limit(found(f"{ALONE}, {shape % least}").s)
    millimetre = f"{int(least.split()[0]) - 1} mm"
    assert words in told(f"flywheel: {{{ALONE}, {shape % millimetre}}}")


def test_the_own_part_is_the_stated_one_the_links_and_the_rotor():
    of = book(solved("punch_press").flywheel)
    assert of["flywheel_J_own"].value == pytest.approx(1.5 + 0.035 * 16**2)
    assert of["flywheel_J_0"].value == 1.5 and of["flywheel_J_r"].value == 0.035
    constant = found(ALONE + ", inertia: {constant: 2 kg*m^2}, own: 0.5 kg*m^2")
    assert book(constant)["flywheel_J_0"].value == book(constant)["flywheel_J_own"].value == 2.5
    of = book(solved("engine_four_stroke").flywheel)
    assert of["flywheel_J_c"].value == of["flywheel_J_own"].value == pytest.approx(0.09)


AREAS = "delta: 0.02, speed: 25, areas: {values: [400, -320, 380, -410, 300, -350]}, positions: "


def test_areas_have_the_moment_after_a_jump_at_every_boundary():
    of = book(found(AREAS + "24")).tables["flywheel_table"]
    areas = np.array([400, -320, 380, -410, 300, -350, 400])
    assert np.array(of["M_ex"].values)[::4] == pytest.approx(areas * 6 / (2 * np.pi))


@pytest.mark.parametrize("positions", [8, 10, 11, 24, 60])
def test_a_jump_is_drawn_upright_at_any_positions(positions):
    wheel = found(AREAS + str(positions))
    drawn = wheel.cycle.panels.at(wheel.cycle.moment, x := places(wheel))
    steep = np.diff(x)[np.abs(np.diff(drawn)) > 1]
    assert len(steep) == 6 and np.max(steep) < 1e-5


def test_a_stated_wheel_of_a_machine_whose_inertia_varies_has_it_in_the_table():
    wheel = found(
        "wheel: {inertia: 20}, speed: 30, inertia: {mean: 3, harmonics: [{order: 2, cos: 1}]}, " + LOAD
    )
    assert np.array(book(wheel).tables["flywheel_table"]["J_II"].values)[0] == pytest.approx(4)


def test_the_mass_of_a_wheel_known_whole_is_the_whole_one():
    for keys in (
        "wheel: {mass: 90, radius_of_gyration: 1}, speed: 30, ",
        "delta: 0.1, speed: 30, disc: {}, ",
    ):
        assert book(found(keys + LOAD))["flywheel_m"].quantity.meaning.text == "mass of the flywheel"
    rim = book(found("delta: 0.1, speed: 30, rim: {}, " + LOAD))["flywheel_m"]
    assert rim.quantity.meaning.text == "mass of the flywheel without spokes and hub"


def test_where_no_flywheel_is_needed_the_summary_says_so():
    (line,) = found("delta: 0.1, speed: 90, own: 40, " + LOAD).summary()
    assert "none is needed" in str(line)


def test_signs_of_the_differences_are_those_of_what_is_larger():
    wheel = solved("compressor").flywheel
    tables = book(wheel).tables
    cycle, methods = tables["flywheel_table"], tables["flywheel_methods"]
    assert np.array(cycle["domega"].values) == pytest.approx(np.array(cycle["omega"].values) - wheel.omega)
    fly = dict(zip(methods["method"].values, methods["J_fl"].values, strict=True))
    off = dict(zip(methods["method"].values, methods["deviation"].values, strict=True))
    assert (
        fly["mertsalov"] > fly["exact"] > fly["constant"] and off["mertsalov"] > 2 and off["constant"] < -40
    )


def words(keys: str, before: str = "") -> str:
    """The note without its tags."""
    made = render(course.solve(loading.loads(f"{before}flywheel: {{{keys}}}")), "html", "en", "full")
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", made["note.html"].decode()))


def test_only_a_stated_coefficient_is_called_so():
    usual = "For a machine of the kind “pump”"
    pump = "machine: pump, speed: 30, " + LOAD
    assert "; the stated one lies within this range" in words("delta: 0.1, " + pump)
    assert "; the stated one lies outside this range" in words("delta: 1e-2, " + pump)
    for wheel in (20, 2000):
        said = words(f"wheel: {{inertia: {wheel}}}, " + pump)
        assert usual in said and "the stated one" not in said


def test_where_no_flywheel_is_needed_none_is_given():
    said = words("delta: 0.1, own: 50", LEVER + LOADS)
    assert "no flywheel is needed" in said and "is taken for the flywheel of the machine" not in said


def test_nothing_is_shown_of_links_whose_inertia_does_not_vary():
    light = re.sub(r", mass: \d, mass_centre: \w(, inertia: 0.02)?", "", LEVER)
    said = words("delta: 0.1", light + LOADS)
    assert "Moments and work over the cycle" in said and "moment of inertia varies" not in said
    assert "Moments, work and energies" not in said and "ΔT" not in said


def test_a_wheel_known_whole_on_the_main_shaft_has_no_section_of_its_sizes():
    wheel = "wheel: {mass: 90, radius_of_gyration: 1}, speed: 30, "
    assert "Dimensions of the flywheel" not in words(wheel + LOAD)
    assert "Dimensions of the flywheel" in words(wheel + "ratio: 2, " + LOAD)
