"""Where the involute really begins: by formula, and by the envelope of the tool traced through the blank."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.gears import tooth_outlines
from tmm_report.mechanics.gears.cutting import (
    ByCutter,
    ByRack,
    Cutter,
    base_half_angle,
    fillet_radius,
    real_start,
)
from tmm_report.mechanics.gears.involute import inv
from tmm_report.mechanics.gears.meshing import Rack, meshed

RACK = Rack()
FINE = 2e-3  # modules: of the radii of curvature that are tried
DEPTH = 1e-7  # modules: how deep under the flank a point is held to be metal


def flank_of_space(z, x, rho):
    """Points just under the flank above the space on the +x axis, at radii of curvature `rho`, modules."""
    base = z / 2 * math.cos(RACK.alpha)
    half = math.pi / z - (base_half_angle(z, x, RACK.alpha) - (rho / base - np.arctan(rho / base)))
    radius = np.hypot(base, rho)
    return radius * np.exp(1j * (half + DEPTH / radius))


def left_by_rack(z, x, turns):
    """Radius of curvature of the lowest point of the flank that no position of the rack's tooth takes away."""
    rho = np.arange(0, 3, FINE)
    points, r = flank_of_space(z, x, rho), z / 2
    taken = np.zeros(len(rho), dtype=bool)
    for turn in turns:
        # in the axes of the rack: its pitch line is the imaginary axis at r, its tooth points to -x
        moved = points * np.exp(-1j * turn) - r + 1j * r * turn
        deep, aside = x - moved.real, np.abs(moved.imag)  # under the middle line of the rack
        taken |= within_tooth(deep, aside)
    return rho[~taken][0]


def within_tooth(deep, aside):
    """Whether points `deep` under the middle line and `aside` of a tooth's middle lie in the rack's rounded tooth."""
    rho = fillet_radius(RACK)
    up = RACK.ha + RACK.c - rho
    wide = math.pi / 4 - up * math.tan(RACK.alpha) - rho / math.cos(RACK.alpha)
    straight = (deep < up + rho * math.sin(RACK.alpha)) & (aside < math.pi / 4 - deep * math.tan(RACK.alpha))
    middle = (aside <= wide) & (deep < RACK.ha + RACK.c)
    corner = np.hypot(aside - wide, deep - up) < rho
    return straight | (middle & (deep > 0)) | corner


def left_by_cutter(z, x, cutter, turns):
    """The same of a pinion cutter with sharp tips."""
    rho = np.arange(0, 3, FINE)
    cut = ByCutter(z, 1.0, x, RACK, cutter, cutter.x)
    points, distance = flank_of_space(z, x, rho), float(cut.distance)
    half = base_half_angle(cutter.z, cutter.x, RACK.alpha)
    taken = np.zeros(len(rho), dtype=bool)
    for turn in turns:
        own = -(points * np.exp(-1j * turn * cutter.z / z) - distance) * np.exp(-1j * turn)
        radius = np.abs(own)
        thick = half - inv(np.arccos(np.minimum(cut.base / radius, 1.0)))
        taken |= (radius < cut.tip) & (radius > cut.base) & (np.abs(np.angle(own)) < thick - 1e-9)
    return rho[~taken][0]


@pytest.mark.parametrize("z, x", [(10, 0.0), (14, -0.317), (8, 0.1), (12, -0.5)])
def test_the_rack_traced_through_the_blank_leaves_the_involute_that_is_computed(z, x):
    found = float(real_start(ByRack(z, 1.0, x, RACK)))
    assert left_by_rack(z, x, np.linspace(-1.2, 1.2, 1501)) == pytest.approx(found, abs=1.5 * FINE)


@pytest.mark.parametrize("z, x, cutter", [(10, 0.0, Cutter(20)), (12, 0.0, Cutter(20, 0.1)),
                                          (14, -0.4, Cutter(34)), (9, 0.1, Cutter(40, -0.2))])  # fmt: skip
def test_the_pinion_cutter_traced_through_the_blank_does_too(z, x, cutter):
    found = float(real_start(ByCutter(z, 1.0, x, RACK, cutter, cutter.x)))
    turns = np.linspace(-14, 14, 1501) / cutter.z
    assert left_by_cutter(z, x, cutter, turns) == pytest.approx(found, abs=1.5 * FINE)


