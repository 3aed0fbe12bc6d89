"""Where the contours of the groups are worked out: what is known of points, lines and links, and what is found, as
variables of formulas that carry their numbers at all table positions.

A formula's numbers are arrays (P,) over the table positions; it is printed at one of them. What the solver found itself
(places, velocities, angular rates) is taken from its tables; what only the contours need is worked out here and kept
in tables of their own.
"""

from __future__ import annotations

from dataclasses import field, replace
from typing import Any

import numpy as np

from tmm_report.chapters.lever.initial_data import quantities as given
from tmm_report.chapters.lever.kinematics.contours.carried_point import Moved
from tmm_report.chapters.lever.kinematics.contours.known import Line, Pose, Spot
from tmm_report.chapters.lever.kinematics.solve import points_and_links as q
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import SINGULAR
from tmm_report.mechanics.lever.vector_equations import moving_points, turning_links
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.model import Book, Quantity, variable
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.terms.directions import X_OF, Y_OF
from tmm_report.records import dataclass

Array = Any
TABLE, CONSTANTS = "contours", "contour_constants"
STRAIGHT = 1e-12  # rad: an angle within a link that is no more than rounding

LENGTH = N_("length of segment %(of)s")
WITHIN = N_("constant angle of segment %(of)s with the direction from which its link's angle is counted")
OF_GUIDE = N_("constant angle of guide %(of)s with the direction from which its link's angle is counted")
GUIDE_ANGLE = N_("angle of guide %(of)s with the x axis")
AUXILIARY = N_("%(axis)s coordinate of point %(of)s of a guide")


