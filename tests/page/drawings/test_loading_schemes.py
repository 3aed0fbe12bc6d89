"""Loading schemes and Zhukovsky's lever measured on the paper: arms as long as printed, forces as they act."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from captions import figures, position_of
from note import Note, text_of
from pages import table_of
from reading import LEVERS, html, results, wrong
from vectors import Vector, Vectors, forces, vectors

MEASURED = 0.1  # mm: to this an arm on the paper is what is printed
SEEN = 0.6  # mm: a shorter arm may be left out
LOADING = re.compile("Loading of|Схема нагружения")
LEVER = re.compile("Zhukovsky|Жуковск")
TURNED = 1.5  # degrees: an arrow of 10 mm is drawn to a thousandth, a reaction read to a step


def columns(document: dict[str, Any], name: str) -> dict[str, list[Any]]:
    return {column["key"]: column["values"] for column in document["tables"][name]["columns"]}


def schemes(note: Note) -> Iterator[tuple[str, int, Vectors]]:
    """Anchor, position and vectors of every loading scheme."""
    for anchor, caption, _ in figures(note, "μ_l"):
        k = position_of(caption)
        if LOADING.search(caption) and k is not None:
            yield anchor, k, vectors(note.drawings[anchor])


def arms_of(document: dict[str, Any], k: int) -> dict[str, list[float]]:
    """Arms as printed, mm, by the letters of force and point; of one force about one point on two links several."""
    table, found = columns(document, f"arms_{k}"), {}
    for force, about, mm in zip(table["force"], table["about"], table["arm_mm"], strict=True):
        found.setdefault(f"h_{force}_{about}", []).append(mm)
    return found


def printed_arms(vector: Vector, arms: dict[str, list[float]]) -> list[float]:
    """Of a link alone the name of its arm ends in the link."""
    return arms.get(vector.key) or arms.get(vector.key.rsplit("_", 1)[0], [])


def wrong_arms(drawn: Vectors, arms: dict[str, list[float]]) -> Iterator[str]:
    for vector in (v for v in drawn.shown if v.key.startswith("h_")):
        printed = printed_arms(vector, arms)
        if not any(abs(abs(vector.along) - mm) <= MEASURED for mm in printed):
            yield f"{vector.key} is {abs(vector.along):.3f} mm on the paper, printed {printed}"


def turned(one: complex, other: complex) -> float:
    """Angle between two directions, degrees."""
    return abs(np.degrees(np.angle(one / other)))


def wrong_ways(drawn: Vectors, expected: dict[str, complex]) -> Iterator[str]:
    """Whole forces act as by the results; a component has the sense of what it is a part of."""
    largest = max(map(abs, expected.values()), default=0.0)
    for vector in (v for v in drawn.shown if v.key in expected and abs(expected[v.key]) > 1e-3 * largest):
        if turned(vector.along, expected[vector.key]) > TURNED:
            yield f"{vector.key} points to {np.degrees(np.angle(vector.along)):.1f}°"
    for vector in drawn.shown:
        whole, _, part = vector.key.rpartition("_")
        if whole not in expected or abs(expected[whole]) < 1e-2 * largest or part not in "xytn":
            continue
        along = (expected[whole] * vector.along.conjugate()).real / abs(vector.along)
        if along < -0.02 * abs(expected[whole]):
            yield f"{vector.key} points against its reaction"


@pytest.mark.parametrize("name", LEVERS)
def test_arms_and_forces_of_loading_schemes(name):
    note, document, found = html(name), results(name), []
    seen: dict[int, set[str]] = {}
    for anchor, k, drawn in schemes(note):
        seen.setdefault(k, set()).update(v.key for v in drawn.shown)
        arms = arms_of(document, k)
        off = [*wrong_arms(drawn, arms), *wrong_ways(drawn, forces(document, k))]
        found += [f"{anchor}: {text}" for text in off]
    for k in (int(key[5:]) for key in document["tables"] if re.fullmatch(r"arms_\d+", key)):
        names = set(seen.get(k, ())) | {n.rsplit("_", 1)[0] for n in seen.get(k, ())}
        missing = [key for key, mm in arms_of(document, k).items() if max(mm) > SEEN and key not in names]
        found += [f"position {k}: the arms {missing} are not drawn"] if missing else []
    wrong(found)


@pytest.mark.parametrize("name", LEVERS)
def test_arms_of_a_short_note_are_as_long_at_the_scales_that_it_states(name):
    note, document, found = html(name, depth="short"), results(name), []
    own = next(value["value"] for value in document["values"] if value["key"] == "mu_l")
    for anchor, caption, mu in figures(note, "μ_l"):
        k = position_of(caption)
        if LOADING.search(caption) and k is not None:
            drawn = {key: [mm * own / mu for mm in arms] for key, arms in arms_of(document, k).items()}
            off = wrong_arms(vectors(note.drawings[anchor]), drawn)
            found += [f"{anchor}: {text}" for text in off]
    wrong(found)


# --- Zhukovsky's lever ---


def lever_figures(note: Note) -> Iterator[tuple[int, Vectors]]:
    for figure in note.root.iter("figure"):
        caption = text_of(figure.find("figcaption"))  # type: ignore[arg-type]
        k = position_of(caption)
        if k is not None and LEVER.search(caption):
            yield k, vectors(note.drawings[figure.get("id") or ""])


@pytest.mark.parametrize("name", LEVERS)
def test_arms_of_the_lever(name):
    note, document, found = html(name), results(name), []
    for k, drawn in lever_figures(note):
        table = columns(document, f"lever_arms_{k}")
        arms = {f"h_{force}_p": [mm] for force, mm in zip(table["force"], table["arm_mm"], strict=True)}
        found += wrong_arms(drawn, arms)
        lettered = {v.key for v in drawn.shown}
        pairs = {force for force in table["force"] if force.startswith("F_M")} | {"P_bal"}
        found += [
            f"{force}: its arm is not drawn"
            for force, mm in zip(table["force"], table["arm_mm"], strict=True)
            if mm > SEEN and force not in pairs and f"h_{force}_p" not in lettered
        ]
    wrong(found)


@pytest.mark.parametrize("name", LEVERS)
def test_the_lever_is_in_balance_as_printed(name):
    """Force times arm is the moment; the moments with the balancing one add up to nothing."""
    document, found = results(name), []
    for key in (key for key in document["tables"] if re.fullmatch(r"lever_arms_\d+", key)):
        table, k = columns(document, key), key.rsplit("_", 1)[1]
        sizes, arms, moments = (np.array(table[column]) for column in ("size", "arm_mm", "moment"))
        slack = 1e-5 * np.abs(moments).sum() + 1e-9
        if np.any(np.abs(sizes * arms - np.abs(moments)) > 2e-4 * np.abs(moments) + 1e-9):
            found.append(f"{key}: a moment is not its force times its arm")
        if abs(moments.sum()) > 10 * slack:
            found.append(f"{key}: the moments add up to {moments.sum():.5g}")
        thrust = "drive_table" in document["tables"]  # a force along the stroke in place of a moment
        other = columns(document, f"lever_compared_{k}")
        balancing = table_of(document, "drive_table" if thrust else "balancing_table")
        beside = dict(zip(other["way"], other["force" if thrust else "moment"], strict=True))
        letter = "F_stroke", "F_power"
        for way, column in zip(
            ("analytic", "power"), letter if thrust else ("M_bal", "M_power"), strict=True
        ):
            if abs(beside[way] - balancing[column][int(k)]) > 1e-9 * abs(beside[way]):
                found.append(f"lever_compared_{k} is compared with another moment: {way}")
    wrong(found)
