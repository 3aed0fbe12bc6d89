"""Every number of a spur stage: single ones, those of each wheel, columns of the tables."""

from __future__ import annotations

from tmm_report.chapters.gears.spur.solve.pair import Found
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Row, Sheet
from tmm_report.quantity.symbols import Symbol, both, math_symbol, segment
from tmm_report.quantity.terms.gear_terms import HA, C
from tmm_report.quantity.terms.wheel_words import DIAMETERS, OWN_SYMBOLS, TEETH

MM = ("mm", "mm")  # of print, in formulas
SUM = N_("sum of the profile shift coefficients (of an internal pair, their difference)")
NEEDED = N_("sum of the shifts (of an internal pair, their difference) that leaves no backlash")
BOUND = N_("what the sum of the numbers of teeth (of an internal pair, their difference) must not exceed")
ZONE = N_("each of the two parts of the line of action with two pairs in mesh")
FAR = N_("distance of the pitch point from the end of the active part where the profiles slide fastest")
LINE = N_("theoretical line of action, between its points of contact with the base circles")
OMEGA, STATED = N_("magnitude of the angular velocity"), N_("profile shift coefficient that is stated")

PRESSURE_POLE = N_("coefficient of specific pressure at the pitch point")
PRESSURE_LOWER = N_(
    "coefficient of specific pressure at the lower point of the active profile of wheel %(wheel)s"
)
PRESSURE_TIP = N_("coefficient of specific pressure at the tip of wheel %(wheel)s")


class Values(Sheet):
    ratio = Q("u", "", N_("ratio of the angular velocities"))
    a = Q("a", "m", N_("reference centre distance"), *MM)
    a_w = Q("a_w", "m", N_("centre distance"), *MM)
    alpha_w = Q("alpha_w", "deg", N_("working pressure angle"))
    x_sum = Q("x_Sigma", "", SUM)
    y = Q("y", "", N_("centre distance modification coefficient"))
    shortening = Q(Symbol("Deltay"), "", N_("tip alteration coefficient"))
    p = Q("p", "m", N_("pitch"), *MM)
    p_b = Q("p_b", "m", N_("base pitch"), *MM)
    p_w = Q("p_w", "m", N_("pitch on the working pitch circles"), *MM)
    backlash = Q("j_w", "m", N_("backlash on the working pitch circles"), *MM)
    line = Q(segment("N1N2"), "m", LINE, *MM)
    active = Q(segment("AB"), "m", N_("active part of the line of action"), *MM)
    eps = Q("epsilon_alpha", "", N_("contact ratio"))
    active_tips = Q(segment("A0B0"), "m", N_("line of action between the tip circles"), *MM)
    eps_tips = Q("epsilon_0", "", N_("contact ratio by the tip circles alone"))
    two_pairs = Q("delta_2", "", N_("fraction of the time in which two pairs are in mesh"), "%", "%")

    u_required = Q("u", "", N_("required ratio of the angular velocities"))
    m = Q("m", "m", N_("module"), *MM)
    alpha = Q("alpha", "deg", N_("profile angle of the basic rack"))
    ha = Q(HA, "", N_("addendum coefficient"))
    c = Q(C, "", N_("tip clearance coefficient"))
    beta = Q("beta", "deg", N_("helix angle"))
    b = Q("b", "m", N_("facewidth"), *MM)

    u = Q("u", "", N_("required ratio of the larger number of teeth to the smaller"))
    z_bound = Q("z_Sigma", "", BOUND)
    z_share = Q("z", "", N_("teeth of the smaller wheel before rounding"))
    z_larger = Q("z", "", N_("teeth of the larger wheel by the ratio, before rounding"))
    z_spare = Q("Delta_z", "", N_("what the numbers of teeth leave of their bound"))

    m_t = Q("m_t", "m", N_("module of the transverse section"), *MM)
    beta_b = Q("beta_b", "deg", N_("helix angle on the base cylinder"))
    alpha_t = Q("alpha_t", "deg", N_("profile angle in the transverse section"))
    inv_alpha = Q(Symbol("inv α"), "", N_("involute function of the profile angle"))
    inv_alpha_w = Q(Symbol("inv α", "w"), "", N_("involute function of the working pressure angle"))

    stated_one = Q("x_st", "", STATED)
    stated_two = Q("x_st", "", STATED)
    x_needed = Q("x_Sigma", "", NEEDED)
    z_rule = Q("z_min", "", N_("least number of teeth without undercut, by the rule"))
    backlash_n = Q("j_n", "m", N_("backlash along the line of action"), *MM)
    two_length = Q(segment("AC"), "m", ZONE, *MM)
    eps_beta = Q("epsilon_beta", "", N_("overlap ratio of helical teeth"))

    omega_one = Q("omega", "rad/s", OMEGA)
    omega_two = Q("omega", "rad/s", OMEGA)
    v_pitch = Q("V", "m/s", N_("pitch-line velocity, that of the point of contact at the pitch point"))
    sliding_limit = Q("lambda_max", "", N_("largest specific sliding allowed at this pitch-line velocity"))
    v_along = Q("V_n", "m/s", N_("velocity of both teeth along the line of action, at any of its points"))
    v_way = Q(None, "m", FAR)


