"""A machine with its governor after a step of the load: large motions, with stops, dry friction and the servo's limits.

J ω' = M_d(ω) s − M_c(ω);  m z'' + m' z'²/2 + k z' + E − A ω_g² = ∓F on the sleeve, ω_g = i ω; the throttle follows the
sleeve, or the piston of a servo: T h s' = −(z − z₀ + x), x' = β h s' − x/T_i. The sleeve rests where the forces do not
exceed friction, and on its stops, which it hits without rebound.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.machine.governor.equilibrium import Equilibrium
from tmm_report.mechanics.machine.governor.stability import Servo
from tmm_report.mechanics.machine.governor.steps import Left, Rates, State, follow, follow_stiff
from tmm_report.records import dataclass

Array = Any
DEGREE = 36  # at most, of the polynomials of E, A, m over the lift
FINE = 1e-10  # of their size, which they leave out
BEYOND = 1e-7  # lifts, by which a stop is passed before it is noticed
NUDGE = 1e-7  # lifts a second: with what a sleeve leaves its rest
PIECES = 200  # stretches between rests, stops and reversals
MOST = 300_000  # evaluations of the rates in all, a second or two
RELATIVE = 1e-6  # tolerance of a step, of each unknown's size
ABSOLUTE = 1e-8  # and of the size of speed, lift, stroke
STIFF = 3000.0  # times, that the quickest motion dies away by e in the whole time, from which it is stiff
LEAVES, TURNS, TOP, FOOT = "leaves", "turns", "top", "foot"  # what ends a stretch: of the sleeve
STALLS = "stalls"  # of the machine
FREE, FULL, LEAST = "free", "full", "least"  # and of the servo's piston


@dataclass(frozen=True)
class Machine:
    """Moments M_d = `torque` − `slope` (ω − ω₀) at full supply, M_c = `load` + `load_slope` (ω − ω₀), N m; inertia,
    kg m²; `ratio` of the governor's speed to the machine's; `least` supply, with the sleeve at its upper stop; ω₀
    rad/s."""

    inertia: float
    torque: float
    load: float
    omega: float
    slope: float = 0.0
    load_slope: float = 0.0
    ratio: float = 1.0
    least: float = 0.0

    def drive(self, omega: Array) -> Array:
        """Moment of the full supply, N m."""
        return self.torque - self.slope * (omega - self.omega)

    def resistance(self, omega: Array) -> Array:
        return self.load + self.load_slope * (omega - self.omega)


@dataclass(frozen=True)
class Sleeve:
    """Of the governor on its lift: the polynomials over −1 … 1, highest power first; `neutral`: where a servo's valve
    is closed, m."""

    E: tuple[float, ...]
    A: tuple[float, ...]
    m: tuple[float, ...]
    dm: tuple[float, ...]
    h: float
    friction: float
    damping: float
    neutral: float


def sleeve(
    at: Callable[[Array], Equilibrium], h: float, friction: float, damping: float, neutral: float = 0.0
) -> Sleeve:
    """`at`: the equilibrium at lifts (P,). E, A and m go through Chebyshev's points of the lift; what is below FINE of
    them is left out."""
    nodes = np.cos(np.pi * (2 * np.arange(DEGREE + 1) + 1) / (2 * DEGREE + 2))
    found = at((nodes + 1) * h / 2)
    E, A, m = (_power_series(nodes, one) for one in (found.E, found.A, found.mass))
    dm = np.polyder(m) * 2 / h
    return Sleeve(_plain(E), _plain(A), _plain(m), _plain(dm), h, friction, damping, neutral)


def _power_series(nodes: Array, f: Array) -> Array:
    """The polynomial through f at Chebyshev's points, highest power first, without the terms that are nothing."""
    terms = np.polynomial.chebyshev.chebvander(nodes, len(nodes) - 1).T @ f * 2 / len(nodes)
    terms[0] /= 2
    rest = np.cumsum(np.abs(terms[::-1]))[::-1]  # of each term and all behind it
    kept = terms[: max(1, int((rest > FINE * np.abs(f).max()).sum()))]
    return np.polynomial.chebyshev.cheb2poly(kept)[::-1]


