"""Long strokes are drawn through fewer of their points: what is left out lies on the line, what is held stays."""

import numpy as np
import pytest

from tmm_report.figures.drawing import Drawing, Path, svg
from tmm_report.figures.primitives import dot, polyline
from tmm_report.figures.thinning import APART, SHORT, thinned

TURN = np.linspace(0, 2 * np.pi, 1441)
CURVES = {
    "a circle": 40 * np.exp(1j * TURN),
    "a wave": 28 * TURN + 20j * np.sin(3 * TURN),
    "a corner": 10 * TURN + 30j * np.abs(TURN - 2),
    "a jump": 10 * TURN + 25j * (TURN > 3),
    "there and back": 30 * np.sin(TURN) + 0j,
    "a level": 28 * TURN + 5j,
    "a point": np.full(60, 3 + 4j),
}


def away(points: np.ndarray, line: np.ndarray) -> np.ndarray:
    """Distances of points from a polyline, each segment by itself."""
    start, chord = line[:-1], np.diff(line)
    off = points[:, None] - start
    share = np.clip((off * chord.conj()).real / np.maximum(np.abs(chord) ** 2, 1e-300), 0, 1)
    return np.abs(off - share * chord).min(axis=1)


@pytest.mark.parametrize("name", CURVES)
def test_what_is_left_out_lies_on_the_line(name):
    points = CURVES[name]
    (path,) = thinned([polyline(points.tolist())])
    (line,) = path.strokes
    assert set(line) <= set(points.tolist()) and (line[0], line[-1]) == (points[0], points[-1])
    assert len(line) < 0.7 * len(points)
    assert away(points, np.array(line)).max() <= APART
    assert away(points, np.array(line)[::2]).max() > APART or name in ("a level", "a point", "there and back")


def test_points_held_stay_and_others_are_left_as_they_are():
    points = CURVES["a level"].tolist()
    held = points[7], points[100]
    short = tuple(points[:SHORT])
    disc = dot(1j)
    one, two, three = thinned([Path((tuple(points), short), held=frozenset(held)), disc, polyline(short)])
    assert set(held) <= set(one.strokes[0]) and len(one.strokes[0]) < 110
    assert one.strokes[1] == short and two is disc and three.strokes == (short,)


def test_the_values_of_a_graph_are_true_where_it_is_steep():
    x = np.linspace(0, 100, 801)
    points = x + 40j * np.tanh((x - 41.7) / 8)
    (path,) = thinned([Path((tuple(points.tolist()),), held=frozenset([complex(points[400])]))])
    line = np.array(path.strokes[0])
    assert len(line) < 0.5 * len(points)
    assert np.abs(np.interp(x, line.real, line.imag) - points.imag).max() <= APART


def test_strokes_of_one_drawing_do_not_touch_one_another():
    curves = list(CURVES.values())
    together = thinned([Path(tuple(tuple(curve.tolist()) for curve in curves))])[0].strokes
    assert list(together) == [thinned([polyline(curve.tolist())])[0].strokes[0] for curve in curves]


def test_a_moved_curve_is_drawn_through_the_same_of_its_points():
    points = tuple(CURVES["a wave"].tolist())
    path = Path((points,), held=frozenset(points[::30]))
    drawn = [svg(Drawing((one,))).count("L") for one in (path, path.moved(8 + 4j))]
    assert drawn[0] == drawn[1] < 0.7 * len(points)
