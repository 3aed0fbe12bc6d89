"""Geometry of a pair: what must hold of any wheels, drawn at random; and that arrays equal single pairs."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tmm_report.mechanics.gears import meshing, shift_sharing, tooth_outlines
from tmm_report.mechanics.gears.meshing import Pair, Rack, least_shift, meshed, shift_sum

STANDARD = Rack()
DIMENSIONS = (
    "d",
    "d_b",
    "d_w",
    "d_f",
    "d_a",
    "s",
    "s_b",
    "s_w",
    "s_a",
    "s_na",
    "rho_a",
    "rho_p",
    "rho_m",
    "starts",
    "rho_l",
    "x_min",
)
NUMBERS = ("a", "a_w", "alpha_w", "x_sum", "y", "shortening", "backlash", "line", "active", "eps", "fouling")

racks = st.builds(
    Rack, st.sampled_from([math.radians(a) for a in (15, 20, 25)]), st.sampled_from([0.8, 1.0]), st.just(0.25)
)


@st.composite
def pairs(draw, internal=None):
    """A pair without backlash whose wheels exist."""
    inner = draw(st.booleans()) if internal is None else internal
    z1 = draw(st.integers(12, 40))
    z2 = draw(st.integers(z1 + 20, 120)) if inner else draw(st.integers(12, 120))
    swapped = draw(st.booleans())
    x1, x2 = draw(st.floats(-0.4, 1.0)), draw(st.floats(-0.4, 1.0))
    beta = draw(st.sampled_from([0.0, 0.0, math.radians(12), math.radians(25)]))
    if swapped:
        z1, z2 = z2, z1
    pair = meshed(z1, z2, draw(st.sampled_from([0.5e-3, 6e-3])), draw(racks), beta, x1, x2, inner)
    assume(np.isfinite(pair.a_w) and np.all(np.isfinite(pair.rho_a)))
    return pair


@given(pairs())
def test_thicknesses_fill_the_working_pitch(pair):
    assert pair.s_w[0] + pair.s_w[1] == pytest.approx(pair.p_w, rel=1e-11)
    assert abs(pair.backlash) < 1e-11 * pair.p_w


@given(pairs())
def test_distance_and_shifts_undo_each_other(pair):
    found = shift_sum(pair.z1, pair.z2, pair.m, pair.rack, pair.beta, pair.a_w, pair.internal)
    assert found == pytest.approx(pair.x_sum, abs=1e-9)


@given(pairs())
def test_working_circles_roll(pair):
    """Their radii give the centre distance and the ratio."""
    (d1, d2), way = pair.d_w, -1 if pair.internal else 1
    assert abs(d1 + way * d2) / 2 == pytest.approx(pair.a_w, rel=1e-12)
    assert -way * d2 / d1 == pytest.approx(pair.ratio, rel=1e-12)


@given(pairs())
def test_the_radii_of_curvature_fill_the_line_of_action(pair):
    """At every point of the mesh; so at the tips, where the mate's lower point is."""
    s1, s2 = pair.signs
    line = pair.side * pair.line
    assert s1 * pair.rho_a[0] + s2 * pair.rho_m[1] == pytest.approx(line, abs=1e-12)
    assert s1 * pair.rho_m[0] + s2 * pair.rho_a[1] == pytest.approx(line, abs=1e-12)
    assert s1 * pair.rho_w[0] + s2 * pair.rho_w[1] == pytest.approx(line, abs=1e-12)


@given(pairs())
def test_contact_ratio_by_the_angles(pair):
    """ε = Σ z (tan α_a − tan α_w)/2π, the textbooks' other formula."""
    total = sum(
        sign * z * (np.tan(alpha) - np.tan(pair.alpha_w))
        for sign, z, alpha in zip(pair.signs, (pair.z1, pair.z2), pair.alpha_a, strict=True)
    )
    assert pair.eps_tips == pytest.approx(total / (2 * math.pi), abs=1e-9)


@given(pairs())
def test_the_pitch_point_does_not_slide(pair):
    at = pair.sliding(pair.rho_w[0])
    assert abs(at.first) < 1e-9 and abs(at.second) < 1e-9


