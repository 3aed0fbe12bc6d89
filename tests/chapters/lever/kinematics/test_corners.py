"""Corners and turns that do not come back, as a user meets them: extremes, exit code, last row, checks."""

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.course import solve
from tmm_report.loading import load, loads
from tmm_report.problems import ProblemError

CASES = Path(__file__).parents[3] / "cases" / "mechanics"


def solved(name, folder):
    """The exit code, the values by key, the tables and what was printed."""
    run = CliRunner().invoke(
        app, ["solve", str(CASES / f"{name}.yaml"), "-o", str(folder), "--format", "json"]
    )
    found = json.loads((folder / "results.json").read_text("utf-8"))
    return run.exit_code, {one["key"]: one for one in found["values"]}, found["tables"], run.output


@pytest.mark.parametrize(
    ("name", "k", "omega"),
    [("kite", 1 / 3, 10), ("kite_extremes_k1", 0.12 / 0.27, 10), ("kite_extremes_k3", 0.15 / 0.19, 10)],
)
def test_a_kite_jumps_and_its_extremes_are_those_of_both_sides(name, k, omega, tmp_path):
    code, values, _, said = solved(name, tmp_path)
    assert code == 1 and "its links jump there" in " ".join(said.split())
    assert values["H_3"]["value"] == pytest.approx(np.pi, abs=1e-9)
    assert values["V_3_min"]["value"] == pytest.approx(omega * (1 - k) / 2, rel=1e-9)
    assert values["V_3_max"]["value"] == pytest.approx(omega * (1 + k) / 2, rel=1e-9)
    assert values["V_3_min"]["side"] == -1 and values["V_3_max"]["side"] == 1
    # θ = φ/2 + arcsin(k sin φ/2), twice differentiated, halfway round
    assert values["A_3_min"]["value"] == pytest.approx(-(omega**2) * k / 4 / np.sqrt(1 - k * k), rel=1e-9)


def test_a_kite_begun_at_its_change_point_swings_by_half_a_turn_and_has_no_dead_point(tmp_path):
    code, values, tables, _ = solved("k1z", tmp_path)
    special = {column["key"]: column["values"] for column in tables["special"]["columns"]}
    outputs = {column["key"]: column["values"] for column in tables["outputs_table"]["columns"]}
    assert code == 1 and values["H_3"]["value"] == pytest.approx(np.pi, abs=1e-9)
    assert "dead" not in special["kind"]
    assert outputs["psi_3"][0] == 0.0 and outputs["psi_3"][-1] == pytest.approx(np.pi, abs=1e-9)
    assert outputs["omega_3"][0] is None and outputs["omega_3"][-1] is None


def test_a_slider_whose_offset_is_rod_less_crank_has_no_rate_of_rounding_errors(tmp_path):
    code, values, _, _ = solved("offset_eq_acceleration", tmp_path)
    assert code == 0
    assert values["A_B_min"]["value"] == pytest.approx(-2.582441681646934, rel=1e-9)
    assert values["A_B_max"]["value"] == pytest.approx(17.856241581267145, rel=1e-9)
    assert values["A_2_min"]["value"] == pytest.approx(0.0, abs=1e-7)
    assert values["A_2_max"]["value"] == pytest.approx(40.824829046386306, rel=1e-9)


def test_the_last_row_of_a_motion_that_does_not_come_back_is_what_the_mechanism_is_there():
    results = solve(load(CASES / "z2048.yaml"))
    found, forces = results.lever.kinematics, results.lever.kinetostatics
    first, last = (found.table.turn("3")[k] for k in (0, -1))
    assert abs(first - last) > 0.1
    almost = found.cycle.motion(np.array([2 * np.pi - 1e-6])).turn("3")[0]
    assert abs(last - almost) < 1e-4
    assert forces.worst_power < 1e-9 and forces.worst_lever < 1e-9
    assert found.table.angular_velocity("3")[0] != found.table.angular_velocity("3")[-1]


def test_of_turns_after_one_that_does_not_come_back_nothing_is_printed():
    text = (CASES / "z2048.yaml").read_text("utf-8")
    again = text.replace('"rotation": "clockwise"', '"rotation": "clockwise", "turns": 2').replace(
        '"table": 120', '"table": 24'
    )
    found = solve(loads(again)).lever.kinematics
    assert found.missing == tuple(range(13, 25))


@pytest.mark.parametrize(
    ("from_", "to", "said"),
    [
        ("[B]", "[E, C]", "{E: 0, C: 100 mm}"),
        ("through: Q", "points: [E, C]", "through: [E, C]"),
    ],
)
def test_points_in_a_list_are_told_what_they_lack(from_, to, said):
    text = """\
mechanism:
  frame: {O: [0, 0], Q: [0, -0.05]}
  guides: {x: {through: Q}}
  links:
    1: {points: {O: 0, A: 0.1}}
    2: {points: {A: 0, B: 0.3}}
    3: {points: [B], slides: x}
  driver: {link: 1, speed: 10, rotation: counter-clockwise}
  assembly: {B: right}
"""
    with pytest.raises(ProblemError) as caught:
        loads(text.replace(from_, to))
    assert any(said in str(one.right) for one in caught.value.problems)


def test_two_guides_through_the_same_two_points_are_solved():
    text = """\
mechanism:
  frame: {O: [0, 0], C: [0, -0.3], E: [0.2, 0.1]}
  guides: {x: {through: [E, C]}, y: {through: [E, C]}}
  links:
    1: {points: {O: 0, A: 0.1}}
    2: {points: {A: 0, B: 0.35}}
    3: {points: [B], slides: x}
    4: {points: {A: 0, D: 0.4}}
    5: {points: [D], slides: y}
  driver: {link: 1, speed: 10, rotation: counter-clockwise, zero: {angle: 20 deg}}
  assembly: {B: up, D: down}
"""
    assert solve(loads(text)).lever.kinematics.missing == ()


ANTIPARALLEL = """
language: en
mechanism:
  frame: {{O: [0, 0], C: [-{frame} mm, 0]}}
  links:
    1: {{points: {{O: 0, A: {crank} mm}}}}
    2: {{points: {{A: 0, B: {frame} mm}}}}
    3: {{points: {{C: 0, B: {crank} mm}}}}
  driver: {{link: 1, speed: 10 rad/s, rotation: counter-clockwise, zero: {{angle: 18.7 deg}}}}
  assembly: {{B: left of A-C}}
positions: {{table: 12, diagram: 36}}
"""


@pytest.mark.parametrize(("frame", "crank"), [(131.74, 131.7), (197, 196), (189.1, 188.9), (300, 150)])
def test_an_antiparallelogram_of_nearly_equal_sides_turns_all_round_within_a_fraction_of_a_degree(
    frame, crank
):
    """Passing its change point link 3 turns (d + r)/(d - r) times as fast as the crank; over the turn it goes all
    round."""
    kinematics = solve(loads(ANTIPARALLEL.format(frame=frame, crank=crank))).lever.kinematics
    (travel,) = kinematics.travels
    fastest = max(abs(extreme.value) for extreme in travel.V_extremes)
    assert fastest == pytest.approx(10 * (frame + crank) / (frame - crank), rel=1e-8)
    assert travel.stroke == pytest.approx(2 * np.pi, rel=1e-9)
