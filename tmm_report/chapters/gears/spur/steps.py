"""The numbers of a spur stage with the expressions that the note prints of them; lengths in mm.

The geometry of a pair is sought through by the ten thousand: its numbers are those of mechanics/gears.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.gears.spur.gauging import gauges
from tmm_report.chapters.gears.spur.loosening import loosened
from tmm_report.chapters.gears.spur.qualities import divided
from tmm_report.chapters.gears.spur.solve.motion import FAST, NARROWEST, SLOW, WIDEST, sliding_limit
from tmm_report.chapters.gears.spur.solve.pair import EQUAL, Found
from tmm_report.chapters.gears.spur.values import (
    Divided,
    Drawn,
    Gauge,
    Loosened,
    Tool,
    Values,
    Wheel,
    letters,
)
from tmm_report.mechanics.gears import shift_sharing
from tmm_report.quantity.formula import PI, Expr, Number, Var, arccos, cos, sin, sqrt, tan
from tmm_report.quantity.functions import arcsin, arctan
from tmm_report.quantity.sheet import Computed
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.gear_terms import involute


def stage(found: Found, prefix: str) -> Stage:
    """The numbers of a pair, made once; every name begins with `prefix`."""
    return next(iter(_stages(found, prefix)))


@tabulated
def _stages(found: Found, prefix: str) -> Iterator[Stage]:
    yield Stage(found, prefix)


def _angle(expression: Expr, number: Any) -> Computed:
    """`number`: rad."""
    return Computed(expression, float(np.degrees(number)))


class Stage:
    """`s`: the single numbers; `wheels`: counted 0 and 1 here, and named as in the drive; `tools`: a row for each wheel
    that a pinion cutter cuts."""

    def __init__(self, found: Found, prefix: str):
        self.found, self.prefix = found, prefix
        self.pair, self.given, self.names = found.pair, found.given, found.given.wheels
        self.internal, self.helical = found.given.internal, bool(found.pair.beta > 0)
        self.small = found.teeth.small
        self.s = Values(letters(found), prefix)
        self.wheels = tuple(Wheel(f"{prefix}_wheels", i, name) for i, name in enumerate(self.names))
        self.tools = tuple(Tool(f"{prefix}_cutter", row) for row in range(len(found.cutters)))
        for step in (
            self._given, self._teeth, self._section, self._distance, self._own_shifts, self._cutting,
            self._circles, self._tips, self._thicknesses, self._pitches, self._path, self._quality, self._slides,
            self._motion,
        ):  # fmt: skip
            step()

    @cached_property
    def drawn(self) -> Drawn:
        """Made when it is asked for: the outlines are turned over a pitch."""
        s, found = Drawn(prefix=self.prefix), self.found
        s.accuracy, s.scale, s.reduction = self.given.accuracy, found.mesh.scale, 1 / found.mesh.scale
        if not found.beyond:
            s.mu_sliding = found.sliding_scale
        s.overlap, s.clearance, s.eps_counted = (
            getattr(found.proof, key) for key in ("overlap", "clearance", "ratio")
        )
        return s

    @cached_property
    def gauges(self) -> tuple[Gauge, ...]:
        """By what both wheels are measured."""
        return gauges(self)

    @cached_property
    def divided(self) -> Divided | None:
        """Of the quality over the division of the shifts; None where it is not asked for."""
        return divided(self, self.found.quality) if self.found.quality else None

    @cached_property
    def loosened(self) -> Loosened | None:
        """Of the backlash; None where it is not asked for."""
        return loosened(self, self.found.backlash) if self.found.backlash else None

    # ------------------------------------------------------------ terms

    @property
    def m_t(self) -> Var:
        return self.s.m_t if self.helical else self.s.m

    @property
    def alpha_t(self) -> Var:
        return self.s.alpha_t if self.helical else self.s.alpha

    @property
    def teeth_sum(self) -> Expr:
        return self._combined("z")

    def _combined(self, key: str) -> Expr:
        """The sum over both wheels; of an internal pair the larger's less the smaller's."""
        one, other = (wheel.var(key) for wheel in self.wheels)
        if not self.internal:
            return one + other
        return other - one if self.small == 0 else one - other

    def ring(self, i: int) -> bool:
        return bool(self.pair.signs[i] < 0)

    # ------------------------------------------------------------ teeth

    def _given(self) -> None:
        s, given, rack = self.s, self.given, self.pair.rack
        s.u_required, s.m, s.alpha, s.ha, s.c = (
            None if given.by_teeth else given.ratio,
            given.module,
            float(np.degrees(rack.alpha)),
            rack.ha,
            rack.c,
        )
        s.b = given.width
        if given.helix:
            s.beta = float(np.degrees(given.helix))
        for i, w in enumerate(self.wheels):
            w.z, w.x_rule = self.found.teeth.z[i], self.found.rule_shifts[i]
        if given.centre_distance is not None:
            s.a_w = float(self.pair.a_w)

    def _teeth(self) -> None:
        """How the numbers of teeth were found."""
        s, (one, two) = self.s, self.wheels
        u = two.z / one.z
        s.ratio = Computed(u if self.internal else -u, self.pair.ratio)
        if (choice := self.found.teeth.choice) is None:
            return
        s.u, over = choice.u, 2 * s.a_w
        s.z_bound = Computed((over * cos(s.beta) if self.helical else over) / s.m, choice.bound)
        s.z_share = Computed(s.z_bound / (s.u - 1 if self.internal else 1 + s.u), choice.share)
        s.z_larger = Computed(s.u * self.wheels[self.small].z, choice.larger)
        s.z_spare = Computed(s.z_bound - self.teeth_sum, choice.spare)

    # ------------------------------------------------------------ section, angle, shifts

    def _section(self) -> None:
        """Module and profile angle of the transverse section of helical teeth."""
        s, p = self.s, self.pair
        if self.helical:
            s.m_t = Computed(s.m / cos(s.beta), p.m_t)
            s.alpha_t = _angle(arctan(tan(s.alpha) / cos(s.beta)), p.t.alpha)
            s.beta_b = arcsin(sin(s.beta) * cos(s.alpha))
        s.a = Computed(self.m_t * self.teeth_sum / 2, p.a)

    def _distance(self) -> None:
        """From the centre distance to the sum of the shifts, or from the shifts to the centre distance."""
        s, p = self.s, self.pair
        profile, operating = self.found.involutes
        if self.given.centre_distance is None:
            self._shifts_taken()
            s.x_sum = Computed(self._combined("x"), p.x_sum)
            angle = involute(self.alpha_t) + 2 * s.x_sum * tan(s.alpha) / self.teeth_sum
            s.inv_alpha, s.inv_alpha_w = profile, Computed(angle, operating)
            s.alpha_w = float(np.degrees(p.alpha_w))
            s.a_w = Computed(s.a * cos(self.alpha_t) / cos(s.alpha_w), p.a_w)
            return
        s.alpha_w = _angle(arccos(s.a * cos(self.alpha_t) / s.a_w), p.alpha_w)
        s.inv_alpha = Computed(self._spelled("alpha_t" if self.helical else "alpha"), profile)
        s.inv_alpha_w = Computed(self._spelled("alpha_w"), operating)
        filled = self.teeth_sum * (involute(s.alpha_w) - involute(self.alpha_t)) / (2 * tan(s.alpha))
        if self.found.loose:
            s.x_sum, s.x_needed = float(p.x_sum), Computed(filled, self.found.needed)
        else:
            s.x_sum = Computed(filled, p.x_sum)
        self._shifts_taken()

    def _spelled(self, angle: str) -> Expr:
        return tan(self.s.var(angle)) - self.s[angle].var("rad")

    def _shifts_taken(self) -> None:
        """Those of both wheels; by a rule the smaller wheel takes its least one, the other the rest."""
        s, shift, taken = self.s, self.given.shift, (float(self.pair.x1), float(self.pair.x2))
        small, other = self.wheels[self.small], self.wheels[1 - self.small]
        s.z_rule = shift_sharing.rule_teeth(self.pair.rack)
        if self.given.rests:
            rest = self.given.rests[0]
            self.wheels[1 - rest].x = taken[1 - rest]
            self.wheels[rest].x = Computed(self._rest(rest), taken[rest])
            return
        if self.given.centre_distance is None or not isinstance(shift, str) or shift == EQUAL:
            small.x, other.x = taken[self.small], taken[1 - self.small]
            return
        least = taken[self.small]
        ruled = least and not (self.by_cutter and shift == "limit")
        small.x = Computed(self._least() if shift == "limit" else self._by_rule(), least) if ruled else least
        other.x = Computed(self._rest(1 - self.small), taken[1 - self.small])

    def _rest(self, i: int) -> Expr:
        """What the sum of the shifts leaves to wheel i; of an internal pair the ring's less the pinion's."""
        s, own = self.s, self.wheels[1 - i].x
        if not self.internal:
            return s.x_sum - own
        return s.x_sum + own if self.ring(i) else own - s.x_sum

    @property
    def by_cutter(self) -> bool:
        """Whether a stated pinion cutter cuts both wheels."""
        return self.given.cutter is not None and not self.internal

    def _by_rule(self) -> Expr:
        least, z = Number(self.s.number("z_rule")), self.wheels[self.small].z
        value = (least - (z / cos(self.s.beta) ** 3 if self.helical else z)) / least
        return value if self.pair.rack.ha == 1 else self.s.ha * value

    def _least(self) -> Expr:
        """The least shift of the smaller wheel without undercut."""
        cut = self.wheels[self.small].z * sin(self.alpha_t) ** 2
        return self.s.ha - (cut / (2 * cos(self.s.beta)) if self.helical else cut / 2)

    def _own_shifts(self) -> None:
        """What they leave: undercut, shift of the centres, shortening; those stated where they were changed."""
        s, p, stated = self.s, self.pair, self.given.shift
        for i, w in enumerate(self.wheels):
            least = float(p.x_min[i])
            w.x_min = Computed(self._least(), least) if i == self.small and not self.by_cutter else least
        if self.found.altered and isinstance(stated, tuple):
            s.stated_one, s.stated_two = stated
        s.y = Computed((s.a_w - s.a) / s.m, p.y)
        if p.tips is None:
            s.shortening = Computed(s.x_sum - s.y, p.shortening) if self.equalised else float(p.shortening)

    @property
    def equalised(self) -> bool:
        """Whether the tips are cut down to keep the clearance."""
        return bool(self.pair.shortening > 1e-9)

    # ------------------------------------------------------------ cutting by a pinion cutter

    def _cutting(self) -> None:
        for tool, cut in zip(self.tools, self.found.cutters, strict=True):
            by, wheel = cut.by, cut.wheel
            tool.z0, tool.x0, tool.d_0 = float(by.tool.z), by.tool.x, by.tool.z * by.m
            tool.alpha_w0, tool.d_f0 = float(np.degrees(by.alpha)), abs(by.root)
            numbers = (np.tan(by.alpha) - by.alpha, abs(by.distance), 2 * by.tip, 2 * by.base, abs(by.start))
            for key, number in zip(("inv_alpha_w0", "a_w0", "d_a0", "d_b0", "rho_l0"), numbers, strict=True):
                made = self._by_tool(key, tool, wheel) if self.given.cutter else None
                tool.put(key, Computed(made, number) if made else float(number))
            tool.clearance0 = float(cut.pair.clearance[wheel])

    def _by_tool(self, key: str, tool: Tool, i: int) -> Expr | None:
        """Of a wheel that the stated cutter cuts: the last pass, the cutter, the end of the involute."""
        s, w, ring = self.s, self.wheels[i], self.ring(i)
        teeth, shifts = (w.z - tool.z0, w.x - tool.x0) if ring else (w.z + tool.z0, w.x + tool.x0)
        match key:
            case "inv_alpha_w0":
                return involute(self.alpha_t) + 2 * shifts * tan(s.alpha) / teeth
            case "a_w0":
                return self.m_t * teeth * cos(self.alpha_t) / (2 * cos(tool.alpha_w0))
            case "d_a0":
                return self.m_t * tool.z0 + 2 * s.m * (s.ha + s.c + tool.x0)
            case "d_b0":
                return self.m_t * tool.z0 * cos(self.alpha_t)
        curvature = sqrt(tool.d_a0**2 - tool.d_b0**2) / 2
        reach = tool.a_w0 * sin(tool.alpha_w0)
        if ring:
            return reach + curvature
        return reach - curvature if self.pair.rho_l[i] >= 0 else None

    # ------------------------------------------------------------ dimensions of the wheels

    def _circles(self) -> None:
        s, p = self.s, self.pair
        s.line = Computed(s.a_w * sin(s.alpha_w), p.line)
        for i, w in enumerate(self.wheels):
            w.d = Computed(self.m_t * w.z, p.d[i])
            w.d_b = Computed(w.d * cos(self.alpha_t), p.d_b[i])
            w.d_w = Computed(w.d_b / cos(s.alpha_w), p.d_w[i])
            w.d_f = Computed(self._root(i), p.d_f[i])
            start = self.found.starts[i]
            w.rho_l = Computed(self._involute_start(i), start) if self._clears(i) else start

    def _root(self, i: int) -> Expr:
        s, w = self.s, self.wheels[i]
        if self.given.cutter and self.found.cut_by(i):
            tool = self.tools[self.found.cut_wheels.index(i)]
            return 2 * tool.a_w0 + tool.d_a0 if self.ring(i) else 2 * tool.a_w0 - tool.d_a0
        if self.ring(i):
            return w.d + 2 * s.m * (s.ha + s.c + w.x)
        return w.d - 2 * s.m * (s.ha + s.c - w.x)

    def trimmed(self, i: int) -> bool:
        """Whether the tips of a ring are cut down to clear the fillets of its pinion."""
        return bool(self.pair.trimming[i] > 1e-9 * self.pair.m)

    def _clears(self, i: int) -> bool:
        """Whether a ring's tips are cut down to clear the fillets of this wheel, which the rack leaves no undercut."""
        return self.trimmed(1 - i) and bool(self.pair.rho_l[i] > 0)

    def _involute_start(self, i: int) -> Expr:
        """Of a pinion that is cut by the rack without undercut: where its involute begins."""
        w, s = self.wheels[i], self.s
        lost = (s.ha - w.x) * s.m / sin(self.alpha_t)
        return self.m_t * w.z / 2 * sin(self.alpha_t) - lost

    def _tips(self) -> None:
        for i, w in enumerate(self.wheels):
            if self.pair.tips is not None:
                self._stated_tip(i)
            else:
                w.d_a = Computed(self._tip(i), self.pair.d_a[i])
            w.alpha_a = _angle(arccos(w.d_b / w.d_a), self.pair.alpha_a[i])
        if self.pair.tips is not None:
            self._clearances()

    def _stated_tip(self, i: int) -> None:
        """The tip circle as it is stated, and what the head has lost; the clearance at the root of the other wheel."""
        s, w, ring = self.s, self.wheels[i], self.ring(i)
        w.d_a = float(self.pair.d_a[i])
        full = w.d - 2 * s.m * (s.ha - w.x) if ring else w.d + 2 * s.m * (s.ha + w.x)
        w.tip_lost = (w.d_a - full if ring else full - w.d_a) / (2 * s.m)

    def _clearances(self) -> None:
        """At the root of each wheel, of stated tips."""
        for i, w in enumerate(self.wheels):
            tip = self.wheels[1 - i].d_a
            apart = (w.d_f - tip if self.ring(i) else tip - w.d_f) / 2
            room = apart - self.s.a_w if self.internal else self.s.a_w - (w.d_f + tip) / 2
            w.clearance = Computed(room, self.pair.clearance[i])

    def _tip(self, i: int) -> Expr:
        s, w, other = self.s, self.wheels[i], self.wheels[1 - i]
        if self.trimmed(i):
            return 2 * sqrt((w.d_b / 2) ** 2 + (s.line + other.rho_l) ** 2)
        if self.equalised and self.given.cutter:
            return w.d + 2 * s.m * (s.ha + w.x - s.shortening)
        if self.equalised:
            return 2 * s.a_w - other.d_f - 2 * s.c * s.m
        if self.ring(i):
            return w.d - 2 * s.m * (s.ha - w.x)
        return w.d + 2 * s.m * (s.ha + w.x)

    def _thicknesses(self) -> None:
        p = self.pair
        for i, w in enumerate(self.wheels):
            widened = 2 * w.x * tan(self.s.alpha)
            w.s = Computed(self.m_t * (PI / 2 - widened if self.ring(i) else PI / 2 + widened), p.s[i])
            # the teeth of a ring end before its base circle
            w.s_b = float(p.s_b[i]) if self.ring(i) else Computed(self._arc(i, w.d_b), p.s_b[i])
            w.s_w = Computed(self._arc(i, w.d_w, self.s.alpha_w), p.s_w[i])
            w.s_a = Computed(self._arc(i, w.d_a, w.alpha_a), p.s_a[i])

    def _arc(self, i: int, d: Var, angle: Expr | None = None) -> Expr:
        """`angle`: of the profile on the circle; None of the base circle."""
        w, own = self.wheels[i], involute(self.alpha_t)
        total = w.s / w.d - own if self.ring(i) else w.s / w.d + own
        if angle is None:
            return d * total
        return d * (total + involute(angle) if self.ring(i) else total - involute(angle))

    def _pitches(self) -> None:
        s, p, (one, two) = self.s, self.pair, self.wheels
        s.p = Computed(PI * self.m_t, p.p)
        s.p_b = Computed(s.p * cos(self.alpha_t), p.p_b)
        s.p_w = Computed(s.p_b / cos(s.alpha_w), p.p_w)
        left = float(p.backlash)
        s.backlash = Computed(s.p_w - one.s_w - two.s_w, left) if self.found.loose else left
        s.backlash_n = float(p.normal_backlash)

    # ------------------------------------------------------------ line of action

    def _path(self) -> None:
        for i, w in enumerate(self.wheels):
            tip = sqrt(w.d_a**2 - w.d_b**2) / 2
            w.rho_a = Computed(tip, self.pair.rho_a[i])
        lower, others = ("rho_m", ("rho_p", "rho_u")) if self.found.cut_short else ("rho_p", ())
        for i, w in enumerate(self.wheels):
            w.put(lower, Computed(self._lower(i), getattr(self.pair, lower)[i]))
            for key in others:
                w.put(key, float(getattr(self.pair, key)[i]))
            w.height = float(self.pair.height[i])

    def _lower(self, i: int) -> Expr:
        line, other = self.s.line, self.wheels[1 - i].rho_a
        if not self.internal:
            return line - other
        return line + other if self.ring(i) else other - line

    def _quality(self) -> None:
        s, p, short = self.s, self.pair, self.found.cut_short
        s.active = Computed(self._real() if short else self._between_tips(), p.active)
        s.eps = Computed(s.active / s.p_b, p.eps)
        if short:
            s.active_tips = Computed(self._between_tips(), p.active_tips)
            s.eps_tips = Computed(s.active_tips / s.p_b, p.eps_tips)
        if self.helical and self.given.width is not None:
            s.eps_beta = Computed(s.b * sin(s.beta) / (PI * s.m), p.overlap(self.given.width))
        if self.found.two_zones:
            s.two_length = Computed(s.active - s.p_b, p.active - p.p_b)
            s.two_pairs = Computed((s.eps - 1) * Number(100), p.two_pairs)
        else:
            s.two_pairs = float(p.two_pairs)

    def _between_tips(self) -> Expr:
        one, other = (w.rho_a for w in self.wheels)
        if self.internal:
            return (one - other if self.small == 0 else other - one) + self.s.line
        return one + other - self.s.line

    def _real(self) -> Expr:
        """Between the lower points of both active profiles."""
        one, other = (w.rho_p for w in self.wheels)
        if self.internal:
            return (other - one if self.small == 0 else one - other) - self.s.line
        return self.s.line - one - other

    def _slides(self) -> None:
        """Specific sliding at the lower points of the active profiles, and at the tips."""
        upper = "rho_u" if self.found.cut_short else "rho_a"
        for key, own, other in (("root_sliding", "rho_p", upper), ("tip_sliding", upper, "rho_p")):
            for i, w in enumerate(self.wheels):
                mate, number = self.wheels[1 - i], getattr(self.pair, key)[i]
                ratio = w.z * mate.var(other) / (mate.z * w.var(own))
                w.put(key, float(number) if self.found.beyond else Computed(1 - ratio, number))

    # ------------------------------------------------------------ at the speed of the drive

    def _motion(self) -> None:
        s, motion = self.s, self.found.motion
        if motion is None:
            return
        s.omega_one, s.omega_two = motion.omega
        d_w, d_b = (self.wheels[0][key].var("m") for key in ("d_w", "d_b"))
        s.v_pitch = Computed(s.omega_one * d_w / 2, motion.pitch)
        s.v_along = Computed(s.omega_one * d_b / 2, motion.along)
        s.v_way = abs(float(self.found.path.at.rho[motion.fastest]) - float(self.pair.rho_w[0]))
        if self.given.sliding_limit is None:
            fall = Number((WIDEST - NARROWEST) / (FAST - SLOW))
            falling = Number(WIDEST) - fall * (s.v_pitch - Number(SLOW))
            limit = sliding_limit(motion.pitch)
            s.sliding_limit = Computed(falling, limit) if SLOW < motion.pitch < FAST else limit
