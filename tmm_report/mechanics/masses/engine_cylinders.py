"""Inertia forces of an engine of several cylinders: orders, direct and reverse cranks, what they leave.

The plane across the crankshaft is the complex plane, y up. Cylinder i has its axis at the angle β_i from the upward
vertical, its crank at the angle φ + ψ_i from there, its plane at z_i along the shaft; all angles counter-clockwise.
The reciprocating mass m pushes along its axis with m r ω² Σ c_k cos k(φ + ψ_i − β_i), and each cosine is half the sum
of a vector that turns at k ω and of one that turns at −k ω: the direct and the reverse crank of order k.
(Bevan, The theory of machines, ch. 14; Artobolevsky, ch. 13)
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

Array = Any
CLEAR = 1e-12  # of the sizes summed up: less is rounding
SAMPLES = 256  # angles of a turn, for the coefficients: the aliased ones are below rounding up to λ = 0.9


class Turning(NamedTuple):
    """A vector forward·e^{ikφ} + backward·e^{−ikφ}: an ellipse run through k times a turn."""

    forward: Array
    backward: Array

    @property
    def greatest(self) -> Array:
        return np.abs(self.forward) + np.abs(self.backward)

    @property
    def least(self) -> Array:
        return np.abs(np.abs(self.forward) - np.abs(self.backward))

    @property
    def direction(self) -> Array:
        """Angle of the long axis of the ellipse from x, rad, 0 … π; nan of a circle and of nothing."""
        turned = np.mod((np.angle(self.forward) + np.angle(self.backward)) / 2, np.pi)
        return np.where(self.greatest - self.least > CLEAR * self.greatest, turned, np.nan)

    def along(self, direction: Array) -> Array:
        """Amplitude of the component along a unit vector."""
        return np.abs(self.forward * np.conj(direction) + np.conj(self.backward) * direction)

    def at(self, order: int, phi: Array) -> Array:
        """The vector at the angles φ, rad."""
        return self.forward * np.exp(1j * order * phi) + self.backward * np.exp(-1j * order * phi)


def acceleration(theta: Array, lam: float) -> Array:
    """Of the piston towards the crankshaft by r ω², exact: cos θ + λ (cos 2θ + λ² sin⁴θ)/(1 − λ² sin²θ)^{3/2}.

    `theta`: of the crank from the cylinder's axis, rad; `lam` = r/l < 1.
    """
    sine = np.sin(theta) ** 2
    return np.cos(theta) + lam * (np.cos(2 * theta) + lam**2 * sine**2) / (1 - lam**2 * sine) ** 1.5


def coefficients(lam: float, orders: Sequence[int]) -> Array:
    """The exact c_k of cos kθ in `acceleration`: of order 1 it is 1, of the other odd ones 0, of order 2 about λ."""
    theta = 2 * np.pi * np.arange(SAMPLES) / SAMPLES
    values = acceleration(theta, lam)
    return np.array([2 * np.mean(values * np.cos(k * theta)) for k in orders])


def cranks(order: int, banks: Array, angles: Array) -> tuple[Array, Array]:
    """Angles of the direct and of the reverse cranks of an order from the upward vertical at φ = 0, rad."""
    return order * angles - (order - 1) * banks, -order * angles + (order + 1) * banks


def turning(order: int, banks: Array, angles: Array, weights: Array) -> Turning:
    """Σ w_i e^{iβ_i} cos k(φ + ψ_i − β_i), turned upright: of the forces with w = 1, of the couples with w = z_i."""
    direct, reverse = (1j * np.exp(1j * turned) / 2 for turned in cranks(order, banks, angles))
    size = np.sum(np.abs(weights))
    return Turning(settled(np.sum(weights * direct), size), settled(np.sum(weights * reverse), size))


def settled(vector: Array, size: float) -> Array:
    """The vector, 0 where it is nothing but the rounding of a sum of this size."""
    return np.where(np.abs(vector) > CLEAR * size, vector, 0.0)[()]


def exact(phi: Array, lam: float, banks: Array, angles: Array, weights: Array) -> Array:
    """The same of the exact motion, by r ω² and kg: the sum over the cylinders at the angles φ (P,), complex (P,)."""
    theta = phi[..., None] + angles - banks
    return np.sum(weights * 1j * np.exp(1j * banks) * acceleration(theta, lam), axis=-1)


def rotating(phi: Array, angles: Array, weights: Array) -> Array:
    """Σ w_i i e^{i(φ + ψ_i)}: of the masses that turn with the cranks, complex (P,)."""
    total = settled(np.sum(weights * np.exp(1j * angles)), np.sum(np.abs(weights)))
    return 1j * np.exp(1j * phi) * total


# --- layouts: bank, crank and place of each cylinder


def inline(crank_angles: Sequence[float], spacing: float, bank: float = 0.0) -> tuple[Array, Array, Array]:
    """One row; places from the middle of the row, m."""
    angles = np.asarray(crank_angles, dtype=float)
    places = spacing * (np.arange(len(angles)) - (len(angles) - 1) / 2)
    return np.full(len(angles), bank), angles, places


def vee(
    between: float, crank_angles: Sequence[float], spacing: float, offset: float = 0.0
) -> tuple[Array, Array, Array]:
    """Two rows at ± half the angle `between`, two cylinders on each crankpin, `offset` apart along the shaft."""
    _, angles, places = inline(crank_angles, spacing)
    sides = np.tile([1.0, -1.0], len(angles))
    return sides * between / 2, np.repeat(angles, 2), np.repeat(places, 2) - sides * offset / 2


def opposed(crank_angles: Sequence[float], spacing: float) -> tuple[Array, Array, Array]:
    """Lying cylinders to the left and to the right by turns, each with a crankpin of its own."""
    _, angles, places = inline(crank_angles, spacing)
    return np.where(np.arange(len(angles)) % 2 == 0, np.pi / 2, -np.pi / 2), angles, places


def radial(count: int, bank: float = 0.0) -> tuple[Array, Array, Array]:
    """A star about one crankpin; the first axis at `bank`."""
    return bank + 2 * np.pi * np.arange(count) / count, np.zeros(count), np.zeros(count)


# --- counterweights


def counterweight(reciprocating: float, rotating: float, share: float, radius: float, at: float) -> float:
    """Mass, kg, at the radius `at` opposite a crank of the radius `radius`, m, for all of the rotating mass and a
    `share` of the reciprocating one."""
    return (rotating + share * reciprocating) * radius / at


class Locomotive(NamedTuple):
    """What a two-cylinder locomotive is left with, amplitudes: N, N m, N."""

    traction: float
    swaying: float
    hammer: float


def locomotive(reciprocating: float, radius: float, omega: float, share: float, between: float) -> Locomotive:
    """Uncoupled, cranks at right angles, `between` the cylinders, m; a `share` of each reciprocating mass balanced on
    the wheels: along the rails (1 − c) m r ω² √2, swaying (1 − c) m r ω² a/√2, hammer blow of a wheel c m r ω².

    The hammer blow is of weights in the planes of the cylinders. (Bevan, ch. 14; Khurmi, ch. 22)
    """
    pull = reciprocating * radius * omega**2
    left = (1 - share) * pull
    return Locomotive(left * np.sqrt(2), left * between / np.sqrt(2), share * pull)
