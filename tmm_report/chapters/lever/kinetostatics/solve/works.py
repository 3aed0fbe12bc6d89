"""What the loads do over a cycle: where each drives and where it resists, its work, and where the engine must drive.

A force drives where it makes an acute angle with the velocity of its point, that is where its power is above zero; it
resists where the angle is obtuse. (Artobolevsky, Theory of mechanisms and machines, ch. 14)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import Loading
from tmm_report.chapters.lever.kinetostatics.solve.powers import powers_of
from tmm_report.chapters.lever.kinetostatics.solve.whole_cycle import Over
from tmm_report.chapters.lever.kinetostatics.ties import together
from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.extremes import integral, signed
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics

Array = Any
NOTHING = 1e-9  # of the largest power of a load: less is none


@dataclass(frozen=True, eq=False)
class Work:
    """Of one load over a cycle, J: what it does where it drives and, below zero, where it resists; `signs`: of its
    power at the table positions, (P,) of -1, 0, 1."""

    driving: float
    resisting: float
    signs: Array

    @property
    def whole(self) -> float:
        return self.driving + self.resisting


@dataclass(frozen=True)
class Zone:
    """From one angle turned to another, rad, the balancing moment has one sense: `drives` with the rotation, so that
    the engine must give work; else the mechanism gives it. `work`: of the moment there, J."""

    start: float
    end: float
    drives: bool
    work: float


@dataclass(frozen=True, eq=False)
class Works:
    """Over a whole cycle: of the `stated` forces, of springs and dampers, then of moments, in their order; of the
    weights by link; of the balancing moment. `time`: of a cycle, s."""

    stated: tuple[Work, ...]
    weights: dict[str, Work]
    balancing: Work
    zones: tuple[Zone, ...]
    time: float

    @property
    def whole(self) -> float:
        """Of all the loads together, J: nothing, as the mechanism comes back with the energy that it had."""
        return self.balancing.whole + sum(one.whole for one in (*self.stated, *self.weights.values()))

    @property
    def size(self) -> float:
        """Beside which the sum is nothing, J."""
        every = (self.balancing, *self.stated, *self.weights.values())
        return max(one.driving - one.resisting for one in every)

    @property
    def power(self) -> float:
        """Mean power of the balancing moment, W."""
        return self.balancing.whole / self.time


def works(found: Kinetostatics) -> Works | None:
    """None where the cycle does not end where it begins, or has a position without forces."""
    over, cycle = found.over, found.kinematics.cycle
    if over is None or not cycle.closed:
        return None
    omega, given, table = found.kinematics.omega, found.given, found.table
    whole = (
        _powers(given, m, load) for m, load in ((over.motion, over.loading), (table.motion, table.loading))
    )
    loads, at_table = whole
    done = [
        _work(over, over.on(power) / abs(omega), _signs(there, power))
        for power, there in zip(loads, at_table, strict=True)
    ]
    count = len(together(given.forces)) + len(given.moments)
    # by the angle turned, or by the phase of a law: what the driving link turns beside it
    moment = over.balancing * over.on(over.motion.omega / abs(omega))
    return Works(
        tuple(done[:count]),
        dict(zip(over.loading.gravity, done[count:], strict=True)),
        _work(over, moment, _signs(table.balancing * table.motion.omega / abs(omega), moment)),
        _zones(over.panels, moment),
        cycle.period / abs(omega),
    )


def _powers(given: Loads, motion: Motion, load: Loading) -> list[Array]:
    """Power of everything stated (`powers_of`), then of every weight, (..., P), W."""
    links, shape = motion.linkage.mechanism.links, motion.shape
    weights = [
        dot(force, motion.velocity(str(links[link].mass_centre))) for link, force in load.gravity.items()
    ]
    return [np.broadcast_to(power, shape) for power in (*powers_of(given, motion, load), *weights)]


def _work(over: Over, moment: Array, signs: Array) -> Work:
    """Of what is `moment` (K, n) reduced to the driving link, in its sense of rotation."""
    driving, resisting = signed(over.panels, moment)
    return Work(driving, resisting, signs)


def _signs(values: Array, over: Array) -> Array:
    """Of values at the positions; what is next to nothing beside the largest of the cycle has none."""
    largest = np.abs(over).max(initial=0.0)
    least = NOTHING * largest if largest > 0 else np.inf
    return np.where(np.abs(values) <= least, 0, np.sign(np.nan_to_num(values))).astype(int)


def _zones(panels: Panels, moment: Array) -> tuple[Zone, ...]:
    """Between the angles at which the moment passes through zero, jumps among them; none where there is no moment."""
    if not moment.any():
        return ()
    marks = distinct(np.concatenate([[0.0], panels.roots(moment), [panels.period]]))
    done = integral(panels, moment, marks[1:]) - integral(panels, moment, marks[:-1])
    rows = zip(marks[:-1], marks[1:], done, strict=True)
    return tuple(Zone(float(a), float(b), bool(work > 0), float(work)) for a, b, work in rows)
