"""Slips in the keys `wheels`, `racks` and `rolling`: one clear message each, at its line, with its cure."""

import pytest

from tmm_report import course, loading
from tmm_report.problems import ProblemError

TEXT = """language: en
mechanism:
  frame: {O1: [0, 0], O2: [150 mm, 0], E: [400 mm, 248 mm], P: [0, 200 mm]}
  guides: {x: {through: P}, k: {through: A, link: 3}}
  links:
    1: {points: {O1: 0, A: 60 mm}}
    2: {points: {O2: 0, B: 40 mm}}
    3: {points: {A: 0, C: 200 mm}}
    4: {points: {B: 0, C: 180 mm}}
    5: {points: {C: 0, D: 300 mm}}
    6: {points: [D], slides: x}
    7: {points: [E]}
  wheels:
    - {links: [1, 2], teeth: [40, 20], module: 5 mm, angles: [0, 30 deg]}
  racks:
    - {slider: 6, wheel: 7, radius: 48 mm}
  driver: {link: 1, speed: 120 rpm}
  assembly: {C: left of A-B, D: right}
positions: {table: 12}
"""
PAIR, RACK = "{links: [1, 2], teeth: [40, 20], module: 5 mm, angles: [0, 30 deg]}", "radius: 48 mm}"
SLIPS = {
    "no such link": ("links: [1, 2]", "links: [1, 9]", "mechanism.wheels.0.links.1", "there is no link 9", ""),
    "the frame": ("links: [1, 2]", "links: [0, 2]", "mechanism.wheels.0.links.0", "frame carries no wheel", "1, 2"),
    "the frame last": (
        "links: [1, 2]", "carrier: 1, links: [3, 0]",
        "mechanism.wheels.0.links.1", "behind the one that runs round", "links: [0, 3]",
    ),
    "itself": ("links: [1, 2]", "links: [2, 2]", "mechanism.wheels.0", "in mesh with itself", "two different"),
    "moving axis": ("links: [1, 2]", "links: [1, 3]", "mechanism.wheels.0.links.1", "no fixed point", "carrier: 1 / 4"),
    "two sizes": ("module: 5 mm", "ratio: 2", "mechanism.wheels.0", "not stated in one way", "one of them"),
    "no size": ("teeth: [40, 20], module: 5 mm, ", "", "mechanism.wheels.0", "not stated in one way", "ratio: 2"),
    "module alone": ("teeth: [40, 20], ", "ratio: 2, ", "mechanism.wheels.0", "without numbers of teeth", "leave"),
    "wrong module": (
        "module: 5 mm", "module: 4 mm",
        "mechanism.wheels.0.module", "120 mm, and the axes are 150 mm", "module: 5 mm",
    ),
    "wrong radii": (
        "teeth: [40, 20], module: 5 mm", "radii: [80 mm, 40 mm]",
        "mechanism.wheels.0.radii", "do not touch", "100 mm, 50 mm",
    ),
    "equal ring": (
        "teeth: [40, 20], module: 5 mm", "ratio: 1, mesh: internal",
        "mechanism.wheels.0.ratio", "can't be equal", "external",
    ),
    "signed ratio": (
        "teeth: [40, 20], module: 5 mm", "ratio: -2",
        "mechanism.wheels.0", "follows from the mesh", "ratio: 2",
    ),
    "angle": (
        "module: 5 mm", "module: 5 mm, pressure_angle: 60 deg",
        "mechanism.wheels.0", "no teeth are in mesh", "0 to 45",
    ),
    "two phases": ("angles: [0", "phase: 0, angles: [0", "mechanism.wheels.0", "stated twice", "leave one"),
    "twice": (
        PAIR, PAIR + "\n    - {links: [2, 1], ratio: 0.5}",
        "mechanism.wheels.1", "in mesh twice", "leave one",
    ),
    "one axis": (
        "2: {points: {O2: 0, B: 40 mm}}", "2: {points: {O1: 0, B: 40 mm}}",
        "mechanism.wheels.0.links", "have one axis", "one link",
    ),
    "no slider": ("slider: 6", "slider: 5", "mechanism.racks.0.slider", "slides along no fixed guide", "slides:"),
    "rack wheel": ("wheel: 7", "wheel: 4", "mechanism.racks.0.wheel", "turns about no fixed point", "carrier: "),
    "teeth alone": (RACK, "teeth: 24}", "mechanism.racks.0", "not stated in one way", "module: 4 mm"),
    "side along": (RACK, "radius: 48 mm, side: left}", "mechanism.racks.0.side", "the rack runs that way", "above"),
    "side unknown": ("248 mm]", "200 mm]", "mechanism.racks.0", "lies on the line of the guide", "side: above"),
    "planet": ("links: [1, 2]", "planet: 3, links: [1, 2]", "mechanism.wheels.0.planet", "is the carrier", "[0, 2"),
    "own carrier": ("links: [1, 2]", "carrier: 1, links: [1, 2]", "mechanism.wheels.0.carrier", "its own wheel", "3"),
    "no such carrier": ("links: [1, 2]", "carrier: 9, links: [1, 2]", "mechanism.wheels.0.carrier", "no link 9", ""),
    "frame as carrier": ("links: [1, 2]", "carrier: 0, links: [1, 2]", "mechanism.wheels.0.carrier", "no carrier", ""),
    "carrier apart": (
        "links: [1, 2]", "carrier: 5, links: [1, 2]",
        "mechanism.wheels.0.carrier", "not one common point", "both wheels are pivoted",
    ),
    "carrier too long": (
        "links: [1, 2], teeth: [40, 20], module: 5 mm,", "links: [1, 4], carrier: 3, teeth: [40, 20], module: 5 mm,",
        "mechanism.wheels.0.module", "150 mm, and the axes are 200 mm", "module: 6.66667 mm",
    ),
    "frame turned": (
        "links: [1, 2], teeth: [40, 20], module: 5 mm, angles: [0,",
        "links: [0, 3], carrier: 1, teeth: [40, 20], module: 2 mm, angles: [1,",
        "mechanism.wheels.0.angles.0", "frame does not turn", "0",
    ),
    "fixed rack": ("slider: 6", "slider: 0", "mechanism.racks.0.slider", "do not move", "carrier"),
    "carrier on no guide": (
        "slider: 6", "carrier: 5, slider: 6",
        "mechanism.racks.0.carrier", "slides along no fixed guide", "a guide of the frame",
    ),
    "method": (
        "positions:", "method: newton\npositions:",
        "method", "is not worked out of a mechanism with wheels", "closed form",
    ),
}  # fmt: skip


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_is_told_with_its_cure(slip):
    right, wrong, key, words, cure = SLIPS[slip]
    assert TEXT.count(right) == 1
    cured(TEXT.replace(right, wrong), key, words, cure)


