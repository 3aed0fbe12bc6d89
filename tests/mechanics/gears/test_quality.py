"""Quality over the shifts against velocities of points, curvatures of drawn involutes and grids of closed formulas."""

import math

import numpy as np
import pytest

from tmm_report.mechanics.gears import meshing, quality, shift_sharing, tooth_outlines
from tmm_report.mechanics.gears.rack import Rack

RACK = Rack()


def pairs(count, seed=3):
    """Random external and internal, straight and helical pairs that are in mesh."""
    rng = np.random.default_rng(seed)
    made = []
    while len(made) < count:
        internal = rng.random() < 0.4
        z1 = int(rng.integers(12, 30))
        z2 = z1 + int(rng.integers(20, 60)) if internal else int(rng.integers(z1, 70))
        x1, x2 = (0.3, 0.3 + 0.3 * rng.random()) if internal else (0.6 * rng.random(), 0.6 * rng.random())
        beta = rng.choice([0.0, math.radians(rng.uniform(5, 25))])
        pair = meshing.meshed(z1, z2, 3e-3, RACK, beta, x1, x2, internal, True, True)
        if rng.random() < 0.3:
            pair = meshing.meshed(z2, z1, 3e-3, RACK, beta, x2, x1, internal, True, True)
        if min(pair.rho_p) > 0 and pair.eps > 1 and min(pair.s_na) > 0:
            made.append(pair)
    return made


@pytest.mark.parametrize("pair", pairs(12))
def test_specific_sliding_is_that_of_velocities(pair):
    """Points of both wheels in one place on the line of action: their velocities along the common tangent."""
    omega, centres = (1.0, 1 / float(pair.ratio)), (0.0, float(pair.a_w))
    pole = omega[1] * centres[1] / (omega[1] - omega[0])  # where both have one velocity
    along = np.exp(1j * (math.pi / 2 - float(pair.alpha_w)))
    for key, rhos in (("root_sliding", pair.rho_p), ("tip_sliding", pair.rho_u)):
        for i in (0, 1):
            foot = pole - along * ((pole - centres[i]) / along).real
            place = foot + (pole - foot) / abs(pole - foot) * float(rhos[i])
            v = [omega[k] * ((place - centres[k]) / along).real for k in (0, 1)]
            assert getattr(pair, key)[i] == pytest.approx(1 - v[1 - i] / v[i], rel=1e-9, abs=1e-9)


def curvature(pair, i, rho):
    """Of the drawn flank where its radius of curvature should be `rho`, by the circle through three of its points."""
    z, x = (pair.z1, pair.z2)[i], (pair.x1, pair.x2)[i] * math.cos(pair.beta)
    if pair.signs[i] < 0:
        drawn = tooth_outlines.ring(z, pair.m_t, x, pair.t, pair.d_a[i] / 2, pair.d_f[i] / 2)
    else:
        drawn = tooth_outlines.external(z, pair.m_t, x, pair.t, pair.d_a[i] / 2)
    r = np.hypot(pair.d_b[i] / 2, rho + 3e-6 * np.array([-1, 0, 1]))
    a, b, c = drawn.flank(r)
    area = ((b - a).conjugate() * (c - a)).imag / 2
    return abs(4 * area / (abs(b - a) * abs(c - b) * abs(c - a)))


@pytest.mark.parametrize("pair", pairs(8, seed=5))
def test_specific_pressure_is_that_of_the_drawn_profiles(pair):
    """The difference of both curvatures; across helical teeth less by the cosine of the helix on the base cylinder."""
    turn = math.cos(math.atan(math.tan(pair.beta) * math.cos(pair.t.alpha)))
    for rho, mate in ((pair.rho_w[0], pair.rho_w[1]), (pair.rho_p[0], pair.rho_u[1])):
        bent = [curvature(pair, i, float(r)) for i, r in enumerate((rho, mate))]
        between = abs(bent[0] - bent[1]) if pair.internal else bent[0] + bent[1]
        assert quality.specific_pressure(pair, rho) == pytest.approx(pair.m * turn * between, rel=2e-4)


