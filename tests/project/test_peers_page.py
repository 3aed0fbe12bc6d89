"""The comparison with other programs, without any of them: its reference, its judge, its tables."""

from __future__ import annotations

import importlib.metadata
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from benchmarks.peers import chart, judge, ours, page, scenes, table
from benchmarks.peers import scene as scenery
from benchmarks.peers.gears import ours as our_gears
from benchmarks.peers.gears import scene as gears
from benchmarks.peers.judge import Row
from benchmarks.peers.peer import Peer, Refused
from benchmarks.peers.scene import KINDS

SCENES = {
    "compressor": scenery.compressor(),
    "guide under the crank, slider left": replace(
        scenery.slider_crank(0.1, 0.3, -0.04, -1), omega=2.0, gravity=-9.81
    ),
    "four-bar": scenery.four_bar(0.1, 0.3, 0.25, 0.35),
    "four-bar, crossed": scenery.four_bar(0.1, 0.3, 0.25, 0.35, -1),
}


@pytest.mark.parametrize("name", SCENES)
def test_the_reference_by_closed_forms_and_powers_is_what_the_general_solver_finds(name: str) -> None:
    scene = SCENES[name]
    phi = scenery.angles(scene, 17, 0.2)
    scene = replace(scene, forces={p: f[:17] for p, f in scene.forces.items()})
    exact = scenery.reference(scene, phi)
    found = judge.errors(ours.prepare(scene, phi)(), exact, scene)
    assert all(off is not None and off < 1e-14 for off in found.values()), found


def test_a_doubled_number_of_digits_changes_nothing() -> None:
    scene = scenery.compressor()
    phi = scenery.angles(scene)[[0, 5]]
    fewer, more = (scenery.reference(scene, phi, digits) for digits in (40, 80))
    assert all(
        np.max(np.abs(fewer[key] - more[key])) < 1e-30 for key in more
    )  # a slider's y is 0 but for 1e-41


def test_the_reference_keeps_its_digits_where_the_rod_stands_almost_across_its_guide() -> None:
    r, l = 0.1, 0.1 * (1 + 1e-10)
    exact = scenery.reference(scenery.slider_crank(r, l), np.array([-np.pi / 2]))
    assert exact["B"][0].real == pytest.approx(
        math.sqrt((l - r) * (l + r)), rel=1e-9, abs=0
    )  # r·cos φ is 6e-18


def test_the_side_of_a_rod_is_the_one_that_the_scene_states() -> None:
    for side in (1, -1):
        bar, slider = scenery.four_bar(0.1, 0.3, 0.25, 0.35, side), scenery.slider_crank(0.1, 0.3, 0.0, side)
        A, B = (scenery.starts(bar, 0.7)[point] for point in "AB")
        assert np.sign(((B - A) / (0.35 - A)).imag) == side
        assert np.sign(scenery.starts(slider, 0.7)["B"].real) == side


def test_velocities_and_accelerations_are_slopes_of_the_places() -> None:
    scene, step = SCENES["four-bar"], 1e-4
    before, at, after = (scenery.motion(scene, 0.7 + k * step) for k in (-1, 0, 1))
    back = -2 * step  # the crank turns clockwise, 1 rad/s
    assert abs((after["B"] - before["B"]) / back - at["v_B"]) < 1e-8 * scene.crank
    assert abs((after["v_B"] - before["v_B"]) / back - at["a_B"]) < 1e-8 * scene.crank


def test_a_planted_error_is_found_what_is_missing_and_what_has_no_value_is_told_apart() -> None:
    scene = scenery.slider_crank(0.1, 0.3)
    phi = scenery.angles(scene, 12)
    exact = scenery.reference(scene, phi)
    found = {
        key: values.copy() for key, values in exact.items() if not key.startswith("a_") and key != "moment"
    }
    found["B"][3] += 1e-6j * np.max(np.abs(exact["B"]))
    found["v_A"][0] = np.nan
    judged = judge.errors(found, exact, scene)
    assert judged["position"] == pytest.approx(1e-6)
    assert np.isnan(judged["velocity"])
    assert judged["acceleration"] is judged["moment"] is None


def test_times_are_ratios_to_ours_of_the_same_work_and_a_refusal_is_a_row() -> None:
    def refuses(*_: object) -> None:
        raise Refused("cannot be assembled")

    scene = scenery.slider_crank(0.1, 0.3)
    phi = scenery.angles(scene, 12)
    peers = {"ours": ours.PEER, "other": Peer("other", "none", refuses)}
    rows = judge.measured(peers, scene, phi, scenery.reference(scene, phi), (1, 1))
    assert [(row.name, row.refused) for row in rows] == [
        ("ours, motion and forces", ""),
        ("ours, motion", ""),
        ("other", "cannot be assembled"),
    ]
    assert [row.ratio for row in rows[:2]] == [1.0, 1.0]


