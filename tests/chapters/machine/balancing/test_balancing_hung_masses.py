"""Masses handed on to the crank through rods and blocks, and the line from which counterweights are measured: stated
in the file, solved, held against what follows by hand."""

import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.problems import ProblemError

TWO_STAGES = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 50 mm}}
    2: {points: {A: 0, B: 200 mm, C: 60 mm, S2: 80 mm}, mass: 2 kg, mass_centre: S2, inertia: 0.01 kg*m^2}
    3: {points: [B], slides: x, mass: 1.2 kg}
    4: {points: {C: 0, D: 220 mm, S4: 70 mm}, mass: 1.5 kg, mass_centre: S4, inertia: 0.008 kg*m^2}
    5: {points: [D], slides: x, mass: 0.9 kg}
  driver: {link: 1, speed: 900 rpm, rotation: clockwise, zero: {angle: 0 deg}}
  assembly: {B: right, D: left}
"""
YOKE = """
mechanism:
  frame: {O: [0, 0]}
  guides:
    x: {through: O}
    s: {through: E, angle: 90 deg, link: 3}
  links:
    1: {points: {O: 0, A: 50 mm, S1: -8 mm}, mass: 2 kg, mass_centre: S1}
    2: {points: [A], slides: {guide: s, angle: 0 deg}, mass: 0.3 kg}
    3: {points: {E: 0, S3: [60 mm, 0]}, slides: {guide: x, at: E}, mass: 3.2 kg, mass_centre: S3}
  driver: {link: 1, speed: 300 rpm, zero: {angle: 90 deg}}
"""
ONE_SLIDER_TWO_RODS = """
mechanism:
  frame: {O: [0, 0], Q: [400 mm, -150 mm]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 30 mm}}
    2: {points: {A: 0, B: 150 mm}}
    3: {points: [B], slides: x, mass: 1 kg}
    4: {points: {B: 0, D: 250 mm}}
    5: {points: {Q: 0, D: 160 mm}}
  driver: {link: 1, speed: 300 rpm, zero: {angle: 0 deg}}
  assembly: {B: right, D: left of B-Q}
"""
CRANK = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, %sS1: [-10 mm, 3 mm]}, mass: 4 kg, mass_centre: S1}
    2: {points: {A: 0, B: 200 mm}}
    3: {points: [B], slides: x, mass: 0.8 kg}
  driver: {link: 1, speed: 900 rpm, zero: {angle: 30 deg}}
  assembly: {B: right}
"""
BALANCED = "balancing: {methods: [substituted, optimum], part: %g, counterweights: {1: {distance: 60 mm}}}"


def balanced(text: str, block: str = BALANCED % 0.5) -> Found:
    found = course.solve(loading.loads(f"{text}{block}\n")).balancing
    assert found is not None
    return found


def moment(found: Found, name: str) -> complex:
    return next(case for case in found.cases if case.name == name).placed[0].moment


def told(text: str, block: str) -> list[str]:
    with pytest.raises(ProblemError) as caught:
        loading.loads(f"{text}{block}\n")
    return [".".join(map(str, problem.path)) for problem in caught.value.problems]


