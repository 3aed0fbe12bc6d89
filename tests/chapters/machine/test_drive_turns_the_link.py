"""`speed: drive`: the driving link turned by the gear drive, its balancing moment in the gears, or both at odds."""

import math
from dataclasses import replace

import numpy as np
import pytest
from notes import render

from tmm_report import course, loading
from tmm_report.problems import ProblemError

MECHANISM = """
mechanism:
  frame: {{O: [0, 0]}}
  guides: {{x: {{through: O}}}}
  links:
    1: {{points: {{O: 0, A: 100 mm}}}}
    2: {{points: {{A: 0, B: 350 mm}}}}
    3: {{points: [B], slides: x, mass: 2 kg, mass_centre: B}}
  driver: {{link: 1, {driver}}}
  assembly: {{B: right}}
loads:
  forces:
    - name: load
      at: B
      direction: left
      by_displacement: {{zero: left, forward: [[0, 500], [1, 500]], back: [[0, -500], [1, -500]]}}
"""
DRIVE = """
drive:
  speed: 960 rpm
  stages: [{{kind: spur, ratio: {ratio}, module: 4 mm, teeth: [{teeth}], efficiency: 0.97}}]
"""


def text(driver, ratio=-4, teeth="20, 80", extra=""):
    return MECHANISM.format(driver=driver) + DRIVE.format(ratio=ratio, teeth=teeth) + extra


def solved(*args, **kwargs):
    return course.solve(loading.loads(text(*args, **kwargs)))


@pytest.mark.parametrize("word", ["drive", "привод"])
def test_the_link_takes_the_speed_and_the_sense_of_the_output(word):
    found = solved(f"speed: {word}")
    omega = found.lever.given.mechanism.driver.omega
    assert omega == pytest.approx(-960 / 4 * math.pi / 30) == found.drive.speed[found.drive.output]
    assert solved(f"speed: {word}", ratio=4).lever.given.mechanism.driver.omega > 0


FRICTION = "friction: {pivots: {coefficient: 0.1, diameter: 60 mm}, guides: {coefficient: 0.15}}\n"


@pytest.mark.exhaustive
def test_friction_of_the_pairs_loads_the_drive():
    """By its dense mean and, of the greatest moment, by a fine table; `friction: false` leaves it out."""
    said = "language: en\n" + text("speed: drive", extra=FRICTION)
    found, without = (
        course.solve(loading.loads(said.replace("  speed: 960", f"{more}  speed: 960")))
        for more in ("", "  friction: false\n")
    )
    left, plain = without.drive, solved("speed: drive").drive
    lever, moments = found.lever, found.drive.moments
    omega = abs(lever.kinematics.omega)
    assert moments.mean * omega == pytest.approx(
        plain.moments.mean * omega + lever.friction.mean_power, rel=1e-9
    )
    assert found.drive.given.torque == pytest.approx(moments.mean / (4 * 0.97))
    positions = replace(lever.given.positions, diagram=720)
    fine = course.solve_lever(replace(lever.given, positions=positions))
    sense = math.copysign(1, lever.kinematics.omega)
    whole = sense * fine.kinetostatics.diagram.balancing + fine.friction.diagram.reduced
    assert moments.greatest == pytest.approx(whole[np.abs(whole).argmax()], rel=1e-3)
    assert left.moments.mean == pytest.approx(plain.moments.mean)
    assert left.moments.greatest == pytest.approx(plain.moments.greatest)
    for one, words in ((found, "is included in both, "), (without, "is included in neither")):
        assert words in render(one, "html")["note.html"].decode()


@pytest.mark.parametrize(("rotation", "sign"), [("clockwise", -1), ("counter-clockwise", 1)])
@pytest.mark.parametrize("ratio", [-4, 4])
def test_a_stated_sense_turns_the_input_to_suit(rotation, sign, ratio):
    found = solved(f"speed: drive, rotation: {rotation}", ratio=ratio)
    omega = found.lever.given.mechanism.driver.omega
    assert math.copysign(1, omega) == sign
    assert found.drive.speed[found.drive.output] == pytest.approx(omega)


def test_the_teeth_make_the_speed_not_the_wanted_ratio():
    """21 and 80 teeth for a ratio of 4 within the tolerance."""
    found = solved("speed: drive", ratio=-3.9, teeth="21, 80")
    assert abs(found.lever.given.mechanism.driver.omega) == pytest.approx(960 * 21 / 80 * math.pi / 30)


