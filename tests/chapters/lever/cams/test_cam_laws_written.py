"""Laws and least sizes of a cam as the note writes them out: every piece of a graph, every shape, every case."""

import json
from pathlib import Path

import numpy as np
import pytest
from note import read
from notes import render
from reading import wrong
from test_against_results import wrong_cells, wrong_formulas

from tmm_report.chapters.cams.cam.quantities import demands, values
from tmm_report.chapters.cams.cam.solve.found import Cams
from tmm_report.course import solve
from tmm_report.loading import loads
from tmm_report.mechanics.cams.shapes import NAMED
from tmm_report.problems import ProblemError

TEXT = Path(__file__).parents[3].joinpath("cases/explain/graph_cam.yaml").read_text("utf-8")
SIZED = Path(__file__).parents[3].joinpath("statements/cam_from_pressure_angles.yaml").read_text("utf-8")
STARTS = (18, 42, 66, 72, 88, 102)  # deg of the law at position 0
GRAPH = TEXT[TEXT.index("        - rise:") : TEXT.index("        - {dwell: 40 deg}")]


def written(text):
    """Formulas and cells of a variant's note that are wrong, and how many laws it writes out."""
    results = solve(loads(text))
    note = read(render(results, "html")["note.html"].decode())
    document = json.loads(render(results, "json")["results.json"])
    wrong([*wrong_cells(note, document), *wrong_formulas(note, document)])
    return results.lever.cams.cams[0]


@pytest.mark.parametrize("start", STARTS)
def test_every_piece_of_a_graph(start):
    """Turned by its start, the law's first position comes into each of its pieces in turn."""
    found = written(TEXT.replace("      lift:", f"      start: -{start} deg\n      lift:"))
    assert found.samples and found.pieces


def test_the_starts_come_into_every_piece():
    numbers = set()
    for start in STARTS:
        found = solve(
            loads(TEXT.replace("      lift:", f"      start: -{start} deg\n      lift:"))
        ).lever.cams.cams[0]
        numbers |= {found.number_of(one) for one in found.samples if one.phase.kind == "rise"}
    assert numbers == set(range(len(found.pieces)))


@pytest.mark.parametrize("start", (20, 50))
def test_both_halves_of_a_parabolic_law_with_unequal_accelerations(start):
    """Of the rise of 100 deg the acceleration takes 100/2.8 = 35.7 deg."""
    found = written(SIZED.replace("      lift:", f"      start: {start} deg\n      lift:"))  # turns clockwise
    (share,) = (one.share for one in found.samples if one.phase.kind == "rise")
    assert share == pytest.approx(start / 100)


@pytest.mark.parametrize("law", NAMED)
def test_every_shape(law):
    text = TEXT.replace(GRAPH, f"        - {{rise: 110 deg, law: {law}}}\n")
    text = text.replace("law: parabolic, ratio: 1.8", f"law: {law}")
    assert [one.phase.law.name for one in written(text).samples] == [law, law]


SIZES = {
    "as stated": {},
    "in line": {"[-12 mm, 0]": "[0, 0]"},
    "on the other side": {"[-12 mm, 0]": "[9 mm, 0]"},
    "far aside, held by the dwells": {"[-12 mm, 0]": "[-80 mm, 0]"},
    "a return without a limit": {"      return_angle_limit: 45 deg\n": ""},
    "held by the return": {"return_angle_limit: 45": "return_angle_limit: 12"},
    "the best by both returns and dwells": {"return_angle_limit: 45": "return_angle_limit: 75"},
    "an edge": {"{at: B, radius: 21 mm}": "{at: B}"},
    "not rounded": {"      round: 1 mm\n": ""},
}


@pytest.mark.parametrize("case", SIZES)
def test_least_sizes(case):
    text = SIZED
    for old, new in SIZES[case].items():
        assert old in text
        text = text.replace(old, new)
    found = written(text)
    low, zone = found.pitch_base, found.cam.sized
    step = 1e-3 if "round" in text else 1e-9
    assert zone.at(found.offset).radius <= low * (1 + 1e-12) < zone.at(found.offset).radius + step
    assert found.rise.value <= found.cam.limit + 1e-7
    assert found.cam.back is None or found.back.value <= found.cam.back + 1e-7
    assert not found.exceeds and not found.exceeds_back


LEVER, FLAT = (
    Path(__file__).parents[3].joinpath(f"cases/explain/smallest_{name}_cam.yaml").read_text("utf-8")
    for name in ("lever", "flat")
)
LEVERS = {
    "as stated": {},
    "the other way round": {"zero: {angle: 0 deg}": "rotation: clockwise, zero: {angle: 0 deg}"},
    "held by the return": {"return_angle_limit: 60": "return_angle_limit: 35"},
    "the far side": {"swing: 20 deg": "swing: 8 deg", "B: 120 mm": "B: 150 mm"},
    "without a limit of the return": {"      return_angle_limit: 60 deg\n": ""},
}


