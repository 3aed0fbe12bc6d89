"""Sheets of paper: on which one a picture stands at its own size.

A picture that the text of a page holds stands in the text. One that its page holds sideways has such a page in the
text, which goes on before and behind it. A larger one has a sheet of its own in the appendix of the drawings: the
smallest of A3, three A4 in a row, A2 and A1, lying or standing, that holds it. The room
comes from the margins of the note's profile; the size of a picture never does.
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import NamedTuple

from tmm_report.profiles import Margins, Text, shipped
from tmm_report.records import dataclass

CAPTION = 15.0  # mm: what a caption takes of a sheet
HEAD = 22.0  # mm: what the heading of their appendix takes of the first of them
BELOW = 29.0  # mm: what the caption of a picture in the text takes, and the text that leads to it
SIZES = (
    ("a3", 420.0, 297.0), ("a3tall", 297.0, 420.0), ("a4x3", 630.0, 297.0), ("a2", 594.0, 420.0),
    ("a2tall", 420.0, 594.0), ("a1", 841.0, 594.0), ("a1tall", 594.0, 841.0),
)  # fmt: skip
TABLE = 0.881  # letters of a table, in sizes of those of the text
POINT = 25.4 / 72  # mm
NUMBERED = 21.1  # mm: what the number of a formula takes on both sides of it


class Sheet(NamedTuple):
    """`name` is its class in the style sheet; width and height of the paper, of what may be printed on, and the margins
    to the left of it and above, mm."""

    name: str
    wide: float
    tall: float
    field: tuple[float, float]
    corner: tuple[float, float]

    def holds(self, size: tuple[float, float]) -> bool:
        """Whether a picture of this width and height, mm, stands on it with its caption."""
        return _holds((self.field[0], self.field[1] - CAPTION), size)

    @property
    def margins(self) -> tuple[float, float, float, float]:
        """Above, right, below, left, mm."""
        left, above = self.corner
        return above, self.wide - left - self.field[0], self.tall - above - self.field[1], left


@dataclass(frozen=True)
class Paper:
    """The paper of a note and the letters on it; `most`: the longest side that its format takes, mm."""

    margins: Margins
    text: Text
    most: float = math.inf

    @property
    def width(self) -> float:
        """Of the text, mm."""
        return self.margins.left_of_a4[0]

    @property
    def height(self) -> float:
        """Of the text, mm."""
        return self.margins.left_of_a4[1]

    @property
    def page(self) -> tuple[float, float]:
        """The largest picture in the text of a page, mm."""
        return self.width, self.height - BELOW

    @property
    def em(self) -> float:
        """Of a table's letters, mm."""
        return TABLE * self.text.size * POINT

    @property
    def padding(self) -> float:
        """Both margins of a table's cell and its line, mm."""
        return 0.3 * self.text.size

    @property
    def line(self) -> float:
        """What a line of formulas holds beside its number, in sizes of its letters."""
        return (self.width - NUMBERED) / (self.text.size * POINT)

    @property
    def sideways(self) -> tuple[float, float]:
        """The largest picture that stands sideways on a page, mm: width along the page, height across it."""
        return self.height, self.width - CAPTION

    @cached_property
    def sheets(self) -> tuple[Sheet, ...]:
        """From the smallest on."""
        return tuple(self._standing(*size) for size in SIZES)

    def _standing(self, name: str, wide: float, tall: float) -> Sheet:
        one, wide, tall = self.margins, min(wide, self.most), min(tall, self.most)
        field = (wide - one.left - one.right, tall - one.top - one.bottom)
        return Sheet(name, wide, tall, field, (one.left, one.top))

    def fits(self, size: tuple[float, float]) -> bool:
        """Whether a picture of this width and height, mm, stands in the text of a page."""
        return _holds(self.page, size)

    def turns(self, size: tuple[float, float]) -> bool:
        """Whether it stands sideways on a page."""
        return not self.fits(size) and _holds(self.sideways, size)

    def sheet_of(self, size: tuple[float, float]) -> Sheet | None:
        """The sheet of a picture of this width and height, mm; None: it stands on a page of the text. What no
        sheet holds is put on the one that reduces it least."""
        if self.fits(size) or self.turns(size):
            return None
        held = next((sheet for sheet in self.sheets if sheet.holds(size)), None)
        return held or max(self.sheets[-2:], key=lambda sheet: _share(sheet, size))

    def percent(self, size: tuple[float, float]) -> int:
        """To how many per cent of its size a picture is reduced; 100: not at all, as the largest sheet holds it."""
        sheet = self.sheet_of(size)
        return 100 if sheet is None or sheet.holds(size) else int(100 * _share(sheet, size))


USUAL = Paper(shipped().margins, shipped().text)


def _holds(room: tuple[float, float], size: tuple[float, float]) -> bool:
    return size[0] <= room[0] + 0.01 and size[1] <= room[1] + 0.01


def _share(sheet: Sheet, size: tuple[float, float]) -> float:
    return min(sheet.field[0] / size[0], (sheet.field[1] - CAPTION) / size[1])
