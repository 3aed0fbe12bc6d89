"""What a drive states amiss of its machine, motor and shafts: said once, by key, with what would be right."""

import pytest

from tmm_report import course, loading
from tmm_report.problems import ProblemError

STAGE = "{kind: spur, ratio: -3, teeth: [20, 60], module: 3 mm}"
OPEN = "{kind: spur, teeth: [20, rest], module: 3 mm}"
DRUM = "output: {force: 3.2 kN, speed: 0.85 m/s, diameter: 315 mm}"
MOTOR = "motors: [[a, 4 kW, 155 rpm]]"
MECHANISM = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 350 mm}}
    3: {points: [B], slides: x}
  driver: {link: 1, speed: SPEED}
  assembly: {B: right}
"""
LOADS = "loads: {forces: [{at: B, direction: against motion, constant: 500 N}]}\n"


def lines(keys, stage=STAGE, before=""):
    text = before + "drive:\n" + "".join(f"  {key}\n" for key in keys) + f"  stages: [{stage}]\n"
    try:
        course.solve(loading.loads(text))
    except ProblemError as error:
        return [problem.text() for problem in error.problems]
    return []


SAID = [
    ([], "drive: how fast the drive is turned is not stated; state speed: 1450 rpm"),
    (["speed: 90 rpm", MOTOR, DRUM], "drive.speed: the speed of the drive is that of its motor"),
    (["speed: 90 rpm", "bearings: 0.99"], "drive.bearings: nothing is asked of a motor"),
    (["speed: 90 rpm", "shafts: {by: rated}", DRUM], "drive.shafts.by: no motor is stated whose rated power"),
    (["speed: 90 rpm", "torque: 5 N*m", DRUM], "drive.torque: the torque on the input shaft follows from the power"),
    ([MOTOR, DRUM, "ratio_range: [9, 3]"], "drive.ratio_range: the range from 9 to 3 is empty"),
    ([MOTOR, DRUM, "needed: greatest"], "drive.needed: the drive turns no driving link"),
    (["speed: 90 rpm", "output: {diameter: 0.3}"], "drive.output: neither the load of the machine nor a motor"),
    (["speed: 90 rpm", "output: {force: 9}"], "drive.output: the diameter of the drum is not stated, so the torque"),
    (["speed: 90 rpm", "output: {power: 9, speed: 2 m/s}"], "the diameter of the drum is not stated, so the speed"),
    (["speed: 90 rpm", "output: {force: 9, torque: 3}"], "the load is stated twice: force, torque"),
    (["speed: 90 rpm", "output: {power: 3, teeth: 9}"], "a sprocket has teeth and a pitch"),
    (["speed: 90 rpm", "output: {power: 3, speed: 0 rpm}"], "is not more than zero"),
    (["speed: 90 rpm", "output: {force: -3, diameter: 1}"], "is not more than zero"),
    (["speed: 90 rpm", "output: {force: 3 mm, diameter: 1}"], "drive.output.force"),
    (["speed: 90 rpm", "output: [3]"], "crank, other or a machine"),
    ([MOTOR, DRUM, "bearings: [0.99]"], "the efficiency of a pair, or {efficiency: 0.99, pairs: [0, 1, 1]}"),
    ([MOTOR, DRUM, "bearings: 1.2"], "drive.bearings: 1.2 is out of range"),
    ([MOTOR, DRUM, "split: {slow: 0.88, fast: 1}"], "drive.split: one rule divides the ratio"),
    ([MOTOR, DRUM, "split: {slow: 99}"], "99 is out of range: from 0.05 to 20 is expected"),
    ([MOTOR, DRUM, "split: evenly"], "drive.split"),
    ([MOTOR, DRUM, "shafts: {torque: 9549}"], "drive.shafts.torque"),
    (["motors: [[a, 0 kW, 9 rpm]]", DRUM], "drive.motors.0.1"),
    (["motors: [[a, 4 kW]]", DRUM], "drive.motors.0"),
]  # fmt: skip


@pytest.mark.parametrize(("keys", "said"), SAID)
def test_it_is_said_once(keys, said):
    found = lines(keys)
    assert len([line for line in found if said in line]) == 1, found
    assert len(found) == 1, found


OF_TEETH = [
    (
        "{kind: spur, teeth: [20, rest], module: 3 mm}",
        "the teeth of the other wheel are sought, and its ratio",
    ),
    ("{kind: spur, teeth: [rest, rest], module: 3 mm}", "the teeth of both wheels are sought by one ratio"),
    (
        "{kind: spur, ratio: -50, teeth: [60, rest], module: 3 mm}",
        "the ratio gives the other wheel 3000 teeth",
    ),
]


@pytest.mark.parametrize(("stage", "said"), OF_TEETH)
def test_teeth_that_are_sought(stage, said):
    (line,) = lines(["speed: 90 rpm"], stage)
    assert said in line


def test_the_rest_by_a_stated_ratio():
    text = "drive: {speed: 90 rpm, stages: [{kind: spur, ratio: -3.3, teeth: [17, rest], module: 3 mm}]}"
    (stage,) = course.solve(loading.loads(text)).drive.stages
    assert stage.teeth.z == (17, 56) and stage.wanted == -3.3


def test_a_differential_has_no_one_motor():
    stage = (
        "{kind: planetary, ratio: 6.56, module: 5 mm, satellites: 3, teeth: [20, 46, 112], input: sun, "
        "output: carrier, second: {member: ring, speed: 9 rpm}}"
    )
    (line,) = lines([MOTOR, DRUM], stage)
    assert "drive.stages.0.second: a differential divides the power" in line


OF_LINK = [
    (
        "drive",
        ["motors: [[a, 1 kW, 90 rpm], [b, 2 kW, 90 rpm]]"],
        LOADS,
        "state the speed of the driving link",
    ),
    ("30 rpm", ["motors: [[a, 1 kW, 90 rpm], [b, 2 kW, 90 rpm]]"], "", "has no balancing moment with a mean"),
    ("drive", [MOTOR, DRUM], LOADS, "and the drive turns something else"),
]


@pytest.mark.parametrize(("speed", "keys", "loads", "said"), OF_LINK)
def test_of_a_driving_link(speed, keys, loads, said):
    (line,) = lines(keys, before=MECHANISM.replace("SPEED", speed) + loads)
    assert said in line


def test_a_stated_motor_that_is_too_weak_is_a_doubt_and_no_mistake():
    text = "drive:\n  motors: [[a, 2 kW, 155 rpm]]\n  " + DRUM + f"\n  stages: [{STAGE}]\n"
    results = course.solve(loading.loads(text))
    (line,) = [problem.text() for problem in results.drive.doubts if "overloaded" in str(problem.wrong)]
    assert "drive.motors" in line and "2 kW" in line and "by 38.8 %" in line
