"""Tables of the forces and of friction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.force_plans.drafting import ForceDrawn
from tmm_report.mechanics.statics import Reaction
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import reaction_key, symbol_of
from tmm_report.report.columns import Columns
from tmm_report.report.layout import Column, Table, numeric, worded
from tmm_report.report.samples import Power


class ForceTables(Columns):
    def inertia(self, caption: Any) -> Table:
        """Inertia forces and couples, magnitudes, at the table positions."""
        loading = self.r.kinetostatics.table.loading
        columns = [
            Column(self._head(Symbol("F", f"I{link}"), "N"), self.col(np.abs(f)))
            for link, f in loading.inertia.items()
        ]
        columns += [
            Column(self._head(Symbol("M", f"I{link}"), "N·m"), self.col(m))
            for link, m in loading.couples.items()
        ]
        return numeric(caption, self._positions(len(self.r.kinematics.turned)), columns)

    def weights(self, caption: Any) -> Table:
        gravity = self.r.kinetostatics.table.loading.gravity
        columns = [
            Column(self._head(Symbol("G", link), "N"), [self.page.num(abs(w[0]))])
            for link, w in gravity.items()
        ]
        return numeric(caption, columns[0], columns[1:])

    def reactions(self, caption: Any) -> Table:
        columns = []
        for reaction in self.r.kinetostatics.table.statics.reactions.values():
            size = np.abs(np.broadcast_to(reaction.force, self.r.kinematics.turned.shape))
            columns.append(
                Column(self._head(symbol_of(reaction_key(*reaction.pair.links)), "N"), self.col(size))
            )
        return numeric(caption, self._positions(len(self.r.kinematics.turned)), columns)

    def directions(self, caption: Any) -> Table:
        """Angles of the reactions with the x axis, degrees; none where there is no force."""
        columns = []
        for reaction in self.r.kinetostatics.table.statics.reactions.values():
            force = np.broadcast_to(reaction.force, self.r.kinematics.turned.shape)
            angle = np.degrees(np.angle(force)) % 360
            none = np.abs(force) <= 1e-9 * np.nanmax(np.abs(force))
            key = reaction_key(*reaction.pair.links).replace("R", "alpha", 1)
            columns.append(Column(self._head(symbol_of(key), "deg"), self.col(np.where(none, np.nan, angle))))
        return numeric(caption, self._positions(len(self.r.kinematics.turned)), columns)

    def _in_guides(self) -> list[tuple[Reaction, Any]]:
        """Reactions of the guides with their moments at the table positions, N m."""
        shape = self.r.kinematics.turned.shape
        reactions = self.r.kinetostatics.table.statics.reactions.values()
        return [(r, np.broadcast_to(r.moment, shape)) for r in reactions if r.pair.kind == "P"]

    @property
    def guides(self) -> bool:
        return bool(self._in_guides())

    @property
    def central(self) -> bool:
        """Whether the reactions of all guides pass through the points of their sliders."""
        largest = float(np.nanmax(self.r.kinetostatics.table.scale))
        return all(np.nanmax(np.abs(moment)) <= 1e-9 * largest for _, moment in self._in_guides())

    def guide_points(self, caption: Any) -> Table:
        """Moments of the reactions in guides, and where along the guide the force alone would act."""
        columns = []
        for reaction, moment in self._in_guides():
            index = reaction_key(*reaction.pair.links)[2:]
            offset = np.broadcast_to(replace(reaction, moment=moment).offset, moment.shape)
            columns.append(Column(self._head(Symbol("M", index), "N·m"), self.col(moment)))
            columns.append(Column(self._head(Symbol("x", index), "m"), self.col(offset)))
        return numeric(caption, self._positions(len(self.r.kinematics.turned)), columns)

    def balancing(self, caption: Any) -> Table:
        """The balancing moment by groups, by the lever and by power."""
        table = self.r.kinetostatics.table
        heads = [
            self.t("from the force analysis"),
            self.t("from the lever"),
            self.t("from the power balance"),
        ]
        rows = (table.balancing, table.lever, table.power)
        columns = [
            Column(self.page.listed([self._head("M_bal", "N·m"), head]), self.col(values), least=20)
            for head, values in zip(heads, rows, strict=True)
        ]
        return numeric(caption, self._positions(len(self.r.kinematics.turned)), columns)

    def powers(self, caption: Any, powers: Sequence[Power]) -> Table:
        rows = [
            [
                self.page.listed(self.sym(symbol) for symbol in p.symbols),
                self.page.num(p.power, scale=max(1.0, abs(p.power))),
            ]
            for p in powers
        ]
        total = sum(p.power for p in powers)
        rows.append([self.t("Sum"), self.page.num(total)])
        return worded(
            caption, [self.t("Loads"), self.page.listed([self.t("Power"), self.page.unit("W")])], rows, (1, 1)
        )

    def arms(self, caption: Any, drawn: ForceDrawn) -> Table:
        arms = [arm for plan in drawn.plans for arm in plan.arms]
        rows = [
            [
                self.sym(symbol_of(arm.key)),
                arm.about,
                self.page.num(arm.millimetres, 7),
                self.page.num(arm.metres),
            ]
            for arm in arms
        ]
        heads = [self.t("Force"), self.t("About point"), self.t("Arm on the scheme, mm"), self.t("Arm, m")]
        return worded(caption, heads, rows, (2, 2, 3, 3))

    def reduced(self, caption: Any, drawn: ForceDrawn) -> Table:
        rows = [
            [
                one.link, self.page.num(one.force), self.page.num(one.couple), self.page.num(one.arm),
                f"{self.page.num(one.centre.real, 4)}; {self.page.num(one.centre.imag, 4)}",
            ]
            for one in drawn.reduced
        ]  # fmt: skip
        heads = [
            self.t("Link"), self._head("F_I", "N"), self._head("M_I", "N·m"), self._head("h", "m"),
            self.page.listed([self.t("Swing centre K: x; y"), self.page.unit("m")]),
        ]  # fmt: skip
        return worded(caption, heads, rows, (1, 2, 2, 2, 3))

    # ------------------------------------------------------------ friction

    def losses(self, caption: Any) -> Table:
        """Power lost in each pair, in all of them, and the efficiency."""
        losses = self.r.friction.table
        columns = [
            Column(self._head(Symbol("P", f"fr{loss.pair.name}"), "W"), self.col(loss.power))
            for loss in losses.pairs
        ]
        columns.append(Column(self._head("P_fr", "W"), self.col(losses.total)))
        columns.append(Column(self._head("P_1", "W"), self.col(losses.driving)))
        columns.append(Column(self._head("eta"), self.col(losses.efficiency, 4)))
        return numeric(caption, self._positions(len(self.r.kinematics.turned)), columns)

    def friction_given(self, caption: Any) -> Table:
        rows = [
            [
                f"{loss.pair.links[0]}–{loss.pair.links[1]}",
                loss.pair.name,
                self.words.pair_kind(loss.pair),
                self.page.num(loss.rubbing.coefficient),
                self.page.num(loss.rubbing.diameter) if loss.rubbing.diameter else "—",
            ]
            for loss in self.r.friction.table.pairs
        ]
        heads = [
            self.t("Links"), self.t("Point, guide"), self.t("Kind"), self.t("Friction coefficient"),
            self.page.listed([self.t("Journal diameter"), self.page.unit("m")]),
        ]  # fmt: skip
        return worded(caption, heads, rows, (2, 2, 4, 3, 3))
