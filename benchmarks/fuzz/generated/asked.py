"""What asks for a look at the whole variant: springs and dampers between its points, a question asked backwards."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import Any

Made = dict[str, Any]
Path = tuple[str | int, ...]
DEMANDED = {"loads": "balancing_table.M_bal.max", "flywheel": "flywheel_J"}


def tied(data: Made, random: Random) -> None:
    """Springs and dampers hold points of two links, or of one and the frame; each spring has one datum."""
    links, frame = data["mechanism"]["links"], list(data["mechanism"]["frame"])
    loads = data.get("loads", {})
    for one in loads.get("torsion_springs", ()):
        last = [*links][-1]
        one["links"] = random.choice(([last, 0], [0, last]))
    named = {name: set(link["points"]) for name, link in links.items()}
    for one in (*loads.get("springs", ()), *loads.get("dampers", ())):
        link = random.choice([*links])
        first = random.choice(
            [name for name in links[link]["points"] if name not in frame] or [*links[link]["points"]]
        )
        near = set().union(*(points for points in named.values() if first in points))
        far = sorted({*frame, *set().union(*named.values())} - near)
        if not far:
            continue
        one["between"] = [first, random.choice(far)]
        if "on" in one:
            one["on"] = {one["between"][0]: link}
        if "stiffness" in one:
            _datum(one, random)


def rising(made: Made, walk: Any) -> Made:
    """Velocities of sliding ascend."""
    if "by_speed" in made:
        made["by_speed"] = [[f"{k / 10} m/s", one[1]] for k, one in enumerate(made["by_speed"])]
    return made


def _datum(spring: Made, random: Random) -> None:
    places = [key for key in ("at_length", "at_position") if key in spring]
    for key in places if "preload" not in spring else places[1:]:
        del spring[key]
    if "at_position" in spring:
        spring["at_position"] = random.randint(0, 3)
    if "preload" in spring:
        spring.pop("free_length", None)
    else:
        spring.setdefault("free_length", f"{random.uniform(0.05, 0.3):.3g} m")


def backwards(data: Made, random: Random) -> None:
    """A number of the variant is sought about what it is, for one that its blocks have."""
    keys = [key for block, key in DEMANDED.items() if block in data]
    if not keys:
        return
    path, number, unit = random.choice([*_numbers(data, ())] or [(("speed",), 1.0, "")])
    low, high = sorted((0.8 * number, 1.25 * number))
    key = random.choice(keys)
    demand: Made = random.choice(({"so_that": {key: 1.0}}, {"greatest": key}, {"least": key}))
    name = ".".join(str(part) for part in path)
    ends = [f"{end:.6g} {unit}".strip() for end in (low, high)]
    data["find"] = {"unknown": {name: random.choice((" .. ".join(ends), ends))}, **demand}
    if random.random() < 0.6:
        data["find"]["choose"] = random.choice(("first", "last", 1, 2))


def _numbers(data: Any, path: Path) -> Iterator[tuple[Path, float, str]]:
    """Every number of the data with its path and unit."""
    if isinstance(data, dict | list):
        for key, inner in data.items() if isinstance(data, dict) else enumerate(data):
            yield from _numbers(inner, (*path, key))
    elif isinstance(data, str):
        number, _, unit = data.partition(" ")
        try:
            yield path, float(number), unit
        except ValueError:
            return
