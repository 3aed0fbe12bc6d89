"""Against the moment by which a mechanism shakes its foundation: wheels geared to the links, weights in antiphase.

The moment is −dL/dt of the angular momentum L about the point. A wheel of moment of inertia J on an axis of the frame,
geared to a link so that it turns at i times its angular velocity, adds −J i ε: nothing where the link turns evenly. Two
equal weights that turn alike, half a turn apart, on axes a distance apart, give a moment and no force. Arrays (..., P),
SI. Sources: Berkof, Complete force and moment balancing of inline four-bar linkages, Mech. Mach. Theory 8 (1973);
Lanchester's pairs are in `counterweights`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

Array = Any
EVEN = 1e-9  # of ω²: an angular acceleration that is rounding


@dataclass(frozen=True)
class Wheel:
    """A wheel geared to a link: `ratio` of its angular velocity to the link's, negative where it turns against it, 1
    where it is fixed to the link; moment of inertia, kg m²."""

    link: str
    ratio: float
    inertia: float


@dataclass(frozen=True)
class Couple:
    """Two weights in antiphase that turn `order` times a turn of the driving link, in its sense, on axes side by side
    along x, `distance` apart. `amplitude` of their moment, N m; `moment`: m r of each, kg m; `angle`, rad: of the one
    with the greater x from the x axis at position 0."""

    order: int
    amplitude: float
    moment: float
    angle: float
    radius: float
    distance: float

    @property
    def mass(self) -> float:
        """Of each of both weights, kg."""
        return self.moment / self.radius


# ---------------------------------------------------------------- wheels


def uneven(motion: Motion, links: Iterable[str]) -> list[str]:
    """Those of the links that turn unevenly."""
    least = EVEN * float(np.max(np.square(motion.omega)))
    return [link for link in links if np.abs(motion.angular_acceleration(link)).max() > least]


def geared(motion: Motion, wheels: Iterable[Wheel]) -> Array:
    """What wheels add to the shaking moment, N m."""
    total = np.zeros(motion.shape)
    for wheel in wheels:
        total = total - wheel.inertia * wheel.ratio * motion.angular_acceleration(wheel.link)
    return total


def least_square(motion: Motion, ratios: Mapping[str, float], moment: Array) -> list[Wheel]:
    """Wheels geared to links at these ratios, with the moments of inertia, none negative, that leave the least mean
    square of the moment (P,)."""
    columns = [geared(motion, [Wheel(link, ratio, 1.0)]) for link, ratio in ratios.items()]
    if not columns:
        return []
    found = not_negative(np.array(columns).T, -np.asarray(moment))
    return [Wheel(link, ratio, float(J)) for (link, ratio), J in zip(ratios.items(), found, strict=True)]


def not_negative(columns: Array, wanted: Array) -> Array:
    """x ≥ 0 with the least |columns x − wanted|, columns (P, N) (Lawson, Hanson, Solving least squares problems)."""
    sizes = np.linalg.norm(columns, axis=0)
    A, x = columns / sizes, np.zeros(len(sizes))
    used = np.zeros(len(sizes), dtype=bool)
    for _ in range(3 * len(sizes)):
        slope = np.where(used, -np.inf, A.T @ (wanted - A @ x))
        enters = int(np.argmax(slope))
        if slope[enters] <= 1e-10 * np.linalg.norm(wanted):
            break
        used[enters] = True
        while True:
            free = np.zeros(len(sizes))
            free[used] = np.linalg.lstsq(A[:, used], wanted, rcond=1e-10)[0]
            if free[used].min() > 0:
                x = free
                break
            leaves = used & (free <= 0)
            step = np.min(x[leaves] / (x[leaves] - free[leaves]))
            x = x + step * (free - x)
            used &= x > 1e-14 * x.max(initial=0.0)
            x[~used] = 0.0
            if not used.any():
                break
    return x / sizes


# ---------------------------------------------------------------- weights in antiphase


def couple(harmonic: complex, order: int, sense: int, omega: float, radius: float, distance: float) -> Couple:
    """Against the harmonic M_k = Re(c e^{ikφ}) of the moment, φ turned by the driving link, whose sense is + or −.

    At the angle ψ from the axes' line both weights give m r (kω)² d sin ψ: with ψ = ±kφ + β this is the harmonic with
    the other sign.
    """
    size = abs(harmonic)
    angle = sense * float(np.angle(harmonic)) - np.pi / 2 if size else 0.0
    product = size / ((order * omega) ** 2 * distance)
    return Couple(order, size, product, float(np.angle(np.exp(1j * angle))), radius, distance)


def moment_of(couples: Iterable[Couple], turned: Array, omega: float) -> Array:
    """Moment of pairs of weights in antiphase, N m, at angles turned by the driving link, counter-clockwise."""
    total = np.zeros(np.shape(turned))
    for one in couples:
        size = one.moment * (one.order * omega) ** 2 * one.distance
        total = total + size * np.sin(one.angle + one.order * turned)
    return total
