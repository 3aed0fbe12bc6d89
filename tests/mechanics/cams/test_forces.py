"""Forces of a cam against second ways: the equilibrium of the whole follower, the balance of power, the formula of the
books; the spring against scipy's linear programme; the pressure in the contact by the rule of steel and by chords."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from exhaustive import many
from scipy.optimize import linprog

from tmm_report.mechanics.calculus import laws
from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.cams import spring
from tmm_report.mechanics.cams.cam import ByLaw, Cam, Sliding, Swinging
from tmm_report.mechanics.cams.contact_pressure import Material, hertz
from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Phase, Phases
from tmm_report.mechanics.cams.forces import Guide, Pin, Rubs, touching, ways
from tmm_report.mechanics.cams.shapes import NAMED, named
from tmm_report.mechanics.cams.turn import Contact, Loaded, Spring

STEEL = Material(2.1e11, 0.3)
KINDS = ("roller", "edge", "flat", "lever", "flat lever")


def drawn(seed: int, kind: str | None = None, law: str | None = None) -> Loaded:
    """A loaded follower that touches its cam everywhere, its sizes and loads by the seed."""
    draw = np.random.default_rng(seed)
    kind = kind or KINDS[seed % len(KINDS)]
    sense, swings = int(draw.choice([-1, 1])), kind in ("lever", "flat lever")
    smooth = [name for name in NAMED if name != "uniform"]
    up, back = (named(law or str(draw.choice(smooth))) for _ in range(2))
    angles = draw.uniform(0.8, 1.2, 4) * np.array([2.2, 0.6, 2.0, 1.4])
    angles *= FULL_TURN / angles.sum()
    kinds = ("rise", "dwell", "return", "dwell")
    phases = tuple(
        Phase(one, float(angle), shape)
        for one, angle, shape in zip(kinds, angles, (up, None, back, None), strict=True)
    )
    lift = draw.uniform(0.15, 0.3) if swings else draw.uniform(0.01, 0.025)
    law_of = Phases(phases, float(lift))
    r0, roller = draw.uniform(0.06, 0.08), draw.uniform(0.008, 0.015)
    size = {"roller": roller, "edge": 0.0, "lever": roller}.get(kind)
    start = draw.uniform(-3, 3)
    if swings:
        side = int(draw.choice([-1, 1]))
        pivot, arm = draw.uniform(0.14, 0.17) * np.exp(1j * draw.uniform(-3, 3)), draw.uniform(0.11, 0.13)
        motion: Sliding | Swinging = Swinging(complex(pivot), complex(arm), side)
        towards = float(np.angle(-pivot))
        if kind == "lever":
            d, l = abs(pivot), arm
            low = towards + side * np.arccos((d * d + l * l - r0**2) / (2 * d * l))
        else:
            low = towards + side * np.arcsin(r0 / abs(pivot))
    else:
        along = np.exp(1j * draw.uniform(-3, 3))
        foot = draw.uniform(-0.012, 0.012) if kind != "flat" else 0.0
        motion = Sliding(complex(along), complex(-1j * along * foot), complex(-1j * along))
        low = np.sqrt(r0**2 - foot**2)
    cam = Cam(
        "k", "1", "2", "B", "K", 0j, motion, ByLaw(law_of, float(low), motion.side if swings else 1, start, sense),
        size, 0.6, r0 - (size or 0.0),
    )  # fmt: skip
    made = Loaded(
        cam, sense, float(draw.uniform(5, 20)), begin=start, inertia=0.002 if swings else 1.5,
        mass=0.8 if swings else 1.5, centre=complex(draw.uniform(0, 0.08), draw.uniform(-0.02, 0.02)) if swings else 0j,
        gravity=-9.81j, load=laws.Constant(30.0 if swings else 300.0),
        spring=Spring(20.0, 40.0) if swings else Spring(200.0, 5000.0),
        rubs=Rubs(
            guide=None if swings else Guide(0.09, float(draw.uniform(0.03, 0.06)), 0.12, bool(draw.integers(2))),
            pin=Pin(0.004, 0.1) if size else None, face=0.0 if size else 0.1, pivot=Pin(0.01, 0.12) if swings else None,
        ),
    )  # fmt: skip
    return made


X = np.linspace(0.003, FULL_TURN - 0.004, 181)
SEEDS = many(range(20), 6)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_power_of_the_drive_is_that_of_the_needs_and_of_every_friction(seed):
    one = drawn(seed)
    found = one.at(X)
    assert not found.jams.any() and not found.left.any()
    needed = one.parts(X).whole * one.lifted(X)[1]
    assert np.allclose(found.smooth, needed, rtol=1e-11, atol=1e-11 * np.abs(needed).max())
    assert np.allclose(found.torque, needed + found.wasted, rtol=1e-11, atol=1e-11 * np.abs(needed).max())
    assert all((power >= 0).all() and power.any() for power in found.lost.values()) and found.lost


@pytest.mark.parametrize("seed", SEEDS)
def test_the_whole_follower_is_in_equilibrium(seed):
    """All its forces as vectors, friction against what slides: their sum and their moment about a foreign point."""
    one = drawn(seed)
    found, cam = one.at(X), one.cam
    S, first, _ = one.lifted(X)
    phi = one.phi(X)
    q, b = cam.moved(phi)
    here = touching(cam, (q, b), one.sense, one.rubs)
    about = 0.3 - 0.2j
    parts = one.parts(X)
    if one.slides:
        a = cam.motion.along
        other = -(parts.load + parts.spring + parts.inertia) * a + one.mass * dot(one.gravity, a) * a
        guide, near = one.rubs.guide, b.z + one.rubs.guide.at(S) * a
        forces = [(here.at, found.R), (b.z, other)]
        for place, side in zip((near, near + guide.length * a), found.ends, strict=True):
            forces.append((place, side * 1j * a))
            forces.append((b.z, -guide.friction * np.abs(side) * ways(first) * a))  # on the axis of the stem
        total = sum(force for _, force in forces)
        moment = sum(cross(place - about, force) for place, force in forces)
        assert np.abs(total).max() < 1e-9 * np.abs(found.R).max()
        assert np.abs(moment).max() < 1e-9 * np.abs(found.R).max()
        return
    side, pivot = cam.motion.side, cam.motion.pivot
    centre = one._centre(q)
    weight = one.mass * one.gravity
    inertia = -one.mass * one.omega**2 * (1j * q.dd - q.d**2) * centre
    bears = -(found.R + weight + inertia)  # of the pivot on the follower
    rub = -side * one.rubs.pivot.circle * np.abs(bears) * ways(first)
    couple = -side * (parts.load + parts.spring + parts.inertia)
    moment = cross(here.at - pivot, found.R) + cross(centre, weight) + couple + rub
    assert np.abs(moment).max() < 1e-11 * np.abs(found.R).max()


@pytest.mark.parametrize("seed", SEEDS)
def test_the_force_of_the_books(seed):
    """N = Q/(cos α − f(1 + 2b/c)|sin α|) of a rise, with + of a return; of a lever by its moment about the pivot."""
    one = drawn(seed)
    rubs = Rubs(guide=replace(one.rubs.guide, lowest=False)) if one.slides else Rubs()
    one = replace(one, rubs=rubs)
    found, alpha, Q = one.at(X), one.cam.pressure(one.phi(X)), one.parts(X).whole
    if one.slides:
        if one.cam.flat:
            c, f, offset = rubs.guide.length, rubs.guide.friction, np.abs(one.lifted(X)[1])
            expected = Q / (1 - ways(one.lifted(X)[1]) * 2 * f * offset / c)
        else:
            c, b, f = rubs.guide.length, rubs.guide.overhang, rubs.guide.friction
            growth = f * (1 + 2 * b / c) * np.abs(np.sin(alpha))
            expected = Q / (np.cos(alpha) - ways(one.lifted(X)[1]) * growth)
    else:
        touch = one.cam.contact(one.phi(X))
        point = touch.at if one.cam.flat else one.cam.moved(one.phi(X))[1].z
        expected = Q / (np.abs(point - one.cam.motion.pivot) * np.cos(alpha))
    assert pytest.approx(expected, rel=1e-10) == found.N


def test_a_guide_jams_from_its_angle_on():
    """At the angle arctan(c/(f(c + 2b))) the cam's force grows without bound; beyond it none lifts the follower."""
    for seed in range(0, 40, 5):
        one = drawn(seed, "roller")
        plain = replace(one, rubs=Rubs(guide=Guide(0.02, 0.06, 0.4)))
        rises = plain.lifted(X)[1] > 0
        alpha = np.abs(plain.cam.pressure(plain.phi(X)))
        beyond = alpha > plain.rubs.guide.jams_from(0.0)
        assert (plain.at(X).jams == (beyond & rises)).all()
        limit = np.arctan(0.02 / (0.4 * (0.02 + 2 * 0.06)))
        assert plain.rubs.guide.jams_from(0.0) == pytest.approx(limit, rel=1e-14)


