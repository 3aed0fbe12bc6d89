"""Plans: vectors drawn to the length given, vertices lettered once."""

import xml.etree.ElementTree as ET

from tmm_report.figures.drawing import Arrow, Path, Text, svg
from tmm_report.figures.lettering import Symbol, symbol
from tmm_report.figures.plans import BEYOND, PENS, PlanVector, plan

VERTICES = {"p": 0j, "o": 0j, "a": 60 + 40j, "b": 80 + 0j}
VECTORS = [
    PlanVector(0, 60 + 40j, symbol("v_A"), "absolute"),
    PlanVector(0, 80, symbol("v_B"), "absolute"),
    PlanVector(60 + 40j, 80, symbol("v_BA")),
    PlanVector(60 + 40j, 80, None, "construction"),
    PlanVector(80, 80 + 1e-6, symbol("v_0")),
]


def drawn():
    return plan(VECTORS, VERTICES, "масштаб 0,075", "План", "p")


def texts(drawing):
    return [
        "".join(p if isinstance(p, str) else p.base for p in i.parts)
        for i in drawing.items
        if isinstance(i, Text)
    ]


def test_arrows_are_the_vectors_in_millimetres():
    arrows = {(item.start, item.end): item.pen for item in drawn().items if isinstance(item, Arrow)}
    assert set(arrows) == {(0, 60 + 40j), (0, 80), (60 + 40j, 80)}
    assert arrows[(0, 80)].width > arrows[(60 + 40j, 80)].width


def test_a_vector_says_of_which_quantity_it_is():
    vectors = [PlanVector(0, 60, None, "force", 'P_<"&'), PlanVector(60, 60 + 40j)]
    groups = [node for node in ET.fromstring(svg(plan(vectors, {}))).iter() if node.get("data-q")]
    assert [group.get("data-q") for group in groups] == ['P_<"&']
    assert [path.tag.rpartition("}")[2] for path in groups[0]] == ["path", "path"]


def test_a_vector_without_length_is_left_out_with_its_label():
    assert Symbol("v", "0") not in [p for i in drawn().items if isinstance(i, Text) for p in i.parts]


def test_a_construction_line_runs_past_both_ends_and_has_no_head():
    lines = [item for item in drawn().items if isinstance(item, Path) and item.pen == PENS["construction"]]
    start, end = lines[0].strokes[0]
    assert abs(abs(end - start) - abs(20 - 40j) - 2 * BEYOND) < 1e-9


def test_coinciding_vertices_share_one_label():
    words = texts(drawn())
    assert words.count("p, o") == 1 and "p" not in words and words.count("a") == 1
    assert "масштаб 0,075" in words


def test_an_empty_plan_and_the_same_bytes_twice():
    ET.fromstring(svg(plan([], {})))
    assert svg(drawn()) == svg(drawn())
