"""Coefficients of friction that depend on the velocity of sliding: powers, works, reactions, mistakes."""

import numpy as np
import pytest
from conftest import path_of

from tmm_report import course, loading
from tmm_report.chapters.lever.friction import solve as friction
from tmm_report.problems import ProblemError

R, L, FORCE = 0.05, 0.2, 1000.0
OMEGA, SHAFT, PIN = 3 * np.pi, 0.06, 0.04
SLIDER_CRANK = """
mechanism:
  frame: {O: [0, 0], Q: [0, 0]}
  guides: {x: {through: Q}}
  links:
    1: {points: {O: 0, A: 50 mm}}
    2: {points: {A: 0, B: 200 mm}}
    3: {points: {B: 0}, slides: {guide: x, at: B}}
  driver: {link: 1, speed: 90 rpm, rotation: counter-clockwise}
  assembly: {B: right}
loads:
  gravity: 0
  forces: [{at: B, direction: against motion, constant: 1 kN}]
positions: {table: 24, diagram: 72}
friction: """
SPEEDS, VALUES = (0.0, 0.1, 0.3), (0.15, 0.1, 0.08)
TABLE = "{by_speed: [[0, 0.15], [0.1 m/s, 0.1], [0.3 m/s, 0.08]]}"
STATED = "{stribeck: {static: 0.2, kinetic: 0.1, speed: 0.1 m/s, viscous: 0.02 s/m, exponent: %d}}"


def stribeck(v, n):
    return 0.1 + 0.1 * np.exp(-((v / 0.1) ** n)) + 0.02 * v


def slider_crank(stated):
    return course.solve(loading.loads(SLIDER_CRANK + stated)).lever


def powers(phi, n):
    """Of a slider-crank without masses in closed form, W: in the guide and in the pivots O, A, B."""
    beta = np.arcsin(R * np.sin(phi) / L)
    swing = OMEGA * R * np.cos(phi) / (L * np.cos(beta))  # of the rod, against the crank
    slide = np.abs(OMEGA * R * (np.sin(phi) + np.cos(phi) * np.tan(beta)))
    rod = FORCE / np.cos(beta)
    guide = stribeck(slide, n) * FORCE * np.abs(np.tan(beta)) * slide
    found = [guide, 0.1 * rod * SHAFT / 2 * OMEGA]
    for rate in (OMEGA + swing, swing):
        v = np.abs(rate) * PIN / 2
        found.append(np.interp(v, SPEEDS, VALUES) * rod * v)
    return found


def stated(guides, pivots=TABLE):
    joints = f"{{O: {{coefficient: 0.1, diameter: {SHAFT}}}}}"
    return (
        f"{{guides: {{coefficient: {guides}}}, pivots: {{coefficient: {pivots}, diameter: {PIN}}}, "
        f"joints: {joints}, corrected: true}}"
    )


@pytest.mark.parametrize("n", [1, 2])
def test_powers_and_work_are_those_of_an_own_integration(n):
    lever = slider_crank(stated(STATED % n))
    found, phi = lever.friction, lever.kinematics.turned
    moving = np.abs(np.sin(phi)) > 1e-9  # at its ends the force has no sense
    by_name = {loss.pair.name: loss.power for loss in found.table.pairs}
    for name, power in zip("xOAB", powers(phi, n), strict=True):
        np.testing.assert_allclose(by_name[name][moving], power[moving], rtol=1e-11, atol=1e-12)
    fine = (np.arange(400_000) + 0.5) * (2 * np.pi / 400_000)
    mean = float(np.mean(sum(powers(fine, n))))
    assert found.mean_power == pytest.approx(mean, rel=1e-9)
    assert found.work == pytest.approx(mean / 1.5, rel=1e-9)  # a turn takes 2/3 s


def test_the_integral_goes_from_corner_to_corner():
    """Somewhere between the positions the journal of A slides by 0.2 m/s, where its table has a corner."""
    lever = slider_crank(stated("0.1", "{by_speed: [[0, 0.15], [0.2 m/s, 0.1], [0.9 m/s, 0.09]]}"))
    beta = np.arcsin(R * np.sin(edges := lever.friction.whole[0].panels.edges) / L)
    swing = OMEGA * R * np.cos(edges) / (L * np.cos(beta))
    at_corner = np.abs(np.abs(OMEGA + swing) * PIN / 2 - 0.2) < 1e-9
    assert at_corner.sum() == 2  # once there, once back


@pytest.mark.parametrize("n", [1, 2])
def test_reactions_under_such_friction(n):
    """The rod's force is F/(cos β − f(v) |sin β|) where the guide alone rubs."""
    lever = slider_crank(f"{{guides: {{coefficient: {STATED % n}}}, corrected: true}}")
    phi = lever.kinematics.turned
    beta = np.arcsin(R * np.sin(phi) / L)
    f = stribeck(np.abs(OMEGA * R * (np.sin(phi) + np.cos(phi) * np.tan(beta))), n)
    moment = FORCE / (np.cos(beta) - f * np.abs(np.sin(beta))) * R * np.abs(np.sin(phi + beta))
    moving = np.abs(np.sin(phi)) > 1e-9
    found = lever.friction.corrected
    np.testing.assert_allclose(found.table.moment[moving], moment[moving], rtol=1e-11)
    assert found.worst < 1e-12


