"""Every number of the mechanism balanced on its foundation: single values, and columns of its tables."""

from __future__ import annotations

from dataclasses import replace

from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, kept
from tmm_report.quantity.sheet import Q, Sheet
from tmm_report.quantity.symbols import Symbol

RMS = NP_("index", "rms")  # root mean square
RECIPROCATING = NP_("index", "recip")


class Values(Sheet):
    k_part = Q(Symbol("k", RECIPROCATING), "", N_("balanced part of the reciprocating masses"))
    balancing_disagreement = Q(
        None, "", N_("worst relative disagreement of the shaking with the reactions of the frame")
    )
    shaking_tail = Q(None, "", N_("harmonics of the shaking force that its samples miss, relative"))
    seen_x = Q("U_C^x", "kg·m", N_("centre of the smallest circle, along the driving link"))
    seen_y = Q("U_C^y", "kg·m", N_("centre of the smallest circle, across the driving link"))
    seen_mean_x = Q("U_D^x", "kg·m", N_("mean of the force seen by the driving link, along it"))
    seen_mean_y = Q("U_D^y", "kg·m", N_("mean of the force seen by the driving link, across it"))
    seen_radius = Q("R", "kg·m", N_("radius of the smallest circle"))


def _order(letter: str, unit: str, text: str, order: int) -> Q:
    return Q(letter, unit, Message(text, {"order": order}))


PRODUCT = N_("product of mass and radius of each rotor of order %(order)s for slider %(name)s")
RADIUS = N_("radius of the rotors of order %(order)s")
MASS = N_("mass of each rotor of order %(order)s")


class Slider(Sheet, prefix="slider"):
    """Of a slider-crank; its numbers bear the name of the `slider` and tell of its `joint`."""

    r = Q("r", "m", N_("radius of the crank"))
    l = Q("l", "m", N_("length of the connecting rod"))
    lam = Q("lambda", "", N_("ratio of the crank radius to the rod length"), key="lambda")
    lambda_L = Q("lambda_L", "", N_("ratio of the rod length to the crank radius, λ of other textbooks"))
    offset = Q("e", "m", N_("offset of the crank's pivot from the line of point %(name)s"), "mm")
    m_B = Q("m", "kg", N_("mass that reciprocates with slider %(name)s"))
    U_I, U_II = _order("U_I", "kg·m", PRODUCT, 1), _order("U_II", "kg·m", PRODUCT, 2)
    r_I, r_II = _order("r_I", "m", RADIUS, 1), _order("r_II", "m", RADIUS, 2)
    m_I, m_II = _order("m_I", "kg", MASS, 1), _order("m_II", "kg", MASS, 2)
    F_B_max = Q("F_max", "N", N_("greatest inertia force of what reciprocates with slider %(name)s"))
    F_I_max = Q("F_max", "N", N_("greatest force left by the rotors of the first order, slider %(name)s"))
    F_II_max = Q("F_max", "N", N_("greatest force left by the rotors of both orders, slider %(name)s"))

    def __init__(self, slider: str, joint: str):
        super().__init__()
        self.slider, self.joint = slider, joint

    def named(self, key: str) -> Quantity:
        of = super().named(key)
        if "%(name)s" in of.meaning.text:
            of = replace(of, meaning=Message(of.meaning.text, {**of.meaning.values, "name": self.joint}))
        sign = Symbol("m", self.joint) if key == "m_B" else of.symbol
        return replace(of, key=f"{of.key}_{self.slider}", symbol=sign)


# --- the shaking over the cycle


class Shaking(Sheet):
    F_shake = Q("F_Sigma", "N", N_("shaking force"))
    M_shake = Q("M_Sigma", "N·m", N_("shaking moment"))


@kept
def force(number: int) -> Quantity:
    """What a way of balancing leaves of the shaking force."""
    meaning = Message(N_("shaking force left by way %(n)s"), {"n": number})
    return Quantity(f"F_shake_{number}", Symbol("F", f"Sigma{number}"), "N", meaning)


@kept
def moment(number: int) -> Quantity:
    meaning = Message(N_("shaking moment with way %(n)s"), {"n": number})
    return Quantity(f"M_shake_{number}", Symbol("M", f"Sigma{number}"), "N·m", meaning)


class Cases(Sheet):
    case = Q(None, "", N_("number of the way of balancing, 0: as it is"))
    F_max = Q("F_max", "N", N_("greatest shaking force"))
    F_max_at = Q("phi", "deg", N_("angle of rotation at which it is reached"))
    left = Q("delta_F", "", N_("ratio of the greatest shaking force to that of the mechanism as it is"), "%")
    F_rms = Q(Symbol("F", RMS), "N", N_("root mean square of the shaking force"))
    M_max = Q("M_max", "N·m", N_("greatest shaking moment"))
    M_left = Q(
        "delta_M", "", N_("ratio of the greatest shaking moment to that of the mechanism as it is"), "%"
    )
    M_rms = Q(Symbol("M", RMS), "N·m", N_("root mean square of the shaking moment"))
    m_total = Q("m_Sigma", "kg", N_("mass of all the counterweights"))


