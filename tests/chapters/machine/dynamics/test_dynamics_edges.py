"""The machine in motion at its edges: loads that jump, machines that wait, ends that are the beginning."""

from __future__ import annotations

import math

import numpy as np
import pytest
from notes import VARIANTS
from test_dynamics_chapter import alone, book, refused

from tmm_report import course, loading, note
from tmm_report.figures.drawing import Path
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

STATED = (VARIANTS / "piston_pump.yaml").read_text("utf-8").split("\ndynamics:")[0]
ENGINE = (VARIANTS / "engine_four_stroke.yaml").read_text("utf-8").split("\nflywheel:")[0]


def test_a_load_that_acts_through_a_quarter_of_the_turn_swings_the_speed_by_its_work():
    found = alone("""
  parts: [{name: flywheel, inertia: 20}]
  motor: {constant: 100}
  resistance: [{by_angle: [[0, 0], [90 deg, 0], [90 deg, 400], [180 deg, 400], [180 deg, 0]]}]
  speed: 20
  steady: true
""").steady
    (_, least), (_, greatest) = found.extremes
    assert (greatest, least) == pytest.approx((math.pi / 2, math.pi))
    assert found.delta == pytest.approx(100 * 1.5 * math.pi / (20 * 20**2), rel=1e-9)


def test_a_load_that_rises_through_the_turn_is_least_at_its_beginning():
    found = alone("""
  parts: [{name: flywheel, inertia: 20}]
  motor: {constant: 50}
  resistance: [{by_angle: [[0, 0], [360 deg, 100]]}]
  speed: 20
  steady: true
""").steady
    (_, least), (_, greatest) = found.extremes
    assert greatest == pytest.approx(math.pi) and math.sin(least) == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize("points", ["[[85 deg, 2], [270 deg, 3]]", "[[0, 2], [180 deg, 3], [360 deg, 2]]"])
def test_an_inertia_by_angle_has_everywhere_the_slope_of_its_own_piece(points):
    found = alone(f"""
  varying_inertia: {points}
  resistance: [{{friction: 1}}]
  start: {{begin: 20, angle: 720 deg}}
""").start
    place, period = found.phi, 2 * math.pi
    after, before = (np.interp((place + h) % period, found.plant.panels.x.ravel(), found.plant.inertia.ravel())
                     for h in (0.02, -0.02))  # fmt: skip
    slope = found.plant.panels.at(found.plant.slope, place)
    inside = (
        np.abs((place + 0.3) % (math.pi / 2) - 0.3) > 0.25
    )  # away from the corners and from the edge of the cycle
    assert slope[inside] == pytest.approx(((after - before) / 0.04)[inside], abs=1e-6)
    numbers = np.gradient(found.omega, found.t)
    assert numbers[inside][2:-2] == pytest.approx(found.epsilon[inside][2:-2], abs=0.3)


def test_a_motor_too_weak_to_start_under_its_load_drives_it_once_it_runs():
    text = """
  parts: [{name: rotor, inertia: 3, moment: 60}]
  motor: {induction: {synchronous: 157, max_moment: 200, critical_slip: 0.1}}
"""
    found = alone(text + "  coast: {}")
    slip = 0.1 * (200 / 60 - math.sqrt((200 / 60) ** 2 - 1))
    assert found.steady.mean == pytest.approx(157 * (1 - slip))
    assert found.coast.t[-1] == pytest.approx(3 * found.steady.mean / 60)
    (said,) = refused(text + "  start: {}")
    assert "does not start" in said


def test_a_name_plate_with_the_resistance_of_the_stator_is_kept_to():
    found = alone("""
  parts: [{name: rotor, inertia: 3, moment: 100}]
  motor: {induction: {moment: 100, speed: 1450 rpm, synchronous: 1500 rpm, overload: 2.5, stator: 1.5}}
  start: {}
""")
    assert found.steady.mean == pytest.approx(1450 * math.pi / 30)


def test_a_motor_whose_moment_grows_from_nil_starts_when_it_overcomes_the_friction():
    text = """
  parts: [{name: rotor, inertia: 2}]
  motor: {by_time: [[0, 0], [2, 40], [4, 0]]}
  resistance: [{friction: FRICTION}]
  start: {time: END}
"""
    found = alone(text.replace("FRICTION", "5").replace("END", "6")).start
    assert found.t[0] == pytest.approx(0.25) and found.omega[0] == 0
    assert found.omega[-1] == pytest.approx((10 * (4 - 0.0625) - 5 * 1.75 + 70 - 40 - 10) / 2, rel=1e-8)
    assert "does not start" in refused(text.replace("FRICTION", "41").replace("END", "6"))[0]
    assert "stops on the way" in refused(text.replace("FRICTION", "5").replace("END", "0.2"))[0]


