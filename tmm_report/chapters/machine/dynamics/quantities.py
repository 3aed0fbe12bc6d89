"""The numbers of the machine in motion: parts on the main shaft, characteristics, the motion of each regime, works."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.machine.dynamics.joined import Joined
from tmm_report.chapters.machine.dynamics.plant import MOTOR
from tmm_report.chapters.machine.dynamics.solve import Found
from tmm_report.chapters.machine.dynamics.values import GENERALISED, Motion, Regimes, WithPairs, Works
from tmm_report.mechanics.machine.characteristics import Kloss
from tmm_report.mechanics.machine.run.motion_law import SAMPLES, Run
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Table, Value, text_column
from tmm_report.quantity.tabulated import tabulated

HEADLINE = (
    "dynamics_omega_m",
    "dynamics_delta",
    "dynamics_t_start",
    "dynamics_t_coast",
)  # what is looked for first

Array = Any
WORKED = {
    "A_dr": "motor",
    "A_br": "brake",
    "A_load": "load",
    "A_fr": "friction",
}  # columns of works, of which kind
ROWS = 12  # of the table of a start-up or run-down

CURVES = Message(N_("characteristics of the motor and of the resistances over the speed"))
CYCLE = Message(N_("steady motion over the cycle of the machine"))
RUNS = {
    "start": Message(N_("start-up of the machine")),
    "coast": Message(N_("run-down of the machine")),
}
JOINED = Message(N_("the regimes of the machine as one motion"))
REGIMES = Message(N_("the regimes of the machine one after another"))
WORKS = Message(N_("work of the forces in each regime"))


@tabulated
def values(found: Found) -> Iterator[Value]:
    return found.s.values()


def book(found: Found) -> Book:
    return Book.of(tables(found), values(found))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    if found.parts is not None:
        yield found.parts
    if found.speeds is not None:
        yield Table("dynamics_characteristics", CURVES, tuple(_characteristics(found)))
    if found.steady is not None and not found.even:
        for name, turned in (("table", found.turned), ("diagram", found.diagram_turned)):
            columns = [*where(turned), *_cycle(found, turned)]
            if name == "diagram":
                columns.append(Motion.domega.column(found.omega(turned) - found.steady.mean))
            yield Table(f"dynamics_cycle_{name}", CYCLE, tuple(columns))
    for name, run in found.runs:
        yield Table(f"dynamics_{name}", RUNS[name], tuple(_run(run, slice(None, None, rows_apart(run)))))
        yield Table(f"dynamics_{name}_diagram", RUNS[name], tuple(_run(run, slice(None))))
    if found.moves:
        yield Table("dynamics_works", WORKS, tuple(_works(found)))
    if found.joined is not None:
        of = zip((Motion.t, Motion.phi, Motion.omega), found.joined.samples(), strict=True)
        yield Table("dynamics_joined", JOINED, tuple(one.column(values) for one, values in of))
        yield Table("dynamics_regimes", REGIMES, tuple(_regimes(found.joined)))


def rows_apart(run: Run) -> int:
    """Samples between two rows of the table."""
    return max(1, (len(run.t) - 1) // ROWS)


# ---------------------------------------------------------------- characteristics


def _characteristics(found: Found) -> Iterator[Column]:
    """Over the speed, of what depends on the angle too the mean over the cycle."""
    omega, plant, motor = found.speeds, found.supplied, found.given.motor
    yield Motion.omega.column(omega)
    if motor is not None and isinstance(motor.own, Kloss):
        yield Motion.s.column(1 - omega * motor.ratio / motor.own.synchronous)
    driving = np.zeros(len(omega))
    for one in plant.acting:
        if one.key == MOTOR:
            driving = driving + (plant.panels.mean(one.values) if one.by_angle else one.at(omega))
    yield Motion.M_dr.column(driving)
    yield Motion.M_res.column(driving - plant.net(omega))


# ---------------------------------------------------------------- the motion


def _cycle(found: Found, turned: Array) -> Iterator[Column]:
    """Over the cycle of the steady motion."""
    steady = found.steady
    assert steady is not None  # asked for only where there is one
    plant, at = steady.plant, found.at

    def shown(values: Array) -> Array:
        return at(np.broadcast_to(values, plant.panels.shape), turned)

    if found.whole.machine is not None:
        yield Motion.I_red.column(shown(plant.inertia - found.whole.added))
    yield Motion.J.column(shown(plant.inertia))
    if not found.constant_inertia:
        yield Motion.J_slope.column(shown(plant.slope))
    driving, loads, rubbing = found.moments(steady.omega)
    yield Motion.M_dr.column(shown(driving))
    if found.whole.machine is not None:
        yield Motion.M_red.column(shown(loads))
        yield (WithPairs if found.whole.machine.rubs else Motion).M_fr.column(shown(rubbing))
    if plant.passing is not None:
        yield Motion.M_lost.column(shown(plant.acted(steady.omega) - steady.moment))
    yield Motion.M_res.column(shown(driving - steady.moment))
    yield Motion.M.column(shown(steady.moment))
    yield Motion.A.column(found.work(turned))
    yield Motion.omega.column(found.omega(turned))
    yield Motion.epsilon.column(shown(steady.epsilon))
    yield Motion.t.column(found.time(turned))
    if found.has_potential:
        yield Motion.V.column(shown(found.whole.potential))
        fall = sum((one.values for one in found.placed_weights), np.zeros(plant.panels.shape))
        yield Motion.V_slope.column(shown(-fall))
        yield GENERALISED.column(shown(steady.moment - fall))


def _run(run: Run, rows: slice) -> Iterator[Column]:
    driving = sum((run.of(one) for one in run.plant.acting if one.key == MOTOR), np.zeros(len(run.t)))
    yield Motion.t.column(run.t[rows])
    yield Motion.phi.column(run.phi[rows])
    yield Motion.omega.column(run.omega[rows])
    yield Motion.epsilon.column(run.epsilon[rows])
    yield Motion.M_dr.column(driving[rows])
    yield Motion.M_res.column((driving - run.moment)[rows])
    if run.plant.passing is not None:
        yield Motion.M_lost.column(run.lost[rows])


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
        yield Works.DECLARED[f"A_{name}"].column(np.array(numbers))


def _regimes(of: Joined) -> Iterator[Column]:
    """A row for each, then one for all together."""
    stretches = of.stretches

    def all_too(values: Sequence[float]) -> Array:
        return np.array([*values, sum(values)])

    times, angles = (
        [float(one[-1]) for one in ends] for ends in zip(*((s.t, s.phi) for s in stretches), strict=True)
    )
    ends = np.cumsum(times)
    yield text_column("regime", Message(N_("regime")), [*(one.name for one in stretches), "whole"])
    yield Regimes.t_begin.column(np.array([0.0, *ends[:-1], 0.0]))
    yield Regimes.t_end.column(np.array([*ends, ends[-1]]))
    yield Regimes.t.column(all_too(times))
    yield Regimes.phi.column(all_too(angles))
    yield Regimes.turns.column(all_too(angles) / (2 * np.pi))
    speeds = [float(one.omega[-1]) for one in stretches]
    yield Regimes.omega_end.column(np.array([*speeds, speeds[-1]]))
    for column, kind in WORKED.items():
        if any(kind in of.kinds_of(one) for one in stretches):
            yield Regimes.DECLARED[column].column(all_too([of.work(one, kind) for one in stretches]))
    yield Regimes.gained.column(all_too([one.gained for one in stretches]))


assert SAMPLES % ROWS == 0
