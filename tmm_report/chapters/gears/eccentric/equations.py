"""Equations and definitions of the teeth in symbols, each built of the numbers of the chosen set, so that a test can
evaluate them."""

from __future__ import annotations

from tmm_report.chapters.gears.eccentric.steps import Mechanism
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Number, Page, Piece, Var
from tmm_report.quantity.model import Value
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.written import Equation
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Coefficient(Number):
    """A number of the results among the symbols of an equation, with all its digits."""

    ref: Ref | None = None

    def piece(self, page: Page) -> Piece:
        return page.number(float(self.number), 10, scale=0.0, ref=self.ref)


def coefficient(of: Value, size: bool = False) -> Coefficient:
    """`size`: without its sign, which stands before it."""
    return Coefficient(abs(of.value) if size else of.value, of.ref(size=size))


def second(of: Mechanism) -> Var:
    """The satellite of the equation: the largest, or a middle one where that has half a tooth."""
    return of.set.z4 if of.found.halved else of.set.z2


def general(of: Mechanism) -> Equation:
    """(1 − u) k z1 + 2 k z2 − E k = 0, or (1 − u) k z1 + 2 k z4 = 0."""
    s, k = of.s, of.s.equation_k
    terms = (1 - s.u_teeth) * k * s.z1 + 2 * k * second(of)
    return Equation(terms if of.found.halved else terms - s.E * k, numbers=False)


def with_numbers(of: Mechanism) -> Equation:
    """The same with its coefficients; one of −1 is not written."""
    a, b, c = (of.s[f"equation_{name}"] for name in "abc")
    terms = -of.s.z1 if a.value == -1 else coefficient(a) * of.s.z1
    terms = terms + coefficient(b) * second(of)
    return Equation(terms if of.found.halved else terms - coefficient(c, size=True), numbers=False)


def solutions(of: Mechanism) -> list[Definition]:
    """Both teeth of the equation for any t."""
    s, turned = of.s, of.s.a_1 * of.s.t
    if of.found.halved:
        return [Definition(s.z1.sign, -(s.b_1 * s.t)), Definition(second(of).sign, turned)]
    return [Definition(s.z1.sign, s.z1_0 - s.b_1 * s.t), Definition(second(of).sign, s.z2_0 + turned)]


def ring_teeth(of: Mechanism) -> Definition:
    return Definition(of.s.z3.sign, of.s.u_teeth * of.s.z1)


def middle_teeth(of: Mechanism) -> Definition:
    return Definition(of.set.z4.sign, (of.s.z3 - of.s.z1) / 2)


def smallest_teeth(of: Mechanism) -> Definition:
    return Definition(of.set.z5.sign, of.set.z2 - of.s.E)


def near(of: Mechanism) -> list[Definition]:
    """By how much a set near the ratio misses it, relative; its largest satellite."""
    s = of.s
    return [
        Definition("Delta_u", (s.z3 / s.z1 - s.u_wanted) / s.u_wanted),
        Definition(of.set.z2.sign, (s.z3 - s.z1) / 2 + s.e / s.m),
    ]
