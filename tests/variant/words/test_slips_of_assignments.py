"""Slips in the keys by which assignments of collections are stated: each is told once, with its line and its cure.

(Those of a synthesis stand with it: tests/chapters/lever/synthesis.)
"""

import pytest
from catalogues import LATIN_UNIT

from tmm_report import loading
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError
from tmm_report.resources import data_root

RUSSIAN = Translator("ru").gettext
LOADED = """language: en
mechanism:
  frame: {O: [0, 0], C: [0.5, 0.6]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 300 mm, S: 0.4*l_AB}, mass: 30 kg/m, mass_centre: S, inertia: m*l^2/12}
    3: {points: [B], slides: x, mass: 0.5*m2}
  driver: {link: 1, law: {speed: 12 rad/s, harmonic: {amplitude: 0.15 rad}}}
  assembly: {B: right}
positions: {at: [0.03 s, 0.05 s]}
loads:
  forces:
    - {at: B, components: [400 N, -260 N]}
    - {at: B, direction: left, by_time: [[0 s, 0 N], [0.1 s, 300 N], [0.5 s, 0 N]]}
    - {at: B, direction: left, by_angle: [[0, 0], [180 deg, 2 kN], [360 deg, 0]]}
    - {at: B, direction: against motion, constant: 1 kN, stroke: {zero: right, ends: 0.05}}
  moments:
    - {on: 2, direction: clockwise, constant: 1}
  springs: [{between: [B, C], stiffness: 2 kN/m, free_length: 0.3 m}]
  dampers: [{between: [A, C], viscosity: 40 N*s/m}]
"""
LAW = "link: 1, law: {speed: 12 rad/s, harmonic: {amplitude: 0.15 rad}}"
DRIVEN = (
    LOADED.replace(LAW, "slider: 3, stroke: {from: 0.25 m, to: 0.35 m, speed: 1.2 m/s}")
    .split("positions:")[0]
    .replace("assembly: {B: right}", "assembly: {A: left of O-B}")
)
WHEELS = """language: en
mechanism:
  frame: {O: [0, 0], C: [0.3, 0], P: [0, 0.5]}
  guides: {x: {through: P}}
  links: {1: {points: {O: 0, A: 100 mm}}, 2: {points: {C: 0, B: 100 mm}}, 3: {points: {A: 0, D: 0.4}},
    4: {points: {B: 0, D: 0.4}}}
  driver: {link: 1, speed: 60 rpm}
  assembly: {D: left of A-B}
  wheels:
    - {links: [1, 2], teeth: [30, 30]}
"""
PRESS = (data_root() / "variants" / "press_flywheel.yaml").read_text(encoding="utf-8")
FIND = "language: en\n" + PRESS.partition("language: ru\n")[2]
SLIPS = [  # text, what is replaced by what, line, key, cure
    (LOADED, "speed: 12 rad/s, harm", "speed: 12 rad, harm",
     9, "mechanism.driver.law.speed", "expected: an angular velocity (rad/s);"),
    (LOADED, "amplitude: 0.15 rad", "amplitude: 15 mm",
     9, "mechanism.driver.law.harmonic.amplitude", "expected: an angle (rad); for example, 20"),
    (LOADED, "harmonic: {amplitude: 0.15 rad}", "harmonic: 0.15 rad",
     9, "mechanism.driver.law.harmonic", "for example, harmonic: {amplitude: 35"),
    (LOADED, "harmonic: {amplitude: 0.15 rad}", "acceleration: 4 rad/s",
     9, "mechanism.driver.law.acceleration", "expected: an angular acceleration"),
    (LOADED, "harmonic: {amplitude: 0.15 rad}", "harmonic: {amplitude: 0.15 rad}, acceleration: 4",
     9, "mechanism.driver.law", "one of acceleration: 5 rad/s^2; harmonic:"),
    (LOADED, LAW, "link: 1, law: sine", 9, "mechanism.driver.law", "for example, law: {speed: 10 rad/s,"),
    (LOADED, "link: 1, law:", "link: 1, speed: 60 rpm, law:",
     9, "mechanism.driver", "either speed: 1200 rpm or period: 0.05 s"),
    (LOADED, LAW, "link: 1, speed: 60 rpm, acceleration: 3",
     9, "mechanism.driver.acceleration", "how the driving link moves, if not"),
    (LOADED, LAW, "link: 1, speed: 60 об/мин, rotation: вправо",
     9, "mechanism.driver.rotation", "one of: clockwise, counter-clockwise"),
    (LOADED, "[400 N, -260 N]", "[400 N]",
     14, "loads.forces.0.components", "for example, components: [400 N, -2600 N]"),
    (LOADED, "[400 N, -260 N]", "400 N, -260 N", 14, "loads.forces.0.components", "write components: [400 N, -260 N]"),
    (LOADED, "components: [400 N, -260 N]", "components: [400 N, -260 N], direction: left",
     14, "loads.forces.0.direction", "the components state the force and its"),
    (LOADED, "[400 N, -260 N]", "[400 kg, -260 N]",
     14, "loads.forces.0.components.0", "expected: a force (N); did you mean 400 kgf?"),
    (LOADED, "[400 N, -260 N]", "[400 кгс, -260 Н], по_y: 3",
     14, "loads.forces.0.по_y", "known: at, components, name, on, stroke"),
    (LOADED, "[[0 s, 0 N], [0.1 s", "[[0 s, 0 N], [100 deg",
     15, "loads.forces.1.by_time.1.0", "expected: a time (s); for example, 0.05 s"),
    (LOADED, "[[0 s, 0 N], [0.1 s, 300 N], [0.5 s, 0 N]]", "[[0.1 s, 0 N], [0 s, 300 N], [0.5 s, 0 N]]",
     15, "loads.forces.1.by_time", "the first numbers of the pairs must ascend"),
    (LOADED, "[0.5 s, 0 N]]}", "[0.5 s, 0 N]], constant: 2}",
     15, "loads.forces.1", "exactly one of: constant, by_position,"),
    (LOADED, "[180 deg, 2 kN]", "[180, 2 kN]", 16, "loads.forces.2.by_angle.1.0", "did you mean 180 deg?"),
    (LOADED, "[180 deg, 2 kN]", "[400 deg, 2 kN]",
     16, "loads.forces.2.by_angle", "the first numbers of the pairs must ascend"),
    (LOADED, "by_angle", "by_angel", 16, "loads.forces.2.by_angel", "did you mean by_angle?"),
    (LOADED, "ends: 0.05", "ends: 0.6", 17, "loads.forces.3.stroke.ends", "0.6 is out of range: a plain number from"),
    (LOADED, "ends: 0.05", "ends: 5 mm", 17, "loads.forces.3.stroke.ends", "expected: a plain number (1); for"),
    (LOADED, "zero: right, ends", "zero: rechts, ends",
     17, "loads.forces.3.stroke.zero", "one of: right, left, up, down"),
    (LOADED, "constant: 1 kN, stroke:", "by_angle: [[0, 0], [180 deg, 2 kN]], stroke:",
     17, "loads.forces.3", "constant with stroke, or by_displacement"),
    (LOADED, "stiffness: 2 kN/m", "stiffness: 2 kN",
     20, "loads.springs.0.stiffness", "expected: a stiffness (N/m); for example,"),
    (LOADED, "stiffness: 2 kN/m, ", "rate: 2 kN/m, ", 20, "loads.springs.0.rate", "did you mean stiffness?"),
    (LOADED, "free_length: 0.3 m", "free_length: 0.3 m, preload: 20 N",
     20, "loads.springs.0", "either free_length: 240 mm or preload:"),
    (LOADED, ", free_length: 0.3 m", "", 20, "loads.springs.0", "either free_length: 240 mm or preload:"),
    (LOADED, "between: [B, C]", "between: [B, Q]", 20, "loads.springs.0.between.1", "known: O, C, A, B, S"),
    (LOADED, "between: [B, C]", "between: [O, C]", 20, "loads.springs.0.between", "one of the points on a moving link"),
    (LOADED, "between: [B, C]", "between: [A, B]", 20, "loads.springs.0.between", "points of two links"),
    (LOADED, "between: [B, C]", "between: B", 20, "loads.springs.0.between", "for example, between: [B, K]"),
    (LOADED, "viscosity: 40 N*s/m", "viscosity: 40 N/m",
     21, "loads.dampers.0.viscosity", "expected: a damping (N*s/m); for example,"),
    (LOADED, "viscosity: 40 N*s/m", "damping: 40 N*s/m", 21, "loads.dampers.0.damping", "did you mean viscosity?"),
    (LOADED, "springs: [{between: [B, C], stiffness: 2 kN/m, free_length: 0.3 m}]",
     "springs: {between: [B, C], stiffness: 2 kN/m, free_length: 0.3 m}",
     20, "loads.springs", "begin each item with - and a space"),
    (LOADED, "0.4*l_AB", "0.4*l_AQ", 7, "mechanism.links.2.points.S", "one of l_AB"),
    (LOADED, "0.5*m2", "0.5*m9", 8, "mechanism.links.3.mass", "one of m1, m2, m3"),
    (LOADED, "0.5*m2", "0.5*m3", 8, "mechanism.links.3.mass", "a mass, 30 kg/m of its length, or the"),
    (LOADED, "m*l^2/12", "m*l/12", 7, "mechanism.links.2.inertia", "a mass times a length squared, such as"),
    (LOADED, "m*l^2/12", "m*l^2/12 + 3", 7, "mechanism.links.2.inertia", "a mass times a length squared, such as"),
    (LOADED, "mass: 30 kg/m", "mass: 3 tonnes",
     7, "mechanism.links.2.mass", "expected: a mass (kg); for example, 1.5 kg"),
    (LOADED, "2 kN]", "2 dyn]", 16, "loads.forces.2.by_angle.1.1", "expected: a force (N); for example, 2 kN"),
    (LOADED, "constant: 1 kN", "constant: 3 л.с.",
     17, "loads.forces.3.constant", "expected: a force (N); for example, 2 kN"),
    (LOADED, "100 mm", "4 дюйма", 6, "mechanism.links.1.points.A", "expected: a length (m); for example, 300"),
    (LOADED, "at: [0.03 s, 0.05 s]", "at: [0.03 s, 5 mm]",
     11, "positions.at.1", "only where a slider or a cylinder drives"),
    (LOADED, "at: [0.03 s, 0.05 s]", "at: 40 deg", 11, "positions.at", "for example, at: [40 deg, 100 deg]"),
    (LOADED, "direction: against motion", "direction: против",
     17, "loads.forces.3.direction", "right, left, up, down, an angle (30 deg),"),
    (LOADED, "direction: against motion", "направление: против движения",
     17, "loads.forces.3.направление", "keys are English words: direction"),
    (LOADED, "direction: clockwise", "direction: left",
     19, "loads.moments.0.direction", "one of: clockwise, counter-clockwise,"),
    (LOADED, "on: 2, direction", "at: B, direction", 19, "loads.moments.0.at", "did you mean on?"),
    (DRIVEN, "slider: 3, stroke", "slider: 2, stroke",
     9, "mechanism.driver.slider", "its guide on the frame: guides: {x:"),
    (DRIVEN, "slider: 3, stroke: {from: 0.25 m, to: 0.35 m, speed: 1.2 m/s}", "slider: 3, speed: 1.2 m/s",
     9, "mechanism.driver", "{slider: 3, stroke: {from: 0.35 m, to:"),
    (DRIVEN, "from: 0.25 m, ", "", 9, "mechanism.driver.stroke", "for example, {from: 1.10 m, speed: 0.15"),
    (DRIVEN, "to: 0.35 m", "to: 0.95 m", 9, "mechanism.driver.stroke", "a stroke that ends before it"),
    (DRIVEN, "to: 0.35 m", "to: 0.25 m", 9, "mechanism.driver.stroke", "from and to that differ, or a speed or an"),
    (DRIVEN, "speed: 1.2 m/s", "speed: 1.2 rpm",
     9, "mechanism.driver.stroke.speed", "expected: a velocity (m/s); for example,"),
    (DRIVEN, "speed: 1.2 m/s", "accelerations: [[0.4 s, 0.375 m/s]]",
     9, "mechanism.driver.stroke.accelerations.0.1", "expected: an acceleration (m/s^2); for"),
    (DRIVEN, "slider: 3, stroke", "cylinder: [A, Q], stroke", 9, "mechanism.driver.cylinder.1", "known: O, C, A, B, S"),
    (DRIVEN, "slider: 3, stroke", "cylinder: [O, C], stroke", 9, "mechanism.driver.cylinder", "fixed points: O, C"),
    (FIND, "flywheel.delta: 0", "flywheel.dleta: 0", 4, "find.unknown.flywheel.dleta", "did you mean delta?"),
    (FIND, "flywheel.delta: 0.01 .. 0.1", "flywheel.delta: 0.1 .. 0.01",
     4, "find.unknown.flywheel.delta", "write the smaller number first"),
    (FIND, "flywheel.delta: 0.01 .. 0.1", "flywheel.delta: 0.05",
     4, "find.unknown.flywheel.delta", "write both ends, for example 0.01 .. 0.1"),
    (FIND, "so_that:", "demand:", 5, "find.demand", "did you mean so_that?"),
    (FIND, "flywheel_D: 800 mm", "flywheel_D: about 800 mm",
     5, "find.so_that.flywheel_D", "expected: a plain number (1); for"),
    (FIND, "  so_that: {flywheel_D: 800 mm}\n", "", 3, "find", "so_that: {key: value}, greatest: key or"),
    (WHEELS, "teeth: [30, 30]", "teeth: [30, 30.5]",
     10, "mechanism.wheels.0.teeth.1", "30.5 is out of range: a whole number from"),
    (WHEELS, "teeth: [30, 30]", "teeth: [30]", 10, "mechanism.wheels.0.teeth", "a value of the list is missing"),
    (WHEELS, "teeth: [30, 30]", "ratio: 2, teeth: [30, 30]",
     10, "mechanism.wheels.0", "teeth: [20, 40], radii: [100 mm, 200 mm]"),
    (WHEELS, "links: [1, 2], teeth", "links: [1, 3], teeth",
     10, "mechanism.wheels.0.links.1", "the link that holds both axes, or a point of the frame (O, C, P)"),
    (WHEELS, "links: [1, 2], teeth", "links: [1, 7], teeth", 10, "mechanism.wheels.0.links.1", "known: 1, 2, 3, 4"),
    (WHEELS, "teeth: [30, 30]", "teeth: [30, 30], mesh: angular",
     10, "mechanism.wheels.0.mesh", "one of: external, internal"),
    (WHEELS, "teeth: [30, 30]", "radii: [100 mm, 150 mm]",
     10, "mechanism.wheels.0.radii", "radii: [120 mm, 180 mm] in the same"),
    (WHEELS, "teeth: [30, 30]", "teeth: [30, 30], module: 40 mm",
     10, "mechanism.wheels.0.module", "module: 10 mm, or leave it out; or axes"),
    (WHEELS, "  wheels:\n    - {links: [1, 2], teeth: [30, 30]}",
     "  racks: [{slider: 3, wheel: 1, radius: 48 mm}]\n  wheels: [{links: [1, 2], teeth: [30, 30]}]",
     9, "mechanism.racks.0.slider", "slides: a guide of the frame"),
]  # fmt: skip


IDS = [f"{one[4]}-{n}" for n, one in enumerate(SLIPS)]


@pytest.mark.parametrize("text", [LOADED, DRIVEN, WHEELS, FIND], ids=["loaded", "driven", "wheels", "find"])
def test_the_texts_themselves_are_right(text):
    assert loading.loads(text)


@pytest.mark.parametrize(("text", "right", "wrong", "line", "key", "cure"), SLIPS, ids=IDS)
def test_a_slip_is_told_once_with_its_line_and_cure(text, right, wrong, line, key, cure):
    assert text.count(right) == 1
    with pytest.raises(ProblemError) as caught:
        loading.loads(text.replace(right, wrong))
    (told,) = caught.value.problems
    assert (told.line, told.key) == (line, key)
    assert cure in told.text()
    echoed = told.right is None or told.right.text == "write %(text)s"  # as the file has it
    assert echoed or not LATIN_UNIT.search(told.right.render(RUSSIAN))


def test_there_are_many_slips_of_every_kind():
    assert len({(key, wrong) for _, _, wrong, _, key, _ in SLIPS}) >= 40
