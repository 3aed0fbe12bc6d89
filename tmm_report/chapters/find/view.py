"""View of a question asked backwards."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.find.draw import course, meeting
from tmm_report.chapters.find.pair import Both
from tmm_report.chapters.find.quantities import tables, values
from tmm_report.chapters.find.solve import Found
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Book
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import CycleGraphs, letter
from tmm_report.report.page import ROUNDING, Page
from tmm_report.report.paper.layout import Table, numeric
from tmm_report.report.part import Failed, Part

MARKED = 12  # roots with their numbers on the chart


def parts(found: Found | Both, page: Page) -> Iterator[Part]:
    if isinstance(found, Both):
        yield Part("find_both", BothView(found, page))
    else:
        yield Part("find", FindView(found, page))


class FindView(BookView):
    own = True

    def __init__(self, found: Found, page: Page):
        super().__init__(page, Book.of(tables(found), values(found)), "find_")
        self.found, self.demand, self.unknown = found, found.given.demand, found.given.unknown

    def closed(self) -> list[Formula]:
        """The textbook's formula."""
        if self.found.closed is None:
            return []
        return [self.value("closed").formula(self.found.closed.form)]

    @property
    def meaning(self) -> Markup:
        """What is demanded, in words."""
        return self.page.message(self.found.target.quantity.meaning)

    def wanted(self) -> Markup:
        """The demand as a sentence goes on: = 0.8 m, not more than 0.8 m."""
        signs = {"equal": "=", "most": "≤", "least_allowed": "≥"}
        sign = self.page.sym(self.value("y").symbol)
        return self.page.listed([sign, signs[self.demand.kind], self.measured("wanted")], " ")

    def extreme(self) -> Markup:
        """Of which rows of a column the number is."""
        pick = self.found.target.pick
        if pick == "max":
            return self.t(N_("its greatest value in the table"))
        return self.t(N_("its least value in the table")) if pick == "min" else self.t(N_("one row"))

    @property
    def met(self) -> bool:
        return self.knows("wanted") and _met(self, ("",))

    @property
    def left(self) -> list[str]:
        """Columns of the roots beside the numbers themselves."""
        shown = ("rate",) if self.met else ("residual", "rate")
        return [key for key in shown if key in self.table("roots")]

    def agrees(self, *keys: str) -> bool:
        return _agree(self, keys)

    def roots(self, caption: Any) -> Table:
        left = ("number", "residual") if self.met else ("number",)
        return _roots(self, caption, [one.key for one in self.table("roots").columns if one.key not in left])

    def jumps(self) -> Markup:
        return self._places("jumps", "x")

    def lost(self) -> Markup:
        """The parts of the range with no results."""
        rows = range(min(len(self.table("lost")), MARKED))
        ends = ([self._at("lost", key, row) for key in ("begin", "end")] for row in rows)
        return self.page.listed(self.page.listed(pair, " … ") for pair in ends)

    def _places(self, name: str, key: str) -> Markup:
        rows = range(min(len(self.table(name)), MARKED))
        return self.page.listed(self._at(name, key, row) for row in rows)

    def _at(self, name: str, key: str, row: int) -> Markup:
        return self.page.shown(self.table(name), key, row, digits=6)

    def reason(self) -> Markup:
        assert self.found.reason is not None
        return self.page.sentence(self.found.reason)

    @cached_property
    def chart(self) -> Drawing:
        found, page = self.found, self.page
        x, y = self.of("course", "x"), self.of("course", "y")
        names = CycleGraphs((), 0, page.tr)
        unit, own = x.quantity.printed, y.quantity.printed
        scale = x.quantity.value(1.0).number(unit), y.quantity.value(1.0).number(own)
        roots = found.sought.roots if found.sought.roots else (found.chosen,)
        several = 1 < len(roots) <= MARKED
        marks = [
            (found.size(root.at) * scale[0], root.value * scale[1], str(k) if several else "")
            for k, root in enumerate(roots, 1)
        ]
        jumps = [found.size(part) * scale[0] for part in found.sought.jumps]
        axes = names.letter(x.quantity.sign, unit), names.letter(y.quantity.sign, own)
        told = letter(self.value("wanted").symbol, page.tr) if self.knows("wanted") else ()
        return course(
            x.numbers(unit), y.numbers(own), jumps, found.level * scale[1], marks, axes, page.num, told
        )

    def conclusions(self) -> Sequence[Markup]:
        x, y = self.sized("x"), self.sized("y")
        if not self.found.sound:
            text = N_(
                "The demand on %(what)s cannot be met in the range of %(name)s: nearest is %(y)s at %(x)s."
            )
            return [Failed(self.t(text, what=self.meaning, name=self.unknown.name, x=x, y=y))]
        text = N_("Asked backwards, %(name)s is %(x)s; then %(y)s.")
        return [self.t(text, name=self.unknown.name, x=x, y=y)]


