"""View of friction in single pairs: planes and wedges, screws, pivots, belts, wheels, journals."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.contacts import draw_turning
from tmm_report.chapters.machine.contacts import quantities as q
from tmm_report.chapters.machine.contacts.formulas import Of
from tmm_report.chapters.machine.contacts.formulas_turning import FORMULAS
from tmm_report.chapters.machine.contacts.solve import Found, Solved
from tmm_report.chapters.machine.contacts.terms import KINDS
from tmm_report.chapters.machine.contacts.words import introduced, shown, verdicts
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.pairs.materials import Stock
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Book
from tmm_report.report.page import Page
from tmm_report.report.paper import layout
from tmm_report.report.part import Part

LENGTHS = ("m",)
LOCKING = ("incline", "wedge", "screw")


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/contacts", ContactsView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The first pair at a glance, for a list of many."""
    return draw_turning.picture(found)


class ContactsView:
    def __init__(self, found: Found, page: Page):
        self.found, self.page, self.t = found, page, page.t
        self.book = Book.of(q.tables(found), q.values(found))

    @property
    def items(self) -> tuple[Solved, ...]:
        return self.found.items

    def conclusions(self) -> list[Markup]:
        """One sentence for all pairs with an efficiency."""
        named = [self._concluded(item) for item in self.items if "eta" in item.numbers]
        text = N_("The efficiencies of the single pairs with friction: %(pairs)s.")
        return [self.t(text, pairs=self.page.listed(named, "; "))] if named else []

    def _concluded(self, item: Solved) -> Markup:
        return self.page.listed([item.name or self.heading(item), self.number(item, "eta", digits=4)], " – ")

    def together(self, caption: Any) -> layout.Table:
        """The pairs side by side: coefficient and angle of friction, efficiency, whether they lock."""
        listed = self.book.tables["contacts"]
        heads: list[Any] = [self.t("No."), self.t("Pair")]
        heads += [self.page.head(listed[key].symbol(), listed[key].unit) for key in ("f", "phi_fr", "eta")]
        rows = [self._row(item) for item in self.items]
        return layout.worded(caption, [*heads, self.t("Locks by itself")], rows, (1, 8, 3, 3, 3, 3))

    def _row(self, item: Solved) -> list[Any]:
        table, page, row = self.book.tables["contacts"], self.page, item.number - 1
        locks = self.t("yes") if item.locks else self.t("no")
        return [
            layout.Cell(str(item.number), table.ref("number", row)), self.heading(item),
            page.cell(table, "f", row, digits=4), page.cell(table, "phi_fr", row, digits=4),
            page.cell(table, "eta", row, digits=4) if "eta" in item.numbers else "—",
            page.word(locks, table, "locks", row) if item.kind in LOCKING else "—",
        ]  # fmt: skip

    # ------------------------------------------------------------ a pair

    def heading(self, item: Solved) -> Markup:
        kind = self.t(KINDS[item.kind])
        return self.page.listed([kind, item.name], ": ") if item.name else kind

    def label(self, item: Solved) -> str:
        return f"contacts:{item.number}"

    def introduced(self, item: Solved) -> Markup:
        return self.page.listed([self.t(text) for text in introduced(item)], " ")

    def shown(self, item: Solved, figure: Any) -> Markup:
        return self.t(shown(item), figure=figure)

    def formulas(self, item: Solved) -> list[Formula]:
        return list(FORMULAS[item.kind](Of(item)))

    def given(self, item: Solved) -> Markup:
        """What is stated of the pair: its numbers that no formula gives."""
        result = {formula.ref.key for formula in self.formulas(item) if formula.ref is not None}
        table = self.book.tables[q.name(item)]
        keys = [key for key in item.numbers if key not in result and self._stated(item, key)]
        units = {key: "mm" if table[key].unit in LENGTHS else "" for key in keys}
        return self.page.listed(self.page.value(table.var(key, 0, unit)) for key, unit in units.items())

    def _stated(self, item: Solved, key: str) -> bool:
        """A flat pivot or drum has no angle worth a word, nor has a full disc an inner radius."""
        flat = key in ("half_cone", "groove") and item.numbers[key] == 90.0
        nothing = key in ("r_inner", "beta") and not item.numbers[key]
        return not (flat or nothing or (key == "f_red" and item.numbers["groove"] == 90.0))

    def where(self, item: Solved) -> list[dict[str, Any]]:
        """Every symbol of the pair with its meaning: a letter may mean another thing in another pair."""
        table = self.book.tables[q.name(item)]
        keys = [key for key in item.numbers if self._stated(item, key)]
        return [
            {
                "id": (table[key].symbol(), table[key].meaning.text),
                "symbol": table[key].symbol(),
                "meaning": self.page.message(table[key].meaning),
                "unit": "" if table[key].unit == "deg" else table[key].unit,
            }
            for key in keys
        ]

    def materials(self, item: Solved) -> Markup | None:
        """Of which materials the coefficient is taken."""
        rough = getattr(item.of, "rough", None)
        stock = rough.stock if rough is not None else None
        return self._materials(stock, item) if stock is not None else None

    def _materials(self, stock: Stock, item: Solved) -> Markup:
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
        table = self.book.tables["contacts"]
        ends = dict.fromkeys(("f_low", "f_high") if len(set(stock.range or ())) > 1 else ("f_low",))
        shown = self.page.listed([self.page.shown(table, key, item.number - 1) for key in ends], "–")
        return self.t(texts[stock.lubrication, stock.state], pair=pair, range=shown)

    def verdicts(self, item: Solved) -> list[Markup]:
        return list(verdicts(item, self.page, self.book.tables[q.name(item)]))

    def sketch(self, item: Solved) -> Drawing | None:
        make = draw_turning.SKETCHES.get(item.kind)
        return make(item, str(self.heading(item))) if make else None

    def number(self, item: Solved, key: str, **form: Any) -> Markup:
        return self.page.shown(self.book.tables[q.name(item)], key, **form)