def missed(governor: Sleeve, at: Callable[[Array], Equilibrium]) -> float:
    """The greatest part by which the polynomials miss `at` between their points: much, where the arms come near to
    their straight line, at which the balls move without the sleeve."""
    z = np.linspace(0.0, governor.h, 2 * DEGREE)
    exact, x = at(z), 2 * z / governor.h - 1
    pairs = (governor.E, exact.E), (governor.A, exact.A), (governor.m, exact.mass)
    return max(float(np.abs(np.polyval(mine, x) / one - 1).max()) for mine, one in pairs)


def _plain(coefficients: Array) -> tuple[float, ...]:
    return tuple(map(float, coefficients))


def horner(coefficients: tuple[float, ...], x: float) -> float:
    total = 0.0
    for one in coefficients:
        total = total * x + one
    return total


class Stalled(ArithmeticError):
    """The machine stops; `at`: when, s."""

    def __init__(self, at: float):
        super().__init__(f"the machine stops after {at} s")
        self.at = at


@dataclass(frozen=True, eq=False)
class Response:
    """At moments `t` (P,), s: speed of the machine, rad/s; lift, m; supply; `x`: the isodromic feedback, m, None
    without. `steps`: evaluations of the rates."""

    t: Array
    omega: Array
    z: Array
    s: Array
    x: Array | None
    steps: int


def respond(
    machine: Machine, governor: Sleeve, start: Array, t: Array, servo: Servo | None = None
) -> Response:
    """From `start` = ω, z, z' (with a servo s, x) at moments t (P,) from 0, to RELATIVE of each unknown in a step.
    Raises Stalled where the machine stops, ArithmeticError where the sleeve goes to and fro without end."""
    y, now, steps, ended = np.array(start, dtype=float), 0.0, 0, ""
    pieces, fine = [], _fine(machine, governor)[: len(start)]
    step = follow_stiff if _quickest(governor, servo) * float(t[-1]) > STIFF else follow
    for _ in range(PIECES):
        way = _way(machine, governor, y, ended == LEAVES)
        limit = 0 if servo is None or ended == FREE else _limit(machine, governor, servo, y)
        y = _started(y, way, governor)
        left = _left(machine, governor, servo, way, limit)
        rate = _rates(machine, governor, servo, way, limit)
        found = step(rate, y.tolist(), (now, float(t[-1])), left, RELATIVE, fine)
        inside = t[(t >= now) & ((t < found.x[-1]) | (found.ended is None))]
        pieces.append(found.at(inside) if len(inside) else np.empty((len(y), 0)))
        now, steps = float(found.x[-1]), steps + found.steps
        if found.ended is None:
            return _response(machine, governor, servo, t, np.concatenate(pieces, axis=1), steps)
        end = left(found.y[:, -1].tolist())
        ended = min(end, key=end.__getitem__)
        if ended == STALLS:
            raise Stalled(now)
        if steps > MOST:
            break
        y = _stopped(found.y[:, -1], governor, machine, ended)
    raise ArithmeticError("the sleeve goes to and fro without end")


def _quickest(governor: Sleeve, servo: Servo | None) -> float:
    """The quickest of what dies away by itself, the dashpots of sleeve and isodrome, 1/s."""
    damped = governor.damping / min(horner(governor.m, x) for x in (-1.0, 0.0, 1.0))
    return max(damped, servo.beta / servo.T + 1 / servo.Ti if servo and servo.beta else 0.0)


def _response(
    machine: Machine, governor: Sleeve, servo: Servo | None, t: Array, y: Array, steps: int
) -> Response:
    omega, z, _, *rest = y
    s = rest[0] if servo else _throttle(machine, governor, z)
    return Response(t, omega, z, s, rest[1] if servo and servo.beta else None, steps)


def _fine(machine: Machine, governor: Sleeve) -> State:
    """What is nothing of each unknown."""
    h = governor.h
    return [ABSOLUTE * one for one in (machine.omega, h, h, 1.0, h)]


def _throttle(machine: Machine, governor: Sleeve, z: Array) -> Array:
    return 1 - (1 - machine.least) * z / governor.h


def _net(machine: Machine, governor: Sleeve, y: Any) -> float:
    """Force that lifts the sleeve, without friction, N."""
    x = 2 * y[1] / governor.h - 1
    return horner(governor.A, x) * (machine.ratio * y[0]) ** 2 - horner(governor.E, x)


# --- the sleeve moves, or rests


