"""Published examples of reduced inertia, start-up and run-down: by the program's functions, and as variants."""

from __future__ import annotations

import math

import numpy as np
import pytest
from cases import agrees, case

from tmm_report import course, loading
from tmm_report.chapters.machine.dynamics import quantities
from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.machine import characteristics as ch
from tmm_report.mechanics.machine import reduced_train
from tmm_report.mechanics.machine.reduced import Acting, Plant
from tmm_report.mechanics.machine.run.law import run
from tmm_report.mechanics.machine.run.motion_law import Goal
from tmm_report.quantity.model import Book

RPM = math.pi / 30
TURN = panels(2 * math.pi)


def given(name):
    return case(name)["inputs"]


def machine(text):
    """What the chapter finds in a variant that is a machine of shafts."""
    return course.solve(loading.loads("dynamics:\n" + text)).dynamics


def value(found, key):
    return Book.of(values=quantities.values(found))[f"dynamics_{key}"].value


def plant(inertia, *acting):
    return Plant(TURN, np.full(TURN.shape, float(inertia)), np.zeros(TURN.shape), acting)


def fixed(key, moment):
    return Acting(key, values=np.full(TURN.shape, float(moment)))


# --- reduced inertia and moment


def test_motor_with_a_geared_shaft_and_a_hoist():
    name = "dubey-2-1-two-loads"
    x = given(name)
    omega = x["N_rpm"] * RPM
    J = (
        x["J0"]
        + reduced_train.inertia(x["a"], x["J1"])
        + reduced_train.travelling(x["M_kg"], x["v_mps"] / omega)
    )
    M = reduced_train.moment(x["a"], x["T1_Nm"], x["eta1"])
    M += reduced_train.moment(x["v_mps"] / omega, x["M_kg"] * 9.81, x["eta2"])
    agrees(name, J_kgm2=J, T_Nm=M, P_kW=M * omega / 1e3)


def test_motor_with_a_geared_shaft_and_a_hoist_as_a_variant():
    found = machine("""
  speed: 1420 rpm
  parts:
    - {name: motor, inertia: 0.2}
    - {name: drum, ratio: 0.1, inertia: 10, moment: 10, efficiency: 0.9}
    - {name: load, mass: 1000, velocity: 1.5, moves: up, efficiency: 0.85}
  motor: {shunt: {moment: 200, speed: 1420 rpm, no_load: 1500 rpm}}
""")
    agrees("dubey-2-1-two-loads", J_kgm2=value(found, "J_parts"), T_Nm=value(found, "M_parts"))


def test_motor_with_a_gear_and_a_belt():
    name = "guptasinghal-3-9-gear-belt"
    x = given(name)
    J = x["J0"] + reduced_train.inertia(x["i1"], x["J1"]) + reduced_train.inertia(x["i2"], x["J2"])
    M = reduced_train.moment(x["i1"], x["T1_Nm"]) + reduced_train.moment(x["i2"], x["T2_Nm"])
    agrees(name, J_kgm2=J, T_Nm=M, P_W=M * x["N_rpm"] * RPM)


def test_motor_with_a_gear_and_a_belt_as_a_variant():
    """The motor's line is laid through the moment of the load at the stated speed: there the motion is steady."""
    found = machine("""
  parts:
    - {name: motor, inertia: 0.3}
    - {name: gear, ratio: 0.1, inertia: 15, moment: 100}
    - {name: belt, ratio: 0.3333333333333333, inertia: 0.6, moment: 35}
  motor: {shunt: {moment: 21.666666666666668, speed: 1440 rpm, no_load: 1500 rpm}}
""")
    J, M, P = (value(found, key) for key in ("J_parts", "M_parts", "P"))
    agrees("guptasinghal-3-9-gear-belt", J_kgm2=J, T_Nm=M, P_W=P)


def test_belt_conveyor():
    name = "guptasinghal-3-6-conveyor"
    x = given(name)
    omega, mass = x["N_rpm"] * RPM, reduced_train.carried(x["rate_t_per_h"] / 3.6, x["l_m"], x["v_mps"])
    J = reduced_train.travelling(mass, x["v_mps"] / omega)
    moment = (x["J0"] + J) * omega / x["t_s"]
    assert run(plant(x["J0"] + J, fixed("motor", moment)), 0.0, Goal(speed=omega)).t[-1] == pytest.approx(8.0)
    agrees(name, J_load_kgm2=J, T_Nm=moment)


