"""Every number of masses on a turning shaft balanced: single values, and the columns of its tables."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Sheet

PER = NP_("index", "lim")  # permissible

ALONG_X = N_("sum of the moments about plane I, component along x")
ALONG_Y = N_("sum of the moments about plane I, component along y")


class Values(Sheet, prefix="rotor"):
    D_x = Q("D_Sigma^x", "kg·m", N_("sum of the unbalances, component along x"))
    D_y = Q("D_Sigma^y", "kg·m", N_("sum of the unbalances, component along y"))
    D = Q("D_Sigma", "kg·m", N_("sum of the unbalances"))
    alpha = Q("alpha_Sigma", "deg", N_("angle of the sum of the unbalances from x"))
    M_x = Q("M_Sigma^x", "kg·m²", ALONG_X)
    M_y = Q("M_Sigma^y", "kg·m²", ALONG_Y)
    M = Q("M_Sigma", "kg·m²", N_("sum of the moments about plane I"))
    L = Q(
        "L",
        "m",
        N_("distance between the correction planes, negative where plane II stands before plane I"),
    )
    L_AB = Q("L_AB", "m", N_("distance between the bearings"))
    omega = Q("omega", "rad/s", N_("angular velocity of the rotor"))
    mass = Q("m_0", "kg", N_("mass of the rotor"))
    e = Q("e", "m", N_("distance of the mass centre of the rotor from its axis"))
    mu_D = Q("mu_D", "kg·m/mm", N_("scale of the polygon of the unbalances"))
    closing_D = Q("d_I", "mm", N_("length of the vector that closes the polygon of the unbalances"))
    read_D = Q("alpha_I", "deg", N_("angle of that closing vector, read off the polygon of the unbalances"))
    mu_M = Q("mu_M", "kg·m²/mm", N_("scale of the polygon of the moments"))
    closing_M = Q("d_M,II", "mm", N_("length of the vector that closes the polygon of the moments"))
    read_M = Q("alpha_II", "deg", N_("angle of that closing vector, read off the polygon of the moments"))
    laid_II = Q("d_II", "mm", N_("length of the product of plane II in the polygon of the unbalances"))
    left_D = Q("D'_Sigma", "kg·m", N_("sum of the unbalances with the weights as they are made"))
    left_M = Q("M'_Sigma", "kg·m²", N_("sum of the moments about plane I with the weights as they are made"))
    uneven = Q(None, "", N_("what exact weights leave of the unbalance, relative"))
    disagreement = Q(
        None, "", N_("relative disagreement of the forces of both bearings with the sum of the unbalances")
    )
    G = Q("G", "mm/s", N_("balance quality grade, product of permissible eccentricity and angular velocity"))
    D_per = Q(f"D_{PER}", "kg·m", N_("permissible unbalance of the rotor"))
    centre = Q("z_S", "m", N_("place of the mass centre along the shaft"))
    ratio = Q("lambda", "", N_("ratio of the width of the rotor to its diameter"))
    one_plane = Q("omega_1", "rad/s", N_("angular velocity up to which balance in one plane suffices"))


class Masses(Sheet):
    """Of what is on the shaft."""

    m = Q("m", "kg", N_("mass"))
    r = Q("r", "m", N_("distance of the mass centre from the axis"))
    D = Q("D", "kg·m", N_("unbalance, product of mass and radius"))
    alpha = Q("alpha", "deg", N_("angle of the unbalance from the axis x of the shaft"))
    z = Q("z", "m", N_("place along the shaft"))
    J_xz = Q("J_xz", "kg·m²", N_("product of inertia about the axes x and z"))
    J_yz = Q("J_yz", "kg·m²", N_("product of inertia about the axes y and z"))
    l = Q("l", "m", N_("distance from plane I along the shaft"))
    M = Q("M", "kg·m²", N_("moment of the unbalance about plane I"))
    D_mm = Q("d", "mm", N_("length of the vector in the polygon of the unbalances"))
    M_mm = Q("d_M", "mm", N_("length of the vector in the polygon of the moments"))


class Weights(Sheet):
    """Of what balances them."""

    z = Masses.z
    D_x = Q("D^x", "kg·m", N_("component of the product of the weight along x"))
    D_y = Q("D^y", "kg·m", N_("component of the product of the weight along y"))
    D = Q("D_bal", "kg·m", N_("product of mass and radius that balances"))
    alpha = Q("alpha_bal", "deg", N_("angle of the product that balances"))
    m = Q("m_bal", "kg", N_("mass of the balancing weight"))
    r = Q("r_bal", "m", N_("distance of the balancing weight from the axis"))
    beta = Q("beta", "deg", N_("angle at which the weight is put or taken off"))
    m_made = Q("m'", "kg", N_("mass of the weight as it is made"))
    r_made = Q("r'", "m", N_("distance of the weight as it is made"))
    beta_made = Q("beta'", "deg", N_("angle of the weight as it is made"))


class Bearings(Sheet):
    """Of the bearings A and B."""

    z = Masses.z
    D_x = Q("D^x", "kg·m", N_("unbalance in the plane of the bearing before balancing, component along x"))
    D_y = Q("D^y", "kg·m", N_("unbalance in the plane of the bearing before balancing, component along y"))
    D_before = Q("D_AB", "kg·m", N_("unbalance in the plane of the bearing before balancing"))
    R_before = Q("R", "N", N_("force of the unbalance on the bearing before balancing"))
    D_made = Q("D'", "kg·m", N_("unbalance in the plane of the bearing with the weights as they are made"))
    R_made = Q("R'", "N", N_("force of the unbalance on the bearing with the weights as they are made"))
    psi = Q("psi", "deg", N_("angle of the force before balancing from x"))
    D_per = Q(f"D_{PER},AB", "kg·m", N_("permissible unbalance in the plane of the bearing"))
