"""Mistakes in the description of a mechanism, made on purpose: each kind of mistake at every place of a variant.

A variant is here what its YAML says: dicts, lists, texts and numbers. A kind yields (where, changes) for `changed`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import deepcopy
from itertools import combinations
from typing import Any

Data = dict[str, Any]
Path = tuple[str | int, ...]
Changes = tuple[tuple[Path, Any], ...]
Found = Iterator[tuple[str, Changes]]
GONE = object()


def changed(data: Data, changes: Changes) -> Data:
    """A copy with other values at these places; GONE takes the key out."""
    data = deepcopy(data)
    for path, value in changes:
        holder = at(data, path[:-1])
        if value is GONE:
            holder.pop(path[-1])
        else:
            holder[path[-1]] = deepcopy(value)
    return data


def at(data: Any, path: Path) -> Any:
    for part in path:
        data = data[part]
    return data


LINKS, GUIDES = ("mechanism", "links"), ("mechanism", "guides")
FRAME, DRIVER = ("mechanism", "frame"), ("mechanism", "driver")


def bare(data: Data) -> Data:
    """The mechanism alone: nothing else in the file refers to the parts that a mistake takes away."""
    mechanism = deepcopy(data["mechanism"])
    for link in mechanism["links"].values():
        for key in ("mass", "mass_centre", "inertia"):
            link.pop(key, None)
    return {"mechanism": mechanism}


def _links(data: Data) -> list[str]:
    return list(data["mechanism"]["links"])


def _guides(data: Data) -> list[str]:
    return list(data["mechanism"].get("guides", {}))


def _points(data: Data) -> list[Path]:
    """Places of the points of links and frame that have a place of their own."""
    found = [(*FRAME, point) for point in data["mechanism"]["frame"]]
    for link in _links(data):
        points = data["mechanism"]["links"][link]["points"]
        found += [(*LINKS, link, "points", point) for point in points if isinstance(points, dict)]
    return found


def _names(data: Data) -> list[str]:
    """Names of all points."""
    parts = [data["mechanism"]["frame"], *(link["points"] for link in data["mechanism"]["links"].values())]
    return list(dict.fromkeys(name for part in parts for name in part))


def _each(data: Data, paths: list[Path], *values: Any) -> Found:
    """Every value at every place."""
    for path in paths:
        for value in values:
            shown = "gone" if value is GONE else value
            yield f"{'.'.join(map(str, path))} = {shown}", ((path, value),)


def _swapped(data: Data, pairs: Iterator[tuple[Path, Path]]) -> Found:
    """The values of two places exchanged."""
    for one, other in pairs:
        values = (one, at(data, other)), (other, at(data, one))
        yield f"{'.'.join(map(str, one))} <-> {'.'.join(map(str, other))}", values


def dropped_links(data: Data) -> Found:
    yield from _each(data, [(*LINKS, link) for link in _links(data)], GONE)


def doubled_links(data: Data) -> Found:
    """The same link once more, joined to the same points, or hung on the first of them only."""
    for link in _links(data):
        copy = deepcopy(data["mechanism"]["links"][link])
        yield f"{link} twice", (((*LINKS, "99"), deepcopy(copy)),)
        if copy["points"] and isinstance(copy["points"], dict):
            first = next(iter(copy["points"]))
            copy["points"] = {name if name == first else f"{name}9": x for name, x in copy["points"].items()}
            copy.pop("mass_centre", None)
            yield f"{link} again on {first}", (((*LINKS, "99"), deepcopy(copy)),)


def dropped_points(data: Data) -> Found:
    yield from _each(data, _points(data), GONE)


def moved_points(data: Data) -> Found:
    """Zero, negative, tiny and huge lengths."""
    own = [path for path in _points(data) if path[:2] == LINKS]
    yield from _each(data, own, 0, [0, 0], "-100 mm", ["-100 mm", "1 mm"], 2e-9, "50 km", 1e300)
    fixed = [path for path in _points(data) if path[:2] == FRAME]
    yield from _each(data, fixed, [0, 0], [100, "-3 km"], [2e-9, 0], [1e200, 1e200])


def swapped_points(data: Data) -> Found:
    """Two points of one link in each other's place."""
    pairs = combinations(_points(data), 2)
    yield from _swapped(data, ((a, b) for a, b in pairs if a[:-1] == b[:-1]))


def renamed_points(data: Data) -> Found:
    """A point of a link takes another point's name: joints come apart and fall together."""
    for path in _points(data):
        for name in _names(data):
            holder = dict(at(data, path[:-1]))
            if name not in holder:
                holder = {name if key == path[-1] else key: value for key, value in holder.items()}
                yield f"{'.'.join(map(str, path))} -> {name}", ((path[:-1], holder),)