@dataclass
class Bench:
    """`index`: the table position that is written out."""

    found: Kinematics
    index: int
    columns: dict[str, tuple[Quantity, Array]] = field(default_factory=dict)
    constants: dict[str, tuple[Quantity, float]] = field(default_factory=dict)
    formulas: list[Formula] = field(default_factory=list)
    poses: dict[str, Pose] = field(default_factory=dict)
    checks: list[tuple[Formula, Array]] = field(default_factory=list)
    named: int = 0  # points to which a name was given here

    def __post_init__(self) -> None:
        self.motion, self.linkage = self.found.table, self.found.linkage
        self.mechanism = self.linkage.mechanism
        near = [sine <= SINGULAR for sine in self.motion.sines.values()]
        self.singular = np.logical_or.reduce([np.zeros(self.found.turned.shape, dtype=bool), *near])
        self.fixed = list(self.mechanism.links[FRAME].points)
        self.moving_order = moving_points(self.linkage)
        self.moving = set(self.moving_order)
        self.turning = set(turning_links(self.linkage))
        tables = Book.of(given.given_tables(self.mechanism)).tables
        self.dimensions, self.fixed_points = tables["dimensions"], tables["fixed_points"]
        self.known_lengths = dict(
            zip(self.dimensions["key"].values, self.dimensions["length"].values, strict=True)
        )

    # ------------------------------------------------------------ what is found

    def own(self, quantity: Quantity, expression: Expr, known: bool = False) -> Var:
        """A number that only the contours need, by its formula. `known`: what its symbol means was said for all."""
        ref = Ref(quantity.key, self.index, TABLE)
        meaning = None if known else quantity.meaning
        found = self._keep(quantity, expression, ref, meaning).value
        values = self._told(found)
        self.columns[quantity.key] = quantity, np.degrees(values) if quantity.unit == "deg" else values
        return Var(quantity.sign, values, quantity.unit, ref=ref, meaning=meaning)

    def _told(self, values: Array) -> Array:
        """A number at all positions, nan in singular ones: what is found there is made of rounding errors."""
        return np.where(
            self.singular, np.nan, np.broadcast_to(np.asarray(values, dtype=float), self.singular.shape)
        )

    def kept(self, quantity: Quantity, values: Array) -> Var:
        """A number that only the contours need, as the solver's motion gives it."""
        values = self._told(values)
        self.columns[quantity.key] = quantity, values
        ref = Ref(quantity.key, self.index, TABLE)
        return Var(quantity.sign, values, quantity.unit, ref=ref, meaning=quantity.meaning)

    def solved(self, table: str, quantity: Quantity, expression: Expr, values: Array) -> Var:
        """A number that the solver has found, by its formula. What coordinates and projections are was said for all."""
        ref = Ref(quantity.key, self.index, table)
        meaning = quantity.meaning if quantity.unit.startswith("rad") else None
        formula = self._keep(quantity, expression, ref, meaning)
        self.checks.append((formula, values))
        return Var(quantity.sign, values, quantity.unit, ref=ref, meaning=meaning)

    def _keep(self, quantity: Quantity, expression: Expr, ref: Ref, meaning: Message | None) -> Formula:
        formula = Formula(
            quantity.sign, expression, quantity.unit, index=self.index, ref=ref, meaning=meaning
        )
        self.formulas.append(formula)
        return formula

    def constant(self, quantity: Quantity, value: float) -> Var:
        """A number of the mechanism that stands nowhere else: an angle in rad."""
        self.constants.setdefault(quantity.key, (quantity, float(value)))
        ref = Ref(quantity.key, None, CONSTANTS, by="value")
        return Var(quantity.sign, float(value), quantity.unit, ref=ref, meaning=quantity.meaning)

    def taken(self) -> list[Formula]:
        """The formulas since the last time."""
        taken, self.formulas = self.formulas, []
        return taken

    # ------------------------------------------------------------ numbers of the solver

    def of_table(self, table: str, quantity: Quantity, values: Array) -> Var:
        ref = Ref(quantity.key, self.index, table)
        return Var(quantity.sign, values, quantity.unit, ref=ref, meaning=quantity.meaning)

    def w(self, link: str) -> Var | None:
        """Angular velocity of a link; None of one that cannot turn."""
        if link not in self.turning:
            return None
        return self.of_table("rates_table", q.link_rate("w", link), self.found.values[f"w_{link}"])

    def e(self, link: str) -> Var | None:
        """Angular acceleration; None, too, of a driving link that turns evenly."""
        driver = self.mechanism.driver
        if link not in self.turning or (link == driver.link and driver.law is None):
            return None
        return self.of_table("rates_table", q.link_rate("e", link), self.found.values[f"e_{link}"])

    def rate(self, letter: str, point: str) -> tuple[Var, Var]:
        """Projections of a point's velocity "v" or acceleration "a"."""
        x, y = q.point_rate(letter, point).components
        values = self.found.values[f"{letter}_{point}"]
        return self._said("rates_table", x, values.real), self._said("rates_table", y, values.imag)

    def _said(self, table: str, quantity: Quantity, values: Array) -> Var:
        """`of_table` of a coordinate or projection, which is explained for all points."""
        return replace(self.of_table(table, quantity, values), meaning=None)

    def spot(self, point: str) -> Spot:
        """A named point."""
        if point not in self.moving:
            row, place = self.fixed.index(point), self.mechanism.links[FRAME].points[point]
            x, y = (
                replace(variable(one, number, ref=self.fixed_points.ref(axis, row)), meaning=None)
                for axis, one, number in (
                    ("x", q.coordinate("x", X_OF, point), place.real),
                    ("y", q.coordinate("y", Y_OF, point), place.imag),
                )
            )
            return Spot(point, x, y)
        place = self.motion.place(point)
        x = self._said("positions_table", q.coordinate("x", X_OF, point), place.real)
        y = self._said("positions_table", q.coordinate("y", Y_OF, point), place.imag)
        return Spot(point, x, y, self.rate("v", point), self.rate("a", point))

    # ------------------------------------------------------------ lengths and angles within links

    def length(self, one: str, other: str, size: float) -> Var:
        """Of the segment between two points of a link: as the initial data have it, or one of the contours' own."""
        for ends in (one + other, other + one):
            key = given.length(ends).key
            if key in self.known_lengths and abs(self.known_lengths[key] - size) <= 1e-9 * size:
                return variable(given.length(ends), size, ref=self.dimensions.by_key(key, "length"))
        return self.constant(given.length(one + other), size)

    def within(self, ends: str, angle: float, text: str = WITHIN) -> Var | None:
        """A constant angle within a link, rad; None where it is nothing."""
        angle = float(np.angle(np.exp(1j * angle)))
        if abs(angle) <= STRAIGHT:
            return None
        quantity = Quantity(f"gamma_{ends}", Symbol("gamma", ends), "deg", Message(text, {"of": ends}))
        return replace(self.constant(quantity, angle), meaning=None)  # explained for all segments

    def turned(self, pose: Pose, ends: str, at: complex, text: str = WITHIN) -> Expr:
        """The angle with the x axis of a direction `at` in a link's axes."""
        if pose.angle is None:
            raise ValueError("the frame has no angle")
        added = self.within(ends, float(np.angle(at)) - pose.zero, text)
        return pose.angle if added is None else pose.angle + added

    # ------------------------------------------------------------ points and lines of known links

    def point_of(self, link: str, point: str) -> None:
        """Write out place, velocity and acceleration of a named point of a link whose pose is known."""
        pose = self.poses[link]
        arm = self.mechanism.links[link].points[point] - pose.origin
        moved = Moved(self, pose, pose.base.name, point, arm)
        place, v, a = (self.motion.place(point), *(self.found.values[f"{x}_{point}"] for x in "va"))
        for axis, text, values in ((0, X_OF, place.real), (1, Y_OF, place.imag)):
            self.solved("positions_table", q.coordinate("xy"[axis], text, point), moved.place(axis), values)
        for letter, values, terms in (("v", v, moved.velocity), ("a", a, moved.acceleration)):
            for axis, component in enumerate(q.point_rate(letter, point).components):
                self.solved("rates_table", component, terms(axis), (values.real, values.imag)[axis])

    def take_pose(self, link: str) -> None:
        """The pose of a link as the solver has found it."""
        points = self.mechanism.links[link].points
        name = next((p for p in points if p in self.moving or p in self.fixed), None)
        if name is None:
            return
        angle = self.of_table("positions_table", q.angle(link), np.angle(self.motion.turn(link)))
        if link not in self.turning:
            angle = self.constant(_beta(link), float(np.angle(self.motion.turn(link)[self.index])))
        self.poses[link] = Pose(
            self.spot(name), complex(points[name]), angle, 0.0, self.w(link), self.e(link)
        )

    def line(self, guide: str, link: str, through: complex, along: complex) -> Line:
        """A line fixed to a known link, by a point of it and its unit direction in the link's axes."""
        through, along = complex(through), complex(along)
        named, beta = self._on_line(link, through, along), self.direction(guide, link, along)
        if link == FRAME:
            return Line(guide, self.spot(named) if named else self._fixed_spot(through), beta, None, None)
        at = self.spot(named) if named else self._carried_spot(link, through)
        return Line(guide, at, beta, self.poses[link].w, self.poses[link].e)

    def direction(self, guide: str, link: str, along: complex) -> Expr:
        """The angle of a guide with the x axis, by its unit direction in the axes of a known link."""
        return self.bearing(_beta(guide), guide, link, along)

    def bearing(self, quantity: Quantity, name: str, link: str, along: complex) -> Expr:
        """The angle with the x axis of a direction fixed to a known link."""
        if link == FRAME:
            return self.constant(quantity, float(np.angle(along)))
        turned = self.turned(self.poses[link], name, along, OF_GUIDE)
        return turned if isinstance(turned, Var) else self.own(quantity, turned)

    def _on_line(self, link: str, through: complex, along: complex) -> str | None:
        """A named point of a link that lies on the line, a joint rather than another point."""
        points = self.mechanism.links[link].points
        size = max((abs(z) for z in points.values()), default=0.0) + abs(through)
        on = [p for p, z in points.items() if abs(cross(along, complex(z) - through)) <= 1e-12 * size]
        return next(iter(sorted(on, key=lambda p: len(self.mechanism.links_at(p)) < 2)), None)

    def new_point(self) -> str:
        """A name for a point that has none: one that no point of the mechanism has."""
        self.named += 1
        while f"G{self.named}" in self.mechanism.point_names:
            self.named += 1
        return f"G{self.named}"

    def auxiliary(self, link: str, place: complex) -> Spot:
        """A point of a known link that has no name, by its place in the link's axes."""
        return self._fixed_spot(place) if link == FRAME else self._carried_spot(link, place)

    def _fixed_spot(self, place: complex) -> Spot:
        name = self.new_point()
        x, y = (
            self.constant(_auxiliary(axis, name), at) for axis, at in (("x", place.real), ("y", place.imag))
        )
        return Spot(name, x, y)

    def _carried_spot(self, link: str, place: complex) -> Spot:
        """A point of a moving link that has no name, by its place in the link."""
        pose, name = self.poses[link], self.new_point()
        moved = Moved(self, pose, pose.base.name, name, place - pose.origin)
        x, y = (self.own(_auxiliary("xy"[axis], name), moved.place(axis), known=True) for axis in (0, 1))
        v, a = (
            tuple(
                self.own(one, terms(axis), known=True)
                for axis, one in enumerate(q.point_rate(letter, name).components)
            )
            for letter, terms in (("v", moved.velocity), ("a", moved.acceleration))
        )
        return Spot(name, x, y, (v[0], v[1]), (a[0], a[1]))


def _beta(guide: str) -> Quantity:
    return Quantity(f"beta_{guide}", Symbol("beta", guide), "deg", Message(GUIDE_ANGLE, {"of": guide}))


def _auxiliary(axis: str, name: str) -> Quantity:
    return Quantity(f"{axis}_{name}", Symbol(axis, name), "m", Message(AUXILIARY, {"axis": axis, "of": name}))
