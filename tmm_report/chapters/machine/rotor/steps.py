"""The single numbers of a rotor, each assigned the expression that the note prints."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from operator import add
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.machine.rotor.quantities import table
from tmm_report.mechanics.masses import rotor
from tmm_report.quantity.formula import Expr, Page, Piece, arccos, cos, sin, sqrt
from tmm_report.quantity.sheet import Computed
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.machine.rotor.solve import Found


@dataclass(frozen=True, eq=False)
class FullTurn(Expr):
    """The 360° of the formula itself."""

    def evaluate(self, digits: int | None = None) -> float:
        return 2 * np.pi

    def piece(self, page: Page) -> Piece:
        return page.number(2 * np.pi, 10, degrees=True)


def degrees(vector: complex) -> float:
    """The direction of a vector, 0 … 360."""
    return float(np.degrees(np.angle(vector))) % 360.0


def unbalance(found: Found) -> None:
    """Sums of the unbalances and of their moments about plane I; what is nothing but rounding is nought."""
    s, masses, heavy = found.s, table(found, "masses"), found.given.heavy
    pulling = [k for k, one in enumerate(heavy) if one.product]
    skewed = [k for k, one in enumerate(heavy) if one.couple]
    turns = {"x": cos, "y": sin}
    forces = {
        axis: [masses.var("D", k) * turn(masses.var("alpha", k)) for k in pulling]
        for axis, turn in turns.items()
    }
    moments = {
        axis: [
            masses.var("D", k) * masses.var("l", k) * turn(masses.var("alpha", k))
            for k in pulling
            if masses["l"].values[k]
        ]
        + [masses.var(f"J_{axis}z", k) for k in skewed]
        for axis, turn in turns.items()
    }
    s.D_x = _sum(forces["x"], found.resultant.real, found.size)
    s.D_y = _sum(forces["y"], found.resultant.imag, found.size)
    s.D = sqrt(s.D_x**2 + s.D_y**2)
    s.alpha = _direction(found)
    s.M_x = _sum(moments["x"], found.moment.real, found.size * found.length)
    s.M_y = _sum(moments["y"], found.moment.imag, found.size * found.length)
    s.M = sqrt(s.M_x**2 + s.M_y**2)


def _sum(terms: Sequence[Expr], number: float, scale: float) -> Computed | float:
    return Computed(reduce(add, terms), number, scale) if terms else number


def _direction(found: Found) -> Computed | float:
    """Of the sum from x; of what is nothing none is written."""
    if not found.pulls:
        return 0.0
    turned = arccos(found.s.D_x / found.s.D)
    upwards = found.resultant.imag >= 0
    return Computed(turned if upwards else FullTurn() - turned, degrees(found.resultant))


def shaft(found: Found) -> None:
    """Its lengths, speed and mass, and what of them limits the unbalance."""
    s, given = found.s, found.given
    if found.two:
        s.L = found.corrections[1].at - found.corrections[0].at
    if given.bearings:
        s.L_AB = given.bearings[1] - given.bearings[0]
    s.omega = given.speed or None
    s.mass, s.centre = given.mass or found.summed_mass, found.centre
    if "mass" in s:
        s.e = s.D / s.mass
    if "mass" in s and given.grade and given.speed:
        s.G = given.grade
        s.D_per = s.mass * s.G / (1000 * s.omega)
    if given.width and given.diameter:
        s.ratio = given.width / given.diameter
        s.one_plane = rotor.one_plane_up_to(s.number("ratio"))


def polygons(found: Found) -> None:
    """What is read off them."""
    s, couple, force = found.s, found.couple, found.force
    s.mu_D, s.closing_D, s.read_D = force.scale, abs(force.closing), degrees(force.closing)
    if couple is not None:
        s.mu_M, s.closing_M, s.read_M = couple.scale, abs(couple.closing), degrees(couple.closing)
        s.laid_II = float(force.lengths[-1])


def left(found: Found) -> None:
    """What the weights leave, as they are made and exact."""
    s = found.s
    s.left_D, s.left_M = map(abs, found.left)
    s.uneven = found.uneven
    if found.given.bearings:
        s.disagreement = found.disagreement
