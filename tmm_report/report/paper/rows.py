"""Figures that wait for their place: side by side where the paper is wide enough, one above another on one sheet."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import field
from typing import Generic, NamedTuple, TypeVar

from markupsafe import Markup

from tmm_report.records import dataclass
from tmm_report.report.paper.sheets import CAPTION, USUAL, Paper, Sheet

NARROW = 40.0  # mm: a caption is not set narrower
GAP = 4.0  # mm between figures side by side
LINE = 10.0  # mm: a caption that stands beside another has more lines
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
    """Figures side by side, on a `sheet` or in the text."""

    sheet: Sheet | None
    figures: tuple[Kept[T], ...]

    @property
    def tall(self) -> float:
        """With the caption, mm."""
        return max(one.size[1] for one in self.figures) + CAPTION + (LINE if len(self.figures) > 1 else 0.0)

    @property
    def wide(self) -> float:
        return sum(one.wide for one in self.figures) + GAP * (len(self.figures) - 1)


@dataclass
class Waiting(Generic[T]):
    """What a format keeps for the next heading. `gathers`: so all figures, not only those that must wait."""

    paper: Paper = USUAL
    waiting: list[Kept[T]] = field(default_factory=list)
    gathers: bool = False

    def block(self, rows: Sequence[Row[T]]) -> Markup:
        """The markup of rows that stand together."""
        raise NotImplementedError

    def gather(self) -> Markup:
        """From here on figures wait for the next heading, so that they share the paper."""
        self.gathers = True
        return Markup("")

    def laid(self) -> Markup:
        """The figures that wait, side by side and on sheets."""
        blocks, self.waiting = laid(self.waiting, self.paper), []
        return Markup("".join(map(self.block, blocks)))

    def due(self) -> Markup:
        """The same at a heading: those behind it do not wait."""
        self.gathers = False
        return self.laid()

    def flowing(self) -> Markup:
        """At a heading that the text goes on with."""
        return self.due()

    def apart(self, write: Callable[[], Markup]) -> Markup:
        """What stands elsewhere, in an appendix, with the sheets of its own figures."""
        before, self.waiting, self.gathers = (self.waiting, self.gathers), [], False
        try:
            return write() + self.due()
        finally:
            self.waiting, self.gathers = before


def laid(waiting: Iterable[Kept[T]], paper: Paper) -> list[list[Row[T]]]:
    """The figures in their order: rows, those of a list on one sheet; a row in the text has a list of its own."""
    blocks: list[list[Row[T]]] = []
    for kept in waiting:
        last = blocks[-1][-1] if blocks else None
        row = None if last is None else _beside(last, kept, paper)
        if row is not None:
            blocks[-1][-1] = row
        else:
            row = Row(paper.sheet_of(kept.size), (kept,))
            if blocks and (joined := _on_one_sheet(blocks[-1], row)):
                blocks[-1] = joined
                continue
            blocks.append([row])
    return blocks


def _common(one: Sheet | None, other: Sheet | None) -> Sheet | None:
    return one or other if None in (one, other) or one == other else None


def _beside(row: Row[T], kept: Kept[T], paper: Paper) -> Row[T] | None:
    """The row with a figure more, in the text; None: there is no room for it."""
    tall = max(kept.size[1], *(one.size[1] for one in row.figures))
    if row.sheet or paper.sheet_of(kept.size) or tall > TALL:
        return None
    wider = Row(None, (*row.figures, kept))
    return wider if wider.wide <= paper.width else None


def _on_one_sheet(rows: list[Row[T]], row: Row[T]) -> list[Row[T]] | None:
    """The rows of a sheet with one more below; None: no sheet holds them."""
    sheet = _common(rows[0].sheet, row.sheet)
    if sheet is None or sum(one.tall for one in (*rows, row)) > sheet.field[1]:
        return None
    return [one._replace(sheet=sheet) for one in (*rows, row)]
