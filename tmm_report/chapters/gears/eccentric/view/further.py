"""View of what may be asked for besides the family: sets near the ratio, masses of the satellites, paths."""

from __future__ import annotations

from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.gears.eccentric import equations
from tmm_report.chapters.gears.eccentric.draw.path import path_drawing
from tmm_report.chapters.gears.eccentric.quantities import tables
from tmm_report.chapters.gears.eccentric.solve.mechanism import Found
from tmm_report.chapters.gears.eccentric.steps import Path, steps
from tmm_report.figures.drawing import Drawing
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric, worded

SHOWN = 12  # sets near the ratio


class FurtherView(ChapterView):
    def __init__(self, found: Found, page: Page):
        self.found, self.made = found, steps(found)
        super().__init__(page, self.made.s, tables(found))

    # ------------------------------------------------------------ sets near the ratio

    def definitions(self) -> list[Definition]:
        return equations.near(self.made)

    def near(self, caption: Any) -> Table:
        """The best of the sets near the ratio."""
        table, page = self.table("near"), self.page
        whole = ("place", "z1", "z2", "z3", "z5")
        rows = [
            [
                *(Cell(str(int(table[key].values[row])), table.ref(key, row)) for key in whole),
                page.cell(table, "u", row),
                page.cell(table, "delta_u", row, places=2),
                page.word(table["satellites"].values[row] or "—", table, "satellites", row),
            ]
            for row in range(min(SHOWN, len(table)))
        ]
        heads = [self.t("No."), *(page.head(table[key].symbol()) for key in (*whole[1:], "u"))]
        heads += [page.head(table["delta_u"].symbol(), "%"), self.t("Planet gears")]
        return worded(caption, heads, rows, (1, 1, 1, 1, 1, 1.4, 1.4, 2))

    # ------------------------------------------------------------ masses

    def mass(self) -> list[Formula]:
        """Of each satellite of the chosen set, and the saving."""
        of = self.made.masses
        each = [of.formula(key) for key in of.computed()] if of else []
        return [*each, *self.formulas("saved_share")]

    def masses(self, caption: Any) -> Table:
        """Of every set of the family."""
        table, page = self.table("masses"), self.page
        sets = [Cell(str(int(t)), table.ref("t", row)) for row, t in enumerate(table["t"].values)]
        keys = ("m4", "held") if self.found.halved else ("m2", "m4", "m5", "held", "saving")
        return numeric(caption, Column(page.sym("t"), sets), [self._mass_column(key) for key in keys])

    def _mass_column(self, key: str) -> Column:
        """A dash for a satellite of half a tooth."""
        column, known = self.column("masses", key), np.isfinite(self.of("masses", key).numbers())
        return column._replace(
            cells=[cell if there else "—" for cell, there in zip(column.cells, known, strict=True)]
        )

    def mass_of(self, key: str) -> Markup:
        """Of the chosen set."""
        return self.page.value(self.table("masses").var(key, self.found.row))

    # ------------------------------------------------------------ loads

    def moments(self) -> list[Formula]:
        """The sum of the circumferential forces, the moments on the others."""
        return self.formulas("F_sum", "M_1", "M_3", "M_H")

    def sharing(self) -> list[Formula]:
        """What a satellite has of the sum, and its normal force: of each, or of the first where all are alike."""
        rows = self.made.loads
        if self.found.given.load is None or self.found.given.load.yielding is None:
            return [rows[0].formula(key) for key in ("F_t", "F_n")]
        each = [row.formula("w") for row in rows]
        forces = [row.formula("F_t") for row in rows]
        shared, normal = self.formulas("share_sum"), rows[0].formula("F_n")
        return [*self.of_each_kind(each), *shared, *self.of_each_kind(forces), normal]

    def of_first(self, *keys: str) -> list[Formula]:
        """Of the first satellite: what the letters of all are."""
        return [self.made.loads[0].formula(key) for key in keys if self.made.loads[0].has_formula(key)]

    def on_axes(self) -> list[Formula]:
        return self.of_each_kind(row.formula("Q") for row in self.made.loads)

    def loads(self, caption: Any) -> Table:
        table = self.table("loads")
        names = [self.page.word(text, table, "wheel", row) for row, text in enumerate(table["wheel"].values)]
        keys = [key for key in ("w", "F_t", "F_n", "Q") if key in table]
        columns = [self.page.singles(table, "gamma", places=3), *self.columns("loads", keys)]
        return numeric(caption, Column(self.t("Planet gear"), names), columns)

    # ------------------------------------------------------------ paths

    @property
    def paths(self) -> tuple[Path, ...]:
        return self.made.paths

    def of_ring(self, path: Path) -> bool:
        return path.traced.point.of_ring

    def path_values(self, path: Path) -> Markup:
        """Where the point lies on its wheel."""
        return self.page.values([path.s.radius, path.s.angle])

    def place(self, path: Path) -> list[Formula]:
        """Both coordinates at the position written out."""
        return [path.place.formula(key) for key in ("x", "y")]

    def theta(self, path: Path) -> Markup:
        return self.page.value(path.place.theta)

    def places(self, path: Path, caption: Any) -> Table:
        return self.by_positions(caption, f"path_{path.traced.name}")

    def drawing(self, path: Path) -> Drawing:
        title = self.t("Path of point %(name)s", name=path.traced.name)
        return path_drawing(self.found, path.traced, str(title))

    def scale(self, path: Path) -> Markup:
        """1:2 or 2:1, as it is written under the drawing."""
        if "enlargement" in path.s:
            return self.page.listed([self.page.shown(path.s["enlargement"]), "1"], ":")
        return self.page.listed(["1", self.page.shown(path.s["reduction"])], ":")