def test_a_pivot_jams_where_the_cam_presses_through_its_circle_of_friction():
    one = replace(drawn(3, "lever"), mass=0.0)
    arm, rises = np.abs(_arms(one)), one.lifted(X)[1] > 0
    circle = 1.0001 * float(np.median(arm[rises]))
    wide = replace(one, rubs=Rubs(pivot=Pin(2 * circle, 0.5)))
    assert ((rises & (arm < circle)) == wide.at(X).jams).all()
    assert wide.at(X).jams.any()


def _arms(one):
    phi = one.phi(X)
    here = one.cam.contact(phi)
    return cross(here.at - one.cam.motion.pivot, here.normal)


def test_a_follower_that_is_not_held_has_left_its_cam_and_a_groove_pulls_it():
    one = replace(
        drawn(0, "roller", "sine"), spring=Spring(0.0, 0.0), load=laws.Constant(0.0), gravity=0j, omega=40.0
    )
    free, held = one.at(X), replace(one, groove=True).at(X)
    Q = one.parts(X).whole
    assert (free.left == (Q < 0)).all() and free.left.any() and not held.left.any()
    alpha = one.cam.pressure(one.phi(X))
    assert free.N[free.left] == pytest.approx((Q / np.cos(alpha))[free.left], rel=1e-11)
    assert free.torque[free.left] == pytest.approx((Q * one.lifted(X)[1])[free.left], rel=1e-11)
    needed = Q * one.lifted(X)[1]
    assert np.allclose(held.torque, needed + held.wasted, rtol=1e-11, atol=1e-11 * np.abs(needed).max())
    assert (held.wasted[free.left & (one.lifted(X)[1] != 0)] > 0).all()


