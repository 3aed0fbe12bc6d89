"""The finished cam: the outer wall of a groove, the path of the cutter, the outline point by point, and the proof of
the profile by reversed motion."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.cams.cam.given import Given
from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.chapters.cams.cam.solve.lifting import side_of
from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.cams.extremes import Extreme
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.mechanics.cams.reversed_motion import recovered, touching
from tmm_report.quantity.text import column
from tmm_report.records import dataclass

Array = Any
OUTLINED = 361  # angles at which the outline is listed: every degree
PROVED = 73  # angles at which the follower is let down on the profile, beside the table positions
BESIDE = np.radians([-1.0, -0.5, -0.2, 0.2, 0.5, 1.0])  # from a hard shock of the law, which cuts the profile
DIGITS = 5  # of the largest coordinate: as the table of the profile is printed


@dataclass(frozen=True, eq=False)
class Curves:
    """Of a cam at angles turned, (P,), in its axes, m: the profile and the pitch curve; `outer`: the other wall of a
    groove; `cut`, `cut_outer`: the path of the cutter's centre along each wall. None of what there is not."""

    turned: Array
    profile: Array
    pitch: Array | None
    outer: Array | None
    cut: Array | None
    cut_outer: Array | None


@dataclass(frozen=True, eq=False)
class Making:
    """`cutter`: its radius, m, where it is stated; `groove`: whether the roller runs between two walls."""

    found: CamFound
    cutter: float | None
    groove: bool

    @property
    def asked(self) -> bool:
        return self.groove or self.cutter is not None

    def curves(self, turned: Array) -> Curves:
        cam = self.found.cam
        phi = self.found.phi(turned)
        back = np.exp(-1j * phi)
        touch = cam.contact(phi)
        profile, normal = touch.at * back, touch.normal * back
        outer = profile + 2 * (cam.roller or 0.0) * normal if self.groove else None
        r = self.cutter
        return Curves(
            turned,
            profile,
            cam.pitch(phi) if cam.roller else None,
            outer,
            None if r is None else profile + r * normal,
            None if r is None or outer is None else outer - r * normal,
        )

    @cached_property
    def table(self) -> Curves:
        """At the table positions."""
        return self.curves(self.found.turn.table)

    @cached_property
    def outline(self) -> Curves:
        return self.curves(np.linspace(0.0, FULL_TURN, OUTLINED))

    # ------------------------------------------------------------ reversed motion

    @cached_property
    def proof(self) -> Extreme:
        """The greatest difference of the displacement found back from the profile, m or rad, and where."""
        found = self.found
        hard = np.array([shock.turned for shock in found.shocks if shock.hard])
        beside = np.mod((hard[:, None] + BESIDE).ravel(), FULL_TURN)
        turned = distinct(np.concatenate([np.linspace(0.0, FULL_TURN, PROVED), found.turn.table, beside]))
        return self._worst(turned, recovered(found.cam, found.phi(turned)))

    @cached_property
    def proof_as_printed(self) -> Extreme:
        """The same at the table positions with the coordinates rounded as the table has them."""
        found = self.found
        exact = self.table.profile
        points = _as_printed(exact.real) + 1j * _as_printed(exact.imag)
        return self._worst(found.turn.table, touching(found.cam, points, found.phi(found.turn.table)))

    def _worst(self, turned: Array, q: Array) -> Extreme:
        found = self.found
        off = q - side_of(found.cam) * found.cam.moved(found.phi(turned))[0].z
        if not found.slides:
            off = np.mod(off + np.pi, FULL_TURN) - np.pi
        k = int(np.argmax(np.abs(off)))
        return Extreme(float(np.abs(off[k])), float(turned[k]))


def _as_printed(numbers: Array) -> Array:
    """Rounded as a column of a table is."""
    return np.array([float(text.replace("−", "-")) for text in column(numbers, DIGITS, ".")])


def making(given: Given, found: CamFound) -> Making:
    return Making(found, given.cutter, given.groove)
