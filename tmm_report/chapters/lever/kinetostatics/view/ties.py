"""View of springs and dampers between points: what is stated of them, their lengths and forces over the cycle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.initial_data.quantities import given_tables
from tmm_report.chapters.lever.kinematics import quantities as rates
from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.quantities import ties as own
from tmm_report.chapters.lever.kinetostatics.solve.drawn_cycle import Sampled
from tmm_report.chapters.lever.kinetostatics.solve.lengths import ties_of
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.kinetostatics.ties import End, Spring
from tmm_report.chapters.lever.kinetostatics.view.diagrams import sheets_of
from tmm_report.figures.charts.graphs import Graph
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.problems import N_
from tmm_report.quantity import model
from tmm_report.quantity.formula import Expr, Formula, sqrt
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import CycleGraphs
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, worded

POINT, FIXED = N_("%(point)s of link %(link)s"), N_("%(point)s of the frame")
AT_POSITION, AT_LENGTH = N_("%(force)s at position %(position)s"), N_("%(force)s at %(length)s")
NONE = "—"


class TiesView(BookView):
    def __init__(self, found: Kinetostatics, position: int, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found, self.ties = found, ties_of(found.given)
        self.springs = [end for end in self.ties if isinstance(end.tie, Spring)]
        self.dampers = [end for end in self.ties if not isinstance(end.tie, Spring)]
        self.asked = position

    # ------------------------------------------------------------ what is given

    def given(self, caption: Any, name: str) -> Table:
        """The stated springs or dampers: name, points, coefficient, of a spring its free length or preload."""
        table, springs = self.table(name), name == "springs"
        rows = []
        for row, end in enumerate(self.springs if springs else self.dampers):
            called = self.page.word(table["name"].values[row], table, "name", row)
            points = [self._point(table, row, which) for which in ("one", "other")]
            amount = self.page.cell(table, "c" if springs else "b", row)
            rows.append(
                [
                    self.page.sym(own.coefficient(end)),
                    called,
                    *points,
                    amount,
                    *(self._unloaded(row, end) if springs else ()),
                ]
            )
        coefficient = self.t("Stiffness, N/m") if springs else self.t("Coefficient, N·s/m")
        heads = [self.t("Symbol"), self.t("Name"), self.t("From point"), self.t("To point"), coefficient]
        heads += [self.t("Free length, mm"), self.t("Preload, N")] if springs else []
        return worded(caption, heads, rows, (2, 4, 4, 4, 3, 3, 5)[: len(heads)])

    def _point(self, table: model.Table, row: int, which: str) -> Markup:
        """A point and the link that takes the force there."""
        point = self.page.said(Cell(str(table[which].values[row]), table.ref(which, row)))
        link = str(table[f"link_{which}"].values[row])
        said = self.page.said(Cell(link, table.ref(f"link_{which}", row)))
        return self.t(FIXED, point=point) if link == FRAME else self.t(POINT, point=point, link=said)

    def _unloaded(self, row: int, end: End) -> list[Any]:
        """Free length, or the preload in its place."""
        table, tie = self.table("springs"), end.tie
        assert isinstance(tie, Spring)
        if tie.preload is None:
            return [self.page.cell(table, "l_0", row, unit="mm"), NONE]
        force = self.page.shown(table, "F_0", row)
        if tie.at_length is None:
            return [NONE, self.t(AT_POSITION, force=force, position=tie.at_position or 0)]
        arm = self.page.shown(table, "l_F", row, unit="mm")
        under = self.page.in_unit(arm, "mm")
        return [NONE, self.t(AT_LENGTH, force=force, length=under)]

    # ------------------------------------------------------------ the sample position

    def free(self) -> list[Formula]:
        """Free lengths of the springs that are stated by a preload."""
        if not self.springs:
            return []
        table = self.table("springs")
        loaded = [k for k, end in enumerate(self.springs) if end.tie.preload is not None]  # type: ignore[attr-defined]
        return [
            table.formula("l_0", k, table.var("l_F", k) - table.var("F_0", k) / table.var("c", k))
            for k in loaded
        ]

    def position(self, end: End) -> int:
        """The sample position, or the first in which the tie has a force."""
        known = np.isfinite(np.asarray(self.of("ties_table", own.force(end).key).values, dtype=float))
        return self.asked if known[self.asked] else int(np.argmax(known))

    def formulas(self, end: End) -> list[Formula]:
        """Length by the coordinates, its rate by the projections of the velocities, the force."""
        table, k = self.table("ties_table"), self.position(end)
        length, rate, force = (of(end).key for of in (own.length, own.rate, own.force))
        ways = [self._difference(end, axis, k) for axis in "xy"]
        found = [table.formula(length, k, sqrt(ways[0] ** 2 + ways[1] ** 2))]
        if isinstance(end.tie, Spring):
            springs, row = self.table("springs"), self.springs.index(end)
            out = table.var(length, k) - springs.var("l_0", row)
            return [*found, table.formula(force, k, springs.var("c", row) * out)]
        dampers, row = self.table("dampers"), self.dampers.index(end)
        grows = sum_of(
            [way * fast for way, axis in zip(ways, "xy", strict=True) if (fast := self._rate(end, axis, k))]
        )
        found.append(table.formula(rate, k, grows / table.var(length, k)))
        return [*found, table.formula(force, k, dampers.var("b", row) * table.var(rate, k))]

    def _difference(self, end: End, axis: str, k: int) -> Expr:
        one, other = (self._coordinate(point, axis, k) for point in end.tie.between)
        return other - one

    def _coordinate(self, point: str, axis: str, k: int) -> Expr:
        fixed = self._fixed
        if point in (names := list(fixed["point"].values)):
            return fixed.var(axis, names.index(point))
        return self._motion.tables["positions_table"].var(f"{axis}_{point}", k)

    def _rate(self, end: End, axis: str, k: int) -> Expr | None:
        """What the second point goes faster than the first along an axis; None where neither moves."""
        table = self._motion.tables["rates_table"]
        one, other = (
            None if point in self._fixed["point"].values else table.var(f"v_{point}_{axis}", k)
            for point in end.tie.between
        )
        if one is None or other is None:
            return other if one is None else -one
        return other - one

    @cached_property
    def _fixed(self) -> model.Table:
        mechanism = self.found.kinematics.linkage.mechanism
        return next(table for table in given_tables(mechanism) if table.name == "fixed_points")

    @cached_property
    def _motion(self) -> model.Book:
        return self.page.once(rates.book, self.found.kinematics)

    def said(self) -> list[dict[str, Any]]:
        return self.where(*self.free(), *(one for end in self.ties for one in self.formulas(end)))

    def called(self, end: End) -> Markup:
        """ "Spring c1, valve spring"."""
        return self.t(own.SPRING_CALLED if isinstance(end.tie, Spring) else own.DAMPER_CALLED, of=end.of)

    # ------------------------------------------------------------ over the cycle

    def by_position(self, caption: Any) -> Table:
        keys = [of(end).key for end in self.ties for of in (own.length, own.rate, own.force)]
        return self.by_positions(caption, "ties_table", keys)

    @property
    def met(self) -> list[int]:
        """Positions at which the points of one of them meet."""
        columns = [np.asarray(self.of("ties_table", own.force(end).key).values, float) for end in self.ties]
        lengths = [np.asarray(self.of("ties_table", own.length(end).key).values, float) for end in self.ties]
        rows = zip(columns, lengths, strict=True)
        lost = np.any([np.isnan(force) & np.isfinite(length) for force, length in rows], axis=0)
        return [int(k) for k in np.flatnonzero(lost[: self.found.positions])]

    def diagrams(self, at: Sampled, graphs: CycleGraphs) -> Sequence[Graph]:
        """Forces of all of them over the cycle."""
        return sheets_of(list(self._panels(at, graphs)), graphs, self.page.form.paper.page[1])

    def _panels(self, at: Sampled, graphs: CycleGraphs) -> Iterator[Any]:
        found = self.found
        for end in self.ties:
            k = own.of_tie(found, end)[0]
            over = found.over.loading.stated[k] if found.over else None
            yield [at.of(over, found.diagram.loading.stated[k])], graphs.axis(own.force(end))


def sum_of(terms: Sequence[Expr]) -> Expr:
    total, *others = terms
    for one in others:
        total = total + one
    return total
