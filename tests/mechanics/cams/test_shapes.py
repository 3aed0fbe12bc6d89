"""Graphs of acceleration: closed forms against pieces, quadrature of the stated ordinates, forty digits, refusals."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from tmm_report.mechanics.cams.shapes import (
    Graph,
    Parabolic,
    Piece,
    Unfit,
    by_displacement,
    by_velocity,
    lines,
    named,
    trapezoid,
)
from tmm_report.mechanics.rivals.exact import cams as exact_cams
from tmm_report.mechanics.rivals.exact.numbers import exact

FINE = np.linspace(0.0, 1.0, 1201)

EQUAL = {
    "parabolic": Graph((Piece(1, 1, 1), Piece(1, -1, -1))),
    "decreasing": Graph(lines([3.0, -3.0])),
    "cosine": Graph((Piece(2, 7, 0, "sine"), Piece(2, 0, -7, "sine"))),
    "sine": Graph(
        (Piece(1, 0, 1, "sine"), Piece(1, 1, 0, "sine"), Piece(1, 0, -2, "sine"), Piece(1, -2, 0, "sine"))
    ),
    "trapezoid": Graph(lines([0, 2, 2, 0, -1, -1, 0], [1, 2, 1, 1, 2, 1])),
}


@pytest.mark.parametrize("name", EQUAL)
def test_a_closed_form_is_its_own_graph(name):
    for one, other in zip(named(name).of(FINE), EQUAL[name].of(FINE), strict=True):
        assert np.allclose(one, other, rtol=0, atol=3e-14)


@pytest.mark.parametrize("ratio", [0.4, 1.0, 1.8, 3.0])
def test_unequal_accelerations_are_the_graph_of_two_steps(ratio):
    stepped = Graph((Piece(1, 5, 5), Piece(ratio, -1, -1)))
    for one, other in zip(Parabolic(ratio).of(FINE), stepped.of(FINE), strict=True):
        assert np.allclose(one, other, rtol=0, atol=3e-14)
    assert np.ptp(Parabolic(ratio).of(FINE)[2]) == pytest.approx(2 * (1 + ratio) * (1 + 1 / ratio))


def test_triangles_are_trapezoids_of_longest_ramps():
    assert np.max(trapezoid(0.25).of(FINE)[2]) == pytest.approx(8.0)
    assert len(trapezoid(0.25).laid) == 4


def ordinate(pieces, t):
    """Of a graph as it is stated, at a part of its whole width."""
    at = t * sum(p.width for p in pieces)
    for p in pieces:
        if at <= p.width or p is pieces[-1]:
            u = at / p.width
            if p.form == "line":
                return p.start + (p.end - p.start) * u
            if abs(p.end) > abs(p.start):
                return p.start + (p.end - p.start) * np.sin(np.pi / 2 * u)
            return p.end + (p.start - p.end) * np.cos(np.pi / 2 * u)
        at -= p.width
    raise AssertionError


def random_pieces(random):
    """Pieces above zero, then pieces below it."""
    found = []
    for sign in (1, -1):
        for _ in range(random.integers(1, 4)):
            a, b = sign * random.uniform(0.0, 3.0, 2)
            found.append(Piece(random.uniform(0.2, 2.0), a, b, random.choice(["line", "sine"])))
    return tuple(found)


@pytest.mark.parametrize("seed", range(12))
def test_a_graph_is_integrated_as_quadrature_does(seed):
    pieces = random_pieces(np.random.default_rng(seed))
    graph, edges = Graph(pieces), [*np.cumsum([0.0, *(p.width for p in pieces)])]
    edges = [one / edges[-1] for one in edges]

    def integral(of, end):
        marks = [one for one in edges if one < end] + [end]
        return sum(quad(of, a, b, epsabs=1e-13, epsrel=1e-13)[0] for a, b in pairwise(marks))

    # the factor of the ordinates below zero, sought and not reckoned, at which the follower comes to rest
    by = brentq(lambda k: integral(lambda t: scaled(pieces, k, t), 1.0), 1e-6, 1e6, xtol=1e-15, rtol=1e-14)
    lift = integral(lambda t: (1 - t) * scaled(pieces, by, t), 1.0)
    for t in (0.11, 0.37, 0.5, 0.83, 1.0):
        f, slope, bend = (float(x) for x in graph.of(np.array(t)))
        assert f == pytest.approx(
            integral(lambda x, t=t: (t - x) * scaled(pieces, by, x), t) / lift, abs=1e-10
        )
        assert slope == pytest.approx(integral(lambda x: scaled(pieces, by, x), t) / lift, abs=1e-10)
        if min(abs(t - edge) for edge in edges) > 1e-6:
            assert bend == pytest.approx(scaled(pieces, by, t) / lift, rel=1e-9)


def scaled(pieces, by, t):
    """Ordinate whose part below zero is `by` times as large."""
    value = ordinate(pieces, t)
    return value if value > 0 else by * value


@pytest.mark.parametrize("seed", range(6))
def test_a_graph_in_forty_digits(seed):
    graph = Graph(random_pieces(np.random.default_rng(100 + seed)))
    for t in (0.0, 0.123, 0.456, 0.789, 1.0):
        found = exact_cams._shape(graph, exact(t), t)
        for one, other in zip(graph.of(np.array(t)), found, strict=True):
            assert float(one) == pytest.approx(float(other), abs=2e-13 * max(1.0, abs(float(other))))


@pytest.mark.parametrize(
    "name", ["parabolic", "polynomial_4567", "modified_sine", "modified_trapezoid", "trapezoid"]
)
def test_named_shapes_in_forty_digits(name):
    for t in (0.031, 0.2, 0.44, 0.5, 0.61, 0.99):
        found = exact_cams._shape(named(name), exact(t), t)
        for one, other in zip(named(name).of(np.array(t)), found, strict=True):
            assert float(one) == pytest.approx(float(other), abs=1e-13)


def test_velocity_by_ordinates():
    graph = by_velocity([0, 1, 2, 2, 1, 0])
    f, slope, _ = graph.of(np.linspace(0, 1, 6))
    assert np.allclose(slope, np.array([0, 1, 2, 2, 1, 0]) * 5 / 6)
    assert np.allclose(f, np.array([0, 0.5, 2, 4, 5.5, 6]) / 6)


def test_a_velocity_that_begins_at_once_is_a_hard_shock():
    f, slope, bend = by_velocity([1, 1, 1]).of(FINE)
    assert np.allclose(f, FINE) and np.allclose(slope, 1) and np.allclose(bend, 0)


@pytest.mark.parametrize("seed", range(12))
def test_displacements_by_ordinates_against_the_clamped_spline_of_scipy(seed):
    from scipy.interpolate import CubicSpline

    random = np.random.default_rng(seed)
    count = int(random.integers(4, 30))
    x = np.linspace(0, 1, count)
    y = random.uniform(1, 40) * (x - np.sin(2 * np.pi * x) / 7 + random.uniform(0, 2e-3, count)) + 5
    y.sort()
    graph = by_displacement(y.tolist())
    peer = CubicSpline(x, (y - y[0]) / (y[-1] - y[0]), bc_type="clamped")
    f, slope, bend = graph.of(FINE)
    for k, found in enumerate((f, slope, bend)):
        other = peer(FINE, k)
        assert found == pytest.approx(other, abs=1e-9 * np.max(np.abs(other)))
    away = np.min(np.abs(FINE[:, None] - x), axis=1) > 1e-6
    assert graph.third(FINE)[away] == pytest.approx(
        peer(FINE, 3)[away], abs=1e-7 * np.max(np.abs(peer(FINE, 3)))
    )


def test_displacements_are_gone_through_and_begin_and_end_at_rest():
    graph = by_displacement([0, 3, 10, 17, 20])
    f, slope, _ = graph.of(np.linspace(0, 1, 5))
    assert f * 20 == pytest.approx([0, 3, 10, 17, 20]) and slope[[0, -1]] == pytest.approx([0, 0], abs=1e-12)


@pytest.mark.parametrize(
    ("ordinates", "why"),
    [
        ([5, 5, 5, 5], "no lift"),
        ([20, 17, 3, 0], "falls back"),
        ([0, 3, 2, 20], "falls back"),
        ([0, 0.01, 0.02, 10, 10.01, 10.02], "swings back"),
    ],
)
def test_displacements_that_are_no_rise(ordinates, why):
    with pytest.raises(Unfit, match=why):
        by_displacement(ordinates)


@pytest.mark.parametrize(
    ("pieces", "why"),
    [
        (lines([0, 1, 1, 0]), "one sign"),
        (lines([-1, -1, 1, 1]), "turns back"),
        (lines([1, -3, -3, 6, -1]), "turns back"),
    ],
)
def test_what_is_no_rise(pieces, why):
    with pytest.raises(Unfit, match=why):
        Graph(pieces)
