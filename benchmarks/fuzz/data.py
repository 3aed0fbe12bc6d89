"""Mutations of the data of a variant: keys dropped, doubled, moved and exchanged, values of other kinds, long lists."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from copy import deepcopy
from random import Random
from typing import Any

from mutations import GONE, KINDS, Data, Path, at, changed

from benchmarks.fuzz.edges import agreeing, coinciding, loaded, rubbing, without_masses
from benchmarks.fuzz.words import HOSTILE, NUMBERS, UNITS

POSITIONS: tuple[Data, ...] = (
    {"table": 4, "diagram": 4}, {"table": 360, "diagram": 720}, {"table": 360, "plans": list(range(0, 361, 10))},
    {"table": 12, "plans": list(range(13)), "force_plan": list(range(13))}, {"table": 5, "diagram": 7, "plans": 5},
    {"table": 361}, {"table": 3}, {"table": 0}, {"table": -1}, {"table": 12.5}, {"plans": [400]}, {"plans": []},
    {"diagram": 721}, {"table": 24, "diagram": 24, "force_plan": 24}, {"plans": [1, 1, 1, 1]}, {"table": 1e9},
)  # fmt: skip
TURNS = (
    {"range": "1 deg"}, {"range": "0.001 deg"}, {"range": "359.999 deg"}, {"range": "360 deg"}, {"turns": 4},
    {"turns": 2}, {"rotation": "clockwise"}, {"rotation": "counter-clockwise"}, {"speed": 1e-12}, {"speed": 1e6},
    {"zero": {"angle": 1}}, {"zero": {"angle": 1e9}},
)  # fmt: skip
VALUES: tuple[Any, ...] = (
    None, True, False, 0, -1, 1, 1e300, -1e-300, "", "x", [], {}, [[]], [{}], {"x": {}}, [0, 0], [1, 2, 3], "0", 10**30,
    "5 mm", [None], {"0": 0}, 1e-9, "along motion", "right", [[0, 0], [1, 1]], "1/0",
)  # fmt: skip

Mutation = Callable[[Data, Random, Sequence[Data]], Data]


def places(data: Any, path: Path = ()) -> list[Path]:
    """Paths of everything in the data."""
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    found: list[Path] = []
    for key, inner in items:
        found += [(*path, key), *places(inner, (*path, key))]
    return found


def _one(data: Data, random: Random) -> Path | None:
    found = places(data)
    return random.choice(found) if found else None


def dropped(data: Data, random: Random, others: Sequence[Data]) -> Data:
    path = _one(data, random)
    return changed(data, ((path, GONE),)) if path else data


def replaced(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """A value of another kind, a number or a text from nowhere."""
    path = _one(data, random)
    value = random.choice((random.choice(VALUES), random.choice(NUMBERS), random.choice(HOSTILE)))
    return changed(data, ((path, value),)) if path else data


def scaled(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """A number ten times as large some times over, negative or nothing; a text of one in another unit."""
    paths = [path for path in places(data) if _number(at(data, path))]
    if not paths:
        return data
    path = random.choice(paths)
    value, _, unit = str(at(data, path)).partition(" ")
    number = float(value) * random.choice((0, -1, 10.0 ** random.randint(-12, 12), random.uniform(0.2, 5)))
    unit = random.choice(UNITS) if random.random() < 0.2 else unit
    return changed(data, ((path, f"{number:.12g} {unit}".strip()),))


def _number(value: Any) -> bool:
    head = str(value).split(" ")[0].replace(".", "", 1).removeprefix("-")
    return not isinstance(value, bool | dict | list) and head.isascii() and head.isdigit()


def exchanged(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """Two values in each other's place."""
    one, other = _one(data, random), _one(data, random)
    if one is None or other is None or one[: len(other)] == other or other[: len(one)] == one:
        return data
    return changed(data, ((one, at(data, other)), (other, at(data, one))))


def moved(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """A key with all that is in it put into another mapping, under its own name or another."""
    path = _one(data, random)
    holders = [p for p in [(), *places(data)] if isinstance(at(data, p), dict) and at(data, p)]
    if path is None or not holders:
        return data
    home = random.choice(holders)
    name = str(path[-1]) if random.random() < 0.7 else random.choice(HOSTILE)
    return changed(data, (((*home, name), at(data, path)),))


def renamed(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """A key, or a name wherever it stands in the file, called otherwise."""
    path = _one(data, random)
    if path is None:
        return data
    every = [str(key) for other in (data, random.choice(others)) for p in places(other) for key in p[-1:]]
    new = random.choice(every) if random.random() < 0.6 else random.choice(HOSTILE)
    return json.loads(json.dumps(_called(data, str(path[-1]), new, random.random() < 0.5)))


def _called(value: Any, old: str, new: str, words: bool) -> Any:
    if isinstance(value, dict):
        return {new if key == old else key: _called(inner, old, new, words) for key, inner in value.items()}
    if isinstance(value, list):
        return [_called(inner, old, new, words) for inner in value]
    return new if words and value == old else value


def lengthened(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """A list many times as long, or a mapping with many more keys of the same kind."""
    paths = [path for path in places(data) if isinstance(at(data, path), list | dict) and at(data, path)]
    if not paths:
        return data
    path, times = random.choice(paths), random.choice((2, 3, 20, 200))
    inside = at(data, path)
    if isinstance(inside, list):
        return changed(data, ((path, inside * times),))
    more = {f"{key}{k}": value for k in range(min(times, 60)) for key, value in list(inside.items())[:3]}
    return changed(data, ((path, {**inside, **more}),))


def odd_positions(data: Data, random: Random, others: Sequence[Data]) -> Data:
    return {**data, "positions": deepcopy(random.choice(POSITIONS))}


def odd_driver(data: Data, random: Random, others: Sequence[Data]) -> Data:
    driver = data.get("mechanism", {}).get("driver") if isinstance(data.get("mechanism"), dict) else None
    return changed(data, ((("mechanism", "driver"), {**driver, **random.choice(TURNS)}),)) if driver else data


def block_of_another(data: Data, random: Random, others: Sequence[Data]) -> Data:
    other = random.choice(others)
    key = random.choice(list(other))
    return {**data, key: deepcopy(other[key])}


def meant(data: Data, random: Random, others: Sequence[Data]) -> Data:
    """A mistake that a person makes in the description of a mechanism (`tests/variant/mutations.py`)."""
    try:
        changes = [changes for _, changes in random.choice(KINDS)(data)]
        return changed(data, random.choice(changes)) if changes else data
    except (KeyError, TypeError, AttributeError, ValueError, IndexError):
        return data  # a mutation before has broken what it wants


MUTATIONS: tuple[Mutation, ...] = (
    dropped, dropped, replaced, replaced, scaled, scaled, scaled, scaled, exchanged, moved, renamed, renamed,
    lengthened, odd_positions, odd_driver, block_of_another, block_of_another, meant, meant, meant, agreeing, agreeing,
    agreeing, coinciding, loaded, loaded, rubbing, without_masses,
)  # fmt: skip


def mutated(data: Data, random: Random, others: Sequence[Data]) -> tuple[str, str]:
    """The text of the data with one to four mutations on one another, and their names."""
    chosen = [random.choice(MUTATIONS) for _ in range(random.choice((1, 1, 1, 2, 2, 4)))]
    for mutation in chosen:
        data = mutation(data, random, others)
    return json.dumps(data, ensure_ascii=False, indent=1), " ".join(mutation.__name__ for mutation in chosen)
