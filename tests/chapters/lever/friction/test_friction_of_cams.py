"""Friction of cam pairs in a lever mechanism: against the follower in closed form (another module, by the ends of its
guide), the balance of power, the whole equilibrium of both links; what is told of jams and of slips."""

import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.chapters.lever.friction.solve import rate_of_contact
from tmm_report.mechanics.calculus.laws import Constant
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.cams.forces import Guide, Pin, Rubs
from tmm_report.mechanics.cams.turn import Loaded
from tmm_report.mechanics.lever.cams.rubbing import contacts, normal_force
from tmm_report.problems import ProblemError

LAW = "phases: [{rise: 100 deg, law: sine}, {dwell: 30 deg}, {return: 120 deg, law: polynomial}, {dwell: 110 deg}]"
SLIDING = "{points: {B: 0, C: [100 mm, 0], S2: [60 mm, 0]}, slides: {guide: y, at: C}, mass: 1.5 kg, mass_centre: S2}"
SWINGING = (
    "{points: {C: 0, B: 90 mm, S2: [40 mm, 10 mm]}, mass: 1.2 kg, mass_centre: S2, inertia: 0.004 kg*m^2}"
)
ROLLER = "roller: {at: B, radius: 8 mm}"
ENDS = {
    "roller": (SLIDING, f"follower: 2, {ROLLER}, base: 40 mm, lift: 20 mm"),
    "edge": (SLIDING, "follower: 2, roller: {at: B}, base: 40 mm, lift: 20 mm"),
    "flat": (SLIDING, "follower: 2, flat: {at: B, angle: 90 deg}, base: 60 mm, lift: 20 mm"),
    "lever": (SWINGING, f"follower: 2, {ROLLER}, base: 40 mm, swing: 14 deg, side: left"),
    "flat lever": (SWINGING, "follower: 2, flat: {at: B}, base: 50 mm, swing: 9 deg, side: right"),
}
SENSES = ("counter-clockwise", "clockwise")
GUIDE = "guides: {coefficient: 0.1, length: 60 mm}, cams: {coefficient: 0.1, diameter: 8 mm}"
PIVOT = "joints: {C: {coefficient: 0.1, diameter: 20 mm}, k: {coefficient: 0.1%s}}"


def text(kind: str, sense: str = SENSES[0], friction: str = "", load: str = "400 N") -> str:
    follower, pair = ENDS[kind]
    lever = follower == SWINGING
    guide = "" if lever else "guides: {y: {through: O, angle: 90 deg}}"
    own = PIVOT % (", diameter: 8 mm" if kind == "lever" else "") if lever else GUIDE
    acting = (
        f"moments: [{{on: 2, direction: {'clockwise' if kind == 'lever' else 'counter-clockwise'}, constant: 30 N*m}}]"
        if lever
        else f"forces: [{{at: B, on: 2, direction: down, constant: {load}}}]"
    )
    return f"""
mechanism:
  frame: {{O: [0, 0], {"C: [100 mm, 20 mm]" if lever else "Q: [0, 1 mm]"}}}
  {guide}
  links: {{1: {{points: {{O: 0}}}}, 2: {follower}}}
  driver: {{link: 1, speed: 10 rad/s, rotation: {sense}}}
  cams: {{k: {{{pair}, {LAW}}}}}
loads: {{{acting}}}
friction: {{{friction or own}, corrected: true}}
"""


def solved(kind: str, sense: str = SENSES[0], friction: str = "", load: str = "400 N"):
    return course.solve(loading.loads(text(kind, sense, friction, load))).lever


@pytest.fixture(params=[(kind, sense) for kind in ENDS for sense in SENSES], ids=str)
def case(request):
    return request.param, solved(*request.param)


def closed(kind: str, lever, sense: str) -> Loaded:
    """The same follower by the closed form of its equilibrium."""
    cam = lever.kinematics.linkage.mechanism.cams[0]
    slides = ENDS[kind][0] == SLIDING
    pin = Pin(0.004, 0.1) if cam.roller else None
    rubs = Rubs(
        guide=Guide(0.06, 0.07, 0.1) if slides else None,  # the point C, 100 mm from B, is the middle of the slider
        pin=pin, face=0.0 if pin else 0.1, pivot=None if slides else Pin(0.01, 0.1),
    )  # fmt: skip
    begin = float(np.ravel(lever.kinematics.cycle.phi(np.zeros(1)))[0])
    side = 0 if slides else cam.motion.side
    load = 400.0 if slides else 30.0 * (side if kind == "lever" else -side)
    return Loaded(
        cam, lever.kinematics.cycle.sense, 10.0, begin, 1.5 if slides else 0.004 + 1.2 * abs(0.04 + 0.01j) ** 2,
        1.5 if slides else 1.2, 0j if slides else 0.04 + 0.01j, -9.81j, Constant(load), rubs=rubs,
    )  # fmt: skip


