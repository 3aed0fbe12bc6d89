"""Loading schemes: arms have their true lengths and lie beside one another, forces point as they act."""

from __future__ import annotations

import cmath
from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.figures.drawing import Arc, Arrow, line
from tmm_report.figures.lettering import Symbol
from tmm_report.figures.loading import Arm, Couple, Force, loading

PLACES = st.complex_numbers(max_magnitude=80, allow_nan=False, allow_infinity=False)
WAYS = st.floats(0, 6.28).map(lambda angle: cmath.rect(1, angle))


def arrows(drawing, key):
    return [item for item in drawing.items if isinstance(item, Arrow) and item.of == key]


@given(PLACES, PLACES, WAYS)
def test_an_arm_is_the_distance_of_its_line(centre, at, along):
    distance = abs(((at - centre) * along.conjugate()).imag)
    found = arrows(loading([], [], [], [Arm(centre, at, along, None, "h")]), "h")
    if distance < 0.5:
        assert not found or abs(found[0].end - found[0].start) == pytest.approx(distance, abs=1e-9)
        return
    (drawn,) = found
    assert abs(drawn.end - drawn.start) == pytest.approx(distance, abs=1e-9)
    # its end is on the line, and it is across it
    assert ((drawn.end - at) * along.conjugate()).imag == pytest.approx(0.0, abs=1e-9)
    assert ((drawn.end - drawn.start) * along.conjugate()).real == pytest.approx(0.0, abs=1e-9)


def test_arms_of_parallel_forces_stand_side_by_side():
    arms = [Arm(0j, complex(x, 10), -1j, Symbol("h", str(x)), f"h{x}") for x in (30, 50, 70)]
    drawing = loading([line(0j, 90 + 0j)], [], [], arms)
    heights = [arrows(drawing, arm.of)[0].start.imag for arm in arms]
    assert all(abs(one - other) >= 2.2 for one, other in combinations([*heights, 0.0], 2))
    assert [abs(arrows(drawing, arm.of)[0].end - arrows(drawing, arm.of)[0].start) for arm in arms] == [
        30,
        50,
        70,
    ]


@given(st.lists(st.floats(1.0, 1e4), min_size=1, max_size=5), WAYS)
def test_arrows_hint_at_sizes_and_point_as_the_forces(sizes, way):
    forces = [Force(complex(40 * k, 0), size * way, None, "force", f"F{k}") for k, size in enumerate(sizes)]
    drawing = loading([], [], forces)
    lengths = []
    for force in forces:
        (drawn,) = arrows(drawing, force.of)
        assert (drawn.end - drawn.start) / abs(drawn.end - drawn.start) == pytest.approx(way)
        lengths.append(abs(drawn.end - drawn.start))
    assert sorted(lengths) == pytest.approx(
        [length for _, length in sorted(zip(sizes, lengths, strict=True))]
    )


def test_forces_on_one_line_are_told_apart():
    forces = [Force(0j, 5.0 + 0j, None, "force", "G"), Force(0j, 7.0 + 0j, None, "reaction", "R")]
    one, other = (arrows(loading([], [], forces), key)[0] for key in ("G", "R"))
    assert abs(one.start.imag - other.start.imag) > 1.0


def test_an_assumed_sense_is_dashed_and_unmarked():
    forces = [
        Force(0j, 5.0j, None, "reaction", "R_t"),
        Force(0j, -5.0j, None, "reaction", "R_t", assumed=True),
    ]
    drawing = loading([], [], forces)
    assert len(arrows(drawing, "R_t")) == 1
    assert [item.pen.dash for item in arrows(drawing, "")] != [()]


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_couple_turns_in_its_sense(sense):
    drawing = loading([], [], [], [], [Couple(0j, sense, Symbol("M"))])
    (arc,) = (item for item in drawing.items if isinstance(item, Arc))
    assert (arc.end - arc.start) * sense > 0