@given(pairs(), st.floats(0.1, 0.9))
def test_specific_sliding_by_velocities(pair, share):
    """From the velocities of the touching points across the line of action: ω ρ of each wheel."""
    rho = pair.rho_p[0] + share * (pair.rho_a[0] - pair.rho_p[0])
    s1, s2 = pair.signs
    mate = s2 * (pair.side * pair.line - s1 * rho)
    assume(min(rho, mate) > 1e-6)
    v1, v2 = rho, mate / abs(pair.ratio)
    at = pair.sliding(rho)
    assert at.first == pytest.approx((v1 - v2) / v1, rel=1e-9, abs=1e-9)
    assert at.second == pytest.approx((v2 - v1) / v2, rel=1e-9, abs=1e-9)


@given(pairs())
def test_the_clearance_is_never_less_than_the_rack_s(pair):
    standard = pair.rack.c * pair.m
    assert min(pair.clearance) >= standard * (1 - 1e-9)
    if pair.shortening > 1e-9:
        assert pair.clearance == pytest.approx((standard, standard))


@given(pairs(internal=False))
def test_tips_of_full_height_lose_the_clearance(pair):
    full = replace(pair, shortened=False)
    assert full.clearance[0] == pytest.approx((pair.rack.c - (pair.x_sum - pair.y)) * pair.m, abs=1e-12)
    assert full.d_a[0] - pair.d_a[0] == pytest.approx(2 * pair.shortening * pair.m, abs=1e-12)


@given(pairs())
def test_wheels_in_the_other_order(pair):
    other = replace(pair, z1=pair.z2, z2=pair.z1, x1=pair.x2, x2=pair.x1)
    for name in DIMENSIONS:
        assert getattr(other, name) == pytest.approx(getattr(pair, name)[::-1], nan_ok=True), name
    assert other.root_sliding == pytest.approx(pair.root_sliding[::-1], rel=1e-9)
    assert other.eps == pytest.approx(pair.eps)
    assert other.fouling == pytest.approx(pair.fouling, nan_ok=True)


@given(pairs(), st.floats(1e-4, 0.05))
def test_a_wider_distance_leaves_backlash(pair, modules):
    """A small change of the distance opens 2 Δa tan α_w along the working circles."""
    way = -1 if pair.internal else 1
    wider = replace(pair, a_w=pair.a_w + way * modules * pair.m)
    assume(np.isfinite(wider.alpha_w) and pair.alpha_w > math.radians(10))
    gap = 2 * modules * pair.m * np.tan(pair.alpha_w)
    assert wider.backlash == pytest.approx(gap, rel=modules * 20)
    assert wider.normal_backlash < wider.backlash


@pytest.mark.parametrize("internal", [False, True])
def test_arrays_equal_single_pairs(internal):
    x1, x2 = np.meshgrid(np.linspace(-0.3, 0.9, 5), np.linspace(-0.2, 1.0, 4))
    together = meshed(15, 47, 4e-3, STANDARD, 0.1, x1, x2, internal)
    for at in np.ndindex(x1.shape):
        single = meshed(15, 47, 4e-3, STANDARD, 0.1, float(x1[at]), float(x2[at]), internal)
        for name in DIMENSIONS:
            for whole, one in zip(getattr(together, name), getattr(single, name), strict=True):
                found = np.broadcast_to(whole, x1.shape)[at]
                assert found == pytest.approx(one, rel=1e-12, nan_ok=True), name
        for name in NUMBERS:
            found = np.broadcast_to(getattr(together, name), x1.shape)[at]
            assert found == pytest.approx(getattr(single, name), rel=1e-9, abs=1e-12, nan_ok=True), name


def test_a_grid_of_teeth():
    """z may be arrays too; the ring is then told apart element by element."""
    z1, z2 = np.array([20, 60]), np.array([60, 20])
    pair = meshed(z1, z2, 5e-3, STANDARD, 0.0, np.array([0.3, 0.5]), np.array([0.5, 0.3]), True)
    assert pair.ratio == pytest.approx([3, 1 / 3])
    assert pair.d_a[0][0] == pytest.approx(pair.d_a[1][1])
    assert pair.fouling[0] == pytest.approx(pair.fouling[1])


def test_no_such_pair_is_nan():
    assert np.isnan(meshed(14, 28, 6e-3, STANDARD, 0.0, -3.0, -3.0).a_w)
    assert np.isnan(Pair(14, 28, 6e-3, STANDARD, 0.0, 0.0, 0.0, 0.1).alpha_w)


