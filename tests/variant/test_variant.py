# ruff: noqa: E501  (tables of cases: one case, one line)
"""Variants: what a text becomes, and every kind of mistake with its line, column and key."""

import math
import subprocess
import sys
from functools import cache
from pathlib import Path

import jsonschema
import pytest

from tmm_report import loading, variant, yamlread
from tmm_report.languages import LANGUAGES
from tmm_report.mechanics.calculus.laws import ByAngle, ByDisplacement, ByPosition, Constant
from tmm_report.mechanics.lever.mechanism import ZeroAngle, ZeroExtreme
from tmm_report.problems import ProblemError, mistake

VARIANTS = sorted(Path(__file__).parents[2].joinpath("variants").glob("*.yaml"))
COMPRESSOR = next(path for path in VARIANTS if path.stem == "compressor").read_text(encoding="utf-8")
SMALL = """\
mechanism:
  frame: {O: [0, 0], P: [0.1, 0.2]}
  guides:
    x: {through: O}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 300 mm}}
    3: {points: [B], slides: x}
  driver:
    link: 1
    speed: 1200 rpm
  assembly: {B: right}
"""


def edited(*edits, text=SMALL):
    for old, new in edits:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    return text


def mistakes(text):
    with pytest.raises(ProblemError) as caught:
        loading.loads(text, "v.yaml")
    assert all(problem.file == "v.yaml" for problem in caught.value.problems)
    return [(p.line, p.column, p.key, str(p.wrong), str(p.right or "")) for p in caught.value.problems]


def part(section):
    return loading.loads(SMALL + section)


# --- what a text becomes


def test_compressor():
    v = loading.loads(COMPRESSOR, "c.yaml")
    mechanism = v.lever.mechanism
    assert list(mechanism.links) == ["0", "1", "2", "3", "4", "5"]
    assert mechanism.links["2"].points == {"A": 0, "B": 0.3, "C": 0.075, "S2": 0.15}
    assert (mechanism.links["2"].mass, mechanism.links["2"].inertia) == (1.5, 0.0135)
    assert mechanism.driver.omega == pytest.approx(-40 * math.pi)
    assert mechanism.driver.zero == ZeroExtreme(point="B", direction=1)
    assert [(one.key, one.choice) for one in mechanism.assembly] == [("B", 1), ("D", -1)]
    assert [(one.link, one.guide) for one in mechanism.slides] == [("3", "x"), ("5", "x")]
    assert v.lever.loads.gravity == -9.81j
    assert v.lever.loads.forces[0].law == ByPosition((2000, 1000, 0, 0, 0, 0, 0, 500, 1000, 1500, 2000, 2000))
    assert (v.lever.friction.pivots.coefficient, v.lever.friction.pivots.diameter) == (0.1, 0.05)
    assert (v.lever.positions.plans, v.lever.positions.force_plan) == ((6, 7), (7,))
    assert (v.lever.drawing.accuracy, v.lever.drawing.force) == (1e-5, {"4-5": 10, "2-3": 20})
    assert v.lever.readings[7]["v_B"] == (4.444, "")
    assert (v.title.variant, v.title.year, v.language, v.decimal_sign) == ("1", "2026", "ru", "comma")


def test_defaults():
    v = loading.loads(SMALL)
    assert (v.lever.loads, v.lever.friction, v.lever.readings) == (None, None, {})
    assert (
        v.lever.positions.table,
        v.lever.positions.diagram,
        v.lever.positions.plans,
        v.lever.positions.force_plan,
    ) == (
        12,
        36,
        (1, 7),
        (7,),
    )
    assert v.lever.mechanism.driver.zero == ZeroAngle(0.0)
    assert v.lever.mechanism.driver.sweep == 2 * math.pi
    assert loading.loads(SMALL + "language: en").decimal_sign == "point"
    assert part("loads: {}").lever.loads.gravity == -9.81j


