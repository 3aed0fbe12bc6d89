"""Every law against its acceleration integrated symbolically: values, continuity, extremes, jumps (shocks)."""

from __future__ import annotations

import itertools
from functools import cache

import numpy as np
import pytest
import sympy as sp
from sympy import Rational as R
from sympy import cos, pi, sin

from tmm_report.mechanics.cams.shapes import NAMED, Parabolic, named

u = sp.Symbol("u", real=True)


def ramps(tau):
    """Trapezoid, its ordinate 1: it rises, stays, falls through zero, stays, rises."""
    return [
        (tau, u / tau),
        (R(1, 2) - tau, sp.Integer(1)),
        (R(1, 2) + tau, (R(1, 2) - u) / tau),
        (1 - tau, sp.Integer(-1)),
        (sp.Integer(1), (u - 1) / tau),
    ]


# ends of the pieces, and the acceleration in each but for a factor: what makes S(1) = 1 is found here
ACCELERATIONS = {
    "parabolic": [(R(1, 2), sp.Integer(1)), (sp.Integer(1), sp.Integer(-1))],
    "decreasing": [(sp.Integer(1), 1 - 2 * u)],
    "cosine": [(sp.Integer(1), cos(pi * u))],
    "sine": [(sp.Integer(1), sin(2 * pi * u))],
    "polynomial": [(sp.Integer(1), u * (1 - u) * (1 - 2 * u))],
    "polynomial_4567": [(sp.Integer(1), u**2 * (1 - u) ** 2 * (1 - 2 * u))],
    "trapezoid": ramps(R(1, 8)),
    "modified_trapezoid": [
        (R(1, 8), sin(4 * pi * u)),
        (R(3, 8), sp.Integer(1)),
        (R(5, 8), sin(4 * pi * (R(1, 2) - u))),
        (R(7, 8), sp.Integer(-1)),
        (sp.Integer(1), -sin(4 * pi * (1 - u))),
    ],
    "modified_sine": [
        (R(1, 8), sin(4 * pi * u)),
        (R(7, 8), cos(4 * pi * (u - R(1, 8)) / 3)),
        (sp.Integer(1), -sin(4 * pi * (1 - u))),
    ],
}
# greatest velocity and acceleration of a phase and a lift of 1, by the tables of guides
PEAKS = {
    "parabolic": (2, 4), "decreasing": (R(3, 2), 6), "cosine": (pi / 2, pi**2 / 2), "sine": (2, 2 * pi),
    "polynomial": (R(15, 8), 10 / sp.sqrt(3)), "polynomial_4567": (R(35, 16), 84 * sp.sqrt(5) / 25),
    "trapezoid": (2, R(16, 3)), "modified_trapezoid": (2, 8 * pi / (2 + pi)),
    "modified_sine": (4 * pi / (4 + pi), 4 * pi**2 / (4 + pi)),
}  # fmt: skip
SOFT = {"parabolic", "decreasing", "cosine"}  # the acceleration jumps at the ends of the phase


def integrated(pieces):
    """(start, end, S, V, A) of each piece, exactly: V(0) = S(0) = 0, S(1) = 1."""
    found, start, speed, way = [], sp.Integer(0), sp.Integer(0), sp.Integer(0)
    for end, bend in pieces:
        rate = sp.integrate(bend, u)
        rate = speed + rate - rate.subs(u, start)
        place = sp.integrate(rate, u)
        place = way + place - place.subs(u, start)
        found.append((start, end, place, rate, bend))
        start, speed, way = end, sp.simplify(rate.subs(u, end)), sp.simplify(place.subs(u, end))
    assert speed == 0 and way > 0
    return [(a, b, *(one / way for one in three)) for a, b, *three in found]


@cache
def law(name):
    return integrated(ACCELERATIONS[name])


def numbers(expression, at):
    return np.array([float(expression.subs(u, x)) for x in at])


def test_no_law_is_missing():
    assert set(ACCELERATIONS) | {"uniform"} == set(NAMED)