class Harmonics(Sheet):
    order = Q("k", "", N_("order: turns in a turn of the driving link"))
    F_with = Q("F_k", "N", N_("force that turns k times with the driving link"))
    alpha_with = Q("alpha_k", "deg", N_("angle of the vector of that order with the x axis at position 0"))
    F_against = Q("F_-k", "N", N_("force that turns k times against the driving link"))
    alpha_against = Q(
        "alpha_-k", "deg", N_("angle of the vector of that order with the x axis at position 0")
    )


class Rotors(Sheet):
    order = Q(None, "", N_("order: turns in a turn of the driving link"))
    mr = Q("U", "kg·m", N_("product of mass and radius of a rotor"))
    alpha = Q("alpha", "deg", N_("angle of its mass from the x axis at position 0"))
    r = Q("r_U", "m", N_("radius of the mass of a rotor"), "mm")
    m = Q("m_U", "kg", N_("mass of a rotor"))


# --- wheels and weights against the moment


class Wheels(Sheet):
    i = Q("i", "", N_("turns of the wheel for one of the link, negative against it"))
    J = Q("J", "kg·m²", N_("moment of inertia of the wheel, or what the link itself gets"))


class MomentHarmonics(Sheet):
    order = Q("k", "", N_("order: turns in a turn of the driving link"))
    M = Q("M_k", "N·m", N_("harmonic of the shaking moment of the mechanism as it is"))
    M_before = Q("M_k^'", "N·m", N_("harmonic of the shaking moment that the balance of the force leaves"))
    M_after = Q("M_k^''", "N·m", N_("harmonic of the shaking moment that is left in the end"))


def _pair(base: str) -> Symbol:
    """Of a pair of weights of order k."""
    return Symbol(base, "c", "(k)")


class Couples(Sheet):
    order = Q("k", "", N_("order: turns in a turn of the driving link"))
    M = Q("M", "N·m", N_("amplitude of the moment of both weights"))
    U = Q(_pair("U"), "kg·m", N_("product of mass and radius of each weight"))
    alpha = Q(_pair("alpha"), "deg", N_("angle of the weight farther along x from the x axis at position 0"))
    d = Q(_pair("d"), "m", N_("distance between the axes of both weights"), "mm")
    r = Q(_pair("r"), "m", N_("radius of the mass of a weight"), "mm")
    m = Q(_pair("m"), "kg", N_("mass of a weight"))


# --- counterweights, masses put into joints


class Weights(Sheet):
    U_x = Q("U^x", "kg·m", N_("static moment of the counterweight along the link"))
    U_y = Q("U^y", "kg·m", N_("static moment of the counterweight across the link"))
    U = Q("U", "kg·m", N_("static moment of the counterweight"))
    beta = Q("beta", "deg", N_("angle of the counterweight from the line of the link"))
    rho = Q("rho", "m", N_("distance of the counterweight from the pivot of the link"), "mm")
    m_c = Q("m_c", "kg", N_("mass of the counterweight"))


class Masses(Sheet):
    m = Q("m", "kg", N_("mass on the link"))
    x = Q("x", "m", N_("arm of the mass along the link"), "mm")
    y = Q("y", "m", N_("arm of the mass across the link"), "mm")


class Splits(Sheet):
    m = Q("m", "kg", N_("mass of the link"))
    J = Q("J", "kg·m²", N_("moment of inertia of the link about its mass centre"))
    a = Q("a", "m", N_("distance from the first joint to the mass centre, along the line of the joints"))
    b = Q("b", "m", N_("distance from the mass centre to the second joint, along the line of the joints"))
    off = Q("h", "m", N_("distance of the mass centre from the line of the joints"))
    m_A = Q("m_A", "kg", N_("mass at the first joint"))
    m_B = Q("m_B", "kg", N_("mass at the second joint"))
    J_rest = Q("DeltaJ", "kg·m²", N_("moment of inertia of the link less that of the two masses"))
    m_A3 = Q("m_A^d", "kg", N_("mass at the first joint of three that keep the moment of inertia"))
    m_B3 = Q("m_B^d", "kg", N_("mass at the second joint of three that keep the moment of inertia"))
    m_S3 = Q("m_S^d", "kg", N_("mass at the mass centre of three that keep the moment of inertia"))


# --- slider-cranks


class Series(Sheet):
    order = Q("k", "", N_("order of the harmonic"))
    A = Q("A_k", "", N_("coefficient of the cosine, exact"))
    B = Q("B_k", "", N_("coefficient of the sine, exact"))
    A_one = Q("A_k^'", "", N_("by one term of the series in λ"))
    miss_one = Q("delta^'", "", N_("error of one term"), "%")
    A_two = Q("A_k^''", "", N_("by two terms of the series in λ"))
    miss_two = Q("delta^''", "", N_("error of two terms"), "%")
    c = Q("c_k", "", N_("coefficient of the cosine in the cosine of the rod's angle"))
    F = Q("F_k", "N", N_("amplitude of the inertia force of the order"))


class Remains(Sheet):
    F_slider = Q("F", "N", N_("inertia force of what reciprocates with slider %(name)s, along its guide"))
    F_first = Q("F^I", "N", N_("left by the rotors of the first order"))
    F_second = Q("F^II", "N", N_("left by the rotors of both orders"))


@kept
def inertia(joint: str) -> Quantity:
    of = Remains.F_slider.quantity
    meaning = Message(of.meaning.text, {"name": joint})
    return Quantity(of.key, Symbol(of.sign.base, joint), of.unit, meaning)
