"""Primitives: true lengths on paper, escaping, bounds, determinism, placing of labels."""

import math
import re
import xml.etree.ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.figures.drawing import (
    AXIS,
    THICK,
    Arc,
    Arrow,
    Circle,
    Drawing,
    Tag,
    Text,
    hatching,
    line,
    polygon,
    svg,
    tikz,
    together,
)
from tmm_report.figures.lettering import Symbol, symbol, tex_text

places = st.complex_numbers(max_magnitude=200, allow_nan=False, allow_infinity=False)
SVG = "{http://www.w3.org/2000/svg}"
NASTY = "</text><script>&\"'\x00\\input{x}$%#_^~{}\ud800"


def numbers(text):
    return [float(number) for number in re.findall(r"-?\d+\.?\d*", text)]


def everything():
    items = (
        line(0, 40 + 30j, THICK),
        polygon((0, 10, 10j), fill="pale", opacity=0.5),
        Circle(20, 3),
        Arc(0j, 12, 0.2, -1.5, AXIS),
        Arrow(0, -20 - 5j),
        hatching(0, 15, -1j),
        Text(5 + 5j, (symbol("R_12^t", bar=True), ", текст, ", symbol("ε_2"))),
    )
    return Drawing(items, "План <скоростей>")


@given(places, places)
def test_a_drawn_segment_is_as_long_as_given(a, b):
    root = ET.fromstring(svg(Drawing((line(a, b),))))
    x0, y0, x1, y1 = numbers(root.find(f".//{SVG}path").get("d"))
    assert math.hypot(x1 - x0, y1 - y0) == pytest.approx(abs(b - a), abs=2e-3)
    drawn = next(row for row in tikz(Drawing((line(a, b),))).splitlines() if row.startswith(r"\path"))
    x0, y0, x1, y1 = numbers(drawn.split("] ")[1])
    assert complex(x1 - x0, y1 - y0) == pytest.approx(b - a, abs=2e-3)


@given(places, places)
def test_an_arrow_goes_from_its_start_to_its_end_with_a_small_head(a, b):
    if abs(b - a) < 0.01:
        return
    shaft, head = Arrow(a, b).parts
    tip, *wings = head.strokes[0]
    assert shaft.strokes[0][0] == a and tip == b
    back = (sum(wings) / 2 - tip) / (a - b)
    assert 0 < back.real <= 0.25 + 1e-9


def test_one_unit_of_the_view_box_is_one_millimetre():
    root = ET.fromstring(svg(everything()))
    _, _, wide, tall = root.get("viewBox").split()
    assert (root.get("width"), root.get("height")) == (f"{wide}mm", f"{tall}mm")


def test_y_points_up():
    root = ET.fromstring(svg(Drawing((line(0, 10j),))))
    assert numbers(root.find(f".//{SVG}path").get("d")) == [0, 0, 0, -10]


def test_svg_has_title_and_neither_ids_nor_scripts():
    text = svg(everything())
    assert ET.fromstring(text).find(f"{SVG}title").text == "План <скоростей>"
    assert " id=" not in text and "script" not in text and "href" not in text and "-0 " not in text


def test_the_same_drawing_gives_the_same_bytes():
    assert svg(everything()) == svg(everything()) and tikz(everything()) == tikz(everything())


@pytest.mark.parametrize("label", [(NASTY,), (symbol(NASTY),), (Symbol("v", NASTY, NASTY),)])
def test_names_are_escaped(label):
    drawing = Drawing((Text(0, label),), NASTY)
    root = ET.fromstring(svg(drawing))
    assert not list(root.iter(f"{SVG}script"))
    written = "".join(root.find(f".//{SVG}text").itertext())
    assert "<script>" in written and "\x00" not in written
    node = next(row for row in tikz(drawing).splitlines() if row.startswith(r"\node"))
    assert r"\input" not in node and "\x00" not in node and not re.search(r"(?<!\\)[%#&]", node)


def test_tex_of_words_and_symbols():
    assert tex_text("50 % & μ № ★") == r"50 \% \& \ensuremath{\mu} \textnumero{} ?"
    node = tikz(Drawing((Text(0, (symbol("F_и2"), symbol("π"), Symbol("2"))),)))
    assert r"${F}_{\text{и}2}$${\pi{}}$${\mathit{2}}$" in node


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("p", Symbol("p")),
        ("S2", Symbol("S", "2")),
        ("v_BA", Symbol("v", "BA")),
        ("R_12^t", Symbol("R", "12", "t")),
        ("R^t_12", Symbol("R", "12", "t")),
        ("a_BA_n", Symbol("a", "BA", "n")),
        ("12", Symbol("12")),
        ("_x", Symbol("_x")),
        ("", Symbol("")),
    ],
)
def test_symbols_are_read_as_they_are_written(text, expected):
    assert symbol(text) == expected


def test_the_box_holds_lines_and_lettering():
    left, bottom, right, top = Drawing((Circle(0, 10), Text(30, ("abc",), align=1), Arrow(0, 5 - 12j))).box
    assert left <= -10 and top >= 10 and right >= 30 and bottom <= -12


def test_labels_keep_off_lines_and_off_each_other():
    star = tuple(line(0, 30 * complex(math.cos(a), math.sin(a))) for a in (0.3, 1.7, 2.9, 4.4))
    tags = [Tag((symbol(name),), (0j,)) for name in "ABC"]
    texts = [item for item in Drawing(star).labelled(tags).items if isinstance(item, Text)]
    boxes = [text.box for text in texts]
    assert len(boxes) == 3
    for i, a in enumerate(boxes):
        for b in boxes[:i]:
            assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
    lone = Drawing((line(-20, 20),)).labelled([Tag((symbol("A"),), (0j,))]).items[-1]
    assert lone.box[1] > 0 or lone.box[3] < 0


def test_coinciding_places_go_together():
    assert together({"b": 0j, "a": 5j, "p": 0.1}) == [(["b", "p"], 0j), (["a"], 5j)]


def test_a_drawing_far_from_the_origin_is_moved_to_it():
    far = Drawing((line(5e6 + 0j, 5e6 + 30 + 40j),))
    for text in (svg(far), tikz(far)):
        numbers = [
            abs(float(x))
            for x in re.findall(r"-?\d+\.?\d*", re.sub(r"#\w+|\{HTML\}\{\w+\}|http\S+", "", text))
        ]
        assert max(numbers) < 200
