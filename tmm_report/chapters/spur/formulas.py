"""Formulas of a spur stage: in symbols, in numbers, with their value; lengths in mm."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tmm_report.chapters.spur.solve import Found
from tmm_report.chapters.spur.terms import HA, C, arctan, involute
from tmm_report.mechanics import shifts
from tmm_report.quantity.formula import (
    PI,
    Expr,
    Formula,
    Inline,
    Number,
    Var,
    arccos,
    cos,
    expr,
    sin,
    sqrt,
    tan,
)
from tmm_report.quantity.symbols import Symbol, segment

LINE = segment("N1N2")


class SpurFormulas:
    """What the template prints of one pair. Wheels are counted 0 and 1 here and named as in the drive."""

    def __init__(self, found: Found):
        self.found, self.pair, self.names = found, found.pair, found.given.wheels
        self.helical = found.pair.beta > 0
        self.internal = found.given.internal
        self.small = found.teeth.small
        self.sum = "x_d" if self.internal else "x_Sigma"
        self.bound_sign = "z_d" if self.internal else "z_Sigma"

    # ------------------------------------------------------------ variables

    def mm(self, key: str | Symbol, metres: Any) -> Var:
        return Var(key, 1e3 * float(metres), "mm")

    def of(self, key: str, wheel: int) -> Var:
        """A dimension of a wheel by the name of its attribute: d_a -> d_a4."""
        base, _, sub = key.partition("_")
        return self.mm(Symbol(base, sub + self.names[wheel]), getattr(self.pair, key)[wheel])

    def z(self, wheel: int) -> Var:
        return Var(Symbol("z", self.names[wheel]), self.found.teeth.z[wheel])

    def x(self, wheel: int) -> Var:
        return Var(Symbol("x", self.names[wheel]), float((self.pair.x1, self.pair.x2)[wheel]))

    @property
    def m(self) -> Var:
        return self.mm("m", self.pair.m)

    @property
    def m_t(self) -> Var:
        return self.mm("m_t", self.pair.m_t) if self.helical else self.m

    @property
    def ha(self) -> Var:
        return Var(HA, self.pair.rack.ha)

    @property
    def c(self) -> Var:
        return Var(C, self.pair.rack.c)

    @property
    def alpha(self) -> Var:
        return Var("alpha", self.pair.rack.alpha, "deg")

    @property
    def alpha_t(self) -> Var:
        return Var("alpha_t", self.pair.t.alpha, "deg") if self.helical else self.alpha

    @property
    def alpha_w(self) -> Var:
        return Var("alpha_w", float(self.pair.alpha_w), "deg")

    @property
    def beta(self) -> Var:
        return Var("beta", self.pair.beta, "deg")

    @property
    def a_w(self) -> Var:
        return self.mm("a_w", self.pair.a_w)

    @property
    def line(self) -> Var:
        return self.mm(LINE, self.pair.line)

    @property
    def p_b(self) -> Var:
        return self.mm("p_b", self.pair.p_b)

    def combined(self, one: Expr, other: Expr) -> Expr:
        """The sum over both wheels; of an internal pair the larger's less the smaller's."""
        if not self.internal:
            return one + other
        return other - one if self.small == 0 else one - other

    def teeth_sum(self) -> Expr:
        return self.combined(self.z(0), self.z(1))

    # ------------------------------------------------------------ teeth

    def bound(self) -> Formula:
        """What the sum of teeth must not exceed."""
        given = self.found.given
        over = 2 * self.mm("a_w", given.centre_distance or 0.0)
        turned = over * cos(self.beta) if self.helical else over
        return Formula(self.bound_sign, turned / self.m)

    @property
    def u(self) -> Var:
        """The wanted ratio of the larger wheel's teeth to the smaller's."""
        ratio = abs(self.found.given.ratio)
        return Var("u", ratio if self.small == 0 else 1 / ratio)

    def share(self) -> Formula:
        u = self.u
        below = u - 1 if self.internal else 1 + u
        return Formula(
            Symbol("z", self.names[self.small]), Var(self.bound_sign, self.found.teeth.bound) / below
        )

    def larger(self) -> Formula:
        return Formula(Symbol("z", self.names[1 - self.small]), self.u * self.z(self.small))

    def count(self, i: int) -> Inline:
        """The number of teeth of a wheel, in running text."""
        return Inline(self.z(i).sign, float(self.found.teeth.z[i]))

    def spare(self) -> Formula:
        return Formula(Symbol("Delta", "z"), Var(self.bound_sign, self.found.teeth.bound) - self.teeth_sum())

    def ratio(self) -> Formula:
        u = self.z(1) / self.z(0)
        return Formula(Symbol("u", "".join(self.names)), u if self.internal else -u)

    # ------------------------------------------------------------ section, angle, shifts

    def section(self) -> Iterator[Formula]:
        """Module and profile angle of the transverse section of helical teeth."""
        if self.helical:
            yield Formula("m_t", self.m / cos(self.beta), "mm")
            yield Formula("alpha_t", arctan(tan(self.alpha) / cos(self.beta)), "deg")

    def reference_distance(self) -> Formula:
        return Formula("a", self.m_t * self.teeth_sum() / 2, "mm")

    def angle_of_distance(self) -> Formula:
        a = self.mm("a", self.pair.a)
        return Formula("alpha_w", arccos(a * cos(self.alpha_t) / self.a_w), "deg")

    def involutes(self) -> Iterator[Formula]:
        yield Formula(Symbol("inv α", "t" if self.helical else ""), self._spelled(self.alpha_t))
        yield Formula(Symbol("inv α", "w"), self._spelled(self.alpha_w))

    def _spelled(self, angle: Var) -> Expr:
        return tan(angle) - Var(Symbol(str(angle.sign.base), angle.sign.sub), angle.number, "rad")

    def sum_of_distance(self) -> Formula:
        difference = involute(self.alpha_w) - involute(self.alpha_t)
        return Formula(self.sum, self.teeth_sum() * difference / (2 * tan(self.alpha)))

    def sum_of_shifts(self) -> Formula:
        return Formula(self.sum, self.combined(self.x(0), self.x(1)))

    def angle_of_shifts(self) -> Formula:
        total = Var(self.sum, float(self.pair.x_sum))
        value = involute(self.alpha_t) + 2 * total * tan(self.alpha) / self.teeth_sum()
        return Formula(Symbol("inv α", "w"), value)

    def distance_of_angle(self) -> Formula:
        a = self.mm("a", self.pair.a)
        return Formula("a_w", a * cos(self.alpha_t) / cos(self.alpha_w), "mm")

    @property
    def needless(self) -> bool:
        """Whether the smaller wheel needs no shift of its own."""
        return float(self.x(self.small).number) == 0

    def least(self) -> Formula:
        """The smaller wheel's shift by the rule by which it was taken."""
        if self.found.given.shift == "limit":
            return self._exact(self.small, Symbol("x", self.names[self.small]))
        least = Number(shifts.rule_teeth(self.pair.rack))
        z: Expr = self.z(self.small)
        z = z / cos(self.beta) ** 3 if self.helical else z
        value = (least - z) / least
        return Formula(
            Symbol("x", self.names[self.small]), value if self.pair.rack.ha == 1 else self.ha * value
        )

    def exact_least(self) -> Formula:
        """The least shift of the smaller wheel without undercut."""
        return self._exact(self.small, Symbol("x", f"min{self.names[self.small]}"))

    def _exact(self, i: int, name: Symbol) -> Formula:
        cut = self.z(i) * sin(self.alpha_t) ** 2
        return Formula(name, self.ha - (cut / (2 * cos(self.beta)) if self.helical else cut / 2))

    def rest(self) -> Formula:
        """The larger wheel's shift from the sum and the smaller's."""
        total, small = Var(self.sum, float(self.pair.x_sum)), self.x(self.small)
        name = Symbol("x", self.names[1 - self.small])
        return Formula(name, total + small if self.internal else total - small)

    def centre_shift(self) -> Formula:
        return Formula("y", (self.a_w - self.mm("a", self.pair.a)) / self.m)

    def shortening(self) -> Formula:
        return Formula(Symbol("Deltay"), Var(self.sum, float(self.pair.x_sum)) - Var("y", float(self.pair.y)))

    @property
    def loose(self) -> bool:
        """Whether the shifts leave backlash at the given distance."""
        return bool(self.pair.backlash > 1e-6 * self.pair.m)

    @property
    def beyond(self) -> bool:
        """Whether the contact passes an end of the line of action, where the sliding has no bound."""
        return bool(min(self.pair.rho_p) <= 0)

    @property
    def two_zones(self) -> bool:
        """Whether one and two pairs of teeth take turns."""
        return bool(1 < self.pair.eps < 2)

    def backlash(self) -> Formula:
        """Backlash along the working circles."""
        j = self.mm("p_w", self.pair.p_w) - self.of("s_w", 0) - self.of("s_w", 1)
        return Formula("j_w", j, "mm")

    def filled(self) -> Formula:
        """The thicknesses on the working circles together: the pitch, where there is no backlash."""
        return Formula("p_w", self.of("s_w", 0) + self.of("s_w", 1), "mm")

    # ------------------------------------------------------------ dimensions of a wheel

    def pitches(self) -> Iterator[Formula]:
        yield Formula("p", PI * self.m_t, "mm")
        yield Formula("p_b", self.mm("p", self.pair.p) * cos(self.alpha_t), "mm")
        yield Formula("p_w", self.p_b / cos(self.alpha_w), "mm")

    def dimensions(self, i: int) -> Iterator[Formula]:
        """Diameters and thicknesses of one wheel, in the order of computing."""
        d, d_b, name = self.of("d", i), self.of("d_b", i), self.names[i]
        yield Formula(Symbol("d", name), self.m_t * self.z(i), "mm")
        yield Formula(Symbol("d", "b" + name), d * cos(self.alpha_t), "mm")
        yield Formula(Symbol("d", "w" + name), d_b / cos(self.alpha_w), "mm")
        yield Formula(Symbol("d", "f" + name), self._root(i), "mm")
        yield Formula(Symbol("d", "a" + name), self._tip(i), "mm")
        yield Formula(Symbol("s", name), self._thickness(i), "mm")
        yield Formula(Symbol("alpha", "a" + name), arccos(d_b / self.of("d_a", i)), "deg")
        for circle, angle in (("b", expr(0.0)), ("w", self.alpha_w), ("a", self.alpha_a(i))):
            yield Formula(Symbol("s", circle + name), self._arc(i, circle, angle), "mm")

    def _ring(self, i: int) -> bool:
        return bool(self.pair.signs[i] < 0)

    def _root(self, i: int) -> Expr:
        if self._ring(i):
            return self.of("d", i) + 2 * self.m * (self.ha + self.c + self.x(i))
        return self.of("d", i) - 2 * self.m * (self.ha + self.c - self.x(i))

    @property
    def equalised(self) -> bool:
        """Whether the tips are cut down to keep the clearance."""
        return bool(self.pair.shortening > 1e-9)

    def _tip(self, i: int) -> Expr:
        if self.equalised:
            return 2 * self.a_w - self.of("d_f", 1 - i) - 2 * self.c * self.m
        if self._ring(i):
            return self.of("d", i) - 2 * self.m * (self.ha - self.x(i))
        return self.of("d", i) + 2 * self.m * (self.ha + self.x(i))

    def _thickness(self, i: int) -> Expr:
        widened = 2 * self.x(i) * tan(self.alpha)
        return self.m_t * (PI / 2 - widened if self._ring(i) else PI / 2 + widened)

    def _arc(self, i: int, circle: str, angle: Expr) -> Expr:
        share = self.of("s", i) / self.of("d", i)
        own = involute(self.alpha_t)
        if circle == "b":
            total = share - own if self._ring(i) else share + own
        else:
            total = share - own + involute(angle) if self._ring(i) else share + own - involute(angle)
        return self.of(f"d_{circle}", i) * total

    def alpha_a(self, i: int) -> Var:
        return Var(Symbol("alpha", "a" + self.names[i]), float(self.pair.alpha_a[i]), "deg")

    # ------------------------------------------------------------ line of action

    def path(self) -> Iterator[Formula]:
        yield Formula(LINE, self.a_w * sin(self.alpha_w), "mm")
        for i in (0, 1):
            curvature = sqrt(self.of("d_a", i) ** 2 - self.of("d_b", i) ** 2) / 2
            yield Formula(Symbol("rho", "a" + self.names[i]), curvature, "mm")
        for i in (0, 1):
            yield Formula(Symbol("rho", "p" + self.names[i]), self._lower(i), "mm")

    def _lower(self, i: int) -> Expr:
        other = self.of("rho_a", 1 - i)
        if not self.internal:
            return self.line - other
        return self.line + other if self._ring(i) else other - self.line

    def active(self) -> Formula:
        one, other = self.of("rho_a", 0), self.of("rho_a", 1)
        if self.internal:
            return Formula(segment("AB"), (one - other if self.small == 0 else other - one) + self.line, "mm")
        return Formula(segment("AB"), one + other - self.line, "mm")

    def contact(self) -> Formula:
        return Formula(Symbol("epsilon", "alpha"), self.mm(segment("AB"), self.pair.active) / self.p_b)

    def overlap(self) -> Formula:
        width = self.found.given.width or 0.0
        b = self.mm("b", width)
        return Formula(Symbol("epsilon", "beta"), b * sin(self.beta) / (PI * self.m))

    def two_pairs(self) -> Formula:
        """Length of each of the two zones of two-pair contact."""
        return Formula(segment("AC"), self.mm(segment("AB"), self.pair.active) - self.p_b, "mm")

    def share_of_two(self) -> Formula:
        eps = Var(Symbol("epsilon", "alpha"), float(self.pair.eps))
        return Formula(Symbol("delta", "2"), (eps - 1) * Number(100), "%")

    def slidings(self) -> Iterator[Formula]:
        """Specific sliding at the lower points of the active profiles, and at the tips."""
        for i in (0, 1):
            yield self._sliding("p", i, self.of("rho_p", i), self.of("rho_a", 1 - i))
        for i in (0, 1):
            yield self._sliding("a", i, self.of("rho_a", i), self.of("rho_p", 1 - i))

    def _sliding(self, point: str, i: int, own: Var, other: Var) -> Formula:
        value = 1 - self.z(i) * other / (self.z(1 - i) * own)
        return Formula(Symbol("lambda", point + self.names[i]), value)
