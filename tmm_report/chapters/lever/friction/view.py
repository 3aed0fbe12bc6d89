"""View of the friction losses and the efficiency."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.friction import quantities as q
from tmm_report.chapters.lever.friction.corrected_view import CorrectedView, tilted, tilting
from tmm_report.chapters.lever.friction.solve import FrictionFound, PairLoss
from tmm_report.chapters.lever.kinetostatics.quantities import positions as forces
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.pairs.materials import Range, Stock
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.model import Book
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import CycleGraphs
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, numeric, worded
from tmm_report.report.part import Part
from tmm_report.report.words import PAIR_KINDS

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def given_parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    """What the initial data say of friction."""
    if (view := _view(lever, page)) is not None:
        yield Part("lever/friction/given", view, concludes=False)


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    if (view := _view(lever, page)) is not None:
        yield Part("lever/friction", view)
        if (corrected := view.found.corrected) is not None:
            yield Part(
                "lever/friction/corrected",
                CorrectedView(view.found, corrected, view.kinetostatics, view.position, page),
            )


def _view(lever: LeverFound, page: Page) -> FrictionView | None:
    if lever.friction is None or lever.kinetostatics is None:
        return None
    return page.once(FrictionView, lever.friction, lever.kinetostatics, lever.sample, page)


class FrictionView:
    def __init__(self, found: FrictionFound, kinetostatics: Kinetostatics, position: int, page: Page):
        self.found, self.position, self.page, self.t = found, position, page, page.t
        self.kinetostatics = kinetostatics
        self.book = Book.of(q.tables(found), q.values(found))
        self.table = self.book.tables["friction_table"]
        self.pairs = [loss.pair for loss in found.table.pairs]

    def conclusions(self) -> list[Markup]:
        return [self.means()]

    def means(self) -> Markup:
        if self.found.forces.kinematics.gaps:
            text = N_(
                "The mechanism makes no full cycle, so that friction has no mean power and no mean efficiency."
            )
            return self.t(text)
        text = N_(
            "The mean power of friction over the cycle is %(power)s W, the mean efficiency of the mechanism is %(eta)s."
        )
        power = self.page.shown(self.book["P_fr_mean"])
        return self.t(text, power=power, eta=self.page.shown(self.book["eta_mean"], digits=4))

    def explained(self, key: str) -> dict[str, Any]:
        """An item of a "where" list."""
        table = self.book.tables["friction_given"]
        column = table[key] if key in table else self.table[key]
        return self.page.explained(key, column, column.unit)

    # ------------------------------------------------------------ tables

    def stated(self, caption: Any) -> Table:
        table = self.book.tables["friction_given"]
        journals = any(loss.rubbing.diameter for loss in self.found.table.pairs)
        rows = [
            [
                self.page.word("–".join(pair.links), table, "links", row),
                self.page.word(pair.name, table, "name", row), self.t(PAIR_KINDS[pair.kind]),
                self.page.cell(table, "f", row), *([self._diameter(table, row, pair)] if journals else []),
            ]
            for row, pair in enumerate(loss.pair for loss in self.found.table.pairs)
        ]  # fmt: skip
        heads = [
            self.t("Links"), self.t("Point, guide"), self.t("Kind"), self.t("Friction coefficient"),
            *([self.page.listed([self.t("Journal diameter"), self.page.unit("m")])] if journals else []),
        ]  # fmt: skip
        return worded(caption, heads, rows, (2, 2, 4, 3, 3)[: len(heads)])

    def lengths(self) -> Markup | None:
        """Of the sliders that have one stated, by their guides; None where there are none."""
        table, losses = self.book.tables["friction_given"], self.found.table.pairs
        lines = [self._length(table, row) for row, loss in enumerate(losses) if loss.rubbing.length]
        return self.page.listed(lines) if lines else None

    def _length(self, table: Any, row: int) -> Markup:
        text, name = N_("%(length)s in guide %(name)s"), self.found.table.pairs[row].pair.name
        return self.t(text, name=name, length=self.page.value(table.var("l", row, "mm")))

    def materials(self, caption: Any) -> Table | None:
        """Materials with the ranges of their coefficients; None where none are stated."""
        table = self.book.tables.get("friction_materials")
        if table is None:
            return None
        stocks = [loss.rubbing.stock for loss in self.found.table.pairs if loss.rubbing.stock is not None]
        rows = [self._materials(table, row, stock) for row, stock in enumerate(stocks)]
        phi = self.page.head(table["phi_fr"].symbol(), "deg")
        heads = [
            self.t("Point, guide"), self.t("Materials"), self.t("Friction"),
            self.t("Range of the coefficient"), self.t("At rest"), phi,
        ]  # fmt: skip
        return worded(caption, heads, rows, (1, 5, 9, 2, 2, 1))

    def _materials(self, table: Any, row: int, stock: Stock) -> list[Any]:
        page = self.page
        pair = page.listed([self.t(stock.one), self.t(stock.other)], "–")
        friction = self.t(N_("dry friction") if stock.lubrication == "dry" else N_("semi-fluid friction"))
        return [
            page.word(table["name"].values[row], table, "name", row),
            page.word(pair, table, "materials", row), page.word(friction, table, "lubrication", row),
            self._range(table, row, "f_low", "f_high", stock.range),
            self._range(table, row, "f_rest_low", "f_rest_high", stock.rest),
            page.cell(table, "phi_fr", row, digits=4),
        ]  # fmt: skip

    def _range(self, table: Any, row: int, low: str, high: str, of: Range | None) -> Any:
        """0,05–0,1, one number, or a dash."""
        if of is None:
            return Cell("—", table.ref(low, row))
        keys = (low,) if of[0] == of[1] else (low, high)
        return self.page.listed([self.page.shown(table, key, row) for key in keys], "–")

    def _diameter(self, table: Any, row: int, pair: Pair) -> Cell:
        known = bool(self.found.table.pairs[row].rubbing.diameter)
        return self.page.cell(table, "d", row) if known else Cell("—", table.ref("d", row))

    def losses(self, caption: Any) -> Table:
        """Power lost in each pair, in all of them, and the efficiency."""
        keys = [
            *(q.lost(loss.pair, self.pairs).key for loss in self.found.table.pairs),
            "P_fr",
            "P_drive",
            "T_fr",
        ]
        columns = [self.page.column(self.table, key) for key in keys]
        columns.append(self.page.column(self.table, "eta", digits=4))
        return numeric(caption, self.page.positions(self.table), columns)

    # ------------------------------------------------------------ the slider that tilts

    @property
    def guides(self) -> list[tuple[int, PairLoss]]:
        """Those whose slider has a stated length, with their row of the given."""
        return [(row, loss) for row, loss in enumerate(self.found.table.pairs) if loss.couple is not None]

    @property
    def tilts_here(self) -> bool:
        """Whether a slider tilts at the position written out."""
        return any(self.position in tilted(loss) for _, loss in self.guides)

    def tilting(self) -> Markup | None:
        return tilting(self.found.table.pairs, self.table, self.page)

    # ------------------------------------------------------------ formulas of the sample position

    def sample(self) -> list[Formula]:
        """Power lost in each pair, before it the force that presses each slider of stated length."""
        losses = [self._loss(row, loss) for row, loss in enumerate(self.found.table.pairs)]
        return [*(self._pressing(row, loss) for row, loss in self.guides), *losses]

    def _pressing(self, row: int, loss: PairLoss) -> Formula:
        """The reaction, or where the slider tilts the sum of the forces at its ends."""
        pair, k = loss.pair, self.position
        presses: Expr = self.table.var(q.borne(pair).key, k)
        if k in tilted(loss):
            length = self.book.tables["friction_given"].var("l", row)
            presses = 2 * abs(self.table.var(q.couple(pair).key, k)) / length
        return self.table.formula(q.pressing(pair).key, k, presses, scale=float(np.nanmax(loss.pressing)))

    def _loss(self, row: int, loss: PairLoss) -> Formula:
        pair, k, stated = loss.pair, self.position, self.book.tables["friction_given"]
        presses = q.borne if loss.couple is None else q.pressing
        friction = stated.var("f", row) * self.table.var(presses(pair).key, k)
        if pair.kind == "R":
            arm = (
                stated.var("d", row)
                if loss.rubbing.diameter
                else Var("d", 0.0, "m", ref=stated.ref("d", row))
            )
            friction = friction * (arm / 2)
        rate = self.table.var(q.rate(pair).key, k)
        return self.table.formula(q.lost(pair, self.pairs).key, k, friction * rate)

    def driving_power(self) -> Formula:
        balancing = self.page.once(forces.book, self.kinetostatics).tables["balancing_table"]
        power = abs(balancing.var("M_bal", self.position)) * self._omega()
        return self.table.formula(
            "P_drive", self.position, power, scale=float(self.found.table.driving.max())
        )

    @property
    def idle(self) -> bool:
        """Whether neither the balancing moment nor friction has any power at the position written out."""
        return not np.isfinite(self.found.table.efficiency[self.position])

    def efficiency(self) -> Formula:
        driving = self.table.var("P_drive", self.position)
        lost = self.table.var("P_fr", self.position)
        return self.table.formula("eta", self.position, driving / (driving + lost), digits=4)

    def reduced(self) -> Formula:
        """The moment of friction reduced to the driving link."""
        lost = self.table.var("P_fr", self.position)
        return self.table.formula("T_fr", self.position, lost / self._omega())

    def by_moments(self) -> Formula:
        """The efficiency once more, by moments."""
        balancing = self.page.once(forces.book, self.kinetostatics).tables["balancing_table"]
        useful = abs(balancing.var("M_bal", self.position))
        reduced = self.table.var("T_fr", self.position)
        return self.table.formula("eta", self.position, useful / (useful + reduced), digits=4)

    def _omega(self) -> Var:
        kinematics = self.kinetostatics.kinematics
        link = kinematics.linkage.mechanism.driver.link
        return Var(Symbol("omega", link), abs(kinematics.omega), "rad/s", ref=Ref("omega", size=True))

    # ------------------------------------------------------------ diagram

    def diagram(self) -> Graph:
        kinematics, losses = self.kinetostatics.kinematics, self.found.diagram
        closed = kinematics.positions.table if kinematics.cycle.closed else 0
        graphs = CycleGraphs(kinematics.diagram_turned, closed, self.page.tr)
        curves = [Curve(losses.total, panel=0), Curve(losses.efficiency, panel=1)]
        labels = [graphs.letter(Symbol("P", "fr"), "W"), graphs.letter(Symbol("eta"), "")]
        return graphs.graph(curves, labels, join=False)
