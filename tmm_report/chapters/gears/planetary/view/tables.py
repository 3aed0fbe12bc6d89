"""Tables of a planetary stage: the search for teeth, conditions, dimensions, motions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any, assert_never

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.gears.planetary.quantities.stage import tables
from tmm_report.chapters.gears.planetary.solve.conditions import Condition
from tmm_report.chapters.gears.planetary.solve.limits import REASONS
from tmm_report.chapters.gears.planetary.solve.stage import Found, Motion
from tmm_report.chapters.gears.planetary.steps import stage
from tmm_report.chapters.gears.planetary.values import Values
from tmm_report.chapters.gears.planetary.view.schemes import SchemesView
from tmm_report.chapters.gears.rejected import rejected
from tmm_report.i18n import NP_
from tmm_report.mechanics.gears.pair_sizes import ring_rule
from tmm_report.mechanics.gears.planetary.stage import MEMBERS, ROWS
from tmm_report.problems import N_
from tmm_report.quantity import model as quantity
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.terms.wheel_words import DIAMETERS
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, padded, worded

BEST, SHOWN = 3, 10  # solutions in the text and in all, besides the chosen one
PLACES = {
    "ratio": 2,
    "undercut": 2,
    "tips": 3,
    "radial": 3,
    "contact": 3,
    "gap": 2,
}  # decimals of the conditions

INPUT = Symbol("omega", NP_("index", "in"))


class PlanetaryTables(ChapterView):
    """`label` begins the labels of the stage's sections and its names in the results."""

    s: Values

    def __init__(self, found: Found, page: Page, label: str):
        self.found, self.given, self.task, self.label = found, found.given, found.given.task, label
        self.stage = stage(found, label)
        super().__init__(page, self.stage.s, tables(found, label))
        self.scheme, self.wheels = found.scheme, self.given.wheels
        self.one, self.three, self.carrier = (self.given.member(member) for member in MEMBERS)
        self.sizes, self.meshes = self.table("wheels"), self.stage.meshes

    # ------------------------------------------------------------ the search

    def ranges(self) -> dict[str, Markup]:
        """The ranges of teeth that were examined."""
        keys = {
            "low": "external_least",
            "high": "external_most",
            "least": "rings_least",
            "most": "rings_most",
        }
        return {name: self.number(key) for name, key in keys.items()}

    def reasons(self) -> Markup:
        """How many candidates were rejected, by the first condition that fails."""
        return rejected(self.page, self.table("rejected"), "combinations", REASONS)

    def _count(self, table: quantity.Table, key: str, row: int) -> Cell:
        """A whole number of a table, with all its digits."""
        return Cell(str(int(table[key].values[row])), table.ref(key, row))

    @property
    def best(self) -> list[int]:
        """Places in the ranking of the best few, and of the chosen one."""
        best = list(range(min(BEST, len(self.found.ranking))))
        chosen = self.found.chosen
        return best if chosen is None or chosen in best else [*best, chosen]

    @property
    def others(self) -> list[int]:
        """Places of those behind them that the table of further solutions shows."""
        shown = range(min(SHOWN, len(self.found.ranking)))
        return [place for place in shown if place not in self.best]

    def solutions(self, caption: Any, places: Sequence[int]) -> Table:
        """The best of the solutions, the chosen one marked."""
        table, page = self.table("solutions"), self.page
        teeth = [key for key in ("z1", "z2", "z2'", "z3") if key in table]
        remarks = [page.listed(self._remarks(place)) for place in places]
        rows = [
            [
                *(self._count(table, key, place) for key in ("place", *teeth, "k")),
                page.cell(table, "u", place),
                page.cell(table, "delta_u", place, places=2),
                page.cell(table, "D", place, "mm"),
                *([remark] if any(remarks) else []),
            ]
            for place, remark in zip(places, remarks, strict=True)
        ]
        heads = [
            self.t("No."),
            *(page.head(table[key].symbol()) for key in (*teeth, "k", "u")),
            page.listed([page.sym(table["delta_u"].symbol()), "%"]),
            page.head(table["D"].symbol(), "mm"),
            *([self.t("Remark")] if any(remarks) else []),
        ]
        return worded(caption, heads, rows, (1, *[1] * len(teeth), 0.8, 1.4, 1.2, 1.4, 3.4)[: len(heads)])

    def _remarks(self, place: int) -> Iterator[Markup]:
        of = self.found.solutions
        if place == self.found.chosen:
            yield self.t("chosen")
        if of.shifted[place]:
            yield self.t("with shift")
        if of.of.multiple[place]:
            yield self.t("multiple of k")

    # ------------------------------------------------------------ conditions and sizes

    def conditions(self, caption: Any) -> Table:
        """Every condition of the chosen teeth: the value, the limit, what is in hand."""
        rows = [
            [self._condition_name(of), *self._condition(of, row)]
            for row, of in enumerate(self.found.conditions)
        ]
        heads = [self.t("Condition"), self.t("Value"), self.t("Limit"), self.t("Margin")]
        return worded(caption, heads, rows, (5, 3, 2.4, 2))

    def _condition_name(self, of: Condition) -> Markup:
        wheels = [self.wheels[wheel] for wheel in of.wheels]
        match of.key:
            case "ratio":
                return self.t("ratio")
            case "undercut":
                return self.t("no undercut of the teeth of wheel %(wheel)s", wheel=wheels[0])
            case "tips":
                return self.t("no overlap of the tips in the mesh with ring %(wheel)s", wheel=wheels[0])
            case "radial":
                return self.t("a planet gear can be put into ring %(wheel)s radially", wheel=wheels[0])
            case "contact":
                return self.t("contact ratio of the pair %(pair)s", pair="-".join(wheels))
            case "gap":
                return self.t("gap between neighbouring planet gears")
            case _:
                assert_never(of.key)

    @property
    def axial(self) -> list[str]:
        """Rings into which the satellites go axially only."""
        return [
            self.wheels[of.wheels[0]] for of in self.found.conditions if of.key == "radial" and of.margin < 0
        ]

    def _condition(self, of: Condition, row: int) -> list[Markup]:
        """Value, limit and what is in hand, each with its unit."""
        table, listed = self.table("conditions"), self.page.listed
        if of.key == "gap":
            found = self.page.shown(table, "value", row, "mm", places=2)
            gap = self.page.in_unit(found, "mm")
            return [gap, listed(["> ", self.page.shown(table, "limit", row, "mm")], ""), gap]
        value, limit, margin = (
            self.page.in_unit(self.page.shown(table, key, row, places=PLACES[of.key]), of.unit)
            for key in ("value", "limit", "margin")
        )
        symbol = self.page.sym(table["value"].symbol(row))
        if of.key == "ratio":  # the limit holds its deviation either way
            symbol = listed(["|", symbol, "|"], "")
        sign = "≥ " if of.least else "≤ "
        return [listed([symbol, " = ", value], ""), listed([sign, limit], ""), margin]

    def dimensions(self, caption: Any) -> Table:
        """Diameters of all wheels and crowns, mm, and their shift coefficients."""
        page, sized, wheels = self.page, self.sizes, self.scheme.wheels
        rows = [
            [
                self.t(text),
                page.head(sized[key].symbol(), "mm"),
                *padded([self._diameter(key, wheel) for wheel in wheels]),
            ]
            for key, text in DIAMETERS.items()
            if key != "d_w" or self.found.shifted or self.page.note.every  # else the text says that it is d
        ]
        if self.found.shifted:
            rows[:0] = [self._shifts(key) for key in ("x_n", "x") if key == "x" or self.given.helix]
        heads = [
            self.t("Dimension"),
            self.t("Symbol"),
            *(self.t("wheel %(name)s", name=self.wheels[wheel]) for wheel in wheels),
        ]
        return worded(caption, heads, rows, (4, 2, *[2] * len(wheels)))

    def _shifts(self, key: str) -> list[Any]:
        """A row of the table: of helical teeth the coefficients of both sections."""
        of = self.sizes[key]
        cells = [self.page.cell(self.sizes, key, row, places=4) for row in range(len(self.scheme.wheels))]
        return [self.page.message(of.meaning), self.page.head(of.symbol()), *cells]

    def _diameter(self, key: str, wheel: int) -> Any:
        """mm; the satellite of a single row with shift rolls on another circle in each mesh."""
        if key == "d_w" and wheel == 1 and self.scheme.single and self.found.shifted:
            return self.page.listed((self.page.shown(self.table("rows"), "d_w", row) for row in (0, 1)), "; ")
        return self.page.cell(self.sizes, key, self.stage.row_of(wheel), "mm")

    def ring_rule(self, row: int) -> Markup | None:
        """What the rule of the course says of the ring of a row; None where it says nothing."""
        if not np.isfinite(self.found.rows.least[row]) or ring_rule(self.task.rack) is None:
            return None
        wheel = ROWS[row][0]
        values = {
            "rule": self.number("ring_rule"),
            "wheel": self.wheels[wheel],
            "ring": self.page.shown(self.sizes, "z", self.stage.row_of(wheel)),
        }
        if self.found.teeth[wheel] >= self.s.number("ring_rule"):
            return self.t(
                "The rule of the course, by which a ring without shift has at least %(rule)s teeth, is met by ring "
                "%(wheel)s with its %(ring)s.",
                **values,
            )
        return self.t(
            "The rule of the course, by which a ring without shift has at least %(rule)s teeth, is not met by ring "
            "%(wheel)s with its %(ring)s; the exact condition decides.",
            **values,
        )

    @cached_property
    def schemes(self) -> SchemesView | None:
        """The schemes that were judged; None where the scheme is stated."""
        choice = self.found.choice
        return SchemesView(choice, self.page, self.table("schemes")) if choice else None

    # ------------------------------------------------------------ motion

    def motions(self, caption: Any) -> Table:
        """Speeds of all members to the input's, ratio and efficiency, whichever is held; the third is the output."""
        table = self.table("motions")
        keys = (f"omega_{self.one}", "omega_satellite", f"omega_{self.three}", f"omega_{self.carrier}")
        rows = [self._motion(motion, row, keys) for row, motion in enumerate(self.found.motions)]
        heads = [
            self.t("Held"),
            self.t("Input"),
            *(self._relative(table[key]) for key in keys),
            self.page.head(table["u"].symbol()),
            self.page.head(table["eta"].symbol()),
            self.t("Power flow"),
        ]
        return worded(caption, heads, rows, (0.8, 0.8, 1.4, 1.4, 1.4, 1.4, 1.4, 1.2, 1.2))

    def _relative(self, speed: quantity.Column) -> Markup:
        return self.page.listed([self.page.sym(speed.symbol()), self.page.sym(INPUT)], "/")

    def _motion(self, motion: Motion, row: int, keys: tuple[str, ...]) -> list[Any]:
        table, page = self.table("motions"), self.page
        locks = page.word(page.tr.gettext(N_("locks")), table, "eta", row)
        return [
            *(page.word(table[key].values[row], table, key, row) for key in ("held", "input")),
            *(page.cell(table, key, row, digits=4) for key in (*keys, "u")),
            locks if motion.locks else page.cell(table, "eta", row, places=4),
            page.word("→".join(self._sense(motion)), table, "power", row),
        ]

    def _sense(self, motion: Motion) -> tuple[str, str]:
        """Which central wheel drives which in the stopped-carrier frame."""
        return (self.one, self.three) if motion.exponent > 0 else (self.three, self.one)

    @property
    def sense(self) -> tuple[str, str]:
        """The same as the stage runs in the drive."""
        return self._sense(self.found.motion)
