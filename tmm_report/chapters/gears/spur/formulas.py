"""Formulas of a spur stage: in symbols, in numbers, with their value; lengths in mm."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.gears.spur.quantities import book
from tmm_report.chapters.gears.spur.solve.pair import Found
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
from tmm_report.quantity.part import Part
from tmm_report.quantity.terms.gear_terms import arctan, involute

UNITS = {"m": "mm"}  # of the results -> of print


class SpurFormulas:
    """What the template prints of one pair. Wheels are counted 0 and 1 here and named as in the drive.

    `prefix` begins the names of the stage in the results.
    """

    def __init__(self, found: Found, prefix: str):
        self.found, self.pair, self.names = found, found.pair, found.given.wheels
        self.part = Part(prefix, book(found, prefix))
        self.wheels = self.part.table("wheels")
        self.helical = found.pair.beta > 0
        self.internal = found.given.internal
        self.small = found.teeth.small

    # ------------------------------------------------------------ variables

    def var(self, key: str, unit: str = "") -> Var:
        """A single number of the pair; lengths in mm."""
        value = self.part[key]
        return value.var(unit or UNITS.get(value.unit, ""))

    def result(self, key: str, expression: Expr, unit: str = "") -> Formula:
        """The formula of a single number of the pair."""
        value = self.part[key]
        return value.formula(expression, unit or UNITS.get(value.unit, ""))

    def tool(self, key: str, wheel: int) -> Var:
        """A number of the pinion cutter of a wheel, or of cutting by it."""
        table = self.part.table("cutter")
        return table.var(key, self.found.cut_wheels.index(wheel), UNITS.get(table[key].unit, ""))

    def of(self, key: str, wheel: int) -> Var:
        """A number of a wheel."""
        return self.wheels.var(key, wheel, UNITS.get(self.wheels[key].unit, ""))

    def result_of(self, key: str, wheel: int, expression: Expr) -> Formula:
        return self.wheels.formula(key, wheel, expression, UNITS.get(self.wheels[key].unit, ""))

    def z(self, wheel: int) -> Var:
        return self.of("z", wheel)

    def x(self, wheel: int) -> Var:
        return self.of("x", wheel)

    @property
    def m(self) -> Var:
        return self.var("m")

    @property
    def m_t(self) -> Var:
        return self.var("m_t") if self.helical else self.m

    @property
    def ha(self) -> Var:
        return self.var("ha")

    @property
    def c(self) -> Var:
        return self.var("c")

    @property
    def alpha(self) -> Var:
        return self.var("alpha")

    @property
    def alpha_t(self) -> Var:
        return self.var("alpha_t") if self.helical else self.alpha

    @property
    def alpha_w(self) -> Var:
        return self.var("alpha_w")

    @property
    def beta(self) -> Var:
        return self.var("beta")

    @property
    def a_w(self) -> Var:
        return self.var("a_w")

    @property
    def line(self) -> Var:
        return self.var("line")

    @property
    def p_b(self) -> Var:
        return self.var("p_b")

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
        over = 2 * self.a_w
        turned = over * cos(self.beta) if self.helical else over
        return self.result("z_bound", turned / self.m)

    def share(self) -> Formula:
        u = self.var("u")
        below = u - 1 if self.internal else 1 + u
        return self.result("z_share", self.var("z_bound") / below)

    def larger(self) -> Formula:
        return self.result("z_larger", self.var("u") * self.z(self.small))

    def count(self, i: int) -> Inline:
        """The number of teeth of a wheel, in running text."""
        z = self.z(i)
        return Inline(z.sign, float(z.number), ref=z.ref)

    def spare(self) -> Formula:
        return self.result("z_spare", self.var("z_bound") - self.teeth_sum())

    def ratio(self) -> Formula:
        u = self.z(1) / self.z(0)
        return self.result("ratio", u if self.internal else -u)

    # ------------------------------------------------------------ section, angle, shifts

    def section(self) -> Iterator[Formula]:
        """Module and profile angle of the transverse section of helical teeth."""
        if self.helical:
            yield self.result("m_t", self.m / cos(self.beta))
            yield self.result("alpha_t", arctan(tan(self.alpha) / cos(self.beta)))

    def reference_distance(self) -> Formula:
        return self.result("a", self.m_t * self.teeth_sum() / 2)

    def angle_of_distance(self) -> Formula:
        return self.result("alpha_w", arccos(self.var("a") * cos(self.alpha_t) / self.a_w))

    def involutes(self) -> Iterator[Formula]:
        yield self.result("inv_alpha", self._spelled("alpha_t" if self.helical else "alpha"))
        yield self.result("inv_alpha_w", self._spelled("alpha_w"))

    def _spelled(self, angle: str) -> Expr:
        return tan(self.var(angle)) - self.var(angle, "rad")

    def sum_of_distance(self) -> Formula:
        difference = involute(self.alpha_w) - involute(self.alpha_t)
        key = "x_needed" if self.found.loose else "x_sum"
        return self.result(key, self.teeth_sum() * difference / (2 * tan(self.alpha)))

    def sum_of_shifts(self) -> Formula:
        return self.result("x_sum", self.combined(self.x(0), self.x(1)))

    def angle_of_shifts(self) -> Formula:
        value = involute(self.alpha_t) + 2 * self.var("x_sum") * tan(self.alpha) / self.teeth_sum()
        return self.result("inv_alpha_w", value)

    def distance_of_angle(self) -> Formula:
        return self.result("a_w", self.var("a") * cos(self.alpha_t) / cos(self.alpha_w))

    @property
    def by_cutter(self) -> bool:
        """Whether a stated pinion cutter cuts both wheels."""
        return self.found.given.cutter is not None and not self.internal

    @property
    def needless(self) -> bool:
        """Whether the smaller wheel needs no shift of its own."""
        return float(self.x(self.small).number) == 0

    def least(self) -> Formula:
        """The smaller wheel's shift by the rule by which it was taken."""
        if self.found.given.shift == "limit":
            return self._exact("x")
        least = Number(self.part["z_rule"].value)
        z: Expr = self.z(self.small)
        z = z / cos(self.beta) ** 3 if self.helical else z
        value = (least - z) / least
        return self.result_of("x", self.small, value if self.pair.rack.ha == 1 else self.ha * value)

    def exact_least(self) -> Formula:
        """The least shift of the smaller wheel without undercut."""
        return self._exact("x_min")

    def _exact(self, key: str) -> Formula:
        cut = self.z(self.small) * sin(self.alpha_t) ** 2
        value = self.ha - (cut / (2 * cos(self.beta)) if self.helical else cut / 2)
        return self.result_of(key, self.small, value)

    def rest(self) -> Formula:
        """The larger wheel's shift from the sum and the smaller's."""
        total, small = self.var("x_sum"), self.x(self.small)
        return self.result_of("x", 1 - self.small, total + small if self.internal else total - small)

    def centre_shift(self) -> Formula:
        return self.result("y", (self.a_w - self.var("a")) / self.m)

    def shortening(self) -> Formula:
        return self.result("shortening", self.var("x_sum") - self.var("y"))

    def backlash(self) -> Formula:
        """Backlash along the working circles."""
        return self.result("backlash", self.var("p_w") - self.of("s_w", 0) - self.of("s_w", 1))

    def filled(self) -> Formula:
        """The thicknesses on the working circles together: the pitch, where there is no backlash."""
        return self.result("p_w", self.of("s_w", 0) + self.of("s_w", 1))

    # ------------------------------------------------------------ dimensions of a wheel

    def pitches(self) -> Iterator[Formula]:
        yield self.result("p", PI * self.m_t)
        yield self.result("p_b", self.var("p") * cos(self.alpha_t))
        yield self.result("p_w", self.p_b / cos(self.alpha_w))

    def dimensions(self, i: int) -> Iterator[Formula]:
        """Diameters and thicknesses of one wheel, in the order of computing."""
        d, d_b = self.of("d", i), self.of("d_b", i)
        yield self.result_of("d", i, self.m_t * self.z(i))
        yield self.result_of("d_b", i, d * cos(self.alpha_t))
        yield self.result_of("d_w", i, d_b / cos(self.alpha_w))
        yield self.result_of("d_f", i, self._root(i))
        yield self.result_of("d_a", i, self._tip(i))
        yield self.result_of("s", i, self._thickness(i))
        yield self.result_of("alpha_a", i, arccos(d_b / self.of("d_a", i)))
        circles = [("b", expr(0.0)), ("w", self.alpha_w), ("a", self.of("alpha_a", i))]
        for circle, angle in circles[self._ring(i) :]:  # the teeth of a ring end before its base circle
            yield self.result_of(f"s_{circle}", i, self._arc(i, circle, angle))

    def _ring(self, i: int) -> bool:
        return bool(self.pair.signs[i] < 0)

    def _root(self, i: int) -> Expr:
        if self.found.given.cutter and self.found.cut_by(i):
            a_w0, d_a0 = self.tool("a_w0", i), self.tool("d_a0", i)
            return 2 * a_w0 + d_a0 if self._ring(i) else 2 * a_w0 - d_a0
        if self._ring(i):
            return self.of("d", i) + 2 * self.m * (self.ha + self.c + self.x(i))
        return self.of("d", i) - 2 * self.m * (self.ha + self.c - self.x(i))

    @property
    def equalised(self) -> bool:
        """Whether the tips are cut down to keep the clearance."""
        return bool(self.pair.shortening > 1e-9)

    def trimmed(self, i: int) -> bool:
        """Whether the tips of a ring are cut down to clear the fillets of its pinion."""
        return bool(self.pair.trimming[i] > 1e-9 * self.pair.m)

    def _tip(self, i: int) -> Expr:
        if self.trimmed(i):
            start = self.of("rho_l", 1 - i)
            return 2 * sqrt((self.of("d_b", i) / 2) ** 2 + (self.line + start) ** 2)
        if self.equalised and self.found.given.cutter:
            return self.of("d", i) + 2 * self.m * (self.ha + self.x(i) - self.var("shortening"))
        if self.equalised:
            return 2 * self.a_w - self.of("d_f", 1 - i) - 2 * self.c * self.m
        if self._ring(i):
            return self.of("d", i) - 2 * self.m * (self.ha - self.x(i))
        return self.of("d", i) + 2 * self.m * (self.ha + self.x(i))

    def involute_start(self, i: int) -> Formula:
        """Of a pinion that is cut by the rack without undercut: where its involute begins."""
        lost = (self.ha - self.x(i)) * self.m / sin(self.alpha_t)
        return self.result_of("rho_l", i, self.m_t * self.z(i) / 2 * sin(self.alpha_t) - lost)

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

    # ------------------------------------------------------------ line of action

    def path(self) -> Iterator[Formula]:
        yield self.result("line", self.a_w * sin(self.alpha_w))
        for i in (0, 1):
            yield self.result_of("rho_a", i, sqrt(self.of("d_a", i) ** 2 - self.of("d_b", i) ** 2) / 2)
        for i in (0, 1):
            yield self.result_of("rho_m" if self.found.cut_short else "rho_p", i, self._lower(i))

    def short_path(self) -> Iterator[Formula]:
        """The active part of the line of action and the contact ratio by the tip circles, the textbook's formula."""
        yield self.result("active_tips", self._between("rho_a"))
        yield self.result("eps_tips", self.var("active_tips") / self.p_b)

    def _lower(self, i: int) -> Expr:
        other = self.of("rho_a", 1 - i)
        if not self.internal:
            return self.line - other
        return self.line + other if self._ring(i) else other - self.line

    def active(self) -> Formula:
        if not self.found.cut_short:
            return self.result("active", self._between("rho_a"))
        one, other = self.of("rho_p", 0), self.of("rho_p", 1)
        if self.internal:
            return self.result("active", (other - one if self.small == 0 else one - other) - self.line)
        return self.result("active", self.line - one - other)

    def _between(self, key: str) -> Expr:
        one, other = self.of(key, 0), self.of(key, 1)
        if self.internal:
            return (one - other if self.small == 0 else other - one) + self.line
        return one + other - self.line

    def contact(self) -> Formula:
        return self.result("eps", self.var("active") / self.p_b)

    def overlap(self) -> Formula:
        return self.result("eps_beta", self.var("b") * sin(self.beta) / (PI * self.m))

    def two_pairs(self) -> Formula:
        """Length of each of the two zones of two-pair contact."""
        return self.result("two_length", self.var("active") - self.p_b)

    def share_of_two(self) -> Formula:
        return self.result("two_pairs", (self.var("eps") - 1) * Number(100), "%")

    def slidings(self) -> Iterator[Formula]:
        """Specific sliding at the lower points of the active profiles, and at the tips."""
        upper = "rho_u" if self.found.cut_short else "rho_a"
        for key, own, other in (("root_sliding", "rho_p", upper), ("tip_sliding", upper, "rho_p")):
            for i in (0, 1):
                ratio = self.z(i) * self.of(other, 1 - i) / (self.z(1 - i) * self.of(own, i))
                yield self.result_of(key, i, 1 - ratio)
