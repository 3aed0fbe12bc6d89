"""Formulas of the balance of a rotor: in symbols, in numbers, with their value."""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from operator import add

import numpy as np

from tmm_report.chapters.machine.rotor import quantities as q
from tmm_report.chapters.machine.rotor.solve import Found
from tmm_report.quantity.formula import Expr, Formula, Page, Piece, arccos, cos, sin, sqrt
from tmm_report.quantity.model import Book, Table
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class FullTurn(Expr):
    """The 360° of the formula itself."""

    def evaluate(self, digits: int | None = None) -> float:
        return 2 * np.pi

    def piece(self, page: Page) -> Piece:
        return page.number(2 * np.pi, 10, degrees=True)


class RotorFormulas:
    """What the template prints."""

    def __init__(self, found: Found):
        self.found = found
        self.book = Book.of(q.tables(found), q.values(found))
        self.masses: Table = self.book.tables["rotor_masses"]
        self.weights: Table = self.book.tables["rotor_corrections"]

    # --- sums of unbalances and of moments

    def product(self) -> Formula | None:
        """D = m r of the first mass that is stated so; None where all unbalances are stated as they are."""
        known = [k for k, one in enumerate(self.found.given.heavy) if one.mass and one.radius]
        if not known:
            return None
        k = known[0]
        return self.masses.formula("D", k, self.masses.var("m", k) * self.masses.var("r", k))

    def sums(self) -> Iterator[Formula]:
        """Components of Σ D and its size."""
        for axis, turn in (("x", cos), ("y", sin)):
            terms = [self.masses.var("D", k) * turn(self.masses.var("alpha", k)) for k in self._unbalanced]
            if terms:
                yield self.book[f"rotor_D_{axis}"].formula(reduce(add, terms), scale=self.found.size)
        yield self._size("D")

    def moments(self) -> Iterator[Formula]:
        """Components of the sum of the moments about plane I and its size."""
        for axis, turn in (("x", cos), ("y", sin)):
            terms = [
                self.masses.var("D", k) * self.masses.var("l", k) * turn(self.masses.var("alpha", k))
                for k in self._unbalanced
                if self.masses["l"].values[k]
            ]
            terms += [self.masses.var(f"J_{axis}z", k) for k in self.skewed]
            if terms:
                scale = self.found.size * self.found.length
                yield self.book[f"rotor_M_{axis}"].formula(reduce(add, terms), scale=scale)
        yield self._size("M")

    def _size(self, letter: str) -> Formula:
        parts = (self.book[f"rotor_{letter}_{axis}"].var() for axis in "xy")
        return self.book[f"rotor_{letter}"].formula(sqrt(reduce(add, (part**2 for part in parts))))

    @property
    def _unbalanced(self) -> list[int]:
        return [k for k, one in enumerate(self.found.given.heavy) if one.product]

    @property
    def skewed(self) -> list[int]:
        return [k for k, one in enumerate(self.found.given.heavy) if one.couple]

    @property
    def pulls(self) -> bool:
        """Whether the sum of the unbalances is anything."""
        return abs(self.found.resultant) > 1e-9 * self.found.size

    @property
    def turns(self) -> bool:
        """Whether any unbalance has a moment about plane I."""
        return bool(np.max(np.abs(self.found.moments)) > 1e-9 * self.found.size * self.found.length)

    def direction(self) -> Formula:
        """Angle of the sum from x."""
        turned = arccos(self.book["rotor_D_x"].var() / self.book["rotor_D"].var())
        upwards = self.found.resultant.imag >= 0
        return self.book["rotor_alpha"].formula(turned if upwards else FullTurn() - turned)

    def eccentricity(self) -> Formula:
        return self.book["rotor_e"].formula(self.book["rotor_D"].var() / self.book["rotor_mass"].var())

    # --- weights

    def balancing(self) -> Iterator[Formula]:
        """Components of what balances: of plane II first, by the moments; then of plane I, by the forces."""
        if self.found.two:
            for axis in "xy":
                moment, between = self.book[f"rotor_M_{axis}"].var(), self.book["rotor_L"].var()
                yield self.weights.formula(f"D_{axis}", 1, -(moment / between), scale=self.found.size)
            for axis in "xy":
                second = self.weights.var(f"D_{axis}", 1)
                total = -self.book[f"rotor_D_{axis}"].var() - second
                yield self.weights.formula(f"D_{axis}", 0, total, scale=self.found.size)
        else:
            for axis in "xy":
                total = -self.book[f"rotor_D_{axis}"].var()
                yield self.weights.formula(f"D_{axis}", 0, total, scale=self.found.size)

    def balancing_sizes(self) -> Iterator[Formula]:
        for row in reversed(range(len(self.weights))):
            parts = [self.weights.var(f"D_{axis}", row) for axis in "xy"]
            yield self.weights.formula("D", row, sqrt(parts[0] ** 2 + parts[1] ** 2))

    def weight(self) -> Iterator[Formula]:
        """The mass from the distance, or the distance from the mass."""
        for row, plane in enumerate(self.found.given.planes):
            product = self.weights.var("D", row)
            if plane.mass is None:
                yield self.weights.formula("m", row, product / self.weights.var("r", row))
            else:
                yield self.weights.formula("r", row, product / self.weights.var("m", row))

    # --- by the polygons

    def read(self) -> Iterator[Formula]:
        """Products by the closing vectors as read."""
        of, table = self.book, self.book.tables["rotor_comparison"]
        sizes = {quantity.key: (quantity, graph) for quantity, graph, _ in q.compared(self.found)}
        if self.found.two:
            quantity, _ = sizes["D_II"]
            between = of["rotor_L"].var(size=True)
            expression = of["rotor_closing_M"].var() * of["rotor_mu_M"].var() / between
            ref = table.by_key("D_II", "graph")
            yield Formula(quantity.sign, expression, quantity.unit, ref=ref, meaning=quantity.meaning)
        quantity, _ = sizes["D_I"]
        expression = of["rotor_closing_D"].var() * of["rotor_mu_D"].var()
        ref = table.by_key("D_I", "graph")
        yield Formula(quantity.sign, expression, quantity.unit, ref=ref, meaning=quantity.meaning)

    # --- bearings and limits

    def carried(self) -> Iterator[Formula]:
        """Unbalances in the planes of the bearings: of B by the moments about A, of A by the sum; then their sizes."""
        table, of = self.book.tables["rotor_bearings"], self.book
        back = self.weights.var("z", 0) - table.var("z", 0)
        for axis in "xy":
            moment = of[f"rotor_M_{axis}"].var() + of[f"rotor_D_{axis}"].var() * back
            yield table.formula(f"D_{axis}", 1, moment / of["rotor_L_AB"].var(), scale=self.found.size)
        for axis in "xy":
            total = of[f"rotor_D_{axis}"].var() - table.var(f"D_{axis}", 1)
            yield table.formula(f"D_{axis}", 0, total, scale=self.found.size)
        for row in (0, 1):
            x, y = (table.var(f"D_{axis}", row) for axis in "xy")
            yield table.formula("D_before", row, sqrt(x**2 + y**2))

    def force(self) -> Iterator[Formula]:
        """Of the bearings, by their unbalances."""
        table = self.book.tables["rotor_bearings"]
        for row in (0, 1):
            expression = table.var("D_before", row) * self.book["rotor_omega"].var() ** 2
            yield table.formula("R_before", row, expression)

    def permissible(self) -> Formula:
        of = self.book
        expression = of["rotor_mass"].var() * of["rotor_G"].var() / (1000 * of["rotor_omega"].var())
        return of["rotor_D_per"].formula(expression)