@pytest.mark.parametrize("text", [TWO_STAGES, YOKE], ids=["rod on a rod", "block"])
def test_half_of_what_reciprocates_along_one_line_is_the_least_mean_square(text):
    """Of all that goes to and fro in the crank's line the mean seen from the crank is half: whatever hands it on."""
    found = balanced(text)
    assert moment(found, "substituted") == pytest.approx(moment(found, "optimum_rms"), rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("text", [TWO_STAGES, YOKE], ids=["rod on a rod", "block"])
def test_the_whole_of_it_leaves_no_first_order_along_the_line(text):
    case = balanced(text, BALANCED % 1.0).cases[0]
    along = fourier.series(case.cycle.force.real, 1).amplitude[1]
    assert along <= 1e-9 * case.force_max.value


def test_masses_of_a_rod_on_a_rod_by_hand():
    """m_C = m4 (1 − 70/220) is shared 140 : 60 between A and B, so is the balanced part of what slides with D."""
    found = balanced(TWO_STAGES, BALANCED % 0.25)
    at_a, at_b = 2 * (1 - 80 / 200), 2 * 80 / 200
    at_c, at_d = 1.5 * (1 - 70 / 220), 1.5 * 70 / 220
    at_a, at_b = at_a + 0.7 * at_c, at_b + 0.3 * at_c
    met = at_a + 0.25 * (1.2 + at_b) + 0.25 * (0.9 + at_d)
    assert found.substituted.carried["1"]["A"].mass == pytest.approx(met, rel=1e-12)
    assert found.substituted.sliding == pytest.approx({"3": 1.2 + at_b, "5": 0.9 + at_d}, rel=1e-12)


def test_a_block_on_the_crank_pin_turns_with_the_crank():
    found = balanced(YOKE, BALANCED % 0.0)
    assert found.substituted.carried["1"]["A"].mass == pytest.approx(0.3)
    assert found.substituted.sliding == {"3": 3.2}


def test_a_slider_with_two_rods_is_met_where_the_driving_one_hangs():
    """Not on the rocker too, which the slider drives: the part would be balanced twice."""
    carried = balanced(ONE_SLIDER_TWO_RODS).substituted.carried
    assert carried["1"]["A"].mass == pytest.approx(0.5)
    assert "5" not in carried


@pytest.mark.parametrize("points", ["A: 50 mm, ", "T: [0, 20 mm], A: 50 mm, "], ids=["plain", "tracer"])
def test_angles_are_counted_from_the_joint_whatever_points_stand_before_it(points):
    found = balanced(CRANK % points)
    x, y = 4 * -0.01 + 0.4 * 0.05, 4 * 0.003
    assert moment(found, "substituted") == pytest.approx(complex(-x, -y), rel=1e-12)


def test_a_stated_counterweight_is_opposite_to_the_joint():
    block = "balancing: {methods: [rotors], rotors: {first: 60 mm, second: 40 mm}, stated: {1: %s}}"
    found = balanced(CRANK % "T: [0, 20 mm], A: 50 mm, ", block % "{mass: 2 kg, distance: 70 mm}")
    stated = found.cases[0]
    added = stated.cycle.force - found.original.cycle.force
    turned = found.turned + np.radians(30)
    assert added == pytest.approx(-2 * 0.07 * found.kinematics.omega**2 * np.exp(1j * turned), rel=1e-9)


def test_a_rod_as_long_as_the_crank_is_no_slider_crank_of_the_series():
    """Through its change points the slider goes on with x = 2r cos φ; the series of √(1 − sin² φ) would say |cos φ|."""
    folded = (CRANK % "A: 50 mm, ").replace("B: 200 mm", "B: 50 mm")
    assert len(balanced(CRANK % "A: 50 mm, ").cranks) == 1
    assert not balanced(folded).cranks


@pytest.mark.parametrize(
    ("block", "places"),
    [
        ("balancing: {counterweights: {1: {distance: -5 mm}}}", ["balancing.counterweights.1.distance"]),
        (
            "balancing: {methods: [rotors], rotors: {first: 60 mm, second: 0 mm}}",
            ["balancing.rotors.second"],
        ),
        ("balancing: {counterweights: {1: {}}}", ["balancing.counterweights.1"]),
        ("balancing: {methods: [rotors]}", ["balancing.rotors"]),
    ],
)
def test_a_wrong_size_is_not_told_as_a_missing_one_too(block, places):
    assert told(CRANK % "A: 50 mm, ", block) == places


def test_a_fixed_point_is_not_offered_for_itself():
    with pytest.raises(ProblemError) as caught:
        loading.loads(CRANK % "A: 50 mm, " + "harmonics: {points: [O]}\n")
    (problem,) = caught.value.problems
    assert problem.right is not None and "O" not in problem.right.values.get("words", "").split(", ")
    assert "near" not in problem.right.values


KITE = """
mechanism:
  frame: {O: [0, 0], C: [100 mm, 0]}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 200 mm, S2: 90 mm}, mass: 2 kg, mass_centre: S2, inertia: 0.01 kg*m^2}
    3: {points: {C: 0, B: 200 mm}}
  driver: {link: 1, speed: 60 rpm, zero: {angle: 20 deg}}
  assembly: {B: left of A-C}
"""


@pytest.mark.parametrize(
    "block", ["harmonics: {}", "balancing: {methods: [optimum], counterweights: {1: {distance: 60 mm}}}"]
)
def test_a_motion_that_jumps_within_the_turn_has_no_harmonics(block):
    """A kite whose pin passes through the fixed pivot: the rocker goes on by half a turn, or back. The jump is told as
    a gap of the mechanism, with which there is no cycle to be developed."""
    found = course.solve(loading.loads(f"{KITE}{block}\n"))
    assert course.left_out(found) == [block.split(":")[0]]
    assert found.lever.kinematics.gaps


def test_a_moment_that_is_rounding_is_none():
    """Every force of a sine mechanism passes through the pivot: no diagram of 1e-16 N m."""
    found = balanced(YOKE)
    for case in found.every:
        assert not np.any(case.cycle.moment) and not np.any(case.diagram.moment)


@pytest.mark.parametrize("sense", ["clockwise", "counter-clockwise"])
@pytest.mark.parametrize("height", ["30 mm", "-30 mm"])
def test_orders_of_an_offset_slider_add_up_whichever_way_it_turns(sense, height):
    """What is left after all orders but the first two is small, on either side of the pivot and in either sense."""
    text = (CRANK % "A: 50 mm, ").replace("O: [0, 0]", f"O: [0, 0], P: [0, {height}]")
    text = text.replace("through: O", "through: P").replace(
        "speed: 900 rpm", f"speed: 900 rpm, rotation: {sense}"
    )
    found = balanced(text)
    (crank,), (remains,) = found.cranks, found.cycle_remains
    for force, order in ((remains.first, 1), (remains.second, 2)):
        assert fourier.series(force, order).amplitude[1:] == pytest.approx(0, abs=1e-9 * crank.mass * 500)
    side = 1 if (height[0] != "-") == (sense == "counter-clockwise") else -1
    assert crank.offset == pytest.approx(0.03 * side)
