"""Reduced moments: equality of energy and of power, the derivative, the balancing moment of the force analysis."""

import json
import math
import re
from dataclasses import replace

import numpy as np
import pytest
from conftest import read, solved, stating
from note import read as read_note
from notes import VARIANTS, render
from reading import wrong
from test_against_results import unmarked, wrong_cells, wrong_formulas
from test_arithmetic import wrong_results

from tmm_report import course, loading
from tmm_report.chapters.lever.kinematics.given import Positions
from tmm_report.chapters.lever.kinetostatics.solve.positions import external_power, kinetic_energy
from tmm_report.problems import ProblemError

FINE = 720


@pytest.fixture
def reduced(variant) -> course.LeverFound:
    """Every ready mechanism that has masses, reduced."""
    if not any(link.mass or link.inertia for link in variant.lever.mechanism.links.values()):
        pytest.skip("nothing to reduce")
    return course.solve_lever(stating(variant, reduction=True, readings={}).lever)


def test_energy_of_the_links_is_that_of_the_reduced_disc(reduced):
    motion = reduced.kinematics.diagram
    energy = reduced.reduction.diagram.whole_inertia * motion.omega**2 / 2
    assert np.allclose(energy, kinetic_energy(motion), rtol=1e-12, equal_nan=True)


def test_power_of_the_loads_is_that_of_the_reduced_moment(reduced):
    found = reduced.kinetostatics
    if found is None:
        assert reduced.reduction.diagram.moments == ()
        return
    solved_ = found.diagram
    power = external_power(found.given, solved_.motion, solved_.loading)
    ours = reduced.reduction.diagram.whole_moment * solved_.motion.omega
    scale = np.nanmax(np.abs(power), initial=1e-300)
    assert np.allclose(ours, power, rtol=0, atol=1e-12 * scale, equal_nan=True)


def test_balancing_moment_follows_from_both(reduced):
    if reduced.kinetostatics is not None:
        assert reduced.reduction.disagreement < 1e-9


