"""Torsion springs between links: the slope of their potential, closed forms, the machine in motion, mistakes."""

import math

import numpy as np
import pytest
from conftest import path_of

from tmm_report import course, loading
from tmm_report.chapters.lever.kinetostatics.solve import lengths
from tmm_report.chapters.lever.kinetostatics.solve.acting_exact import acting
from tmm_report.mechanics.rivals.exact.moving import motion as exactly
from tmm_report.problems import ProblemError

ROCKER = """
language: en
mechanism:
  frame: {O: [0, 0], C: [320 mm, 60 mm]}
  links:
    1: {points: {O: 0, A: 60 mm}}
    2: {points: {A: 0, B: 300 mm}}
    3: {points: {C: 0, B: 180 mm}}
  driver: {link: 1, speed: 60 rpm, zero: {angle: 25 deg}}
  assembly: {B: left of A-C}
loads:
  gravity: 0
  %s: [%s]
positions: {table: 24, diagram: 36}
"""
OMEGA = 2 * np.pi


def rocker(*springs, key="torsion_springs", more=""):
    return course.solve(loading.loads(ROCKER % (key, ", ".join(springs)) + more)).lever


def angles(phi):
    """Of the rod and the rocker by the cosine law alone, B to the left of the way from A to C."""
    A, C = 0.06 * np.exp(1j * phi), 0.32 + 0.06j
    far = np.abs(C - A)
    at_a = np.arccos((0.3**2 + far**2 - 0.18**2) / (2 * 0.3 * far))
    B = A + 0.3 * (C - A) / far * np.exp(1j * at_a)
    return np.unwrap(np.angle(B - A)), np.unwrap(np.angle(B - C))


def phases(lever):
    return math.radians(25) + lever.kinematics.turned


@pytest.mark.parametrize(
    ("spring", "of"),
    [
        ("{links: [3, 0], stiffness: 50, preload: 7}", lambda rod, rocker: rocker),
        ("{links: [0, 3], stiffness: 50, preload: -7}", lambda rod, rocker: rocker),
        ("{links: [2, 3], stiffness: 50, preload: 7}", lambda rod, rocker: rod - rocker),
        ("{links: [2, 3], stiffness: 50, free_angle: 0.14 rad}", lambda rod, rocker: rod - rocker),
    ],
)
def test_the_balancing_moment_is_the_slope_of_the_potential(spring, of):
    """Without masses the driving link needs dU/dφ, U = c (φ − α₀)²/2, by differences of the cosine law."""
    lever, h = rocker(spring), 1e-5
    phi = phases(lever)
    fine = np.linspace(0, 2 * np.pi, 4001) + math.radians(25)

    def potential(at):
        """The angle goes on without jumps from position 0."""
        whole = of(*angles(fine))
        near = np.interp(np.mod(at - fine[0], 2 * np.pi) + fine[0], fine, whole)
        turn = of(*(x for x in angles(np.atleast_1d(at))))
        turn = turn + 2 * np.pi * np.round((near - turn) / (2 * np.pi))
        return 50 * (turn - whole[0] - 0.14) ** 2 / 2

    slope = np.array([(potential(x + h) - potential(x - h))[0] / (2 * h) for x in phi])
    np.testing.assert_allclose(lever.kinetostatics.table.balancing, slope, rtol=1e-6, atol=1e-6)


def test_both_links_take_opposite_moments_and_the_pivot_no_force_of_them():
    lever = rocker("{links: [2, 3], stiffness: 50, preload: 7}")
    one, other = lever.kinetostatics.table.loading.moments
    np.testing.assert_allclose(one, -other, rtol=1e-14)
    assert one[0] == pytest.approx(7.0)


def test_a_spring_so_soft_is_its_preload():
    soft = rocker("{links: [3, 0], stiffness: 1e-9, preload: 7}").kinetostatics.table
    moment = rocker("{on: 3, direction: counter-clockwise, constant: 7}", key="moments").kinetostatics.table
    np.testing.assert_allclose(soft.balancing, moment.balancing, rtol=1e-9)


def test_works_powers_and_lever_agree_over_the_cycle():
    lever = course.solve(loading.load(path_of("sprung_screen"))).lever.kinetostatics
    assert abs(lever.works.whole) < 1e-12 * lever.works.size
    for one in (lever.table, lever.diagram):
        assert np.nanmax(one.disagreement(one.lever)) < 1e-9
        assert np.nanmax(one.disagreement(one.power)) < 1e-9
    for k, spring in enumerate(lengths.torsions_of(lever.given)):
        energy = lengths.twist_energy(spring, lever.kinematics, lever.over.motion)
        # what the spring gives is what its potential loses: both ends together over the panels
        own = [i for i, moment in enumerate(lever.given.moments) if getattr(moment, "of", "") == f"k{k + 1}"]
        power = sum(
            lever.over.loading.moments[i] * lever.over.motion.angular_velocity(lever.given.moments[i].on)
            for i in own
        )
        panels = lever.over.panels
        given = panels.total(lever.over.on(np.broadcast_to(np.abs(power), lever.over.motion.shape)))
        assert given > 0 and abs(panels.total(lever.over.on(power))) < 1e-9 * given
        assert energy.min() >= 0


