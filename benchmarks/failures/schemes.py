"""Variants of one crank and one dyad, as a file states them, SI."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

Variant = dict[str, Any]


def variant(
    frame: Mapping[str, complex],
    links: Mapping[str, Any],
    assembly: Mapping[str, str],
    zero: float,
    table: int,
    **rest: Any,
) -> Variant:
    """`zero`: angle of the crank in position 0, degrees. `rest`: guides, sketch, range."""
    whole: Variant = {"frame": {name: _xy(z) for name, z in frame.items()}}
    driver: Variant = {
        "link": "1",
        "speed": 10.0,
        "rotation": "counter-clockwise",
        "zero": {"angle": math.radians(zero)},
    }
    if "range" in rest:
        driver["range"] = rest["range"]
    if "guides" in rest:
        whole["guides"] = rest["guides"]
    whole |= {"links": dict(links), "driver": driver}
    if assembly:
        whole["assembly"] = dict(assembly)
    if "sketch" in rest:
        whole["sketch"] = {name: _xy(z) for name, z in rest["sketch"].items()}
    return {
        "mechanism": whole,
        "loads": {"gravity": 9.81},
        "positions": {"table": table, "diagram": table},
        "allow_partial": True,
        "language": "en",
    }


def _xy(z: complex) -> list[float]:
    return [float(complex(z).real), float(complex(z).imag)]


def body(
    points: Mapping[str, complex] | Sequence[str], centre: str, mass: float, inertia: float = 0.0, **rest: Any
) -> Variant:
    places = {name: _xy(z) for name, z in points.items()} if isinstance(points, Mapping) else list(points)
    link: Variant = {"points": places, "mass": mass, "mass_centre": centre, **rest}
    return link | ({"inertia": inertia} if inertia else {})


def slider_crank(
    r: float, l: float, offset: float = 0.0, zero: float = 0.0, table: int = 12, **rest: Any
) -> Variant:
    """A central or offset slider-crank, B ahead; masses as of a machine of its size."""
    links = {
        "1": {"points": {"O": [0.0, 0.0], "A": [r, 0.0]}},
        "2": body({"A": 0, "B": l, "S2": 0.4 * l}, "S2", 1.0, 0.1 * l * l),
        "3": body(["B"], "B", 0.8, slides="x"),
    }
    frame = {"O": 0, "Q": 1j * offset}
    guides = {"x": {"through": "Q", "angle": 0.0}}
    return variant(frame, links, {"B": "+"}, zero, table, guides=guides, **rest)


def four_bar(
    a: float, b: float, c: float, f: float, zero: float, table: int = 12, side: str = "left", **rest: Any
) -> Variant:
    """Crank a, rod b, rocker c, frame f; B on a side of the line from A to the rocker's pivot."""
    links = {
        "1": {"points": {"O": [0.0, 0.0], "A": [a, 0.0]}},
        "2": body({"A": 0, "B": b, "S2": 0.4 * b}, "S2", 1.5, 0.1 * b * b),
        "3": body({"C": 0, "B": c, "S3": 0.5 * c}, "S3", 0.8, 0.1 * c * c),
    }
    return variant({"O": 0, "C": f}, links, {"B": f"{side} of A-C"}, zero, table, **rest)


def slotted(a: float, C: complex, offset: float, zero: float, table: int = 12, **rest: Any) -> Variant:
    """A slotted link turning about C, its slot `offset` from there, driven by the crank's pin."""
    links = {
        "1": {"points": {"O": [0.0, 0.0], "A": [a, 0.0]}},
        "2": body(["A"], "A", 0.3, slides="k"),
        "3": body({"C": 0, "K": 1j * offset, "S3": 0.15 + 0.02j}, "S3", 1.2, 0.01) if offset
        else body({"C": 0, "S3": 0.15 + 0.02j}, "S3", 1.2, 0.01),
    }  # fmt: skip
    guides = {"k": {"through": "K" if offset else "C", "link": "3", "angle": 0.0}}
    return variant({"O": 0, "C": C}, links, {"2-3": "+"}, zero, table, guides=guides, **rest)


def crossing(zero: float, table: int = 12) -> Variant:
    """A pin where a guide of the crank crosses a fixed one: they are parallel twice in a turn."""
    links = {
        "1": {"points": {"O": [0.0, 0.0], "A": [0.1, 0.0]}},
        "2": body(["B"], "B", 0.3, slides="m"),
        "3": body({"B": 0, "S3": 0.01 + 0.02j}, "S3", 1.2, slides="f"),
    }
    guides = {"f": {"through": "Q", "angle": 0.0}, "m": {"through": "O", "link": "1", "angle": 0.0}}
    return variant({"O": 0, "Q": 0.2j}, links, {}, zero, table, guides=guides)


def triad(zero: float, table: int, **rest: Any) -> Variant:
    """A group of class III with three pivots; the sketch holds at −134.64°. `zero`: rad."""
    links = {
        "1": {"points": {"O": [0.0, 0.0], "A": [0.0874, 0.0]}},
        "2": body({"A": 0, "B": 0.2905, "S2": 0.046 + 0.07j}, "S2", 1.57, 0.025),
        "3": body({"B": 0, "C": 0.0935, "D": 0.0319 + 0.1766j, "S3": 0.086 + 0.045j}, "S3", 2.18, 0.0058),
        "4": body({"C": 0, "E": 0.2554, "S4": 0.0735 - 0.0704j}, "S4", 3.15, 0.0336),
        "5": body({"D": 0, "F": 0.2108, "S5": 0.123 - 0.021j}, "S5", 3.25, 0.0196),
    }
    sketch = {"A": -0.0614 - 0.0622j, "B": 0.2092 + 0.0435j, "C": 0.1962 - 0.0491j, "D": 0.3796 - 0.0127j}
    frame = {"O": 0, "E": 0.13 - 0.296j, "F": 0.464 - 0.206j}
    return variant(frame, links, {}, math.degrees(zero), table, sketch=sketch, **rest)