# ---------------------------------------------------------------- over the turn


@pytest.mark.parametrize("seed", many(range(20), 5))
def test_the_work_of_a_turn_is_that_of_load_and_friction(seed):
    """Springs, weights and inertia give back what they take: without friction a constant load does no work."""
    one = drawn(seed)
    over = one.panels
    found = one.at(over.x)
    scale = np.abs(found.torque).max()
    assert over.total(found.smooth) == pytest.approx(0.0, abs=1e-9 * scale)
    assert over.total(found.torque) == pytest.approx(over.total(found.wasted), rel=1e-7)
    fine = np.linspace(0, FULL_TURN, 400001)[:-1] + 1e-6
    assert over.mean(found.torque) == pytest.approx(
        float(np.mean(one.at(fine).torque)), rel=1e-4, abs=1e-6 * scale
    )


def test_a_load_of_one_stroke_does_its_work_on_the_way_out():
    curve = laws.ByDisplacement(
        1 + 0j, ((0.0, 100.0), (0.5, 400.0), (1.0, 400.0)), ((0.0, 50.0), (1.0, 50.0))
    )
    one = replace(drawn(5, "roller"), load=curve, rubs=Rubs())
    work = one.lift * (250 * 0.5 + 400 * 0.5 - 50)
    assert one.panels.total(one.at(one.panels.x).torque) == pytest.approx(work, rel=1e-9)


# ---------------------------------------------------------------- the spring


def demanded(seed: int, reserve: float = 1.4):
    one = drawn(seed)
    one = replace(one, omega=60.0, load=laws.Constant(5.0 if one.slides else 0.05), gravity=0j)
    over = one.panels
    parts = one.parts(over.x)
    S = one.lifted(over.x)[0]
    return one, over, -reserve * parts.inertia - parts.load - parts.weight, S


def fine_of(one, reserve=1.4):
    x = np.concatenate(
        [np.linspace(0, FULL_TURN, 20001), one.panels.edges[:-1] + 2e-9, one.panels.edges[1:] - 2e-9]
    )
    parts = one.parts(x)
    return -reserve * parts.inertia - parts.load - parts.weight, one.lifted(x)[0]


