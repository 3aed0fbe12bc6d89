"""Diagrams in parts of a greatest value, p/p_max against s/H, and one curve for several cylinders."""

import json

import pytest
import yaml

from tmm_report import course, loading
from tmm_report.problems import ProblemError

TEXT = """
mechanism:
  frame: {O: [0, 0]}
  guides: {y: {through: O, angle: 90 deg}, z: {through: O, angle: 30 deg}}
  links:
    1: {points: {O: [0, 0], A: [50 mm, 0]}}
    2: {points: {A: [0, 0], B: [200 mm, 0]}}
    3: {points: {B: [0, 0]}, slides: y}
    4: {points: {A: [0, 0], D: [200 mm, 0]}}
    5: {points: {D: [0, 0]}, slides: z}
  driver: {link: 1, speed: 100 rad/s}
  assembly: {B: up, D: up}
loads:
CURVES
  forces:
    - {at: B, direction: down, piston_diameter: 80 mm, by_displacement: FIRST}
    - {at: D, direction: 210 deg, piston_diameter: 60 mm, by_displacement: SECOND}
"""
CURVE = "forward: [[0, 0.02], [0.4, 0.2], [1, 1]], back: [[0, 0], [0.3, 0], [1, 1]]"
CURVES = f"  curves: {{gas: {{{CURVE}}}}}"
FORWARD, BACK = "[[0, {0} MPa], [0.4, {1} MPa], [1, {2} MPa]]", "[[0, 0], [0.3, 0], [1, {2} MPa]]"
SPELLED = f"{{{{zero: down, forward: {FORWARD}, back: {BACK}}}}}"
OTHER = "{zero: down, forward: [[0, 0], [1, 0]], back: [[0, 0], [1, 0]]}"


def loaded(first, second=OTHER, curves=""):
    text = (
        TEXT.replace("FIRST", first)
        .replace("SECOND", second)
        .replace("CURVES\n", curves + "\n" if curves else "")
    )
    return course.solve(loading.loads(text)).lever.kinetostatics


def test_in_parts_of_the_greatest_they_are_the_values():
    spelled = loaded(SPELLED.format(0.06, 0.6, 3.0))
    parts = loaded(f"{{zero: down, of: 3 MPa, {CURVE}}}")
    assert parts.table.balancing == pytest.approx(spelled.table.balancing, rel=1e-12, abs=1e-9)
    assert abs(parts.table.balancing).max() > 10


def test_the_way_back_may_be_stated_as_the_point_goes():
    """From the far end to the zero, a jump among it."""
    ascending = loaded(
        "{zero: down, of: 3 MPa, forward: [[0, 0], [1, 1]], back: [[0, 0], [0.4, 0.2], [0.4, 0.6], [1, 1]]}"
    )
    back = loaded(
        "{zero: down, of: 3 MPa, forward: [[0, 0], [1, 1]], back: [[1, 1], [0.4, 0.6], [0.4, 0.2], [0, 0]]}"
    )
    assert back.table.balancing == pytest.approx(ascending.table.balancing, rel=1e-15)
    with pytest.raises(ProblemError) as caught:
        loaded(
            "{zero: down, of: 3 MPa, forward: [[0, 0], [1, 1]], back: [[1, 1], [0.2, 0.6], [0.4, 0.2], [0, 0]]}"
        )
    (told,) = caught.value.problems
    assert told.key.endswith("back") and "from the least to the greatest" in told.text()


def test_a_curve_with_a_mistake_is_told_once():
    with pytest.raises(ProblemError) as caught:
        loaded(
            "{zero: down, curve: gas, of: 3 MPa}",
            curves="  curves: {gas: {forward: [[0, a], [1, 1]], back: [[0, 0], [1, 1]]}}",
        )
    assert [one.key for one in caught.value.problems] == ["loads.curves.gas.forward.0.1"]


def test_one_curve_for_two_cylinders():
    shared = "{{zero: down, curve: gas, of: {0} MPa}}"
    spelled = loaded(SPELLED.format(0.06, 0.6, 3.0), SPELLED.format(0.04, 0.4, 2.0))
    found = loaded(shared.format(3), shared.format(2), CURVES)
    assert found.table.balancing == pytest.approx(spelled.table.balancing, rel=1e-12, abs=1e-9)
    assert [end.value for end in found.extremes] == pytest.approx([end.value for end in spelled.extremes])


STROKES = {
    "intake": "[[0, 0.02], [1, 0.02]]",
    "compression": "[[0, 0.9], [0.4, 0.2], [1, 0.02]]",
    "power": "[[0, 1], [0.3, 0.4], [1, 0.1]]",
    "exhaust": "[[0, 0.03], [1, 0.1]]",
}