@pytest.mark.parametrize("name", ACCELERATIONS)
def test_values_within_every_piece(name):
    for a, b, *three in law(name):
        at = [a + (b - a) * R(k, 7) for k in range(1, 7)]
        found = named(name).of(np.array([float(x) for x in at]))
        for values, expression in zip(found, three, strict=True):
            np.testing.assert_allclose(values, numbers(expression, at), rtol=1e-13, atol=1e-13)
        third = numbers(sp.diff(three[2], u), at)
        np.testing.assert_allclose(
            named(name).third(np.array([float(x) for x in at])), third, rtol=1e-11, atol=1e-11
        )


@pytest.mark.parametrize("name", ACCELERATIONS)
def test_displacement_and_velocity_are_continuous_and_the_law_breaks_where_it_says(name):
    pieces = law(name)
    ends = {float(b) for _, b, *_ in pieces[:-1]}
    breaks = {round(one, 14) for one in named(name).breaks}
    assert (
        ends <= breaks <= ends | {0.5}
    )  # a graph by pieces is cut where its acceleration passes through zero
    for (_, b, *before), (_, _, *after) in itertools.pairwise(pieces):
        for one, other in list(zip(before, after, strict=True))[:2]:
            assert sp.simplify(one.subs(u, b) - other.subs(u, b)) == 0
        jump = sp.simplify(after[2].subs(u, b) - before[2].subs(u, b))
        s = named(name)
        got = s.of(np.array(float(b)))[2] - s.of(np.array(float(b) - 1e-9))[2]
        assert got == pytest.approx(float(jump), abs=1e-6)


@pytest.mark.parametrize("name", ACCELERATIONS)
def test_peaks_are_those_of_the_tables(name):
    velocity, acceleration = PEAKS[name]
    grid = np.linspace(0, 1, 840_001)  # its points hit the middle and the breaks by eighths
    _, rate, bend = named(name).of(grid)
    assert rate.max() == pytest.approx(float(velocity), rel=1e-10)
    assert np.abs(bend).max() == pytest.approx(float(acceleration), rel=1e-10)
    middle = next(v.subs(u, R(1, 2)) for a, b, _, v, _ in law(name) if a <= R(1, 2) <= b)
    assert sp.simplify(middle - velocity) == 0  # every one of them is fastest in the middle


@pytest.mark.parametrize("name", ACCELERATIONS)
def test_shocks_at_the_ends_of_a_phase(name):
    """Beside a dwell: velocities are nil, and the acceleration is nil but in the laws with soft shocks."""
    first, last = law(name)[0], law(name)[-1]
    s = named(name)
    _, rate, bend = s.of(np.array([0.0, 1.0]))
    assert rate == pytest.approx([0, 0], abs=1e-14)
    ends = [sp.simplify(first[4].subs(u, 0)), sp.simplify(last[4].subs(u, 1))]
    assert bend == pytest.approx([float(one) for one in ends], abs=1e-12)
    assert (name in SOFT) == all(one != 0 for one in ends) and (name in SOFT) == any(one != 0 for one in ends)


def test_the_uniform_law_has_hard_shocks():
    place, rate, bend = named("uniform").of(np.array([0.0, 0.3, 1.0]))
    assert place == pytest.approx([0, 0.3, 1]) and list(rate) == [1, 1, 1] and list(bend) == [0, 0, 0]


@pytest.mark.parametrize("ratio", [R(1, 2), R(9, 5), 3])
def test_unequal_accelerations(ratio):
    """a₁/a₂ = n: the first takes 1/(1 + n) of the phase."""
    pieces = integrated([(1 / (1 + ratio), sp.Integer(1) * ratio), (sp.Integer(1), sp.Integer(-1))])
    shape = Parabolic(float(ratio))
    for a, b, *three in pieces:
        at = [a + (b - a) * R(k, 5) for k in range(1, 5)]
        for values, expression in zip(shape.of(np.array([float(x) for x in at])), three, strict=True):
            np.testing.assert_allclose(values, numbers(expression, at), rtol=1e-13)
