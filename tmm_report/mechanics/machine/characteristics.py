"""Characteristics of motors and working machines: the moment on a shaft as a function of its speed, angle or time.

All are moments in the sense of rotation, N m, of ω rad/s, φ rad and t s, numbers or arrays; a resistance is above zero
where it is against the rotation, and whoever adds it up changes its sign. `of` says what a characteristic depends on.
What is stated by points, and what is constant, are `calculus.laws`; here are the motors' own, and their gears.
(Klyuchev, Theory of electric drives, ch. 3–4; Dubey, Fundamentals of electrical drives, ch. 5–6)
"""

from __future__ import annotations

import math
from typing import Any, ClassVar, Protocol

import numpy as np

from tmm_report.mechanics.calculus.laws import DOUBLES, SPEED, Arithmetic, Break, Law
from tmm_report.records import dataclass

Array = Any


class Characteristic(Protocol):
    @property
    def of(self) -> str:
        """What it depends on."""

    def at(self, omega: Array, phi: Array = 0.0, t: Array = 0.0) -> Array:
        """The moment, N m."""

    def breaks(self) -> tuple[Break, ...]:
        """Places on its axis at which it has a corner or a jump."""


@dataclass(frozen=True)
class Linear(Law):
    """A shunt or separately excited motor: M = M0 (1 − ω/ω0), `stall`: M0 at rest, `no_load`: ω0 without a load."""

    of: ClassVar[str] = SPEED
    stall: float
    no_load: float

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        return self.stall * (1 - at / self.no_load)


@dataclass(frozen=True)
class Series(Law):
    """A series-wound motor without saturation: M = a/(ω + b)², a in N m/s², b in rad/s."""

    of: ClassVar[str] = SPEED
    a: float
    b: float

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        return self.a / (at + self.b) ** 2


@dataclass(frozen=True)
class Kloss(Law):
    """An induction motor: M = 2 M_max (1 + a s_m)/(s/s_m + s_m/s + 2 a s_m), s = 1 − ω/ω_s.

    `synchronous`: ω_s; `greatest`: M_max; `critical`: s_m; `a`: resistance of the stator to that of the rotor; 0 is
    Kloss's simplified formula. (Kloss, 1909; Klyuchev, § 3.11)
    """

    of: ClassVar[str] = SPEED
    synchronous: float
    greatest: float
    critical: float
    a: float = 0.0

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        s, m = 1 - at / self.synchronous, self.critical
        return 2 * self.greatest * (1 + self.a * m) * s * m / (s * s + m * m + 2 * self.a * m * m * s)


@dataclass(frozen=True)
class Power(Law):
    """A resistance M (ω/ω_n)^k: k = 1 viscous, k = 2 of a fan or a pump; against the motion in either sense."""

    of: ClassVar[str] = SPEED
    moment: float
    speed: float
    exponent: int = 1

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        share = at / self.speed
        return self.moment * (share if self.exponent == 1 else share * abs(share))


@dataclass(frozen=True, eq=False)
class Reversed:
    """A motor whose supply is reversed while it runs on (plugging): M(ω) = −M_motor(−ω)."""

    of: ClassVar[str] = SPEED
    motor: Characteristic

    def at(self, omega: Array, phi: Array = 0.0, t: Array = 0.0) -> Array:
        return -self.motor.at(-omega, phi, t)

    def breaks(self) -> tuple[Break, ...]:
        return tuple(Break(-one.at, -one.after, -one.before) for one in self.motor.breaks())


def reversed_(law: Characteristic) -> Characteristic:
    """The motor itself reversed, not its gear."""
    if isinstance(law, Geared):
        return Geared(Reversed(law.inner), law.ratio, law.efficiency)
    return Reversed(law)


@dataclass(frozen=True, eq=False)
class Geared:
    """A characteristic of a motor on another shaft, on the main one: M(ω i) i η, `ratio` i of their speeds.

    `efficiency` of the gear between: where the motor brakes, the power goes the other way, and the gear's losses brake
    too: M i/η. By angle it is stated of the main shaft's.
    """

    inner: Characteristic
    ratio: float
    efficiency: float = 1.0

    @property
    def of(self) -> str:
        return self.inner.of

    @property
    def lossy(self) -> bool:
        return self.efficiency < 1

    def at(self, omega: Array, phi: Array = 0.0, t: Array = 0.0) -> Array:
        own, eta = self.inner.at(omega * self.ratio, phi, t), self.efficiency
        if isinstance(own, float):  # an integrator asks for one value at a time
            return self.ratio * own * (eta if own > 0 else 1 / eta)
        return self.ratio * own * np.where(np.asarray(own) > 0, eta, 1 / eta)

    def breaks(self) -> tuple[Break, ...]:
        """Of the moment on the motor's own shaft, at the speeds of the main one."""
        ratio = self.ratio if self.of == SPEED else 1.0
        return tuple(one._replace(at=one.at / ratio) for one in self.inner.breaks())


