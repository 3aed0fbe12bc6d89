"""Radius of curvature by the law alone against the contact's, jerk against differences, the rules of guides."""

import math

import numpy as np
import pytest

from tmm_report.mechanics.cams.cam import ByLaw, Cam, Sliding, Swinging, lowest_sliding, lowest_swinging
from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Phase, Phases, Tabled
from tmm_report.mechanics.cams.shapes import NAMED, Parabolic, named
from tmm_report.mechanics.cams.sizes import rules
from tmm_report.mechanics.cams.sizes.curvature import OnArm, OnLine, least_convex, least_hollow


def law_of(name, lift):
    rise, back = Phase("rise", 1.7, named(name)), Phase("return", 1.3, named(name))
    return Phases((rise, Phase("dwell", 0.5), back, Phase("dwell", FULL_TURN - 3.5)), lift)


def cam(law, motion, low, side, sense, base):
    given = ByLaw(law, low, side, 0.0, sense)
    return Cam("k", "1", "2", "B", "K", 0j, motion, given, 0.0, 0.5, base)


@pytest.mark.parametrize("name", ["cosine", "sine", "parabolic", "modified_sine"])
@pytest.mark.parametrize("sense", [1, -1])
def test_curvature_of_the_pitch_curve_is_the_contacts(name, sense):
    theta, base = np.linspace(0.01, 6.2, 57), 0.05
    law, e = law_of(name, 0.02), 0.012
    motion = Sliding(1j, complex(sense * e), 1.0)
    low = lowest_sliding(motion, base)
    ours = OnLine(e, low).radius(*law.of(theta))
    theirs = cam(law, motion, low, 1, sense, base).contact(sense * theta).radius
    assert 1 / ours == pytest.approx(1 / theirs, abs=1e-7)
    law = law_of(name, 0.3)
    for side in (1, -1):
        motion = Swinging(complex(0.14), 0.11 + 0j, side)
        low = lowest_swinging(motion, base)
        start = math.acos((0.14**2 + 0.11**2 - base**2) / (2 * 0.14 * 0.11))
        ours = OnArm(0.11, 0.14, start, side == sense).radius(*law.of(theta))
        theirs = cam(law, motion, low, side, sense, base).contact(sense * theta).radius
        assert 1 / ours == pytest.approx(1 / theirs, abs=1e-7)


def test_least_radii_of_a_course_and_by_circles_through_three_points():
    """Own numbers in the form of the guides: ρ on the first side of the jump at 35.7°, 43.4091 mm."""
    turn = np.radians([100, 40, 80, 140])
    law = Phases(
        (Phase("rise", turn[0], Parabolic(1.8)), Phase("dwell", turn[1]), Phase("return", turn[2], named("cosine")),
         Phase("dwell", turn[3])), 0.045,
    )  # fmt: skip
    place = OnLine(0.012, math.sqrt(0.054**2 - 0.012**2))
    least = least_convex(law, place)
    assert least == pytest.approx(0.0434091269189, rel=1e-6)
    theta = np.linspace(0, FULL_TURN, 72001)
    S, _, _ = law.of(theta)
    z = (place.offset + 1j * (place.start + S)) * np.exp(-1j * theta)
    a, b, c = z[:-2], z[1:-1], z[2:]
    area = ((b - a).conj() * (c - a)).imag
    with np.errstate(divide="ignore"):
        radius = -np.abs(b - a) * np.abs(c - b) * np.abs(a - c) / (2 * area)
    assert least == pytest.approx(radius[radius > 0].min(), rel=1e-3)
    assert least_hollow(law, place) == pytest.approx(-radius[radius < 0].max(), rel=1e-3)


def test_the_roller_of_a_course_by_its_rules():
    limits = rules.roller_limits(0.054, 0.0434091269189)
    assert limits == pytest.approx((0.0216, 0.0347273015351, math.inf), rel=1e-9)
    assert rules.roller_limits(0.054, 0.0434091269189, 0.02).most == pytest.approx(0.016)
    assert limits.most == limits.by_radius
    assert rules.chosen(limits.most, 0.001) == pytest.approx(0.021)
    assert rules.chosen(limits.most, 0.001, (0.010, 0.016, 0.019, 0.022)) == 0.019
    assert rules.chosen(0.005, 0.01) is None
    assert rules.chosen(0.02, 0.005) == pytest.approx(0.02)  # a whole number of steps is none less
    assert rules.by_shaft(0.04, 0.021) == pytest.approx(0.053)


@pytest.mark.parametrize("name", NAMED)
def test_jerk_is_the_difference_of_accelerations(name):
    law, step = law_of(name, 0.03), 1e-5
    theta = np.linspace(0.0131, 6.2, 91)
    inside = np.array([min(abs(x - e) for e in law.breaks) > 1e-3 for x in theta])
    ahead, behind = (law.of(theta + d)[2] for d in (step, -step))
    assert law.third(theta)[inside] == pytest.approx(((ahead - behind) / (2 * step))[inside], abs=1e-6)


def test_jerk_of_a_table():
    angles = np.arange(12) * FULL_TURN / 12
    law = Tabled(tuple(angles), tuple(0.01 * (1 - np.cos(angles))))
    theta = np.linspace(0.05, 6.0, 40)
    ahead, behind = (law.of(theta + d)[2] for d in (1e-6, -1e-6))
    assert law.third(theta) == pytest.approx((ahead - behind) / 2e-6, abs=1e-6)