def test_belt_conveyor_as_a_variant():
    """The moment that is found brings the belt to its speed in the stated time."""
    moment = case("guptasinghal-3-6-conveyor")["recomputed"]["T_Nm"]
    found = machine(f"""
  speed: 1200 rpm
  parts:
    - {{name: motor, inertia: 0.1}}
    - {{name: belt, mass: {100 / 3.6 * 200 / 1.2}, velocity: 1.2}}
  motor: {{constant: {moment}}}
  start: {{speed: 1200 rpm}}
""")
    agrees("guptasinghal-3-6-conveyor", J_load_kgm2=found.whole.parts[1].inertia)
    assert value(found, "t_start") == pytest.approx(8.0, rel=1e-6)


@pytest.mark.parametrize("passing", [False, True])
def test_falling_mass_with_a_geared_shaft(passing):
    name = "khurmi-3-13-falling-mass"
    x = given(name)
    eta = x["eta"] if passing else 1.0
    J = x["IA"] + reduced_train.inertia(x["G"], x["IB"], eta) + reduced_train.travelling(x["M"], x["r"])
    a = -reduced_train.moment(x["r"], -x["M"] * x["g"]) / J * x["r"]
    agrees(name, **{"a_eta" if passing else "a": a})


@pytest.mark.parametrize("passing", [False, True])
def test_falling_mass_with_a_geared_shaft_as_a_variant(passing):
    found = machine(f"""
  parts:
    - {{name: shaft A, inertia: 100}}
    - {{name: shaft B, inertia: 5, ratio: 6, efficiency: 0.9}}
    - {{name: mass, mass: 75, radius: 0.3, moves: down}}
  losses_of_acceleration: {str(passing).lower()}
  start: {{time: 3}}
""")
    acceleration = found.start.omega[-1] / found.start.t[-1] * 0.3
    agrees("khurmi-3-13-falling-mass", **{"a_eta" if passing else "a": acceleration})


def test_crank_moment_of_a_steam_engine():
    name = "bevan-12-3-crank-moment"
    x = given(name)
    head, rod = (math.pi / 4 * x[key] ** 2 for key in ("D_in", "d_rod_in"))
    force = x["p1_psi"] * head - x["p2_psi"] * (head - rod)  # lb
    arms = [
        reduced_train.crank_arm(math.radians(x["theta_deg"]), x["stroke_in"] / 2, x["l_in"], exact)
        for exact in (False, True)
    ]
    agrees(name, T_lbft=force * arms[0] / 12, T_lbft_exact_kinematics=force * arms[1] / 12)


ENGINE = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 12}}
    2: {points: {A: 0, B: 60}}
    3: {points: {B: 0}, slides: {guide: x, at: B}}
  driver: {link: 1, speed: 10, rotation: clockwise, zero: {point: B, extreme: right}}
  assembly: {2-3: right}
loads:
  gravity: 0
  forces: [{at: B, direction: left, constant: FORCE}]
reduction: true
positions: {table: 9}
"""


def test_crank_moment_of_a_steam_engine_as_a_variant():
    """In inches and pounds, which the solution does not know; 40° is position 1 of nine."""
    x = given("bevan-12-3-crank-moment")
    head, rod = (math.pi / 4 * x[key] ** 2 for key in ("D_in", "d_rod_in"))
    force = x["p1_psi"] * head - x["p2_psi"] * (head - rod)
    heavy = ENGINE.replace("A: 12}", "A: 12}, mass: 1, mass_centre: O, inertia: 1")
    found = course.solve(loading.loads(heavy.replace("FORCE", repr(force)))).lever
    moment = abs(found.reduction.table.whole_moment[1]) / 12
    agrees("bevan-12-3-crank-moment", T_lbft_exact_kinematics=moment)


# --- start-up


def test_flywheel_speeded_up_by_a_constant_moment():
    name = "khurmi-16-2-start"
    x = given(name)
    J = x["m_kg"] * x["k_m"] ** 2
    found = run(plant(J, fixed("motor", x["T_Nm"])), 0.0, Goal(time=x["t_s"]))
    agrees(name, alpha=found.epsilon[-1], KE_kJ=found.gained / 1e3)


def test_flywheel_speeded_up_by_a_constant_moment_as_a_variant():
    found = machine("""
  parts: [{name: flywheel, inertia: 2500}]
  motor: {constant: 1500}
  start: {time: 10}