# ---------------------------------------------------------------- from what a name plate says


def shunt(moment: float, speed: float, no_load: float) -> Linear:
    """Through the nominal point and the speed without a load."""
    return Linear(moment / (1 - speed / no_load), no_load)


def shunt_of_circuit(voltage: float, resistance: float, constant: float) -> Linear:
    """V, R and kΦ: stalled kΦ V/R, without a load V/(kΦ)."""
    return Linear(constant * voltage / resistance, voltage / constant)


def series(moment: float, speed: float, stall: float) -> Series:
    """Through the nominal point and the moment at rest: b = ω_n/(√(M0/M_n) − 1), a = M0 b²."""
    b = speed / (math.sqrt(stall / moment) - 1)
    return Series(stall * b * b, b)


def series_of_circuit(voltage: float, resistance: float, constant: float) -> Series:
    """V, R and k, by which M = k I² and E = k ω I: I = V/(R + k ω), so that a = V²/k, b = R/k."""
    return Series(voltage**2 / constant, resistance / constant)


def kloss(moment: float, speed: float, synchronous: float, overload: float, a: float = 0.0) -> Kloss:
    """Through the nominal point, λ = M_max/M_n: s_m = s_n (λ + √(λ² − q))/q, q = 1 − 2 a s_n (λ − 1).

    Raises ArithmeticError where q is not above zero: with so much resistance of the stator no curve of the formula
    goes through the point. (Klyuchev, § 3.11)
    """
    slip = 1 - speed / synchronous
    share = 1 - 2 * a * slip * (overload - 1)
    if share <= 0:
        raise ArithmeticError
    return Kloss(
        synchronous, overload * moment, slip * (overload + math.sqrt(overload**2 - share)) / share, a
    )


def kloss_of_circuit(
    voltage: float, synchronous: float, R1: float, R2: float, X: float, phases: int = 3
) -> Kloss:
    """Of the equivalent circuit: phase voltage V, ω_s, resistances, both reactances together (all of the stator).

    s_m = R2/√(R1² + X²), M_max = m V²/(2 ω_s (R1 + √(R1² + X²))); simplified, a = 0.
    """
    impedance = math.hypot(R1, X)
    return Kloss(synchronous, phases * voltage**2 / (2 * synchronous * (R1 + impedance)), R2 / impedance)


# ---------------------------------------------------------------- closed integrals of the simplified Kloss


def kloss_time(inertia: float, of: Kloss, start: float, end: float) -> float:
    """Time from slip `start` to slip `end` of an unloaded rotor, s: ∫ J dω/M = J ω_s/(2 M_max)
    [(s1² − s2²)/(2 s_m) + s_m ln(s1/s2)]. Plugging runs from s = 2 to 1. (Dubey, § 6.7)"""
    m = of.critical
    shape = (start**2 - end**2) / (2 * m) + m * math.log(start / end)
    return inertia * of.synchronous / (2 * of.greatest) * shape


def quickest_slip(start: float, end: float) -> float:
    """The critical slip for which `kloss_time` is least: √((s1² − s2²)/(2 ln(s1/s2)))."""
    return math.sqrt((start**2 - end**2) / (2 * math.log(start / end)))


def winding_loss(inertia: float, synchronous: float, start: float, end: float, stator: float = 0.0) -> float:
    """Heat in the windings of an unloaded induction motor between two slips, J: J ω_s² (s1² − s2²)/2 in the rotor, and
    `stator` = R1/R2 times that in the stator."""
    return inertia * synchronous**2 * (start**2 - end**2) / 2 * (1 + stator)


# ---------------------------------------------------------------- with the inductance of the armature


def armature(
    voltage: float, resistance: float, inductance: float, constant: float, inertia: float, load: float
) -> tuple[tuple[complex, complex], float]:
    """Of a separately excited motor whose current lags, L di/dt + R i + kΦ ω = V, J dω/dt = kΦ i − M: both poles,
    1/s, and the speed towards which it tends, rad/s, (kΦ V − R M)/(kΦ)². A reversed supply is a negative V. (Dubey,
    § 5.10)"""
    half = resistance / (2 * inductance)
    root = complex(half**2 - constant**2 / (inertia * inductance)) ** 0.5
    return (-half + root, -half - root), (constant * voltage - resistance * load) / constant**2


def armature_speed(t: Array, start: float, poles: tuple[complex, complex], end: float, rise: float) -> Array:
    """ω(t) of it, rad/s: from `start` with dω/dt = `rise`, which the current then has; the poles differ."""
    one, other = poles
    away = start - end
    first = (rise - other * away) / (one - other)
    return np.real(end + first * np.exp(one * t) + (away - first) * np.exp(other * t))