class Drawn(Sheet):
    """Of the drawing of the mesh, and of the outlines turned over a pitch."""

    accuracy = Q(None, "m", N_("accuracy to which places are read off the drawing of the mesh"), "mm")
    scale = Q(None, "", N_("lengths of the drawing of the mesh to those of the wheels"))
    reduction = Q(None, "", N_("lengths of the wheels to those of the drawing of the mesh"))
    mu_sliding = Q("mu_lambda", "1/mm", N_("specific sliding that 1 mm of its graph stands for"))
    overlap = Q(None, "m²", N_("largest area that the outlines of the teeth share"), "mm²")
    clearance = Q(None, "m", N_("smallest distance between the outlines of the teeth"), "mm")
    eps_counted = Q(None, "", N_("number of pairs in mesh, counted on the outlines"))


def _size(key: str) -> Q:
    return Q(OWN_SYMBOLS.get(key) or math_symbol(key), "m", (DIAMETERS | TEETH)[key], *MM)


TIP = N_("radius of curvature of the profile at the tip")
LOWER = N_("radius of curvature at the lower point of the active profile")
MEETS = N_("radius of curvature where the tip circle of the other wheel meets the line of action")
UPPER = N_("radius of curvature at the upper point of the active profile")


class Wheel(Row):
    """`rho_m` and `rho_u`: where the contact is shorter than between the tip circles."""

    z = Q("z", "", N_("number of teeth"))
    x = Q("x", "", N_("profile shift coefficient"))
    x_rule = Q(None, "", N_("least shift by the rule"))
    x_min = Q("x_min", "", N_("exact least shift"))
    d, d_b, d_w, d_f, d_a = map(_size, DIAMETERS)
    height, s, s_b, s_w, s_a = map(_size, TEETH)
    alpha_a = Q("alpha_a", "deg", N_("profile angle at the tip"))
    rho_a = Q("rho_a", "m", TIP, *MM)
    rho_p = Q("rho_p", "m", LOWER, *MM)
    root_sliding = Q("lambda_p", "", N_("specific sliding at the lower point of the active profile"))
    tip_sliding = Q("lambda_a", "", N_("specific sliding at the tip"))
    rho_m = Q("rho_m", "m", MEETS, *MM)
    rho_u = Q("rho_u", "m", UPPER, *MM)
    rho_l = Q("rho_l", "m", N_("radius of curvature where the involute begins"), *MM)
    tip_lost = Q(Symbol("Deltay"), "", N_("coefficient of the shortening of the addendum"))
    clearance = Q("c", "m", N_("bottom clearance at the root"), *MM)


