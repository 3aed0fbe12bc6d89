"""The numbers of every kind of pair, a sheet each, in the order of its table."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q as Number
from tmm_report.quantity.sheet import Row, Sheet

KINDS = {
    "incline": N_("Inclined plane"),
    "wedge": N_("Wedge"),
    "sliders": N_("Pair of guided sliders"),
    "trial": N_("Pull and push of a body"),
    "screw": N_("Screw pair"),
    "pivot": N_("Pivot"),
    "belt": N_("Belt round a drum"),
    "belt_drive": N_("Belt drive"),
    "wheel": N_("Rolling wheel"),
    "journal": N_("Journal"),
    "crank": N_("Slider-crank with friction circles"),
}
WORDS = (
    NP_("index", "raise"), NP_("index", "lower"), NP_("index", "red"), NP_("index", "best"),
    NP_("index", "thread"), NP_("index", "collar"), NP_("index", "hand"), NP_("index", "worn"),
    NP_("index", "even"), NP_("index", "roll"), NP_("index", "slide"), NP_("index", "mean"), NP_("index", "need"),
    NP_("index", "ideal"), NP_("index", "drive"), NP_("index", "hold"),
)  # fmt: skip


class Listed(Sheet):
    """Columns of all pairs side by side."""

    f_low = Number("f_min", "", N_("least coefficient of the range in the table"))
    f_high = Number("f_max", "", N_("greatest coefficient of the range in the table"))
    f = Number("f", "", N_("coefficient of friction"))
    phi_fr = Number("phi_fr", "deg", N_("angle of friction"))
    eta = Number("eta", "", N_("efficiency"))


class Incline(Row):
    Q = Number("Q", "N", N_("load"))
    alpha = Number("alpha", "deg", N_("slope of the plane"))
    f = Number("f", "", N_("coefficient of friction"))
    phi = Number("phi", "deg", N_("angle of friction"))
    F_up = Number("F_raise", "N", N_("force that moves the body up"))
    F_down = Number("F_lower", "N", N_("force that lets the body down at constant speed"))
    eta = Number("eta_raise", "", N_("efficiency of raising"))
    eta_back = Number("eta_lower", "", N_("efficiency of lowering, the load driving"))


class Wedge(Row):
    Q = Number("Q", "N", N_("load"))
    alpha = Number("alpha", "deg", N_("angle of the wedge"))
    f = Number("f_1", "", N_("coefficient of friction on the sloping face"))
    phi = Number("phi_1", "deg", N_("angle of friction on the sloping face"))
    f_base = Number("f_2", "", N_("coefficient of friction on the base"))
    phi_base = Number("phi_2", "deg", N_("angle of friction on the base"))
    F_in = Number("F_drive", "N", N_("force that drives the wedge in"))
    F_out = Number("F_hold", "N", N_("force that holds the wedge against the load"))
    alpha_lock = Number("alpha_max", "deg", N_("greatest angle at which the wedge locks"))
    eta = Number("eta", "", N_("efficiency"))


class Sliders(Row):
    theta = Number("theta", "deg", N_("angle between the directions of the sliders"))
    f = Number("f_1", "", N_("coefficient of friction on the sloping face"))
    phi = Number("phi_1", "deg", N_("angle of friction on the sloping face"))
    f_guide = Number("f_2", "", N_("coefficient of friction in the guides"))
    phi_guide = Number("phi_2", "deg", N_("angle of friction in the guides"))
    phi_both = Number("Phi", "deg", N_("angles of friction of face and guide together"))
    alpha_best = Number("alpha_best", "deg", N_("best angle of the face's normal"))
    eta_best = Number("eta_max", "", N_("greatest efficiency"))
    alpha = Number("alpha", "deg", N_("angle of the face's normal with the driving direction"))
    eta = Number("eta", "", N_("efficiency"))
    Q = Number("Q", "N", N_("load"))
    F = Number("F", "N", N_("driving force"))


class Trial(Row):
    theta = Number("theta", "deg", N_("angle of the force with the level"))
    P_pull = Number("P_1", "N", N_("force that just pulls the body"))
    P_push = Number("P_2", "N", N_("force that just pushes the body"))
    f = Number("f", "", N_("coefficient of friction"))
    G = Number("G", "N", N_("weight of the body"))
    phi = Number("phi", "deg", N_("angle of friction"))
    P_least = Number("P_min", "N", N_("least force that moves the body"))


class Screw(Row):
    Q = Number("Q", "N", N_("load"))
    d_2 = Number("d_2", "m", N_("mean diameter of the thread"), "mm")
    p = Number("p", "m", N_("pitch of the thread"), "mm")
    z = Number("z", "", N_("number of starts"))
    h = Number("h", "m", N_("lead of the thread"))
    psi = Number("psi", "deg", N_("lead angle"))
    beta = Number("beta", "deg", N_("half the angle of the thread"))
    f = Number("f", "", N_("coefficient of friction"))
    phi_red = Number("phi'", "deg", N_("reduced angle of friction"))
    M_thread = Number("M_thread", "N·m", N_("moment of friction and load in the thread, raising"))
    M_low = Number("M_lower", "N·m", N_("moment in the thread that lowers the load"))
    eta_thread = Number("eta_thread", "", N_("efficiency of the thread"))
    M_screw = Number("M", "N·m", N_("moment that raises the load"))
    eta = Number("eta", "", N_("efficiency"))
    f_collar = Number("f_collar", "", N_("coefficient of friction of the collar"))
    R_collar = Number("R_collar", "m", N_("mean radius of the collar"), "mm")
    M_collar = Number("M_collar", "N·m", N_("moment of friction of the collar"))
    M_back = Number("M'", "N·m", N_("moment that lowers the load, with the collar"))
    l_hand = Number("l_hand", "m", N_("arm of the hand force"), "mm")
    P_hand = Number("P_hand", "N", N_("force of a hand"))
    n_hand = Number("n_hand", "", N_("number of hands"))
    D_wheel = Number("D_hand", "m", N_("diameter of the handwheel"))


class Pivot(Row):
    Q = Number("Q", "N", N_("load"))
    f = Number("f", "", N_("coefficient of friction"))
    R_outer = Number("R", "m", N_("outer radius"), "mm")
    r_inner = Number("r", "m", N_("inner radius"), "mm")
    k = Number("k", "", N_("ratio of the inner radius to the outer one"))
    half_cone = Number("alpha", "deg", N_("half the angle of the cone"))
    n_surfaces = Number("n", "", N_("number of pairs of surfaces that rub"))
    n_collars = Number("z", "", N_("number of collars"))
    p_mean = Number("p_mean", "Pa", N_("mean pressure"), "MPa")
    p_max = Number("p_max", "Pa", N_("greatest pressure of a run-in pivot, at its inner radius"), "MPa")
    M_pressure = Number("M_even", "N·m", N_("moment of friction under uniform pressure"))
    M_wear = Number("M_worn", "N·m", N_("moment of friction of a run-in pivot"))
    omega = Number("omega", "rad/s", N_("angular velocity"))
    P_pressure = Number("P_even", "W", N_("power of friction under uniform pressure"))
    P_wear = Number("P_worn", "W", N_("power of friction of a run-in pivot"))


class Belt(Row):
    f = Number("f", "", N_("coefficient of friction"))
    groove = Number("gamma", "deg", N_("half the angle of the groove"))
    f_red = Number("f_red", "", N_("reduced coefficient of friction in the groove"))
    alpha = Number("alpha", "rad", N_("angle of contact"))
    T_1 = Number("T_1", "N", N_("tension of the tight side"))
    T_2 = Number("T_2", "N", N_("tension of the slack side"))
    F_t = Number("F_t", "N", N_("force carried by friction"))
    D = Number("D", "m", N_("diameter of the drum"), "mm")
    M_drum = Number("M", "N·m", N_("moment of friction on the drum"))
    omega = Number("omega", "rad/s", N_("angular velocity"))
    v = Number("v", "m/s", N_("speed of the belt"))
    P = Number("P", "W", N_("power"))


class BeltDrive(Row):
    d_1 = Number("d_1", "m", N_("diameter of the driving pulley"), "mm")
    d_2 = Number("d_2", "m", N_("diameter of the driven pulley"), "mm")
    a = Number("a", "m", N_("centre distance"), "mm")
    omega_1 = Number("omega_1", "rad/s", N_("angular velocity of the driving pulley"))
    b = Number("b", "m", N_("width of the belt"), "mm")
    t = Number("t", "m", N_("thickness of the belt"), "mm")
    sigma = Number("sigma", "Pa", N_("stress allowed in the belt"))
    f = Number("f", "", N_("coefficient of friction"))
    u = Number("u", "", N_("ratio"))
    alpha = Number("alpha", "rad", N_("angle of contact on the smaller pulley"))
    v = Number("v", "m/s", N_("speed of the belt"))
    T_max = Number("T_max", "N", N_("tension that the belt bears"))
    T_1 = Number("T_1", "N", N_("tension of the tight side"))
    T_2 = Number("T_2", "N", N_("tension of the slack side"))
    F_t = Number("F_t", "N", N_("force carried by friction"))
    P = Number("P", "W", N_("greatest power"))
    T_0 = Number("T_0", "N", N_("initial tension"))
    rho = Number("rho", "kg/m³", N_("density of the belt"))
    q = Number("q", "kg/m", N_("mass of a metre of the belt"))
    T_c = Number("T_c", "N", N_("centrifugal tension"))
    v_best = Number("v_best", "m/s", N_("speed of the greatest power"))
    P_best = Number("P_best", "W", N_("power at that speed"), "kW")


class Wheel(Row):
    N = Number("N", "N", N_("load on the wheel"))
    k = Number("k", "m", N_("arm of rolling resistance"), "mm")
    r = Number("r", "m", N_("radius of the wheel"), "mm")
    f = Number("f", "", N_("coefficient of friction"))
    M_roll = Number("M_roll", "N·m", N_("moment of rolling resistance"))
    F_roll = Number("F_roll", "N", N_("force at the axle that makes the wheel roll"))
    F_slide = Number("F_slide", "N", N_("force at the axle that makes the wheel slide"))
    f_roll = Number("f_roll", "", N_("coefficient of resistance of the wheel, k/r"))
    phi_roll = Number("phi_roll", "deg", N_("slope on which the wheel begins to roll"))
    phi = Number("phi", "deg", N_("angle of friction"))
    F = Number("F", "N", N_("force stated at the axle"))
    r_least = Number("r_min", "m", N_("radius above which the wheel rolls"), "mm")
    k_most = Number("k_max", "m", N_("arm of rolling resistance below which the wheel rolls"), "mm")
    M = Number("M", "N·m", N_("moment that drives the wheel"))
    M_most = Number("M_max", "N·m", N_("greatest moment at which the driving wheel does not slip"))
    T = Number("T", "N", N_("force on the ground that the moment asks for in steady motion"))
    f_need = Number("f_need", "", N_("coefficient of friction that is enough for the moment"))
    N_need = Number("N_need", "N", N_("load on the wheel that is enough for the moment"))
    r_need = Number("r_need", "m", N_("radius of the wheel that is enough for the moment"), "mm")


class Journal(Row):
    Q = Number("Q", "N", N_("load"))
    d = Number("d", "m", N_("diameter of the journal"), "mm")
    f = Number("f", "", N_("coefficient of friction"))
    rho = Number("rho", "m", N_("radius of the friction circle"))
    M_fr = Number("M_fr", "N·m", N_("moment of friction"))
    phi = Number("phi", "deg", N_("angle of friction"))
    omega = Number("omega", "rad/s", N_("angular velocity"))
    P = Number("P_fr", "W", N_("power of friction"))


class Crank(Row):
    F = Number("F", "N", N_("force on the slider"))
    r = Number("r", "m", N_("length of the crank"), "mm")
    l = Number("l", "m", N_("length of the connecting rod"), "mm")
    phi = Number("phi", "deg", N_("angle of the crank from its dead point"))
    f = Number("f", "", N_("coefficient of friction"))
    d_shaft = Number("d_1", "m", N_("diameter of the shaft's journal"), "mm")
    d_pin = Number("d_2", "m", N_("diameter of the crankpin"), "mm")
    d_wrist = Number("d_3", "m", N_("diameter of the wrist pin"), "mm")
    rho_shaft = Number("rho_1", "m", N_("radius of the friction circle of the shaft"))
    rho_pin = Number("rho_2", "m", N_("radius of the friction circle of the crankpin"))
    rho_wrist = Number("rho_3", "m", N_("radius of the friction circle of the wrist pin"))
    beta = Number("beta", "deg", N_("angle of the connecting rod with the stroke"))
    tau = Number("tau", "deg", N_("angle of the force in the rod with the stroke"))
    M_ideal = Number("M_ideal", "N·m", N_("moment on the crank without friction"))
    M_crank = Number("M", "N·m", N_("moment on the crank with friction"))
    eta = Number("eta", "", N_("efficiency"))
