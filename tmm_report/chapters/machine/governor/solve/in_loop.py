"""The machine with its governor: steady states, small motions and their stability, the response to a step of the
load."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.machine.governor import steps
from tmm_report.chapters.machine.governor.given import Plant
from tmm_report.chapters.machine.governor.solve import mistakes
from tmm_report.chapters.machine.governor.solve import steady_states as steady
from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.chapters.machine.governor.solve.steady_states import Steady
from tmm_report.chapters.machine.governor.values import Values
from tmm_report.mechanics.calculus.roots import bisected
from tmm_report.mechanics.machine.governor import stability as small
from tmm_report.mechanics.machine.governor.equilibrium import Equilibrium
from tmm_report.mechanics.machine.governor.response import (
    Machine,
    Response,
    Sleeve,
    Stalled,
    missed,
    respond,
    sleeve,
)
from tmm_report.mechanics.machine.governor.stability import Loop, Servo
from tmm_report.records import dataclass

Array = Any
MOMENTS = 401  # of the response
LASTING = 8.0  # how many times the slowest motion dies away by e in the time that is shown
SWINGS = 10.0  # that are shown where nothing dies away
BEYOND = 3.0  # times the greatest deviation, to which the small motions are followed
ZONE = 0.05  # part of the greatest deviation within which the response counts as settled
ROUND = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)  # lengths of time, times a power of ten
CHART = 241  # points of the boundary over two parameters
NEAR = 1e-6  # of the lift, at which a stop is met
MISSED = 1e-3  # part of the forces and the reduced mass by which the large motions may be off
FAR = 4.0  # how many times what is stated the chart goes to at most


@dataclass(frozen=True, eq=False)
class LoopFound:
    """`s`: the single numbers; `before`, `after`: steady states; small motions about the latter, `there`: of the
    governor in it; `response` to the step; `linear`: the deviation of the speed from the final one by the small
    motions alone, rad/s."""

    s: Values
    plant: Plant
    servo: Servo | None
    governor: Sleeve
    before: Steady
    after: Steady
    there: Equilibrium
    loop: Loop
    response: Response
    linear: Array
    direct: DirectFound

    @property
    def too_heavy(self) -> bool:
        """Whether the throttle costs more than the insensitiveness that is allowed: then the sleeve alone cannot move
        it."""
        return "F_allowed" in self.s and self.s.number("F_sum") > self.s.number("F_allowed")

    # --- stability

    @cached_property
    def matrix(self) -> Array:
        return small.matrix(self.loop, self.servo)

    @property
    def states(self) -> tuple[str, ...]:
        return small.states(self.servo)

    @cached_property
    def eigenvalues(self) -> Array:
        """The slowest first, of a pair the one with the positive frequency first."""
        found = np.linalg.eigvals(self.matrix)
        return found[np.lexsort((-found.imag, -np.round(found.real, 9)))]

    @cached_property
    def polynomial(self) -> Array:
        """Of the direct loop as it is written out, of the others divided by the leading coefficient."""
        return small.cubic(self.loop) if self.servo is None else small.polynomial(self.loop, self.servo)

    @cached_property
    def hurwitz(self) -> Array:
        return small.hurwitz(self.polynomial)

    @property
    def stable(self) -> bool:
        return bool((self.eigenvalues.real < 0).all())

    @property
    def vyshnegradsky(self) -> tuple[float, float] | None:
        """X, Y of the direct loop; None with a servo, or where a root is positive whatever they are."""
        return (self.s.number("X"), self.s.number("Y")) if "X" in self.s else None

    @cached_property
    def damping_needed(self) -> float | None:
        return small.damping_needed(self.loop) if self.servo is None else None

    @cached_property
    def boundary(self) -> tuple[Array, Array, Array]:
        """ν, β, T_i of the boundary of stability of the loop with an isodrome, evenly along it, as far as the chart
        goes."""
        servo = self.servo
        assert servo is not None
        nu = np.geomspace(1e-4, 1.0, 4 * CHART) * 1.2 * float(np.abs(self.eigenvalues).max())
        for _ in range(4):
            beta, q = small.isodrome_boundary(self.loop, servo.T, nu)
            place = np.clip(1 / np.maximum(q, 1e-12) / servo.Ti, 0, FAR) + 1j * np.clip(
                beta / servo.beta, 0, FAR
            )
            length = np.append(0.0, np.cumsum(np.abs(np.diff(place))))
            nu = np.interp(np.linspace(0, length[-1], CHART), length, nu)
        beta, q = small.isodrome_boundary(self.loop, servo.T, nu)
        kept = (beta > 0) & (q * servo.Ti * FAR > 1) & (beta < FAR * servo.beta)
        return nu[kept], beta[kept], 1 / q[kept]

    @cached_property
    def feedback_needed(self) -> tuple[float, float] | None:
        """Least and greatest β that are stable with the time T_i of the isodrome; None where none is."""
        servo = self.servo
        if servo is None or not servo.beta:
            return None
        tried = servo.beta * np.geomspace(1e-3, 1e3, 91)
        good = np.array([self._holds(beta) for beta in tried])
        if not good.any():
            return None
        first, last = int(np.argmax(good)), len(good) - 1 - int(np.argmax(good[::-1]))
        low = self._edge(tried[first - 1], tried[first]) if first else 0.0
        high = self._edge(tried[last + 1], tried[last]) if last < len(good) - 1 else np.inf
        return low, high

    def _holds(self, beta: float) -> bool:
        assert self.servo is not None
        return small.stable(small.polynomial(self.loop, Servo(self.servo.T, 0.0, float(beta), self.servo.Ti)))

    def _edge(self, bad: float, good: float) -> float:
        """The last β that is stable on the way from one that is not."""
        if bad < good:
            return bisected(lambda beta: not self._holds(beta), bad, good)[1]
        return bisected(self._holds, good, bad)[0]

    # --- the response

    @property
    def stopped(self) -> bool:
        """Whether the sleeve meets one of its stops."""
        z, h = self.response.z, self.governor.h
        return bool(z.min() <= NEAR * h or z.max() >= (1 - NEAR) * h)

    @property
    def final(self) -> float:
        """Speed that the machine comes to, rad/s: with friction the sleeve, with a dead zone the piston rests as soon
        as it may, short of equilibrium."""
        return float(self.response.omega[-1]) if self.governor.friction or self.zone else self.after.omega

    @property
    def zone(self) -> float:
        """Dead zone of the servomotor's valve, m."""
        return self.servo.zone if self.servo else 0.0

    @property
    def short(self) -> bool:
        """Whether friction or the dead zone hold it noticeably short of its steady state."""
        return bool(self.zone or (self.governor.friction and not self.servo))

    @cached_property
    def deviation(self) -> Array:
        """Of the speed from the final one, rad/s."""
        return self.response.omega - self.final

    @cached_property
    def worst(self) -> int:
        """The moment of the greatest deviation from the speed before the step."""
        return int(np.argmax(np.abs(self.response.omega - self.before.omega)))

    @property
    def peak(self) -> float:
        """The greatest deviation from the speed before the step, by that speed."""
        return float(self.response.omega[self.worst] / self.before.omega - 1)

    @property
    def settled(self) -> float | None:
        """After which the speed stays within `ZONE` of the greatest deviation from the final one, s; None: it does
        not."""
        off = np.abs(self.deviation)
        outside = np.flatnonzero(off > ZONE * off.max())
        if not len(outside):
            return 0.0
        return (
            float(self.response.t[outside[-1] + 1]) if outside[-1] + 1 < len(off) - len(off) // 20 else None
        )


