"""The numbers of the machine in motion: parts on the main shaft, characteristics, the motion of each regime, works."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.machine.dynamics.plant import MOTOR
from tmm_report.chapters.machine.dynamics.solve import Found
from tmm_report.chapters.machine.dynamics.terms import (
    ACCELERATION,
    ANGLE,
    DEVIATION,
    DRIVING,
    FRICTION,
    GENERALISED,
    INERTIA,
    LOST,
    OF_LINKS,
    OF_LOADS,
    POTENTIAL,
    POTENTIAL_SLOPE,
    RED,
    RESISTING,
    SLIP,
    SLOPE,
    SPEED,
    TIME,
    TOTAL,
    WITH_PAIRS,
    WORK,
)
from tmm_report.chapters.machine.dynamics.values import values
from tmm_report.mechanics.machine.characteristics import Kloss
from tmm_report.mechanics.machine.run.motion_law import SAMPLES, Run
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

__all__ = ["book", "tables", "values"]

Array = Any
ROWS = 12  # of the table of a start-up or run-down

PARTS = Message(N_("parts of the machine reduced to the main shaft"))
CURVES = Message(N_("characteristics of the motor and of the resistances over the speed"))
CYCLE = Message(N_("steady motion over the cycle of the machine"))
RUNS = {
    "start": Message(N_("start-up of the machine")),
    "coast": Message(N_("run-down of the machine")),
}
WORKS = Message(N_("works of the forces in each regime"))


def book(found: Found) -> Book:
    return Book.of(tables(found), values(found))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    if found.given.parts:
        yield Table("dynamics_parts", PARTS, tuple(_parts(found)))
    if found.speeds is not None:
        yield Table("dynamics_characteristics", CURVES, tuple(_characteristics(found)))
    if found.steady is not None and not found.even:
        for name, turned in (("table", found.turned), ("diagram", found.diagram_turned)):
            columns = [*where(turned), *_cycle(found, turned)]
            if name == "diagram":
                columns.append(DEVIATION.column(found.omega(turned) - found.steady.mean))
            yield Table(f"dynamics_cycle_{name}", CYCLE, tuple(columns))
    for name, run in found.runs:
        yield Table(f"dynamics_{name}", RUNS[name], tuple(_run(run, slice(None, None, rows_apart(run)))))
        yield Table(f"dynamics_{name}_diagram", RUNS[name], tuple(_run(run, slice(None))))
    if found.moves:
        yield Table("dynamics_works", WORKS, tuple(_works(found)))


def rows_apart(run: Run) -> int:
    """Samples between two rows of the table."""
    return max(1, (len(run.t) - 1) // ROWS)


# ---------------------------------------------------------------- parts and characteristics


def _parts(found: Found) -> Iterator[Column]:
    """Numbers that a part has not are none."""
    parts = found.whole.parts
    gravity = found.given.gravity

    def numbered(key: str, symbol: Symbol, unit: str, text: str, numbers: list[float]) -> Column:
        names = [
            Symbol(symbol.base, ",".join(filter(None, (symbol.sub, str(k)))))
            for k in range(1, len(parts) + 1)
        ]
        return Column(Quantity(key, symbol, unit, Message(text)), np.array(numbers, float), names)

    nan = float("nan")
    yield text_column("part", Message(N_("part of the machine")), [one.part.name for one in parts])
    ratio = [one.part.ratio if one.part.turns or not one.part.arm else nan for one in parts]
    yield numbered(
        "i", Symbol("i"), "", N_("ratio of the speed of the shaft to that of the main shaft"), ratio
    )
    eta = [one.part.efficiency for one in parts]
    yield numbered("eta", Symbol("eta"), "", N_("efficiency of the gears between it and the main shaft"), eta)
    own = [one.part.inertia if one.part.turns else nan for one in parts]
    yield numbered("J", Symbol("J"), "kg·m²", N_("moment of inertia of the shaft with what is on it"), own)
    moments = [one.part.moment if one.part.turns else nan for one in parts]
    yield numbered("M", Symbol("M"), "N·m", N_("moment that resists the shaft"), moments)
    masses = [one.part.mass if one.part.arm else nan for one in parts]
    yield numbered("m", Symbol("m"), "kg", N_("mass that moves along"), masses)
    arms = [one.part.arm or nan for one in parts]
    yield numbered("r", Symbol("r"), "m", N_("velocity of the mass by the speed of the main shaft"), arms)
    forces = [
        one.part.moves * one.part.mass * gravity + one.part.force if one.part.arm else nan for one in parts
    ]
    yield numbered("F", Symbol("F"), "N", N_("force that resists the mass; below zero it drives"), forces)
    text = N_("its part in the moment of inertia on the main shaft")
    yield numbered("J_red", Symbol("J", RED), "kg·m²", text, [one.inertia for one in parts])
    text = N_("its part in the resisting moment on the main shaft")
    yield numbered("M_red", Symbol("M", RED), "N·m", text, [one.moment for one in parts])


def _characteristics(found: Found) -> Iterator[Column]:
    """Over the speed, of what depends on the angle too the mean over the cycle."""
    omega, plant, motor = found.speeds, found.supplied, found.given.motor
    yield SPEED.column(omega)
    if motor is not None and isinstance(motor.own, Kloss):
        yield SLIP.column(1 - omega * motor.ratio / motor.own.synchronous)
    driving = np.zeros(len(omega))
    for one in plant.acting:
        if one.key == MOTOR:
            driving = driving + (plant.panels.mean(one.values) if one.by_angle else one.at(omega))
    yield DRIVING.column(driving)
    yield RESISTING.column(driving - plant.net(omega))


# ---------------------------------------------------------------- the motion


def _cycle(found: Found, turned: Array) -> Iterator[Column]:
    """Over the cycle of the steady motion."""
    steady = found.steady
    assert steady is not None  # asked for only where there is one
    plant, at = steady.plant, found.at

    def shown(values: Array) -> Array:
        return at(np.broadcast_to(values, plant.panels.shape), turned)

    if found.whole.machine is not None:
        yield OF_LINKS.column(shown(plant.inertia - found.whole.added))
    yield INERTIA.column(shown(plant.inertia))
    if not found.constant_inertia:
        yield SLOPE.column(shown(plant.slope))
    driving, loads, rubbing = found.moments(steady.omega)
    yield DRIVING.column(shown(driving))
    if found.whole.machine is not None:
        yield OF_LOADS.column(shown(loads))
        yield (WITH_PAIRS if found.whole.machine.rubs else FRICTION).column(shown(rubbing))
    if plant.passing is not None:
        yield LOST.column(shown(plant.acted(steady.omega) - steady.moment))
    yield RESISTING.column(shown(driving - steady.moment))
    yield TOTAL.column(shown(steady.moment))
    yield WORK.column(found.work(turned))
    yield SPEED.column(found.omega(turned))
    yield ACCELERATION.column(shown(steady.epsilon))
    yield TIME.column(found.time(turned))
    if found.has_potential:
        yield POTENTIAL.column(shown(found.whole.potential))
        fall = sum((one.values for one in found.placed_weights), np.zeros(plant.panels.shape))
        yield POTENTIAL_SLOPE.column(shown(-fall))
        yield GENERALISED.column(shown(steady.moment - fall))


def _run(run: Run, rows: slice) -> Iterator[Column]:
    driving = sum((run.of(one) for one in run.plant.acting if one.key == MOTOR), np.zeros(len(run.t)))
    columns = [
        (TIME, run.t), (ANGLE, run.phi), (SPEED, run.omega), (ACCELERATION, run.epsilon), (DRIVING, driving),
        (RESISTING, driving - run.moment),
    ]  # fmt: skip
    if run.plant.passing is not None:
        columns.append((LOST, run.lost))
    for quantity, numbers in columns:
        yield quantity.column(numbers[rows])


def _works(found: Found) -> Iterator[Column]:
    """A row for each that acts, then their sum and the change of the kinetic energy."""
    sets: dict[str, tuple[dict[str, float], float]] = {}
    if found.start is not None:
        sets["start"] = found.start.works, found.start.gained
    if found.steady is not None:
        sets["steady"] = found.steady.works, 0.0
    if found.coast is not None:
        sets["coast"] = found.coast.works, found.coast.gained
    names = list(dict.fromkeys(key for works, _ in sets.values() for key in works))
    yield text_column("acting", Message(N_("what acts")), [*names, "sum", "gained"])
    for name, (works, gained) in sets.items():
        numbers = [*(works.get(key, float("nan")) for key in names), sum(works.values()), gained]
        yield Quantity(f"A_{name}", Symbol("A"), "J", Message(REGIMES[name])).column(np.array(numbers))


REGIMES = {
    "start": N_("work in the start-up"),
    "steady": N_("work in a cycle of the steady motion"),
    "coast": N_("work in the run-down"),
}
assert SAMPLES % ROWS == 0