class Gauge(Row):
    """By what a wheel is measured; what it cannot be measured by, it has not."""

    alpha_m = Q("alpha_m", "deg", N_("profile angle halfway up the tooth, on the circle d + 2xm"))
    span_rule = Q(Symbol("z", "W", "′"), "", N_("number of teeth in the span by the rule"))
    span_teeth = Q("z_W", "", N_("number of teeth in the span, taken"))
    W = Q("W", "m", N_("span over these teeth"), *MM)
    rho_W = Q("rho_W", "m", N_("radius of curvature where the span touches the flank"), *MM)
    beta_a = Q("beta_a", "deg", N_("helix angle on the tip circle"))
    s_ay = Q(Symbol("s", "a", bar=True), "m", N_("chordal thickness on the tip circle"), *MM)
    sag = Q(Symbol("Deltah"), "m", N_("by how much the corners of a ring's tip stand out of its middle"), *MM)
    s_c = Q(Symbol("s", "c", bar=True), "m", N_("constant chord"), *MM)
    h_c = Q(Symbol("h", "c", bar=True), "m", N_("distance from the tip to the constant chord"), *MM)
    d_y = Q("d_y", "m", N_("diameter of the circle of the chordal thickness"), *MM)
    beta_y = Q("beta_y", "deg", N_("helix angle on this circle"))
    alpha_y = Q("alpha_y", "deg", N_("profile angle on this circle"))
    psi_y = Q("psi_y", "rad", N_("half the angle of a tooth on this circle"))
    s_y = Q(Symbol("s", "y", bar=True), "m", N_("chordal thickness on this circle"), *MM)
    h_y = Q(Symbol("h", "y", bar=True), "m", N_("distance from the tip to this chord"), *MM)
    pin = Q("D", "m", N_("diameter of the pins or balls"), *MM)
    inv_alpha_D = Q(Symbol("inv α", "D"), "", N_("involute function of the profile angle at their centres"))
    alpha_D = Q("alpha_D", "deg", N_("profile angle on the circle of their centres"))
    d_D = Q("d_D", "m", N_("diameter of the circle of their centres"), *MM)
    d_k = Q("d_k", "m", N_("diameter of the circle on which they touch the flanks"), *MM)
    M = Q("M", "m", N_("measurement over them"), *MM)


OF_RINGS = {  # where one of the wheels is a ring
    "span_rule": Q(
        Symbol("z", "W", "′"), "", N_("number of teeth (of the ring, of spaces) in the span by the rule")
    ),
    "span_teeth": Q("z_W", "", N_("number of teeth (of the ring, of spaces) in the span, taken")),
    "M": Q("M", "m", N_("measurement over them (of the ring, between them)"), *MM),
}


class Tool(Row):
    """The pinion cutter of a wheel, and what it leaves of it."""

    z0 = Q("z_0", "", N_("number of teeth of the pinion cutter"))
    x0 = Q("x_0", "", N_("profile shift coefficient of the pinion cutter"))
    inv_alpha_w0 = Q(
        Symbol("inv α", "w0"), "", N_("involute function of the working pressure angle in cutting")
    )
    alpha_w0 = Q("alpha_w0", "deg", N_("working pressure angle in cutting"))
    a_w0 = Q("a_w0", "m", N_("centre distance in cutting"), *MM)
    d_0 = Q("d_0", "m", N_("reference diameter of the pinion cutter"), *MM)
    d_a0 = Q("d_a0", "m", N_("tip diameter of the pinion cutter"), *MM)
    d_b0 = Q("d_b0", "m", N_("base diameter of the pinion cutter"), *MM)
    d_f0 = Q("d_f", "m", N_("root diameter as the pinion cutter leaves it"), *MM)
    rho_l0 = Q("rho_l", "m", N_("radius of curvature where the pinion cutter leaves the involute"), *MM)
    clearance0 = Q("c", "m", N_("bottom clearance at the root"), *MM)


