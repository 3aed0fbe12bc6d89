"""Questions as textbooks ask them (own numbers), typed as they stand: each answer worked again by hand or by a solver
that shares no code with the program."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from test_find import number_of, results_of

from tmm_report import course, loading
from tmm_report.problems import ProblemError

CLUTCH = """language: en
contacts:
  - {kind: pivot, outer: 150 mm, inner: 100 mm, surfaces: 2, load: 3 kN, coefficient: 0.3, speed: 2500 rpm}
"""
CONE = """language: en
contacts:
  - {kind: pivot, outer: 100 mm, ratio: 0.5, half_cone: 60 deg, load: 20 kN, coefficient: 0.1, speed: 200 rpm}
"""
COLLARS = """language: en
contacts:
  - {kind: pivot, outer: 300 mm, %s, collars: 3, load: 200 kN, coefficient: 0.03, speed: 75 rpm}
"""
RIM = """language: en
flywheel:
  delta: 2 %
  speed: 250 rpm
  areas: {values: [21, -21], scale: 1 kJ}
  rim: {height: 0.1, width: 2, spokes: 0.05, diameter: 2.2 m}
  material: {density: 7200 kg/m^3, stress: 6 MPa}
"""
CHAIN = """language: en
efficiency:
  input: 11 kW
  series:
    - {name: motor, efficiency: 0.92}
    - parallel:
        - {share: 0.6, efficiency: 0.8}
        - series: [{name: gearbox, efficiency: 0.95}, {name: fan, efficiency: 0.7}]
"""
LIFT = """language: en
dynamics:
  parts:
    - {name: drum, inertia: 1000 kg*m^2}
    - {name: cage, radius: 600 mm, mass: 1000 kg, moves: up}
  motor: {constant: 5 kN*m}
"""
GEARED = """language: en
dynamics:
  parts:
    - {name: rotor, on: motor, inertia: 0.2 kg*m^2}
    - {name: drum, inertia: 8 kg*m^2}
    - {name: load, radius: 250 mm, mass: 300 kg, moves: up}
  motor: {constant: 60 N*m, ratio: 20}
"""
PRESS = """language: en
dynamics:
  speed: 48 rpm
  period: 360 deg
  parts: [{name: flywheel, on: motor, inertia: 5 kg*m^2}]
  motor: {induction: {power: 5.5 kW, speed: 960 rpm, synchronous: 1000 rpm, overload: 2.2}, ratio: 20}
  resistance:
    - {name: press, by_angle: [[0, 400 N*m], [15 deg, 400 N*m], [15 deg, 6000 N*m], [60 deg, 6000 N*m],
       [60 deg, 400 N*m], [360 deg, 400 N*m]]}
"""
VALVE = """language: en
mechanism:
  frame: {O: [0, 0], P: [0, 200 mm]}
  guides: {y: {through: O, angle: 90 deg}}
  links:
    1: {points: {O: 0}}
    2: {points: {B: 0, D: 100 mm}, mass: 1.2 kg, mass_centre: B, slides: y}
  cams:
    k:
      follower: 2
      roller: {at: B, radius: 15 mm}
      base: 30 mm
      lift: 25 mm
      phases: [{rise: 120 deg, law: cosine}, {dwell: 30 deg}, {return: 120 deg, law: cosine}, {dwell: 90 deg}]
  driver: {link: 1, speed: 600 rpm}
loads:
  springs: [{between: [D, P], stiffness: 8 N/mm, preload: -150 N}]
"""


def answered(text, find):
    """The unknown, and by the textbook's formula where there is one."""
    found = results_of(text, find).find
    assert found.sound
    return found.size(found.chosen.at), found.closed and found.closed.number


# text, question, the answer by hand
BY_HAND = {
    "load of a clutch for its greatest pressure": (
        CLUTCH,
        "{unknown: {contacts.0.load: 1 kN .. 50 kN}, so_that: {contacts_1.p_max: 0.1 MPa}}",
        2 * math.pi * 1e5 * 0.1 * 0.05,
    ),
    "outer radius of a clutch for its greatest pressure": (
        CLUTCH,
        "{unknown: {contacts.0.outer: 110 mm .. 500 mm}, so_that: {contacts_1.p_max: 0.1 MPa}}",
        0.1 + 3000 / (2 * math.pi * 1e5 * 0.1),
    ),
    "radii of a conical pivot, one by the other": (
        CONE,
        "{unknown: {contacts.0.outer: 20 mm .. 300 mm}, so_that: {contacts_1.p_mean: 0.3 MPa}}",
        math.sqrt(20e3 / (math.pi * 0.3e6 * 0.75)),
    ),
    "radii of a run-in pivot, one by the other": (
        CONE,
        "{unknown: {contacts.0.outer: 20 mm .. 300 mm}, so_that: {contacts_1.p_max: 0.3 MPa}}",
        math.sqrt(20e3 / (2 * math.pi * 0.3e6 * 0.25)),
    ),
    "collars that share the load": (
        COLLARS % "inner: 150 mm",
        "{unknown: {contacts.0.outer: 160 mm .. 500 mm}, so_that: {contacts_1.p_mean: 0.35 MPa}}",
        math.sqrt(200e3 / (3 * math.pi * 0.35e6) + 0.15**2),
    ),
    "load of collars": (
        COLLARS % "ratio: 1/2",
        "{unknown: {contacts.0.load: 20 kN .. 900 kN}, so_that: {contacts_1.p_mean: 0.35 MPa}}",
        3 * math.pi * 0.35e6 * 0.3**2 * 0.75,
    ),
    "torque of a hoist for an acceleration": (
        LIFT,
        "{unknown: {dynamics.motor.constant: 1 kN*m .. 20 kN*m}, so_that: {dynamics_epsilon: 5/3}}",
        (1000 + 1000 * 0.6**2) * 5 / 3 + 1000 * 9.81 * 0.6,
    ),
    "best ratio of a hoist": (
        GEARED,
        "{unknown: {dynamics.motor.ratio: 2 .. 200}, greatest: dynamics_epsilon}",
        735.75 / 60 + math.sqrt((735.75 / 60) ** 2 + 26.75 / 0.2),
    ),
}


