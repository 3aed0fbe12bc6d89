"""Integrals over a cycle from equal steps: exact values, orders of convergence, kinks and jumps."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from tmm_report.mechanics.rivals.integrals import INTEGRALS, Sampled, exact, simpson, spline, trapezoid

TURN = 2 * np.pi
KEYS = {one.key: one for one in INTEGRALS}
POISSON = Sampled(lambda x: 1 / (1.3 + np.cos(x)), TURN)  # its integral is 2π/√(1.3² − 1)
RISING = Sampled(lambda x: np.exp(x / 3), TURN)  # does not end where it begins
KINKED = Sampled(lambda x: np.abs(np.sin(x + 0.3)), TURN, [np.pi - 0.3, TURN - 0.3])  # 4
JUMPING = Sampled(lambda x: np.where((x > 1) & (x < 3), np.cos(x), 0.0), TURN, [1.0, 3.0])


def errors(scene, key, value, counts):
    return np.abs(np.array([KEYS[key].run(scene, count) for count in counts]) / value - 1)


@pytest.mark.parametrize(
    ("scene", "value"),
    [
        (POISSON, TURN / np.sqrt(0.69)),
        (RISING, 3 * (np.exp(TURN / 3) - 1)),
        (KINKED, 4.0),
        (JUMPING, np.sin(3) - np.sin(1)),
    ],
)
def test_gauss_between_the_breaks_is_exact(scene, value):
    assert exact(scene) == pytest.approx(value, rel=1e-14)


def test_equal_steps_over_a_period_of_a_smooth_function_err_less_than_any_power():
    """The k-th harmonic of the function is ρ^k, ρ = 1.3 − √0.69: the error is 2ρ^N/(1 − ρ^N)."""
    rho = 1.3 - np.sqrt(0.69)
    for count in (12, 24):
        (found,) = errors(POISSON, "trapezoid", TURN / np.sqrt(0.69), [count])
        assert found == pytest.approx(2 * rho**count / (1 - rho**count), rel=1e-6)


def test_simpsons_rule_over_a_period_errs_as_half_as_many_trapezia():
    """S_N = (4 T_N − T_{N/2})/3, and of the two the second is far worse."""
    for count in (12, 24, 36):
        whole, half = (KEYS["trapezoid"].run(POISSON, n) for n in (count, count // 2))
        assert KEYS["simpson"].run(POISSON, count) == pytest.approx((4 * whole - half) / 3, rel=1e-15)


def test_a_periodic_spline_has_the_integral_of_the_trapezia():
    values, step = POISSON.table(12)
    values[-1] = values[0]
    x = np.arange(13) * step
    whole = CubicSpline(x, values, bc_type="periodic").integrate(0, TURN)
    assert spline(values, step) == pytest.approx(whole, rel=1e-14)
    assert trapezoid(values, step) == pytest.approx(whole, rel=1e-14)


def test_a_spline_with_ends_has_the_integral_of_the_librarys():
    values, step = RISING.table(11)
    whole = CubicSpline(np.arange(12) * step, values).integrate(0, TURN)
    assert spline(values, step) == pytest.approx(whole, rel=1e-13)


@pytest.mark.parametrize(("key", "order"), [("trapezoid", 2), ("simpson", 4), ("spline_integral", 4)])
def test_orders_for_a_function_that_does_not_end_where_it_begins(key, order):
    found = errors(RISING, key, 3 * (np.exp(TURN / 3) - 1), (100, 200, 400))
    assert np.log2(found[:-1] / found[1:]) == pytest.approx(
        [order] * 2, abs=0.2 + 0.3 * (key == "spline_integral")
    )


@pytest.mark.parametrize("key", ["trapezoid", "simpson", "spline_integral"])
def test_a_kink_leaves_every_rule_the_second_order_and_a_jump_the_first(key):
    """Errors swing with where the break falls between two positions: the worst of many counts is compared."""
    for scene, value, order in ((KINKED, 4.0, 2), (JUMPING, np.sin(3) - np.sin(1), 1)):
        rough, fine = (max(errors(scene, key, value, range(n, n + 40, 2))) for n in (100, 1000))
        assert np.log10(rough / fine) == pytest.approx(order, abs=0.3)


def test_many_functions_are_integrated_at_once():
    both = Sampled(lambda x: np.array([np.sin(x) ** 2, 1 + 0 * x]), TURN)
    for one in INTEGRALS:
        assert one.run(both, 12) == pytest.approx([np.pi, TURN])


def test_simpsons_rule_refuses_an_odd_number_of_steps():
    with pytest.raises(ArithmeticError, match="even"):
        KEYS["simpson"].run(POISSON, 13)
    assert simpson(np.array([0.0, 1.0, 4.0]), 1.0) == pytest.approx(8 / 3)
