"""How numbers come about as a click tells it: the sentence of their chapter's ways, what is worked out by them, and
with which numbers they start, as `explain` has them.

Of a table by positions what is worked out is packed once, with the numbers of the position that the note writes out;
with which numbers it starts in another one the script finds in the tables of the page.
"""

from __future__ import annotations

from collections.abc import Container, Iterator
from dataclasses import field
from functools import cache, cached_property
from typing import Any, NamedTuple

from tmm_report.course import Results, room, with_data
from tmm_report.problems import Message
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Book, Column, Table, Value
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.text import number
from tmm_report.quantity.ways import Input, Known, Line, OwnWays, Way, by_kind, formula, telling
from tmm_report.quantity.written import variables
from tmm_report.records import dataclass
from tmm_report.report.formats import Html
from tmm_report.report.heard import Spoken
from tmm_report.report.page import Page
from tmm_report.report.plain import Plain, gap, said, text
from tmm_report.results import tables, values

DIGITS = 5
MOST = 24  # numbers that a way starts with
Start = str | tuple[str, str]  # name of a column by rows; or sign with meaning, and number


class _Told(NamedTuple):
    """A way; the lines that are worked out by it; with what it starts."""

    way: Way
    worked: list[str]
    starts: list[Start]

    @property
    def says(self) -> bool:
        """Whether it says more than that there is a method."""
        return bool(self.worked or self.starts) or self.way.ends


def told(results: Results, page: Page, shown: Container[str]) -> dict[str, Any]:
    """`ways`, `meanings`: name of a number, "key" or, where tables differ in it, "table.key" -> the place of its text
    among `texts`, or the places of those of its rows; of the keys and names `shown` on the page. `worked`, by
    "table.key" or the key of a single number: the places of the lines at position `sample`; `starts`: names of columns,
    or the places of a sign and a number."""
    teller = _Teller(page, Plain(page.tr), Book.of(tables(results), values(results)), _sample(results))
    for chapter, found in with_data(results):
        quantities = room(chapter, "quantities")
        for table in quantities.tables(found):
            if not table.name.endswith("_diagram"):  # no cell of the page is of these
                whole = table.name.endswith("_table")  # comparisons ask for these, too
                for column in table.columns:
                    if f"{table.name}.{column.key}" in shown or (whole and column.key in shown):
                        teller.tell(chapter, found, table, column)
        for value in quantities.values(found):
            if value.key in shown:
                teller.tell(chapter, found, None, value)
    left = list(teller.left())
    return {"sample": teller.sample, "texts": list(teller.texts), "left": left, **teller.found}


def _sample(results: Results) -> int:
    return results.lever.sample if results.lever is not None else 0


