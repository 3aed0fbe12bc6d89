"""A slider or a hydraulic cylinder drives: its force by two ways, every law of its stroke, what is refused in words."""

from pathlib import Path

import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.chapters.lever.kinetostatics.quantities import tables as kinetostatics_tables
from tmm_report.chapters.lever.kinetostatics.quantities import values as kinetostatics_values
from tmm_report.chapters.lever.structure.naming import link_name
from tmm_report.figures.schemes import marks
from tmm_report.figures.schemes.view import view_of
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.driving.reversed import Reversed
from tmm_report.mechanics.lever.driving.triangle import Triangle
from tmm_report.problems import ProblemError

STATEMENTS = Path(__file__).parents[2] / "statements"
SLIDER = (STATEMENTS / "slider_drives.yaml").read_text("utf-8").replace(", at: [0.60 m, 0.50 m, 0.35 m]", "")
TIPPER = (
    (STATEMENTS / "tipper_by_cylinder.yaml").read_text("utf-8").replace(", at: [0.2 s, 1.0 s, 3.0 s]", "")
)
UNIFORM = "{from: 0.35 m, to: 0.60 m, speed: 1.2 m/s}"
RAMP = "{from: 1.10 m, speed: 0.15 m/s, run_up: 0.4 s, time: 3.0 s}"


def with_stroke(text, stroke):
    return text.replace(UNIFORM, stroke).replace(RAMP, stroke)


