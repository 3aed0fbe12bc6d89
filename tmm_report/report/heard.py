"""What a note says, gathered while it is written: its formulas and where each number of a table stands; and what a
note of its depth leaves out."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import field
from typing import TYPE_CHECKING, Any, NamedTuple

from markupsafe import Markup

from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.i18n import Translator
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula, VectorEquation
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.written import Equation
from tmm_report.records import dataclass
from tmm_report.report.formats import Html, Mathematics
from tmm_report.report.numbering import Numbering, Place, Section
from tmm_report.report.paper.layout import Cell, Words
from tmm_report.report.plain import Item
from tmm_report.report.sources import Cited
from tmm_report.report.symbol_list import SymbolList

if TYPE_CHECKING:
    from tmm_report.report.page import Page


class Spoken(NamedTuple):
    """A formula of the note, its number ("" of one without), the section it stands in; of one that is left out, the
    result of the formula before it."""

    item: Item
    number: str
    section: Section
    behind: Ref | None = None


class Listed(NamedTuple):
    """A number in a table of the note: the table's number, the section it stands in."""

    ref: Ref
    table: str
    section: Section


@dataclass
class Heard:
    """All formulas of a note and all numbers of its tables, in its order."""

    formulas: list[Spoken] = field(default_factory=list)
    cells: list[Listed] = field(default_factory=list)

    def left_out(self, formulas: Iterable[Formula], page: Page) -> None:
        """Formulas that the section being written has others like."""
        here = section(page.numbering)
        self.formulas += [Spoken(one, "", here, _last(page)) for one in formulas]


def _last(page: Page) -> Ref | None:
    """The result of the last formula that is printed."""
    return page.form.defined[-1] if isinstance(page.form, Html) and page.form.defined else None


def section(numbering: Numbering) -> Section:
    """The section that is being written, its title as plain text."""
    last = numbering.sections[-1]
    return last._replace(title=Markup(last.title).striptags())


def overhear(page: Page, write: Callable[[], Markup]) -> None:
    """What a piece says that the note leaves out, into the page's `aside`; nothing of it is numbered or explained."""
    assert page.aside is not None
    kept, aside = (page.form, page.numbering, page.symbols, page.cited), page.aside
    first, behind = len(aside.formulas), _last(page)
    numbering = Counted(sections=[*page.numbering.sections], scheme=page.numbering.scheme)
    page.form, page.numbering = Listener(numbering, aside), numbering
    page.form.paper = kept[0].paper
    page.symbols, page.cited = SymbolList(), Cited(page.tr.cited)
    try:
        write()
    finally:
        page.form, page.numbering, page.symbols, page.cited = kept
    aside.formulas[first:] = [one._replace(behind=behind) for one in aside.formulas[first:]]


@dataclass
class Counted(Numbering):
    """A numbering that knows what was numbered last, by kinds."""

    last: dict[str, str] = field(default_factory=dict)

    def take(self, kind: str, label: str = "") -> Place:
        place = super().take(kind, label)
        self.last[kind] = place.number
        return place


class Listener(Html):
    """HTML that remembers what is printed."""

    def __init__(self, numbering: Counted, heard: Heard):
        super().__init__()
        self.numbering, self.heard = numbering, heard

    def math(self, item: Mathematics, tr: Translator, display: bool = False) -> Markup:
        if isinstance(item, Formula | VectorEquation | Equation | Definition):
            number = self.numbering.last.pop("formula", "") if display else ""
            self.heard.formulas.append(Spoken(item, number, self._section()))
        return Markup("")

    def cells(self, row: Iterable[Any]) -> Markup:
        for cell in row:
            if isinstance(cell, Cell | Words):
                table = self.numbering.last.get("table", "")
                self.heard.cells.append(Listed(cell.ref, table, self._section()))
        return Markup("")

    def _section(self) -> Section:
        return section(self.numbering)

    def picture(self, picture: Drawing | Graph, anchor: str, caption: object = "") -> Markup:
        return Markup("")
