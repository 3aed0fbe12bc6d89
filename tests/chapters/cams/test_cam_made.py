"""How a cam is made: walls of a groove, path of the cutter, outline, drawing for CAD, the sheet, the proof."""

import json
import re

import numpy as np
import pytest
from notes import render

from tmm_report import course, load, loading
from tmm_report.chapters.cams.cam.draw import sheet
from tmm_report.figures.drawing import Circle
from tmm_report.problems import ProblemError

PHASES = (
    "phases: [{rise: 120 deg, law: sine}, {dwell: 40 deg}, {return: 110 deg, law: cosine}, {dwell: rest}]"
)
GROOVE = f"roller: 8 mm, base: 40 mm, lift: 18 mm, offset: 6 mm, closure: groove, cutter: 5 mm, {PHASES}"


def alone(cam: str) -> course.Results:
    return course.solve(loading.loads(f"language: en\ncam: {{{cam}}}"))


def tables(results: course.Results) -> dict:
    found = json.loads(render(results, "json")["results.json"])["tables"]
    return {
        name: {one["key"]: np.array(one["values"]) for one in table["columns"]}
        for name, table in found.items()
    }


def nearest(points: np.ndarray, curve: np.ndarray) -> np.ndarray:
    return np.abs(points[:, None] - curve).min(axis=1)


def test_the_walls_of_a_groove_are_a_rollers_diameter_apart_and_the_cutter_runs_along_both():
    results = alone(GROOVE)
    walls = tables(results)["cam_walls"]
    cam = results.cam.cams[0].cam
    fine = cam.profile(
        np.linspace(0, 2 * np.pi, 40001)
    )  # the second way: the distance from any point of the profile
    outer, cut, along = (
        walls[f"cam_x_{name}"] + 1j * walls[f"cam_y_{name}"] for name in ("outer", "cut", "cut_outer")
    )
    assert nearest(outer, fine) == pytest.approx(np.full(len(outer), 16e-3), abs=2e-8)
    assert nearest(cut, fine) == pytest.approx(np.full(len(cut), 5e-3), abs=2e-8)
    assert nearest(along, fine) == pytest.approx(np.full(len(along), 11e-3), abs=2e-8)
    assert np.abs(outer) == pytest.approx(walls["cam_R_outer"])


def test_a_cutter_of_the_rollers_size_runs_on_the_pitch_curve():
    walls = tables(alone(f"roller: 8 mm, base: 40 mm, lift: 18 mm, cutter: 8 mm, {PHASES}"))
    of = walls["cam_walls"], walls["cam_profile"]
    assert of[0]["cam_x_cut"] == pytest.approx(of[1]["cam_x_pitch"])
    assert of[0]["cam_y_cut"] == pytest.approx(of[1]["cam_y_pitch"]) and "cam_x_outer" not in of[0]


def test_the_outline_goes_degree_by_degree_through_the_table():
    found = tables(alone(GROOVE))
    outline, profile = found["cam_outline"], found["cam_profile"]
    assert outline["phi"] == pytest.approx(np.arange(361))
    assert outline["cam_x"][::30] == pytest.approx(profile["cam_x"], abs=1e-15)
    assert outline["cam_y"][::30] == pytest.approx(profile["cam_y"], abs=1e-15)


@pytest.mark.parametrize("follower", ["roller: 9 mm", "follower: knife", "follower: flat"])
def test_the_proof_by_reversed_motion(follower):
    (made,) = alone(f"{follower}, base: 60 mm, lift: 14 mm, {PHASES}").cam.made
    assert made.proof.value <= 1e-12
    assert 1e-8 < made.proof_as_printed.value < 3e-6  # coordinates are printed to the micrometre


def test_it_is_told_where_a_law_asks_for_a_profile_that_cannot_be():
    for follower in ("roller: 9 mm", "follower: flat", "follower: knife"):
        results = alone(f"{follower}, base: 40 mm, lift: 14 mm, {PHASES.replace('sine}', 'uniform}', 1)}")
        (made,) = results.cam.made
        cut, note = follower != "follower: knife", render(results, "html")["note.html"].decode()
        assert (made.proof.value > 1e-6) == cut, (follower, made.proof.value)
        assert ("cut by another part of itself" in note) == cut and (
            "no part of it is undercut" in note
        ) != cut


# --- for CAD


def read(dxf: bytes) -> dict[str, list]:
    """Layer -> closed polylines as points, circles as radii, mm."""
    lines = dxf.decode("ascii").split("\r\n")
    pairs = list(zip(map(str.strip, lines[::2]), lines[1::2], strict=False))
    found: dict[str, list] = {}
    x, points, layer, kind = 0.0, [], "", ""
    for code, value in pairs:
        if code == "0":
            if value == "SEQEND":
                found.setdefault(layer, []).append(np.array(points))
            kind, points = value, ([] if value == "POLYLINE" else points)
        elif code == "8":
            layer = value
        elif code == "10":
            x = float(value)
        elif code == "20" and kind == "VERTEX":
            points.append(complex(x, float(value)))
        elif code == "40" and kind == "CIRCLE":
            found.setdefault(layer, []).append(float(value))
    return found


