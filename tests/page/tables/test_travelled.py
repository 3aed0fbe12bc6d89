"""A main link that slides, in the results: its equation of motion, the derivatives of place and speed, its works."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from pages import table_of
from reading import CHOSEN, results, wrong

NAMES = [name for name in ("steam_hammer", "boom_by_cylinder") if name in CHOSEN]
CLOSE = 1e-6


def differ(name: str, one: np.ndarray, other: np.ndarray, close: float = CLOSE) -> Iterator[str]:
    for k in np.flatnonzero(~(np.abs(one - other) <= close * np.abs(other).max())):
        yield f"{name} in row {k} is {one[k]:.6g}, by the others {other[k]:.6g}"


def wrong_motion(document: dict[str, Any], table: str) -> Iterator[str]:
    rows = table_of(document, table)
    values = {one["key"]: one["value"] for one in document["values"]}
    m = rows.get("m_red", np.full(len(rows["t"]), values.get("travel_m_red")))
    forces = rows["F_dr"] + rows["F_red"] - rows["F_res"]
    yield from differ("F", rows["F"], forces, 1e-9)
    kinetic = m * rows["v"] ** 2 / 2
    yield from differ("A", rows["A"], kinetic - kinetic[0])
    inert = m * rows["a"] + rows.get("m_red_slope", 0 * m) * rows["v"] ** 2 / 2
    yield from differ("a", inert, rows["F"])
    if "omega" in rows:
        yield from differ("I_red", rows["I_red"] * rows["omega"] ** 2 / 2, kinetic)


def wrong_course(document: dict[str, Any]) -> Iterator[str]:
    """By the samples of the diagram: sums of trapezia."""
    rows = table_of(document, "travel_motion_diagram")
    values = {one["key"]: one["value"] for one in document["values"]}
    t, s, v = rows["t"], rows["s"], rows["v"]
    for name, found, other in (
        ("s", s[-1] - s[0], np.trapezoid(v, t)),
        ("v", v[-1] - v[0], np.trapezoid(rows["a"], t)),
        ("A", rows["A"][-1], np.trapezoid(rows["F"], s)),
        ("travel_t_end", values["travel_t_end"], t[-1]),
        ("travel_v_end", values["travel_v_end"], v[-1]),
        ("travel_v_max", values["travel_v_max"], v.max()),
        ("travel_gained", values["travel_gained"], rows["A"][-1]),
        ("travel_way", values["travel_way"], abs(s[-1] - s[0])),
    ):
        if abs(found - other) > 1e-3 * abs(other):
            yield f"{name} is {found:.6g}, by the samples {other:.6g}"
    if "m_red" in rows:
        slope = np.gradient(rows["m_red"][1:-1], s[1:-1], edge_order=2)
        yield from differ("m_red_slope", rows["m_red_slope"][1:-1], slope, 1e-2)


def wrong_works(document: dict[str, Any]) -> Iterator[str]:
    columns = {one["key"]: one["values"] for one in document["tables"]["travel_works"]["columns"]}
    works = dict(zip(columns["acting"], columns["A"], strict=True))
    gained, total = works.pop("gained"), works.pop("sum")
    size = max(map(abs, works.values()))
    if abs(total - sum(works.values())) > 1e-9 * size or abs(total - gained) > 1e-6 * size:
        yield f"works {works} make {sum(works.values())}, not {total} and {gained}"
    rows = table_of(document, "travel_motion_diagram")
    driving = works["force1"]
    if abs(driving - np.trapezoid(rows["F_dr"], rows["s"])) > 1e-3 * abs(driving):
        yield f"the driving force works {driving}"


@pytest.mark.parametrize("name", NAMES)
def test_motion_of_a_main_link_that_slides(name):
    document = results(name)
    wrong(list(wrong_motion(document, "travel_motion")))
    wrong(list(wrong_motion(document, "travel_motion_diagram")))
    wrong([*wrong_course(document), *wrong_works(document)])


def test_given_numbers_are_those_of_the_file():
    if "steam_hammer" not in CHOSEN:
        return
    values = {one["key"]: one["value"] for one in results("steam_hammer")["values"]}
    asked = {
        "travel_mass": 1000,
        "travel_wheels": 40,
        "travel_m_red": 1040,
        "travel_weight": 9810,
        "travel_end": 1.2,
    }
    assert {key: values[key] for key in asked} == pytest.approx(asked)
