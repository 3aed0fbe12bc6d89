"""The regimes of the machine one after another: one motion from the start to the stop.

The start-up goes on until the speed is the steady one, cycles of the steady motion follow, and from position 0 the
run-down, each beginning where the one before it ends: A_dr + A_br + A_l + A_fr = ΔT in each and in all. (Artobolevsky,
Theory of mechanisms and machines, ch. 14; Frolov, Theory of mechanisms and machines, ch. 9)
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.machine.dynamics.given import Given
from tmm_report.chapters.machine.dynamics.plant import BRAKE, MOTOR, RUBBING, Whole
from tmm_report.mechanics.calculus.laws import TIME
from tmm_report.mechanics.machine.reduced import LOST, Plant
from tmm_report.mechanics.machine.run.by_angle import running_at
from tmm_report.mechanics.machine.run.law import run
from tmm_report.mechanics.machine.run.motion_law import TURNS, Goal, NeverReached, Run
from tmm_report.mechanics.machine.run.steady import Steady
from tmm_report.records import dataclass

Array = Any
START, SETTLING, STEADY, COAST = "start", "settling", "steady", "coast"
SETTLED = 1e-5  # of the steady speed: what is left of a motion that never becomes steady to the last digit
SHARE = 0.25  # of the time of all else that the steady motion is shown, where no number of cycles is stated
LEAST, MOST = 2, 12  # cycles of a speed that varies, where no number is stated
PER_CYCLE = 72  # intervals between the samples of such a cycle
JOINED = 1e-9  # of the speed: where a regime begins as the one before it ends


@dataclass(frozen=True, eq=False)
class Stretch:
    """A regime: `t`, `phi`, `omega` (P,) from its beginning; `works` of each that acts and the change of the kinetic
    energy `gained`, J; `cycles`: of the steady motion."""

    name: str
    t: Array
    phi: Array
    omega: Array
    works: dict[str, float]
    gained: float
    cycles: int = 0

    @classmethod
    def of(cls, name: str, runs: Sequence[Run]) -> Stretch:
        """Runs one after another."""
        works: dict[str, float] = {}
        for one in runs:
            for key, work in one.works.items():
                works[key] = works.get(key, 0.0) + work
        return cls(name, *_end_to_end(runs), works, sum(one.gained for one in runs))


@dataclass(frozen=True, eq=False)
class Joined:
    """`stretches` in the order of the time; `kinds`: of what acts and is no load, "motor", "brake" or "friction"."""

    stretches: tuple[Stretch, ...]
    kinds: dict[str, str]

    @property
    def cycles(self) -> int:
        return sum(one.cycles for one in self.stretches)

    def samples(self) -> tuple[Array, Array, Array]:
        """t, φ and ω of all of it, (P,)."""
        return _end_to_end(self.stretches)

    def kind(self, key: str) -> str:
        """Of what acts: "load" of what is none of the others."""
        return self.kinds.get(key, "load")

    def kinds_of(self, one: Stretch) -> set[str]:
        return {self.kind(key) for key in one.works}

    def work(self, one: Stretch, kind: str) -> float:
        """Of all of a kind, J."""
        return float(sum(work for key, work in one.works.items() if self.kind(key) == kind))


def _end_to_end(motions: Sequence[Run | Stretch]) -> tuple[Array, Array, Array]:
    """t, φ and ω of motions one after another, φ from the beginning of the first, (P,)."""
    first, *others = motions
    t, phi, omega = first.t, first.phi - first.phi[0], first.omega
    for one in others:
        t = np.concatenate([t, t[-1] + one.t[1:] - one.t[0]])
        phi = np.concatenate([phi, phi[-1] + one.phi[1:] - one.phi[0]])
        omega = np.concatenate([omega, one.omega[1:]])
    return t, phi, omega


def joined(
    given: Given, machine: Whole, plant: Plant, steady: Steady | None, start: Run | None, coast: Run | None
) -> Joined | None:
    """None where fewer than two regimes follow one another. `plant`: of the start-up."""
    stretches = list(_led(plant, steady, start)) if start is not None else []
    follows = coast is not None and _follows(coast, plant, steady, start)
    if steady is not None:
        rest = sum(float(one.t[-1]) for one in stretches) + (float(coast.t[-1]) if coast and follows else 0.0)
        stretches.append(_cycles(steady, given.cycles or _chosen(steady, rest)))
    if coast is not None and follows:
        stretches.append(Stretch.of(COAST, [coast]))
    if sum(one.name != SETTLING for one in stretches) < 2:
        return None
    kinds = {one.key: "friction" for kind, one in machine.acting if kind == RUBBING}
    return Joined(tuple(stretches), kinds | {MOTOR: "motor", BRAKE: "brake", LOST: "friction"})


def _led(plant: Plant, steady: Steady | None, start: Run) -> Iterator[Stretch]:
    """The start-up and what leads from its end to position 0 of the steady motion; nothing where it does not lead."""
    if steady is None:
        yield Stretch.of(START, [start])
        return
    try:
        settling = list(_settling(plant, steady, start))
    except NeverReached:
        return
    yield Stretch.of(START, [start])
    if settling:
        yield _closed(Stretch.of(SETTLING, settling), steady)


def _closed(settling: Stretch, steady: Steady) -> Stretch:
    """With what is left of the kinetic energy of the steady motion, as the work of what drives most."""
    inertia = float(steady.plant.panels.at(steady.plant.inertia, np.zeros(1))[0])
    left = inertia * (steady.speed(0.0) ** 2 - float(settling.omega[-1]) ** 2) / 2
    most = max(settling.works, key=lambda key: settling.works[key])
    works = settling.works | {most: settling.works[most] + left}
    return replace(settling, works=works, gained=settling.gained + left)


def _settling(plant: Plant, steady: Steady, start: Run) -> Iterator[Run]:
    """Raises NeverReached."""
    phi, omega, period = float(start.phi[-1]), float(start.omega[-1]), plant.panels.period
    lacks = omega / steady.speed(phi) - 1
    if abs(lacks) > SETTLED and not plant.of:
        raise NeverReached("away", omega)
    if plant.even:
        if abs(lacks) > SETTLED:
            yield run(plant, omega, Goal(speed=(1 + math.copysign(SETTLED, lacks)) * steady.mean), phi)
        return
    first = math.ceil(phi / period - JOINED)  # the next position 0
    while phi / period < first - JOINED or abs(lacks) > SETTLED:
        to = first if phi / period < first - JOINED else round(phi / period) + _needed(lacks, steady)
        if to - first > TURNS:
            raise NeverReached("long", omega, phi)
        found = run(plant, omega, Goal(angle=to * period - phi), phi)
        yield found
        phi, omega = float(found.phi[-1]), float(found.omega[-1])
        lacks = omega / steady.speed(0.0) - 1


def _needed(lacks: float, steady: Steady) -> int:
    """Cycles after which little enough is left of a lack, as a small one is multiplied in each."""
    rate = math.log(max(steady.multiplier, 1e-12))
    return max(1, math.ceil(math.log(SETTLED / abs(lacks)) / rate)) if rate < 0 else TURNS + 1


def _follows(coast: Run, plant: Plant, steady: Steady | None, start: Run | None) -> bool:
    """Whether the run-down begins at position 0 of the steady motion, or where the start-up ends."""
    if steady is not None:
        before = steady.speed(0.0)
    elif start is not None and plant.even and coast.plant.even and TIME not in plant.of | coast.plant.of:
        before = float(start.omega[-1])
    else:
        return False
    return abs(float(coast.omega[0]) - before) <= JOINED * before


def _chosen(steady: Steady, rest: float) -> int:
    """How many cycles are shown: as long as a quarter of all else takes, of a speed that varies not too many."""
    count = max(1, math.ceil(SHARE * rest / steady.cycle))
    return count if steady.plant.even else min(max(count, LEAST), MOST)


def _cycles(steady: Steady, count: int) -> Stretch:
    panels = steady.plant.panels
    inside = np.linspace(0.0, panels.period, (1 if steady.plant.even else PER_CYCLE) + 1)
    times, speeds = running_at(panels, 1 / steady.omega, inside), panels.at(steady.omega, inside)
    times[-1] = steady.cycle
    many = 1 if steady.plant.even else count  # of a speed that does not vary both ends say all
    wide = count // many
    t, phi = (
        np.append((np.arange(many)[:, None] * one[-1] + one[:-1]).ravel(), many * one[-1]) * wide
        for one in (times, inside)
    )
    omega = np.append(np.tile(speeds[:-1], many), speeds[-1])
    works = {key: count * work for key, work in steady.works.items()}
    return Stretch(STEADY, t, phi, omega, works, 0.0, count)
