"""Formulas of a planetary stage: in symbols, in numbers, with their value; lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.gears.planetary.quantities.stage import book, one_module
from tmm_report.chapters.gears.planetary.relation import Relation, Side
from tmm_report.chapters.gears.planetary.solve.stage import Found
from tmm_report.chapters.gears.planetary.solve.stated_shifts import whole
from tmm_report.mechanics.gears.planetary.stage import EXTERNAL, INTERNAL, MEMBERS, ROWS, Member
from tmm_report.quantity.formula import Expr, Formula, Number, Var, arccos, cos, sin, sqrt, tan
from tmm_report.quantity.part import Part
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.terms.gear_terms import arctan, involute

HALF_TURN = Var("pi", np.pi, "deg", ref=Ref("pi", unit="deg"))


class PlanetaryFormulas:
    """What the template prints of one stage; `prefix`: of its names in the results."""

    def __init__(self, found: Found, prefix: str):
        self.found, self.given, self.task = found, found.given, found.given.task
        self.scheme, self.sizes = found.scheme, found.sizes
        self.one, self.three, self.carrier = (self.given.member(member) for member in MEMBERS)
        self.wheels = self.given.wheels
        self.of = Part(prefix, book(found, prefix))
        self.sized, self.rows = self.of.table("wheels"), self.of.table("rows")

    # ------------------------------------------------------------ variables

    def place(self, wheel: int) -> int:
        """Row of wheels 1, 2, 2', 3 in the table of wheels, which has the one crown of a single row once."""
        return self.scheme.wheels.index(1 if wheel == 2 and self.scheme.single else wheel)

    def wheel(self, key: str, wheel: int, unit: str = "mm") -> Var:
        """A dimension of a wheel."""
        return self.sized.var(key, self.place(wheel), unit)

    def z(self, wheel: int) -> Var:
        """Teeth of wheels 1, 2, 2', 3 by their index 0..3."""
        return self.wheel("z", wheel, "")

    def m(self, row: int) -> Var:
        return self.of["m" if one_module(self.given) else ("m_I", "m_II")[row]].var("mm")

    @property
    def k(self) -> Var:
        return self.of["k"].var()

    @property
    def a_w(self) -> Var:
        return self.of["a_w"].var("mm")

    @property
    def ha(self) -> Var:
        return self.of["ha"].var()

    @property
    def alpha(self) -> Var:
        return self.of["alpha"].var()

    def alpha_w(self, row: int) -> Var:
        return self.rows.var("alpha_w", row)

    def basic(self) -> Var:
        """u13(H), with more digits where its difference from 1 has few of them."""
        near = max(0, math.ceil(-math.log10(abs(1 - self.found.basic))))
        return self.of["u_basic"].var(digits=5 + near)

    def teeth_sum(self, row: int) -> Expr:
        """z1 + z2 or z3 − z2' of a row."""
        central, satellite = ROWS[row]
        outer, inner = self.z(central), self.z(satellite)
        return outer + inner if self.scheme.rows[row] == EXTERNAL else outer - inner

    # ------------------------------------------------------------ ratio

    def basic_ratio(self) -> Formula:
        """Willis' ratio of the stage with its carrier stopped."""
        if self.scheme.single:
            return self.of["u_basic"].formula(-(self.z(3) / self.z(0)))
        value = (self.z(1) * self.z(3)) / (self.z(0) * self.z(2))
        return self.of["u_basic"].formula(value if self.found.basic > 0 else -value)

    @property
    def ordinary(self) -> bool:
        """Whether the carrier is held and wheel 1 drives: the stage's ratio is the basic one itself."""
        return self.task.output == "wheel3" and self.task.input == "wheel1"

    def ratio(self) -> Formula:
        """The ratio of the stage from that with its carrier stopped."""
        return self.of["u"].formula(self._ratio(self.task.input, self.task.output))

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
        found, wanted = self.of["u"].var(digits=5), self.of["u_wanted"].var(digits=5)
        off = abs(found - wanted) / abs(wanted) * Number(100)
        return self.of["delta_u"].formula(off, size=True, digits=3)

    # ------------------------------------------------------------ conditions

    def coaxiality(self) -> Relation:
        """Of one module by the teeth, else by the centre distances."""
        sums = [self.teeth_sum(row) for row in (0, 1)]
        if one_module(self.given):
            left, right = (Side(total, self.rows.ref("z_sum", row)) for row, total in enumerate(sums))
            return Relation(left, self._equal(), right)
        distances = (self.m(row) * total / 2 for row, total in enumerate(sums))
        left, right = (Side(of, self.rows.ref("a", row, "mm")) for row, of in enumerate(distances))
        return Relation(left, self._equal(), right, "mm")

    def _equal(self) -> str:
        if self.found.coaxial:
            return "="
        return "<" if self.sizes.pitch_distances[0] < self.sizes.pitch_distances[1] else ">"

    def distance(self) -> Formula:
        """The centre distance, that of the row without shift."""
        row = int(np.argmax(self.sizes.pitch_distances))
        return self.of["a_w"].formula(self.m(row) * self.teeth_sum(row) / 2, "mm")

    @property
    def opened(self) -> int:
        """The row that profile shift opens to the centre distance, or the first of them."""
        return self.found.opened[0] if self.found.opened else 0

    def shift(self) -> Iterator[Formula]:
        """The operating angle and the sum of shift coefficients of the opened rows; where the coefficients are stated
        their sum is not found."""
        alpha = self.alpha
        for row in self.found.opened:
            yield self.rows.formula("a", row, self.m(row) * self.teeth_sum(row) / 2, "mm")
            angle = arccos(self.rows.var("a", row, "mm") * cos(alpha) / self.a_w)
            yield self.rows.formula("alpha_w", row, angle)
            if not whole(self.task):
                difference = involute(self.alpha_w(row)) - involute(alpha)
                yield self.rows.formula("x_sum", row, self.teeth_sum(row) * difference / (2 * tan(alpha)))

    @property
    def stated(self) -> bool:
        """Whether the shift coefficients of all wheels are stated."""
        return whole(self.task)

    def transverse(self) -> Iterator[Formula]:
        """Of helical teeth: modules, profile angle and height of the head in the transverse section."""
        turn = cos(self.of["beta"].var())
        for key in ("m",) if one_module(self.given) else ("m_I", "m_II"):
            yield self.of[key].formula(self.of[f"{key}_n"].var("mm") / turn, "mm", digits=6)
        yield self.of["alpha"].formula(arctan(tan(self.of["alpha_n"].var()) / turn), digits=6)
        yield self.of["ha"].formula(self.of["ha_n"].var() * turn, digits=6)

    def least_teeth(self) -> Formula:
        return self.of["least_teeth"].formula(2 * self.ha / sin(self.alpha) ** 2)

    def ring_tip(self, row: int) -> Relation:
        """The ring's tip beyond the limit point of the line of action."""
        wheel = ROWS[row][0]
        tip, base = self.wheel("d_a_full", wheel), self.wheel("d_b", wheel)
        curvature = Side(sqrt(tip**2 - base**2) / 2, self.rows.ref("rho_a", row, "mm"))
        line = Side(self.a_w * sin(self.alpha_w(row)), self.rows.ref("line", row, "mm"))
        return Relation(curvature, ">", line, "mm")

    def involute_start(self, row: int) -> Formula:
        """Radius of curvature of the satellite's flank where the rack's fillet begins."""
        crown, alpha, m = row + 1, self.alpha, self.m(row)
        height: Expr = self.ha - self.wheel("x", crown, "") if self.sizes.shifts[crown] else self.ha
        start = m * self.z(crown) / 2 * sin(alpha) - m * height / sin(alpha)
        return self.rows.formula("rho_l", row, start, "mm")

    def ring_limit(self, row: int) -> Formula | None:
        """The least teeth of the ring beside its satellite, both without shift; None where there is no such number."""
        if not np.isfinite(self.found.rows.least[row]):
            return None
        z, square = self.z(row + 1), sin(self.alpha) ** 2
        value = (z**2 * square - 4 * self.ha**2) / (2 * z * square - 4 * self.ha)
        return self.rows.formula("z_least", row, value)

    def trimmed(self, row: int) -> Formula | None:
        """The ring's tip diameter where full height would touch the satellite's fillets; else None."""
        if not np.isfinite(self.found.rows.cut[row]):
            return None
        base = self.wheel("d_b", ROWS[row][0])
        touching = self.a_w * sin(self.alpha_w(row)) + self.rows.var("rho_l", row, "mm")
        return self.rows.formula("d_a_cut", row, 2 * sqrt((base / 2) ** 2 + touching**2), "mm")

    @property
    def largest_crown(self) -> int:
        return 1 if self.sizes.tip[1] >= self.sizes.tip[2] else 2

    def neighbourhood(self) -> Relation:
        tip = self.wheel("d_a", self.largest_crown)
        apart = Side(2 * self.a_w * sin(HALF_TURN / self.k), self.of["apart"].ref("mm"))
        assert tip.ref is not None
        return Relation(apart, ">", Side(tip, tip.ref), "mm")

    def tip_diameter(self) -> Formula:
        """Of the larger crown, without shift m (z + 2 ha*)."""
        crown = self.largest_crown
        height = self.m(crown - 1) * (self.z(crown) + 2 * self.ha)
        return self.sized.formula("d_a", self.place(crown), height, "mm")

    def assembly(self) -> Formula:
        """(z1 + z3)/k of a single row; of two rows also over the common divisor of the crowns' teeth."""
        if self.scheme.single:
            return self.of["assembly"].formula((self.z(0) + self.z(3)) / self.k)
        one, other = self.z(0) * self.z(2), self.z(1) * self.z(3)
        opposite = self.scheme.rows[0] * self.scheme.rows[1] == INTERNAL
        top = one + other if opposite else abs(one - other)
        return self.of["assembly"].formula(top / (self.k * self.of["divisor"].var()))

    def course_assembly(self) -> Formula | None:
        """The course's C = z1 u1H (1 + k p)/k of two rows; None where no whole p makes it whole."""
        if self.found.turns is None:
            return None
        u, p = self.of["u_carrier"].var(), self.of["turns"].var()
        return self.of["usual_assembly"].formula(abs(self.z(0) * u) / self.k * (1 + self.k * p))

    # ------------------------------------------------------------ sizes, efficiency, loads

    def working(self) -> Iterator[Formula]:
        """Working diameters of wheels without shift."""
        for row, wheel in enumerate(self.scheme.wheels):
            yield self.sized.formula("d_w", row, self.m(0 if wheel < 2 else 1) * self.z(wheel), "mm")

    def efficiency(self) -> Formula:
        """By the way of the power: u η_H or u/η_H in the place of u."""
        motion, eta, u = self.found.motion, self.of["eta_stopped"].var(), self.basic()
        lossy = u * eta if motion.exponent > 0 else u / eta
        value = {
            ("wheel1", "carrier"): (1 - lossy) / (1 - u),
            ("carrier", "wheel1"): (1 - u) / (1 - lossy),
            ("wheel3", "carrier"): (1 - 1 / lossy) / (1 - 1 / u),
            ("carrier", "wheel3"): (1 - 1 / u) / (1 - 1 / lossy),
        }.get((self.task.input, self.task.output), eta)
        row = self.found.motions.index(motion)
        return self.of.table("motions").formula("eta", row, value, digits=4)

    def force(self) -> Formula:
        """The circumferential force on one satellite from wheel 1, of each N·m of its torque, N."""
        return self.of["force"].formula(Number(2) / (self.k * self.wheel("d_w", 0, "m")))
