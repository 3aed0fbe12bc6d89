"""Cam pairs against second ways: the envelope, the linkage that a circular cam is, the replacing mechanism, power."""

import numpy as np
import pytest
from exhaustive import many

from tmm_report import loading
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.cams.cam import Sliding
from tmm_report.mechanics.cams.stated_profile import ByProfile, Circle
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cams.replacing_dyad import in_position
from tmm_report.mechanics.lever.dyads import State, close
from tmm_report.mechanics.lever.forces import reactions as statics

PHI = np.linspace(0.03, 2 * np.pi + 0.03, 97)
LAW = "phases: [{rise: 100 deg, law: sine}, {dwell: 30 deg}, {return: 120 deg, law: polynomial}, {dwell: 110 deg}]"
SLIDING = "{points: {B: 0, C: [60 mm, -10 mm]}, slides: {guide: y, at: C}}"
SWINGING = "{points: {C: 0, B: 90 mm, D: [20 mm, 40 mm]}}"
CIRCLE = "{circle: {radius: 40 mm, at: [12 mm, 5 mm]}}"
LEVER = "follower: 2, roller: {at: B, radius: 8 mm}, base: 40 mm, swing: 14 deg, side: left"
FLAT_LEVER = "follower: 2, flat: {at: B, angle: 5 deg}, base: 50 mm, swing: 9 deg, side: right"
PAIRS = {
    "roller": (SLIDING, f"{{follower: 2, roller: {{at: B, radius: 8 mm}}, base: 40 mm, lift: 20 mm, {LAW}}}"),
    "edge": (SLIDING, f"{{follower: 2, roller: {{at: B}}, base: 40 mm, lift: 20 mm, {LAW}}}"),
    "flat": (SLIDING, f"{{follower: 2, flat: {{at: B, angle: 102 deg}}, base: 60 mm, lift: 20 mm, {LAW}}}"),
    "lever": (SWINGING, f"{{{LEVER}, {LAW}}}"),
    "lever, right": (SWINGING, f"{{follower: 2, roller: {{at: B}}, base: 40 mm, swing: 14 deg, side: right, {LAW}}}"),
    "flat lever": (SWINGING, f"{{{FLAT_LEVER}, {LAW}}}"),
    "circle": (SLIDING, f"{{follower: 2, roller: {{at: B, radius: 8 mm}}, profile: {CIRCLE}}}"),
    "flat on a circle": (SLIDING, f"{{follower: 2, flat: {{at: B}}, profile: {CIRCLE}}}"),
}  # fmt: skip


def text(follower: str, cam: str, sense: str = "counter-clockwise") -> str:
    return f"""
mechanism:
  frame: {{O: [0, 0], C: [100 mm, 20 mm], G: [15 mm, 0]}}
  guides: {{y: {{through: G, angle: 90 deg}}}}
  links: {{1: {{points: {{O: 0}}}}, 2: {follower}}}
  driver: {{link: 1, speed: 10 rad/s, rotation: {sense}}}
  cams: {{k: {cam}}}
""".replace("C: [100 mm, 20 mm], ", "" if "slides" in follower else "C: [100 mm, 20 mm], ")


def linkage_of(name: str, sense: str = "counter-clockwise"):
    return assemble(loading.loads(text(*PAIRS[name], sense)).lever.mechanism)


@pytest.fixture(
    params=[(name, sense) for name in PAIRS for sense in ("counter-clockwise", "clockwise")], ids=str
)
def linkage(request):
    return linkage_of(*request.param)


def test_velocities_and_accelerations_are_derivatives_of_places(linkage):
    step, omega = 1e-5, linkage.mechanism.driver.omega
    inside = np.array([x for x in PHI if abs(np.sin(9 * x)) > 0.2])  # away from the ends of phases
    here, ahead, behind = (motion.solve(linkage, inside + d) for d in (0.0, step, -step))
    for point in ("B", "C"):
        if point in linkage.mechanism.links["2"].points and point not in linkage.mechanism.links["0"].points:
            v = (ahead.place(point) - behind.place(point)) / (2 * step) * omega
            a = (ahead.velocity(point) - behind.velocity(point)) / (2 * step) * omega
            assert np.allclose(here.velocity(point), v, atol=1e-8)
            assert np.allclose(here.acceleration(point), a, atol=1e-4 * np.max(np.abs(a)) + 1e-6)


