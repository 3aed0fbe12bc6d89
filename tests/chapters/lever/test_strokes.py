"""A slider or a hydraulic cylinder drives: its force by two ways, every law of its stroke, what is refused in words."""

from pathlib import Path

import numpy as np
import pytest

from tmm_report import course
from tmm_report.chapters.lever.kinetostatics.quantities import tables as kinetostatics_tables
from tmm_report.chapters.lever.kinetostatics.quantities import values as kinetostatics_values
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.problems import ProblemError

STATEMENTS = Path(__file__).parents[2] / "statements"
SLIDER = (STATEMENTS / "slider_drives.yaml").read_text("utf-8")
TIPPER = (STATEMENTS / "tipper_by_cylinder.yaml").read_text("utf-8")
UNIFORM = "{from: 0.35 m, to: 0.60 m, speed: 1.2 m/s}"
RAMP = "{from: 1.10 m, accelerations: [[0.4 s, 0.375 m/s^2], [2.6 s, 0]]}"


def with_stroke(text, stroke):
    return text.replace(UNIFORM, stroke).replace(RAMP, stroke)


def solved(text):
    return course.solve(course.loads(text)).lever


LAWS = {
    "uniform by its time": (SLIDER, "{from: 0.35 m, speed: 1.2 m/s, time: 0.2 s}"),
    "backwards": (SLIDER, "{from: 0.60 m, to: 0.35 m, speed: 1.2 m/s}"),
    "accelerated": (SLIDER, "{from: 0.35 m, to: 0.6 m, speed: 0.4 m/s, acceleration: 2 m/s^2}"),
    "harmonic": (SLIDER, "{from: 0.45 m, harmonic: {amplitude: 100 mm, frequency: 8 rad/s}}"),
    "polynomial": (TIPPER, "{from: 1.1 m, polynomial: [0.1, 0.05, -0.01], time: 2 s}"),
    "table": (TIPPER, "{lengths: [[0 s, 1.1 m], [0.5 s, 1.15 m], [1 s, 1.25 m], [2 s, 1.5 m]]}"),
    "phases": (
        TIPPER,
        "{from: 1.1 m, rise: 300 mm, time: 4 s, phases: [{rise: 140 deg, law: sine}, {dwell: 40 deg}, "
        "{return: 180 deg, law: polynomial}]}",
    ),
}


@pytest.mark.parametrize("name", LAWS)
def test_every_law_of_the_stroke_agrees_by_three_ways(name):
    text, stroke = LAWS[name]
    lever = solved(with_stroke(text, stroke))
    forces = lever.kinetostatics
    assert forces.agrees
    assert max(forces.worst_lever, forces.worst_power) < 1e-9
    of = lever.kinematics.linkage.mechanism.driver.stroke
    s, v, a = of.law.of_phase(lever.kinematics.table.phase)
    p, q = (lever.kinematics.table.place(point) for point in of.names[1:])
    if of.slides:
        along = dot(q, of.way), dot(lever.kinematics.table.velocity(of.names[2]), of.way)
        assert along[0] == pytest.approx(s - 0.0)
        assert along[1] == pytest.approx(v, abs=1e-12)
        assert dot(lever.kinematics.table.acceleration(of.names[2]), of.way) == pytest.approx(a, abs=1e-10)
    else:
        assert np.abs(p - q) == pytest.approx(s)


@pytest.mark.parametrize("text", [SLIDER, TIPPER])
def test_under_the_force_nothing_is_left_of_a_moment(text):
    """Of every link that turns about a fixed point the moments of all reactions and loads add up to nothing."""
    forces = solved(text).kinetostatics.table
    motion, of = forces.motion, forces.motion.linkage.mechanism.driver.stroke
    pivot = motion.place(of.names[0])
    moment = np.zeros(motion.shape)
    for one in forces.statics.reactions.values():
        if of.link in one.pair.links and one.pair.key != motion.linkage.structure.driver_pair.key:
            sign = 1 if one.pair.links[1] == of.link else -1
            moment = moment + sign * cross(one.at - pivot, one.force)
    own = motion.linkage.mechanism.links[of.link]
    for link, force in forces.loading.inertia.items():
        if link == of.link:
            arm = motion.place(own.mass_centre) - pivot
            moment = moment + cross(arm, force + forces.loading.gravity[link])
    moment = moment + forces.loading.couples.get(of.link, 0.0)
    given = solved(text).kinetostatics.given.moments
    for stated, couple in zip(given, forces.loading.moments, strict=True):
        moment = moment + (couple if stated.on == of.link else 0.0)
    assert moment == pytest.approx(np.zeros(motion.shape), abs=1e-9 * np.nanmax(forces.scale))


def test_the_power_of_the_force_is_that_of_all_loads():
    """F v = dT/dt − ΣN, without the moment that the program goes through."""
    lever = solved(SLIDER)
    table, of = lever.kinetostatics.table, lever.kinematics.linkage.mechanism.driver.stroke
    v = of.law.of_phase(table.motion.phase)[1]
    assert table.statics.driving * v == pytest.approx(-np.sum(table.powers, axis=0), rel=1e-12)


