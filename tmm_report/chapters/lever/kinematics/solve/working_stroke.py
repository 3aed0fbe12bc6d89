"""The working stroke of each output: what a load says of it, or else the longer-lasting one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics, Travel
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

Array = Any
EQUAL = 1e-6  # strokes whose angles differ by less, rad, last equally long
LEAST = 1e-9  # part of all work that is more than rounding


@dataclass(frozen=True)
class Working:
    """The working stroke of an output: from the angle turned `first` to `last`, rad, within the cycle; one that goes
    over position 0 ends beyond it. `ends`: at which ends of the stroke it begins and ends, "min" and "max"; `by`: what
    says so. `positions`: the table positions within it, in their order."""

    output: str
    link: str
    first: float
    last: float
    ends: tuple[Literal["min", "max"], Literal["min", "max"]]
    by: Literal["load", "longer"]
    positions: tuple[int, ...]


def working_of(lever: LeverFound) -> dict[str, Working]:
    """Working strokes by the names of the outputs; of an output without two strokes a turn there is none."""
    powers = load_powers(lever) if lever.kinetostatics is not None else {}
    return working_strokes(lever.kinematics, powers)


def load_powers(lever: LeverFound) -> dict[str, Array]:
    """Link -> power of the stated loads upon it at the diagram positions, (P,), W."""
    found = lever.kinetostatics
    if found is None:
        return {}
    motion, loading = found.diagram.motion, found.diagram.loading
    powers: dict[str, Array] = {}
    for link, own in motion.linkage.mechanism.links.items():
        for force, vector in zip(found.given.forces, loading.forces, strict=True):
            if force.at in own.points:
                powers[link] = powers.get(link, 0.0) + dot(vector, motion.velocity(force.at))
        for moment, couple in zip(found.given.moments, loading.moments, strict=True):
            if moment.on == link:
                powers[link] = powers.get(link, 0.0) + couple * motion.angular_velocity(link)
    return powers


def working_strokes(found: Kinematics, powers: Mapping[str, Array]) -> dict[str, Working]:
    """`powers`: of the loads upon links, at the diagram positions, W."""
    made = (_working(found, travel, powers.get(travel.output.link)) for travel in found.travels)
    return {stroke.output: stroke for stroke in made if stroke is not None}


def _working(found: Kinematics, travel: Travel, power: Array | None) -> Working | None:
    if travel.time_ratio is None:
        return None
    begins = _begins(found, travel)
    lasts = [(stop[0], after[0]) for stop, after in zip(begins, [*begins[1:], begins[0]], strict=True)]
    lasts = [(a, b if b > a else b + found.cycle.period) for a, b in lasts]
    by, k = _chosen(found, lasts, power)
    (first, last), end = lasts[k], begins[k][1]
    return Working(
        travel.output.name, travel.output.link, first, last, (end, "max" if end == "min" else "min"), by,
        _positions(found, first, last),
    )  # fmt: skip


def _begins(found: Kinematics, travel: Travel) -> list[tuple[float, Literal["min", "max"]]]:
    """Where the strokes begin over the whole cycle, and at which end of the stroke."""
    ends: list[tuple[float, Literal["min", "max"]]] = [
        (travel.near.turned, "min"),
        (travel.far.turned, "max"),
    ]
    sweep = found.cycle.sweep
    each = [(turned % sweep + k * sweep, end) for k in range(found.cycle.turns) for turned, end in ends]
    return sorted(each)


def _chosen(
    found: Kinematics, strokes: list[tuple[float, float]], power: Array | None
) -> tuple[Literal["load", "longer"], int]:
    """The stroke in which the load does most of the work that it does in all; of equal ones the first."""
    works = [0.0] if power is None else [_work(found, power, *stroke) for stroke in strokes]
    total = sum(works)
    if abs(total) > LEAST * sum(abs(work) for work in works) > 0:
        return "load", int(np.argmax([work * np.sign(total) for work in works]))
    lengths = np.array([last - first for first, last in strokes])
    return "longer", int(np.flatnonzero(lengths >= lengths.max() - EQUAL)[0])


def _work(found: Kinematics, power: Array, first: float, last: float) -> float:
    """Work between two angles turned, by the diagram positions, J."""
    period, fine = found.cycle.period, np.linspace(first, last, 181)
    values = np.interp(np.mod(fine, period), found.diagram_turned, np.nan_to_num(power))
    return float(np.sum((values[1:] + values[:-1]) / 2) * (last - first) / 180 / abs(found.omega))


def _positions(found: Kinematics, first: float, last: float) -> tuple[int, ...]:
    """Table positions within an interval that may go over the end of the cycle."""
    step, count = found.cycle.period / found.positions.table, found.positions.table
    numbers = range(int(np.ceil(first / step - 1e-6)), int(np.floor(last / step + 1e-6)) + 1)
    return tuple(k % count for k in numbers)
