"""What a driving slider or cylinder asks of a mechanism, in words; other main links; structure, scheme, equations."""

from math import hypot
from pathlib import Path

import numpy as np
import pytest
import yaml
from stroke_constraints import Solver
from stroke_mechanisms import Made, rocking
from test_reversed_strokes import coordinates

from tmm_report import course, loading
from tmm_report.chapters.lever.kinetostatics.quantities.equations import system
from tmm_report.figures.schemes import marks
from tmm_report.figures.schemes.view import view_of
from tmm_report.problems import ProblemError

TESTS = Path(__file__).parents[3]
LIFT = (TESTS / "statements" / "scissor_between_arms.yaml").read_text("utf-8")
TIPPER = (TESTS / "statements" / "tipper_by_cylinder.yaml").read_text("utf-8")
LAW = "{from: 0.36 m, to: 0.56 m, speed: 0.05 m/s, run_up: 0.5 s, run_down: 0.5 s}"
LONGEST = 1e3 * (hypot(0.2, 0.06) + hypot(0.5, 0.05))  # C, on the line between the pins
SHORTEST = 1e3 * (hypot(0.5, 0.05) - hypot(0.2, 0.06))
TRAMMEL = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O, angle: 0 deg}, y: {through: O, angle: 90 deg}}
  links:
    1: {points: [A], slides: x}
    2: {points: {A: 0, B: 300 mm}}
    3: {points: [B], slides: y}
  driver: {slider: 1, stroke: {from: 100 mm, to: 200 mm, speed: 0.1 m/s}}
  assembly: {B: up}
"""
PRESS = """
mechanism:
  frame: {O: [0, 0]}
  guides: {y: {through: O, angle: 90 deg}}
  links:
    1: {points: {O: 0, B: 40 mm}}
    2: {points: {C: 0, E: 135 mm, B: {from: {C: 90 mm, E: 90 mm}, side: left}}}
    3: {points: {D: 0, C: 185 mm, K: 90 mm}}
    4: {points: {F: 0, E: 185 mm}}
    5: {points: {S: 0, F: 67.5 mm, D: -67.5 mm}, slides: {guide: y, at: S, angle: 90 deg}}
  driver: {cylinder: [B, K], stroke: {from: 100 mm, to: 101 mm, speed: 1 mm/s}}
  sketch: {B: [0, 40 mm], C: [-70 mm, -20 mm], E: [70 mm, -20 mm], D: [-70 mm, -200 mm], F: [70 mm, -200 mm]}
"""


def stroke(law):
    return LIFT.replace(LAW, law)


REFUSED = {
    "one link": (LIFT.replace("[Q, P]", "[O, P]"), "O and P are points of one link", "driver.cylinder"),
    "no pivot": (TRAMMEL, "the crank to the middle of its rod", "driver.slider"),
    "a higher group": (PRESS, "a group above class II is left (from link 1, IV(2,3,4,5))", "driver.cylinder"),
    "too long": (stroke("{from: 0.36 m, to: 0.75 m, speed: 0.1 m/s}"), f"beyond {LONGEST:.6g} mm", "stroke"),
    "too short": (stroke("{from: 0.36 m, to: 0.2 m, speed: 0.1 m/s}"), f"beyond {SHORTEST:.6g} mm", "stroke"),
    "its range": (
        stroke("{from: 0.36 m, to: 0.75 m, speed: 0.1 m/s}"),
        f"a stroke between {SHORTEST:.6g} and {LONGEST:.6g} mm",
        "stroke",
    ),
    "begins beyond": (
        stroke("{from: 0.8 m, speed: 0.1 m/s, time: 1 s}"),
        "where the stroke begins, at 800",
        "stroke",
    ),
    "two ways": (LIFT.replace("C: up, ", ""), "in 2 ways", "assembly"),
    "how to say it": (LIFT.replace("C: up, ", ""), "assembly: {C: up} or {C: down}", "assembly"),
    "not told": (LIFT.replace("C: up", "C: +"), "does not tell where C lies", "assembly.C"),
    "against itself": (
        LIFT.replace("C: up", "C: up, K: right of O-D").replace("P: [1", "K: [0.5 m, 0], P: [1"),
        "cannot stand so that K is on this side",
        "assembly.K",
    ),
    "no such group": (LIFT.replace("C: up", "C: up, 1-5: +"), "1-5 names no group", "assembly.1-5"),
    "its groups": (LIFT.replace(", 4-5: +", ""), "group II2(4,5) can be assembled in two ways", "assembly"),
    "too free": (LIFT.replace(", slides: table", ""), "mobility is W", "links"),
    "farthest": (rocking((0.7, 0.5, 0.6), 1.1, -0.5 + 0.3j, -0.5), "cannot go beyond", "stroke"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_refused_is_said_once_with_its_key(name):
    text, wrong, key = REFUSED[name]
    with pytest.raises(ProblemError) as error:
        loading.loads(text)
    (problem,) = error.value.problems
    assert wrong in problem.text()
    assert key in problem.key


@pytest.mark.parametrize("way", ["C: up", "C: down", "K: left of O-D", "K: right of O-D"])
def test_the_side_that_is_stated_is_taken(way):
    text = LIFT.replace("C: up", way).replace("P: [1.0", "K: [0.5 m, 0], P: [1.0")
    found = course.solve(loading.loads(text)).lever.kinematics.table
    up = "up" in way or "left" in way
    assert (found.place("C").imag > 0).all() == up and (found.place("C").imag < 0).all() == (not up)


@pytest.mark.parametrize(
    ("lengths", "angle", "base", "speed"),
    [((0.9, 0.5, 0.35), 0.4, -0.5 + 0.3j, -0.3), ((0.7, 0.5, 0.6), 1.2, 0.5 + 1.5j, 0.3)],
)
def test_a_link_that_turns_back_leaves_its_place_to_another(lengths, angle, base, speed):
    """Link 1 stops and turns back while the cylinder goes on: the motion is found from link 3, through that place."""
    text = rocking(lengths, angle, base, speed)
    lever, solver = course.solve(loading.loads(text)).lever, Solver(text)
    table = lever.kinematics.table
    assert lever.kinematics.stroke.link == "3"
    turning = lever.kinematics.diagram.angular_velocity("1")
    assert turning.min() < 0 < turning.max()
    for k in (1, 3, 5):
        motion = solver.motion(solver.period * k / 6, coordinates(solver, table, k))
        for name in solver.names:
            omega = motion[1][3 * solver.names.index(name) + 2]
            assert float(table.angular_velocity(name)[k]) == pytest.approx(omega, rel=1e-8)
        assert lever.kinetostatics.table.statics.driving[k] == pytest.approx(
            solver.by_power(motion), rel=1e-8
        )


def test_two_fingers_in_mesh_are_pushed_apart():
    """A gripper whose fingers are geared together, the cylinder between them: s = c − 2 r cos(φ + α)."""
    text = """