def test_an_angle_beyond_half_a_turn_has_no_jump():
    """A crank that turns by 300° and back: its spring is drawn up by c φ all the way."""
    text = ROCKER.replace("driver: {link: 1, ", "driver: {link: 1, range: 300 deg, ")
    lever = course.solve(
        loading.loads(text % ("torsion_springs", "{links: [1, 0], stiffness: 5, preload: 0}"))
    ).lever
    np.testing.assert_allclose(
        lever.kinetostatics.table.balancing, 5 * np.linspace(0, math.radians(300), 25), rtol=1e-9, atol=1e-9
    )


def test_the_machine_in_motion_has_it_in_its_potential():
    more = (
        "dynamics: {motor: {constant: 2 N*m}, parts: [{name: wheel, inertia: 3 kg*m^2}], "
        "resistance: [{viscous: 0.3}]}\n"
    )
    found = course.solve(
        loading.loads(ROCKER % ("torsion_springs", "{links: [2, 3], stiffness: 50, preload: 7}") + more)
    ).dynamics
    whole = found.whole
    keys = [one.key for one in whole.conservative]
    assert len([key for key in keys if key.startswith("M_")]) == 2
    values = sum(one.values for one in whole.conservative)
    panels = whole.panels
    change = whole.potential[:, -1] - whole.potential[:, 0]
    for k in range(panels.shape[0]):
        x, force = panels.x.reshape(panels.shape)[k], values[k]
        done = np.polynomial.Polynomial.fit(x, force, len(x) - 1).integ()
        assert change[k] == pytest.approx(
            -(done(x[-1]) - done(x[0])), abs=1e-9 * np.abs(whole.potential).max()
        )


@pytest.mark.parametrize(
    ("spring", "path", "words"),
    [
        ("{links: [1, 0], stiffness: 5, preload: 0}", "links", "go round one another"),
        ("{links: [1, 3], stiffness: 5, preload: 0}", "links", "go round one another"),
        ("{links: [3, 3], stiffness: 5, preload: 0}", "links", "both ends are on link 3"),
        ("{links: [3, 7], stiffness: 5, preload: 0}", "links.1", "7"),
        ("{links: [3, 0], stiffness: 5}", "", "needs its preload or its free angle"),
        ("{links: [3, 0], stiffness: 5, preload: 1, free_angle: 1 deg}", "", "not both"),
        ("{links: [3, 0], stiffness: 5 N/m, preload: 1}", "stiffness", "a torsional stiffness"),
        ("{links: [3, 0], stiffness: 0, preload: 1}", "stiffness", ""),
        ("{between: [B, C], links: [3, 0], stiffness: 5, preload: 1}", "between", "links: [3, 0]"),
    ],
)
def test_mistakes_are_told_at_their_places(spring, path, words):
    with pytest.raises(ProblemError) as told:
        rocker(spring)
    (problem,) = told.value.problems
    assert ".".join(map(str, problem.path)) == ".".join(filter(None, ("loads.torsion_springs.0", path)))
    assert words in str(told.value)


def test_the_older_name_is_told_the_list():
    with pytest.raises(ProblemError, match="stand in the list torsion_springs"):
        rocker("{links: [3, 0], stiffness: 5, preload: 0}", key="torsional_springs")


def test_the_exact_moments_are_those_of_the_doubles():
    """Also beside half a turn, where the directions alone do not tell the angle."""
    text = ROCKER.replace("driver: {link: 1, ", "driver: {link: 1, range: 300 deg, ")
    springs = "{links: [1, 0], stiffness: 5, preload: 2}, {links: [2, 3], stiffness: 3, free_angle: 20 deg}"
    lever = course.solve(loading.loads(text % ("torsion_springs", springs))).lever
    kinematics, given = lever.kinematics, lever.kinetostatics.given
    found = exactly(kinematics.cycle, kinematics.table.phi)
    moments = acting(given, kinematics, kinematics.table, found, kinematics.turned).moments
    for (link, row), moment, doubles in zip(
        moments, given.moments, lever.kinetostatics.table.loading.moments, strict=True
    ):
        assert link == moment.on
        np.testing.assert_allclose([float(x) for x in row], doubles, rtol=1e-11, atol=1e-11)


# ---------------------------------------------------------------- of the machine in motion

MACHINE = """dynamics:
  motor: {constant: 2 N*m}
  parts: [{name: wheel, inertia: 3 kg*m^2}]
  resistance: [{viscous: 0.3}]
  start: {time: 2 s}
"""
BARE = ROCKER.replace("  %s: [%s]\n", "")


