"""Rotors and engines that no ready variant has: what is printed of them stands in the results, as of the ready ones."""

import json
from functools import cache

import pytest
from note import read
from notes import render
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas, wrong_spans
from test_arithmetic import wrong_results

from tmm_report import solve
from tmm_report.loading import loads

MASS = "{mass: 0.5 kg, radius: 80 mm, angle: 30 deg, at: 100 mm}"
OPPOSITE = "{mass: 0.5 kg, radius: 80 mm, angle: 210 deg, at: 300 mm}"
ENGINE = "speed: 3000 rpm, crank_radius: 40 mm, rod_length: 150 mm, reciprocating: 0.6 kg"
TEXTS = {
    "one plane, by its mass": f"rotor: {{masses: [{MASS}], planes: [{{at: 0, mass: 0.3 kg}}], speed: 900 rpm, "
    "diameter: 300 mm, width: 40 mm, bearings: [0, 400 mm], mass: 40 kg, centre: 90 mm, grade: 16}",
    "one plane, a couple": f"rotor: {{masses: [{MASS}, {OPPOSITE}], planes: [{{at: 0, radius: 90 mm}}], "
    "bearings: [0, 400 mm], speed: 900 rpm, diameter: 300 mm, width: 40 mm}",
    "in balance": f"rotor: {{masses: [{MASS}, {OPPOSITE.replace('300', '100')}], bearings: [0, 400 mm], "
    "planes: [{at: 0, radius: 90 mm}, {at: 300 mm, mass: 1 kg, remove: true}], steps: {mass: 1 g}, speed: 50}",
    "overhung": f"rotor: {{masses: [{MASS}], bearings: [200 mm, 400 mm], mass: 40 kg, centre: 100 mm, grade: 6.3, "
    "speed: 1500 rpm, planes: [{at: 80 mm, radius: 90 mm}, {at: 300 mm, radius: 90 mm}], steps: {mass: 0.1 kg}}",
    "one plane, a fast long rotor": f"rotor: {{masses: [{MASS}, {{unbalance: 3 kg*mm, angle: 1, at: 0.2}}], "
    "planes: [{at: 0, radius: 90 mm, remove: true}], speed: 9000 rpm, diameter: 100 mm, width: 400 mm}",
    "a couple alone": f"rotor: {{masses: [{MASS}, {OPPOSITE}], bearings: [0, 400 mm], "
    "planes: [{at: 300 mm, radius: 50 mm}, {at: 50 mm, radius: 60 mm}], steps: {mass: 1 g}}",
    "a disc askew": "rotor: {bodies: [{mass: 9 kg, products: {xz: 0.001, yz: -0.002}}], speed: 100, "
    "planes: [{at: -50 mm, radius: 50 mm}, {at: 50 mm, radius: 60 mm}]}",
    "one cylinder": f"engine: {{{ENGINE}, cylinders: [{{}}]}}",
    "four in line": f"engine: {{{ENGINE}, inline: {{cranks: [0, 180 deg, 180 deg, 0], spacing: 90 mm}}, "
    "rotating: 0.5 kg, counterweights: {mass: 0.6 kg, radius: 50 mm}, firing: [1, 3, 4, 2]}",
    "two opposed": f"engine: {{{ENGINE}, opposed: {{cranks: [0, 180 deg], spacing: 30 mm}}, about: 0, "
    "rod: {mass: 0.5 kg, centre: 45 mm}, counterweights: {share: 0.5, mass: 2 kg}}",
    "two together": f"engine: {{{ENGINE}, opposed: {{cranks: [0, 180 deg], spacing: 30 mm}}, strokes: 2, "
    "firing: [1, 2]}",
    "star": f"engine: {{{ENGINE}, radial: {{cylinders: 3, bank: 10 deg}}, accuracy: 0.5 mm}}",
    "narrow V": f"engine: {{{ENGINE}, vee: {{angle: 45 deg, cranks: [0], offset: 20 mm}}, firing: [2, 1]}}",
}


@cache
def made(name: str):
    """The note and results.json."""
    found = solve(loads("language: en\n" + TEXTS[name]))
    return read(render(found, "html")["note.html"].decode()), json.loads(
        render(found, "json")["results.json"]
    )


@pytest.mark.parametrize("name", TEXTS)
def test_marked_numbers_are_those_of_the_results(name):
    note, document = made(name)
    assert len(note.marked) > 20
    wrong([*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_spans(note, document)])


@pytest.mark.parametrize("name", TEXTS)
def test_every_printed_number_is_marked_and_every_formula_gives_what_it_prints(name):
    note, _ = made(name)
    wrong([*unmarked(note), *wrong_results(note)])


@pytest.mark.parametrize("name", TEXTS)
def test_nothing_is_printed_that_does_not_exist(name):
    note, _ = made(name)
    text = "".join(note.root.itertext())
    assert "nan" not in text.split() and "None" not in text and "inf" not in text.split()
