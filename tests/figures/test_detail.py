"""A short crank is drawn larger beside its scheme; the working stroke goes round the driver's circle."""

import cmath
import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mechanisms import CASES, compressor

from tmm_report.figures.drawing import THICK, Arc, Circle, Drawing, Path, Text, line
from tmm_report.figures.schemes.detail import SHORT, beside, clipped, times
from tmm_report.figures.schemes.scheme import positions_scheme, scheme
from tmm_report.figures.schemes.strokes import BAND, Stroke
from tmm_report.figures.schemes.view import view_of

places = st.complex_numbers(max_magnitude=30, allow_nan=False, allow_infinity=False)


def words(drawing):
    return ["".join(map(str, item.parts)) for item in drawing.items if isinstance(item, Text)]


def bars(drawing):
    return [
        abs(i.strokes[0][1] - i.strokes[0][0])
        for i in drawing.items
        if isinstance(i, Path) and i.pen == THICK
    ]


@pytest.mark.parametrize(("mu", "k"), [(0.005, 1), (0.01, 2), (0.02, 4), (0.1, 20)])
def test_a_crank_too_short_to_be_read_is_drawn_larger_beside_the_scheme(mu, k):
    drawing = scheme(*compressor(), mu, 2)
    assert times(view_of(*compressor(), mu, 2)) == k
    assert (f"I ({k:g}:1)" in words(drawing)) == (k > 1)
    assert min(abs(length - k * 0.1 / mu) for length in bars(drawing)) < 1e-9
    assert min(abs(length - 0.1 / mu) for length in bars(drawing)) < 1e-9  # the scheme keeps its scale
    assert k == 1 or 0.1 / mu < SHORT


def test_positions_of_a_short_crank_are_numbered_in_the_detail_alone():
    long, short = (words(positions_scheme(*compressor(), mu)) for mu in (0.005, 0.01))
    assert long.count("0=12") == short.count("0=12") == 1
    assert "9" in short  # of the crank alone: its sliders share numbers


@given(places, places, st.floats(1, 20))
def test_a_segment_is_cut_by_a_circle(a, b, radius):
    pieces = [stroke for item in clipped([line(a, b)], 0j, radius) for stroke in item.strokes]
    inside = [abs(a + t * (b - a)) < radius for t in np.linspace(0, 1, 2001)]
    assert sum(abs(q - p) for p, q in pieces) == pytest.approx(
        np.mean(inside) * abs(b - a), abs=0.003 * abs(b - a) + 1e-9
    )


def test_what_lies_within_the_circle_is_left_as_it_is():
    within, without = Circle(1j, 1.0, None, "white"), Circle(40j, 1.0)
    assert clipped([within, without], 0j, 10.0) == [within]


def test_a_detail_stands_in_an_empty_corner_or_beside_the_drawing():
    corner = Drawing((line(0, 100 + 0j), line(0, 100j)))
    small = Drawing((Circle(0j, 10.0),))
    assert beside(corner, small).size == corner.size
    full = Drawing(tuple(line(complex(0, y), complex(100, y)) for y in range(0, 101, 5)))
    assert beside(full, small).size[0] > full.size[0] and beside(full, small).size[1] == full.size[1]
    wide = Drawing(tuple(line(complex(0, y), complex(160, y)) for y in range(0, 101, 5)))
    assert beside(wide, small).size[0] == wide.size[0]


# --- working strokes ---


def bands(drawing):
    return [item for item in drawing.items if isinstance(item, Arc) and item.pen == BAND]


@pytest.mark.parametrize("sense", [1, -1])
def test_a_working_stroke_goes_the_way_the_driver_turns(sense):
    mechanism, places, turns = compressor()
    mechanism = replace(mechanism, driver=replace(mechanism.driver, omega=125.0 * sense))
    (arc,) = bands(positions_scheme(mechanism, places, turns, 0.005, strokes=[Stroke(0.5, 2.0, ("stroke",))]))
    assert arc.radius > 20 and arc.start == pytest.approx(0.5 * sense)
    assert 1.3 < sense * (arc.end - arc.start) < 1.5  # the head ends it


def test_strokes_of_two_outputs_are_told_apart():
    strokes = [Stroke(0.0, math.pi, ("one",)), Stroke(math.pi, 2 * math.pi, ("two",))]
    drawing = positions_scheme(*compressor(), 0.005, strokes=strokes)
    one, two = bands(drawing)
    assert two.radius > one.radius + 2 and {"one", "two"} <= set(words(drawing))
    assert cmath.rect(1, two.start) == pytest.approx(cmath.rect(1, -math.pi))


@pytest.mark.parametrize("name", ["compressor", "four_bar"])
def test_trajectories_are_smooth(name):
    """Whether or not the last place of a path is its first again."""
    mechanism, every, turns = CASES[name](36)
    twice = {point: np.append(path, path[0]) for point, path in every.items()}
    one, other = (
        positions_scheme(mechanism, every, turns, 0.005, paths=p, traced=list(every)) for p in (every, twice)
    )
    assert one.items == other.items
