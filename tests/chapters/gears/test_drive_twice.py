"""Every formula of a drive as a whole against the solution of all its meshes together."""

import math

import pytest
from notes import VARIANTS
from test_drive import DRIVES, PAIR, PLANETARY, SECOND, solve
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.gears.drive.steps import whole

CARRIER = {key: value for key, value in PLANETARY.items() if key != "fixed"} | {
    "second": {"member": "carrier", "speed": "-200 rpm"}, "output": "ring", "ratio": -5.6,
}  # fmt: skip
MORE = {
    "differential to the sun": [SECOND | {"input": "carrier", "output": "sun", "ratio": 1 / 6.56}, PAIR],
    "differential to the ring": [CARRIER],
}
ALL = {**DRIVES, **MORE}
LINKED = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 350 mm}}
    3: {points: [B], slides: x, mass: 2 kg, mass_centre: B}
  driver: {link: 1, speed: drive}
  assembly: {B: right}
loads:
  forces:
    - name: load
      at: B
      direction: left
      by_displacement: {zero: left, forward: [[0, 500], [1, 500]], back: [[0, -500], [1, -500]]}
drive:
  speed: 960 rpm
  stages: [{kind: spur, ratio: -4, module: 4 mm, teeth: [20, 80], efficiency: 0.97}]
"""


@pytest.mark.parametrize("name", ALL)
def test_every_formula_agrees_with_the_second_way(name):
    assert told(solve(*ALL[name])) == []


def test_every_formula_of_a_drive_that_turns_the_link():
    found = course.solve(loading.loads(LINKED)).drive
    assert whole(found, "drive").s.has_formula("T_mean") and told(found) == []


def test_a_stated_torque_is_not_called_that_of_the_mean_moment():
    """The drive that turns the link and has its own torque: the note would set one beside the formula of the other."""
    found = course.solve(loading.loads(LINKED.replace("drive:\n", "drive:\n  torque: 50 N*m\n"))).drive
    s = whole(found, "drive").s
    assert found.given.torque == 50 and not found.asked and told(found) == []
    assert "T_mean" not in s and s.number("M_mean") == pytest.approx(31.830988618379067)
    assert found.loads.torque[found.input] == pytest.approx(50)


@pytest.mark.parametrize("name", ["compressor", "drum_motor", "hoist_drive"])
def test_every_formula_of_a_ready_variant(name):
    assert told(course.solve(loading.load(VARIANTS / f"{name}.yaml")).drive) == []


def told(found):
    made = whole(found, "drive")
    wrong = disagreements(made.s, _ways(found), formed=True)
    for name, row in made.members.items():
        wrong += disagreements(row, {"omega": found.speed[name]}, formed=True)
    return wrong


def _ways(found):
    """By the speeds of the train, and the powers that go in and come out."""
    plans, wanted = found.plans, math.prod(stage.wanted for stage in found.stages)
    read, exact = (plans.segment(found.input), plans.segment(found.output)), found.ratio
    given, taken = (sum(found.loads.power[name] for name in names) for names in (found.supplied, found.taken))
    ways = {
        "u_required": wanted, "u_teeth": found.geared, "u": exact, "delta_u": 100 * (found.geared - wanted) / wanted,
        "h": plans.velocity_scale / plans.length_scale / plans.angular_scale, "eta": -taken / given,
        "laid": abs(found.speed[found.input] * found.arm) / plans.velocity_scale,
    }  # fmt: skip
    if found.runs and read[1]:
        graph = read[0] / read[1]
        error = 200 * (graph / exact - 1) / (graph / exact + 1)
        ways |= {"u_graph": graph, "error": error if abs(error) > 1e-9 else 0.0}
    if found.moments is not None:
        over = -found.loads.power[found.output] / abs(found.speed[found.output])  # torque of the output
        ways |= {"T_mean": found.given.torque * found.moments.mean / over, "peak": found.moments.peak}
    return ways
