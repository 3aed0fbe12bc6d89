"""View of the machine with its governor: steady states, small motions, stability, the response."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.governor import equations
from tmm_report.chapters.machine.governor.draw import blocks, charts
from tmm_report.chapters.machine.governor.equations import Rate, Relation
from tmm_report.chapters.machine.governor.quantities import of_loop
from tmm_report.chapters.machine.governor.solve.in_loop import LoopFound
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import Parts
from tmm_report.mechanics.machine.governor.stability import kind
from tmm_report.problems import N_
from tmm_report.quantity.model import Quantity
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import Line, chart, named
from tmm_report.report.page import ROUNDING, Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric, worded
from tmm_report.report.part import Failed

GIVEN = (
    "J", "i", "omega_mean", "M_mean", "k_d", "k_c", "load_before", "load_after", "s_min", "F_throttle", "k", "T_s",
    "zone", "beta", "T_i",
)  # fmt: skip
STEADY = {"before": N_("before the step"), "after": N_("after the step")}
KINDS = {
    "unstable": N_("The point of the machine lies below the hyperbola: the loop is unstable."),
    "monotonic": N_(
        "The point of the machine lies where all roots are real: the process has no oscillations."
    ),
    "aperiodic": N_(
        "The point of the machine lies where the real root dies away last: the oscillation is soon lost in a slow "
        "return."
    ),
    "oscillating": N_(
        "The point of the machine lies where the oscillation dies away last: the process oscillates."
    ),
}


def axis(page: Page, of: Quantity) -> Parts:
    """Letter and unit of what an axis shows."""
    return named(of.sign, of.printed, page.tr)


class LoopView(ChapterView):
    def __init__(self, found: LoopFound, page: Page):
        super().__init__(page, found.s, of_loop(found))
        self.found = found

    # ------------------------------------------------------------ words

    def given_values(self) -> Markup:
        return self.listed(self._given())

    def _given(self) -> list[str]:
        return [key for key in GIVEN if self.s.get(key)]

    def explained_given(self) -> list[dict[str, Any]]:
        return self.explained(*self._given())

    def explained(self, *keys: str) -> list[dict[str, Any]]:
        """A symbol is explained once, whichever number it stands for."""
        return [{**item, "id": item["symbol"]} for item in super().explained(*keys)]

    def states(self) -> list[dict[str, Any]]:
        """The states of the small motions."""
        return self._heads("matrix", self.found.states)

    def motions(self) -> list[dict[str, Any]]:
        """What stands in the equations of motion."""
        of = [*self._heads("steady", ("omega", "z", "s", "M_d", "M_c"))]
        return of + (self._heads("response", ("x",)) if self.found.response.x is not None else [])

    def _heads(self, name: str, keys: Iterable[str]) -> list[dict[str, Any]]:
        columns = [self.of(name, key) for key in keys]
        return [self.page.explained("", one, one.unit) | {"id": one.symbol()} for one in columns]

    # ------------------------------------------------------------ equations

    def motion(self) -> list[Relation]:
        return equations.motion(self.found)

    def small(self) -> list[Relation]:
        return equations.small(self.found)

    def characteristic(self) -> Relation:
        return equations.characteristic(self.found)

    def normal(self) -> Relation:
        return equations.normal(self.found)

    def kind(self) -> Markup:
        x, y = self.found.vyshnegradsky or (0.0, 0.0)
        return self.t(KINDS[kind(x, y)])

    def verdict(self) -> Markup:
        """The signs of the determinants agree with those of the eigenvalues."""
        if self.found.stable:
            return self.t(
                N_(
                    "All of them are positive and all eigenvalues lie in the left half-plane: the loop is stable."
                )
            )
        return self.t(
            N_(
                "Not all of them are positive, and an eigenvalue lies in the right half-plane: the loop is unstable."
            )
        )

    # ------------------------------------------------------------ tables

    def steady(self, caption: Any) -> Table:
        table, page = self.table("steady"), self.page
        names = [
            page.word(self.t(STEADY[str(one)]), table, "state", row)
            for row, one in enumerate(table["state"].values)
        ]
        columns = [
            *self.columns("steady", ("M_c", "omega")), self.column("steady", "omega", "rpm"),
            *self.columns("steady", ("z", "s")),
        ]  # fmt: skip
        return numeric(caption, Column(self.t(N_("State")), names), columns)

    def matrix(self, caption: Any) -> Table:
        """Each number with its own digits: those of a column are coefficients of different units."""
        table, page, names = self.table("matrix"), self.page, self.found.states

        def own(cell: Cell) -> Cell:
            return Cell(cell, cell.ref, cell.full)

        rows = [
            [
                page.word(page.math(Rate(table[name].symbol())), table, "state", row),
                *(own(page.cell(table, other, row, scale=0.0)) for other in names),
            ]
            for row, name in enumerate(names)
        ]
        heads = [self.t(N_("Rate")), *(page.sym(table[name].symbol()) for name in names)]
        return worded(caption, heads, rows, (2, *(3 for _ in names)))

    def roots(self, caption: Any) -> Table:
        table, page = self.table("eigenvalues"), self.page
        numbers = [page.cell(table, "number", row) for row in range(len(table))]
        columns = self.columns("eigenvalues", ("real", "imaginary"))
        return numeric(caption, Column(self.t(N_("No.")), numbers), columns)

    def hurwitz(self, caption: Any) -> Table:
        """Each number with its own digits: they differ by many powers of ten."""
        table, page = self.table("hurwitz"), self.page
        rows = [
            [
                page.cell(table, "k", row),
                page.cell(table, "a", row, scale=0.0),
                page.cell(table, "Delta", row, scale=0.0) if row else "—",
            ]
            for row in range(len(table))
        ]
        heads = [self.t(N_("No.")), page.sym("a"), page.sym("Delta")]
        return worded(caption, heads, rows, (1, 3, 3))

    # ------------------------------------------------------------ pictures

    @cached_property
    def blocks(self) -> Drawing:
        return blocks.blocks(
            self.found, lambda text: str(self.t(text)), str(self.t(N_("Block scheme of the loop")))
        )

    @cached_property
    def chart(self) -> Drawing:
        words = {
            "boundary": N_("boundary of stability"), "double": N_("two roots are equal"),
            "equal": N_("all roots die away alike"), "monotonic": N_("no oscillations"),
            "aperiodic": N_("slow return"), "oscillating": N_("oscillations"), "unstable": N_("unstable"),
            "stable": N_("stable"), "machine": N_("the machine"),
        }  # fmt: skip
        said = {key: str(self.t(text)) for key, text in words.items()}
        if self.found.servo is None:
            x, y = (axis(self.page, self.s.quantity(key)) for key in "XY")
            return charts.vyshnegradsky(self.found, (x, y), self._num, said)
        time, back = (axis(self.page, self.of("boundary", key).quantity) for key in ("T_i", "beta"))
        return charts.isodrome(self.found, (time, back), self._num, said)

    def _num(self, value: float) -> str:
        return self.page.num(value, 4)

    @cached_property
    def response(self) -> Graph:
        exact, small = str(self.t(N_("large motions"))), str(self.t(N_("small motions")))
        deviation, z, supply = (self.of("response", key) for key in ("deviation", "z", "s"))
        peak = (self.s.number("peak_time"), deviation.number(self.found.worst))
        lines = [
            Line(deviation, exact, 0, [peak]),
            Line(self.of("response", "deviation_linear"), small, 0),
            Line(z, "", 1),
            Line(supply, "", 2),
        ]
        panels = [one.quantity for one in (deviation, z, supply)]
        return chart(lines, self.of("response", "t"), panels, self.page.tr)

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        text = N_(
            "After the step of the load the speed of the machine deviates by %(peak)s %% at most and by %(static)s %% "
            "in the end."
        )
        stable = N_("The machine with its governor is stable.")
        unstable = N_("The machine with its governor is unstable.")
        lines = [self.t(stable) if self.found.stable else Failed(self.t(unstable))]
        if self.found.stable:
            key = "final" if self.found.short else "static"
            peak = self.number("peak", size=True)
            if abs(self.s.number(key)) < ROUNDING:
                text = N_(
                    "After the step of the load the speed of the machine deviates by %(peak)s %% at most and returns "
                    "to what it was."
                )
                lines.append(self.t(text, peak=peak))
            else:
                lines.append(self.t(text, peak=peak, static=self.number(key, "%", size=True)))
        if self.found.servo is None and self.found.too_heavy:
            text = N_("The sleeve alone cannot move the throttle: an indirect governor is needed.")
            lines.append(Failed(self.t(text)))
        return lines
