"""Loads at their edges: a value for each position, the link that takes a force at a shared pivot, two points at one
place."""

from __future__ import annotations

import json
import math
import re

import numpy as np
import pytest
from edge_variants import PUMP, ROCKER, forces, found, refused
from exhaustive import many
from notes import render


def at(point: str, law: str, more: str = "") -> str:
    return f"loads:\n  forces:\n    - {{at: {point}, direction: left, {law}{more}}}\n"


def values(count: int) -> str:
    return f"by_position: [{'; '.join(f'{k} N' for k in range(count))}]".replace(";", ",")


# ---------------------------------------------------------------- as many values as positions


RANGE = ROCKER.replace("rad/s,", "rad/s, range: 60 deg,")


@pytest.mark.parametrize("steps", (12, 7))
def test_with_a_range_every_row_has_a_value_of_its_own(steps):
    text = f"{RANGE}positions: {{table: {steps}, diagram: 36}}\n"
    stated = forces(text + at("T", values(steps + 1))).loading.stated[0]
    assert stated == pytest.approx(np.arange(steps + 1.0))
    assert f"{steps} values, {steps + 1} positions" in refused(text + at("T", values(steps)))
    assert f"0 … {steps}" in refused(text + at("T", values(1)))


def test_of_full_turns_the_last_position_is_the_first_again():
    assert forces(ROCKER + at("T", values(12))).loading.stated[0] == pytest.approx([*range(12), 0])
    assert "13 values, 12 positions" in refused(ROCKER + at("T", values(13)))
    assert "position 12 is position 0 again" in refused(ROCKER + at("T", values(2)))
    whole = ROCKER.replace("rad/s,", "rad/s, range: 360 deg,")
    assert forces(whole + at("T", values(12))).loading.stated[0][-1] == 0
    turns = ROCKER.replace("rad/s,", "rad/s, turns: 2,")
    assert "0 … 23" in refused(turns + at("T", values(12)))


def test_where_the_range_is_wrong_itself_values_are_not_counted():
    said = refused(ROCKER.replace("rad/s,", "rad/s, range: 60 kg,") + at("T", values(13)))
    assert "range" in said and "by_position" not in said


# ---------------------------------------------------------------- pressures


def test_a_pressure_by_position_or_constant_is_a_force_on_the_piston():
    area, piston = math.pi / 4 * 0.09**2, "piston_diameter: 90 mm, "
    one = forces(PUMP + at("D", piston + "by_position: [0, 1 MPa, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.5 MPa]"))
    assert one.loading.stated[0][[0, 1, 2, 11]] == pytest.approx([0, 1e6 * area, 0, 0.5e6 * area])
    assert forces(PUMP + at("D", piston + "constant: 1 MPa")).loading.stated[0] == pytest.approx(1e6 * area)
    assert "a pressure (Pa)" in refused(PUMP + at("D", piston + "constant: 1 kN"))
    assert "2 values, 12 positions" in refused(PUMP + at("D", piston + "by_position: [1, 2]"))


# ---------------------------------------------------------------- which link takes a force


def column(text: str, key: str, table: str = "reactions_table"):
    written = json.loads(render(found(text), "json")["results.json"])
    return next(c["values"] for c in written["tables"][table]["columns"] if c["key"] == key)


@pytest.mark.exhaustive
def test_the_force_at_a_pivot_goes_to_the_stated_link():
    """The pivot's reaction differs by the force, and nothing else does."""
    rod, slider = PUMP + at("D", "constant: 700 N", ", on: 4"), PUMP + at("D", "constant: 700 N", ", on: 5")
    assert np.subtract(column(rod, "R_45_x"), column(slider, "R_45_x")) == pytest.approx(-700)
    assert column(rod, "R_45_y") == pytest.approx(column(slider, "R_45_y"))
    for key in ("R_05", "R_34", "R_01", "R_23"):
        if key in str(render(found(rod), "json")):
            assert column(rod, key) == pytest.approx(column(slider, key))
    assert forces(rod).balancing == pytest.approx(forces(slider).balancing)
    assert found(rod).lever.kinetostatics.agrees


@pytest.mark.exhaustive
def test_the_note_and_the_results_say_which_link_takes_it():
    for text, link in (
        (PUMP + at("D", "constant: 700 N"), "5"),
        (PUMP + at("D", "constant: 700 N", ", on: 4"), "4"),
        (PUMP + at("B", "constant: 700 N"), "2"),
        (PUMP + at("B", "constant: 700 N", ", on: 3"), "3"),
    ):
        assert column(text, "link", "loads_given") == [link]
        note = render(found(text), "html")["note.html"].decode()
        assert f'of link <span data-q="link" data-k="0" data-t="loads_given">{link}</span>' in note


def test_the_link_that_takes_a_force_has_its_point_and_moves():
    wrong = {
        "3": "the point D is not on link 3; known: 4, 5",
        "9": "there is no link 9",
        "0": "the frame takes",
    }
    for link, said in wrong.items():
        assert said in refused(PUMP + at("D", "constant: 1 N", f", on: {link}"))
    assert "the frame takes every moment" in refused(
        PUMP + "loads: {moments: [{on: 0, direction: clockwise, constant: 1 N*m}]}"
    )


# ---------------------------------------------------------------- points at one place


@pytest.mark.exhaustive
@pytest.mark.parametrize("point", many(("A: 100 mm", "O: 0", "S1: 50 mm")))
def test_a_point_may_stand_at_the_place_of_another(point):
    """Loads and masses at it do what they do at the other; the lengths are as without it."""
    name, place = point.split(": ")
    moved = PUMP.replace("S1: 50 mm}}", f"S1: 50 mm, P0: {place}}}, mass: 3 kg, mass_centre: P0}}")
    plain = PUMP.replace("S1: 50 mm}}", f"S1: 50 mm}}, mass: 3 kg, mass_centre: {name}}}")
    there, here = moved + at("P0", "constant: 50 N"), plain + at(name, "constant: 50 N", ", on: 1")
    assert forces(there).balancing == pytest.approx(forces(here).balancing, abs=1e-9)
    assert column(there, "R_01") == pytest.approx(column(here, "R_01"))
    assert min(column(there, "length", "dimensions")) > 0
    said = re.sub(r"<[^>]+>", "", render(found(there), "html")["note.html"].decode())
    assert f"P₀ at the place of {name.translate({49: 8321})}" in said  # S₁
    assert b"P0" in render(found(there), "tex")["note.tex"]
    assert f"v_{name}" in ("v_O", *found(there).lever.kinematics.values)
    same = found(there).lever.kinematics.values["v_P0"]
    assert same == pytest.approx(0 if name == "O" else found(there).lever.kinematics.values[f"v_{name}"])


@pytest.mark.exhaustive
def test_a_point_at_the_place_of_the_first_leaves_its_axis_to_the_next():
    text = PUMP.replace("{O: 0, A: 100 mm,", "{O: 0, P0: 0, A: 100 mm,")
    assert found(text).lever.kinematics.table.place("D") == pytest.approx(
        found(PUMP).lever.kinematics.table.place("D")
    )
    with np.errstate(all="raise"):  # the scale is not worked out from a segment of nothing
        assert b"</html>" in render(found(text), "html")["note.html"]


def test_two_pivots_of_a_link_are_not_at_one_place():
    said = refused(PUMP.replace("B: 280 mm}", "B: 280 mm, D: 280 mm}"))
    assert "zero length: D is at the place of B; one name for both" in said
