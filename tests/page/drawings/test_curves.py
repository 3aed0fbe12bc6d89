"""Curves of diagrams against results.json, read by the figures beside their axes; printed scales against the axes."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any
from xml.etree.ElementTree import Element

import numpy as np
import pytest
from curves import Curve, curves, is_graph
from note import Note, text_of
from pages import table_of
from printed import Printed, number, unit
from reading import CHOSEN, LEVERS, html, in_both, results, wrong

CLOSE = 2e-4  # of the height of a curve: figures of four digits beside the ticks
WRITTEN = 1.5e-3  # mm: places and ticks are written to a thousandth
MOTION = {"S": "S", "V": "V", "a": "A", "ψ": "psi", "ω": "omega", "ε": "epsilon"}
ANALOGUES = {"S′": "dS", "S′′": "ddS", "ψ′": "dpsi", "ψ′′": "ddpsi"}
OTHERS = {
    "Mур": ("balancing", "M_bal"), "Mbal": ("balancing", "M_bal"), "Pтр": ("friction", "P_fr"),
    "Pfr": ("friction", "P_fr"), "η": ("friction", "eta"), "Iпр": ("reduced_inertia", "I_red"),
    "s": ("stroke", "stroke"), "vs": ("stroke", "stroke_v"), "as": ("stroke", "stroke_a"),
    "Fbal": ("drive", "F_stroke"), "Fур": ("drive", "F_stroke"),
    "Ired": ("reduced_inertia", "I_red"), "Mпр": ("reduced_moment", "M_red"), "Mred": ("reduced_moment", "M_red"),
    "mпр": ("reduced_mass", "m_red"), "mred": ("reduced_mass", "m_red"),
    "Fпр": ("reduced_force", "F_red"), "Fred": ("reduced_force", "F_red"),
}  # fmt: skip
OWN = (
    "Исходные данные", "Initial data", "Кинематический анализ", "Силовой", "Потери на трение", "Приведение",
    "Kinematic analysis", "Kinetostatic analysis", "Friction losses", "Reduction",
)  # fmt: skip
"""How the sections of the lever's chapters begin: diagrams of the others have tests of their own."""
SEVERAL = {  # letters of axes with several curves: each of them must be one of these
    "M": [("balancing", "M_bal"), ("friction_corrected", "M_first"), ("friction_corrected", "M_bal_fr")],
    **{key: [("friction", "eta"), ("friction_corrected", "eta_corrected")] for key in ("ηтр", "ηfr")},
}


def graphs(note: Note, own: bool = False) -> Iterator[tuple[str, list[Curve]]]:
    """Captions of the graphs and their curves; `own`: of the lever's chapters alone."""
    section = ""
    for figure in note.root.iter():
        if figure.tag == "h1":
            section = text_of(figure).lstrip("0123456789 ")
        if figure.tag != "figure" or (own and not section.startswith(OWN)):
            continue
        svg = note.drawings[figure.get("id") or ""]
        caption = figure.find("figcaption")
        if is_graph(svg) and caption is not None:
            yield text_of(caption).split("; μ")[0], curves(svg)  # without the scales


def column(curve: Curve, caption: str, document: dict[str, Any]) -> tuple[str, str]:
    """Which table of the results a curve over the cycle shows, and which column."""
    if letter_of_driver(curve, caption):
        return "rates", f"{'w' if curve.axis.letter[0] == 'ω' else 'e'}_{curve.axis.letter[1:]}"
    if curve.axis.letter in MOTION:
        return "outputs", f"{MOTION[curve.axis.letter]}_{caption.split()[-1]}"
    if curve.axis.letter in ANALOGUES:
        return "analogues", f"{ANALOGUES[curve.axis.letter]}_{caption.split()[-1]}"
    if curve.axis.letter in OTHERS:
        return OTHERS[curve.axis.letter]
    letter = curve.axis.letter
    if letter[0] == "F":  # of a spring or damper
        return "ties", f"F_{letter[1:]}"
    assert letter[0] in "PM", letter
    if letter[0] == "M":  # a stated moment by its symbol: M3 is M_3, its key M_3,1
        return "stated", next(key for key, sign in signs(document).items() if sign == letter)
    return "stated", f"P_{letter[1:]}"  # a stated force by its point


def letter_of_driver(curve: Curve, caption: str) -> bool:
    """Whether a curve shows a rate of a driving link that moves by a law."""
    return curve.axis.letter[0] in "ωε" and ("driving link" in caption or "ведущего звена" in caption)


def signs(document: dict[str, Any]) -> dict[str, str]:
    """Keys of the stated loads and their symbols as they are drawn."""
    columns = document["tables"]["stated_diagram"]["columns"]
    return {column["key"]: column.get("symbol", "").replace("_", "") for column in columns}


def several_of(letter: str) -> list[tuple[str, str]]:
    """The columns that the curves of an axis may show, where it has several."""
    if letter[0] == "R":  # magnitude and projections of a reaction
        return [("reactions", f"R_{letter[1:]}{part}") for part in ("", "_x", "_y")]
    return SEVERAL.get(letter, [])


