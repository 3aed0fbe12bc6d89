"""The numbers of the speed governor: its equilibrium, the loop with its machine, the brake."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.machine.governor.values import (
    Boundary,
    Braking,
    Hurwitz,
    Motion,
    Places,
    Roots,
    States,
)
from tmm_report.mechanics.machine.governor.equilibrium import Arms
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, Value, plain, text_column
from tmm_report.quantity.sheet import Q
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

HEADLINE = (
    "governor_delta",
    "governor_effort",
    "governor_omega_0",
    "governor_omega_h",
    "governor_brake_contact",
    "governor_brake_held",
    "governor_brake_power",
    "governor_brake_settled",
)  # what is looked for first

if TYPE_CHECKING:
    from tmm_report.chapters.machine.governor.solve.brake import BrakeFound
    from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
    from tmm_report.chapters.machine.governor.solve.in_loop import LoopFound
    from tmm_report.chapters.machine.governor.solve.whole import Found

__all__ = ["tables", "values"]


@tabulated
def values(found: Found) -> Iterator[Value]:
    if found.direct is not None:
        yield from found.direct.s.values()
    if found.brake is not None:
        yield from found.brake.s.values()


@tabulated
def tables(found: Found) -> Iterator[Table]:
    if found.direct is not None:
        yield from of_direct(found.direct)
    if found.loop is not None:
        yield from of_loop(found.loop)
    if found.brake is not None:
        yield from of_brake(found.brake)


def _table(name: str, meaning: str, columns: Iterable[Column]) -> Table:
    return Table(f"governor_{name}", Message(meaning), tuple(columns))


# --- the centrifugal governor by itself


@tabulated
def of_direct(found: DirectFound) -> Iterator[Table]:
    yield _table("equilibrium", N_("equilibrium of the governor over the lift"), _places(found))
    yield _table("curve", N_("curves of equilibrium of the governor"), _curve(found))


def places(found: DirectFound) -> Table:
    """The equilibrium over the lift."""
    return next(iter(of_direct(found)))


def _places(found: DirectFound) -> Iterator[Column]:
    at, balls, friction = found.table, found.table.balls, found.given.sleeve.friction
    down, up = at.band(friction)
    yield plain("point", "", Message(N_("number of the place of the sleeve")), list(range(len(balls.z))))
    yield Places.z.column(balls.z)
    yield from _arms(found)
    for name, angle in balls.tilt.items():
        yield Places.DECLARED[name].column(angle)
    yield Places.r.column(balls.r)
    yield Places.dr.column(balls.dr)
    yield Places.dy.column(balls.dh)
    yield Places.A.column(at.A)
    yield Places.E.column(at.E)
    yield Places.dA.column(at.dA)
    yield Places.dE.column(at.dE)
    yield Places.omega_g.column(at.omega)
    yield Places.C.column(at.force)
    yield Places.S.column(at.S)
    yield Places.omega_low.column(down)
    yield Places.omega_up.column(up)
    yield Places.epsilon.column(at.insensitivity(friction))


def _arms(found: DirectFound) -> Iterator[Column]:
    """Height and pin of the two arms."""
    arms, z = found.given.geometry, found.table.balls.z
    if isinstance(arms, Arms):
        height = arms.height(found.given.lowest) - z
        yield Places.H.column(height)
        yield Places.x.column(arms.pin(height))
        yield Places.dx.column(arms.pin_slope(found.table.balls.tilt))


def _curve(found: DirectFound) -> Iterator[Column]:
    at = found.curve
    yield Places.z.column(at.balls.z)
    yield Places.r.column(at.balls.r)
    yield Places.omega_g.column(at.omega)
    yield Places.C.column(at.force)


# --- the machine with its governor


@tabulated
def of_loop(found: LoopFound) -> Iterator[Table]:
    yield _table("steady", N_("steady states of the machine before and after the step"), _steady(found))
    yield _table("response", N_("response to the step of the load"), _response(found))
    yield _table("matrix", N_("matrix of the equations of small motions, SI"), _matrix(found))
    yield _table("eigenvalues", N_("eigenvalues of the equations of small motions"), _roots(found))
    yield _table("hurwitz", N_("characteristic equation and Hurwitz's determinants, SI"), _hurwitz(found))
    if found.servo is not None and found.servo.beta:
        meaning = N_(
            "boundary of stability over the feedback and the time constant of the isodromic feedback"
        )
        yield _table("boundary", meaning, _boundary(found))


def steady(found: LoopFound) -> Table:
    """The steady states before and after the step."""
    return next(iter(of_loop(found)))


def _steady(found: LoopFound) -> Iterator[Column]:
    both = found.before, found.after
    yield text_column("state", Message(N_("steady state")), ["before", "after"])
    yield _twice(Motion.M_c, [one.load for one in both])
    yield _twice(Motion.M_d, [one.full for one in both])
    yield _twice(Motion.omega, [one.omega for one in both])
    yield _twice(Motion.z, [one.z for one in both])
    yield _twice(Motion.s, [one.s for one in both])


def _twice(of: Q, numbers: list[float]) -> Column:
    """Before and after, with the index 1 and 2."""
    sign = of.quantity.sign
    names = [Symbol(sign.base, ",".join(filter(None, (sign.sub, index)))) for index in "12"]
    return Column(of.quantity, numbers, names)


def _response(found: LoopFound) -> Iterator[Column]:
    response, start = found.response, found.before.omega
    yield Motion.t.column(response.t)
    yield Motion.omega.column(response.omega)
    yield Motion.deviation.column(response.omega - start)
    yield Motion.deviation_linear.column(found.linear + found.after.omega - start)
    yield Motion.z.column(response.z)
    yield Motion.s.column(response.s)
    if response.x is not None:
        yield Motion.x.column(response.x)


def _matrix(found: LoopFound) -> Iterator[Column]:
    yield text_column("state", Message(N_("whose rate the row gives")), list(found.states))
    for k, name in enumerate(found.states):
        yield States.DECLARED[name].column(found.matrix[:, k])


def _roots(found: LoopFound) -> Iterator[Column]:
    roots = found.eigenvalues
    yield plain("number", "", Message(N_("number of the eigenvalue")), list(range(1, len(roots) + 1)))
    yield Roots.real.column(roots.real)
    yield Roots.imaginary.column(roots.imag)


def _hurwitz(found: LoopFound) -> Iterator[Column]:
    """Δ₀ stands for the leading coefficient."""
    order = len(found.polynomial)
    numbers = [str(k) for k in range(order)]
    determinants = np.append(found.polynomial[0], found.hurwitz)
    yield plain("k", "", Message(N_("number of the coefficient")), list(range(order)))
    yield Column(Hurwitz.a.quantity, found.polynomial, [Symbol("a", k) for k in numbers])
    yield Column(Hurwitz.Delta.quantity, determinants, [Symbol("Delta", k) for k in numbers])


def _boundary(found: LoopFound) -> Iterator[Column]:
    nu, beta, Ti = found.boundary
    yield Boundary.nu.column(nu)
    yield Boundary.beta.column(beta)
    yield Boundary.T_i.column(Ti)


# --- the brake


@tabulated
def of_brake(found: BrakeFound) -> Iterator[Table]:
    moments = Braking.omega.column(found.omega), Braking.M_b.column(found.moment)
    yield _table("brake", N_("braking moment over the speed"), moments)
    if len(found.t):
        start = Braking.t.column(found.t), Braking.omega.column(found.started)
        yield _table("brake_start", N_("start of the shaft with the brake"), start)
