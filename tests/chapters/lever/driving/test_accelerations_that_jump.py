"""Accelerations that jump by the law of the driving link: both sides in the diagrams, what stands in the tables."""

import re

import numpy as np
import pytest
from notes import render

from tmm_report import course, loading
from tmm_report.chapters.lever.kinematics.solve.jumps import BESIDE, drawn
from tmm_report.chapters.lever.kinematics.view.diagrams import Diagrams
from tmm_report.i18n import Translator

ROCKER = """language: en
mechanism:
  frame: {O: [0, 0], C: [0.4 m, 0.1 m]}
  links:
    1: {points: {O: [0, 0], A: [100 mm, 0]}, mass: 2 kg, mass_centre: A, inertia: 0.09 kg*m^2}
    2: {points: {A: [0, 0], B: [450 mm, 0], S2: [225 mm, 0]}, mass: 1.5 kg, mass_centre: S2, inertia: m*l^2/12}
    3: {points: {C: [0, 0], B: [300 mm, 0], S3: [150 mm, 0]}, mass: 2 kg, mass_centre: S3, inertia: m*l^2/12}
  driver: {link: 1, law: LAW}
  assembly: {B: left of A-C}
loads: {gravity: 9.81 m/s^2}
"""
BOOM = """language: en
mechanism:
  frame: {O: [0, 0], E: [400 mm, -300 mm], Q: [0, 300 mm]}
  guides: {axis: {through: E, link: 2}, x: {through: Q, angle: 0 deg}}
  links:
    1: {points: {O: [0, 0], B: [500 mm, 150 mm], D: [700 mm, 0]}, mass: 30 kg, mass_centre: D, inertia: 2 kg*m^2}
    2: {points: {E: [0, 0]}}
    3: {points: {B: [0, 0]}, slides: axis}
    4: {points: {D: [0, 0], F: [500 mm, 0]}}
    5: {points: {F: [0, 0]}, slides: x, mass: 8 kg, mass_centre: F}
  driver: {cylinder: [E, B], stroke: {from: 560 mm, speed: 50 mm/s, time: 2 s, run_up: 0.35 s, run_down: 0.5 s}}
  assembly: {B: left of O-E, F: right}
loads: {gravity: 9.81 m/s^2}
"""
PHASES = (
    "{phases: [{rise: 150 deg, law: parabolic}, {dwell: 30 deg}, {return: 180 deg, law: parabolic}], "
    "swing: 60 deg, time: 1 s}"
)
SMOOTH = PHASES.replace("parabolic", "sine")
TEXTS = {
    # the driving link's acceleration before and after each jump: 4 ψ/t² of a parabolic phase; Δv/t of a run-up
    "phases": (
        ROCKER.replace("LAW", PHASES),
        {0: (16 / 3 * np.pi, 24.127431), 75: (24.127431, -24.127431), 150: (-24.127431, 0), 180: (0, -16 / 3 * np.pi),
         270: (-16 / 3 * np.pi, 16 / 3 * np.pi)},
    ),
    "stroke": (BOOM, {63: (0.05 / 0.35, 0.0), 270: (0.0, -0.05 / 0.5)}),
}  # fmt: skip


def found(text):
    return course.solve(loading.loads(text)).lever


def stated(name, lever, motion):
    """What the law states the acceleration of: the driving link's angle, or the stroke."""
    if name == "phases":
        return motion.angular_acceleration("1")
    return lever.kinematics.stroke.law.of_phase(motion.phase)[2]


@pytest.mark.parametrize("name", TEXTS)
def test_jumps_are_where_the_law_has_them_with_both_values(name):
    text, wanted = TEXTS[name]
    lever = found(text)
    at = lever.kinematics.jumps
    assert np.degrees(at.turned) == pytest.approx(sorted(wanted), abs=1e-6)
    before, after = at.sides
    for k, values in enumerate(wanted.values()):
        sides = [stated(name, lever, side.motion)[k] for side in (before, after)]
        assert sides == pytest.approx(values, rel=1e-7, abs=1e-9)