def test_strokes_of_one_curve_for_two_cylinders():
    """Four strokes in parts of the greatest pressure, each cylinder at its own of them: the values spelled out."""
    text = TEXT.replace("speed: 100 rad/s}", "speed: 100 rad/s, zero: {point: B, extreme: up}, turns: 2}")
    strokes = "{" + ", ".join(f"{name}: {curve}" for name, curve in STROKES.items()) + "}"
    curve = f"  curves: {{gas: {{strokes: {strokes}}}}}\n"
    firsts = (("power", 4.0), ("intake", 3.0))
    shared = [f"{{zero: up, curve: gas, of: {size} MPa, first: {first}}}" for first, size in firsts]
    inline = [f"{{zero: up, of: {size} MPa, first: {first}, strokes: {strokes}}}" for first, size in firsts]
    found = []
    for (first, second), curves in ((shared, curve), (inline, ""), (map(_spelled, firsts), "")):
        own = text.replace("FIRST", first).replace("SECOND", second).replace("CURVES\n", curves)
        found.append(course.solve(loading.loads(own)).lever.kinetostatics.table.balancing)
    assert found[0] == pytest.approx(found[2], rel=1e-12, abs=1e-9)
    assert found[1] == pytest.approx(found[2], rel=1e-12, abs=1e-9)
    assert abs(found[2]).max() > 100


def _spelled(of):
    first, size = of
    curves = {
        name: [[x, f"{y * size!r} MPa"] for x, y in yaml.safe_load(curve)] for name, curve in STROKES.items()
    }
    return json.dumps({"zero": "up", "first": first, "strokes": curves})


def test_a_moment_by_a_curve():
    text = TEXT.replace("CURVES\n", CURVES + "\n").split("  forces:")[0]
    text = text.replace("3: {points: {B: [0, 0]}, slides: y}", "3: {points: {C: [0, 0], B: [150 mm, 0]}}")
    text = text.replace("frame: {O: [0, 0]}", "frame: {O: [0, 0], C: [200 mm, 0]}").replace(
        "B: up", "B: left of A-C"
    )
    moment = "  moments: [{on: 3, direction: clockwise, by_displacement: DIAGRAM}]\n"
    shared = loading.loads(text + moment.replace("DIAGRAM", "{zero: clockwise, curve: gas, of: 40 N*m}"))
    values = "{zero: clockwise, forward: [[0, 0.8], [0.4, 8], [1, 40]], back: [[0, 0], [0.3, 0], [1, 40]]}"
    spelled = loading.loads(text.replace(CURVES + "\n", "") + moment.replace("DIAGRAM", values))
    one, other = (course.solve(variant).lever.kinetostatics.table.balancing for variant in (shared, spelled))
    assert one == pytest.approx(other, rel=1e-12, abs=1e-9)


TWO = "  curves: {gas: {strokes: {a: [[0, 1], [1, 0]], b: [[0, 1], [1, 0]]}}}"
SLIPS = {
    ("{zero: down, curve: gaz, of: 3 MPa}", CURVES): (
        "loads.forces.0.by_displacement.curve",
        "there is no curve gaz",
    ),
    (OTHER, CURVES): ("loads.curves.gas", "no load has the curve gas"),
    ("{zero: down, curve: gas, of: 3 MPa}", CURVES.replace("[1, 1]", "[1, 3]")): (
        "loads.curves.gas.forward",
        "parts of the greatest one, at most 1",
    ),
    (f"{{zero: down, of: 3 MPa, {CURVE.replace('[1, 1]', '[1, 3 MPa]')}}}", ""): (
        "loads.forces.0.by_displacement",
        "parts of the greatest one",
    ),
    ("{zero: down, curve: gas, of: 3 MPa, first: power}", CURVES): (
        "loads.forces.0.by_displacement.first",
        "the curve gas has two ways and no strokes",
    ),
    ("{zero: down, curve: gas, of: 3 MPa}", "  curves: {gas: {strokes: {one: [[0, 1], [1, 0]]}}}"): (
        "loads.curves.gas.strokes",
        "1 strokes are stated, the cycle has 2",
    ),
    (
        "{zero: down, curve: gas, of: 3 MPa}",
        TWO.replace("[0, 1]", "[0, 2]", 1),
    ): (
        "loads.curves.gas.strokes.a",
        "parts of the greatest one, at most 1",
    ),
    (
        "{zero: down, curve: gas, of: 3 MPa, first: x}",
        TWO,
    ): (
        "loads.forces.0.by_displacement.first",
        "there is no stroke x",
    ),
    ("{zero: down, curve: gas}", CURVES): ("loads.forces.0.by_displacement.of", ""),
    ("{zero: down, curve: gas, of: 3 N}", CURVES): ("loads.forces.0.by_displacement.of", "a pressure"),
}


@pytest.mark.parametrize("slip", SLIPS)
def test_slips(slip):
    key, words = SLIPS[slip]
    with pytest.raises(ProblemError) as caught:
        loaded(slip[0], OTHER, slip[1])
    told = {problem.key: problem.text() for problem in caught.value.problems}
    assert key in told and words in told[key], told
