"""Drawings of ordinary stages by what they show: senses of rotation, strands, threads, cones, read off their lines."""

import cmath
import math
from itertools import pairwise

import numpy as np
import pytest
from test_drive import PAIR, solve
from test_ordinary import (
    BELTS,
    BEVEL,
    CHAIN,
    CONES,
    EVERY,
    FRICTION,
    INNER,
    OBLIQUE,
    RINGED,
    TRAIN,
    WORM,
    turned_by_worm,
)

from tmm_report.chapters.gears.drive.draw.scheme import scheme
from tmm_report.chapters.gears.ordinary.draw import sketch
from tmm_report.figures.primitives import THICK, Arc, Path

SIDE_BY_SIDE = {
    **BELTS,
    "chain": CHAIN,
    "friction": FRICTION,
    "inner": INNER,
    "train": TRAIN,
    "ringed": RINGED,
}
HANDS = [(hand, place) for hand in ("right", "left") for place in ("above", "below")]


def drawn(stage):
    found = solve(stage)
    return found, sketch(found.stages[0], "")


def arrows(items):
    """Arcs with a head at their end: centre, radius, sense."""
    return [
        (one.centre, one.radius, np.sign(one.end - one.start))
        for one, head in pairwise(items)
        if isinstance(one, Arc) and isinstance(head, Path) and head.closed and head.pen is None
    ]


@pytest.mark.parametrize("name", SIDE_BY_SIDE)
def test_every_wheel_turns_as_in_the_train(name):
    found, drawing = drawn(SIDE_BY_SIDE[name])
    members = found.stages[0].members
    told = arrows(drawing.items)
    assert [sense for _, _, sense in told] == [
        np.sign(found.speed[one.name] / found.speed[members[0].name]) for one in members
    ]
    (scale,) = drawing.scales
    assert [at.real for at, _, _ in told] == pytest.approx([one.distance / scale.value for one in members])


@pytest.mark.parametrize("name", BELTS)
def test_the_belt_is_drawn_as_long_as_it_is(name):
    """Two strands square to the radii of both pulleys, and the arcs between their ends."""
    found, drawing = drawn(BELTS[name])
    n, (scale,) = found.stages[0].s.number, drawing.scales
    mm = 1 / scale.value
    one, two, far = n("d1") / 2 * mm, n("d2") / 2 * mm, n("a") * mm
    own = [item for item in drawing.items if getattr(item, "pen", None) is THICK]
    strands = [item.strokes[0] for item in own if isinstance(item, Path)]
    arcs = [item for item in own if isinstance(item, Arc)]
    assert len(strands) == len(arcs) == 2
    for start, end in strands:
        assert abs(start) == pytest.approx(one) and abs(end - far) == pytest.approx(two)
        assert ((end - start) * start.conjugate()).real == pytest.approx(0, abs=1e-9)
        assert ((end - start) * (end - far).conjugate()).real == pytest.approx(0, abs=1e-9)
        assert (start.imag * end.imag < 0) == (name == "crossed")
    ends = {complex(round(z.real, 6), round(z.imag, 6)) for strand in strands for z in strand}
    met = {
        complex(round(z.real, 6), round(z.imag, 6))
        for arc in arcs
        for z in (arc.at(arc.start), arc.at(arc.end))
    }
    assert ends == met
    long = sum(abs(end - start) for start, end in strands) + sum(
        arc.radius * abs(arc.end - arc.start) for arc in arcs
    )
    assert long / mm == pytest.approx(n("L"), rel=1e-9)


@pytest.mark.parametrize(("hand", "place"), HANDS)
def test_the_worm_is_drawn_with_its_hand_and_its_wheel_turning(hand, place):
    found, drawing = drawn(WORM | {"hand": hand, "worm": place})
    wheel, worm = arrows(drawing.items)
    assert wheel[0] == 0 and wheel[2] == np.sign(turned_by_worm(hand, place)) and worm[2] == 1
    assert (worm[0].imag > 0) == (place == "above") and worm[0].real < 0  # at its driving end
    assert leans(drawing.items) == {falls(hand)}
    shown = scheme(found.stages, found.plans, found.speed).items
    assert leans(shown) == {falls(hand)}
    ((_, _, sense),) = (one for one in arrows(shown) if one[1] != 3.2)  # beside those of the shafts
    assert sense == wheel[2]
    behind = solve(PAIR, WORM | {"hand": hand, "worm": place})  # the pair turns the worm the other way
    backwards = scheme(behind.stages, behind.plans, behind.speed).items
    assert [one[2] for one in arrows(backwards) if one[1] > 5] == [-wheel[2]]


def falls(hand):
    """Whether the near side of a thread along x goes down to the right: its tangent at the point towards the reader."""
    lead = 0.2 if hand == "right" else -0.2
    along = np.array([lead, 0, 0]) + np.cross([1, 0, 0], [0, 0, 1])
    return bool(along[1] / along[0] < 0)


def leans(items):
    """Whether the lines of the thread fall to the right: seven alike beside one another."""
    strokes = [item.strokes[0] for item in items if isinstance(item, Path) and not item.closed]
    lines = [one[1] - one[0] for one in strokes if len(one) == 2]
    oblique = [one for one in lines if abs(one.real) > 1e-9 and abs(one.imag) > 1e-9]
    alike = [one for one in oblique if sum(abs(one - other) < 1e-9 for other in oblique) == 7]
    assert len(alike) == 7
    return {bool(one.imag / one.real < 0) for one in alike}


@pytest.mark.parametrize("stage", [BEVEL, OBLIQUE, CONES], ids=["bevel", "oblique", "friction"])
def test_the_cones_are_drawn_with_their_angles(stage):
    found, drawing = drawn(stage)
    n = found.stages[0].s.number
    for items in (drawing.items, scheme(found.stages, found.plans, found.speed).items):
        halves = [half for item in items if (half := half_angle(item)) is not None]
        assert halves == pytest.approx([n("delta1"), n("delta2")])


def half_angle(item):
    """Of the frustum of a cone, degrees; None of anything else."""
    if not (isinstance(item, Path) and item.closed and item.pen is not None and len(item.strokes[0]) == 4):
        return None
    one, two, three, four = item.strokes[0]
    between = abs(math.degrees(cmath.phase((two - one) / (three - four))))
    return between / 2 if between > 1e-6 else None


def test_every_kind_has_its_drawing():
    assert all(drawn(stage)[1].items for stage in EVERY.values())
