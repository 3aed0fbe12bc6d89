"""View of coefficients of friction that depend on the sliding: their laws, and the formulas at a position."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.lever.friction import quantities as q
from tmm_report.chapters.lever.friction import sliding_quantities as own
from tmm_report.chapters.lever.friction.solve import FrictionFound, PairLoss
from tmm_report.mechanics.pairs.coefficients import BySliding, Stribeck
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.functions import exp
from tmm_report.quantity.model import Table as Numbers
from tmm_report.report.chapter_view import BookView
from tmm_report.report.paper.layout import Table, worded


class SlidingView(BookView):
    """Of the pairs whose coefficient is a law; the others it leaves out."""

    found: FrictionFound
    position: int

    @property
    def by_law(self) -> list[PairLoss]:
        return [loss for loss in self.found.table.pairs if loss.rubbing.law is not None]

    # ------------------------------------------------------------ what is stated

    def stribeck(self) -> list[Markup]:
        """Every law of Stribeck with its numbers."""
        if not self.has("friction_stribeck"):
            return []
        table = self.table("friction_stribeck")
        return [self._stribeck(table, row) for row in range(len(table))]

    def _stribeck(self, table: Numbers, row: int) -> Markup:
        keys = ["f_s", "f_k", "v_s", *(["k_v"] if table["k_v"].values[row] else [])]
        numbers = self.page.listed(self.page.value(table.var(key, row)) for key in keys)
        text = N_("%(names)s: exponent n = %(n)s, %(numbers)s")
        names = str(table["names"].values[row])
        return self.t(text, names=names, n=self.page.shown(table, "n", row), numbers=numbers)

    def points(self, caption: Any) -> Table | None:
        """The tables of coefficients at velocities of sliding; None where none are stated."""
        if not self.has("friction_points"):
            return None
        table, page = self.table("friction_points"), self.page
        columns = [page.column(table, key) for key in ("v", "f")]
        rows = [
            [
                page.word(str(table["names"].values[row]), table, "names", row),
                *(one.cells[row] for one in columns),
            ]
            for row in range(len(table))
        ]
        return worded(caption, [self.t("Points, guides"), *(one.head for one in columns)], rows, (2, 1, 1))

    # ------------------------------------------------------------ at the positions

    def coefficients(self, caption: Any) -> Table:
        """Velocity of sliding and coefficient of every pair by positions."""
        keys = [key for loss in self.by_law for key in (self._velocity(loss), self._at_velocity(loss))]
        return self.by_positions(caption, "friction_table", keys)

    def _velocity(self, loss: PairLoss) -> str:
        return (own.sliding(loss.pair) if loss.pair.kind == "R" else q.rate(loss)).key

    def _at_velocity(self, loss: PairLoss) -> str:
        return own.coefficient(loss.pair, [one.pair for one in self.found.table.pairs]).key

    def sliding_sample(self) -> list[Formula]:
        """Velocity of sliding and coefficient of each pair at the position written out."""
        return [
            formula for row, loss in enumerate(self.found.table.pairs) for formula in self._law(row, loss)
        ]

    def _law(self, row: int, loss: PairLoss) -> Iterator[Formula]:
        law, k = loss.rubbing.law, self.position
        if law is None:
            return
        lost = self.table("friction_table")
        if loss.pair.kind == "R":
            half = self.table("friction_given").var("d", row) / 2
            rate = lost.var(q.rate(loss).key, k)
            yield lost.formula(self._velocity(loss), k, rate * half, scale=float(loss.sliding.max()))
        speed = lost.var(self._velocity(loss), k)
        expression = self._curve(law, speed) if isinstance(law, Stribeck) else self._line(law, speed)
        yield lost.formula(self._at_velocity(loss), k, expression)

    def _curve(self, law: Stribeck, speed: Var) -> Expr:
        table = self.table("friction_stribeck")
        row = [one for one in own.laws(self.found.table.pairs) if isinstance(one, Stribeck)].index(law)
        rest, moving, fall = (table.var(key, row) for key in ("f_s", "f_k", "v_s"))
        part = speed / fall
        found = moving + (rest - moving) * exp(-(part if law.exponent == 1 else part**law.exponent))
        return found + table.var("k_v", row) * speed if law.viscous else found

    def _line(self, law: BySliding, speed: Var) -> Expr:
        """The line between two points of its table on which a coefficient lies; beyond them the end."""
        table = self.table("friction_points")
        tables = [one for one in own.laws(self.found.table.pairs) if isinstance(one, BySliding)]
        first = sum(len(one.speeds) for one in tables[: tables.index(law)])
        after = bisect_right(law.speeds, float(speed.value))
        if after in (0, len(law.speeds)):
            return table.var("f", first + max(after - 1, 0))
        (low, start), (high, end) = (
            (table.var("v", row), table.var("f", row)) for row in (first + after - 1, first + after)
        )
        return start + (end - start) * (speed - low) / (high - low)

    def friction_at(self, row: int) -> Expr:
        """The coefficient of a pair at the position written out, for its formulas."""
        loss = self.found.table.pairs[row]
        if loss.rubbing.law is None:
            return self.table("friction_given").var("f", row)
        return self.table("friction_table").var(self._at_velocity(loss), self.position)

    def work(self) -> Markup | None:
        """Energy that friction takes over the cycle, with its sentence; None without a law, or without a cycle."""
        if not self.by_law or self.found.forces.kinematics.gaps:
            return None
        return self.t(N_("Over the cycle friction takes the energy %(work)s."), work=self.sized("E_fr"))