class BothView(BookView):
    own = True

    def __init__(self, found: Both, page: Page):
        super().__init__(page, Book.of(tables(found), values(found)), "find_")
        self.found, self.unknowns = found, found.given.unknowns

    def sought(self) -> Markup:
        """Both unknowns with their ranges."""
        text = N_("%(name)s within %(low)s … %(high)s")
        return self.page.listed(
            self.t(text, name=of.name, low=self.measured(f"low{last}"), high=self.measured(f"high{last}"))
            for of, last in zip(self.unknowns, ("", "2"), strict=True)
        )

    def wanted(self) -> Markup:
        """Both demands."""
        return self.page.listed(
            self.page.listed(
                [self.page.message(of.quantity.meaning), self.page.value(self.var(f"wanted{last}"))], " "
            )
            for of, last in zip(self.found.targets, ("", "2"), strict=True)
        )

    def taken(self) -> Markup:
        return self.listed(("x", "x2"))

    def reason(self) -> Markup:
        assert self.found.reason is not None
        return self.page.sentence(self.found.reason)

    def closed(self) -> list[Formula]:
        """The textbook's formulas."""
        return [self.value(f"closed{'2' if k else ''}").formula(one.form) for k, one in self.found.closed]

    def made(self) -> Markup:
        return self.listed(("y", "y2"))

    @property
    def met(self) -> bool:
        return _met(self, ("", "2"))

    @property
    def left(self) -> list[str]:
        """Columns of what is left of the differences."""
        return [] if self.met else ["residual", "residual2"]

    def agrees(self, *keys: str) -> bool:
        return _agree(self, keys)

    def roots(self, caption: Any) -> Table:
        return _roots(self, caption, ["x", "x2", *self.left])

    def rates(self, caption: Any) -> Table:
        return _roots(
            self, caption, [one.key for one in self.table("roots").columns if one.key[:5] == "rate_"]
        )

    @cached_property
    def chart(self) -> Drawing:
        found, page, names = self.found, self.page, CycleGraphs((), 0, self.page.tr)
        axes = [self.of("course", key) for key in ("x", "x2")]
        units = [one.quantity.printed for one in axes]
        scales = [one.quantity.value(1.0).number(unit) for one, unit in zip(axes, units, strict=True)]
        roots = [root.at for root in found.sought.roots] or [found.chosen.at]
        spots = [
            complex(*(size * scale for size, scale in zip(found.sizes(at), scales, strict=True)))
            for at in roots
        ]
        several = 1 < len(spots) <= MARKED
        marks = [(at, str(k) if several else "") for k, at in enumerate(spots, 1)]
        places = np.stack([one.numbers(unit) for one, unit in zip(axes, units, strict=True)], axis=1)
        wanted = [letter(self.value(key).symbol, page.tr) for key in ("wanted", "wanted2")]
        first, second = (names.letter(of.quantity.sign, unit) for of, unit in zip(axes, units, strict=True))
        rest = found.sought.f - np.array(found.levels)
        return meeting(places.reshape(found.sought.x.shape), rest, marks, (first, second), wanted, page.num)

    def conclusions(self) -> Sequence[Markup]:
        if not self.found.sound:
            text = N_("The two demands cannot both be met in the ranges: nearest is %(x)s, where %(y)s.")
            return [Failed(self.t(text, x=self.taken(), y=self.made()))]
        return [self.t(N_("Asked backwards, %(x)s; then %(y)s."), x=self.taken(), y=self.made())]


def _agree(view: BookView, keys: Iterable[str]) -> bool:
    """Whether relative differences are nothing but rounding."""
    return all(abs(view.value(key).value) < ROUNDING for key in keys)


def _met(view: BookView, lasts: Iterable[str]) -> bool:
    """Whether at every root nothing but rounding is left of what is wanted."""
    return all(
        bool(
            np.all(
                np.abs(view.of("roots", f"residual{last}").values)
                < ROUNDING * abs(view.value(f"wanted{last}").value)
            )
        )
        for last in lasts
    )


def _roots(view: BookView, caption: Any, keys: Sequence[str]) -> Table:
    """Roots to many digits; what is left and sensitivities to few."""
    table = view.table("roots")
    columns = [
        view.page.singles(table, key, digits=3)
        if key.startswith(("residual", "rate"))
        else view.column("roots", key, digits=8)
        for key in keys
    ]
    return numeric(caption, view.column("roots", "number", digits=1), columns)
