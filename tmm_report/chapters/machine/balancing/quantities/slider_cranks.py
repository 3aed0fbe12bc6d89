"""The numbers of the slider-cranks of a mechanism: harmonics of the slider's motion, Lanchester's rotors."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.machine.balancing.solve.slider_cranks import Remaining
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.chapters.machine.balancing.values import Remains, Series, inertia
from tmm_report.mechanics.masses import slider_harmonics
from tmm_report.mechanics.masses.slider_harmonics import SliderCrank
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, plain
from tmm_report.quantity.sheet import Q
from tmm_report.quantity.symbols import Symbol

SERIES = N_("harmonics of the acceleration of slider %(name)s, exact and by the series in λ")
FORCES = N_("inertia force of what reciprocates with slider %(name)s, and what the rotors leave of it")


def tables(found: Found) -> Iterator[Table]:
    for crank, remains in zip(found.cranks, found.remains, strict=True):
        yield _series(crank, float(found.kinematics.omega))
        columns = _forces(crank, remains)
        meaning = Message(FORCES, {"name": crank.joint})
        yield Table(f"slider_forces_{crank.slider}", meaning, (*where(found.kinematics.turned), *columns))


def _series(crank: SliderCrank, omega: float) -> Table:
    orders, lam = crank.orders, crank.lam

    def named(of: Q, values: list[float]) -> Column:
        symbol = of.quantity.sign
        return Column(
            of.quantity, np.array(values), [Symbol(symbol.base, str(k), symbol.sup) for k in orders]
        )

    coefficients = [float(crank.harmonics.cosine[k]) for k in orders]
    exact = coefficients if crank.central else [_settled(one) for one in coefficients]
    columns = [plain("order", "", Series.order.meaning, list(orders)), named(Series.A, exact)]
    if crank.central:
        short, long = ([slider_harmonics.acceleration_series(lam, k, n) for k in orders] for n in (1, 2))
        columns += [
            named(Series.A_one, short),
            Series.miss_one.column(np.array(short) / np.array(exact) - 1),
            named(Series.A_two, long),
            Series.miss_two.column(np.array(long) / np.array(exact) - 1),
            named(Series.c, [slider_harmonics.root_exact(lam, k) if k > 1 else np.nan for k in orders]),
        ]
    else:
        columns.append(named(Series.B, [_settled(float(crank.harmonics.sine[k])) for k in orders]))
    columns.append(named(Series.F, [crank.force(omega, k) for k in orders]))
    return Table(f"slider_harmonics_{crank.slider}", Message(SERIES, {"name": crank.joint}), tuple(columns))


def _settled(coefficient: float) -> float:
    """Without the rounding of sums of numbers of the size of 1."""
    return 0.0 if abs(coefficient) <= 1e-13 else coefficient


def _forces(crank: SliderCrank, remains: Remaining) -> Iterator[Column]:
    yield inertia(crank.joint).column(remains.exact)
    yield Remains.F_first.column(remains.first)
    yield Remains.F_second.column(remains.second)
