"""The numbers of a drive from the machine back to the motor: single ones, those of each shaft, of each sought wheel."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Row, Sheet
from tmm_report.quantity.symbols import Symbol

WHOLE, NEEDED, MOTOR = NP_("index", "total"), NP_("index", "need"), NP_("index", "mot")
OUT, LEFT, BEARINGS, COUPLING = (
    NP_("index", "out"),
    NP_("index", "rest"),
    NP_("index", "bear"),
    NP_("index", "coup"),
)
ACTUAL, ALLOWED = NP_("index", "act"), NP_("index", "avail")


class Values(Sheet):
    force = Q("F", "N", N_("force that the machine needs"), "kN", formed="kN")
    v_out = Q(Symbol("v", OUT), "m/s", N_("velocity at which the machine works"))
    D_out = Q("D", "m", N_("diameter of the drum"), "mm", formed="mm")
    z_out = Q(Symbol("z", OUT), "", N_("number of teeth of the sprocket"), digits=9)
    t_out = Q("t", "m", N_("pitch of the chain"), "mm", formed="mm")
    omega_out = Q(Symbol("omega", OUT), "rad/s", N_("angular velocity of the machine's shaft"))
    n_out = Q(Symbol("n", OUT), "rpm", N_("wanted rotational speed of the machine's shaft"))
    T_out = Q(Symbol("T", OUT), "N·m", N_("useful torque on the machine's shaft"))
    P_out = Q(Symbol("P", OUT), "W", N_("useful power of the machine"), "kW", formed="kW")
    eta_bearings = Q(Symbol("eta", BEARINGS), "", N_("efficiency of a pair of bearings"))
    eta_coupling = Q(Symbol("eta", COUPLING), "", N_("efficiency of a coupling"))
    eta_out = Q(Symbol("eta", OUT), "", N_("efficiency of the machine's working member"))
    eta_total = Q(Symbol("eta", WHOLE), "", N_("efficiency from the motor to the useful power"))
    P_req = Q(Symbol("P", NEEDED), "W", N_("power needed from the motor"), "kW", formed="kW")
    P_motor = Q(Symbol("P", MOTOR), "W", N_("rated power of the motor"), "kW", formed="kW")
    n_motor = Q(Symbol("n", MOTOR), "rpm", N_("rated rotational speed of the motor"))
    overload = Q(None, "%", N_("permitted overload of the motor"))
    u_low = Q(None, "", N_("least permitted ratio of the whole drive"))
    u_high = Q(None, "", N_("greatest permitted ratio of the whole drive"))
    load_factor = Q("k_P", "", N_("ratio of the needed power to the rated power of the motor"))
    u_total = Q(Symbol("u", WHOLE), "", N_("ratio of the whole drive for the wanted speed"))
    u_rest = Q(Symbol("u", LEFT), "", N_("ratio that is left to the stages without a stated one"))
    factor = Q(None, "", N_("factor of the rule that divides the ratio"))
    v_actual = Q(Symbol("v", ACTUAL), "m/s", N_("velocity at which the machine works with this drive"))
    delta_n = Q("delta_n", "%", N_("deviation of the machine's speed from the wanted one"))
    P_allowed = Q(
        Symbol("P", ALLOWED), "W", N_("useful power at the rated power of the motor"), "kW", formed="kW"
    )
    T_allowed = Q(Symbol("T", ALLOWED), "N·m", N_("useful torque at the rated power of the motor"))
    F_allowed = Q(
        Symbol("F", ALLOWED),
        "N",
        N_("force that the machine has at the rated power of the motor"),
        "kN",
        formed="kN",
    )


class Shaft(Row):
    P = Q("P", "W", N_("power of the shaft"), "kW", formed="kW")
    n = Q("n", "rpm", N_("rotational speed of the shaft"))
    omega = Q("omega", "rad/s", N_("angular velocity of the shaft"))
    T = Q("T", "N·m", N_("torque of the shaft"))


class Sought(Row):
    z_exact = Q(Symbol("z", "", "′"), "", N_("number of teeth before rounding"))
    z = Q("z", "", N_("number of teeth"), digits=9)
