"""The numbers of the quality of a pair over the division of its shifts and over its centre distance."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.gears.spur.solve.quality import Course, Found
from tmm_report.chapters.gears.spur.values import Along, Divided
from tmm_report.mechanics.gears.quality import specific_pressure
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, cos, sin
from tmm_report.quantity.model import Column, text_column
from tmm_report.quantity.sheet import Computed, Q

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.steps import Stage

COUNTED = {"own": "1 − v{other}/v{own}", "mate": "v{own}/v{other} − 1", "size": "|1 − v{other}/v{own}|"}
OVER_SHIFTS = N_("quality of pair %(name)s over the division of its shifts")
SHIFT_CURVES = N_("quality of pair %(name)s over the division of its shifts: curves")
BOUNDS = N_("bounds of the shift of wheel %(wheel)s at the centre distance of pair %(name)s")
OVER_DISTANCES = N_("quality of pair %(name)s over the centre distance")
DISTANCE_CURVES = N_("quality of pair %(name)s over the centre distance: curves")


# ---------------------------------------------------------------- single numbers


def divided(stage: Stage, of: Found) -> Divided:
    """The bounds, the shift of equal sliding, the pressure between the profiles of the chosen pair."""
    one, pair = stage.names[0], stage.pair
    own = ("x_least", "x_most", "x_equal", "gamma_p", "gamma_a")
    s = Divided({key: Divided.DECLARED[key].of(one, wheel=one) for key in own}, stage.prefix)
    s.take(stage.given.quality, "least_tip", "least_contact")
    if of.ends is not None and of.at_ends is not None:
        s.x_least, s.x_most = of.ends
        s.eps_least, s.eps_most = (float(eps) for eps in of.at_ends.pair.eps)
        s.play = of.play
    if math.isfinite(of.equal):
        s.x_equal, s.lambda_equal = of.equal, of.equal_sliding
    for key, rho, formula in (
        ("gamma_w", pair.rho_w[0], _at_pole(stage)),
        ("gamma_p", pair.rho_p[0], _at_end(stage, 0)),
        ("gamma_a", pair.rho_u[0], _at_end(stage, 1)),
    ):
        if not stage.found.beyond:
            s.put(key, Computed(formula, float(specific_pressure(pair, rho))))
    return s


def _at_pole(stage: Stage) -> Expr:
    """The radii of curvature in the pitch point are (d_w/2) sin α_w."""
    apart = _apart(stage, *(wheel.d_w for wheel in stage.wheels))
    return 2 * _module(stage) / sin(stage.s.alpha_w) * apart


def _at_end(stage: Stage, lower: int) -> Expr:
    """Where the lower point of wheel `lower` (0, 1) meets the upper one of the other."""
    upper = "rho_u" if stage.found.cut_short else "rho_a"
    radii = [wheel.var("rho_p" if i == lower else upper) for i, wheel in enumerate(stage.wheels)]
    return _module(stage) * _apart(stage, *radii)


def _module(stage: Stage) -> Expr:
    """Of helical teeth the radii are those of their normal section, greater by the cosine."""
    return stage.s.m * cos(stage.s.beta_b) if stage.helical else stage.s.m


def _apart(stage: Stage, one: Expr, other: Expr) -> Expr:
    """The difference of the curvatures of both profiles."""
    if not stage.internal:
        return 1 / one + 1 / other
    return 1 / one - 1 / other if stage.small == 0 else 1 / other - 1 / one


# ---------------------------------------------------------------- tables


def tables(stage: Stage, of: Found) -> Iterator[tuple[str, str, list[Column]]]:
    """Name, meaning, columns."""
    over = Columns(stage)
    yield "quality", OVER_SHIFTS, [*over.shifts(of.stated), *over.measures(of.stated)]
    yield "quality_curves", SHIFT_CURVES, [*over.shifts(of.drawn), *over.measures(of.drawn)]
    yield "bounds", BOUNDS, list(over.bounds(of))
    for key, meaning, course in (
        ("distances", OVER_DISTANCES, of.stated_over),
        ("distance_curves", DISTANCE_CURVES, of.drawn_over),
    ):
        if course is not None:
            columns = [*over.distances(course), *over.shifts(course), *over.measures(course)]
            yield key, meaning, columns


class Columns:
    """The columns of the tables of one pair."""

    def __init__(self, stage: Stage):
        self.names, self.kind = stage.names, "d" if stage.internal else "Sigma"

    def _each(self, of: Q, both: tuple[Any, Any], like: Any, how: str = "") -> Iterator[Column]:
        """A column for each wheel; `how` its numbers are counted by the velocities of both."""
        for i, numbers in enumerate(both):
            own, other = self.names[i], self.names[1 - i]
            counted = {"how": how.format(own=own, other=other)} if how else {}
            yield of.of(own, wheel=own, **counted).column(_filled(numbers, like))

    def shifts(self, of: Course) -> Iterator[Column]:
        p = of.pair
        yield from self._each(Along.x, (p.x1, p.x2), p.x1)

    def distances(self, of: Course) -> Iterator[Column]:
        p = of.pair
        yield Along.a_w.column(_filled(p.a_w, p.x1))
        yield Along.alpha_w.column(_filled(np.degrees(p.alpha_w), p.x1))
        yield Along.x_sum.column(_filled(p.x_sum, p.x1))

    def measures(self, of: Course) -> Iterator[Column]:
        p, one = of.pair, self.names[0]
        yield Along.eps.column(_filled(p.eps, p.x1))
        yield from self._each(Along.tip, of.tips, p.x1)
        yield from self._each(Along.play, p.interference, p.x1)
        for declared, both in ((Along.lambda_p, of.root_sliding), (Along.lambda_a, of.tip_sliding)):
            yield from self._each(declared, both, p.x1, how=COUNTED[of.by])
        pole, low, high = of.pressures
        yield Along.gamma_w.column(_filled(pole, p.x1))
        yield Along.gamma_p.of(one, wheel=one).column(_filled(low, p.x1))
        yield Along.gamma_a.of(one, wheel=one).column(_filled(high, p.x1))

    def bounds(self, of: Found) -> Iterator[Column]:
        """Every end that a limit sets to the shift of wheel 1."""
        rows = [
            (one.limit, side, x)
            for one in of.alone
            for side, x in (("from", one.low), ("to", one.high))
            if math.isfinite(x)
        ]
        wheels = [self.names[limit.wheel - 1] if limit.wheel else "" for limit, _, _ in rows]
        yield text_column("limit", Message(N_("name of the limit")), [limit.kind for limit, _, _ in rows])
        yield text_column("wheel", Message(N_("number of the wheel")), wheels)
        yield text_column(
            "side", Message(N_("from: a least shift, to: a greatest")), [side for _, side, _ in rows]
        )
        one = self.names[0]
        yield Along.x.of(one, wheel=one).column([x for _, _, x in rows])


def _filled(numbers: Any, like: Any) -> list[float]:
    """As many numbers as there are rows; what is not finite is nan."""
    found = np.broadcast_to(np.asarray(numbers, float), np.shape(like))
    return [float(x) if math.isfinite(x) else math.nan for x in found]