def _way(machine: Machine, governor: Sleeve, y: Array, leaves: bool) -> int | None:
    """The sense in which the sleeve goes, against which friction acts: 1, −1; 0: without friction; None: it rests.
    `leaves`: it rested until now, and just begins to move."""
    net, z, v = float(_net(machine, governor, y)), y[1], y[2]
    if v or leaves:
        return int(np.sign(v or net)) if governor.friction else 0
    on_stop = (z >= governor.h and net > -governor.friction) or (z <= 0 and net < governor.friction)
    if on_stop or (governor.friction and abs(net) <= governor.friction):
        return None
    return int(np.sign(net)) if governor.friction else 0


def _started(y: Array, way: int | None, governor: Sleeve) -> Array:
    """With a speed that events can tell from rest."""
    if way and not y[2]:
        y = y.copy()
        y[2] = way * NUDGE * governor.h
    return y


def _stopped(y: Array, governor: Sleeve, machine: Machine, ended: str) -> Array:
    """The state after an event: the sleeve at rest where it hit a stop or turns, the supply at its limit."""
    y = y.copy()
    if ended in (TOP, FOOT):
        y[1], y[2] = (governor.h if ended == TOP else 0.0), 0.0
    elif ended == TURNS:
        y[2] = 0.0
    elif ended in (FULL, LEAST):
        y[3] = 1.0 if ended == FULL else machine.least
    return y


def _left(machine: Machine, governor: Sleeve, servo: Servo | None, way: int | None, limit: int) -> Left:
    """What is left of each state until a stretch ends, positive while it lasts: before the machine stops, the sleeve
    leaves its rest or meets a stop or turns, the piston meets an end of its stroke or leaves it."""
    h, friction, least = governor.h, bool(governor.friction), machine.least

    def left(y: State) -> dict[str, float]:
        found = {STALLS: y[0]}
        if way is None:
            found[LEAVES] = _rests(machine, governor, y)
        else:
            found |= {TOP: h * (1 + BEYOND) - y[1], FOOT: y[1] + h * BEYOND}
            if friction:
                found[TURNS] = way * y[2]
        if servo is not None and limit:
            found[FREE] = -limit * _shift(governor, servo, y)
        elif servo is not None:
            found |= {FULL: 1 + BEYOND - y[3], LEAST: y[3] - least + BEYOND}
        return found

    return left


def _rests(machine: Machine, governor: Sleeve, y: State) -> float:
    """Positive while a resting sleeve stays."""
    net, F = _net(machine, governor, y), governor.friction
    up = F - net if y[1] < governor.h else np.inf
    down = net + F if y[1] > 0 else np.inf
    return min(up, down)


# --- the servo


def _shift(governor: Sleeve, servo: Servo, y: Any) -> float:
    """By what the valve is open, m: beyond its dead zone."""
    shift = y[1] - governor.neutral + (y[4] if servo.beta else 0.0)
    return float(shift - min(max(shift, -servo.zone), servo.zone))


def _limit(machine: Machine, governor: Sleeve, servo: Servo, y: Array) -> int:
    """The end of its stroke to which the piston is pressed: 1 full supply, −1 the least; 0: to none."""
    shift = _shift(governor, servo, y)
    return int(y[3] >= 1 and shift < 0) - int(y[3] <= machine.least and shift > 0)


# --- the rates


def _rates(machine: Machine, governor: Sleeve, servo: Servo | None, way: int | None, limit: int) -> Rates:
    h, F, k, least = governor.h, governor.friction * (way or 0), governor.damping, machine.least

    def supply(y: State) -> tuple[float, State]:
        """Supply of the machine and the rates of the servo."""
        if servo is None:
            return 1 - (1 - least) * y[1] / h, []
        ds = 0.0 if limit else -_shift(governor, servo, y) / (h * servo.T)
        back = [servo.beta * h * ds - y[4] / servo.Ti] if servo.beta else []
        return y[3], [ds, *back]

    def rate(t: float, y: State) -> State:
        s, others = supply(y)
        turned = (machine.drive(y[0]) * s - machine.resistance(y[0])) / machine.inertia
        if way is None:
            return [turned, 0.0, 0.0, *others]
        x, v = 2 * y[1] / h - 1, y[2]
        net = horner(governor.A, x) * (machine.ratio * y[0]) ** 2 - horner(governor.E, x)
        lifted = (net - F - k * v - horner(governor.dm, x) * v * v / 2) / horner(governor.m, x)
        return [turned, v, lifted, *others]

    return rate