def cured(text, key, words, cure):
    """At the key the words and the cure are told, with a line."""
    with pytest.raises(ProblemError) as caught:
        loading.loads(text)
    told = [problem for problem in caught.value.problems if problem.key == key]
    assert told, [problem.text() for problem in caught.value.problems]
    assert any(words in problem.text() and cure in problem.text() for problem in told)
    assert all(problem.line for problem in told)


SOLVED = {
    "ratio": ("teeth: [40, 20], module: 5 mm", "teeth: [40, 25]", "1.6 turns for each turn", "whole number of turns"),
    "over-constrained": ("7: {points: [E]}", "7: {points: {E: 0, D: 50 mm}}", "p4 = 2 higher pairs", "too many"),
    "no axis": ("3: {points: {A: 0, C: 200 mm}}", "3: {points: {A: 0}}", "2 link end", "too free"),
    "too free": ("  wheels:\n    - " + PAIR + "\n", "", "mobility", "too free"),
}  # fmt: skip


@pytest.mark.parametrize("slip", SOLVED)
def test_what_the_structure_says_against_it(slip):
    right, wrong, words, cure = SOLVED[slip]
    assert TEXT.count(right) == 1
    variant = loading.loads(TEXT.replace(right, wrong))
    with pytest.raises(ProblemError) as caught:
        course.solve(variant)
    told = " ".join(problem.text() for problem in caught.value.problems)
    assert words in told and cure in told


