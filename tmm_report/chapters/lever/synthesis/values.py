"""Every single number of a synthesis, by the letters that textbooks share: a crank, b rod, c rocker, d frame."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.sheet import Q, Sheet
from tmm_report.quantity.terms.directions import X_OF, Y_OF

WORDS = (
    NP_("index", "lim"),
    NP_("index", "max"),
    NP_("index", "min"),
    NP_("index", "met"),
    NP_("index", "work"),
)


def _centre(coordinate: str) -> Message:
    return Message(N_("%(of)s, the centre of the arc"), {"of": Message(coordinate, {"name": "Q"})})


class Values(Sheet, prefix="synthesis"):
    K = Q("K", "", N_("ratio of the time of the slower stroke to that of the faster one"))
    mean_speed = Q("v_m", "m/s", N_("mean speed of the slider over the turn"))
    working_speed = Q("v_work", "m/s", N_("mean speed of the slider on the working stroke"))
    speed = Q("omega", "rad/s", N_("angular velocity of the crank"))
    stroke = Q("H", "m", N_("stroke of the slider"), "mm")
    swing = Q("psi", "rad", N_("swing of the rocker"), "deg")
    theta = Q(
        "theta", "rad", N_("angle between the lines of the crank and the rod in the extreme positions"), "deg"
    )
    ratio = Q("lambda", "", N_("ratio of the length of the rod to that of the crank"))
    offset_ratio = Q("epsilon", "", N_("ratio of the offset to the length of the crank"))
    rod_ratio = Q("nu", "", N_("ratio of the length of the rod to that of the link that moves it"))
    difference = Q("q", "m²", N_("difference of the squares of rod and crank"))
    crank = Q("a", "m", N_("length of the crank"), "mm")
    rod = Q("b", "m", N_("length of the rod"), "mm")
    rocker = Q("c", "m", N_("length of the rocker"), "mm")
    frame = Q("d", "m", N_("distance of the fixed pivots"), "mm")
    offset = Q("e", "m", N_("offset of the slide line from the pivot of the crank"), "mm")
    link = Q("L", "m", N_("length of the slotted link from its pivot to the joint of the rod"), "mm")
    arm = Q("r", "m", N_("arm of the slotted link"), "mm")
    sagitta = Q("f", "m", N_("sagitta of the arc that the end of the slotted link describes"), "mm")
    slide_line = Q("h", "m", N_("distance of the slide line from the pivot of the slotted link"), "mm")
    psi_1 = Q("psi_1", "rad", N_("first angle of the rocker from the line of the pivots"), "deg")
    psi_2 = Q("psi_2", "rad", N_("second angle of the rocker from the line of the pivots"), "deg")
    phi_1 = Q("phi_1", "rad", N_("angle of the crank in the first position"), "deg")
    phi_2 = Q("phi_2", "rad", N_("angle of the crank in the second position"), "deg")
    x_1 = Q("x_1", "m", N_("first place of the slider from the crank's pivot, along the slide line"), "mm")
    x_2 = Q("x_2", "m", N_("second place of the slider from the crank's pivot, along the slide line"), "mm")
    far = Q(
        "l_1", "m", N_("distance of the moved joint from the crank's pivot, crank and rod outstretched"), "mm"
    )
    near = Q(
        "l_2", "m", N_("distance of the moved joint from the crank's pivot, the crank upon the rod"), "mm"
    )
    half_chord = Q("s", "m", N_("half the chord of the rocker's swing"), "mm")
    rise = Q("p", "m", N_("distance of the chord from the rocker's pivot"), "mm")
    along = Q("u", "m", N_("distance of the crank's pivot from the middle line of the swing"), "mm")
    away = Q("v", "m", N_("distance of the crank's pivot from the chord"), "mm")
    frame_x = Q("x_d", "m", N_("abscissa of the rocker's pivot from that of the crank"), "mm")
    frame_y = Q("y_d", "m", N_("ordinate of the rocker's pivot from that of the crank"), "mm")
    permitted = Q("gamma_lim", "rad", N_("permitted pressure angle"), "deg")
    pressure = Q("gamma_max", "rad", N_("greatest pressure angle"), "deg")
    mu_permitted = Q("mu_lim", "rad", N_("permitted transmission angle"), "deg")
    mu_inner = Q(
        "mu_1", "rad", N_("angle of rod and rocker with the crank towards the rocker's pivot"), "deg"
    )
    mu_outer = Q(
        "mu_2", "rad", N_("angle of rod and rocker with the crank away from the rocker's pivot"), "deg"
    )
    transmission = Q("mu_min", "rad", N_("least transmission angle"), "deg")
    stroke_met = Q("H_met", "m", N_("stroke of the analysed mechanism"), "mm")
    swing_met = Q("psi_met", "rad", N_("swing of the rocker of the analysed mechanism"), "deg")
    K_met = Q("K_met", "", N_("time ratio of the analysed mechanism"))
    pressure_met = Q("gamma_met", "rad", N_("greatest pressure angle of the analysed mechanism"), "deg")
    transmission_met = Q("mu_met", "rad", N_("least transmission angle of the analysed mechanism"), "deg")
    stroke_taken = Q("H_r", "m", N_("stroke with the rounded lengths"), "mm")
    swing_taken = Q("psi_r", "rad", N_("swing of the rocker with the rounded lengths"), "deg")
    K_taken = Q("K_r", "", N_("time ratio with the rounded lengths"))
    pressure_taken = Q("gamma_r", "rad", N_("greatest pressure angle with the rounded lengths"), "deg")
    transmission_taken = Q("mu_r", "rad", N_("least transmission angle with the rounded lengths"), "deg")
    error_taken = Q(
        "Delta_r", "rad", N_("greatest difference from the function with the rounded lengths"), "deg"
    )
    misfit = Q(
        "delta_r", "m", N_("greatest gap between links of the rounded lengths in the stated positions"), "mm"
    )
    low = Q("x_0", "", N_("the variable at the beginning of its range"))
    high = Q("x_f", "", N_("the variable at the end of its range"))
    crank_from = Q("phi_0", "rad", N_("angle of the crank at the beginning of the range"), "deg")
    crank_turn = Q("Deltaphi", "rad", N_("turn of the crank over the range"), "deg")
    rocker_from = Q("psi_0", "rad", N_("angle of the rocker at the beginning of the range"), "deg")
    rocker_turn = Q("Deltapsi", "rad", N_("turn of the rocker over the range"), "deg")
    point_x = Q("xi_P", "m", N_("place of the point along the coupler"), "mm")
    point_y = Q("eta_P", "m", N_("place of the point to the left of the coupler"), "mm")
    k1 = Q("k_1", "", N_("constant of Freudenstein's equation"))
    k2 = Q("k_2", "", N_("constant of Freudenstein's equation: ratio of the frame to the crank"))
    k3 = Q("k_3", "", N_("constant of Freudenstein's equation: ratio of the frame to the rocker"))
    pairs_taken = Q(
        "Delta_r", "rad", N_("greatest difference from the stated pairs with the rounded lengths"), "deg"
    )
    error = Q("Delta_max", "rad", N_("greatest difference of the rocker's angle from the function"), "deg")
    centre_x = Q("x_Q", "m", _centre(X_OF), "mm")
    centre_y = Q("y_Q", "m", _centre(Y_OF), "mm")
    crank_pivot_x = Q("x_O", "m", N_("abscissa of the pivot of the crank"), "mm")
    crank_pivot_y = Q("y_O", "m", N_("ordinate of the pivot of the crank"), "mm")
    rocker_pivot_x = Q("x_C", "m", N_("abscissa of the pivot of the rocker"), "mm")
    rocker_pivot_y = Q("y_C", "m", N_("ordinate of the pivot of the rocker"), "mm")
    way_A = Q("k_A", "m", N_("distance between both places of the pin of the crank"), "mm")
    way_B = Q("k_B", "m", N_("distance between both places of the pin of the rocker"), "mm")
    off_A = Q("h_A", "m", N_("distance of the crank's pivot to the left of the way of its pin"), "mm")
    off_B = Q("h_B", "m", N_("distance of the rocker's pivot to the left of the way of its pin"), "mm")
    turn_A = Q("beta_A", "rad", N_("angle by which the crank turns between the positions"), "deg")
    turn_B = Q("beta_B", "rad", N_("angle by which the rocker turns between the positions"), "deg")
    crank_angle = Q("phi_1", "rad", N_("angle of the crank in the first position of the body"), "deg")
    crank_way = Q(
        "Deltaphi_b",
        "rad",
        N_("angle by which the crank turns from the first position to the last, positive counter-clockwise"),
        "deg",
    )
    radius = Q("R", "m", N_("radius of the arc: length of the rod"), "mm")
    guide_angle = Q("alpha", "rad", N_("direction from the middle point of the arc to its centre"), "deg")


SWING_OF_LINK = Q("theta", "rad", N_("swing of the slotted link"), "deg", key="theta")

LENGTHS = (
    "crank", "rod", "rocker", "frame", "offset", "link", "arm", "slide_line", "frame_x", "frame_y", "centre_x",
    "centre_y", "crank_pivot_x", "crank_pivot_y", "rocker_pivot_x", "rocker_pivot_y", "radius",
)  # fmt: skip
"""What a mechanism may take of a synthesis as a length, and `guide_angle` as an angle."""
ANGLES = ("guide_angle", "crank_angle", "crank_way")
SPEEDS = ("speed",)
"""And as the speed of its driving link, rad/s."""


class Pairs(Sheet):
    """Columns of the points of accuracy."""

    x = Q("x", "", N_("variable of the function"))
    y = Q("y", "", N_("the function"))
    phi = Q("phi", "rad", N_("angle of the crank from the line of the pivots"), "deg")
    psi = Q("psi", "rad", N_("angle of the rocker from the line of the pivots"), "deg")


class Poses(Sheet):
    """Columns of the positions of a body."""

    x = Q("x", "m", N_("abscissa of the origin of the body"), "mm")
    y = Q("y", "m", N_("ordinate of the origin of the body"), "mm")
    angle = Q("theta_b", "rad", N_("angle of the x axis of the body"), "deg")
    x_A = Q("x_A", "m", N_("abscissa of the pin of the crank"), "mm")
    y_A = Q("y_A", "m", N_("ordinate of the pin of the crank"), "mm")
    x_B = Q("x_B", "m", N_("abscissa of the pin of the rocker"), "mm")
    y_B = Q("y_B", "m", N_("ordinate of the pin of the rocker"), "mm")


class Path(Sheet):
    """Columns of the points through which the arc is laid."""

    phi = Q("phi", "rad", N_("angle of the crank from the line of the pivots"), "deg")
    x = Q("x_P", "m", N_("abscissa of the point of the coupler"), "mm")
    y = Q("y_P", "m", N_("ordinate of the point of the coupler"), "mm")
