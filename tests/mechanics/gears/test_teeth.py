"""Outlines of wheels: thickness and fillet against their definitions, meshing without overlap over a pitch."""

import math

import numpy as np
import pytest
from conftest import examples
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.polygons import clearance
from tmm_report.mechanics.gears import meshing, tooth_outlines
from tmm_report.mechanics.gears.limits.blocking_contour import Blocking
from tmm_report.mechanics.gears.meshing import Rack

RACK = Rack()
SHIFTED = st.tuples(st.integers(6, 90), st.floats(-0.3, 1.0))


def thickness(wheel, radius):
    """Of tooth 0 along a circle, from the sides of the outline that cross it."""
    z = np.roll(wheel.outline, len(wheel.outline) // (2 * wheel.z) if wheel.internal else 0)
    z = z[: len(z) // wheel.z]
    far = np.abs(z) - radius
    k = np.flatnonzero(far[:-1] * far[1:] <= 0)
    at = z[k] - far[k] * (z[k + 1] - z[k]) / (far[k + 1] - far[k])
    return radius * abs(np.angle(at[-1] / at[0]))


@given(SHIFTED)
def test_thickness_on_the_pitch_circle(shifted):
    z, x = shifted
    expected = math.pi / 2 + 2 * x * math.tan(RACK.alpha)
    wheel = tooth_outlines.external(z, 1.0, x, RACK)
    assume(wheel.junction < z / 2 < wheel.tip)
    assert thickness(wheel, z / 2) == pytest.approx(expected, abs=4 * tooth_outlines.FINE)


@given(st.integers(30, 150), st.floats(-0.5, 0.9))
def test_thickness_of_a_ring(z, x):
    wheel = tooth_outlines.ring(z, 1.0, x, RACK)
    expected = math.pi / 2 - 2 * x * math.tan(RACK.alpha)
    assert thickness(wheel, z / 2) == pytest.approx(expected, abs=6 * tooth_outlines.FINE)


def rack_tooth(x):
    """One tooth of the rack, complex, depth along the real axis: the pitch line at 0, its tip rounded."""
    rho = RACK.fillet
    deep = RACK.ha + RACK.c - rho - x
    wide = math.pi / 4 - (deep + x) * math.tan(RACK.alpha) - rho / math.cos(RACK.alpha)
    theta = np.linspace(0, math.pi / 2 - RACK.alpha, 40)
    corner = -deep + 1j * wide + rho * (-np.cos(theta) + 1j * np.sin(theta))
    top = corner[-1] + 2.5 * (1 + 1j * math.tan(RACK.alpha))
    upper = np.append(corner, top)
    return np.concatenate([upper, upper.conj()[::-1]])


@pytest.mark.parametrize(
    "z, x", [(6, 0.0), (8, 0.0), (14, 0.1765), (17, 0.0), (30, 0.6), (60, -0.4), (12, 1.3)]
)
def test_the_rack_cuts_the_outline_and_no_more(z, x):
    """The rack rolled along the wheel touches every vertex of fillet and flank and enters the metal nowhere."""
    r, cutter = z / 2, rack_tooth(x)
    wheel = tooth_outlines.external(z, 1.0, x, RACK)
    space = wheel.outline[: len(wheel.outline) // (2 * z)] * np.exp(
        1j * math.pi / z
    )  # of the space on the +x axis
    space = space[np.abs(space) < wheel.tip - 1e-6][::2]
    roll = np.linspace(-8, 8, 3201)
    seen = space[:, None] * np.exp(1j * roll / r) - r - 1j * roll  # in the axes of the rack
    start, end = cutter, np.roll(cutter, -1)
    nearest = np.full(len(space), np.inf)
    for k in range(len(cutter)):
        along = (end[k] - start[k]) / abs(end[k] - start[k])
        part = np.clip(((seen - start[k]) * along.conj()).real, 0, abs(end[k] - start[k]))
        nearest = np.minimum(nearest, np.abs(seen - start[k] - part * along).min(axis=1))
    assert nearest.max() < 3 * tooth_outlines.FINE
    within = (seen.real > -(RACK.ha + RACK.c - x) + 5e-4) & (seen.real < 2)
    half = np.interp(seen.real, cutter[: len(cutter) // 2].real, cutter[: len(cutter) // 2].imag)
    assert not (within & (np.abs(seen.imag) < half - 5e-4)).any()


@given(st.integers(6, 60), st.floats(-0.3, 1.0))
def test_undercut_takes_involute_where_the_shift_is_less_than_the_limit(z, x):
    wheel = tooth_outlines.external(z, 1.0, x, RACK)
    limit = float(meshing.least_shift(z, RACK))
    assume(abs(x - limit) > 1e-3)
    expected = z / 2 * math.sin(RACK.alpha) - (RACK.ha - x) / math.sin(RACK.alpha)  # radius of curvature
    if x > limit:
        assert math.sqrt(wheel.junction**2 - wheel.base**2) == pytest.approx(expected, abs=1e-9)
    else:
        assert wheel.junction > wheel.base


@given(SHIFTED)
def test_an_outline_is_a_simple_ring_of_z_equal_teeth(shifted):
    z, x = shifted
    wheel = tooth_outlines.external(z, 1.0, x, RACK)
    tooth = wheel.outline.reshape(z, -1)
    assert np.allclose(tooth, tooth[0] * np.exp(2j * math.pi * np.arange(z) / z)[:, None], atol=1e-12)
    radii = np.abs(tooth[0])
    top = int(np.argmax(radii))
    assert (np.diff(radii[: top + 1]) > -1e-9).all()  # so a flank has one point at every radius
    assert radii.max() == pytest.approx(wheel.tip) and radii.min() == pytest.approx(
        wheel.root, abs=2 * tooth_outlines.FINE
    )


PAIRS = st.tuples(st.integers(8, 40), st.integers(8, 60), st.floats(-0.2, 1.0), st.floats(-0.2, 1.0))


@settings(max_examples=examples(25))
@given(PAIRS, st.sampled_from([0.0, 0.3]))
def test_feasible_external_pairs_do_not_overlap_and_the_contact_ratio_is_the_formula(sizes, beta):
    z1, z2, x1, x2 = sizes
    assume(float(Blocking(z1, z2, 1.0, RACK, beta).margin(np.array(complex(x1, x2)))) > 1e-3)
    pair = meshing.meshed(z1, z2, 1.0, RACK, beta, x1, x2)
    turn, size = math.cos(beta), float(pair.m_t)
    one, other = (
        tooth_outlines.external(z, size, x * turn, pair.t, tip=float(d) / 2)
        for z, x, d in zip((z1, z2), (x1, x2), pair.d_a, strict=True)
    )
    assert_meshing(one, other, pair)


@settings(max_examples=examples(15))
@given(st.integers(12, 40), st.integers(20, 60), st.floats(0.0, 0.8), st.floats(0.2, 1.5))
def test_feasible_internal_pairs_do_not_overlap_and_the_contact_ratio_is_the_formula(z1, more, x1, x2):
    z2 = z1 + more
    assume(float(Blocking(z1, z2, 1.0, RACK, internal=True).margin(np.array(complex(x1, x2)))) > 1e-3)
    pair = meshing.meshed(z1, z2, 1.0, RACK, 0.0, x1, x2, internal=True)
    one = tooth_outlines.external(z1, 1.0, x1, RACK, tip=float(pair.d_a[0]) / 2)
    other = tooth_outlines.ring(z2, 1.0, x2, RACK, tip=float(pair.d_a[1]) / 2, root=float(pair.d_f[1]) / 2)
    assert_meshing(one, other, pair)


def assert_meshing(one, other, pair):
    shared, apart = tooth_outlines.over_pitch(one, other, float(pair.a_w), 12)
    assert shared.max() < 1e-12 and apart.min() > -1e-9
    assert apart.max() < 5 * tooth_outlines.FINE  # flanks touch: there is no backlash
    counted = tooth_outlines.contact_ratio(one, other, float(pair.a_w))
    assert counted == pytest.approx(float(pair.eps), abs=3e-3)


def test_wheels_too_close_overlap_and_apart_leave_room():
    pair = meshing.meshed(14, 28, 6.0, RACK, 0.0, 0.2, 0.5)
    wheels = [
        tooth_outlines.external(z, 6.0, x, RACK, tip=float(d) / 2)
        for z, x, d in zip((14, 28), (0.2, 0.5), pair.d_a, strict=True)
    ]
    shared, apart = tooth_outlines.over_pitch(*wheels, float(pair.a_w) - 0.1, 6)
    assert shared.min() > 0 and apart.max() < 0
    # the backlash of both flanks: 2 Δa sin α_w along the line of action, half of it on either side
    _, apart = tooth_outlines.over_pitch(*wheels, float(pair.a_w) + 0.1, 6)
    assert apart.mean() == pytest.approx(0.1 * math.sin(float(pair.alpha_w)), rel=0.05)


def test_interference_that_the_formula_foresees_is_seen_in_the_outlines():
    """Full-height ring of 112 teeth over a satellite of 46: the ring's tips reach under the satellite's involutes."""
    satellite = tooth_outlines.external(46, 5.0, 0.0, RACK)
    pair = meshing.meshed(46, 112, 5.0, RACK, internal=True)
    assert pair.interference[0] < 0
    shared, _ = tooth_outlines.over_pitch(satellite, tooth_outlines.ring(112, 5.0, 0.0, RACK), 165.0, 8)
    assert shared.max() > 1e-3
    shared, _ = tooth_outlines.over_pitch(
        satellite, tooth_outlines.ring(112, 5.0, 0.0, RACK, tip=275.6), 165.0, 8
    )
    assert shared.max() == 0


def test_a_touching_flank_stays_touching_where_there_is_backlash():
    pair = meshing.meshed(20, 31, 1.0, RACK, 0.0, 0.1, 0.2)
    one, other = tooth_outlines.external(20, 1.0, 0.1, RACK), tooth_outlines.external(31, 1.0, 0.15, RACK)
    for turn in (-0.05, 0.0, 0.1):
        touching = tooth_outlines.touching_turn(one, other, float(pair.a_w), turn)
        gap = clearance(one.placed(0, turn), other.placed(float(pair.a_w), touching))
        assert -1e-9 < gap < 4 * tooth_outlines.FINE


def test_a_wheel_that_is_undercut_to_its_tips_is_refused():
    with pytest.raises(ValueError, match="undercut up to its tip circle"):
        tooth_outlines.external(8, 1.0, -1.6, RACK)


def test_a_rack_with_a_narrow_tooth_gets_a_smaller_rounding():
    rack = Rack(np.radians(28), 1.0, 0.25)
    assert tooth_outlines.fillet_radius(RACK) == pytest.approx(0.38, abs=1e-4)
    assert tooth_outlines.fillet_radius(rack) < rack.fillet
    assert tooth_outlines.external(20, 1.0, 0.0, rack).root > 0


def test_a_ring_whose_spaces_are_narrow_is_rounded_off_before_its_root_circle():
    wheel = tooth_outlines.ring(38, 1.0, 1.5, RACK)
    assert wheel.junction < wheel.root < 38 / 2 + 1.25 + 1.5
    assert np.abs(wheel.outline).max() == pytest.approx(wheel.root, abs=2 * tooth_outlines.FINE)
    angles = np.angle(wheel.outline[: len(wheel.outline) // 38] * np.exp(-1j * math.pi / 38))
    assert (np.diff(angles) > -1e-9).all()  # the fillets of one space do not cross
