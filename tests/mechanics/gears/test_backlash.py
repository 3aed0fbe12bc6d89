"""Backlash against drawn teeth that are turned until they touch, with no formula shared; measured sizes of thinned
teeth against gauges laid on them."""

import math
from dataclasses import replace

import numpy as np
import pytest
from exhaustive import many
from test_quality import pairs

from tmm_report.mechanics.gears import backlash, tooth_outlines
from tmm_report.mechanics.gears.inspection import Gauged


def flank(pair, i, thinned, radii):
    """Half the angle of the drawn tooth at radii (N,) of its involute; thinned by an arc of its pitch circle across."""
    z, x = (pair.z1, pair.z2)[i], (pair.x1, pair.x2)[i] * math.cos(pair.beta)
    if pair.signs[i] < 0:
        drawn = tooth_outlines.ring(z, pair.m_t, x, pair.t, pair.d_a[i] / 2, pair.d_f[i] / 2)
    else:
        drawn = tooth_outlines.external(z, pair.m_t, x, pair.t, pair.d_a[i] / 2)
    return np.angle(drawn.flank(radii)) - thinned / math.cos(pair.beta) / float(pair.d[i])


def turns_freely(pair, a_w, thinned):
    """The angle by which the larger wheel turns while the smaller one is held, its tooth on the line of the axes."""
    small = int(pair.z2 < pair.z1)
    large = 1 - small
    g = Gauged(pair, small)
    r = np.linspace(*(float(g.at(rho)) / 2 for rho in g.involute), 40001)
    points = r * np.exp(1j * flank(pair, small, thinned[small], r))
    seen = a_w + points if pair.internal else (a_w - points).conjugate()
    room = Gauged(pair, large)
    low, high = (float(room.at(rho)) / 2 for rho in room.involute)
    seen = seen[(low < abs(seen)) & (abs(seen) < high)]
    space = math.pi / (pair.z1, pair.z2)[large] - flank(pair, large, thinned[large], abs(seen))
    gap = space - np.angle(seen)
    least = int(np.argmin(gap))
    assert 0 < least < len(gap) - 1  # the flanks touch one another, not a corner
    return 2 * float(gap[least])


@pytest.mark.parametrize("k", many(range(60), 10))
def test_backlash_is_that_of_drawn_teeth(k):
    pair = PAIRS[k]
    rng = np.random.default_rng(k)
    thinned = tuple(rng.uniform(0, 0.04, 2) * pair.m)
    a_w = float(pair.a_w) + rng.uniform(-0.01, 0.03) * pair.m
    loose = backlash.Loose(pair, a_w, sum(thinned))
    large = int(pair.z2 > pair.z1)
    assert turns_freely(pair, a_w, thinned) == pytest.approx(loose.turns[large], abs=1e-7)
    assert loose.turns[0] == pytest.approx(loose.turns[1] * abs(float(pair.ratio)), rel=1e-9)


PAIRS = pairs(60, seed=21)


@pytest.mark.parametrize("k", range(6))
def test_what_is_guaranteed_is_left_at_the_closest_distance(k):
    pair = PAIRS[k]
    a_w = backlash.closest(pair, 0.01 * pair.m)
    thinned = backlash.thinning_for(pair, a_w, 0.03 * pair.m)
    assert backlash.Loose(pair, a_w, thinned).normal == pytest.approx(0.03 * pair.m, rel=1e-9)
    assert all(
        backlash.Loose(pair, float(pair.a_w) + off * pair.m, thinned).normal >= 0.03 * pair.m * (1 - 1e-9)
        for off in np.linspace(-0.01, 0.01, 21)
    )
    assert backlash.thinning_for(pair, backlash.closest(pair, -0.05 * pair.m), 1e-6) == 0


@pytest.mark.parametrize("k", range(30))
def test_chord_of_a_thinned_tooth_where_a_caliper_stands(k):
    """On the drawn tooth of a straight wheel: where its flank is as far below the tip as the caliper is set."""
    pair = PAIRS[k]
    for i in (0, 1):
        if pair.beta or pair.signs[i] < 0:
            continue
        plain, thin = Gauged(pair, i), Gauged(pair, i, None, 0.02 * pair.m)
        height = float(plain.chord(plain.of("d"))[1])
        r = np.linspace(*(float(thin.at(rho)) / 2 for rho in thin.involute), 200001)
        points = r * np.exp(1j * flank(pair, i, 0.02 * pair.m, r))
        depth = float(pair.d_a[i]) / 2 - points.real
        order = np.argsort(depth)
        assert 2 * np.interp(height, depth[order], points.imag[order]) == pytest.approx(
            thin.chord_below(height), abs=1e-9 * pair.m
        )


@pytest.mark.parametrize("k", range(20))
def test_a_thinned_wheel_is_one_of_less_shift(k):
    """A rack cuts thinner teeth by a lesser shift: span and pins measure the same."""
    pair = PAIRS[k]
    for i, key in ((0, "x1"), (1, "x2")):
        lost = 0.02 * pair.m
        sign = -1 if pair.signs[i] < 0 else 1
        x = float(getattr(pair, key)) - sign * lost / (2 * pair.m * math.tan(pair.rack.alpha))
        thin, less = Gauged(pair, i, None, lost), Gauged(replace(pair, **{key: x}), i)
        assert thin.over(1.7 * pair.m) == pytest.approx(float(less.over(1.7 * pair.m)), rel=1e-12)
        if thin.spannable:
            assert thin.span(3) == pytest.approx(float(less.span(3)), rel=1e-12)
