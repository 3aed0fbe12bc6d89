"""Friction wheels: diameters, ratio with slip, distance; at work the force that presses them together."""

from __future__ import annotations

import math

from tmm_report.chapters.gears.ordinary.given import FrictionStage
from tmm_report.chapters.gears.ordinary.steps.common import is_plane, kept
from tmm_report.chapters.gears.ordinary.values import Friction
from tmm_report.mechanics.gears import trains
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.formula import cos, sin
from tmm_report.quantity.functions import arctan


def geometry(s: Friction, of: FrictionStage) -> None:
    """Raises ProblemError for a wheel that does not fit into its ring."""
    s.epsilon, s.u_required = of.slip or None, of.ratio
    if of.driving is None:
        s.d2 = of.driven
        s.d1 = s.d2 / kept(abs(s.u_required), s)
    else:
        s.d1 = of.driving
        s.d2 = kept(s.d1 * abs(s.u_required), s) if of.driven is None else of.driven
    turned = s.d2 / kept(s.d1, s)
    s.u = turned if of.sense > 0 else -turned
    if of.contact == "bevel":
        _cones(s, of)
        return
    one, two = s.number("d1"), s.number("d2")
    if of.sense > 0 and abs(two - one) < 1e-3 * two:
        wrong = N_("a wheel of %(one)s mm does not run within a ring of %(two)s mm")
        right = Message(N_("diameters that differ, or contact: external"))
        values = {"one": f"{1e3 * one:.5g}", "two": f"{1e3 * two:.5g}"}
        raise ProblemError([mistake(wrong, ("contact",), right, **values)])
    reach = s.d1 + s.d2 if of.sense < 0 else s.d2 - s.d1 if two > one else s.d1 - s.d2
    s.a = reach / 2


def _cones(s: Friction, of: FrictionStage) -> None:
    """Two cones with one apex, by their mean diameters."""
    angle = math.pi / 2 if of.shaft_angle is None else of.shaft_angle
    if is_plane(angle, s.number("d2") / s.number("d1")):
        wrong = N_("at an angle of %(angle)s° between the axes one of these cones is a plate")
        right = Message(N_("another shaft_angle, or diameters that differ less"))
        raise ProblemError([mistake(wrong, ("shaft_angle",), right, angle=f"{math.degrees(angle):.4g}")])
    s.sigma = math.degrees(angle)
    s.delta1 = arctan(sin(s.sigma) / (s.d2 / s.d1 + cos(s.sigma)))
    s.delta2 = s.sigma - s.delta1


def members(s: Friction, of: FrictionStage) -> tuple[trains.Member, ...]:
    sizes = s.number("d1"), s.number("d2")
    ring = max(sizes) if of.sense > 0 else 0.0
    places = 0.0, sum(sizes) / 2 if of.contact == "bevel" else s.number("a")  # of cones: unfolded
    return tuple(
        trains.Member(name, "ring" if size == ring else "wheel", radius=size / 2, distance=place)
        for name, size, place in zip(of.wheels, sizes, places, strict=True)
    )


def meshes(s: Friction, of: FrictionStage) -> tuple[trains.Mesh, ...]:
    one, two = of.wheels
    return (
        trains.Mesh(
            one, two, "", of.sense > 0, of.eta, size=abs(s.number("u")), crosses=of.contact == "bevel"
        ),
    )


def work(s: Friction, of: FrictionStage, speed: float, torque: float | None) -> None:
    """`speed`: of the driving wheel, rad/s; `torque`: on it, N·m, None: not known."""
    s.omega1 = abs(speed)
    s.v = s.omega1 * s.d1 / 2
    if of.slip:
        s.v_slip = s.v * s.epsilon
    if torque is None:
        return
    s.T1 = abs(torque)
    s.F_t = 2 * s.T1 / s.d1
    if not of.coefficient:
        return
    s.f, s.k = of.coefficient, of.reserve
    s.F_n = s.k * s.F_t / s.f
    if of.contact == "bevel":
        s.F_a1 = s.F_n * sin(s.delta1)
        s.F_a2 = s.F_n * sin(s.delta2)
    if of.width is not None:
        s.b = of.width
        s.q_n = s.F_n / s.b
