"""Published worked examples of friction: through the formulas, through variants of single pairs, and the engine with
friction circles through the force analysis of a solved mechanism, too."""

from __future__ import annotations

import math

import pytest
from cases import agrees, case

from tmm_report import course, loading
from tmm_report.mechanics.pairs import friction as law

INCH, RPM = 0.0254, math.pi / 30


def pair(text: str) -> dict[str, float]:
    """The numbers of the one pair that a variant states."""
    found = course.solve(loading.loads(f"language: en\ncontacts:\n  - {{{text}}}\n")).contacts
    assert found is not None
    return {one.key: one.value for one in found.items[0].s.values()}


def given(name: str) -> dict[str, float]:
    return case(name)["inputs"]


def test_pull_and_push():
    of = given("khurmi-10-1-pull-push")
    f, weight = law.pulled_and_pushed(of["P1"], of["P2"], math.radians(of["theta_deg"]))
    agrees("khurmi-10-1-pull-push", mu=f, W_N=weight)
    found = pair("kind: trial, angle: 30 deg, pull: 180 N, push: 220 N")
    agrees("khurmi-10-1-pull-push", mu=found["f"], W_N=found["G"])


def test_screw_with_a_handwheel():
    """The source takes tan for arctan of the coefficient of friction."""
    of = given("khurmi-10-7-screw-wheel")
    d, load = of["d_mm"] / 1e3, of["W_N"]
    thread = law.screw_moment(load, d, law.lead_angle(of["p_mm"] / 1e3, d), law.angle(of["mu"]))
    moment = thread + of["mu_c"] * load * of["R_c_mm"] / 1e3
    agrees("khurmi-10-7-screw-wheel", D_m=moment / of["P_N"])
    found = pair(
        "kind: screw, diameter: 50 mm, pitch: 12.5 mm, coefficient: 0.15, load: 10 kN, hand_force: 100 N, "
        "collar: {coefficient: 0.18, radius: 30 mm}"
    )
    agrees("khurmi-10-7-screw-wheel", D_m=found["D_wheel"])


def test_screw_with_a_v_thread():
    """The source takes tan for arctan of the reduced coefficient."""
    of = given("khurmi-10-14-v-thread")
    d, load = of["d_mm"] / 1e3, of["W_N"]
    phi = law.reduced_angle(of["mu"], math.radians(of["beta_deg"]))
    thread = law.screw_moment(load, d, law.lead_angle(of["p_mm"] / 1e3, d), phi)
    agrees("khurmi-10-14-v-thread", P_N=(thread + of["mu_c"] * load * of["R_c_mm"] / 1e3) / of["L_m"])
    found = pair(
        "kind: screw, diameter: 25 mm, pitch: 5 mm, profile: 27.5 deg, coefficient: 0.1, load: 10 kN, arm: 0.5 m, "
        "collar: {coefficient: 0.16, radius: 25 mm}"
    )
    agrees("khurmi-10-14-v-thread", P_N=found["P_hand"])


def test_conical_pivot():
    of = given("khurmi-10-18-cone-pivot")
    about = of["W_N"], of["mu"], of["r1_mm"] / 1e3, 0.0, math.radians(of["half_cone_deg"])
    omega = of["N"] * RPM
    pressure, wear = law.pivot_pressure(*about) * omega, law.pivot_wear(*about) * omega
    agrees("khurmi-10-18-cone-pivot", P_pressure_W=pressure, P_wear_W=wear, P_pressure_kW=pressure / 1e3)
    found = pair(
        "kind: pivot, outer: 100 mm, half_cone: 60 deg, coefficient: 0.025, load: 30 kN, speed: 140 rpm"
    )
    agrees("khurmi-10-18-cone-pivot", P_pressure_W=found["P_pressure"], P_wear_W=found["P_wear"])


def test_pair_of_wedges():
    of = given("bevan-6-1-wedge-pair")
    theta, both = math.radians(of["theta_deg"]), law.angle(of["mu1"]) + law.angle(of["mu2"])
    agrees(
        "bevan-6-1-wedge-pair",
        eta_percent=100 * law.best_guided_pair(theta, both),
        alpha_deg=math.degrees(law.best_face(theta, both)),
    )
    found = pair("kind: sliders, between: 60 deg, coefficient: 0.1, guides: 0.15")
    agrees("bevan-6-1-wedge-pair", eta_percent=100 * found["eta"], alpha_deg=found["alpha"])


def test_capstan():
    of = given("khurmi-11-5-capstan")
    slack = law.slack(of["T1_N"], of["mu"], of["theta_rad"])
    power = (of["T1_N"] - slack) * of["N"] * RPM * of["d_m"] / 2
    agrees("khurmi-11-5-capstan", T2_N=slack, P_kW=power / 1e3)
    found = pair("kind: belt, wrap: 900 deg, tight: 9 kN, coefficient: 0.25, diameter: 300 mm, speed: 20 rpm")
    agrees("khurmi-11-5-capstan", T2_N=found["T_2"], P_kW=found["P"] / 1e3)


