"""Tables of a note found as a reader finds them, by the symbols and units of their heads; numbers of results.json."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from note import Note, Table
from printed import unit

BALANCING = ("M_bal", "M_ур")


class Series(NamedTuple):
    """A printed column by positions in SI, and half a unit of its last place."""

    values: np.ndarray
    half: np.ndarray
    unit: str

    @property
    def known(self) -> np.ndarray:
        return np.isfinite(self.values)


def by_positions(table: Table) -> bool:
    return table.heads[0].text in ("Position", "Положение") and len(table.rows) > 2


def series(table: Table, j: int) -> Series:
    """A column in SI. Raises ValueError where it is not of numbers."""
    text = table.heads[j].unit_text
    of = unit(text) if text else unit("")
    if of is None:
        raise ValueError(text)
    cells, places = table.numbers(j), table.places(j)
    half = [0.5 * 10.0**-places if x.places or x.value == 0 else x.half for x in cells]
    half = [min(h, 0.5 * 10.0**-places) if places else h for h in half]
    return Series(np.array([x.value for x in cells]) * of.factor, np.array(half) * of.factor, text)


def columns(note: Note) -> dict[str, list[tuple[Table, Series]]]:
    """Symbol of a head -> the columns by positions under it, each with its table."""
    found: dict[str, list[tuple[Table, Series]]] = {}
    for table in note.tables:
        if by_positions(table):
            for j, head in enumerate(table.heads[1:], 1):
                if head.symbol and (not head.unit_text or head.unit is not None):
                    found.setdefault(head.symbol, []).append((table, series(table, j)))
    return found


def rows_of(note: Note, *symbols: str) -> Iterator[Table]:
    """Tables that have all of these symbols among their heads."""
    for table in note.tables:
        if set(symbols) <= {head.symbol for head in table.heads}:
            yield table


def last_number(caption: str) -> int:
    """The position that a caption names."""
    return int(re.findall(r"\d+", caption)[-1])


def turned_link(index: str) -> str:
    """The link of a moment by the index of its letter: 3, 3,2 of the second, k1,3 of a torsion spring."""
    first, _, last = index.partition(",")
    return last if last and first.startswith("k") else first


def table_of(document: dict[str, Any], name: str) -> dict[str, np.ndarray]:
    """The numbers of a table of results.json by their keys, None as nan; angles in radians."""
    return {
        column["key"]: np.array([math.nan if x is None else x for x in column["values"]], float)
        * (math.pi / 180 if column["unit"] == "deg" else 1.0)
        for column in document["tables"][name]["columns"]
        if not any(isinstance(x, str) for x in column["values"])
    }


def value_of(document: dict[str, Any], key: str) -> float:
    return next(entry["value"] for entry in document["values"] if entry["key"] == key)


def by_law(document: dict[str, Any]) -> bool:
    """Whether the driving link moves by a law of the time: no angular velocity of it is stated."""
    return any(entry["key"] == "law_time" for entry in document["values"])


def driving_speed(document: dict[str, Any], k: int | slice) -> Any:
    """Angular velocity of the driving link, called 1 where it moves by a law, at table positions, rad/s."""
    return table_of(document, "rates_table")["w_1"][k] if by_law(document) else value_of(document, "omega")
