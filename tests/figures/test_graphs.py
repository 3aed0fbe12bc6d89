"""Graphs with axes: round scales, curves to the millimetre, values and names that cover nothing."""

from __future__ import annotations

import math
import subprocess
import sys
import xml.etree.ElementTree as ET
from itertools import pairwise

import numpy as np
import pytest
from conftest import solved
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report.chapters.lever.kinematics.view.diagrams import Diagrams
from tmm_report.figures.charts.axes import figure, position_marks, round_axis, round_ticks, value_ticks
from tmm_report.figures.charts.graphs import Curve, graph
from tmm_report.figures.charts.sheet import CURVE, JOINED
from tmm_report.figures.drawing import Path, Text, svg, tikz
from tmm_report.figures.lettering import Symbol, width
from tmm_report.i18n import Translator
from tmm_report.quantity.paper import ROUND
from tmm_report.report.diagrams import CycleGraphs
from tmm_report.report.diagrams import scales as scales_of

X = np.linspace(0, 360, 37)
PHI = np.radians(X)
NAME = "_ползун $x_1^$ <b>&"


def drawn(shift=0.0):
    curves = [Curve(np.sin(PHI) + shift, NAME), Curve(0.5 * np.cos(PHI), "D"), Curve(np.cos(PHI), "", 1)]
    labels = [(Symbol("S", "D"), ", м"), "V $, м/с"]
    return graph(curves, X, "φ, град", labels, wide=180.0, positions=12, comma=True, title="Диаграмма <S>")


def lines(made):
    """The curves as drawn, mm: [(P,) complex of each stroke]."""
    paths = [item for item in made.drawing.items if isinstance(item, Path) and item.pen]
    return [
        np.array(stroke)
        for path in paths
        if path.pen.width == CURVE
        for stroke in path.strokes
        if len(stroke) > 2
    ]


def texts(made):
    return [item for item in made.drawing.items if isinstance(item, Text)]


def overlap(one, other):
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def is_round(scale):
    return any(
        math.isclose(scale / 10.0 ** math.floor(math.log10(scale) + 1e-9), step, rel_tol=1e-9)
        for step in ROUND
    )


def test_svg_is_well_formed_and_keeps_what_a_user_wrote_as_text():
    text = svg(drawn().drawing)
    root = ET.fromstring(text)
    words = ["".join(node.itertext()).strip() for node in root.iter("{http://www.w3.org/2000/svg}text")]
    assert NAME in words and "V $, м/с" in words and "SD, м" in words and "−0,5" in words
    assert root.find("{http://www.w3.org/2000/svg}title").text == "Диаграмма <S>"
    assert r"\$x\_1\textasciicircum{}\$ \ensuremath{<}b" in tikz(drawn().drawing)


def test_the_letter_of_an_axis_is_italic_and_its_index_below():
    assert '<tspan font-style="italic">S</tspan>' in svg(drawn().drawing)
    assert "{S}_{D}" in tikz(drawn().drawing)


def test_the_same_data_give_the_same_bytes():
    assert svg(drawn().drawing) == svg(drawn().drawing) and tikz(drawn().drawing) == tikz(drawn().drawing)


def test_the_size_holds_all_that_is_drawn():
    made = drawn()
    left, bottom, right, top = made.drawing.box
    assert left >= -1 and bottom >= -1 and right <= made.size[0] + 1 and top <= made.size[1] + 1


# --- scales and places


@pytest.mark.parametrize(
    ("extent", "wide"), [(360, 144), (720, 144), (1440, 144), (60, 120), (90, 112.5), (130, 130)]
)
def test_the_axis_of_the_angle_is_at_a_round_scale(extent, wide):
    assert round_axis(extent, 145.0) == pytest.approx(wide)


@given(st.floats(1e-6, 1e7), st.floats(-1, 1), st.integers(1, 4))
@settings(max_examples=40, deadline=None)
def test_scales_of_values_are_round_and_panels_fill_their_sheet(size, middle, count):
    curves = [Curve(size * (np.sin(PHI) + middle), panel=k) for k in range(count)]
    made = graph(curves, X, "φ", ["y"] * count, wide=180.0)
    assert made.size[1] <= (158 if count < 4 else 242)
    for panel in made.panels:
        assert is_round(panel.y_scale)
        assert (
            10
            <= (max(size * (1 + middle), 0) - min(size * (middle - 1), 0)) / panel.y_scale
            <= (50.001 if count > 1 else 70.001)
        )


def test_drawn_millimetres_times_the_scale_are_the_values():
    values = [0.2 * np.sin(PHI) + 0.1, -3000 * np.cos(PHI)]
    made = graph([Curve(y, panel=k) for k, y in enumerate(values)], X, "x", ["S", "a"], wide=180.0)
    for y, panel, line in zip(values, made.panels, lines(made), strict=True):
        assert (line.real - panel.left) * 2 == pytest.approx(X)
        assert (line.imag - panel.up(0.0)) * panel.y_scale == pytest.approx(y, abs=1e-9 * np.abs(y).max())