# ---------------------------------------------------------------- bounds


def tip(pair, x1):
    """Thicknesses of both tips, modules, by the textbook's formula for straight external wheels."""
    a, inv = pair.rack.alpha, lambda t: math.tan(t) - t
    x2 = float(pair.x_sum) - x1
    lost = float(pair.x_sum) - (float(pair.a_w) / pair.m - (pair.z1 + pair.z2) / 2)
    found = []
    for z, x in ((pair.z1, x1), (pair.z2, x2)):
        d = z + 2 * (1 + x - lost)
        at = math.acos(z * math.cos(a) / d)
        found.append(d * ((math.pi / 2 + 2 * x * math.tan(a)) / z + inv(a) - inv(at)))
    return found


def straight(count):
    rng = np.random.default_rng(8)
    made = []
    while len(made) < count:
        z = rng.integers(10, 40, 2)
        a = 4e-3 * (z.sum() / 2 + rng.uniform(0.1, 0.9))
        x_sum = float(meshing.shift_sum(*z, 4e-3, RACK, 0.0, a))
        made.append(meshing.Pair(int(z[0]), int(z[1]), 4e-3, RACK, 0.0, x_sum / 2, x_sum / 2, a))
    return made


@pytest.mark.parametrize("pair", straight(12))
def test_bounds_are_where_the_closed_formulas_say(pair):
    alone, ends = quality.allowed(pair, 0.25, 1.0)
    x_sum = float(pair.x_sum)
    least = [1 - z * math.sin(RACK.alpha) ** 2 / 2 for z in (pair.z1, pair.z2)]
    told = {(one.limit.kind, one.limit.wheel): one for one in alone}
    assert told["undercut", 1].low == pytest.approx(least[0], abs=1e-12)
    assert told["undercut", 2].high == pytest.approx(x_sum - least[1], abs=1e-12)
    assert tip(pair, told["pointing", 1].high)[0] == pytest.approx(0.25, abs=1e-12)
    assert tip(pair, told["pointing", 2].low)[1] == pytest.approx(0.25, abs=1e-12)
    inner = max(least[0], told["pointing", 2].low), min(x_sum - least[1], told["pointing", 1].high)
    others = [
        x for one in alone if one.limit.kind in ("contact", "interference") for x in (one.low, one.high)
    ]
    if inner[0] > inner[1]:
        assert ends is None
        return
    assert ends is not None
    for end, own, closer in ((ends[0], inner[0], max), (ends[1], inner[1], min)):
        assert closer(end, own) == pytest.approx(end, abs=1e-12)
        assert end == pytest.approx(own, abs=1e-12) or min(abs(end - x) for x in others) < 1e-12


@pytest.mark.parametrize("pair", pairs(6, seed=11))
def test_within_the_bounds_all_limits_are_kept_and_beyond_them_not(pair):
    """On a grid, every shift that breaks nothing lies within, and none of the others."""
    alone, ends = quality.allowed(pair, 0.3, 1.05)
    if ends is None:
        return
    for end, out in ((ends[0], -1), (ends[1], 1)):
        inside, outside = (shift_sharing.with_first_shift(pair, end + s * out * 1e-6) for s in (-1, 1))
        kept = [all(float(one.limit.margin(of)) >= 0 for one in alone) for of in (inside, outside)]
        assert kept[0]
        hard = quality.limits_of(outside, 0.3, 1.05)
        assert not all(float(limit.margin(outside)) >= 0 for limit in hard)


def test_where_nothing_is_allowed_there_are_no_ends():
    pair = meshing.meshed(8, 9, 4e-3, RACK, 0.0, 0.3, 0.3)
    alone, ends = quality.allowed(pair, 0.4, 1.05)
    assert ends is None and {one.limit.kind for one in alone} >= {"undercut", "pointing"}