def test_the_drawing_for_cad_holds_every_curve_in_millimetres():
    results = alone(GROOVE)
    files = render(results, "dxf")
    assert list(files) == ["cam.dxf"]
    text = files["cam.dxf"].decode("ascii")
    assert "$ACADVER\r\n1\r\nAC1009" in text and text.endswith("0\r\nEOF\r\n")
    assert len(re.findall(r"\r\n0\r\nPOLYLINE\r\n", text)) == 5 and "70\r\n1\r\n0\r\nVERTEX" in text
    layers = read(files["cam.dxf"])
    assert set(layers) == {"PROFILE", "BASE", "PITCH", "OUTER_WALL", "CUTTER", "CUTTER_OUTER"}
    (profile,), cam = layers["PROFILE"], results.cam.cams[0].cam
    assert layers["BASE"] == [40.0]
    assert nearest(profile / 1e3, cam.profile(np.linspace(0, 2 * np.pi, 7201))).max() < 5e-8
    area = abs(np.imag(np.conj(profile) * np.roll(profile, -1)).sum()) / 2
    gamma = np.linspace(0, 2 * np.pi, 100001)
    curve = cam.profile(gamma) * 1e3
    assert area == pytest.approx(abs(np.imag(np.conj(curve[:-1]) * np.diff(curve)).sum()) / 2, rel=2e-5)


def test_cam_pairs_of_a_mechanism_are_drawn_too_and_without_a_cam_it_is_told():
    assert list(render(course.solve(load("variants/cam_press.yaml")), "dxf")) == ["cam_k.dxf"]
    with pytest.raises(ProblemError, match="cam"):
        render(course.solve(load("variants/rotor.yaml")), "dxf")


# --- the sheet


@pytest.mark.parametrize(("count", "drawn"), [(12, 12), (24, 24), (36, 36), (72, 36)])
def test_the_sheet_has_every_numbered_position(count, drawn):
    """Rollers about the profile, each of which it touches: no point of it lies nearer to their centres."""
    (made,) = alone(f"roller: 8 mm, base: 40 mm, lift: 18 mm, positions: {count}, {PHASES}").cam.made
    mu = sheet.scale(made)
    rollers = [
        item
        for item in sheet.drawing(made, mu).items
        if isinstance(item, Circle) and abs(item.radius * mu - 8e-3) < 1e-9
    ]
    assert len(rollers) == drawn
    profile = made.found.cam.profile(np.linspace(0, 2 * np.pi, 20001)) / mu
    away = nearest(np.array([one.centre for one in rollers]), profile)
    assert away * mu == pytest.approx(np.full(drawn, 8e-3), abs=1e-7)


def test_the_pivots_of_a_swinging_follower_go_round_on_their_circle():
    (made,) = alone(
        f"roller: 8 mm, base: 40 mm, swing: 15 deg, arm: 120 mm, centre_distance: 130 mm, side: with, {PHASES}"
    ).cam.made
    at = sheet.Reversed(made.found, 1e-3)
    assert np.abs(at.root) == pytest.approx(np.full(12, 130.0))
    turned = np.diff(np.unwrap(np.angle(at.root)))
    assert turned == pytest.approx(
        np.full(11, -np.radians(30))
    )  # against the cam, which turns counter-clockwise
    assert np.abs(at.end - at.root) == pytest.approx(np.full(12, 120.0))


BAD = [
    (f"follower: knife, base: 40 mm, lift: 20 mm, closure: groove, {PHASES}", "cam.closure", "holds a roller"),
    (f"roller: 5 mm, base: 40 mm, lift: 20 mm, closure: groove, cutter: 6 mm, {PHASES}",
     "cam.cutter", "does not enter"),
    ("roller: 20 mm, base: 20 mm, lift: 40 mm, closure: groove, phases: [{rise: 60 deg, law: cosine}, {dwell: 60 deg}, "
     "{return: 180 deg, law: cosine}, {dwell: rest}]", "cam.closure", "outer wall"),
    ("roller: 12 mm, base: 30 mm, lift: 30 mm, cutter: 80 mm, phases: [{rise: 60 deg, law: cosine}, {dwell: 60 deg}, "
     "{return: 180 deg, law: cosine}, {dwell: rest}]", "cam.cutter", "hollow"),
]  # fmt: skip


@pytest.mark.parametrize(("cam", "path", "words"), BAD)
def test_what_cannot_be_made_is_told(cam, path, words):
    with pytest.raises(ProblemError) as raised:
        loading.loads(f"cam: {{{cam}}}")
    told = [(".".join(map(str, p.path)), p.wrong.text % p.wrong.values) for p in raised.value.problems]
    assert any(where == path and words in text for where, text in told), told
