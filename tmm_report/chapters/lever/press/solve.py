"""A press by its slider: which force a permitted torque allows on the way to the dead point, dwell there, evenness.

With the arm h = v/ω of the slider's force on the driving link, friction and weights left out: F = M/h. Towards the dead
point h goes to nil and F grows without bound: the frame is rated for F_nom, the crank and its drive for M, and from the
angle where h = M/F_nom on both hold. (Bocharov, Forging and stamping equipment, the permitted forces; Schuler, Metal
forming handbook, ch. 3)
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinematics.solve.strokes import Output, outputs
from tmm_report.chapters.lever.press import steps
from tmm_report.chapters.lever.press.given import Press
from tmm_report.chapters.lever.press.values import Values
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.cycle import Quantity
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any
ACROSS = 1e-6  # cosine of a guide to the side of the dead point, below which it does not lead there
SAME = 1e-9  # rad: nearer to the dead point than this is it itself


@dataclass(frozen=True, eq=False)
class Found:
    """`output`: the slider, positive towards the dead point, which is `top` along its direction, `dead` turned from
    position 0; `begins`: angle before it at which the slider sets out; `always`: whether the rated force is permitted
    over the whole stroke."""

    given: Press
    kinematics: Kinematics
    output: Output
    top: float
    dead: float
    begins: float
    always: bool
    s: Values

    def before(self, alpha: Array) -> Motion:
        """The motion at angles before the dead point, rad, (P,)."""
        return self.kinematics.cycle.motion(self.dead - np.asarray(alpha, float))

    def path(self, motion: Motion) -> Array:
        """Left to the dead point, m."""
        return self.top - self.output.coordinate(motion)

    def arm(self, motion: Motion) -> Array:
        """v/ω, m: above zero towards the dead point."""
        return self.output.velocity(motion) / np.abs(motion.omega)

    def where(self, level: Quantity) -> tuple[Array, Array]:
        """Angles at which a quantity of the motion is nil: before the dead point within the stroke to it, and after it,
        both ascending, rad."""
        cycle = self.kinematics.cycle
        roots = cycle.roots(level)
        before, after = (np.sort(np.mod(x, cycle.sweep)) for x in (self.dead - roots, roots - self.dead))
        return before[before <= self.begins + SAME], after

    @cached_property
    def peaks(self) -> Array:
        """Angles before the dead point at which the slider goes fastest or slowest within the stroke, rad."""
        return self.where(self.output.acceleration)[0]

    def at_path(self, path: float) -> float:
        """Angle before the dead point at which so much is left, rad; nan where the stroke is shorter."""
        if path == 0:
            return 0.0
        before, _ = self.where(lambda motion: self.path(motion) - path)
        return float(before[0]) if before.size else np.nan


def solve(kinematics: Kinematics, given: Press) -> Found:
    """Raises ProblemError."""
    cycle = kinematics.cycle
    if kinematics.gaps or not cycle.closed:
        text = N_("a press goes all round: this mechanism does not")
        raise ProblemError([mistake(text, ("press",), Message(N_("leave the block out")))])
    output = _slider(kinematics, given)
    stops = cycle.swings(output.velocity, output.size)
    if not stops.size:
        raise ProblemError([mistake(N_("the slider does not move"), ("press", "slider"))])
    reached = output.coordinate(cycle.motion(stops))
    highest = np.flatnonzero(reached >= reached.max() - 1e-9 * np.ptp(reached))
    dead, top = float(stops[highest[0]]), float(reached[highest[0]])
    back = np.mod(dead - stops, cycle.sweep)
    begins = float(back[(back > SAME) & (back < cycle.sweep - SAME)].min(initial=cycle.sweep))
    found = Found(given, kinematics, output, top, dead, begins, False, Values())
    return steps.worked(found)


def _slider(kinematics: Kinematics, given: Press) -> Output:
    """Positive towards the dead point."""
    path = ("press", "slider")
    sliders = {one.link: one for one in outputs(kinematics.linkage) if one.kind == "slider"}
    if given.slider not in sliders:
        right = Message(N_("one of: %(words)s"), {"words": ", ".join(sliders)}) if sliders else None
        text = N_("link %(name)s does not slide on a fixed guide")
        raise ProblemError([mistake(text, path, right, name=given.slider)])
    own = sliders[given.slider]
    towards = float(dot(given.extreme, own.direction))
    if abs(towards) < ACROSS:
        text = N_("the guide of link %(name)s does not lead there")
        right = Message(N_("a side to which the slider moves: right, left, up or down"))
        raise ProblemError([mistake(text, ("press", "extreme"), right, name=given.slider)])
    return Output("slider", own.name, own.link, own.direction * np.sign(towards))
