"""Formulas of friction on planes and screws, one list a kind, each worked from the numbers of its pair."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from tmm_report.chapters.machine.contacts.given import Incline, Sliders
from tmm_report.chapters.machine.contacts.quantities import name, terms
from tmm_report.chapters.machine.contacts.solve import Solved
from tmm_report.problems import Message
from tmm_report.quantity.formula import PI, Expr, Formula, Function, Var, cos, sin, tan
from tmm_report.quantity.model import Table
from tmm_report.quantity.terms.gear_terms import arctan


class Of:
    """The numbers of a pair as variables and results of formulas: `of("Q")`, `of.gives("F_up", …)`."""

    def __init__(self, item: Solved):
        columns = tuple(q.column([item.numbers[key]]) for key, q in terms(item).items())
        self.item, self.table = item, Table(name(item), Message(item.kind), columns)

    def __call__(self, key: str, unit: str = "") -> Var:
        return self.table.var(key, 0, unit)

    def __contains__(self, key: str) -> bool:
        return key in self.item.numbers

    def gives(self, key: str, expression: Expr) -> Formula:
        return self.table.formula(key, 0, expression)


Formulas = Callable[[Of], Iterator[Formula]]


def exp(argument: Expr) -> Expr:
    return Function("exp", argument, np.exp)


def incline(of: Of) -> Iterator[Formula]:
    load, slope, phi = of("Q"), of("alpha"), of("phi")
    yield of.gives("phi", arctan(of("f")))
    if isinstance(of.item.of, Incline) and of.item.of.force == "level":
        yield of.gives("F_up", load * tan(slope + phi))
        yield of.gives("F_down", load * tan(slope - phi))
        yield of.gives("eta", tan(slope) / tan(slope + phi))
        if "eta_back" in of:
            yield of.gives("eta_back", tan(slope - phi) / tan(slope))
        return
    yield of.gives("F_up", load * sin(slope + phi) / cos(phi))
    yield of.gives("F_down", load * sin(slope - phi) / cos(phi))
    yield of.gives("eta", sin(slope) * cos(phi) / sin(slope + phi))
    if "eta_back" in of:
        yield of.gives("eta_back", sin(slope - phi) / (sin(slope) * cos(phi)))


def wedge(of: Of) -> Iterator[Formula]:
    load, slope, face, base = of("Q"), of("alpha"), of("phi"), of("phi_base")
    yield of.gives("phi", arctan(of("f")))
    yield of.gives("phi_base", arctan(of("f_base")))
    yield of.gives("F_in", load * (tan(slope + face) + tan(base)))
    yield of.gives("F_out", load * (tan(slope - face) - tan(base)))
    yield of.gives("eta", tan(slope) / (tan(slope + face) + tan(base)))
    yield of.gives("alpha_lock", face + base)


def sliders(of: Of) -> Iterator[Formula]:
    theta, both, alpha = of("theta"), of("phi_both"), of("alpha")
    yield of.gives("phi", arctan(of("f")))
    yield of.gives("phi_guide", arctan(of("f_guide")))
    yield of.gives("phi_both", of("phi") + of("phi_guide"))
    yield of.gives("alpha_best", (theta + both) / 2)
    yield of.gives("eta_best", (cos(of("alpha_best")) / cos(of("alpha_best") - both)) ** 2)
    if isinstance(of.item.of, Sliders) and of.item.of.face is None:
        yield of.gives("alpha", of("alpha_best"))
    yield of.gives("eta", cos(alpha) * cos(theta - alpha + both) / (cos(theta - alpha) * cos(alpha - both)))
    if "F" in of:
        yield of.gives("F", of("Q") * cos(alpha) / (cos(theta - alpha) * of("eta")))


def trial(of: Of) -> Iterator[Formula]:
    theta, pull, push = of("theta"), of("P_pull"), of("P_push")
    yield of.gives("f", (push - pull) / ((pull + push) * tan(theta)))
    yield of.gives("G", pull * (cos(theta) / of("f") + sin(theta)))
    yield of.gives("phi", arctan(of("f")))
    yield of.gives("P_least", of("G") * sin(of("phi")))


def screw(of: Of) -> Iterator[Formula]:
    load, d, psi, phi = of("Q"), of("d_2"), of("psi"), of("phi_red")
    yield of.gives("h", of("z") * of("p"))
    yield of.gives("psi", arctan(of("h") / (PI * d)))
    square = not of.item.numbers["beta"]
    yield of.gives("phi_red", arctan(of("f")) if square else arctan(of("f") / cos(of("beta"))))
    yield of.gives("M_thread", load * d / 2 * tan(psi + phi))
    yield of.gives("M_low", load * d / 2 * tan(phi - psi))
    yield of.gives("eta_thread", tan(psi) / tan(psi + phi))
    if "M_collar" in of:
        yield of.gives("M_collar", of("f_collar") * load * of("R_collar"))
        yield of.gives("M_screw", of("M_thread") + of("M_collar"))
        yield of.gives("M_back", of("M_low") + of("M_collar"))
    else:
        yield of.gives("M_screw", of("M_thread"))
    yield of.gives("eta", load * of("h") / (2 * PI * of("M_screw")))
    if "l_hand" in of:
        arms = of("n_hand") * of("l_hand") if "n_hand" in of else of("l_hand")
        yield of.gives("P_hand", of("M_screw") / arms)
    if "D_wheel" in of:
        yield of.gives("D_wheel", 2 * of("M_screw") / (of("n_hand") * of("P_hand")))
