"""The least teeth of a ring without shift: the closed form against the radii of curvature, and the course's rule."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.gears.eccentric.mechanism import root_in_hand
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.mechanics.gears.pair_sizes import Rack, least_ring, ring_rule

RACK, STUB = Rack(), Rack(math.pi / 9, 0.8, 0.3)


@settings(max_examples=60, deadline=None)
@given(st.floats(12.0, 30.0), st.sampled_from([RACK, STUB, Rack(math.radians(25), 1.0, 0.2)]))
def test_at_the_limit_the_rings_tip_lies_in_the_end_of_the_line_of_action(z, rack):
    ring = float(least_ring(z, rack))
    assume(z + 8 < ring < 5000)  # a ring that goes round the wheel, its tips outside its base circle
    pair = Pair(z, ring, 0.003, rack, 0.0, 0.0, 0.0, 0.0015 * (ring - z), internal=True)
    assert float(pair.rho_a[1]) == pytest.approx(float(pair.line), rel=1e-9)
    assert root_in_hand(1.01 * ring, z, 0.003, rack) > 0 > root_in_hand(0.99 * ring, z, 0.003, rack)


def test_a_satellite_that_a_rack_undercuts_suits_no_ring():
    assert least_ring(17, RACK) == math.inf and math.isfinite(least_ring(18, RACK))
    assert np.isinf(least_ring(np.arange(6, 18), RACK)).all()


def test_the_ring_of_the_hoist_is_just_within_both():
    """86 teeth beside a satellite of 19: the exact least number is 85.88, the rule of the course asks for 85."""
    assert least_ring(19, RACK) == pytest.approx(85.88, abs=5e-3)
    assert ring_rule(RACK) == 85 < 86


def test_the_rule_is_known_of_two_racks():
    assert (ring_rule(RACK), ring_rule(STUB), ring_rule(Rack(math.pi / 9, 0.9))) == (85, 58, None)
    assert ring_rule(Rack(math.radians(25), 1.0)) is None
