"""Lists of numbers for JSON, written many at once and the same to the last byte as the library writes them."""

import json
import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.jsontext import framed, indented, number_lists

sizes = st.floats() | st.floats(1e-10, 1e-3) | st.floats(1e15, 1e18) | st.integers(-(10**6), 10**6).map(float)


def plain(x: float) -> float | None:
    return x + 0.0 if math.isfinite(x) else None


@given(st.lists(st.lists(sizes, max_size=6), max_size=5), st.integers(0, 4))
def test_numbers_are_written_as_the_library_writes_them(rows, depth):
    written = [text.decode() for text in number_lists([np.array(row, dtype=float) for row in rows], depth)]
    assert written == [indented([plain(x) for x in row], depth) for row in rows]


def test_powers_of_two_and_of_ten_and_their_neighbours():
    powers = np.concatenate([2.0 ** np.arange(-1074, 1024), 10.0 ** np.arange(-320, 309)])
    beside = np.concatenate([np.nextafter(powers, 0), powers, np.nextafter(powers, np.inf)])
    rows = np.concatenate([beside, -beside])
    text = next(iter(number_lists([rows], 0))).decode()
    assert text == json.dumps([plain(x) for x in rows.tolist()], indent=1)


def test_what_is_written_already_is_framed_as_it_stands():
    assert b"".join(framed(b"{}", [], 2)) == b"{}"
    assert b"".join(framed(b"[]", [[b"1"], [b"2", b"3"]], 1)) == b"[\n  1,\n  23\n ]"
