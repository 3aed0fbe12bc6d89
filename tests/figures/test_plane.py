"""Curves of one quantity against another: what is drawn where, and at which scale."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.figures.charts.plane import FIELD, Frame, Spot, Trace, framed, plane
from tmm_report.figures.drawing import Path, Text, svg, tikz
from tmm_report.figures.lettering import Label
from tmm_report.quantity.symbols import Symbol

ROUND = (1.0, 1.25, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0)
TURN = np.exp(1j * np.linspace(0, 2 * np.pi, 41)[:-1])


def num(x: float) -> str:
    return f"{x:g}"


def texts(drawing) -> list[str]:
    return ["".join(str(part) for part in item.parts) for item in drawing.items if isinstance(item, Text)]


@given(st.floats(1e-6, 1e6), st.floats(1e-6, 1e6), st.floats(-10, 10))
def test_a_frame_holds_its_curves_and_zero_within_the_field(wide, tall, aside):
    curve = wide * (TURN.real + aside) + 1j * tall * TURN.imag
    frame = framed([curve])
    assert all(frame.holds(z) for z in [*curve, 0j])
    for scale, filled, room in zip(
        (frame.x_scale, frame.y_scale), (frame.corner.real, frame.corner.imag), FIELD, strict=True
    ):
        assert round(scale / 10 ** np.floor(np.log10(scale * (1 + 1e-9))), 6) in ROUND
        assert room / 1.6 * (1 - 1e-6) <= filled <= room * (1 + 1e-6)  # 1.25 is followed by 2


def test_vectors_keep_their_angles():
    frame = framed([TURN * np.array(5.0), np.array([30 + 2j])], equal=True)
    assert frame.x_scale == frame.y_scale == 0.4  # of 0.33 that would fill the field
    one, other = frame.at(0j), frame.at(3 + 4j)
    assert (other - one) / abs(other - one) == pytest.approx(0.6 + 0.8j)


def test_stated_scales_are_those_of_the_paper():
    frame = framed([TURN], scales=(0.02, 0.05))
    assert frame.at(1 + 1j) - frame.at(0j) == pytest.approx(50 + 20j)


def test_a_picture_tells_the_scales_of_the_axes_that_know_what_they_are():
    x, y = (Label.made((letter,), Symbol(letter), unit) for letter, unit in (("J", "kg·m²"), ("T", "J")))
    told = plane(framed([TURN], scales=(0.02, 0.05)), [Trace(TURN)], x, y, num).scales
    assert [(one.of.base, one.value, one.unit) for one in told] == [("J", 0.02, "kg·m²"), ("T", 0.05, "J")]
    assert plane(framed([TURN]), [Trace(TURN)], ("x",), ("y",), num).scales == ()


def test_a_curve_is_drawn_through_its_places_and_closes():
    frame = framed([TURN])
    drawing = plane(frame, [Trace(TURN, closed=True)], ("x",), ("y",), num)
    curve = max(
        (item for item in drawing.items if isinstance(item, Path)), key=lambda path: len(path.strokes[0])
    )
    (stroke,) = curve.strokes
    assert stroke[0] == stroke[-1] and len(stroke) == len(TURN) + 1
    assert stroke[10] == pytest.approx(frame.at(TURN[10]))


def test_what_is_nan_breaks_a_curve():
    broken = np.where(np.arange(40) == 20, np.nan, TURN)
    drawing = plane(framed([broken]), [Trace(broken)], ("x",), ("y",), num)
    long = [item for item in drawing.items if isinstance(item, Path) and len(item.strokes[0]) > 10]
    assert [len(path.strokes[0]) for path in long] == [20, 19]


def test_figures_stand_by_their_ticks():
    frame = Frame(-1 - 1j, 1 + 1j, 0.02, 0.02)
    drawing = plane(frame, [], ("x",), ("y",), num)
    figures = [item for item in drawing.items if isinstance(item, Text) and item.parts[0] not in ("x", "y")]
    across = {item.parts[0]: item.at.real for item in figures if item.align == 0}
    assert len(across) >= 3
    for text, place in across.items():
        assert place == pytest.approx(frame.at(complex(float(text), 0)).real)


def test_names_and_spots_are_written_in_both_formats():
    drawing = plane(
        framed([TURN]), [Trace(TURN, ("before",)), Trace(TURN / 2, ("after",))], ("x",), ("y",), num,
        spots=[Spot(1 + 0j, ("a",))],
    )  # fmt: skip
    assert {"before", "after", "a"} <= set(texts(drawing))
    for written in (svg(drawing), tikz(drawing)):
        assert "before" in written and "after" in written


def test_the_hodograph_of_what_has_one_direction_is_wide_enough_for_its_figures():
    drawing = plane(framed([1j * np.linspace(-700, 600, 9)], equal=True), [], ("x",), ("y",), num)
    boxes = [
        text.box
        for text in drawing.items
        if isinstance(text, Text) and text.align == 0 and text.parts != ("x",)
    ]
    assert len(boxes) >= 2 and all(one[2] < other[0] for one, other in pairwise(sorted(boxes)))


def test_figures_that_would_touch_are_left_out():
    drawing = plane(Frame(-2 - 2j, 2 + 2j, 0.1, 0.1), [], ("x",), ("y",), lambda x: f"{x:+.7f}")
    boxes = [
        text.box
        for text in drawing.items
        if isinstance(text, Text) and text.align == 0 and text.parts != ("x",)
    ]
    assert len(boxes) >= 2 and all(one[2] < other[0] for one, other in pairwise(sorted(boxes)))