def test_a_program_that_is_not_installed_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    def nothing(name: str) -> str:
        raise importlib.metadata.PackageNotFoundError(name)

    monkeypatch.setattr("benchmarks.peers.peer.metadata.version", nothing)
    assert scenes.installed() == ()


def test_a_scene_is_solved_by_name_and_what_a_program_raises_is_its_refusal(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = scenery.slider_crank(0.1, 0.3, 0.05)
    phi = scenery.angles(scene, 12)
    assert np.allclose(scenes.solve("ours", scene, phi)["B"], scenery.reference(scene, phi)["B"], atol=1e-15)

    def breaks(*_: object) -> None:
        raise ValueError("singular matrix")

    monkeypatch.setitem(scenes.PEERS, "ours", Peer("ours", "tmm-report", breaks))
    with pytest.raises(Refused, match="ValueError: singular matrix"):
        scenes.solve("ours", scene, phi)


ROWS = [
    Row("ours", "motion", dict(zip(KINDS, (3e-16, 0.0, 2e-16, None), strict=True)), 1.0),
    Row("other", "10 steps a position", dict.fromkeys(KINDS, 1.23e-4), 123.4),
    Row("other", "100 steps a position", dict.fromkeys(KINDS, float("nan")), 9.87),
    Row("third", "", dict.fromkeys(KINDS), refused="cannot be assembled"),
]
GEARS = {
    "plain": {
        "other, wheel": {"errors": dict.fromkeys(gears.KINDS, 2e-9), "ratio": 4.0},
        "ours": {"missing": "no shifts"},
    }
}


def test_the_tables_say_orders_of_errors_ratios_and_what_is_not_offered() -> None:
    assert table.levers(ROWS).splitlines()[2:] == [
        "| ours | motion | 3e-16 | 0 | 2e-16 | not offered | 1.0 |",
        "| other | 10 steps a position | 1e-4 | 1e-4 | 1e-4 | 1e-4 | 120 |",
        "| other | 100 steps a position | no value | no value | no value | no value | 9.9 |",
        "| third |  | refused: cannot be assembled |  |  |  |  |",
    ]
    assert table.gears(GEARS).splitlines()[2:] == [
        "| plain | other, wheel | 2e-9 | 2e-9 | 2e-9 | 2e-9 | 4.0 |",
        "| plain | ours | not offered: no shifts |  |  |  |  |",
    ]


def test_the_stored_figures_are_errors_and_ratios_without_seconds() -> None:
    kept = table.figures(ROWS, {"other": 2.5}, GEARS)
    assert kept["ours, motion: position"] == 3e-16 and "ours, motion: moment" not in kept
    assert kept["other, 10 steps a position: time to ours"] == 123.4
    assert kept["other: cold start to ours"] == 2.5 and kept["plain, other, wheel: profile"] == 2e-9
    assert not any("second" in key for key in kept)


def test_the_page_names_the_command_the_machine_and_the_versions_that_were_there() -> None:
    said = page.text({"levers": "L", "cold": "C", "gears": "G"}, {"ours": "1", "kinepy": "0.1.7"}, 100)
    assert "python -m benchmarks.peers -o docs --store" in said and "kinepy 0.1.7" in said
    assert "**kinepy**" in said and "**mujoco**" not in said


@pytest.mark.exhaustive
def test_the_chart_is_small_and_the_same_every_time(tmp_path: Path) -> None:
    for name in ("one.svg", "two.svg"):
        chart.draw(ROWS, tmp_path / name)
    assert (tmp_path / "one.svg").read_bytes() == (tmp_path / "two.svg").read_bytes()
    assert (tmp_path / "one.svg").stat().st_size < 80_000


@pytest.mark.parametrize("name", gears.PAIRS)
def test_our_gears_are_the_exact_involute_to_rounding(name: str) -> None:
    judged = gears.errors(our_gears.both(gears.PAIRS[name]), gears.PAIRS[name])
    assert all(off is not None and off < 1e-14 for off in judged.values()), judged


def test_a_flank_that_is_moved_along_the_circle_is_off_by_as_much() -> None:
    pair = gears.PAIRS["with shifts"]
    points = our_gears.wheel(pair)["profile"]
    off = gears.errors({"profile": points * np.exp(1e-6j)}, pair)
    assert off["profile"] == pytest.approx(1e-6 * np.max(np.abs(points)) / pair.m, rel=1e-6)
    assert off["distance"] is None
