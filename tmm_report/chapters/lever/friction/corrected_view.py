"""View of the force analysis with friction: reactions, balancing moment, efficiency."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.friction import corrected_quantities as c
from tmm_report.chapters.lever.friction import quantities as q
from tmm_report.chapters.lever.friction.corrected import STILL, Correction, Loss
from tmm_report.chapters.lever.friction.sliding_view import SlidingView
from tmm_report.chapters.lever.friction.solve import FrictionFound, PairLoss
from tmm_report.chapters.lever.kinetostatics.quantities import positions as forces
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.figures.charts.graphs import Graph
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.model import Book
from tmm_report.quantity.model import Table as Numbers
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import Line
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table


def tilting(losses: Iterable[PairLoss | Loss], table: Numbers, page: Page) -> Markup | None:
    """Guides whose slider touches both faces somewhere, each with its positions, of `table`; None where there are
    none."""
    where = [(loss, tilted(loss)) for loss in losses]
    text, lines = N_("in guide %(pair)s at positions %(positions)s"), []
    for loss, positions in where:
        shown = [page.shown(table, "position", int(k)) for k in positions]
        lines += [page.t(text, pair=loss.pair.name, positions=page.listed(shown))] if shown else []
    return page.listed(lines, "; ") if lines else None


def tilted(loss: PairLoss | Loss) -> Any:
    """Positions at which the forces at the ends of a slider are more than its reaction."""
    more = loss.pressing - np.abs(loss.reaction)
    return np.flatnonzero(more > STILL * np.nanmax(loss.pressing, initial=0.0))


class CorrectedView(SlidingView):
    def __init__(
        self,
        found: FrictionFound,
        correction: Correction,
        kinetostatics: Kinetostatics,
        position: int,
        page: Page,
    ):
        super().__init__(page, Book.of(q.tables(found), q.values(found)))
        self.found, self.correction, self.position = found, correction, position
        self.kinetostatics = kinetostatics
        self.moments = self.table("friction_corrected_table")
        self.reactions = self.table("friction_reactions_table")
        self.pairs = [loss.pair for loss in found.table.pairs]

    def conclusions(self) -> list[Markup]:
        if self.correction.partial:
            return []
        text = N_(
            "With friction in the reactions the largest balancing moment is %(growth)s times that without "
            "friction; the mean efficiency is %(eta)s."
        )
        growth, eta = (self.number(key) for key in ("M_growth", "eta_corrected_mean"))
        return [self.t(text, growth=growth, eta=eta)]

    @property
    def of_cams(self) -> bool:
        """Whether a cam pair rubs."""
        return any(one.contact for one in self.found.table.pairs)

    @property
    def steps(self) -> Markup:
        return self.number("friction_steps", places=0)

    @property
    def worst(self) -> Markup:
        """Of both ways to the moment: noise is told as nothing."""
        return self.bound("friction_disagreement")

    # ------------------------------------------------------------ the slider that tilts

    def tilting(self) -> Markup | None:
        return tilting(self.correction.table.pairs, self.moments, self.page)

    # ------------------------------------------------------------ formulas of the sample position

    def pressing(self) -> list[Formula]:
        """Force that presses each slider: its reaction, or where it tilts the sum of the forces at its ends."""
        guides = [
            (row, loss) for row, loss in enumerate(self.correction.table.pairs) if loss.pair.kind == "P"
        ]
        return [self._pressing(row, loss) for row, loss in guides]

    def _pressing(self, row: int, loss: Loss) -> Formula:
        pair, k = loss.pair, self.position
        presses: Expr = self.reactions.var(c.corrected_reaction(pair).key, k)
        if k in tilted(loss):
            couple = self.reactions.var(c.corrected_couple(pair).key, k)
            presses = 2 * abs(couple) / self.table("friction_given").var("l", row)
        scale = float(np.nanmax(loss.pressing))
        return self.reactions.formula(c.corrected_pressing(pair).key, k, presses, scale=scale)

    @property
    def lengths(self) -> bool:
        return any(loss.couple is not None for loss in self.correction.table.pairs)

    @property
    def tilts_here(self) -> bool:
        return any(
            self.position in tilted(loss) for loss in self.correction.table.pairs if loss.pair.kind == "P"
        )

    def sample(self) -> list[Formula]:
        """Power lost in each pair by its corrected reaction."""
        return [self._loss(row, loss) for row, loss in enumerate(self.correction.table.pairs)]

    def _loss(self, row: int, loss: Loss) -> Formula:
        pair, k, stated = loss.pair, self.position, self.table("friction_given")
        first = self.found.table.pairs[row]
        diameter = first.rubbing.diameter
        rate = self.table("friction_table").var(q.rate(first).key, k)
        friction = self.friction_at(row)
        if pair.kind == "R":
            arm = (
                stated.var("d", row) if diameter else Var(q.DIAMETER.sign, 0.0, "m", ref=stated.ref("d", row))
            )
            friction = friction * self.reactions.var(c.corrected_reaction(pair).key, k) * (arm / 2)
        else:
            friction = friction * self.reactions.var(c.corrected_pressing(pair).key, k)
        scale = float(np.nanmax(loss.power))
        return self.reactions.formula(c.corrected_loss(pair, self.pairs).key, k, friction * rate, scale=scale)

    def moment(self) -> Formula:
        """By the power balance with friction."""
        balancing = self.page.once(forces.book, self.kinetostatics).tables["balancing_table"]
        kinematics = self.kinetostatics.kinematics
        link = kinematics.linkage.mechanism.driver.link
        omega = Var(Symbol("omega", link), kinematics.omega, "rad/s", ref=Ref("omega"))
        lost = self.moments.var("P_fr_corrected", self.position)
        return self.moments.formula(
            "M_bal_fr", self.position, balancing.var("M_bal", self.position) + lost / omega
        )

    @property
    def idle(self) -> bool:
        """Whether nothing is driven and nothing lost at the position written out."""
        return not np.isfinite(self.moments["eta_corrected"].values[self.position])

    def efficiency(self) -> Formula:
        driving = self.table("friction_table").var("P_drive", self.position)
        lost = self.moments.var("P_fr_corrected", self.position)
        return self.moments.formula("eta_corrected", self.position, driving / (driving + lost))

    # ------------------------------------------------------------ tables and diagrams

    def compared(self, caption: Any) -> Table:
        """Balancing moment without friction, in first approximation and corrected; power lost, efficiency."""
        balancing = self.page.once(forces.book, self.kinetostatics).tables["balancing_table"]
        without, name = self.page.column(balancing, "M_bal"), self.moments.name
        eta = self.column(name, "eta_corrected", digits=4)
        return self.by_positions(caption, name, [without, "M_first", "M_bal_fr", "P_fr_corrected", eta])

    def pressed(self, caption: Any) -> Table:
        """Reactions without friction and with it, pair by pair."""
        columns: list[str | Column] = []
        for pair, loss in zip(self.pairs, self.correction.table.pairs, strict=True):
            columns += [self.column("friction_table", q.borne(pair).key), c.corrected_reaction(pair).key]
            columns += [c.corrected_pressing(pair).key] if loss.couple is not None else []
        return self.by_positions(caption, self.reactions.name, columns)

    def diagram(self) -> Graph:
        say, name = self.page.tr.gettext, "friction_corrected_diagram"
        without, first, corrected = map(
            say, (N_("without friction"), N_("first approximation"), N_("corrected"))
        )
        lines = [
            Line(c.ANY_MOMENT.column(self.correction.diagram.without), without),
            Line(self.of(name, "M_first"), first),
            Line(self.of(name, "M_bal_fr"), corrected, extremes=None),
            Line(c.ANY_EFFICIENCY.column(self.found.diagram.efficiency), first, 1),
            Line(self.of(name, "eta_corrected"), corrected, 1, extremes=None),
        ]
        return self.over_cycle(name, lines, self.kinetostatics.kinematics.numbered, join=False)
