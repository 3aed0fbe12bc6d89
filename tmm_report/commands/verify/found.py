"""What the program finds of a variant, by the kinds and names of its reference."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

from tmm_report.course import LeverFound, Results
from tmm_report.mechanics.gears import involute
from tmm_report.results import tables, values

Array = Any
Of = Callable[[LeverFound, str], Array]

OF: Mapping[str, Of] = {
    "angle": lambda lever, name: lever.kinematics.table.phi,
    "place": lambda lever, name: lever.kinematics.table.place(name),
    "velocity": lambda lever, name: lever.kinematics.table.velocity(name),
    "acceleration": lambda lever, name: lever.kinematics.table.acceleration(name),
    "angular velocity": lambda lever, name: lever.kinematics.table.angular_velocity(name),
    "angular acceleration": lambda lever, name: lever.kinematics.table.angular_acceleration(name),
    "reaction": lambda lever, name: _reaction(lever, name).force,
    "couple": lambda lever, name: _reaction(lever, name).moment,
    "moment": lambda lever, name: _forces(lever).balancing,
}
"""Kind -> numbers of something named at the table positions, (P,) or one number."""
FUNCTIONS: Mapping[str, Callable[[Array], Array]] = {"inv": involute.inv, "arcinv": involute.inverse}


def row(results: Results, kind: str, name: str) -> Array:
    """Numbers at the table positions, (P,)."""
    assert results.lever is not None
    return np.broadcast_to(OF[kind](results.lever, name), results.lever.kinematics.table.shape)


def single(results: Results, keys: Iterable[str]) -> Mapping[str, float]:
    """Numbers of the results by their keys: of a single value, or "table/column/row" of a cell of a table."""
    found = {value.key: value.value for value in values(results)}
    if cells := [key.split("/") for key in keys if "/" in key]:
        by_name = {table.name: table for table in tables(results)}
        for table, column, line in cells:
            if table in by_name and column in by_name[table]:
                found["/".join((table, column, line))] = by_name[table][column].number(int(line))
    return found


def of_functions(keys: Iterable[str]) -> Mapping[str, float]:
    """Of keys such as "inv(0.35)": the value of the function at the double next to that number."""
    parts = [(key, *key.removesuffix(")").split("(")) for key in keys]
    return {key: float(FUNCTIONS[name](np.array(float(at)))) for key, name, at in parts}


def _forces(lever: LeverFound) -> Any:
    assert lever.kinetostatics is not None
    return lever.kinetostatics.table.statics


def _reaction(lever: LeverFound, key: str) -> Any:
    return _forces(lever).reactions[key]
