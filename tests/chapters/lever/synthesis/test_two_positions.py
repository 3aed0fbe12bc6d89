"""A linkage by two positions of its rocker or slider: what the analysis makes of it, pages, slips."""

import json
import math

import pytest
from catalogues import LATIN_UNIT
from note import read
from notes import render
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas
from test_arithmetic import wrong_results

from tmm_report import course, loading
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError

RUSSIAN = Translator("ru").gettext
DEMANDS = {
    "extremes of a rocker": "rocker_positions: {rocker: 300 mm, angles: [60 deg, 100 deg], frame: 400 mm}",
    "free frame": "rocker_positions: {rocker: 300 mm, angles: [60 deg, 100 deg], transmission: 30 deg}",
    "rocker and crank": "rocker_positions: {frame: 400 mm, angles: [60 deg, 100 deg], crank_angles: [30 deg, 110 deg]}",
    "double rocker": "rocker_positions: {frame: 400 mm, rocker: 600 mm, angles: [60 deg, 100 deg], "
    "crank_angles: [30 deg, 110 deg]}",
    "extremes of a slider": "slider_positions: {places: [150 mm, 270 mm], offset: 30 mm}",
    "in line": "slider_positions: {places: [270 mm, 150 mm], pressure_angle: 20 deg}",
    "slider and crank": "slider_positions: {places: [270 mm, 190 mm], crank_angles: [20 deg, 90 deg]}",
}
ROCKER = """
mechanism:
  frame: {O: [0, 0], C: [synthesis.frame, 0]}
  links:
    1: {points: {O: 0, A: synthesis.crank}}
    2: {points: {A: 0, B: synthesis.rod}}
    3: {points: {C: 0, B: synthesis.rocker}}
  driver: {link: 1, speed: 60 rpm}
  assembly: {B: left of A-C}
"""
SLIDER = """
mechanism:
  frame: {O: [0, 0], P: [0, -30 mm]}
  guides: {x: {through: P, angle: 0 deg}}
  links: {1: {points: {O: 0, A: synthesis.crank}}, 2: {points: {A: 0, B: synthesis.rod}}, 3: {points: [B], slides: x}}
  driver: {link: 1, speed: 60 rpm}
  assembly: {B: right}
"""


def found(demand, more="", language="en"):
    return course.solve(loading.loads(f"language: {language}\nsynthesis: {{{demand}}}\n{more}"))


@pytest.mark.parametrize("name", DEMANDS, ids=lambda name: name.replace(" ", "_"))
@pytest.mark.parametrize("language", ["en", "ru"])
def test_every_printed_number_is_that_of_the_results(name, language):
    results = found(DEMANDS[name], language=language)
    note = read(render(results, "html", language)["note.html"].decode())
    document = json.loads(render(results, "json")["results.json"])
    wrong(
        [*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_results(note), *unmarked(note)]
    )
    assert render(results, "tex", language)["note.tex"]


def test_the_analysed_rocker_has_its_extreme_positions():
    s = found(DEMANDS["extremes of a rocker"], ROCKER).synthesis.s
    assert s.number("swing_met") == pytest.approx(math.radians(40), rel=1e-9)
    assert s.number("K_met") == pytest.approx(s.number("K"), rel=1e-8)
    assert s.number("transmission_met") == pytest.approx(s.number("transmission"), rel=1e-8)


def test_the_analysed_slider_has_its_extreme_places():
    s = found(DEMANDS["extremes of a slider"], SLIDER).synthesis.s
    assert s.number("stroke_met") == pytest.approx(0.12, rel=1e-9)
    assert s.number("K_met") == pytest.approx(s.number("K"), rel=1e-8)
    assert s.number("pressure_met") == pytest.approx(s.number("pressure"), rel=1e-8)


def test_positions_on_the_way_are_no_stroke():
    s = found(DEMANDS["rocker and crank"], ROCKER).synthesis.s
    assert "swing_met" not in s and "K_met" not in s


def test_the_kind_of_linkage_is_said():
    said = {
        "double rocker": "a double rocker",
        "rocker and crank": "is a crank-rocker: its crank turns round",
    }
    for name, words in said.items():
        s = found(DEMANDS[name]).synthesis.s
        a, b, c, d = (s.number(key) for key in ("crank", "rod", "rocker", "frame"))
        html = render(found(DEMANDS[name]), "html", "en")["note.html"].decode()
        sides = sorted((a, b, c, d))
        turns = a == sides[0] and sides[0] + sides[3] <= sides[1] + sides[2]
        assert (words in html) and turns == (name == "rocker and crank")


@pytest.mark.parametrize(
    ("demand", "key", "words"),
    [
        ("rocker_positions: {rocker: 0.3, angles: [-60 deg, 100 deg]}", "rocker_positions.angles", "on both sides"),
        ("rocker_positions: {angles: [60 deg, 100 deg]}", "rocker_positions.rocker", "the key rocker is missing"),
        ("rocker_positions: {rocker: 0.3, angles: [60 deg, 100 deg], crank_angles: [0, 1]}", "rocker_positions.frame",
         "the key frame is missing"),
        ("rocker_positions: {rocker: 0.3, angles: [60 deg, 60 deg]}", "rocker_positions.angles",
         "both positions are one"),
        ("rocker_positions: {frame: 0.3, angles: [60 deg, 100 deg], crank_angles: [110 deg, 30 deg]}",
         "rocker_positions.crank_angles", "links do not meet"),
        ("slider_positions: {places: [-0.1, 0.2]}", "slider_positions.places", "on both sides"),
        ("slider_positions: {places: [0.1, 0.2], offset: -10 mm}", "slider_positions.offset", "not below zero"),
        ("slider_positions: {places: [0.1, 0.2], pressure_angle: 10 deg}", "slider_positions.pressure_angle",
         "comes to"),
        ("slider_positions: {places: [0.2, 0.1], crank_angles: [90 deg, 20 deg], offset: 0}",
         "slider_positions.crank_angles", "no crank turns by these angles"),
    ],
)  # fmt: skip
def test_slips_and_what_no_linkage_does(demand, key, words):
    with pytest.raises(ProblemError) as caught:
        found(demand)
    (problem,) = caught.value.problems
    assert problem.key == f"synthesis.{key}" and words in problem.text() and problem.right is not None
    assert not LATIN_UNIT.search(problem.sentence(RUSSIAN))


@pytest.mark.parametrize(
    ("name", "key"),
    [("extremes of a rocker", "swing_taken"), ("rocker and crank", "misfit"), ("slider and crank", "misfit")],
)
def test_rounding_is_told(name, key):
    s = course.solve(
        loading.loads(f"language: en\nsynthesis: {{{DEMANDS[name]}, round: 1 mm}}\n")
    ).synthesis.s
    assert key in s and (s.number(key) < 1e-3 or key == "swing_taken")
