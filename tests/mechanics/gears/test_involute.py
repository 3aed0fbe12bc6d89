"""The involute function and its inverse against 60 digits of decimal arithmetic."""

import math
from decimal import Decimal, localcontext

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.gears.involute import REVERTED, SMALL, SMALL_INV, TANGENT, inv, inverse

DIGITS = 60
LEAST, MOST = 1e-6, math.radians(89.99)


def tan_and_inv(alpha: float) -> tuple[Decimal, Decimal]:
    """tan α and tan α − α from the series of sine and cosine."""
    x = Decimal(float(alpha))
    term, sums = Decimal(1), [Decimal(0), Decimal(0)]
    for n in range(90):
        sums[n % 2] += term if n % 4 < 2 else -term
        term *= x / (n + 1)
    tangent = sums[1] / sums[0]
    return tangent, tangent - x


def ulps_of_inverse(v: float) -> float:
    """How far inverse(v) is from the exact inverse of the binary number v; one Newton step is exact to 30 digits."""
    found = inverse(v)
    with localcontext() as context:
        context.prec = DIGITS
        tangent, value = tan_and_inv(found)
        return abs(float((value - Decimal(float(v))) / tangent**2 / Decimal(float(np.spacing(found)))))


def ulps_of_inv(alpha: float) -> float:
    found = inv(alpha)
    with localcontext() as context:
        context.prec = DIGITS
        return abs(float((Decimal(float(found)) - tan_and_inv(alpha)[1]) / Decimal(float(np.spacing(found)))))


def angles() -> np.ndarray:
    """Dense where it is delicate: at the ends, at the change of the method, over the decades below it."""
    return np.concatenate(
        [
            np.geomspace(LEAST, MOST, 300),
            np.pi / 2 - np.geomspace(np.pi / 2 - MOST, 1.0, 100),
            np.linspace(SMALL - 0.02, SMALL + 0.1, 150),
            np.linspace(0.05, 1.5, 200),
        ]
    )


def test_inverse_within_4_ulp():
    assert max(ulps_of_inverse(v) for v in inv(angles())) <= 4


def test_inv_within_10_ulp():
    assert max(ulps_of_inv(alpha) for alpha in angles()) <= 10


@given(st.floats(LEAST, MOST))
def test_any_angle(alpha):
    assert ulps_of_inverse(inv(alpha)) <= 4


def test_the_handbook():
    assert inv(math.radians(20)) == pytest.approx(0.014904383867, abs=1e-12)
    assert inverse(0.02771231) == pytest.approx(0.42562949, abs=1e-8)


def test_arrays_and_single_numbers():
    v = np.array([[0.0, 1e-18, SMALL_INV], [0.7, 5729.0, 1e300]])
    together = inverse(v)
    assert together.shape == v.shape
    assert [inverse(one) for one in v.ravel()] == together.ravel().tolist()
    assert inverse(np.array([])).shape == (0,)
    many = np.linspace(0.0, 50.0, 20_001).reshape(3, -1)  # more than are taken at a time
    assert np.array_equal(inverse(many), np.stack([inverse(row) for row in many]))
    assert [inv(alpha) for alpha in together.ravel()] == inv(together).ravel().tolist()


def test_odd_and_ends():
    v = np.array([1e-9, 0.3, 40.0])
    assert np.array_equal(inverse(-v), -inverse(v))
    assert np.array_equal(inv(-np.array([0.1, 1.2])), -inv(np.array([0.1, 1.2])))
    assert inverse(np.inf) == math.pi / 2
    assert np.isnan(inverse(np.nan))


def test_series_coefficients():
    """The tangent's by tan' = 1 + tan²; the reverted series put into the other gives α back, with rational numbers."""
    from fractions import Fraction

    tangent = [Fraction(1)]
    for k in range(1, len(TANGENT) + 1):
        tangent.append(sum((tangent[i] * tangent[k - 1 - i] for i in range(k)), Fraction(0)) / (2 * k + 1))
    assert [float(t) for t in tangent[1:]] == list(TANGENT)
    assert [float(a) for a in reverted(tangent, len(REVERTED))] == list(REVERTED)


def reverted(tangent, count):
    """a_k of α = c Σ a_k q^k, q = c², from 3 α³ Σ t_(k+1) α^2k = c³, one coefficient after another."""
    from fractions import Fraction

    def product(a, b):
        return [sum((a[i] * b[n - i] for i in range(n + 1)), Fraction(0)) for n in range(count)]

    found = [Fraction(1)] + [Fraction(0)] * (count - 1)
    for n in range(1, count):
        square = product(found, found)
        power, total = product(square, found), Fraction(0)
        for k in range(n + 1):
            total += 3 * tangent[k + 1] * power[n - k]
            power = product(power, square)
        found[n] -= total / 3
    return found


def test_methods_meet():
    """No step where the series gives way to the iteration."""
    v = SMALL_INV * (1 + 1e-13 * np.arange(-50, 50))
    steps = np.diff(inverse(v))
    assert np.all(steps > 0)
    assert np.ptp(steps) < 5e-15