SHUNT = """
  parts: [{name: rotor, inertia: 3, moment: 10}]
  motor: {shunt: {moment: 100, speed: 140, no_load: 150}}
"""


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (SHUNT + "  start: {begin: 50, speed: 50}", "there is no start-up"),
        (SHUNT + "  start: {begin: 148.9}", "there is no start-up"),
        (SHUNT + "  start: {within: 100 %}", "out of range"),
        (SHUNT + "  coast: {speed: 149.5}", "not lower"),
        (SHUNT + "  start: {begin: 50, speed: 30}", "the other way"),
        (SHUNT + "  varying_inertia: [[0, 2], [360 deg, 3]]", "jumps from cycle to cycle"),
        (SHUNT + "  varying_inertia: [[0, 2], [400 deg, 3]]", "more than one cycle, which is 360 degrees"),
        (SHUNT + "  resistance: [{by_angle: [[90 deg, 2], [0, 3]]}]", "ascend"),
        (SHUNT + "  resistance: [{by_angle: [[0, 2], [300 deg, 3]]}]\n  period: 180 deg", "which is 180"),
        ("  parts: [{name: a, inertia: 2}]\n  motor: {induction: {moment: 5, speed: 8, synchronous: 10, overload: 4, "
         "stator: 2}}", "no motor has this overload"),
    ],
)  # fmt: skip
def test_an_end_that_is_not_one_and_points_that_reach_too_far_are_told(text, words):
    assert any(words in one for one in refused(text))


def test_a_start_to_a_steady_motion_to_which_nothing_leads_is_refused():
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(STATED + "\ndynamics: {parts: [{name: a, inertia: 14}], start: {}}\n"))
    (said,) = [problem.text() for problem in error.value.problems]
    assert "does not come to its steady motion by itself" in said


def test_the_cycle_of_a_mechanism_is_its_own():
    with pytest.raises(ProblemError) as error:
        loading.loads(
            STATED + "\ndynamics: {parts: [], period: 360 deg, varying_inertia: [[0, 2], [90 deg, 3]]}\n"
        )
    said = [problem.text() for problem in error.value.problems]
    assert sum("are those of the mechanism" in one for one in said) == 2


def test_an_engine_settles_where_its_fan_takes_the_work_of_both_turns():
    text = """
dynamics:
  parts: [{name: flywheel, inertia: 2}]
  resistance: [{fan: {moment: 150, speed: 230}}, {by_angle: [[0, 20], [720 deg, 0]]}]
"""
    found = course.solve(loading.loads(ENGINE + text)).dynamics
    assert "dynamics_M_closing" not in book(found).values
    works = found.steady.works
    assert works["res2"] == pytest.approx(-10 * 4 * math.pi)
    assert works["res1"] == pytest.approx(-150 * (found.steady.mean / 230) ** 2 * 4 * math.pi, rel=1e-3)
    assert works["pairs"] < 0
    acting = ("P_B", "P_D", "res1", "res2", "pairs")
    assert sum(works[key] for key in acting) == pytest.approx(0, abs=1e-7 * works["P_B"])


def test_a_machine_whose_motion_is_not_asked_for_is_drawn_as_its_shaft():
    """In a list of many every variant has a picture."""
    text = "dynamics: {parts: [{name: a, inertia: 2 kg*m^2}, {name: b, inertia: 1 kg*m^2, ratio: 0.5}]}"
    drawn = note.picture(course.solve(loading.loads(text)), Page(Html(), Translator("en"), Numbering()))
    assert sum(isinstance(item, Path) and item.closed for item in drawn.items) == 2


# --- tables over a part of the cycle; jumps in time; a run-down alone

STROKE = "[[0, 90], [120 deg, 90], [150 deg, 4000], [180 deg, 90]%s]"
ROUND = ", [360 deg, 90]"


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("flywheel: {delta: 1/30, speed: 90 rpm, resisting: {table: %s}}", "flywheel.resisting.table"),
        ("flywheel: {delta: 1/30, speed: 90 rpm, driving: {table: %s}}", "flywheel.driving.table"),
        (
            "dynamics: {parts: [{inertia: 9, name: a}], motor: {by_angle: %s}, steady: false}",
            "motor.by_angle",
        ),
        (
            "dynamics: {parts: [{inertia: 9, name: a}], resistance: [{by_angle: %s}], motor: {constant: 9}, "
            "steady: false, start: {begin: 9, angle: 1}}",
            "resistance.0.by_angle",
        ),
        ("dynamics: {varying_inertia: %s, motor: {constant: 9}, steady: false}", "varying_inertia"),
    ],
)
def test_a_table_that_leaves_out_a_long_part_of_the_cycle_is_asked_for_it(text, place):
    """It was drawn straight on to the next cycle without a word."""
    with pytest.raises(ProblemError) as error:
        loading.loads(text % STROKE % "")
    assert ".".join(map(str, error.value.problems[0].path)).endswith(place)
    assert "from 180 to 360 deg" in error.value.problems[0].text()
    loading.loads(text % STROKE % ROUND)


