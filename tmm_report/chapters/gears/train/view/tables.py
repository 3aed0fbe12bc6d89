"""Tables of a compound gear train: members, search, conditions, speeds, powers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.gears.power_flow import power_flow
from tmm_report.chapters.gears.rejected import rejected
from tmm_report.chapters.gears.train.given import LOADS
from tmm_report.chapters.gears.train.quantities import tables
from tmm_report.chapters.gears.train.solve.train import Found
from tmm_report.chapters.gears.train.steps import whole
from tmm_report.mechanics.gears.compound.search import Reason
from tmm_report.problems import N_
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper import layout
from tmm_report.report.paper.layout import Cell, worded

BEST, SHOWN = 3, 10  # solutions of the search: in the text and in all
REASONS = {
    Reason.ACCEPTED: N_("all conditions are met"),
    Reason.COAXIALITY: N_("coaxiality, or teeth out of range"),
    Reason.RATIO: N_("the ratio is missed"),
    Reason.INTERFERENCE: N_("interference in an internal mesh"),
    Reason.ASSEMBLY: N_("the planet gears cannot be put in"),
    Reason.NEIGHBOURHOOD: N_("neighbouring planet gears touch"),
}


def _dashed(pair: str) -> str:
    """Two members: 1\N{EN DASH}2."""
    return pair.replace("-", "\N{EN DASH}")


class TrainTables(ChapterView):
    """`made`: the numbers with their formulas."""

    own = True

    def __init__(self, found: Found, page: Page):
        self.found, self.made = found, whole(found)
        super().__init__(page, self.made.s, tables(found))

    def names(self, names: Sequence[str]) -> Markup:
        return self.page.listed(names)

    def given_table(self) -> layout.Table:
        """Wheels and carriers: teeth, axis, what they turn with."""
        table = self.table("speeds")
        heads = [self.t("Member"), self.page.head(table["z"].symbol()), self.t("Axis"), self.t("Turns with")]
        rows = []
        for row, m in enumerate(self.found.train.members):
            teeth: Any = Cell(str(m.teeth), table.ref("z", row)) if m.teeth else "—"
            axis = self.t("on carrier %(name)s", name=m.carried_by) if m.carried_by else self.t("fixed")
            alike = self.page.word(self.made.joined(m.name) or "—", table, "with", row)
            rows.append([self.page.word(m.name, table, "member", row), teeth, axis, alike])
        return worded(self.t("Members of the gear train"), heads, rows, [14, 14, 30, 30])

    @property
    def loaded(self) -> bool:
        """Whether a load is stated."""
        return any(getattr(self.found.given, key) is not None for key in LOADS)

    def reasons(self) -> Markup:
        """How many sets of teeth fail by each condition."""
        return rejected(self.page, self.table("rejected"), "count", REASONS)

    @property
    def best(self) -> range:
        """Rows of the best few sets of teeth."""
        return range(min(BEST, len(self.table("solutions"))))

    @property
    def others(self) -> range:
        """Of those that come next."""
        return range(len(self.best), min(SHOWN, len(self.table("solutions"))))

    def solutions(self, shown: range) -> layout.Table:
        table, page = self.table("solutions"), self.page
        whole_ = [c.key for c in table.columns if c.key == "place" or c.key.startswith("z_") or c.key == "k"]
        rows = [
            [
                *(Cell(str(int(table[key].values[row])), table.ref(key, row)) for key in whole_),
                page.cell(table, "u", row),
                page.cell(table, "delta_u", row, places=2),
                *([page.cell(table, "eta", row, digits=3)] if "eta" in table else []),
                page.cell(table, "D", row, digits=4),
            ]
            for row in shown
        ]
        heads = [self.t("No."), *(page.head(table[key].symbol()) for key in whole_[1:])]
        heads += [
            page.head(table["u"].symbol()),
            page.head(table["delta_u"].symbol(), "%"),
            *([page.head(table["eta"].symbol())] if "eta" in table else []),
            page.head(table["D"].symbol()),
        ]
        text = N_(
            "The best sets of teeth; D is the diameter that the train fills, in modules of the first wheel"
        )
        if shown.start:
            text = N_(
                "Further sets of teeth; D is the diameter that the train fills, in modules of the first wheel"
            )
        return worded(self.t(text), heads, rows, [1] * len(heads))

    def distances(self) -> layout.Table:
        table, page = self.table("distances"), self.page
        rows = [
            [
                page.word(_dashed(table["mesh"].values[row]), table, "mesh", row),
                page.cell(table, "a", row),
                page.word(_dashed(table["other"].values[row]), table, "other", row),
                page.cell(table, "a_other", row),
                page.cell(table, "gap", row, digits=4),
            ]
            for row in range(len(table))
        ]
        millimetres = page.head(Symbol("a"), "mm")
        heads = [
            self.t("Mesh"),
            millimetres,
            self.t("Mesh"),
            millimetres,
            self.t("Difference of the sums of teeth"),
        ]
        return worded(self.t("Coaxiality"), heads, rows, (2, 2, 2, 2, 3))

    def assembly(self) -> layout.Table:
        table, page = self.table("assembly"), self.page
        rows = [
            [
                page.word(_dashed(table["row"].values[row]), table, "row", row),
                Cell(str(int(table["k"].values[row])), table.ref("k", row)),
                page.cell(table, "C", row),
                self.t("whole") if one.met else self.t("not whole"),
            ]
            for row, one in enumerate(self.found.conditions.assembly)
        ]
        heads = [self.t("Row"), page.head(table["k"].symbol()), page.head(Symbol("C")), self.t("Condition")]
        return worded(self.t("Condition of assembly"), heads, rows, (2, 1, 2, 2))

    def neighbours(self) -> layout.Table:
        table, page = self.table("neighbours"), self.page
        rows = [
            [
                page.word(table["satellite"].values[row], table, "satellite", row),
                Cell(str(int(table["k"].values[row])), table.ref("k", row)),
                page.cell(table, "gap", row),
                self.t("free") if one.met else self.t("they touch"),
            ]
            for row, one in enumerate(self.found.conditions.neighbours)
        ]
        heads = [
            self.t("Planet gears"),
            page.head(table["k"].symbol()),
            page.head(Symbol("Delta"), "mm"),
            self.t("Neighbours"),
        ]
        return worded(self.t("Condition of neighbourhood"), heads, rows, (2, 1, 2, 2))

    def speeds_table(self) -> layout.Table:
        table, page = self.table("speeds"), self.page
        carried = any(m.carried_by for m in self.found.train.members)
        keys = ["omega", "n", *(["omega_rel", "n_rel"] if carried else [])]
        rows = [
            [
                page.word(m.name, table, "member", row),
                *(page.cell(table, key, row) if key in self.made.members[m.name] else "—" for key in keys),
            ]
            for row, m in enumerate(self.found.train.members)
        ]
        plain = {
            "omega": Symbol("omega"),
            "n": Symbol("n"),
            "omega_rel": Symbol("omega", "", "(H)"),
            "n_rel": Symbol("n", "", "(H)"),
        }
        heads = [self.t("Member"), *(page.head(plain[key], table[key].unit) for key in keys)]
        return worded(self.t("Speeds of all the members of the train"), heads, rows, [2, *[2] * len(keys)])

    def cases_table(self) -> layout.Table:
        table, page = self.table("cases"), self.page
        rows = [
            [
                Cell(str(int(table["case"].values[row])), table.ref("case", row)),
                page.word(name, table, "member", row),
                page.cell(table, "omega", row),
                page.cell(table, "n", row),
            ]
            for row, name in enumerate(table["member"].values)
        ]
        heads = [
            self.t("Motion"),
            self.t("Member"),
            page.head(Symbol("omega"), "rad/s"),
            page.head(Symbol("n"), "rpm"),
        ]
        return worded(self.t("Speeds in the other motions"), heads, rows, (1, 1, 2, 2))

    def meshes_table(self) -> layout.Table:
        caption = self.t("Flow of the power through the meshes of the train")
        return power_flow(self.page, self.table("meshes"), caption)

    @property
    def forces(self) -> bool:
        """Whether the module of some mesh is stated, and the load."""
        return self.loaded and "F_t" in self.table("meshes")

    def forces_table(self) -> layout.Table:
        table, page = self.table("meshes"), self.page
        rows = [
            [page.word(f"{mesh.i}–{mesh.j}", table, "mesh", row), page.cell(table, "F_t", row)]
            for row, mesh in enumerate(self.found.train.meshes)
        ]
        heads = [self.t("Mesh"), page.head(Symbol("F", "t"), "N")]
        return worded(self.t("Circumferential forces in the meshes of the train"), heads, rows, [1, 1])

    def loads_table(self) -> layout.Table:
        keys = [
            key for key in ("T_0", "N_0", "T_free", "T", "N", "F_free", "F") if key in self.table("loads")
        ]
        if not self.found.lossy:
            keys = [key for key in keys if key not in ("T", "N")]
        names = {
            "T_0": N_("Torque without losses, N·m"), "N_0": N_("Power without losses, W"),
            "T_free": N_("Torque without friction in the differential, N·m"),
            "T": N_("Torque, N·m"), "N": N_("Power, W"),
            "F_free": N_("Force without friction in the differential, N"), "F": N_("Tractive force, N"),
        }  # fmt: skip
        return self._of_members(
            "loads", keys, names, self.t("External torques and powers of the train"), self.made.loads
        )

    def flow_table(self) -> layout.Table:
        names = {"T": N_("Torque of the meshes, N·m"), "N": N_("Power from the meshes, W")}
        return self._of_members(
            "flow", ["T", "N"], names, self.t("What the meshes give to every member"), self.made.flows
        )

    def _of_members(
        self, name: str, keys: Sequence[str], names: dict[str, str], caption: Any, rows: dict[str, Any]
    ) -> layout.Table:
        table, page = self.table(name), self.page
        cells = [
            [
                page.word(member, table, "member", k),
                *(page.cell(table, key, k, digits=5) if key in row else "—" for key in keys),
            ]
            for k, (member, row) in enumerate(rows.items())
        ]
        heads = [self.t("Member"), *(self.t(names[key]) for key in keys)]
        return worded(caption, heads, cells, [2, *[3] * len(keys)])

    def branches_table(self) -> layout.Table:
        table, page = self.table("branches"), self.page
        rows = [
            [
                page.word(table["shaft"].values[k], table, "shaft", k),
                page.word(name, table, "member", k),
                page.cell(table, "share_0", k),
                *([page.cell(table, "share", k)] if self.found.lossy else []),
            ]
            for k, name in enumerate(self.made.branches)
        ]
        heads = [self.t("Shaft"), self.t("Through member"), self.t("Share without losses")]
        heads += [self.t("Share with losses")] if self.found.lossy else []
        return worded(
            self.t("Shares of the power through the branches"), heads, rows, [2, 3, 3, 3][: len(heads)]
        )
