"""Formulas of the eccentric epicyclic mechanism: in symbols, in numbers, with their value; lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.chapters.gears.eccentric.quantities.mechanism import book
from tmm_report.chapters.gears.eccentric.solve.mechanism import Found
from tmm_report.chapters.gears.eccentric.solve.satellites import Neighbours, Satellite
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Formula, Number, Page, Piece, Var, arccos, cos, sin, sqrt, tan
from tmm_report.quantity.model import Value
from tmm_report.quantity.part import Part
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation
from tmm_report.records import dataclass

FIRST, SECOND = Symbol("z", "1", "0"), Symbol("z", "2", "0")


@dataclass(frozen=True, eq=False)
class Degrees(Expr):
    """An exact angle of the formula itself, as the 360° of φ/360°."""

    degrees: int

    def evaluate(self, digits: int | None = None) -> float:
        return math.radians(self.degrees)

    def piece(self, page: Page) -> Piece:
        return page.number(math.radians(self.degrees), 10, degrees=True)


@dataclass(frozen=True, eq=False)
class Coefficient(Number):
    """A number of the results among the symbols of an equation, with all its digits."""

    ref: Ref | None = None

    def piece(self, page: Page) -> Piece:
        return page.number(float(self.number), 10, scale=0.0, ref=self.ref)


def coefficient(of: Value, size: bool = False) -> Coefficient:
    """`size`: without its sign, which stands before it."""
    return Coefficient(abs(of.value) if size else of.value, of.ref(size=size))


class EccentricFormulas:
    """What the template prints; `prefix`: of its names in the results."""

    def __init__(self, found: Found, prefix: str):
        self.found = found
        self.of = of = Part(prefix, book(found, prefix))
        self.family_of, self.satellites_of = of.table("family"), of.table("satellites")
        self.neighbours_of = of.table("neighbours")
        self.u, self.ha, self.alpha = of["u_teeth"].var(), of["ha"].var(), of["alpha"].var()
        self.m, self.e = of["m"].var("mm"), of["e"].var("mm")
        self.E, self.z1, self.z3 = self.whole("E"), self.whole("z1"), self.whole("z3")

    def whole(self, key: str) -> Var:
        """A whole number, with all its digits."""
        return self.of[key].var(digits=9)

    def of_set(self, key: str) -> Var:
        """A number of teeth of the chosen set."""
        return self.family_of.var(key, self.found.row, digits=9)

    def place(self, s: Satellite) -> int:
        """Its row among the satellites."""
        return self.found.satellites.index(s)

    def z(self, s: Satellite) -> Var:
        return self.satellites_of.var("z", self.place(s), digits=9)

    # ------------------------------------------------------------ teeth

    def halves(self) -> Formula:
        return self.of["E"].formula(2 * self.e / self.m, digits=9)

    def general(self) -> Equation:
        """(1 − u) k z1 + 2 k z2 − E k = 0, or (1 − u) k z1 + 2 k z4 = 0."""
        u, k, z1, z2, E = (Var(key, 0.0) for key in ("u", "k", "z_1", self.second, "E"))
        if self.found.halved:
            return Equation((1 - u) * k * z1 + 2 * k * z2, numbers=False)
        return Equation((1 - u) * k * z1 + 2 * k * z2 - E * k, numbers=False)

    def with_numbers(self) -> Equation:
        """The same with its coefficients; one of −1 is not written."""
        first, second = Var("z_1", 0.0), Var(self.second, 0.0)
        a, b, c = (self.of[f"equation_{name}"] for name in "abc")
        terms = -first if a.value == -1 else coefficient(a) * first
        terms = terms + coefficient(b) * second
        return Equation(terms if self.found.halved else terms - coefficient(c, size=True), numbers=False)

    @property
    def second(self) -> str:
        """The satellite of the equation."""
        return "z_4" if self.found.halved else "z_2"

    def coefficients(self) -> Iterator[Formula]:
        k = self.of["equation_k"].var()
        yield self.of["equation_a"].formula((1 - self.u) * k, digits=9)
        yield self.of["equation_b"].formula(2 * k, digits=9)
        if not self.found.halved:
            yield self.of["equation_c"].formula(-(self.E * k), digits=9)

    def euclid(self) -> Formula:
        a, b, x, y = (self.whole(key) for key in ("equation_a", "equation_b", "euclid_x", "euclid_y"))
        return self.of["divisor"].formula(a * x + b * y, digits=9)

    def particular(self) -> Iterator[Formula]:
        c, d = self.whole("equation_c"), self.whole("divisor")
        for key, factor in (("z1_0", "euclid_x"), ("z2_0", "euclid_y")):
            yield self.of[key].formula(-(c / d) * self.whole(factor), digits=9)

    def divided(self) -> Iterator[Formula]:
        for name in "ab":
            quotient = self.whole(f"equation_{name}") / self.whole("divisor")
            yield self.of[f"{name}_1"].formula(quotient, digits=9)

    def all_first(self) -> Definition:
        first, b, t = Var(FIRST, 0.0), Var("b_1", 0.0), Var("t", 0.0)
        return Definition("z_1", -(b * t) if self.found.halved else first - b * t)

    def all_second(self) -> Definition:
        second, a, t = Var(SECOND, 0.0), Var("a_1", 0.0), Var("t", 0.0)
        return Definition(self.second, a * t if self.found.halved else second + a * t)

    def ring_teeth(self) -> Definition:
        return Definition("z_3", Var("u", 0.0) * Var("z_1", 0.0))

    def middle_teeth(self) -> Definition:
        return Definition("z_4", (Var("z_3", 0.0) - Var("z_1", 0.0)) / 2)

    def smallest_teeth(self) -> Definition:
        return Definition("z_5", Var("z_2", 0.0) - Var("E", 0.0))

    def near_ratio(self) -> Definition:
        """By how much a set near the ratio misses it, relative."""
        u = Var("u", 0.0)
        return Definition("Delta_u", (Var("z_3", 0.0) / Var("z_1", 0.0) - u) / u)

    def near_largest(self) -> Definition:
        return Definition("z_2", (Var("z_3", 0.0) - Var("z_1", 0.0)) / 2 + Var("e", 0.0) / Var("m", 0.0))

    def chosen(self) -> Iterator[Formula]:
        """Teeth of the chosen set from its t."""
        row = self.found.row
        for key, expression in self._chosen().items():
            yield self.family_of.formula(key, row, expression, digits=9)

    def _chosen(self) -> dict[str, Expr]:
        t, ring = self.whole("t"), self.u * self.z1
        if self.found.halved:
            return {"z1": -(self.whole("b_1") * t), "z4": self.whole("a_1") * t, "z3": ring}
        teeth: dict[str, Expr] = {
            "z1": self.whole("z1_0") - self.whole("b_1") * t,
            "z2": self.whole("z2_0") + self.whole("a_1") * t,
            "z3": ring,
        }
        if (self.found.ring - self.found.sun) % 2 == 0:
            teeth["z4"] = (self.z3 - self.z1) / 2
        return teeth | {"z5": self.of_set("z2") - self.E}

    # ------------------------------------------------------------ places

    def angle1(self, s: Satellite) -> Formula:
        z, E = self.z(s), self.E
        over = (self.z1 + z) ** 2 + E**2 - (self.z3 - z) ** 2
        angle = arccos(over / (2 * E * (self.z1 + z)))
        return self.satellites_of.formula("phi1", self.place(s), angle, digits=6)

    def angle3(self, s: Satellite) -> Formula:
        z, E = self.z(s), self.E
        over = (self.z1 + z) ** 2 - (self.z3 - z) ** 2 - E**2
        angle = arccos(over / (2 * E * (self.z3 - z)))
        return self.satellites_of.formula("phi3", self.place(s), angle, digits=6)

    def phi(self, s: Satellite, about: int) -> Var:
        return self.satellites_of.var(f"phi{about}", self.place(s), digits=6)

    # ------------------------------------------------------------ conditions

    def belt(self, s: Satellite) -> Formula:
        """L = z2/2 + z1 φ1/360 + z3 φ3/360 + z/2 (1 − (φ3 − φ1)/180), the angles in degrees; −z3/2 in the place of z2/2
        where the line goes over a middle satellite."""
        one, three = self.phi(s, 1), self.phi(s, 3)
        full, half = Degrees(360), Degrees(180)
        total = self.z1 * one / full + self.z3 * three / full
        if not self.found.by_middle:
            total = self.of_set("z2") / 2 + self.z1 * one / full + self.z3 * three / full
        total = total + self.z(s) / 2 * (1 - (three - one) / half)
        if self.found.by_middle:
            total = total - self.z3 / 2
        return self.satellites_of.formula("L", self.place(s), total, digits=7)

    def arm(self, s: Satellite) -> Formula:
        """The distance of a satellite's axis from that of the sun, m (z1 + z)/2."""
        length = self.m * (self.z1 + self.z(s)) / 2
        return self.satellites_of.formula("l", self.place(s), length, "mm", digits=6)

    def _arm(self, s: Satellite) -> Var:
        return self.satellites_of.var("l", self.place(s), "mm", digits=6)

    def distance(self, pair: Neighbours) -> Formula:
        one, other = pair.one, pair.other
        near, far = self._arm(one), self._arm(other)
        angle = self.phi(one, 1) - self.phi(other, 1) if one.phi1 else self.phi(other, 1)
        length = sqrt(near**2 + far**2 - 2 * near * far * cos(angle))
        return self.neighbours_of.formula("l", self._row(pair), length, "mm", digits=6)

    def _row(self, pair: Neighbours) -> int:
        return [near.wheels for near in self.found.near].index(pair.wheels)

    def gap(self, pair: Neighbours) -> Formula:
        """What is left of the distance: l − m (z_i + z_j)/2 − 2 ha* m."""
        row = self._row(pair)
        l = self.neighbours_of.var("l", row, "mm", digits=6)
        rest = l - self.m * (self.z(pair.one) + self.z(pair.other)) / 2 - 2 * self.ha * self.m
        return self.neighbours_of.formula("gap", row, rest, "mm", digits=4, scale=self.m.number)

    def closed(self) -> Formula:
        """The same for the largest and a middle satellite in closed form."""
        r1, r3 = (self.of[key].var("mm", digits=6) for key in ("r_1", "r_3"))
        root = sqrt((r1 + r3) ** 2 / 2 - self.e**2 / 4)
        rest = root - (r3 - r1) - self.e / 2 - 2 * self.ha * self.m
        return self.of["gap_2_4"].formula(rest, "mm", digits=4, scale=self.m.number)

    def tips(self) -> Formula:
        rest = self.m * (self.z3 - self.z1) / 2 - self.e - 2 * self.ha * self.m
        return self.of["gap_1_3"].formula(rest, "mm")

    def least_teeth(self) -> Formula:
        return self.of["least_teeth"].formula(2 * self.ha / sin(self.alpha) ** 2)

    # ------------------------------------------------------------ interference in the ring

    def tip_angle(self) -> Formula:
        """Profile angle at the tips of the ring of full height."""
        angle = arccos(self.z3 * cos(self.alpha) / (self.z3 - 2 * self.ha))
        return self.of["alpha_a3"].formula(angle, digits=6)

    def root(self, s: Satellite) -> Formula:
        """Radius of curvature of the satellite where the ring's tip touches it."""
        at_tip, z = self.of["alpha_a3"].var(digits=6), self.z(s)
        line = self.m / 2 * (self.z3 * cos(self.alpha) * tan(at_tip) - (self.z3 - z) * sin(self.alpha))
        return self.satellites_of.formula("rho", self.place(s), line, "mm")

    def ring_limit(self) -> Formula:
        """Least teeth of the ring beside the satellite that asks for most of them."""
        s = self.hardest
        z, square = self.z(s), sin(self.alpha) ** 2
        value = (z**2 * square - 4 * self.ha**2) / (2 * z * square - 4 * self.ha)
        return self.satellites_of.formula("z3_least", self.place(s), value)

    @property
    def hardest(self) -> Satellite:
        """The satellite beside which the ring must have most teeth."""
        return max(
            self.found.upper, key=lambda s: float(self.satellites_of["z3_least"].values[self.place(s)])
        )

    # ------------------------------------------------------------ kinematics

    def ratio(self) -> Formula:
        return self.of["u"].formula(-(self.z3 / self.z1))

    def other_ratios(self) -> Iterator[Formula]:
        u = self.of["u"].var()
        yield self.of["u_1H"].formula(1 - u)
        yield self.of["u_3H"].formula(1 - 1 / u)
