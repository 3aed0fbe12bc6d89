"""Formulas of friction in what turns: pivots, belts, wheels, journals, a crank; and all formulas by the kind."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.contacts import formulas as plane
from tmm_report.chapters.machine.contacts.formulas import Formulas, Of, exp
from tmm_report.quantity.formula import PI, Expr, Formula, Function, cos, sin, sqrt
from tmm_report.quantity.terms.gear_terms import arctan


def arcsin(x: Expr) -> Expr:
    return Function("arcsin", x, np.arcsin)


def pivot(of: Of) -> Iterator[Formula]:
    load, f, outer, inner = of("Q"), of("f"), of("R_outer"), of("r_inner")
    flat, hollow = of.item.numbers["half_cone"] == 90.0, of.item.numbers["r_inner"] > 0
    pressure, wear = 2 * f * load * outer / 3, f * load * outer / 2
    if hollow:
        pressure = 2 * f * load * (outer**3 - inner**3) / (3 * (outer**2 - inner**2))
        wear = f * load * (outer + inner) / 2
    yield of.gives("p_mean", load / (PI * ((outer**2 - inner**2) if hollow else outer**2)))
    yield of.gives("M_pressure", pressure if flat else pressure / sin(of("half_cone")))
    yield of.gives("M_wear", wear if flat else wear / sin(of("half_cone")))
    if "omega" in of:
        yield of.gives("P_pressure", of("M_pressure") * of("omega"))
        yield of.gives("P_wear", of("M_wear") * of("omega"))


def belt(of: Of) -> Iterator[Formula]:
    f, flat = of("f"), of.item.numbers["groove"] == 90.0
    if not flat:
        yield of.gives("f_red", f / sin(of("groove")))
    yield of.gives("T_2", of("T_1") * exp(-((f if flat else of("f_red")) * of("alpha"))))
    yield of.gives("F_t", of("T_1") - of("T_2"))
    if "M_drum" in of:
        yield of.gives("M_drum", of("F_t") * of("D") / 2)
    if "P" in of:
        yield of.gives("v", of("omega") * of("D") / 2)
        yield of.gives("P", of("F_t") * of("v"))


def belt_drive(of: Of) -> Iterator[Formula]:
    one, other = of("d_1"), of("d_2")
    yield of.gives("u", other / one)
    yield of.gives("alpha", PI - 2 * arcsin(abs(other - one) / (2 * of("a"))))
    yield of.gives("v", of("omega_1") * one / 2)
    yield of.gives("T_max", of("sigma") * of("b") * of("t"))
    heavy = "T_c" in of
    if heavy:
        yield of.gives("q", of("rho") * of("b") * of("t"))
        yield of.gives("T_c", of("q") * of("v") ** 2)
    yield of.gives("T_1", of("T_max") - of("T_c") if heavy else of("T_max"))
    yield of.gives("T_2", of("T_1") * exp(-(of("f") * of("alpha"))))
    yield of.gives("F_t", of("T_1") - of("T_2"))
    yield of.gives("P", of("F_t") * of("v"))
    mean = (of("T_1") + of("T_2")) / 2
    yield of.gives("T_0", mean + of("T_c") if heavy else mean)
    if heavy:
        yield of.gives("v_best", sqrt(of("T_max") / (3 * of("q"))))
        carried = of("T_max") * (1 - exp(-(of("f") * of("alpha")))) * of("v_best")
        yield of.gives("P_best", 2 * carried / 3)


def wheel(of: Of) -> Iterator[Formula]:
    yield of.gives("M_roll", of("k") * of("N"))
    yield of.gives("F_roll", of("M_roll") / of("r"))
    yield of.gives("F_slide", of("f") * of("N"))
    yield of.gives("f_roll", of("k") / of("r"))
    yield of.gives("phi_roll", arctan(of("f_roll")))
    yield of.gives("phi", arctan(of("f")))


def journal(of: Of) -> Iterator[Formula]:
    yield of.gives("phi", arctan(of("f")))
    yield of.gives("rho", of("f") * of("d") / 2)
    yield of.gives("M_fr", of("Q") * of("rho"))
    if "P" in of:
        yield of.gives("P", of("M_fr") * of("omega"))


def crank(of: Of) -> Iterator[Formula]:
    r, phi, beta, tau = of("r"), of("phi"), of("beta"), of("tau")
    for part in ("shaft", "pin", "wrist"):
        yield of.gives(f"rho_{part}", of("f") * of(f"d_{part}") / 2)
    yield of.gives("beta", arcsin(r * sin(phi) / of("l")))
    pins = of("rho_pin") + of("rho_wrist") if cos(phi).value > 0 else of("rho_pin") - of("rho_wrist")
    yield of.gives("tau", beta - arcsin(pins / of("l")))
    yield of.gives("M_ideal", of("F") / cos(beta) * (r * sin(phi + beta)))
    yield of.gives("M_crank", of("F") / cos(tau) * (r * sin(phi + tau) - of("rho_shaft") - of("rho_pin")))
    yield of.gives("eta", of("M_crank") / of("M_ideal"))


FORMULAS: dict[str, Formulas] = {
    "incline": plane.incline, "wedge": plane.wedge, "sliders": plane.sliders, "trial": plane.trial,
    "screw": plane.screw, "pivot": pivot, "belt": belt, "belt_drive": belt_drive, "wheel": wheel,
    "journal": journal, "crank": crank,
}  # fmt: skip
