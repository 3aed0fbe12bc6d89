"""The numbers of a planetary stage: single ones, those of each wheel, of each mesh."""

from __future__ import annotations

from tmm_report.chapters.gears.planetary.solve.stage import Found, Given
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Row, Sheet
from tmm_report.quantity.symbols import Symbol, both, math_symbol
from tmm_report.quantity.terms.gear_terms import HA
from tmm_report.quantity.terms.wheel_words import DIAMETERS

MM = ("mm", "mm")  # of print, in formulas
MODULE, NORMAL = N_("module"), N_("module in the normal section")
WANTED = N_("required ratio of the angular velocities of the input and the output")
STOPPED = N_("efficiency of the stage with carrier %(carrier)s stopped")
FORCE = N_(
    "circumferential force on one planet gear from wheel %(wheel)s for each newton metre of its moment"
)
TURNS = N_("whole turns of the carrier in the usual form of the condition of assembly")
USUAL = N_("whole number of the usual form of the condition of assembly")
RULE = N_("least teeth of a ring without shift by the rule of the course")


class Values(Sheet):
    u_wanted = Q(Symbol("u", "", "′"), "", WANTED)
    tolerance = Q("Delta_u", "%", N_("allowed deviation of the ratio"))
    m = Q("m", "m", MODULE, *MM)
    m_I = Q("m_I", "m", MODULE, *MM)
    m_II = Q("m_II", "m", MODULE, *MM)
    k_least = Q(None, "", N_("least number of planet gears examined"))
    k_most = Q(None, "", N_("largest number of planet gears examined"))
    eta_stopped = Q("eta", "", STOPPED)
    ha = Q(HA, "", N_("addendum coefficient"))
    alpha = Q("alpha", "deg", N_("profile angle of the basic rack"))
    ratio_weight = Q("w", "", N_("weight of the nearness of the ratio in the ranking"))
    beta = Q("beta", "deg", N_("helix angle"))
    m_n = Q("m_n", "m", NORMAL, *MM)
    m_I_n = Q("m_nI", "m", NORMAL, *MM)
    m_II_n = Q("m_nII", "m", NORMAL, *MM)
    alpha_n = Q("alpha_n", "deg", N_("profile angle of the basic rack in the normal section"))
    ha_n = Q(HA, "", N_("addendum coefficient in the normal section"))
    external_least = Q(None, "", N_("least number of external teeth examined"))
    external_most = Q(None, "", N_("largest number of external teeth examined"))
    rings_least = Q(None, "", N_("least number of teeth of rings examined"))
    rings_most = Q(None, "", N_("largest number of teeth of rings examined"))

    u = Q("u", "", N_("ratio of the stage, the second input at rest"))
    u_basic = Q("u", "", N_("ratio with the carrier stopped, wheel 1 to wheel 3"))
    u_carrier = Q("u", "", N_("ratio of wheel 1 to the carrier, wheel 3 at rest"))
    delta_u = Q("Delta_u", "%", N_("deviation of the ratio"))
    combinations = Q(None, "", N_("number of combinations of teeth"))
    solutions = Q(None, "", N_("how many solutions there are"))

    k = Q("k", "", N_("number of planet gears"))
    a_w = Q("a_w", "m", N_("centre distance"), *MM)
    apart = Q(None, "m", N_("distance between the axes of neighbouring planet gears"), "mm")
    gap = Q("Delta", "m", N_("gap between the tip circles of neighbouring planet gears"), *MM)
    least_teeth = Q("z_min", "", N_("least number of teeth that the rack does not undercut"))
    least_teeth_rounded = Q(None, "", N_("least number of teeth as the course rounds it"))

    assembly = Q("C", "", N_("whole number of the assembly condition"))
    divisor = Q("q", "", N_("greatest common divisor of the teeth of the two crowns"))
    turns = Q("p", "", TURNS)
    usual_assembly = Q(Symbol("C", "", "′"), "", USUAL)

    eta = Q("eta", "", N_("efficiency of the stage"))
    force = Q("F", "N/(N·m)", FORCE)
    mu_l = Q("mu_l", "m/mm", N_("scale of the drawing of the stage"))
    ring_rule = Q(None, "", RULE)


def _diameter(key: str) -> Q:
    return Q(math_symbol(key), "m", DIAMETERS[key], *MM)


class Wheel(Row):
    """`x`: in the transverse section."""

    z = Q("z", "", N_("number of teeth"))
    x_n = Q("x_n", "", N_("profile shift coefficient in the normal section"))
    x = Q("x", "", N_("profile shift coefficient"))
    d, d_b, d_w, d_f, d_a = map(_diameter, DIAMETERS)
    d_a_full = Q("d_a", "m", N_("tip diameter of teeth of full height"), *MM)


SUMS = N_("sum of the teeth of the wheels in mesh; with a ring, their difference")
SHIFTS = N_("sum of the profile shift coefficients in mesh; with a ring, their difference")
TRANSVERSE = N_("profile shift coefficient in the transverse section")
CUT = N_("tip diameter of the ring cut down clear of the planet gear's fillets")
LEAST = N_("least teeth of a ring without shift that does not interfere with its planet gear")


class Mesh(Row):
    """Wheel 1 with its crown, and wheel 3 with the other; some of it is of meshes with a ring alone."""

    z_sum = Q(None, "", SUMS)
    a = Q("a", "m", N_("reference centre distance of the mesh that is opened"), *MM)
    alpha_w = Q("alpha_w", "deg", N_("working pressure angle of that mesh"))
    x_sum = Q("x_Sigma", "", SHIFTS)
    eps_alpha = Q("epsilon_alpha", "", N_("contact ratio"))
    d_w = Q("d_w", "m", N_("working pitch diameter of the planet gear in the mesh"), *MM)
    rho_l = Q("rho_l", "m", N_("radius of curvature of the planet gear where its involute begins"), *MM)
    line = Q(None, "m", N_("distance between the limit points of the line of action"), "mm")
    rho_a = Q(None, "m", N_("radius of curvature at the tip of the ring of full height"), "mm")
    d_a_cut = Q(Symbol("d", "a", "′"), "m", CUT, *MM)
    z_least = Q("z_min", "", LEAST)


def letters(found: Found) -> dict[str, Q]:
    """What this stage calls otherwise: by the names of its members, in the transverse section."""
    given, task = found.given, found.given.task
    one, carrier, t = given.member("wheel1"), given.names[-1], "t" if given.helix else ""
    ratio, of = ratio_symbol(given, task.input, task.output), Values.DECLARED
    called = {
        "m": Symbol("m", t), "m_I": Symbol("m", t + "I"), "m_II": Symbol("m", t + "II"), "alpha": Symbol("alpha", t),
        "ha": Symbol("h", "at", "*") if t else HA, "u": ratio, "u_basic": ratio_symbol(given, "wheel1", "wheel3"),
        "u_carrier": ratio_symbol(given, "wheel1", "carrier"), "eta": Symbol("eta", ratio.sub, ratio.sup),
    }  # fmt: skip
    return {
        **{key: of[key].called(symbol) for key, symbol in called.items()},
        "eta_stopped": Values.eta_stopped.called(Symbol("eta", carrier), carrier=carrier),
        "force": Values.force.called(Symbol("F", "t" + one), wheel=one),
    }


def ratio_symbol(given: Given, input: p.Member, output: p.Member) -> Symbol:
    """u_1H^(3): of the input to the output with the third member held."""
    (held,) = set(p.MEMBERS) - {input, output}
    return Symbol("u", both(given.member(input), given.member(output)), f"({given.member(held)})")