@pytest.mark.parametrize("case", BY_HAND)
def test_the_formula_beside_the_root_is_the_answer_by_hand(case):
    text, find, right = BY_HAND[case]
    root, formula = answered(text, find)
    assert formula == pytest.approx(right, rel=1e-12)
    assert root == pytest.approx(right, rel=1e-7 if "greatest: " in find else 1e-11)


def test_power_of_a_clutch_of_two_pairs_of_surfaces():
    """2 f Q (R + r)/2 ω of a run-in one."""
    find = BY_HAND["load of a clutch for its greatest pressure"][1]
    power = number_of(results_of(CLUTCH, find), "contacts_1.P_wear.0")
    assert power == pytest.approx(2 * 0.3 * 1000 * math.pi * 0.125 * 2500 * math.pi / 30, rel=1e-11)


def test_diameter_of_a_rim_for_its_stress():
    """ρ v² = σ at the outer diameter, where the machine is fastest."""
    find = "{unknown: {flywheel.rim.diameter: 1 m .. 4 m}, so_that: {flywheel_sigma: 6 MPa}}"
    results = results_of(RIM, find)
    fastest = 250 * math.pi / 30 * 1.01
    outer = 2 * math.sqrt(6e6 / 7200) / fastest
    assert number_of(results, "flywheel_v_lim") == pytest.approx(math.sqrt(6e6 / 7200), rel=1e-12)
    assert number_of(results, "flywheel_D_out") == pytest.approx(outer, rel=1e-10)
    wheel = 21e3 / (0.02 * (250 * math.pi / 30) ** 2)

    def missing(mean):
        """Of the moment of inertia of a rim with 5 % of it in the spokes: m (D² + h²)/4, b = 2 h."""
        h = outer - mean
        return math.pi * mean * 2 * h**2 * 7200 * (mean**2 + h**2) / 4 / 0.95 - wheel

    assert results.find.size(results.find.chosen.at) == pytest.approx(
        brentq(missing, 1.5, outer * 0.999), rel=1e-9
    )


def test_share_of_the_power_that_a_chain_leaves_to_the_other_part():
    root, _ = answered(
        CHAIN, "{unknown: {efficiency.series.1.parallel.0.share: 0.1 .. 0.9}, so_that: {eta_whole: 0.7}}"
    )
    assert root == pytest.approx((0.7 / 0.92 - 0.95 * 0.7) / (0.8 - 0.95 * 0.7), rel=1e-11)


def test_an_efficiency_deep_in_a_chain():
    find = "{unknown: {efficiency.series.1.parallel.1.series.fan.efficiency: 0.2 .. 0.9}, so_that: {eta_whole: 0.6}}"
    root, _ = answered(CHAIN, find)
    assert root == pytest.approx((0.6 / 0.92 - 0.6 * 0.8) / (0.4 * 0.95), rel=1e-11)


def torque(slip):
    """Kloss, on the main shaft of the press."""
    nominal = 5500 / (960 * math.pi / 30)
    critical = 0.04 * (2.2 + math.sqrt(2.2**2 - 1))
    return 20 * 2 * 2.2 * nominal / (slip / critical + critical / slip)


def greatest_torque(inertia):
    """Over the steady cycle, by Runge and Kutta over the angle, cycle after cycle."""
    ends, loads = (0, math.pi / 12, math.pi / 3, 2 * math.pi), (400, 6000, 400)
    synchronous, omega, most = 1000 * math.pi / 30 / 20, 5.0, 0.0
    for _ in range(30):
        most, begin = 0.0, omega
        for k, load in enumerate(loads):
            law = lambda _, w, load=load: (torque(1 - w / synchronous) - load) / (400 * inertia * w)  # noqa: E731
            found = solve_ivp(law, ends[k : k + 2], [omega], rtol=1e-10, atol=1e-12, max_step=0.01)
            most = max(most, *torque(1 - found.y[0] / synchronous))
            omega = found.y[0][-1]
        if abs(omega - begin) < 1e-11:
            break
    return most