mechanism:
  frame: {O: [0, 0], Q: [80 mm, 0]}
  links:
    1: {points: {O: 0, A: [20 mm, 90 mm]}, inertia: 0.004 kg*m^2}
    2: {points: {Q: 0, B: [-20 mm, 90 mm]}, inertia: 0.004 kg*m^2}
  wheels: [{links: [1, 2], ratio: 1}]
  driver: {cylinder: [A, B], stroke: {from: 50 mm, to: 70 mm, speed: 0.1 m/s}}
  assembly: {A: up}
loads: {moments: [{on: 1, direction: clockwise, constant: 3 N*m}]}
positions: {table: 6}
"""
    lever = course.solve(loading.loads(text)).lever
    s = np.linspace(0.05, 0.07, 7)
    arm = hypot(0.02, 0.09)
    angle = np.arccos((0.08 - s) / 2 / arm) - np.arctan2(0.09, 0.02)  # by which A has turned
    assert lever.kinematics.table.phi == pytest.approx(angle, abs=1e-12)
    slope = 2 * arm * np.sin(angle + np.arctan2(0.09, 0.02))  # ds/dφ
    rate = 0.1 / slope
    sudden = -2 * arm * np.cos(angle + np.arctan2(0.09, 0.02)) * rate**2 / slope
    assert lever.kinetostatics.table.statics.driving == pytest.approx(
        (2 * 0.004 * sudden + 3) / slope, rel=1e-9
    )


@pytest.mark.parametrize(
    ("text", "groups"),
    [(LIFT, ["III2(1,2,3,QP)", "II2(4,5)"]), (TIPPER, ["II2(3,1+2)"])],
)
def test_groups_with_the_cylinder_held(text, groups):
    """Its length fixed, the mechanism is a truss: of each group 3n = 2p."""
    found = course.solve(loading.loads(text)).lever.structure.by_cylinder
    assert [group.label for group in found] == groups
    for group in found:
        assert 3 * len(group.links) == 2 * (len(group.inner) + len(group.outer))


def test_a_cylinder_between_links_has_no_support():
    """Of the lift the frame bears O alone; the barrel is drawn between Q and P, wherever they are."""
    lever = course.solve(loading.loads(LIFT)).lever
    motion, mechanism = lever.kinematics.table, lever.kinematics.linkage.mechanism
    places = {point: motion.place(point) for point in mechanism.point_names}
    turns = {link: motion.turn(link) for link in mechanism.moving}
    seen = view_of(mechanism, places, turns, 0.01, 3)
    assert seen.cylinder == ("Q", "P")
    supports = {point: marks.support(seen.points[point]) for point in ("O", "Q")}
    assert all(item in seen.frame() for item in supports["O"])
    assert not any(item in seen.frame() for item in supports["Q"])


def slider_between_cranks(rng, keys, short=0.25 + 0.02j, slider=0.28 + 0.6j):
    """A slider with two rods: on one side a short crank and the rod across the guide at the beginning."""
    z = {"O": 0j, "A": short, "B": slider, "U": slider - 1, "C": 0.9 + 0.7j, "Q": 0.6 + 0.1j}
    made = Made(rng, z)
    made.fixed("O", "U", "Q")
    made.guide("x", "U")
    made.link("1", "O", "A")
    made.link("2", "A", "B")
    made.link("3", "B", slides="x")
    made.link("4", "B", "C")
    made.link("5", "Q", "C")
    whole = yaml.safe_load(made.text({"slider": "3"}, abs(z["B"] - z["U"]), "C"))
    whole["mechanism"]["driver"]["stroke"] |= {"speed": -0.1, "time": 1.0}
    whole["mechanism"]["assembly"] = keys
    return yaml.safe_dump(whole, sort_keys=False)


@pytest.mark.parametrize("keys", [{}, {"A": "right of O-B"}])
def test_a_triangle_that_stops_leaves_its_place_to_another_link(keys):
    """The rod AB comes to stand across the guide, where link 1 turns back: link 5 is found first."""
    text = slider_between_cranks(np.random.default_rng(3), keys)
    lever, solver = course.solve(loading.loads(text)).lever, Solver(text)
    assert lever.kinematics.stroke.link == "5"
    turning = lever.kinematics.diagram.angular_velocity("1")
    assert turning.min() < 0 < turning.max()
    for k in (0, 3, 6):
        motion = solver.motion(solver.period * k / 6, coordinates(solver, lever.kinematics.table, k))
        assert lever.kinetostatics.table.statics.driving[k] == pytest.approx(
            solver.by_power(motion), rel=1e-8
        )


def test_a_triangle_that_falls_flat_stops_the_mechanism():
    """Crank and rod come into one line: no other link helps."""
    text = slider_between_cranks(np.random.default_rng(3), {"A": "left of O-B"}, 0.25j, 0.02 + 0.95j)
    with pytest.raises(ProblemError, match="O, A and B come into one line"):
        loading.loads(text)


def test_the_side_of_a_triangle_by_the_sketch():
    lines = TIPPER.replace("  assembly: {B: left of O-A}", "  sketch: {B: SKETCHED, A: [1.5 m, -0.4 m]}")
    stated = course.solve(loading.loads(TIPPER)).lever.kinematics.table
    for sketched, same in (("[0.8 m, 0.6 m]", True), ("[0.4 m, -0.9 m]", False)):
        found = course.solve(loading.loads(lines.replace("SKETCHED", sketched))).lever.kinematics.table
        assert np.allclose(found.place("B"), stated.place("B")) == same


@pytest.mark.parametrize("links", [("1",), ("2", "3"), ("4", "5")])
def test_the_equations_of_equilibrium_hold_the_force_on_both_links(links):
    """As `explain` writes them: with the numbers of the solution each is nothing, beside the force of the cylinder."""
    forces = course.solve(loading.loads(LIFT)).lever.kinetostatics
    written = system(forces, forces.table, links, 3)
    size = float(forces.table.statics.driving[3])
    sums = [float(one.value) for _, lines in written.lines for one in lines]
    assert len(sums) >= 3 * len(links)
    assert sums == pytest.approx([0.0] * len(sums), abs=1e-9 * size)


SHAPER = """
mechanism:
  frame: {O: [0, 0], E: [-0.2, -0.31], Q: [0, 0.27], G: [0.4, 0.1]}
  guides: {x: {through: Q}, k: {through: C, link: 3}}
  links:
    1: {points: {O: [0, 0], A: [0.095, 0]}, inertia: 0.03}
    2: {points: {A: [0, 0]}, slides: k, mass: 0.9, mass_centre: A}
    3: {points: {C: [0, 0], D: [0.6, 0], S3: [0.31, 0]}, mass: 11, mass_centre: S3, inertia: 0.36}
    4: {points: {E: [0, 0], C: [0.2, 0], S4: [0.1, 0]}, mass: 2.4, mass_centre: S4, inertia: 0.01}
    5: {points: {D: [0, 0]}, slides: x, mass: 28, mass_centre: D}
  driver: {cylinder: [G, A], stroke: {from: 0.4, speed: 0.1, time: 0.2}}
  sketch: {A: [0, 0.095], C: [0, -0.33], D: [0, 0.27]}
loads: {gravity: 9.81}
positions: {table: 6}
"""


def test_a_link_that_leaves_a_group_of_class_iii_is_not_found_first():
    """A cylinder on the crank of a shaper whose slotted link swings on a rocker: by the triangle of the crank the rest
    is a group of class III, from the rocker on dyads."""
    lever, solver = course.solve(loading.loads(SHAPER)).lever, Solver(SHAPER)
    assert lever.structure.formula == "I(0,4) → II2(3,5) → II2(1,2)"
    assert lever.kinetostatics.agrees
    for k in (0, 3, 6):
        motion = solver.motion(solver.period * k / 6, coordinates(solver, lever.kinematics.table, k))
        for name in solver.names:
            omega = motion[1][3 * solver.names.index(name) + 2]
            assert float(lever.kinematics.table.angular_velocity(name)[k]) == pytest.approx(omega, abs=1e-9)
        assert lever.kinetostatics.table.statics.driving[k] == pytest.approx(
            solver.by_power(motion), rel=1e-8
        )