def solve(plant: Plant, servo: Servo | None, direct: DirectFound) -> LoopFound:
    """Raises ProblemError where a load finds no equilibrium."""
    given, mean, least = direct.given, direct.mean / plant.ratio, plant.throttle.least
    machine = Machine(
        inertia=plant.inertia,
        torque=plant.torque.full,
        load=plant.load.after,
        omega=mean,
        slope=plant.torque.slope,
        load_slope=plant.load.slope,
        ratio=plant.ratio,
        least=least,
    )
    moved = given.sleeve.friction + (plant.throttle.force if servo is None else 0.0)
    governor = sleeve(direct.at, direct.lift, moved, given.sleeve.damping, direct.lift / 2)
    if missed(governor, direct.at) > MISSED:
        raise mistakes.straight(given.lowest)
    find = steady.direct if servo is None else steady.indirect
    before = find("before", plant.load.before, machine, plant, direct)
    after = find("after", plant.load.after, machine, plant, direct)
    s, there = direct.s, direct.at(np.array([after.z]))
    steps.machine(s, plant, mean, after, there)
    loop = _loop(s, least)
    start = _start(before, after, loop, servo)
    t = np.linspace(0.0, plant.time or _time(loop, servo), MOMENTS)
    response = _response(machine, governor, before, t, servo)
    linear = _linear(loop, servo, start, response, after)
    found = LoopFound(s, plant, servo, governor, before, after, there, loop, response, linear, direct)
    steps.loop(found)
    return found


def _linear(loop: Loop, servo: Servo | None, start: Array, response: Response, after: Steady) -> Array:
    """Deviation of the speed by the small motions, rad/s; nan from where they grow far beyond the large ones."""
    found = small.linear(small.matrix(loop, servo), start, float(response.t[-1]), MOMENTS)[0] * after.omega
    most = BEYOND * np.abs(response.omega - after.omega).max()
    return np.where(np.maximum.accumulate(np.abs(found)) <= most, found, np.nan)


def _response(machine: Machine, governor: Sleeve, before: Steady, t: Array, servo: Servo | None) -> Response:
    start = [before.omega, before.z, 0.0]
    if servo is not None:
        start += [before.s, *([0.0] if servo.beta else [])]
    try:
        return respond(machine, governor, np.array(start), t, servo)
    except Stalled as stalled:
        raise mistakes.stalls(stalled.at) from None
    except (ArithmeticError, ValueError):  # an event that is nearer than the digits of the time
        raise mistakes.chatters() from None


# --- small motions


def _loop(s: Values, least: float) -> Loop:
    """`least`: supply with the sleeve at its upper stop."""
    return Loop(
        J=s.number("J"),
        D=s.number("D"),
        M=s.number("after_M_d"),
        supply=1 - least,
        m=s.number("after_m"),
        k=s.number("k"),
        S=s.number("after_S"),
        R=s.number("R"),
        omega=s.number("after_omega"),
        h=s.number("h"),
    )


def _start(before: Steady, after: Steady, loop: Loop, servo: Servo | None) -> Array:
    """Relative deviations of the state before the step from that after it."""
    phi, eta = before.omega / after.omega - 1, (before.z - after.z) / loop.h
    sigma = [] if servo is None else [before.s - after.s, *([0.0] if servo.beta else [])]
    return np.array([phi, eta, 0.0, *sigma])


def _time(loop: Loop, servo: Servo | None) -> float:
    """A round time in which the slowest motion dies away, or some swings of what does not."""
    found = np.linalg.eigvals(small.matrix(loop, servo))
    slowest = found[np.argmax(found.real)]
    swing = 2 * np.pi / max(abs(slowest), 1e-9)
    time = LASTING / -slowest.real if slowest.real < 0 else SWINGS * swing
    power = 10.0 ** np.floor(np.log10(time))
    return float(power * next(step for step in ROUND if time <= step * power * (1 + 1e-9)))
