"""Labels find clear places, or are led to theirs; what the grid calls clear is clear."""

from itertools import combinations, pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.figures.crowded import areas, cut, ground, overlapping
from tmm_report.figures.drawing import Circle, Drawing, Path, Pen, Tag, Text, line
from tmm_report.figures.lettering import Symbol, lettered, svg_parts, symbol, tex_parts
from tmm_report.figures.placing import AWAY, LEADER, clear_of
from tmm_report.quantity import symbols

coordinates = st.floats(-20, 20)
places = st.builds(complex, coordinates, coordinates)


def texts(drawing):
    return [item for item in drawing.items if isinstance(item, Text)]


def leaders(drawing):
    return [i.strokes[0] for i in drawing.items if isinstance(i, Path) and i.pen and i.pen.width == LEADER]


def crossings(drawing):
    """Labels that a line of the drawing goes through."""
    strokes = [stroke for item in drawing.items if not isinstance(item, Text) for stroke in item.outline()]
    pairs = [pair for stroke in strokes for pair in pairwise(stroke)]
    lines = [np.array(pair) for pair in pairs]
    return [text for text in texts(drawing) if any(cut(np.array(text.box), line) for line in lines)]


@given(st.lists(st.tuples(places, places), min_size=1, max_size=6), places)
def test_a_box_that_the_grid_calls_clear_is_clear(lines, corner):
    box = (corner.real, corner.imag, corner.real + 3.0, corner.imag + 2.0)
    rows = np.array([(a.real, a.imag, b.real, b.imag, 1.0) for a, b in lines])
    on = ground(rows, np.array([-20.0, -20.0]), np.array([20.0, 20.0]))
    if any(cut(np.array(box), np.array([a, b])) for a, b in lines):
        assert on.covered(np.array([box]))[0] > 0


def test_the_weight_of_a_line_goes_with_its_length_in_the_box():
    on = ground(np.array([(0.0, 5.0, 30.0, 5.0, 1.0)]), np.zeros(2), np.array([30.0, 10.0]))
    short, long = on.covered(np.array([(5.0, 3.0, 10.0, 7.0), (5.0, 3.0, 25.0, 7.0)]))
    assert long == pytest.approx(4 * short, rel=0.1)
    assert on.across(0j, 30 + 0j) == 0 < on.across(15 + 0j, 15 + 10j)


def test_shared_areas():
    box, other = (0.0, 0.0, 4.0, 3.0), (3.0, 1.0, 9.0, 2.0)
    assert areas(np.array([box]), [other])[0] == 1.0 and overlapping(np.array([box]), np.array([other]))[0]
    apart = (4.0, 0.0, 5.0, 1.0)
    assert (
        areas(np.array([box]), [apart])[0] == 0.0 and not overlapping(np.array([box]), np.array([apart]))[0]
    )


def star(count=40):
    return tuple(line(2 * np.exp(1j * a), 14 * np.exp(1j * a)) for a in 2 * np.pi * np.arange(count) / count)


def test_a_label_with_no_room_beside_its_point_is_led_to_it():
    drawing = Drawing(star()).labelled([Tag((symbol("A"),), (0j,), gap=2.0)])
    ((start, end),) = leaders(drawing)
    (text,) = texts(drawing)
    assert abs(start) == pytest.approx(1.3) and abs(end) > 2.0 + AWAY
    assert text.box[0] - 0.2 <= end.real <= text.box[2] + 0.2 and not crossings(drawing)


def test_a_label_with_room_has_no_leader():
    assert not leaders(Drawing((line(-20, 20),)).labelled([Tag((symbol("A"),), (0j,))]))


def test_many_labels_of_one_place_are_all_read():
    tags = [Tag((symbol(f"R_{k}"),), (0j,), gap=2.0) for k in range(12)]
    drawing = Drawing(star(16)).labelled(tags)
    assert not crossings(drawing) and leaders(drawing)
    assert not [
        pair
        for pair in combinations([t.box for t in texts(drawing)], 2)
        if overlapping(*np.array(pair)[:, None])[0]
    ]


def test_who_finds_no_place_is_let_go_first():
    """A wall with one hole: the first label, which has room elsewhere, leaves it to the second."""
    wall = [line(complex(x, -40), complex(x, 40)) for x in np.arange(-40, 40, 0.5) if not 0 < x < 4]
    wall += [line(complex(x, y), complex(x, 20 * y)) for x in np.arange(0.5, 4, 0.5) for y in (-2, 2)]
    tags = [Tag(("B",), (0j, 60 + 0j), gap=0.5), Tag(("A",), (0j,), gap=0.5)]
    assert not crossings(Drawing(tuple(wall)).labelled(tags))


def test_the_texts_stand_in_the_order_of_their_tags():
    drawing = Drawing(star(16)).labelled([Tag((name,), (0j,)) for name in "ABCDEF"])
    assert [text.parts for text in texts(drawing)] == [(name,) for name in "ABCDEF"]


def test_a_label_may_stand_on_the_pale_lines_of_a_grid():
    grid = Path(tuple((complex(x, -20), complex(x, 20)) for x in range(-20, 21)), Pen(0.13, "pale"))
    drawing = Drawing((grid,)).labelled([Tag((symbol("A"),), (0j,))])
    assert not leaders(drawing) and abs(complex(*texts(drawing)[0].box[:2])) < 3


def test_a_clear_box_holds_neither_lines_nor_letters():
    items = (Circle(0j, 5.0), Text(20 + 0j, ("A",)))
    assert clear_of(items, [(-2, -2, 2, 2), (4, -1, 6, 1), (19, -1, 22, 1), (30, 0, 40, 9)]) == [
        True,
        False,
        False,
        True,
    ]


# --- indices are set as in formulas ---


@pytest.mark.parametrize(
    ("text", "italic", "tex"),
    [
        ("M_bal", [], r"\text{bal}"),
        ("d_ai", ["ai"], "ai"),
        ("v_S2", ["S"], "S2"),
        ("F_и2", [], r"\text{и}2"),
    ],
)
def test_words_and_numbers_of_indices_are_upright(text, italic, tex):
    written = svg_parts((symbol(text),), 3.2)
    slanted = [part.split(">")[1].split("<")[0] for part in written.split("<tspan")[2:] if "italic" in part]
    assert slanted == italic and f"_{{{tex}}}" in tex_parts((symbol(text),))


def test_a_quantity_is_lettered_with_the_words_of_the_language():
    of = symbols.Symbol("M", "bal")
    assert lettered(of, {"bal": "ур"}.__getitem__) == Symbol("M", "ур")
    assert lettered(symbols.Symbol("omega", "2")) == Symbol("ω", "2")
