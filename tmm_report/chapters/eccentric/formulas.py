"""Formulas of the eccentric epicyclic mechanism: in symbols, in numbers, with their value; lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tmm_report.chapters.eccentric.solve import RING, SUN, Found, Satellite
from tmm_report.mechanics import eccentric as ecc
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Formula, Number, Page, Piece, Var, arccos, cos, sin, sqrt, tan
from tmm_report.quantity.gear_terms import HA
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation

FIRST, SECOND = Symbol("z", "1", "0"), Symbol("z", "2", "0")
GAP = "Delta"


@dataclass(frozen=True, eq=False)
class Degrees(Expr):
    """An exact angle of the formula itself, as the 360° of φ/360°."""

    degrees: int

    def evaluate(self, digits: int | None = None) -> float:
        return math.radians(self.degrees)

    def piece(self, page: Page) -> Piece:
        return page.number(math.radians(self.degrees), 10, degrees=True)


def teeth(wheel: str, z: int) -> Var:
    return Var(Symbol("z", wheel), z, digits=9)


class EccentricFormulas:
    def __init__(self, found: Found):
        self.found = found
        given = found.given
        self.u = Var("u", float(found.ratio_of_teeth))
        self.m = Var("m", 1e3 * given.module, "mm")
        self.e = Var("e", 1e3 * found.e, "mm")
        self.E = Var("E", found.E, digits=9)
        self.ha = Var(HA, given.rack.ha)
        self.z1, self.z3 = teeth(SUN, found.sun), teeth(RING, found.ring)

    def z(self, s: Satellite) -> Var:
        return teeth(s.wheel, s.teeth)

    # ------------------------------------------------------------ teeth

    def halves(self) -> Formula:
        return Formula("E", 2 * self.e / self.m, digits=9)

    def general(self) -> Equation:
        """(1 − u) k z1 + 2 k z2 − E k = 0."""
        u, k, z1, z2, E = (Var(key, 0.0) for key in ("u", "k", "z_1", "z_2", "E"))
        return Equation((1 - u) * k * z1 + 2 * k * z2 - E * k, numbers=False)

    def whole(self) -> Equation:
        eq = self.found.equation
        first, second = Var("z_1", 0.0), Var("z_2", 0.0)
        terms = -first if eq.a == -1 else Number(eq.a) * first
        return Equation(terms + Number(eq.b) * second - Number(-eq.c), numbers=False)

    def coefficients(self) -> Iterator[Formula]:
        eq = self.found.equation
        k = Var("k", eq.k)
        yield Formula("a", (1 - self.u) * k, digits=9)
        yield Formula("b", 2 * k, digits=9)
        yield Formula("c", -(self.E * k), digits=9)

    def euclid(self) -> Formula:
        eq, found = self.found.equation, self.found.solution
        a, b = Var("a", eq.a, digits=9), Var("b", eq.b, digits=9)
        return Formula("d", a * Var("x", found.x, digits=9) + b * Var("y", found.y, digits=9), digits=9)

    def particular(self) -> Iterator[Formula]:
        eq, found = self.found.equation, self.found.solution
        c, d = Var("c", eq.c, digits=9), Var("d", found.divisor, digits=9)
        yield Formula(FIRST, -(c / d) * Var("x", found.x, digits=9), digits=9)
        yield Formula(SECOND, -(c / d) * Var("y", found.y, digits=9), digits=9)

    def divided(self) -> Iterator[Formula]:
        eq, d = self.found.equation, Var("d", self.found.solution.divisor, digits=9)
        yield Formula("a_1", Var("a", eq.a, digits=9) / d, digits=9)
        yield Formula("b_1", Var("b", eq.b, digits=9) / d, digits=9)

    def all_first(self) -> Definition:
        first, b, t = Var(FIRST, 0.0), Var("b_1", 0.0), Var("t", 0.0)
        return Definition("z_1", first - b * t)

    def all_second(self) -> Definition:
        second, a, t = Var(SECOND, 0.0), Var("a_1", 0.0), Var("t", 0.0)
        return Definition("z_2", second + a * t)

    def ring_teeth(self) -> Definition:
        return Definition("z_3", Var("u", 0.0) * Var("z_1", 0.0))

    def middle_teeth(self) -> Definition:
        return Definition("z_4", (Var("z_3", 0.0) - Var("z_1", 0.0)) / 2)

    def smallest_teeth(self) -> Definition:
        return Definition("z_5", Var("z_2", 0.0) - Var("E", 0.0))

    def chosen(self) -> Iterator[Formula]:
        """Teeth of the chosen set from its t."""
        found, t = self.found.solution, Var("t", self.found.t, digits=9)
        one, two = Var(FIRST, found.first, digits=9), Var(SECOND, found.second, digits=9)
        b1 = Var("b_1", found.b1, digits=9)
        a1 = Var("a_1", found.a1, digits=9)
        z2 = Var("z_2", self.found.largest, digits=9)
        yield Formula("z_1", one - b1 * t, digits=9)
        yield Formula("z_2", two + a1 * t, digits=9)
        yield Formula("z_3", self.u * self.z1, digits=9)
        if (self.found.ring - self.found.sun) % 2 == 0:
            yield Formula("z_4", (self.z3 - self.z1) / 2, digits=9)
        yield Formula("z_5", z2 - self.E, digits=9)

    # ------------------------------------------------------------ places

    def angle1(self, s: Satellite) -> Formula:
        z, E = self.z(s), self.E
        over = (self.z1 + z) ** 2 + E**2 - (self.z3 - z) ** 2
        return Formula(self.phi(s, 1).sign, arccos(over / (2 * E * (self.z1 + z))), "deg", digits=6)

    def angle3(self, s: Satellite) -> Formula:
        z, E = self.z(s), self.E
        over = (self.z1 + z) ** 2 - (self.z3 - z) ** 2 - E**2
        return Formula(self.phi(s, 3).sign, arccos(over / (2 * E * (self.z3 - z))), "deg", digits=6)

    def phi(self, s: Satellite, about: int) -> Var:
        angle = s.phi1 if about == 1 else s.phi3
        return Var(Symbol("phi", f"{about},{s.wheel}"), angle, "deg", 6)

    # ------------------------------------------------------------ conditions

    def belt(self, s: Satellite) -> Formula:
        """L = z2/2 + z1 φ1/360 + z3 φ3/360 + z/2 (1 − (φ3 − φ1)/180), the angles in degrees."""
        z2 = Var("z_2", self.found.largest, digits=9)
        one, three = self.phi(s, 1), self.phi(s, 3)
        full, half = Degrees(360), Degrees(180)
        total = z2 / 2 + self.z1 * one / full + self.z3 * three / full
        total = total + self.z(s) / 2 * (1 - (three - one) / half)
        return Formula(Symbol("L", s.wheel), total, digits=7)

    def distance(self, one: Satellite, other: Satellite) -> Formula:
        near, far = self._arm(one), self._arm(other)
        angle = self.phi(one, 1) - self.phi(other, 1) if one.phi1 else self.phi(other, 1)
        return Formula(
            Symbol("l", f"{one.wheel},{other.wheel}"),
            sqrt(near**2 + far**2 - 2 * near * far * cos(angle)),
            "mm",
            digits=6,
        )

    def arm(self, s: Satellite) -> Formula:
        """The distance of a satellite's axis from that of the sun, m (z1 + z)/2."""
        return Formula(self._arm(s).sign, self.m * (self.z1 + self.z(s)) / 2, "mm", digits=6)

    def _arm(self, s: Satellite) -> Var:
        return Var(Symbol("l", s.wheel), 5e2 * self.found.given.module * (self.found.sun + s.teeth), "mm", 6)

    def gap(self, one: Satellite, other: Satellite) -> Formula:
        """What is left of the distance: l − m (z_i + z_j)/2 − 2 ha* m."""
        apart = self.distance(one, other)
        index = f"{one.wheel},{other.wheel}"
        l = Var(Symbol("l", index), float(apart.value), "mm", 6)
        rest = l - self.m * (self.z(one) + self.z(other)) / 2 - 2 * self.ha * self.m
        return Formula(Symbol(GAP, index), rest, "mm", digits=4, scale=1e3 * self.found.given.module)

    def closed(self) -> Formula:
        """The same for the largest and a middle satellite in closed form."""
        found = self.found
        r1, r3 = (
            Var(f"r_{k}", 5e2 * found.given.module * z, "mm", 6) for k, z in ((1, found.sun), (3, found.ring))
        )
        root = sqrt((r1 + r3) ** 2 / 2 - self.e**2 / 4)
        rest = root - (r3 - r1) - self.e / 2 - 2 * self.ha * self.m
        return Formula(Symbol(GAP, "2,4"), rest, "mm", digits=4, scale=1e3 * found.given.module)

    def tips(self) -> Formula:
        return Formula(
            Symbol(GAP, "1,3"), self.m * (self.z3 - self.z1) / 2 - self.e - 2 * self.ha * self.m, "mm"
        )

    def least_teeth(self) -> Formula:
        alpha = Var("alpha", self.found.given.rack.alpha, "deg")
        return Formula("z_min", 2 * self.ha / sin(alpha) ** 2)

    # ------------------------------------------------------------ interference in the ring

    def tip_angle(self) -> Formula:
        """Profile angle at the tips of the ring of full height."""
        alpha = Var("alpha", self.found.given.rack.alpha, "deg")
        return Formula("alpha_a3", arccos(self.z3 * cos(alpha) / (self.z3 - 2 * self.ha)), "deg", digits=6)

    def root(self, s: Satellite) -> Formula:
        """Radius of curvature of the satellite where the ring's tip touches it."""
        alpha, tip = Var("alpha", self.found.given.rack.alpha, "deg"), self.tip_angle()
        at_tip = Var("alpha_a3", float(tip.value), "deg", 6)
        z = self.z(s)
        line = self.m / 2 * (self.z3 * cos(alpha) * tan(at_tip) - (self.z3 - z) * sin(alpha))
        return Formula(Symbol("rho", s.wheel), line, "mm")

    def cut_down(self) -> float:
        """By how much the ring's tips are cut down to keep clear of the satellites' fillets, m."""
        given = self.found.given
        full = given.module * (self.found.ring / 2 - given.rack.ha)
        z = np.array([s.teeth for s in self.found.satellites])
        return ecc.ring_tip(self.found.ring, z, given.module, given.rack) - full

    # ------------------------------------------------------------ kinematics

    def ratio(self) -> Formula:
        return Formula(Symbol("u", "13", "H"), -(self.z3 / self.z1))

    def other_ratios(self) -> Iterator[Formula]:
        u = Var(Symbol("u", "13", "H"), self.found.ratio)
        yield Formula(Symbol("u", "1H", "3"), 1 - u)
        yield Formula(Symbol("u", "3H", "1"), 1 - 1 / u)
