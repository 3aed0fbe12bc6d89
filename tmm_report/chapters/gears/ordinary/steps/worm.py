"""A worm and its wheel: lead angle, sizes, efficiency by the angle of friction, self-locking; sliding and forces."""

from __future__ import annotations

import math

from tmm_report.chapters.gears.ordinary.given import WormStage
from tmm_report.chapters.gears.ordinary.values import Worm
from tmm_report.mechanics.gears import trains
from tmm_report.quantity.formula import Expr, cos, tan
from tmm_report.quantity.functions import arctan


def geometry(s: Worm, of: WormStage) -> None:
    s.u_required, s.z1, s.m, s.q = of.ratio, float(of.starts), of.module, of.q
    if of.teeth is None:
        s.z_exact = s.z1 * abs(s.u_required)
    s.z2 = float(of.z[1])
    s.u = s.z2 / s.z1 if of.sense > 0 else -(s.z2 / s.z1)
    s.gamma = arctan(s.z1 / s.q)
    s.d1 = s.m * s.q
    s.d2 = s.m * s.z2
    s.a = s.m * (s.q + s.z2) / 2
    _losses(s, of)


def _losses(s: Worm, of: WormStage) -> None:
    """From the friction to the efficiency, or from the stated efficiency back to the friction."""
    s.k = of.splash if of.splash < 1 else None
    if of.efficiency is not None:
        s.eta = of.efficiency
        s.eta_mesh = _beside(s, of, s.eta)
        s.phi = arctan(tan(s.gamma) / s.eta_mesh) - s.gamma
    else:
        s.f = of.coefficient
        s.phi = arctan(s.f) if of.coefficient is not None else math.degrees(of.friction_angle or 0.0)
        s.eta_mesh = tan(s.gamma) / tan(s.gamma + s.phi)
        s.eta = s.k * s.eta_mesh if of.splash < 1 else s.eta_mesh
    if not locks(s):
        s.eta_back = tan(s.gamma - s.phi) / tan(s.gamma)


def _beside(s: Worm, of: WormStage, eta: Expr) -> Expr:
    """The efficiency of the mesh where that of the stage is stated."""
    return eta / s.k if of.splash < 1 else 1 * eta


def locks(s: Worm) -> bool:
    """Whether the wheel cannot drive the worm, however great its torque."""
    return s.number("gamma") <= s.number("phi")


def members(s: Worm, of: WormStage) -> tuple[trains.Member, ...]:
    """The wheel's axis unfolded till it is parallel to that of the worm."""
    one, two = of.wheels
    return (
        trains.Member(one, "wheel", of.starts, s.number("d1") / 2),
        trains.Member(two, "wheel", of.z[1], s.number("d2") / 2, s.number("a")),
    )


def meshes(s: Worm, of: WormStage) -> tuple[trains.Mesh, ...]:
    one, two = of.wheels
    return (trains.Mesh(one, two, "", of.sense > 0, s.number("eta"), size=of.z[1] / of.starts, crosses=True),)


def work(s: Worm, of: WormStage, speed: float, torque: float | None) -> None:
    """`speed`: of the worm, rad/s; `torque`: on it, N·m, None: not known."""
    s.omega1 = abs(speed)
    s.omega2 = s.omega1 / abs(s.u)
    s.v1 = s.omega1 * s.d1 / 2
    s.v2 = s.omega2 * s.d2 / 2
    s.v_slip = s.v1 / cos(s.gamma)
    if torque is None:
        return
    s.T1 = abs(torque)
    s.T2 = s.T1 * abs(s.u) * s.eta
    s.F_t2 = 2 * s.T2 / s.d2
    s.F_t1 = s.F_t2 * tan(s.gamma + s.phi)
    s.alpha = math.degrees(of.alpha)
    s.F_r = s.F_t2 * tan(s.alpha)
