"""The zone of the cam's axis under a swinging roller against a grid of places, and the least cam under a swinging face
against a grid of its lowest angles: none smaller is permitted. The pressure angles and radii of curvature are those of
contacts, by differences along envelopes, no formula of the zone shared."""

import math

import numpy as np
import pytest
from exhaustive import many

from tmm_report.mechanics.cams.cam import ByLaw, Cam, Swinging, lowest_face_swinging
from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Phase, Phases
from tmm_report.mechanics.cams.shapes import NAMED, named
from tmm_report.mechanics.cams.sizes.centres import Centres, NoZone, zone
from tmm_report.mechanics.cams.sizes.least_face import TurnedFace
from tmm_report.mechanics.cams.sizes.least_size import Lever

SMOOTH = [name for name in NAMED if name != "uniform"]
COARSE, FINE = (np.linspace(0.0, FULL_TURN, count) for count in (2001, 40001))


def law_of(random, low, high):
    """A swing of `low` … `high` degrees by three phases and a dwell."""
    angles = np.radians([random.uniform(60, 140), random.uniform(0.5, 60), random.uniform(60, 120)])
    return Phases(
        (
            Phase("rise", angles[0], named(random.choice(SMOOTH))), Phase("dwell", angles[1]),
            Phase("return", angles[2], named(random.choice(SMOOTH))), Phase("dwell", FULL_TURN - angles.sum()),
        ),
        math.radians(random.uniform(low, high)),
    )  # fmt: skip


def drawn(seed, low=8, high=40):
    random = np.random.default_rng(9000 + seed)
    law = law_of(random, low, high)
    back = None if random.random() < 0.3 else math.radians(random.uniform(30, 65))
    alike = bool(random.random() < 0.5)
    return Centres(law, random.uniform(0.08, 0.2), alike, math.radians(random.uniform(30, 50)), back)


def leans(one, p, over):
    """tan of the pressure angle at the angles of the law, as the roller's path leaves it: the normal is across the path
    of the roller's centre in the cam's axes, the lift across the arm; (K, …) of places p."""
    S, slope, _ = one.law.of(np.union1d(over, one.law.breaks))
    arm = one.arm * np.exp(1j * S)
    b, k = arm - p[..., None], -1 if one.alike else 1
    # the follower is lifted counter-clockwise; the cam turns by −k
    path = 1j * arm * slope + 1j * k * b
    outward = -k * 1j * path
    lift = 1j * arm
    return outward, lift, slope


def keeps(one, p, slack=0.0, over=FINE):
    """Whether all angles of cams with axes at p, (K,), are permitted."""
    outward, lift, slope = leans(one, p, over)
    cosine = (outward.conj() * lift).real / np.abs(lift)
    sine = np.abs((outward.conj() * lift).imag) / np.abs(lift)
    good = np.ones(p.shape, bool)
    for limit, way in ((one.rise, slope >= 0), (one.back, slope <= 0)):
        if limit is not None:
            # the cam presses the way of the lift; a flipped normal would not
            good &= np.all(~way | (sine <= math.tan(limit) * cosine + slack), axis=-1)
    return good


def kept(one, p):
    """The same at the coarse angles: most of many places, (K,), fail already at a few of them."""
    good = keeps(one, p, over=COARSE[::25])
    good[good] = keeps(one, p[good], over=COARSE)
    return good


@pytest.mark.parametrize("seed", many(range(100), 8))
def test_the_least_cam_of_a_swinging_roller_is_permitted_and_none_is_smaller(seed):
    one = drawn(seed)
    best = one.best
    assert keeps(one, np.array([best.p]), 1e-9 * one.arm)[0]
    radius = one.radius(best)
    turned = np.exp(1j * np.linspace(0, FULL_TURN, 121))
    shares = np.concatenate([np.linspace(0.05, 0.95, 12), [0.999]])
    smaller = (one.arm + radius * np.outer(shares, turned)).ravel()
    assert not kept(one, smaller).any()


@pytest.mark.parametrize("seed", many(range(40), 4))
def test_the_least_distance_of_the_pivots_bounds_what_a_stated_one_may_be(seed):
    one = drawn(seed)
    least = abs(one.closest.p)
    assert keeps(one, np.array([one.closest.p]), 1e-9 * one.arm)[0]
    for share, possible in ((0.999, False), (1.001, True)):
        lever = Lever(one.law, one.arm, least * share, one.alike, one.rise, one.back)
        assert (lever.lowest is not None) == possible
    # with the distance of the best, the least angle is the best's (a hair more: it may be the least distance itself)
    apart = abs(one.best.p) * (1 + 1e-12)
    lever = Lever(one.law, one.arm, apart, one.alike, one.rise, one.back)
    assert lever.radius(lever.lowest.least) == pytest.approx(one.radius(one.best), rel=1e-6)


