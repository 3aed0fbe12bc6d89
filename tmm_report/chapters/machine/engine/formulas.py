"""Formulas of the balance of an engine: in symbols, in numbers, with their value."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.machine.engine import quantities as q
from tmm_report.chapters.machine.engine.drawn import LETTERS, Star, stars
from tmm_report.chapters.machine.engine.solve import Found
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Formula, Number, Var, cos
from tmm_report.quantity.model import Book, Table
from tmm_report.quantity.symbols import Symbol

MASS, RADIUS, SPEED = Var("m", 0.0), Var("r", 0.0), Var("omega", 0.0)
LAMBDA, THETA = Var("lambda", 0.0), Var(Symbol("theta", "i"), 0.0)


class EngineFormulas:
    """What the template prints."""

    def __init__(self, found: Found):
        self.found = found
        self.book = Book.of(q.tables(found), q.values(found))
        self.stars = list(stars(found))

    def table(self, name: str) -> Table:
        return self.book.tables[f"engine_{name}"]

    def var(self, key: str) -> Var:
        return self.book[f"engine_{key}"].var()

    # --- masses and sizes

    def masses(self) -> Iterator[Formula]:
        """The rod's mass split between the pins; nothing where no rod is stated."""
        if self.found.given.rod is None:
            return
        upper = self.var("m_rod") * self.var("a") / self.var("l")
        yield self.book["engine_m"].formula(self.var("m_piston") + upper)
        lower: Expr = self.var("m_rod") * (self.var("l") - self.var("a")) / self.var("l")
        if self.found.given.rotating:
            lower = self.var("m_crank") + lower
        yield self.book["engine_m_rot"].formula(lower)

    def sizes(self) -> Iterator[Formula]:
        yield self.book["engine_lambda"].formula(self.var("r") / self.var("l"))
        yield self.book["engine_unit"].formula(self.var("m") * self.var("r") * self.var("omega") ** 2)

    def of_one(self) -> Definition:
        """The inertia force of a cylinder along its axis."""
        series = cos(THETA) + LAMBDA * cos(2 * THETA) - LAMBDA**3 / 4 * cos(4 * THETA)
        return Definition(Symbol("F", "i"), MASS * RADIUS * SPEED**2 * series)

    def turned(self) -> Definition:
        """The angle of a crank from its cylinder's axis."""
        angle = Var("phi", 0.0) + Var(Symbol("psi", "i"), 0.0) - Var(Symbol("beta", "i"), 0.0)
        return Definition(Symbol("theta", "i"), angle)

    # --- by the polygons

    def greatest(self, star: Star) -> Formula:
        """(d + d')/2 μ ω² c; of cylinders of one direction d μ ω² c."""
        row = self.stars.index(star)
        table, quantity = self.table("polygons"), q.graph(star)
        direct, reverse = (table.var(key, row) for key in ("d_direct", "d_reverse"))
        length: Expr = direct if self.found.in_line else (direct + reverse) / Number(2)
        size = length * self.var(f"mu_{LETTERS[star.of]}") * self.var("omega") ** 2
        if star.order == 2:
            size = size * self.var("lambda")
        ref = table.by_key(quantity.key, "graph")
        return Formula(quantity.sign, size, quantity.unit, ref=ref, meaning=quantity.meaning)

    # --- counterweights

    def counterweight(self) -> Formula | None:
        of = self.found.given.counterweight
        if of is None:
            return None
        rotating: Expr | None = self.var("m_rot") if self.found.rotating else None
        if of.share is None:
            product = self.var("m_cw") * self.var("r_cw") / self.var("r")
            product = product - rotating if rotating is not None else product
            return self.book["engine_share"].formula(product / self.var("m"))
        masses: Expr = self.var("share") * self.var("m")
        masses = (rotating + masses) * self.var("r") if rotating is not None else masses * self.var("r")
        if of.mass is None:
            return self.book["engine_m_cw"].formula(masses / self.var("r_cw"))
        return self.book["engine_r_cw"].formula(masses / self.var("m_cw"))

    # --- what balances the rest

    def remedy(self, row: int) -> Iterator[Formula]:
        """Product of the weight that turns forward and, where it differs, of that which turns back."""
        one = self.found.remedies[row]
        table, letter = self.table("remedies"), LETTERS[one.of]
        source = self.table("primary") if one.order == 1 else self.table("orders")
        at = len(source) - 1 if one.order == 1 else 1
        rate = self.var("omega") if one.order == 1 else 2 * self.var("omega")
        senses = {"forward": ["forward"], "backward": ["backward"], "pair": ["forward"], "none": []}
        for sense in senses.get(one.kind, ["forward", "backward"]):
            yield table.formula(sense, row, source.var(f"{letter}_{sense}", at) / rate**2)
