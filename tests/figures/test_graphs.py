"""Graphs: text of the user stays text, the same data give the same bytes, pyplot is not loaded."""

import re
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest

pytest.importorskip("matplotlib")
from tmm_report.figures.graphs import Curve, graph

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
    values = sign * (6 + 94 * np.sin(np.radians(X) / 2))
    axes = graph([Curve(values)], X, "x", ["y"]).figure.axes[0]
    zero = axes.transData.transform((0, 0))[1]
    boxes = [text.get_window_extent() for text in axes.texts]
    assert len(boxes) == 2 and not any(box.y0 < zero < box.y1 for box in boxes)


def test_curves_differ_without_colour():
    figure = drawn().figure
    looks = [
        (line.get_linestyle(), line.get_marker())
        for line in figure.axes[0].get_lines()
        if len(line.get_xdata()) > 2
    ]
    assert len(looks) == 2 and looks[0][1] != looks[1][1]


def test_width_is_that_of_the_text_of_a_page():
    assert drawn().figure.get_size_inches()[0] * 25.4 == pytest.approx(165)


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
