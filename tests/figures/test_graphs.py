"""Graphs: text of the user stays text, the same data give the same bytes, pyplot is not loaded."""

import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from itertools import pairwise

import numpy as np
import pytest
from conftest import solved

pytest.importorskip("matplotlib")
from tmm_report.chapters.kinematics.draw import Diagrams
from tmm_report.figures.axes import round_ticks
from tmm_report.figures.graphs import VALUE, Curve, _drawn_points, _freest, _positions, _values, graph
from tmm_report.figures.lettering import width
from tmm_report.i18n import Translator

X = np.linspace(0, 360, 37)
NAME = "_ползун $x_1^$ <b>&"


def drawn(shift=0.0):
    phi = np.radians(X)
    curves = [Curve(np.sin(phi) + shift, NAME), Curve(0.5 * np.cos(phi), "D"), Curve(np.cos(phi), "", 1)]
    return graph(curves, X, "φ, град", ["S, м", "V $, м/с"], positions=12, comma=True, title="Диаграмма <S>")


def test_svg_is_well_formed_inline_and_keeps_text():
    text = drawn().svg()
    root = ET.fromstring(text)
    words = ["".join(node.itertext()).strip() for node in root.iter("{http://www.w3.org/2000/svg}text")]
    assert text.startswith("<svg") and NAME in words and "V $, м/с" in words and "−0,5" in words
    assert [words.count(number) >= 1 for number in ("11", "360")] == [True, True]
    assert root.find("{http://www.w3.org/2000/svg}title").text == "Диаграмма <S>"
    assert "http" not in re.sub(r'xmlns(:\w+)?="[^"]*"', "", text)


def test_ids_are_used_and_differ_between_graphs():
    one, other = (set(re.findall(r' id="([^"]+)"', drawn(shift).svg())) for shift in (0.0, 0.2))
    assert one and not one & other
    assert all(f"#{name}" in drawn().svg() for name in one)


def test_the_same_data_give_the_same_bytes():
    assert drawn().svg() == drawn().svg()
    assert drawn().pdf() == drawn().pdf() and drawn().pdf().startswith(b"%PDF")


def test_extremes_given_are_marked_in_place_of_the_sampled_ones():
    curve = Curve(np.sin(np.radians(X)), extremes=[(90.0, 1.2345)])
    text = graph([curve], X, "x", ["y"]).svg()
    assert "1.234" in text or "1.235" in text
    assert "−1.2345" not in text


def test_noise_is_drawn_as_zero_and_has_no_extremes():
    noise = 1e-9 * np.sin(40 * X)
    whole, alone = Curve(np.cos(np.radians(X)) * 50 + 50 + noise / 1e3), Curve(noise, panel=1, scale=150.0)
    marked = Curve(whole.values, extremes=[(180.0, -8e-15), (0.0, 100.0)])
    assert whole.settled().values.min() == 0 < 1 < whole.settled().values.max()
    assert marked.settled().extremes == [(180.0, 0.0), (0.0, 100.0)]
    assert not alone.settled().values.any() and alone.settled().extremes == ()
    assert "e−" not in graph([whole, alone], X, "x", ["y", "z"]).svg()


def test_a_constant_has_no_extremes_and_a_small_curve_of_its_own_keeps_them():
    steady = Curve(12.57 + 1e-12 * np.sin(X), extremes=[(30.0, 12.57), (90.0, 12.57)])
    assert steady.settled().extremes == () and steady.settled().values == pytest.approx(12.57)
    assert Curve(1e-12 * np.sin(X)).settled().extremes is None


@pytest.mark.parametrize("sign", [1, -1])
def test_a_value_is_not_written_across_the_line_of_zero(sign):
    made = graph([Curve(sign * (6 + 94 * np.sin(np.radians(X) / 2)))], X, "x", ["y"])
    zero = made.panels[0].up(0.0)
    boxes = [box for _, box in _values(made, made.panels[0], made.curves[0])]
    assert len(boxes) == 2 and not any(foot < zero < foot + tall for _, foot, _, tall in boxes)


def test_values_at_the_edges_stand_inside_their_panel():
    made = graph([Curve(np.cos(np.radians(X)), extremes=[(0, 1.0), (180, -1.0), (360, 1.0)])], X, "x", ["y"])
    panel = made.panels[0]
    for _, (left, foot, wide, tall) in _values(made, panel, made.curves[0]):
        assert panel.left < left < left + wide < panel.right
        assert panel.bottom < foot < foot + tall < panel.top


def test_curves_differ_without_colour():
    (one, two), (third,) = drawn().of(0), drawn().of(1)
    assert one[1].marker != two[1].marker and one[1].dash != two[1].dash
    assert third[1] == one[1] and third[0].panel == 1


def test_width_is_that_of_the_text_of_a_page():
    wide, tall = drawn().size
    head = drawn().svg()[:200]
    assert wide == 165 and f'width="{wide * 72 / 25.4:.6f}pt" height="{tall * 72 / 25.4:.6f}pt"' in head


def lines(svg, colour="#000000", pen="1.1"):
    """Strokes of a curve as drawn, mm from the lower left corner of the sheet: [(N, 2), ...]."""
    tall = float(re.search(r'height="([\d.]+)pt"', svg)[1])
    paths = re.findall(rf'<path d="([^"]+)"[^>]*stroke: {colour}; stroke-width: {pen}[;"]', svg)
    strokes = [stroke for path in paths for stroke in path.split("M") if stroke.strip()]
    points = [np.array(re.findall(r"[-\d.]+", stroke), float).reshape(-1, 2) for stroke in strokes]
    return [np.stack([stroke[:, 0], tall - stroke[:, 1]], axis=1) * 25.4 / 72 for stroke in points]


