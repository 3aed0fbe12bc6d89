"""results.json: strict JSON with every number to its last digit, the same bytes each time."""

import json
import math

import numpy as np
import pytest
from conftest import read
from hypothesis import given
from hypothesis import strategies as st
from pydantic_core import to_json

from tmm_report import course, render
from tmm_report.results import _numbers


def refuse(text):
    raise ValueError(f"{text} is no JSON")


def again(column):
    """The numbers as a reader of the file has them."""
    text = to_json(_numbers(column), inf_nan_mode="null")
    assert b"-0.0" not in text.replace(b",", b" ").split() and text == to_json(
        _numbers(column), inf_nan_mode="null"
    )
    return json.loads(text, parse_constant=refuse)


def told(x):
    return x + 0.0 if math.isfinite(x) else None


@given(st.lists(st.floats() | st.floats(1e-10, 1e-3) | st.floats(1e15, 1e18)))
def test_numbers_are_read_back_as_they_are(numbers):
    for column in (numbers, np.array(numbers, dtype=float)):
        assert list(map(repr, again(column))) == [repr(told(x)) for x in numbers]


def test_powers_of_two_and_of_ten_and_their_neighbours():
    powers = np.concatenate([2.0 ** np.arange(-1074, 1024), 10.0 ** np.arange(-320, 309)])
    column = np.concatenate([np.nextafter(powers, 0), powers, np.nextafter(powers, np.inf), -powers])
    assert again(column) == [told(x) for x in column.tolist()]


def test_texts_and_whole_numbers_stay_what_they_are():
    assert again(['ω₁ "2"', 3, -0.0, np.float64(0.5), np.int64(4)]) == ['ω₁ "2"', 3, 0.0, 0.5, 4.0]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["compressor", "drum_motor"])
def test_a_file_is_strict_and_the_same_each_time(name):
    one, other = (render(course.solve(read(name)), "json")["results.json"] for _ in range(2))
    assert one == other and json.loads(one, parse_constant=refuse)["format"] == 1
