"""The numbers of machines joined in a tree: single ones of the whole, columns of its parts."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_
from tmm_report.quantity.sheet import Q, Sheet

WORDS = (NP_("index", "in"), NP_("index", "out"), NP_("index", "lost"))


class Values(Sheet):
    """Powers are parts of that at the input where no power is stated."""

    eta_whole = Q("eta", "", N_("efficiency of the machines joined"))
    psi_whole = Q("psi", "", N_("loss coefficient of the machines joined"))
    P_in_whole = Q("P_in", "W", N_("power at the input of the whole"), "kW", formed="kW")
    P_out_whole = Q("P_out", "W", N_("useful power of the whole"), "kW", formed="kW")
    efficiency_imbalance = Q(
        None, "", N_("relative disagreement of the whole with the power lost in all the modules")
    )


class Parts(Sheet):
    """Columns of the parts; their symbols have the indices of the rows."""

    eta = Q("eta", "", N_("efficiency"))
    psi = Q("psi", "", N_("loss coefficient"))
    share = Q("s", "", N_("share of the input power among the parallel parts"))
    output_share = Q("q", "", N_("share of the output power among the parallel parts"))
    P_in = Q("P_in", "W", N_("power at the input"), "kW")
    P_out = Q("P_out", "W", N_("power at the output"), "kW")
    P_lost = Q("P_lost", "W", N_("power lost"), "kW")
    kappa = Q("kappa", "", N_("derivative of the efficiency of the whole with respect to that of the part"))


def unstated(declared: type[Sheet]) -> dict[str, Q]:
    """Powers in parts of that at the input."""
    return {key: Q(one.symbol, "", one.meaning) for key, one in declared.DECLARED.items() if one.unit == "W"}