@pytest.mark.parametrize("name", TEXTS)
def test_both_values_are_slopes_of_the_velocity_from_their_own_side(name):
    """Velocities alone, in one-sided differences of the fourth order: no acceleration takes part."""
    motion = found(TEXTS[name][0]).kinematics
    weights, step = np.array([-25 / 12, 4, -3, 4 / 3, -1 / 4]), 1e-3
    for side in motion.jumps.sides:
        places = side.turned[:, None] + side.side * (step * np.arange(5) + 1e-8)
        for travel in (*motion.travels, *motion.links):
            velocity = travel.output.velocity(motion.cycle.motion(places.ravel())).reshape(places.shape)
            slope = side.side * velocity @ weights / step * abs(motion.omega)
            size = np.nanmax(np.abs(travel.diagram_a))
            assert travel.output.acceleration(side.motion) == pytest.approx(slope, abs=1e-5 * size)


@pytest.mark.parametrize("name", TEXTS)
def test_a_jump_is_drawn_upright_with_both_values(name):
    text, wanted = TEXTS[name]
    motion = found(text).kinematics
    diagrams = Diagrams(motion, Translator("en"))
    assert motion.travels
    for travel in motion.travels:
        graph = diagrams.travel(travel)
        assert np.all(np.diff(graph.x) >= 0) and np.ptp([len(curve.values) for curve in graph.curves]) == 0
        for panel, curve in zip(graph.panels, graph.curves, strict=True):
            assert np.all(np.isfinite(curve.values))
            places = panel.places(graph.x, curve.values)
            steep = np.abs(np.diff(places.imag)) > 0.5 * panel.tall
            assert np.all(
                np.abs(np.diff(places.real))[steep] < 0.02
            )  # mm: no line across the panel is slanted
        values, of = graph.curves[-1].values, travel.output.acceleration
        for angle in wanted:
            for side in motion.jumps.sides:
                place = np.radians(angle or (360 if side.side < 0 else 0)) + side.side * BESIDE
                k = np.argmin(np.abs(graph.x - np.degrees(place)))
                true = of(side.motion)[np.flatnonzero(np.isclose(np.degrees(side.turned) % 360, angle % 360))]
                assert values[k] == pytest.approx(float(true[0]), abs=1e-9 * np.abs(values).max())


def test_displacements_go_on_through_a_jump():
    motion = found(TEXTS["phases"][0]).kinematics
    at = drawn(motion, motion.jumps)
    for travel in motion.travels:
        graph = Diagrams(motion, Translator("en")).travel(travel)
        moved, speed = (np.radians(graph.curves[0].values), graph.curves[1].values)
        # what is moved between neighbours is the mean of their velocities times the time between
        mean = (speed[1:] + speed[:-1]) / 2 * np.diff(at.turned) / motion.omega
        assert np.diff(moved) == pytest.approx(mean, abs=3e-3 * np.ptp(moved))


def test_a_smooth_law_has_no_jumps():
    motion = found(ROCKER.replace("LAW", SMOOTH)).kinematics
    assert not motion.jumps.turned.size and not motion.jumps.sides
    assert len(Diagrams(motion, Translator("en")).at.turned) == len(motion.diagram_turned)


def test_extremes_see_the_side_before_the_middle_of_a_long_phase():
    """By parts of the phase the middle is as near as to the degree: half a turn is three times as far in radians."""
    phases = "{phases: [{rise: 180 deg, law: parabolic}, {return: 180 deg, law: parabolic}], swing: 80 deg, time: 1 s}"
    text = ROCKER.replace("LAW", phases)
    motion = found(text).kinematics
    for travel in motion.travels:
        low, high = travel.a_extremes
        sides = np.concatenate([travel.output.acceleration(side.motion) for side in motion.jumps.sides])
        assert low.value <= sides.min() + 1e-6 and high.value >= sides.max() - 1e-6


@pytest.mark.parametrize(("name", "positions"), [("phases", "0, 5, 6, 9, 12"), ("stroke", "9")])
def test_the_note_says_which_side_the_tables_have(name, positions):
    lever = found(TEXTS[name][0])
    html = render(course.solve(loading.loads(TEXTS[name][0])), "html", "en")["note.html"].decode()
    text = re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", html))
    assert f"Positions that stand at a jump: {positions}; the tables give there what is after it" in text
    assert f"Positions at which the accelerations jump: {positions};" in text
    after = lever.kinematics.jumps.sides[1]
    rows = np.flatnonzero(lever.kinematics.jumps.standing(lever.kinematics.turned))
    for k in rows:
        there = np.argmin(np.abs(after.turned - lever.kinematics.turned[k] % (2 * np.pi)))
        for travel in lever.kinematics.travels:
            true = travel.output.acceleration(after.motion)[there]
            assert travel.a[k] == pytest.approx(true, abs=1e-6 * np.abs(travel.a).max())