def test_the_replacing_dyad_moves_the_follower_as_the_law_does(linkage):
    """Ordinary dyads with K at rest on the cam and the link of constant length, position by position."""
    found = motion.solve(linkage, PHI)
    for k, phi in enumerate(PHI[::7]):
        k *= 7
        one = in_position(motion.solve(linkage, np.array([phi])))
        still, s = one.linkage.groups[0], State(**vars(one.state))
        still.move(s)
        for name, x in (("w", found.angular_velocity("2")), ("e", found.angular_acceleration("2"))):
            assert np.ravel(getattr(s, name)["2"])[0] == pytest.approx(x[k], rel=1e-9, abs=1e-8)
        arm = found.place("B")[k] - np.ravel(s.r["2"])[0]
        assert np.ravel(s.velocity("2", arm))[0] == pytest.approx(found.velocity("B")[k], rel=1e-9, abs=1e-10)
        assert np.ravel(s.acceleration("2", arm))[0] == pytest.approx(
            found.acceleration("B")[k], rel=1e-8, abs=1e-8
        )


def test_the_vector_equation_of_the_dyad_closes(linkage):
    found = motion.solve(linkage, PHI)
    c = close(found.state, linkage.groups[0])
    left, right = (
        side + rate * e for side, rate, e in ((c.v_left, c.x, c.left.e), (c.v_right, c.y, c.right.e))
    )
    assert np.allclose(left, right, atol=1e-10)
    assert np.allclose(
        found.state.w["2"],
        c.x if linkage.groups[0].a == "2" and linkage.groups[0].kind in (1, 3) else found.state.w["2"],
        atol=1e-8,
    )


@pytest.mark.parametrize("name", many([name for name in PAIRS if "flat" not in name], 2))
def test_a_roller_touches_the_profile_and_nowhere_goes_into_it(name):
    """The motion turned back: the profile is the envelope of the roller, and its least distance from B is r."""
    cam = linkage_of(name).mechanism.cams[0]
    profile = cam.profile(np.linspace(0, 2 * np.pi, 20001))
    for b, at in zip(cam.pitch(PHI), cam.profile(PHI), strict=True):
        assert abs(b - at) == pytest.approx(cam.roller, abs=1e-12)
        assert np.min(np.abs(profile - b)) == pytest.approx(cam.roller, abs=1e-6 if cam.roller else 2e-5)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [name for name in PAIRS if "flat" in name])
def test_a_flat_face_is_tangent_and_the_cam_lies_on_one_side(name):
    cam = linkage_of(name).mechanism.cams[0]
    profile = cam.profile(np.linspace(0, 2 * np.pi, 20001))
    touch, (q, b) = cam.contact(PHI), cam.moved(PHI)
    turn = cam.turn(q.z) * cam.face
    assert np.allclose(dot(touch.normal, turn), 0, atol=1e-12)
    assert np.allclose(cross(turn, touch.at - b.z), 0, atol=1e-12)  # the contact is on the face
    for n, h, phi in zip(touch.normal, dot(touch.normal, b.z), PHI, strict=True):
        assert np.max(dot(n * np.exp(-1j * phi), profile)) == pytest.approx(h, abs=1e-8)


@pytest.mark.parametrize("name", PAIRS)
def test_the_centre_of_curvature_is_that_of_the_profile(name):
    """By differences along the profile: curvature (x'y'' − y'x'')/s'³."""
    cam, step = linkage_of(name).mechanism.cams[0], 1e-4
    phi = np.array([0.4, 0.9, 1.3, 2.9, 3.3, 3.9])
    behind, at, ahead = (
        cam.pitch(phi + d) if cam.roller is not None else cam.profile(phi + d) for d in (-step, 0, step)
    )
    rate, bend = (ahead - behind) / (2 * step), (ahead - 2 * at + behind) / step**2
    radius = -(np.abs(rate) ** 3) / cross(rate, bend)
    good = np.abs(rate) > 1e-3
    assert np.allclose((1 / cam.contact(phi).radius)[good], (1 / radius)[good], rtol=1e-4, atol=1e-4)


def test_a_circular_cam_under_a_roller_is_a_slider_crank():
    e, rod, offset = abs(12e-3 + 5e-3j), 48e-3, 5e-3  # B goes 5 mm right of O: 15 − 10 mm
    found = motion.solve(linkage_of("circle"), PHI)
    beta = PHI + np.angle(12 + 5j)
    across = e * np.cos(beta) - offset
    y = e * np.sin(beta) + np.sqrt(rod**2 - across**2)
    assert np.allclose(found.place("B"), offset + 1j * y, atol=1e-12)
    rate = e * np.cos(beta) + across * e * np.sin(beta) / np.sqrt(rod**2 - across**2)
    assert np.allclose(found.velocity("B"), 10j * rate, rtol=1e-9)


def test_a_circular_cam_under_a_flat_face_is_a_scotch_yoke():
    e, found = 12e-3 + 5e-3j, motion.solve(linkage_of("flat on a circle"), PHI)
    eccentric = e * np.exp(1j * PHI)
    assert np.allclose(found.place("B").imag, eccentric.imag + 40e-3, atol=1e-12)
    assert np.allclose(found.velocity("B").imag, 10 * eccentric.real, atol=1e-11)
    assert np.allclose(found.acceleration("B").imag, -100 * eccentric.imag, atol=1e-9)