WITHIN = """language: en
mechanism:
  frame: {O1: [0, 0], O2: [150 mm, 0], E: [75 mm, 400 mm]}
  links:
    1: {points: {O1: 0, A: 60 mm}}
    2: {points: {O2: 0, B: 60 mm}}
    3: {points: {A: 0, C: 200 mm}}
    4: {points: {B: 0, C: 200 mm}}
    8: {points: {E: 0, K: 20 mm}}
    9: {points: {K: 0, C: 220 mm}}
  wheels:
    - {links: [1, 2], ratio: 1}
  driver: {link: 8, speed: 120 rpm}
"""


def test_a_mesh_within_a_group_is_refused_by_name():
    with pytest.raises(ProblemError) as caught:
        course.solve(loading.loads(WITHIN))
    (told,) = caught.value.problems
    assert told.key == "mechanism.wheels.0" and "within a group" in told.text()
    assert "let the driving link" in told.text()


def test_a_rack_driven_by_full_turns_runs_away():
    text = """language: en
mechanism:
  frame: {O: [0, 0], G: [0, 40 mm]}
  guides: {x: {through: G}}
  links: {1: {points: {O: 0, A: 30 mm}}, 2: {points: [B], slides: x}}
  racks: [{slider: 2, wheel: 1, radius: 40 mm}]
  driver: {link: 1, speed: 1}
"""
    with pytest.raises(ProblemError) as caught:
        course.solve(loading.loads(text))
    (told,) = caught.value.problems
    assert told.key == "mechanism.racks.0" and "runs away" in told.text() and "driver.range" in told.text()
    swung = course.solve(loading.loads(text.replace("speed: 1}", "speed: 1, range: 90 deg}"))).lever
    way = swung.kinematics.table.place("B").real
    assert way[-1] - way[0] == pytest.approx(
        -0.04 * 1.5707963267948966
    )  # above the wheel, which turns to the left there


def test_the_text_itself_is_right():
    found = course.solve(loading.loads(TEXT)).lever.structure
    assert (found.moving_links, found.lower_pairs, found.higher_pairs, found.mobility) == (7, 9, 2, 1)
    assert found.formula == "I(0,1) → z(2) → II2(3,4) → II2(5,6) → z(7)"


ROLLING = """language: en
mechanism:
  frame: {O: [0, 0], P: [0, 50 mm]}
  guides: {x: {through: O}, y: {through: P, angle: 20 deg}}
  links:
    1: {points: {O: 0, A: 60 mm}}
    2: {points: {A: 0, B: 240 mm}}
    3: {points: {B: 0}, slides: x}
    4: {points: [B], mass: 7 kg}
    5: {points: [K], slides: y}
  rolling:
    - {wheel: 4, carrier: 3, radius: 70 mm, side: above}
  racks:
    - {slider: 5, wheel: 4, carrier: 3, radius: 50 mm}
  driver: {link: 1, speed: 100 rpm}
  assembly: {B: right}
positions: {table: 12}
"""
ON_RAILS = {
    "not parallel": ("", "", "mechanism.racks.0.carrier", "not parallel", "with the angle"),
    "side": ("side: above", "side: left", "mechanism.rolling.0.side", "the rack runs that way", "side: above"),
    "axle": ("3: {points: {B: 0}", "3: {points: {B: 0, K: 50 mm}", "mechanism.rolling.0.carrier", "more than the axle",
             "mechanism.racks"),
    "no axle": ("4, carrier: 3, radius: 70", "4, carrier: 1, radius: 70", "mechanism.rolling.0.carrier",
                "no fixed guide", "a guide of the frame"),
    "wheel elsewhere": ("wheel: 4, carrier: 3, radius: 70", "wheel: 1, carrier: 3, radius: 70",
                        "mechanism.rolling.0.carrier", "not one common point", ""),
    "no radius": ("radius: 70 mm, ", "", "mechanism.rolling.0.radius", "", ""),
    "on a slider": ("side: above", "side: above, slider: 5", "mechanism.rolling.0.slider", "held by teeth", ""),
    "friction": ("side: above", "side: above, f: 0.2", "mechanism.rolling.0.f", "told by the note", "contacts"),
}  # fmt: skip


