"""Pinion and ring put together radially: the formula against teeth that are turned and moved."""

import numpy as np
import pytest

from tmm_report.mechanics.calculus.polygons import overlap
from tmm_report.mechanics.gears import tooth_outlines
from tmm_report.mechanics.gears.meshing import Cutter, Rack, meshed
from tmm_report.mechanics.gears.pair_sizes import by_cutter
from tmm_report.mechanics.gears.ring_interference import cutting_of

STUB, FULL = Rack(ha=0.8), Rack()
PHASES = 12  # of the teeth beside the line of centres, over a pitch


def most_overlap(pair):
    """Largest area that the teeth share while the pinion is moved from its place to the ring's centre, modules²."""
    pinion = tooth_outlines.external(
        pair.z1, 1.0, pair.x1, pair.t, tip=float(pair.d_a[0]) / 2, tolerance=1e-3
    )
    ring = tooth_outlines.ring(pair.z2, 1.0, pair.x2, pair.t, tip=float(pair.d_a[1]) / 2, tolerance=1e-3)
    found = 0.0
    for turn in pinion.pitch_angle * np.arange(PHASES) / PHASES:
        around = ring.placed(
            tooth_outlines.centre_beside(ring, float(pair.a_w)),
            float(tooth_outlines.mating_turn(pinion, ring, turn)),
        )
        put = pinion.placed(0.0, turn)
        found = max(found, *(overlap(put - way, around, True) for way in np.linspace(0, 3, 13)))
    return found


@pytest.mark.exhaustive
@pytest.mark.parametrize("z1, z2, x1, x2, rack", [
    (25, 34, 0.0, 0.0, STUB), (25, 32, 0.3, 0.3, STUB), (40, 50, 0.0, 0.0, FULL), (30, 41, 0.5, 0.5, FULL),
])  # fmt: skip
def test_teeth_meet_where_the_formula_says_so(z1, z2, x1, x2, rack):
    pair = meshed(z1, z2, 1.0, rack, 0.0, x1, x2, True, trimmed=True)
    assert pair.radial < 0 < pair.fouling  # axially they go together
    assert most_overlap(pair) > 2e-3


@pytest.mark.parametrize("z1, z2, x1, x2, rack", [
    (25, 75, 0.4, 0.5, FULL), (25, 45, 0.0, 0.0, FULL), (30, 44, 0.5, 0.5, FULL), (20, 33, 0.5, 0.6, STUB),
])  # fmt: skip
def test_teeth_pass_where_the_formula_says_so(z1, z2, x1, x2, rack):
    pair = meshed(z1, z2, 1.0, rack, 0.0, x1, x2, True, trimmed=True)
    assert 0 < pair.radial <= pair.fouling
    assert most_overlap(pair) == pytest.approx(0, abs=1e-9)


def test_room_grows_with_the_difference_of_teeth():
    ring = np.arange(32, 60)
    room = meshed(25, ring, 1.0, STUB, 0.0, 0.0, 0.0, True, trimmed=True).radial
    assert (np.diff(room) > 0).all() and room[0] < 0 < room[-1]


def test_a_cutter_like_the_pinion_is_fed_as_the_pinion_is_put_in():
    """A cutter of the pinion's teeth and tips, at the pinion's distance: one formula for both."""
    pair = meshed(25, 45, 1.0, FULL, 0.0, 0.0, 0.0, True)
    taller = Rack(ha=FULL.ha - FULL.c, c=FULL.c)  # so that the cutter is as high as the pinion
    cut = by_cutter(meshed(25, 45, 1.0, taller, 0.0, 0.0, 0.0, True).cuts[1], Cutter(25), 0.0)
    found = cutting_of(cut, 45, pair.d_a[1] / 2, pair.alpha_a[1])
    assert float(found.radial) == pytest.approx(float(pair.radial), rel=1e-12)
    assert float(found.fouling) == pytest.approx(float(pair.fouling), rel=1e-12)


def test_no_ring_no_radial_assembly():
    assert np.isnan(meshed(20, 40, 1.0, FULL).radial)
