"""Tables of the results -> the columns of numbers that a person may be asked for."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import numpy as np

from tmm_report.judging.model import Asked
from tmm_report.quantity.model import Column, Table, Value

POSITION = "position"
ANGLES = ("deg", "rad")
_OF_CHECKS = re.compile("_disagreement|digits|sin_|closeness")
"""Parts of the keys of what the program says of its own exactness: nobody is asked for it."""
_ANOTHERS = re.compile("comparison|readings|special|segments|plan_values|senses|rejected|solutions")
"""Parts of the names of tables that hold what another hand has drawn, or lists of what was found on the way."""


def of_table(table: Table, chapter: str) -> Iterator[Asked]:
    """The columns of numbers of a table; none of one at the positions of the diagrams, which are those of the tables
    at more positions, and of one whose rows measure different things."""
    if table.name.endswith("_diagram") or "unit" in table or _ANOTHERS.search(table.name):
        return
    by_position = POSITION in table
    rows = tuple(map(str, table[POSITION].values)) if by_position else _labels(table)
    for column in table.columns:
        if _is_number(column) and column.asked and not _OF_CHECKS.search(column.key):
            yield Asked(
                table.name,
                column.quantity,
                np.array(column.values, dtype=float),
                rows,
                chapter,
                by_position,
                angle=column.unit == "deg" or (column.unit == "rad" and by_position),
                whole=not isinstance(column.values, np.ndarray) and _all_whole(column.values),
                signed=f"{column.key}_x" not in table,
            )


def of_value(value: Value, chapter: str) -> Iterator[Asked]:
    """A single number as a column of one row."""
    if not _OF_CHECKS.search(value.key):
        number, whole = np.array([value.value], dtype=float), isinstance(value.value, int)
        yield Asked("", value.quantity, number, ("",), chapter, angle=value.unit in ANGLES, whole=whole)


def _labels(table: Table) -> tuple[str, ...]:
    """What names the rows: the first text, as many texts as tell them apart, else the number of the row."""
    names: list[str] = [""] * len(table)
    for column in table.columns:
        if _is_number(column):
            break
        names = [f"{name} {text}".strip() for name, text in zip(names, column.values, strict=True)]
        if len(set(names)) == len(names):
            return tuple(names)
    return tuple(map(str, range(len(table))))


def _is_number(column: Column) -> bool:
    if column.key in (POSITION, "phi") or column.units:
        return False
    return isinstance(column.values, np.ndarray) or not any(isinstance(x, str) for x in column.values)


def _all_whole(values: Sequence[object]) -> bool:
    return bool(len(values)) and all(isinstance(x, int) for x in values)


def of_motion(one: Asked) -> bool:
    """Whether a column is of an output's motion, S, V, a of a slider: its sign is what the diagram shows, and a number
    without it is wrong."""
    return one.table.startswith("outputs_")
