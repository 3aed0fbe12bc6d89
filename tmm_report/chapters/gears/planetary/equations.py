"""What of a planetary stage is set against one another, and its efficiency; lengths in mm."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.gears.planetary.relation import Relation, Side
from tmm_report.chapters.gears.planetary.steps import Stage
from tmm_report.mechanics.gears.planetary.stage import ROWS
from tmm_report.quantity.formula import Expr, Var, sin, sqrt
from tmm_report.quantity.ref import Ref

HALF_TURN = Var("pi", np.pi, "deg", ref=Ref("pi", unit="deg"))


def coaxiality(of: Stage) -> Relation:
    """Of one module by the teeth, else by the centre distances."""
    sums = [of.teeth_sum(row) for row in (0, 1)]
    if of.given.one_module:
        left, right = (Side(total, mesh["z_sum"].ref()) for total, mesh in zip(sums, of.meshes, strict=True))
        return Relation(left, _equal(of), right)
    distances = (of.m(row) * total / 2 for row, total in enumerate(sums))
    left, right = (Side(a, mesh["a"].ref("mm")) for a, mesh in zip(distances, of.meshes, strict=True))
    return Relation(left, _equal(of), right, "mm")


def _equal(of: Stage) -> str:
    if of.found.coaxial:
        return "="
    return "<" if of.sizes.pitch_distances[0] < of.sizes.pitch_distances[1] else ">"


def ring_tip(of: Stage, row: int) -> Relation:
    """The ring's tip beyond the limit point of the line of action."""
    ring, mesh = of.w(ROWS[row][0]), of.meshes[row]
    curvature = Side(sqrt(ring.d_a_full**2 - ring.d_b**2) / 2, mesh["rho_a"].ref("mm"))
    return Relation(curvature, ">", Side(of.s.a_w * sin(mesh.alpha_w), mesh["line"].ref("mm")), "mm")


def neighbourhood(of: Stage) -> Relation:
    tip = of.w(of.largest_crown).d_a
    apart = Side(2 * of.s.a_w * sin(HALF_TURN / of.s.k), of.s["apart"].ref("mm"))
    assert tip.ref is not None
    return Relation(apart, ">", Side(tip, tip.ref), "mm")


def efficiency(of: Stage) -> Expr:
    """By the way of the power: u η_H or u/η_H in the place of u."""
    eta, u = of.s.eta_stopped, of.basic()
    lossy = u * eta if of.found.motion.exponent > 0 else u / eta
    return {
        ("wheel1", "carrier"): (1 - lossy) / (1 - u),
        ("carrier", "wheel1"): (1 - u) / (1 - lossy),
        ("wheel3", "carrier"): (1 - 1 / lossy) / (1 - 1 / u),
        ("carrier", "wheel3"): (1 - 1 / u) / (1 - 1 / lossy),
    }.get((of.task.input, of.task.output), eta)


def deviation(of: Stage) -> Expr:
    found, wanted = of.s["u"].var(digits=5), of.s["u_wanted"].var(digits=5)
    return (found - wanted) / wanted * 100
