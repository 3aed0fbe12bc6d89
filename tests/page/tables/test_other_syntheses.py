"""Linkages synthesised as in no ready variant: what is printed of them is in the results, curves are the columns."""

import json
from functools import cache

import numpy as np
import pytest
from curves import curves, is_graph
from exhaustive import many
from note import read, text_of
from notes import render
from pages import table_of
from printed import unit
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans
from test_arithmetic import wrong_results

from tmm_report import solve
from tmm_report.loading import loads

TEXTS = {
    "crank-rocker, free": "crank_rocker: {K: 1.1, swing: 40 deg, rocker: 300 mm, transmission: 30 deg}",
    "function": "function: {y: x^1.5, x: [1, 4], crank_from: 30 deg, crank_turn: 90 deg, rocker_from: 60 deg, "
    "rocker_turn: 90 deg, frame: 100 mm}",
    "slider-crank, free": "slider_crank: {stroke: 120 mm, K: 1.2}",
    "slider-crank by offset": "slider_crank: {stroke: 120 mm, K: 1.2, offset: 40 mm}",
    "slider-crank by ratios": "slider_crank: {stroke: 120 mm, ratio: 3, offset_ratio: 0.7}",
    "slider-crank in line": "slider_crank: {mean_speed: 0.8 m/s, speed: 120 rpm, pressure_angle: 12 deg}",
    "crank-rocker in step": "crank_rocker: {swing: 60 deg, rocker: 300 mm}",
    "crank-rocker below the permitted angle": "crank_rocker: {K: 1.1, swing: 32 deg, rocker: 0.6 m, crank: 0.15 m, "
    "transmission: 60 deg}",
    "shaper by crank": "slotted_link: {stroke: 400 mm, K: 1.5, crank: 130 mm, pressure_angle: 7 deg}",
    "Whitworth": "turning_guide: {stroke: 300 mm, K: 1.8, crank: 150 mm, rod_ratio: 4}",
    "a power": "function: {y: 1/x, x: [1, 2], crank_from: 40 deg, crank_turn: 60 deg, rocker_from: 100 deg, "
    "rocker_turn: 50 deg, frame: 1 m, spacing: ends}",
    "body": "body: {positions: [[0, 0, 0], [60 mm, 25 mm, 20 deg], [110 mm, 20 mm, 45 deg]], "
    "points: [[0, 0], [80 mm, 20 mm]]}",
    "two positions": "body: {positions: [[0, 0, 0], [90 mm, 40 mm, 50 deg]], points: [[0, 0], [80 mm, 20 mm]], "
    "crank: 70 mm}",
    "two positions, a stated rocker": "body: {positions: [[0, 0, 0], [90 mm, 40 mm, 50 deg]], "
    "points: [[0, 0], [80 mm, 20 mm]], crank: 70 mm, rocker: 120 mm}, round: 5 mm",
    "slider-crank of two cranks": "slider_crank: {stroke: 207 mm, ratio: 1.6, offset: 50 mm}",
    "crank-rocker, rounded": "crank_rocker: {K: 1.1, swing: 40 deg, rocker: 303 mm}, round: 5 mm",
    "function, rounded": "function: {y: x^1.5, x: [1, 4], crank_from: 30 deg, crank_turn: 90 deg, rocker_from: 60 deg, "
    "rocker_turn: 90 deg, frame: 100 mm}, round: 1 mm",
    "dwell": "dwell: {crank: 50 mm, coupler: 125 mm, rocker: 125 mm, frame: 100 mm, point: [125 mm, 125 mm], "
    "angles: [140 deg, 180 deg, 220 deg]}",
}
KEYS = {"γmax": "pressure", "μmin": "transmission", "μ": "transmission", "ψwant": "psi_wanted", "Δ": "error"}
LENGTHS = {"a": "crank", "b": "rod", "c": "rocker", "e": "offset", "d": "frame"}


@cache
def made(name: str):
    """The note and results.json."""
    found = solve(loads(f"language: en\nsynthesis: {{{TEXTS[name]}}}\n"))
    return read(render(found, "html")["note.html"].decode()), json.loads(
        render(found, "json")["results.json"]
    )


@pytest.mark.parametrize("name", many(TEXTS, 3))
def test_marked_numbers_are_those_of_the_results(name):
    note, document = made(name)
    assert len(note.marked) > 10
    wrong([*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_spans(note, document)])


@pytest.mark.parametrize("name", many(TEXTS, 3))
def test_every_printed_number_is_marked_and_every_formula_gives_what_it_prints(name):
    note, _ = made(name)
    wrong([*unmarked(note), *wrong_results(note)])
    text = "".join(note.root.itertext())
    assert "nan" not in text.split() and "None" not in text and "inf" not in text.split()


@pytest.mark.parametrize("name", ["crank-rocker, free", "function", "two positions"])
def test_curves_are_the_columns(name):
    note, document = made(name)
    table = table_of(document, "synthesis_course" if name == "function" else "synthesis_family")
    seen = set()
    for figure in note.root.iter("figure"):
        svg = note.drawings[figure.get("id") or ""]
        for curve in curves(svg) if is_graph(svg) else ():
            of = unit(curve.axis.unit)
            columns = [KEYS[curve.axis.letter]] if curve.axis.letter in KEYS else [*LENGTHS.values()]
            drawn = [key for key in columns if key in table and _same(curve, table, key, of)]
            assert len(drawn) == 1, (text_of(figure), curve.axis.letter)
            seen |= set(drawn)
    assert seen == set(table) - {"crank", "x", "off_B"}


def test_the_effect_of_rounding_goes_from_what_was_asked_to_what_is_taken():
    note, _ = made("crank-rocker, rounded")
    (told,) = [one for one in note.root.iter("p") if "becomes" in text_of(one)]
    marks = [one.get("data-q") for one in told.iter() if one.get("data-q")]
    assert marks[0::2] == ["synthesis_swing", "synthesis_K", "synthesis_transmission"]
    assert marks[1::2] == [f"{key}_taken" for key in marks[0::2]]


def _same(curve, table, key, of):
    """Whether a curve goes through the points of a column over the first one."""
    x = table[next(iter(table))]
    exists = np.isfinite(table[key])
    reach = (curve.turned[-1] - curve.turned[0]) / (x[exists][-1] - x[exists][0])
    at = curve.turned[0] + (x[exists] - x[exists][0]) * reach
    values = table[key][exists] / of.factor
    return bool(np.allclose(np.interp(at, curve.turned, curve.values), values, atol=1e-3 * np.ptp(values)))
