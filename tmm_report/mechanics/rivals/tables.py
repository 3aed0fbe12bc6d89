"""Velocities and accelerations from a table of positions alone: differences, a cubic spline, a trigonometric sum.

Of each link the table holds the place of its reference point and its angle, unwrapped, at equal steps of the driving
link; rates by the angle turned become rates by time with the driver's constant speed. The places are the groups' own.
Over a whole turn the table repeats, but for an angle that gains full turns: its even part is taken out beforehand.
Where the mechanism does not close, or the driving link swings, each unbroken stretch is a table of its own, with ends.
Source: Bakhvalov, Numerical methods, ch. 2, 4; de Boor, A practical guide to splines, ch. 4; Trefethen, Spectral
methods in MATLAB, ch. 3.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion, drive, positions
from tmm_report.mechanics.rivals.model import Method, MotionMethod
from tmm_report.problems import N_, Message
from tmm_report.records import dataclass

Array = Any
Rates = tuple[Array, Array]  # first and second derivative, of the shape of the values
COUNTS = (12, 36, 72, 100)  # positions that tables of courses have


@dataclass(frozen=True)
class Rule:
    """`around(values, step)`: rates of a function that repeats after its P values (..., P); `along`: of one that has
    ends, None where there is no such rule."""

    around: Callable[[Array, float], Rates]
    along: Callable[[Array, float], Rates] | None = None


# ---------------------------------------------------------------- differences


def differences_around(values: Array, step: float) -> Rates:
    """Central differences, second order: (y₊ − y₋)/2h, (y₊ − 2y + y₋)/h²."""
    ahead, behind = np.roll(values, -1, axis=-1), np.roll(values, 1, axis=-1)
    return (ahead - behind) / (2 * step), (ahead - 2 * values + behind) / step**2


def differences_along(values: Array, step: float) -> Rates:
    """The same with the one-sided differences of second order at both ends; of less than three values no bend, of less
    than two no slope."""
    count = values.shape[-1]
    slope, bend = np.full_like(values, np.nan), np.full_like(values, np.nan)
    if count == 2:
        slope[...] = np.diff(values, axis=-1) / step
    if count > 2:
        slope[...] = np.gradient(values, step, axis=-1, edge_order=2)
        bend[..., 1:-1] = np.diff(values, 2, axis=-1) / step**2
        bend[..., 0], bend[..., -1] = bend[..., 1], bend[..., -2]
    if count > 3:  # a straight line through the two nearest: 2, −5, 4, −1
        bend[..., 0] = 2 * bend[..., 1] - bend[..., 2]
        bend[..., -1] = 2 * bend[..., -2] - bend[..., -3]
    return slope, bend


# ---------------------------------------------------------------- cubic spline


def spline_around(values: Array, step: float) -> Rates:
    """Periodic cubic spline: slopes m₋ + 4m + m₊ = 3(y₊ − y₋)/h, bends M₋ + 4M + M₊ = 6(y₊ − 2y + y₋)/h², whose
    matrix is a circulant one, so that Fourier's sums solve it. At the knots slopes are of the fourth order, bends of
    the second."""
    count = values.shape[-1]
    slope, bend = differences_around(values, step)
    share = 6 / (4 + 2 * np.cos(2 * np.pi * np.arange(count) / count))
    found = (np.fft.ifft(np.fft.fft(rate) * share) for rate in (slope, bend))
    first, second = (rate if np.iscomplexobj(values) else rate.real for rate in found)
    return first, second


def spline_along(values: Array, step: float) -> Rates:
    """Cubic spline through a stretch with ends, the third derivative whole at the knots next to them ("not a knot");
    through three values a parabola, through two a straight line without a bend that counts."""
    count = values.shape[-1]
    if count < 3:
        return differences_along(values, step)
    bend = _bends(values, step)
    rise = np.diff(values, axis=-1) / step
    slope = np.empty_like(values)
    slope[..., :-1] = rise - step / 6 * (2 * bend[..., :-1] + bend[..., 1:])
    slope[..., -1] = rise[..., -1] + step / 6 * (bend[..., -2] + 2 * bend[..., -1])
    return slope, bend


def _bends(values: Array, step: float) -> Array:
    """Second derivatives at the knots. With equal steps the conditions M₀ − 2M₁ + M₂ = 0 at the ends leave M₁ the
    second difference itself; between the two the system is solved by elimination, row by row."""
    bend = np.empty_like(values)
    second = np.diff(values, 2, axis=-1) / step**2
    bend[..., 1:-1] = second
    last, share = values.shape[-1] - 2, 0.0
    shares = [share]
    for k in range(2, last):
        share = 1 / (4 - share)
        shares.append(share)
        bend[..., k] = (6 * second[..., k - 1] - bend[..., k - 1]) * share
    for k in range(last - 1, 1, -1):
        bend[..., k] = bend[..., k] - shares[k - 1] * bend[..., k + 1]
    three = values.shape[-1] == 3
    bend[..., 0] = bend[..., 1] if three else 2 * bend[..., 1] - bend[..., 2]
    bend[..., -1] = bend[..., 1] if three else 2 * bend[..., -2] - bend[..., -3]
    return bend


# ---------------------------------------------------------------- trigonometric sum


def fourier_around(values: Array, step: float) -> Rates:
    """Derivatives of the trigonometric sum through the values. Of an even number of values the highest harmonic is
    neither forward nor backward: its slope at the values is nothing."""
    count = values.shape[-1]
    order = np.fft.fftfreq(count, 1 / count) * (2 * np.pi / (count * step))
    odd = np.where(2 * np.abs(np.fft.fftfreq(count)) == 1, 0.0, order)
    spectrum = np.fft.fft(values)
    found = (np.fft.ifft(spectrum * share) for share in (1j * odd, -(order**2)))
    first, second = (rate if np.iscomplexobj(values) else rate.real for rate in found)
    return first, second


# ---------------------------------------------------------------- a table of any kind


def rates(values: Array, step: float, closed: bool, rule: Rule) -> Rates:
    """Rates of the rows of a table (..., P) by its argument; `closed`: the last column is the first one again, but for
    what the row gains over the whole. nan where there is no value, or no rule for the stretch it stands in."""
    values = np.asarray(values)
    whole = np.isfinite(values).all(axis=-1)
    if closed and whole.all():
        return _around(values, step, rule)
    slope, bend = np.full_like(values, np.nan), np.full_like(values, np.nan)
    for row in np.ndindex(values.shape[:-1]):
        one = _around if closed and whole[row] else _in_stretches
        slope[row], bend[row] = one(values[row], step, rule)
    return slope, bend


def _around(values: Array, step: float, rule: Rule) -> Rates:
    count = values.shape[-1] - 1
    gain = values[..., -1:] - values[..., :1]
    slope, bend = rule.around(values[..., :-1] - gain * (np.arange(count) / count), step)
    slope = slope + gain / (count * step)
    return tuple(np.concatenate([rate, rate[..., :1]], axis=-1) for rate in (slope, bend))  # type: ignore[return-value]


def _in_stretches(values: Array, step: float, rule: Rule) -> Rates:
    slope, bend = np.full_like(values, np.nan), np.full_like(values, np.nan)
    known = np.concatenate([[False], np.isfinite(values), [False]])
    marks = np.flatnonzero(known[1:] != known[:-1])
    for start, end in zip(marks[::2], marks[1::2], strict=True):
        if rule.along is not None:
            slope[start:end], bend[start:end] = rule.along(values[start:end], step)
    return slope, bend


def unwrapped(u: Array) -> Array:
    """Angles of unit vectors (..., P), rad, each within half a turn of the one before it."""
    turned = np.angle(u[..., 1:] * u[..., :-1].conjugate())
    start = np.angle(u[..., :1])
    whole = np.concatenate([start, start + np.cumsum(turned, axis=-1)], axis=-1)
    return whole if np.isfinite(whole).all() else _unwrapped_beside_gaps(u)


def _unwrapped_beside_gaps(u: Array) -> Array:
    """The same, begun anew after every gap."""
    angle = np.angle(u)
    angle = np.where(np.isfinite(u), angle, np.nan)
    for row in np.ndindex(u.shape[:-1]):
        known = np.isfinite(angle[row])
        edges = [0, *(np.flatnonzero(known[1:] != known[:-1]) + 1), u.shape[-1]]
        for start, end in pairwise(edges):
            if known[start]:
                angle[row][start:end] = np.unwrap(angle[row][start:end])
    return angle


def derived(cycle: Cycle, count: int, rule: Rule) -> Motion:
    """The motion at `count` equal steps, the last included: places by groups, the driving link's rates as stated, those
    of all other links by the rule. Links stay rigid: rates of their points follow from those of the links."""
    linkage, omega = cycle.linkage, cycle.linkage.mechanism.driver.omega
    phi = cycle.phi(cycle.once(count))
    shape = np.broadcast_shapes(linkage.axes, np.shape(phi), np.shape(omega))
    placed, s = positions(linkage, phi), drive(linkage, phi, omega)
    links = [link for link in placed.r if link not in (FRAME, linkage.mechanism.driver.link)]
    with np.errstate(invalid="ignore", divide="ignore"):
        _fill(s, placed, links, shape, lambda table: rates(table, cycle.period / count, cycle.closed, rule))
        _by_time(s, links, np.abs(omega))
    return Motion(linkage, phi, omega, s, shape)


def _fill(
    s: State, placed: State, links: list[str], shape: tuple[int, ...], by_angle: Callable[[Array], Rates]
) -> None:
    """Poses of the links, and their rates by the angle turned."""
    if not links:
        return
    r, u = (np.array([np.broadcast_to(of[link], shape) for link in links]) for of in (placed.r, placed.u))
    velocity, acceleration = by_angle(r)
    turning, bending = by_angle(unwrapped(u))
    for k, link in enumerate(links):
        s.o[link], s.r[link], s.u[link] = placed.o[link], placed.r[link], placed.u[link]
        s.carry(link, velocity[k], acceleration[k])
        s.turn(link, turning[k], bending[k])


def _by_time(s: State, links: list[str], omega: Array) -> None:
    for link in links:
        s.carry(link, s.v[link] * omega, s.a[link] * omega**2)
        s.turn(link, s.w[link] * omega, s.e[link] * omega**2)


# ---------------------------------------------------------------- the methods

DIFFERENCES = Rule(differences_around, differences_along)
SPLINE = Rule(spline_around, spline_along)
FOURIER = Rule(fourier_around)


def _of_cams(cycle: Cycle) -> Message | None:
    if cycle.linkage.mechanism.cams:
        text = N_(
            "a cam is replaced by another linkage in every position: the places are no table of one motion"
        )
        return Message(text)
    return None


def _does_not_repeat(cycle: Cycle) -> Message | None:
    if not cycle.closed:
        return Message(N_("the driving link swings: a table over its swing does not repeat"))
    if cycle.limits.size:
        return Message(N_("the mechanism does not go all round: there is no table of a whole turn"))
    return _of_cams(cycle)


TABLES: tuple[MotionMethod, ...] = (
    Method(
        "differences",
        N_("central differences of the table of positions"),
        lambda cycle, count: derived(cycle, count, DIFFERENCES),
        _of_cams,
    ),
    Method(
        "spline",
        N_("cubic spline through the table of positions"),
        lambda cycle, count: derived(cycle, count, SPLINE),
        _of_cams,
    ),
    Method(
        "fourier",
        N_("trigonometric sum through the table of positions"),
        lambda cycle, count: derived(cycle, count, FOURIER),
        _does_not_repeat,
    ),
)
