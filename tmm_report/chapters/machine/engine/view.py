"""View of the balance of an engine of several cylinders."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.engine import sheet
from tmm_report.chapters.machine.engine.draw import along_scale, scheme, star_picture
from tmm_report.chapters.machine.engine.drawn import Star
from tmm_report.chapters.machine.engine.formulas import EngineFormulas
from tmm_report.chapters.machine.engine.solve import Found
from tmm_report.chapters.machine.engine.words import BALANCED, REMEDIES
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric, worded
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


class EngineView(EngineFormulas):
    def __init__(self, found: Found, page: Page):
        super().__init__(found)
        self.page, self.t = page, page.t

    @property
    def name(self) -> str:
        return self.found.given.name

    def number(self, key: str, unit: str = "", **form: Any) -> Markup:
        return self.page.shown(self.book[f"engine_{key}"], unit=unit, **form)

    def stated(self, *keys: str) -> Markup:
        """symbol = value unit."""
        return self.page.values(self.var(key) for key in keys if f"engine_{key}" in self.book.values)

    def given_values(self) -> Markup:
        keys = ["r", "l", "omega", "m_piston" if self.found.given.rod else "m"]
        keys += ["m_rod", "a"] if self.found.given.rod else []
        keys += ["m_crank"] if self.found.given.rotating else []
        return self.stated(*keys)

    def where(self, formula: Formula) -> list[dict[str, Any]]:
        return self.page.where(formula)

    # ------------------------------------------------------------ tables

    def _column(self, name: str, key: str) -> Column:
        return self.page.column(self.table(name), key)

    def cylinders(self) -> Table:
        table = self.table("cylinders")
        names = [
            self.page.word(text, table, "cylinder", row) for row, text in enumerate(table["cylinder"].values)
        ]
        keys = ["beta", "psi", "z", "direct_1", "direct_2"]
        keys += [] if self.found.in_line else ["reverse_1", "reverse_2"]
        columns = [self.page.column(table, key, digits=4) for key in keys]
        return numeric(self.t("Cylinders and their cranks"), Column(self.t("Cylinder"), names), columns)

    def coefficients(self) -> Table:
        columns = [self._column("orders", key) for key in ("c", "c_exact")]
        return numeric(self.t("Coefficients of the orders"), self._orders(), columns)

    def _orders(self) -> Column:
        table = self.table("orders")
        cells = [self.page.cell(table, "order", row) for row in range(len(table))]
        return Column(self.page.head(table["order"].symbol()), cells)

    def orders(self) -> Table:
        keys = [f"{letter}_{key}" for letter in self.letters for key in ("max", "min", "direction")]
        columns = [self._column("orders", key) for key in keys]
        return numeric(self.t("Inertia forces and moments by orders"), self._orders(), columns)

    def primary(self) -> Table:
        table, rows = self.table("primary"), []
        for row, (stage, *_) in enumerate(self.found.stages):
            keys = [f"{letter}_{key}" for letter in self.letters for key in ("max", "min")]
            words = self.page.word(self.t(STAGES[stage]), table, "stage", row)
            rows.append([words, *(self.page.cell(table, key, row) for key in keys)])
        heads = [
            self.page.head(table[f"{letter}_{key}"].symbol(), table[f"{letter}_{key}"].unit)
            for letter in self.letters
            for key in ("max", "min")
        ]
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
        table = self.table("polygons")
        keys = ["d_direct", *([] if self.found.in_line else ["d_reverse"])]
        rows = [
            [
                self.page.head(self._graph_sign(star), table["unit"].values[row]),
                *(self.page.cell(table, key, row) for key in keys),
                *(sheet.by_key(self.page, table, row, by) for by in ("graph", "analytic")),
                sheet.delta(self.page, table, row),
            ]
            for row, star in enumerate(self.stars)
        ]
        lengths = [self.page.head(table[key].symbol(), "mm") for key in keys]
        heads = [
            self.t("Quantity"),
            *lengths,
            self.t("By the polygon"),
            self.t("By calculation"),
            self.t("Difference, %%"),
        ]
        return worded(
            self.t("Greatest forces and moments by the polygons"), heads, rows, [3] + [2] * (len(heads) - 1)
        )

    def _graph_sign(self, star: Star) -> Any:
        return sheet.graph(star).sign

    def greatest_over_turn(self) -> Table:
        return sheet.greatest_table(self)

    def weights(self) -> Table | None:
        """None where nothing is left."""
        return sheet.remedies_table(self) if any(one.kind != "none" for one in self.found.remedies) else None

    def firing(self) -> Table:
        table = self.table("firing")
        names = [
            self.page.word(text, table, "cylinder", row) for row, text in enumerate(table["cylinder"].values)
        ]
        columns = [self._column("firing", key) for key in ("angle", "interval")]
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
        table = self.table("remedies")
        return [
            (self.t(REMEDIES[one.of, one.order, one.kind]), list(self.remedy(row)))
            for row, one in enumerate(self.found.remedies)
            if len(table) and (one.of == "force" or self.found.spread)
        ]

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
        scale = self.stated("mu_F" if star.of == "force" else "mu_M")
        return self.t(text, k=star.order, scale=scale)

    @cached_property
    def hodographs(self) -> Sequence[tuple[str, Drawing]]:
        return list(sheet.hodographs(self))

    @cached_property
    def diagrams(self) -> Sequence[tuple[str, Graph]]:
        return list(sheet.diagrams(self))

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        table = self.table("greatest")
        text = N_(
            "The greatest inertia force of the engine of %(count)s cylinders is %(force)s N over a turn, the greatest "
            "moment %(couple)s N·m."
        )
        force, couple = (sheet.entry(self.page, table, "after", row) for row in (0, 1))
        lines = [self.t(text, count=self.number("count"), force=force, couple=couple)]
        return lines + self.states()
