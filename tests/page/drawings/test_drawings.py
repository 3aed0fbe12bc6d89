"""Schemes against results.json at their scale; letters of the vertices of plans."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np
import pytest
from captions import figures, position_of
from pages import table_of
from picture import Picture, picture
from reading import LEVERS, html, results, wrong
from vectors import POLE, rates

BESIDE = 9.0  # mm: lettering stands no further from its point


# --- plans of velocities and accelerations ---


def wrong_letters(where: str, drawn: Picture, pole: complex, ends: dict[str, complex]) -> Iterator[str]:
    """The letter of a point stands beside the end of its vector."""
    for name, end in ends.items():
        if not np.isfinite(end):
            continue
        texts = [text for at, text in drawn.letters if abs(at - pole - end) < BESIDE + 2.0 * len(text)]
        if not any(name.lower() in [part.strip() for part in text.split(",")] for text in texts):
            yield f"{where}: no letter {name.lower()} beside its point, there are {texts}"


@pytest.mark.parametrize("name", LEVERS)
@pytest.mark.parametrize(("letter", "scale"), [("v", "μ_v"), ("a", "μ_a")])
def test_vertices_of_plans_are_lettered(name, letter, scale):
    note, document, found, seen = html(name), results(name), [], 0
    points = {key[2:] for key in table_of(document, "positions_table") if key.startswith("x_")}
    for anchor, caption, mu in figures(note, scale):
        k = position_of(caption)
        if k is not None:
            drawn, speeds = picture(note.drawings[anchor]), rates(document, k)
            ends = {p: speeds[f"{letter}_{p}"] / mu for p in points if f"{letter}_{p}" in speeds}
            pole = next(centre for centre, radius in drawn.dots if radius == POLE)
            seen += 1
            found += wrong_letters(f"{anchor} {caption[:50]}", drawn, pole, ends)
    wrong(found if seen else ["no plans"])


# --- schemes ---


@pytest.mark.parametrize("name", LEVERS)
def test_points_of_schemes_are_at_their_scale(name):
    note, document, found, seen = html(name), results(name), [], 0
    places = table_of(document, "positions_table")
    points = [key[2:] for key in places if key.startswith("x_")]
    for anchor, caption, mu in figures(note, "μ_l"):
        k = position_of(caption)
        if k is None or "." in anchor or re.search("Loading of|Схема нагружения", caption):
            continue  # a group alone
        drawn = picture(note.drawings[anchor])
        marks = np.array([*drawn.corners, *(centre for centre, _ in drawn.dots)])
        expected = {p: complex(places[f"x_{p}"][k], places[f"y_{p}"][k]) / mu for p in points}
        seen += 1
        missing = [p for p, at in expected.items() if np.isfinite(at) and np.abs(marks - at).min() > 0.05]
        if len(missing) > len(points) // 3:  # a point within a bar is no corner
            found.append(f"{anchor} {caption[:50]}: {missing} are not at their places")
    wrong(found if seen else ["no schemes"])