@pytest.mark.parametrize(
    "angles", ["[[0, 0], [90 deg, 50], [180 deg, 0]]", "[[0, 40], [90 deg, 50], [270 deg, 9]]"]
)
def test_a_table_of_nought_outside_or_of_points_all_round_is_whole(angles):
    loading.loads(f"flywheel: {{delta: 1/30, speed: 9, resisting: {{table: {angles}}}}}")


def test_a_moment_by_time_may_jump():
    found = alone("""
  parts: [{name: rotor, inertia: 2}]
  motor: {by_time: [[0, 10], [1, 10], [1, 40], [2.5, 40], [2.5, 0], [9, 0]]}
  resistance: [{friction: 5}]
  start: {time: 3 s}
""").start
    rise = [5 / 2 * 1, 35 / 2 * 1.5, -5 / 2 * 0.5]
    assert found.omega[-1] == pytest.approx(sum(rise), rel=1e-9)
    mean = np.array([rise[0] / 2, rise[0] + rise[1] / 2, rise[0] + rise[1] + rise[2] / 2])
    assert found.phi[-1] == pytest.approx(float(mean @ [1, 1.5, 0.5]), rel=1e-9)
    assert found.works["motor"] == pytest.approx(10 * mean[0] + 40 * 1.5 * mean[1], rel=1e-9)


@pytest.mark.parametrize(("points", "waits"), [
    ("[[0, 1], [2, 1], [2, 9], [8, 9]]", 2.0),  # from one moment to the next
    ("[[0, 0], [2, 10], [2, 6], [9, 6]]", 1.0),  # before it falls again
])  # fmt: skip
def test_a_machine_waits_for_a_jump_and_not_on_the_way_to_it(points, waits):
    text = f"\n  parts: [{{name: rotor, inertia: 2}}]\n  motor: {{by_time: {points}}}\n"
    found = alone(text + "  resistance: [{friction: 5}]\n  start: {time: 7}\n").start
    assert found.t[0] == pytest.approx(waits, rel=1e-9)


@pytest.mark.parametrize("three", ["[[0, 1], [1, 1], [1, 2], [1, 3]]", "[[0, 1], [2, 3], [1, 3]]"])
def test_three_moments_at_one_time_are_no_jump(three):
    assert "ascend" in refused(f"  parts: [{{name: a, inertia: 1}}]\n  motor: {{by_time: {three}}}\n")[0]


@pytest.mark.parametrize(
    ("law", "time"),
    [
        ("{viscous: 0.5}", 2 / 0.5 * math.log(100 / 20)),
        ("{fan: {moment: 10, speed: 50}}", 2 / 10 * 50**2 * (1 / 20 - 1 / 100)),
        ("{by_speed: [[0, 10], [200, 10]]}", 2 * 80 / 10),
    ],
)
def test_a_machine_is_let_run_down_alone(law, time):
    """Closed integrals of J dω/M."""
    found = alone(f"""
  parts: [{{name: rotor, inertia: 2}}]
  resistance: [{law}]
  coast: {{begin: 100, speed: 20}}
""")
    assert found.coast.t[-1] == pytest.approx(time, rel=1e-9) and found.steady is None


def test_a_run_down_without_a_motor_asks_for_its_beginning_and_not_for_a_motor():
    told = refused("  parts: [{name: a, inertia: 1}]\n  resistance: [{viscous: 1}]\n  coast: {speed: 3}\n")
    assert "begin" in told[0] and "motor" not in told[0]


# --- a ratio the wrong way round

HOIST = """
  parts:
    - {name: rotor, inertia: 0.2}
    - {name: drum, ratio: DRUM, inertia: 9, radius: 0.2, mass: 100, moves: up, efficiency: 0.9}
  motor: {induction: {power: 5.5 kW, speed: 1455 rpm, synchronous: 1500 rpm, overload: 2.6}, ratio: MOTOR}
  start: {within: 2 %}
"""


@pytest.mark.parametrize(
    ("drum", "motor", "key", "cure"),
    [
        ("25", "1", "parts.1.ratio", "0.04"),
        ("0.5", "0.05", "motor.ratio", "20"),
        ("12.5", "1", "parts.1.ratio", "0.08"),
    ],
)
def test_a_machine_that_would_move_with_a_ratio_the_other_way_round_is_told_so(drum, motor, key, cure):
    said = refused(HOIST.replace("DRUM", drum).replace("MOTOR", motor))
    assert f"look at dynamics.{key}:" in said[0] and f"with {cure}, the other way round" in said[0]
    other = HOIST.replace("DRUM", cure if "parts" in key else drum).replace(
        "MOTOR", motor if "parts" in key else cure
    )
    assert alone(other).start.t[-1] > 0


def test_a_motor_that_is_too_weak_either_way_is_asked_to_be_stronger():
    text = HOIST.replace("DRUM", "0.04").replace("MOTOR", "2").replace("mass: 100", "mass: 400 t")
    assert "a stronger motor, a greater ratio" in refused(text)[0]
