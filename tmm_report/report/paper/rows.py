"""Figures that wait for their place: side by side where the text is wide enough, or one above another, sideways on a
page or on a sheet of their own."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import field
from typing import Any, Generic, NamedTuple, TypeVar

from markupsafe import Markup

from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.records import dataclass
from tmm_report.report.paper.sheets import CAPTION, HEAD, USUAL, Paper, Sheet

NARROW = 40.0  # mm: a caption is not set narrower
GAP = 4.0  # mm between figures side by side
TALL = 200.0  # mm: a picture that leaves no room for such a caption

T = TypeVar("T")


class Kept(NamedTuple, Generic[T]):
    """A figure that waits: what makes it, and the size of its picture, mm."""

    figure: T
    size: tuple[float, float]

    @property
    def wide(self) -> float:
        return max(self.size[0], NARROW)


class Row(NamedTuple, Generic[T]):
    """Figures side by side in the text, or, `sideways`, one above another on a page."""

    figures: tuple[Kept[T], ...]
    sideways: bool = False

    def and_one(self, kept: Kept[T], paper: Paper) -> Row[T] | None:
        """With one more; None: there is no room for it."""
        more = self._replace(figures=(*self.figures, kept))
        if self.sideways:
            fits = kept.size[0] <= paper.sideways[0] and _stacked(more.figures) <= paper.width
        else:
            short = max(one.size[1] for one in more.figures) <= TALL
            fits = short and paper.fits(kept.size) and more.wide <= paper.width
        return more if fits else None

    @property
    def wide(self) -> float:
        return sum(one.wide for one in self.figures) + GAP * (len(self.figures) - 1)


class Drawings(NamedTuple, Generic[T]):
    """Figures one above another on a sheet of their own."""

    sheet: Sheet
    figures: tuple[Kept[T], ...]

    def and_below(self, kept: Kept[T]) -> Drawings[T] | None:
        """With one more; None: the sheet does not hold it."""
        more = Drawings(self.sheet, (*self.figures, kept))
        wide, tall = self.sheet.field
        return more if kept.size[0] <= wide and _stacked(more.figures) <= tall else None


def _stacked(figures: Iterable[Kept[Any]]) -> float:
    """How tall figures are one above another, mm."""
    return sum(one.size[1] + CAPTION for one in figures)


@dataclass
class Waiting(Generic[T]):
    """What a format keeps: `waiting`: for the next heading, so that they share the paper, all if it `gathers`, else
    what stands sideways and what is behind it; `drawings`: for their appendix, what no page of the text holds."""

    most = math.inf  # mm: the longest side of a sheet of paper
    paper: Paper = USUAL
    waiting: list[Kept[T]] = field(default_factory=list)
    gathers: bool = False
    drawings: list[Kept[T]] = field(default_factory=list)

    def alone(self, figure: T) -> Markup:
        """The markup of a figure in the text."""
        raise NotImplementedError

    def drawn(self, figure: T) -> Markup:
        """Of one among others on a page or sheet of their own."""
        return self.alone(figure)

    def in_row(self, row: Row[T]) -> Markup:
        """Of figures side by side."""
        raise NotImplementedError

    def sideways(self, figures: Markup) -> Markup:
        """Of a page on which they stand so."""
        raise NotImplementedError

    def sheet(self, sheet: Sheet, figures: Markup) -> Markup:
        """Of a sheet with them."""
        raise NotImplementedError

    def placed(self, figure: T, picture: Drawing | Graph) -> Markup:
        """A figure where it comes, if it stands there."""
        return Markup("") if self.kept(figure, picture) else self.alone(figure)

    def gather(self) -> Markup:
        """From here on all figures wait for the next heading."""
        self.gathers = True
        return Markup("")

    def due(self) -> Markup:
        """At a heading: the figures that wait; those behind it do not wait."""
        rows, self.waiting, self.gathers = together(self.waiting, self.paper), [], False
        return Markup("").join(map(self._laid, rows))

    def _laid(self, row: Row[T]) -> Markup:
        if row.sideways:
            return self.sideways(self._drawn(row.figures))
        return self.in_row(row) if len(row.figures) > 1 else self.alone(row.figures[0].figure)

    def _drawn(self, figures: Iterable[Kept[T]]) -> Markup:
        return Markup("").join(self.drawn(one.figure) for one in figures)

    def kept(self, figure: T, picture: Drawing | Graph) -> bool:
        """Whether a figure does not stand where it comes, but is kept."""
        if self.paper.sheet_of(picture.size):
            self.drawings.append(Kept(figure, self.room(picture)))
        elif self.gathers or self.waiting or self.paper.turns(picture.size):
            self.waiting.append(Kept(figure, picture.size))
        else:
            return False
        return True

    def room(self, picture: Drawing | Graph) -> tuple[float, float]:
        """What a picture takes of its paper, mm: the first of the drawings with the heading above it."""
        wide, tall = picture.size
        first = not self.drawings and self.paper.sheet_of(picture.size)
        return (wide, tall + HEAD) if first else (wide, tall)

    def percent(self, picture: Drawing | Graph) -> int:
        """To how many per cent the next picture is reduced, as no sheet holds it; 100: it is not."""
        return self.paper.percent(self.room(picture))

    def sheets(self, head: Markup) -> Markup:
        """The drawings on their sheets, `head` on the first of them."""
        found = [(one.sheet, self._drawn(one.figures)) for one in on_sheets(self.drawings, self.paper)]
        return Markup("").join(
            self.sheet(sheet, figures if k else head + figures) for k, (sheet, figures) in enumerate(found)
        )

    def apart(self, write: Callable[[], Markup]) -> Markup:
        """What stands elsewhere, in an appendix, with the figures of its own that wait."""
        before, self.waiting, self.gathers = (self.waiting, self.gathers), [], False
        try:
            return write() + self.due()
        finally:
            self.waiting, self.gathers = before


class Ready(Waiting[Markup]):
    """Figures that wait as their markup."""

    def alone(self, figure: Markup) -> Markup:
        return figure


def together(waiting: Iterable[Kept[T]], paper: Paper) -> list[Row[T]]:
    """Figures that pages of the text hold, in their order, as many together as there is room for."""
    rows: list[Row[T]] = []
    for kept in waiting:
        more = rows[-1].and_one(kept, paper) if rows else None
        if more:
            rows[-1] = more
        else:
            rows.append(Row((kept,), paper.turns(kept.size)))
    return rows


def on_sheets(drawings: Iterable[Kept[T]], paper: Paper) -> list[Drawings[T]]:
    """Drawings in their order on the smallest sheets that hold them, on the last one while that has room."""
    found: list[Drawings[T]] = []
    for kept in drawings:
        more = found[-1].and_below(kept) if found else None
        sheet = paper.sheet_of(kept.size)
        if more:
            found[-1] = more
        elif sheet:
            found.append(Drawings(sheet, (kept,)))
    return found
