"""A machine of shafts, gears and masses reduced to one shaft; numbers or arrays, SI.

Kinetic energy: J_r = Σ J i² + Σ m (v/ω)²; power: M_r = Σ M i/η + Σ F v/(ω η). Losses are those of power that goes
from the main shaft to the part; where a part drives (a weight that is lowered) the power comes back and M_r = M i η.
(Artobolevsky, ch. 15; Klyuchev, § 2.2)
"""

from __future__ import annotations

from typing import Any

import numpy as np

Array = Any


def inertia(ratio: Array, J: Array, efficiency: Array = 1.0) -> Array:
    """Of a shaft that turns `ratio` times as fast as the main one. `efficiency`: 1 by kinetic energy; that of the
    gears where what accelerates the shaft must pass them: J i²/η."""
    return J * ratio**2 / efficiency


def travelling(mass: Array, arm: Array, efficiency: Array = 1.0) -> Array:
    """Of a mass that moves with v = arm · ω."""
    return mass * arm**2 / efficiency


def moment(ratio: Array, M: Array, efficiency: Array = 1.0) -> Array:
    """A resisting moment on such a shaft, on the main one; a driving one is below zero."""
    return M * ratio * side(M, efficiency)


def side(M: Array, efficiency: Array) -> Array:
    """The factor of the losses, by the way that the power goes: 1/η to the part, η from it."""
    return np.where(np.asarray(M) < 0, efficiency, 1 / np.asarray(efficiency))


def best_ratio(
    motor_inertia: float, load_inertia: float, motor: float, load: float, efficiency: float
) -> float:
    """The reduction ratio G by which the load's shaft gets the greatest acceleration from a constant moment:
    G = c + √(c² + J_load/(η J_motor)), c = M_load/(η M_motor). (Zero of dε/dG, ε = (Gη M − M_l)/(J_l + G² η J))"""
    c = load / (efficiency * motor)
    return c + float(np.sqrt(c * c + load_inertia / (efficiency * motor_inertia)))


def geared_acceleration(
    ratio: float,
    motor_inertia: float,
    load_inertia: float,
    motor: float,
    load: float,
    efficiency: float = 1.0,
) -> float:
    """Of the load's shaft, rad/s²: (G η M − M_l)/(J_l + G² η J)."""
    return (ratio * efficiency * motor - load) / (load_inertia + ratio**2 * efficiency * motor_inertia)


def crank_arm(angle: Array, crank: float, rod: float, exact: bool = True) -> Array:
    """Reduced moment of a slider-crank by the force on its piston, m: v/ω. `angle` from the inner dead point;
    not `exact`: r (sin φ + λ sin 2φ/2), λ = r/l."""
    lam = crank / rod
    s, c = np.sin(angle), np.cos(angle)
    return crank * s * (1 + lam * c / (np.sqrt(1 - (lam * s) ** 2) if exact else 1.0))


def carried(rate: float, length: float, velocity: float) -> float:
    """Mass on a belt, kg: what is loaded in the time that it stays there."""
    return rate * length / velocity
