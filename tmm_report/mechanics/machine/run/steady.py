"""Steady motion of a machine: the speed that repeats each cycle, found as a periodic solution and not by waiting.

In T = J ω²/2 as a function of the angle the equation is dT/dφ = M(φ, √(2T/J)). On each panel T is the polynomial that
meets it at the Gauss points (collocation); Newton's method solves for all panels at once, each step a linear equation
whose map over a cycle, δ_end = g δ_start + c, is closed by δ_start = c/(1 − g). At the solution g is the multiplier of
Poincaré's map: by it a disturbance of T is multiplied in a cycle. (Hairer, Nørsett, Wanner, Solving ODE I, ch. II.7;
Seydel, Bifurcation and stability analysis, ch. 7)
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.mechanics.calculus.roots import newton
from tmm_report.mechanics.machine.characteristics import Geared
from tmm_report.mechanics.machine.reduced import LOST, Acting, Plant
from tmm_report.records import dataclass

Array = Any
STEPS, DONE = 40, 1e-12
LEAST = 1e-14  # of the energies, above zero, with which the slowest place is passed
NUDGE = 1e-6  # of the speed: for the slope of a characteristic


class NotSteady(ArithmeticError):
    """No periodic motion was found: the machine stops on the way, at the angle `phi`, rad."""

    def __init__(self, phi: float):
        super().__init__(phi)
        self.phi = phi


@dataclass(frozen=True, eq=False)
class Steady:
    """`energy` (K, n): kinetic energy at the points of the panels, J; `multiplier` g; `steps` of Newton's method."""

    plant: Plant
    energy: Array
    multiplier: float
    steps: int

    @cached_property
    def omega(self) -> Array:
        """Angular velocity, rad/s, (K, n)."""
        return np.sqrt(2 * self.energy / self.plant.inertia)

    def speed(self, phi: float) -> float:
        """Angular velocity at an angle, rad/s."""
        return float(self.plant.panels.at(self.omega, np.array([phi]))[0])

    @cached_property
    def moment(self) -> Array:
        """Of all that acts, N m, (K, n)."""
        return moment_at(self.plant, self.omega)

    @cached_property
    def epsilon(self) -> Array:
        """Angular acceleration by the equation in differential form, rad/s², (K, n)."""
        plant = self.plant
        return (self.moment - plant.slope * self.omega**2 / 2) / plant.inertia

    @property
    def time(self) -> Array:
        """From position 0, s, (K, n)."""
        return self.plant.panels.running(1 / self.omega)

    @property
    def cycle(self) -> float:
        """Time of a cycle, s."""
        return float(self.plant.panels.total(1 / self.omega))

    @cached_property
    def extremes(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Least and greatest ω with the angles turned there."""
        return self.plant.panels.extremes(self.omega)

    def given_by(self, key: str) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """Least and greatest moment of one that acts by a law of the speed, with the angles turned there; None where
        nothing does by this key."""
        one = next((one for one in self.plant.laws if one.key == key), None)
        return (
            None
            if one is None
            else self.plant.panels.extremes(one.at(self.omega) + np.zeros_like(self.omega))
        )

    @property
    def mean(self) -> float:
        """Half the sum of the extremes, rad/s."""
        return (self.extremes[0][0] + self.extremes[1][0]) / 2

    @property
    def delta(self) -> float:
        """Coefficient of speed fluctuation of the motion."""
        return (self.extremes[1][0] - self.extremes[0][0]) / self.mean

    @cached_property
    def works(self) -> dict[str, float]:
        """Work of each that acts over the cycle, J."""
        panels, found = self.plant.panels, {}
        for one in self.plant.acting:
            values = one.values if one.by_angle else one.at(self.omega) + np.zeros(panels.shape)
            found[one.key] = float(panels.total(values))
        if self.plant.passing is not None:
            found[LOST] = float(panels.total(self.moment - self.plant.acted(self.omega)))
        return found

    @cached_property
    def bends(self) -> Array:
        """Angles at which a power turns in a gear, of a part that is accelerated or of a motor that brakes: the moment
        is bent there, and integrals over it want an edge, (B,)."""
        panels = self.plant.panels
        turns = [
            one.at(self.omega) for one in self.plant.laws if isinstance(one.law, Geared) and one.law.lossy
        ]
        if self.plant.passing is not None:
            turns += [self.epsilon - one for one in self.plant.passing.bends]
        return np.concatenate([np.zeros(0), *(panels.roots(one, within=True) for one in turns)])

    @cached_property
    def residual(self) -> float:
        """Worst difference of ω dω/dφ, by differences of the found ω, from the angular acceleration by the equation:
        relative to the moments that act by the moment of inertia there."""
        by_slope = self.omega * self.plant.panels.slope(self.omega)
        sizes = sum(
            (np.abs(one.values) for one in self.plant.acting if one.by_angle), np.zeros(self.omega.shape)
        )
        sizes = sizes + sum(np.abs(one.at(self.omega)) for one in self.plant.laws)
        size = float((sizes / self.plant.inertia).max()) + float(np.abs(self.epsilon).max())
        return float(np.abs(by_slope - self.epsilon).max()) / (size or 1.0)


def moment_at(plant: Plant, omega: Array) -> Array:
    """Of all that acts, less what the gears lose by the acceleration, N m, at speeds at the points (K, n)."""
    acted = plant.acted(omega)
    return acted - plant.lost(acted, omega, plant.inertia, plant.slope)


def periodic(plant: Plant, guess: float) -> Steady:
    """The motion that repeats each cycle and is stable, of laws of the speed. `guess`: rad/s, about which it runs.

    Raises NotSteady."""
    panels = plant.panels
    swing = panels.running(plant.placed - plant.mean_moment)
    level = float(panels.mean(plant.inertia)) * guess**2 / 2
    swinging = np.maximum(level + swing - panels.mean(swing), level / 20)
    last: Array = swinging
    for energy in (plant.inertia * guess**2 / 2, swinging):
        found = _closed(plant, energy)
        if isinstance(found, Steady) and found.multiplier < 1:
            return found
        last = found.energy if isinstance(found, Steady) else found
    raise NotSteady(float(panels.x.flat[int(np.argmin(last))]))


def _closed(plant: Plant, energy: Array) -> Steady | Array:
    """Newton's method from a first T; what it has come to where it does not end."""
    rule, start = _Rule.of(plant.panels), float(energy[0, 0])
    for step in range(1, STEPS + 1):
        linear = _step(plant, rule, energy, start)
        change_of_start, multiplier = linear.closed()
        change, _ = linear.changes(change_of_start)
        share = 1.0
        while (energy + share * change <= 0).any() and share > 1e-6:
            share /= 2
        energy, start = energy + share * change, start + share * change_of_start
        if share < 1e-3:
            break
        if share == 1.0 and float(np.abs(change).max()) <= DONE * float(energy.max()):
            return Steady(plant, energy, multiplier, step)
    return energy


def advanced(plant: Plant, guess: Array, start: float) -> Array | None:
    """T over one cycle from its value `start` at the angle 0, (K, n), by the same collocation; `guess`: of it. None
    where Newton's method does not come to it: the machine is about to stop."""
    rule, energy = _Rule.of(plant.panels), guess
    for _ in range(12):
        step = _step(plant, rule, energy, start)
        change, _ = step.changes(0.0)
        energy = energy + change
        if (energy <= 0).any():
            return None
        if float(np.abs(change).max()) <= 1e-12 * float(energy.max()):
            return energy
    return None


@dataclass(frozen=True, eq=False)
class _Rule:
    """Of one panel from −1 to 1: running integrals (n, n) and weights (n,)."""

    running: Array
    weights: Array

    @classmethod
    def of(cls, panels: Panels) -> _Rule:
        one = Panels(np.array([0.0, 2.0]), panels.order)
        unit = np.eye(panels.order)[:, None, :]
        return cls(one.running(unit)[:, 0, :].T, one.total(unit))


@dataclass(frozen=True, eq=False)
class _Step:
    """The linear equation of a step of Newton's method: on a panel the change of T is `gain` δ_start + `shift` at the
    points (K, n), and g δ_start + c at its end, (K,); `closing`: what T lacks over the cycle."""

    gain: Array
    shift: Array
    g: list[float]
    c: list[float]
    closing: float

    def closed(self) -> tuple[float, float]:
        """The change at the start by which the cycle closes; the multiplier."""
        product, ahead = 1.0, 0.0
        for gain, shift in zip(self.g, self.c, strict=True):
            product, ahead = product * gain, gain * ahead + shift
        return ((ahead + self.closing) / (1 - product) if product != 1 else 0.0), product

    def changes(self, first: float) -> tuple[Array, float]:
        """The change of T at the points, (K, n), and after the cycle, for a change at the start."""
        before, value = [], first
        for gain, shift in zip(self.g, self.c, strict=True):
            before.append(value)
            value = gain * value + shift
        return self.gain * np.array(before)[:, None] + self.shift, value


def _step(plant: Plant, rule: _Rule, energy: Array, start: float) -> _Step:
    """The edges are summed up from the start, so that they are off nowhere but at the end."""
    panels, half = plant.panels, plant.panels.half
    omega = np.sqrt(2 * energy / plant.inertia)
    moment = moment_at(plant, omega)
    rate = _slope(plant, omega) / (plant.inertia * omega)  # dM/dT
    edges = start + np.concatenate([[0.0], np.cumsum((moment @ rule.weights) * half[:, 0])])
    off = energy - edges[:-1, None] - half * (moment @ rule.running.T)
    matrix = np.eye(panels.order) - half[:, :, None] * rule.running * rate[:, None, :]
    one = np.linalg.solve(matrix, np.stack([np.ones(off.shape), -off], axis=-1))
    gain, shift = one[:, :, 0], one[:, :, 1]
    through = half * rule.weights * rate
    g, c = 1 + np.sum(through * gain, axis=1), np.sum(through * shift, axis=1)
    return _Step(gain, shift, g.tolist(), c.tolist(), float(edges[-1] - start))


def _slope(plant: Plant, omega: Array) -> Array:
    """dM/dω of the characteristics, and of what the gears lose."""
    step = NUDGE * omega
    if plant.passing is not None:
        up, down = (moment_at(plant, omega + s) for s in (step, -step))
    else:
        up, down = (
            sum((one.at(omega + s) for one in plant.laws), np.zeros(omega.shape)) for s in (step, -step)
        )
    return (up - down) / (2 * step)


def at_mean_speed(plant: Plant, mean: float) -> Steady:
    """The motion under moments that depend on the angle alone and whose work over the cycle is nil: T is their running
    work from an energy by which the mean of the extremes of ω is `mean`. Raises NotSteady where that is not above zero
    all round.

    What gears lose by the acceleration depends on the motion a little: it is found again from each until none changes;
    its work is what the cycle then lacks."""
    found = _of_works(plant, plant.placed, mean)
    if plant.passing is None:
        return found
    for _ in range(STEPS):
        before, found = found, _of_works(plant, found.moment, mean)
        if float(np.abs(found.energy - before.energy).max()) <= DONE * float(found.energy.max()):
            break
    return found


def closing(plant: Plant, mean: float) -> float:
    """The constant moment by which the work of a cycle at this mean speed is nil, N m, where moments depend on the
    angle alone. Raises NotSteady."""
    more = -plant.mean_moment
    if plant.passing is None:
        return more
    for _ in range(STEPS):
        driven = replace(plant, acting=(*plant.acting, Acting("closing", np.full(plant.panels.shape, more))))
        lacks = float(plant.panels.mean(at_mean_speed(driven, mean).moment))
        more -= lacks
        if abs(lacks) <= DONE * float(np.abs(driven.placed).max()):
            break
    return more


def _of_works(plant: Plant, moment: Array, mean: float) -> Steady:
    """T as the running work of a `moment` at the points, (K, n)."""
    swing = plant.panels.running(moment)
    swing = swing - plant.panels.mean(swing)
    heavy, low = float(plant.panels.mean(plant.inertia)), -float(swing.min())

    def motion(level: float) -> Steady:
        """About a mean energy, J."""
        return Steady(plant, level + swing, 1.0, 0)

    def slow(level: float) -> tuple[float, float]:
        """What the energy lacks at the mean speed, J, for which the level makes up all but one for one."""
        return heavy * (mean**2 - motion(level).mean ** 2) / 2, -1.0

    least = low + LEAST * heavy * mean**2
    if slow(least)[0] <= 0:
        raise NotSteady(float(plant.panels.x.flat[int(np.argmin(swing))]))
    most = max(least, low + float(np.max(plant.inertia)) * mean**2 / 2)  # nowhere below the mean speed
    return motion(newton(slow, least, most, max(least, heavy * mean**2 / 2)))