def test_a_cylinder_without_links_of_its_own_pushes_as_one_without_masses():
    """The same force, and the same reaction of the frame on the body."""
    light = TIPPER
    for mass in (
        "mass: 40 kg, mass_centre: S1, inertia: 3.0 kg*m^2",
        "mass: 25 kg, mass_centre: S2, inertia: 1.5 kg*m^2",
    ):
        light = light.replace(f", {mass}", "")
    alone = "\n".join(
        line for line in TIPPER.splitlines() if not line.startswith(("    1: ", "    2: ", "  guides:"))
    )
    one, other = solved(light).kinetostatics.table, solved(alone).kinetostatics.table
    assert one.statics.driving == pytest.approx(other.statics.driving)
    assert one.statics.force("3", "0") == pytest.approx(other.statics.force("3", "0"))


REFUSED = {
    "which side": (SLIDER.replace("assembly: {A: left of O-B}", ""), "may lie on either side", "assembly"),
    "unclear side": (SLIDER.replace("left of O-B", "left of O-E"), "does not tell", "assembly.A"),
    "said twice": (SLIDER.replace("{A: left", "{B: right, A: left"), "the stroke itself says", "assembly.B"),
    "beyond the triangle": (SLIDER.replace("to: 0.60 m", "to: 0.70 m"), "cannot go on", "driver.stroke"),
    "begins beyond": (SLIDER.replace("from: 0.35 m", "from: 0.70 m"), "cannot be assembled", "driver.stroke"),
    "too long a cylinder": (TIPPER.replace("[2.6 s, 0]", "[20 s, 0]"), "cannot go on", "driver.stroke"),
    "no rod": (SLIDER.replace("slider: 3", "slider: 1"), "no guide of the frame", "driver.slider"),
    "unknown slider": (SLIDER.replace("slider: 3", "slider: 7"), "no link 7", "driver.slider"),
    "both ends fixed": (
        TIPPER.replace("cylinder: [A, B]", "cylinder: [A, O]"),
        "between a fixed",
        "cylinder",
    ),
    "both ends moving": (
        TIPPER.replace("cylinder: [A, B]", "cylinder: [S1, B]"),
        "between a fixed",
        "cylinder",
    ),
    "a link that slides": (
        SLIDER.replace(f"slider: 3, stroke: {UNIFORM}", "link: 3, speed: 10 rad/s"),
        "is stated with its stroke",
        "driver.link",
    ),
    "no stroke": (SLIDER.replace(f", stroke: {UNIFORM}", ""), "stroke of the slider", "driver"),
    "a speed of rotation": (
        SLIDER.replace("slider: 3,", "slider: 3, speed: 10 rad/s,"),
        "does not go",
        "driver",
    ),
    "two laws": (
        with_stroke(SLIDER, "{from: 0, acceleration: 1, polynomial: [1], time: 1}"),
        "one way",
        "stroke",
    ),
    "no end": (with_stroke(SLIDER, "{from: 0.35 m, speed: 1 m/s}"), "stated once", "stroke"),
    "never there": (with_stroke(SLIDER, "{from: 0.35 m, to: 0.5 m, speed: -1 m/s}"), "never comes", "stroke"),
    "stops before": (
        with_stroke(SLIDER, "{from: 0.35 m, to: 0.6 m, speed: 0.1 m/s, acceleration: -1 m/s^2}"),
        "never comes",
        "stroke",
    ),
    "no beginning": (with_stroke(SLIDER, "{to: 0.6 m, speed: 1 m/s}"), "needs the key from", "stroke"),
    "uniform rotation": (SLIDER + "balancing: {methods: [full]}\n", "uniformly turning", "balancing"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_not_offered_is_said_with_its_key(name):
    text, wrong, key = REFUSED[name]
    with pytest.raises(ProblemError) as error:
        course.loads(text)
    said = [problem.text() for problem in error.value.problems]
    assert len(said) == 1
    assert wrong in said[0]
    assert key in error.value.problems[0].key


def test_a_slider_in_a_slot_is_refused():
    slotted = (
        (SLIDER.replace("B: 0.45 m, ", "").replace("2: {points: {A: 0,", "2: {points: {A: 0, D: 0.4 m,"))
        .replace("inertia: m*l_AB^2/12", "inertia: 0.05 kg*m^2")
        .replace("S2: 0.5*l_AB", "S2: 0.2 m")
    )
    with pytest.raises(ProblemError, match="no rod joins slider 3"):
        course.loads(slotted)


@pytest.mark.parametrize("text", [SLIDER, TIPPER])
def test_the_tables_of_the_force_say_one_number_three_times_and_the_extremes_bound_it(text):
    lever = solved(text)
    tables = {table.name: table for table in kinetostatics_tables(lever.kinetostatics)}
    found = {column.key: np.array(column.values, float) for column in tables["drive_table"].columns}
    for other in ("F_lever", "F_power"):
        known = np.isfinite(found[other])  # at rest a power says nothing of a force
        assert known.sum() > 15
        assert found[other][known] == pytest.approx(found["F_stroke"][known], rel=1e-9)
    drawn = {column.key: np.array(column.values, float) for column in tables["drive_diagram"].columns}[
        "F_stroke"
    ]
    ends = {value.key: value.value for value in kinetostatics_values(lever.kinetostatics)}
    least, greatest = ends["F_stroke_min"], ends["F_stroke_max"]
    near = 0.01 * (greatest - least)
    assert least - 1e-9 < drawn.min() < least + near and greatest - near < drawn.max() < greatest + 1e-9
