"""Drawings as PNG pictures: of their true size, each primitive at its place, letters that are letters."""

import io
import os
import struct
import subprocess
import sys
import zlib
from dataclasses import replace
from itertools import pairwise

import matplotlib.image
import numpy as np
import pytest
from conftest import examples
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from pixels import PIXEL, SHEET, box, inked, picture, places

from tmm_report.figures import raster
from tmm_report.figures.charts.graphs import Curve, graph
from tmm_report.figures.charts.sheet import LOOKS
from tmm_report.figures.drawing import (
    COLOURS,
    THICK,
    Arc,
    Arrow,
    Circle,
    Drawing,
    Path,
    Pen,
    Text,
    dot,
    line,
    polygon,
    polyline,
)
from tmm_report.figures.primitives import HEAD
from tmm_report.figures.raster import INCH, dots, png


def away(z: np.ndarray, strokes) -> np.ndarray:
    """How far places (N,) are from the nearest of some polylines, mm."""
    ends = [pair for stroke in strokes for pair in pairwise(stroke)]
    found = np.full(len(z), np.inf)
    for start, end in ends:
        along = end - start or 1e-12
        share = np.clip(((z - start) / along).real, 0, 1)
        found = np.minimum(found, np.abs(z - start - share * along))
    return found


def chunks(data: bytes) -> dict[bytes, bytes]:
    """The chunks of a PNG file by their names."""
    found, at = {}, 8
    while at < len(data):
        (length,) = struct.unpack(">I", data[at : at + 4])
        name, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + length]
        assert zlib.crc32(name + body) == struct.unpack(">I", data[at + 8 + length : at + 12 + length])[0]
        found.setdefault(name, body)
        at += 12 + length
    return found


# --- size


@pytest.mark.parametrize("size", [(165, 228), (60, 40), (33.33, 7.77)])
def test_a_picture_has_300_dots_to_an_inch_of_the_drawing_and_says_so(size):
    data = png(Drawing((line(0, complex(*size)),), "кривошип", margin=0.0))
    found = chunks(data)
    assert struct.unpack(">II", found[b"IHDR"][:8]) == tuple(round(side * 300 / 25.4) for side in size)
    assert struct.unpack(">IIB", found[b"pHYs"]) == (11811, 11811, 1)  # dots to a metre
    assert "кривошип" in found[b"iTXt"].decode()
    assert found.keys() == {b"IHDR", b"pHYs", b"iTXt", b"IDAT", b"IEND"}  # no program, no date


@pytest.mark.parametrize("size", [(841, 594), (20_000, 2), (3, 50_000), (5000, 5000)])
def test_a_picture_too_large_has_fewer_dots(size):
    fewer = dots(size)
    assert fewer < 300
    wide, tall = (side * fewer / INCH for side in size)
    assert wide * tall <= 20e6 * 1.001 and max(wide, tall) <= 30_000.5
    assert wide * tall > 19e6 or max(wide, tall) > 29_999  # and no fewer than that


def test_a_sheet_that_a_note_may_have_keeps_its_dots():
    assert dots((165, 228)) == dots((261, 165)) == 300 and dots((375, 257)) == 300


def test_fewer_dots_show_the_same_drawing_of_the_same_size(monkeypatch):
    items = (SHEET, polygon((10 + 10j, 30 + 10j, 30 + 30j, 10 + 30j), None, "black"))
    monkeypatch.setattr(raster, "MOST", 60 * 40 / INCH**2 * 75**2)  # pixels of a quarter of the side
    data = png(Drawing(items, margin=0.0))
    found = chunks(data)
    (wide,) = struct.unpack(">I", found[b"IHDR"][:4])
    across, up, _ = struct.unpack(">IIB", found[b"pHYs"])
    assert (across, up) == (2953, 2953) and wide / across * 1000 == pytest.approx(60, abs=0.2)
    dark = matplotlib.image.imread(io.BytesIO(data))[..., 0] < 0.5
    assert dark.sum() / dark.size == pytest.approx(400 / 2400, rel=0.02)


# --- primitives

spots = st.builds(complex, st.integers(5, 55), st.integers(5, 35))


@pytest.mark.exhaustive
@settings(max_examples=examples(30))
@given(start=spots, end=spots, wide=st.sampled_from([0.18, 0.35, 0.6]))
def test_a_line_is_dark_where_it_is_and_nowhere_else(start, end, wide):
    assume(start != end)
    ink = inked(line(start, end, Pen(wide)))
    dark = places(ink)
    assert away(dark, [(start, end)]).max() <= wide / 2 + PIXEL
    along = start + (end - start) * np.linspace(0, 1, 50)
    rows, columns = np.floor(along.imag / PIXEL).astype(int), np.floor(along.real / PIXEL).astype(int)
    assert (ink[rows, columns] > 0.4).all()
    area = wide * abs(end - start) + np.pi * wide**2 / 4  # the ends are round
    assert ink.sum() * PIXEL**2 == pytest.approx(area, rel=0.02)


SHAPES = {
    "polyline": polyline((5 + 5j, 20 + 30j, 50 + 8j), THICK),
    "polygon": polygon((5 + 5j, 20 + 30j, 50 + 8j), THICK),
    "strokes": Path(((5 + 5j, 5 + 30j), (20 + 5j, 40 + 5j))),
    "circle": Circle(30 + 20j, 15.0),
    "arc": Arc(30 + 20j, 15.0, 0.3, 4.0),
    "arc clockwise": Arc(30 + 20j, 15.0, 3.0, -1.0),
    "arrow": Arrow(5 + 30j, 50 + 10j, THICK),
}


