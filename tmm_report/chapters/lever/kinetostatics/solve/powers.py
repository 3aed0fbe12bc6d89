"""Powers of the loads of a mechanism."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import Loading
from tmm_report.chapters.lever.kinetostatics.ties import together
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.motion import Motion

Array = Any


def lever_terms(given: Loads, motion: Motion, load: Loading) -> Array:
    """Zhukovsky's lever: powers of all loads, inertia among them, one row a load, W.

    The velocity plan turned by 90° is a lever; the moment of a force about its pole is the force's power.
    """
    mechanism = motion.linkage.mechanism
    turned_plan = {point: 1j * motion.velocity(point) for point in motion.point_index}
    rows = []
    for link, vector in load.inertia.items():
        rows.append(-cross(turned_plan[str(mechanism.links[link].mass_centre)], vector + load.gravity[link]))
    rows += [-cross(turned_plan[f.at], vector) for f, vector in zip(given.forces, load.forces, strict=True)]
    rows += [couple * motion.angular_velocity(link) for link, couple in load.couples.items()]
    rows += [c * motion.angular_velocity(m.on) for m, c in zip(given.moments, load.moments, strict=True)]
    return np.array(rows) if rows else np.zeros((1, *motion.shape))


def powers_of(given: Loads, motion: Motion, load: Loading) -> list[Array]:
    """Power of every stated force, every spring and damper with both its ends, every stated moment, W, (..., P)."""
    single = [
        dot(vector, motion.velocity(one.at)) for one, vector in zip(given.forces, load.forces, strict=True)
    ]
    whole: list[Array] = [sum(single[k] for k in own) for own in together(given.forces)]
    turning = zip(given.moments, load.moments, strict=True)
    return [*whole, *(couple * motion.angular_velocity(one.on) for one, couple in turning)]


def external_power(given: Loads, motion: Motion, load: Loading) -> Array:
    """Power of gravity and of the stated forces and moments, W; no inertia."""
    mechanism = motion.linkage.mechanism
    power = np.zeros(motion.shape)
    for link, weight in load.gravity.items():
        power = power + dot(weight, motion.velocity(str(mechanism.links[link].mass_centre)))
    for stated, vector in zip(given.forces, load.forces, strict=True):
        power = power + dot(vector, motion.velocity(stated.at))
    for on, couple in zip(given.moments, load.moments, strict=True):
        power = power + couple * motion.angular_velocity(on.on)
    return power
