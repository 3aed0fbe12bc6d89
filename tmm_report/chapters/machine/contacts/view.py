"""View of friction in single pairs: planes and wedges, screws, pivots, belts, wheels, journals."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.contacts import draw_turning
from tmm_report.chapters.machine.contacts.given import Rough
from tmm_report.chapters.machine.contacts.quantities import tables
from tmm_report.chapters.machine.contacts.solve import Found, Solved
from tmm_report.chapters.machine.contacts.steps import flat
from tmm_report.chapters.machine.contacts.values import KINDS
from tmm_report.chapters.machine.contacts.words import introduced, shown, verdicts
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.pairs.materials import Stock
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Table
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper import layout
from tmm_report.report.part import Part

LOCKING = ("incline", "wedge", "screw")


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/contacts", ContactsView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The first pair at a glance, for a list of many."""
    return draw_turning.picture(found)


class ContactsView:
    def __init__(self, found: Found, page: Page):
        self.page, self.t = page, page.t
        self.listed, *_ = tables(found)
        self.pairs = [PairView(item, page, self.listed) for item in found.items]

    def conclusions(self) -> list[Markup]:
        """One sentence for all pairs with an efficiency."""
        named = [pair.concluded() for pair in self.pairs if "eta" in pair.s]
        text = N_("The efficiencies of the single pairs with friction: %(pairs)s.")
        return [self.t(text, pairs=self.page.listed(named, "; "))] if named else []

    def together(self, caption: Any) -> layout.Table:
        """The pairs side by side: coefficient and angle of friction, efficiency, whether they lock."""
        columns = (self.listed[key] for key in ("f", "phi_fr", "eta"))
        heads: list[Any] = [self.t("No."), self.t("Pair")]
        heads += [self.page.head(one.symbol(), one.quantity.printed) for one in columns]
        rows = [pair.row() for pair in self.pairs]
        return layout.worded(caption, [*heads, self.t("Locks by itself")], rows, (1, 8, 3, 3, 3, 3))


class PairView(ChapterView):
    """One of the pairs; `together`: the table of all of them."""

    def __init__(self, item: Solved, page: Page, together: Table):
        super().__init__(page, item.s)
        self.item, self.together = item, together
        self.label = f"contacts:{item.number}"

    @property
    def heading(self) -> Markup:
        kind = self.t(KINDS[self.item.kind])
        return self.page.listed([kind, self.item.of.name], ": ") if self.item.of.name else kind

    def concluded(self) -> Markup:
        return self.page.listed([self.item.of.name or self.heading, self.number("eta")], " – ")

    def row(self) -> list[Any]:
        """Of the table of all pairs."""
        table, page, row = self.together, self.page, self.item.number - 1
        locks = self.t("yes") if self.item.locks else self.t("no")
        return [
            layout.Cell(str(self.item.number), table.ref("number", row)), self.heading,
            page.cell(table, "f", row, digits=4), page.cell(table, "phi_fr", row, digits=4),
            page.cell(table, "eta", row, digits=4) if "eta" in self.s else "—",
            page.word(locks, table, "locks", row) if self.item.kind in LOCKING else "—",
        ]  # fmt: skip

    def introduced(self) -> Markup:
        return self.page.listed([self.t(text) for text in introduced(self.item)], " ")

    def shown(self, figure: Any) -> Markup:
        return self.t(shown(self.item), figure=figure)

    def worked(self) -> list[Formula]:
        """All of its formulas."""
        return self.formulas(*self.s.computed())

    def given(self) -> Markup:
        """What is stated of the pair: its numbers that no formula gives."""
        return self.listed(key for key in self._told() if not self.s.has_formula(key))

    def _told(self) -> list[str]:
        """A flat pivot or drum has no angle worth a word, nor has a full disc an inner radius."""
        level = {key for key in ("half_cone", "groove") if key in self.s and flat(self.var(key).number)}
        nothing = {key for key in ("r_inner", "beta") if self.s.get(key) == 0}
        left = level | nothing | ({"f_red"} if "groove" in level else set())
        return [one.key for one in self.s.values() if one.key not in left]

    def symbols(self) -> list[dict[str, Any]]:
        """Every symbol of the pair with its meaning: a letter may mean another thing in another pair."""
        told = [self.value(key).quantity for key in self._told()]
        return [
            {
                "id": (one.symbol, one.meaning.text),
                "symbol": one.symbol,
                "meaning": self.page.message(one.meaning),
                "unit": "" if one.unit == "deg" else one.unit,
            }
            for one in told
        ]

    def materials(self) -> Markup | None:
        """Of which materials the coefficient is taken."""
        stock = self.item.of.stock if isinstance(self.item.of, Rough) else None
        return self._materials(stock) if stock is not None else None

    def _materials(self, stock: Stock) -> Markup:
        texts = {
            ("dry", "moving"): N_(
                "The coefficient is that of %(pair)s, dry friction in motion: %(range)s in the table."
            ),
            ("dry", "rest"): N_(
                "The coefficient is that of %(pair)s, dry friction at rest: %(range)s in the table."
            ),
            ("semi-fluid", "moving"): N_(
                "The coefficient is that of %(pair)s, semi-fluid friction in motion: %(range)s in the table."
            ),
            ("semi-fluid", "rest"): N_(
                "The coefficient is that of %(pair)s, semi-fluid friction at rest: %(range)s in the table."
            ),
        }
        pair = self.page.listed([self.t(stock.one), self.t(stock.other)], "–")
        ends = dict.fromkeys(("f_low", "f_high") if len(set(stock.range or ())) > 1 else ("f_low",))
        row = self.item.number - 1
        shown = self.page.listed([self.page.shown(self.together, key, row) for key in ends], "–")
        return self.t(texts[stock.lubrication, stock.state], pair=pair, range=shown)

    def verdicts(self) -> list[Markup]:
        return list(verdicts(self.item, self))

    def sketch(self) -> Drawing | None:
        make = draw_turning.SKETCHES.get(self.item.kind)
        return make(self.item, self.heading.unescape()) if make else None
