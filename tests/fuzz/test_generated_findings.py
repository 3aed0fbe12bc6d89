"""What generated variants once broke, the smallest variant of each: it has a note in every form and language."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from exhaustive import many

sys.path.append(str(Path(__file__).parents[2]))

from benchmarks.fuzz.judge import odd_words, unbalanced
from tmm_report import course, loading, render
from tmm_report.problems import ProblemError

CRANK = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 100 mm}, mass: 2 kg, mass_centre: O}
    2: {points: {A: 0, B: 400 mm}, mass: 3 kg, mass_centre: B, inertia: 0.06 kg*m^2}
    3: {points: [B], slides: x, mass: 4 kg}
  driver: {link: 1, speed: 90 rpm}
  assembly: {B: right}
"""
ALONE = """
mechanism:
  frame: {O: [0, 0]}
  links:
    1: {points: {O: 0, A: 100 mm}, mass: 2 kg, mass_centre: O}
  driver: {link: 1, speed: 90 rpm}
"""
CAM = """
mechanism:
  frame: {O: [0, 0]}
  guides: {y: {through: O, angle: 90 deg}}
  links:
    1: {points: {O: 0}}
    2: {points: {B: 0, D: 80 mm}, slides: y}
  driver: {link: 1, speed: 51 rpm, zero: {angle: 95 deg}}
  cams:
    k:
      follower: 2
      roller: {at: B}
      base: 40 mm
      lift: 8 mm
      phases: [{rise: 110 deg, law: uniform}, {dwell: 50 deg}, {return: 110 deg, law: parabolic}, {dwell: 90 deg}]
harmonics: {highest: 4, points: [B]}
"""
EQUAL_SIDES = """
mechanism:
  frame: {O: [0, 0], P: [200 mm, 0]}
  guides: {x: {through: [O, P]}}
  links:
    1: {points: {O: 0, A: 50.37 mm}}
    2: {points: {A: 0, B: 50.37 mm}}
    3: {points: [B], slides: x}
  assembly: {2-3: right}
  driver: {link: 1, speed: 230 rpm, rotation: clockwise, zero: {angle: -60 deg}, range: 120 deg}
positions: {table: 4, diagram: 12, plans: 1}
"""
SLOT = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}, s: {through: E, angle: 90 deg, link: 3}}
  links:
    1: {points: {O: 0, A: 50 mm}, mass: 1 kg, mass_centre: O, inertia: 0.01 kg*m^2}
    2: {points: [A], slides: {guide: s, angle: 90 deg}}
    3: {points: {E: 0, D: 170 mm}, slides: [{guide: x}]}
  driver: {link: 1, speed: 72 rpm, rotation: clockwise, zero: {point: D, extreme: right}}
positions: {table: 4, diagram: 4, force_plan: 4}
loads: {forces: [{name: F, at: D, direction: against motion, constant: 2 kN}]}
friction: {guides: {coefficient: 0.06, length: 212 mm}, corrected: true}
"""
TEXTS = {
    "plans at a position that is flat by the closed form and not by Newton": EQUAL_SIDES + "method: newton\n",
    "a position where friction has no power, nor the driving moment": SLOT,
    "parts of a machine without mass": "dynamics: {parts: [{name: gear, ratio: 0.9}], speed: 27 rad/s, "
    "varying_inertia: [[0 deg, 0.112 kg*m^2], [180 deg, 0.108 kg*m^2], [360 deg, 0.112 kg*m^2]], "
    "start: {begin: 1.3 rad/s, time: 0.9 s}, steady: false}",
    "a driving link alone whose methods are compared": ALONE
    + "methods: true\npositions: {table: 4, diagram: 4}\n",
    "harmonics of a cam's follower, whose link in place of the pair is no rod": CAM,
    "the field of a follower that only slides": CAM.replace("points: [B]}", "links: ['2', '2']}"),
    "a position of the plans that is written twice": CRANK
    + "loads: {}\npositions: {table: 8, plans: [3, 1, 3], "
    "force_plan: [3, 3]}",
    "a punch of a hundred turns between its strokes": "flywheel: {speed: 1000 rpm, delta: 1/10, "
    "motor: {power: 3 kW, speed: 1400 rpm}, punch: {work: 9 kJ, period: 6.4 s, time: 0.35 s}}",
}


@pytest.mark.exhaustive
@pytest.mark.parametrize("language", many(("ru", "en")))
@pytest.mark.parametrize("name", TEXTS)
def test_it_has_a_note(name, language):
    results = course.solve(loading.loads(TEXTS[name]))
    files = {form: render(results, form, language) for form in ("html", "tex", "json", "csv")}
    assert list(odd_words(files["html"]["note.html"].decode())) == []
    assert list(unbalanced(files["tex"]["note.tex"].decode())) == []


def test_masses_that_do_not_move_are_not_reduced():
    """A driving link that turns about its mass centre and has no moment of inertia."""
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(ALONE + "loads: {}\nreduction: true\n"))
    assert "no mass of the links moves" in error.value.problems[0].text()
    moving = ALONE.replace("mass_centre: O", "mass_centre: O, inertia: 0.01 kg*m^2")
    found = course.solve(loading.loads(moving + "loads: {}\nreduction: true\n")).lever
    assert found.reduction.table.whole_inertia == pytest.approx(0.01)


def test_a_machine_whose_moments_only_drive_has_no_steady_motion():
    """Its running work never goes below what it begins with."""
    given = """
dynamics:
  parts: [{name: '1', inertia: 0.961 kg*m^2, moment: -14.1 N*m}, {name: x, mass: 1.6 kg, velocity: 1.62354 m/s,
    angle: 180 deg, efficiency: 0.94}]
  period: 749 deg
  losses_of_acceleration: true
  start: {time: 0.791797 s, at: 24 deg}
  steady: true
  speed: 12 rad/s
"""
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(given))
    (told,) = error.value.problems
    assert "each cycle leaves 184 J over: the speed grows" in told.text()