@pytest.mark.parametrize("seed", SEEDS)
def test_the_least_spring_is_that_of_the_linear_programme(seed):
    """By scipy over a fine turn: first the least greatest force, then with it the least preload."""
    one, over, D, S = demanded(seed)
    found = spring.smallest(over, D, S, one.lift)
    d, s = fine_of(one)
    scale = np.abs(d).max()
    rows = -np.stack([np.ones(len(s)), s / one.lift], axis=1)
    first = linprog([1, 1], A_ub=rows, b_ub=-d / scale, bounds=[(0, None)] * 2)
    assert found.greatest == pytest.approx(first.fun * scale, rel=1e-6)
    assert found.preload + found.rate * one.lift == pytest.approx(found.greatest, rel=1e-12)
    assert (found.preload + found.rate * s - d).min() > -1e-7 * scale
    less = 0.999 * found.preload - 1e-6 * scale
    steeper = (found.greatest - less) / one.lift
    assert less < 0 or (less + steeper * s - d).min() < 0


@pytest.mark.parametrize("seed", SEEDS)
def test_a_stated_rate_a_stated_preload_and_a_stated_ratio_are_met_and_no_more(seed):
    one, over, D, S = demanded(seed)
    d, s = fine_of(one)
    scale = np.abs(d).max()
    rate = 0.2 * scale / one.lift
    least = spring.preload(over, D, S, rate)
    assert least.value == pytest.approx(max((d - rate * s).max(), 0.0), rel=1e-5)
    ratio = spring.of_ratio(over, D, S, one.lift, 0.4)
    assert ratio.value == pytest.approx((d / (0.4 + 0.6 * s / one.lift)).max(), rel=1e-5)
    preload = 0.5 * ratio.value
    asked = spring.rate(over, D, S, preload)
    with np.errstate(divide="ignore", invalid="ignore"):
        expected = np.max(np.where(s > 1e-6 * one.lift, (d - preload) / s, -np.inf))
    assert asked.value == pytest.approx(max(expected, 0.0), rel=1e-4)


def test_no_rate_holds_a_follower_that_is_lifted_off_where_the_spring_is_not_drawn():
    _, over, D, S = demanded(0)
    assert spring.rate(over, D + 10 * np.abs(D).max(), S, 0.0) is None


@pytest.mark.parametrize("seed", SEEDS)
def test_at_the_speed_of_lifting_off_the_least_force_is_nothing(seed):
    one = drawn(seed)
    found = one.lifts_off()
    fast = replace(one, omega=found.value)
    over = fast.panels
    parts = fast.parts(over.x)
    least = over.extremes(parts.whole)[0][0]
    assert least == pytest.approx(0.0, abs=1e-9 * np.abs(parts.inertia).max())
    slow = replace(one, omega=0.999 * found.value)
    assert slow.panels.extremes(slow.parts(slow.panels.x).whole)[0][0] > 0


def test_a_follower_that_hangs_leaves_at_no_speed_and_one_that_is_drawn_off_at_any():
    x = panels(FULL_TURN, [1.0, 2.0])
    one = np.ones(x.shape)
    assert spring.lifts_off(x, one, 1.0, one) is None
    assert spring.lifts_off(x, -one, 1.0, -one).value == 0.0


# ---------------------------------------------------------------- the contact


def test_pressure_of_steel_on_steel_is_that_of_the_rule():
    """0.418 √(N E/(B ρ)), for two of E = 2.1e5 MPa and ν = 0.3, a roller of 10 mm on a profile of 40 mm."""
    curved = 1 / 0.010 + 1 / 0.040
    expected = 0.418 * np.sqrt(800.0 * 2.1e11 * curved / 0.012)
    assert hertz(800.0, 0.012, curved, STEEL, STEEL) == pytest.approx(expected, rel=1e-3)
    assert hertz(800.0, 0.012, curved, Material(2.1e11, 0.3), Material(1.1e11, 0.3)) == pytest.approx(
        0.418 * np.sqrt(800.0 * (2 * 2.1 * 1.1 / 3.2 * 1e11) * curved / 0.012), rel=1e-3
    )


