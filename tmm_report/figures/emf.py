"""Drawings as enhanced metafiles (EMF), the vector pictures that word processors have long shown and printed.

    emf(drawing)        # bytes: of the drawing's own size, the same of the same drawing

Letters are outlines, those of `raster`, so that a picture needs no font; dashes are cut here, for LibreOffice draws
those of a pen's own as a whole line. Source: Microsoft, [MS-EMF], Enhanced Metafile Format.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from tmm_report.figures.drawing import Drawing, Text, near_origin
from tmm_report.figures.raster import CLOSE, LINE, MOVE, Array, Ink, inked, rgb
from tmm_report.figures.thinning import thinned

UNITS = 200  # a millimetre: of places and thicknesses
_QUADRATIC = 3  # a vertex of a curve with one handle, as matplotlib counts it; 4: with two
# kinds of records
_HEADER, _BEZIER_TO, _LINE_TO, _EOF, _FILL_MODE, _MOVE_TO = 1, 5, 6, 14, 19, 27
_SELECT, _BRUSH, _BEGIN, _END, _CLOSE, _FILL, _FILL_AND_STROKE, _STROKE, _PEN = (
    37,
    39,
    59,
    60,
    61,
    62,
    63,
    64,
    95,
)
_NO_PEN, _NO_BRUSH = 0x80000008, 0x80000005
_ROUND_PEN = 0x10000  # geometric: its width is one of the drawing; round ends and joins are 0
_WINDING = 2


def emf(drawing: Drawing) -> bytes:
    """The drawing as a metafile whose frame is the drawing's box."""
    drawing = near_origin(drawing)
    lines = [item for item in thinned(drawing.items) if not isinstance(item, Text)]
    texts = [item for item in drawing.items if isinstance(item, Text)]
    page = _Page(drawing.box)
    for item in (*lines, *texts):
        for ink in inked(item):
            page.draw(ink)
    return page.written()


class _Page:
    """Records of one picture; x to the right, y down from the upper left corner of the box, mm."""

    def __init__(self, box: tuple[float, float, float, float]):
        self.left, _, _, self.top = box
        self.size = box[2] - box[0], box[3] - box[1]
        self.records = [_record(_FILL_MODE, "I", _WINDING)]
        self.tools: dict[bytes, int] = {}
        self.selected: dict[int, int] = {}

    def draw(self, ink: Ink) -> None:
        places, codes = ink.outline.places, ink.outline.codes
        if not len(codes):
            return
        if ink.fill:
            whole = ink.pen is not None and not ink.pen.dash
            self._select(_PEN, self._pen(ink) if whole else _NO_PEN)
            self._select(_BRUSH, self._tool(_BRUSH, "III", 0, _colour(ink.fill, ink.opacity), 0))
            self._path(places, codes, _FILL_AND_STROKE if whole else _FILL)
            if whole:
                return
        if ink.pen is not None:
            self._select(_PEN, self._pen(ink))
            self._select(_BRUSH, _NO_BRUSH)
            for stroke in dashed(places, codes, ink.pen.dash) if ink.pen.dash else [(places, codes)]:
                self._path(*stroke, _STROKE)

    def _pen(self, ink: Ink) -> int:
        assert ink.pen is not None
        wide = max(1, round(ink.pen.width * UNITS))
        return self._tool(
            _PEN, "9I", 0, 0, 0, 0, _ROUND_PEN, wide, 0, _colour(ink.pen.colour), 0, more=b"\0" * 4
        )

    def _tool(self, kind: int, form: str, *values: int, more: bytes = b"") -> int:
        """The number of a pen or brush, which is made where it is first asked for."""
        made = struct.pack(f"<{form}", *values) + more
        if made not in self.tools:
            self.tools[made] = len(self.tools) + 1
            self.records.append(_record(kind, "I", self.tools[made], more=made))
        return self.tools[made]

    def _select(self, kind: int, number: int) -> None:
        if self.selected.get(kind) != number:
            self.selected[kind] = number
            self.records.append(_record(_SELECT, "I", number))

    def _path(self, places: Array, codes: Array, how: int) -> None:
        across = np.rint((places.real - self.left) * UNITS).astype("<i4")
        down = np.rint((self.top - places.imag) * UNITS).astype("<i4")
        points = np.column_stack([across, down])
        self.records.append(_record(_BEGIN))
        for kind, at, end in _runs(codes):
            if kind == MOVE:
                self.records.append(_record(_MOVE_TO, "", more=points[end - 1].tobytes()))
            elif kind == CLOSE:
                self.records.append(_record(_CLOSE))
            elif kind == LINE:
                self.records.append(_points(_LINE_TO, points[at:end]))
            else:
                exact = np.column_stack([(places.real - self.left), (self.top - places.imag)]) * UNITS
                curve = exact[at:end] if kind != _QUADRATIC else _cubic(exact[at - 1 : end])
                self.records.append(_points(_BEZIER_TO, np.rint(curve).astype("<i4")))
        self.records += [_record(_END), _record(how, "4i", *self._bounds())]

    def _bounds(self) -> tuple[int, int, int, int]:
        return 0, 0, round(self.size[0] * UNITS), round(self.size[1] * UNITS)

    def written(self) -> bytes:
        """The file. The device is one of so many dots that a dot is a unit."""
        body = b"".join([*self.records, _record(_EOF, "3I", 0, 16, 20)])
        frame = (0, 0, *(round(100 * side) for side in self.size))
        head = struct.pack(
            "<2I4i4i4I2H3I4i3I2i",
            _HEADER, 108, *self._bounds(), *frame, 0x464D4520, 0x10000, 108 + len(body), len(self.records) + 2,
            len(self.tools) + 1, 0, 0, 0, 0, 1000 * UNITS, 1000 * UNITS, 1000, 1000, 0, 0, 0, 1_000_000, 1_000_000,
        )  # fmt: skip
        return head + body