@pytest.mark.parametrize("case", LEVERS)
def test_least_sizes_of_levers(case):
    text = LEVER
    for old, new in LEVERS[case].items():
        assert old in text
        text = text.replace(old, new)
    found = written(text)
    least = found.cam.sized.radius(found.cam.sized.lowest.least)
    assert least <= found.pitch_base * (1 + 1e-12) < least + 0.5e-3
    exact = solve(loads(text.replace("      round: 0.5 mm\n", ""))).lever.cams.cams[0]
    asked = {"rise": exact.cam.limit, "return": exact.cam.back}[exact.cam.sized.lowest.way]
    reached = {"rise": exact.rise, "return": exact.back}[exact.cam.sized.lowest.way].value
    assert reached == pytest.approx(asked, abs=1e-8)  # nowhere more than is permitted, and once as much
    assert not exact.exceeds and not exact.exceeds_back


def reach(found):
    """How far the contact goes along the face, m."""
    return next(one.value for one in values(Cams((found,))) if one.key == "cam_reach_k")


def test_least_size_under_a_face():
    found = written(FLAT)
    assert found.least.value == pytest.approx(8e-3, rel=1e-9)
    assert list(demands(found)) == ["return"]  # where it begins, at the end of a dwell
    assert reach(found) == pytest.approx(1.875 * 12e-3 / np.radians(90), rel=1e-9)  # the rise is the faster
    assert written(
        FLAT.replace("least_curvature: 8 mm", "least_curvature: 8 mm\n      round: 1 mm")
    ).cam.base == (pytest.approx(1e-3 * np.ceil(found.cam.base * 1e3)))


def test_a_base_under_a_face_may_be_smaller_than_its_curvature():
    """A harmonic over the whole turn: the profile is a circle, eccentric by half the lift."""
    harmonic = "        - {rise: 180 deg, law: cosine}\n        - {return: 180 deg, law: cosine}\n"
    text = FLAT.replace(FLAT[FLAT.index("        - {rise: 90") : FLAT.index("positions")], harmonic)
    found = written(text.replace("least_curvature: 8 mm", "least_curvature: 20 mm"))
    assert found.cam.base == pytest.approx(20e-3 - 12e-3 / 2, rel=1e-9)
    assert found.least.value == pytest.approx(20e-3, rel=1e-9)
    assert reach(found) == pytest.approx(12e-3 / 2, rel=1e-9)  # as far as the circle is eccentric


WRONG_SIZES = {
    "no curvature": (FLAT, "      least_curvature: 8 mm\n", "", "follows from the least radius of curvature"),
    "any base": (
        FLAT.replace("least_curvature: 8 mm", "least_curvature: 5 mm"),
        FLAT[FLAT.index("        - {rise: 90") : FLAT.index("positions")],
        "        - {rise: 180 deg, law: cosine}\n        - {return: 180 deg, law: cosine}\n",
        "any base circle keeps the curvature",
    ),
    "slanting face": (FLAT, "{at: B}", "{at: B, angle: 10 deg}", "slides across its face"),
    "curvature of a roller": (LEVER, "round: 0.5 mm", "least_curvature: 3 mm", "under a flat face"),
    "angles too small": (
        LEVER,
        "pressure_angle_limit: 40 deg",
        "pressure_angle_limit: 8 deg",
        "no place of the cam",
    ),
}


@pytest.mark.parametrize("slip", WRONG_SIZES)
def test_slips_of_sizes(slip):
    text, old, new, told = WRONG_SIZES[slip]
    assert old in text
    with pytest.raises(ProblemError) as caught:
        loads(text.replace(old, new))
    (problem,) = caught.value.problems
    assert told in problem.wrong.text % problem.wrong.values and problem.line


WRONG = {
    "round: 1 mm": ("base: smallest", "base: 60 mm", "only the smallest base circle is rounded"),
    "flat": ("roller: {at: B, radius: 21 mm}", "flat: {at: B}", "follows from the least radius of curvature"),
    "roller": ("radius: 21 mm", "radius: 90 mm", "is larger than the least radius of its centre"),
    "return": ("return_angle_limit: 45 deg", "return_angle_limit: 95 deg", "95 deg"),
    "ratio": ("law: cosine", "law: cosine, ratio: 2", "ratio belongs to the law parabolic"),
    "ramp": ("law: cosine", "law: trapezoid, ramp: 0.4", "0.4"),
    "two ways": ("law: cosine", "law: cosine, velocity: [0, 1, 0]", "a rise and a return have a law"),
    "one sign": ("law: cosine", "acceleration: [0, 1, 2, 0]", "both sides of zero"),
    "back": ("law: cosine", "velocity: [0, 2, -1, 0]", "turns back"),
    "mixed": ("law: cosine", "acceleration: [1, {constant: -1}]", "by ordinates or by pieces"),
    "no form": (
        "law: cosine",
        "acceleration: [{width: 1}, {constant: -1}]",
        "a piece of a graph has one form",
    ),
    "through zero": (
        "law: cosine",
        "acceleration: [{sine: [1, -1]}, {constant: -1}]",
        "does not pass through zero",
    ),
}


@pytest.mark.parametrize("slip", WRONG)
def test_slips(slip):
    old, new, told = WRONG[slip]
    assert old in SIZED
    with pytest.raises(ProblemError) as caught:
        loads(SIZED.replace(old, new))
    (problem,) = caught.value.problems
    assert told in problem.wrong.text % problem.wrong.values and problem.line
