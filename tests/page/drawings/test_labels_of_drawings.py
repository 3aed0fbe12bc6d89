"""Labels of all drawings of all notes, by the drawings' own boxes: each read without doubt, on a sheet at full size."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
import pytest
from reading import CHOSEN, drawings, wrong

from tmm_report.figures.drawing import Circle, Drawing, Item, Path, Text
from tmm_report.figures.lettering import tex_parts
from tmm_report.report.paper.sheets import USUAL

SLACK = 0.15  # mm: lettering may touch its neighbour by so much
NARROW = (
    0.1  # a box is as wide as the widest of the fonts: the free end of the text is short of it by this part
)
UNSEEN = ("white", "pale")  # colours of lines that lettering may stand on


def words(text: Text) -> str:
    return "".join(part if isinstance(part, str) else part.base + part.sub + part.sup for part in text.parts)


def box(text: Text) -> tuple[float, float, float, float]:
    """What the letters of a text really take, mm."""
    left, bottom, right, top = text.box
    spare = NARROW * (right - left)
    left, right = left + spare * (1 + text.align) / 2, right - spare * (1 - text.align) / 2
    return left + SLACK, bottom + SLACK, right - SLACK, top - SLACK


def texts(drawing: Drawing) -> list[Text]:
    return [item for item in drawing.items if isinstance(item, Text)]


def seen(item: Item) -> bool:
    """Whether an item is lines, or a fill of its own: a plate and a grid are none."""
    if isinstance(item, Text):
        return False
    colour = item.pen.colour if item.pen else item.fill if isinstance(item, Path | Circle) else "black"
    return colour not in UNSEEN


def lines(drawing: Drawing) -> np.ndarray:
    """All that is drawn as segments, complex (M, 2), mm."""
    strokes = [stroke for item in drawing.items if seen(item) for stroke in item.outline()]
    return np.array([pair for stroke in strokes for pair in pairwise(stroke)], complex).reshape(-1, 2)


def inside(segments: np.ndarray, corners: tuple[float, float, float, float]) -> float:
    """The longest part of a segment in a box, mm."""
    start, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    low, high = np.zeros(len(segments)), np.ones(len(segments))
    for at, by, least, most in (
        (start.real, along.real, corners[0], corners[2]),
        (start.imag, along.imag, corners[1], corners[3]),
    ):
        by = np.where(abs(by) < 1e-9, 1e-9, by)
        one, other = (least - at) / by, (most - at) / by
        low, high = np.maximum(low, np.minimum(one, other)), np.minimum(high, np.maximum(one, other))
    return float((np.clip(high - low, 0.0, None) * abs(along)).max(initial=0.0))


def overlapping(drawing: Drawing) -> Iterator[str]:
    some = texts(drawing)
    boxes = np.array([box(text) for text in some]).reshape(-1, 4)
    low = np.maximum(boxes[:, None, :2], boxes[:, :2])
    high = np.minimum(boxes[:, None, 2:], boxes[:, 2:])
    for one, other in np.argwhere(np.triu((low < high).all(axis=-1), 1)):
        yield f"{words(some[one])!r} lies on {words(some[other])!r}"


def crossed(drawing: Drawing) -> Iterator[str]:
    drawn = lines(drawing)
    for text in texts(drawing):
        if (length := inside(drawn, box(text))) > 0.05:
            yield f"{words(text)!r} is crossed by {length:.2f} mm of a line"


def of_all(name: str, found) -> list[str]:
    return [f"{anchor}: {fault}" for anchor, drawing in drawings(name).items() for fault in found(drawing)]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", CHOSEN)
def test_no_label_lies_on_another(name):
    wrong(of_all(name, overlapping))


@pytest.mark.parametrize("name", CHOSEN)
def test_no_line_goes_through_a_label(name):
    wrong(of_all(name, crossed))


@pytest.mark.parametrize("name", CHOSEN)
def test_every_drawing_is_on_a_sheet_at_its_full_size(name):
    wrong([f"{a} is reduced: {d.size}" for a, d in drawings(name).items() if USUAL.percent(d.size) < 100])


@pytest.mark.parametrize("name", CHOSEN)
def test_no_white_box_lies_over_lines(name):
    boxes = [
        f"{anchor}: a white box without an outline"
        for anchor, drawing in drawings(name).items()
        for item in drawing.items
        if isinstance(item, Path) and item.pen is None and item.fill == "white"
    ]
    wrong(boxes)


@pytest.mark.parametrize("name", CHOSEN)
def test_latex_has_every_character_of_the_labels(name):
    lost = [
        f"{anchor}: {words(text)!r}"
        for anchor, drawing in drawings(name).items()
        for text in texts(drawing)
        if "?" in tex_parts(text.parts) and "?" not in words(text)
    ]
    wrong(lost)


def test_faults_of_lettering_are_seen():
    """The tests above on a drawing that has them."""
    text = Text(0j, ("AB",))
    across = Path(((-5 + 0j, 20 + 0j),))
    assert list(overlapping(Drawing((text, Text(2 + 0j, ("C",)))))) and list(crossed(Drawing((text, across))))
    far = Text(30 + 0j, ("C",))
    assert not list(overlapping(Drawing((text, far)))) and not list(
        crossed(Drawing((text, across.moved(5j))))
    )