@dataclass(frozen=True, eq=False)
class _Teller:
    page: Page
    plain: Plain
    book: Book
    sample: int
    texts: dict[str, int] = field(default_factory=dict)
    found: dict[str, dict[str, Any]] = field(
        default_factory=lambda: {"ways": {}, "meanings": {}, "worked": {}, "starts": {}}
    )

    named: set[str] = field(default_factory=set)  # columns that have their meaning among the texts
    written: dict[int, tuple[Any, str]] = field(default_factory=dict)  # by identity: many numbers share them

    @cached_property
    def defined(self) -> set[str]:
        """Keys of the numbers that have a formula."""
        assert isinstance(self.page.form, Html)
        left = (item.ref for item, *_ in self._left() if item.ref is not None)
        return {ref.key for ref in (*self.page.form.defined, *left)}

    def _left(self) -> Iterator[tuple[Formula, Spoken]]:
        """The formulas that a note of this depth leaves out."""
        for one in self.page.aside.formulas if self.page.aside is not None else ():
            if isinstance(one.item, Formula) and one.item.ref is not None:
                yield one.item, one

    def left(self) -> Iterator[list[Any]]:
        """Of each of them its text and that of its section; where the numbers in it stand in the results, its own as
        the last: key, row and table; and so the result of the formula of the page behind which it belongs."""
        for item, spoken in self._left():
            own = _mark(item.ref)
            known = [_mark(var.ref) for var in variables(item.expression) if var.ref is not None]
            marks = [*(one for one in known if one != own), own]
            yield [self.put(self._line(item)), self.put(spoken.section.title), marks, _mark(spoken.behind)]

    def put(self, words: str) -> int:
        return self.texts.setdefault(words, len(self.texts))

    def tell(self, chapter: str, found: Any, table: Table | None, of: Column | Value) -> None:
        key, name = of.key, of.key if table is None else f"{table.name}.{of.key}"
        self._mean(name, of)
        one = self._told(chapter, found, table, of)
        if one is None:
            return
        self._keep("ways", key, name, self.page.tr.gettext(one.way.text) if one.way.text else "")
        if one.worked:
            self.found["worked"][name] = [self.put(line) for line in one.worked]
        if one.starts:
            self.found["starts"][name] = [
                s if isinstance(s, str) else [self.put(x) for x in s] for s in one.starts
            ]

    def _keep(self, kind: str, key: str, name: str, words: str) -> None:
        """By the key alone, if no other table has another text for it."""
        if words and self.found[kind].setdefault(key, self.put(words)) != self.put(words):
            self.found[kind][name] = self.put(words)

    def _mean(self, name: str, of: Column | Value) -> None:
        """What a number is; where the rows name it, of each row."""
        if isinstance(of, Column) and len(set(of.symbols)) > 1:
            rows = [self._named(of.meaning_of(k), symbol) for k, symbol in enumerate(of.symbols)]
            self.found["meanings"][name] = [self.put(one) for one in rows]
        else:
            self._keep("meanings", of.key, name, self._named(of.quantity.meaning, of.quantity.symbol))

    def _named(self, meaning: Message, symbol: Symbol | None) -> str:
        words = said(meaning, self.page.tr, self.plain)
        return words if symbol is None else f"{self.plain.symbol(symbol)} – {words}"

    def _told(self, chapter: str, found: Any, table: Table | None, of: Column | Value) -> _Told | None:
        """By the first way that says with which numbers, else by the first; None of a single number that formulas of
        the note tell."""
        name = of.key if table is None else f"{table.name}.{of.key}"
        kind = by_kind(table, of, of.key) if isinstance(of, Column) else None
        own = _own_ways(chapter)
        ways = [*own.of(name), *([(kind, ())] if kind is not None else [])]
        if table is None and of.key in self.defined and not any(way.beside for way, _ in ways):
            return None
        return telling(self._one(own, way, parts, found, table, of) for way, parts in ways)

    def _one(
        self,
        own: OwnWays,
        way: Way,
        parts: tuple[str, ...],
        found: Any,
        table: Table | None,
        of: Column | Value,
    ) -> _Told:
        row = None if table is None else _row(table, self.sample)
        known = _Asking(self.book, table, row, parts, of.key, found)
        lines: list[Line] = []
        if table is None or "position" in table or len(table) == 1:  # else each row has its own
            lines += way.worked(found, known) if way.worked is not None else ()
            unit = of.unit_of(known.row or 0) if isinstance(of, Column) else of.unit
            lines += formula(way, known, of.quantity.symbol or Symbol(of.key), unit)
        list(known.inputs(own.begins(way, known)))
        whole = f"{table.name}.{of.key}" if table is not None else of.key
        starts = [self._start(*one) for name, one in known.asked.items() if name != whole]
        return _Told(way, list(dict.fromkeys(map(self._line, lines))), starts[:MOST])

    def _line(self, line: Line) -> str:
        if id(line) not in self.written:
            self.written[id(line)] = line, self._written(line)
        return self.written[id(line)][1]

    def _written(self, line: Line) -> str:
        match line:
            case Message():
                return line.render(self.page.tr.gettext)
            case Input():
                named = self.plain.symbol(line.symbol) if line.symbol is not None else line.quantity.key
                between = ": " if isinstance(line.number, str) else " = "
                return f"{named}{between}{self._number(line)}"
            case _:
                return text(line, self.page.tr, self.plain)

    def _start(self, column: str | None, one: Input) -> Start:
        if column is not None:
            if column not in self.named:
                self.named.add(column)
                table, _, key = column.rpartition(".")
                self._mean(column, self.book.tables[table][key])
            return column
        of = one.quantity
        if id(of) not in self.written:
            self.written[id(of)] = of, self._named(of.meaning, one.symbol)
        sign = self.written[id(of)][1] if one.symbol is of.symbol else self._named(of.meaning, one.symbol)
        return sign, self._number(one)

    def _number(self, one: Input) -> str:
        if isinstance(one.number, str):
            return one.number
        return number(one.number, DIGITS, self.page.tr.decimal, scale=0.0) + gap(one.unit, self.page.tr)


@dataclass(frozen=True, eq=False)
class _Asking(Known):
    """It keeps what was asked for: name -> the column, where the number is one of the rows, and the number."""

    asked: dict[str, tuple[str | None, Input]] = field(default_factory=dict)

    def _input(self, name: str) -> Input:
        one = super()._input(name)
        table, _, key = name.rpartition(".")
        column = None
        if self.row is not None and self.table is not None and len(self.table) > 1:
            if not table and key in self.table:
                column = f"{self.table.name}.{key}"
            elif table in self.book.tables and len(self.book.tables[table]) > 1:
                column = name
        self.asked.setdefault(column or name, (column, one))
        return one


def _mark(ref: Ref | None) -> list[Any] | None:
    return None if ref is None else [ref.key, ref.row, ref.table]


def _row(table: Table, sample: int) -> int | None:
    """That of position `sample`, where the table has it."""
    if not len(table):
        return None
    at = [int(k) for k in table["position"].values] if "position" in table else []
    return at.index(sample) if sample in at else 0


@cache
def _own_ways(chapter: str) -> OwnWays:
    return OwnWays(room(chapter, "ways").WAYS)