def test_the_power_balance_with_friction_in_every_pair():
    assert slider_crank(stated(STATED % 1)).friction.corrected.worst < 1e-9


@pytest.mark.parametrize(
    "law",
    [
        "{by_speed: [[0, 0.12], [0.3 m/s, 0.12]]}",
        "{by_speed: [[0.01, 0.12], [0.1, 0.12], [5, 0.12]]}",
        "{stribeck: {static: 0.12, kinetic: 0.12, speed: 1000 m/s}}",
    ],
)
def test_a_law_that_is_constant_is_the_constant_to_the_last_digit(law):
    one, other = (slider_crank(stated(of, of)).friction for of in (law, "0.12"))
    for mine, plain in ((one.table, other.table), (one.diagram, other.diagram)):
        np.testing.assert_array_equal(mine.total, plain.total)
    np.testing.assert_array_equal(one.corrected.table.moment, other.corrected.table.moment)
    if "by_speed" in law:  # its panels are the same
        assert one.mean_power == other.mean_power
    assert one.mean_power == pytest.approx(other.mean_power, rel=1e-13)


def test_beyond_its_points_a_table_keeps_its_ends():
    slow, fast = (
        slider_crank(f"{{guides: {{coefficient: {{by_speed: [[{a}, 0.1], [{b}, 0.2]]}}}}}}").friction.table
        for a, b in ((10, 20), (1e-9, 2e-9))
    )
    moving = slow.pairs[0].sliding > 1e-6
    assert (slow.pairs[0].coefficient == 0.1).all() and (fast.pairs[0].coefficient[moving] == 0.2).all()


def test_means_between_corners_agree_with_many_more_positions(compressor):
    """Of a mechanism with masses: the panels' integral and the mean of the diagram come together."""
    text = compressor_text()
    lever = course.solve(loading.loads(text)).lever
    total = lever.friction.diagram.total[:-1]
    assert lever.friction.mean_power == pytest.approx(float(total.mean()), rel=2e-4)


def compressor_text():
    text = path_of("compressor").read_text(encoding="utf-8")
    text = text.replace("guides: {coefficient: 0.1}", f"guides: {{coefficient: {STATED % 1}}}")
    text = text.replace("coefficient: 0.1, diameter: 50 mm", f"coefficient: {TABLE}, diameter: 50 mm")
    return text.replace("diagram: 36", "diagram: 720")


@pytest.mark.parametrize(
    ("law", "path", "words"),
    [
        ("{by_speed: [[0, 0.15], [0, 0.1]]}", "friction.guides.coefficient.by_speed", "must ascend"),
        ("{by_speed: [[0, 0.15]]}", "friction.guides.coefficient.by_speed", ""),
        ("{by_speed: [[0, 1.5], [1, 0.1]]}", "friction.guides.coefficient.by_speed.0.1", "0 … 1"),
        ("{by_speed: [[-1, 0.5], [1, 0.1]]}", "friction.guides.coefficient.by_speed.0.0", ""),
        ("{by_speed: [[0, 0.5], [3 rpm, 0.1]]}", "friction.guides.coefficient.by_speed.1.0", "a velocity"),
        ("{}", "friction.guides.coefficient", "exactly one of"),
        (
            "{by_speed: [[0, 0.15], [1, 0.1]], stribeck: {static: 0.2, kinetic: 0.1, speed: 1}}",
            "friction.guides.coefficient",
            "exactly one of",
        ),
        (
            "{stribeck: {static: 0.1, kinetic: 0.2, speed: 1}}",
            "friction.guides.coefficient.stribeck",
            "exchange static and kinetic",
        ),
        ("{stribeck: {static: 0.2, kinetic: 0.1}}", "friction.guides.coefficient.stribeck.speed", "missing"),
        (
            "{stribeck: {static: 0.2, kinetic: 0.1, speed: 1, exponent: 3}}",
            "friction.guides.coefficient.stribeck.exponent",
            "from 1 to 2",
        ),
        ("[0.1, 0.2]", "friction.guides.coefficient", "a number, {by_speed"),
    ],
)
def test_mistakes_are_told_at_their_places(law, path, words):
    with pytest.raises(ProblemError) as told:
        slider_crank(f"{{guides: {{coefficient: {law}}}}}")
    (problem,) = told.value.problems
    assert ".".join(map(str, problem.path)) == path
    assert words in str(told.value)


def test_losses_of_both_kinds_say_the_coefficient_that_they_take(compressor):
    lever = course.solve(loading.loads(compressor_text())).lever
    for loss in lever.friction.table.pairs:
        arm = 0.025 if loss.pair.kind == "R" else 1.0
        np.testing.assert_allclose(loss.sliding, loss.rate * arm, rtol=1e-14)
        np.testing.assert_allclose(
            loss.power, loss.coefficient * loss.pressing * loss.sliding, rtol=1e-13, atol=1e-12
        )
        assert friction.rubbing_of(lever.friction.given, loss.pair).law is not None