@pytest.mark.parametrize("name", ["compressor", "piston_pump", "shaper", "whitworth"])
def test_slope_is_the_derivative(name):
    """Of a periodic smooth function the trigonometric interpolation is exact to rounding."""
    given = replace(solved(name).variant.lever, reduction=True, readings={}, loads=None, friction=None)
    given = replace(given, positions=Positions(table=12, diagram=FINE, plans=(), force_plan=()))
    found = course.solve_lever(given).reduction.diagram
    inertia, slope = found.whole_inertia[:-1], found.slope[:-1]
    spectrum = np.fft.rfft(inertia) * 1j * np.arange(FINE // 2 + 1)
    spectrum[-1] = 0
    sense = math.copysign(1, given.mechanism.driver.omega)
    assert np.allclose(np.fft.irfft(spectrum, FINE) * sense, slope, rtol=0, atol=1e-8 * np.abs(slope).max())


def test_parts_add_up(reduced):
    one = reduced.reduction.table
    assert np.allclose(sum(one.inertia.values()), one.whole_inertia, rtol=1e-14, equal_nan=True)
    assert all(np.nanmin(part) >= 0 for part in one.inertia.values())


def test_nothing_to_reduce_is_told():
    text = VARIANTS.joinpath("crank_rocker.yaml").read_text(encoding="utf-8")
    light = re.sub(r"\b(mass|mass_centre|inertia): [^,}\n]*,? ?", "", text.split("\nloads:")[0])
    with pytest.raises(ProblemError) as error:
        loading.loads(light + "\nreduction: true\n")
    assert [problem.path for problem in error.value.problems] == [("reduction",)]


def test_plans_of_velocities_give_the_same_inertia_to_their_accuracy():
    """Ratios are read to a hundredth of a millimetre of some hundred."""
    found = solved("piston_pump").lever.reduction
    assert [one.position for one in found.plans] == [
        d.position for d in solved("piston_pump").lever.plans.drawn
    ]
    for one in found.plans:
        assert one.graph != one.exact == found.table.whole_inertia[one.position]
        assert one.graph == pytest.approx(one.exact, rel=1e-3)
        assert one.delta == pytest.approx(100 * (one.graph / one.exact - 1), rel=1e-2)


@pytest.mark.exhaustive
def test_the_speed_for_which_a_plan_is_drawn_does_not_matter():
    """Ten times the speed at ten times the scale: the same lengths, the same ratios."""
    variant = read("piston_pump")
    mechanism = variant.lever.mechanism
    fast = replace(mechanism, driver=replace(mechanism.driver, omega=10 * mechanism.driver.omega))
    slow, quick = (
        course.solve(
            stating(
                variant, mechanism=one, drawing=replace(variant.lever.drawing, velocity=scale), readings={}
            )
        )
        for one, scale in ((mechanism, 0.02), (fast, 0.2))
    )
    for one, other in zip(slow.lever.reduction.plans, quick.lever.reduction.plans, strict=True):
        assert one.graph == pytest.approx(other.graph, rel=1e-12)
        assert dict(one.centres) == pytest.approx(dict(other.centres), rel=1e-12)


# ---------------------------------------------------------------- a driving link that moves by a law

BY_LAW = """language: en
mechanism:
  frame: {O: [0, 0], C: [0.4 m, 0.1 m]}
  links:
    1: {points: {O: [0, 0], A: [100 mm, 0]}, mass: 2 kg, mass_centre: A, inertia: 0.09 kg*m^2}
    2: {points: {A: [0, 0], B: [450 mm, 0], S2: [225 mm, 0]}, mass: 1.5 kg, mass_centre: S2, inertia: m*l^2/12}
    3: {points: {C: [0, 0], B: [300 mm, 0], S3: [150 mm, 0]}, mass: 2 kg, mass_centre: S3, inertia: m*l^2/12}
  driver: {link: 1, DRIVES}
  assembly: {B: left of A-C}
loads: {gravity: 9.81 m/s^2, moments: [{on: 3, direction: against motion, constant: 25 N*m}]}
reduction: REDUCED
"""
LAWS = {
    "harmonic": "law: {angle: 60 deg, harmonic: {amplitude: 35 deg, frequency: 8 rad/s, phase: 40 deg}}",
    "accelerated": "law: {speed: 2 rad/s, acceleration: 40 rad/s^2, time: 0.5 s}",
    "with a dwell": "law: {phases: [{rise: 150 deg, law: parabolic}, {dwell: 60 deg}, {return: 150 deg, law: sine}], "
    "swing: 60 deg, time: 1 s}",
}


def by_law(drives, reduced="true"):
    return course.solve(loading.loads(BY_LAW.replace("DRIVES", drives).replace("REDUCED", reduced))).lever


@pytest.mark.parametrize("law", LAWS)
def test_by_a_law_energy_and_power_are_those_of_the_reduced(law):
    lever = by_law(LAWS[law])
    motion, forces, reduced = lever.kinematics.diagram, lever.kinetostatics.diagram, lever.reduction.diagram
    omega = motion.angular_velocity("1")
    energy = kinetic_energy(motion)
    assert reduced.whole_inertia * omega**2 / 2 == pytest.approx(energy, abs=1e-12 * energy.max())
    power = external_power(lever.kinetostatics.given, forces.motion, forces.loading)
    moving = (
        np.abs(omega) > 1e-6 * np.abs(omega).max()
    )  # a moment against the motion of what stands has no sense
    assert (reduced.whole_moment * omega)[moving] == pytest.approx(
        power[moving], abs=1e-12 * np.abs(power).max()
    )
    assert np.all(np.isfinite(reduced.whole_inertia)) and np.all(np.isfinite(reduced.slope))


@pytest.mark.parametrize("law", LAWS)
def test_by_a_law_the_inertia_is_that_of_the_place_and_the_slope_its_derivative(law):
    """At the same angles of a mechanism that turns uniformly, at which no law takes part."""
    lever = by_law(LAWS[law])
    uniform = by_law("speed: 7 rad/s, zero: {angle: 0 deg}").kinematics
    phi = lever.kinematics.diagram.phi
    step = 1e-4 * np.array([-2, -1, 0, 1, 2])
    motion = uniform.cycle.motion(np.mod(phi[:, None] + step, 2 * np.pi).ravel())
    inertia = (2 * kinetic_energy(motion) / 7**2).reshape(-1, 5)
    reduced = lever.reduction.diagram
    assert reduced.whole_inertia == pytest.approx(inertia[:, 2], rel=1e-12)
    slope = inertia @ np.array([1, -8, 0, 8, -1]) / (12 * 1e-4)
    assert reduced.slope == pytest.approx(slope, abs=1e-8 * np.abs(slope).max())


@pytest.mark.parametrize("law", LAWS)
def test_by_a_law_the_equation_of_motion_gives_the_balancing_moment(law):
    lever = by_law(LAWS[law])
    assert lever.reduction.disagreement < 1e-9
    reduced, motion = lever.reduction.table, lever.kinematics.table
    omega, epsilon = motion.angular_velocity("1"), motion.angular_acceleration("1")
    moment = reduced.whole_inertia * epsilon + omega**2 * reduced.slope / 2 - reduced.whole_moment
    own = lever.kinetostatics.table.balancing
    assert moment == pytest.approx(own, abs=1e-9 * np.abs(own).max())
    assert np.abs(reduced.whole_inertia * epsilon).max() > 0.1 * np.abs(own).max()


def test_by_a_law_the_reduction_to_another_link_is_refused_with_what_is_offered():
    text = BY_LAW.replace("DRIVES", LAWS["harmonic"]).replace("REDUCED", "{link: 3}")
    with pytest.raises(ProblemError, match="reduction: true, to the driving link"):
        loading.loads(text)


@pytest.mark.parametrize("language", ["en", "ru"])
def test_by_a_law_the_note_writes_the_equation_of_motion(language):
    results = course.solve(
        loading.loads(BY_LAW.replace("DRIVES", LAWS["with a dwell"]).replace("REDUCED", "true"))
    )
    html = render(results, "html", language)["note.html"].decode()
    note, document = read_note(html), json.loads(render(results, "json")["results.json"])
    wrong(
        [*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_results(note), *unmarked(note)]
    )
    said = {"en": "by whatever law it moves", "ru": "по какому бы закону"}[language]
    assert said in re.sub(r"\s+", " ", re.sub(r"<[^>]+>", "", html))