""")
    agrees("khurmi-16-2-start", alpha=found.start.epsilon[0], KE_kJ=found.start.gained / 1e3)


def test_start_with_twice_the_full_moment():
    name = "gupta-23-start-energy"
    x = given(name)
    omega = x["N_rpm"] * RPM
    full, J = x["P_W"] / omega, 2 * x["E_J"] / omega**2
    found = run(plant(J, fixed("motor", x["Tm_rel"] * full), fixed("load", -full)), 0.0, Goal(speed=omega))
    agrees(name, t_s=found.t[-1])
    text = f"""
  parts: [{{name: rotor, inertia: {J!r}, moment: {full!r}}}]
  motor: {{constant: {2 * full!r}}}
  start: {{speed: 500 rpm}}
"""
    agrees(name, t_s=value(machine(text), "t_start"))


@pytest.mark.parametrize("friction", [False, True])
def test_run_down_over_a_resistor(friction):
    name = "gupta-44-rundown"
    x = given(name)
    begin, end = x["N1_rpm"] * RPM, x["N2_rpm"] * RPM
    constant = x["E_V"] / begin
    generator = ch.shunt_of_circuit(1e-9, x["R"], constant)  # without a supply
    rubbing = [fixed("friction", -x["Tf"])] if friction else []
    found = run(plant(x["J"], Acting("motor", law=generator), *rubbing), begin, Goal(speed=end))
    key = "t_s" if friction else "t_nofriction_s"
    agrees(name, **{key: found.t[-1]})
    text = f"""
  parts: [{{name: rotor, inertia: 20}}]
  resistance:
    - {{viscous: {constant**2 / x["R"]!r}}}
    {"- {friction: 14.715}" if friction else ""}
  coast: {{begin: 1500 rpm, speed: 600 rpm}}
  steady: false
"""
    agrees(name, **{key: value(machine(text), "t_coast")})


def test_flywheel_for_a_shock_load():
    """The moment of inertia by which the motor gives its greatest moment just at the end of the shock."""
    name = "gupta-64-shock-load"
    x = given(name)
    stall = x["T_droop_Nm"] / x["droop_rad_s"]  # moment by lost speed
    J = -x["t_s"] * stall / math.log((x["TL"] - x["Tm"]) / (x["TL"] - x["T0"]))
    agrees(name, J_kgm2=J, J_fly_kgm2=J - x["J_motor"])
    no_load = 50.0
    text = f"""
  parts: [{{name: motor, inertia: 10}}, {{name: flywheel, inertia: {J - 10!r}, moment: 600}}]
  motor: {{shunt: {{moment: 450, speed: {no_load - x["droop_rad_s"]!r}, no_load: {no_load}}}}}
  start: {{begin: {no_load}, time: 10}}
"""
    found = machine(text)
    assert found.start.of(found.start.plant.acting[0])[-1] == pytest.approx(450.0, rel=1e-8)


def test_start_and_plugging_of_an_induction_motor():
    name = "dubey-6-7-kloss"
    x = given(name)
    synchronous = 4 * math.pi * x["f"] / x["poles"]
    motor = ch.kloss_of_circuit(x["V_line"] / math.sqrt(3), synchronous, x["R1"], x["R2"], x["X1"] + x["X2"])
    Acts, J = Acting("motor", law=motor), x["J"]
    start = run(plant(J, Acts), 0.0, Goal(speed=0.95 * synchronous))
    plug = run(plant(J, Acting("motor", law=ch.Reversed(motor))), synchronous, Goal(speed=0.0))
    best = ch.quickest_slip(2.0, 1.0)
    quick = ch.kloss_time(J, ch.Kloss(synchronous, motor.greatest, best), 2.0, 1.0)
    heat = [
        ch.winding_loss(J, synchronous, *slips, x["R1"] / x["R2"]) / 1e3 for slips in ((1.0, 0.0), (2.0, 1.0))
    ]
    agrees(
        name, sm=motor.critical, Tmax_Nm=motor.greatest, t_start_s=start.t[-1], t_plug_s=plug.t[-1],
        t_plug_min_s=quick, Es_kJ=heat[0], Eplug_kJ=heat[1], Rext=best * (x["X1"] + x["X2"]) - x["R2"],
    )  # fmt: skip


def test_start_and_plugging_of_an_induction_motor_as_a_variant():
    x = given("dubey-6-7-kloss")
    synchronous = 4 * math.pi * x["f"] / x["poles"]
    motor = ch.kloss_of_circuit(x["V_line"] / math.sqrt(3), synchronous, x["R1"], x["R2"], x["X1"] + x["X2"])
    induction = (
        f"synchronous: {synchronous!r}, max_moment: {motor.greatest!r}, critical_slip: {motor.critical!r}"
    )
    found = machine(f"""
  parts: [{{name: rotor, inertia: 100}}]
  motor: {{induction: {{{induction}}}}}
  start: {{speed: {0.95 * synchronous!r}}}
  coast: {{begin: {synchronous!r}, motor: reversed}}