def wrong_curve(curve: Curve, caption: str, document: dict[str, Any], which: str) -> Iterator[str]:
    """At each position of the table or of the diagram; of several curves over one axis one must be it."""
    if several := several_of(curve.axis.letter):
        yield from min((list(_wrong(curve, caption, document, which, *one)) for one in several), key=len)
        return
    yield from _wrong(curve, caption, document, which, *column(curve, caption, document))


def _wrong(
    curve: Curve, caption: str, document: dict[str, Any], which: str, name: str, key: str
) -> Iterator[str]:
    table = table_of(document, f"{name}_{which}")
    of = unit(curve.axis.unit)
    assert of is not None
    close = CLOSE * (np.ptp(curve.values) or 1.0) + WRITTEN * curve.axis.scale
    seen = 0
    for phi, value in zip(np.degrees(table["phi"]), table[key] / of.factor, strict=True):
        k = int(np.argmin(np.abs(curve.turned - phi)))
        if math.isfinite(value) and abs(curve.turned[k] - phi) < 1e-3:
            seen += 1
            if abs(curve.values[k] - value) > close:
                yield f"{caption}: {key} at {phi:.4g}° is drawn as {curve.values[k]:.5g}, it is {value:.5g}"
    if seen < (8 if name in ("reduced_mass", "reduced_force") else 12):  # left out beside dead points
        yield f"{caption}: only {seen} points of {key} are drawn"


@pytest.mark.parametrize("name", LEVERS)
def test_diagrams_over_the_cycle(name):
    document, found, seen = results(name), [], set()
    for caption, drawn in graphs(html(name), own=True):
        for curve in drawn:
            if curve.axis.letter != "λ":
                if not several_of(curve.axis.letter):
                    seen.add(column(curve, caption, document)[1])
                elif curve.axis.letter[0] == "R":
                    seen.add(f"R_{curve.axis.letter[1:]}")
                for which in ("table", "diagram"):
                    found += wrong_curve(curve, caption, document, which)
    wanted = {f"{letter}_{key[2:]}" for key in outputs(document) for letter in ("S", "V", "A")}
    wanted |= set(reactions(document))
    wanted |= {f"{letter}_{key[4:]}" for key in rockers(document) for letter in ("psi", "omega", "epsilon")}
    wrong([*found, *(f"{key} is not drawn" for key in wanted - seen)])


def reactions(document: dict[str, Any]) -> list[str]:
    """Every pair's: the columns of the reactions that are magnitudes."""
    names = document["tables"].get("reactions_table", {"columns": []})["columns"]
    return [
        column["key"]
        for column in names
        if column["key"].startswith("R_") and column["key"][-2:] not in ("_x", "_y")
    ]


def outputs(document: dict[str, Any]) -> list[str]:
    return [key for key in table_of(document, "outputs_table") if key.startswith("S_")]


def rockers(document: dict[str, Any]) -> list[str]:
    return [key for key in table_of(document, "outputs_table") if key.startswith("psi_")]


@pytest.mark.exhaustive
@pytest.mark.parametrize(("name", "language"), in_both(LEVERS))
def test_printed_scales_are_those_of_the_axes(name, language):
    """Under each diagram, what 1 mm along each of its axes stands for."""
    note, found, seen = html(name, language), [], 0
    for figure in note.root.iter("figure"):
        svg, caption = note.drawings[figure.get("id") or ""], figure.find("figcaption")
        if not is_graph(svg) or caption is None or not (drawn := curves(svg)):
            continue
        stated = [one for one in map(printed_scale, caption.iter()) if one]
        seen += len(stated)
        axes = [*(curve.axis.scale for curve in drawn), drawn[0].across]
        found += [
            f"{text_of(caption)}: no axis has the scale {one.value}"
            for one in stated
            if not any(near(one, scale) for scale in axes)
        ]
        found += [
            f"{text_of(caption)}: the scale {scale:.5g} of an axis is not under it"
            for scale in axes
            if stated and not any(near(one, scale) for one in stated)
        ]
    wrong(found if seen else ["no scales"])


def printed_scale(node: Element) -> Printed | None:
    return number(text_of(node)) if node.get("data-t") == "picture" else None


def near(printed: Printed, scale: float) -> bool:
    return abs(printed.value - scale) <= printed.half + CLOSE * scale


def sliding(document: dict[str, Any], wheels: list[str]) -> dict[str, np.ndarray]:
    """The table of a pair."""
    tables = (table_of(document, key) for key in document["tables"] if key.endswith("sliding"))
    return next(table for table in tables if {f"lambda_{wheel}" for wheel in wheels} <= set(table))


@pytest.mark.parametrize("name", CHOSEN)
def test_diagrams_of_sliding(name):
    """Specific sliding of both wheels along the line of action."""
    document, found = results(name), []
    for caption, drawn in graphs(html(name)):
        if drawn[0].axis.letter == "λ":
            wheels = re.findall(r"[\w']+", caption)[-2:]
            table = sliding(document, wheels)
            rho = 1e3 * table[f"rho_{wheels[0]}"]
            for wheel, curve in zip(wheels, drawn, strict=True):
                order = np.argsort(rho)
                drawn_at = np.interp(rho[order], curve.turned, curve.values)
                worst = np.abs(drawn_at - table[f"lambda_{wheel}"][order]).max()
                if worst > 1e-3 * np.ptp(curve.values):
                    found.append(f"{caption}: λ of {wheel} is drawn {worst:.3g} off")
    wrong(found)