def test_places_of_points():
    points = "{A: 0, B: 300 mm, C: [1 cm, -2 cm], D: {from: {A: 300 mm, B: 400 mm}, side: %s}, E: -1 cm}"
    for side, sign in (("left", 1), ("right", -1)):
        text = edited(("{A: 0, B: 300 mm}", points % side))
        placed = loading.loads(text).lever.mechanism.links["2"].points
        assert placed["C"] == 0.01 - 0.02j
        assert placed["E"] == -0.01
        assert abs(placed["D"] - placed["A"]) == pytest.approx(0.3)
        assert abs(placed["D"] - placed["B"]) == pytest.approx(0.4)
        assert math.copysign(1, placed["D"].imag) == sign


def test_guides_and_slides():
    text = edited(
        (
            "x: {through: O}",
            "x: {through: O}\n    y: {through: [O, P]}\n    z: {through: B, angle: 90 deg, link: 2}",
        ),
        ("slides: x", "slides: [{guide: x, at: B, angle: 90 deg}, y]"),
    )
    mechanism = loading.loads(text).lever.mechanism
    assert mechanism.guides["x"].direction == 1
    assert mechanism.guides["y"].direction == pytest.approx((0.1 + 0.2j) / abs(0.1 + 0.2j))
    guide = mechanism.guides["z"]
    assert (guide.link, guide.through, guide.direction) == ("2", 0.3, 1j)
    assert [(one.guide, one.through, one.direction) for one in mechanism.slides] == [
        ("x", 0, 1j),
        ("y", 0, 1),
    ]


@pytest.mark.parametrize(
    ("written", "choice"),
    [
        ("right", 1), ("up", 1j), ("left", -1), ("down", -1j), ("+", 1), ("'-'", -1), ("+1", 1), ("-1", -1),
        ("left of O-A", ("left", "O", "A")), ("right of A-P", ("right", "A", "P")),
    ],
)  # fmt: skip
def test_assembly(written, choice):
    (read,) = loading.loads(edited(("{B: right}", f"{{2-3: {written}}}"))).lever.mechanism.assembly
    assert (read.key, read.choice) == ("2-3", choice)
    assert type(read.choice) is type(choice) or isinstance(read.choice, complex)


@pytest.mark.parametrize(
    ("written", "zero"),
    [
        ("{angle: 90 deg}", ZeroAngle(math.pi / 2)), ("{point: B, extreme: down}", ZeroExtreme("B", None, -1j)),
        ("{link: 2, extreme: clockwise}", ZeroExtreme(None, "2", -1)),
        ("{link: 2, extreme: counter-clockwise}", ZeroExtreme(None, "2", 1)),
    ],
)  # fmt: skip
def test_zero(written, zero):
    text = edited(
        (
            "speed: 1200 rpm",
            f"period: 0,05 s\n    rotation: clockwise\n    range: 90 deg\n    zero: {written}",
        )
    )
    driver = loading.loads(text).lever.mechanism.driver
    assert driver.zero == zero
    assert (driver.omega, driver.sweep) == pytest.approx((-40 * math.pi, math.pi / 2))


def test_loads_and_laws():
    loads = part("""
loads:
  gravity: {value: 10, direction: left}
  forces:
    - {at: B, direction: up, constant: 2 kN}
    - {at: B, direction: along motion, by_angle: [[0, 1], [180 deg, 5 N], [360 deg, 1]]}
    - {name: газ, at: B, direction: 30 deg, piston_diameter: 100 mm,
       by_displacement: {zero: right, forward: [[0, 1 MPa], [1, 0]], back: [[0, 0.2 MPa]]}}
    - {at: A, direction: against motion, by_displacement: {zero: up, forward: [[50 %, 7]], back: [[0, 8 N]]}}
  moments:
    - {on: 2, direction: clockwise, constant: -5 N*m}
    - {on: 1, direction: against motion, by_angle: [[0, 1]]}
""").lever.loads
    first, second, third, fourth = loads.forces
    area = math.pi / 4 * 0.01
    assert loads.gravity == -10
    assert (first.name, first.direction, first.law) == (None, 1j, Constant(2000))
    assert (second.direction, second.law) == ("along", ByAngle((0, math.pi, 2 * math.pi), (1, 5, 1)))
    assert third.name == "газ"
    assert third.law == ByDisplacement(1, ((0, 1e6 * area), (1, 0)), ((0, 0.2e6 * area),))
    assert (fourth.direction, fourth.law) == ("against", ByDisplacement(1j, ((0.5, 7),), ((0, 8),)))
    assert [(one.name, one.on, one.direction) for one in loads.moments] == [
        (None, "2", -1),
        (None, "1", "against"),
    ]
    assert part("loads: {gravity: 0}").lever.loads.gravity == 0


