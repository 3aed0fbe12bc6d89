"""A logarithmic chart: a decade is a decade wherever it lies, and what none beats is full."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.figures.charts.logs import LEVEL, STAIRS, WIDE, Series, decades, loglog
from tmm_report.figures.drawing import Path, Text

values = st.lists(st.floats(1e-18, 1e12), min_size=1, max_size=8)


@given(values)
def test_an_axis_holds_all_its_values(numbers):
    axis = decades(np.array(numbers), 100.0)
    assert all(0 < axis.at(x) < 100 for x in numbers)


@given(values, st.floats(1e-3, 1e3))
def test_a_factor_is_one_length_wherever_it_is_measured(numbers, factor):
    axis = decades(np.array(numbers), 100.0)
    steps = [axis.at(x * factor) - axis.at(x) for x in numbers]
    assert steps == pytest.approx([steps[0]] * len(steps), abs=1e-9)


def chart(**more):
    series = [
        Series([1 + 1e-3j, 10 + 1e-6j], ("one",), (0, 1)),
        Series([complex(5, 1e-2), complex(np.nan, np.nan)], ("other",)),
    ]
    return loglog(series, ("x",), ("y",), level=1e-4, named=("limit",), **more)


def filled(item: object, colours=("black", "blue")) -> bool:
    return isinstance(item, Path) and item.fill in colours


def test_only_what_none_beats_is_full_and_stairs_join_it():
    items = chart().items
    assert sum(filled(item) for item in items) == 2
    assert sum(isinstance(item, Path) and item.fill == "white" for item in items) == 1
    (stairs,) = [item for item in items if isinstance(item, Path) and item.pen == STAIRS]
    heights = [z.imag for z in stairs.strokes[0]]
    assert heights == sorted(heights, reverse=True)
    assert not any(isinstance(item, Path) and item.pen == STAIRS for item in chart(stairs=False).items)


def test_the_level_lies_between_the_points_above_and_below_it():
    items = chart().items
    (level,) = [item for item in items if isinstance(item, Path) and item.pen == LEVEL]
    (a, b) = level.strokes[0]
    marks = sorted(np.mean(item.strokes[0]).imag for item in items if isinstance(item, Path) and item.fill)
    assert a.imag == b.imag and marks[0] < a.imag < marks[1] and b.real - a.real == WIDE


def test_every_series_is_named_and_stated_figures_stand_along_the_axis():
    texts = [item.parts for item in chart(xticks=(1, 4, 12)).items if isinstance(item, Text)]
    assert {("one",), ("other",), ("limit",), ("1",), ("4",), ("12",)} <= set(texts)
