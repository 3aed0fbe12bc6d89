"""Vectors upon one another are drawn side by side, moved across their own line and measured between ticks."""

from __future__ import annotations

import cmath

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.figures.aside import SPACING, asides, lie_upon
from tmm_report.figures.drawing import THIN, Arrow, Path
from tmm_report.figures.plans import PlanVector, plan

TURNS = st.floats(0, 6.28).map(lambda angle: cmath.rect(1, angle))


def test_vectors_that_only_touch_keep_their_line():
    assert asides([(0, 50), (50, 80), (0, 40j), (80, 80 + 1j)]) == [0, 0, 0, 0]


def test_a_dead_point_is_seen_whole():
    """v_A, v_BA back to the pole, and a third upon both."""
    found = asides([(0, 50), (50, 0), (10, 40)])
    assert found[0] == 0
    sides = [0.0, -found[1], found[2]]  # the second points the other way: its left is the right of the first
    assert sorted(sides) == pytest.approx([-SPACING, 0, SPACING])


@given(TURNS, st.lists(st.tuples(st.floats(-60, 60), st.floats(5, 60), st.booleans()), max_size=6))
def test_no_two_of_one_line_lie_upon_one_another(turn, spans):
    segments = [(turn * at, turn * (at + size)) for at, size, _ in spans]
    segments = [one[::-1] if back else one for one, (*_, back) in zip(segments, spans, strict=True)]
    moved = []
    for (start, end), aside in zip(segments, asides(segments), strict=True):
        by = 1j * aside * (end - start) / abs(end - start)
        moved.append((start + by, end + by))
    assert not any(lie_upon(one, other) for i, one in enumerate(moved) for other in moved[:i])


@given(TURNS)
def test_lines_a_little_apart_or_across_do_not_lie_upon_one_another(turn):
    one = (0j, 50 * turn)
    assert lie_upon(one, (10 * turn, (30 + 0.2j) * turn))
    assert not lie_upon(one, ((10 + 1j) * turn, (30 + 1j) * turn))
    assert not lie_upon(one, ((20 - 10j) * turn, (20 + 10j) * turn))
    assert not lie_upon(one, (0j, 50 * turn * cmath.rect(1, 0.1)))


def test_a_moved_arrow_keeps_length_and_direction_and_ticks_lead_to_its_ends():
    drawn = plan(
        [PlanVector(0, 50, None, "absolute", "v_A"), PlanVector(50, 0, None, "relative", "v_BA")], {}
    )
    arrows = {item.of: item for item in drawn.items if isinstance(item, Arrow)}
    thick, moved = arrows["v_A"], arrows["v_BA"]
    assert (thick.start, thick.end, thick.aside) == (0, 50, 0)
    assert moved.end - moved.start == -50 and abs(moved.aside) == SPACING
    ticks = [item.strokes[0] for item in drawn.items if isinstance(item, Path) and item.pen == THIN]
    assert [tick[0] for tick in ticks] == [50, 0]
    for tick, end in zip(ticks, (moved.start, moved.end), strict=True):
        assert abs(tick[1] - tick[0]) > abs(end - tick[0]) == SPACING
    assert 'data-aside="1.3"' in moved.svg([]) and "data-aside" not in thick.svg([])


def test_a_drawing_all_on_one_line_has_room_for_its_letters():
    line = [(0, 50), (50, 0), (10, 40)]
    assert sorted(map(abs, asides(line, [5, 6, 4]))) == [0, 6, 6]
    assert sorted(map(abs, asides([*line, (0, 40j)], [5, 6, 4, 5]))) == [0, 0, SPACING, SPACING]
