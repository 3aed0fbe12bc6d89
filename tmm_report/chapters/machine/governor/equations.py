"""Equations of the machine with its governor, in symbols; their numbers: of the steady state after the step."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.machine.governor.solve.in_loop import LoopFound
from tmm_report.chapters.machine.governor.values import States
from tmm_report.i18n import Translator
from tmm_report.quantity.formula import FRACTION, Expr, Number, Page, Piece, Var
from tmm_report.quantity.symbols import Notation, Symbol, notation
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Relation:
    """left = right, in symbols alone."""

    left: Expr
    right: Expr

    def latex(self, tr: Translator) -> str:
        return self.printed(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self.printed(notation("mathml", tr))

    def printed(self, form: Notation) -> str:
        page = Page(form, numbers=False)
        first, *rest = self.right.terms(page)
        return form.formula(["".join(self.left.terms(page)) + form.operator("=") + first, *rest])


@dataclass(frozen=True, eq=False)
class Rate(Expr):
    """dφ/dt, or d²z/dt²: a derivative by the time, in symbols; nought in a steady state."""

    sign: Symbol
    order: int = 1

    def evaluate(self, digits: int | None = None) -> float:
        return 0.0

    def latex(self, tr: Translator) -> str:
        return self.printed(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self.printed(notation("mathml", tr))

    def printed(self, form: Notation) -> str:
        return form.formula([self.piece(Page(form, numbers=False)).text])

    def piece(self, page: Page) -> Piece:
        form = page.notation
        d, t, power = form.run("d"), form.run("t"), form.run(str(self.order))
        above = (d if self.order == 1 else form.power(d, power)) + form.symbol(self.sign)
        return Piece(form.fraction(above, d + (t if self.order == 1 else form.power(t, power))), FRACTION)


def rate(base: str, order: int = 1) -> Expr:
    return Rate(Symbol(base), order)


# --- large motions


def motion(found: LoopFound) -> list[Relation]:
    """The equations of large motions."""
    s, z = found.s, Var("z", found.after.z)
    load, supporting = Var("M_c", found.after.load), Var("E", float(found.there.E[0]))
    lifted = s.after_A * s.i**2 * s.after_omega**2 - supporting - s.k * rate("z")
    machine = Relation(s.J * rate("omega"), s.after_M_d * s.after_s - load)
    governor = Relation(s.after_m * rate("z", 2), lifted)
    if found.servo is not None:
        return [machine, *_moments(found, load), governor, *_piston(found, z)]
    limited = (1 - s.s_min) * z / s.h if found.plant.throttle.least else z / s.h
    return [machine, *_moments(found, load), governor, Relation(s.after_s, 1 - limited)]


def _moments(found: LoopFound, load: Var) -> list[Relation]:
    """By the speed, where they change with it."""
    s, plant = found.s, found.plant
    above = s.after_omega - s.omega_mean
    relations = []
    if plant.torque.slope:
        relations.append(Relation(s.after_M_d, s.M_mean - s.k_d * above))
    if plant.load.slope:
        relations.append(Relation(load, s.load_after + s.k_c * above))
    return relations


def _piston(found: LoopFound, z: Var) -> list[Relation]:
    assert found.servo is not None
    s, x = found.s, Var("x", 0.0)
    shift = z - s.z_m + x if found.servo.beta else z - s.z_m
    piston = Relation(s.T_s * rate("s"), -(shift / s.h))
    if not found.servo.beta:
        return [piston]
    return [piston, Relation(rate("x"), s.beta * s.h * rate("s") - x / s.T_i)]


# --- small motions


def small(found: LoopFound) -> list[Relation]:
    """In relative deviations, each 1 by itself: the right sides are then the rows of the matrix of small motions."""
    s, ones = found.s, np.eye(len(found.states))
    of = {name: Var(States.DECLARED[name].quantity.sign, ones[k]) for k, name in enumerate(found.states)}
    lift = s.R * s.after_omega / (s.after_m * s.h) * of["phi"]
    lift = lift - s.after_S / s.after_m * of["eta"] - s.k / s.after_m * of["vartheta"]
    rows = [
        Relation(rate("phi"), _driven(found, of) - s.D / s.J * of["phi"]),
        Relation(rate("eta"), of["vartheta"]),
        Relation(rate("psi"), lift),
    ]
    if "xi" in of:
        shift = (of["eta"] + of["xi"]) / s.T_s
        rows.append(Relation(rate("sigma"), -shift))
        rows.append(Relation(rate("xi"), -(s.beta * shift) - of["xi"] / s.T_i))
    elif "sigma" in of:
        rows.append(Relation(rate("sigma"), -(of["eta"] / s.T_s)))
    return rows


def _driven(found: LoopFound, of: dict[str, Var]) -> Expr:
    """By what the supply speeds the machine up."""
    s = found.s
    below = s.J * s.after_omega
    if "sigma" in of:
        return s.after_M_d / below * of["sigma"]
    if not found.plant.throttle.least:
        return -(s.after_M_d / below * of["eta"])
    return -(s.after_M_d * (1 - s.s_min) / below * of["eta"])


def characteristic(found: LoopFound) -> Relation:
    """Of direct action; λ: its roots."""
    s, root = found.s, Var("lambda", found.eigenvalues)
    return Relation(s.a_0 * root**3 + s.a_1 * root**2 + s.a_2 * root + s.a_3, Number(0))


def normal(found: LoopFound) -> Relation:
    """In Vyshnegradsky's form."""
    s, q = found.s, Var("q", found.eigenvalues / found.s.number("p"))
    return Relation(q**3 + s.X * q**2 + s.Y * q + 1, Number(0))
