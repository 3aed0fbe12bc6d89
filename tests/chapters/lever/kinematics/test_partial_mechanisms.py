"""Mechanisms that close over part of the cycle: what is lost is lost whole, is told first, and has no extremes."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from notes import static

from tmm_report.chapters.lever.kinematics.checks.open_cycle import angles
from tmm_report.course import solve
from tmm_report.i18n import Translator
from tmm_report.loading import load, loads
from tmm_report.mechanics.lever import dyads
from tmm_report.note import render
from tmm_report.problems import ProblemError
from tmm_report.results import as_json, tables, values

JAM = """\
language: en
mechanism:
  frame: {O: [0, 0], C: [4.2, 0]}
  links:
    1: {points: {O: 0, A: 3}}
    2: {points: {A: 0, B: 1, S2: 0.4}, mass: 1.5, mass_centre: S2, inertia: 0.002}
    3: {points: {C: 0, B: ROCKER, S3: 1}, mass: 0.8, mass_centre: S3, inertia: 0.001}
  driver: {link: 1, speed: 10, rotation: counter-clockwise, zero: {angle: 0 deg}}
  assembly: {B: left of A-C}
loads:
  gravity: 9.81
  moments: [{on: 3, direction: clockwise, constant: 5}]
allow_partial: true
"""
SHORT_ROD = """\
language: en
mechanism:
  frame: {O: [0, 0], G: [0, OFFSET]}
  guides: {x: {through: G}}
  links:
    1: {points: {O: 0, A: CRANK}}
    2: {points: {A: 0, B: ROD, S2: 0.04}, mass: 1.5, mass_centre: S2, inertia: 0.002}
    3: {points: [B], slides: x, mass: 0.8, mass_centre: B}
  driver: {link: 1, speed: 10, rotation: SENSE, zero: {angle: START deg}}
  assembly: {B: right}
loads:
  gravity: 9.81
  forces: [{at: B, direction: left, constant: 30}]
