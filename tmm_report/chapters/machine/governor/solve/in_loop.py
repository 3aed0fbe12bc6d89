"""The machine with its governor: steady states, small motions and their stability, the response to a step of the
load."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.machine.governor.given import Plant
from tmm_report.chapters.machine.governor.solve import mistakes
from tmm_report.chapters.machine.governor.solve import steady_states as steady
from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.chapters.machine.governor.solve.steady_states import Steady
from tmm_report.mechanics.calculus.roots import bisected
from tmm_report.mechanics.machine.governor import stability as small
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
    """`machine` with the load after the step; `before`, `after`: steady states; small motions about the latter;
    `response` to the step; `linear`: the deviation of the speed from the final one by the small motions alone, rad/s;
    `inertial`: A of the governor there, kg m; `throttle_allowed`: friction on the sleeve that the allowed
    insensitivity leaves, N."""

    plant: Plant
    servo: Servo | None
    machine: Machine
    governor: Sleeve
    before: Steady
    after: Steady
    loop: Loop
    response: Response
    linear: Array
    direct: DirectFound
    inertial: float
    throttle_allowed: float | None

    @property
    def friction(self) -> float:
        """On the sleeve without the throttle, N."""
        return self.direct.given.friction

    @property
    def delta(self) -> float:
        """Non-uniformity of the governor."""
        return self.direct.delta

    @property
    def too_heavy(self) -> bool:
        """Whether the throttle costs more than the insensitivity that is allowed: then the sleeve alone cannot move
        it."""
        allowed = self.throttle_allowed
        return allowed is not None and self.friction + self.plant.throttle.force > allowed

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

    @cached_property
    def vyshnegradsky(self) -> tuple[float, float] | None:
        """X, Y of the direct loop; None with a servo, or where a root is positive whatever they are."""
        cubic = small.cubic(self.loop)
        return small.vyshnegradsky(cubic) if self.servo is None and cubic[3] / cubic[0] > 0 else None

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
    def static_error(self) -> float:
        """Change of the steady speed by that before the step."""
        return (self.after.omega - self.before.omega) / self.before.omega

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
    mean = direct.mean / plant.ratio
    machine = Machine(
        plant.inertia,
        plant.torque,
        plant.after,
        mean,
        plant.slope,
        plant.load_slope,
        plant.ratio,
        plant.least,
    )
    moved = direct.given.friction + (plant.throttle.force if servo is None else 0.0)
    governor = sleeve(direct.at, direct.lift, moved, direct.given.damping, direct.lift / 2)
    if missed(governor, direct.at) > MISSED:
        raise mistakes.straight(direct.given.lowest)
    find = steady.direct if servo is None else steady.indirect
    before = find("before", plant.before, machine, plant, direct)
    after = find("after", plant.after, machine, plant, direct)
    loop = _loop(after, machine, plant, direct)
    start = _start(before, after, loop, servo)
    t = np.linspace(0.0, plant.time or _time(loop, servo), MOMENTS)
    response = _response(machine, governor, before, t, servo)
    linear = _linear(loop, servo, start, response, after)
    wanted = plant.throttle.insensitivity
    allowed = direct.friction_for(wanted) if wanted is not None else None
    inertial = float(direct.at(np.array([after.z])).A[0])
    return LoopFound(
        plant, servo, machine, governor, before, after, loop, response, linear, direct, inertial, allowed
    )


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


def _loop(after: Steady, machine: Machine, plant: Plant, direct: DirectFound) -> Loop:
    at = direct.at(np.array([after.z]))
    A, S, mass = (float(one[0]) for one in (at.A, at.S, at.mass))
    return Loop(
        J=plant.inertia,
        D=plant.slope * after.s + plant.load_slope,
        M=after.full,
        supply=1 - plant.least,
        m=mass,
        k=direct.given.damping,
        S=S,
        R=2 * A * after.omega * plant.ratio**2,
        omega=after.omega,
        h=direct.lift,
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