# ---------------------------------------------------------------- undercut, shifts


def test_least_shift():
    """1 − z sin²α/2: zero at 17.097 teeth; the rule is zero at 17 and never negative."""
    assert least_shift(2 / math.sin(math.radians(20)) ** 2, STANDARD) == pytest.approx(0, abs=1e-12)
    assert shift_sharing.rule_shift(np.array([14, 17, 40]), STANDARD) == pytest.approx([3 / 17, 0, 0])


@pytest.mark.parametrize("beta", [0.0, 0.35])
@pytest.mark.parametrize("z", [8, 12, 16])
def test_least_shift_against_the_cut_tooth(z, beta):
    """The tooth that the rack cuts keeps its involute down to the base circle just at the least shift."""
    x, t = float(least_shift(z, STANDARD, beta)), STANDARD.transverse(beta)
    at_limit = tooth_outlines.external(z, 1e-3, x * math.cos(beta), t)
    above = tooth_outlines.external(z, 1e-3, (x + 0.02) * math.cos(beta), t)
    below = tooth_outlines.external(z, 1e-3, (x - 0.02) * math.cos(beta), t)
    assert at_limit.junction == pytest.approx(at_limit.base, rel=1e-6)
    pair = meshed(z, 60, 1e-3, t, 0.0, (x + 0.02) * math.cos(beta), 0.0)
    assert math.sqrt(above.junction**2 - above.base**2) == pytest.approx(pair.rho_l[0], rel=1e-6)
    assert below.junction > below.base * (1 + 1e-9)


@pytest.mark.exhaustive
@given(pairs(internal=False))
def test_equal_sliding(pair):
    x1 = shift_sharing.equal_sliding(pair)
    assume(np.isfinite(x1))
    found = shift_sharing.with_first_shift(pair, x1)
    assert found.x_sum == pytest.approx(pair.x_sum, abs=1e-9)
    assert found.root_sliding[0] == pytest.approx(found.root_sliding[1], rel=1e-6)


@given(pairs(), st.integers(0, 1), st.floats(-0.5, 0.5))
def test_filling(pair, wheel, x):
    filled = shift_sharing.filling(pair, wheel, x, pair.x_sum)
    assert filled.x_sum == pytest.approx(pair.x_sum, abs=1e-12)
    assert (filled.x1, filled.x2)[wheel] == x
    assert filled.backlash == pytest.approx(0, abs=1e-10 * pair.m + 1e-12)


def test_equal_sliding_of_the_textbook():
    """Twins slide equally when they are shifted equally."""
    pair = meshed(20, 20, 4e-3, STANDARD, 0.0, 0.6, 0.2)
    assert shift_sharing.equal_sliding(pair) == pytest.approx(0.4, abs=1e-9)


# ---------------------------------------------------------------- internal pairs


@pytest.mark.parametrize("z2, fouls", [(24, True), (25, True), (26, False), (27, False), (30, False)])
def test_fouling_is_what_the_outlines_show(z2, fouls):
    """Tips of a pinion and a ring of few teeth more run into each other just where the formula says."""
    pair = meshed(22, z2, 3e-3, Rack(ha=0.8), 0.0, 1.0, 1.1, internal=True)
    pinion = tooth_outlines.external(22, pair.m, 1.0, pair.rack, tip=float(pair.d_a[0]) / 2)
    ring = tooth_outlines.ring(z2, pair.m, 1.1, pair.rack, tip=float(pair.d_a[1]) / 2)
    overlap, _ = tooth_outlines.over_pitch(pinion, ring, float(pair.a_w), 12)
    assert (overlap.max() > 1e-3 * pair.m**2) == fouls
    assert (pair.fouling < 0) == fouls


def test_helical_teeth_thin_in_the_normal_section():
    pair = meshed(20, 40, 4e-3, STANDARD, math.radians(20), 0.2, 0.1)
    assert all(s_na < s_a for s_na, s_a in zip(pair.s_na, pair.s_a, strict=True))
    assert pair.overlap(0.05) == pytest.approx(0.05 * math.sin(math.radians(20)) / (math.pi * 4e-3))
    assert meshing.meshed(20, 40, 4e-3, STANDARD, 0.0, 0.2, 0.1).overlap(0.05) == 0