def test_yaml_traps_do_the_expected_thing():
    v = part(
        "title: {group: 21.10, student: no, topic: 12:30, variant: 017, city: 1e5, year: ~}\ndrawing: {accuracy: 1e-5}"
    )
    title = v.title
    assert (title.group, title.student, title.topic, title.variant, title.city) == (
        "21.10",
        "no",
        "12:30",
        "017",
        "1e5",
    )
    assert (
        loading.loads(edited(("[0.1, 0.2]", "['0,1', 2e-1]"))).lever.mechanism.links["0"].points["P"]
        == 0.1 + 0.2j
    )


def test_names_of_letters():
    names = edited(("x: {through: O}", "Ә: {through: O}"), ("slides: x", "slides: Ә"), ("P: [", "Щ'2: ["))
    assert list(loading.loads(names).lever.mechanism.guides) == ["Ә"]


# --- mistakes: (edit of SMALL or text after it, line, column, key, what is wrong)

MISTAKES = [
    (("speed:", "sped:"), 11, 5, "mechanism.driver.sped", "unknown key sped"),
    (("assembly:", "asembly:"), 12, 3, "mechanism.asembly", "unknown key asembly"),
    (("    link: 1\n", ""), 9, 3, "mechanism.driver", "what drives must be stated once"),
    (("    speed: 1200 rpm\n", ""), 9, 3, "mechanism.driver", "the speed must be stated once"),
    (("1200 rpm", "1200 rpm\n    period: 1 s"), 9, 3, "mechanism.driver", "the speed must be stated once"),
    (("1200 rpm", "1200 mm"), 11, 5, "mechanism.driver.speed", "1200 mm is a length (mm); expected: an angular velocity (rad/s)"),
    (("1200 rpm", "0"), 11, 5, "mechanism.driver.speed", "0 is negative or zero: an angular velocity must be greater than zero"),
    (("1200 rpm", "5\n    rotation: left"), 12, 5, "mechanism.driver.rotation", "left is not a word known here"),
    (("1200 rpm", "5\n    zero: {point: B}"), 12, 5, "mechanism.driver.zero", "position 0 is not stated in one way"),
    (("1200 rpm", "5\n    zero: {point: Q, extreme: up}"), 12, 12, "mechanism.driver.zero.point", "no link has the point Q"),
    (("1200 rpm", "5\n    zero: {link: 7, extreme: clockwise}"), 12, 12, "mechanism.driver.zero.link", "there is no link 7"),
    (("link: 1", "link: 7"), 10, 5, "mechanism.driver.link", "there is no link 7"),
    (("link: 1", "link: 2"), 10, 5, "mechanism.driver.link", "the driving link 2 has no fixed point"),
    (("link: 1", "link: 0"), 10, 5, "mechanism.driver.link", "the frame cannot drive"),
    (("100 mm", "-100 mm"), 6, 24, "mechanism.links.1.points.A", "negative length"),
    (("100 mm", "0"), 6, 24, "mechanism.links.1.points.A", "zero length: A is at the place of O"),
    (("100 mm", ".nan"), 6, 24, "mechanism.links.1.points.A", ".nan is not a number; expected: a length (m)"),
    (("100 mm", "1 kg"), 6, 24, "mechanism.links.1.points.A", "1 kg is a mass (kg); expected: a length (m)"),
    (("100 mm", "[1, 2, 3]"), 6, 24, "mechanism.links.1.points.A", "too many values: 2 expected"),
    (("100 mm", "[1]"), 6, 24, "mechanism.links.1.points.A", "a value of the list is missing"),
    (("100 mm", ""), 6, 24, "mechanism.links.1.points.A", "there is no value here"),
    (("300 mm", "300 mm, C: {from: {A: 1 mm, B: 1 mm}, side: left}"), 7, 35, "mechanism.links.2.points.C",
     "the triangle does not close: A and B are 0.3 m apart"),
    (("300 mm", "300 mm, C: {from: {A: 1 mm, D: 1 mm}, side: left}"), 7, 35, "mechanism.links.2.points.C",
     "the point D is not placed on this link before"),
    (("300 mm", "300 mm, C: {from: {A: 1 mm}, side: left}"), 7, 39, "mechanism.links.2.points.C.from",
     "too few values: 2 expected, 1 found"),
    (("300 mm", "300 mm, C: {from: {A: 1, B: 1}, side: up}"), 7, 59, "mechanism.links.2.points.C.side", "up is not a word known here"),
    (("300 mm", "300 mm, B_2: 5 mm"), 7, 35, "mechanism.links.2.points.B_2", "B_2 is not a name: «_» may not stand in one"),
    (("300 mm}", "300 mm, C: 50 mm}, mass: 2 kg"), 7, 46, "mechanism.links.2.mass", "the link has a mass and no mass centre"),
    (("300 mm}", "300 mm}, mass: -2 kg"), 7, 36, "mechanism.links.2.mass", "-2 kg is negative: a mass cannot be"),
    (("300 mm}", "300 mm}, inertia: -2"), 7, 36, "mechanism.links.2.inertia", "-2 is negative: a moment of inertia cannot be"),
    (("300 mm}", "300 mm}, mass_centre: O"), 7, 36, "mechanism.links.2.mass_centre", "the point O is not on link 2"),
    (
        ("[B]", "[B, C]"), 8, 9, "mechanism.links.3.points",
        "the list names several points (B, C), but not their places on the link",
    ),
    (("[B]", "B"), 8, 9, "mechanism.links.3.points", "this has another form than expected here"),
    (("slides: x", "slides: z"), 8, 22, "mechanism.links.3.slides", "there is no guide z"),
    (("slides: x", "slides: {guide: x, at: A}"), 8, 41, "mechanism.links.3.slides.at", "the point A is not on link 3"),
    (("{through: O}", "{through: B}"), 4, 9, "mechanism.guides.x.through", "the point B is not on link 0"),
    (("{through: O}", "{through: [O, P], angle: 0}"), 4, 26, "mechanism.guides.x.angle", "the direction is stated twice"),
    (("{through: O}", "{through: [O, O]}"), 4, 9, "mechanism.guides.x.through", "a line needs two different points"),
    (("{through: O}", "{through: B, link: 3}"), 8, 22, "mechanism.links.3.slides", "the link cannot slide along its own guide"),
    (("{through: O}", "{through: O, link: 9}"), 4, 21, "mechanism.guides.x.link", "there is no link 9"),
    (("P: [", "x: ["), 4, 5, "mechanism.guides.x", "a point is also called x"),
    (("100 mm}}", "100 mm}}\n    0: {points: [O]}"), 7, 5, "mechanism.links.0", "0 is the frame and cannot be a moving link"),
    (("{B: right}", "{Q: right}"), 12, 14, "mechanism.assembly.Q", "Q is neither a point nor a pair of links"),
    (("{B: right}", "{2-9: right}"), 12, 14, "mechanism.assembly.2-9", "2-9 is neither a point nor a pair of links"),
    (("{B: right}", "{B: sideways}"), 12, 14, "mechanism.assembly.B", "sideways does not say which way the group is assembled"),
    (("{B: right}", "{B: left of A-Q}"), 12, 14, "mechanism.assembly.B", "no link has the point Q"),
    (("{B: right}", "{}\n  sketch: {Q: [0, 0]}"), 13, 12, "mechanism.sketch.Q", "no link has the point Q"),
    ("language: de", 13, 1, "language", "there is no language de"),
    ("mehcanism: {}", 13, 1, "mehcanism", "unknown key mehcanism"),
    ("title: {city: '" + "x" * 201 + "'}", 13, 9, "title.city", "the text is longer than 200 characters"),
    ("title: {city: [Москва]}", 13, 9, "title.city", "a text is expected here"),
    ("title: {city: \"a\\u202eb\"}", 13, 9, "title.city", "a\N{REPLACEMENT CHARACTER}b: control characters are not allowed"),
    ("loads:", 13, 1, "loads", "there is no value here"),
    ("loads: 5", 13, 1, "loads", "keys with values are expected here"),
    ("loads: {forces: 5}", 13, 9, "loads.forces", "a list in square brackets is expected here"),
    ("loads: {gravity: -9}", 13, 9, "loads.gravity", "-9 is negative: an acceleration cannot be"),
    ("loads: {forces: [{at: Z, direction: left, constant: 5}]}", 13, 19, "loads.forces.0.at", "no link has the point Z"),
    ("loads: {forces: [{at: B, direction: lft, constant: 5}]}", 13, 26, "loads.forces.0.direction", "lft is not a direction"),
    ("loads: {forces: [{at: B, direction: 3 m, constant: 5}]}", 13, 26, "loads.forces.0.direction",
     "3 m is a length (m); expected: an angle (rad)"),
    ("loads: {forces: [{at: B, direction: left}]}", 13, 18, "loads.forces.0", "the load's magnitude must be stated by one law"),
    ("loads: {forces: [{at: B, direction: left, constant: 5, by_position: [1]}]}", 13, 18, "loads.forces.0",
     "the load's magnitude must be stated by one law"),
    ("loads: {forces: [{at: B, direction: left, by_position: [1, 2]}]}", 13, 43, "loads.forces.0.by_position", "2 values, 12 positions"),
    ("loads: {forces: [{at: B, direction: left, by_angle: [[5, 1], [4, 2]]}]}", 13, 43, "loads.forces.0.by_angle",
     "the first numbers of the pairs must ascend"),
    ("loads: {forces: [{at: B, direction: left, by_angle: [[361 deg, 1]]}]}", 13, 55, "loads.forces.0.by_angle.0.0",
     "361 deg is out of range: an angle from 0 … 360 deg is expected"),
    ("loads: {forces: [{at: B, direction: left, constant: 5 MPa}]}", 13, 43, "loads.forces.0.constant",
     "5 MPa is a pressure (MPa); expected: a force (N)"),
    ("loads: {forces: [{at: B, direction: left, by_displacement: {zero: up, forward: [[2, 1]], back: [[0, 1]]}}]}",
     13, 82, "loads.forces.0.by_displacement.forward.0.0", "2 is out of range: a plain number from 0 … 1 is expected"),
    ("loads: {forces: [{at: B, direction: left, piston_diameter: 1 cm,"
     " by_displacement: {zero: up, forward: [[0, 1 N]], back: [[0, 1]]}}]}",
     13, 108, "loads.forces.0.by_displacement.forward.0.1", "1 N is a force (N); expected: a pressure (Pa)"),
    ("loads: {moments: [{on: 7, direction: clockwise, constant: 5}]}", 13, 20, "loads.moments.0.on", "there is no link 7"),
    ("loads: {moments: [{on: 1, direction: clockwise, constant: 5 N}]}", 13, 49, "loads.moments.0.constant",
     "5 N is a force (N); expected: a moment of force (N*m)"),
    ("friction: {guides: {coefficient: 1.5}}", 13, 21, "friction.guides.coefficient",
     "1.5 is out of range: a plain number from 0 … 1 is expected"),
    ("friction: {pivots: {coefficient: 0.1}}", 13, 12, "friction.pivots.diameter", "the key diameter is missing"),
    ("friction: {joints: {Q: {coefficient: 0.1}}}", 13, 21, "friction.joints.Q", "there is no joint Q: neither a point nor a guide"),
    ("positions: {table: 1000000000}", 13, 13, "positions.table",
     "1000000000 is out of range: a whole number from 4 to 360 is expected"),
    ("positions: {table: 12.5}", 13, 13, "positions.table", "12.5 is out of range: a whole number from 4 to 360 is expected"),
    ("positions: {plans: [1, 13]}", 13, 24, "positions.plans.1", "there is no position 13: the table has positions 0 to 12"),
    ("positions: {force_plan: 13}", 13, 13, "positions.force_plan", "there is no position 13: the table has positions 0 to 12"),
    ("drawing: {accuracy: 1 m}", 13, 11, "drawing.accuracy", "1 m is out of range: a length from 0.001 … 2 mm is expected"),
    ("drawing: {scales: {length: 0}}", 13, 20, "drawing.scales.length", "0 is negative or zero: a plain number must be greater than zero"),
    ("drawing: {scales: {force: {2-3: 5 N}}}", 13, 28, "drawing.scales.force.2-3", "5 N is a force (N); expected: a plain number (1)"),
    ("readings: {13: {v_A: 5}}", 13, 12, "readings.13", "there is no position 13: the table has positions 0 to 12"),
    ("readings: {six: {v_A: 5}}", 13, 12, "readings.six", "a number of a position is expected as the key"),
    ("readings: {6: {v_A: .inf}}", 13, 16, "readings.6.v_A", ".inf is not a number; expected: a plain number (1)"),
]  # fmt: skip


