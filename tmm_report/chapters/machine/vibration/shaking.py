"""The mechanism's own shaking force along a direction, and the steady motion of the machine under all its harmonics."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.masses import vibration as vib
from tmm_report.mechanics.masses.vibration import Body
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

Array = Any
COUNT = 720  # angles over a turn: its last harmonics are rounding
SHOWN = 8  # harmonics at most in the table
LEAST = 0.05  # of the largest harmonic: the first one above it is followed in full
NOTHING = 1e-9  # of the sum of the links' inertia forces: a resultant below it is rounding
PATH = ("vibration", "mechanism")


@dataclass(frozen=True, eq=False)
class Shaking:
    """`turned`: angles from position 0 and the end of the turn, rad, (N+1,); `force` along the direction there, N;
    `sizes`, `phases`: of the harmonics 1 … K, (K,); `moved`, `handed`: the machine's steady motion, m, and the force on
    its base; `omega`: rad/s, without sign."""

    omega: float
    turned: Array
    force: Array
    sizes: Array
    phases: Array
    moved: Array | None = None
    handed: Array | None = None

    @property
    def leading(self) -> int:
        """The lowest harmonic that counts."""
        return int(np.flatnonzero(self.sizes >= LEAST * self.sizes.max())[0]) + 1

    @property
    def orders(self) -> Array:
        return np.arange(1, len(self.sizes) + 1)

    @property
    def spectrum(self) -> Array:
        """Of all its harmonics, from 0; those of rounding are nothing."""
        return vib.spectrum(self.force[:-1])

    def on(self, body: Body) -> Shaking:
        """With the motion of a machine on its isolators."""
        moved, handed = vib.periodic(body, self.omega, self.force[:-1])
        return replace(self, moved=np.append(moved, moved[0]), handed=np.append(handed, handed[0]))


def shaking(moving: Moving, direction: complex) -> Shaking:
    """−Σ m a_S along the direction over a turn. Raises ProblemError where the turn is not whole or nothing shakes."""
    cycle = moving.kinematics.cycle
    turned = np.arange(COUNT) * (cycle.sweep / COUNT)
    motion = cycle.motion(turned)
    if not cycle.closed:
        raise ProblemError(
            [mistake(N_("the driving link makes no full turns: its motion has no harmonics"), PATH)]
        )
    parts = _inertia(motion, direction)
    force = np.sum(parts, axis=0)
    if not np.isfinite(force).all():
        raise ProblemError(
            [mistake(N_("the shaking force is not known at every angle: there are singular positions"), PATH)]
        )
    if not np.abs(force - force.mean()).max() > NOTHING * max(np.abs(parts).max(initial=0.0), 1e-300):
        right = Message(N_("give the links their masses, or take another direction"))
        raise ProblemError(
            [mistake(N_("the mechanism does not shake its frame in this direction"), PATH, right)]
        )
    sizes, phases = vib.harmonics(force, SHOWN)
    return Shaking(
        abs(moving.kinematics.omega), np.append(turned, 2 * np.pi), np.append(force, force[0]), sizes, phases
    )


def _inertia(motion: Motion, direction: complex) -> Array:
    """−m a_S of every link along the direction, (L, N)."""
    links = motion.linkage.mechanism.links
    heavy = [
        link for name, link in links.items() if name != FRAME and link.mass and link.mass_centre is not None
    ]
    rows = [-link.mass * dot(motion.acceleration(str(link.mass_centre)), direction) for link in heavy]
    return np.array(rows).reshape(len(heavy), *motion.shape)
