"""Single numbers of the balancing: what the whole is left with, and each slider-crank, whose numbers are assigned the
expressions that the note prints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.machine.balancing.given import Given
from tmm_report.chapters.machine.balancing.values import Series, Slider, Values
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.masses.slider_harmonics import SliderCrank
from tmm_report.quantity.formula import Var
from tmm_report.quantity.model import variable
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.sheet import Reached
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.machine.balancing.solve.cases import Case
    from tmm_report.chapters.machine.balancing.solve.slider_cranks import Remaining

Array = Any


def whole(
    given: Given, every: Sequence[Case], tail: float, seen: Array, circle: tuple[complex, float]
) -> Values:
    """`every`: the mechanism as it is and each way of balancing it; `seen`: see `Found`."""
    s = Values()
    s.k_part = given.part
    s.balancing_disagreement = max(case.check for case in every if case.check is not None)
    s.shaking_tail = tail
    centre, mean, size = circle[0], complex(seen.mean()), float(np.abs(seen).max())

    def settled(number: float) -> float:
        return 0.0 if abs(number) <= 1e-10 * size else number

    s.seen_x, s.seen_y = settled(centre.real), settled(centre.imag)
    s.seen_mean_x, s.seen_mean_y = settled(mean.real), settled(mean.imag)
    s.seen_radius = circle[1]
    return s


def slider(given: Given, crank: SliderCrank, remains: Remaining) -> Slider:
    """Sizes of a slider-crank, rotors against the first two orders, what they leave over the cycle."""
    s = Slider(crank.slider, crank.joint)
    s.r, s.l, s.m_B = crank.r, crank.l, crank.mass
    s.lam = s.r / s.l
    s.lambda_L = s.l / s.r
    if crank.central:
        whole = s.m_B * s.r
        s.U_I = whole / 2
        s.U_II = abs(coefficient(crank, 2)) * whole / 8
    else:  # sines, too: the formulas hold no more
        s.offset = crank.offset
        s.U_I, s.U_II = crank.product(1), crank.product(2)
    if 1 in given.radii:
        s.r_I = given.radii[1]
        s.m_I = s.U_I / s.r_I
    if 2 in given.radii:
        s.r_II = given.radii[2]
        s.m_II = s.U_II / s.r_II
    for key, left in (("F_B_max", remains.exact), ("F_I_max", remains.first), ("F_II_max", remains.second)):
        s.put(key, Reached(*fourier.greatest(left)))
    return s


def coefficient(crank: SliderCrank, order: int) -> Var:
    """A_k of the slider's acceleration, which stands in the table of its harmonics."""
    row, of = crank.orders.index(order), Series.A.quantity
    ref = Ref(of.key, row, f"slider_harmonics_{crank.slider}")
    number = float(crank.harmonics.cosine[order])
    return variable(of, number, ref=ref, symbol=Symbol(of.sign.base, str(order)))
