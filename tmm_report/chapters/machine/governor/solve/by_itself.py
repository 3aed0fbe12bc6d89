"""The centrifugal governor by itself: its places, its equilibrium, what is chosen of it, whether it is stable."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import Any, Literal

import numpy as np

from tmm_report.chapters.machine.governor import steps
from tmm_report.chapters.machine.governor.given import Given
from tmm_report.chapters.machine.governor.solve import mistakes
from tmm_report.chapters.machine.governor.values import Values
from tmm_report.mechanics.machine.governor.equilibrium import (
    Arms,
    Balls,
    BellCrank,
    Equilibrium,
    Weights,
    ball_mass,
    equilibrium,
    sleeve_mass,
    spring_force,
)
from tmm_report.records import dataclass

Array = Any
POINTS = 11  # places of the sleeve in the table
CURVE = 61  # and of the diagrams
FLAT = 1e-6  # relative change of the speed over the lift below which a governor is called flat
Word = Literal["stable", "unstable", "flat", "partly"]


@dataclass(frozen=True, eq=False)
class DirectFound:
    """`s`: the single numbers; `lift` of the sleeve, m; `weights` with what was chosen; at the places of the table and
    of the curve."""

    given: Given
    s: Values
    lift: float
    weights: Weights
    table: Equilibrium
    curve: Equilibrium

    def at(self, z: Array) -> Equilibrium:
        """The equilibrium at any lifts (P,), m."""
        return equilibrium(self.given.geometry.moves(z, self.given.lowest), self.weights)

    @property
    def middle(self) -> int:
        """The place of the table at half the lift, of which formulas are written out."""
        return POINTS // 2

    # --- speeds

    @property
    def ends(self) -> tuple[float, float]:
        """Speeds at the lower and at the upper stop, rad/s."""
        return float(self.table.omega[0]), float(self.table.omega[-1])

    @property
    def mean(self) -> float:
        return sum(self.ends) / 2

    # --- stability

    @cached_property
    def word(self) -> Word:
        """Whether the speed grows with the lift all over it."""
        gain = self.curve.slope * self.lift / self.curve.omega
        if np.abs(gain).max() < FLAT:
            return "flat"
        if (gain > 0).all():
            return "stable"
        return "unstable" if (gain <= 0).all() else "partly"

    @cached_property
    def stiffness_needed(self) -> float | None:
        """Least stiffness of the spring, with its force at the lower stop kept, that makes S positive all over, N/m;
        None where none does: S is linear in it."""
        found = self.curve
        share = 1 - found.balls.z * found.dA / found.A
        if (share <= 0).any():
            return None
        return float(np.max(self.weights.stiffness - found.S / share))

    @cached_property
    def preload_allowed(self) -> float | None:
        """Greatest force of the spring at the lower stop, with its stiffness kept, that leaves S positive all over,
        N; None where there is none that still holds the sleeve."""
        found = self.curve
        relative = found.dA / found.A
        if (relative <= 0).any():
            return None
        most = float(np.min(self.weights.preload + found.S / relative))
        held = np.min(found.E - self.weights.preload + most)
        return most if most > 0 and held > 0 else None


def solve(given: Given) -> DirectFound:
    """Raises ProblemError where the arms do not reach, or nothing can be chosen, or nothing holds the sleeve."""
    lift = _lift(given)
    z = np.linspace(0.0, lift, POINTS)
    weights = _chosen(given, lift)
    geometry, lowest = given.geometry, given.lowest
    table = equilibrium(geometry.moves(z, lowest), weights)
    curve = equilibrium(geometry.moves(np.linspace(0.0, lift, CURVE), lowest), weights)
    _held(curve, weights)
    if given.sleeve.friction >= curve.E.min():
        raise mistakes.stuck(given.sleeve.friction, float(curve.E.min()))
    found = DirectFound(given, steps.mechanism(given), lift, weights, table, curve)
    steps.direct(found)
    return found


# --- the places


def _lift(given: Given) -> float:
    """Of the sleeve, m; the mechanism moves through all of it."""
    if isinstance(given.geometry, BellCrank):
        return _crank_lift(given.geometry, given)
    return _arms_lift(given.geometry, given)


def _crank_lift(crank: BellCrank, given: Given) -> float:
    highest = given.highest or given.lowest + (given.lift or 0.0) * crank.ball_arm / crank.sleeve_arm
    for radius in (given.lowest, highest):
        if not crank.level and crank.fulcrum is not None and abs(radius - crank.fulcrum) >= crank.ball_arm:
            raise mistakes.crank_over(
                radius, max(0.0, crank.fulcrum - crank.ball_arm), crank.fulcrum + crank.ball_arm
            )
    return float(crank.lift(given.lowest, highest))


def _arms_lift(arms: Arms, given: Given) -> float:
    least, most = _radii(arms)
    for key, radius in (("lowest", given.lowest), ("highest", given.highest)):
        if radius is not None and not least < radius < most:
            raise mistakes.out_of_reach(key, radius, least, most)
    top = float(arms.height(given.lowest))
    if given.highest is not None:
        return top - float(arms.height(given.highest))
    room = top - float(arms.height(most))
    if given.lift is not None and given.lift >= room:
        raise mistakes.too_long_lift(given.lift, room)
    return given.lift or 0.0


def _radii(arms: Arms) -> tuple[float, float]:
    """Between which the pin lifts the sleeve as it goes outwards: from the straight line of both arms to where one of
    them lies level, m."""
    d = arms.lower_offset - arms.upper_offset
    straight = arms.upper_offset + d * arms.upper / (arms.upper + arms.lower)
    most = min(arms.upper_offset + arms.upper, arms.lower_offset + arms.lower)
    return max(0.0, straight), most


# --- what holds the sleeve


def _chosen(given: Given, lift: float) -> Weights:
    """The weights with what is to be chosen."""
    chosen, weights = given.choose, given.weights
    if chosen is None:
        return weights
    if chosen.spring is not None:
        return _spring(given, lift, chosen.spring)
    middle = given.geometry.moves(np.array([lift / 2]), given.lowest)
    if chosen.balls is not None:
        return replace(weights, ball=_balls(middle, weights, chosen.balls))
    speed = chosen.sleeve
    assert speed is not None  # `Choose`
    mass = float(sleeve_mass(middle, weights, speed)[0])
    if mass <= 0:
        raise mistakes.light_sleeve(speed, float(equilibrium(middle, replace(weights, sleeve=0.0)).omega[0]))
    return replace(weights, sleeve=mass)


def _spring(given: Given, lift: float, speeds: tuple[float, float]) -> Weights:
    """The spring for the speeds at both stops; of speeds that fall it makes an unstable governor, and that is told."""
    ends = given.geometry.moves(np.array([0.0, lift]), given.lowest)
    low, high = map(float, spring_force(ends, given.weights, np.array(speeds)))
    bare = equilibrium(ends, replace(given.weights, stiffness=0.0, preload=0.0))
    if low < 0:
        raise mistakes.pulling_spring(-low, speeds[0], float(bare.omega[0]))
    if high < low:
        even = float(np.sqrt((bare.E[1] + low) / bare.A[1]))
        raise mistakes.soft_spring((low, high), speeds, even)
    return replace(given.weights, stiffness=(high - low) / lift, preload=low)


def _balls(middle: Balls, weights: Weights, speed: float) -> float:
    """Mass of a ball for the speed at the middle of the lift, kg."""
    mass = float(ball_mass(middle, weights, speed)[0])
    if mass == 0:
        raise mistakes.weightless_balls()
    if not 0 < mass < np.inf:
        least = np.sqrt(max(0.0, float(weights.gravity * middle.dh[0] / (middle.r * middle.dr)[0])))
        raise mistakes.no_balls(speed, float(least))
    return mass


def _held(curve: Equilibrium, weights: Weights) -> None:
    """Raises ProblemError where nothing holds the sleeve down."""
    worst = int(np.argmin(curve.E))
    if not curve.E[worst] > 0:
        key = "spring" if weights.stiffness or weights.preload else "sleeve"
        raise mistakes.nothing_holds(float(curve.balls.z[worst]), -float(curve.E[worst]), key)