def in_motion(*springs, text=BARE):
    return course.solve(loading.loads(f"{text}{MACHINE}  torsion_springs: [{', '.join(springs)}]\n"))


@pytest.mark.parametrize(
    ("spring", "free", "of"),
    [
        ("{links: [3, 0], stiffness: 50, preload: 7}", 7 / 50, lambda rod, rocker: rocker),
        ("{links: [0, 3], stiffness: 50, preload: 7}", -7 / 50, lambda rod, rocker: rocker),
        (
            "{links: [2, 3], stiffness: 50, free_angle: 8 deg}",
            math.radians(8),
            lambda rod, rocker: rod - rocker,
        ),
        (
            "{links: [3, 2], stiffness: 50, free_angle: 8 deg}",
            -math.radians(8),
            lambda rod, rocker: rod - rocker,
        ),
    ],
)
def test_its_moment_on_the_main_shaft_is_the_slope_of_its_energy(spring, free, of):
    """M = −dU/dφ, U = c (φ − α₀)²/2, by differences of the cosine law alone."""
    found = in_motion(spring).dynamics
    (acting,) = (one for one in found.whole.conservative if one.key == "torsion1")
    x = found.whole.panels.x
    step = 1e-5
    phi = math.radians(25) + np.concatenate(
        [[0.0], (x.ravel()[:, None] + step * np.array([-2, -1, 1, 2])).ravel()]
    )
    order = np.argsort(phi, kind="stable")
    turned = np.empty_like(phi)
    turned[order] = of(*angles(phi[order]))
    energy = 25 * (turned[1:] - turned[0] - free) ** 2
    slope = energy.reshape(-1, 4) @ np.array([1, -8, 8, -1]) / (12 * step)
    assert acting.values.ravel() == pytest.approx(-slope, abs=1e-6 * np.abs(slope).max())
    assert found.conservative < 1e-8


def test_it_acts_as_the_same_one_among_the_loads():
    spring = "{links: [2, 3], stiffness: 50, preload: 7}"
    own = in_motion(spring).dynamics
    among = course.solve(loading.loads(ROCKER % ("torsion_springs", spring) + MACHINE)).dynamics
    assert own.start.omega[-1] == pytest.approx(among.start.omega[-1], rel=1e-10)
    assert np.ptp(own.whole.potential) == pytest.approx(np.ptp(among.whole.potential), rel=1e-10)
    none = course.solve(loading.loads(BARE + MACHINE)).dynamics
    assert abs(own.start.omega[-1] / none.start.omega[-1] - 1) > 1e-4


def test_the_note_calls_it_by_its_number():
    from tmm_report import render

    note = render(in_motion("{links: [3, 0], stiffness: 50, preload: 7}"), "html", "en")["note.html"].decode()
    assert "torsion spring 1" in note


@pytest.mark.parametrize(
    ("springs", "path", "words"),
    [
        ("{links: [1, 0], stiffness: 5, preload: 0}", "torsion_springs.0.links", "go round one another"),
        ("{links: [3, 3], stiffness: 5, preload: 0}", "torsion_springs.0.links", "both ends are on link 3"),
        ("{links: [3, 7], stiffness: 5, preload: 0}", "torsion_springs.0.links.1", "7"),
        (
            "{links: [3, 0], stiffness: 5 N/m, preload: 0}",
            "torsion_springs.0.stiffness",
            "a torsional stiffness",
        ),
    ],
)
def test_slips_of_the_machine_s_own(springs, path, words):
    with pytest.raises(ProblemError) as caught:
        in_motion(springs)
    (problem,) = caught.value.problems
    assert problem.key == f"dynamics.{path}" and words in problem.text()


def test_without_a_mechanism_there_is_nothing_to_turn():
    with pytest.raises(
        ProblemError, match="turns links of a mechanism against one another, and there is none"
    ):
        loading.loads(
            f"language: en\n{MACHINE}  torsion_springs: [{{links: [3, 0], stiffness: 5, preload: 0}}]\n"
        )
    with pytest.raises(ProblemError, match=r"stands in dynamics\.torsion_springs"):
        loading.loads(f"{BARE}{MACHINE}  springs: [{{links: [3, 0], stiffness: 5, length: 0.1}}]\n")


@pytest.mark.parametrize(("links", "told"), [("[3, 0]", 1), ("[0, 3]", 1), ("[2, 3]", 0)])
def test_one_among_the_loads_too_is_asked_about(links, told):
    text = ROCKER % ("torsion_springs", "{links: [3, 0], stiffness: 50, preload: 7}")
    spring = f"{{links: {links}, stiffness: 50, preload: 7}}"
    variant = loading.loads(f"{text}{MACHINE}  torsion_springs: [{spring}]\n")
    doubts = [one for one in variant.doubts if "stands among the loads, too" in one.text()]
    assert [one.key for one in doubts] == ["dynamics.torsion_springs.0.links"] * told
