"""View of what the wheels are measured by: a table of both, the formulas where they are asked for, drawing tables."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.gears.spur.words import (
    NO_CHORD,
    NO_CONSTANT,
    NO_PINS,
    NO_SPAN,
    OFF_PITCH,
    SPAN_MOVED,
)
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.symbols import math_symbol
from tmm_report.report.paper.layout import DASH, Cell, Table, worded

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.view.pair import SpurView

SIZES = (
    "span_rule",
    "span_teeth",
    "W",
    "rho_W",
    "s_c",
    "h_c",
    "d_y",
    "s_y",
    "h_y",
    "s_ay",
    "pin",
    "d_D",
    "d_k",
    "M",
)
FORMULAS = {
    "span": ("alpha_m", "span_rule", "W", "rho_W"),
    "chords": ("beta_a", "s_ay", "sag", "s_c", "h_c", "alpha_y", "beta_y", "psi_y", "s_y", "h_y"),
    "pins": ("inv_alpha_D", "d_D", "d_k", "M"),
}
STANDARD = (20.0, 1.0, 0.25)  # the basic rack of GOST 13755: degrees, modules


class InspectionView:
    """`of`: the view of the pair."""

    def __init__(self, of: SpurView):
        self.of, self.page, self.t, self.names = of, of.page, of.t, of.names
        self.given, self.gauges = of.found.given.inspection, of.stage.gauges
        self.table = of.table("inspection")

    @property
    def shown(self) -> tuple[int, ...]:
        """Wheels whose formulas are written out: the smaller of an external pair; a ring has others."""
        if self.given is None:
            return ()
        return (0, 1) if self.of.found.given.internal else (self.of.small,)

    def formulas(self, i: int, kind: str) -> list[Formula]:
        gauge = self.gauges[i]
        if kind == "span" and "W" not in gauge:
            return []
        return [gauge.formula(key) for key in FORMULAS[kind] if gauge.has_formula(key)]

    def meant(self, kind: str) -> list[dict[str, Any]]:
        """What the letters of the formulas mean."""
        told = {"span": ("span_teeth",), "chords": ("d_y",), "pins": ("pin", "alpha_D")}[kind]
        keys = [key for key in (*told, *FORMULAS[kind]) if any(key in gauge for gauge in self.gauges)]
        return [self.of.explained_of_wheels(self.table[key]) for key in keys]

    def angle(self, i: int) -> Markup:
        """The profile angle at the centres of the pins, by its involute function."""
        return self.page.value(self.gauges[i].alpha_D)

    # ------------------------------------------------------------ tables

    def sizes(self, caption: Any) -> Table:
        """Of both wheels; each row is a column of the results."""
        columns = [self.table[key] for key in SIZES if any(key in gauge for gauge in self.gauges)]
        rows = [
            [
                self.page.message(column.meaning),
                self.page.head(column.symbol(), column.quantity.printed),
                *(self._size(column.key, i) for i in (0, 1)),
            ]
            for column in columns
        ]
        wheels = [self.t("wheel %(name)s", name=name) for name in self.names]
        return worded(caption, [self.t("Dimension"), self.t("Symbol"), *wheels], rows, (5, 1.6, 1.8, 1.8))

    def _size(self, key: str, i: int) -> Cell | str:
        if key not in self.gauges[i]:
            return DASH
        cell = self.page.cell(self.table, key, i, places=None if key == "span_teeth" else 3)
        return cell if key == "span_teeth" else Cell(cell.full, cell.ref)

    def remarks(self) -> list[Markup]:
        """What a wheel cannot be measured by, and where the usual size was not taken."""
        return [said for i in (0, 1) for said in self._remarks(i)]

    def _remarks(self, i: int) -> Iterator[Markup]:
        of, name = self.of.found.inspected[i], self.names[i]
        if of.span is None:
            yield self.t(NO_SPAN[of.why_no_span], wheel=name)
        elif of.moved and self.given is None:
            yield self.t(SPAN_MOVED, wheel=name)
        if not of.has_constant_chord:
            yield self.t(NO_CONSTANT, wheel=name)
        if of.circle is None:
            yield self.t(NO_CHORD, wheel=name)
        elif of.circle != of.gauge.of("d") and self.given is None:
            yield self.t(OFF_PITCH, wheel=name)
        if of.pin is None:
            yield self.t(NO_PINS, wheel=name)

    # ------------------------------------------------------------ drawing

    @property
    def standard(self) -> bool:
        """Whether the basic rack is that of the standard."""
        return tuple(round(self.of.s.number(key), 9) for key in ("alpha", "ha", "c")) == STANDARD

    def drawing_table(self, i: int, caption: Any) -> Table:
        """The table of GOST 2.403 for the drawing of wheel i; what the calculation does not know is left to be filled
        in."""
        left = self.t("to be filled in")
        rows = [*self._basic(i, left), *self._control(i, left), *self._reference(i, left)]
        return worded(caption, [self.t("Parameter"), self.t("Symbol"), self.t("Value")], rows, (5, 1.5, 2.5))

    def _basic(self, i: int, left: Markup) -> Iterator[list[Any]]:
        of, t = self.of, self.t
        yield self._single("m")
        yield self._wheel("z", i)
        if of.helical:
            yield self._single("beta")
            yield [t("direction of the teeth"), DASH, left]
        if self.standard:
            yield [t("basic rack"), DASH, t("GOST\N{NO-BREAK SPACE}13755")]
        else:
            yield from (self._single(key) for key in ("alpha", "ha", "c"))
        yield self._wheel("x", i)
        grade = of.found.given.backlash.grade if of.found.given.backlash else None
        yield [t("degree of accuracy by GOST 1643"), DASH, grade or left]

    def _control(self, i: int, left: Markup) -> Iterator[list[Any]]:
        """One of the sizes that tell the thickness of the teeth: the span, else over pins, else the constant chord."""
        gauge = self.gauges[i]
        ways = (("span_teeth", "W"), ("pin", "M"), ("s_c", "h_c"))
        chosen = next((keys for keys in ways if all(key in gauge for key in keys)), ())
        for key in chosen:
            column = self.table[key]
            yield [
                self.page.message(column.meaning),
                self.page.head(column.symbol(i), column.quantity.printed),
                self._size(key, i),
            ]
        off: list[Markup] = []
        if self.of.backlash is not None and chosen:
            off = list(self.of.backlash.deviations(i, chosen[0] if chosen[0] == "s_c" else chosen[1]))
        deviations = self.page.listed(off, "; ") if off else left
        yield [self.t("limit deviations of the measured size"), DASH, deviations]

    def _reference(self, i: int, left: Markup) -> Iterator[list[Any]]:
        yield self._wheel("d", i)
        yield [self.t("number of teeth of the mating wheel"), *self._wheel("z", 1 - i)[1:]]
        yield [self.t("drawing of the mating wheel"), DASH, left]

    def _single(self, key: str) -> list[Any]:
        value = self.of.value(key)
        return [
            self.page.message(value.quantity.meaning),
            self.page.head(value.quantity.symbol or math_symbol(key), value.quantity.printed),
            self.page.cell(value),
        ]

    def _wheel(self, key: str, i: int) -> list[Any]:
        column = self.of.sizes[key]
        return [
            self.page.message(column.meaning),
            self.page.head(column.symbol(i), column.quantity.printed),
            self.page.cell(self.of.sizes, key, i, places=4 if key == "x" else None),
        ]
