"""Cams of arcs and straight flanks against what textbooks print of them, the outline itself, differences."""

import math

import numpy as np
import pytest
from exhaustive import many

from tmm_report import loading
from tmm_report.mechanics.cams.arcs import FULL_TURN, ArcLaw, Impossible, Outline, Rocker, Slider, outline
from tmm_report.mechanics.rivals.exact.cams import coordinate
from tmm_report.mechanics.rivals.exact.numbers import exact

THETA = np.linspace(0.011, 6.27, 75)


def drawn(seed):
    """A cam of arcs, or with straight flanks, and a follower of each kind."""
    random = np.random.default_rng(700 + seed)
    base = random.uniform(0.02, 0.04)
    nose, lift = base * random.uniform(0.15, 0.6), base * random.uniform(0.2, 0.7)
    straight = outline(base, nose, lift, flank=math.inf)
    least = base + lift  # flanks of less would be hollow or none
    cam = straight if seed % 3 == 0 else outline(base, nose, lift, flank=least * random.uniform(2.5, 8))
    roller = base * random.uniform(0.2, 0.8)
    apart, alike = base * random.uniform(3, 4), bool(random.random() < 0.5)
    followers = [
        Slider(0.0, roller), Slider(base * random.uniform(-0.3, 0.3), roller), Slider(0.0, None),
        Rocker(apart * random.uniform(0.8, 1.0), apart, alike, roller),
        Rocker(base * random.uniform(-0.2, 0.2), apart, alike, None),
    ]  # fmt: skip
    follower = followers[(seed // 3) % 5]
    return None if cam.straight and follower.roller is None else ArcLaw(cam, follower)


def points(one, count=4000):
    """Of the profile and their outward normals, the axis of symmetry along x."""
    at, normals = [], []
    flank = one.distance if one.straight else one.flank
    up = np.linspace(one.joint, one.half_angle, count)
    for centre, radius, angles in (
        (one.distance, one.nose, np.linspace(-one.joint, one.joint, count)),
        (0, one.base, np.linspace(one.half_angle, FULL_TURN - one.half_angle, count)),
        *(() if one.straight else ((one.centre(side), flank, side * up) for side in (1, -1))),
    ):
        at.append(centre + radius * np.exp(1j * angles))
        normals.append(np.exp(1j * angles))
    if one.straight:
        for side in (1, -1):
            n = np.exp(1j * side * one.half_angle)
            at.append(np.linspace(one.base * n, one.distance + one.nose * n, count))
            normals.append(np.full(count, n))
    return np.concatenate(at), np.concatenate(normals)


def farthest(law, theta):
    """The follower on the outline of points: lifted until it clears all of them."""
    at, _ = points(law.outline)
    one, found = law.follower, []
    for turn in np.exp(1j * (theta + law._joints[0])):
        z = at * turn
        if isinstance(one, Slider) and one.roller is None:
            found.append(z.imag.max())
        elif isinstance(one, Slider):
            x = z.real - one.offset
            near = np.abs(x) <= one.roller
            found.append((z.imag[near] + np.sqrt(one.roller**2 - x[near] ** 2)).max())
        else:
            w = z - one.pivot
            away, towards = np.abs(w), np.angle(w * one.side)  # from the line of the pivots
            if one.roller is None:
                lifted = one.side * towards + math.pi / 2 - np.arcsin(one.arm / away)
                found.append(lifted.max() - math.pi / 2)
            else:
                cosine = (away**2 + one.arm**2 - one.roller**2) / (2 * away * one.arm)
                lifted = one.side * towards + np.where(cosine < 1, np.arccos(np.clip(cosine, -1, 1)), -9)
                found.append(lifted.max())
    return np.array(found)


@pytest.mark.parametrize("seed", many(range(50), 10))
def test_the_follower_rests_on_the_outline_and_its_rates_are_differences(seed):
    law = drawn(seed)
    if law is None:
        return
    S, first, second = law.of(THETA)
    lowest = farthest(law, np.array([-0.01]))
    assert farthest(law, THETA) - lowest == pytest.approx(S, abs=3e-5 * law.lift)
    step = 1e-5
    inside = np.array([min(abs(x - e) for e in (*law.edges, FULL_TURN)) > 1e-3 for x in THETA])
    ahead, behind = law.of(THETA + step), law.of(THETA - step)
    assert first[inside] == pytest.approx((ahead[0] - behind[0])[inside] / (2 * step), abs=1e-7 * law.lift)
    assert second[inside] == pytest.approx((ahead[1] - behind[1])[inside] / (2 * step), abs=1e-6 * law.lift)
    assert law.lift == pytest.approx(law.of(np.linspace(0, FULL_TURN, 20001))[0].max(), rel=1e-6)


@pytest.mark.parametrize("seed", range(15))
def test_the_velocity_is_continuous_where_pieces_meet(seed):
    law = drawn(seed)
    if law is None:
        return
    before, after = law.of(law.edges - 1e-8), law.of(law.edges)
    assert before[0] == pytest.approx(after[0], abs=1e-7 * law.lift)
    assert before[1] == pytest.approx(after[1], abs=2e-6 * law.lift)
    assert np.abs(before[2] - after[2]).min() > 1e-3 * law.lift


def test_a_tangent_cam_under_a_roller_as_textbooks_work_it():
    """Least radius 32, nose 10, roller 18, lift 16 mm, 420 rpm: own numbers in the form of Rattan's exercises."""
    one = outline(0.032, 0.010, 0.016, flank=math.inf)
    law, omega = ArcLaw(one, Slider(0.0, 0.018)), 420 * math.pi / 30
    assert one.distance == pytest.approx(0.038, rel=1e-12)
    assert math.degrees(one.half_angle) == pytest.approx(54.6234598481, abs=1e-9)
    change = law.edges[1]
    assert math.degrees(change) == pytest.approx(31.7855568638, abs=1e-9)
    S, first, second = law.of(np.array([0.0, change - 1e-8, change, one.half_angle]))
    assert S[2] == pytest.approx(0.00882176467941, rel=1e-10)
    assert omega * first[2] == pytest.approx(1.60317735561, rel=1e-10)
    assert S[3] == pytest.approx(0.016, rel=1e-12)
    a = omega**2 * second
    assert a[0] == pytest.approx(96.7221231307, rel=1e-10)
    assert a[1] == pytest.approx(201.175980561, rel=1e-6)  # just before
    assert a[2] == pytest.approx(-188.02866858, rel=1e-10)
    assert a[3] == pytest.approx(-173.270774866, rel=1e-10)
    # the flank by its own formulas: (r1 + r0)(sec θ − 1) and its derivatives
    x, far = np.linspace(0, change - 1e-6, 9), 0.050
    flank = (
        far * (1 / np.cos(x) - 1),
        far * np.sin(x) / np.cos(x) ** 2,
        far * (2 - np.cos(x) ** 2) / np.cos(x) ** 3,
    )
    for ours, theirs in zip(law.of(x), flank, strict=True):
        assert ours == pytest.approx(theirs, rel=1e-10, abs=1e-15)


def test_a_cam_of_arcs_under_a_flat_face_as_textbooks_work_it():
    """Least radius 30, lift 20, nose 5 mm, angle of the rise 75° (Khurmi and Gupta's form): flank, rates by the
    formulas (R − r1)(1 − cos θ) of the flank and r(cos(α − θ)) of the nose."""
    alpha = math.radians(75)
    one = outline(0.030, 0.005, 0.020, half_angle=alpha)
    law = ArcLaw(one, Slider(0.0, None))
    r, R = one.distance, one.flank
    assert r == pytest.approx(0.045, rel=1e-12)
    # the triangle of the centres by the law of cosines, and the flank's angle by that of sines
    third = r**2 + (R - 0.030) ** 2 + 2 * r * (R - 0.030) * math.cos(alpha)
    assert math.sqrt(third) == pytest.approx(R - 0.005)
    change = math.asin(r * math.sin(alpha) / (R - 0.005))
    assert law.edges == pytest.approx([0, change, 2 * alpha - change, 2 * alpha], abs=1e-12)
    x = np.linspace(0.01, change - 0.01, 7)
    away = R - 0.030
    for ours, theirs in zip(
        law.of(x), (away * (1 - np.cos(x)), away * np.sin(x), away * np.cos(x)), strict=True
    ):
        assert ours == pytest.approx(theirs, rel=1e-10)
    x = np.linspace(change, 2 * alpha - change - 0.01, 7)
    left = alpha - x
    nose = r * np.cos(left) + 0.005 - 0.030, r * np.sin(left), -r * np.cos(left)
    for ours, theirs in zip(law.of(x), nose, strict=True):
        assert ours == pytest.approx(theirs, rel=1e-10, abs=1e-15)


STATED = (
    ("nose", "lift"), ("nose", "distance"), ("lift", "distance"), ("nose", "half_angle"), ("lift", "half_angle"),
    ("distance", "half_angle"),
)  # fmt: skip


@pytest.mark.parametrize("seed", range(30))
@pytest.mark.parametrize("keys", STATED)
def test_any_two_sizes_beside_the_flank_give_the_same_cam(seed, keys):
    random = np.random.default_rng(seed)
    base = 0.03
    flank = math.inf if seed % 2 else base * random.uniform(3, 9)
    made = outline(base, base * random.uniform(0.2, 0.6), base * random.uniform(0.2, 0.7), flank=flank)
    again = outline(base, flank=flank, **{key: getattr(made, key) for key in keys})
    for key in ("nose", "distance", "lift", "half_angle"):
        assert getattr(again, key) == pytest.approx(getattr(made, key), rel=1e-9)


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("keys", STATED[:3])
def test_the_flank_follows_from_the_half_angle(seed, keys):
    random = np.random.default_rng(seed)
    base = 0.03
    made = outline(base, base * 0.4, base * 0.5, flank=base * random.uniform(3, 9))
    again = outline(base, half_angle=made.half_angle, **{key: getattr(made, key) for key in keys})
    assert again.flank == pytest.approx(made.flank, rel=1e-9)


@pytest.mark.parametrize(
    ("sizes", "why"),
    [
        ({"nose": 0.01, "lift": 0.016, "flank": 0.02}, "flank"),
        ({"nose": 0.06, "lift": 0.016, "flank": math.inf}, "sizes"),
        ({"nose": 0.01, "lift": 0.016, "half_angle": 0.3}, "hollow"),
        ({"nose": 0.01, "half_angle": 1.7, "flank": math.inf}, "angle"),
    ],
)
def test_sizes_of_which_no_cam_can_be_made(sizes, why):
    with pytest.raises(Impossible, match=why):
        outline(0.032, **sizes)


def test_a_straight_flank_lies_under_no_flat_face_and_a_short_lever_does_not_reach():
    one = Outline(0.032, 0.010, 0.038)
    with pytest.raises(Impossible, match="face"):
        ArcLaw(one, Slider(0.0, None))
    with pytest.raises(Impossible, match="reach"):
        ArcLaw(one, Rocker(0.05, 0.12, True, 0.01))


ALONE = "language: en\ncam: {{{follower}, profile: {profile}, rotation: {sense}, positions: 24}}\n"
TANGENT = "{tangent: {base: 32 mm, nose: 10 mm, lift: 16 mm}}"
ARCS = "{arcs: {base: 32 mm, nose: 10 mm, lift: 16 mm, flank: 110 mm}}"
TYPED = {
    "roller": ("roller: 18 mm, offset: 5 mm", TANGENT),
    "edge": ("follower: knife", ARCS),
    "flat": ("follower: flat", ARCS),
    "lever against": ("roller: 14 mm, arm: 90 mm, centre_distance: 100 mm, side: against", TANGENT),
    "lever with": ("roller: 14 mm, arm: 90 mm, centre_distance: 100 mm, side: with", ARCS),
    "flat lever": ("follower: flat, face_offset: -6 mm, centre_distance: 100 mm, side: against", ARCS),
}


@pytest.mark.parametrize("sense", ["counter-clockwise", "clockwise"])
@pytest.mark.parametrize("name", TYPED)
def test_the_profile_that_the_follower_makes_is_the_outline_it_was_stated_by(name, sense):
    follower, profile = TYPED[name]
    cam = loading.loads(ALONE.format(follower=follower, profile=profile, sense=sense)).cam.cam
    one = cam.given.law.outline
    at = cam.profile(np.linspace(0, FULL_TURN, 241))
    tip = np.exp(1j * cam.given.law._joints[0])  # towards the nose where the rise begins
    z = at / (tip if cam.given.sense > 0 else -tip.conjugate())
    nose = np.abs(np.abs(z - one.distance) - one.nose)
    round_ = np.abs(np.abs(z) - one.base)
    if one.straight:
        n = np.exp(1j * one.half_angle)
        flanks = [np.abs((z * side.conjugate()).real - one.base) for side in (n, n.conjugate())]
    else:
        flanks = [np.abs(np.abs(z - one.centre(side)) - one.flank) for side in (1, -1)]
    assert np.min([nose, round_, *flanks], axis=0).max() < 1e-12


@pytest.mark.parametrize("name", TYPED)
def test_forty_digits_of_the_follower_are_those_of_doubles(name):
    follower, profile = TYPED[name]
    cam = loading.loads(ALONE.format(follower=follower, profile=profile, sense="clockwise")).cam.cam
    for phi in np.linspace(0.05, 6.2, 15):
        ours, theirs = cam.given.of(np.array(phi)), coordinate(cam, exact(float(phi)))
        for own, other in zip(ours, theirs, strict=True):
            assert float(own) == pytest.approx(float(other), rel=1e-11, abs=1e-13)
