"""What the view of every chapter offers its template: numbers, formulas, lists, tables by the keys of the declarations.

Letter, unit and noun come from the declaration, so that a view cannot print another: it chooses, and says sentences.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import Any

from markupsafe import Markup

from tmm_report.figures.charts.graphs import Graph
from tmm_report.quantity.formula import Formula, Var
from tmm_report.quantity.model import Book, Column, Table, Value
from tmm_report.quantity.sheet import Sheet
from tmm_report.quantity.terms.kinds import parted
from tmm_report.quantity.written import Equation
from tmm_report.report.diagrams import Line, cycle_lines
from tmm_report.report.page import Page
from tmm_report.report.paper import layout
from tmm_report.report.paper.layout import numeric


class BookView:
    """`book`: tables and single values of the chapter, found here without `prefix`, with which their names begin in the
    results. `own`: whether its letters are its own, to be explained again where another chapter has explained them as
    something else. `kinds_once`: whether of what is called alike, as reactions are but for their links, a "where" list
    explains the first for all."""

    own = False
    kinds_once = False

    def __init__(self, page: Page, book: Book, prefix: str = ""):
        self.page, self.t, self.book, self.prefix = page, page.t, book, prefix

    # --- single numbers

    def value(self, key: str) -> Value:
        return self.book[f"{self.prefix}{key}"]

    def knows(self, key: str) -> bool:
        """Whether this variant has the single number."""
        return f"{self.prefix}{key}" in self.book.values

    def number(self, key: str, unit: str = "", **form: Any) -> Markup:
        """A single number in running text, without its unit."""
        return self.page.shown(self.value(key), unit=unit, **form)

    def bound(self, key: str) -> Markup:
        """A relative difference that is not exceeded."""
        return self.page.bound(self.value(key))

    def measured(self, key: str, unit: str = "", **form: Any) -> Markup:
        """A single number in running text with its unit."""
        return self.page.measured(self.value(key), unit=unit, **form)

    def var(self, key: str, unit: str = "") -> Var:
        """A single number as it is printed."""
        value = self.value(key)
        return value.var(unit or value.quantity.shown)

    def sized(self, key: str, unit: str = "") -> Markup:
        """symbol = value unit."""
        return self.page.value(self.var(key, unit))

    def turned(self, key: str, places: int = 1) -> Markup:
        """The angle turned from position 0 at which a single number is reached, in degrees."""
        return self.page.said(self.page.turned(self.value(key), places))

    def listed(self, keys: Iterable[str]) -> Markup:
        """`sized` of those that this variant has."""
        return self.page.listed(self.sized(key) for key in keys if self.knows(key))

    def told_of(self, keys: Iterable[str]) -> Markup:
        """The same with what each is in front: module m = 5 mm; number of planet gears k = 3."""
        return self.page.listed((self.by_noun(key, self.sized(key)) for key in keys if self.knows(key)), "; ")

    def by_noun(self, key: str, of: Any) -> Markup:
        """A noun of the declaration in front of what is said of its number."""
        return self.page.listed([self.page.message(self.value(key).quantity.meaning), of], " ")

    # --- formulas

    def where(self, *formulas: Formula | Equation) -> list[dict[str, Any]]:
        """What a "where" list says of the quantities of the formulas."""
        items = self.page.where(*formulas, kinds_once=self.kinds_once)
        return [{**item, "id": (self.prefix, item["id"])} for item in items] if self.own else items

    def explained(self, *keys: str) -> list[dict[str, Any]]:
        """What a "where" list says of single numbers."""
        return [
            self.page.explained(f"{self.prefix}{key}", self.value(key), self.value(key).quantity.printed)
            for key in keys
            if self.knows(key)
        ]

    def columns_explained(self, name: str, *keys: str) -> list[dict[str, Any]]:
        """What a "where" list says of columns of a table."""
        return [
            self.page.explained(f"{self.prefix}{name}.{key}", one, one.quantity.printed)
            for key, one in ((key, self.of(name, key)) for key in keys)
        ]

    def column_sign(self, name: str, key: str) -> Markup:
        """The symbol of a column, as it stands in formulas."""
        return self.page.sym(self.of(name, key).quantity.sign)

    def columns_named(self, name: str, *keys: str) -> Markup:
        """What columns with symbols for heads mean, in a sentence: F_max – greatest shaking force; …"""
        signs = [self.column_sign(name, key) for key in keys]
        said = [self.page.message(self.of(name, key).quantity.meaning) for key in keys]
        return self.page.listed(
            (self.page.listed(pair, " – ") for pair in zip(signs, said, strict=True)), "; "
        )

    # --- tables

    def table(self, name: str) -> Table:
        """A table of the results. Raises KeyError for one that this variant has not."""
        return self.book.tables[f"{self.prefix}{name}"]

    def has(self, name: str) -> bool:
        return f"{self.prefix}{name}" in self.book.tables

    def column(self, name: str, key: str, unit: str = "", **form: Any) -> layout.Column:
        return self.page.column(self.table(name), key, unit, **form)

    def columns(
        self, name: str, keys: Iterable[str] = (), leave: Collection[str] = ()
    ) -> list[layout.Column]:
        """As the note prints them; without `keys` all of them but those that it is to `leave` out."""
        chosen: Sequence[str] = [*keys] or [
            one.key for one in self.table(name).columns if one.key not in leave
        ]
        return [self.column(name, key) for key in chosen]

    def numeric(
        self, caption: Any, name: str, keys: Iterable[str] = (), leave: Collection[str] = (), **first: Any
    ) -> layout.Table:
        """A table of numbers; `first`: how its first column is printed."""
        own, *others = self.columns(name, keys, leave)
        if first:
            key = next(iter(keys), "") or self.table(name).columns[0].key
            own = self.column(name, key, **first)
        return numeric(caption, own, others)

    def of(self, name: str, key: str) -> Column:
        """A column of the results."""
        return self.table(name)[key]

    # --- over the cycle

    def by_positions(
        self, caption: Any, name: str, keys: Iterable[str | layout.Column] = (), joined: bool = False
    ) -> layout.Table:
        """A table by positions: their numbers, then its columns by their keys, or others that are ready; without `keys`
        all of them but the angle turned. `joined`: positions alike that follow one another stand in one row."""
        chosen = [*keys] or [
            one.key for one in self.table(name).columns if one.key not in ("position", "phi")
        ]
        columns = [self.column(name, one) if isinstance(one, str) else one for one in chosen]
        first = self.page.positions(self.table(name))
        if joined:
            first, columns = layout.joined(first, columns)
        return numeric(caption, first, columns)

    def over_cycle(self, name: str, of: Iterable[str | Line], positions: int = 0, join: bool = True) -> Graph:
        """Columns of a table over the angle turned, each in a panel of its own, or lines in theirs; an axis has letter
        and unit of the first in its panel. `positions`: how many are numbered."""
        table = self.table(name)
        lines = [
            Line(table[one], panel=panel, extremes=None) if isinstance(one, str) else one
            for panel, one in enumerate(of)
        ]
        return cycle_lines(lines, table["phi"], self.page.tr, positions, join)


class ChapterView(BookView):
    """`s`: the single numbers of the chapter, with the formulas that compute them; `tables`: of the results."""

    def __init__(self, page: Page, s: Sheet, tables: Iterable[Table] = (), prefix: str | None = None):
        super().__init__(page, Book.of(tables), s.PREFIX if prefix is None else prefix)
        self.s = s

    def value(self, key: str) -> Value:
        return self.s[key]

    def knows(self, key: str) -> bool:
        return key in self.s

    def formula(self, key: str, **form: Any) -> Formula:
        return self.s.formula(key, **form)

    def formulas(self, *keys: str) -> list[Formula]:
        """Those of the numbers that this variant computes by one."""
        return [self.formula(key) for key in keys if self.s.has_formula(key)]

    def of_each_kind(self, formulas: Iterable[Formula]) -> list[Formula]:
        """All of them, or the first of each kind; tables have the numbers of the others."""
        if self.page.note.every:
            return [*formulas]
        first, others = parted(formulas)
        self.page.leaves_out(others)
        return first