@pytest.mark.parametrize("name", ["crank_rocker", "slider_crank_offset"])
def test_scales_told_under_the_diagrams_are_those_they_are_drawn_at(name):
    found = solved(name).lever.kinematics
    diagrams, travel = Diagrams(found, Translator("ru")), found.travels[0]
    angle = np.degrees(1) if travel.output.kind == "rocker" else 1.0
    values = (travel.diagram_S * angle, travel.diagram_V, travel.diagram_a)
    degrees, *scales = scales_of(diagrams.travel(travel))
    assert degrees.unit == "°/mm"
    for line, y, scale in zip(lines(diagrams.travel(travel)), values, scales, strict=True):
        assert np.ptp(line.real) * degrees.number == pytest.approx(np.degrees(found.cycle.sweep))
        assert np.ptp(line.imag) * scale.number == pytest.approx(np.ptp(y)) and is_round(scale.number)


def test_ticks_of_values_stand_ten_millimetres_apart():
    made = drawn()
    for panel in made.panels:
        ticks = value_ticks(panel)
        assert len(ticks) >= 2 and np.diff(ticks) / panel.y_scale == pytest.approx(
            np.full(len(ticks) - 1, 10.0)
        )


@pytest.mark.parametrize("factor", [1e-7, 3.3, 1e9])
def test_every_range_has_ticks(factor):
    for share in np.linspace(-1, 0, 12):
        low, high = factor * share, factor * (share + 1)
        ticks = round_ticks(low, high)
        assert 2 <= len(ticks) <= 7 and low - 1e-5 * factor <= ticks[0] < ticks[-1] <= high + 1e-5 * factor


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (-2.5, "−2,5"), (123456, "123456"), (1.2345e-5, "0,00001234"), (2e-7, "0,0000002")],
)
def test_figures_have_four_digits_and_no_power(value, text):
    assert figure(value, True) == text


@pytest.mark.parametrize(("positions", "every"), [(12, 1), (24, 1), (36, 2), (60, 3)])
def test_positions_are_numbered_from_0_to_the_end_of_the_cycle_and_do_not_touch(positions, every):
    made = graph([Curve(np.cos(PHI))], X, "x", ["y"], wide=180.0, positions=positions)
    marks = list(position_marks(made.panels[0], positions))
    named = [(x, name) for x, name in marks if name]
    assert len(marks) == positions + 1 and marks[-1][0] == pytest.approx(made.panels[0].right)
    assert [name for _, name in named] == [str(k) for k in range(0, positions + 1, every)]
    edges = [(x - width((name,), 2.8) / 2, x + width((name,), 2.8) / 2) for x, name in named]
    assert all(one[1] < other[0] + 0.1 for one, other in pairwise(edges))


# --- curves


def test_noise_is_drawn_as_zero_and_has_no_extremes():
    noise = 1e-9 * np.sin(40 * X)
    whole, alone = Curve(np.cos(PHI) * 50 + 50 + noise / 1e3), Curve(noise, panel=1, scale=150.0)
    marked = Curve(whole.values, extremes=[(180.0, -8e-15), (0.0, 100.0)])
    assert whole.settled().values.min() == 0 < 1 < whole.settled().values.max()
    assert marked.settled().extremes == [(180.0, 0.0), (0.0, 100.0)]
    assert not alone.settled().values.any() and alone.settled().extremes == ()


def test_a_constant_has_no_extremes_and_a_small_curve_of_its_own_keeps_them():
    steady = Curve(12.57 + 1e-12 * np.sin(X), extremes=[(30.0, 12.57), (90.0, 12.57)])
    assert steady.settled().extremes == () and steady.settled().values == pytest.approx(12.57)
    assert Curve(1e-12 * np.sin(X)).settled().extremes is None


def test_a_curve_breaks_where_it_has_no_value():
    values = np.sin(PHI)
    values[[0, 10, 11]] = np.nan
    assert [len(stroke) for stroke in lines(graph([Curve(values)], X, "x", ["y"]))] == [9, 25]


def test_a_curve_without_any_value_leaves_an_empty_panel():
    made = graph([Curve(np.full(37, np.nan))], X, "x", ["y"])
    assert made.panels[0].y == (-1, 1) and lines(made) == []


@pytest.mark.parametrize("count", [127, 500])
def test_every_point_of_a_curve_is_drawn_however_many_there_are(count):
    x = np.linspace(0, 720, count)
    assert [len(line) for line in lines(graph([Curve(np.sin(np.radians(x)))], x, "x", ["y"]))] == [count]


