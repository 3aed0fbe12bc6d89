"""The mechanism reduced over its cycle: what the chapters of the machine in motion integrate."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from conftest import read, solved, stating

from tmm_report import course
from tmm_report.chapters.lever.kinetostatics.given import Diagram, Force, Loads
from tmm_report.chapters.lever.moving import Moving, machine
from tmm_report.problems import ProblemError


def machine_of(results):
    return machine(Moving(results.lever.kinematics, results.lever.kinetostatics))


CLOSED = ["crank_rocker", "shaper", "v_engine", "press", "piston_pump"]


@pytest.mark.parametrize("name", CLOSED)
def test_the_balancing_moment_does_the_work_that_the_loads_take(name):
    """The energy of the links is the same after a turn: over the cycle the moment's mean is minus that of the loads."""
    results = solved(name)
    of = machine_of(results)
    forces = results.lever.kinetostatics
    at = of.panels.at(of.whole_moment, forces.diagram.turned[:-1])
    slope = of.panels.at(of.slope, forces.diagram.turned[:-1])
    expected = of.omega**2 * slope / 2 - at
    found = forces.diagram.balancing[:-1] * results.lever.kinematics.cycle.sense
    jumps = np.min(np.abs(forces.diagram.turned[:-1, None] - of.panels.edges), axis=1) < 1e-7
    assert np.mean(~jumps) > 0.3
    assert found[~jumps] == pytest.approx(expected[~jumps], abs=1e-9 * np.abs(found).max())


@pytest.mark.parametrize("name", CLOSED)
def test_the_slope_of_the_inertia_is_its_derivative(name):
    of = machine_of(solved(name))
    largest = np.abs(of.slope).max()
    assert of.panels.slope(of.whole_inertia) == pytest.approx(of.slope, abs=1e-8 * largest)
    assert of.panels.total(of.slope) == pytest.approx(0, abs=1e-10 * largest)


@pytest.mark.parametrize("name", CLOSED)
def test_weights_do_no_work_over_a_cycle(name):
    of = machine_of(solved(name))
    weights = [part for load, part in of.moments if load.key.startswith("G_")]
    assert weights
    for part in weights:
        assert of.panels.total(part) == pytest.approx(0, abs=1e-10 * np.abs(part).max())


def test_work_of_an_indicator_diagram_is_its_area():
    """To the last digits, though the force jumps where the slider turns back and bends within the stroke."""
    (travel,) = [
        t for t in solved("slider_crank_offset").lever.kinematics.travels if t.output.kind == "slider"
    ]
    zero = travel.output.direction
    gas = Diagram(
        zero=zero, forward=[(0.0, 900.0), (0.3, 100.0), (1.0, 100.0)], back=[(0.0, 40.0), (1.0, 40.0)]
    )
    force = Force(at=travel.output.name, direction=-zero, by_displacement=gas)
    variant = stating(read("slider_crank_offset"), loads=Loads(0j, forces=(force,)), readings={})
    of = machine_of(course.solve(variant))
    area = 0.3 * 500 + 0.7 * 100 - 40
    assert of.panels.total(of.whole_moment) == pytest.approx(area * travel.stroke, rel=1e-12)


def test_breaks_of_loads_by_angle_are_edges():
    force = Force(at="B", direction=-1 + 0j, by_angle=[(0.0, 0.0), (1.0, 100.0), (2.0, 0.0)])
    variant = stating(read("crank_rocker"), loads=Loads(forces=(force,)), readings={})
    of = machine_of(course.solve(variant))
    assert {1.0, 2.0} <= set(of.panels.edges)


def test_a_force_against_the_motion_breaks_where_its_point_turns_back():
    force = Force(at="B", direction="against", constant=50.0)
    variant = stating(read("crank_rocker"), loads=Loads(0j, forces=(force,)), readings={})
    results = course.solve(variant)
    of = machine_of(results)
    stops = [
        x.turned
        for t in results.lever.kinematics.travels
        for x in (t.near, t.far)
        if t.output.kind == "rocker"
    ]
    assert stops
    for stop in stops:
        assert np.min(np.abs(of.panels.edges - stop)) < 1e-9
    # the force takes energy all the time, and its work is the force by the path of its point
    path = of.panels.total(np.abs(of.motion.velocity("B")).reshape(of.panels.shape)) / of.omega
    assert of.panels.total(of.whole_moment) == pytest.approx(-50 * path, rel=1e-12)


def test_a_driving_link_that_only_swings_has_no_steady_motion():
    with pytest.raises(ProblemError, match="makes no full turn"):
        machine_of(solved("tangent"))


def test_of_a_mechanism_that_does_not_close_all_round_the_rest_is_solved_and_what_is_left_out_is_said():
    variant = read("compressor")
    links = variant.lever.mechanism.links
    short = replace(links["4"], points={**links["4"].points, "D": 0.05 + 0j})
    mechanism = replace(variant.lever.mechanism, links={**links, "4": short})
    drawing = replace(variant.lever.drawing, force=None)
    results = course.solve(stating(variant, mechanism=mechanism, drawing=drawing, readings={}))
    assert results.lever.partial and results.drive is not None
    assert results.flywheel is None and results.balancing is None
    said = [str(line) for line in course.summary(results)]
    assert "left out, as the mechanism does not close over the whole cycle: flywheel, balancing" in said
    assert not [line for line in course.summary(solved("compressor")) if "left out" in str(line)]
