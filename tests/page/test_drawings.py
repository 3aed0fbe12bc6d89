"""Drawings against results.json: schemes at their scale, vectors of plans as long as printed and the way they point."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from note import Note, formulas_of, text_of
from pages import table_of
from picture import Picture, picture
from reading import LEVERS, html, results, wrong

POLE = 0.8  # radius of the dot of a pole, mm
NEAR, SHARE = 0.12, 0.004  # mm, and share of a vector: what readings by a pencil may add up to
BESIDE = 9.0  # mm: lettering stands no further from its point


def figures(note: Note, symbol: str) -> Iterator[tuple[str, str, float]]:
    """Anchor, caption and scale of the figures that state this scale."""
    for figure in note.root.iter("figure"):
        caption = figure.find("figcaption")
        assert caption is not None
        for math in caption.iter("math"):
            stated = formulas_of([math], "", False)[0][1]
            if stated.symbol == symbol and stated.result is not None:
                yield figure.get("id") or "", text_of(caption), stated.result.value


def position_of(caption: str) -> int | None:
    """The position that a caption names, by its words."""
    match = re.search(r"(?:position|положение) (\d+)", caption)
    return int(match[1]) if match else None


# --- plans of velocities and accelerations ---


def vectors(document: dict[str, Any], letter: str, k: int) -> dict[str, complex]:
    """Velocities or accelerations of points at a position of the table; of single letters or with digits."""
    rates = table_of(document, "rates_table")
    places = table_of(document, "positions_table")
    found = {}
    for key in rates:
        name = key.removeprefix(f"{letter}_").removesuffix("_x")
        if key == f"{letter}_{name}_x" and f"x_{name}" in places:
            found[name] = complex(rates[key][k], rates[f"{letter}_{name}_y"][k])
    return found


def read_off(document: dict[str, Any], letter: str, k: int, mu: float) -> list[float]:
    """Lengths of all that is read off the plan: components and points of guides among them."""
    columns = {c["key"]: c["values"] for c in document["tables"][f"comparison_{k}"]["columns"]}
    entries = zip(columns["key"], columns["graph"], strict=True)
    return [value / mu for key, value in entries if key.startswith(letter) and value is not None]


def near(one: complex, other: complex, size: float = 30.0) -> bool:
    """Within what readings add up to beside vectors of this size."""
    return abs(one - other) <= NEAR + SHARE * max(abs(one), abs(other), size)


def wrong_plan(where: str, drawn: Picture, expected: dict[str, complex], sizes: list[float]) -> Iterator[str]:
    poles = [centre for centre, radius in drawn.dots if radius == POLE]
    if len(poles) != 1:
        yield f"{where}: {len(poles)} poles"
        return
    tips = [tip - poles[0] for start, tip in drawn.arrows if abs(start - poles[0]) < 0.01]
    for name, vector in expected.items():
        if np.isfinite(vector) and abs(vector) > 1 and not any(near(tip, vector) for tip in tips):
            nearest = min(tips, key=lambda tip: abs(tip - vector), default=None)
            yield f"{where}: no arrow to {name} at {vector:.3f} mm, the nearest one is {nearest}"
        yield from _unlettered(where, drawn, poles[0] + vector, name)
    for tip in tips:
        like = any(abs(abs(tip) - size) <= NEAR + SHARE * size for size in sizes)
        if abs(tip) > 1 and not like and not any(near(tip, vector) for vector in expected.values()):
            yield f"{where}: an arrow to {tip:.3f} mm that is nothing of the results"


def _unlettered(where: str, drawn: Picture, at: complex, name: str) -> Iterator[str]:
    """The letter of a point stands beside it."""
    if not np.isfinite(at):
        return
    texts = [text for place, text in drawn.letters if abs(place - at) < BESIDE + 2.0 * len(text)]
    if not any(name.lower() in [part.strip() for part in text.split(",")] for text in texts):
        yield f"{where}: no letter {name.lower()} beside its point, there are {texts}"


@pytest.mark.parametrize("name", LEVERS)
@pytest.mark.parametrize(("letter", "scale"), [("v", "μ_v"), ("a", "μ_a")])
def test_vectors_of_plans(name, letter, scale):
    note, document, found, seen = html(name), results(name), [], 0
    for anchor, caption, mu in figures(note, scale):
        k = position_of(caption)
        if k is None:
            continue
        seen += 1
        expected = {point: vector / mu for point, vector in vectors(document, letter, k).items()}
        fixed = {point: vector for point, vector in expected.items() if vector == vector}
        sizes = read_off(document, letter, k, mu)
        found += wrong_plan(f"{anchor} {caption[:50]}", picture(note.drawings[anchor]), fixed, sizes)
    wrong(found if seen else ["no plans"])


# --- force plans ---


def forces(document: dict[str, Any], k: int) -> list[complex]:
    """Every force at a position; reactions both ways."""
    found = []
    for name in ("loads_table", "reactions_table"):
        table = table_of(document, name)
        for key in table:
            if f"{key}_x" in table:
                vector = complex(table[f"{key}_x"][k], table[f"{key}_y"][k])
                found += [vector, -vector] if key.startswith("R") else [vector]
    return found


@pytest.mark.parametrize("name", LEVERS)
def test_vectors_of_force_plans(name):
    note, document, found, seen = html(name), results(name), [], 0
    for anchor, caption, mu in figures(note, "μ_F"):
        k = position_of(caption)
        if k is None:
            continue
        known = [force / mu for force in forces(document, k)]
        drawn = [tip - start for start, tip in picture(note.drawings[anchor]).arrows]
        seen += sum(1 for vector in drawn if any(near(vector, force) for force in known))
        if not closes(drawn, known):
            found.append(f"{anchor} {caption[:50]}: what is drawn is not what acts: {drawn}")
    wrong(found if seen else ["no force plans"])


SHORT = 5.0  # mm: components may be as short as the errors of their sums


def closes(drawn: list[complex], known: list[complex]) -> bool:
    """Forces of the results make up the drawing; what is none of them are components of one of them."""
    others = [vector for vector in drawn if not any(near(vector, force) for force in known)]
    # a short component may be like some force
    parts = [*others, *(vector for vector in drawn if abs(vector) < SHORT)]
    return all(
        abs(one) < SHORT
        or any(near(one + other, force) for other in parts if other is not one for force in known)
        for one in others
    )


# --- schemes ---


@pytest.mark.parametrize("name", LEVERS)
def test_points_of_schemes_are_at_their_scale(name):
    note, document, found, seen = html(name), results(name), [], 0
    places = table_of(document, "positions_table")
    points = [key[2:] for key in places if key.startswith("x_")]
    for anchor, caption, mu in figures(note, "μ_l"):
        k = position_of(caption)
        if k is None or "." in anchor:
            continue
        drawn = picture(note.drawings[anchor])
        marks = np.array([*drawn.corners, *(centre for centre, _ in drawn.dots)])
        expected = {p: complex(places[f"x_{p}"][k], places[f"y_{p}"][k]) / mu for p in points}
        seen += 1
        missing = [p for p, at in expected.items() if np.isfinite(at) and np.abs(marks - at).min() > 0.05]
        if len(missing) > len(points) // 3:  # a point within a bar is no corner
            found.append(f"{anchor} {caption[:50]}: {missing} are not at their places")
    wrong(found if seen else ["no schemes"])


# --- Zhukovsky's lever ---


@pytest.mark.parametrize("name", LEVERS)
def test_forces_of_the_lever_point_their_way(name):
    """The plan is turned by 90°, the forces are not."""
    note, document, found = html(name), results(name), []
    for figure in note.root.iter("figure"):
        caption = text_of(figure.find("figcaption"))  # type: ignore[arg-type]
        k = position_of(caption)
        if k is None or not ("Жуковск" in caption or "Zhukovsky" in caption):
            continue
        drawn = picture(note.drawings[figure.get("id") or ""])
        ways = [np.angle(tip - start) for start, tip in drawn.arrows if abs(tip - start) > 9]
        table = table_of(document, "loads_table")
        for key in table:
            if f"{key}_x" in table and abs(table[key][k]) > 1e-9:
                way = np.angle(complex(table[f"{key}_x"][k], table[f"{key}_y"][k]))
                if not any(abs(np.angle(np.exp(1j * (way - one)))) < 0.01 for one in ways):
                    found.append(f"{caption[:40]}: {key} points to {np.degrees(way):.1f}°, no arrow does")
    wrong(found)