@pytest.mark.parametrize(("change", "line", "column", "key", "wrong"), MISTAKES)
def test_mistake(change, line, column, key, wrong):
    text = SMALL + change if isinstance(change, str) else edited(change)
    assert [found[:4] for found in mistakes(text)] == [(line, column, key, wrong)]


@pytest.mark.parametrize(
    ("change", "right"),
    [
        (("speed:", "sped:"), "did you mean speed?"),
        (("slides: x", "slidse: x"), "did you mean slides?"),
        (("x: {through: O}", "x: {throgh: O}"), "did you mean through?"),
        (("300 mm", "300 kg"), "for example, 300 mm"),
        (("    link: 1\n", ""), "one of link: 1, slider: 3, cylinder: [A, B]"),
        (("1200 rpm", "5\n    rotation: cw"), "one of: clockwise, counter-clockwise"),
    ],
)
def test_what_would_be_right(change, right):
    assert right in [found[4] for found in mistakes(edited(change))]


def test_all_mistakes_of_a_file_at_once():
    text = edited(
        ("P: [0.1, 0.2]", "P: [0.1, 1 kg]"), ("{through: O}", "{through: B}"), ("100 mm", "100 nm"),
        ("300 mm", "-300 mm"), ("slides: x", "slides: z"), ("speed: 1200 rpm", "speed: 1200"), ("{B: right}", "{Q: up}"),
        text=SMALL,
    )  # fmt: skip
    text += "loads:\n  forces:\n    - {constant: [5], by_position: [x]}\n    - {at: Z, direction: up, constant: 1}\ntitel: {}\nlanguage: ru\nlanguage: en\n"
    assert [found[2] for found in mistakes(text)] == [
        "mechanism.frame.P.1", "mechanism.guides.x.through", "mechanism.links.1.points.A", "mechanism.links.2.points.B",
        "mechanism.links.3.slides", "mechanism.assembly.Q", "loads.forces.0.at", "loads.forces.0.direction", "loads.forces.0.constant", "loads.forces.0.by_position.0", "loads.forces.1.at", "titel",
        "language",
    ]  # fmt: skip


