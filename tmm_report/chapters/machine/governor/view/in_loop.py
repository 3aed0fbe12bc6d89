"""View of the machine with its governor: steady states, small motions, stability, the response."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.governor.draw import blocks, charts
from tmm_report.chapters.machine.governor.formulas.in_loop import LoopFormulas, Rate
from tmm_report.chapters.machine.governor.quantities import in_loop as q
from tmm_report.chapters.machine.governor.solve.in_loop import LoopFound
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.machine.governor.stability import kind
from tmm_report.problems import N_
from tmm_report.quantity.model import Book, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import plot
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric, worded
from tmm_report.report.part import Failed

GIVEN = (
    "J",
    "i",
    "omega_mean",
    "M_mean",
    "k_d",
    "k_c",
    "load_before",
    "load_after",
    "s_min",
    "F_throttle",
    "k",
)
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


class LoopView:
    def __init__(self, found: LoopFound, book: Book, page: Page):
        self.found, self.book, self.page, self.t = found, book, page, page.t
        self.formulas = LoopFormulas(found, book)

    # ------------------------------------------------------------ words

    def has(self, key: str) -> bool:
        return f"governor_{key}" in self.book.values

    def number(self, key: str, unit: str = "", **form: Any) -> Markup:
        return self.page.shown(self.book[f"governor_{key}"], unit=unit, **form)

    def sized(self, key: str, unit: str = "") -> Markup:
        return self.page.value(self.book[f"governor_{key}"].var(unit))

    def given_values(self) -> Markup:
        return self.page.values(self.book[f"governor_{key}"].var() for key in self._given())

    def _given(self) -> list[str]:
        servo = [key for key in ("T_s", "zone", "beta", "T_i") if self.has(key)]
        return [key for key in (*GIVEN, *servo) if self.book[f"governor_{key}"].value]

    def explained(self, *keys: str) -> list[dict[str, Any]]:
        """Of these numbers, or of those that are given."""
        of = {key: self.book[f"governor_{key}"] for key in keys or self._given() if self.has(key)}
        return [self._meant(one) for one in of.values()]

    def _meant(self, of: Value) -> dict[str, Any]:
        """A symbol is explained once, whichever number it stands for."""
        return {**self.page.explained(of.key, of, of.unit), "id": of.symbol}

    def states(self) -> list[dict[str, Any]]:
        """The states of the small motions."""
        return [self._meant(q.state(name).value(0.0)) for name in self.found.states]

    def motions(self) -> list[dict[str, Any]]:
        """What stands in the equations of motion."""
        of = [
            q.OMEGA,
            q.Z,
            q.SUPPLY,
            q.FULL,
            q.LOAD,
            *([q.BACK] if self.found.response.x is not None else []),
        ]
        return [self._meant(one.value(0.0)) for one in of]

    def kind(self) -> Markup:
        x, y = self.found.vyshnegradsky or (0.0, 0.0)
        return self.t(KINDS[kind(x, y)])

    def verdict(self) -> Markup:
        """The signs of the determinants agree with those of the eigenvalues."""
        if self.found.stable:
            return self.t(
                N_(
                    "All of them are positive and all eigenvalues lie in the left half plane: the loop is stable."
                )
            )
        return self.t(
            N_(
                "Not all of them are positive, and an eigenvalue lies in the right half plane: the loop is unstable."
            )
        )

    # ------------------------------------------------------------ tables

    def steady(self, caption: Any) -> Table:
        table, page = self.book.tables["governor_steady"], self.page
        names = [
            page.word(self.t(STEADY[str(one)]), table, "state", row)
            for row, one in enumerate(table["state"].values)
        ]
        columns = [
            page.column(table, "M_c"), page.column(table, "omega"), page.column(table, "omega", "rpm"),
            page.column(table, "z", "mm"), page.column(table, "s"),
        ]  # fmt: skip
        return numeric(caption, Column(self.t(N_("State")), names), columns)

    def matrix(self, caption: Any) -> Table:
        """Each number with its own digits."""
        table, page, names = self.book.tables["governor_matrix"], self.page, self.found.states
        rows = [
            [
                page.word(page.math(Rate(q.STATES[name][0])), table, "state", row),
                *(page.cell(table, other, row, scale=0.0) for other in names),
            ]
            for row, name in enumerate(names)
        ]
        heads = [self.t(N_("Rate")), *(page.sym(table[name].symbol()) for name in names)]
        return worded(caption, heads, rows, (2, *(3 for _ in names)))

    def roots(self, caption: Any) -> Table:
        table, page = self.book.tables["governor_eigenvalues"], self.page
        numbers = [page.cell(table, "number", row) for row in range(len(table))]
        columns = [page.column(table, key) for key in ("real", "imaginary")]
        return numeric(caption, Column(self.t(N_("No.")), numbers), columns)

    def hurwitz(self, caption: Any) -> Table:
        """Each number with its own digits: they differ by many powers of ten."""
        table, page = self.book.tables["governor_hurwitz"], self.page
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
            return charts.vyshnegradsky(self.found, self._num, said)
        return charts.isodrome(self.found, self._num, self.page.unit("s"), said)

    def _num(self, value: float) -> str:
        return self.page.num(value, 4)

    @cached_property
    def response(self) -> Graph:
        response, start = self.found.response, self.found.before.omega
        peak = (float(response.t[self.found.worst]), float(response.omega[self.found.worst] - start))
        exact, small = str(self.t(N_("large motions"))), str(self.t(N_("small motions")))
        curves = [
            Curve(response.omega - start, exact, 0, extremes=[peak]),
            Curve(self.found.linear + self.found.after.omega - start, small, 0, extremes=()),
            Curve(1e3 * response.z, "", 1, extremes=()),
            Curve(response.s, "", 2, extremes=()),
        ]
        axes = [(Symbol("Δω"), "rad/s"), (q.Z.sign, "mm"), (q.SUPPLY.sign, "")]
        return plot(curves, response.t, q.T, axes, self.page.tr)

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
            final = self.number("final" if self.found.short else "static", "%", digits=4)
            lines.append(self.t(text, peak=self.number("peak", "%", digits=4), static=final))
        if self.found.servo is None and self.found.too_heavy:
            text = N_("The sleeve alone cannot move the throttle: an indirect governor is needed.")
            lines.append(Failed(self.t(text)))
        return lines
