"""What textbooks have and the program lacks is known: it is not offered, and what is nearest is named."""

import pytest

from tmm_report import course
from tmm_report.problems import ProblemError

TEXT = """language: en
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links: {1: {points: {O: 0, A: 1}}, 2: {points: {A: 0, B: 3}}, 3: {points: [B], slides: x}}
  driver: {link: 1, speed: 1}
  assembly: {B: right}
loads:
  forces: [{at: B, direction: left, constant: 1}]
  moments: [{on: 2, direction: clockwise, constant: 1}]
"""
SLIPS = {
    "mechanism.driver.acceleration": ("speed: 1}", "speed: 1, acceleration: 2}", "if not uniformly, stands under law"),
    "mechanism.driver.link": ("link: 1,", "link: 3,", "a driving slider is stated with its stroke"),
    "mechanism.gears": ("  assembly:", "  gears: []\n  assembly:", "mechanism.wheels"),
    "mechanism.belts": ("  assembly:", "  belts: []\n  assembly:", "stages of the block drive"),
    "mechanism.links.3.rolls": ("slides: x", "slides: x, rolls: x", "rolling on a guide is not offered"),
    "mechanism.springs": ("  assembly:", "  springs: []\n  assembly:", "loads.springs"),
    "mechanism.links.3.rack": ("slides: x", "slides: x, rack: {module: 4 mm}", "mechanism.racks"),
    "mechanism.links.3.teeth": ("slides: x", "slides: x, teeth: 20", "mechanism.wheels"),
    "loads.spring": ("loads:\n", "loads:\n  spring: {}\n", "stand in lists"),
    "loads.torsional_springs": ("loads:\n", "loads:\n  torsional_springs: []\n", "in the list torsion_springs"),
    "loads.torsional_dampers": ("loads:\n", "loads:\n  torsional_dampers: []\n", "that turn links are not offered"),
    "loads.moments.0.by_velocity": ("clockwise, constant: 1", "clockwise, by_velocity: [[0, 1]]", "by the speed"),
    "gears": ("loads:\n", "gears: [20, 40]\nloads:\n", "stages of the block drive"),
}  # fmt: skip


@pytest.mark.parametrize("key", SLIPS)
def test_what_is_not_offered_says_so(key):
    right, wrong, words = SLIPS[key]
    assert TEXT.count(right) == 1
    with pytest.raises(ProblemError) as caught:
        course.loads(TEXT.replace(right, wrong))
    told = {problem.key: problem.text() for problem in caught.value.problems}
    assert words in told[key]


def test_the_text_itself_is_right():
    assert course.loads(TEXT).lever is not None
