"""View of what holds over the whole cycle: extremes of the forces, senses of the balancing moment, works."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.mechanics.lever.cycle import larger
from tmm_report.problems import N_
from tmm_report.quantity.model import Table as Numbers
from tmm_report.report.chapter_view import BookView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, worded

SIDES = {"before": N_("before the jump"), "after": N_("after the jump")}
ENDS = {"least": "M_bal_min", "greatest": "M_bal_max"}
NOISE = 1e-9  # of the largest work, beside which another is nothing


class CycleView(BookView):
    def __init__(self, found: Kinetostatics, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found = found

    def conclusions(self) -> Sequence[Markup]:
        """The largest reaction of a pivot or a guide, with its pair and angle; the mean power."""
        return [*self._largest(), *self._power()]

    @property
    def by_law(self) -> bool:
        """Whether the driving link moves by a law: the cycle then goes over its phase."""
        return self.found.kinematics.by_law

    @property
    def exact(self) -> bool:
        """Whether every position has forces."""
        return self.found.over is not None

    @property
    def told(self) -> bool:
        """Whether the works of the cycle are told: it ends where it begins."""
        return self.found.works is not None

    # ------------------------------------------------------------ extremes

    @property
    def _extremes(self) -> Numbers:
        return self.table("force_extremes")

    def _row(self, key: str) -> int:
        return list(self._extremes["key"].values).index(key)

    def moment(self, which: str) -> Markup:
        """ "least" or "greatest" balancing moment, N m."""
        return self.number(ENDS[which])

    def moment_at(self, which: str) -> Markup:
        if self.exact:
            return self._at(which, self._row(q.BALANCING_MOMENT.key), "°")
        return self.page.listed([self.turned(ENDS[which]), "°"], "")

    def _at(self, which: str, row: int, unit: str = "") -> Markup:
        """The angle at which an extreme is reached, and the side of a jump."""
        angle = self.page.listed([self.page.shown(self._extremes, f"{which}_at", row, places=1), unit], "")
        side = str(self._extremes[f"{which}_side"].values[row])
        if not side:
            return angle
        said = Cell(str(self.t(SIDES[side])), self._extremes.ref(f"{which}_side", row))
        return self.page.listed([angle, self.page.said(said)], " ")

    @property
    def jumps(self) -> bool:
        return any(self._extremes[key].values.count("") < len(self._extremes) for key in _SIDE_KEYS)

    def reactions(self, caption: Any) -> Table:
        """Least and greatest of every reaction, and where they are reached."""
        return self._least_and_greatest(caption, self._sizes)

    def projections(self, caption: Any) -> Table:
        """The same of their projections."""
        others = {str(key) for key in self._extremes["key"].values}
        return self._least_and_greatest(caption, others - self._sizes - {q.BALANCING_MOMENT.key})

    @property
    def _sizes(self) -> set[str]:
        """Keys of the reactions."""
        return {q.reaction(*one.pair.links).key for one in self.found.table.statics.reactions.values()}

    def _least_and_greatest(self, caption: Any, keys: set[str]) -> Table:
        table = self._extremes
        rows = [
            [self.page.head(table["least"].symbol(row), table["least"].unit_of(row)), *self._ends(row)]
            for row, key in enumerate(table["key"].values)
            if key in keys and self._speaks(row)
        ]
        at = self.t("at θ, °") if self.by_law else self.t("at φ, °")
        heads = [self.t("Reaction"), self.t("Least value"), at, self.t("Greatest value"), at]
        return worded(caption, heads, rows, (3, 3, 3, 3, 3))

    def _speaks(self, row: int) -> bool:
        """Whether a projection is more than rounding: a guide gives no force along itself."""
        low, high = (np.abs(np.array(self._extremes[key].values, float)) for key in ("least", "greatest"))
        return bool(max(low[row], high[row]) > NOISE * max(low.max(), high.max()))

    def _ends(self, row: int) -> list[Any]:
        size = max(abs(float(self._extremes[key].values[row])) for key in ("least", "greatest"))
        found: list[Any] = []
        for key in ("least", "greatest"):
            found += [self.page.cell(self._extremes, key, row, scale=size), self._at(key, row)]
        return found

    def _largest(self) -> list[Markup]:
        if self.found.over is None:
            return []
        sizes = {key: larger(peaks) for key, peaks in self.found.over.sizes.items()}
        key = max(sizes, key=lambda one: sizes[one].value)
        if not sizes[key].value > 0:
            return []
        pair = self.found.over.statics.reactions[key].pair
        row = self._row(q.reaction(*pair.links).key)
        pivot = N_(
            "The largest reaction is that of pivot %(pair)s of links %(one)s and %(other)s: %(force)s N at the "
            "angle of rotation %(angle)s°."
        )
        guide = N_(
            "The largest reaction is that of guide %(pair)s of links %(one)s and %(other)s: %(force)s N at the "
            "angle of rotation %(angle)s°."
        )
        text = pivot if pair.kind == "R" else guide
        force = self.page.shown(self._extremes, "greatest", row)
        angle = self.page.shown(self._extremes, "greatest_at", row, places=1)
        one, other = pair.links
        return [self.t(text, pair=pair.name, one=one, other=other, force=force, angle=angle)]

    # ------------------------------------------------------------ senses of the moment

    @property
    def _zones(self) -> Numbers:
        return self.table("moment_senses")

    @property
    def changes(self) -> bool:
        """Whether the balancing moment has both senses over the cycle."""
        return len(self._zones) > 1

    @property
    def idle(self) -> bool:
        """Whether there is no balancing moment over the whole cycle."""
        return not len(self._zones)

    @property
    def drives(self) -> bool:
        """Whether it drives all round, where it has one sense."""
        return self._zones["sense"].values[0] == "along"

    def zones(self, caption: Any) -> Table:
        """Where the moment has which sense, and its work there."""
        table = self._zones
        words = {
            "along": self.t("along ω: it drives the mechanism"),
            "against": self.t("opposite to ω: the mechanism gives off work"),
        }
        rows = [
            [
                self.page.cell(table, "from", row, places=1), self.page.cell(table, "to", row, places=1),
                self.page.word(words[sense], table, "sense", row), self.page.cell(table, "work", row),
            ]
            for row, sense in enumerate(table["sense"].values)
        ]  # fmt: skip
        from_, to = (
            (self.t("From θ, °"), self.t("To θ, °"))
            if self.by_law
            else (self.t("From φ, °"), self.t("To φ, °"))
        )
        heads = [
            from_, to, self.t("Balancing moment"),
            self.page.listed([self.t("Work"), self.page.unit("J")]),
        ]  # fmt: skip
        return worded(caption, heads, rows, (2, 2, 6, 2))

    def moment_positions(self) -> list[Markup]:
        """At which positions the moment has which sense, in sentences."""
        table = self._works
        driving = N_(
            "The moment has the sense of rotation of the driving link at the positions %(positions)s: there it "
            "drives the mechanism."
        )
        giving = N_("It is opposite at the positions %(positions)s: there the mechanism gives off work.")
        texts = (("drives_at", driving), ("resists_at", giving))
        return [
            self.t(text, positions=self.page.said(Cell(table[key].values[0], table.ref(key, 0))))
            for key, text in texts
            if table[key].values[0]
        ]

    # ------------------------------------------------------------ works of the loads

    @property
    def _works(self) -> Numbers:
        return self.table("works")

    @property
    def weights(self) -> bool:
        return bool(self.found.works and self.found.works.weights)

    def works(self, caption: Any) -> Table:
        """Where each load drives and resists, and its work."""
        table, works = self._works, self.found.works
        assert works is not None
        rows = []
        named = q.named_works(self.found, works)
        scale = max((size for _, done in named for size in (done.driving, -done.resisting)), default=0.0)
        for row, (of, _) in enumerate(named):
            cells: list[Any] = [self.page.sym(of.sign)]
            cells += [self.page.word(table[key].values[row] or "—", table, key, row) for key in _AT_KEYS]
            cells += [
                self.page.cell(table, key, row, scale=max(scale, 1e-300))
                for key in ("driving", "resisting", "work")
            ]
            rows.append(cells)
        heads = [
            self.t("Load"), self.t("Drives at positions"), self.t("Resists at positions"),
            *(self.page.head(table[key].symbol(), "J") for key in ("driving", "resisting", "work")),
        ]  # fmt: skip
        return worded(caption, heads, rows, (2, 4, 4, 3, 3, 3))

    @property
    def sum(self) -> Markup:
        return self.bound("works_sum")

    @property
    def power(self) -> Markup:
        return self.number("P_bal_mean")

    def _power(self) -> list[Markup]:
        if not self.told:
            return []
        text = N_("The mean power of the balancing moment over the cycle is %(power)s W.")
        return [self.t(text, power=self.power)]


_SIDE_KEYS, _AT_KEYS = ("least_side", "greatest_side"), ("drives_at", "resists_at")
