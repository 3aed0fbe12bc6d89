"""Pictures of cam pairs as a reader reads them: curves by the figures beside the axes, the profile by its scale."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import LEVERS, solved
from curves import curves, is_graph
from pages import table_of, value_of
from reading import CHOSEN, drawings, html, results
from test_curves import CLOSE, graphs

from tmm_report.figures.primitives import Path

CAMS = [path.stem for path in LEVERS if path.stem in CHOSEN and "\n  cams:" in path.read_text("utf-8")]
KEYS = {"": "cam_S", "′": "cam_S1", "′′": "cam_S2"}


def pairs(name: str):
    return solved(name).lever.cams.cams


def sheet(name: str, own: str):
    """The curves of the sheet that shows the law of one cam."""
    (drawn,) = [c for _, c in graphs(html(name)) if any(x.axis.letter in (f"s{own}", f"β{own}") for x in c)]
    return drawn


def pictures(name: str) -> list[str]:
    return [svg for svg in html(name).drawings.values() if is_graph(svg)]


def at_positions(curve, table) -> np.ndarray:
    """The values drawn at the diagram positions; at a jump, which is drawn upright, that of the nearest point."""
    phi = np.degrees(table["phi"])
    near = np.abs(curve.turned[:, None] - phi).argmin(axis=0)
    on_a_point = np.abs(curve.turned[near] - phi) < 1e-3
    return np.where(on_a_point, curve.values[near], np.interp(phi, curve.turned, curve.values))


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", CAMS)
def test_curves_of_the_law_are_those_of_the_results(name):
    for one in pairs(name):
        own = one.cam.name
        table = table_of(results(name), f"cam_motion_{own}_diagram")
        moved = [curve for curve in sheet(name, own) if curve.axis.letter[0] in "sβ"]
        assert len(moved) == 3
        for curve in moved:
            values = table[f"{KEYS[curve.axis.letter[1:].removesuffix(own)]}_{own}"]
            assert np.max(np.abs(at_positions(curve, table) - values)) < CLOSE * 5 * np.max(np.abs(values))


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", CAMS)
def test_the_pressure_angle_stands_between_its_limits(name):
    for one in pairs(name):
        own = one.cam.name
        table = table_of(results(name), f"cam_motion_{own}_diagram")
        limit = value_of(results(name), f"cam_alpha_limit_{own}")
        angles = [curve for curve in sheet(name, own) if curve.axis.letter == f"α{own}"]
        found = sorted(angles, key=lambda curve: np.ptp(curve.values))
        assert sorted(round(float(curve.values.mean()), 1) for curve in found[:2]) == pytest.approx(
            [-limit, limit]
        )
        assert np.max(np.abs(at_positions(found[2], table) - np.degrees(table[f"cam_alpha_{own}"]))) < 0.05


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", CAMS)
def test_the_extremes_marked_are_those_of_the_text(name):
    """The figures beside the extremes of the drawn curves: exact ones, not those of the diagram positions."""
    for one in pairs(name):
        own, document = one.cam.name, results(name)
        (words,) = [svg for svg in pictures(name) if any(c.axis.letter == f"α{own}" for c in curves(svg))]
        words = words.replace("−", "-").replace(",", ".")
        wanted = [value_of(document, f"cam_alpha_{way}_{own}") for way in ("rise", "return")]
        wanted += [ends[1].value for ends in one.ends[1:]]
        for value in wanted:
            assert f"{value:.4g}" in words, value


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", CAMS)
def test_the_profile_is_drawn_at_the_scale_of_its_caption(name):
    """Every contact of the table lies on the outline drawn, turned as the cam stands in position 0."""
    for one, picture in zip(pairs(name), profiles(name), strict=True):
        own, mu = one.cam.name, picture[0]
        table = table_of(results(name), f"cam_profile_{own}")
        turn = np.exp(1j * one.phi(0.0))
        places = table[f"cam_R_{own}"] * np.exp(1j * table[f"cam_gamma_{own}"]) * turn / mu
        for place in places:
            assert np.min(np.abs(np.asarray(picture[1]) - place)) < 0.5


def profiles(name: str) -> list[tuple[float, tuple[complex, ...]]]:
    """Scale by the caption, m/mm, and the outline, mm, of every profile drawn, in the order of the note."""
    found = []
    note = html(name)
    for figure in note.root.iter("figure"):
        words = "".join(figure.find("figcaption").itertext()) if figure.find("figcaption") is not None else ""
        if "Профиль кулачка" not in words and "Profile of cam" not in words:
            continue
        outline = next(
            item
            for item in drawings(name)[figure.get("id")].items
            if isinstance(item, Path) and item.fill == "pale"
        )
        scale = words.replace(",", ".").replace("\u2009", " ")
        found.append((float(scale.split("=")[1].split()[0].rstrip("мm/")), outline.strokes[0]))
    return found
