"""Rows of the balancing's tables written out: shaking at one position, substituted masses, counterweights."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property

from tmm_report.chapters.lever.initial_data import quantities as initial
from tmm_report.chapters.lever.kinematics import quantities as rates
from tmm_report.chapters.machine.balancing.given import OPTIMUM, STATED, SUBSTITUTED
from tmm_report.chapters.machine.balancing.quantities import weights
from tmm_report.chapters.machine.balancing.quantities import whole as q
from tmm_report.chapters.machine.balancing.solve.cases import RMS, Case, Placed
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.chapters.machine.balancing.view.handed import sum_at
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.vector_equations import moving_points, turning_links
from tmm_report.quantity import model
from tmm_report.quantity.formula import Expr, Formula, Number, sqrt
from tmm_report.quantity.model import Book, variable
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page

NOTHING = 1e-9  # of the largest: a term that is rounding


class BalancingRows(ChapterView):
    """Every number of a formula is one of the results."""

    kinds_once = True

    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, q.tables(found))
        self.found = found
        self.linkage = found.kinematics.linkage
        self.mechanism = self.linkage.mechanism

    @cached_property
    def position(self) -> int:
        """The position of which formulas are written out: the first regular one after 0."""
        found = self.found.kinematics
        lost = (*found.singular, *found.missing)
        return next((k for k in range(1, len(found.turned)) if k not in lost), 0)

    @cached_property
    def given(self) -> Book:
        return Book.of(initial.given_tables(self.mechanism), [initial.speed(self.mechanism)])

    @cached_property
    def _motion(self) -> Book:
        return self.page.once(rates.book, self.found.kinematics)

    # ------------------------------------------------------------ the shaking at one position

    def shaking_formulas(self) -> list[Formula]:
        """Both projections of the force, and the moment."""
        table, k = self.table("shaking_table"), self.position
        formulas = [table.formula(f"F_shake_{axis}", k, self._force(axis)) for axis in "xy"]
        return [*formulas, table.formula("M_shake", k, self._moment())]

    def _force(self, axis: str) -> Expr:
        terms = [mass * self._acceleration(point, axis) for mass, point in self._heavy()]
        size = max(abs(term.value) for term in terms)
        return _less([term for term in terms if abs(term.value) > NOTHING * size] or terms)

    def _moment(self) -> Expr:
        return _less([*self._moments(), *self._couples()])

    def _moments(self) -> Iterator[Expr]:
        """m (x a_y − y a_x) of every mass centre that moves."""
        for mass, point in self._heavy():
            ax, ay = (self._acceleration(point, axis) for axis in "xy")
            one, other = self._arm(point, "x") * ay, self._arm(point, "y") * ax
            sizes = abs(mass.value * one.value), abs(mass.value * other.value)
            some = [size > NOTHING * self.found.original.moment_max.value for size in sizes]
            if any(some):
                yield mass * (one - other if all(some) else one if some[0] else -other)

    def _couples(self) -> Iterator[Expr]:
        """J ε of every link that turns unevenly."""
        turning, driver = turning_links(self.linkage), self.mechanism.driver.link
        for row, link in enumerate(initial.heavy_links(self.mechanism)):
            if link.inertia and link.name in turning and link.name != driver:
                rate = rates.link_rate("e", link.name).key
                yield self.given.tables["masses"].var("J", row) * self._rates.var(rate, self.position)

    def _heavy(self) -> Iterator[tuple[Expr, str]]:
        """Mass and mass centre of every link whose centre moves."""
        moving = moving_points(self.linkage)
        for row, link in enumerate(initial.heavy_links(self.mechanism)):
            if link.mass and link.mass_centre in moving:
                yield self.given.tables["masses"].var("m", row), str(link.mass_centre)

    @property
    def _rates(self) -> model.Table:
        return self._motion.tables["rates_table"]

    def _acceleration(self, point: str, axis: str) -> Expr:
        return self._rates.var(f"{rates.point_rate('a', point).key}_{axis}", self.position)

    def _arm(self, point: str, axis: str) -> Expr:
        """From the point of the moments."""
        own = self._motion.tables["positions_table"].var(f"{axis}_{point}", self.position)
        fixed = self.given.tables["fixed_points"]
        row = list(self.mechanism.links[FRAME].points).index(self.found.about)
        away = fixed[axis].number(row)
        quantity = initial.X if axis == "x" else initial.Y
        symbol = Symbol(axis, self.found.about)
        return own - variable(quantity, away, ref=fixed.ref(axis, row), symbol=symbol) if away else own

    # ------------------------------------------------------------ rotors

    def rotor_formulas(self) -> list[Formula]:
        """Of both rotors of the highest order that needs them."""
        rows = [row for row, one in enumerate(self.found.rotors) if one.moment]
        highest = max((abs(self.found.rotors[row].order) for row in rows), default=0)
        found = (self._rotor(row) for row in rows if abs(self.found.rotors[row].order) == highest)
        return [formula for formulas in found for formula in formulas]

    def _rotor(self, row: int) -> Iterator[Formula]:
        """m r = F/(kω)²; the mass, where the radius is stated."""
        table, harmonics = self.table("lanchester_rotors"), self.table("shaking_harmonics")
        order = self.found.rotors[row].order
        of = abs(order) - 1
        force = harmonics.var("F_with" if order > 0 else "F_against", of)
        turns = harmonics.var("order", of) * self.given["omega"].var()
        yield table.formula("mr", row, force / turns**2)
        if self.found.given.radii:
            yield table.formula("m", row, table.var("mr", row) / table.var("r", row))

    # ------------------------------------------------------------ substituted masses

    def split_formulas(self, row: int) -> list[Formula]:
        """Two masses of a link, and what they lack of its moment of inertia."""
        table = self.table("substituted_masses")
        m, a, b = (table.var(key, row) for key in ("m", "a", "b"))
        masses = [table.formula("m_A", row, m * b / (a + b)), table.formula("m_B", row, m * a / (a + b))]
        if not table["J"].number(row):
            return masses
        off = table.var("off", row) if table["off"].number(row) else None
        reach = [arm**2 + off**2 if off else arm**2 for arm in (a, b)]
        rest = table.var("J", row) - table.var("m_A", row) * reach[0] - table.var("m_B", row) * reach[1]
        return [*masses, table.formula("J_rest", row, rest)]

    def three_masses(self, row: int) -> list[Formula]:
        """Three masses that keep the moment of inertia too; none where the centre is off the line of the joints."""
        table = self.table("substituted_masses")
        if math.isnan(table["m_S3"].number(row)):
            return []
        m, inertia, a, b = (table.var(key, row) for key in ("m", "J", "a", "b"))
        return [
            table.formula("m_A3", row, inertia / (a * (a + b))),
            table.formula("m_B3", row, inertia / (b * (a + b))),
            table.formula("m_S3", row, m - inertia / (a * b)),
        ]

    # ------------------------------------------------------------ counterweights

    def counterweight_formulas(self, case: Case) -> list[list[Formula]]:
        """Static moment and mass, or distance, of every counterweight of a way of balancing."""
        placed = enumerate(weights.placed(self.found.cases))
        return [list(self._counterweight(case, one, row)) for row, (other, one) in placed if other is case]

    def _counterweight(self, case: Case, one: Placed, row: int) -> Iterator[Formula]:
        table = self.table("counterweights")
        if case.name == STATED:
            return
        yield from self._moment_of(case, one, row)
        yield table.formula("U", row, self._size(case, one, row))
        if self.found.given.counterweights[one.link].distance is not None:
            yield table.formula("m_c", row, table.var("U", row) / table.var("rho", row))
        else:
            yield table.formula("rho", row, table.var("U", row) / table.var("m_c", row))

    def _moment_of(self, case: Case, one: Placed, row: int) -> Iterator[Formula]:
        """Both projections of the static moment, where it has them."""
        table = self.table("counterweights")
        axes = [axis for axis, part in (("x", one.moment.real), ("y", one.moment.imag)) if part]
        if one.carried is not None:
            rows = self._masses_of(case, one.link)
            for mass in rows:
                yield from self._sum_of(case, mass)
            for axis in axes:
                yield table.formula(f"U_{axis}", row, self._met(axis, rows))

    def _size(self, case: Case, one: Placed, row: int) -> Expr:
        """Of the static moment, from its projections; of a single counterweight, from those of the point that it is to
        shift into the origin."""
        axes = [axis for axis, part in (("x", one.moment.real), ("y", one.moment.imag)) if part]
        if case.name.startswith(OPTIMUM):
            key = "seen_mean" if case.name.endswith(RMS) else "seen"
            parts = [self.s.var(f"{key}_{axis}") for axis in axes]
        else:
            parts = [self.table("counterweights").var(f"U_{axis}", row) for axis in axes]
        return abs(parts[0]) if len(parts) == 1 else sqrt(parts[0] ** 2 + parts[1] ** 2)

    def _masses_of(self, case: Case, link: str) -> list[int]:
        table = self.table("counterweight_masses")
        rows = zip(table["method"].values, table["link"].values, strict=True)
        return [row for row, names in enumerate(rows) if names == (case.name, link)]

    def _sum_of(self, case: Case, row: int) -> Iterator[Formula]:
        """A mass that is the sum of those of several links and of their counterweights."""
        table, others = self.table("counterweight_masses"), self.table("counterweights")
        _, one, met = weights.met(self.found.cases)[row]
        if case.name == SUBSTITUTED:
            joined = sum_at(self.found, self, self.given, one.link, met.name, met.mass)
            if joined is not None:
                yield table.formula("m", row, joined)
            return
        links = met.links
        heavy = [link.name for link in initial.heavy_links(self.mechanism)]
        masses = [
            self.given.tables["masses"].var("m", heavy.index(link))
            for link in links
            if link in heavy and self.mechanism.links[link].mass
        ]
        places = zip(others["method"].values, others["link"].values, strict=True)
        added = [k for k, (way, link) in enumerate(places) if way == case.name and link in links]
        terms: list[Expr] = [*masses, *(others.var("m_c", k) for k in added)]
        if len(terms) > 1:
            total = sum(terms[1:], terms[0])
            yield table.formula("m", row, total)

    def _met(self, axis: str, rows: list[int]) -> Expr:
        """−Σ m x, without the masses that have no arm on the axis."""
        table = self.table("counterweight_masses")
        used = [row for row in rows if table[axis].number(row)]
        return _less([table.var("m", row) * table.var(axis, row) for row in used])


def _less(terms: Sequence[Expr]) -> Expr:
    """− a − b − c; 0 of nothing."""
    first, *others = terms or [Number(0)]
    total: Expr = -first
    for term in others:
        total = total - term
    return total