def test_a_wrong_part_raises_no_second_mistake():
    text = edited(("{A: 0, B: 300 mm}", "{A: 0, B: 300 kg}"), ("link: 1", "link: 1\n    rotation: up"))
    text += "positions: {table: 3}\nloads: {forces: [{at: B, direction: up, by_position: [1, 2, 3]}]}"
    keys = [found[2] for found in mistakes(text)]
    assert keys == ["mechanism.links.2.points.B", "mechanism.driver.rotation", "positions.table"]


def test_missing_parts():
    assert [found[2:4] for found in mistakes("mechanism: {guides: {}}")] == [
        (f"mechanism.{key}", f"the key {key} is missing") for key in ("frame", "links", "driver")
    ]
    for text in ("", "[1]", "just text", "5"):
        assert [found[3] for found in mistakes(text)] == ["the file has no variant"]


def test_messages_carry_nothing_hostile():
    with pytest.raises(ProblemError) as caught:
        loading.loads(SMALL + "title: {city: [a]}\nx\u202e" + "k" * 900 + ": 1\nlanguage: \u2066" + "y" * 900)
    assert "\u202e" not in str(caught.value)
    assert "\u2066" not in str(caught.value)
    assert (
        max(map(len, str(caught.value).splitlines())) < 400
    )  # the blocks that there are, by their names, take 190


