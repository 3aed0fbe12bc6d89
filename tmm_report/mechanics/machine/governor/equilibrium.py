"""Centrifugal governors: how the balls move with the sleeve, and at which speed they are in equilibrium.

By virtual work on the sleeve, whatever the mechanism: the centrifugal forces of the balls lift it with A ω², their
weight, that of the sleeve and the spring hold it down with the supporting force E; in equilibrium E = A ω², where
A = n m r r', E = n m g h' + M g + F(z), and r', h' are the derivatives of radius and height of a ball by the lift z.
(Vyshnegradsky 1876; Krutov, Automatic control of internal combustion engines, ch. 3; Rattan, Theory of machines, ch.
16)"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any
GRAVITY = 9.81  # m/s²


@dataclass(frozen=True, eq=False)
class Balls:
    """How a ball moves, each (P,): lift of the sleeve `z`, radius `r`, m; derivatives by z of the radius (`dr`,
    `ddr`) and of the height (`dh`, `ddh`); `tilt`: angles that the formulas name, rad."""

    z: Array
    r: Array
    dr: Array
    ddr: Array
    dh: Array
    ddh: Array
    tilt: dict[str, Array]


# --- mechanisms with two arms: Watt, Porter, Proell


@dataclass(frozen=True)
class Arms:
    """An upper arm from a pivot at the distance `upper_offset` from the axis and a lower arm to the sleeve, at
    `lower_offset`, m; a pivot across the axis has a negative offset.

    The ball is on the pin of both arms, or `distance` from the pivot on the upper arm, or at the end of an
    `extension` of the lower arm beyond the pin, which is upright where the pin is at the radius `upright_at`."""

    upper: float
    lower: float
    upper_offset: float = 0.0
    lower_offset: float = 0.0
    distance: float | None = None
    extension: float | None = None
    upright_at: float = 0.0

    def height(self, x: Array) -> Array:
        """Of the upper pivots over those of the sleeve, m, with the pin at the radius x; nan where the arms do not
        reach."""
        with np.errstate(invalid="ignore"):
            above = np.sqrt(self.upper**2 - (x - self.upper_offset) ** 2)
            return above + np.sqrt(self.lower**2 - (x - self.lower_offset) ** 2)

    def pin(self, height: Array) -> Array:
        """Radius of the pin, m: the outer of the two points at the ends of both arms (cosine rule)."""
        reach = (self.lower_offset - self.upper_offset) - 1j * np.asarray(height, dtype=float)
        d = np.abs(reach)
        with np.errstate(invalid="ignore", divide="ignore"):
            along = (self.upper**2 - self.lower**2 + d**2) / (2 * d)
            across = np.sqrt(self.upper**2 - along**2)
        return self.upper_offset + np.real(reach / d * (along + 1j * across))

    @staticmethod
    def pin_slope(tilt: dict[str, Array]) -> Array:
        """Derivative of the radius of the pin by the lift: both arms keep their length."""
        with np.errstate(divide="ignore"):
            return 1 / (np.tan(tilt["alpha"]) + np.tan(tilt["beta"]))

    def moves(self, z: Array, lowest: float) -> Balls:
        """At lifts z (P,) from the position with the pin at the radius `lowest`, m."""
        z = np.asarray(z, dtype=float)
        x = self.pin(self.height(lowest) - z)
        alpha = np.arcsin((x - self.upper_offset) / self.upper)
        beta = np.arcsin((x - self.lower_offset) / self.lower)
        tilt = {"alpha": alpha, "beta": beta}
        dx = self.pin_slope(tilt)
        da, db = dx / (self.upper * np.cos(alpha)), dx / (self.lower * np.cos(beta))
        ddx = -(dx**2) * (da / np.cos(alpha) ** 2 + db / np.cos(beta) ** 2)
        dda = ddx / (self.upper * np.cos(alpha)) + da**2 * np.tan(alpha)
        ddb = ddx / (self.lower * np.cos(beta)) + db**2 * np.tan(beta)
        if self.distance is not None:
            return _swung(z, self.upper_offset, self.distance, alpha, da, dda, tilt)
        pin = _swung(z, self.upper_offset, self.upper, alpha, da, dda, tilt)
        if self.extension is None:
            return pin
        gamma = beta - np.arcsin((self.upright_at - self.lower_offset) / self.lower)
        s, sin, cos = self.extension, np.sin(gamma), np.cos(gamma)
        return Balls(
            z,
            pin.r + s * sin,
            pin.dr + s * cos * db,
            pin.ddr + s * (cos * ddb - sin * db**2),
            pin.dh - s * sin * db,
            pin.ddh - s * (sin * ddb + cos * db**2),
            {**tilt, "gamma": gamma},
        )


def _swung(
    z: Array, offset: float, length: float, angle: Array, first: Array, second: Array, tilt: dict[str, Array]
) -> Balls:
    """A point at `length` along an arm that hangs from a fixed pivot, by the angle from the vertical and its
    derivatives."""
    sin, cos = np.sin(angle), np.cos(angle)
    return Balls(
        z,
        offset + length * sin,
        length * cos * first,
        length * (cos * second - sin * first**2),
        length * sin * first,
        length * (sin * second + cos * first**2),
        tilt,
    )


# --- the bell crank: Hartnell


@dataclass(frozen=True)
class BellCrank:
    """A right-angled lever: the ball on its upright arm `ball_arm`, the sleeve on its level arm `sleeve_arm`; the
    fulcrum is at the radius `fulcrum`, at which the ball arm stands upright, m.

    `level`: the obliquity of the arms and with it the weight of the balls is neglected, as books often do; the
    `fulcrum` is of no matter then, and may be None."""

    ball_arm: float
    sleeve_arm: float
    fulcrum: float | None
    level: bool = False

    def lift(self, lowest: float, r: Array) -> Array:
        """Of the sleeve, m, from the ball's radius `lowest` to r: both ends go in proportion, as the arms are at right
        angles."""
        return (r - lowest) * self.sleeve_arm / self.ball_arm

    def moves(self, z: Array, lowest: float) -> Balls:
        """At lifts z (P,) from the position with the ball at the radius `lowest`, m."""
        z = np.asarray(z, dtype=float)
        ratio = self.ball_arm / self.sleeve_arm
        r = lowest + ratio * z
        nought, ones = np.zeros_like(z), np.ones_like(z)
        if self.level:
            return Balls(z, r, ratio * ones, nought, nought, nought, {"theta": nought})
        assert self.fulcrum is not None  # not level
        theta = np.arcsin((r - self.fulcrum) / self.ball_arm)
        turn = 1 / (self.sleeve_arm * np.cos(theta))
        dh, ddh = -ratio * np.tan(theta), -ratio * turn / np.cos(theta) ** 2
        return Balls(z, r, ratio * ones, nought, dh, ddh, {"theta": theta})


Geometry = Arms | BellCrank


# --- forces on the sleeve


@dataclass(frozen=True)
class Weights:
    """What holds the sleeve down: `count` balls of the mass `ball`, the sleeve's mass, a spring with the stiffness
    and its force at the lowest position, kg, N/m, N."""

    ball: float
    sleeve: float = 0.0
    stiffness: float = 0.0
    preload: float = 0.0
    count: int = 2
    gravity: float = GRAVITY


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """At each lift (P,): `A` kg m, `E` N with their derivatives by z; `omega` of the governor's shaft, rad/s; `S`: the
    factor of stability dE/dz − ω² dA/dz, N/m, positive where the speed grows with the lift."""

    balls: Balls
    weights: Weights
    A: Array
    E: Array
    dA: Array
    dE: Array

    @property
    def omega(self) -> Array:
        """nan where nothing balances the sleeve."""
        with np.errstate(invalid="ignore"):
            return np.sqrt(self.E / self.A)

    @property
    def S(self) -> Array:
        return self.dE - self.E / self.A * self.dA

    @property
    def slope(self) -> Array:
        """dω/dz, rad/(s m)."""
        return self.S / (2 * self.A * self.omega)

    @property
    def force(self) -> Array:
        """Controlling force C = m ω² r of one ball, N."""
        return self.weights.ball * self.E / self.A * self.balls.r

    @property
    def mass(self) -> Array:
        """Of all that moves with the sleeve, reduced to it, kg: M + n m (r'² + h'²)."""
        balls = self.balls
        return self.weights.sleeve + self.weights.count * self.weights.ball * (balls.dr**2 + balls.dh**2)

    def band(self, friction: float) -> tuple[Array, Array]:
        """Speeds at which the sleeve begins to sink and to rise against a force of friction on it, rad/s."""
        with np.errstate(invalid="ignore"):
            return np.sqrt((self.E - friction) / self.A), np.sqrt((self.E + friction) / self.A)

    def insensitivity(self, friction: float) -> Array:
        """ε = (ω₊ − ω₋)/ω: the part of its speed within which the governor does not move, nearly F/E."""
        down, up = self.band(friction)
        return (up - down) / self.omega


def equilibrium(balls: Balls, weights: Weights) -> Equilibrium:
    """E = A ω² at each place of the sleeve."""
    heavy = weights.count * weights.ball
    return Equilibrium(
        balls,
        weights,
        heavy * balls.r * balls.dr,
        heavy * weights.gravity * balls.dh
        + weights.sleeve * weights.gravity
        + weights.preload
        + weights.stiffness * balls.z,
        heavy * (balls.dr**2 + balls.r * balls.ddr),
        heavy * weights.gravity * balls.ddh + weights.stiffness + 0 * balls.z,
    )


# --- choice of what is not stated


def spring_force(balls: Balls, weights: Weights, omega: Array) -> Array:
    """What the spring must press at each place so that it is in equilibrium at the speed, N (P,)."""
    held = equilibrium(balls, Weights(weights.ball, weights.sleeve, 0.0, 0.0, weights.count, weights.gravity))
    return held.A * np.asarray(omega) ** 2 - held.E


def ball_mass(balls: Balls, weights: Weights, omega: float) -> Array:
    """Mass of a ball so that it is in equilibrium at the speed, kg (P,); the mass in `weights` is passed over."""
    rest = weights.sleeve * weights.gravity + weights.preload + weights.stiffness * balls.z
    return rest / (weights.count * (balls.r * balls.dr * omega**2 - weights.gravity * balls.dh))


def sleeve_mass(balls: Balls, weights: Weights, omega: float) -> Array:
    """Mass of the sleeve so that it is in equilibrium at the speed, kg (P,)."""
    bare = Weights(weights.ball, 0.0, weights.stiffness, weights.preload, weights.count, weights.gravity)
    found = equilibrium(balls, bare)
    return (found.A * omega**2 - found.E) / weights.gravity


# --- figures of merit


def nonuniformity(lowest: float, highest: float) -> float:
    """δ = 2 (ω_max − ω_min)/(ω_max + ω_min)."""
    return 2 * (highest - lowest) / (highest + lowest)


def effort(E: Array, change: float) -> Array:
    """Mean force on the sleeve, N, while it yields to a sudden relative change of the speed: half of what would hold
    it."""
    return E * ((1 + change) ** 2 - 1) / 2


def friction_for(E: Array, insensitivity: float) -> Array:
    """Friction on the sleeve, N, that costs this insensitiveness: √(1 + F/E) − √(1 − F/E) = ε solved for F."""
    return E * insensitivity * np.sqrt(1 - insensitivity**2 / 4)


# --- a straight line of the controlling force


def line_through(r: tuple[float, float], force: tuple[float, float]) -> tuple[float, float]:
    """(a, b) of C = a r + b through two points. The governor is stable where b < 0, flat where b = 0."""
    a = (force[1] - force[0]) / (r[1] - r[0])
    return a, force[0] - a * r[0]


def speed_on_ray(force: Array, mass: float, r: Array) -> Array:
    """ω of the ray from the origin through (r, C): C = m ω² r, rad/s."""
    return np.sqrt(force / (mass * r))
