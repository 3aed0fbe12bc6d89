"""The numbers of the flywheel: single ones, and the columns of its tables."""

from __future__ import annotations

from tmm_report.chapters.lever.moving import FRICTION_POWER, FRICTION_SHARE
from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Sheet
from tmm_report.quantity.symbols import Symbol, segment

WORDS = (
    NP_("index", "mean"),
    NP_("index", "fl"),
    NP_("index", "own"),
    NP_("index", "nom"),
    NP_("index", "exc"),
    NP_("index", "est"),
    NP_("index", "outer"),
    NP_("index", "allow"),
    NP_("index", "dr"),
    NP_("index", "res"),
)


class Values(Sheet, prefix="flywheel"):
    delta = Q("delta", "", N_("coefficient of speed fluctuation"))
    delta_fine = Q(None, "", N_("the least coefficient usual for machines of the kind"))
    delta_coarse = Q(None, "", N_("the greatest coefficient usual for machines of the kind"))
    omega_m = Q("omega_mean", "rad/s", N_("mean angular velocity of the main link"))
    omega_max = Q("omega_max", "rad/s", N_("greatest angular velocity"))
    omega_min = Q("omega_min", "rad/s", N_("least angular velocity"))
    J_0 = Q("J_0", "kg·m²", N_("constant moment of inertia that is stated, of what turns with the main link"))
    J_c = Q("J_c", "kg·m²", N_("constant parts of the reduced moments of inertia of the links"))
    J_r = Q("J_r", "kg·m²", N_("moment of inertia of the motor's rotor on its own shaft"))
    J_own = Q(
        "J_own",
        "kg·m²",
        N_("constant part of the machine's reduced moment of inertia, without the flywheel"),
    )
    Phi = Q("Phi", "rad", N_("angle of the cycle"))
    P_nom = Q("P_nom", "W", N_("nominal power of the motor"), "kW")
    omega_nom = Q("omega_nom", "rad/s", N_("nominal speed of the motor"))
    eta = Q("eta", "", N_("efficiency of the transmission"))
    W = Q("W", "J", N_("work of the driving moment over the cycle"))
    M_m = Q("M_mean", "N·m", N_("constant driving moment that closes the cycle"))
    P_m = Q("P_mean", "W", N_("mean power of the cycle"))
    C_E = Q("k_E", "%", N_("fluctuation of energy to the work of the cycle"))
    left = Q(None, "%", N_("part of the work of the cycle by which both sides do not close"))
    P_fr = FRICTION_POWER
    P_fr_share = FRICTION_SHARE
    P_need = Q("P", "W", N_("power that the motor must give on average"))
    A_max = Q("A_max", "J", N_("greatest work of the excess moment"))
    A_min = Q("A_min", "J", N_("least work of the excess moment"))
    A_ex = Q("A_exc", "J", N_("greatest excess work: fluctuation of energy"))
    J_mean = Q("J_II,mean", "kg·m²", N_("mean of the varying part of the moment of inertia"))
    # the energy–mass diagram at its scales: 1 mm of paper
    mu_J = Q("mu_J", "kg·m²/mm", N_("scale of the moments of inertia"))
    mu_T = Q("mu_T", "J/mm", N_("scale of the energies"))
    psi_1 = Q(
        "psi_1", "deg", N_("angle of the tangent at the greatest speed with the axis of moments of inertia")
    )
    psi_2 = Q(
        "psi_2", "deg", N_("angle of the tangent at the least speed with the axis of moments of inertia")
    )
    ab = Q(segment("ab"), "mm", N_("segment between the tangents on the axis of energies"))
    J_fl = Q("J_fl", "kg·m²", N_("moment of inertia of the flywheel, reduced to the main link"))
    delta_est = Q(
        "delta_est",
        "",
        N_("coefficient of speed fluctuation by the estimate with a constant moment of inertia"),
    )
    delta_0 = Q("delta_0", "", N_("coefficient of speed fluctuation without a flywheel"))
    delta_run = Q(None, "", N_("coefficient of speed fluctuation measured in the motion integrated"))
    closure = Q(None, "", N_("relative difference of the speeds at both ends of the cycle"))
    eps_max = Q("epsilon_max", "rad/s²", N_("greatest angular acceleration"))
    eps_min = Q("epsilon_min", "rad/s²", N_("least angular acceleration"))
    i = Q("i", "", N_("speed of the flywheel's shaft to that of the main link"))
    J_shaft = Q("J", "kg·m²", N_("moment of inertia of the flywheel on its shaft"))
    m = Q("m", "kg", N_("mass of the flywheel"))
    k = Q("k", "m", N_("radius of gyration of the flywheel"))
    D = Q("D", "m", N_("diameter of the flywheel (of a rim, the mean one)"))
    b = Q("b", "m", N_("width of the flywheel"))
    h = Q("h", "m", N_("height of the rim's section"))
    k_h = Q("k_h", "", N_("ratio of the height of the rim's section to the diameter of the rim"))
    k_b = Q("k_b", "", N_("ratio of the width of the disc to its diameter"))
    k_s = Q("k_s", "", N_("share of the moment of inertia in the spokes and the hub"))
    D_out = Q("D_outer", "m", N_("outer diameter of the flywheel"))
    rho = Q("rho", "kg/m³", N_("density of the material"))
    omega_s = Q("omega_s", "rad/s", N_("greatest angular velocity of the flywheel's shaft"))
    v = Q("v", "m/s", N_("greatest speed of the rim"))
    v_lim = Q("v_allow", "m/s", N_("speed of the rim that is commonly allowed"))
    sigma_lim = Q("sigma_allow", "Pa", N_("stress that the rim may bear"), "MPa")
    sigma = Q("sigma", "Pa", N_("stress in a thin rim at that speed"), "MPa")
    D_lim = Q("D_allow", "m", N_("largest outer diameter that the rim's speed allows"))