def test_locate_finds_the_nearest_key():
    v = loading.loads(SMALL, "v.yaml")
    for path, place in [
        (("mechanism", "links", "2", "points", "B"), (7, 24)), (("mechanism", "links", 2), (7, 5)),
        (("mechanism", "links", "2", "mass", "x"), (7, 5)), (("loads", "forces", 0), (1, 1)), ((), (1, 1)),
    ]:  # fmt: skip
        problem = variant.locate(mistake("wrong", path), v)
        assert (problem.file, problem.line, problem.column, problem.path) == ("v.yaml", *place, path)


def test_load_names_the_file(tmp_path):
    path = tmp_path / "a.yaml"
    path.write_text(SMALL, encoding="utf-8")
    assert loading.load(path).file == str(path)
    path.write_text(SMALL + "x: 1", encoding="utf-8")
    with pytest.raises(ProblemError, match=r"a.yaml:13:1: x: unknown key x"):
        loading.load(path)


# --- the schema, the starting variants, the cost


@cache
def validator():
    schema = loading.schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


@pytest.mark.parametrize("path", VARIANTS, ids=lambda path: path.stem)
def test_every_variant_loads_and_fits_the_schema(path):
    loading.load(path)
    assert [error.message for error in validator().iter_errors(yamlread.read(path).data)] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_starting_variants(language):
    text = variant.new(language)
    assert loading.loads(text).language == language
    assert list(validator().iter_errors(yamlread.loads(text).data)) == []
    assert text.count("#") > 20