@pytest.mark.parametrize("slip", ON_RAILS)
def test_a_slip_of_a_wheel_on_a_rail_is_told_with_its_cure(slip):
    right, wrong, key, words, cure = ON_RAILS[slip]
    assert not right or ROLLING.count(right) == 1
    cured(ROLLING.replace(right, wrong) if right else ROLLING, key, words, cure)


PLANET = """language: en
mechanism:
  frame: {O: [0, 0]}
  links:
    1: {points: {O: 0, A: 60 mm}}
    2: {points: {A: 0, D: 30 mm}}
  wheels:
    - {links: [0, 2], carrier: 1, ratio: 0.5, mesh: internal}
  driver: {link: 1, speed: 100 rpm}
positions: {table: 12}
"""


def refused(text):
    with pytest.raises(ProblemError) as caught:
        course.solve(loading.loads(text))
    return " ".join(problem.text() for problem in caught.value.problems)


def test_a_planet_that_does_not_come_back_is_refused_unless_it_carries_nothing():
    assert "1.5 turns for each turn" in refused(PLANET.replace("ratio: 0.5", "ratio: 0.4"))
    course.solve(loading.loads(PLANET.replace("ratio: 0.5", "ratio: 0.4").replace(", D: 30 mm", "")))
    course.solve(
        loading.loads(PLANET.replace("ratio: 0.5", "ratio: 0.4").replace("rpm}", "rpm, range: 90 deg}"))
    )


def test_an_unknown_carrier_is_a_mesh_within_a_group():
    text = PLANET.replace("1: {points: {O: 0, A", "3: {points: {O: 0}}\n    1: {points: {O: 0, A")
    sun = "mesh: internal}\n    - {links: [3, 2], carrier: 1, radii: [30 mm, 30 mm]}"
    text = text.replace("ratio: 0.5, mesh: internal}", "radii: [90 mm, 30 mm], " + sun)
    assert course.solve(loading.loads(text)).lever.structure.formula == "I(0,1) → z(2) → z(3)"
    told = refused(text.replace("link: 1,", "link: 3,"))
    assert "within a group" in told and "and the carrier" in told


def test_a_wheel_that_turns_too_often_is_refused():
    chain = "3: {points: {P: 0}}\n    2: {points: {A: 0}}"
    text = PLANET.replace("2: {points: {A: 0, D: 30 mm}}", chain).replace(
        "{O: [0, 0]}", "{O: [0, 0], P: [1, 0], Q: [2, 0]}"
    )
    text = text.replace("    3:", "    4: {points: {Q: 0}}\n    3:")
    wheels = "wheels:\n    - {links: [1, 3], ratio: 0.001}\n    - {links: [3, 4], ratio: 0.001}"
    assert "more than 100000 turns" in refused(text.replace("wheels:", wheels))


def test_a_wheel_moved_by_two_meshes_is_redundant():
    text = PLANET.replace("2: {points: {A: 0, D: 30 mm}}", "2: {points: {A: 0}}\n    3: {points: {O: 0}}")
    twice = "mesh: internal}\n    - {links: [3, 2], carrier: 1, ratio: 2}\n    - {links: [1, 3], ratio: 2}"
    assert "one axis" in refused(text.replace("mesh: internal}", twice))
