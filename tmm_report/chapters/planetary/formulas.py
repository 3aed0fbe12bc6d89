"""Formulas of a planetary stage: in symbols, in numbers, with their value; lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tmm_report.chapters.planetary.solve import Found
from tmm_report.i18n import Translator
from tmm_report.mechanics.planetary import EXTERNAL, INTERNAL, MEMBERS, ROWS, Member, carrier_turns
from tmm_report.quantity.formula import Expr, Formula, Number, Page, Var, arccos, cos, sin, sqrt, tan
from tmm_report.quantity.gear_terms import HA, involute
from tmm_report.quantity.symbols import Latex, MathML, Symbol, both, notation

HALF_TURN = Var("pi", np.pi, "deg")


@dataclass(frozen=True, eq=False)
class Relation:
    """left = numbers = value, unit, and how it stands to the right, written in the same way: a = b, a > b."""

    left: Expr
    sign: str
    right: Expr
    unit: str = ""

    @property
    def holds(self) -> bool:
        difference = float(self.left.value - self.right.value)
        return abs(difference) < 1e-9 * abs(float(self.right.value)) if self.sign == "=" else difference > 0

    def latex(self, tr: Translator) -> str:
        return self._print(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self._print(notation("mathml", tr))

    def _print(self, form: Latex | MathML) -> str:
        left, right = self._side(self.left, form), self._side(self.right, form)
        return form.formula([left[0] + left[1], *left[2:], form.operator(self.sign) + right[0], *right[1:]])

    def _side(self, side: Expr, form: Latex | MathML) -> list[str]:
        """In symbols, in numbers, the value: each with its sign of equality, what repeats left out."""
        pages = [Page(form, numbers) for numbers in (False, True)]
        texts = [side.piece(page).text for page in pages]
        texts.append(pages[1].number(side.value, 5).text)
        new = [text for k, text in enumerate(texts) if k == 0 or text != texts[k - 1]]
        pieces = [new[0], *(form.operator("=") + text for text in new[1:])]
        pieces[-1] += form.unit(self.unit)
        return pieces


class PlanetaryFormulas:
    """What the template prints of one stage; members are named as in the drive."""

    def __init__(self, found: Found):
        self.found, self.given, self.task = found, found.given, found.given.task
        self.scheme, self.sizes = found.scheme, found.sizes
        given = self.given
        self.one, self.three, self.carrier = (given.member(member) for member in MEMBERS)
        self.crowns = given.crowns
        self.wheels = (self.one, *self.crowns, self.three)
        self.one_module = self.scheme.single or self.task.modules[0] == self.task.modules[1]

    # ------------------------------------------------------------ variables

    def mm(self, key: str | Symbol, metres: float) -> Var:
        return Var(key, 1e3 * float(metres), "mm")

    def z(self, wheel: int) -> Var:
        """Teeth of wheels 1, 2, 2', 3 by their index 0..3."""
        return Var(Symbol("z", self.wheels[wheel]), self.found.teeth[wheel])

    def m(self, row: int) -> Var:
        name = "" if self.one_module else ("I", "II")[row]
        return self.mm(Symbol("m", name), self.task.modules[row])

    def of(self, base: str, sub: str, wheel: int, values: str) -> Var:
        """A diameter of a wheel by the name of its array in the sizes."""
        return self.mm(Symbol(base, sub + self.wheels[wheel]), getattr(self.sizes, values)[wheel])

    @property
    def k(self) -> Var:
        return Var("k", self.found.satellites)

    @property
    def a_w(self) -> Var:
        return self.mm("a_w", self.sizes.centre_distance)

    def basic(self) -> Var:
        """u13(H), with more digits where its difference from 1 has few of them."""
        near = max(0, math.ceil(-math.log10(abs(1 - self.found.basic))))
        return Var(self._ratio_symbol("wheel1", "wheel3"), self.found.basic, digits=5 + near)

    def _ratio_symbol(self, input: Member, output: Member) -> Symbol:
        (held,) = set(MEMBERS) - {input, output}
        name = self.given.member
        return Symbol("u", both(name(input), name(output)), f"({name(held)})")

    def teeth_sum(self, row: int) -> Expr:
        """z1 + z2 or z3 − z2' of a row."""
        central, satellite = ROWS[row]
        outer, inner = self.z(central), self.z(satellite)
        return outer + inner if self.scheme.rows[row] == EXTERNAL else outer - inner

    # ------------------------------------------------------------ ratio

    def basic_ratio(self) -> Formula:
        """Willis' ratio of the stage with its carrier stopped."""
        if self.scheme.single:
            return Formula(self.basic().symbol, -(self.z(3) / self.z(0)))
        value = (self.z(1) * self.z(3)) / (self.z(0) * self.z(2))
        return Formula(self.basic().symbol, value if self.found.basic > 0 else -value)

    @property
    def ordinary(self) -> bool:
        """Whether the carrier is held and wheel 1 drives: the stage's ratio is the basic one itself."""
        return self.task.output == "wheel3" and self.task.input == "wheel1"

    def ratio(self) -> Formula:
        """The ratio of the stage from that with its carrier stopped."""
        task = self.task
        return Formula(self._ratio_symbol(task.input, task.output), self._ratio(task.input, task.output))

    def _ratio(self, input: Member, output: Member) -> Expr:
        u = self.basic()
        return {
            ("wheel1", "carrier"): 1 - u,
            ("carrier", "wheel1"): 1 / (1 - u),
            ("wheel3", "carrier"): 1 - 1 / u,
            ("carrier", "wheel3"): 1 / (1 - 1 / u),
            ("wheel3", "wheel1"): 1 / u,
        }[input, output]

    def deviation(self) -> Formula:
        symbol = self._ratio_symbol(self.task.input, self.task.output)
        found, wanted = Var(symbol, self.found.ratio, digits=5), Var("u", self.task.ratio, digits=5)
        return Formula(Symbol("Delta", "u"), abs(found - wanted) / abs(wanted) * Number(100), "%", digits=3)

    # ------------------------------------------------------------ conditions

    def coaxiality(self) -> Relation:
        """Of one module by the teeth, else by the centre distances."""
        sums = [self.teeth_sum(row) for row in (0, 1)]
        if self.one_module:
            return Relation(sums[0], self._equal(), sums[1])
        distances = [self.m(row) * total / 2 for row, total in enumerate(sums)]
        return Relation(distances[0], self._equal(), distances[1], "mm")

    def _equal(self) -> str:
        if not self.found.shifted:
            return "="
        return "<" if self.sizes.pitch_distances[0] < self.sizes.pitch_distances[1] else ">"

    def distance(self) -> Formula:
        """The centre distance, that of the row without shift."""
        row = int(np.argmax(self.sizes.pitch_distances))
        return Formula("a_w", self.m(row) * self.teeth_sum(row) / 2, "mm")

    @property
    def opened(self) -> int:
        """The row that profile shift opens to the centre distance."""
        return int(np.argmin(self.sizes.pitch_distances))

    def shift(self) -> Iterator[Formula]:
        """The operating angle and the sum of shift coefficients of the opened row."""
        row, rack = self.opened, self.task.rack
        a = self.mm("a", self.sizes.pitch_distances[row])
        alpha = Var("alpha", rack.alpha, "deg")
        yield Formula("a", self.m(row) * self.teeth_sum(row) / 2, "mm")
        yield Formula("alpha_w", arccos(a * cos(alpha) / self.a_w), "deg")
        alpha_w = Var("alpha_w", float(self.sizes.angles[row]), "deg")
        total = "x_Sigma" if self.scheme.rows[row] == EXTERNAL else "x_d"
        difference = involute(alpha_w) - involute(alpha)
        yield Formula(total, self.teeth_sum(row) * difference / (2 * tan(alpha)))

    def least_teeth(self) -> Formula:
        rack = self.task.rack
        ha, alpha = Var(HA, rack.ha), Var("alpha", rack.alpha, "deg")
        return Formula("z_min", 2 * ha / sin(alpha) ** 2)

    def ring_tip(self, row: int) -> Relation:
        """The ring's tip beyond the limit point of the line of action."""
        wheel = ROWS[row][0]
        tip, base = self.of("d", "a", wheel, "tip"), self.of("d", "b", wheel, "base")
        alpha_w = Var("alpha_w", float(self.sizes.angles[row]), "deg")
        return Relation(sqrt(tip**2 - base**2) / 2, ">", self.a_w * sin(alpha_w), "mm")

    def involute_start(self, row: int) -> Formula:
        """Radius of curvature of the satellite's flank where the rack's fillet begins."""
        crown, rack = row + 1, self.task.rack
        ha, alpha = Var(HA, rack.ha), Var("alpha", rack.alpha, "deg")
        shift = float(self.sizes.shifts[crown])
        height: Expr = ha - Var(Symbol("x", self.wheels[crown]), shift) if shift else ha
        m = self.m(row)
        return Formula(self._start(row), m * self.z(crown) / 2 * sin(alpha) - m * height / sin(alpha), "mm")

    def _start(self, row: int) -> Symbol:
        return Symbol("rho", "l" + self.wheels[row + 1])

    def trimmed(self, row: int) -> Formula | None:
        """The ring's tip diameter where full height would touch the satellite's fillets; else None."""
        wheel = ROWS[row][0]
        full, cut = self.sizes.tip[wheel], self.sizes.trimmed[wheel]
        if cut <= full * (1 + 1e-12):
            return None
        base, alpha_w = self.of("d", "b", wheel, "base"), Var("alpha_w", float(self.sizes.angles[row]), "deg")
        start = self.involute_start(row)
        touching = self.a_w * sin(alpha_w) + Var(self._start(row), float(start.value), "mm")
        symbol = Symbol("d", "a" + self.wheels[wheel], "′")
        return Formula(symbol, 2 * sqrt((base / 2) ** 2 + touching**2), "mm")

    def neighbourhood(self) -> Relation:
        crown = 1 if self.sizes.tip[1] >= self.sizes.tip[2] else 2
        return Relation(2 * self.a_w * sin(HALF_TURN / self.k), ">", self.of("d", "a", crown, "tip"), "mm")

    def tip_diameter(self) -> Formula:
        """Of the larger crown, without shift m (z + 2 ha*)."""
        crown = 1 if self.sizes.tip[1] >= self.sizes.tip[2] else 2
        ha, m = Var(HA, self.task.rack.ha), self.m(crown - 1)
        return Formula(Symbol("d", "a" + self.wheels[crown]), m * (self.z(crown) + 2 * ha), "mm")

    def assembly(self) -> Formula:
        """(z1 + z3)/k of a single row; of two rows also over the common divisor of the crowns' teeth."""
        if self.scheme.single:
            return Formula("C", (self.z(0) + self.z(3)) / self.k)
        one, other = self.z(0) * self.z(2), self.z(1) * self.z(3)
        opposite = self.scheme.rows[0] * self.scheme.rows[1] == INTERNAL
        top = one + other if opposite else abs(one - other)
        common = Var("D", int(np.gcd(self.found.teeth[1], self.found.teeth[2])))
        return Formula("C", top / (self.k * common))

    def course_assembly(self) -> Formula | None:
        """The course's C = z1 u1H (1 + k p)/k of two rows; None where no whole p makes it whole."""
        turns = carrier_turns(self.scheme, self.found.teeth, self.found.satellites)
        if turns is None:
            return None
        u = Var(self._ratio_symbol("wheel1", "carrier"), 1 - self.found.basic)
        return Formula("C", abs(self.z(0) * u) / self.k * (1 + self.k * Var("p", turns)))

    # ------------------------------------------------------------ sizes, efficiency, loads

    def working(self) -> Iterator[Formula]:
        """Working diameters of wheels without shift."""
        for wheel in self.scheme.wheels:
            symbol = Symbol("d", "w" + self.wheels[wheel])
            yield Formula(symbol, self.m(0 if wheel < 2 else 1) * self.z(wheel), "mm")

    def efficiency(self) -> Formula:
        """By the way of the power: u η_H or u/η_H in the place of u."""
        motion, eta = self.found.motion, Var(Symbol("eta", self.carrier), self.given.efficiency)
        u = self.basic()
        lossy = u * eta if motion.exponent > 0 else u / eta
        value = {
            ("wheel1", "carrier"): (1 - lossy) / (1 - u),
            ("carrier", "wheel1"): (1 - u) / (1 - lossy),
            ("wheel3", "carrier"): (1 - 1 / lossy) / (1 - 1 / u),
            ("carrier", "wheel3"): (1 - 1 / u) / (1 - 1 / lossy),
        }.get((self.task.input, self.task.output), eta)
        name = self.given.member
        symbol = Symbol(
            "eta", both(name(self.task.input), name(self.task.output)), f"({name(self.task.held)})"
        )
        return Formula(symbol, value, digits=4)

    def force(self) -> Formula:
        """The circumferential force on one satellite from wheel 1, of each N·m of its torque, N."""
        d = Var(Symbol("d", "w" + self.one), float(self.sizes.working[0]), "m")
        return Formula(Symbol("F", "t" + self.one), Number(2) / (self.k * d), "N/(N·m)")
