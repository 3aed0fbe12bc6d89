"""View of the drawings of a spur pair: the mesh and what is read off it, zones of contact, blocking contour."""

from __future__ import annotations

import math
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.gears.spur.draw.contour import contour
from tmm_report.chapters.gears.spur.draw.mesh import mesh_drawing
from tmm_report.chapters.gears.spur.draw.phase import phase_drawing
from tmm_report.chapters.gears.spur.draw.sliding import sliding_drawing
from tmm_report.chapters.gears.spur.draw.zones import zones
from tmm_report.chapters.gears.spur.quantities import tables
from tmm_report.chapters.gears.spur.solve.pair import Found
from tmm_report.chapters.gears.spur.solve.readings import Reading
from tmm_report.chapters.gears.spur.steps import stage
from tmm_report.chapters.gears.spur.words import HARD, LACKS, NONE, PAIRS, STUCK
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.gears.limits.blocking_contour import Lack
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric, worded

CHOSEN, NEAREST, SAME_DISTANCE = range(3)  # rows of the contour's table


class TeethView(ChapterView):
    """Pictures and readings of one pair. `label` begins the labels of its figures and its names in the results."""

    def __init__(self, found: Found, page: Page, label: str):
        super().__init__(page, stage(found, label).drawn, tables(found, label))
        self.found, self.label, self.names = found, label, found.given.wheels
        self.contour_found = found.contour
        self.wheel = 1 - found.teeth.small  # the larger: its angles are read off
        self.read, self.shifts = self.table("readings"), self.table("contour")

    def num(self, value: float) -> str:
        return self.page.num(value, 4)

    # ------------------------------------------------------------ the mesh

    @property
    def scale(self) -> Markup:
        """The scale of the drawing: 2:1, 1:2.5."""
        larger = self.found.mesh.scale >= 1
        number = self.number("scale" if larger else "reduction", digits=4)
        return self.page.listed([number, ":1"] if larger else ["1:", number], "")

    def drawing(self) -> Drawing:
        return mesh_drawing(self.found.mesh, self.names, self.num, str(self.t("Gear pair in mesh")))

    def phase(self) -> Drawing:
        phase = self.found.phase
        assert phase is not None
        return phase_drawing(
            self.found.mesh, phase, self.names, self.num, str(self.t("Two pairs of teeth in contact"))
        )

    def phase_table(self, caption: Any) -> Table:
        """Where the pair touches: radii of curvature, and distances from both axes."""
        table = self.table("phase")
        points = [self.page.word(name, table, "point", row) for row, name in enumerate(table["point"].values)]
        columns = self.columns("phase", leave=("point",))
        return numeric(caption, Column(self.t("Point"), points), columns)

    @property
    def per_mm(self) -> Markup:
        """The scale of the graph of specific sliding."""
        return self.sized("mu_sliding")

    def sliding(self) -> Drawing:
        per_mm = self.s.number("mu_sliding")
        return sliding_drawing(self.found.mesh, self.names, per_mm, self.num, str(self.t("Specific sliding")))

    def zones(self) -> Drawing:
        return zones(self.found.mesh, self.num, self._pairs, str(self.t("Zones of contact")))

    def _pairs(self, count: int) -> str:
        return self.page.tr.gettext(PAIRS[count]) if count < len(PAIRS) else str(count)

    # ------------------------------------------------------------ what is read off

    @property
    def accuracy(self) -> Markup:
        return self.number("accuracy", digits=4)

    def readings(self, caption: Any) -> Table:
        """Every value read off the drawing beside the computed one, with the difference in per cent."""
        rows = [
            [
                self._sign(row, reading),
                self._measured("graph", row, reading),
                self._measured("analytic", row, reading),
                self.page.cell(self.read, "delta", row, places=3),
            ]
            for row, reading in enumerate(self.found.readings)
        ]
        heads = [self.t("Quantity"), self.t("By the drawing"), self.t("Computed"), self.t("Difference, %%")]
        return worded(caption, heads, rows, (4, 3, 3, 3))

    def _sign(self, row: int, reading: Reading) -> Markup:
        """The symbol of a row; of the contact ratio, how it is read off."""
        sign = self.page.sym(self.read["analytic"].symbol(row))
        if reading.wheel is None:
            return self.page.listed([sign, self.page.unit("mm")])
        if reading.key != "ratio":
            return sign
        above, below = (
            self.page.sym(self.read["graph"].symbol(self._row(key, reading.wheel)))
            for key in ("angle", "pitch")
        )
        return self.page.listed([sign, " = ", above, "/", below], "")

    def _measured(self, key: str, row: int, reading: Reading) -> Cell | Markup:
        """Lengths in mm, angles in degrees with their sign."""
        if reading.wheel is None:
            return self._whole(self.page.cell(self.read, key, row, "mm", places=self._places))
        if reading.key == "ratio":
            return self._whole(self.page.cell(self.read, key, row, digits=6))
        angle = self._whole(self.page.cell(self.read, key, row, "deg", places=4))
        return self.page.listed([self.page.said(angle), "°"], "")

    @property
    def _places(self) -> int:
        """Decimals of a length in mm: one more than its ends are read to, so that the difference can be checked."""
        finest = 1e3 * self.s.number("accuracy") / self.found.mesh.scale
        return max(0, 1 + math.ceil(-math.log10(finest) - 1e-9))

    @staticmethod
    def _whole(cell: Cell) -> Cell:
        """The number with the zeros at its end, so that all rows have the same decimals."""
        return Cell(cell.full, cell.ref)

    def _row(self, key: str, wheel: int) -> int:
        return next(n for n, r in enumerate(self.found.readings) if (r.key, r.wheel) == (key, wheel))

    def graph_ratio(self) -> Formula:
        """The contact ratio read off the drawing."""
        above, below = (
            self.read.var("graph", self._row(key, self.wheel), "deg") for key in ("angle", "pitch")
        )
        return self.read.formula("graph", self._row("ratio", self.wheel), above / below)

    def difference(self) -> Formula:
        """By how many per cent it differs from the computed one: 200 |a − b|/(a + b)."""
        row = self._row("ratio", self.wheel)
        drawn, computed = (self.read.var(key, row, digits=6) for key in ("graph", "analytic"))
        apart = 200 * abs(computed - drawn) / (computed + drawn)
        return self.read.formula("delta", row, apart, digits=2)

    # ------------------------------------------------------------ proof by the outlines

    @property
    def proof(self) -> dict[str, Markup]:
        """Overlap, mm², clearance and contact ratio of the drawn outlines over a pitch, printed."""
        return {
            "overlap": self.number("overlap", digits=3, scale=1e3),
            "clearance": self.measured("clearance", digits=2, scale=1e6),
            "ratio": self.number("eps_counted"),
        }

    @property
    def touching(self) -> bool:
        """Whether the distance between the outlines is printed as nought."""
        return self.proof["clearance"].striptags().startswith("0 ")

    # ------------------------------------------------------------ the blocking contour

    def contour(self) -> Drawing:
        return contour(self.found.contour, self.names, self.num, str(self.t("Blocking contour")))

    def lacks(self) -> list[Markup]:
        return [self._lack(row, lack) for row, lack in enumerate(self.found.contour.lacks)]

    def _lack(self, row: int, lack: Lack) -> Markup:
        wheel = self.names[lack.limit.wheel - 1]
        if lack.limit.kind not in LACKS or math.isnan(lack.lack):
            return self.t(HARD, wheel=wheel) if lack.limit.wheel else self.t(NONE)
        if math.isinf(lack.lack) and lack.limit.kind == "fouling":
            return self.t(STUCK)
        table = self.table("lacks")
        value, bound, wanting = (
            self.page.shown(table, key, row, places=4) for key in ("value", "bound", "lack")
        )
        return self.t(
            LACKS[lack.limit.kind],
            wheel=wheel,
            value=value,
            bound=bound,
            lack=wanting,
            degrees=wanting,
            m=self.page.sym("m"),
        )

    def point(self, row: int) -> Markup:
        """The shifts of a point of the contour."""
        return self.page.listed(self.page.value(self.shifts.var(f"x_{name}", row)) for name in self.names)

    def margin(self, row: int) -> Markup:
        """How far the shifts would be changed."""
        return self.page.shown(self.shifts, "step", row, places=4)