@pytest.mark.exhaustive
def test_a_circular_cam_under_a_lever_is_a_four_bar_linkage():
    cam = "{follower: 2, roller: {at: B, radius: 8 mm}, side: left, profile: {circle: {radius: 40 mm, at: [12 mm, 0]}}}"
    found = motion.solve(assemble(loading.loads(text(SWINGING, cam)).lever.mechanism), PHI)
    bars = """
mechanism:
  frame: {O: [0, 0], C: [100 mm, 20 mm]}
  links: {1: {points: {O: 0, A: 12 mm}}, 2: {points: {C: 0, B: 90 mm}}, 3: {points: {A: 0, B: 48 mm}}}
  driver: {link: 1, speed: 10 rad/s}
  assembly: {B: right of A-C}
"""
    same = motion.solve(assemble(loading.loads(bars).lever.mechanism), PHI)
    for kind in ("place", "velocity", "acceleration"):
        assert np.allclose(getattr(found, kind)("B"), getattr(same, kind)("B"), rtol=1e-9, atol=1e-11)
    assert np.allclose(found.angular_acceleration("2"), same.angular_acceleration("2"), rtol=1e-9, atol=1e-9)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["roller", "edge"])
def test_a_profile_by_points_gives_back_the_law_that_it_was_made_by(name):
    made = linkage_of(name).mechanism.cams[0]
    errors = []
    for count in (180, 360):
        at = made.profile(np.arange(count) * 2 * np.pi / count)
        points = ", ".join(f"[{z.real!r} , {z.imag!r}]" for z in map(complex, at))
        end = PAIRS[name][1].split("base:")[0]
        cam = f"{end} profile: {{points: [{points}]}}}}"
        found = assemble(loading.loads(text(SLIDING, cam)).lever.mechanism).mechanism.cams[0]
        errors.append(np.max(np.abs(found.moved(PHI)[0].z - made.moved(PHI)[0].z)))
    assert errors[0] < 2e-6 and errors[1] < 2e-7


def test_the_reaction_lies_along_the_normal_and_balances_power(linkage):
    """A force on the massless follower: R along n–n, and the balancing moment takes its power."""
    found = motion.solve(linkage, PHI)
    loads = {link: statics.Load(0j, 0.0) for link in linkage.mechanism.moving}
    force, moment = 30.0 - 70.0j, 4.0
    loads["2"] = statics.Load(force, moment)
    solved = statics.solve(found, loads)
    cam = linkage.mechanism.cams[0]
    pressing = solved.force("k", "1")
    assert np.allclose(cross(pressing, cam.contact(PHI).normal), 0, atol=1e-7)
    reference = found.state.v["2"]
    power = dot(force, reference) + moment * found.angular_velocity("2")
    assert np.allclose(solved.balancing * found.omega, -power, atol=1e-8 * np.max(np.abs(power)) + 1e-9)


def test_two_ways_to_the_pressure_angle_of_a_roller():
    """tan α = (S' − e)/(S0 + S), by the law alone; by the contact's normal."""
    cam = linkage_of("roller").mechanism.cams[0]
    q = cam.given.of(PHI)
    assert np.allclose(np.tan(cam.pressure(PHI)), (q.d - cam.motion.offset) / q.z, atol=1e-12)
    assert cam.motion.offset == pytest.approx(5e-3)  # its line passes right of the axis


def test_a_flat_face_across_the_motion_has_no_pressure_angle():
    assert np.allclose(linkage_of("flat on a circle").mechanism.cams[0].pressure(PHI), 0, atol=1e-12)


@pytest.mark.parametrize("turned", range(0, 360, 15))
def test_a_contact_at_a_point_laid_on_the_cam_is_found_on_both_sides_of_it(turned):
    """Seen at 90° of a circle: the parameter there is a whole turn, worked out at both ends with unlike roundings; what
    was taken then was the contact on the other side of the cam."""
    a, whole, side = 0.012274, 0.059999, 0.49 * np.pi / 180
    cam = ByProfile(Circle(complex(a), whole - 0.01), Sliding(1j, 0j, 1.0), 0.01)
    phi = np.radians(turned) + np.arange(-40, 41) * np.spacing(np.radians(turned))
    phi = np.concatenate((phi, [np.radians(turned) - side, np.radians(turned) + side]))
    assert cam.of(phi).z == pytest.approx(
        a * np.sin(phi) + np.sqrt(whole**2 - (a * np.cos(phi)) ** 2), rel=1e-12
    )