@pytest.mark.parametrize("seed", many(range(40), 3))
def test_the_polygon_drawn_is_the_zone(seed):
    one, random = drawn(seed), np.random.default_rng(seed)
    reach = 3 * one.arm
    box = [complex(x, y) for x, y in ((-reach, -reach), (reach, -reach), (reach, reach), (-reach, reach))]
    corners = np.array(
        zone(*one.conditions(COARSE[::4]), box)
    )  # it stands off the zone by 1e-5 of the arm or less
    tried = np.array([complex(x, y) for x, y in random.uniform(-reach, reach, (400, 2))])
    ahead = np.roll(corners, -1) - corners
    away = ((ahead.conj() * (tried[:, None] - corners)).imag / np.abs(ahead)).min(axis=1)
    inside, far = away > 0, np.abs(away) > 1e-3 * one.arm
    assert (inside == kept(one, tried))[far].all()
    assert inside.any()


def test_a_swing_too_great_for_the_angles_has_no_zone_and_says_by_what():
    law = Phases(
        (Phase("rise", 2.0, named("cosine")), Phase("return", FULL_TURN - 2.0, named("cosine"))), 2.2
    )
    one = Centres(law, 0.1, False, math.radians(30), math.radians(30))
    with pytest.raises(NoZone) as caught:
        _ = one.best
    against = caught.value.args[0]
    assert len(against) == 3
    normals, most = (np.array(x) for x in zip(*((c.normal, c.most) for c in against), strict=True))
    tried = np.array([complex(x, y) for x in np.linspace(-3, 3, 301) for y in np.linspace(-3, 3, 301)])
    assert not ((tried.conj()[:, None] * normals).real <= most).all(axis=1).any()


# ---------------------------------------------------------------- a swinging face


def face(seed):
    random = np.random.default_rng(12000 + seed)
    law = law_of(random, 5, 16)
    apart = random.uniform(0.08, 0.2)
    away = apart * random.uniform(-0.05, 0.1)
    alike = bool(random.random() < 0.5)
    return TurnedFace(law, away, apart, alike, apart * random.uniform(0.01, 0.1), math.radians(45))


def cam_of(one, lowest):
    """The cam itself: axis 0, pivot at d, the face lifted clockwise; the cam turns clockwise where it is alike."""
    motion = Swinging(complex(one.apart), -0.6 * one.apart + 1j * one.away, -1)
    made = motion.arm, 1 + 0j
    low = lowest_face_swinging(motion, made[1], one.radius(lowest))
    given = ByLaw(one.law, low, -1, 0.0, -1 if one.alike else 1)
    return Cam("k", "1", "2", "B", "K", 0j, motion, given, None, 0.7, one.radius(lowest), made[1])


@pytest.mark.parametrize("seed", many(range(100), 12))
def test_the_least_cam_under_a_swinging_face_is_convex_and_none_is_smaller(seed):
    one = face(seed)
    breaks = np.array(one.law.breaks)
    all_angles = one.law.of(np.unique(np.concatenate([COARSE, breaks, breaks - 1e-7])))

    def good(lowest, slack=0.0, every=1):
        S, slope, bend = (x[::every] for x in all_angles)
        reach = np.where(slope >= 0, abs(one.away) / math.tan(one.rise), 0.0)
        return (
            np.all(one.curved(lowest, S, slope, bend) >= one.curvature - slack, axis=-1)
            & np.all(one.contact(lowest, S, slope) >= reach - slack, axis=-1)
            & (np.ravel(one.radius(lowest)) > 0)
        )

    tried = np.linspace(-math.pi / 2, math.pi / 2, 401)
    permitted = good(tried[:, None], every=25)
    permitted[permitted] = good(tried[permitted, None])
    if one.lowest is None:
        assert one.overtaken or not permitted.any()
        return
    assert good(np.array([one.lowest]), 1e-9).all()
    assert not permitted[tried < one.lowest - 1e-4].any()


@pytest.mark.parametrize("seed", many(range(60), 6))
def test_radius_of_curvature_and_contact_are_those_of_the_envelope(seed):
    one = face(seed)
    if one.lowest is None:
        return
    lowest = one.lowest + 0.05
    cam = cam_of(one, lowest)
    theta = np.linspace(0.2, 6.0, 23)
    S, slope, bend = one.law.of(theta)
    phi = (-1 if one.alike else 1) * theta
    touch = cam.contact(phi)
    assert touch.radius == pytest.approx(one.curved(lowest, S, slope, bend), rel=1e-9)
    foot = np.abs(touch.at - cam.motion.pivot) ** 2 - one.away**2
    assert np.sqrt(foot) == pytest.approx(one.contact(lowest, S, slope), rel=1e-9)
    assert np.tan(np.abs(cam.pressure(phi))) == pytest.approx(abs(one.away) / np.sqrt(foot), rel=1e-9)
