"""What a note says, gathered while it is written: its formulas and where each number of a table stands.

heard = listen(lambda page: list(note.parts(results, page)), title, Translator("ru"))
heard.formulas[0]      # the formula itself, its number and the section in which it stands
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import field
from typing import Any, NamedTuple

from markupsafe import Markup

from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.i18n import Translator
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula, VectorEquation
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.written import Equation
from tmm_report.records import dataclass
from tmm_report.report import render
from tmm_report.report.formats import Html, Mathematics
from tmm_report.report.numbering import Numbering, Place, Section
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Words
from tmm_report.report.part import Part, Title
from tmm_report.report.plain import Item


class Spoken(NamedTuple):
    """A formula of the note, its number there ("" of one without), the section it stands in."""

    item: Item
    number: str
    section: Section


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


def listen(make: Callable[[Page], Sequence[Part]], title: Title, tr: Translator) -> Heard:
    """What the note of these parts says. No picture is drawn."""
    heard = Heard()

    def parts(page: Page) -> Sequence[Part]:
        page.numbering = Counted()
        page.form = Listener(page.numbering, heard)
        return make(page)

    render(parts, title, "html", tr)
    return heard


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
        """The section that is being written, its title as plain text."""
        last = self.numbering.sections[-1]
        return last._replace(title=Markup(last.title).striptags())

    def picture(self, picture: Drawing | Graph, anchor: str, caption: object = "") -> Markup:
        return Markup("")
