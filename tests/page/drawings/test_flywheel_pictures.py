"""Diagrams, energy–mass diagram and sketch of a flywheel, as drawn, against results.json at their printed scales."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any
from xml.etree.ElementTree import fromstring

import numpy as np
import pytest
from curves import Curve
from note import Note, text_of
from pages import table_of, value_of
from picture import SVG, Picture, picture, points
from printed import number, unit
from reading import CHOSEN, html, results, variant, wrong
from test_curves import CLOSE, graphs

KEYS = {  # letter of the axis -> the columns of its curves in their order
    "M": ("M_dr", "M_res"),
    "JII": ("J_II",),
    "A": ("A", "dT_I"),
    "ω": ("omega_0", "omega"),
    "Δω": ("domega",),
}
WITH = [name for name in CHOSEN if variant(name).flywheel]
DOT = 0.5  # mm: radius of a position's mark
JUMP = 2e-3  # degrees


def figures(note: Note) -> Iterator[list[Curve]]:
    """The diagrams of the flywheel: no others are of work or of the difference of a speed."""
    for _, drawn in graphs(note):
        if {curve.axis.letter for curve in drawn} & {"A", "Δω"}:
            yield drawn


def named(drawn: list[Curve], table: dict[str, np.ndarray]) -> Iterator[tuple[str, Curve]]:
    """Each curve with the column that it shows."""
    for letter, keys in KEYS.items():
        own = [curve for curve in drawn if curve.axis.letter == letter]
        yield from zip([key for key in keys if key in table], own, strict=False)


def wrong_curve(key: str, curve: Curve, table: dict[str, np.ndarray]) -> Iterator[str]:
    of = unit(curve.axis.unit)
    assert of is not None
    height = 40 * curve.axis.scale  # mm: of the panel
    for phi, value in zip(np.degrees(table["phi"]), table[key] / of.factor, strict=True):
        # a jump is drawn upright: its table has one of both values
        beside = np.interp(phi + np.array([-JUMP, 0.0, JUMP]), curve.turned, curve.values)
        if not beside.min() - CLOSE * height <= value <= beside.max() + CLOSE * height:
            yield f"{key} at {phi:.5g}°: {value:.5g} is drawn as {beside[1]:.5g}"


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", WITH)
def test_diagrams_of_the_flywheel(name):
    document, found, seen = results(name), [], set()
    for drawn in figures(html(name)):
        for which in ("table", "diagram"):
            table = table_of(document, f"flywheel_{which}")
            for key, curve in named(drawn, table):
                seen.add(key)
                found += wrong_curve(key, curve, table)
    wanted = {key for keys in KEYS.values() for key in keys} & set(table_of(document, "flywheel_table"))
    wrong([*found, *(f"{key} is not drawn" for key in wanted - seen)])


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", WITH)
def test_the_scales_in_the_caption_are_those_of_the_axes(name):
    note = html(name)
    caption = next(node for node in note.root.iter("figcaption") if "mu_A" in stated(node))
    axes = {curve.axis.letter: curve.axis.scale for curve in next(figures(note))}
    printed = stated(caption)
    pairs = (("mu_M", "M"), ("mu_A", "A"), ("mu_J", "JII"))
    wrong(
        [f"{key} is {printed[key]}" for key, letter in pairs if abs(printed[key] / axes[letter] - 1) > CLOSE]
    )


@pytest.mark.parametrize("name", WITH)
def test_the_pole_distance_is_that_of_the_scales(name):
    note = html(name)
    scales = stated(next(node for node in note.root.iter("figcaption") if "mu_A" in stated(node)))
    (printed,) = {stated(node)["H"] for node in note.root.iter("div") if "H" in stated(node)}
    turned = math.radians(scales["mu_phi"])
    assert printed * scales["mu_M"] * turned == pytest.approx(scales["mu_A"], rel=1e-3)


def stated(caption: Any) -> dict[str, float]:
    """The scales of a caption."""
    marked = [node for node in caption.iter() if node.get("data-t") == "picture"]
    found = {node.get("data-q"): number(text_of(node)) for node in marked}
    return {key: value.value for key, value in found.items() if key and value}


# --- the energy–mass diagram


def energy_mass(note: Note) -> str:
    """The figure in whose caption its scales are results, not the picture's own."""
    for figure in note.root.iter("figure"):
        marks = {node.get("data-q") for node in figure.iter()}
        if {"flywheel_mu_J", "flywheel_mu_T"} <= marks:
            return note.drawings[figure.get("id") or ""]
    raise AssertionError("no energy–mass diagram")


def lines_from(svg: str, start: complex) -> Iterator[complex]:
    """Straight lines that begin at a place, mm: where each goes from there."""
    for path in fromstring(svg).iter(SVG + "path"):
        ends = points(path)
        if len(ends) == 2 and abs(ends[0] - start) < 0.01:
            yield ends[1] - ends[0]


@pytest.mark.parametrize("name", WITH)
def test_positions_tangents_and_their_cuts_on_the_energy_mass_diagram(name):
    svg = energy_mass(html(name))
    document, drawn, found = results(name), picture(svg), []
    scale = (value_of(document, "flywheel_mu_J"), value_of(document, "flywheel_mu_T"))
    table, methods = (table_of(document, f"flywheel_{which}") for which in ("table", "methods"))
    row = document["tables"]["flywheel_methods"]["columns"][0]["values"].index("wittenbauer")

    def at(inertia: float, work: float) -> complex:
        return complex(inertia / scale[0], work / scale[1])

    marks = np.array([centre for centre, radius in drawn.dots if radius == DOT])
    places = np.array([at(*pair) for pair in zip(table["J_II"], table["A"], strict=True)])[:-1]
    if np.abs((marks - marks[0]) - (places - places[0])).max() > 0.01:
        found.append("positions are not at their places")
    origin = marks[0] - places[0]
    for end in "12":
        cut, slope = methods[f"T_{end}"][row], methods[f"s_{end}"][row]
        turn = np.angle(at(1.0, slope))
        drawn_at = [np.angle(line) for line in lines_from(svg, origin + at(0.0, cut)) if abs(line) > 20]
        if not any(abs(angle - turn) < 1e-3 for angle in drawn_at):
            found.append(
                f"no tangent {end} from {cut:.5g} J at {np.degrees(turn):.5g}°: there are {drawn_at}"
            )
        if abs(value_of(document, f"flywheel_psi_{end}") - np.degrees(turn)) > 1e-9:
            found.append(f"ψ_{end} is not the angle of the tangent")
    wrong(found)


# --- the sketch


@pytest.mark.parametrize("name", WITH)
def test_the_sketch_is_as_large_as_its_scale_says(name):
    note, document = html(name), results(name)
    figures = [node for node in note.root.iter("figure") if "mu_l" in stated(node)]
    outer = f"{1e3 * value_of(document, 'flywheel_D_out'):.4g}"
    # other chapters have figures at a scale of lengths too: the wheel's has its outer diameter on it
    figure, drawn = next(
        (node, of) for node in figures if outer in written(of := picture(note.drawings[node.get("id") or ""]))
    )
    scale = stated(figure)["mu_l"]
    largest = max(radius for _, radius in drawn.dots)
    assert 2 * largest * scale == pytest.approx(value_of(document, "flywheel_D_out"), rel=1e-3)
    assert f"{1e3 * value_of(document, 'flywheel_b'):.4g}" in written(drawn)


def written(drawn: Picture) -> str:
    """All the letters of a picture."""
    return "".join(text.replace(",", ".") for _, text in drawn.letters)
