"""Loads by the time: at constant speed the same as by the angle turned; their jumps; what is refused."""

import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.problems import ProblemError

TEXT = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O, angle: 0 deg}}
  links:
    1: {points: {O: [0, 0], A: [80 mm, 0]}}
    2: {points: {A: [0, 0], B: [300 mm, 0]}, mass: 1.5 kg, inertia: m*l^2/12}
    3: {points: {B: [0, 0]}, slides: x, mass: 5 kg, mass_centre: B}
  driver: {link: 1, SPEED}
  assembly: {B: right}
loads:
  forces: [{at: B, direction: left, FORCE}]
  moments: [{on: 2, direction: clockwise, MOMENT}]
"""
POINTS = [(0.0, 40.0), (0.02, 300.0), (0.05, 300.0), (0.05, -100.0), (0.08, 20.0)]
MOMENTS = [(0.0, 0.0), (0.03, 4.0), (0.06, 0.0)]


def stated(key, points, size=1.0, unit="s"):
    return f"{key}: [" + ", ".join(f"[{x * size!r} {unit}, {y}]" for x, y in points) + "]"


def variant(speed, force, moment, more=""):
    text = TEXT.replace("SPEED", speed).replace("FORCE", force).replace("MOMENT", moment)
    return loading.loads(text + more)


def solved(speed, key, size, unit):
    found = course.solve(variant(speed, stated(key, POINTS, size, unit), stated(key, MOMENTS, size, unit)))
    return found.lever.kinetostatics


@pytest.mark.parametrize(
    "speed", ["speed: 20 pi rad/s", "period: 0.1 s", "period: 0.1 s, rotation: clockwise"]
)
def test_at_constant_speed_a_time_is_an_angle(speed):
    speed = speed.replace("20 pi", repr(20 * np.pi))
    by_time, by_angle = solved(speed, "by_time", 1, "s"), solved(speed, "by_angle", 3600.0, "deg")
    for one, other in ((by_time.table, by_angle.table), (by_time.diagram, by_angle.diagram)):
        assert one.loading.stated[0] == pytest.approx(other.loading.stated[0], abs=1e-6)
        assert one.balancing == pytest.approx(other.balancing, abs=1e-6)
    assert [end.value for end in by_time.extremes] == pytest.approx([end.value for end in by_angle.extremes])
    assert by_time.worst_power < 1e-9
    assert abs(by_time.works.whole) < 1e-9 * by_time.works.size


def test_of_a_law_the_time_is_its_own():
    law = "law: {speed: 62.83185307179586 rad/s, harmonic: {amplitude: 0.4 rad}}"
    forces = solved(law, "by_time", 1, "s")
    t = np.arange(13) / 120
    places = [0.0, 0.02, 0.05, np.nextafter(0.05, 1), 0.08, 0.1]
    wanted = np.interp(np.mod(t, 0.1), places, [40.0, 300.0, 300.0, -100.0, 20.0, 40.0])
    away = np.abs(t - 0.05) > 1e-9
    assert forces.table.loading.stated[0][away] == pytest.approx(wanted[away], abs=1e-9)
    assert forces.worst_power < 1e-9


def test_a_jump_is_met_from_both_sides():
    over = solved("period: 0.1 s", "by_time", 1, "s").over
    load = over.on(over.loading.stated[0])
    edge = int(np.argmin(np.abs(over.panels.edges - np.pi)))
    assert over.panels.edges[edge] == pytest.approx(np.pi, abs=1e-9)
    assert load[edge - 1].min() > 299.0 and load[edge].max() < 21.0


CONSTANT = "constant: 1"
SLIPS = {
    "by_time: [[0, 1], [0.11 s, 2]]": "0.11 s is beyond the cycle, which takes 0.1 s",
    "by_time: [[0, 1], [0.02 s, 2]]": "nothing is stated from 0.02 to 0.1 s, where the next cycle begins",
    "by_time: [[0.02 s, 1], [0.01 s, 2]]": "the first numbers of the pairs must ascend",
    "by_time: [[0.02 m, 1]]": "a time",
}


@pytest.mark.parametrize("force", SLIPS)
def test_slips(force):
    with pytest.raises(ProblemError) as caught:
        variant("period: 0.1 s", force, CONSTANT)
    (problem,) = caught.value.problems
    assert problem.key.startswith("loads.forces.0.by_time")
    assert SLIPS[force] in problem.text()


def test_a_law_that_does_not_repeat_wants_its_whole_time():
    law = "law: {speed: 5 rad/s, acceleration: 4 rad/s^2, time: 1 s}"
    with pytest.raises(ProblemError) as caught:
        variant(law, "by_time: [[0, 1], [0.1 s, 2]]", CONSTANT)
    assert "nothing is stated from 0.1 to 1" in caught.value.problems[0].text()


def test_dynamics_takes_none():
    dynamics = "dynamics: {inertia: 5 kg*m^2, start: {speed: 10 rad/s, time: 1 s}}\n"
    with pytest.raises(ProblemError) as caught:
        variant("period: 0.1 s", stated("by_time", POINTS), CONSTANT, dynamics)
    assert any("has no place in dynamics" in problem.text() for problem in caught.value.problems)
