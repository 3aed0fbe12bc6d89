"""Bevel wheels by their pitch cones: angles, cone distances, diameters; at work the forces at the mean diameter."""

from __future__ import annotations

import math

from tmm_report.chapters.gears.ordinary.given import BevelStage
from tmm_report.chapters.gears.ordinary.steps.common import is_plane
from tmm_report.chapters.gears.ordinary.values import Bevel
from tmm_report.mechanics.gears import trains
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.formula import cos, sin, tan
from tmm_report.quantity.functions import arctan

USUAL = 0.285  # width of the teeth by the cone distance
WIDEST = 0.5


def geometry(s: Bevel, of: BevelStage) -> None:
    """Raises ProblemError for a crown wheel and for teeth that reach too far to the apex."""
    s.u_required, s.z1, s.sigma = of.ratio, float(of.z[0]), math.degrees(of.shaft_angle)
    if not isinstance(of.teeth, tuple):
        s.z_exact = s.z1 * abs(s.u_required)
    s.z2 = float(of.z[1])
    s.u = -(s.z2 / s.z1)
    _cones(s, of)
    if of.module is not None:
        s.m_e = of.module
        s.R_e = s.m_e * s.z1 / (2 * sin(s.delta1))
        _width(s, of)
        s.R_m = s.R_e - s.b / 2
        s.m_m = s.m_e * s.R_m / s.R_e
    else:
        s.m_m = of.mean_module
        s.R_m = s.m_m * s.z1 / (2 * sin(s.delta1))
        if of.width is None:
            s.psi = USUAL
            s.R_e = s.R_m / (1 - s.psi / 2)
            s.b = s.psi * s.R_e
        else:
            s.b = of.width
            s.R_e = s.R_m + s.b / 2
        _narrow(s)
        s.m_e = s.m_m * s.R_e / s.R_m
    for one, z, delta in (("1", s.z1, s.delta1), ("2", s.z2, s.delta2)):
        s.put(f"d_e{one}", s.m_e * z)
        s.put(f"d_m{one}", s.m_m * z)
        s.put(f"z_v{one}", z / cos(delta))
    s.alpha = math.degrees(of.alpha)


def _cones(s: Bevel, of: BevelStage) -> None:
    one, two = of.z
    if is_plane(of.shaft_angle, two / one):
        wrong = N_("at an angle of %(angle)s° between the axes one of these wheels is a crown wheel")
        right = Message(N_("another shaft_angle, or numbers of teeth that differ less"))
        raise ProblemError(
            [mistake(wrong, ("shaft_angle",), right, angle=f"{math.degrees(of.shaft_angle):.4g}")]
        )
    square = abs(of.shaft_angle - math.pi / 2) < 1e-12
    cone = arctan(s.z1 / s.z2) if square else arctan(sin(s.sigma) / (s.z2 / s.z1 + cos(s.sigma)))
    s.delta1 = cone
    s.delta2 = s.sigma - s.delta1


def _width(s: Bevel, of: BevelStage) -> None:
    if of.width is None:
        s.psi = USUAL
        s.b = s.psi * s.R_e
    else:
        s.b = of.width
    _narrow(s)


def _narrow(s: Bevel) -> None:
    most = WIDEST * s.number("R_e")
    if s.number("b") >= most:
        wrong = N_("teeth %(width)s mm wide reach too near to the apex of the cones")
        right = Message(
            N_("a width below %(most)s mm, usually 0.285 of the cone distance"), {"most": f"{1e3 * most:.4g}"}
        )
        raise ProblemError([mistake(wrong, ("width",), right, width=f"{1e3 * s.number('b'):.4g}")])


def members(s: Bevel, of: BevelStage) -> tuple[trains.Member, ...]:
    """By the mean diameters, the axes unfolded into one plane."""
    one, two = s.number("d_m1") / 2, s.number("d_m2") / 2
    first, second = of.wheels
    return (
        trains.Member(first, "wheel", of.z[0], one),
        trains.Member(second, "wheel", of.z[1], two, one + two),
    )


def meshes(s: Bevel, of: BevelStage) -> tuple[trains.Mesh, ...]:
    one, two = of.wheels
    return (trains.Mesh(one, two, efficiency=of.eta, crosses=True),)


def work(s: Bevel, of: BevelStage, speed: float, torque: float | None) -> None:
    """`speed`: of the driving wheel, rad/s; `torque`: on it, N·m, None: not known."""
    s.omega1 = abs(speed)
    s.v = s.omega1 * s.d_m1 / 2
    if torque is None:
        return
    s.T1 = abs(torque)
    s.F_t = 2 * s.T1 / s.d_m1
    s.F_r1 = s.F_t * tan(s.alpha) * cos(s.delta1)
    s.F_a1 = s.F_t * tan(s.alpha) * sin(s.delta1)
    s.F_r2 = s.F_t * tan(s.alpha) * cos(s.delta2)
    s.F_a2 = s.F_t * tan(s.alpha) * sin(s.delta2)
