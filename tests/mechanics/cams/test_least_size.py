"""Least cams with a sliding roller against a search over all of them, and a course's answers."""

import math
from functools import partial

import numpy as np
import pytest
from exhaustive import many

from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Phase, Phases
from tmm_report.mechanics.cams.shapes import NAMED, Parabolic, named
from tmm_report.mechanics.cams.sizes.least_face import under_face
from tmm_report.mechanics.cams.sizes.least_size import Lever, Zone

SMOOTH = [name for name in NAMED if name != "uniform"]
COARSE, FINE = (np.linspace(0.0, FULL_TURN, count) for count in (6001, 100001))


def drawn(seed):
    random = np.random.default_rng(seed)
    angles = np.radians([random.uniform(50, 140), random.uniform(0.5, 60), random.uniform(50, 120)])
    law = Phases(
        (
            Phase("rise", angles[0], named(random.choice(SMOOTH))), Phase("dwell", angles[1]),
            Phase("return", angles[2], named(random.choice(SMOOTH))), Phase("dwell", FULL_TURN - angles.sum()),
        ),
        random.uniform(5e-3, 0.08),
    )  # fmt: skip
    back = None if random.random() < 0.3 else math.radians(random.uniform(20, 60))
    return Zone(law, math.radians(random.uniform(15, 45)), back)


def keeps(zone, e, s0, slack=0.0, over=FINE):
    """Whether all angles of a cam are permitted, dwells and ends by the limit of the rise; (…) of e and s0."""
    S, slope, _ = zone.law.of(over)
    tangent = (slope - e[..., None]) / (s0[..., None] + S)
    good = (s0 > 0) & np.all(
        np.where(slope >= 0, np.abs(tangent) <= math.tan(zone.rise) + slack, True), axis=-1
    )
    if zone.back is not None:
        good &= np.all(np.where(slope < 0, -tangent <= math.tan(zone.back) + slack, True), axis=-1)
    return good


def kept(permitted, *sizes):
    """`permitted` at the coarse angles: most of many sizes, (K,), fail already at a few of them."""
    good = permitted(*sizes, over=COARSE[::50])
    good[good] = permitted(*(size[good] for size in sizes), over=COARSE)
    return good


@pytest.mark.parametrize("seed", many(range(100), 12))
def test_the_least_cam_is_permitted_and_none_is_smaller(seed):
    zone = drawn(seed)
    best = zone.best
    assert keeps(zone, np.array(best.e), np.array(best.s0), 1e-9)
    # every cam a thousandth smaller, at every offset that it can have
    r0 = best.radius * 0.999
    turned = np.linspace(-math.pi / 2, math.pi / 2, 181)[1:-1]
    assert not kept(partial(keeps, zone), r0 * np.sin(turned), r0 * np.cos(turned)).any()


@pytest.mark.parametrize("seed", range(20))
def test_with_a_stated_offset_none_is_smaller(seed):
    zone = drawn(1000 + seed)
    for share in (-0.6, 0.0, 0.4, 1.3):
        place = zone.at(share * zone.best.radius)
        e = np.array(place.e)
        assert keeps(zone, e, np.array(place.s0), 1e-9)
        assert not keeps(zone, e, np.array(place.s0 * 0.999))


def test_a_course_with_unequal_accelerations():
    """Own numbers in the form of Korenyako's and Popov's guides; a search over e and s0 found the same."""
    turn = np.radians([100, 40, 80, 140])
    law = Phases(
        (
            Phase("rise", turn[0], Parabolic(1.8)), Phase("dwell", turn[1]),
            Phase("return", turn[2], named("cosine")), Phase("dwell", turn[3]),
        ),
        0.045,
    )  # fmt: skip
    zone = Zone(law, math.radians(30), math.radians(45))
    best = zone.best
    assert (best.radius, best.e, best.s0) == pytest.approx(
        (0.0499017322171, 0.0147669389017, 0.0476667640368), rel=1e-9
    )
    assert zone.at(0.0).radius == pytest.approx(0.0732438524868, rel=1e-9)
    assert zone.at(0.012).radius == pytest.approx(0.0538142374724, rel=1e-9)


