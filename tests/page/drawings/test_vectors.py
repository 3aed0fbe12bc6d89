"""Vectors of the plans and of the lever against results.json: their length at the scale, direction, place."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from captions import figures, position_of
from note import text_of
from pages import driving_speed
from reading import LEVERS, html, results, variant, wrong
from statics import Scheme, scheme
from vectors import Vector, Vectors, forces, near, off, rates, vectors, written

from tmm_report.mechanics.lever.driving.reversed import Reversed

LEAST = 1.0  # mm: a vector so short may be left out
NAMED = {"F_stroke": "F_bal"}  # keys that are not called as they are lettered
BESIDE = 9.0  # mm: lettering stands no further from its vector


def wrong_ends(drawn: Vectors, letter: str, fixed: complex) -> Iterator[str]:
    """Vectors of points begin in the pole; all begin and end where others do."""
    places = [fixed, *(vector.tip for vector in drawn.shown if vector.key[0] == letter)]
    for vector in drawn.shown:
        if vector.key[0] == letter and min(abs(vector.start - one) for one in places) > 0.02:
            yield f"{vector.key} begins at {vector.start:.3f}, where nothing ends"


def unlettered(drawn: Vectors) -> Iterator[str]:
    """Vectors without their letters beside them."""
    for vector in drawn.shown:
        texts = [text for at, text in drawn.letters if distance(at, vector) < BESIDE + 2 * len(text)]
        if not any(plain(text) == plain(NAMED.get(vector.key, vector.key)) for text in texts):
            yield f"no {plain(vector.key)} beside {vector.key}, there are {texts}"


def plain(symbol: str) -> str:
    """Letters and digits of a symbol, whichever stand in the index; words of the index are of the language."""
    told = re.sub(r"[_,\s]", "", symbol).replace("и", "I").replace("τ", "t").replace("ур", "bal")
    return "".join(sorted(told))


def distance(at: complex, vector: Vector) -> float:
    """From a place to a vector, mm."""
    at -= vector.by
    share = ((at - vector.start) * vector.along.conjugate()).real / abs(vector.along) ** 2
    return abs(at - vector.start - min(1.0, max(0.0, share)) * vector.along)


# --- plans of velocities and accelerations ---


def compared(document: dict[str, Any], letter: str, k: int) -> list[str]:
    """Keys of what is read off a plan."""
    columns = {c["key"]: c["values"] for c in document["tables"][f"comparison_{k}"]["columns"]}
    return [key for key in columns["key"] if key.startswith(letter + "_")]


def wrong_plan(document: dict[str, Any], drawn: Vectors, letter: str, k: int, scale: float) -> Iterator[str]:
    expected = rates(document, k)
    for vector in drawn.shown:
        yield off(vector, scale, expected[vector.key])
    for key in compared(document, letter, k):
        if abs(expected[key]) / scale > LEAST and not drawn.of(key):
            yield f"{key} is not drawn"
    yield from wrong_ends(drawn, letter, drawn.poles[0])
    yield from unlettered(drawn)


# a short note has its plans smaller, at scales of their own
depths = pytest.mark.parametrize("depth", ["full", "short"])


@depths
@pytest.mark.parametrize("name", LEVERS)
@pytest.mark.parametrize(("letter", "scale"), [("v", "μ_v"), ("a", "μ_a")])
def test_every_vector_of_a_plan(name, letter, scale, depth):
    note, document, found, seen = html(name, depth=depth), results(name), [], 0
    for anchor, caption, mu in figures(note, scale):
        k = position_of(caption)
        if k is not None:
            drawn = vectors(note.drawings[anchor])
            seen += len(drawn.shown)
            found += [f"{anchor}: {text}" for text in wrong_plan(document, drawn, letter, k, mu) if text]
    wrong(found if seen else ["no vectors"])


# --- force plans ---


def links_of(caption: str, driver: str) -> list[str]:
    """The links of a group, those named one by one, or the driving link."""
    match = re.search(r"\(([\d,]+)\)|(?:links?|звена|звеньев) (\d+(?:, \d+)*)", caption)
    return re.findall(r"\d+", match[0]) if match else [driver]


def wrong_forces(
    document: dict[str, Any], drawn: Vectors, links: list[str], k: int, scale: float
) -> Iterator[str]:
    expected = forces(document, k)
    whole = [vector for vector in drawn.shown if vector.key in expected]
    for vector in whole:
        yield off(vector, scale, expected[vector.key])
    for link in links:
        for key in (f"G_{link}", f"F_I{link}"):
            if abs(expected.get(key, 0.0)) / scale > LEAST and not drawn.of(key):
                yield f"{key} is not drawn"
    parts = {vector.key: vector for vector in drawn.shown if vector not in whole}
    yield from wrong_components(document, parts, expected, k, scale)
    yield from unlettered(drawn)


def wrong_components(
    document: dict[str, Any], parts: dict[str, Vector], expected: dict[str, complex], k: int, scale: float
) -> Iterator[str]:
    """Normal and tangential components make up their reaction, across one another; the tangential is as worked."""
    by_hand: dict[str, float] = {}
    for name in document["tables"]:
        if name.startswith(f"force_plan_{k}_"):
            by_hand |= written(document, name)
    for key, tangential in parts.items():
        of = key.removesuffix("_t")
        if key == of:
            if key.removesuffix("_n") not in expected:
                yield f"{key} is nothing of the results"
            continue
        normal = parts.get(of + "_n")
        along = normal.along if normal else 0j
        if not near(tangential.along + along, expected[of] / scale):
            yield f"{of} is not made up by {tangential.along:.3f} and {along:.3f} mm"
        if abs((tangential.along.conjugate() * along).real) > 0.02 * max(abs(along), abs(tangential.along)):
            yield f"{key} is not across {of}_n"
        if not near(abs(tangential.along), abs(by_hand[key]) / scale):
            yield f"{key} is {abs(tangential.along):.3f} mm, worked by hand {by_hand[key]:.5g} N"


@depths
@pytest.mark.parametrize("name", LEVERS)
def test_every_vector_of_a_force_plan(name, depth):
    note, document, found, seen = html(name, depth=depth), results(name), [], 0
    plans = [*figures(note, "μ_F")]
    if isinstance(
        variant(name).lever.mechanism.driver.stroke, Reversed
    ):  # no triangle follows it: no plan is drawn
        assert not plans
        return
    for anchor, caption, mu in plans:
        k = position_of(caption)
        if k is not None:
            drawn, links = vectors(note.drawings[anchor]), links_of(caption, scheme(name).driver)
            seen += len(drawn.shown)
            found += [f"{anchor}: {text}" for text in wrong_forces(document, drawn, links, k, mu) if text]
    wrong(found if seen else ["no vectors"])


# --- Zhukovsky's lever ---


def acts_at(key: str, drawn: Scheme) -> str:
    """The point of a load."""
    kind, sub = key.split("_", 1)
    if key == "F_stroke":  # the slider, or the end of the cylinder on the link that follows it
        return drawn.drive[0][1]
    if kind == "F" and "," in sub:  # of a spring or damper
        return sub.split(",")[1]
    return sub.split(",")[0] if kind == "P" else drawn.mass_centres[sub.removeprefix("I")]


def wrong_lever(document: dict[str, Any], drawn: Vectors, of: Scheme, k: int, scale: float) -> Iterator[str]:
    """The plan of velocities turned by 90° against the crank, at its scale; forces as they act, at their points."""
    speeds, loads, pole = rates(document, k), forces(document, k), drawn.poles[0]
    turn = -1j * np.sign(driving_speed(document, k))
    for vector in drawn.shown:
        if vector.key[0] == "v":
            yield off(vector, scale, turn * speeds[vector.key])
    acting = {key: force for key, force in loads.items() if key[0] != "R" and key != "F_bal"}
    largest = max(map(abs, acting.values()))
    for key in (key for key in acting if abs(acting[key]) > 1e-6 * largest):
        at = pole + turn * speeds.get(f"v_{acts_at(key, of)}", 0j) / scale
        for vector in drawn.of(key) or [Vector(key, pole, pole)]:
            if not near(vector.along, abs(vector.along) * loads[key] / abs(loads[key])) or not vector.along:
                yield f"{key} is {vector.along:.3f} mm, it acts along {np.degrees(np.angle(loads[key])):.1f}°"
            if not near(vector.start, at, 90.0):
                yield f"{key} begins at {vector.start:.3f}, its point is at {at:.3f}"


@pytest.mark.parametrize("name", LEVERS)
def test_every_vector_of_the_lever(name):
    note, document, found = html(name), results(name), []
    for figure in note.root.iter("figure"):
        caption = text_of(figure.find("figcaption"))  # type: ignore[arg-type]
        k = position_of(caption)
        if k is not None and ("Жуковск" in caption or "Zhukovsky" in caption):
            drawn = vectors(note.drawings[figure.get("id") or ""])
            scale = next(mu for _, _, mu in figures(note, "μ_v"))  # one for all plans
            found += [text for text in wrong_lever(document, drawn, scheme(name), k, scale) if text]
    wrong(found)
