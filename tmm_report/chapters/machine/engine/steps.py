"""The numbers of a cylinder and of its counterweight, each assigned the expression that the note prints."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.machine.engine.given import Given
from tmm_report.chapters.machine.engine.values import Values
from tmm_report.quantity.formula import Expr

if TYPE_CHECKING:
    from tmm_report.chapters.machine.engine.solve import Found


def cylinder(s: Values, given: Given) -> None:
    """Its masses, the rod's split between the pins, and its sizes."""
    s.count = len(given.laid)
    s.r, s.l, s.omega = given.crank_radius, given.rod_length, given.speed
    s.m_piston = given.reciprocating
    s.m_crank = given.rotating or None
    if given.rod is not None:
        s.m_rod, s.a = given.rod.mass, given.rod.centre
        s.m = s.m_piston + s.m_rod * s.a / s.l
        lower = s.m_rod * (s.l - s.a) / s.l
        s.m_rot = s.m_crank + lower if given.rotating else lower
    else:
        s.m = given.reciprocating
        s.m_rot = given.rotating or None
    s.lam = s.r / s.l
    s.unit = s.m * s.r * s.omega**2


def counterweight(s: Values, given: Given) -> None:
    """Share, mass and radius: two are stated, the third follows."""
    of = given.counterweights
    if of is None:
        return
    s.share, s.m_cw, s.r_cw = of.share, of.mass, of.radius
    if of.share is None:
        product: Expr = s.m_cw * s.r_cw / s.r
        s.share = (product - s.m_rot if s.get("m_rot") else product) / s.m
        s.hammer = s.share * s.unit
        return
    s.hammer = s.share * s.unit
    masses: Expr = s.share * s.m
    product = (s.m_rot + masses if s.get("m_rot") else masses) * s.r
    if of.mass is None:
        s.m_cw = product / s.r_cw
    else:
        s.r_cw = product / s.m_cw


def left(s: Values, found: Found) -> None:
    """Of order 1 with all that turns, where all cylinders have one direction: along it and across it."""
    if not found.in_line:
        return
    axis = 1j * np.exp(1j * found.banks[0])
    force, couple = found.primary
    s.F_along, s.F_across = (float(force.along(one)) for one in (axis, 1j * axis))
    s.M_along, s.M_across = (float(couple.along(one)) for one in (axis, 1j * axis))