class Divided(Sheet):
    """Of the quality over the division of the shifts; letters and names of wheel 1."""

    least_tip = Q(None, "", N_("least thickness of the tips, in modules, that bounds the shifts"))
    least_contact = Q(None, "", N_("least contact ratio that bounds the shifts"))
    x_least = Q(Symbol("x", "", "′"), "", N_("least shift of wheel %(wheel)s that every bound allows"))
    x_most = Q(Symbol("x", "", "′′"), "", N_("greatest shift of wheel %(wheel)s that every bound allows"))
    eps_least = Q(Symbol("epsilon", "alpha", "′"), "", N_("contact ratio with the least shift"))
    eps_most = Q(Symbol("epsilon", "alpha", "′′"), "", N_("contact ratio with the greatest shift"))
    play = Q("Delta_rho", "m", N_("least distance of the active profiles from the fillets between them"), *MM)
    x_equal = Q(
        Symbol("x", "", "*"), "", N_("shift of wheel %(wheel)s at which the roots of both slide equally")
    )
    lambda_equal = Q(Symbol("lambda", "p", "*"), "", N_("specific sliding at both roots with it"))
    gamma_w = Q("gamma_P", "", PRESSURE_POLE)
    gamma_p = Q("gamma_p", "", PRESSURE_LOWER)
    gamma_a = Q("gamma_a", "", PRESSURE_TIP)


STATED_LOSS = N_("what is stated of wheel %(wheel)s: shift of the rack or shortening of the span")
STATED_FIELD = N_("tolerance of what is stated of wheel %(wheel)s")
THIN = N_("least thinning of the teeth of wheel %(wheel)s, across them on the reference circle")
FIELD = N_("by how much the teeth of wheel %(wheel)s may be thinner still")
SPAN_FALL = N_("by how much the least thinning changes the span of wheel %(wheel)s")
CLOSE, FAR = N_("centre distance that leaves the least backlash"), N_("and that which leaves the greatest")
CLOSE_ANGLE, FAR_ANGLE = N_("working pressure angle at the first"), N_("working pressure angle at the second")
BY_AXES = N_("backlash on the working pitch circles that the centre distance leaves")
BY_TEETH = N_("backlash on the working pitch circles by the thinning of the teeth")
J_W, J_N = N_("backlash on the working pitch circles"), N_("backlash along the normal of the teeth")
TURNS = N_("angle by which wheel %(wheel)s turns freely while its mate is held")


def _turn(prime: str) -> Q:
    return Q(Symbol("phi", "j", prime), "deg", TURNS)


class Loosened(Sheet):
    """Backlash of a pair, the least (′) and the greatest (′′)."""

    guaranteed = Q(Symbol("j", "n", "min"), "m", N_("normal backlash that must be left at least"), *MM)
    axes = Q("f_a", "m", N_("by how much the centre distance may be longer or shorter"), *MM)
    stated_one, stated_two = (Q("E", "m", STATED_LOSS, *MM) for _ in range(2))
    wide_one, wide_two = (Q("T", "m", STATED_FIELD, *MM) for _ in range(2))
    thin_one, thin_two = (Q("E_s", "m", THIN, *MM) for _ in range(2))
    field_one, field_two = (Q("T_s", "m", FIELD, *MM) for _ in range(2))
    span_fall_one, span_fall_two = (Q("E_W", "m", SPAN_FALL, *MM) for _ in range(2))
    a_least, a_most = Q(Symbol("a", "w", "′"), "m", CLOSE, *MM), Q(Symbol("a", "w", "′′"), "m", FAR, *MM)
    alpha_least = Q(Symbol("alpha", "w", "′"), "deg", CLOSE_ANGLE)
    alpha_most = Q(Symbol("alpha", "w", "′′"), "deg", FAR_ANGLE)
    by_axes_least, by_axes_most = (Q(Symbol("j", "a", prime), "m", BY_AXES, *MM) for prime in ("′", "′′"))
    by_teeth_least, by_teeth_most = (Q(Symbol("j", "s", prime), "m", BY_TEETH, *MM) for prime in ("′", "′′"))
    j_w_least, j_w_most = (Q(Symbol("j", "w", prime), "m", J_W, *MM) for prime in ("′", "′′"))
    j_n_least, j_n_most = (Q(Symbol("j", "n", prime), "m", J_N, *MM) for prime in ("′", "′′"))
    turn_least_one, turn_least_two, turn_most_one, turn_most_two = map(_turn, ("′", "′", "′′", "′′"))