def changed_guides(data: Data) -> Found:
    paths = [(*GUIDES, guide) for guide in _guides(data)]
    yield from _each(data, paths, GONE)
    yield from _each(data, [(*path, "link") for path in paths], *_links(data))
    yield from _each(data, [(*path, "angle") for path in paths], 0, "90 deg", "45 deg")
    yield from _each(data, [(*path, "through") for path in paths], *_names(data))
    for guide in _guides(data):
        renamed = {"r" if key == guide else key: value for key, value in at(data, GUIDES).items()}
        yield f"{guide} -> r", ((GUIDES, renamed),)


def changed_slides(data: Data) -> Found:
    links = data["mechanism"]["links"]
    paths = [(*LINKS, link, "slides") for link in links if "slides" in links[link]]
    yield from _each(data, paths, GONE)
    yield from _swapped(data, combinations(paths, 2))
    every = [(*LINKS, link, "slides") for link in links]
    turned = [{"guide": guide, "angle": "90 deg"} for guide in _guides(data)]
    yield from _each(data, every, *_guides(data), _guides(data), *turned)


def changed_masses(data: Data) -> Found:
    links = data["mechanism"]["links"]
    for key in ("mass", "mass_centre", "inertia"):
        yield from _each(data, [(*LINKS, link, key) for link in links if key in links[link]], GONE)
    yield from _each(data, [(*LINKS, link, "mass") for link in links], 0, "-1 kg", 1e300)
    yield from _each(data, [(*LINKS, link, "mass_centre") for link in links], *_names(data)[:3])
    yield from _each(data, [(*LINKS, link, "inertia") for link in links], "5000 kg*m^2")


def changed_driver(data: Data) -> Found:
    yield from _each(data, [(*DRIVER, "link")], *_links(data), "0")
    yield from _each(data, [(*DRIVER, "range")], "90 deg", "1 deg", "360 deg", "400 deg", 0)
    yield from _each(data, [(*DRIVER, "rotation")], "clockwise", "counter-clockwise")
    for key in ("speed", "period"):
        if key in at(data, DRIVER):
            yield from _each(data, [(*DRIVER, key)], GONE, 0, -5, 1e200, 1e-200)


def changed_zero(data: Data) -> Found:
    zeros: list[Any] = [{"point": name, "extreme": "up"} for name in _names(data)]
    zeros += [{"link": link, "extreme": "clockwise"} for link in _links(data)]
    zeros += [GONE] if "zero" in at(data, DRIVER) else []
    yield from _each(data, [(*DRIVER, "zero")], {"angle": "180 deg"}, {"angle": "-1 deg"}, *zeros)


def changed_assembly(data: Data) -> Found:
    mechanism = data["mechanism"]
    stated = [("mechanism", "assembly", key) for key in mechanism.get("assembly", {})]
    yield from _each(data, stated, GONE, "right", "left", "up", "down", "+", "-", "left of A-B")
    yield from _each(
        data, [("mechanism", "sketch", key) for key in mechanism.get("sketch", {})], GONE, [0, 0]
    )
    whole = [("mechanism", key) for key in ("assembly", "sketch") if key in mechanism]
    yield from _each(data, whole, GONE)
    for name in _names(data):
        cut = [(path, GONE) for path in whole]
        yield f"sketch of {name} only", (*cut, (("mechanism", "sketch"), {name: [0, "1 mm"]}))


def changed_loads(data: Data) -> Found:
    yield from _each(data, [("loads",)] if "loads" in data else [], GONE)
    if "loads" in data:
        yield from _each(data, [("loads", "gravity")], 0, 1e150)
        forces = [("loads", "forces", i) for i in range(len(data["loads"].get("forces", [])))]
        yield from _each(data, [(*path, "at") for path in forces], *_names(data))
        motion = [{"at": n, "direction": "against motion", "constant": "1 N"} for n in _names(data)]
        yield from _each(data, [("loads", "forces")], *([force] for force in motion), [])
        resisted = [{"on": link, "direction": "against motion", "constant": 1} for link in _links(data)]
        yield from _each(data, [("loads", "moments")], *([moment] for moment in resisted))


def changed_rest(data: Data) -> Found:
    """Counts of positions, scales and friction that are allowed and odd."""
    counts: list[Data] = [{"table": 4, "diagram": 4}, {"table": 7, "diagram": 5, "plans": [0]}, {"plans": []}]
    yield from _each(data, [("positions",)], *counts)
    scales = {"length": 1e-9, "velocity": 1e9, "acceleration": 1e-9, "force": 1e-12}
    yield from _each(data, [("drawing",)], {"accuracy": "2 mm"}, {"scales": scales})
    rubbing = {"pivots": {"coefficient": 0, "diameter": "1 mm"}, "guides": {"coefficient": 0.9}}
    yield from _each(data, [("friction",)], {}, rubbing)


KINDS: tuple[Callable[[Data], Found], ...] = (
    dropped_links, doubled_links, dropped_points, moved_points, swapped_points, renamed_points, changed_guides,
    changed_slides, changed_masses, changed_driver, changed_zero, changed_assembly, changed_loads, changed_rest,
)  # fmt: skip
