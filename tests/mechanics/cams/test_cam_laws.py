"""Laws of a follower: derivatives against differences, ends of phases, published greatest rates, tables by splines."""

import numpy as np
import pytest

from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Phase, Phases, Spline, Tabled
from tmm_report.mechanics.cams.shapes import NAMED, named

H = 0.03
# f' and f'' at their greatest (Artobolevsky, ch. 26; Shigley, Uicker, ch. 6; Norton, Cam design, ch. 3)
GREATEST = {
    "parabolic": (2.0, 4.0),
    "cosine": (np.pi / 2, np.pi**2 / 2),
    "sine": (2.0, 2 * np.pi),
    "polynomial": (1.875, 10 / np.sqrt(3)),
    "uniform": (1.0, 0.0),
    "decreasing": (1.5, 6.0),
    "trapezoid": (2.0, 16 / 3),
    "modified_trapezoid": (2.0, 8 * np.pi / (2 + np.pi)),
    "modified_sine": (4 * np.pi / (4 + np.pi), 4 * np.pi**2 / (4 + np.pi)),
    "polynomial_4567": (2.1875, 84 * np.sqrt(5) / 25),
}


def law_of(kind: str) -> Phases:
    return Phases(
        (
            Phase("rise", 2.0, named(kind)),
            Phase("dwell", 0.5),
            Phase("return", 1.5, named(kind)),
            Phase("dwell", FULL_TURN - 4.0),
        ),
        H,
    )


@pytest.mark.parametrize("kind", NAMED)
def test_derivatives_are_those_of_the_displacement(kind):
    law, theta, step = law_of(kind), np.linspace(0.013, 6.2, 60), 1e-5
    _, first, second = law.of(theta)
    ahead, behind = law.of(theta + step), law.of(theta - step)
    assert np.allclose((ahead[0] - behind[0]) / (2 * step), first, rtol=0, atol=1e-10)
    assert np.allclose((ahead[1] - behind[1]) / (2 * step), second, rtol=0, atol=1e-9)


@pytest.mark.parametrize("kind", NAMED)
def test_a_rise_ends_at_the_lift_and_a_return_at_nothing(kind):
    S, _, _ = law_of(kind).of(np.array([0.0, 2.0 - 1e-7, 2.0, 2.2, 2.5, 4.0 - 1e-7, 4.0, 5.0, FULL_TURN]))
    assert np.allclose(S, H * np.array([0, 1, 1, 1, 1, 0, 0, 0, 0]), atol=1e-8)


@pytest.mark.parametrize("kind", NAMED)
def test_greatest_rates_are_the_published_ones(kind):
    theta = np.linspace(1e-6, 2.0 - 1e-6, 40001)
    _, first, second = law_of(kind).of(theta)
    velocity, acceleration = GREATEST[kind]
    assert np.max(first) == pytest.approx(velocity * H / 2.0, rel=1e-6)
    assert np.max(second) == pytest.approx(acceleration * H / 4.0, rel=1e-5)


def test_the_middle_of_a_rise_is_half_the_lift_by_every_law():
    for kind in NAMED:
        assert law_of(kind).of(np.array([1.0]))[0][0] == pytest.approx(H / 2, abs=1e-15)


def test_an_angle_just_before_a_phase_belongs_to_it():
    law = law_of("cosine")
    inside, before = law.of(np.array([2.0, 2.0 - 1e-12]))[2]
    assert inside == before == 0.0  # a dwell: not the −π²h/2β² with which the rise ends


def test_a_spline_is_smooth_round_the_turn():
    x = np.linspace(0, FULL_TURN, 13)
    spline = Spline(x, np.sin(x) ** 2)
    for order in range(3):
        left, right = spline.of(np.array([FULL_TURN - 1e-9]))[order], spline.of(np.array([1e-9]))[order]
        assert left == pytest.approx(right, abs=1e-6)


@pytest.mark.parametrize(("order", "power"), [(0, 4), (1, 3), (2, 2)])
def test_a_spline_comes_nearer_by_its_order(order, power):
    """Halving the steps divides the error by 2^4, 2^3, 2^2 (de Boor)."""
    fine = np.linspace(0, FULL_TURN, 997)
    exact = (
        np.exp(np.sin(fine)),
        np.cos(fine) * np.exp(np.sin(fine)),
        (np.cos(fine) ** 2 - np.sin(fine)) * np.exp(np.sin(fine)),
    )
    errors = []
    for count in (24, 48):
        angles = np.arange(count) * FULL_TURN / count
        found = Tabled(tuple(angles), tuple(np.exp(np.sin(angles)))).of(fine)
        errors.append(np.max(np.abs(found[order] - exact[order])))
    assert errors[0] / errors[1] == pytest.approx(2**power, rel=0.25)
