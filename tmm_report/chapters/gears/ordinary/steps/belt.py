"""A belt drive: diameters, ratio with slip, length or distance, angles of wrap; at work its velocity and tensions."""

from __future__ import annotations

import math

from tmm_report.chapters.gears.ordinary.given import STANDARD, BeltStage
from tmm_report.chapters.gears.ordinary.steps.common import kept
from tmm_report.chapters.gears.ordinary.values import Belt
from tmm_report.mechanics.gears import belts, trains
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.formula import PI, Expr, cos, sin, sqrt
from tmm_report.quantity.functions import arcsin, exp
from tmm_report.quantity.sheet import Computed

GROOVE = math.radians(40)


def geometry(s: Belt, of: BeltStage) -> None:
    """Raises ProblemError for pulleys that meet, and for a belt that is too short."""
    s.epsilon, s.u_required = of.slip or None, of.ratio
    _diameters(s, of)
    turned = s.d2 / kept(s.d1, s)
    s.u = -turned if of.crossed else turned
    _lengths(s, of)


def _diameters(s: Belt, of: BeltStage) -> None:
    if of.driving is None:
        assert isinstance(of.driven, float)  # else the record is refused
        s.d2 = of.driven
        s.d1 = s.d2 / kept(abs(s.u_required), s)
        return
    s.d1 = of.driving
    if isinstance(of.driven, float):
        s.d2 = of.driven
    elif of.driven == STANDARD:
        s.d_exact = kept(s.d1 * abs(s.u_required), s)
        s.d2 = belts.preferred(s.number("d_exact"))
    else:
        s.d2 = kept(s.d1 * abs(s.u_required), s)


def _lengths(s: Belt, of: BeltStage) -> None:
    one, two = s.number("d1"), s.number("d2")
    rule = (1.0 if of.belt == "V" else 1.5) * (one + two)
    stated = of.distance if of.distance is not None or isinstance(of.length, float) else rule
    _check(one, two, stated, of)
    exact = of.length if isinstance(of.length, float) else None
    if of.length == STANDARD and stated is not None:
        s.a_about = stated
        reach = s.d1 + s.d2 if of.crossed else s.d2 - s.d1
        s.L_about = 2 * s.a_about + PI / 2 * (s.d1 + s.d2) + reach**2 / (4 * s.a_about)
        exact = belts.preferred(s.number("L_about"))
    found = stated if exact is None else belts.distance(one, two, exact, of.crossed)
    if found is None or math.isnan(found):
        raise ProblemError([_short(one, two, of, exact)])
    s.a = found
    reach = s.d1 + s.d2 if of.crossed else s.d2 - s.d1
    s.theta = arcsin(reach / (2 * s.a))
    s.alpha1 = PI + 2 * s.theta if of.crossed else PI - 2 * s.theta
    s.alpha2 = PI + 2 * s.theta
    s.L = Computed(2 * s.a * cos(s.theta) + (s.alpha1 * s.d1 + s.alpha2 * s.d2) / 2, exact)


def _check(one: float, two: float, stated: float | None, of: BeltStage) -> None:
    """The distance is stated once, and the pulleys do not meet."""
    problems: list[Problem] = []
    if isinstance(of.length, float) and of.distance is not None:
        wrong = N_("the centre distance and the length of the belt are both stated")
        problems.append(mistake(wrong, ("length",), Message(N_("one of them, or length: standard"))))
    least = (one + two) / 2
    if stated is not None and stated <= least:
        wrong = N_("at a distance of %(distance)s mm the pulleys meet")
        right = Message(N_("a centre distance above %(least)s mm"), {"least": f"{1e3 * least:.5g}"})
        problems.append(mistake(wrong, ("distance",), right, distance=f"{1e3 * stated:.5g}"))
    if problems:
        raise ProblemError(problems)


def _short(one: float, two: float, of: BeltStage, exact: float | None) -> Problem:
    least = belts.length(one, two, (one + two) / 2, of.crossed)
    wrong = N_("a belt of %(length)s mm is too short for the pulleys")
    right = Message(
        N_("a belt longer than %(least)s mm, or smaller pulleys"), {"least": f"{1e3 * least:.5g}"}
    )
    return mistake(wrong, ("length",), right, length=f"{1e3 * (exact or 0):.5g}")


def members(s: Belt, of: BeltStage) -> tuple[trains.Member, ...]:
    one, two = of.wheels
    return (
        trains.Member(one, "wheel", radius=s.number("d1") / 2),
        trains.Member(two, "wheel", radius=s.number("d2") / 2, distance=s.number("a")),
    )


def meshes(s: Belt, of: BeltStage) -> tuple[trains.Mesh, ...]:
    one, two = of.wheels
    return (trains.Mesh(one, two, "", of.sense > 0, of.eta, size=abs(s.number("u")), apart=True),)


def work(s: Belt, of: BeltStage, speed: float, torque: float | None) -> None:
    """`speed`: of the driving pulley, rad/s; `torque`: on it, N·m, None: not known."""
    s.omega1 = abs(speed)
    s.v = s.omega1 * s.d1 / 2
    s.runs = s.v / s.L
    if torque is None:
        return
    s.T1 = abs(torque)
    s.F_t = 2 * s.T1 / s.d1
    if of.coefficient:
        _tensions(s, of)


def _tensions(s: Belt, of: BeltStage) -> None:
    """By Euler on the pulley that is wrapped less, where the belt begins to slip."""
    s.f = of.coefficient
    if of.belt == "V":
        s.phi = math.degrees(GROOVE if of.groove is None else of.groove)
        s.f_red = s.f / sin(s.phi / 2)
    rough = s.f_red if of.belt == "V" else s.f
    wrap = s.alpha1 if s.number("alpha1") <= s.number("alpha2") else s.alpha2
    s.m = exp(rough * wrap)
    force: Expr = s.F_t
    if of.reserve > 1:
        s.k = of.reserve
        force = s.k * s.F_t
    s.F_0 = force / 2 * ((s.m + 1) / (s.m - 1))
    s.F_tight = s.F_0 + s.F_t / 2
    s.F_slack = s.F_0 - s.F_t / 2
    if of.mass is not None:
        s.q = of.mass
        s.F_c = s.q * s.v**2
        s.F_put = s.F_0 + s.F_c
    s.F_shaft = sqrt(s.F_tight**2 + s.F_slack**2 + 2 * s.F_tight * s.F_slack * cos(2 * s.theta))