def test_the_schema_rejects_what_the_reader_rejects():
    check = validator()
    for change in [
        ("speed:", "sped:"), ("guides:", "guide:"), ("    link: 1\n", ""), ("100 mm", ""), ("100 mm", "[1]"),
        ("{through: O}", "{through: O, z: 1}"), ("[B]", "B"), ("1200 rpm", "5\n    rotation: left"), ("  frame:", "  fram:"),
        ("P: [", "P_: ["),
    ]:  # fmt: skip
        assert not check.is_valid(yamlread.loads(edited(change)).data), change
    assert check.is_valid(yamlread.loads(SMALL).data)


@pytest.mark.exhaustive
def test_the_schema_explains_every_key():
    for name, model in loading.schema()["$defs"].items():
        assert model["description"], name
        for key, about in model.get("properties", {}).items():
            assert {"title", "description", "enum", "$ref"} & about.keys(), (name, key)


@pytest.mark.exhaustive
def test_reading_imports_nothing_heavy():
    program = f"""
import sys
from tmm_report import loading
loading.loads({SMALL!r})
print([name for name in ("scipy", "matplotlib", "jinja2", "jsonschema", "pydantic.json_schema") if name in sys.modules])
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert "scipy" not in done.stdout
    assert "matplotlib" not in done.stdout
    assert "jinja2" not in done.stdout
