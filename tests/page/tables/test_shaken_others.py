"""Mechanisms balanced as no ready variant is: what is printed of them stands in the results, as of the ready ones."""

import json
import re
from functools import cache

import pytest
from exhaustive import many
from note import read
from notes import VARIANTS, render
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans
from test_arithmetic import wrong_results

from tmm_report import course, loading

AT = "{distance: 50 mm}"
ALL = "methods: [full, pivoted, substituted, optimum, rotors], rotors: {first: 50 mm, second: 40 mm}"
STATES = {
    "guides alone on the way to the frame": ("piston_pump", f"{ALL}, counterweights: {{1: {AT}, 3: {AT}}}"),
    "two turns in a cycle": (
        "engine_four_stroke",
        f"{ALL}, counterweights: {{1: {AT}, 2: {AT}, 4: {AT}}}, highest: 3",
    ),
    "another point, counterweights there": (
        "crank_rocker",
        "methods: [substituted, rotors], counterweights: {1: {mass: 2 kg}, 3: {distance: 5 cm}}, about: C, "
        "rotors: {first: 5 cm, second: 4 cm}, stated: {3: {mass: 3 kg, distance: 6 cm, angle: 170 deg}}",
    ),
    "against the moment, rotors of order 3": (
        "crank_rocker",
        f"methods: [full, rotors, inertia, couples], counterweights: {{2: {AT}, 3: {AT}}}, after: full, "
        "rotors: {first: 5 cm, 3: 3 cm}, wheels: {3: -2}, couples: {1: {radius: 5 cm, distance: 20 cm}, "
        "2: {radius: 4 cm, distance: 20 cm}}",
    ),
    "against the moment, nothing to gear": (
        "slider_crank_offset",
        "methods: [rotors, inertia, couples], after: none, rotors: {2: 4 cm, 3: 3 cm, 4: 2 cm, 6: 1 cm}, "
        "couples: {2: {radius: 5 cm, distance: 20 cm}}",
    ),
    "a rocker that turns right round": (
        "whitworth",
        f"methods: [pivoted], counterweights: {{1: {AT}, 3: {AT}}}",
    ),
}


@cache
def made(state: str):
    """The note and results.json of the mechanism alone, balanced so, with its harmonics."""
    name, block = STATES[state]
    text = VARIANTS.joinpath(f"{name}.yaml").read_text("utf-8").split("\nloads:")[0]
    text = re.sub(r"\n(balancing|harmonics|flywheel|friction|reduction):[^\n]*(\n+ [^\n]*)*", "", text)
    found = course.solve(loading.loads(f"{text}\nbalancing: {{{block}}}\nharmonics: {{}}\n"))
    note = read(render(found, "html", "en")["note.html"].decode())
    return note, json.loads(render(found, "json", "en")["results.json"])


@pytest.mark.exhaustive
@pytest.mark.parametrize("state", many(STATES, 2))
def test_every_number_is_marked_and_right(state):
    note, document = made(state)
    found = [*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_spans(note, document)]
    wrong([*found, *unmarked(note), *wrong_results(note)])


@pytest.mark.exhaustive
def test_that_guides_forbid_full_balance_is_said():
    note, document = made("guides alone on the way to the frame")
    said = "".join(note.root.itertext())
    assert "by the theorem of Tepper and Lowen counterweights cannot balance" in said
    ways = next(c for c in document["tables"]["balancing_cases"]["columns"] if c["key"] == "method")["values"]
    assert "full" not in ways and "pivoted" in ways
