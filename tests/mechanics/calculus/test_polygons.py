"""Shared area and distance of polygons against what is known in closed form and against a fine raster."""

import math

import numpy as np
import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.polygons import area, clearance, inside, overlap

SQUARE = np.array([0, 1, 1 + 1j, 1j])


def polygon(count, radius=1.0, turn=0.0):
    return radius * np.exp(1j * (turn + 2 * math.pi * np.arange(count) / count))


@pytest.mark.parametrize(
    "shift, shared", [(0.25 + 0.5j, 0.375), (0.9 + 0.9j, 0.01), (2, 0), (0.3 - 0.2j, 0.56)]
)
def test_two_squares(shift, shared):
    assert overlap(SQUARE, SQUARE + shift) == pytest.approx(shared, abs=1e-14)


def test_a_square_inside_a_square_and_inside_an_opening():
    small = 0.3 + 0.3j + 0.2 * SQUARE
    assert overlap(small, SQUARE) == overlap(SQUARE, small) == pytest.approx(0.04)
    assert clearance(small, SQUARE) == pytest.approx(-0.3)
    assert overlap(small, SQUARE, opening=True) == 0
    assert clearance(small, SQUARE, opening=True) == pytest.approx(0.3)


def test_a_square_that_leaves_an_opening_meets_the_metal_round_it():
    assert overlap(SQUARE + 0.25 + 0.5j, SQUARE, opening=True) == pytest.approx(1 - 0.375)


@pytest.mark.exhaustive
@settings(max_examples=examples(40))
@given(st.floats(0.1, 1.9), st.floats(0, 6.28), st.integers(3, 400), st.integers(3, 400))
def test_area_by_a_raster(distance, turn, one, other):
    p, q = polygon(one), polygon(other, 0.8, turn) + distance * np.exp(1j * turn / 2)
    step = 0.02
    x = np.arange(-1, 1, step) + step / 2
    cells = (x + 1j * x[:, None]).ravel()
    raster = np.count_nonzero(inside(cells, p) & inside(cells, q)) * step**2
    assert overlap(p, q) == pytest.approx(raster, abs=0.05)
    assert overlap(p, q) == pytest.approx(overlap(q, p), abs=1e-12)
    assert overlap(p, q) + overlap(p, q, opening=True) == pytest.approx(area(p), abs=1e-12)


@given(st.floats(2.001, 5), st.integers(30, 900))
def test_distance_of_two_round_polygons(distance, count):
    p, q = polygon(count), polygon(count, turn=1.0) + distance
    sagitta = 1 - math.cos(math.pi / count)
    assert distance - 2 - 1e-12 <= clearance(p, q) <= distance - 2 + 2 * sagitta + 1e-12


def test_depth_of_the_deepest_vertex():
    p = polygon(720)
    assert clearance(p, p + 1.9) == pytest.approx(-0.1, abs=1e-3)
