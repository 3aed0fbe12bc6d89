"""View of the friction losses and the efficiency."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.friction import quantities as q
from tmm_report.chapters.lever.friction.corrected_view import CorrectedView, tilted, tilting
from tmm_report.chapters.lever.friction.sliding_view import SlidingView
from tmm_report.chapters.lever.friction.solve import FrictionFound, PairLoss
from tmm_report.chapters.lever.kinematics import quantities as motion
from tmm_report.chapters.lever.kinetostatics.quantities import positions as forces
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.figures.charts.graphs import Graph
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.pairs.materials import Range, Stock
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.model import Book
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, worded
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


class FrictionView(SlidingView):
    def __init__(self, found: FrictionFound, kinetostatics: Kinetostatics, position: int, page: Page):
        super().__init__(page, Book.of(q.tables(found), q.values(found)))
        self.found, self.position, self.kinetostatics = found, position, kinetostatics
        self.stated, self.lost = self.table("friction_given"), self.table("friction_table")
        self.pairs = [loss.pair for loss in found.table.pairs]
        meshes = kinetostatics.kinematics.linkage.mechanism.meshes
        self.toothed = any(not mesh.rolls for mesh in meshes)
        self.rolling = any(mesh.rolls for mesh in meshes)

    @property
    def rollers(self) -> Markup | None:
        """The links that stand for rollers which rub on their pins; None where there are none."""
        own = [one.contact for one in self.found.table.pairs]
        names = [one.cam.name for one in own if one is not None and one.rolls]
        return self.page.listed(names) if names else None

    @property
    def faces(self) -> bool:
        """Whether an edge or a flat face rubs on its cam."""
        return any(one.contact and not one.contact.rolls for one in self.found.table.pairs)

    def conclusions(self) -> list[Markup]:
        return [self.means()]

    def means(self) -> Markup:
        if self.found.forces.kinematics.gaps:
            text = N_(
                "The mechanism makes no full cycle, so that friction has no mean power and no mean efficiency."
            )
            return self.t(text)
        text = N_(
            "The mean power of friction over the cycle is %(power)s W; the mean efficiency of the "
            "mechanism, with the power of the balancing moment taken by its magnitude, is %(eta)s."
        )
        return self.t(text, power=self.number("P_fr_mean"), eta=self.number("eta_mean"))

    def column_explained(self, key: str) -> dict[str, Any]:
        """An item of a "where" list."""
        column = (self.stated if key in self.stated else self.lost)[key]
        return self.page.explained(key, column, column.unit)

    # ------------------------------------------------------------ tables

    def alike(self) -> list[Markup]:
        """The given in words, where in a shorter note all pairs of a kind have one coefficient and one diameter."""
        if self.page.note.every or self.by_law:
            return []
        rubs: dict[str, set[Any]] = {}
        rows: dict[str, int] = {}
        for row, loss in enumerate(self.found.table.pairs):
            rubs.setdefault(loss.pair.kind, set()).add((loss.rubbing.coefficient, loss.rubbing.diameter))
            rows.setdefault(loss.pair.kind, row)
        if rubs.keys() - {"R", "P"} or any(len(one) > 1 for one in rubs.values()):
            return []
        coefficients = {kind: self.page.value(self.stated.var("f", row)) for kind, row in rows.items()}
        if len({coefficient for ((coefficient, _),) in rubs.values()}) == 1:
            text = N_("The coefficient of friction in all kinematic pairs is %(f)s.")
            said = [self.t(text, f=next(iter(coefficients.values())))]
        else:
            text = N_(
                "The coefficient of friction is %(f)s in the revolute pairs and %(g)s in the prismatic ones."
            )
            said = [self.t(text, f=coefficients["R"], g=coefficients["P"])]
        if any(diameter for _, diameter in rubs.get("R", ())):
            text = N_("The journals have the diameter %(d)s.")
            said.append(self.t(text, d=self.page.value(self.stated.var("d", rows["R"]))))
        return said

    def given(self, caption: Any) -> Table:
        table = self.stated
        journals = any(loss.rubbing.diameter for loss in self.found.table.pairs)
        rows = [
            [
                self.page.word("–".join(pair.links), table, "links", row),
                self.page.word(pair.name, table, "name", row), self.t(PAIR_KINDS[pair.kind]),
                self._coefficient(table, row), *([self._diameter(table, row, pair)] if journals else []),
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
        stated = [
            (row, loss.pair.name) for row, loss in enumerate(self.found.table.pairs) if loss.rubbing.length
        ]
        if not stated:
            return None
        if len(stated) == 1:
            row, name = stated[0]
            length = self.page.value(self.stated.var("l", row, q.LENGTH.shown))
            return self.t("Length of the slider in guide %(name)s: %(length)s.", name=name, length=length)
        lengths = self.page.listed(self._length(row, name) for row, name in stated)
        letter = self.page.sym(q.LENGTH.sign)
        return self.t("Lengths of the sliders %(letter)s: %(lengths)s.", letter=letter, lengths=lengths)

    def _length(self, row: int, name: str) -> Markup:
        unit = q.LENGTH.shown
        length = self.page.in_unit(self.page.shown(self.stated, "l", row, unit), unit)
        return self.t(N_("%(length)s in guide %(name)s"), name=name, length=length)

    def materials(self, caption: Any) -> Table | None:
        """Materials with the ranges of their coefficients; None where none are stated."""
        if not self.has("friction_materials"):
            return None
        table = self.table("friction_materials")
        stocks = [loss.rubbing.stock for loss in self.found.table.pairs if loss.rubbing.stock is not None]
        rows = [self._materials(table, row, stock) for row, stock in enumerate(stocks)]
        phi = self.page.head(table["phi_fr"].symbol(), table["phi_fr"].unit)
        heads = [
            self.t("Point, guide"), self.t("Materials"), self.t("Friction"),
            self.t("Range of the coefficient"), self.t("Coefficient at rest"), phi,
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

    def _coefficient(self, table: Any, row: int) -> Cell | str:
        by_law = self.found.table.pairs[row].rubbing.law is not None
        return "f(v)" if by_law else self.page.cell(table, "f", row)

    def _diameter(self, table: Any, row: int, pair: Pair) -> Cell:
        known = bool(self.found.table.pairs[row].rubbing.diameter)
        return self.page.cell(table, "d", row) if known else Cell("—", table.ref("d", row))

    def losses(self, caption: Any) -> Table:
        """Power lost in all pairs, and the efficiency."""
        keys = ["P_fr", "P_drive", self.reduced_key]
        return self.by_positions(
            caption, "friction_table", [*keys, self.column("friction_table", "eta", digits=4)]
        )

    def lost_in_pairs(self, caption: Any) -> Table:
        """Power lost in each pair."""
        return self.by_positions(
            caption, "friction_table", [q.lost(pair, self.pairs).key for pair in self.pairs]
        )

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
        return tilting(self.found.table.pairs, self.lost, self.page)

    # ------------------------------------------------------------ formulas of the sample position

    def leading(self) -> list[Formula]:
        """The first of each kind: of pivots and of guides, with and without a stated length."""
        return [formulas[0] for formulas in self._by_kinds()]

    def following(self) -> list[Formula]:
        """The others."""
        return [one for formulas in self._by_kinds() for one in formulas[1:]]

    def _by_kinds(self) -> list[list[Formula]]:
        kinds: dict[str, list[Formula]] = {}
        for row, loss in enumerate(self.found.table.pairs):
            tilts = loss.couple is not None and self.position in tilted(loss)
            kind = f"{loss.pair.kind}{loss.couple is not None}{tilts}"
            if loss.couple is not None:
                kinds.setdefault(f"pressed {kind}", []).append(self._pressing(row, loss))
            kinds.setdefault(kind, []).append(self._loss(row, loss))
        return list(kinds.values())

    def _pressing(self, row: int, loss: PairLoss) -> Formula:
        """The reaction, or where the slider tilts the sum of the forces at its ends."""
        pair, k = loss.pair, self.position
        presses: Expr = self.lost.var(q.borne(pair).key, k)
        if k in tilted(loss):
            length = self.stated.var("l", row)
            presses = 2 * abs(self.lost.var(q.couple(pair).key, k)) / length
        return self.lost.formula(q.pressing(pair).key, k, presses, scale=float(np.nanmax(loss.pressing)))

    def _loss(self, row: int, loss: PairLoss) -> Formula:
        pair, k, stated = loss.pair, self.position, self.stated
        presses = q.borne if loss.couple is None else q.pressing
        friction = self.friction_at(row) * self.lost.var(presses(pair).key, k)
        if pair.kind == "R":
            arm = (
                stated.var("d", row)
                if loss.rubbing.diameter
                else Var(q.DIAMETER.sign, 0.0, "m", ref=stated.ref("d", row))
            )
            friction = friction * (arm / 2)
        rate = self.lost.var(q.rate(loss).key, k)
        return self.lost.formula(q.lost(pair, self.pairs).key, k, friction * rate)

    @property
    def stroke(self) -> bool:
        """Whether a slider or a cylinder drives: a force and its stroke take the place of moment and rotation."""
        return self.found.table.speed is not None

    @property
    def reduced_key(self) -> str:
        return (q.ALONG if self.stroke else q.REDUCED).key

    @property
    def stands(self) -> bool:
        """Whether the stroke stands still at the position written out: nothing is reduced to it."""
        return not np.isfinite(self.found.table.reduced[self.position])

    def _balancing(self) -> Expr:
        tables = self.page.once(forces.book, self.kinetostatics).tables
        if self.stroke:
            return abs(tables["drive_table"].var("F_stroke", self.position))
        return abs(tables["balancing_table"].var("M_bal", self.position))

    def driving_power(self) -> Formula:
        scale = float(self.found.table.driving.max())
        return self.lost.formula("P_drive", self.position, self._balancing() * self._rate(), scale=scale)

    @property
    def idle(self) -> bool:
        """Whether neither the balancing moment nor friction has any power at the position written out."""
        return not np.isfinite(self.found.table.efficiency[self.position])

    def efficiency(self) -> Formula:
        driving = self.lost.var("P_drive", self.position)
        lost = self.lost.var("P_fr", self.position)
        return self.lost.formula("eta", self.position, driving / (driving + lost))

    def reduced(self) -> Formula:
        """The moment of friction reduced to the driving link, or its force along the stroke."""
        lost = self.lost.var("P_fr", self.position)
        return self.lost.formula(self.reduced_key, self.position, lost / self._rate())

    def by_moments(self) -> Formula:
        """The efficiency once more, by moments or by forces."""
        useful, reduced = self._balancing(), self.lost.var(self.reduced_key, self.position)
        return self.lost.formula("eta", self.position, useful / (useful + reduced))

    def _rate(self) -> Expr:
        kinematics = self.kinetostatics.kinematics
        if self.stroke:
            tables = self.page.once(motion.book, kinematics).tables
            return abs(tables["stroke_table"].var("stroke_v", self.position))
        link = kinematics.linkage.mechanism.driver.link
        return Var(Symbol("omega", link), abs(kinematics.omega), "rad/s", ref=Ref("omega", size=True))

    # ------------------------------------------------------------ diagram

    def diagram(self) -> Graph:
        numbered = self.kinetostatics.kinematics.numbered
        return self.over_cycle("friction_diagram", ("P_fr", "eta"), numbered, join=False)
