"""A driving slider or cylinder: the link that follows it, by the triangle, by differences in time, at its limits."""

from types import SimpleNamespace

import numpy as np
import pytest

from tmm_report.mechanics.calculus.motion_laws import Harmonic, Pieces, Polynomial
from tmm_report.mechanics.calculus.roots import slope
from tmm_report.mechanics.lever.driving.stroke import Turned
from tmm_report.mechanics.lever.driving.triangle import Triangle


def slider(law, side=1, way=1 + 0j, start=0.05j, pin=0.2 + 0j):
    return Triangle(law, "1", 0j, pin, start, way, 0.45, side, ("O", "A", "B"), ("3",), ())


def cylinder(law, side=1, pin=1 + 0j):
    return Triangle(law, "3", 0j, pin, 1.5 - 0.4j, 0j, 0.0, side, ("O", "B", "A"), ("1", "2"), ())


SWAY = Harmonic(0.45, 0.0, 0.12, 7.0, 0.4)
STROKES = {
    "slider": slider(Polynomial((0.35, 1.2), 0.2)),
    "slider below": slider(SWAY, side=-1),
    "slanting guide": slider(SWAY, way=np.exp(0.3j), start=-0.02 + 0.03j, pin=0.18 * np.exp(1.1j)),
    "cylinder": cylinder(Pieces(1.1, 0.0, (0.4, 2.6), (0.375, 0.0))),
    "cylinder on the right": cylinder(Harmonic(1.3, 0.0, 0.2, 3.0), side=-1, pin=0.9 * np.exp(0.4j)),
}
every = pytest.mark.parametrize("stroke", STROKES.values(), ids=STROKES)


def times(stroke):
    t = np.linspace(0.0, stroke.law.period, 23)[1:-1] + 1e-4
    return t[np.min(np.abs(t[:, None] - np.array([*stroke.law.breaks, -1.0])), axis=1) > 1e-2]


@every
def test_the_pin_is_as_far_as_the_rod_or_the_cylinder_says(stroke):
    s = stroke.law.at(times(stroke))[0]
    p, c = stroke.arms(s)
    assert np.abs(p) == pytest.approx(np.full(s.shape, stroke.crank))
    assert np.abs(c) == pytest.approx(stroke.distance(s))
    assert np.sign((np.conj(stroke.far(s)) * p).imag) == pytest.approx(np.full(s.shape, stroke.side))


@every
def test_rates_are_derivatives_by_the_time(stroke):
    law, t = Turned(stroke), times(stroke)
    _, omega, epsilon = law.at(t)
    step = 1e-4 * law.period
    assert slope(lambda x: law.at(x)[0], t, step) == pytest.approx(omega, rel=1e-7, abs=1e-7)
    assert slope(lambda x: law.at(x)[1], t, step) == pytest.approx(epsilon, rel=1e-6, abs=1e-6)


@every
def test_the_transfer_is_a_derivative_by_the_stroke(stroke):
    s = stroke.law.at(times(stroke))[0]
    assert slope(stroke.angle, s, 1e-5) == pytest.approx(stroke.transfer(s), rel=1e-7)


@every
def test_the_stroke_grows_along_its_direction(stroke):
    s = stroke.law.at(times(stroke))[0]
    p, c = stroke.arms(s)
    moved = 1j * p * stroke.transfer(s)  # of the pin by the stroke
    if stroke.slides:
        assert ((moved - stroke.way) * np.conj(c)).real == pytest.approx(np.zeros(s.shape), abs=1e-12)
    else:
        ends = dict(zip(stroke.ends, (stroke.far(s), stroke.arms(s)[0]), strict=True))
        along = stroke.along(SimpleNamespace(place=ends.get, shape=s.shape))
        assert (moved * np.conj(along)).real == pytest.approx(np.ones(s.shape))


def test_none_of_these_comes_to_a_limit():
    assert [name for name, stroke in STROKES.items() if stroke.limit() is not None] == []


def test_limits_are_where_the_triangle_falls_flat():
    """The slider of the statement stops being movable at √(0.65² − 0.05²); the cylinder where its length is r + OA."""
    assert slider(Polynomial((0.5, 1.0), 0.2)).limit() == pytest.approx(np.sqrt(0.65**2 - 0.05**2), abs=1e-3)
    longest = 1.0 + abs(1.5 - 0.4j)
    assert cylinder(Polynomial((1.1, 1.0), 2.0)).limit() == pytest.approx(longest, abs=2e-3)
    shortest = abs(1.5 - 0.4j) - 1.0
    assert cylinder(Polynomial((1.1, -1.0), 0.8)).limit() == pytest.approx(shortest, abs=2e-3)


def test_a_slider_stops_its_link_where_the_rod_stands_across_the_guide():
    """A long arm and a short rod: there the link turns back, and its angle is no coordinate of the mechanism."""
    stroke = Triangle(
        Polynomial((0.1, 1.0), 0.4), "1", 0j, 0.5 + 0j, 0.6j, 1 + 0j, 0.25, -1, ("O", "A", "B"), ("3",), ()
    )
    across = stroke.limit()
    assert across is not None
    p, c = stroke.arms(np.array([across]))
    assert abs(c[0].real) < 2e-3 or abs((np.conj(p) * c)[0].imag) < 2e-3
