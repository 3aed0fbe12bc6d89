"""The numbers of a compound gear train: single ones, those of its rows, members, meshes, branches, conditions."""

from __future__ import annotations

from collections.abc import Mapping

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Row, Sheet
from tmm_report.quantity.symbols import Symbol, both

WORDS = (NP_("index", "in"), NP_("index", "out"), NP_("index", "lost"), NP_("index", "circ"))
FORCE_RATIO = N_("ratio of the torques with the losses in the meshes, −M_out/M_in")
BACK = N_("efficiency with the power going in at the output; not positive: it locks itself")
FORCE = N_("circumferential force in the mesh, of several planet gears on one")
WAY = N_(
    "flow of the power about the carrier: 1 from the first wheel to the second, −1 back, 0 nothing moves"
)


class Values(Sheet, prefix="train"):
    u = Q("u", "", N_("ratio of the speeds of the input and the output"))
    u_wanted = Q(Symbol("u", "", "′"), "", N_("wanted ratio"))
    delta_u = Q("delta_u", "%", N_("deviation of the ratio"))
    tolerance = Q(None, "%", N_("allowed deviation of the ratio"))
    freedom = Q("W", "", N_("degrees of freedom of the train, no member held"), digits=10)
    u_loss = Q(Symbol("u", "", "*"), "", FORCE_RATIO)
    eta = Q("eta", "", N_("efficiency of the train"))
    eta_back = Q("eta", "", BACK)
    T_in = Q("T_in", "N·m", N_("torque on the input"))
    T_out = Q("T_out", "N·m", N_("torque on the output, from outside"))
    P_in = Q("P_in", "W", N_("power of the input"), "kW", formed="kW")
    P_out = Q("P_out", "W", N_("useful power of the output"), "kW", formed="kW")
    P_supplied = Q("P_in", "W", N_("power supplied to the train"), "kW", formed="kW")
    P_taken = Q("P_out", "W", N_("power taken from the train"), "kW", formed="kW")
    P_lost = Q("P_lost", "W", N_("power lost in the train"), "W")
    P_circulating = Q("P_circ", "W", N_("power that circulates in the closed loop"), "W")
    P_differential = Q("P_lost", "W", N_("power lost by friction in the differential"), "W")
    locking = Q("K", "", N_("locking factor of the differential"))
    D = Q("D", "m", N_("diameter of the drum"), "mm")
    F = Q("F", "N", N_("force in the rope"))
    v = Q("v", "m/s", N_("speed of the rope"))
    v_car = Q("v", "m/s", N_("speed of the car"))
    R = Q("R", "m", N_("radius of the curve to the middle of the axle"))
    B = Q("B", "m", N_("track of the axle"), "mm", formed="m")
    D_wheel = Q("D", "m", N_("diameter of the wheels"), "mm", formed="m")
    mu_l = Q("mu_l", "m/mm", N_("scale of the kinematic scheme"))
    mu_v = Q("mu_v", "(m/s)/mm", N_("scale of the diagram of linear velocities"))
    mu_omega = Q("mu_omega", "(rad/s)/mm", N_("scale of the diagram of angular velocities"))
    h = Q("h", "mm", N_("pole distance of the diagram of angular velocities"))
    combinations = Q(None, "", N_("number of sets of teeth that were judged"))
    solutions = Q(None, "", N_("how many sets meet every condition"))


class OfRow(Row):
    """A row of the kinematic formula."""

    u = Q("u", "", N_("ratio of the row with its carrier stopped"))
    u_loss = Q("u", "", N_("the same with the losses of its meshes"))


class Ratio(Row):
    u = Q("u", "", N_("ratio of the speeds of the member and of the one they are referred to"))


class Member(Row):
    z = Q("z", "", N_("number of teeth; 0: a carrier"))
    omega = Q("omega", "rad/s", N_("angular velocity"))
    n = Q("n", "rpm", N_("rotational speed"))
    omega_rel = Q(Symbol("omega", "", "(H)"), "rad/s", N_("angular velocity about the carrier of the axis"))
    n_rel = Q(Symbol("n", "", "(H)"), "rpm", N_("rotational speed about the carrier of the axis"))


class Load(Row):
    T_0 = Q("T", "N·m", N_("external torque without losses"))
    N_0 = Q("N", "W", N_("power without losses; positive: supplied"))
    T_free = Q("T", "N·m", N_("external torque without friction in the differential"))
    T = Q("T", "N·m", N_("external torque"))
    N = Q("N", "W", N_("power; positive: supplied"))
    F_free = Q("F", "N", N_("tractive force without friction in the differential"))
    F = Q("F", "N", N_("tractive force of the wheel"))


class OfMesh(Row):
    N = Q("N", "W", N_("power in the motion about the carrier; negative: the second wheel drives"))
    N_fr = Q("N_fr", "W", N_("power lost"))
    eta = Q("eta", "", N_("efficiency of the mesh, its carrier stopped"))
    way = Q("x", "", WAY)
    F_t = Q("F_t", "N", FORCE)


class Flowing(Row):
    T = Q("T", "N·m", N_("torque on the member from its meshes"))
    N = Q("N", "W", N_("power that the meshes give to the member"))


class Branch(Row):
    share_0 = Q("k", "", N_("share of the power without losses"))
    share = Q("k", "", N_("share of the power"))


class Distance(Row):
    a = Q("a", "m", N_("centre distance of the first mesh without shift"), "mm")
    a_other = Q("a", "m", N_("centre distance of the second mesh without shift"), "mm")
    gap = Q(None, "", N_("their difference in teeth, twice over"))


class Assembly(Row):
    k = Q("k", "", N_("number of planet gears"), digits=10)
    C = Q("C", "", N_("number of the condition of assembly: whole where the planet gears can be put in"))


class Neighbours(Row):
    k = Q("k", "", N_("number of planet gears"), digits=10)
    gap = Q("Delta", "m", N_("gap between the tips of neighbouring planet gears, without shift"), "mm")


class Case(Row):
    omega = Q("omega", "rad/s", N_("angular velocity in another motion"))
    n = Q("n", "rpm", N_("rotational speed in another motion"))


def ratio_symbol(one: str, other: str, carrier: str = "", base: str = "u", star: bool = False) -> Symbol:
    """u_13^(H)."""
    sup = f"({carrier})" if carrier else ""
    return Symbol(base, both(one, other), ("*" if star else "") + sup)


def letters(input: str, output: str, wheels: tuple[str, str] | None) -> Mapping[str, Q]:
    """What this train calls otherwise: by the names of its ends."""
    of = Values.DECLARED
    called = {
        "u": ratio_symbol(input, output),
        "u_wanted": Symbol("u", both(input, output), "′"),
        "u_loss": ratio_symbol(input, output, star=True),
        "eta": ratio_symbol(input, output, base="eta"),
        "eta_back": ratio_symbol(output, input, base="eta"),
        "T_in": Symbol("T", input),
        "T_out": Symbol("T", output),
        "P_in": Symbol("P", input),
        "P_out": Symbol("P", output),
    }
    if wheels:
        called["eta"] = Symbol("eta")
    return {key: of[key].called(symbol) for key, symbol in called.items()}
