"""How hard a cam presses its follower: its reaction along the common normal at the contact, over the cycle.

A cam can push and not pull. Where the reaction found is below zero the follower would leave the cam, and a closure has
to hold it: a spring (closure by force) or a groove and a second face (by shape).
Source: Artobolevsky, Theory of mechanisms and machines, ch. 26; Frolov (ed.), Theory of mechanisms, ch. 15.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.cams.cam import Cam
from tmm_report.mechanics.lever.cycle import Extreme, least_and_greatest
from tmm_report.mechanics.lever.extremes import integral, peaks
from tmm_report.mechanics.lever.forces.reactions import Statics
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics

Array = Any
NOTHING = 1e-9  # of the largest: a reaction that is rounding


@dataclass(frozen=True, eq=False)
class Pressing:
    """Reaction of one cam on its follower along the normal, N, above zero where the cam presses: at the `table` and the
    `diagram` positions, (P,); its `least` and `greatest` over the cycle. `zones`: from and to which angles turned it is
    below zero, rad; none where only the diagram positions have forces."""

    cam: Cam
    table: Array
    diagram: Array
    least: Extreme
    greatest: Extreme
    zones: tuple[tuple[float, float], ...]

    @property
    def parts(self) -> bool:
        """Whether the follower would leave the cam somewhere."""
        return self.least.value < -self._nothing

    @property
    def closure(self) -> float:
        """The greatest force along the normal with which a closure has to hold the follower, N."""
        return -self.least.value if self.parts else 0.0

    @property
    def parting(self) -> list[int]:
        """Table positions in which the follower would leave the cam; the last that is the first is left out."""
        return [int(k) for k in np.flatnonzero(self.table[:-1] < -self._nothing)]

    @property
    def _nothing(self) -> float:
        return NOTHING * max(abs(self.least.value), abs(self.greatest.value))


def pressings(found: Kinetostatics) -> tuple[Pressing, ...]:
    """One a cam pair, none of a mechanism without them."""
    return tuple(_pressing(cam, found) for cam in found.kinematics.linkage.mechanism.cams)


def _pressing(cam: Cam, found: Kinetostatics) -> Pressing:
    table, diagram = (_along_normal(cam, one.motion, one.statics) for one in (found.table, found.diagram))
    over = found.over
    if over is None:
        ends = least_and_greatest(diagram, found.diagram.turned)
        return Pressing(cam, table, diagram, *ends, ())
    values = over.on(_along_normal(cam, over.motion, over.statics))
    least, greatest = peaks(over.panels, values[None], over.closed)[0]
    return Pressing(cam, table, diagram, least, greatest, _below(over.panels, values))


def _along_normal(cam: Cam, motion: Motion, found: Statics) -> Array:
    """Projection of the cam's reaction on its follower on the normal from the cam to the follower, (P,)."""
    pair = found.reactions[f"{cam.follower}-{cam.name}"]
    phi = np.broadcast_to(motion.phi, motion.shape)
    return dot(-pair.force, cam.contact(phi).normal)


def _below(panels: Panels, values: Array) -> tuple[tuple[float, float], ...]:
    """Between which places a function of the panels is below zero by more than rounding."""
    marks = distinct(np.concatenate([[0.0], panels.roots(values), [panels.period]]))
    done = integral(panels, values, marks[1:]) - integral(panels, values, marks[:-1])
    least = NOTHING * np.abs(values).max() * np.diff(marks)
    rows = zip(marks[:-1], marks[1:], done < -least, strict=True)
    return tuple((float(a), float(b)) for a, b, below in rows if below)
