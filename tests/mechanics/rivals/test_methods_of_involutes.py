"""The inverse involute by every method, against 40 digits."""

import mpmath
import numpy as np
import pytest

from tmm_report.mechanics.rivals import involutes
from tmm_report.mechanics.rivals.involutes import INVOLUTES

KEYS = {one.key: one for one in INVOLUTES}
USUAL = np.radians([1, 5, 14.5, 20, 25, 30, 45])  # of gears


def exact(alpha):
    """v = inv α as doubles, and the angles whose involute these doubles are."""
    with mpmath.workdps(40):
        v = [float(mpmath.tan(mpmath.mpf(float(a))) - mpmath.mpf(float(a))) for a in alpha]
        angles = [
            mpmath.findroot(lambda x, w=w: mpmath.tan(x) - x - mpmath.mpf(w), mpmath.mpf(float(a)))
            for a, w in zip(alpha, v, strict=True)
        ]
    return np.array(v), angles


def relative(key, alpha):
    v, angles = exact(alpha)
    found = KEYS[key].run(v, 0)
    return np.array(
        [float(abs(mpmath.mpf(float(own)) - true) / true) for own, true in zip(found, angles, strict=True)]
    )


@pytest.mark.parametrize("key", ["series_and_halley", "newton_involute", "halley_involute", "bisection"])
def test_angles_of_gears_are_found_by_all(key):
    assert relative(key, USUAL).max() < 1e-11


def test_our_own_way_keeps_all_digits_from_nothing_to_a_right_angle():
    alpha = [1e-8, 1e-4, 0.01, 0.49, 0.51, 1.0, 1.5, 1.5707, 1.570796]
    assert relative("series_and_halley", alpha).max() < 5e-16


def test_five_terms_of_the_series_err_by_the_sixth():
    """The first that is left out is of c¹¹, so the error falls as c¹⁰ beside the angle."""
    rough, fine = relative("series", [0.4, 0.2])
    assert np.log2(rough / fine) == pytest.approx(10, abs=0.5)
    assert relative("series", np.radians([20]))[0] < 2e-9
    assert relative("series", [1.4])[0] > 0.1


def test_a_step_of_newtons_squares_the_error_and_one_of_halleys_cubes_it(monkeypatch):
    """Newton: f''/2f' e² = (1 + tan²α)/tan α e²; of the start e ≈ 2c³/15."""
    monkeypatch.setattr(involutes, "SETTLED", np.inf)  # the first step is the last
    alpha = 0.3
    v, _ = exact([alpha])
    start = np.cbrt(3 * v[0]) - alpha
    squared = (1 + np.tan(alpha) ** 2) / np.tan(alpha) * start**2
    newton, halley = (KEYS[f"{key}_involute"].run(v, 0)[0] - alpha for key in ("newton", "halley"))
    assert newton == pytest.approx(squared, rel=0.1)
    assert abs(halley) < 0.05 * newton


def test_near_nothing_the_difference_of_tangent_and_angle_has_no_digits_left():
    """tan α − α is lost by ε/α² of itself: bisection ends in the wrong place, Newton's and Halley's steps do not
    settle, and say so."""
    assert relative("bisection", [1e-6])[0] > 1e-6
    v, _ = exact([1e-7])
    for key in ("newton_involute", "halley_involute"):
        assert np.isnan(KEYS[key].run(v, 0)).all()
        assert relative(key, [1e-3])[0] < 1e-9


def test_beyond_the_start_of_the_series_newtons_method_leaves_the_quarter_and_says_so():
    v, _ = exact([1.56])
    assert np.isnan(KEYS["newton_involute"].run(v, 0)).all()


def test_nothing_and_what_is_no_number():
    ends = np.array([0.0, np.nan])
    for one in INVOLUTES:
        found = one.run(ends, 0)
        assert found[0] == pytest.approx(0.0, abs=3e-8)
        assert np.isnan(found[1])
    assert KEYS["series_and_halley"].run(np.array([np.inf]), 0) == pytest.approx([np.pi / 2])
    assert KEYS["bisection"].run(np.array([np.inf]), 0) == pytest.approx([np.pi / 2])
    assert np.isnan(KEYS["newton_involute"].run(np.array([np.inf]), 0)).all()


def test_any_shape_of_the_array():
    v, _ = exact(USUAL[:6])
    for one in INVOLUTES:
        assert one.run(v.reshape(2, 3), 0) == pytest.approx(one.run(v, 0).reshape(2, 3))