def test_open_belt():
    of = given("khurmi-11-14-open-belt")
    driving = of["d2"] * of["N2"] / of["N1"]
    tight = of["sigma"] * of["b"] * of["t"]
    slack = law.slack(tight, of["mu"], law.open_wrap(driving, of["d2"], of["x"]))
    power = (tight - slack) * of["N1"] * RPM * driving / 2
    agrees("khurmi-11-14-open-belt", d1_m=driving, P_kW=power / 1e3, T0_N=(tight + slack) / 2)
    found = pair(
        "kind: belt drive, driven: 0.4 m, speed: 350 rpm, driven_speed: 140 rpm, distance: 1.2 m, width: 80 mm, "
        "thickness: 5 mm, stress: 1.4 MPa, coefficient: 0.3"
    )
    agrees("khurmi-11-14-open-belt", d1_m=found["d_1"], P_kW=found["P"] / 1e3, T0_N=found["T_0"])


def crank(of: dict[str, float]) -> tuple[float, float, float]:
    """Moments without friction and with it, of a force of 1, in; and the efficiency."""
    r, turned, mu = of["stroke_in"] / 2, math.radians(of["theta_deg"]), of["mu"]
    shaft, pin, wrist = (mu * of[f"r{k}_in"] for k in (1, 2, 3))
    plain = law.tilted_rod(turned, r, 0.0, of["l_in"])
    tilt = law.tilted_rod(turned, r, pin + wrist, of["l_in"])
    ideal = law.crank_moment(of["P"], turned, r, plain, 0.0)
    moment = law.crank_moment(of["P"], turned, r, tilt, shaft + pin)
    return ideal, moment, moment / ideal


def test_friction_circles():
    ideal, moment, eta = crank(given("bevan-6-7-friction-circles"))  # ton in
    agrees("bevan-6-7-friction-circles", Ma=ideal / 12, Mb=moment / 12, eta_percent=100 * eta)
    found = pair(
        "kind: crank, force: 6 kN, crank: 203.2 mm, rod: 2032 mm, angle: 60 deg, coefficient: 0.05, "
        "journals: {shaft: 355.6 mm, crank_pin: 762 mm, wrist_pin: 223.52 mm}"
    )
    foot = 1e3 * INCH * 12  # N m in a kN ft
    agrees(
        "bevan-6-7-friction-circles",
        Ma=found["M_ideal"] / foot,
        Mb=found["M_crank"] / foot,
        eta_percent=100 * found["eta"],
    )


ENGINE = """
language: en
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 203.2 mm}}
    2: {points: {A: 0, B: 2032 mm}}
    3: {points: [B], slides: x}
  driver: {link: 1, speed: 60 rpm, rotation: counter-clockwise}
  assembly: {B: right}
loads:
  gravity: 0
  forces: [{at: B, direction: left, constant: 6 kN}]
friction:
  joints:
    O: {coefficient: 0.05, diameter: 355.6 mm}
    A: {coefficient: 0.05, diameter: 762 mm}
    B: {coefficient: 0.05, diameter: 223.52 mm}
  corrected: true
positions: {table: 12}
"""


@pytest.fixture(scope="module")
def engine():
    return course.solve(loading.loads(ENGINE)).lever.friction.corrected.table


def test_friction_circles_by_the_force_analysis(engine):
    """The crank is 60° past the dead point at position 2; the piston drives, so the balancing moment brakes."""
    foot = 1e3 * INCH * 12
    ideal, moment = (float(of[2]) / foot for of in (engine.without, engine.moment))
    agrees("bevan-6-7-friction-circles", Ma=abs(ideal), Mb=abs(moment), eta_percent=100 * moment / ideal)


def test_two_loads_of_a_hoist_as_machines_joined():
    """Power of the motor of two branches side by side, each with its efficiency and its useful power."""
    of = given("dubey-2-1-two-loads")
    omega = of["N_rpm"] * RPM
    useful = of["a"] * of["T1_Nm"] * omega, of["M_kg"] * 9.81 * of["v_mps"]
    shares = [power / sum(useful) for power in useful]
    parts = ", ".join(
        f"{{output_share: {share!r}, efficiency: {eta}}}"
        for share, eta in zip(shares, (of["eta1"], of["eta2"]), strict=True)
    )
    text = f"language: en\nefficiency: {{output: {sum(useful)!r} W, parallel: [{parts}]}}"
    found = course.solve(loading.loads(text)).efficiency
    power = found.whole.power[0]
    agrees("dubey-2-1-two-loads", P_kW=power / 1e3, T_Nm=power / omega)