def solved(text):
    return course.solve(loading.loads(text)).lever


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
    "too long a cylinder": (TIPPER.replace("time: 3.0 s", "time: 20 s"), "cannot go on", "driver.stroke"),
    "no rod": (SLIDER.replace("slider: 3", "slider: 1"), "no guide of the frame", "driver.slider"),
    "unknown slider": (SLIDER.replace("slider: 3", "slider: 7"), "no link 7", "driver.slider"),
    "both ends fixed": (
        TIPPER.replace("cylinder: [A, B]", "cylinder: [A, O]"),
        "A and O are both fixed",
        "cylinder",
    ),
    "both ends of one link": (
        TIPPER.replace("cylinder: [A, B]", "cylinder: [B, S3]"),
        "B and S3 are points of one link",
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
    "no time to run up": (
        with_stroke(SLIDER, "{from: 0.35 m, to: 0.36 m, speed: 1.2 m/s, run_up: 1 s}"),
        "before the speed is run up to",
        "stroke",
    ),
    "run up of an acceleration": (
        with_stroke(SLIDER, "{from: 0.35 m, to: 0.5 m, acceleration: 1 m/s^2, run_up: 1 s}"),
        "run_up is nothing of the law",
        "stroke",
    ),
    "an instant beyond the stroke": (
        SLIDER.replace("plans: [12]", "plans: [12], at: [0.7 m]"),
        "it goes from 350 to 600 mm",
        "positions.at.0",
    ),
    "no beginning": (with_stroke(SLIDER, "{to: 0.6 m, speed: 1 m/s}"), "needs the key from", "stroke"),
    "uniform rotation": (SLIDER + "balancing: {methods: [full]}\n", "uniformly turning", "balancing"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_not_offered_is_said_with_its_key(name):
    text, wrong, key = REFUSED[name]
    with pytest.raises(ProblemError) as error:
        loading.loads(text)
    said = [problem.text() for problem in error.value.problems]
    assert len(said) == 1
    assert wrong in said[0]
    assert key in error.value.problems[0].key


def test_a_point_of_the_barrel_does_for_its_pivot():
    """The cylinder from S1, which lies on its axis 0.3 m from A: by reversing, the forces of the triangle."""
    text = TIPPER.replace("cylinder: [A, B]", "cylinder: [S1, B]").replace("from: 1.10 m", "from: 0.80 m")
    one, other = solved(TIPPER).kinetostatics, solved(text).kinetostatics
    assert isinstance(one.kinematics.stroke, Triangle) and isinstance(other.kinematics.stroke, Reversed)
    assert other.table.statics.driving == pytest.approx(one.table.statics.driving, rel=1e-10)
    assert other.table.motion.phi == pytest.approx(one.table.motion.phi, abs=1e-12)
    for joint in ("0-3", "0-1"):
        of, like = (found.table.statics.reactions[joint].force for found in (other, one))
        assert of == pytest.approx(like, rel=1e-9)


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


def test_run_up_and_down_is_a_trapezoid():
    """The distance is the area under the speed: v (T − t₁/2 − t₂/2); the same by stated accelerations."""
    base = SLIDER.replace(UNIFORM, "{from: 0.35 m, STATED}")
    stated = "to: 0.60 m, speed: 1.2 m/s, run_up: 0.05 s, run_down: 0.02 s"
    law = loading.loads(base.replace("STATED", stated)).lever.mechanism.driver.stroke.law
    assert law.period == pytest.approx(0.25 / 1.2 + 0.035, rel=1e-15)
    assert float(law.at(np.array([law.period]))[0][0]) == pytest.approx(0.60, rel=1e-15)
    pieces = "accelerations: [[0.05 s, 24 m/s^2], [%r s, 0], [0.02 s, -60 m/s^2]]" % (law.period - 0.07)
    other = loading.loads(base.replace("STATED", pieces)).lever.mechanism.driver.stroke.law
    t = np.linspace(0, law.period, 301)
    for one, two in zip(law.at(t), other.at(t), strict=True):
        assert one == pytest.approx(two, abs=1e-12)


@pytest.mark.parametrize(
    "stated",
    [
        "{from: 0.35 m, to: 0.60 m, speed: 1.2 m/s}",
        "{from: 0.45 m, harmonic: {amplitude: 80 mm, frequency: 3 rad/s}}",
    ],
)
def test_instants_by_the_stroke(stated):
    """At 0.50 m, as often as the stroke comes there: once, or forth and back."""
    text = SLIDER.replace(UNIFORM, stated).replace("plans: [12]", "plans: [12], at: [0.50 m]")
    law = (found := course.solve(loading.loads(text)).lever).kinematics.linkage.mechanism.driver.stroke.law
    times = found.kinematics.instants * law.period / (2 * np.pi)
    dense = np.linspace(0, law.period, 199_999)
    crossings = np.flatnonzero(np.diff(np.sign(law.at(dense)[0] - 0.5)))
    assert len(times) == len(crossings) == (1 if "speed" in stated else 2)
    assert times == pytest.approx(dense[crossings], abs=2 * law.period / 199_998)
    assert law.at(times)[0] == pytest.approx(0.5, abs=1e-12)


BUCKET = """
mechanism:
  frame: {A: [-1.2 m, 0.35 m], C: [-0.3 m, 0.1 m], D: [0, 0]}
  links:
    1: {points: {C: 0, B: 0.5 m}, mass: 40 kg/m, inertia: 0.17*m*l^2}
    2: {points: {B: 0, E: 0.45 m}, mass: 40 kg/m, inertia: 0.17*m*l^2}
    3: {points: {D: 0, E: 0.3 m, K: {distance: 1.1 m, angle: -75 deg}}, mass: 380 kg, mass_centre: K, inertia: 45}
  driver: {cylinder: [A, B], stroke: {from: 0.9 m, speed: 0.2 m/s, run_up: 0.2 s, time: 1.5 s}}
  assembly: {B: left of A-C, E: right of B-D}
loads:
  forces: [{at: K, direction: {link: 3, angle: 200 deg}, constant: 18 kN}]
"""


def test_what_else_has_the_pin_is_no_rod_of_the_cylinder():
    """A cylinder whose links are left out is one of weightless links: its force takes the link that it drives, and the
    rod to the bucket is a connecting rod."""
    left_out = solved(BUCKET)
    stated = solved(
        BUCKET.replace("frame:", "guides: {axis: {through: A, link: 8}}\n  frame:").replace(
            "  links:", "  links:\n    8: {points: [A]}\n    9: {points: [B], slides: axis}"
        )
    )
    one, other = (dict(pair) for pair in (_reactions(left_out), _reactions(stated)))
    for joint in ("R_01", "R_12", "R_23", "R_03", "F_stroke"):
        assert one[joint] == pytest.approx(other[joint], rel=1e-9), joint
    assert {"8", "9"} == {*stated.kinematics.linkage.mechanism.driver.stroke.by}
    assert not left_out.kinematics.linkage.mechanism.driver.stroke.by
    assert link_name(left_out.structure, left_out.kinematics.table, "2").name == "connecting rod"


def _reactions(lever):
    for table in kinetostatics_tables(lever.kinetostatics):
        if table.name in ("reactions_table", "drive_table"):
            yield from ((column.key, column.values) for column in table.columns)


def view(text):
    """Position 0 of a mechanism as it is drawn, at 5 mm of it per mm of paper."""
    motion = (lever := solved(text)).kinematics.table
    mechanism = lever.kinematics.linkage.mechanism
    places = {point: np.broadcast_to(motion.place(point), motion.shape) for point in mechanism.point_names}
    turns = {link: np.broadcast_to(motion.turn(link), motion.shape) for link in mechanism.moving}
    return view_of(mechanism, places, turns, 0.005, 0)


BACKWARDS = "{from: 1.15 m, speed: -0.12 m/s, run_up: 0.3 s, time: 1.2 s}"
EXTENDS = "{from: 0.9 m, speed: 0.2 m/s, run_up: 0.2 s, time: 1.5 s}"


@pytest.mark.parametrize(
    ("text", "way"),
    [
        (BUCKET, 1),
        (BUCKET.replace(EXTENDS, BACKWARDS), -1),
        (TIPPER, 1),
        (SLIDER, 1),
        (with_stroke(SLIDER, "{from: 0.6 m, to: 0.35 m, speed: 1 m/s}"), -1),
    ],
)
def test_the_arrow_of_what_drives_points_as_it_begins_to_move(text, way):
    seen = view(text)
    stroke = seen.mechanism.driver.stroke
    (arrow,) = seen.driving()
    pin, far = (seen.points[name] for name in stroke.names[1:])
    along = stroke.way if stroke.slides else (pin - far) / abs(pin - far)
    pointed = (arrow.end - arrow.start) / abs(arrow.end - arrow.start)
    assert pointed == pytest.approx(way * along, abs=1e-12)
    middle = far if stroke.slides else (pin + far) / 2
    assert abs((arrow.start + arrow.end) / 2 - middle) < 6  # mm, beside the slider or the cylinder


def test_a_cylinder_without_links_is_drawn_between_its_points():
    """Barrel from the fixed point on, rod to the pin, the piston on both their axis and within the barrel."""
    seen, other = view(BUCKET), view(TIPPER)
    assert (seen.cylinder, other.cylinder) == (("A", "B"), None)
    start, end = seen.points["A"], seen.points["B"]
    along = (end - start) / abs(end - start)
    barrel, piston, rod, *joints = marks.cylinder(start, end, *seen.lengths)
    assert [one.centre for one in joints] == pytest.approx([start, end])
    corners = (np.array(barrel.strokes[0]) - start) / along
    assert corners.imag == pytest.approx([-marks.BARREL, -marks.BARREL, marks.BARREL, marks.BARREL])
    at = [(np.array(one.strokes[0]) - start) / along for one in (piston, rod)]
    assert at[1].imag == pytest.approx([0, 0], abs=1e-12) and at[1].real[1] == pytest.approx(abs(end - start))
    assert at[0].real == pytest.approx([at[1].real[0]] * 2)
    assert corners.real.min() < at[1].real[0] < corners.real.max()
    drawn = [item for item in seen.links() if getattr(item, "strokes", None) == barrel.strokes]
    assert len(drawn) == 1
    low, high = solved(BUCKET).kinematics.linkage.mechanism.driver.stroke.law.reach
    assert seen.lengths == pytest.approx((low / 0.005, high / 0.005))