""")
    times = {"t_start_s": value(found, "t_start"), "t_plug_s": value(found, "t_coast")}
    agrees("dubey-6-7-kloss", sm=value(found, "s_cr"), Tmax_Nm=value(found, "M_max"), **times)


def test_quickest_stop_by_plugging():
    name = "pillai-6-7-min-stop"
    x = given(name)
    synchronous = x["Ns_rpm"] * RPM
    greatest = x["V_line"] ** 2 / (2 * x["X"] * synchronous)
    motor = ch.Kloss(synchronous, greatest, x["sm"])
    begin, end = (synchronous * (x[key] - 1) for key in ("s1", "s2"))
    found = run(plant(x["J"], Acting("motor", law=ch.Reversed(motor))), begin, Goal(speed=end))
    agrees(name, t_s=found.t[-1])
    agrees(name, t_s=ch.kloss_time(x["J"], motor, x["s1"], x["s2"]))
    text = f"""
  parts: [{{name: rotor, inertia: 10}}]
  motor: {{induction: {{synchronous: 1000 rpm, max_moment: {greatest!r}, critical_slip: 1.45}}}}
  coast: {{begin: 950 rpm, motor: reversed}}
"""
    agrees(name, t_s=value(machine(text), "t_coast"))


def test_start_over_a_gear_and_the_best_ratio():
    name = "khurmi-3-17-geared-start"
    x = given(name)
    values = x["IA"], x["IB"], x["TA"], x["TB"], x["eta"]
    alpha = reduced_train.geared_acceleration(x["G"], *values)
    speed = x["N_rpm"] * RPM
    agrees(
        name,
        P_W=x["TB"] * speed / x["eta"],
        t_s=x["N2_rpm"] * RPM / alpha,
        G_best=reduced_train.best_ratio(*values),
    )


def test_start_over_a_gear_as_a_variant():
    found = machine("""
  parts:
    - {name: motor, inertia: 0.6}
    - {name: load, ratio: 0.1111111111111111, inertia: 45, moment: 100, efficiency: 0.95}
  losses_of_acceleration: true
  motor: {constant: 30}
  start: {speed: 540 rpm}
""")
    power = value(found, "M_parts") * 160 * RPM * 9
    agrees("khurmi-3-17-geared-start", t_s=value(found, "t_start"), P_W=power)


def test_plugging_of_a_motor_whose_current_lags():
    name = "dubey-5-10-dc-plugging"
    x = given(name)
    constant = (x["V"] - x["Ia"] * x["Ra"]) / (x["N_rpm"] * RPM)
    begin = x["N0_rpm"] * RPM
    total = (x["V"] + constant * begin) / (2 * x["Ia"])
    load = x["load_rel"] * constant * x["Ia"]
    poles, end = ch.armature(-x["V"], total, x["La"], constant, x["J"], load)
    t = np.linspace(0.0, 3.0, 300001)
    speed = ch.armature_speed(t, begin, poles, end, -load / x["J"])
    stop = float(np.interp(0.0, -speed, t))
    agrees(name, Rb_ohm=total - x["Ra"], pole1=poles[0].real, pole2=poles[1].real, w_inf=end, t_stop_s=stop)


def test_plugging_of_a_motor_whose_current_lags_by_integration():
    """The same by steps in time."""
    from tmm_report.mechanics.calculus.ode import integrate

    x = given("dubey-5-10-dc-plugging")
    constant = (x["V"] - x["Ia"] * x["Ra"]) / (x["N_rpm"] * RPM)
    begin, load = x["N0_rpm"] * RPM, x["load_rel"] * constant * x["Ia"]
    total = (x["V"] + constant * begin) / (2 * x["Ia"])

    def rate(t, y):
        return [(-x["V"] - total * y[0] - constant * y[1]) / x["La"], (constant * y[0] - load) / x["J"]]

    found = integrate(rate, np.array([0.0, begin]), (0.0, 5.0), events=[lambda t, y: y[1]])
    agrees("dubey-5-10-dc-plugging", t_stop_s=found.x[-1])
