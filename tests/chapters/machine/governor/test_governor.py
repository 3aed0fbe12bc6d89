"""Centrifugal governors by themselves: geometry against differences, equilibrium against closed answers, choice."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report import course, loading
from tmm_report.chapters.machine.governor import given as block
from tmm_report.chapters.machine.governor.given import Choose, Given
from tmm_report.chapters.machine.governor.solve import by_itself as direct
from tmm_report.mechanics.machine.governor import equilibrium as g
from tmm_report.problems import ProblemError

PORTER = g.Arms(0.30, 0.28, 0.02, 0.04)
WEIGHTS = g.Weights(6.0, 40.0)
KINDS = {
    "Porter": (PORTER, 0.15),
    "Watt": (replace(PORTER, distance=0.36), 0.15),
    "Proell": (replace(PORTER, extension=0.1, upright_at=0.15), 0.15),
    "crossed": (replace(PORTER, upper_offset=-0.03), 0.12),
    "Hartnell": (g.BellCrank(0.12, 0.08, 0.14), 0.11),
}


def stated(
    geometry: g.Geometry, weights: g.Weights, lowest: float, highest: float | None = None, **more
) -> Given:
    """A governor with this mechanism and these weights, as a variant states it."""
    more |= {"radius": block.Radius(lowest, highest), "sleeve": block.Sleeve(mass=weights.sleeve or None)}
    more["balls"] = block.Balls(weights.count, weights.ball or None)
    if weights.stiffness:
        more["spring"] = block.Spring(weights.stiffness, weights.preload)
    if isinstance(geometry, g.BellCrank):
        crank = block.BellCrank(geometry.ball_arm, geometry.sleeve_arm, geometry.fulcrum, geometry.level)
        return Given(bell_crank=crank, **more)
    ends = geometry.distance, geometry.extension
    more["balls"] = block.Balls(weights.count, weights.ball or None, *ends)
    arms = block.Arms(geometry.upper, geometry.lower, geometry.upper_offset, geometry.lower_offset)
    return Given(arms=arms, **more)


def balls_at(name: str, z):
    geometry, lowest = KINDS[name]
    return geometry.moves(np.asarray(z, dtype=float), lowest)


# --- the mechanism


def height(name: str, z: float) -> float:
    """Of the ball, from the drawing of the mechanism: a second way, without the derivatives."""
    geometry, lowest = KINDS[name]
    at = geometry.moves(np.array([z]), lowest)
    if isinstance(geometry, g.BellCrank):
        return geometry.ball_arm * math.cos(math.asin((at.r[0] - geometry.fulcrum) / geometry.ball_arm))
    alpha = at.tilt["alpha"][0]
    if geometry.distance is not None:
        return -geometry.distance * math.cos(alpha)
    beyond = geometry.extension * math.cos(at.tilt["gamma"][0]) if geometry.extension else 0.0
    return -geometry.upper * math.cos(alpha) + beyond


@pytest.mark.parametrize("name", KINDS)
def test_derivatives_are_those_of_the_radius_and_the_height(name):
    z, e = np.linspace(0.002, 0.03, 5), 1e-5
    at, ahead, behind = balls_at(name, z), balls_at(name, z + e), balls_at(name, z - e)
    assert (ahead.r - behind.r) / (2 * e) == pytest.approx(at.dr, rel=1e-7)
    assert (ahead.dr - behind.dr) / (2 * e) == pytest.approx(at.ddr, rel=1e-6, abs=1e-9)
    assert (ahead.dh - behind.dh) / (2 * e) == pytest.approx(at.ddh, rel=1e-6)
    rise = [(height(name, one + e) - height(name, one - e)) / (2 * e) for one in z]
    assert rise == pytest.approx(at.dh, rel=1e-6)


@pytest.mark.parametrize("name", KINDS)
def test_equilibrium_is_least_work(name):
    """dE and dA by differences; in the turning frame the potential energy less the centrifugal work is flat there."""
    z, e = np.linspace(0.002, 0.03, 5), 1e-5
    weights = g.Weights(3.0, 10.0, 4000.0, 150.0)
    at = g.equilibrium(balls_at(name, z), weights)
    ahead, behind = (g.equilibrium(balls_at(name, z + step), weights) for step in (e, -e))
    assert (ahead.E - behind.E) / (2 * e) == pytest.approx(at.dE, rel=1e-6)
    assert (ahead.A - behind.A) / (2 * e) == pytest.approx(at.dA, rel=1e-6, abs=1e-9)
    # A is half the derivative of the moment of inertia of the balls about the axis
    inertia = weights.count * weights.ball * (ahead.balls.r**2 - behind.balls.r**2) / (2 * e)
    assert inertia / 2 == pytest.approx(at.A, rel=1e-7)
    assert (ahead.omega - behind.omega) / (2 * e) == pytest.approx(at.slope, rel=1e-5)


@given(
    st.floats(0.15, 0.5),
    st.floats(0.15, 0.5),
    st.floats(-0.05, 0.05),
    st.floats(0.0, 0.05),
    st.floats(0.1, 0.9),
)
def test_arms_keep_their_length(upper, lower, one, other, part):
    arms = g.Arms(upper, lower, one, other)
    least, most = direct._radii(arms)
    x = least + (0.02 + 0.96 * part) * (most - least)
    H = arms.height(x)
    found = arms.pin(np.array([H]))[0]
    assert found == pytest.approx(x, abs=1e-9)
    pin = complex(x, -math.sqrt(upper**2 - (x - one) ** 2))
    assert abs(pin - one) == pytest.approx(upper) and abs(pin - complex(other, -H)) == pytest.approx(lower)


# --- closed answers


def test_a_watt_governor_is_a_conical_pendulum():
    """ω² = g/h with the height of the cone, whatever the mass of the balls."""
    arms = g.Arms(0.4, 0.4)
    at = g.equilibrium(arms.moves(np.linspace(0, 0.1, 5), 0.2), g.Weights(3.7))
    cone = 0.4 * np.cos(at.balls.tilt["alpha"])
    assert at.omega == pytest.approx(np.sqrt(9.81 / cone), rel=1e-13)


def test_a_porter_governor_with_equal_arms_multiplies_by_the_load():
    """ω² = (m + M)/m g/h where both arms are as long and both pivots on the axis."""
    arms = g.Arms(0.25, 0.25)
    at = g.equilibrium(arms.moves(np.linspace(0, 0.05, 5), 0.15), g.Weights(5.0, 30.0))
    cone = 0.25 * np.cos(at.balls.tilt["alpha"])
    assert at.omega**2 == pytest.approx((5 + 30) / 5 * 9.81 / cone, rel=1e-13)


def test_a_level_bell_crank_has_a_straight_controlling_force():
    crank = g.BellCrank(0.12, 0.08, 0.14, level=True)
    at = g.equilibrium(crank.moves(np.linspace(0, 0.02, 9), 0.12), g.Weights(2.0, 0.0, 20000.0, 900.0))
    a, b = g.line_through((at.balls.r[0], at.balls.r[-1]), (at.force[0], at.force[-1]))
    assert at.force == pytest.approx(a * at.balls.r + b, rel=1e-13)
    assert a == pytest.approx(20000 / 2 * (0.08 / 0.12) ** 2)
    # the ray test and the factor of stability say the same
    assert np.all((b < 0) == (at.S > 0))


def flat(factor: float = 1.0) -> Given:
    """A level bell crank whose line of controlling force goes through the origin: C = a r; with the stiffness of the
    spring times the factor."""
    crank = g.BellCrank(0.12, 0.08, 0.14, level=True)
    stiffness = 20000.0
    preload = stiffness * 0.12 * 0.08 / 0.12
    return stated(crank, g.Weights(2.0, 0.0, stiffness * factor, preload), 0.12, lift=0.02)


def test_a_flat_governor_is_recognised():
    found = direct.solve(flat())
    assert found.word == "flat" and found.s.number("delta") == pytest.approx(0, abs=1e-12)
    assert np.ptp(found.curve.omega) < 1e-9


def test_stiffness_and_preload_beside_the_flat_ones_are_told_apart():
    given, stiffer, softer = flat(), flat(1.001), flat(0.999)
    assert direct.solve(stiffer).word == "stable" and direct.solve(softer).word == "unstable"
    assert direct.solve(softer).stiffness_needed == pytest.approx(given.weights.stiffness)
    assert direct.solve(softer).preload_allowed == pytest.approx(
        given.weights.preload * softer.weights.stiffness / given.weights.stiffness
    )


@pytest.mark.parametrize("name", KINDS)
def test_the_stiffness_needed_is_on_the_edge_of_stability(name):
    geometry, lowest = KINDS[name]
    found = direct.solve(stated(geometry, g.Weights(2.0, 0.0, 100.0, 900.0), lowest, lift=0.02))
    weights = replace(found.weights, stiffness=found.stiffness_needed)
    least = g.equilibrium(found.curve.balls, weights).S.min()
    assert abs(least) < 1e-9 * np.abs(found.curve.dE).max() + 1e-6


def test_what_would_make_it_stable_does():
    geometry, lowest = KINDS["Hartnell"]
    found = direct.solve(stated(geometry, g.Weights(2.0, 0.0, 100.0, 900.0), lowest, lift=0.02))
    assert found.word == "unstable"
    for factor, stable in ((1.001, True), (0.999, False)):
        weights = replace(found.weights, stiffness=found.stiffness_needed * factor)
        assert (direct.solve(stated(geometry, weights, lowest, lift=0.02)).word == "stable") is stable


# --- choice


@pytest.mark.parametrize("name", KINDS)
@given(st.floats(1.01, 1.2))
@settings(max_examples=5)
def test_the_chosen_spring_gives_the_speeds(name, spread):
    geometry, lowest = KINDS[name]
    speeds = (40.0, 40.0 * spread)
    given = stated(geometry, g.Weights(4.0, 2.0), lowest, lift=0.02, choose=Choose(spring=speeds))
    try:
        found = direct.solve(given)
    except ProblemError as error:  # the weights alone spread them further
        assert "no spring" in str(error) or "presses" in str(error) or "spread" in str(error)
        return
    assert found.ends == pytest.approx(speeds, rel=1e-12)
    assert found.s.number("delta") == pytest.approx(2 * (spread - 1) / (spread + 1))


@pytest.mark.parametrize("what", ["balls", "sleeve"])
def test_chosen_weights_give_the_speed_at_the_middle(what):
    weights = g.Weights(0.0 if what == "balls" else 6.0, 0.0 if what == "sleeve" else 40.0)
    found = direct.solve(stated(PORTER, weights, 0.15, 0.2, choose=Choose(**{what: 17.0})))
    assert found.table.omega[found.middle] == pytest.approx(17.0, rel=1e-12)
    assert getattr(found.weights, {"balls": "ball", "sleeve": "sleeve"}[what]) > 0


# --- insensitivity and effort


@given(st.floats(0.001, 0.5))
def test_the_friction_allowed_costs_the_insensitivity(epsilon):
    at = g.equilibrium(PORTER.moves(np.linspace(0, 0.05, 3), 0.15), WEIGHTS)
    friction = g.friction_for(at.E, epsilon)
    down, up = np.sqrt((at.E - friction) / at.A), np.sqrt((at.E + friction) / at.A)
    assert (up - down) / at.omega == pytest.approx(epsilon, rel=1e-9)


def test_small_insensitivity_is_the_friction_by_the_supporting_force():
    at = g.equilibrium(PORTER.moves(np.array([0.02]), 0.15), WEIGHTS)
    assert at.insensitivity(1.0)[0] == pytest.approx(1 / at.E[0], rel=1e-5)


def test_the_effort_is_half_of_what_holds_the_sleeve():
    """At ω (1 + q) the centrifugal forces lift it with A ω² (1 + q)² against E."""
    at = g.equilibrium(PORTER.moves(np.array([0.02]), 0.15), WEIGHTS)
    held = at.A * (at.omega * 1.01) ** 2 - at.E
    assert g.effort(at.E, 0.01) == pytest.approx(held / 2, rel=1e-9)


# --- what is wrong


def text(**changes: str) -> str:
    lines = {
        "arms": "{upper: 300 mm, lower: 300 mm, lower_offset: 40 mm}",
        "balls": "{mass: 6 kg}",
        "radius": "{lowest: 150 mm, highest: 200 mm}",
        "sleeve": "{mass: 40 kg}",
        **changes,
    }
    return "governor:\n" + "".join(f"  {key}: {value}\n" for key, value in lines.items() if value)


CRANK = {
    "arms": "",
    "bell_crank": "{ball_arm: 80 mm, sleeve_arm: 60 mm, fulcrum: 90 mm}",
    "radius": "{lowest: 75 mm}",
    "lift": "20 mm",
}
WRONG = {
    "radii swapped": (
        {"radius": "{lowest: 200 mm, highest: 150 mm}"},
        "radius.highest",
        "not greater than the lowest",
    ),
    "both ends": ({"lift": "10 mm"}, "radius.highest", "one of the two"),
    "no range": ({"radius": ""}, "radius", "working range"),
    "no mass": ({"balls": ""}, "balls.mass", "no mass"),
    "two kinds": ({"bell_crank": CRANK["bell_crank"]}, "bell_crank", "not on both"),
    "nothing": ({"arms": ""}, "governor", "what kind"),
    "out of reach": ({"radius": "{lowest: 150 mm, highest: 320 mm}"}, "radius.highest", "320"),
    "straight arms": ({"radius": "{lowest: 15 mm, highest: 200 mm}"}, "radius.lowest", "15"),
    "lift too long": ({"radius": "{lowest: 150 mm}", "lift": "400 mm"}, "lift", "400"),
    "on both arms": (
        {"balls": "{mass: 1 kg, distance: 350 mm, extension: 9 mm}"},
        "balls.extension",
        "both arms",
    ),
    "level crank": ({**CRANK, "lift": "80 mm"}, "radius", "lie level"),
    "arms of a crank": ({**CRANK, "balls": "{mass: 1 kg, distance: 9 mm}"}, "balls.distance", "no arms"),
    "nothing holds": ({**CRANK, "sleeve": ""}, "sleeve", "holds the sleeve down"),
    "spring too weak": (
        {**CRANK, "sleeve": "", "spring": "{stiffness: 1 kN/m}"},
        "spring",
        "holds the sleeve down",
    ),
    "speeds fall too far": (
        {"choose": "{spring: [200 rpm, 190 rpm]}"},
        "choose.spring",
        "cannot fall so far",
    ),
    "no fulcrum": ({**CRANK, "bell_crank": "{ball_arm: 80 mm, sleeve_arm: 60 mm}"}, "bell_crank", "fulcrum"),
    "speeds too near": ({"choose": "{spring: [200 rpm, 201 rpm]}"}, "choose.spring", "weights alone"),
    "too slow": ({"choose": "{spring: [100 rpm, 120 rpm]}"}, "choose.spring", "do not even carry"),
    "chosen and stated": ({"choose": "{balls: 150 rpm}"}, "choose.balls", "stated"),
    "no balls do": ({"balls": "", "choose": "{balls: 50 rpm}"}, "choose.balls", "no balls"),
    "nothing to hold": (
        {"balls": "", "sleeve": "", "choose": "{balls: 150 rpm}"},
        "choose.balls",
        "weighs nothing",
    ),
    "light sleeve": ({"sleeve": "", "choose": "{sleeve: 50 rpm}"}, "choose.sleeve", "without mass"),
    "chosen twice": ({"balls": "", "choose": "{balls: 150 rpm, sleeve: 150 rpm}"}, "choose", "one thing"),
    "friction beyond all": (
        {"sleeve": "{mass: 40 kg, friction: 5 kN}"},
        "sleeve.friction",
        "holds the sleeve",
    ),
    "no step": (
        {"machine": "{inertia: 9 kg*m^2, torque: {full: 9 N*m}, load: {before: 2 N*m, after: 2 N*m}}"},
        "machine.load.after",
        "does not step",
    ),
    "nearly straight": (
        {
            "arms": "{upper: 300 mm, lower: 300 mm}",
            "radius": "{lowest: 2 mm, highest: 200 mm}",
            "machine": "{inertia: 9 kg*m^2, torque: {full: 9 N*m}, load: {before: 2 N*m, after: 3 N*m}}",
        },
        "radius.lowest",
        "one straight line",
    ),
    "servo alone": ({"servo": "{time: 1 s}"}, "servo", "without a machine"),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_is_wrong_is_said_in_a_sentence(name):
    changes, key, words = WRONG[name]
    with pytest.raises(ProblemError) as caught:
        course.solve(loading.loads(text(**changes)))
    found = [problem for problem in caught.value.problems if problem.key.endswith(key)]
    assert found and words in found[0].text() and found[0].right is not None, str(caught.value)


def test_of_what_is_mistyped_nothing_else_is_said():
    """A crank that is wrong in itself is a crank; balls whose mass is mistyped are not said to have none."""
    wrong = {
        **CRANK,
        "bell_crank": "{ball_arm: -80 mm, sleeve_arm: 60 mm, fulcrum: 90 mm}",
        "balls": "{mas: 6 kg}",
    }
    machine = "{inertia: 9 kg, torque: {full: 9 N*m}, load: {before: 2 N*m, after: 3 N*m}}"
    with pytest.raises(ProblemError) as caught:
        loading.loads(text(**wrong, machine=machine, servo="{time: 1 s}"))
    keys = sorted(problem.key for problem in caught.value.problems)
    assert keys == ["governor.balls.mas", "governor.bell_crank.ball_arm", "governor.machine.inertia"]


def test_what_is_right_is_solved():
    found = course.solve(loading.loads(text())).governor
    assert found.direct.word == "stable" and [str(line) for line in found.summary()]


# --- a falling characteristic; an angle lever whose obliquity is neglected

HARTNELL = """governor:
  bell_crank: {ball_arm: 120 mm, sleeve_arm: 80 mm, %slevel: true}
  balls: {mass: 2 kg}
  radius: {lowest: 100 mm, highest: 160 mm}
  sleeve: {mass: 3 kg}
  choose: {spring: [%s rpm, %s rpm]}
"""


@pytest.mark.parametrize("speeds", [(430, 415), (300, 290), (415, 430)])
def test_a_spring_for_speeds_that_fall_is_found_and_called_unstable(speeds):
    found = course.solve(loading.loads(HARTNELL % ("fulcrum: 150 mm, ", *speeds))).governor
    own = found.direct
    forces = [  # moments about the fulcrum: two balls by the arm of 120 mm, sleeve and spring by that of 80 mm
        2 * 2.0 * (n * math.pi / 30) ** 2 * r * 120 / 80 - 3.0 * 9.81
        for n, r in zip(speeds, (0.1, 0.16), strict=True)
    ]
    assert [own.s.number(key) for key in ("F_0", "spring_top")] == pytest.approx(forces)
    falls = speeds[1] < speeds[0]
    assert (own.word == "unstable") == falls and (own.s.number("delta") < 0) == falls
    assert any("unstable" in line.text for line in found.summary()) == falls


def test_a_level_angle_lever_needs_no_fulcrum():
    without, stated = (
        course.solve(loading.loads(HARTNELL % (key, 400, 430))).governor.direct
        for key in ("", "fulcrum: 150 mm, ")
    )
    assert without.table.omega == pytest.approx(stated.table.omega) and without.weights == stated.weights