def test_inertia_of_a_flywheel_for_the_greatest_moment_of_the_motor():
    find = "{unknown: {dynamics.parts.flywheel.inertia: 2 .. 60}, so_that: {dynamics_M_dr_max: 1600 N*m}}"
    root, _ = answered(PRESS, find)
    assert greatest_torque(root) == pytest.approx(1600, rel=1e-5)


def test_speed_at_which_a_follower_leaves_its_cam():
    """Least of (g + spring/m)/|s″| where the law slows down: of a cosine s″ = h/2 (π/φ)² cos."""
    root, _ = answered(
        VALVE, "{unknown: {mechanism.driver.speed: 100 rpm .. 3000 rpm}, so_that: {cam_press_min_k: 0}}"
    )
    part = np.linspace(0.5, 1, 200001)[1:]  # of the rise, where it slows down
    lift = 0.0125 * (1 - np.cos(np.pi * part))
    slowed = 0.0125 * 1.5**2 * -np.cos(np.pi * part)
    least = np.min((1.2 * 9.81 + 150 + 8000 * lift) / (1.2 * slowed))
    assert root == pytest.approx(math.sqrt(least), rel=1e-8)


@pytest.mark.parametrize(
    "inertia",
    [
        "inertia: 250 kg * (600 mm)^2",
        "inertia: 250 кг·(600 мм)²",
        "mass: 250 kg, radius_of_gyration: 0.6 m",
        "inertia: 90",
    ],
)
def test_a_start_of_shafts_by_mass_and_radius_of_gyration(inertia):
    """t = ω (J_1 + J_2 i²/η)/M."""
    text = f"""dynamics:
  losses_of_acceleration: true
  parts:
    - {{name: motor, mass: 60 kg, radius_of_gyration: 200 mm}}
    - {{name: drum, ratio: 1/5, {inertia}, efficiency: 0.9}}
  motor: {{constant: 100 N*m}}
  start: {{speed: 100 rad/s}}
"""
    found = course.solve(loading.loads(text)).dynamics
    assert found.s.number("t_start") == pytest.approx(100 * (2.4 + 90 / 25 / 0.9) / 100, rel=1e-9)


@pytest.mark.parametrize(
    ("text", "path", "said"),
    [
        (
            "dynamics: {parts: [{name: a, mass: 1, radius: 1, radius_of_gyration: 1}], motor: {constant: 9}}",
            "dynamics.parts.0.radius_of_gyration",
            "is a part of its own",
        ),
        (
            CONE.replace("ratio: 0.5", "ratio: 0.5, inner: 10 mm"),
            "contacts.0",
            "at most one of: inner, ratio",
        ),
        (
            RIM.replace("stress: 6 MPa", "stress: 6 MPa, speed: 30 m/s"),
            "flywheel.material",
            "exactly one of: speed, stress",
        ),
        (
            RIM.replace("stress: 6 MPa", "strength: 6 MPa"),
            "flywheel.material.strength",
            "density, speed, stress",
        ),
        (RIM.replace("2 %", "2/0"), "flywheel.delta", "nothing can be divided by zero"),
        (CHAIN.replace("share: 0.6", "share: 1"), "efficiency.series.1.parallel", "less than 1"),
        ("critical_speed: {length: 0.6 m}", "critical_speed", "the critical speed is the natural frequency"),
        (
            "vibration: {mass: 1, eccentricity: 1 mm, stiffness: 9, force: 1, speed: 1}",
            "vibration.eccentricity",
            "whirls",
        ),
        (
            "vibration: {mass: 1, deflection: 1 mm, stiffness: 9, force: 1, speed: 1}",
            "vibration.deflection",
            "the other follows",
        ),
        (
            "engine: {speed: 9, crank_radius: 1, rod_length: 4, reciprocating: 1, cylinders: [{reciprocating: 2}]}",
            "engine.cylinders.0.reciprocating",
            "different masses are not offered",
        ),
        (
            "governor: {arms: {upper: 1, lower: 1}, gyroscope: {a: 1}}",
            "governor.gyroscope",
            "gyroscopic moments",
        ),
    ],
)
def test_what_is_said_of_slips(text, path, said):
    with pytest.raises(ProblemError) as error:
        loading.loads(text if text.startswith("language") else f"language: en\n{text}\n")
    told = {
        ".".join(map(str, one.path)): str(one.right or one.wrong) + str(one.wrong)
        for one in error.value.problems
    }
    assert said in told[path]


def test_columns_of_a_pair_are_all_named():
    with pytest.raises(ProblemError, match="P_pressure, P_wear"):
        results_of(CONE, "{unknown: {contacts.0.outer: 20 mm .. 300 mm}, so_that: {contacts_1.M: 3}}")