friction: {pivots: {coefficient: 0.1, diameter: 20 mm}, guides: {coefficient: 0.1}}
reduction: true
positions: {table: COUNT, diagram: 36}
"""


def short_rod(crank=0.1, rod=0.08, offset=0.02, sense="counter-clockwise", start=0.0, count=12) -> str:
    stated = {"CRANK": crank, "ROD": rod, "OFFSET": offset, "SENSE": sense, "START": start, "COUNT": count}
    text = SHORT_ROD
    for name, value in stated.items():
        text = text.replace(name, str(value))
    return text


CASES = {
    "four-bar that jams": JAM.replace("ROCKER", "2"),
    "its brother": JAM.replace("ROCKER", "1.9"),
    "rod shorter than the crank": short_rod(),
    "clockwise, position 0 in the gap": short_rod(sense="clockwise", start=90.0, rod=0.07, count=13),
    "rod as long as the crank, in line": short_rod(rod=0.1, offset=0.0),
    "rod that just passes": short_rod(crank=0.0999, rod=0.1, offset=0.1 - 0.0999),
}


def half_lost(found) -> list[tuple[str, str]]:
    """Vectors of which one component, or the size alone, is missing somewhere."""
    wrong = []
    for table in tables(found):
        columns = {column.key: column.values for column in table.columns}
        for key in columns:
            parts = [key, f"{key}_x", f"{key}_y"]
            if parts[1] in columns and parts[2] in columns:
                lost = [np.isnan(np.asarray(columns[part], dtype=float)) for part in parts]
                if any((one != lost[0]).any() for one in lost):
                    wrong.append((table.name, key))
    return wrong


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", CASES)
def test_a_vector_is_lost_in_all_its_components(name):
    found = solve(loads(CASES[name]))
    lost = [
        np.isnan(np.asarray(column.values, dtype=float)).any()
        for table in tables(found)
        if table.name in ("rates_table", "reactions_table")
        for column in table.columns
    ]
    assert any(lost), "nothing is lost, so nothing is shown"
    assert half_lost(found) == []
    lever = found.lever
    reactions = {key: one.force for key, one in lever.kinetostatics.table.statics.reactions.items()}
    for key, numbers in {**lever.kinematics.values, **reactions}.items():
        assert (np.isnan(np.real(numbers)) == np.isnan(np.imag(numbers))).all() or not np.iscomplexobj(
            numbers
        ), key


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["parallelogram_drive", "loom", "slotter"])
def test_ready_variants_lose_whole_vectors(name):
    assert half_lost(solve(load(Path("variants") / f"{name}.yaml"))) == []


def note(text: str) -> str:
    found = solve(loads(text))
    html = render(found, "html", Translator("en"))["note.html"].decode()
    return re.sub(r"<[^>]+>", "", re.sub(r"<(svg|style)\b.*?</\1>", "", static(html), flags=re.S))


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["four-bar that jams", "rod shorter than the crank"])
def test_the_failure_is_said_first(name):
    text = note(CASES[name])
    told = (
        "The mechanism closes over part of the cycle only"
        if "jams" in name
        else "The mechanism does not make a full cycle"
    )
    introduction, conclusions = text.rindex("Introduction"), text.rindex("Conclusions")
    for start in (introduction, conclusions):
        first = text[start:].split("\n", 1)[1].strip()
        assert first.startswith(told), first[:200]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["four-bar that jams", "rod shorter than the crank"])
def test_what_grows_without_bound_has_no_extremes(name):
    found = solve(loads(CASES[name]))
    by_key = {value.key: value.value for value in values(found)}
    output = found.lever.kinematics.travels[0].output.name
    lost = [f"{letter}_{output}_{end}" for letter in "VA" for end in ("min", "max")]
    ends = {key: by_key[key] for key in (*lost, "M_bal_min", "M_bal_max")}
    assert any(np.isnan(ends[key]) for key in lost) and np.isnan(ends["M_bal_min"])
    text = note(CASES[name])
    conclusion = text[text.rindex("Conclusions") :]
    assert "The balancing moment grows without bound towards the limit position" in conclusion
    assert "varies over the cycle" not in conclusion and "nan" not in conclusion.replace("inance", "")


@pytest.mark.exhaustive
def test_nothing_is_averaged_over_a_cycle_that_is_none():
    found = solve(loads(CASES["rod shorter than the crank"]))
    assert np.isnan(found.lever.friction.mean_power) and np.isnan(found.lever.friction.mean_efficiency)
    assert all(np.isnan(end.value) for end in found.lever.reduction.extremes)
    assert b"NaN" not in as_json(found, Translator("en"))


def test_a_position_that_is_a_limit_has_a_place_but_no_rates():
    """Rod 50 mm, crank 100 mm: it stands across the guide at 30°, which is position 1."""
    k = solve(loads(short_rod(rod=0.05, offset=0.0))).lever.kinematics
    for key, numbers in k.values.items():
        if key != "w_1" and key != "e_1":
            assert np.isnan(numbers[1]), key
    assert np.nanmax(np.abs(k.values["v_B"])) < 10.0
    within = solve(loads(short_rod(rod=0.05, offset=0.0, start=-3e-4))).lever.kinematics
    assert within.table.closes[1] and np.isnan(within.values["v_B"][1]) and 1 in within.undefined
    beside = solve(loads(short_rod(rod=0.05, offset=0.0, start=-0.01))).lever.kinematics
    assert np.isfinite(beside.values["v_B"][1])  # 0.01° before it: real, however fast


@pytest.mark.exhaustive
@settings(max_examples=12)
@given(st.floats(0.05, 0.2), st.floats(0.03, 0.2), st.floats(-0.1, 0.1), st.booleans(), st.floats(0, 360))
def test_a_jam_is_told_whatever_the_spacing_of_the_table(crank, rod, offset, forward, start):
    """The rod reaches while |r sin φ − e| ≤ l: the gaps by this formula, and none where it holds all round."""
    sense = "counter-clockwise" if forward else "clockwise"
    reach = max(abs(crank - offset), abs(-crank - offset))
    assume(abs(reach - rod) > 1e-6 and min(abs(crank - offset), abs(crank + offset)) != rod)
    assume(min(abs(-crank - offset), abs(crank - offset), abs(offset)) < rod)
    text = short_rod(crank, rod, offset, sense, start, count=4).replace("diagram: 36", "diagram: 12")
    text = re.sub(r"(?ms)^friction.*?\nreduction: true\n", "", text)
    try:
        found = solve(loads(text)).lever
    except ProblemError as error:  # no position of so few exists: told as such
        assert "at any position" in str(error) or "no position of the table" in str(error)
        return
    k = found.kinematics
    assert bool(k.gaps) == (reach > rod) == found.partial
    fine = np.linspace(0, 2 * np.pi, 7201)
    side = 1 if forward else -1
    lost = np.abs(crank * np.sin(np.radians(start) + side * fine) - offset) > rod
    told = np.zeros(fine.shape, dtype=bool)
    for gap in k.gaps:
        for a, b in gap.intervals:
            told |= ((fine > a) & (fine < b)) | ((fine + 2 * np.pi > a) & (fine + 2 * np.pi < b))
    edge = np.abs(np.abs(crank * np.sin(np.radians(start) + side * fine) - offset) - rod) < 1e-3 * rod
    assert (told == lost)[~edge].all()


# ---------------------------------------------------------------- how intervals are written


@pytest.mark.parametrize(
    "intervals, written",
    [
        ([(30, 150)], "30.00° < φ < 150.00°"),
        ([(350.24, 365.1)], "350.24° < φ < 360° and 0° ≤ φ < 5.10°"),
        ([(30, 150), (210, 330)], "30.00° < φ < 150.00° and 210.00° < φ < 330.00°"),
        ([(10, 20), (30, 40), (355, 361)],
         "10.00° < φ < 20.00°, 30.00° < φ < 40.00°, 355.00° < φ < 360° and 0° ≤ φ < 1.00°"),
        ([(108.39, 108.3907)], "108.39000° < φ < 108.39070°"),
        ([(359.99995, 360.2)], "359.999950° < φ < 360° and 0° ≤ φ < 0.200000°"),
        ([(41.08, 360)], "41.08° < φ < 360°"),
        ([(0, 40)], "0° ≤ φ < 40.00°"),
    ],
)  # fmt: skip
def test_intervals_are_written_as_people_write_them(intervals, written):
    assert str(angles(tuple((np.radians(a), np.radians(b)) for a, b in intervals))) == written


def test_the_two_ends_of_a_narrow_gap_differ_in_print():
    """A gap of 2e-4 rad, between positions 30° apart."""
    found = solve(loads(short_rod(crank=0.1, rod=0.12 * (1 - 5e-9), offset=0.02)))
    (gap,) = found.lever.kinematics.gaps
    first, last = re.findall(r"(\d+\.\d+)°", str(gap.text))[:2]
    assert first != last and found.lever.partial
    width = np.degrees(2 * np.arccos((0.12 * (1 - 5e-9) - 0.02) / 0.1))
    assert float(last) - float(first) == pytest.approx(width, rel=0.1)


# ---------------------------------------------------------------- what is printed closes


def test_a_position_whose_joints_do_not_close_is_left_out_and_named(monkeypatch):
    place = dyads._PLACE[1]

    def slips(s, d):
        place(s, d)
        s.u[d.b] = np.where(np.abs(np.cos(s.phi) - np.cos(0.5236)) < 1e-3, s.u[d.b] * np.exp(1e-6j), s.u[d.b])

    monkeypatch.setitem(dyads._PLACE, 1, slips)
    found = solve(loads(JAM.replace("ROCKER", "3").replace("A: 3", "A: 0.5").replace("B: 1,", "B: 4,"))).lever
    (gap,) = found.kinematics.unclosed[:1]
    assert "do not close to 1e-9" in str(gap.text) and "30.00°" in str(gap.text)
    assert 1 in found.kinematics.missing and np.isnan(found.kinematics.values["v_B"][1])


def test_the_stroke_ends_in_the_limit_exactly():
    """Rod 1 and rocker 2 in one line: AC = 3 by the law of cosines, where A is at 3 and C at 4.2."""
    (travel,) = solve(loads(CASES["four-bar that jams"])).lever.kinematics.travels
    limit = np.arccos((9 + 4.2**2 - 9) / (2 * 3 * 4.2))
    assert travel.far.turned == pytest.approx(2 * np.pi - limit, abs=1e-9)
    A = 3 * np.exp(-1j * limit)
    start = np.angle(placed(1.2, 3.0 + 0j))
    assert travel.far.value == pytest.approx(np.angle((A - 4.2) * np.exp(-1j * start)), abs=1e-5)


def placed(frame_less_crank: float, A: complex) -> complex:
    """B − C of the four-bar with crank 3, rod 1, rocker 2, frame 4.2, for A on the line of the frame; B on the left."""
    x = (frame_less_crank**2 + 1 - 4) / (2 * frame_less_crank)
    return A + x + 1j * np.sqrt(1 - x * x) - 4.2