def lever(seed, swing=(8, 30), alike=None):
    random = np.random.default_rng(5000 + seed)
    angles = np.radians([random.uniform(60, 140), random.uniform(0.5, 60), random.uniform(60, 120)])
    law = Phases(
        (
            Phase("rise", angles[0], named(random.choice(SMOOTH))), Phase("dwell", angles[1]),
            Phase("return", angles[2], named(random.choice(SMOOTH))), Phase("dwell", FULL_TURN - angles.sum()),
        ),
        math.radians(random.uniform(*swing)),
    )  # fmt: skip
    apart = random.uniform(0.1, 0.25)
    back = None if random.random() < 0.3 else math.radians(random.uniform(30, 65))
    arm, drawn_alike = apart * random.uniform(0.6, 1.15), bool(random.random() < 0.5)
    alike = drawn_alike if alike is None else alike
    return Lever(law, arm, apart, alike, math.radians(random.uniform(30, 55)), back)


def leans(lever, lowest, over=FINE):
    """Whether all angles of a lever's cam are permitted; (…) of the lowest angle."""
    S, slope, _ = lever.law.of(over)
    turned = np.asarray(lowest)[..., None] + S
    k = -1 if lever.alike else 1
    tangent = (lever.arm * (1 + k * slope) - lever.apart * np.cos(turned)) / (lever.apart * np.sin(turned))
    inside = (turned > 0) & (turned < math.pi)
    good = np.all(
        inside & np.where(slope >= 0, np.abs(tangent) <= math.tan(lever.rise) + 1e-7, True), axis=-1
    )
    if lever.back is not None:
        good &= np.all(np.where(slope <= 0, np.abs(tangent) <= math.tan(lever.back) + 1e-7, True), axis=-1)
    return good


@pytest.mark.parametrize("seed", many(range(60), 12))
def test_the_least_lever_cam_is_permitted_and_none_is_smaller(seed):
    the_least_is_permitted_and_none_is_smaller(lever(seed))


@pytest.mark.parametrize("seed", many(range(60), 20))
def test_the_least_cam_of_a_lever_that_swings_faster_than_its_cam_turns(seed):
    the_least_is_permitted_and_none_is_smaller(lever(seed, (50, 90), True))


def the_least_is_permitted_and_none_is_smaller(one):
    tried = np.linspace(1e-3, math.pi - 1e-3, 601)
    permitted = kept(partial(leans, one), tried)
    if one.lowest is None:
        assert not permitted.any()
        return
    assert leans(one, one.lowest.least)
    assert not permitted[tried < one.lowest.least - 1e-5].any()
    assert one.radius(one.lowest.least) == pytest.approx(
        abs(one.apart - one.arm * np.exp(1j * one.lowest.least)), rel=1e-12
    )


@pytest.mark.parametrize("name", SMOOTH)
def test_least_cam_under_a_flat_face(name):
    rise, back = Phase("rise", 1.6, named(name)), Phase("return", 1.2, named(name))
    law = Phases((rise, Phase("dwell", 0.4), back, Phase("dwell", FULL_TURN - 3.2)), 0.02)
    found = under_face(law, 0.005).asked
    S, _, bend = law.of(FINE)
    assert found.b >= np.max(0.005 - S - bend) - 1e-12
    assert found.b == pytest.approx(np.max(0.005 - S - bend), rel=2e-4)


@pytest.mark.parametrize("slope", [0.3, 1.6, 2.0, 2.3])
def test_the_angles_that_one_position_permits(slope):
    """Also of a lever that swings so fast that the axis would lie behind it."""
    one = Lever(drawn(1).law, 0.1, 0.1, True, math.radians(50))
    turned = np.linspace(1e-4, math.pi - 1e-4, 20001)
    tangent = (one.arm * (1 - slope) - one.apart * np.cos(turned)) / (one.apart * np.sin(turned))
    permitted = turned[np.abs(tangent) <= math.tan(one.rise)]
    high = -one._high(one.rise, np.array(0.0), np.array(slope))
    low = max(one._low(one.rise, side, np.array(0.0), np.array(slope)) for side in (1, -1))
    assert permitted.max() == pytest.approx(min(float(high), math.pi), abs=1e-3)
    assert permitted.min() == pytest.approx(max(float(low), 0.0), abs=1e-3)