class Limited(Sheet):
    """Columns of the limits of measured sizes; each row has the letter of its size."""

    nominal = Q(None, "m", N_("without thinning"), "mm")
    first_off = Q(None, "m", N_("deviation with the least thinning"), "mm")
    second_off = Q(None, "m", N_("deviation with the greatest thinning"), "mm")
    first = Q(None, "m", N_("limit with the least thinning"), "mm")
    second = Q(None, "m", N_("limit with the greatest thinning"), "mm")


class Along(Sheet):
    """Over the division of the shifts or over the centre distance; those of a wheel have its name in key and letter."""

    x = Q("x", "", N_("profile shift coefficient of wheel %(wheel)s"))
    a_w = Q("a_w", "m", N_("centre distance"), *MM)
    alpha_w = Q("alpha_w", "deg", N_("working pressure angle"))
    x_sum = Q("x_Sigma", "", SUM)
    eps = Q("epsilon_alpha", "", N_("contact ratio"))
    tip = Q(Symbol("s", "a", "*"), "", N_("thickness of the tips of wheel %(wheel)s in modules, s_a/m"))
    play = Q("Delta_rho", "m", N_("distance of the active profile of wheel %(wheel)s from its fillet"), *MM)
    lambda_p = Q(
        "lambda_p",
        "",
        N_("specific sliding %(how)s at the lower point of the active profile of wheel %(wheel)s"),
    )
    lambda_a = Q("lambda_a", "", N_("specific sliding %(how)s at the tip of wheel %(wheel)s"))
    gamma_w = Q("gamma_P", "", PRESSURE_POLE)
    gamma_p = Q("gamma_p", "", PRESSURE_LOWER)
    gamma_a = Q("gamma_a", "", PRESSURE_TIP)


class Points(Sheet):
    """At points of the line of action; those of a wheel have its name in key and letter."""

    rho = Q(
        "rho", "m", N_("radius of curvature of the profile of wheel %(wheel)s at the point of contact"), "mm"
    )
    lambda_ = Q("lambda", "", N_("specific sliding of wheel %(wheel)s"))
    r = Q("r", "m", N_("distance of the point from the axis of wheel %(wheel)s"), "mm")
    v_tau = Q(
        Symbol("V", "τ"),
        "m/s",
        N_("velocity of the point of the tooth of wheel %(wheel)s across the line of action"),
    )
    v = Q("V", "m/s", N_("velocity of the point of the tooth of wheel %(wheel)s"))
    v_sl = Q("V_slide", "m/s", N_("velocity of sliding, above zero where the driving wheel is the faster"))
    x = Q("x", "", N_("profile shift coefficient of wheel %(wheel)s"))
    step = Q(None, "", N_("distance from the chosen shifts"))


def letters(found: Found) -> dict[str, Q]:
    """What this pair calls otherwise: by the names of its wheels, as an internal or a helical one."""
    one, two = found.given.wheels
    pair, kind = both(one, two), "d" if found.given.internal else "Sigma"
    smaller, larger = (found.given.wheels[i] for i in (found.teeth.small, 1 - found.teeth.small))
    called = {
        "ratio": Symbol("u", pair), "u_required": Symbol("u", pair, "′"),
        "x_sum": Symbol("x", kind), "x_needed": Symbol("x", kind),
        "z_bound": Symbol("z", kind), "z_share": Symbol("z", smaller), "z_larger": Symbol("z", larger),
        "inv_alpha": Symbol("inv α", "t" if found.pair.beta > 0 else ""),
    }  # fmt: skip
    if found.motion is not None:
        called["v_way"] = segment("P" + list(found.path.points)[found.motion.fastest])
    own = {key: Values.DECLARED[key].called(symbol) for key, symbol in called.items()}
    for place, wheel in (("one", one), ("two", two)):
        own[f"omega_{place}"] = Values.omega_one.called(Symbol("omega", wheel), f"omega_{wheel}")
        own[f"stated_{place}"] = Values.stated_one.called(Symbol("x", f"st{wheel}"), f"x_stated_{wheel}")
    return own
