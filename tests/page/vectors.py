"""Vectors of a drawing that say of which quantity they are, and the same vectors by results.json."""

from __future__ import annotations

from typing import Any, NamedTuple
from xml.etree.ElementTree import Element, fromstring

import numpy as np
from pages import table_of
from picture import SVG, led, place, points

POLE = 0.8  # radius of the dot of a pole, mm
NEAR, SHARE = 0.12, 0.004  # mm, and share of a vector: what readings by a pencil may add up to


class Vector(NamedTuple):
    """mm of paper, y up; on its line. `by`: how far from it it is drawn."""

    key: str
    start: complex
    tip: complex
    by: complex = 0j

    @property
    def along(self) -> complex:
        return self.tip - self.start


class Vectors(NamedTuple):
    """`letters`: place and text of all lettering."""

    shown: list[Vector]
    poles: list[complex]
    letters: list[tuple[complex, str]]

    def of(self, key: str) -> list[Vector]:
        return [vector for vector in self.shown if vector.key == key]


def vectors(svg: str) -> Vectors:
    nodes = list(fromstring(svg).iter())
    shown = [_vector(node) for node in nodes if node.tag == SVG + "g" and node.get("data-q")]
    dots = [node for node in nodes if node.tag == SVG + "circle" and float(node.get("r", "0")) == POLE]
    letters = [
        (_place(node, "x", "y"), "".join(node.itertext())) for node in nodes if node.tag == SVG + "text"
    ]
    return Vectors(shown, [_place(node, "cx", "cy") for node in dots], letters + led(nodes))


def _vector(group: Element) -> Vector:
    """A line and the triangle that follows it, its tip first; back on its line, if it is drawn beside it."""
    shaft, head = (points(path) for path in group)
    along = head[0] - shaft[0]
    by = 1j * float(group.get("data-aside", "0")) * along / abs(along)
    return Vector(group.get("data-q", ""), shaft[0] - by, head[0] - by, by)


def _place(node: Element, x: str, y: str) -> complex:
    return place(node.get(x, "0"), node.get(y, "0"))


def near(one: complex, other: complex, size: float = 30.0) -> bool:
    """Within what readings add up to beside vectors of this size."""
    return abs(one - other) <= NEAR + SHARE * max(abs(one), abs(other), size)


# --- by the results ---


def components(document: dict[str, Any], table: str, k: int) -> dict[str, complex]:
    """The vectors of a table at a position, SI; nan where there is none."""
    found = table_of(document, table)
    return {key: complex(found[key + "_x"][k], found[key + "_y"][k]) for key in found if key + "_x" in found}


def rates(document: dict[str, Any], k: int) -> dict[str, complex]:
    """Velocities and accelerations, the whole relative accelerations among them."""
    found = components(document, "rates_table", k)
    for key in list(found):
        for one, other in (("_n", "_t"), ("_k", "_r")):
            if key.endswith(one) and key.removesuffix(one) + other in found:
                found.setdefault(key.removesuffix(one), found[key] + found[key.removesuffix(one) + other])
    return found


def forces(document: dict[str, Any], k: int) -> dict[str, complex]:
    """Loads, and reactions both ways: R_21 is -R_12."""
    found = components(document, "loads_table", k)
    for key, force in components(document, "reactions_table", k).items():
        found[key] = force
        found[turned_round(key)] = -force
    if "gear_table" in document["tables"]:  # the force of the gear that turns the driving link
        teeth = table_of(document, "gear_table")
        found["F_bal"] = complex(teeth["F_bal"][k] * np.exp(1j * teeth["alpha_F_bal"][k]))
    if (
        "drive_table" in document["tables"]
    ):  # along the guide, or from the fixed end of the cylinder to the other
        of = {value["key"]: value["value"] for value in document["values"]}
        way = of.get("stroke_gamma", table_of(document, "stroke_table")["stroke_psi"][k])
        found["F_stroke"] = table_of(document, "drive_table")["F_stroke"][k] * np.exp(1j * way)
    return found


def turned_round(key: str) -> str:
    """R_21 of R_12, R_11,10 of R_10,11."""
    sub = key.split("_", 1)[1]
    if "," in sub:
        one, other = sub.split(",")
        return f"R_{other},{one}"
    return f"R_{sub[len(sub) // 2 :]}{sub[: len(sub) // 2]}"


def written(document: dict[str, Any], name: str) -> dict[str, float]:
    """Numbers of a calculation by hand by their keys."""
    columns = {column["key"]: column["values"] for column in document["tables"][name]["columns"]}
    return dict(zip(columns["key"], columns["value"], strict=True))


def off(vector: Vector, scale: float, expected: complex) -> str:
    """What is wrong with a vector drawn at a scale, "" if nothing."""
    wanted = expected / scale
    if not np.isfinite(wanted):
        return f"{vector.key} is drawn but is nothing in the results"
    same = near(vector.along, wanted)
    return "" if same else f"{vector.key} is {vector.along:.3f} mm, by the results {wanted:.3f} mm"