def test_the_drive_and_every_loss_are_those_of_the_closed_form(case):
    (kind, sense), lever = case
    found, one = lever.friction.corrected.diagram, closed(kind, lever, sense)
    turned = lever.friction.diagram_turned
    expected = one.at(turned)
    assert not expected.left.any()
    scale = np.abs(expected.torque).max()
    inside = ~np.isclose(np.mod(turned[:, None] - one.breaks, 2 * np.pi), 0.0, atol=1e-6).any(axis=1)
    assert np.allclose(
        one.sense * found.moment[inside], expected.torque[inside], rtol=1e-9, atol=1e-9 * scale
    )
    own = next(loss for loss in found.pairs if loss.pair.key in ("2-k", "1-2"))
    lost = expected.lost["pin" if one.cam.roller else "face"] * 10.0
    assert np.allclose(own.power[inside], lost[inside], rtol=1e-9)
    pressing = np.abs(expected.R) if one.cam.roller else expected.N
    assert np.allclose(own.pressing[inside], pressing[inside], rtol=1e-9)
    assert np.allclose(np.abs(own.reaction)[inside], np.abs(expected.R)[inside], rtol=1e-9)


def test_the_moment_with_friction_is_that_of_the_balance_of_power(case):
    _, lever = case
    assert lever.friction.corrected.worst < 1e-12
    assert lever.friction.corrected.mean_power > 0


def test_the_first_approximation_takes_the_reactions_without_friction(case):
    _, lever = case
    losses = lever.friction.table
    own = next(loss for loss in losses.pairs if loss.pair.key in ("2-k", "1-2"))
    motion = lever.kinetostatics.table.motion
    contact = contacts(motion.linkage.structure)[0]
    normal = normal_force(contact, motion, lever.kinetostatics.table.statics)
    rate, arm = rate_of_contact(contact, motion), 0.004 if contact.rolls else 1.0
    assert own.power == pytest.approx(0.1 * np.abs(normal) * rate * arm, rel=1e-12)
    assert own.pair.kind == ("R" if contact.rolls else "H")


def test_a_roller_turns_as_fast_as_the_profile_rolls_under_it():
    """By the length of the profile that passes: ds/dt over the radius, less how the follower turns."""
    for kind in ("roller", "lever"):
        lever = solved(kind)
        motion = lever.kinetostatics.diagram.motion
        contact, step = contacts(motion.linkage.structure)[0], 1e-5
        cam, phi = contact.cam, np.broadcast_to(motion.phi, motion.shape)
        passed = np.abs(cam.profile(phi + step) - cam.profile(phi - step)) / (2 * step) * 10.0
        q = cam.moved(phi)[0]
        inside = np.abs(passed - np.median(passed)) < 1e9
        spin = passed / cam.roller
        own = rate_of_contact(contact, motion)
        # the roller rolls backwards on a convex cam: seen from the follower, faster by the turn of the normal
        turned = np.angle(cam.contact(phi + step).normal / cam.contact(phi - step).normal) / (2 * step) * 10.0
        side = 0.0 if kind == "roller" else 1.0
        expected = np.abs(-spin + turned - side * q.d * 10.0)
        assert np.allclose(own[inside], expected[inside], rtol=1e-3)


@pytest.mark.parametrize("kind", ["roller", "flat", "lever"])
def test_both_links_are_in_equilibrium_with_the_friction_of_their_contact(kind):
    """The cam: its drive against the whole force of the contact at its place, and the friction of its own shaft."""
    own = "coefficient: 0.1, diameter: 8 mm" if kind != "flat" else "coefficient: 0.1"
    lever = solved(kind, friction=f"joints: {{k: {{{own}}}}}")
    found, motion = lever.friction.corrected.table, lever.kinetostatics.table.motion
    loss = found.pairs[0]
    contact = contacts(motion.linkage.structure)[0]
    phi = np.broadcast_to(motion.phi, motion.shape)
    at = contact.cam.contact(phi).at
    on_follower = loss.reaction if loss.pair.links[1] == "2" else -loss.reaction
    assert found.moment == pytest.approx(cross(at, on_follower), rel=1e-9, abs=1e-9)


def test_a_guide_too_short_jams_and_it_is_said_where():
    with pytest.raises(ProblemError) as raised:
        solved("roller", friction="guides: {coefficient: 0.5, length: 8 mm}")
    assert "jams" in raised.value.problems[0].wrong.text


BAD = [
    ("roller", "cams: {coefficient: 0.1}", "friction.cams", "needs the diameter of its pin"),
    ("roller", "joints: {k: {coefficient: 0.1}}", "friction.joints.k", "needs the diameter of its pin"),
    ("roller", "joints: {k: {coefficient: 0.1, diameter: 16 mm}}", "friction.joints.k.diameter", "as thick"),
    ("roller", "joints: {k: {coefficient: 0.1, diameter: 6 mm, length: 9 mm}}", "friction.joints.k.length",
     "no length"),
    ("flat", "joints: {k: {coefficient: 0.1, diameter: 6 mm}}", "friction.joints.k.diameter", "has no pin"),
    ("flat", "joints: {kk: {coefficient: 0.1}}", "friction.joints.kk", "no joint"),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "friction", "path", "words"), BAD)
def test_a_slip_is_told_at_its_key(kind, friction, path, words):
    with pytest.raises(ProblemError) as raised:
        loading.loads(text(kind, friction=friction))
    told = [(".".join(map(str, one.path)), one.wrong.text) for one in raised.value.problems]
    assert any(where == path and words in what for where, what in told), told


def test_friction_of_cams_without_a_cam_has_no_effect_and_it_is_said():
    with open("variants/crank_rocker.yaml", encoding="utf-8") as file:
        stated = file.read()
    one = loading.loads(
        stated.split("\nfriction:")[0] + "\nfriction: {cams: {coefficient: 0.1, diameter: 5 mm}}\n"
    )
    assert any("no cam" in doubt.wrong.text for doubt in one.doubts)
