"""Inertia force of what reciprocates with a slider, and what Lanchester's rotors leave of it."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.masses.slider_harmonics import SliderCrank
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Remaining:
    """Inertia force of what reciprocates along the guide, N, (P,): exact, after the rotors of the first order, and
    after those of both orders."""

    exact: Array
    first: Array
    second: Array


def remaining(crank: SliderCrank, motion: Motion, turned: Array) -> Remaining:
    """−m_B a_B from the solved motion, less the harmonics that the rotors take."""
    exact = -crank.mass * dot(motion.acceleration(crank.joint), crank.along)
    phi, scale = crank.angle(turned), crank.mass * crank.r * motion.omega**2
    cosine, sine = crank.harmonics.cosine, crank.harmonics.sine

    def order(k: int) -> Array:
        return scale * (cosine[k] * np.cos(k * phi) + sine[k] * np.sin(k * phi))

    return Remaining(exact, exact - order(1), exact - order(1) - order(2))
