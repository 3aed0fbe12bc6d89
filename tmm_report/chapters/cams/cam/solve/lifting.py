"""The follower over the turn of its cam, and the extremes of what it does, exact between the ends of the law's phases.

The displacement S (m of one that slides, rad of one that swings) and its derivatives are by the angle turned in the
sense of rotation; the pressure angle is above zero where the normal leans as in a rise.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.cams.cam.solve.turn import BEFORE, Turn
from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.cams.cam import ByLaw, Cam, Sliding
from tmm_report.mechanics.cams.extremes import greatest
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.records import dataclass

Array = Any
FINE = 1441  # angles of a turn among which extremes are first looked for
BESIDE = 2e-4  # rad: so little before a break the curve of the piece that ends there stands, 0.01 mm on paper


@dataclass(frozen=True, eq=False)
class Lifted:
    """The follower at angles turned, (P,): displacement and its derivatives by the angle, m or rad; pressure angle and
    polar angles, rad; radii, m. `radius`, `direction`: of the profile's point of contact in the cam's axes; `pitch`,
    `pitch_direction`: of the roller's centre; `curvature`: radius of curvature of the profile."""

    turned: Array
    S: Array
    first: Array
    second: Array
    alpha: Array
    radius: Array
    direction: Array
    pitch: Array
    pitch_direction: Array
    curvature: Array


def side_of(cam: Cam) -> int:
    """+1 where the follower's coordinate grows with its displacement."""
    return 1 if isinstance(cam.motion, Sliding) else cam.motion.side


def lowest(cam: Cam, turn: Turn) -> float:
    """The coordinate from which displacements count, times its sense."""
    side = side_of(cam)
    if isinstance(cam.given, ByLaw):
        return side * cam.given.low
    (found,) = greatest(lambda x: -side * cam.moved(turn.phi(x))[0].z[None], np.linspace(0, FULL_TURN, FINE))
    return -found.value


def lifted(cam: Cam, turn: Turn, turned: Array, low: float) -> Lifted:
    """The follower and the contact at angles turned from position 0, rad. `low`: see `lowest`."""
    sense, side = turn.sense, side_of(cam)
    phi = turn.phi(turned)
    q, b = cam.moved(phi)
    touch = cam.touched(q, b)
    profile, pitch = touch.at * np.exp(-1j * phi), b.z * np.exp(-1j * phi)
    return Lifted(
        turned,
        side * q.z - low,
        side * sense * q.d,
        side * q.dd,
        sense * cam.pressure_at(b, touch),
        np.abs(profile),
        np.mod(np.angle(profile), FULL_TURN),
        np.abs(pitch),
        np.mod(np.angle(pitch), FULL_TURN),
        cam.radius_at(touch),
    )


def searched(turn: Turn) -> Array:
    """Angles turned among which extremes are looked for, rad, ascending: the breaks among them, so that no piece
    of the law is searched together with another."""
    even = np.linspace(0.0, turn.sweep, FINE)
    return distinct(np.concatenate([even, turn.breaks]))


def drawn_at(turn: Turn) -> Array:
    """Angles turned at which curves are drawn, rad, ascending: the diagram positions, every 2.5° at least, and both
    sides of every break, so that a jump stands upright."""
    last = float(turn.diagram[-1])
    count = 1 + round(last / np.radians(2.5))
    beside = np.concatenate([turn.breaks, turn.breaks - BESIDE])
    turns = np.arange(1 + round(last / FULL_TURN)) * FULL_TURN
    every = (beside[:, None] + turns).ravel()
    every = every[(every >= 0) & (every <= last)]
    turned = np.sort(np.concatenate([turn.diagram, np.linspace(0.0, last, count), every]))
    return turned[np.diff(turned, prepend=-1.0) > BEFORE]
