"""Formulas of the place at the middle of the lift, in symbols, in numbers, with their value."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import reduce
from operator import add
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.machine.governor.quantities import places
from tmm_report.chapters.machine.governor.values import Places
from tmm_report.mechanics.machine.governor.equilibrium import Arms, BellCrank
from tmm_report.quantity.formula import Expr, Formula, Var, cos, sin, sqrt, tan
from tmm_report.quantity.functions import arcsin

if TYPE_CHECKING:
    from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound

Named = Iterator[tuple[str, Expr]]


def formulas(found: DirectFound) -> dict[str, Formula]:
    """By the key of the column."""
    table, row = places(found), found.middle
    expressions = [*_mechanism(found), *_equilibrium(found)]
    return {key: table.formula(key, row, of, Places.DECLARED[key].formed) for key, of in expressions}


def at(found: DirectFound, key: str, row: int | None = None) -> Var:
    """A number of the table; at the middle of the lift, if no row is named."""
    return places(found).var(key, found.middle if row is None else row, Places.DECLARED[key].formed)


# --- the mechanism: from the lift to r, r' and y'


def _mechanism(found: DirectFound) -> Named:
    geometry = found.given.geometry
    return _crank(found, geometry) if isinstance(geometry, BellCrank) else _arms(found, geometry)


def _arms(found: DirectFound, arms: Arms) -> Named:
    s, x = found.s, at(found, "x")
    one = x - s.e_1 if arms.upper_offset else x
    two = x - s.e_2 if arms.lower_offset else x
    alpha, beta = at(found, "alpha"), at(found, "beta")
    yield "H", sqrt(s.l_1**2 - one**2) + sqrt(s.l_2**2 - two**2)
    yield "alpha", arcsin(one / s.l_1)
    yield "beta", arcsin(two / s.l_2)
    yield "dx", 1 / (tan(alpha) + tan(beta))
    if arms.distance is None and arms.extension is not None:
        yield from _on_lower(found)
        return
    if arms.distance is not None:
        across = s.L * sin(alpha)
        yield "r", s.e_1 + across if arms.upper_offset else across
        yield "dr", at(found, "dx") * s.L / s.l_1
    else:
        yield "r", x
        yield "dr", at(found, "dx")
    yield "dy", at(found, "dr") * tan(alpha)


def _on_lower(found: DirectFound) -> Named:
    s, beta, gamma, dx = found.s, at(found, "beta"), at(found, "gamma"), at(found, "dx")
    turned = s.b / (s.l_2 * cos(beta))
    yield "gamma", beta - s.beta_0
    yield "r", at(found, "x") + s.b * sin(gamma)
    yield "dr", dx * (1 + turned * cos(gamma))
    yield "dy", dx * (tan(at(found, "alpha")) - turned * sin(gamma))


def _crank(found: DirectFound, crank: BellCrank) -> Named:
    s = found.s
    ratio = s.a / s.b
    yield "r", s.r_min + ratio * at(found, "z")
    yield "dr", ratio
    if not crank.level:
        yield "theta", arcsin((at(found, "r") - s.r_0) / s.a)
        yield "dy", -(at(found, "dr") * tan(at(found, "theta")))


# --- equilibrium


def _equilibrium(found: DirectFound) -> Named:
    s, A, E, omega = found.s, at(found, "A"), at(found, "E"), at(found, "omega_g")
    low, up = at(found, "omega_low"), at(found, "omega_up")
    yield "A", s.n * s.m * at(found, "r") * at(found, "dr")
    yield "E", added(held(found))
    yield "omega_g", sqrt(E / A)
    yield "C", s.m * omega**2 * at(found, "r")
    yield "S", at(found, "dE") - omega**2 * at(found, "dA")
    if found.given.sleeve.friction:
        yield "omega_low", sqrt((E - s.F_fr) / A)
        yield "omega_up", sqrt((E + s.F_fr) / A)
        yield "epsilon", (up - low) / omega


def held(
    found: DirectFound, row: int | None = None, balls: bool = True, sleeve: bool = True, spring: bool = True
) -> Iterator[Expr]:
    """The parts of the supporting force that are not nought."""
    s, weights = found.s, found.weights
    if balls and np.any(found.table.balls.dh):
        yield s.n * s.m * s.g * at(found, "dy", row)
    if sleeve and weights.sleeve:
        yield s.m_0 * s.g
    if spring and weights.preload:
        yield s.F_0
    if spring and weights.stiffness:
        yield s.c * at(found, "z", row)


def added(parts: Iterable[Expr]) -> Expr:
    return reduce(add, parts)


def taken(whole: Expr, parts: Iterable[Expr]) -> Expr:
    """The whole less each of the parts."""
    return reduce(lambda rest, part: rest - part, parts, whole)
