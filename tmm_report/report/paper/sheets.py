"""Sheets of paper: on which one a picture stands at its own size.

A picture that the text of a page holds stands in the text. A larger one has a sheet of its own, turned with its
caption: the smallest of A4 on its side, A3, three A4 in a row, A2 and A1, lying or standing, that holds it.
"""

from __future__ import annotations

from typing import NamedTuple

PAGE = (165.0, 228.0)  # mm: the largest picture in the text of a page; its caption stands below
CAPTION = 15.0  # mm: what a caption takes of a sheet


class Sheet(NamedTuple):
    """`name` is its class in the style sheet; width and height of the paper, of what may be printed on, and the margins
    to the left of it and above, mm."""

    name: str
    wide: float
    tall: float
    field: tuple[float, float]
    corner: tuple[float, float] = (30.0, 20.0)

    def holds(self, size: tuple[float, float]) -> bool:
        """Whether a picture of this width and height, mm, stands on it with its caption."""
        return _holds((self.field[0], self.field[1] - CAPTION), size)


A4 = Sheet(
    "a4", 297.0, 210.0, (261.0, 165.0), (18.0, 30.0)
)  # the page turned, its margin for the binding above
SHEETS = (
    A4,
    Sheet("a3", 420.0, 297.0, (375.0, 257.0)),
    Sheet("a3tall", 297.0, 420.0, (252.0, 380.0)),
    Sheet("a4x3", 630.0, 297.0, (585.0, 257.0)),
    Sheet("a2", 594.0, 420.0, (549.0, 380.0)),
    Sheet("a2tall", 420.0, 594.0, (375.0, 554.0)),
    Sheet("a1", 841.0, 594.0, (796.0, 554.0)),
    Sheet("a1tall", 594.0, 841.0, (549.0, 801.0)),
)


def fits(size: tuple[float, float]) -> bool:
    """Whether a picture of this width and height, mm, stands in the text of a page."""
    return _holds(PAGE, size)


def sheet_of(size: tuple[float, float]) -> Sheet | None:
    """The sheet of a picture of this width and height, mm; None: it stands in the text. What no sheet holds is put
    on the one that reduces it least."""
    if fits(size):
        return None
    held = next((sheet for sheet in SHEETS if sheet.holds(size)), None)
    return held or max(SHEETS[-2:], key=lambda sheet: _share(sheet, size))


def percent(size: tuple[float, float]) -> int:
    """To how many per cent of its size a picture is reduced; 100: not at all, as the largest sheet holds it."""
    sheet = sheet_of(size)
    return 100 if sheet is None or sheet.holds(size) else int(100 * _share(sheet, size))


def _holds(room: tuple[float, float], size: tuple[float, float]) -> bool:
    return size[0] <= room[0] + 0.01 and size[1] <= room[1] + 0.01


def _share(sheet: Sheet, size: tuple[float, float]) -> float:
    return min(sheet.field[0] / size[0], (sheet.field[1] - CAPTION) / size[1])
