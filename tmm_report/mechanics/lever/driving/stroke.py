"""A mechanism that a slider or a hydraulic cylinder drives: what is common to the ways of solving it.

The stroke s goes by a law of the time: the place of the slider along its guide, or the length of the cylinder. A link
that turns about a fixed point follows it, the first to be known; behind it the groups are those of a mechanism that
this link would drive. How it follows the stroke says `triangle` in closed form, and of any mechanism `reversed`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.mechanics.calculus.motion_laws import MotionLaw, Three
from tmm_report.mechanics.calculus.vectors import unit
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.lever.motion import Motion

Array = Any


@dataclass(frozen=True)
class Taken:
    """A force along the stroke: `sign` of it acts on a point of a link."""

    link: str
    point: str
    sign: int


class Stroke:
    """What drives, and how the link `link` follows it; lengths in m, places in the axes of the frame.

    `law`: of the stroke by the time, m. `ends`: of a slider its guided point; of a cylinder the point from which and
    that towards which it pushes. `way`: of a slider the direction of its guide, unit complex, of a cylinder 0. `by`:
    the slider, or the links of the cylinder that are stated; `takes`: where its force acts on moving links.
    """

    law: MotionLaw
    link: str
    ends: tuple[str, ...]
    way: complex
    by: tuple[str, ...]
    takes: tuple[Taken, ...]

    @property
    def slides(self) -> bool:
        """Whether a slider drives, and not a cylinder."""
        return self.way != 0

    def rates(self, s: Array, v: Array, a: Array) -> Three:
        """Angle of the link, its angular velocity and acceleration at strokes s with the rates v, m/s, and a, m/s²."""
        raise NotImplementedError

    def limit(self) -> float | None:
        """Of the strokes that the law goes over one beyond which the mechanism cannot go on, m; None: it can."""
        raise NotImplementedError

    def transfer(self, s: Array) -> Array:
        """dφ/ds, rad/m, by which the moment on the link becomes the force along the stroke."""
        return self.rates(s, 1.0, 0.0)[1]

    def along(self, motion: Motion) -> Array:
        """Direction in which the stroke grows: along the guide, or from one end of the cylinder to the other, unit
        complex, (..., P)."""
        if self.slides:
            return self.way + np.zeros(motion.shape)
        start, end = (motion.place(point) for point in self.ends)
        return unit(end - start)


@dataclass(frozen=True, eq=False)
class Turned(MotionLaw):
    """The angle of the link that follows a stroke, rad."""

    stroke: Stroke

    @property
    def period(self) -> float:  # type: ignore[override]
        return self.stroke.law.period

    @property
    def breaks(self) -> tuple[float, ...]:  # type: ignore[override]
        return self.stroke.law.breaks

    def at(self, t: Array) -> Three:
        return self.stroke.rates(*self.stroke.law.at(np.asarray(t, dtype=float)))
