"""Ways to integrate the equation of motion of a machine: time and error of each, on two machines.

    python benchmarks/integrators.py

The start of a pump driven through its cycle by an induction motor, and that of a shaft whose load a stiff motor carries
and which is stated by time. LSODA, which the program takes, against DOP853 (explicit) and Radau (implicit) at three
tolerances, and against what the program does: cycles by collocation, stretches from kink to kink. The error is that of
the time, or of the speed, at the end, against DOP853 at 1e-12; times are by that of the program. Printed, never
asserted.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from timing import interleaved

from tmm_report import course
from tmm_report.mechanics import by_time as ways
from tmm_report.mechanics.machine import Plant
from tmm_report.mechanics.motion_law import Goal
from tmm_report.mechanics.ode import integrate

VARIANTS = Path(__file__).parents[1] / "variants"
TURNS, LONG = 5, 1.03  # of the pump; s, of the shaft: shortly after its load has come
ROUNDS = 5
METHODS = ("LSODA", "DOP853", "Radau")
TOLERANCES = (1e-5, 1e-7, 1e-9)

SHAFT = """
dynamics:
  parts: [{name: rotor, inertia: 0.05 kg*m^2}]
  motor: {shunt: {moment: 60 N*m, speed: 1470 rpm, no_load: 1500 rpm}}
  resistance: [{by_time: [[0 s, 0 N*m], [1 s, 0 N*m], [1.02 s, 50 N*m], [1.5 s, 50 N*m], [1.52 s, 0 N*m]]}]
  start: {time: 1.03 s}
"""


@dataclass(frozen=True)
class Task:
    """A start from rest of the `plant` up to `goal`."""

    name: str
    plant: Plant
    goal: Goal

    def by(self, method: str, relative: float) -> tuple[float, int]:
        """What is found at the end, the time of the pump or the speed of the shaft; evaluations of the moments."""
        start = np.zeros(3 + len(self.plant.laws))
        events, end = [], self.goal.time
        if self.goal.angle is not None:
            events, end = [partial(_left, self.goal.angle)], 1e3
        rate = ways._rate(self.plant, 0.0)
        found = integrate(
            rate, start, (0.0, float(end or 0.0)), events=events, method=method, relative=relative,
            absolute=relative / 100,
        )  # fmt: skip
        return float(found.x[-1] if events else found.y[1, -1]), found.steps

    def program(self) -> tuple[float, int]:
        run = ways.by_time(self.plant, 0.0, self.goal)
        return float(run.t[-1] if self.goal.time is None else run.omega[-1]), run.steps


def _left(angle: float, t: float, y: np.ndarray) -> float:
    return float(y[0]) - angle


def tasks() -> Iterator[Task]:
    pump = course.solve(course.load(VARIANTS / "piston_pump.yaml")).dynamics
    shaft = course.solve(course.loads(SHAFT)).dynamics
    assert pump is not None and shaft is not None
    yield Task(f"pump, {TURNS} turns", pump.supplied, Goal(angle=TURNS * 2 * math.pi))
    yield Task(f"shaft, {LONG} s", shaft.supplied, Goal(time=LONG))


def measured(task: Task) -> Iterator[tuple[str, float, float, int]]:
    """Of each way: its name, its time by that of the program, relative error, evaluations."""
    rivals: dict[str, Callable[[], tuple[float, int]]] = {"the program": task.program}
    for method in METHODS:
        rivals |= {f"{method} {one:.0e}": partial(task.by, method, one) for one in TOLERANCES}
    taken, (exact, _) = interleaved(rivals, ROUNDS), task.by("DOP853", 1e-12)
    for name, way in rivals.items():
        found, steps = way()
        yield name, taken[name] / taken["the program"], abs(found - exact) / exact, steps


def main() -> None:
    print(f"{'machine':<16}{'way':<16}{'time':>8}{'error':>10}{'evaluations':>13}")
    for task in tasks():
        for name, time, error, steps in measured(task):
            print(f"{task.name:<16}{name:<16}{time:>8.2f}{error:>10.1e}{steps:>13}")


if __name__ == "__main__":
    main()
