"""Forces over the whole cycle: between the positions of a table too, with both sides of every jump of a load.

The cycle is cut into panels at every kink and jump of the loads (`breaks`), on which forces are polynomials to the
rounding of a double; extremes and integrals are then those of the forces themselves, not of a grid.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import Loading, loading, resultants
from tmm_report.chapters.lever.kinetostatics.solve.load_breaks import breaks
from tmm_report.chapters.lever.kinetostatics.solve.powers import lever_terms
from tmm_report.mechanics.calculus.panels import Panels, panels
from tmm_report.mechanics.lever.extremes import Peaks, peaks, refined, size_peaks
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.forces.reactions import Statics
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

Array = Any
NOTHING = 1e-9  # of the largest moment, that another is taken to be nothing at
ROUNDING = 1e-12  # of the moments of the forces: a balancing moment below is none
PART = 1e-2  # of the largest force, that the size of another is taken to be at least
CUTS = 2  # how often panels are cut at most
BESIDE = (
    1e-3,
    1e-5,
)  # rad from a singular position: a force without bound grows a hundredfold from one to the other
GROWS = 3.0


@dataclass(frozen=True, eq=False)
class Over:
    """At the points of `panels` in a row, (K n,): motion, loads and forces; `powers`: of the loads, (rows, K n), W.
    `closed`: whether the cycle ends where it begins."""

    panels: Panels
    motion: Motion
    loading: Loading
    statics: Statics
    powers: Array
    closed: bool

    def on(self, values: Array) -> Array:
        """Values (..., K n) as functions of the panels, (..., K, n)."""
        values = np.asarray(values)
        if values.ndim == 0 or values.shape[-1] != self.panels.x.size:
            values = np.broadcast_to(values, self.motion.shape)
        return values.reshape(*values.shape[:-1], *self.panels.shape)

    @property
    def turned(self) -> Array:
        """Angles turned from position 0, rad, (K n,)."""
        return self.panels.x.ravel()

    @cached_property
    def balancing(self) -> Array:
        """The balancing moment, (K, n), N m; exactly nothing where it is rounding beside the moments of the forces."""
        moment = self.on(self.statics.balancing)
        return moment if np.abs(moment).max() > ROUNDING * self._size else np.zeros_like(moment)

    @cached_property
    def _size(self) -> float:
        """Of the moments of the forces: the largest reaction times the size of the mechanism, N m."""
        force = max(np.abs(one).max() for one in self.reactions.values())
        return float(force * np.abs(self.motion.places).max())

    @cached_property
    def reactions(self) -> dict[str, Array]:
        """Of every pair its reaction, complex (K, n), N."""
        return {key: self.on(one.force) for key, one in self.statics.reactions.items()}

    @cached_property
    def guide_moments(self) -> dict[str, Array]:
        """Of every guide the moment of its reaction, (K, n), N m."""
        found = self.statics.reactions
        return {key: self.on(one.moment) for key, one in found.items() if one.pair.kind == "P"}

    @cached_property
    def moment(self) -> Peaks:
        """Least and greatest balancing moment, N m."""
        return peaks(self.panels, self.balancing[None], self.closed)[0]

    @cached_property
    def sizes(self) -> dict[str, Peaks]:
        """Least and greatest magnitude of every reaction, N."""
        found = size_peaks(self.panels, np.array(list(self.reactions.values())), self.closed)
        return dict(zip(self.reactions, found, strict=True))

    @cached_property
    def components(self) -> dict[str, tuple[Peaks, Peaks]]:
        """Least and greatest projections of every reaction on x and y, N."""
        forces = np.array(list(self.reactions.values()))
        found = peaks(self.panels, np.concatenate([forces.real, forces.imag]), self.closed)
        count = len(forces)
        return {key: (found[i], found[count + i]) for i, key in enumerate(self.reactions)}

    @cached_property
    def couples(self) -> dict[str, Peaks]:
        """Least and greatest moment of the reaction of every guide in which it has one, N m."""
        turning = {key: moment for key, moment in self.guide_moments.items() if self._turns(moment)}
        if not turning:
            return {}
        found = peaks(self.panels, np.array(list(turning.values())), self.closed)
        return dict(zip(turning, found, strict=True))

    def _turns(self, moment: Array) -> bool:
        """Whether a moment is more than the rounding of forces at the size of the mechanism."""
        return bool(np.abs(moment).max() > NOTHING * max(np.abs(self.balancing).max(), self._size))


def over(given: Loads, kinematics: Kinematics) -> Over | None:
    """None where some position has no motion, or no finite forces, or where they grow without bound beside one."""
    if kinematics.gaps or _without_bound(given, kinematics):
        return None
    cycle = kinematics.cycle
    cut = panels(cycle.period, breaks(given, kinematics))
    found = _resolved(_at(cut, given, kinematics), given, kinematics)
    if found is None or kinematics.linkage.mechanism.driver.gear is None:
        return found
    # the force of the teeth changes its line where the moment changes its sense: a kink of what the frame feels
    return cut_at(found, found.panels.roots(found.balancing), given, kinematics)


def _without_bound(given: Loads, kinematics: Kinematics) -> bool:
    """Whether a reaction grows without bound beside a singular position of the cycle, where links in one line must hold
    a load across it: no point of the panels falls on it, so that the force at each is finite."""
    cycle = kinematics.cycle
    places = np.array([x for one in cycle.critical for x in (*one.changes, *one.parallel)])
    turned = cycle.turned_at(places)
    turned = cycle.repeated(turned[turned <= cycle.sweep])
    if not turned.size:
        return False
    far, near = (np.concatenate([turned - away, turned + away]) for away in BESIDE)
    with np.errstate(invalid="ignore", divide="ignore"):
        motion = cycle.motion(np.concatenate([far, near]))
        load = loading(given, kinematics, motion, np.concatenate([far, near]))
        found = statics.solve(motion, resultants(given, motion, load))
    forces = np.array([np.abs(one.force) for one in found.reactions.values()])
    at_far, at_near = np.split(np.nan_to_num(forces.max(axis=0)), 2)
    return bool((at_near > GROWS * at_far).any())


def cut_at(found: Over, kinks: Array, given: Loads, kinematics: Kinematics) -> Over | None:
    """The same on panels that end at other angles too, rad."""
    marks = panels(found.panels.period, np.concatenate([found.panels.edges, kinks]))
    return _resolved(_at(marks, given, kinematics), given, kinematics)


def _resolved(found: Over | None, given: Loads, kinematics: Kinematics) -> Over | None:
    """On panels so fine that the forces are polynomials on them."""
    for _ in range(CUTS):
        if found is None:
            return None
        finer = refined(found.panels, *_shapes(found))
        if finer is found.panels:
            break
        found = _at(finer, given, kinematics)
    return found


def _shapes(found: Over) -> tuple[Array, Array]:
    """The functions that are to be resolved, (F, K, n), and their sizes (F,): a part of the largest of the kind among
    them, beside which another is rounding."""
    forces = np.array(list(found.reactions.values()))
    couples = np.array([found.balancing, *found.guide_moments.values()])
    force, couple = (np.abs(kind).max(axis=(-2, -1)) for kind in (forces, couples))
    force, couple = force + PART * force.max(), couple + PART * couple.max()
    return np.concatenate([couples, forces.real, forces.imag]), np.concatenate([couple, force, force])


def _at(cut: Panels, given: Loads, kinematics: Kinematics) -> Over | None:
    turned = cut.x.ravel()
    with np.errstate(invalid="ignore", divide="ignore"):
        motion = kinematics.cycle.motion(turned)
        load = loading(given, kinematics, motion, turned)
        found = statics.solve(motion, resultants(given, motion, load))
        powers = lever_terms(given, motion, load)
    forces = [one.force for one in found.reactions.values()]
    if not all(np.isfinite(values).all() for values in (found.balancing, *forces)):
        return None
    return Over(cut, motion, load, found, powers, kinematics.cycle.closed)
