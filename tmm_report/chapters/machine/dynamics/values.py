"""The numbers of the machine in motion: single ones, and the columns of its tables."""

from __future__ import annotations

from tmm_report.chapters.lever.moving import FRICTION_POWER, FRICTION_SHARE
from tmm_report.chapters.machine.dynamics.given import Given
from tmm_report.i18n import NP_
from tmm_report.mechanics.calculus.laws import Constant
from tmm_report.mechanics.machine.characteristics import Kloss, Power
from tmm_report.problems import N_, Message
from tmm_report.quantity.sheet import Q, Sheet
from tmm_report.quantity.symbols import Symbol

RES = NP_("index", "res")
LOAD, SHAFT, MOTOR = NP_("index", "load"), NP_("index", "shaft"), NP_("index", "mot")
WORDS = (
    NP_("index", "red"),
    NP_("index", "dr"),
    NP_("index", "mean"),
    NP_("index", "cr"),
    NP_("index", "own"),
    NP_("index", "lost"),
    NP_("index", "start"),
    NP_("index", "coast"),
    NP_("index", "br"),
    NP_("index", "begin"),
)
TURNS = N_("turns of the main shaft")


class Motion(Sheet):
    """Over the cycle, over the time of a regime, over the speed."""

    t = Q("t", "s", N_("time"))
    phi = Q("phi", "rad", N_("angle turned by the main shaft"))
    omega = Q("omega", "rad/s", N_("angular velocity of the main shaft"))
    domega = Q("Δω", "rad/s", N_("deviation of the angular velocity of the main shaft from its mean"))
    epsilon = Q("epsilon", "rad/s²", N_("angular acceleration of the main shaft"))
    s = Q("s", "", N_("slip of the motor"))
    M_dr = Q("M_dr", "N·m", N_("driving moment on the main shaft"))
    M_res = Q("M_res", "N·m", N_("resisting moment on the main shaft"))
    M = Q("M", "N·m", N_("excess moment, the driving one less the resisting one"))
    M_red = Q(
        "M_red",
        "N·m",
        N_("reduced moment of the forces: loads and weights of the mechanism, along the rotation"),
    )
    M_fr = Q(
        Symbol("M", SHAFT), "N·m", N_("moment of the resistances of the main shaft, against the rotation")
    )
    M_lost = Q(
        "M_lost",
        "N·m",
        N_("moment that the gears lose more than at a constant speed, by the acceleration of the parts"),
    )
    I_red = Q("I_red", "kg·m²", N_("reduced moment of inertia of the mechanism"))
    J = Q("J", "kg·m²", N_("moment of inertia of the machine on the main shaft"))
    J_slope = Q(
        "J'",
        "kg·m²/rad",
        N_("derivative of the moment of inertia of the machine with respect to the angle of the main shaft"),
    )
    A = Q("A", "J", N_("work of the excess moment from position 0"))
    V = Q("V", "J", N_("potential energy of the weights and springs"))
    V_slope = Q(
        "V'", "N·m", N_("derivative of the potential energy with respect to the angle of the main shaft")
    )


GENERALISED = Q("Q", "N·m", N_("generalised force, the moment of all that has no potential"))
GENERALISED.key = "Q"  # which no class can call so that declares others


class WithPairs(Sheet):
    """What a mechanism with friction in its pairs calls otherwise."""

    M_fr = Q(
        Symbol("M", SHAFT),
        "N·m",
        N_(
            "moment of the friction in the pairs and of the resistances of the main shaft, against the rotation"
        ),
    )


class Parts(Sheet):
    """Of the parts, a row each: the index of a symbol ends with the number of the part."""

    i = Q("i", "", N_("ratio of the speed of the shaft to that of the main shaft"))
    eta = Q("eta", "", N_("efficiency of the gears between the part and the main shaft"))
    J = Q(Symbol("J", SHAFT), "kg·m²", N_("moment of inertia of the shaft with what is on it"))
    M = Q("M", "N·m", N_("moment that resists the shaft"))
    m = Q("m", "kg", N_("mass that moves along"))
    r = Q("r", "m", N_("ratio of the velocity of the mass to the speed of the main shaft"))
    F = Q("F", "N", N_("force that resists the mass; below zero it drives"))
    J_red = Q("J_red", "kg·m²", N_("share of the part in the moment of inertia on the main shaft"))
    M_red = Q("M_red", "N·m", N_("share of the part in the resisting moment on the main shaft"))


class Works(Sheet):
    """Of each that acts, by the regime."""

    A_start = Q("A", "J", N_("work in the start-up"))
    A_steady = Q("A", "J", N_("work in a cycle of the steady motion"))
    A_coast = Q("A", "J", N_("work in the run-down"))


class Regimes(Sheet):
    """Of the regimes one after another, a row each, and of all of them together."""

    t_begin = Q("t_1", "s", N_("time of the beginning"))
    t_end = Q("t_2", "s", N_("time of the end"))
    t = Q("Deltat", "s", N_("duration"))
    phi = Q("phi", "rad", N_("angle turned by the main shaft"))
    turns = Q("n", "", TURNS)
    omega_end = Q("omega_2", "rad/s", N_("angular velocity of the main shaft at the end"))
    A_dr = Q("A_dr", "J", N_("work of the motor"))
    A_br = Q("A_br", "J", N_("work of the brake"))
    A_load = Q(Symbol("A", LOAD), "J", N_("work of the loads and weights"))
    A_fr = Q(
        "A_fr", "J", N_("work of the friction: in pairs and gears and by the resistances of the main shaft")
    )
    gained = Q("DeltaT", "J", N_("change of the kinetic energy"))