def test_drawn_millimetres_times_the_scale_are_the_values():
    phi = np.radians(X)
    values = [0.2 * np.sin(phi) + 0.1, -3000 * np.cos(phi)]
    made = graph([Curve(y, panel=k) for k, y in enumerate(values)], X, "x", ["S", "a"])
    for y, panel, line in zip(values, made.panels, lines(made.svg(), pen="1.1"), strict=True):
        assert (line[:, 0] - panel.left) * panel.x_scale + X[0] == pytest.approx(X, abs=1e-3)
        heights = line[:, 1] - panel.up(0.0)
        assert heights * panel.y_scale == pytest.approx(y, abs=1e-5 * np.abs(y).max())
        assert panel.y[1] - panel.y[0] == pytest.approx(panel.tall * panel.y_scale)


@pytest.mark.parametrize("name", ["crank_rocker", "slider_crank_offset"])
def test_scales_told_under_the_diagrams_are_those_they_are_drawn_at(name):
    found = solved(name).lever.kinematics
    diagrams, travel = Diagrams(found, Translator("ru")), found.travels[0]
    angle = np.degrees(1) if travel.output.kind == "rocker" else 1.0
    values = (travel.diagram_S * angle, travel.diagram_V, travel.diagram_a)
    across, *scales = diagrams.scales(travel)
    for line, y, scale in zip(lines(diagrams.travel(travel).svg()), values, scales, strict=True):
        assert np.ptp(line[:, 0]) * across.number == pytest.approx(np.degrees(found.cycle.sweep), rel=1e-6)
        assert np.ptp(line[:, 1]) * scale.number == pytest.approx(np.ptp(y), rel=1e-5)


def test_a_curve_breaks_where_it_has_no_value():
    values = np.sin(np.radians(X))
    values[[0, 10, 11]] = np.nan
    assert [len(stroke) for stroke in lines(graph([Curve(values)], X, "x", ["y"]).svg())] == [9, 25]


def test_a_curve_without_any_value_leaves_an_empty_panel():
    made = graph([Curve(np.full(37, np.nan))], X, "x", ["y"])
    assert made.panels[0].y == (-1, 1) and lines(made.svg()) == []


def test_extremes_between_the_points_fit_into_the_panel():
    made = graph([Curve(np.zeros(37) + np.sin(np.radians(X)), extremes=[(85.0, 5.0)])], X, "x", ["y"])
    assert made.panels[0].y[1] > 5


@pytest.mark.parametrize(
    ("low", "high", "ticks"),
    [
        (-0.03, 0.23, [0, 0.05, 0.1, 0.15, 0.2]),
        (-17.4, 17.4, [-10, 0, 10]),
        (-1614, 2620, [-1000, 0, 1000, 2000]),
        (-400.0, 240.0, [-400, -200, 0, 200]),
        (-1.0, 1.0, [-0.8, -0.4, 0, 0.4, 0.8]),
    ],
)
def test_ticks_are_round_and_not_too_many(low, high, ticks):
    assert round_ticks(low, high) == pytest.approx(ticks)


@pytest.mark.parametrize("factor", [1e-7, 3.3, 1e9])
def test_every_range_has_ticks(factor):
    for share in np.linspace(-1, 0, 12):
        low, high = factor * share, factor * (share + 1)
        ticks = round_ticks(low, high)
        assert 2 <= len(ticks) <= 7 and low - 1e-5 * factor <= ticks[0] < ticks[-1] <= high + 1e-5 * factor


def test_legend_hides_no_curve_and_no_value():
    falling, rising = np.linspace(1, -1, 37), np.linspace(-1, 1, 37)
    curves = [Curve(falling, "λ1"), Curve(rising, "λ2")]
    made = graph(curves, X, "x", ["y"])
    points = _drawn_points(made, made.panels[0], made.curves)
    left, foot = _freest(made.panels[0], 18.0, 9.0, points)
    inside = (points > (left, foot)).all(axis=1) & (points < (left + 18, foot + 9)).all(axis=1)
    assert not inside.any()


@pytest.mark.parametrize(("positions", "last"), [(12, "11"), (24, "23"), (36, "34"), (60, "57")])
def test_numbers_of_positions_do_not_touch(positions, last):
    made = graph([Curve(np.cos(np.radians(X)))], X, "x", ["y"], positions=positions)
    named = [(x, name) for x, name in _positions(made) if name]
    assert len(list(_positions(made))) == positions + 1
    assert (named[0][1], named[-2][1], named[-1][1]) == ("0", last, "0")
    edges = [(x - width((name,), VALUE) / 2, x + width((name,), VALUE) / 2) for x, name in named]
    assert all(one[1] < other[0] + 0.1 for one, other in pairwise(edges))


def test_matplotlib_is_loaded_only_by_a_graph_and_pyplot_never():
    code = (
        "import sys, numpy as np\n"
        "import tmm_report.figures.scheme, tmm_report.figures.plans\n"
        "from tmm_report.figures.graphs import Curve, graph\n"
        "assert 'matplotlib' not in sys.modules\n"
        "graph([Curve(np.ones(3))], np.array([0., 180., 360.]), 'x', ['y']).svg()\n"
        "assert 'matplotlib.pyplot' not in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("count", [127, 128, 500])
def test_every_point_of_a_curve_is_drawn_however_many_there_are(count):
    """matplotlib leaves out points of long lines that hardly change them, unless it is told otherwise."""
    x = np.linspace(0, 720, count)
    text = graph([Curve(np.sin(np.radians(x)))], x, "x", ["y"]).svg()
    longest = max(text_of.count("L") for text_of in re.findall(r'<path d="([^"]*)"', text))
    assert longest == count - 1
