"""Numbers of any number of digits: a context of their own, systems of equations, and their way back to doubles.

mpmath is imported here alone. Its context is the room's own, so nobody else's digits change.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.rivals.model import Pair

Array = Any
Number = Any  # a real or complex number of mpmath
DIGITS = 40  # that are right in what is found
GUARD = 15  # more that are carried
MOST = 250  # digits of numbers that are made of others once and for all
IN_DOUBLES = 1e12  # norm of an inverse in doubles beyond which it may be rounding alone
CONTRACTS = 1e-3  # of a residual at a step: where less, the matrix in doubles is no help


@cache
def context() -> Any:
    """The room's own context of mpmath."""
    from mpmath.ctx_mp import MPContext

    made = MPContext()
    made.dps = DIGITS + GUARD
    return made


def exact(x: Any) -> Number:
    """A double, or a number of mpmath, as a number of the context: without any rounding."""
    own = context()
    if hasattr(x, "_mpc_"):
        return own.mpc(own.convert(x.real), own.convert(x.imag))
    if hasattr(x, "_mpf_"):
        return own.convert(x)
    value = complex(np.ravel(x)[0])
    return own.mpc(value.real, value.imag) if np.iscomplexobj(x) else own.mpf(value.real)


def point(x: Any) -> Number:
    """The same as a complex number."""
    return context().mpc(exact(x))


def unit(x: Any) -> Number:
    """The unit complex number along a direction."""
    along = point(x)
    return along / abs(along)


class Three(NamedTuple):
    """A number and its first two derivatives by the cam's angle."""

    z: Number
    d: Number
    dd: Number


def cross(a: Number, b: Number) -> Number:
    return a.real * b.imag - a.imag * b.real


def dot(a: Number, b: Number) -> Number:
    return a.real * b.real + a.imag * b.imag


def halves(values: Iterable[Number | None]) -> Pair:
    """Numbers as two doubles that add up to them; None is nan."""
    high, low = [], []
    for value in values:
        if value is None:
            high.append(np.nan)
            low.append(np.nan)
            continue
        top = _double(value)
        high.append(top)
        low.append(_double(value - exact(top)))
    return Pair(np.array(high), np.array(low))


def _double(value: Number) -> Any:
    return complex(value) if hasattr(value, "_mpc_") else float(value)


def rows_of(table: Sequence[Sequence[Number | None]], usual: Number = 0) -> Pair:
    """Rows of numbers of one kind as two arrays of doubles, (rows, P). What is nothing but the rounding of the digits
    carried, beside the largest of all or the `usual` size of such numbers, is nothing."""
    own = context()
    known = [abs(value) for row in table for value in row if value is not None]
    least = max([own.mpf(usual), *known]) * own.mpf(10) ** -DIGITS
    rows = [halves(None if x is None else _cut(x, least) for x in row) for row in table]
    return Pair(np.array([row.high for row in rows]), np.array([row.low for row in rows]))


def _cut(value: Number, least: Number) -> Number:
    if hasattr(value, "_mpc_"):
        return context().mpc(_cut(value.real, least), _cut(value.imag, least))
    return value if abs(value) > least else context().mpf(0)


# ---------------------------------------------------------------- systems of linear equations

Row = Mapping[int, Number]


def solve(rows: Sequence[Row], right: Sequence[Number]) -> list[Number] | None:
    """x of a square system to the digits of the context; None where it is singular.

    An inverse in doubles refines x step by step, some fifteen digits each, residuals in all digits; where the matrix is
    too near a singular one for that, by elimination in all digits.
    """
    x = refined(rows, right, inverse(rows))
    return eliminated(rows, right) if x is None else x


def inverse(rows: Sequence[Row]) -> Array:
    """In doubles, (n, n); nan where that fails."""
    matrix = np.zeros((len(rows), len(rows)))
    for k, row in enumerate(rows):
        for column, value in row.items():
            matrix[k, column] = float(value)
    try:
        return np.linalg.inv(matrix)
    except np.linalg.LinAlgError:
        return np.full_like(matrix, np.nan)


def strain(rows: Sequence[Row], back: Array) -> float:
    """Norm of the inverse, of which `back` is one in doubles; infinite of a singular matrix."""
    with np.errstate(over="ignore"):
        rough = float(np.abs(back).sum())
    if rough < IN_DOUBLES:  # neither nan nor so large that it may be rounding
        return rough
    own = context()
    try:
        whole = own.inverse(_dense(rows))
    except ZeroDivisionError:
        return np.inf
    size = own.fsum(abs(value) for value in whole)
    return float(size) if size < own.mpf(10) ** 300 else np.inf


def refined(rows: Sequence[Row], right: Sequence[Number], back: Array) -> list[Number] | None:
    own = context()
    if not np.isfinite(back).all():
        return None
    x = [own.mpf(0)] * len(rows)
    rest = list(right)
    size = start = max(map(abs, right), default=own.mpf(0))
    while size > start * own.eps:
        scale = 1 / size
        step = back @ np.array([float(value * scale) for value in rest])
        x = [old + new * size for old, new in zip(x, step.tolist(), strict=True)]
        rest = [
            value - own.fsum(factor * x[column] for column, factor in row.items())
            for value, row in zip(right, rows, strict=True)
        ]
        before, size = size, max(map(abs, rest))
        if size > before * CONTRACTS:
            return x if size <= start * own.eps * 100 else None
    return x


def eliminated(rows: Sequence[Row], right: Sequence[Number]) -> list[Number] | None:
    own = context()
    try:
        return list(own.lu_solve(_dense(rows), own.matrix(list(right))))
    except ZeroDivisionError:
        return None


def _dense(rows: Sequence[Row]) -> Any:
    matrix = context().zeros(len(rows))
    for k, row in enumerate(rows):
        for column, value in row.items():
            matrix[k, column] = value
    return matrix
