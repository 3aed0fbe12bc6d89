"""Instants that a variant asks for beside the positions: the numbers of the table where both meet, and between them."""

import json

import numpy as np
import pytest
from notes import render

from tmm_report import course, loading
from tmm_report.problems import ProblemError

TEXT = """
mechanism:
  frame: {O: [0, 0], C: [0.4 m, 0.1 m]}
  guides: {x: {through: C, angle: 20 deg}}
  links:
    1: {points: {O: [0, 0], A: [100 mm, 0]}}
    2: {points: {A: [0, 0], B: [450 mm, 0]}, mass: 1.5 kg, inertia: m*l^2/12}
    3: {points: {C: [0, 0], B: [300 mm, 0]}, mass: 2 kg, inertia: m*l^2/12}
    4: {points: {B: [0, 0], D: [600 mm, 0]}, mass: 1 kg, inertia: m*l^2/12}
    5: {points: {D: [0, 0]}, slides: x, mass: 4 kg, mass_centre: D}
  driver: {link: 1, DRIVER, zero: {angle: 25 deg}}
  assembly: {B: left of A-C, D: right}
positions: {table: 12, at: [AT]}
loads:
  forces: [{at: D, direction: left, by_angle: [[0, 0], [90 deg, 200 N], [270 deg, -50 N], [360 deg, 0]]}]
"""


def document(driver, at):
    results = course.solve(loading.loads(TEXT.replace("DRIVER", driver).replace("AT", at)))
    return json.loads(render(results, "json")["results.json"])


def columns(of, table):
    return {column["key"]: column["values"] for column in of["tables"][table]["columns"]}


@pytest.mark.parametrize("driver", ["speed: 7 rad/s", "speed: 7 rad/s, rotation: clockwise"])
@pytest.mark.parametrize("timed", [False, True])
def test_at_the_angles_of_positions_they_are_the_positions(driver, timed):
    at = [f"{float(np.radians(angle)) / 7!r} s" if timed else f"{angle} deg" for angle in (60, 30, 270)]
    found, seen = document(driver, ", ".join(at)), 0
    for table in ("outputs", "positions", "rates", "loads", "reactions", "balancing"):
        there, own = columns(found, f"{table}_table"), columns(found, f"{table}_at")
        for key, values in own.items():
            if key in there and "disagreement" not in key and "digits" not in key:
                seen += 1
                wanted = [there[key][k] for k in (2, 1, 9)]
                size = max(abs(value) for value in there[key] if value is not None)
                assert values == pytest.approx(wanted, rel=1e-9, abs=1e-9 * size), (table, key)
    assert seen > 60


def test_between_positions_they_are_those_of_a_finer_table():
    found = document("speed: 7 rad/s", "40 deg, 100 deg")
    finer = loading.loads(
        TEXT.replace("DRIVER", "speed: 7 rad/s").replace("AT", "").replace("table: 12", "table: 36")
    )
    other = json.loads(render(course.solve(finer), "json")["results.json"])
    for table, key in (("rates", "a_D"), ("rates", "e_4"), ("balancing", "M_bal"), ("reactions", "R_05")):
        there = columns(other, f"{table}_table")[key]
        assert columns(found, f"{table}_at")[key] == pytest.approx([there[4], there[10]], rel=1e-9)


def test_the_note_shows_them_with_their_numbers():
    results = course.solve(
        loading.loads(TEXT.replace("DRIVER", "speed: 7 rad/s").replace("AT", "40 deg, 0.2 s"))
    )
    for language, words in (("en", "at the instants asked for"), ("ru", "в заданные моменты")):
        html = render(results, "html", language)["note.html"].decode()
        assert html.count(words) >= 2
        assert 'data-q="outputs_at' in html or "outputs_at" in html


SLIPS = {
    "400 deg": "beyond the cycle, from 0 to 360° or 0.897598 s",
    "1 s": "beyond the cycle",
    "-5 deg": "beyond the cycle",
    "5 m": "by a length only where a slider or a cylinder drives",
    "5 kg": "40 deg, an angle turned, 0.05 s, a time",
}


@pytest.mark.parametrize("at", SLIPS)
def test_slips(at):
    with pytest.raises(ProblemError) as caught:
        document("speed: 7 rad/s", at)
    (problem,) = caught.value.problems
    assert problem.key == "positions.at.0" and SLIPS[at] in problem.text()


def test_no_instants_change_nothing():
    assert not [name for name in document("speed: 7 rad/s", "")["tables"] if name.endswith("_at")]


BY_LAW = TEXT.replace(", zero: {angle: 25 deg}", "").replace(
    "by_angle: [[0, 0], [90 deg, 200 N], [270 deg, -50 N], [360 deg, 0]]", "constant: 200 N"
)


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("zero", ["", ", zero: {point: D, extreme: right}"])
def test_a_link_that_speeds_up_is_asked_by_its_angle(sense, zero):
    """ω₀ t + ε t²/2 = φ by its root; the angle of the link there, and the same numbers as at that time."""
    law = f"law: {{speed: {5 * sense} rad/s, acceleration: {4 * sense} rad/s^2}}{zero}"
    times = [(np.sqrt(25 + 8 * np.radians(angle)) - 5) / 4 for angle in (40, 300, 0)]

    def at(written):
        results = course.solve(loading.loads(BY_LAW.replace("DRIVER", law).replace("AT", written)))
        return json.loads(render(results, "json")["results.json"])

    found, timed = at("40 deg, 300 deg, 0 deg"), at(", ".join(f"{time!r} s" for time in map(float, times)))
    assert columns(found, "rates_at")["t"] == pytest.approx(times, rel=1e-12, abs=1e-12)
    turned = np.array(columns(found, "outputs_at")["phi_law"])
    assert turned - turned[2] == pytest.approx(sense * np.array([40.0, 300.0, 0.0]), rel=1e-11, abs=1e-9)
    for table in ("rates_at", "balancing_at"):
        for key in ("a_D", "e_4", "M_bal"):
            if key in columns(found, table):
                assert columns(found, table)[key] == pytest.approx(
                    columns(timed, table)[key], rel=1e-8, abs=1e-9
                )


@pytest.mark.parametrize(
    ("law", "angle"),
    [
        ("law: {angle: 60 deg, harmonic: {amplitude: 35 deg, frequency: 8 rad/s}}", "10 deg"),
        ("law: {speed: 5 rad/s, acceleration: 4 rad/s^2, time: 0.1 s}", "40 deg"),
    ],
)
def test_a_link_that_turns_back_or_does_not_come_so_far_is_asked_by_the_time(law, angle):
    with pytest.raises(ProblemError) as caught:
        loading.loads(BY_LAW.replace("DRIVER", law).replace("AT", angle))
    (told,) = caught.value.problems
    assert told.key == "positions.at.0" and "positions are stated by the time" in told.text()