def test_curves_differ_without_colour():
    (one, two), (third,) = drawn().of(0), drawn().of(1)
    assert one[1].corners != two[1].corners and one[1].pen.dash != two[1].pen.dash
    assert third[1] == one[1] and third[0].panel == 1


# --- values and names


def values_of(made):
    """Boxes of the values at extremes: the figures within the panels."""
    inside = [
        text
        for text in texts(made)
        if any(p.left < text.at.real < p.right and p.bottom < text.at.imag < p.top for p in made.panels)
    ]
    return [text.box for text in inside]


def test_extremes_given_are_marked_in_place_of_the_sampled_ones():
    made = graph([Curve(np.sin(PHI), extremes=[(90.0, 1.2345)])], X, "x", ["y"])
    written = ["".join(map(str, text.parts)) for text in texts(made)]
    assert ("1.234" in written or "1.235" in written) and "−1.2345" not in written


def test_values_cover_neither_one_another_nor_a_curve_nor_the_line_of_zero():
    curves = [
        Curve(np.sin(PHI)),
        Curve(np.sin(PHI + 0.1)),
        Curve(0.9 * np.sin(PHI)),
        Curve(0.06 + 0.94 * np.sin(PHI / 2)),
    ]
    made = graph(curves, X, "x", ["y"], wide=180.0)
    boxes, zero = values_of(made), made.panels[0].up(0.0)
    assert len(boxes) == 8
    assert not any(overlap(one, other) for k, one in enumerate(boxes) for other in boxes[:k])
    assert not any(foot < zero - 0.3 < zero + 0.3 < top for _, foot, _, top in boxes)
    fine = np.linspace(0, 180, 2000) + made.panels[0].left
    for line in lines(made):
        heights = np.interp(fine, line.real, line.imag)
        for left, foot, right, top in boxes:
            near = heights[(fine > left + 0.3) & (fine < right - 0.3)]
            assert not ((near > foot + 0.4) & (near < top - 0.4)).any()


def test_values_at_the_edges_stand_inside_their_panel():
    made = graph([Curve(np.cos(PHI), extremes=[(0, 1.0), (180, -1.0), (360, 1.0)])], X, "x", ["y"])
    panel, boxes = made.panels[0], values_of(made)
    assert len(boxes) == 3
    for left, foot, right, top in boxes:
        assert panel.left < left < right < panel.right and panel.bottom < foot < top < panel.top


def test_names_of_curves_stand_over_the_panel_and_of_many_in_rows():
    names = [f"кривая с длинным именем {k}" for k in range(5)]
    made = graph([Curve(np.sin(PHI + k), name, extremes=()) for k, name in enumerate(names)], X, "x", ["M"])
    named = [text for text in texts(made) if text.parts[0] in names]
    boxes = [text.box for text in named]
    assert len(named) == 5 and len({text.at.imag for text in named}) > 1
    assert min(box[1] for box in boxes) > made.panels[0].top and max(box[2] for box in boxes) <= made.size[0]
    assert max(box[3] for box in boxes) <= made.size[1]
    assert not any(overlap(one, other) for k, one in enumerate(boxes) for other in boxes[:k])


def test_a_graph_needs_no_library_of_graphs():
    code = (
        "import sys, numpy as np\n"
        "from tmm_report.figures.drawing import svg\n"
        "from tmm_report.figures.charts.graphs import Curve, graph\n"
        "svg(graph([Curve(np.ones(3))], np.array([0., 180., 360.]), 'x', ['y']).drawing)\n"
        "assert 'matplotlib' not in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_the_lines_that_join_extremes_are_broken_at_values():
    made = graph([Curve(np.sin(PHI)), Curve(np.cos(PHI), panel=1)], X, "x", ["y", "z"], wide=180.0)
    joined = [item.strokes[0] for item in made.drawing.items if isinstance(item, Path) and item.pen == JOINED]
    assert len(joined) > 8
    for start, end in joined:
        assert not any(
            left < start.real < right and start.imag < (foot + top) / 2 < end.imag
            for left, foot, right, top in values_of(made)
        )


@pytest.mark.parametrize("size", [1.0, 1e-9, 123456.0])
@pytest.mark.parametrize("extent", [90, 180, 360, 720, 1440])
def test_ticks_of_the_angle_stand_apart_whatever_room_the_figures_leave(extent, size):
    """Wide figures beside the axis leave a shorter one: fewer ticks stand on it."""
    turned = np.radians(np.linspace(0, extent, 37))
    graphs = CycleGraphs(turned, 0, Translator("en"))
    made = graphs.graph([Curve(size * np.sin(turned))], ["y"])
    assert made.step / made.panels[0].x_scale >= 9.0 - 1e-9
    assert made.panels[0].right <= 165.0
