"""Tables of the eccentric epicyclic mechanism: sets of teeth, dimensions, places, conditions, proof, speeds."""

from __future__ import annotations

from typing import Any

from tmm_report.chapters.gears.eccentric.quantities import tables
from tmm_report.chapters.gears.eccentric.solve.mechanism import CARRIER, RING, SUN, Found
from tmm_report.chapters.gears.eccentric.steps import steps
from tmm_report.chapters.gears.eccentric.values import Values
from tmm_report.mechanics.gears.limits.condition import Condition
from tmm_report.problems import N_
from tmm_report.quantity import model as quantity
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric, worded

CONDITIONS = {
    "assembly": N_("assembly of planet gear %(wheel)s, pitches"),
    "neighbourhood": N_("neighbourhood of planet gears %(wheel)s"),
    "tips": N_("tips of sun and ring apart"),
    "undercut": N_("no undercut of wheel %(wheel)s, teeth"),
    "root": N_("no interference of the ring with the root of planet gear %(wheel)s"),
    "fouling": N_("no overlap of the tips of planet gear %(wheel)s and the ring"),
}


class EccentricTables(ChapterView):
    s: Values

    def __init__(self, found: Found, page: Page):
        self.found, self.made = found, steps(found)
        super().__init__(page, self.made.s, tables(found))

    # ------------------------------------------------------------ tables

    def family(self) -> Table:
        """Nothing is said of middle satellites of half a tooth."""
        table, page = self.table("family"), self.page
        keys = ("t", "z1", "z2", "z3", "z4", "z5", "residue_4", "closed_2_4", "gap_4_5")
        heads = [page.head(table[key].symbol(), table[key].quantity.printed) for key in keys]
        rows = [self._set(row) for row in range(len(table))]
        shares = (2, 2, 2, 2, 2, 2, 3, 4, 4, 5)
        return worded(self.t("Sets of teeth of the family"), [*heads, self.t("Planet gears")], rows, shares)

    def _set(self, row: int) -> list[str]:
        table, page = self.table("family"), self.page
        whole = float(table["z4"].values[row]).is_integer()
        held = table["satellites"].values[row]
        middle: list[str] = ["—"] * 4
        beside = float(table["z2"].values[row]).is_integer()
        if whole:
            gaps = ("closed_2_4", "gap_4_5")
            middle = [
                page.cell(table, "z4", row),
                page.cell(table, "residue_4", row, size=True, places=3),
                *(page.cell(table, key, row, places=3, scale=1e3) if beside else "—" for key in gaps),
            ]
        return [
            Cell(str(int(table["t"].values[row])), table.ref("t", row)),
            *(self._teeth(key, row) for key in ("z1", "z2", "z3")),
            middle[0],
            self._teeth("z5", row),
            *middle[1:],
            page.word(held or "—", table, "satellites", row),
        ]

    def _teeth(self, key: str, row: int) -> str:
        """A dash for half a tooth."""
        table = self.table("family")
        whole = float(table[key].values[row]).is_integer()
        return self.page.cell(table, key, row) if whole else "—"

    def _words(self, title: str, table: quantity.Table, key: str) -> Column:
        """A first column of names."""
        names = [self.page.word(text, table, key, row) for row, text in enumerate(table[key].values)]
        return Column(self.t(title), names)

    def _whole(self, table: quantity.Table, key: str) -> Column:
        """Whole numbers with all their digits."""
        texts = [Cell(str(int(z)), table.ref(key, row)) for row, z in enumerate(table[key].values)]
        return Column(self.page.head(table[key].symbol()), texts)

    def sizes(self) -> Table:
        """Teeth and diameters of all the wheels, mm."""
        table = self.table("wheels")
        lengths = (self.page.singles(table, key, places=3) for key in ("d", "d_b", "d_a", "d_f"))
        columns = [self._whole(table, "z"), *lengths]
        return numeric(self.t("Dimensions of the wheels"), self._words(N_("Wheel"), table, "wheel"), columns)

    def places(self) -> Table:
        """Angles, centres and assembly of the satellites."""
        table, singles = self.table("satellites"), self.page.singles
        columns = [
            self._whole(table, "z"),
            *(singles(table, key, places=3) for key in ("phi1", "phi3", "x", "y")),
            singles(table, "L", places=4),
            singles(table, "residue", size=True, places=4),
        ]
        first = self._words(N_("Planet gear"), table, "wheel")
        return numeric(self.t("Positions of the planet gears"), first, columns)

    def conditions(self) -> Table:
        rows = [
            self._condition(condition, row)
            for row, condition in enumerate(self.found.conditions)
            if self._own(condition)
        ]
        heads = [self.t("Condition"), self.t("Value"), self.t("Limit"), self.t("Margin"), self.t("Met")]
        return worded(self.t("Conditions of the mechanism"), heads, rows, (9, 2, 2, 2, 2))

    def _own(self, c: Condition) -> bool:
        """Whether the condition is not the mirror image of another."""
        pairs = [{pair.one.wheel, pair.other.wheel} for pair in self.found.near]
        return set(c.wheel.split("–")) in pairs if c.key == "neighbourhood" else not c.wheel.endswith("'")

    def _condition(self, c: Condition, row: int) -> list[Any]:
        table, page = self.table("conditions"), self.page
        text = self.t(CONDITIONS[c.key], wheel=c.wheel)
        limit = page.shown(table, "limit", row, c.unit, digits=4)
        return [
            page.listed([text, page.unit(c.unit)]) if c.unit else text,
            page.cell(table, "value", row, c.unit),
            page.listed(["≥" if c.least else "≤", limit], " "),
            page.cell(table, "in_hand", row, c.unit),
            self.t("yes") if c.met else self.t("no"),
        ]

    def proof(self) -> Table:
        table, page = self.table("teeth"), self.page
        overlap = self.t("Overlap, %(unit)s", unit=page.unit("mm²"))
        clearance = self.t("Least clearance, %(unit)s", unit=page.unit("mm"))
        rows = range(len(table))
        columns = [
            Column(overlap, [page.cell(table, "overlap", row, digits=3, scale=1e3) for row in rows]),
            Column(clearance, [page.cell(table, "clearance", row, places=5, scale=1e-3) for row in rows]),
        ]
        first = self._words(N_("Wheels"), table, "wheels")
        return numeric(self.t("Overlap and clearance of the teeth over a full pitch"), first, columns)

    def speeds(self) -> Table:
        """Speeds of all the members with one of them stopped, rad/s."""
        names = [SUN, *(s.wheel for s in self.found.upper), RING, CARRIER]
        columns = self.columns("speeds", [f"omega_{name}" for name in names])
        first = self._words(N_("Stopped"), self.table("speeds"), "stopped")
        return numeric(self.t("Angular velocities of the members"), first, columns)
