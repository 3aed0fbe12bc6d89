"""The numbers of the machine with its governor: steady states, small motions, stability, the response."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.governor.quantities.given import value
from tmm_report.chapters.machine.governor.solve.in_loop import LoopFound
from tmm_report.i18n import NP_
from tmm_report.mechanics.machine.governor import stability as small
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, plain, text_column
from tmm_report.quantity.symbols import Symbol

NP_("index", "lin")  # by the equations of small motions
NP_("index", "lim")  # allowed
NP_("index", "re")  # real part
NP_("index", "im")  # imaginary part
NP_("index", "st")  # static
NP_("index", "set")  # of settling
LIN, ALL, RE, IM = "lin", "lim", "re", "im"

T = Quantity("t", Symbol("t"), "s", Message(N_("time")))
OMEGA = Quantity("omega", Symbol("omega"), "rad/s", Message(N_("speed of the machine")))
LINEAR = Quantity(
    "deviation_linear",
    Symbol("Deltaomega", LIN),
    "rad/s",
    Message(N_("deviation of the speed of the machine from that before the step, by the small motions")),
)
DEVIATION = Quantity(
    "deviation",
    Symbol("Deltaomega"),
    "rad/s",
    Message(N_("deviation of the speed of the machine from that before the step")),
)
Z = Quantity("z", Symbol("z"), "m", Message(N_("lift of the sleeve")))
SUPPLY = Quantity("s", Symbol("s"), "", Message(N_("supply of the machine, of the full one")))
BACK = Quantity("x", Symbol("x"), "m", Message(N_("shift of the valve by the isodromic feedback")))
LOAD = Quantity("M_c", Symbol("M", "c"), "N·m", Message(N_("moment of the load")))
FULL = Quantity("M_d", Symbol("M", "d"), "N·m", Message(N_("moment of the drive at full supply")))

STATES = {
    "phi": (Symbol("phi"), Message(N_("relative deviation of the speed of the machine"))),
    "eta": (Symbol("eta"), Message(N_("relative deviation of the sleeve"))),
    "vartheta": (Symbol("theta"), Message(N_("rate of the relative deviation of the sleeve"))),
    "sigma": (Symbol("sigma"), Message(N_("deviation of the supply"))),
    "xi": (Symbol("xi"), Message(N_("relative shift of the valve by the isodromic feedback"))),
}


def state(name: str) -> Quantity:
    """Of the equations of small motions; a coefficient beside it in a row of their matrix."""
    symbol, meaning = STATES[name]
    return Quantity(name, symbol, "", meaning)


def tables(found: LoopFound) -> Iterator[Table]:
    yield Table(
        "governor_steady",
        Message(N_("steady states of the machine before and after the step")),
        _steady(found),
    )
    yield Table("governor_response", Message(N_("response to the step of the load")), _response(found))
    yield Table(
        "governor_matrix", Message(N_("matrix of the equations of small motions, SI")), _matrix(found)
    )
    yield Table(
        "governor_eigenvalues", Message(N_("eigenvalues of the equations of small motions")), _roots(found)
    )
    yield Table(
        "governor_hurwitz",
        Message(N_("characteristic equation and Hurwitz's determinants, SI")),
        _hurwitz(found),
    )
    if found.servo is not None and found.servo.beta:
        meaning = Message(N_("boundary of stability over the feedback and the time of the isodrome"))
        yield Table("governor_boundary", meaning, _boundary(found))


def _steady(found: LoopFound) -> tuple[Column, ...]:
    both = found.before, found.after
    return (
        text_column("state", Message(N_("steady state")), ["before", "after"]),
        _twice(LOAD, [one.load for one in both]),
        _twice(FULL, [one.full for one in both]),
        _twice(OMEGA, [one.omega for one in both]),
        _twice(Z, [one.z for one in both]),
        _twice(SUPPLY, [one.s for one in both]),
    )


def _twice(quantity: Quantity, numbers: list[float]) -> Column:
    """Before and after, with the index 1 and 2."""
    base, sub = quantity.sign.base, quantity.sign.sub
    names = [Symbol(base, ",".join(filter(None, (sub, index)))) for index in "12"]
    return Column(quantity, numbers, names)


def _response(found: LoopFound) -> tuple[Column, ...]:
    response = found.response
    start = found.before.omega
    columns = [
        T.column(response.t),
        OMEGA.column(response.omega),
        DEVIATION.column(response.omega - start),
        LINEAR.column(found.linear + found.after.omega - start),
        Z.column(response.z),
        SUPPLY.column(response.s),
    ]
    return (*columns, BACK.column(response.x)) if response.x is not None else tuple(columns)


def _matrix(found: LoopFound) -> tuple[Column, ...]:
    names = found.states
    rows = text_column("state", Message(N_("whose rate the row gives")), list(names))
    return (rows, *(state(name).column(found.matrix[:, k]) for k, name in enumerate(names)))


def _roots(found: LoopFound) -> tuple[Column, ...]:
    roots = found.eigenvalues
    real = Quantity("real", Symbol("lambda", RE), "rad/s", Message(N_("real part of the eigenvalue")))
    imaginary = Quantity(
        "imaginary", Symbol("lambda", IM), "rad/s", Message(N_("imaginary part of the eigenvalue"))
    )
    number = plain("number", "", Message(N_("number of the eigenvalue")), list(range(1, len(roots) + 1)))
    return (number, real.column(roots.real), imaginary.column(roots.imag))


def _hurwitz(found: LoopFound) -> tuple[Column, ...]:
    """Δ₀ stands for the leading coefficient."""
    order = len(found.polynomial)
    numbers = [str(k) for k in range(order)]
    coefficient = Quantity("a", Symbol("a"), "", Message(N_("coefficient of the characteristic equation")))
    determinant = Quantity("Delta", Symbol("Delta"), "", Message(N_("Hurwitz's determinant")))
    return (
        plain("k", "", Message(N_("number of the coefficient")), list(range(order))),
        Column(coefficient, found.polynomial, [Symbol("a", k) for k in numbers]),
        Column(
            determinant, np.append(found.polynomial[0], found.hurwitz), [Symbol("Delta", k) for k in numbers]
        ),
    )


def _boundary(found: LoopFound) -> tuple[Column, ...]:
    nu, beta, Ti = found.boundary
    frequency = Quantity(
        "nu", Symbol("nu"), "rad/s", Message(N_("frequency of the oscillation at the boundary"))
    )
    back = Quantity("beta", Symbol("beta"), "", Message(N_("feedback of the isodrome at the boundary")))
    time = Quantity("T_i", Symbol("T", "i"), "s", Message(N_("time of the isodrome at the boundary")))
    return (frequency.column(nu), back.column(beta), time.column(Ti))


# --- single numbers


def values(found: LoopFound) -> Iterator[Value]:
    yield from _given(found)
    yield from _small(found)
    if found.servo is None:
        yield from _cubic(found)
    else:
        yield from _servo(found)
    yield from _of_response(found)


def _given(found: LoopFound) -> Iterator[Value]:
    plant, machine = found.plant, found.machine
    yield value("J", Symbol("J"), "kg·m²", N_("moment of inertia of the machine"), plant.inertia)
    yield value("i", Symbol("i"), "", N_("speed of the governor's shaft by that of the machine"), plant.ratio)
    yield value("omega_mean", Symbol("omega", "m"), "rad/s", N_("mean speed of the machine"), machine.omega)
    yield value(
        "M_mean",
        Symbol("M", "m"),
        "N·m",
        N_("moment of the drive at full supply and mean speed"),
        plant.torque,
    )
    yield value(
        "k_d",
        Symbol("k", "d"),
        "N·m·s/rad",
        N_("fall of the moment of the drive with the speed"),
        plant.slope,
    )
    yield value(
        "k_c", Symbol("k", "c"), "N·m·s/rad", N_("growth of the load with the speed"), plant.load_slope
    )
    yield value(
        "load_before", Symbol("M", "c,1"), "N·m", N_("load before the step at mean speed"), plant.before
    )
    yield value("load_after", Symbol("M", "c,2"), "N·m", N_("load after the step at mean speed"), plant.after)
    yield value(
        "s_min", Symbol("s", "min"), "", N_("least supply, with the sleeve at its upper stop"), plant.least
    )
    yield value(
        "F_throttle",
        Symbol("F", "s"),
        "N",
        N_("force at the sleeve that moves the throttle"),
        plant.throttle.force,
    )
    if plant.throttle.insensitivity is not None and found.throttle_allowed is not None:
        yield value(
            "epsilon_allowed",
            Symbol("epsilon", ALL),
            "",
            N_("insensitivity allowed"),
            plant.throttle.insensitivity,
        )
        text = N_("friction on the sleeve that the insensitivity allows")
        yield value("F_allowed", Symbol("F", ALL), "N", text, found.throttle_allowed)
        resisting = found.friction + plant.throttle.force
        yield value(
            "F_sum", Symbol("F", "fr,s"), "N", N_("friction on the sleeve with the throttle"), resisting
        )


def _small(found: LoopFound) -> Iterator[Value]:
    loop = found.loop
    yield value(
        "after_omega", Symbol("omega"), "rad/s", N_("speed of the machine in the steady state"), loop.omega
    )
    yield value(
        "after_M_d", Symbol("M", "d"), "N·m", N_("moment of the full supply in the steady state"), loop.M
    )
    yield value("after_s", Symbol("s"), "", N_("supply in the steady state"), found.after.s)
    yield value(
        "after_A", Symbol("A"), "kg·m", N_("inertial coefficient in the steady state"), found.inertial
    )
    yield value("after_S", Symbol("S"), "N/m", N_("factor of stability in the steady state"), loop.S)
    yield value("after_m", Symbol("m", "red"), "kg", N_("mass of the governor reduced to the sleeve"), loop.m)
    yield value("D", Symbol("D"), "N·m·s/rad", N_("self-regulation of the machine"), loop.D)
    yield value("R", Symbol("R"), "N·s/rad", N_("force on the sleeve by the speed of the machine"), loop.R)
    slowest = float(found.eigenvalues.real.max())
    yield value(
        "slowest", Symbol("lambda", "max"), "rad/s", N_("greatest real part of the eigenvalues"), slowest
    )


def _cubic(found: LoopFound) -> Iterator[Value]:
    yield value("Q_s", Symbol("Q", "s"), "N", N_("fall of the driving moment by the lift"), found.loop.Q)
    units = ("kg²·m²", "kg²·m²/s", "kg²·m²/s²", "kg²·m²/s³")
    for k, (number, unit) in enumerate(zip(small.cubic(found.loop), units, strict=True)):
        text = N_("coefficient of the characteristic equation")
        yield value(f"a_{k}", Symbol("a", str(k)), unit, text, float(number))
    if found.vyshnegradsky is not None:
        x, y = found.vyshnegradsky
        text = N_("unit of the roots in Vyshnegradsky's form")
        cubic = small.cubic(found.loop)
        yield value("p", Symbol("p"), "rad/s", text, float((cubic[3] / cubic[0]) ** (1 / 3)))
        yield value("X", Symbol("X"), "", N_("first parameter of Vyshnegradsky"), x)
        yield value("Y", Symbol("Y"), "", N_("second parameter of Vyshnegradsky"), y)
        yield value("XY", Symbol("XY"), "", N_("product of Vyshnegradsky's parameters"), x * y)
    if found.damping_needed:
        text = N_("dashpot of the sleeve above which the loop is stable")
        yield value("k_min", Symbol("k", "min"), "N·s/m", text, found.damping_needed)


def _servo(found: LoopFound) -> Iterator[Value]:
    servo, direct = found.servo, found.delta
    assert servo is not None
    yield value("T_s", Symbol("T", "s"), "s", N_("time of the servomotor"), servo.T)
    yield value(
        "zone", Symbol("z", "0"), "m", N_("shift of the valve within which it stays closed"), servo.zone
    )
    text = N_("lift at which the valve is closed")
    yield value("z_m", Symbol("z", "m"), "m", text, found.governor.neutral)
    if servo.beta:
        yield value("beta", Symbol("beta"), "", N_("feedback of the isodrome"), servo.beta)
        yield value("T_i", Symbol("T", "i"), "s", N_("time of the isodrome"), servo.Ti)
        text = N_("temporary non-uniformity by the isodrome")
        yield value("b_t", Symbol("b", "t"), "", text, servo.beta * direct)
    if found.feedback_needed is not None:
        low, high = found.feedback_needed
        if low > 0:
            text = N_("feedback of the isodrome above which the loop is stable")
            yield value("beta_min", Symbol("beta", "min"), "", text, low)
        if np.isfinite(high):
            text = N_("feedback of the isodrome below which the loop is stable")
            yield value("beta_max", Symbol("beta", "max"), "", text, high)


def _of_response(found: LoopFound) -> Iterator[Value]:
    response = found.response
    text = N_("change of the steady speed, of that before the step")
    yield value("static", Symbol("Delta", "st"), "", text, found.static_error)
    text = N_("greatest deviation of the speed, of that before the step")
    yield value("peak", Symbol("Delta", "max"), "", text, found.peak)
    at = float(response.t[found.worst])
    yield value("peak_time", Symbol("t", "max"), "s", N_("time of the greatest deviation of the speed"), at)
    text = N_("change of the speed in the time that is shown, of that before the step")
    yield value("final", Symbol("Delta", "t"), "", text, found.final / found.before.omega - 1)
    if found.settled is not None:
        text = N_("time after which the speed stays within 5 %% of the greatest deviation from the final one")
        yield value("settled", Symbol("t", "set"), "s", text, found.settled)