CLOSING = {  # M_m by the side that was found as the moment that closes the cycle
    "driving": Values.M_m.meaning.text,
    "resisting": N_("constant resisting moment that closes the cycle"),
    "": N_("mean driving moment"),
}
OF_RIM = {
    "m": Q("m", "kg", N_("mass of the flywheel without spokes and hub")),
    "k_b": Q("k_b", "", N_("ratio of the width of the rim's section to its height")),
}


def sheet(rim: bool, balancing: str, common: bool = True) -> Values:
    """The numbers of one variant, by what it calls otherwise. `common`: the rim's speed is that commonly allowed."""
    closing = {"M_m": Q("M_mean", "N·m", CLOSING[balancing])}
    if not common:
        closing["v_lim"] = Q("v_allow", "m/s", N_("speed that the rim may have"))
    return Values(closing | OF_RIM if rim else closing)


class OverCycle(Sheet):
    """Over the cycle of the machine."""

    M_dr = Q("M_dr", "N·m", N_("driving moment on the main link"))
    M_res = Q("M_res", "N·m", N_("moment of the resistances"))
    M_fr = Q("M_fr", "N·m", N_("moment of friction reduced to the driving link"))
    M_ex = Q("M_exc", "N·m", N_("excess moment"))
    A = Q("A", "J", N_("work of the excess moment from the beginning of the cycle"))
    J_II = Q("J_II", "kg·m²", N_("varying part of the reduced moment of inertia"))
    T_II = Q("T_II", "J", N_("kinetic energy of the varying part at the mean speed"))
    dT_I = Q("DeltaT_I", "J", N_("change of the kinetic energy of the constant part"))
    omega_0 = Q("omega_0", "rad/s", N_("angular velocity of the main link without the flywheel"))
    omega = Q("omega", "rad/s", N_("angular velocity of the main link with the flywheel"))
    domega = Q(
        "Deltaomega", "rad/s", N_("difference of the angular velocity with the flywheel from the mean one")
    )
    epsilon = Q("epsilon", "rad/s²", N_("angular acceleration of the main link with the flywheel"))


class Methods(Sheet):
    """Of the methods, a row each: of the tangents that they take at both ends the angle, J_II, A, slope and cut."""

    J_I = Q("J_I", "kg·m²", N_("constant moment of inertia that is needed"))
    J_fl = Values.J_fl
    deviation = Q("DeltaJ", "%", N_("difference from the exact moment of inertia of the flywheel"))
    phi_1 = Q(Symbol("phi", "", "(1)"), "deg", N_("angle at which the speed is taken to be greatest"))
    J_1 = Q("J_II,1", "kg·m²", N_("varying part of the moment of inertia where the speed is greatest"))
    A_1 = Q(Symbol("A", "", "(1)"), "J", N_("work of the excess moment where the speed is greatest"))
    s_1 = Q("s_1", "(rad/s)²", N_("slope of the tangent at the greatest speed"))
    T_1 = Q(
        "T_I,1",
        "J",
        N_("work where the speed is greatest, less the energy of the varying part at this speed"),
    )
    phi_2 = Q(Symbol("phi", "", "(2)"), "deg", N_("angle at which the speed is taken to be least"))
    J_2 = Q("J_II,2", "kg·m²", N_("varying part of the moment of inertia where the speed is least"))
    A_2 = Q(Symbol("A", "", "(2)"), "J", N_("work of the excess moment where the speed is least"))
    s_2 = Q("s_2", "(rad/s)²", N_("slope of the tangent at the least speed"))
    T_2 = Q(
        "T_I,2", "J", N_("work where the speed is least, less the energy of the varying part at this speed")
    )


class Proof(Sheet):
    """Of the motion in two ways."""

    omega_max = Values.omega_max
    omega_min = Values.omega_min
    delta = Values.delta
    miss = Q(None, "", N_("relative difference of the coefficient from the one by the energy integral"))
