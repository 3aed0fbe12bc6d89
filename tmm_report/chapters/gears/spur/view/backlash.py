"""View of the backlash of a pair: thinning of the teeth, least and greatest backlash, limits of the measured sizes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.gears.spur.words import BY_WHAT, MEASURED
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.paper.layout import DASH, Cell, Table, worded

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.view.pair import SpurView

ENDS = ("least", "most")
OF_ENDS = ("a", "alpha", "by_axes", "by_teeth", "j_w", "j_n")


class BacklashView(ChapterView):
    """`of`: the view of the pair."""

    def __init__(self, of: SpurView):
        assert of.found.backlash is not None and of.stage.loosened is not None
        super().__init__(of.page, of.stage.loosened, of.tables)
        self.found, self.names, self.stated = of.found.backlash, of.names, of.found.backlash.stated

    # ------------------------------------------------------------ what is stated

    def fields(self, caption: Any) -> Table:
        """What the fit is made of: stated, found, or left to be filled in from the norm's tables."""
        left, rows = self.t("to be filled in"), []
        grade = self.stated.grade
        rows.append([self.t("degree of accuracy and kind of fit by GOST 1643"), DASH, grade or left])
        for key, text, letter in (
            ("guaranteed", N_("least normal backlash, mm"), "j_n^min"),
            ("axes", N_("limit deviation of the centre distance, ±, mm"), "f_a"),
        ):
            rows.append([self.t(text), self.page.sym(letter), self._field(key, left)])
        for place, name in zip(("one", "two"), self.names, strict=True):
            for key, text, letter in (
                ("thin", N_("least thinning of the teeth of wheel %(wheel)s, mm"), f"E_s{name}"),
                ("field", N_("tolerance of the thickness of the teeth of wheel %(wheel)s, mm"), f"T_s{name}"),
            ):
                sign = self.page.sym(letter)
                rows.append([self.t(text, wheel=name), sign, self._field(f"{key}_{place}", left)])
        return worded(caption, [self.t("Parameter"), self.t("Symbol"), self.t("Value")], rows, (5, 1.5, 2.5))

    def _field(self, key: str, left: Markup) -> Cell | Markup:
        return self.page.cell(self.value(key), places=3) if self.knows(key) else left

    @property
    def converted(self) -> Markup:
        """By what the thinning is stated, where it is not that of the teeth."""
        return self.t(BY_WHAT[self.stated.by])

    def thinned(self) -> list[Formula]:
        return self.formulas("thin_one", "thin_two", "field_one", "field_two")

    def span_falls(self) -> list[Formula]:
        return self.formulas("span_fall_one", "span_fall_two")

    # ------------------------------------------------------------ backlash

    @property
    def ends(self) -> tuple[str, ...]:
        """Which are found: the least and the greatest, or one alone."""
        return ENDS[: 1 if self.found.single else 2] if self.found.known else ()

    def steps(self, end: str) -> list[Formula]:
        keys = [f"{key}_{end}" for key in OF_ENDS]
        return self.formulas(*keys, f"turn_{end}_one", f"turn_{end}_two")

    def meant(self, end: str) -> list[dict[str, Any]]:
        """What the letters of the steps mean."""
        return self.where(*self.steps(end))

    # ------------------------------------------------------------ limits

    def limits(self, caption: Any) -> Table:
        """Each size without thinning, with its deviations and its limits."""
        table, page = self.table("limits"), self.page
        shown: tuple[str, ...] = ("nominal", "first_off", "second_off", "first", "second")
        if self.found.least == self.found.most:
            shown = ("nominal", "first_off", "first")
        rows = [
            [
                page.word(self.t(MEASURED[size]), table, "size", row),
                page.sym(table["nominal"].symbol(row)),
                *(page.cell(table, key, row, places=3) for key in shown),
            ]
            for row, size in enumerate(table["size"].values)
        ]
        heads = [self.t("Dimension"), self.t("Symbol")]
        heads += [page.listed([page.message(table[key].meaning), page.unit("mm")]) for key in shown]
        return worded(caption, heads, rows, (3.6, 1.2, *[1.8] * len(shown)))

    def deviations(self, i: int, size: str) -> Iterator[Markup]:
        """Of a measured size of wheel i, for its drawing: with the least thinning and with the greatest."""
        if not self.has("limits"):
            return
        table = self.table("limits")
        for row, (wheel, key) in enumerate(zip(table["wheel"].values, table["size"].values, strict=True)):
            if (wheel, key) == (self.names[i], size):
                columns = (
                    ("first_off",) if self.found.least == self.found.most else ("first_off", "second_off")
                )
                for column in columns:
                    shown = self.page.shown(table, column, row, places=3)
                    yield self.page.in_unit(shown, "mm")