def _record(kind: int, form: str = "", *values: int, more: bytes = b"") -> bytes:
    body = struct.pack(f"<{form}", *values) + more
    return struct.pack("<2I", kind, 8 + len(body)) + body


def _points(kind: int, points: Array) -> bytes:
    low, high = points.min(axis=0), points.max(axis=0)
    return _record(
        kind, "4iI", *map(int, (*low, *high)), len(points), more=np.ascontiguousarray(points).tobytes()
    )


def _runs(codes: Array) -> Iterator[tuple[int, int, int]]:
    """Neighbouring vertices with which the same is done: what, from, to."""
    ends = [0, *(np.flatnonzero(np.diff(codes)) + 1), len(codes)]
    for at, end in pairwise(ends):
        yield int(codes[at]), int(at), int(end)


def _cubic(points: Array) -> Array:
    """Curves of one handle each, (1 + 2n, 2) from the place before them, as curves of two, (3n, 2)."""
    start, handle, end = points[0:-1:2], points[1::2], points[2::2]
    first, second = start + 2 / 3 * (handle - start), end + 2 / 3 * (handle - end)
    return np.stack([first, second, end], axis=1).reshape(-1, 2)


def _colour(name: str, opacity: float = 1.0) -> int:
    """0x00bbggrr; what lets the paper through is as light as white paper makes it."""
    red, green, blue, share = rgb(name, opacity)
    shown = [round(255 * (1 - share * (1 - part))) for part in (red, green, blue)]
    return shown[0] | shown[1] << 8 | shown[2] << 16


def dashed(places: Array, codes: Array, dash: Sequence[float]) -> Iterator[tuple[Array, Array]]:
    """Polylines of an outline cut into dashes: lengths of ink and gap by turns, mm, each stroke from its beginning."""
    starts = [*np.flatnonzero(codes == MOVE), len(codes)]
    for at, end in pairwise(starts):
        stroke = places[at:end]
        along = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(stroke)))])
        marks = _marks(along[-1], dash)
        inks = [_between(stroke, along, *pair) for pair in zip(marks[::2], marks[1::2], strict=True)]
        if not inks:
            continue
        heads = [np.r_[np.uint8(MOVE), np.full(len(ink) - 1, LINE, np.uint8)] for ink in inks]
        yield np.concatenate(inks), np.concatenate(heads)


def _marks(length: float, dash: Sequence[float]) -> list[float]:
    """Where dashes begin and end, by turns."""
    turns = int(length // sum(dash)) + 1
    ends = np.concatenate([[0.0], np.cumsum(np.tile(dash, turns))])
    known = [float(end) for end in ends if end < length]
    return [*known, length] if len(known) % 2 else known


def _between(stroke: Array, along: Array, start: float, end: float) -> Array:
    """The part of a polyline between two lengths along it."""
    inner = stroke[(along > start) & (along < end)]
    ends = np.interp([start, end], along, stroke.real) + 1j * np.interp([start, end], along, stroke.imag)
    return np.concatenate([ends[:1], inner, ends[1:]])