@pytest.mark.parametrize("name", SHAPES)
def test_a_primitive_covers_its_outline(name):
    item = SHAPES[name]
    ink = inked(item)
    strokes = item.outline()
    chord = 0.3 if name == "circle" else 0.02  # outlines are drawn in chords
    head = 0.17 * HEAD if name == "arrow" else 0.0
    assert away(places(ink), strokes).max() <= item.pen.width / 2 + PIXEL + chord + head
    for stroke in strokes:
        for z in stroke:
            if name != "arrow":
                assert ink[int(z.imag / PIXEL), int(z.real / PIXEL)] > 0.15


def test_a_circle_is_round():
    radii = np.abs(places(inked(Circle(30 + 20j, 15.0, Pen(0.2)))) - (30 + 20j))
    assert abs(radii - 15).max() < 0.1 + PIXEL


def test_an_arrow_ends_at_its_point_and_is_widest_behind_it():
    dark = places(inked(Arrow(10 + 20j, 50 + 20j, Pen(0.2))))
    assert dark.real.max() == pytest.approx(50, abs=0.25)
    wide = [np.ptp(dark[abs(dark.real - x) < PIXEL].imag) for x in (47.2, 48.5, 49.5, 30.0)]
    assert wide == [*sorted(wide[:3], reverse=True), wide[3]] and wide[0] > 0.8 and wide[3] < 0.3


def test_dashes_are_as_long_as_the_pen_says():
    ink = inked(line(5 + 20.02j, 55 + 20.02j, Pen(0.2, dash=(2.0, 1.0))))
    row = ink[int(20.02 / PIXEL)] > 0.4
    begins = np.flatnonzero(np.diff(row.astype(int)) == 1) * PIXEL
    ends = np.flatnonzero(np.diff(row.astype(int)) == -1) * PIXEL
    assert len(begins) == 17 and np.diff(begins) == pytest.approx(3.0, abs=0.1)
    assert (ends - begins)[:-1] == pytest.approx(2.2, abs=0.13)  # with round ends


def test_colours_are_those_of_the_drawing_and_a_pale_fill_covers_half():
    whole = dot(15 + 20j, 5.0, "blue")
    square = (40 + 15j, 50 + 15j, 50 + 25j, 40 + 25j)
    pixels = inked(whole, polygon(square, None, "red", 0.5), colour=True)
    blue, red = (np.array(list(bytes.fromhex(COLOURS[name]))) / 255 for name in ("blue", "red"))
    assert pixels[int(20 / PIXEL), int(15 / PIXEL)] == pytest.approx(blue, abs=0.01)
    assert pixels[int(20 / PIXEL), int(45 / PIXEL)] == pytest.approx((1 + red) / 2, abs=0.01)


def test_letters_stand_over_lines_whatever_their_order():
    name, white = Text(20 + 20j, ("H",), 10.0), polygon((10, 50, 50 + 39j, 10 + 39j), None, "white")
    assert np.array_equal(inked(white, name), inked(name, white)) and inked(name, white).max() > 0.9


def test_a_hole_of_a_letter_stays_open():
    ink = inked(Text(30 + 20j, ("O",), 20.0, 0))
    left, low, right, high = box(ink)
    middle = ink[int((low + high) / 2 / PIXEL), int((left + right) / 2 / PIXEL)]
    assert middle == 0 and ink.max() > 0.9


# --- whole pictures


@pytest.mark.exhaustive
def test_a_graph_is_drawn_with_all_its_curves():
    x = np.linspace(0, 360, 73)
    curves = [Curve(np.sin(np.radians(x) + k), str(k)) for k in range(3)]
    pixels = picture(graph(curves, x, "φ, °", ["M, Н·м"], wide=100.0).drawing)
    for look in LOOKS[1:3]:
        own = np.array(list(bytes.fromhex(COLOURS[look.pen.colour]))) / 255
        assert (abs(pixels - own).max(axis=2) < 0.02).sum() > 1000


FIXED = Drawing(
    (SHEET, Circle(30 + 20j, 10.0), line(5, 50 + 30j, Pen(0.3, "red", (2.0, 1.0))), Text(9 + 9j, ("Ω",)))
)


@pytest.mark.exhaustive
def test_same_drawing_same_bytes_whatever_settings_a_machine_has(tmp_path):
    own = tmp_path / "matplotlibrc"
    own.write_text(
        "path.sketch: 5, 100, 2\nimage.origin: lower\nlines.scale_dashes: False\nsavefig.dpi: 50\n"
        "font.family: monospace\npatch.antialiased: False\nsavefig.facecolor: red\npath.snap: True\n"
    )
    code = (
        "import sys; from tmm_report.figures.drawing import *; from tmm_report.figures.raster import png\n"
        f"sys.stdout.buffer.write(png({FIXED!r}))"
    )
    env = {**os.environ, "MATPLOTLIBRC": str(own)}
    done = subprocess.run([sys.executable, "-c", code], env=env, capture_output=True, check=True)
    assert done.stdout == png(FIXED) == png(replace(FIXED))


@settings(max_examples=examples(10))
@given(st.integers(-1_000_000, 1_000_000), st.integers(-1_000_000, 1_000_000))
def test_where_a_drawing_stands_in_its_axes_is_not_seen(x, y):
    here, there = (picture(FIXED.moved(by)) for by in (0j, complex(x, y)))
    assert here.shape == there.shape and abs(here - there).mean() < 1e-3
