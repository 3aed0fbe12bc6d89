"""View of what may be asked for besides the family: sets near the ratio, masses of the satellites, paths."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.gears.eccentric.draw.path import path_drawing, path_scale
from tmm_report.chapters.gears.eccentric.paths import Traced
from tmm_report.chapters.gears.eccentric.quantities.further import MASSES
from tmm_report.chapters.gears.eccentric.solve.mechanism import RING, Found
from tmm_report.figures.drawing import Drawing
from tmm_report.quantity.formula import PI, Formula, Number, Var, cos, sin
from tmm_report.quantity.model import Table as Numbers
from tmm_report.quantity.part import Part
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric, worded

SHOWN = 12  # sets near the ratio
WRITTEN = 1  # the position written out in full


class FurtherView:
    def __init__(self, found: Found, page: Page, of: Part):
        self.found, self.page, self.of, self.t = found, page, of, page.t

    # ------------------------------------------------------------ sets near the ratio

    def near(self, caption: Any) -> Table:
        """The best of the sets near the ratio."""
        table, page = self.of.table("near"), self.page
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
        heads += [page.listed([page.sym(table["delta_u"].symbol()), "%"]), self.t("Satellites")]
        return worded(caption, heads, rows, (1, 1, 1, 1, 1, 1.4, 1.4, 2))

    # ------------------------------------------------------------ masses

    @property
    def _mass_table(self) -> Numbers:
        return self.of.table("masses")

    def mass(self) -> Iterator[Formula]:
        """Of each satellite of the chosen set, of all that it holds, and the saving."""
        row, table = self.found.row, self._mass_table
        whole = self.found.middle_whole
        for wheel, _ in MASSES:
            if wheel != "4" or whole:
                d = self.of["m"].var("m") * self.of.table("family").var(f"z{wheel}", row, digits=9)
                disc = PI * d**2 * self.of["b"].var("m") * self.of["density"].var() / 4
                yield table.formula(f"m{wheel}", row, disc)
        m2, m5 = (table.var(f"m{wheel}", row) for wheel in ("2", "5"))
        yield table.formula("saving", row, m2 - m5)
        yield self.of["saved_share"].formula(table.var("saving", row) / m2 * Number(100))

    def masses(self, caption: Any) -> Table:
        """Of every set of the family."""
        table, page = self._mass_table, self.page
        sets = [Cell(str(int(t)), table.ref("t", row)) for row, t in enumerate(table["t"].values)]
        columns = [page.column(table, key) for key in ("m2", "m4", "m5", "held", "saving")]
        columns[1] = columns[1]._replace(
            cells=[cell if self._known("m4", row) else "—" for row, cell in enumerate(columns[1].cells)]
        )
        return numeric(caption, Column(page.sym("t"), sets), columns)

    def _known(self, key: str, row: int) -> bool:
        number = float(self._mass_table[key].values[row])
        return number == number

    def mass_held(self) -> Markup:
        return self.page.value(self._mass_table.var("held", self.found.row))

    def saving(self) -> Markup:
        return self.page.value(self._mass_table.var("saving", self.found.row))

    # ------------------------------------------------------------ paths

    def path_values(self, path: Traced) -> Markup:
        """Where the point lies on its wheel."""
        radius = self._path(path, "radius", "mm")
        return self.page.values([radius, self._path(path, "angle")])

    def _path(self, path: Traced, key: str, unit: str = "") -> Var:
        return self.of[f"path_{path.point.name}_{key}"].var(unit)

    def of_ring(self, path: Traced) -> bool:
        return path.point.wheel == RING

    def rate(self, path: Traced) -> Formula:
        """1 + z1/z3 of the ring, 1 + z3/z1 of the sun."""
        one, three = (self.of[key].var(digits=9) for key in ("z1", "z3"))
        ratio = one / three if self.of_ring(path) else three / one
        return self.of[f"path_{path.point.name}_rate"].formula(1 + ratio)

    def place(self, path: Traced) -> Iterator[Formula]:
        """Both coordinates at the position written out."""
        table = self.of.table(f"path_{path.point.name}")
        theta = table.var("theta", WRITTEN)
        radius, start, rate = (
            self._path(path, "radius", "mm"),
            self._path(path, "angle"),
            self._path(path, "rate"),
        )
        turned = rate * theta + start
        e = self.of["e"].var("mm")
        for key, of in (("x", cos), ("y", sin)):
            there = radius * of(turned)
            whole = e * of(theta) + there if self.of_ring(path) else there - e * of(theta)
            yield table.formula(key, WRITTEN, whole, "mm", scale=radius.number)

    def theta(self, path: Traced) -> Markup:
        table = self.of.table(f"path_{path.point.name}")
        return self.page.value(table.var("theta", WRITTEN))

    def turns(self, path: Traced) -> Markup:
        return self.page.shown(self.of[f"path_{path.point.name}_turns"])

    def places(self, path: Traced, caption: Any) -> Table:
        table = self.of.table(f"path_{path.point.name}")
        columns = [
            self.page.column(table, key, unit)
            for key, unit in (("theta", ""), ("psi", ""), ("x", "mm"), ("y", "mm"))
        ]
        return numeric(caption, self.page.positions(table), columns)

    def drawing(self, path: Traced) -> Drawing:
        return path_drawing(self.found, path, str(self.t("Path of point %(name)s", name=path.point.name)))

    def scale(self, path: Traced) -> Markup:
        """1:2 or 2:1, as it is written under the drawing."""
        key = f"path_{path.point.name}"
        if path_scale(path) >= 1:
            return self.page.listed([self.page.shown(self.of[f"{key}_enlargement"]), "1"], ":")
        return self.page.listed(["1", self.page.shown(self.of[f"{key}_reduction"])], ":")