def test_the_balancing_moment_loads_the_drive():
    """Mean power of the link over the efficiency is that of the input; every mesh carries what its wheel turns with."""
    found = solved("speed: drive").drive
    moment, torque = found.moments.mean, found.given.torque
    assert moment > 0 and torque == pytest.approx(moment / (4 * 0.97))
    assert float(found.loads.power[found.output]) == pytest.approx(-moment * 24 * math.pi / 3)
    tables = {table.name: table for table in course.room("drive", "quantities").tables(found)}
    force = float(tables["drive_teeth"]["F_t_mean"].values[0])
    assert force == pytest.approx(torque / 0.04, rel=1e-9)
    greatest = float(tables["drive_teeth"]["F_t_greatest"].values[0])
    assert greatest == pytest.approx(force * abs(found.moments.greatest) / moment)


def test_satellites_share_the_force():
    """(20 + 112)/20 is the ratio; each of three satellites takes a third of what the wheel's torque makes."""
    stage = """
drive:
  speed: 960 rpm
  stages: [{kind: planetary, ratio: 6.6, module: 5 mm, teeth: [20, 46, 112], satellites: 3, input: sun,
            output: carrier, fixed: ring}]
"""
    found = course.solve(loading.loads(MECHANISM.format(driver="speed: drive") + stage)).drive
    tables = {table.name: table for table in course.room("drive", "quantities").tables(found)}
    along, across = (tables["drive_teeth"][key].values[0] for key in ("F_t_mean", "F_r_mean"))
    assert along == pytest.approx(found.given.torque / 0.05 / 3)
    assert across == pytest.approx(along * math.tan(math.pi / 9))


def test_the_mean_moment_is_the_work_of_the_load_over_a_turn():
    """Against the motion 500 N over two strokes of 200 mm: 200 J in a turn, inertia gives nothing on the whole."""
    assert solved("speed: drive").drive.moments.mean == pytest.approx(200 / (2 * math.pi), rel=1e-6)


def test_a_stated_torque_stays():
    stated = text("speed: drive").replace("  speed: 960 rpm", "  speed: 960 rpm\n  torque: 7 N*m")
    assert course.solve(loading.loads(stated)).drive.given.torque == 7


def test_a_link_stated_to_turn_otherwise_is_told_with_both_numbers_and_the_cure():
    (doubt,) = course.doubts(solved("speed: 100 rpm"))
    assert doubt.doubt and doubt.path == ("mechanism", "driver", "speed")
    assert "240 rpm" in str(doubt.wrong) and "100 rpm" in str(doubt.wrong)
    assert "ratio 9.6" in str(doubt.right) and "speed: drive" in str(doubt.right)
    (doubt,) = course.doubts(solved("period: 0.6 s"))
    assert doubt.path[-1] == "period"


@pytest.mark.parametrize(
    "driver", ["speed: 240 rpm", "speed: 232 rpm", "speed: 240 rpm, rotation: clockwise"]
)
def test_what_agrees_within_the_tolerance_is_not_told(driver):
    assert not course.doubts(solved(driver))


def test_a_sense_that_is_stated_against_the_drive_is_told():
    (doubt,) = course.doubts(solved("speed: 240 rpm, rotation: counter-clockwise"))
    assert doubt.path[-1] == "rotation" and "speed: drive" in str(doubt.right)


def test_a_drive_that_turns_something_else_is_left_alone():
    apart = text("speed: 100 rpm").replace("  speed: 960 rpm", "  speed: 960 rpm\n  output: other")
    assert not course.doubts(course.solve(loading.loads(apart)))
    with pytest.raises(ProblemError, match="turns something else"):
        loading.loads(apart.replace("speed: 100 rpm", "speed: drive"))


def test_without_a_drive_there_is_no_speed_to_take():
    with pytest.raises(ProblemError, match="there is no drive"):
        loading.loads(MECHANISM.format(driver="speed: drive"))


def test_teeth_that_cannot_be_found_are_told_at_the_door():
    with pytest.raises(ProblemError) as caught:
        loading.loads(
            MECHANISM.format(driver="speed: drive")
            + """
drive:
  speed: 960 rpm
  stages: [{kind: planetary, ratio: 500, module: 4 mm, input: sun, output: carrier}]
"""
        )
    assert caught.value.problems[0].path[:3] == ("drive", "stages", 0) and caught.value.problems[0].line