@pytest.mark.parametrize("kind", ["roller", "flat", "lever"])
def test_curvature_of_the_contact_is_that_of_the_circle_through_three_points_of_the_profile(kind):
    one = replace(drawn(7, kind), contact=Contact(0.012, STEEL, STEEL))
    found = one.at(X)
    pressure = one.pressure(X, found.N)
    step = 1e-4
    p = [one.cam.profile(one.phi(X + d)) for d in (-step, 0.0, step)]
    sides = [abs(p[1] - p[0]), abs(p[2] - p[1]), abs(p[2] - p[0])]
    area = np.abs(cross(p[1] - p[0], p[2] - p[0])) / 2
    bent = np.sign(cross(p[1] - p[0], p[2] - p[1])) * np.sign(-one.sense) * 4 * area / np.prod(sides, axis=0)
    own = (1 / one.cam.roller if one.cam.roller else 0.0) + bent
    expected = np.sqrt(found.N * own / (pi * 0.012 * 2 * (1 - 0.09) / 2.1e11))
    near = np.min(np.abs(X[:, None] - one.panels.edges), axis=1) > 1e-3
    assert pressure[near] == pytest.approx(expected[near], rel=2e-3)


def test_the_outer_wall_of_a_groove_is_hollow():
    one = replace(
        drawn(0, "roller", "sine"), spring=Spring(0.0, 0.0), load=laws.Constant(0.0), gravity=0j, groove=True,
        contact=Contact(0.01, STEEL, STEEL), rubs=Rubs(),
    )  # fmt: skip
    found = one.at(X)
    pulled = found.N < 0
    r, pitch = one.cam.roller, one.cam.contact(one.phi(X)).radius
    curved = 1 / r - 1 / (pitch + r)
    expected = np.sqrt(np.abs(found.N) * curved / (pi * 0.01 * 2 * 0.91 / 2.1e11))
    assert one.pressure(X, found.N)[pulled] == pytest.approx(expected[pulled], rel=1e-9)


# ---------------------------------------------------------------- a published task


def test_a_published_cam_with_a_spring_that_is_too_weak():
    """adapala-academy.com, forum 1522: rise 10 mm in 120° by a cycloid, 1000 rpm, 1.8 kg, 15 N/mm drawn by 2.5 mm."""
    phases = (
        Phase("rise", 2 * pi / 3, named("sine")), Phase("dwell", pi / 3),
        Phase("return", 2 * pi / 3, named("sine")), Phase("dwell", pi / 3),
    )  # fmt: skip
    law, omega = Phases(phases, 0.010), 1000 * pi / 30
    cam = Cam("k", "1", "2", "B", "K", 0j, Sliding(1j, 0j, 1.0), ByLaw(law, 0.04, 1, 0.0, 1), 0.0, 0.6, 0.04)
    one = Loaded(cam, 1, omega, inertia=1.8, spring=Spring(37.5, 15000.0))
    at = np.array([np.radians(100)])
    found = one.at(at)
    assert one.parts(at).whole[0] == pytest.approx(-61.6880805933, rel=1e-10) and found.left[0]
    assert found.torque[0] == pytest.approx(-0.147269444344, rel=1e-10)
    assert one.parts(at).inertia[0] == pytest.approx(-244.862914172, rel=1e-10)
    over = one.panels
    parts = one.parts(over.x)
    (least, low), (most, high) = over.extremes(parts.whole)
    assert (least, most) == pytest.approx((-109.971685807, 334.971685807), rel=1e-9)
    assert (np.degrees(low), np.degrees(high)) == pytest.approx((88.23620378, 31.76379622), abs=1e-5)
    leaves = one.lifts_off()
    assert leaves.value == pytest.approx(81.6632385084, rel=1e-10)
    assert np.degrees(leaves.at) == pytest.approx(86.907272453, abs=1e-5)
    S = one.lifted(over.x)[0]
    assert spring.preload(over, -parts.inertia, S, 15000.0).value == pytest.approx(147.471685807, rel=1e-10)
    most, at = over.extremes(one.at(over.x).torque)[1]
    assert most == pytest.approx(2.27493979438, rel=1e-9)
    assert np.degrees(at) == pytest.approx(43.01893069, abs=1e-5)
