"""Contours of the dyads (Assur groups of class II) as a textbook writes them: projections, solution, derivatives.

Every dyad's contour is x(u, w) = 0, y(u, w) = 0 of two unknowns u, w; differentiated it gives linear equations,

    k11 u′ + k12 w′ = b1,   k21 u′ + k22 w′ = b2        (velocities)
    k11 u″ + k12 w″ = d1,   k21 u″ + k22 w″ = d2        (accelerations)

solved by determinants (Cramer). Source: Artobolevsky, Theory of mechanisms and machines, ch. 5; Levitsky, ch. 3.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.contours.known import Line, Pose, Spot
from tmm_report.chapters.lever.kinematics.contours.nodes import Sides, times, total
from tmm_report.chapters.lever.kinematics.contours.worked import Bench
from tmm_report.chapters.lever.kinematics.solve import points_and_links as q
from tmm_report.mechanics.lever.assur_groups import Group
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Formula, Negative, Term, Var, VectorEquation, cos, sin
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.terms.directions import X_OF, Y_OF
from tmm_report.records import dataclass

Array = Any
Two = tuple[Expr, Expr]

BEARING = N_("angle of segment %(of)s with the x axis")
AT_JOINT = N_("angle at joint %(of)s of the triangle of the group")
FROM_GUIDE = N_("distance of joint %(of)s from the line of guide %(guide)s")
OFFSET = N_("distance of joint %(of)s from the parallel to guide %(guide)s through joint %(other)s")
GUIDE_TURNED = N_("angle of guide %(of)s with the x axis")
SLID = N_("displacement of link %(link)s along guide %(guide)s from point %(of)s")
SLID_RATE = N_(
    "first derivative of the displacement of link %(link)s along guide %(guide)s, its relative velocity"
)
SLID_BEND = N_("second derivative of the displacement of link %(link)s along guide %(guide)s")
COEFFICIENT = N_("coefficient of the differentiated equations of group %(group)s")
KNOWN_V = N_("known part of the velocity equations of group %(group)s")
KNOWN_A = N_("known part of the acceleration equations of group %(group)s")
DETERMINANT = N_("determinant of the equations of group %(group)s")


@dataclass(frozen=True, eq=False)
class Written:
    """What is written out of a group: its vector equation, both projections, the solution for the position, both
    projections differentiated, the solution for velocities and for accelerations, and other points of its links."""

    group: Group
    vectors: tuple[VectorEquation, ...]
    projections: tuple[Sides, ...]
    positions: list[Formula]
    differentiated: tuple[Sides, ...]
    velocities: list[Formula]
    accelerations: list[Formula]
    points: list[Formula]


@dataclass(frozen=True, eq=False)
class Rate:
    """An unknown's first or second derivative: its quantity, the table where the solver has it ("" of the
    contours' own) and its values there."""

    quantity: Quantity
    table: str = ""
    values: Array = None


@dataclass(frozen=True, eq=False)
class Unknown:
    """An unknown of a contour: an angle, or a displacement."""

    first: Rate
    second: Rate
    angular: bool


@dataclass(frozen=True, eq=False)
class Equations:
    """The contour in projections, its coefficients by u and w and the known parts, each in x and in y."""

    left: Two
    right: Two
    by_u: Two
    by_w: Two
    known: Two


# ---------------------------------------------------------------- linear equations


def quantity(key: str, symbol: Symbol, unit: str, text: str, **values: str) -> Quantity:
    return Quantity(key, symbol, unit, Message(text, dict(values)))


class System:
    """Two linear equations of a group: coefficients once, then solved for velocities and for accelerations."""

    def __init__(self, bench: Bench, d: Dyad, u: Unknown, w: Unknown, eq: Equations):
        self.bench, self.group, self.u, self.w = bench, d.group.label, u, w
        units = ["m" if unknown.angular else "" for unknown in (u, w)]
        (self.k11, self.k21), (self.k12, self.k22) = (
            (self._coefficient(f"1{n}", by[0], unit), self._coefficient(f"2{n}", by[1], unit))
            for n, by, unit in ((1, eq.by_u, units[0]), (2, eq.by_w, units[1]))
        )
        size = quantity(
            f"det_{self.group}", Symbol("Delta"), {0: "", 1: "m", 2: "m²"}[units.count("m")], DETERMINANT,
            group=self.group,
        )  # fmt: skip
        self.det = bench.own(size, self.k11 * self.k22 - self.k12 * self.k21, known=True)
        self.velocities = self._solved("b", KNOWN_V, "m/s", eq.known, [u.first, w.first])

    def _coefficient(self, n: str, expression: Expr, unit: str) -> Var:
        of = quantity(f"k{n}_{self.group}", Symbol("k", n), unit, COEFFICIENT, group=self.group)
        return self.bench.own(of, expression, known=True)

    def accelerations(self, known: Two) -> tuple[Var, Var]:
        return self._solved("d", KNOWN_A, "m/s²", known, [self.u.second, self.w.second])

    def _solved(self, letter: str, text: str, unit: str, known: Two, rates: list[Rate]) -> tuple[Var, Var]:
        b1, b2 = (
            self.bench.own(
                quantity(f"{letter}{n}_{self.group}", Symbol(letter, str(n)), unit, text, group=self.group),
                one,
                known=True,
            )
            for n, one in enumerate(known, 1)
        )
        u = self._found(rates[0], (b1 * self.k22 - b2 * self.k12) / self.det)
        w = self._found(rates[1], (b2 * self.k11 - b1 * self.k21) / self.det)
        return u, w

    def _found(self, rate: Rate, expression: Expr) -> Var:
        if rate.table:
            return self.bench.solved(rate.table, rate.quantity, expression, rate.values)
        return self.bench.own(rate.quantity, expression)


