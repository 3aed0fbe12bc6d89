"""Lengths stated by other lengths: `S2: 0.4*l_AB`, `B: 0.25*l_OC`, sides of a triangle."""

import cmath
import json
import math

import pytest
from note import read
from notes import render
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans
from test_arithmetic import wrong_results

from tmm_report import solve, stack
from tmm_report.loading import loads
from tmm_report.problems import ProblemError

TEXT = """language: {language}
mechanism:
  frame: {{O: [0, 0], C: [200 mm, 20 mm]}}
  links:
    1: {{points: {{O: 0, A: {crank}}}}}
    2: {{points: {{A: 0, B: {rod}, S2: {centre}, E: {corner}}}, mass: 2 kg, mass_centre: S2, inertia: 0.01}}
    3: {{points: {{C: 0, B: {rocker}}}, mass: 1 kg, inertia: m*l^2/12}}
  driver: {{link: 1, speed: 180 rpm}}
  assembly: {{B: left of A-C}}
loads: {{gravity: 9.81 m/s^2, moments: [{{on: 3, direction: against motion, constant: 25 N*m}}]}}
"""
STATED = {
    "crank": "60 mm",
    "rod": "3*l1",
    "centre": "0.4*l_AB",
    "corner": "{from: {A: 0.6*l_AB, B: l_OA}, side: left}",
    "rocker": "2/3*l_AB",
}
NUMBERS = {
    "crank": "60 mm",
    "rod": "180 mm",
    "centre": "72 mm",
    "corner": "{from: {A: 108 mm, B: 60 mm}, side: left}",
    "rocker": "120 mm",
}
CORNER = "{from: {A: 0.6*l_AB, B: 0.6*l_AB}, side: left}"


def text(language: str = "en", **other: str) -> str:
    return TEXT.format(language=language, **STATED | {"corner": CORNER} | other)


def points(variant: str, link: str) -> dict[str, complex]:
    return dict(loads(variant).lever.mechanism.links[link].points)


GUIDED = """language: en
mechanism:
  frame: {{O: [0, 0], P: [-20 mm, 12 mm]}}
  guides: {{x: {{through: {through}, angle: 5 deg}}}}
  links:
    1: {{points: {{O: 0, A: 60 mm}}}}
    2: {{points: {{A: 0, B: 200 mm}}}}
    3: {{points: [B], slides: x}}
  driver: {{link: 1, speed: 180 rpm}}
  assembly: {{B: right}}
"""


@pytest.mark.parametrize("through", ["[-20 mm, 12 mm]", "[-0.02, 12 mm]", "[−20 mm, 0.012]", "[-2cm, 12mm]"])
def test_a_guide_through_a_place(through):
    """As through the point there."""
    place, point = (loads(GUIDED.format(through=one)).lever.mechanism.guides["x"] for one in (through, "P"))
    assert (place.through, place.direction) == (pytest.approx(point.through), point.direction)


NO_PLACES = {
    "[0, 12 kg]": "through.1: 12 kg is a mass (kg); expected: a length (m)",
    "[O, 12 mm]": "through.0: O is not a number; expected: a length (m)",
    "[1 mm]": "through: a value of the list is missing",
    "[0, 12]": "the point 12 is not on link 0",
    "{O: 1}": "a point, two: [P, Q], or the coordinates of one: [12 mm, 0]",
}


@pytest.mark.parametrize("through", NO_PLACES)
def test_what_is_no_place_of_a_guide(through):
    with pytest.raises(ProblemError) as told:
        loads(GUIDED.format(through=through))
    assert NO_PLACES[through] in str(told.value)


def test_lengths_are_those_that_they_come_to():
    variant = text(corner="{from: {A: 0.6*l_AB, B: l_OA + 40/60*l_OA}, side: left}")
    assert points(variant, "2")["B"] == pytest.approx(0.18, rel=1e-15)
    assert points(variant, "2")["S2"] == pytest.approx(0.072, rel=1e-15)
    assert points(variant, "3")["B"] == pytest.approx(0.12, rel=1e-15)
    corner = points(variant, "2")["E"]
    assert abs(corner) == pytest.approx(0.108, rel=1e-12) and abs(corner - 0.18) == pytest.approx(
        0.1, rel=1e-12
    )
    assert corner.imag > 0
    elsewhere = text(rocker="l_OC/2").replace("O: [0, 0]", "O: [50 mm, 10 mm]")
    assert points(elsewhere, "3")["B"] == pytest.approx(math.hypot(0.15, 0.01) / 2, rel=1e-14)


def test_a_link_may_follow_from_one_that_stands_after_it():
    variant = text(crank="l3/2", rod="3/2*l_CB", rocker="120 mm")
    assert points(variant, "1")["A"] == pytest.approx(0.06, rel=1e-15)
    assert points(variant, "2")["B"] == pytest.approx(0.18, rel=1e-15)


def test_the_results_are_those_of_the_numbers():
    both = [
        solve(loads(text(**one))) for one in ({}, NUMBERS | {"corner": CORNER.replace("0.6*l_AB", "108 mm")})
    ]
    stated, plain = (json.loads(render(found, "json")["results.json"])["tables"] for found in both)
    assert list(stated) == list(plain)
    for name, table in plain.items():
        for own, other in zip(stated[name]["columns"], table["columns"], strict=True):
            same = [
                x if isinstance(x, str) or x is None else pytest.approx(x, rel=1e-9, abs=1e-9)
                for x in other["values"]
            ]
            assert own["values"] == same, f"{name}.{other['key']}"


