"""Laws of loads: by position, by angle, indicator diagrams, along and against the motion."""

from dataclasses import replace

import numpy as np
import pytest
from loaded import loaded

from tmm_report.chapters.lever.kinetostatics.given import Force, Loads, Moment
from tmm_report.chapters.lever.kinetostatics.solve import positions as kinetostatics
from tmm_report.chapters.lever.kinetostatics.solve.law_arguments import reading
from tmm_report.mechanics.calculus.laws import ByAngle, ByDisplacement, ByPosition, Constant

TWELVE = tuple(float(x) for x in (5, 1, 4, 2, 8, 0, -3, 7, 6, 2, 9, 1))


@pytest.fixture
def at(compressor):
    """Magnitude of a law at point B at the angles turned, degrees."""
    kinematics = compressor.lever.kinematics

    def magnitude(law, *degrees):
        turned = np.radians(degrees)
        motion = kinematics.cycle.motion(turned)
        return reading(loaded(law), kinematics, motion, turned).value

    return magnitude


def test_constant(at):
    assert at(Constant(3.0), 0, 77, 360) == pytest.approx([3, 3, 3])


def test_by_position_is_linear_between_and_periodic(at):
    law = ByPosition(TWELVE)
    assert at(law, *range(0, 360, 30)) == pytest.approx(TWELVE)
    assert at(law, 45, 345, 360) == pytest.approx([2.5, 3.0, 5.0])


def test_by_angle_is_linear_between_and_periodic(at):
    law = ByAngle(tuple(np.radians([40, 100, 300])), (1.0, 4.0, 2.0))
    assert at(law, 40, 70, 100, 300) == pytest.approx([1, 2.5, 4, 2])
    # from 300 over 360 to 40 degrees: 100 degrees down from 2 to 1
    assert at(law, 350, 0, 10) == pytest.approx([1.5, 1.4, 1.3])


def test_a_load_that_ends_otherwise_than_it_began_rises_over_the_whole_turn(at):
    """A saw: its two values at 0 and 360 degrees are a jump, not one the other's neighbour."""
    law = ByAngle((0.0, 2 * np.pi), (0.0, 100.0))
    assert at(law, 0, 36, 90, 270) == pytest.approx([0, 10, 25, 75])


def test_ranges_are_not_periodic(results):
    cycle = results.lever.kinematics.cycle
    if cycle.closed:
        return
    law = ByAngle((0.0, cycle.sweep), (1.0, 3.0))
    turned = np.array([0.0, cycle.sweep / 2, cycle.sweep])
    found = reading(loaded(law, None), results.lever.kinematics, cycle.motion(turned), turned).value
    assert found == pytest.approx([1, 2, 3])
    by_position = ByPosition((0.0, 1.0, 2.0))  # two table steps, then the last one holds
    step = cycle.sweep / 12
    turned = np.array([0.5, 1, 2, 12]) * step
    found = reading(loaded(by_position, None), results.lever.kinematics, cycle.motion(turned), turned).value
    assert found == pytest.approx([0.5, 1, 2, 2])


def test_indicator_diagram(at, compressor):
    """x = displacement / stroke from the stated extreme; one curve a stroke."""
    law = ByDisplacement(1 + 0j, ((0.0, 100.0), (0.5, 0.0), (1.0, 0.0)), ((0.0, 900.0), (1.0, 500.0)))
    S = (
        compressor.lever.kinematics.table.place("B").real[0]
        - compressor.lever.kinematics.table.place("B").real
    )
    x = S / 0.2
    expected = [np.interp(x[k], [0, 0.5, 1], [100, 0, 0]) if k < 6 else 900 - 400 * x[k] for k in range(12)]
    found = at(law, *range(0, 360, 30))
    assert found == pytest.approx(expected)
    # counted from the other extreme, forward is the way back
    other = ByDisplacement(-1 + 0j, ((0.0, 500.0), (1.0, 900.0)), ((0.0, 0.0), (0.5, 0.0), (1.0, 100.0)))
    inner = [k for k in range(12) if k % 6]
    assert at(other, *range(0, 360, 30))[inner] == pytest.approx(found[inner])


def test_at_the_ends_of_the_stroke_the_stroke_that_begins_holds(results):
    """Whatever the rounding of the velocity's zero, and in every drawing."""
    law = ByDisplacement(1 + 0j, ((0.0, 1.0), (1.0, 2.0)), ((0.0, 3.0), (1.0, 4.0)))
    for travel in results.lever.kinematics.travels:
        if travel.output.kind == "slider" and results.lever.kinematics.cycle.closed:
            name, direction = travel.output.name, travel.output.direction
            far, near = travel.far.turned, travel.near.turned
            turned = np.array([0.3, far, near, 1.0])
            motion = results.lever.kinematics.cycle.motion(turned)
            aimed = replace(law, zero=direction)
            found = reading(loaded(aimed, name), results.lever.kinematics, motion, turned).value
            assert found[1:3] == pytest.approx([1.0, 4.0])


def test_along_and_against_the_motion(results):
    kinematics = results.lever.kinematics
    point = next(p for p in kinematics.table.point_index if np.abs(kinematics.table.velocity(p)).max() > 0)
    link = kinematics.linkage.groups[0].links[0]
    given = Loads(
        0j,
        (
            Force(at=point, direction="along", constant=2.0),
            Force(at=point, direction="against", constant=5.0),
        ),
        (
            Moment(on=link, direction="along", constant=2.0),
            Moment(on=link, direction="against", constant=3.0),
        ),
    )
    load = kinetostatics.loading(given, kinematics, kinematics.table, kinematics.turned)
    v, w = kinematics.table.velocity(point), kinematics.table.angular_velocity(link)
    assert np.real(np.conj(v) * load.forces[0]) == pytest.approx(2 * np.abs(v), abs=1e-9)
    assert np.real(np.conj(v) * load.forces[1]) == pytest.approx(-5 * np.abs(v), abs=1e-9)
    assert w * load.moments[0] == pytest.approx(2 * np.abs(w), abs=1e-9)
    assert w * load.moments[1] == pytest.approx(-3 * np.abs(w), abs=1e-9)


def test_what_stands_still_has_no_direction_of_motion(compressor):
    kinematics = compressor.lever.kinematics
    given = Loads(0j, (Force(at="B", direction="against", constant=2.0),))
    load = kinetostatics.loading(given, kinematics, kinematics.table, kinematics.turned)
    expected = [0, 2, 2, 2, 2, 2, 0, 2, 2, 2, 2, 2, 0]
    assert np.abs(load.forces[0]) == pytest.approx(expected)


def test_a_load_at_a_shared_point_acts_on_the_slider(compressor):
    motion = compressor.lever.kinematics.table
    forces = [Force(at=point, direction=1j, constant=1.0) for point in ("B", "A", "S2")]
    taken = {force.at: kinetostatics.loaded_link(motion, force) for force in forces}
    assert taken == {"B": "3", "A": "1", "S2": "2"}