class Values(Sheet, prefix="dynamics"):
    J_parts = Q("J_0", "kg·m²", N_("moment of inertia of the parts on the main shaft"))
    M_parts = Q("M_0", "N·m", N_("resisting moment of the parts on the main shaft"))
    omega_given = Q("omega_1", "rad/s", N_("speed of the main shaft"))
    M_closing = Q("M_dr", "N·m", N_("constant moment on the main shaft that closes the cycle"))
    i_motor = Q("i_dr", "", N_("ratio of the speed of the motor to that of the main shaft"))
    eta_motor = Q("eta_dr", "", N_("efficiency of the gear of the motor"))
    M_motor = Q(Symbol("M", MOTOR), "N·m", N_("constant moment of the motor"))
    M_stall = Q("M_start", "N·m", N_("moment of the motor at rest"))
    omega_0 = Q("omega_0", "rad/s", N_("speed of the motor without a load"))
    a = Q("a", "N·m/s²", N_("first constant of the series-wound motor"))
    b = Q("b", "rad/s", N_("second constant of the series-wound motor"))
    M_max = Q("M_max", "N·m", N_("greatest moment of the motor"))
    s_cr = Q("s_cr", "", N_("critical slip, at which it is reached"))
    M_brake = Q("M_br", "N·m", N_("moment of the brake on the main shaft"))
    P_fr = FRICTION_POWER
    P_fr_share = FRICTION_SHARE
    omega_m = Q("omega_mean", "rad/s", N_("mean angular velocity of the main shaft in steady motion"))
    omega_min = Q("omega_min", "rad/s", N_("least angular velocity in steady motion"))
    omega_max = Q("omega_max", "rad/s", N_("greatest angular velocity in steady motion"))
    M_dr_min = Q("M_dr,min", "N·m", N_("least driving moment on the main shaft in steady motion"))
    M_dr_max = Q("M_dr,max", "N·m", N_("greatest driving moment on the main shaft in steady motion"))
    delta = Q("delta", "", N_("coefficient of speed fluctuation of the steady motion"))
    T_cycle = Q("t_c", "s", N_("time of a cycle of the steady motion"))
    multiplier = Q("mu", "", N_("part of a disturbance of the kinetic energy that is left after a cycle"))
    P = Q("P", "W", N_("mean power on the main shaft in steady motion"), "kW")
    M_steady = Q("M_res", "N·m", Message(N_("%(of)s in steady motion"), {"of": Motion.M_res.meaning}))
    J = Motion.J
    T_steady = Q("T", "J", N_("kinetic energy of the machine in steady motion"))
    T_0 = Q("T_0", "J", N_("kinetic energy of the machine at position 0"))
    # of constant moments and a constant moment of inertia, where no regime is asked for
    M_dr = Motion.M_dr
    M_res = Motion.M_res
    epsilon = Motion.epsilon
    t_start = Q("t_start", "s", N_("time of the start-up"))
    phi_start = Q("phi_start", "rad", N_("angle turned in the start-up"))
    turns_start = Q("n_start", "", TURNS)
    omega_start = Q("omega_start", "rad/s", N_("speed after the start-up"))
    omega_begin = Q("omega_b", "rad/s", N_("speed at the beginning of the start-up"))
    within = Q(None, "", N_("part of the steady speed that may be lacking after the start-up"), "%")
    t_coast = Q("t_coast", "s", N_("time of the run-down"))
    phi_coast = Q("phi_coast", "rad", N_("angle turned in the run-down"))
    turns_coast = Q("n_coast", "", TURNS)
    omega_coast = Q("omega_coast", "rad/s", N_("speed after the run-down"))
    cycles = Q("N", "", N_("cycles of the steady motion that are followed"))
    balance_error = Q(None, "", N_("worst relative lack in the balance of works and kinetic energy"))
    residual = Q(
        None,
        "",
        N_("worst relative disagreement of the found angular acceleration with the equation of motion"),
    )
    potential_error = Q(
        None,
        "",
        N_(
            "worst relative disagreement of the moment of weights and springs with the slope of their potential"
        ),
    )


OF_GEARED = {"M_motor": Q("M_own", "N·m", N_("constant moment of the motor"))}
OF_INDUCTION = {
    "omega_0": Q("omega_0", "rad/s", N_("synchronous speed of the motor")),
    "a": Q("a", "", N_("ratio of the resistance of the stator to that of the rotor")),
}


def sheet(given: Given) -> Values:
    """The numbers of one variant, by what it calls otherwise; its resistances have numbers of their own."""
    other: dict[str, Q] = {}
    motor = given.motor
    if motor is not None and motor.geared:
        other |= OF_GEARED
    if motor is not None and isinstance(motor.own, Kloss):
        other |= OF_INDUCTION
    for k, one in enumerate(given.resistances, 1):
        other |= _resistance(one.law, k)
    return Values(other)


def _resistance(law: object, k: int) -> dict[str, Q]:
    moment, speed = Symbol("M", f"{RES},{k}"), f"omega_{k}"
    if isinstance(law, Constant):
        return {f"M_res{k}": Q(moment, "N·m", N_("constant moment of a resistance"))}
    if not isinstance(law, Power):
        return {}
    if law.exponent == 1:
        return {f"c_res{k}": Q(f"c_{k}", "N·m·s/rad", N_("coefficient of a viscous resistance"))}
    return {
        f"M_res{k}": Q(moment, "N·m", N_("moment of a fan at its stated speed")),
        f"omega_res{k}": Q(speed, "rad/s", N_("stated speed of a fan")),
    }
