"""Tables of the eccentric epicyclic mechanism: sets of teeth, dimensions, places, conditions, proof, speeds."""

from __future__ import annotations

from typing import Any

from tmm_report.chapters.gears.eccentric.formulas import EccentricFormulas
from tmm_report.chapters.gears.eccentric.solve.mechanism import CARRIER, RING, SUN, Found
from tmm_report.mechanics.gears.limits.condition import Condition
from tmm_report.problems import N_
from tmm_report.quantity import model as quantity
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric, worded

CONDITIONS = {
    "assembly": N_("assembly of satellite %(wheel)s, pitches"),
    "neighbourhood": N_("neighbourhood of satellites %(wheel)s"),
    "tips": N_("tips of sun and ring apart"),
    "undercut": N_("no undercut of wheel %(wheel)s, teeth"),
    "root": N_("no interference of the ring with the root of satellite %(wheel)s"),
    "fouling": N_("no overlap of the tips of satellite %(wheel)s and the ring"),
}


class EccentricTables(EccentricFormulas):
    """`label` begins the labels of the chapter's sections and its names in the results."""

    def __init__(self, found: Found, page: Page, label: str):
        super().__init__(found, label)
        self.page, self.label = page, label
        self.t = page.t

    # ------------------------------------------------------------ tables

    def family(self) -> Table:
        """Nothing is said of middle satellites of half a tooth."""
        table, page = self.family_of, self.page
        heads = [page.head(table[key].symbol()) for key in ("t", "z1", "z2", "z3", "z4", "z5", "residue_4")]
        heads += [page.head(table[key].symbol(), "mm") for key in ("closed_2_4", "gap_4_5")]
        rows = [self._set(row) for row in range(len(table))]
        shares = (2, 2, 2, 2, 2, 2, 3, 4, 4, 5)
        return worded(self.t("Sets of teeth of the family"), [*heads, self.t("Satellites")], rows, shares)

    def _set(self, row: int) -> list[str]:
        table, page = self.family_of, self.page
        whole = float(table["z4"].values[row]).is_integer()
        held = table["satellites"].values[row]
        middle: list[str] = ["—"] * 4
        beside = float(table["z2"].values[row]).is_integer()
        if whole:
            gaps = ("closed_2_4", "gap_4_5")
            middle = [
                page.cell(table, "z4", row),
                page.cell(table, "residue_4", row, size=True, places=3),
                *(page.cell(table, key, row, "mm", places=3, scale=1e3) if beside else "—" for key in gaps),
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
        whole = float(self.family_of[key].values[row]).is_integer()
        return self.page.cell(self.family_of, key, row) if whole else "—"

    def _words(self, title: str, table: quantity.Table, key: str) -> Column:
        """A first column of names."""
        names = [self.page.word(text, table, key, row) for row, text in enumerate(table[key].values)]
        return Column(self.t(title), names)

    def _cells(self, head: Any, table: quantity.Table, key: str, unit: str = "", **form: Any) -> Column:
        """A column with decimals of its own in each cell."""
        return Column(head, [self.page.cell(table, key, row, unit, **form) for row in range(len(table))])

    def _whole(self, table: quantity.Table, key: str) -> Column:
        """Whole numbers with all their digits."""
        texts = [Cell(str(int(z)), table.ref(key, row)) for row, z in enumerate(table[key].values)]
        return Column(self.page.head(table[key].symbol()), texts)

    def _mm(self, table: quantity.Table, key: str) -> Column:
        return self._cells(self.page.head(table[key].symbol(), "mm"), table, key, "mm", places=3)

    def sizes(self) -> Table:
        """Teeth and diameters of all the wheels, mm."""
        table = self.of.table("wheels")
        columns = [self._whole(table, "z"), *(self._mm(table, key) for key in ("d", "d_b", "d_a", "d_f"))]
        return numeric(self.t("Dimensions of the wheels"), self._words(N_("Wheel"), table, "wheel"), columns)

    def places(self) -> Table:
        """Angles, centres and assembly of the satellites."""
        table, page = self.satellites_of, self.page
        columns = [
            self._whole(table, "z"),
            *(
                self._cells(page.listed([page.sym(table[key].symbol()), "°"]), table, key, places=3)
                for key in ("phi1", "phi3")
            ),
            *(self._mm(table, key) for key in ("x", "y")),
            self._cells(page.head(table["L"].symbol()), table, "L", places=4),
            self._cells(page.head(table["residue"].symbol()), table, "residue", size=True, places=4),
        ]
        first = self._words(N_("Satellite"), table, "wheel")
        return numeric(self.t("Positions of the satellites"), first, columns)

    def conditions(self) -> Table:
        rows = [
            self._condition(condition, row)
            for row, condition in enumerate(self.found.conditions)
            if self._own(condition)
        ]
        heads = [self.t("Condition"), self.t("Value"), self.t("Limit"), self.t("In hand"), self.t("Met")]
        return worded(self.t("Conditions of the mechanism"), heads, rows, (9, 2, 2, 2, 2))

    def _own(self, c: Condition) -> bool:
        """Whether the condition is not the mirror image of another."""
        pairs = [{pair.one.wheel, pair.other.wheel} for pair in self.found.near]
        return set(c.wheel.split("–")) in pairs if c.key == "neighbourhood" else not c.wheel.endswith("'")

    def _condition(self, c: Condition, row: int) -> list[Any]:
        table, page = self.of.table("conditions"), self.page
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
        table, unit = self.of.table("teeth"), self.page.unit
        columns = [
            self._cells(
                self.t("Overlap, %(unit)s", unit=unit("mm²")), table, "overlap", "mm²", digits=3, scale=1e3
            ),
            self._cells(
                self.t("Least clearance, %(unit)s", unit=unit("mm")), table, "clearance", "mm",
                places=5, scale=1e-3,
            ),
        ]  # fmt: skip
        first = self._words(N_("Wheels"), table, "wheels")
        return numeric(self.t("Overlap and clearance of the teeth over a full pitch"), first, columns)

    def speeds(self) -> Table:
        """Speeds of all the members with one of them stopped, rad/s."""
        table = self.of.table("speeds")
        names = [SUN, *(s.wheel for s in self.found.upper), RING, CARRIER]
        columns = [self.page.column(table, f"omega_{name}") for name in names]
        first = self._words(N_("Stopped"), table, "stopped")
        return numeric(self.t("Angular velocities of the members"), first, columns)
