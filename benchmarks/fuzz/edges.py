"""Mutations of the data towards the edges of mechanics: lengths that agree, points at one place, loads of all kinds."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

from mutations import LINKS, Data, Path, at, changed

LAWS: tuple[Data, ...] = (
    {"constant": 0}, {"constant": "1 kN"}, {"constant": 1e-9}, {"by_position": [1] * 12},
    {"by_position": [0, 5] * 6 + [1]}, {"by_angle": [[0, 0], ["180 deg", 100], ["360 deg", 0]]},
    {"by_angle": [["10 deg", 5]]}, {"by_angle": [["10 deg", 5], ["10 deg", 7]]},
    {"piston_diameter": "50 mm", "by_position": [0, 1e6] * 6},
    {"piston_diameter": "50 mm", "constant": "1 MPa"},
    {"by_displacement": {"zero": "right", "forward": [[0, 9], [1, 0]], "back": [[0, 0], [1, 9]]}},
    {"by_displacement": {"zero": "up", "forward": [[0, 9], [0.5, 1], [0.5, 4], [1, 0]], "back": [[1, 9]]}},
)  # fmt: skip
WAYS = ("right", "left", "up", "down", "along motion", "against motion", "30 deg", 0, "clockwise")
FRICTION: tuple[Data, ...] = (
    {}, {"pivots": {"coefficient": 0.1, "diameter": "20 mm"}}, {"guides": {"coefficient": 0.9, "length": "10 mm"}},
    {"pivots": {"coefficient": 1, "diameter": "1 m"}, "guides": {"coefficient": 1}, "corrected": True},
)  # fmt: skip


def _links(data: Data) -> Data:
    mechanism = data.get("mechanism")
    links = mechanism.get("links") if isinstance(mechanism, dict) else None
    return links if isinstance(links, dict) else {}


def _points(data: Data) -> list[Path]:
    """Places of the points of moving links that have a place of their own."""
    links = {name: link.get("points") for name, link in _links(data).items() if isinstance(link, dict)}
    return [
        (*LINKS, n, "points", p) for n, points in links.items() if isinstance(points, dict) for p in points
    ]


def _metres(value: Any) -> float | None:
    number, _, unit = str(value).partition(" ")
    try:
        return float(number) * {"": 1.0, "m": 1.0, "mm": 1e-3, "cm": 1e-2}[unit]
    except (ValueError, KeyError):
        return None


def agreeing(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """A length equal to another, to a sum or a difference of two: links that stretch or fold over one another."""
    sizes = {path: size for path in _points(data) if (size := _metres(at(data, path)))}
    if len(sizes) < 2:
        return data
    path, one, other = (random.choice(list(sizes)) for _ in range(3))
    size = random.choice((sizes[one], sizes[one] + sizes[other], abs(sizes[one] - sizes[other])))
    return changed(data, ((path, size * (1 + random.choice((0, 0, 1e-12, -1e-9, 1e-6, -1e-3)))),))


def coinciding(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """One more point of a link at the place of another, its mass centre perhaps, with a load."""
    points = _points(data)
    if not points:
        return data
    path = random.choice(points)
    changes: list[tuple[Path, Any]] = [((*path[:-1], "P0"), at(data, path))]
    if random.random() < 0.5:
        changes += [((*path[:3], "mass_centre"), "P0"), ((*path[:3], "mass"), "2 kg")]
    return changed(data, tuple(changes))


def loaded(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """Loads of every kind at points and links of the mechanism."""
    links = _links(data)
    names = [path[-1] for path in _points(data)] + ["B"]
    forces = [
        {"at": random.choice(names), "direction": random.choice(WAYS), **random.choice(LAWS)}
        for _ in range(2)
    ]
    if random.random() < 0.5 and links:
        forces[0]["on"] = random.choice(list(links))
    moments = [
        {"on": random.choice([*links, "0"]), "direction": random.choice(WAYS), **random.choice(LAWS[:8])}
    ]
    parts = {"forces": forces[: random.randrange(3)], "moments": moments[: random.randrange(2)]}
    return {
        **data,
        "loads": {**parts, "gravity": random.choice((9.81, 0, {"value": 5, "direction": "30 deg"}))},
    }


def rubbing(data: Data, random: Random, others: Sequence[Data]) -> Data:
    return {**data, "friction": random.choice(FRICTION)}


def without_masses(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """Some of the links without mass and moment of inertia."""
    kept = {
        name: {k: v for k, v in link.items() if k not in ("mass", "inertia")}
        for name, link in _links(data).items()
        if isinstance(link, dict) and random.random() < 0.7
    }
    return changed(data, tuple(((*LINKS, name), link) for name, link in kept.items()))
