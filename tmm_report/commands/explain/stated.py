"""Where a number that is given stands in the variant's file."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from tmm_report import yamlread
from tmm_report.mechanics.lever.stated_masses import PerLength, letters
from tmm_report.quantity.units import DIMENSIONS, UNITS, WrongValue, parse
from tmm_report.variant import closed

SAME = 1e-9  # relative difference below which a number is the one written


class Written(NamedTuple):
    """A value as the file has it: its line, its key with those around it, its text."""

    line: int
    key: str
    text: str


def stated(file: Path) -> list[tuple[Written, set[float]]]:
    """The values of a file with the sizes that each may have, in SI."""
    document = yamlread.read(file)
    places = document.places
    found = []
    for path, value in _scalars(document.data, ()):
        line = next((places[path[:n]][0] for n in range(len(path), 0, -1) if path[:n] in places), 1)
        found.append((Written(line, ".".join(map(str, path)), str(value)), _read(value)))
    return found


def written(values: list[tuple[Written, set[float]]], numbers: list[float], unit: str) -> list[Written]:
    """Those of the values that are one of the numbers, which are in `unit`."""
    si, _ = UNITS.get(unit, (1.0, None))
    wanted = {x * si for x in numbers if x}
    return [
        one
        for one, sizes in values
        if any(abs(size - abs(x)) <= SAME * abs(x) for size in sizes for x in wanted)
    ]


def _scalars(data: Any, path: tuple[Any, ...]) -> Iterator[tuple[tuple[Any, ...], Any]]:
    if isinstance(data, dict | list):
        for key, value in data.items() if isinstance(data, dict) else enumerate(data):
            yield from _scalars(value, (*path, key))
    elif isinstance(data, int | float | str) and not isinstance(data, bool):
        yield path, data


def _read(value: Any) -> set[float]:
    """The sizes that a value may have in SI: a text with a unit has one, by its own dimension; a mass by letters has
    that of a metre of the link."""
    found = set()
    for dimension in DIMENSIONS:
        try:
            found.add(abs(parse(value, dimension)))
        except WrongValue:
            continue
    with contextlib.suppress(WrongValue):
        found |= {one.value for one in letters(closed.mass(str(value))) if isinstance(one, PerLength)}
    return found