@given(st.integers(5, 30), st.floats(-0.5, 0.5))
def test_the_start_is_where_the_outline_leaves_its_involute(z, x):
    """The outline of the drawing finds the crossing for itself."""
    found = float(real_start(ByRack(z, 1.0, x, RACK)))
    try:
        drawn = tooth_outlines.flank(z, 1.0, x, RACK)
    except ValueError:
        assert found > math.hypot(1, z)  # none left under the tip circle
        return
    assert math.sqrt(max(drawn.junction**2 - drawn.base**2, 0)) == pytest.approx(found, rel=1e-6, abs=1e-6)


@given(st.integers(6, 16), st.floats(1e-6, 0.1))
def test_a_small_undercut_eats_half_as_much_as_the_tool_reaches_too_far(z, less):
    cut = ByRack(z, 1.0, ByRack(z, 1.0, 0.0, RACK).least_shift - less, RACK)
    share = float(real_start(cut)) / -float(cut.start)
    assert 0.45 < share < 0.5 + 1e-6
    if less < 1e-3:
        assert share == pytest.approx(0.5, abs=1e-3)


def test_a_cutter_of_very_many_teeth_is_a_sharp_rack():
    sharp = Rack(ha=RACK.ha + RACK.c, c=0.0)
    for z, x in ((20, 0.2), (-80, -0.5)):
        cutter = ByCutter(z, 1.0, x, RACK, Cutter(10**7), 0.0)
        rack = ByRack(z, 1.0, x, sharp)
        assert float(cutter.start) == pytest.approx(float(rack.start), abs=1e-4)
        assert float(cutter.root) == pytest.approx(float(rack.root), abs=1e-5)


@pytest.mark.parametrize("z, cutter", [(10, Cutter(20)), (14, Cutter(34, 0.2)), (8, Cutter(60, -0.1))])
def test_at_the_least_shift_the_cutters_tip_passes_the_end_of_the_line_of_action(z, cutter):
    least = float(ByCutter(z, 1.0, 0.0, RACK, cutter, cutter.x).least_shift)
    assert float(ByCutter(z, 1.0, least, RACK, cutter, cutter.x).start) == pytest.approx(0, abs=1e-9)
    assert float(real_start(ByCutter(z, 1.0, least + 0.01, RACK, cutter, cutter.x))) > 0


def test_an_array_of_shifts_is_cut_as_each_of_them():
    x = np.linspace(-0.6, 0.6, 25).reshape(5, 5)
    for tool in (None, Cutter(25, 0.1)):
        together = meshed(11, 47, 2e-3, RACK, 0.2, x, x + 0.1, cutter=tool)
        for at in np.ndindex(x.shape):
            one = meshed(11, 47, 2e-3, RACK, 0.2, float(x[at]), float(x[at]) + 0.1, cutter=tool)
            assert [together.starts[i][at] for i in (0, 1)] == pytest.approx(one.starts, rel=1e-9)
            assert together.eps[at] == pytest.approx(one.eps, rel=1e-9, nan_ok=True)


@pytest.mark.parametrize("z1, z2, x1, x2, true, formula", [
    (10, 10, 0.0, 0.0, 0.816, 1.369), (24, 93, -0.7958863, -0.4754253, 1.111, 1.992),
    (14, 48, -0.317, 0.774, 1.121, 1.539), (11, 33, -0.1, 0.1, 1.090, 1.551),
])  # fmt: skip
def test_the_contact_ratio_of_an_undercut_pair_is_what_its_outlines_show(z1, z2, x1, x2, true, formula):
    pair = meshed(z1, z2, 1.0, RACK, 0.0, x1, x2)
    assert (float(pair.eps), float(pair.eps_tips)) == pytest.approx((true, formula), abs=6e-4)
    wheels = [
        tooth_outlines.external(z, 1.0, x, RACK, tip=float(d) / 2)
        for z, x, d in zip((z1, z2), (x1, x2), pair.d_a, strict=True)
    ]
    assert tooth_outlines.contact_ratio(*wheels, float(pair.a_w), 1000) == pytest.approx(
        float(pair.eps), abs=3e-3
    )