@pytest.mark.parametrize("language", ["en", "ru"])
def test_the_note_works_them_out(language):
    found = solve(loads(text(language, rocker="0.6*l_OC")))
    note = read(render(found, "html")["note.html"].decode())
    document = json.loads(render(found, "json")["results.json"])
    wrong([*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_spans(note, document)])
    wrong([*unmarked(note), *wrong_results(note)])
    plain = render(found, "tex")["note.tex"].decode()
    for formula in ("l_{AB}=3l_{OA}", "l_{CB}=0", "l_{AS2}=0"):
        assert formula in plain
    assert list(document["tables"]["stated_lengths"]["columns"][0]["values"]) == ["l_OC"]


def test_variants_of_one_mechanism_are_solved_together_as_alone():
    variants = [loads(text(crank=f"{mm} mm")) for mm in (55, 60, 50)]
    for variant, together in zip(variants, stack.solve_many(variants), strict=True):
        assert render(together, "json") == render(solve(variant), "json")


MISTAKES = [
    ("rod", "3*l_XY", 6, "no link has two points whose names make XY", "give its place above"),
    ("rod", "3*l", 6, "it must be said from which", "0.4*l_AB"),
    ("rod", "3*l1^2", 6, "is no length: its letters multiply", "0.4*l_AB"),
    ("rod", "3*m1", 6, "a length follows from lengths alone", "0.4*l_AB"),
    ("rod", "l1/0", 6, "this comes to inf m", ""),
    ("centre", "0.4*l_BE", 6, "no link has two points whose names make BE", "l_AB"),
    ("centre", "0.4*l_AX", 6, "no link has two points whose names make AX", "l_AB"),
    ("crank", "l_OA", 5, "no link has two points whose names make OA", "give its place above"),
    ("rocker", "l2", 7, "link 2 has several lengths", "l_AB"),
    ("rocker", "0.25*l_BC", 7, "no link has two points whose names make BC", "give its place above"),
    ("corner", "{from: {A: 0.1*l_AB, B: 0.1*l_AB}, side: left}", 6, "the triangle does not close", "shorter"),
]


@pytest.mark.parametrize(("key", "written", "line", "what", "cure"), MISTAKES)
def test_a_mistake_is_told_where_it_stands(key, written, line, what, cure):
    with pytest.raises(ProblemError) as told:
        loads(text(**{key: written}))
    (problem,) = told.value.problems
    assert what in str(problem.wrong) and cure in str(problem.right or "") and problem.line == line


def test_lengths_in_a_circle_are_told_once():
    with pytest.raises(ProblemError) as told:
        loads(text(crank="l3/2", rod="180 mm", rocker="2*l1"))
    (problem,) = told.value.problems
    assert "the lengths of links 1, 3 are stated by one another" in str(problem.wrong) and problem.line == 5


def test_what_rests_on_a_broken_length_is_not_told_again():
    with pytest.raises(ProblemError) as told:
        loads(text(crank="2*l_XY"))
    (problem,) = told.value.problems
    assert "XY" in str(problem.wrong) and problem.line == 5


CORNERS = {
    "{distance: 50 mm, angle: 30 deg}": 0.05 * cmath.exp(1j * math.pi / 6),
    "{about: B, distance: 0.25*l_AB, angle: -90 deg}": 0.18 - 0.045j,
    "{about: B, to: A, distance: 0.5*l_AB, angle: 150 deg}": 0.18 + 0.09 * cmath.exp(-1j * math.pi / 6),
    "{about: S2, to: B, distance: 10 mm, angle: 90 deg}": 0.072 + 0.01j,
}


@pytest.mark.parametrize("corner", CORNERS)
def test_a_point_by_a_distance_and_an_angle(corner):
    """From the link's first point or another one; the angle from its x axis or from the way to another point."""
    text = TEXT.format(language="en", **STATED | {"corner": corner})
    assert loads(text).lever.mechanism.links["2"].points["E"] == pytest.approx(CORNERS[corner], abs=1e-15)


@pytest.mark.parametrize(
    ("corner", "said", "key"),
    [
        ("{distance: 50 mm}", "the key angle is missing", "E.angle"),
        ("{angle: 20 deg}", "the key distance is missing", "E.distance"),
        ("{about: Q, distance: 5 mm, angle: 0}", "point Q is not placed on this link before", "E"),
        ("{about: B, to: B, distance: 5 mm, angle: 0}", "from one point to another", "E"),
        ("{distance: -5 mm, angle: 0}", "", "E.distance"),
        ("{distance: 5 mm, angle: 5 mm}", "is a length", "E.angle"),
    ],
)
def test_a_corner_that_is_wrong_is_said_with_its_key(corner, said, key):
    with pytest.raises(ProblemError) as error:
        loads(TEXT.format(language="en", **STATED | {"corner": corner}))
    (problem,) = error.value.problems
    assert said in problem.text()
    assert problem.key.endswith(f"points.{key}")
