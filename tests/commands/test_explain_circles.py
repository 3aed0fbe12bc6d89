"""No number is explained by what is explained by it, however far round."""

from __future__ import annotations

import pytest
from conftest import ALL_FILES, solved
from exhaustive import many

from tmm_report.commands.explain import way
from tmm_report.commands.explain.target import Target
from tmm_report.commands.explain.way import Told, Ways
from tmm_report.living.told import _Asking
from tmm_report.results import tables, values

FIRST = ["chebyshev_conveyor", "hoist_drive"]
NAMES = [*FIRST, *(file.stem for file in ALL_FILES if file.stem not in FIRST)]


class One(Target):
    """Of a table its first row."""

    @property
    def rows(self):
        return super().rows[:1]


def targets(results):
    """Every single value, and every column in a row."""
    yield from (Target(value.quantity, value=float(value.value)) for value in values(results))
    for table in tables(results):
        if not table.name.endswith("_diagram"):
            position = int(table["position"].values[0]) if "position" in table else None
            yield from (One(column.quantity, table, position) for column in table.columns)


def begun(results, monkeypatch) -> dict[str, tuple[Told, set[str]]]:
    """Of every number how it is told, and the names of the numbers that this begins with."""
    asked: list[_Asking] = []

    def asking(*known):
        asked.append(_Asking(*known))
        return asked[-1]

    monkeypatch.setattr(way, "Known", asking)
    ways, found = Ways.of(results), {}
    for target in targets(results):
        asked.clear()
        if (told := ways.told(target)) is not None:
            name = target.name.partition(".")[2]
            rows = asked[-max(1, len(told.inputs)) :]  # of the way that is told: the last that was tried
            found[name] = told, {one for row in rows for one in row.asked} - {name}
    return found


@pytest.mark.parametrize("name", many(NAMES, 2))
def test_no_number_begins_with_itself(name, monkeypatch):
    """Equations that are written out are solved together; all others have an order."""
    found = begun(solved(name), monkeypatch)
    left = {
        one: {b for b in starts if b in found and not (told.worked and found[b][0].way is told.way)}
        for one, (told, starts) in found.items()
    }
    while known := [one for one, starts in left.items() if not starts & left.keys()]:
        for one in known:
            del left[one]
    assert found and not left, left
