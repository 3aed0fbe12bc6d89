"""By what a wheel is measured, each number with the expression that the note prints of it; lengths in mm.

GOST 16532 of external wheels, 19274 of rings; helical teeth are measured across, in their normal section.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.gears.spur.values import OF_RINGS, Gauge
from tmm_report.quantity.formula import PI, Expr, Number, Var, arccos, cos, sin, sqrt, tan
from tmm_report.quantity.functions import Degrees, arctan
from tmm_report.quantity.terms.gear_terms import involute

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.solve.inspection import Measured
    from tmm_report.chapters.gears.spur.steps import Stage

QUARTER = Degrees(math.pi / 2)


def gauges(stage: Stage) -> tuple[Gauge, ...]:
    """Of both wheels."""
    return tuple(Gauging(stage, of).r for of in stage.found.inspected)


class Gauging:
    """`r`: the numbers of one wheel."""

    def __init__(self, stage: Stage, of: Measured):
        self.stage, self.of, self.i = stage, of, of.gauge.i
        self.s, self.w, self.ring = stage.s, stage.wheels[self.i], stage.ring(self.i)
        other = OF_RINGS if stage.internal else None
        self.r = Gauge(f"{stage.prefix}_inspection", self.i, stage.names[self.i], other)
        for step in (self._span, self._tip, self._constant_chord, self._chord, self._pins):
            step()

    def _across(self, length: Expr) -> Expr:
        """A length along the flanks' normals, seen in the transverse section."""
        return length * cos(self.s.beta_b) if self.stage.helical else length

    # ------------------------------------------------------------ span

    def _span(self) -> None:
        s, w, r, helical = self.s, self.w, self.r, self.stage.helical
        if self.of.gauge.spannable and math.isfinite(self.of.gauge.rule):
            turned = 2 * w.x * cos(s.beta) if helical else 2 * w.x
            r.alpha_m = arccos(w.z * cos(self.stage.alpha_t) / (w.z + turned))
            rise = tan(r.alpha_m) / cos(s.beta_b) ** 2 if helical else tan(r.alpha_m)
            own = rise - 2 * w.x * tan(s.alpha) / w.z - involute(self.stage.alpha_t)
            r.span_rule = w.z / PI * own + Number(0.5)
        if self.of.span is None:
            return
        r.span_teeth = self.of.span
        arcs = PI * (r.span_teeth - Number(0.5)) + 2 * w.x * tan(s.alpha) + w.z * involute(self.stage.alpha_t)
        r.W = s.m * cos(s.alpha) * arcs
        r.rho_W = self._across(r.W) / 2

    # ------------------------------------------------------------ chords

    def _helix(self, d: Var) -> Expr:
        return arctan(d * tan(self.s.beta) / self.w.d)

    def _normal(self, angle: Expr, beta: Var | None) -> Expr:
        """Half the angle of a tooth of the wheel that stands for the normal section; `beta`: the helix angle there,
        None of straight teeth."""
        return angle if beta is None else angle * cos(beta) ** 3

    def _diameter(self, d: Expr, beta: Var | None) -> Expr:
        """Of that wheel."""
        return d if beta is None else d / cos(beta) ** 2

    def _tip(self) -> None:
        w, r = self.w, self.r
        if self.of.gauge.pointed:
            return
        if self.stage.helical:
            r.beta_a = self._helix(w.d_a)
        beta = r.beta_a if self.stage.helical else None
        half = self._normal(w.s_a / w.d_a, beta)
        r.s_ay = self._diameter(w.d_a * sin(half), beta)
        if self.ring:
            r.sag = self._diameter(w.d_a * (1 - cos(half)), beta) / 2

    def _constant_chord(self) -> None:
        if not self.of.has_constant_chord:
            return
        s, w, r = self.s, self.w, self.r
        shifted = w.x * sin(2 * s.alpha)
        square = PI / 2 * cos(s.alpha) ** 2
        r.s_c = s.m * (square - shifted if self.ring else square + shifted)
        lost = r.s_c * tan(s.alpha)
        r.h_c = (w.d - w.d_a - lost) / 2 + r.sag if self.ring else (w.d_a - w.d - lost) / 2

    def _chord(self) -> None:
        w, r, of = self.w, self.r, self.of
        if of.circle is None:
            return
        r.d_y = of.circle
        at_pitch = of.circle == of.gauge.of("d")
        d = w.d if at_pitch else r.d_y
        angle: Expr = w.s / w.d
        if not at_pitch:
            r.alpha_y = arccos(w.d_b / d)
            own, there = involute(self.stage.alpha_t), involute(r.alpha_y)
            angle = angle - own + there if self.ring else angle + own - there
            if self.stage.helical:
                r.beta_y = self._helix(d)
        beta = None
        if self.stage.helical:
            beta = self.s.beta if at_pitch else r.beta_y
        r.psi_y = self._normal(angle, beta)
        r.s_y = self._diameter(d * sin(r.psi_y), beta)
        if not of.gauge.pointed:
            sag = self._diameter(d * (1 - cos(r.psi_y)), beta)
            r.h_y = (d - w.d_a - sag) / 2 + r.sag if self.ring else (w.d_a - d + sag) / 2

    # ------------------------------------------------------------ pins

    def _pins(self) -> None:
        s, w, r, of = self.s, self.w, self.r, self.of
        if of.pin is None:
            return
        r.pin = of.pin
        own, wide = involute(self.stage.alpha_t), r.pin / (s.m * w.z * cos(s.alpha))
        turned = 2 * w.x * tan(s.alpha)
        if self.ring:
            r.inv_alpha_D = (PI / 2 + turned) / w.z + own - wide
        else:
            r.inv_alpha_D = wide + own - (PI / 2 - turned) / w.z
        r.alpha_D = float(np.degrees(of.gauge.pin_angle(of.pin)))
        r.d_D = w.d_b / cos(r.alpha_D)
        rise, aside = w.d_b * tan(r.alpha_D), self._across(r.pin)
        r.d_k = sqrt(w.d_b**2 + (rise + aside if self.ring else rise - aside) ** 2)
        apart = r.d_D * cos(QUARTER / w.z) if of.gauge.z % 2 else r.d_D
        r.M = apart - r.pin if self.ring else apart + r.pin
