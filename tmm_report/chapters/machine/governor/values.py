"""Every number of the speed governor, of its loop and of its brake: single values, and the columns of its tables."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.sheet import Q, Sheet
from tmm_report.quantity.symbols import Symbol

CONTACT = NP_("index", "cont")
UPPER, LOWER = NP_("index", "up"), NP_("index", "low")
LIN = NP_("index", "lin")  # by the equations of small motions
ALL = NP_("index", "lim")  # allowed
RE, IM = NP_("index", "re"), NP_("index", "im")  # parts of a complex number
WORDS = (NP_("index", "st"), NP_("index", "set"))  # static, of settling
SHOE, BRAKE = NP_("index", "shoe"), NP_("index", "br")
SPEED, FULL = N_("speed of the machine"), N_("moment of the drive at full supply")
SUPPLY = N_("supply of the machine, as a fraction of the full one")
INERTIAL, STABILITY = N_("inertial coefficient of the governor"), N_("factor of stability of the governor")
COEFFICIENT = N_("coefficient of the characteristic equation")


def _steady(text: str) -> Message:
    return Message(N_("%(of)s in the steady state"), {"of": Message(text)})


class Values(Sheet, prefix="governor"):
    # the centrifugal governor by itself
    l_1 = Q("l_1", "m", N_("length of the upper arm"), "mm")
    l_2 = Q("l_2", "m", N_("length of the lower arm"), "mm")
    e_1 = Q("e_1", "m", N_("distance of the upper pivot from the axis"), "mm")
    e_2 = Q("e_2", "m", N_("distance of the lower pivot from the axis"), "mm")
    x_0 = Q("x_0", "m", N_("radius of the pin at the lower stop"), "mm")
    L = Q("L", "m", N_("distance of the ball from the upper pivot"), "mm")
    a = Q("a", "m", N_("length of the ball arm"), "mm")
    b = Q("b", "m", N_("length of the extension of the lower arm"), "mm")
    beta_0 = Q(
        "beta_0", "rad", N_("angle of the lower arm with the axis at which the extension is upright"), "deg"
    )
    r_0 = Q("r_0", "m", N_("distance of the fulcrum from the axis"), "mm")
    r_min = Q("r_min", "m", N_("radius of a ball at the lower stop"), "mm")
    n = Q("n", "", N_("number of balls"))
    m = Q("m", "kg", N_("mass of a ball"))
    m_0 = Q("m_0", "kg", N_("mass of the sleeve with its load"))
    c = Q("c", "N/m", N_("stiffness of the spring"), "N/mm")
    F_0 = Q("F_0", "N", N_("force of the spring at the lower stop"))
    g = Q("g", "m/s²", N_("acceleration due to gravity"))
    h = Q("h", "m", N_("lift of the sleeve between its stops"), "mm")
    F_fr = Q("F_fr", "N", N_("dry friction on the sleeve"))
    k = Q("k", "N·s/m", N_("damping coefficient of the dashpot of the sleeve"))
    q = Q("q", "", N_("relative change of the speed for which the effort is found"), "%")
    omega_chosen = Q("omega_g", "rad/s", N_("speed wanted at the middle of the lift"), "rpm")
    omega_0 = Q("omega_g,0", "rad/s", N_("speed of the governor at the lower stop"), "rpm")
    omega_h = Q("omega_g,h", "rad/s", N_("speed of the governor at the upper stop"), "rpm")
    omega_m = Q("omega_g,m", "rad/s", N_("mean speed of the governor"), "rpm")
    delta = Q("delta", "", N_("non-uniformity of the governor"), "%")
    effort = Q("Q", "N", N_("effort of the governor"))
    power = Q("W", "J", N_("power of the governor, its effort times the lift"))
    spring_top = Q("F_h", "N", N_("force of the spring at the upper stop"))
    stiffness_needed = Q(
        "c_min",
        "N/m",
        N_("stiffness of the spring above which the governor is stable over its whole lift"),
        "N/mm",
    )
    preload_allowed = Q(
        "F_0,max",
        "N",
        N_("force of the spring at the lower stop below which the governor is stable over its whole lift"),
    )

    # the machine with its governor
    J = Q("J", "kg·m²", N_("moment of inertia of the machine"))
    i = Q("i", "", N_("ratio of the speed of the governor's shaft to that of the machine"))
    omega_mean = Q("omega_m", "rad/s", N_("mean speed of the machine"))
    M_mean = Q("M_m", "N·m", N_("moment of the drive at full supply and mean speed"))
    k_d = Q("k_d", "N·m·s/rad", N_("fall of the moment of the drive with the speed"))
    k_c = Q("k_c", "N·m·s/rad", N_("growth of the load with the speed"))
    load_before = Q("M_c,1", "N·m", N_("load before the step at mean speed"))
    load_after = Q("M_c,2", "N·m", N_("load after the step at mean speed"))
    s_min = Q("s_min", "", N_("least supply, with the sleeve at its upper stop"))
    F_throttle = Q("F_s", "N", N_("force at the sleeve that moves the throttle"))
    epsilon_allowed = Q(f"epsilon_{ALL}", "", N_("insensitiveness allowed"))
    F_allowed = Q(f"F_{ALL}", "N", N_("friction on the sleeve that the insensitiveness allows"))
    F_sum = Q("F_fr,s", "N", N_("friction on the sleeve with the throttle"))
    after_omega = Q("omega", "rad/s", _steady(SPEED))
    after_M_d = Q("M_d", "N·m", _steady(FULL))
    after_s = Q("s", "", _steady(SUPPLY))
    after_A = Q("A", "kg·m", _steady(INERTIAL))
    after_S = Q("S", "N/m", _steady(STABILITY))
    after_m = Q("m_red", "kg", N_("mass of the governor reduced to the sleeve"))
    D = Q("D", "N·m·s/rad", N_("self-regulation of the machine"))
    R = Q(
        "R", "N·s/rad", N_("derivative of the force on the sleeve with respect to the speed of the machine")
    )
    slowest = Q("lambda_max", "rad/s", N_("greatest real part of the eigenvalues"))
    Q_s = Q("Q_s", "N", N_("fall of the driving moment per unit of lift"))
    a_0 = Q("a_0", "kg²·m²", COEFFICIENT)
    a_1 = Q("a_1", "kg²·m²/s", COEFFICIENT)
    a_2 = Q("a_2", "kg²·m²/s²", COEFFICIENT)
    a_3 = Q("a_3", "kg²·m²/s³", COEFFICIENT)
    p = Q("p", "rad/s", N_("unit of the roots in Vyshnegradsky's form"))
    X = Q("X", "", N_("first parameter of Vyshnegradsky"))
    Y = Q("Y", "", N_("second parameter of Vyshnegradsky"))
    XY = Q("XY", "", N_("product of Vyshnegradsky's parameters"))
    k_min = Q("k_min", "N·s/m", N_("dashpot of the sleeve above which the loop is stable"))
    T_s = Q("T_s", "s", N_("time constant of the servomotor"))
    zone = Q("z_0", "m", N_("shift of the valve within which it stays closed"))
    z_m = Q("z_m", "m", N_("lift at which the valve is closed"))
    beta = Q("beta", "", N_("gain of the isodromic feedback"))
    T_i = Q("T_i", "s", N_("time constant of the isodromic feedback"))
    b_t = Q("b_t", "", N_("temporary non-uniformity by the isodromic feedback"))
    beta_min = Q("beta_min", "", N_("gain of the isodromic feedback above which the loop is stable"))
    beta_max = Q("beta_max", "", N_("gain of the isodromic feedback below which the loop is stable"))
    static = Q("Delta_st", "", N_("change of the steady speed, of that before the step"))
    peak = Q("Delta_max", "", N_("greatest deviation of the speed, of that before the step"), "%")
    peak_time = Q("t_max", "s", N_("time of the greatest deviation of the speed"))
    final = Q(
        "Delta_t", "", N_("change of the speed in the time that is shown, of that before the step"), "%"
    )
    settled = Q(
        "t_set",
        "s",
        N_(
            "time after which the difference from the final speed stays within 5 %% of the greatest deviation"
        ),
    )


OF_CRANK = {"b": Q("b", "m", N_("length of the sleeve arm"), "mm")}  # what a bell crank calls otherwise


class Brake(Sheet, prefix="governor_brake"):
    n = Q(Symbol("n", SHOE), "", N_("number of shoes"))
    m = Q(Symbol("m", SHOE), "kg", N_("mass of a shoe"))
    rho = Q("rho_0", "m", N_("radius of the mass centre of a shoe at rest"), "mm")
    gap = Q(Symbol("s", SHOE), "m", N_("gap between shoe and drum at rest"), "mm")
    rho_contact = Q("rho", "m", N_("radius of the mass centre of a shoe at contact"))
    R = Q(Symbol("R", BRAKE), "m", N_("inner radius of the drum"), "mm")
    f = Q("f", "", N_("coefficient of friction of a shoe on the drum"))
    c = Q(Symbol("c", SHOE), "N/m", N_("stiffness of the spring of a shoe"), "N/mm")
    F_0 = Q(Symbol("F", f"{SHOE},0"), "N", N_("force of the spring of a shoe at rest"))
    F = Q(Symbol("F", SHOE), "N", N_("force of the spring of a shoe at contact"))
    M = Q("M", "N·m", N_("moment that drives the shaft of the brake"))
    J = Q(Symbol("J", BRAKE), "kg·m²", N_("moment of inertia on the shaft of the brake"))
    contact = Q(f"omega_{CONTACT}", "rad/s", N_("speed at which the shoes touch"))
    K = Q("K", "kg·m²", N_("coefficient of the braking moment"))
    held = Q("omega_h", "rad/s", N_("speed that the brake holds"))
    spread = Q("Delta", "", N_("excess of the held speed over that of contact"))
    pressing = Q("N", "N", N_("force of a shoe on the drum at the held speed"))
    power = Q("P", "W", N_("power that the brake turns into heat"))
    contact_time = Q(f"t_{CONTACT}", "s", N_("time from rest to contact"))
    settled = Q("t_h", "s", N_("time from rest to 99 %% of the held speed"))
    a = Q("a", "m", N_("distance of the pivot of an arm from the axis"), "mm")
    psi = Q("psi", "rad", N_("angle at the axis from the pivot of an arm to the middle of its shoe"), "deg")
    psi_m = Q("psi_m", "rad", N_("angle at the axis from the pivot of an arm to its mass centre"), "deg")
    l_F = Q("l_F", "m", N_("distance of the spring from the pivot of the arm"), "mm")
    l_C = Q("l_C", "m", N_("distance of the centrifugal force from the pivot of the arm"), "mm")
    l_N = Q("l_N", "m", N_("distance of the normal force of the drum from the pivot of the arm"), "mm")
    l_T = Q("l_T", "m", N_("distance of the friction from the pivot of the arm"), "mm")
    theta = Q(Symbol("theta", SHOE), "rad", N_("angle by which an arm swings until its shoe touches"))
    f_lock = Q("f_lim", "", N_("coefficient of friction at which the shoe would lock itself"))
    wanted = Q("omega_w", "rad/s", N_("speed that the brake is to hold"))
    back = Q("omega'_h", "rad/s", N_("speed that the brake holds when it turns the other way"))


# --- columns of tables


class Places(Sheet):
    """Over the lift."""

    z = Q("z", "m", N_("lift of the sleeve"), "mm")
    H = Q("H", "m", N_("height of the upper pivots over those of the sleeve"), "mm")
    x = Q("x", "m", N_("radius of the pin of both arms"), "mm")
    dx = Q("x'", "", N_("derivative of the radius of the pin with respect to the lift"))
    alpha = Q("alpha", "rad", N_("angle of the upper arm with the axis"), "deg")
    beta = Q("beta", "rad", N_("angle of the lower arm with the axis"), "deg")
    gamma = Q("gamma", "rad", N_("angle of the extension of the lower arm with the axis"), "deg")
    theta = Q("theta", "rad", N_("angle of the ball arm with the axis"), "deg")
    r = Q("r", "m", N_("radius of the mass centre of a ball"), "mm")
    dr = Q("r'", "", N_("derivative of the radius of a ball with respect to the lift"))
    dy = Q("y'", "", N_("derivative of the height of a ball with respect to the lift"))
    A = Q("A", "kg·m", INERTIAL)
    E = Q("E", "N", N_("supporting force on the sleeve"))
    dA = Q("A'", "kg", N_("derivative of the inertial coefficient with respect to the lift"))
    dE = Q("E'", "N/m", N_("derivative of the supporting force with respect to the lift"))
    omega_g = Q("omega_g", "rad/s", N_("speed of the governor's shaft in equilibrium"))
    C = Q("C", "N", N_("controlling force of one ball"))
    S = Q("S", "N/m", STABILITY)
    omega_low = Q(f"omega_{LOWER}", "rad/s", N_("speed at which the sleeve begins to sink"), "rpm")
    omega_up = Q(f"omega_{UPPER}", "rad/s", N_("speed at which the sleeve begins to rise"), "rpm")
    epsilon = Q("epsilon", "", N_("insensitiveness of the governor"), "%")


class Motion(Sheet):
    """Of the machine: its steady states and the response."""

    t = Q("t", "s", N_("time"))
    M_c = Q("M_c", "N·m", N_("moment of the load"))
    M_d = Q("M_d", "N·m", FULL)
    omega = Q("omega", "rad/s", SPEED)
    deviation = Q(
        "Deltaomega", "rad/s", N_("deviation of the speed of the machine from that before the step")
    )
    deviation_linear = Q(
        f"Deltaomega_{LIN}",
        "rad/s",
        N_("deviation of the speed of the machine from that before the step, by the small motions"),
    )
    z = Q("z", "m", N_("lift of the sleeve"), "mm")
    s = Q("s", "", SUPPLY)
    x = Q("x", "m", N_("shift of the valve by the isodromic feedback"))


class States(Sheet):
    """Of the equations of small motions; a coefficient beside one in a row of their matrix."""

    phi = Q("phi", "", N_("relative deviation of the speed of the machine"))
    eta = Q("eta", "", N_("relative deviation of the sleeve"))
    vartheta = Q("psi", "", N_("rate of the relative deviation of the sleeve"))
    sigma = Q("sigma", "", N_("deviation of the supply"))
    xi = Q("xi", "", N_("relative shift of the valve by the isodromic feedback"))


class Roots(Sheet):
    real = Q(f"lambda_{RE}", "rad/s", N_("real part of the eigenvalue"))
    imaginary = Q(f"lambda_{IM}", "rad/s", N_("imaginary part of the eigenvalue"))


class Hurwitz(Sheet):
    a = Q("a", "", COEFFICIENT)
    Delta = Q("Delta", "", N_("Hurwitz's determinant"))


class Boundary(Sheet):
    nu = Q("nu", "rad/s", N_("frequency of the oscillation at the boundary"))
    beta = Q("beta", "", N_("gain of the isodromic feedback at the boundary"))
    T_i = Q("T_i", "s", N_("time constant of the isodromic feedback at the boundary"))


class Braking(Sheet):
    omega = Q(Symbol("omega", BRAKE), "rad/s", N_("speed of the shaft of the brake"))
    M_b = Q("M_b", "N·m", N_("braking moment"))
    t = Q("t", "s", N_("time"))
