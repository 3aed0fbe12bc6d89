"""A cam alone that takes its speed and its sense from the drive's output shaft."""

import math

import pytest

from tmm_report import course, loading, render
from tmm_report.problems import ProblemError

DRIVE = """language: en
drive:
  speed: 960 rpm
  output: other
  stages:
    - {{kind: spur, ratio: -2, module: 4 mm, teeth: [20, 40], efficiency: 0.97}}
    - {{kind: spur, ratio: {ratio}, module: 4 mm, teeth: [20, {teeth}], efficiency: 0.97}}
"""
CAM = """cam:
  roller: 20 mm
  base: smallest
  offset: 12 mm
  lift: 45 mm
  mass: 1.6 kg
  spring: {{ratio: 0.4, reserve: 1.4}}
  phases: [{{rise: 100 deg, law: sine}}, {{dwell: 40 deg}}, {{return: 80 deg, law: cosine}}, {{dwell: rest}}]
  {speed}
"""


def text(speed="speed: drive", ratio=-4, teeth=80):
    return DRIVE.format(ratio=ratio, teeth=teeth) + CAM.format(speed=speed)


def solved(said):
    return course.solve(loading.loads(said))


def told(said):
    with pytest.raises(ProblemError) as raised:
        loading.loads(said)
    return [(".".join(map(str, one.path)), one.wrong.text) for one in raised.value.problems]


@pytest.mark.parametrize(("ratio", "teeth", "sense"), [(-4, 80, 1), (-2.5, 50, 1), (3, 60, -1)])
def test_the_cam_has_the_speed_and_the_sense_of_the_output(ratio, teeth, sense):
    found = solved(text(ratio=ratio, teeth=teeth))
    turn = found.cam.cams[0].turn
    assert turn.omega == pytest.approx(960 / 2 / abs(ratio) * math.pi / 30)
    assert turn.sense == sense
    assert turn.sense * turn.omega == pytest.approx(found.drive.speed[found.drive.output])


def test_the_forces_are_those_of_a_cam_with_that_speed_stated():
    """The same cam with its speed as a number, found by hand: 960/(2·4) = 120 rpm."""
    linked, stated = (solved(text(speed)).cam_forces for speed in ("speed: drive", "speed: 120 rpm"))
    assert linked.loaded.omega == pytest.approx(stated.loaded.omega)
    for one, other in zip(
        (linked.loaded.spring.rate, linked.torque[0].value, linked.torque[1].value),
        (stated.loaded.spring.rate, stated.torque[0].value, stated.torque[1].value),
        strict=True,
    ):
        assert one == pytest.approx(other, rel=1e-9) and one != 0


def test_the_note_says_what_turns_the_cam_and_a_russian_word_will_do():
    for speed, says in (("speed: drive", True), ("speed: 120 rpm", False), ("speed: привод", True)):
        note = render(solved(text(speed)), "html", "en")["note.html"].decode()
        assert ("The output shaft of the drive turns the cam" in note) == says


def test_a_stated_sense_is_that_of_the_output():
    solved(text("speed: drive\n  rotation: counter-clockwise"))
    found = told(text("speed: drive\n  rotation: clockwise"))
    assert [where for where, _ in found] == ["cam.rotation"] and "turns the other way" in found[0][1]


@pytest.mark.parametrize(
    ("said", "path", "says"),
    [
        ("language: en\n" + CAM.format(speed="speed: drive"), "cam.speed", "and there is no drive"),
        (
            text().replace(
                "  speed: 960 rpm\n  output: other\n",
                "  motors: [[A, 2.2 kW, 1425 rpm], [B, 3 kW, 1435 rpm]]\n"
                "  output: {torque: 20 N*m, speed: 180 rpm}\n",
            ),
            "cam.speed",
            "chosen only when it is solved",
        ),
    ],
)
def test_where_the_drive_gives_no_speed_it_is_told(said, path, says):
    assert [where for where, wrong in told(said) if says in wrong] == [path]


def test_a_mistake_of_the_cam_is_told_once():
    found = told(text().replace("lift: 45 mm", "swing: 20 deg"))
    assert len(found) == len(set(found)) and found
