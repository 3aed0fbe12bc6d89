"""The numbers of a machine whose main link slides: single ones, and the columns of its table."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Sheet

WORDS = (NP_("index", "red"), NP_("index", "dr"), NP_("index", "res"), NP_("index", "add"))


class Motion(Sheet):
    """Over the stroke; speeds and forces are counted along the motion."""

    s = Q("s", "m", N_("place of the main link along its guide"))
    t = Q("t", "s", N_("time"))
    v = Q("v", "m/s", N_("speed of the main link"))
    a = Q("a", "m/s²", N_("acceleration of the main link"))
    m_red = Q("m_red", "kg", N_("reduced mass"))
    m_red_slope = Q("m'_red", "kg/m", N_("derivative of the reduced mass with respect to the stroke"))
    F_dr = Q("F_dr", "N", N_("driving forces along the motion"))
    F_red = Q("F_red", "N", N_("reduced force of weights, loads and springs along the motion"))
    F_res = Q("F_res", "N", N_("resistances against the motion"))
    F = Q("F", "N", N_("sum of the forces along the motion"))
    A = Q("A", "J", N_("work of the forces from the beginning"))
    omega = Q("omega", "rad/s", N_("angular velocity of the link that follows the stroke"))
    I_red = Q("I_red", "kg·m²", N_("moment of inertia reduced to the link that follows the stroke"))


class Values(Sheet, prefix="travel"):
    mass = Q("m", "kg", N_("mass of the main link"))
    wheels = Q("m_add", "kg", N_("mass that the wheels have on the main link"))
    m_red = Q("m_red", "kg", N_("reduced mass"))
    rise = Q("beta", "rad", N_("angle of the motion above the horizontal"), "deg")
    g = Q("g", "m/s²", N_("acceleration due to gravity"))
    weight = Q("F_G", "N", N_("weight of the main link along the motion"))
    begin = Q("s_0", "m", N_("place at the beginning"))
    end = Q("s_1", "m", N_("place at the end"))
    length = Q("L", "m", N_("way to the end"))
    v_begin = Q("v_0", "m/s", N_("speed at the beginning"))
    m_begin = Q("m_red,0", "kg", N_("reduced mass at the beginning"))
    force = Q("F", "N", N_("sum of the forces along the motion"))
    a = Motion.a
    way = Q("x_1", "m", N_("way passed"))
    v_end = Q("v_1", "m/s", N_("speed at the end of the way"))
    t_end = Q("t_1", "s", N_("time of the motion"))
    v_max = Q("v_max", "m/s", N_("greatest speed"))
    gained = Q("ΔT", "J", N_("change of the kinetic energy"))
    balance_error = Q(None, "", N_("relative lack in the balance of works and kinetic energy"))
    residual = Q(
        None, "", N_("worst relative disagreement of the found acceleration with the equation of motion")
    )


OF_MECHANISM = {"mass": Q("m_add", "kg", N_("mass that moves with the main link besides the mechanism"))}
