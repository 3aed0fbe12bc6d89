"""A gear on the driving link's shaft: the force of the wheel that drives it, in place of a balancing moment.

In the pitch point P the teeth press along the line of action, at the angle alpha_w to the common tangent of the pitch
circles, and push the wheels apart: with e from the pivot to P, the force on the gear is
F (s cos alpha_w · ie − sin alpha_w · e), where s is the sense in which it turns the gear. About the pivot its arm is
the base radius r_w cos alpha_w, so F = M / (r_w cos alpha_w).
Source: Artobolevsky, Theory of mechanisms and machines, ch. 13; Frolov (ed.), Theory of mechanisms, ch. 5.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any


def pressed_flank(moment: Array) -> Array:
    """The flank of a gear's teeth that a moment presses: 1, or -1 of a moment below zero; (..., P)."""
    return np.where(np.asarray(moment) < 0, -1.0, 1.0)


@dataclass(frozen=True, eq=False)
class GearDrive:
    """`radius` of the gear's pitch circle, m; `pressure`: alpha_w, rad; `at`: direction from the pivot to the pitch
    point, rad. `one_flank`: the wheel never leaves the flank by which it drives; else the flank in contact is that
    which the sense of the moment presses."""

    radius: Any
    pressure: Any
    at: Any
    one_flank: bool = False

    @property
    def base_radius(self) -> Any:
        """r_w cos alpha_w, m: the arm of the force about the pivot."""
        return self.radius * np.cos(self.pressure)

    @property
    def pitch_point(self) -> Any:
        """From the pivot, complex m."""
        return self.radius * np.exp(1j * self.at)

    def size(self, moment: Array, omega: Any) -> Array:
        """The force, N (..., P), for balancing moments, N m: with one flank its sign is that of M·omega, and below zero
        the wheel would have to pull; else it has the sign of the moment."""
        sense = np.sign(omega) if self.one_flank else 1.0
        return moment / (sense * self.base_radius)

    def line(self, moment: Array, omega: Any, flank: Array | None = None) -> Array:
        """Unit direction of the line of action in which a positive force of `size` pushes, complex (..., P). `flank`:
        the sense of the moment whose flank is in contact, where `moment` is but a part of it."""
        outward = np.exp(1j * self.at)
        if self.one_flank:
            sense = np.sign(omega) * np.ones_like(np.asarray(moment, dtype=float))
            return outward * (1j * sense * np.cos(self.pressure) - np.sin(self.pressure))
        sense = pressed_flank(moment) if flank is None else flank
        # a negative force along −d is a positive one along d, which pushes the wheels apart
        return outward * (1j * np.cos(self.pressure) - sense * np.sin(self.pressure))

    def force(self, moment: Array, omega: Any, flank: Array | None = None) -> Array:
        """On the gear, complex N, (..., P)."""
        return self.size(moment, omega) * self.line(moment, omega, flank)
