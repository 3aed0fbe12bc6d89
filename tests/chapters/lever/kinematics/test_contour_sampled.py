"""Points sampled in the blocking contour all solve, with every condition met; points outside all name their limit."""

import math
from dataclasses import replace

import numpy as np
import pytest
from exhaustive import many

from tmm_report.chapters.gears.spur.given import Given
from tmm_report.chapters.gears.spur.solve.conditions import BY_ASSEMBLY, KEYS, conditions_of
from tmm_report.chapters.gears.spur.solve.contour import contour_of
from tmm_report.chapters.gears.spur.solve.mistakes import check, check_pair, check_teeth
from tmm_report.chapters.gears.spur.solve.motion import WIDEST
from tmm_report.chapters.gears.spur.solve.sizes import choose_shifts, choose_teeth
from tmm_report.mechanics.gears.meshing import Cutter
from tmm_report.problems import ProblemError

DRAWN = 30000  # in the window of the contour
COUNT = 125  # of points on each side, of each of the eight pairs
PLAIN = Given(-2.0, 2e-3, None, (17, 34), shift=(0.2, 0.2))
RING = Given(3.0, 3e-3, None, (25, 75), shift=(0.5, 0.5))
PAIRS = {
    "external": PLAIN,
    "few teeth": replace(PLAIN, teeth=(10, 10), ratio=-1.0),
    "helical": replace(PLAIN, teeth=(14, 61), ratio=-4.4, helix=math.radians(22)),
    "external, by a pinion cutter": replace(PLAIN, cutter=Cutter(25, 0.1)),
    "internal": RING,
    "internal, tips of full height": replace(RING, tip_shortening=False),
    "internal, by a pinion cutter": replace(RING, cutter=Cutter(20, 0.1)),
    "the ring drives, helical": replace(RING, teeth=(60, 22), ratio=22 / 60, helix=0.3),
}


def answer(given):
    """What `solve` says of shifts, without drawings: what it refuses, or the conditions that are not met."""
    check(given)
    teeth = choose_teeth(given)
    check_teeth(given, teeth)
    pair = choose_shifts(given, teeth)
    check_pair(given, pair)
    rows = conditions_of(pair, ("1", "2"), WIDEST)
    return {(c.key, c.wheel) for c in rows if not c.met and c.key not in BY_ASSEMBLY}


def shifted(given, x):
    return replace(given, shift=(float(x.real), float(x.imag)))


@pytest.mark.exhaustive
@pytest.mark.parametrize("given", many(PAIRS.values()), ids=PAIRS)
def test_the_contour_is_bounded_by_every_limit_that_solve_knows(given):
    pair = choose_shifts(given, choose_teeth(given))
    contour = contour_of(pair, WIDEST)
    low, high = contour.window
    rng = np.random.default_rng(5)
    points = low + (high - low).real * rng.random(DRAWN) + 1j * (high - low).imag * rng.random(DRAWN)
    margin = contour.blocking.margin(points)
    inside, outside = points[margin > 1e-9][:COUNT], points[margin < -1e-9][:COUNT]
    assert len(inside) == len(outside) == COUNT
    assert [x for x in inside if answer(shifted(given, x))] == []
    assert [x for x in inside if contour.blocking.lacks(x)] == []
    wrong = [x for x in outside if not named(contour.blocking, given, x)]
    assert wrong == []


def named(blocking, given, x):
    """Whether the contour names limits at a point, those that `solve` names."""
    lacks = blocking.lacks(x)
    broken = {
        (KEYS.get(one.limit.kind, one.limit.kind), str(one.limit.wheel or ""))
        for one in lacks
        if not one.limit.hard or one.limit.kind == "space"
    }
    try:
        return bool(lacks) and answer(shifted(given, x)) == broken
    except ProblemError as refused:
        return bool(lacks) and any(one.limit.hard for one in lacks) and bool(refused.problems[0].text())
