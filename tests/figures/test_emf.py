"""Metafiles hold the drawings that they were made of, read back record by record ([MS-EMF], 2.3)."""

from __future__ import annotations

import struct
from functools import cache

import numpy as np
import pytest
from conftest import solved

from tmm_report import note
from tmm_report.figures.drawing import (
    DASHED,
    NORMAL,
    THICK,
    Arrow,
    Circle,
    Drawing,
    Path,
    Text,
    line,
    near_origin,
)
from tmm_report.figures.emf import UNITS, dashed, emf
from tmm_report.figures.raster import inked
from tmm_report.figures.thinning import thinned
from tmm_report.i18n import Translator
from tmm_report.report import render
from tmm_report.report.formats import drawing_of

MOVE, LINE_TO, BEZIER_TO, CLOSE, END = 27, 6, 5, 61, 60
CLOSE_TO = 0.5 / UNITS * 1.5  # mm: half a unit across and up


def records(file):
    at = 0
    while at < len(file):
        kind, size = struct.unpack_from("<2I", file, at)
        assert size >= 8 and size % 4 == 0
        yield kind, file[at + 8 : at + size]
        at += size
    assert at == len(file)


def vertices(file, box):
    """The strokes of a metafile, mm: each with how its path ends."""
    strokes = []
    for kind, body in records(file):
        if kind == MOVE:
            strokes.append([body])
        elif kind in (LINE_TO, BEZIER_TO):
            count = struct.unpack_from("<I", body, 16)[0]
            assert len(body) == 20 + 8 * count
            strokes[-1].append(body[20:])
    points = [np.frombuffer(b"".join(stroke), "<i4").reshape(-1, 2) / UNITS for stroke in strokes]
    return [box[0] + one[:, 0] + 1j * (box[3] - one[:, 1]) for one in points]


@cache
def pictures_of(name):
    """The drawings of the note of a ready variant."""
    results, pages = solved(name), []

    def parts(page):
        pages.append(page)
        return list(note.parts(results, page))

    render(parts, results.variant.title, "html", Translator("ru"))
    return [drawing_of(one) for one in pages[0].form.pictures.values()]


@pytest.mark.parametrize("name", ["compressor", "cam_press"])
def test_every_line_of_a_note_stands_where_it_is_drawn(name):
    drawings = pictures_of(name)
    assert len(drawings) > 3
    for drawing in map(near_origin, drawings):
        strokes = vertices(emf(drawing), drawing.box)
        found = np.concatenate(strokes)
        for item in thinned(drawing.items):
            if isinstance(item, Path):
                for stroke in item.strokes:
                    wanted = np.array(stroke, complex)
                    ends = wanted[:1] if item.pen and item.pen.dash else wanted
                    assert np.abs(found[:, None] - ends[None, :200]).min(axis=0).max() <= CLOSE_TO


def test_the_head_says_size_and_counts():
    drawing = Drawing((line(0j, 100 + 40j, THICK), Circle(50 + 20j, 10, NORMAL, "")), margin=2.0)
    file = emf(drawing)
    assert emf(drawing) == file
    kind, size, *bounds = struct.unpack_from("<2I4i", file)
    frame = struct.unpack_from("<4i", file, 24)
    signature, version, length, count, handles = struct.unpack_from("<4IH", file, 40)
    assert (kind, size, signature, version, length) == (1, 108, 0x464D4520, 0x10000, len(file))
    assert count == len(list(records(file))) and handles == 1 + sum(k in (39, 95) for k, _ in records(file))
    assert bounds == [0, 0, 104 * UNITS, 44 * UNITS] and frame == (0, 0, 10400, 4400)
    dots, millimetres = struct.unpack_from("<2i2i", file, 72)[:2], struct.unpack_from("<2i", file, 80)
    assert dots[0] / millimetres[0] == UNITS


def test_a_line_is_as_long_and_as_thick_as_drawn():
    drawing = Drawing((line(3 + 4j, 103 + 4j, THICK),))
    file = emf(drawing)
    ((start, end),) = vertices(file, drawing.box)
    assert abs(end - start) == pytest.approx(100) and abs(start - (3 + 4j)) < CLOSE_TO
    pen = next(body for kind, body in records(file) if kind == 95)
    assert struct.unpack_from("<I", pen, 24)[0] == round(THICK.width * UNITS)


def test_letters_are_outlines_where_the_text_stands():
    drawing = Drawing((Text(10 + 10j, ("A",)), Arrow(0j, 20 + 0j)))
    (ink,) = inked(drawing.items[0])
    found = np.concatenate(vertices(emf(drawing), drawing.box))
    corners = ink.outline.places[np.isin(ink.outline.codes, (1, 2))]
    assert len(corners) > 5
    for place in corners:
        assert np.abs(found - place).min() <= CLOSE_TO


def test_dashes_are_parts_of_their_line():
    """Ink and gaps by turns, from the beginning on, round a corner, too; no dash is longer than its own."""
    places = np.array([0, 10, 10 + 7j], complex)
    ink, gap = DASHED.dash[:2]
    ((found, codes),) = dashed(places, np.array([1, 2, 2], np.uint8), DASHED.dash)
    starts = np.flatnonzero(codes == 1)
    pieces = np.split(found, starts[1:])
    along = [np.where(piece.real < 10, piece.real, 10 + piece.imag) for piece in pieces]
    period = sum(DASHED.dash)
    assert (
        [one[0] for one in along] == pytest.approx([k * period for k in range(len(pieces))])
        if len(DASHED.dash) == 2
        else True
    )
    lengths = [one[-1] - one[0] for one in along]
    assert lengths[0] == pytest.approx(ink) and max(lengths) <= ink + 1e-9 and along[-1][-1] <= 17 + 1e-9
    assert along[1][0] - along[0][-1] == pytest.approx(gap)
