"""A published example of the law of wear: a collar that wears evenly carries less where it runs faster."""

import math

import numpy as np
import pytest
from cases import agrees, case

from tmm_report.mechanics.pairs import wear


def test_pressures_of_a_collar_that_wears_evenly():
    of = case("khurmi-10-22-uniform-wear")["inputs"]
    force, outer, inner = of["W_N"], of["r1_mm"], of["r2_mm"]
    most, least = wear.ring_pressure(force, inner, outer, np.array([inner, outer]))
    agrees("khurmi-10-22-uniform-wear", p_max=most, p_min=least, p_av=wear.ring_mean(force, inner, outer))


def test_the_pressures_carry_the_force_and_wear_evenly():
    r = np.linspace(0.05, 0.1, 2001)
    p = wear.ring_pressure(4000.0, 0.05, 0.1, r)
    assert np.mean(2 * math.pi * r * p) * 0.05 == pytest.approx(4000, rel=1e-9)
    assert np.ptp(p * r) < 1e-9 * p[0]
