"""View of the balance of an engine of several cylinders."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.engine import equations, over_turn, quantities
from tmm_report.chapters.machine.engine.draw import along_scale, scheme, star_picture
from tmm_report.chapters.machine.engine.drawn import Star
from tmm_report.chapters.machine.engine.solve import Found
from tmm_report.chapters.machine.engine.values import Cylinders, Turn, graph
from tmm_report.chapters.machine.engine.words import BALANCED, REMEDIES
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric, worded
from tmm_report.report.part import Part

STAGES = {
    "reciprocating": N_("reciprocating masses"),
    "rotating": N_("with the rotating masses"),
    "balanced": N_("with the counterweights"),
}


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/engine", EngineView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The engine at a glance, for a list of many."""
    return scheme(found)


class EngineView(ChapterView):
    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, quantities.tables(found))
        self.found = found

    @property
    def name(self) -> str:
        return self.found.given.name or ""

    def given_values(self) -> Markup:
        rod = self.found.given.rod is not None
        return self.listed(["r", "l", "omega", "m_piston" if rod else "m", "m_rod", "a", "m_crank"])

    # ------------------------------------------------------------ formulas

    def of_one(self) -> Definition:
        return equations.of_one(self.found)

    def angle_of_one(self) -> Definition:
        return equations.turned(self.found)

    def letters_explained(self) -> list[dict[str, Any]]:
        """The angles of these."""
        columns = [of.column(()) for of in (Cylinders.theta, Turn.phi)]
        return [self.page.explained(f"engine:{one.key}", one, one.unit) for one in columns]

    def greatest(self, row: int) -> Formula:
        return equations.by_polygon(self.found, self.table("polygons"), row, self.found.stars[row])

    def counterweight(self) -> list[Formula]:
        return self.formulas("share", "m_cw", "r_cw", "hammer")

    # ------------------------------------------------------------ tables

    def cylinders(self) -> Table:
        table = self.table("cylinders")
        names = [
            self.page.word(text, table, "cylinder", row) for row, text in enumerate(table["cylinder"].values)
        ]
        keys = ["beta", "psi", "z", "direct_1", "direct_2"]
        keys += [] if self.found.in_line else ["reverse_1", "reverse_2"]
        columns = [self.column("cylinders", key, digits=4) for key in keys]
        return numeric(self.t("Cylinders and their cranks"), Column(self.t("Cylinder"), names), columns)

    def coefficients(self) -> Table:
        columns = self.columns("orders", ("c", "c_exact"))
        return numeric(self.t("Coefficients of the orders"), self._orders(), columns)

    def _orders(self) -> Column:
        table = self.table("orders")
        cells = [self.page.cell(table, "order", row) for row in range(len(table))]
        return Column(self.page.head(table["order"].symbol()), cells)

    def orders(self) -> Table:
        keys = [f"{letter}_{key}" for letter in self.letters for key in ("max", "min", "direction")]
        columns = self.columns("orders", keys)
        return numeric(self.t("Inertia forces and moments by orders"), self._orders(), columns)

    def primary(self) -> Table:
        table = self.table("primary")
        keys = [f"{letter}_{key}" for letter in self.letters for key in ("max", "min")]
        rows = [
            [self.page.word(self.t(STAGES[stage]), table, "stage", row)]
            + [self.page.cell(table, key, row) for key in keys]
            for row, (stage, *_) in enumerate(self.found.stages)
        ]
        heads = [self.page.head(table[key].symbol(), table[key].unit) for key in keys]
        caption = self.t("Force and moment of order 1 with the masses that turn")
        return worded(caption, [self.t("Masses"), *heads], rows, [5] + [2] * len(heads))

    @property
    def letters(self) -> str:
        """Of what there may be: cylinders in one plane have no moments."""
        return "FM" if self.found.spread else "F"

    @property
    def pulls(self) -> bool:
        """Whether a force of order 1 or 2 is left."""
        return any(one.kind != "none" for one in self.found.remedies if one.of == "force")

    @property
    def turned_masses(self) -> bool:
        return len(self.found.stages) > 1

    def polygons(self) -> Table:
        table, page = self.table("polygons"), self.page
        keys = ["d_direct", *([] if self.found.in_line else ["d_reverse"])]
        rows = [
            [
                page.head(graph(star.of, star.order).sign, graph(star.of, star.order).unit),
                *(page.cell(table, key, row) for key in keys),
                *(self._by(row, by) for by in ("graph", "analytic", "delta")),
            ]
            for row, star in enumerate(self.found.stars)
        ]
        heads = [
            self.t("Quantity"),
            *(page.head(table[key].symbol(), table[key].unit) for key in keys),
            self.t("By the polygon"),
            self.t("By calculation"),
            self.t("Difference, %%"),
        ]
        return worded(
            self.t("Greatest forces and moments by the polygons"), heads, rows, [3] + [2] * (len(heads) - 1)
        )

    def _by(self, row: int, by: str) -> Cell:
        """Of a row the number of a column that has no letter; of no difference from nothing none."""
        table = self.table("polygons")
        number = table[by].values[row]
        text = self.page.num(number, places=2 if by == "delta" else None) if number == number else "≈ 0"
        return Cell(text, table.by_key(table["key"].values[row], by))

    def greatest_over_turn(self) -> Table:
        return over_turn.greatest_table(self)

    def weights(self) -> Table | None:
        """None where nothing is left."""
        return (
            over_turn.remedies_table(self) if any(one.kind != "none" for one in self.found.remedies) else None
        )

    def firing(self) -> Table:
        table = self.table("firing")
        names = [
            self.page.word(text, table, "cylinder", row) for row, text in enumerate(table["cylinder"].values)
        ]
        columns = self.columns("firing", ("angle", "interval"))
        return numeric(self.t("Order of firing"), Column(self.t("Cylinder"), names), columns)

    @property
    def even(self) -> bool:
        """Whether the cylinders fire at equal intervals."""
        steps = [one.interval for one in self.found.firing]
        return max(steps) - min(steps) < 1e-6

    # ------------------------------------------------------------ words

    def states(self) -> list[Markup]:
        """Of each order, what is balanced of the reciprocating masses."""
        rows = []
        for order in (self.found.first, self.found.second):
            for of, turning in (("force", order.force), ("couple", order.couple)):
                scale = self.found.unit * (1.0 if of == "force" else self.found.spread)
                if of == "couple" and not self.found.spread:
                    continue
                if not turning.greatest > 1e-9 * scale:
                    rows.append(self.t(BALANCED[of, order.order]))
        return rows

    def remedies(self) -> list[tuple[Markup, list[Formula]]]:
        """What is left of orders 1 and 2 and what balances it, with the products of the weights."""
        return [
            (self.t(REMEDIES[one.of, one.order, one.kind]), list(self._remedy(row)))
            for row, one in enumerate(self.found.remedies)
            if one.of == "force" or self.found.spread
        ]

    def _remedy(self, row: int) -> Iterator[Formula]:
        source = self.table("primary" if self.found.remedies[row].order == 1 else "orders")
        return equations.remedy(self.found, self.table("remedies"), source, row)

    # ------------------------------------------------------------ pictures

    @cached_property
    def drawing(self) -> Drawing:
        return scheme(self.found, str(self.t("Scheme of the engine")))

    def along(self) -> Markup | None:
        """The scale of the side view."""
        return (
            self.page.value(scale_of("mu_l", along_scale(self.found), "m/mm")) if self.found.spread else None
        )

    def star(self, star: Star) -> Drawing:
        words = [str(self.t("direct cranks")), str(self.t("reverse cranks"))]
        if self.found.in_line:
            words = ["", ""]
        return star_picture(star, words, self.found.in_line, self.page.plain(self.star_caption(star)))

    def star_caption(self, star: Star) -> Markup:
        text = N_("Cranks of order %(k)s and the sum of the forces, %(scale)s")
        if star.of == "couple":
            text = N_("Cranks of order %(k)s and the sum of the moments, %(scale)s")
        scale = self.sized("mu_F" if star.of == "force" else "mu_M")
        return self.t(text, k=star.order, scale=scale)

    @cached_property
    def hodographs(self) -> Sequence[tuple[str, Drawing]]:
        return list(over_turn.hodographs(self))

    @cached_property
    def diagrams(self) -> Sequence[tuple[str, Graph]]:
        return list(over_turn.diagrams(self))

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        table = self.table("greatest")
        text = N_(
            "The greatest inertia force of the engine of %(count)s cylinders is %(force)s N over a turn, the greatest "
            "moment %(couple)s N·m."
        )
        force, couple = (self.page.shown(table, "after", row) for row in (0, 1))
        lines = [self.t(text, count=self.number("count"), force=force, couple=couple)]
        return lines + self.states()