def turning(bench: Bench, link: str) -> Unknown:
    """ω and ε of a link."""
    first, second = (
        Rate(q.link_rate(letter, link), "rates_table", bench.found.values[f"{letter}_{link}"])
        for letter in "we"
    )
    return Unknown(first, second, angular=True)


def sliding(link: str, guide: str) -> Unknown:
    """The derivatives of a displacement along a guide."""
    of = {"link": link, "guide": guide}
    return Unknown(
        Rate(Quantity(f"s1_{link}", Symbol("s′", link), "m/s", Message(SLID_RATE, of))),
        Rate(Quantity(f"s2_{link}", Symbol("s′′", link), "m/s²", Message(SLID_BEND, of))),
        angular=False,
    )


def slid(link: str, guide: str, start: str) -> Quantity:
    """The displacement of a link along a guide."""
    return quantity(f"s_{link}", Symbol("s", link), "m", SLID, link=link, guide=guide, of=start)


def bearing(ends: str) -> Quantity:
    return quantity(f"phi_{ends}", Symbol("phi", ends), "deg", BEARING, of=ends)


def differentiated(bench: Bench, u: Unknown, w: Unknown, eq: Equations) -> tuple[Sides, Sides]:
    """The projections differentiated, in symbols."""
    one, other = (Var(unknown.first.quantity.sign, 0.0) for unknown in (u, w))
    x, y = (
        Sides(total([_by(eq.by_u[n], one), _by(eq.by_w[n], other)]), eq.known[n], bench.index) for n in (0, 1)
    )
    return x, y


def _by(coefficient: Expr, unknown: Expr) -> tuple[int, Expr]:
    """A term of an equation, its minus apart."""
    if isinstance(coefficient, Negative):
        return -1, coefficient.body * unknown
    return 1, coefficient * unknown


def projected(bench: Bench, left: Two, right: Two) -> tuple[Sides, Sides]:
    return Sides(left[0], right[0], bench.index), Sides(left[1], right[1], bench.index)


def vectors(left: list[str | Symbol], right: list[Symbol | str]) -> tuple[VectorEquation, ...]:
    return (VectorEquation([[Term(x) for x in left], [Term(x) for x in right]]),)


def inner_point(bench: Bench, point: str, at: Two) -> Spot:
    """The inner joint of a group, by its place."""
    place = bench.motion.place(point)
    for n, (text, values) in enumerate(((X_OF, place.real), (Y_OF, place.imag))):
        bench.solved("positions_table", q.coordinate("xy"[n], text, point), at[n], values)
    return bench.spot(point)


def inner_rates(bench: Bench, letter: str, point: str, parts: list[list[tuple[int, Expr | None]]]) -> None:
    """Velocity "v" or acceleration "a" of the inner joint, by its terms in x and in y."""
    values = bench.found.values[f"{letter}_{point}"]
    components = q.point_rate(letter, point).components
    for n, (component, terms) in enumerate(zip(components, parts, strict=True)):
        bench.solved("rates_table", component, total(terms), (values.real, values.imag)[n])


def turned_velocity(start: Spot, length: Expr, angle: Expr, w: Expr) -> list[list[tuple[int, Expr | None]]]:
    """Velocity of the end of a segment that turns about a point."""
    v = start.v or (None, None)
    return [[(1, v[0]), (-1, length * w * sin(angle))], [(1, v[1]), (1, length * w * cos(angle))]]


def turned_acceleration(
    start: Spot, length: Expr, angle: Expr, w: Expr, e: Expr | None
) -> list[list[tuple[int, Expr | None]]]:
    a = start.a or (None, None)
    return [
        [(1, a[0]), (-1, length * w**2 * cos(angle)), (-1, times(length, e, sin(angle)))],
        [(1, a[1]), (-1, length * w**2 * sin(angle)), (1, times(length, e, cos(angle)))],
    ]


def arg(z: complex) -> float:
    """Its angle, rad."""
    return float(np.angle(z))


def outer_line(bench: Bench, guide: str, carrier: str, pair: Any, link: str, arm: complex) -> Line:
    """The line on which the end of a sliding link's arm runs, fixed to the carrier of the outer guide."""
    along = pair.along[carrier]
    return bench.line(guide, carrier, pair.at[carrier] + along * np.conj(pair.along[link]) * arm, along)


def on_guide(base: Spot, origin: complex, along: complex, line: Line) -> Pose:
    """A link that slides along a line: it turns with it."""
    return Pose(base, origin, line.beta, arg(along), line.w, line.e)
