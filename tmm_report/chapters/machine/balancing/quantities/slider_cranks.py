"""The numbers of the slider-cranks of a mechanism: harmonics of the slider's motion, Lanchester's rotors."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.machine.balancing.solve.slider_cranks import Remaining
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.masses import slider_harmonics
from tmm_report.mechanics.masses.slider_harmonics import SliderCrank
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol

SERIES = N_("harmonics of the acceleration of slider %(name)s, exact and by the series in λ")
FORCES = N_("inertia force of what reciprocates with slider %(name)s, and what the rotors leave of it")

ORDER = Quantity("order", Symbol("k"), "", Message(N_("order of the harmonic")))
COSINE = Quantity("A", Symbol("A", "k"), "", Message(N_("coefficient of the cosine, exact")))
SINE = Quantity("B", Symbol("B", "k"), "", Message(N_("coefficient of the sine, exact")))
ONE = Quantity("A_one", Symbol("A", "k", "'"), "", Message(N_("by one term of the series in λ")))
ONE_MISS = Quantity("miss_one", Symbol("delta", "", "'"), "", Message(N_("error of one term")))
TWO = Quantity("A_two", Symbol("A", "k", "''"), "", Message(N_("by two terms of the series in λ")))
TWO_MISS = Quantity("miss_two", Symbol("delta", "", "''"), "", Message(N_("error of two terms")))
OF_ROOT = Quantity(
    "c", Symbol("c", "k"), "", Message(N_("coefficient of the cosine in the cosine of the rod's angle"))
)
AMPLITUDE = Quantity("F", Symbol("F", "k"), "N", Message(N_("amplitude of the inertia force of the order")))


def tables(found: Found) -> Iterator[Table]:
    for crank, remains in zip(found.cranks, found.remains, strict=True):
        yield _series(crank, float(found.kinematics.omega))
        columns = _forces(crank, remains)
        meaning = Message(FORCES, {"name": crank.joint})
        yield Table(f"slider_forces_{crank.slider}", meaning, (*where(found.kinematics.turned), *columns))


def _series(crank: SliderCrank, omega: float) -> Table:
    orders, lam = crank.orders, crank.lam

    def named(of: Quantity, values: list[float]) -> Column:
        symbol = of.sign
        return Column(of, np.array(values), [Symbol(symbol.base, str(k), symbol.sup) for k in orders])

    coefficients = [float(crank.harmonics.cosine[k]) for k in orders]
    exact = coefficients if crank.central else [_settled(one) for one in coefficients]
    columns = [Quantity("order", None, "", ORDER.meaning).column(list(orders)), named(COSINE, exact)]
    if crank.central:
        short, long = ([slider_harmonics.acceleration_series(lam, k, n) for k in orders] for n in (1, 2))
        columns += [
            named(ONE, short),
            ONE_MISS.column(np.array(short) / np.array(exact) - 1),
            named(TWO, long),
            TWO_MISS.column(np.array(long) / np.array(exact) - 1),
            named(OF_ROOT, [slider_harmonics.root_exact(lam, k) if k > 1 else np.nan for k in orders]),
        ]
    else:
        columns.append(named(SINE, [_settled(float(crank.harmonics.sine[k])) for k in orders]))
    columns.append(named(AMPLITUDE, [crank.force(omega, k) for k in orders]))
    return Table(f"slider_harmonics_{crank.slider}", Message(SERIES, {"name": crank.joint}), tuple(columns))


def _settled(coefficient: float) -> float:
    """Without the rounding of sums of numbers of the size of 1."""
    return 0.0 if abs(coefficient) <= 1e-13 else coefficient


def inertia(crank: SliderCrank) -> Quantity:
    meaning = Message(
        N_("inertia force of what reciprocates with slider %(name)s, along its guide"), {"name": crank.joint}
    )
    return Quantity("F_slider", Symbol("F", crank.joint), "N", meaning)


AFTER_FIRST = Quantity(
    "F_first", Symbol("F", "", "I"), "N", Message(N_("left by the rotors of the first order"))
)
AFTER_SECOND = Quantity(
    "F_second", Symbol("F", "", "II"), "N", Message(N_("left by the rotors of both orders"))
)


def _forces(crank: SliderCrank, remains: Remaining) -> Iterator[Column]:
    yield inertia(crank).column(remains.exact)
    yield AFTER_FIRST.column(remains.first)
    yield AFTER_SECOND.column(remains.second)


def _own(crank: SliderCrank, key: str, base: str, unit: str, text: str, sub: str = "") -> Quantity:
    meaning = Message(text, {"name": crank.joint})
    return Quantity(f"slider_{key}_{crank.slider}", Symbol(base, sub), unit, meaning)


def values(found: Found) -> Iterator[Value]:
    for crank, remains in zip(found.cranks, found.cycle_remains, strict=True):
        yield from of_crank(crank)
        yield from _balancer(found, crank, remains)


def of_crank(crank: SliderCrank) -> Iterator[Value]:
    """Sizes of a slider-crank."""
    r, rod = Symbol("r"), Symbol("l")
    yield Quantity(f"slider_r_{crank.slider}", r, "m", Message(N_("radius of the crank"))).value(crank.r)
    yield Quantity(f"slider_l_{crank.slider}", rod, "m", Message(N_("length of the connecting rod"))).value(
        crank.l
    )
    text = N_("crank radius by rod length")
    yield Quantity(f"slider_lambda_{crank.slider}", Symbol("lambda"), "", Message(text)).value(crank.lam)
    text = N_("rod length by crank radius, λ of other lectures")
    yield Quantity(f"slider_lambda_L_{crank.slider}", Symbol("lambda", "L"), "", Message(text)).value(
        1 / crank.lam
    )
    if not crank.central:
        text = N_("offset of the crank's pivot from the line of point %(name)s")
        yield _own(crank, "offset", "e", "m", text).value(crank.offset)
    text = N_("mass that reciprocates with slider %(name)s")
    yield _own(crank, "m_B", "m", "kg", text, crank.joint).value(crank.mass)


def _balancer(found: Found, crank: SliderCrank, remains: Remaining) -> Iterator[Value]:
    """Rotors against the first two orders; what is left of the force."""
    radii = found.given.radii
    for order, roman in ((1, "I"), (2, "II")):
        text = N_("mass by radius of each rotor of order %(order)s for slider %(name)s")
        meaning = Message(text, {"order": order, "name": crank.joint})
        product = crank.product(order)
        yield Quantity(f"slider_U_{roman}_{crank.slider}", Symbol("U", roman), "kg·m", meaning).value(product)
        if radii is not None:
            text = N_("radius of the rotors of order %(order)s")
            meaning = Message(text, {"order": order})
            yield Quantity(f"slider_r_{roman}_{crank.slider}", Symbol("r", roman), "m", meaning).value(
                radii[order - 1]
            )
            text = N_("mass of each rotor of order %(order)s")
            meaning = Message(text, {"order": order})
            mass = product / radii[order - 1]
            yield Quantity(f"slider_m_{roman}_{crank.slider}", Symbol("m", roman), "kg", meaning).value(mass)
    texts = (
        ("F_B_max", N_("greatest inertia force of what reciprocates with slider %(name)s"), remains.exact),
        (
            "F_I_max",
            N_("greatest force left by the rotors of the first order, slider %(name)s"),
            remains.first,
        ),
        ("F_II_max", N_("greatest force left by the rotors of both orders, slider %(name)s"), remains.second),
    )
    for key, text, force in texts:
        value, at = fourier.greatest(force)
        yield _own(crank, key, "F", "N", text, "max").value(value, at)
