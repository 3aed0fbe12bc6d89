"""Roots in brackets: many at once, each to its own noise, in few evaluations."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.roots import (
    bisected,
    bracketed,
    first_root,
    interpolated,
    newton,
    root_between,
)

FINDERS = pytest.mark.parametrize("finder", [bracketed, interpolated])
roots = st.lists(st.floats(0.05, 0.95), min_size=1, max_size=5)


def counted(f):
    calls = []
    return (lambda x: calls.append(x) or f(x)), calls


@FINDERS
@given(at=roots)
def test_many_roots_at_once(finder, at):
    at = np.array(at)
    f = lambda x: np.expm1(x - at) * (2 + np.cos(3 * x))  # noqa: E731
    low, high = np.zeros_like(at), np.ones_like(at)
    found, left = finder(f, low, high, f(low), 1e-14)
    assert found == pytest.approx(at, abs=2e-14)
    assert np.all(np.abs(left) <= 1e-14)


@given(at=roots)
def test_a_batch_equals_a_loop_of_singles(at):
    at = np.array(at)
    low, high = np.zeros_like(at), np.ones_like(at)
    found, _ = interpolated(lambda x: x**3 - at**3, low, high, -(at**3), 1e-13)
    for k, root in enumerate(at):
        cubic = lambda x, root=root: x**3 - root**3  # noqa: E731
        alone, _ = interpolated(cubic, low[k : k + 1], high[k : k + 1], -(at**3)[k : k + 1], 1e-13)
        assert alone == pytest.approx(found[k], abs=1e-12)


def test_each_root_has_its_own_noise():
    """A coarse root stays where it was found while the fine ones go on."""
    low, high = np.zeros(2), np.full(2, 2.0)
    found, left = interpolated(lambda x: x**2 - 2, low, high, low - 2, np.array([0.3, 1e-15]))
    assert 1e-3 < abs(left[0]) <= 0.3
    assert found[1] == pytest.approx(np.sqrt(2), abs=1e-15)


def test_few_evaluations_where_false_position_creeps():
    """The acceleration of a slider beside its zero: bent the same way at both ends of the bracket."""
    low, high = np.array([1.27]), np.array([1.28])
    f, calls = counted(lambda x: np.cos(x) - 0.289 * np.exp(2 * (x - 1.2776)))
    _, left = interpolated(f, low, high, f(low), 1e-15)
    assert abs(left[0]) <= 1e-15
    assert len(calls) <= 7


@FINDERS
def test_a_root_at_either_edge(finder):
    for root in (0.0, 1.0):
        low, high = np.array([0.0]), np.array([1.0])
        found, _ = finder(lambda x, root=root: np.sin(x - root), low, high, np.sin(low - root), 0.0)
        assert found[0] == pytest.approx(root, abs=2e-15)


def test_a_pole_comes_to_an_end():
    """A change of sign without a root: the bracket closes on the pole, and what is left tells it from a root."""
    low, high = np.zeros(1), np.ones(1)
    f, calls = counted(lambda x: 1 / (x - 0.3))
    found, left = interpolated(f, low, high, f(low), 1e-13)
    assert found[0] == pytest.approx(0.3, abs=1e-12)
    assert abs(left[0]) > 1e6
    assert len(calls) <= 62


# --- what ends somewhere


@given(at=st.floats(0.0, 1.0, exclude_max=True))
def test_what_holds_up_to_a_number_ends_between_it_and_the_next(at):
    low, high = bisected(lambda x: x <= at, 0.0, 1.0)
    assert low == at and high == np.nextafter(at, 2.0)


@given(at=st.floats(0.05, 0.95))
def test_one_root_between_two_numbers(at):
    assert root_between(lambda x: np.expm1(x - at), 0.0, 1.0) == pytest.approx(at, abs=1e-14)
    assert root_between(lambda x: at**3 - x**3, 0.0, 1.0) == pytest.approx(at, abs=1e-12)


def test_the_first_of_several_roots_beyond_what_is_unknown():
    grid = np.linspace(0.0, 10.0, 101)
    found = first_root(lambda x: np.where(x > 1, np.sin(x), np.nan), grid)
    assert found == pytest.approx(np.pi, abs=1e-14)
    assert first_root(lambda x: 1 + x**2, grid) is None
    assert first_root(lambda x: x - 0.3, grid[:4]) == pytest.approx(0.3, abs=1e-14)


@given(at=st.floats(0.05, 0.95), start=st.floats(0.0, 1.0))
def test_newtons_steps_stay_between_the_ends(at, start):
    """Of a function whose slope leads far away, is none, or is of the wrong sign."""
    places = []

    def of(slope):
        def f(x):
            places.append(x)
            return -np.cbrt(x - at), slope(x)

        return f

    steep = newton(of(lambda x: -1 / (3 * np.cbrt(x - at) ** 2 + 1e-300)), 0.0, 1.0, start)
    none, wrong = (newton(of(lambda x, k=k: k), 0.0, 1.0, start) for k in (0.0, 1.0))
    assert [steep, none, wrong] == pytest.approx([at] * 3, abs=1e-8)
    assert min(places) >= 0 and max(places) <= 1


def test_newton_settles_in_few_steps():
    f, calls = counted(lambda x: (2 - x**2, -2 * x))
    assert newton(f, 0.0, 2.0, 2.0) == pytest.approx(np.sqrt(2), abs=1e-15)
    assert len(calls) <= 6
