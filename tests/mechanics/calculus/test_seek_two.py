"""All places where two functions are at their levels: against pairs whose roots are known."""

import numpy as np
import pytest

from tmm_report.mechanics.calculus.seek_two import PARTS, Asked, seek, slopes

STEP = 1 / PARTS


def found(sought):
    return np.array([root.at for root in sought.roots]).reshape(-1, 2)


def apart(rng, count):
    while True:
        places = np.sort(rng.uniform(0.03, 0.97, count))
        if count < 2 or np.diff(places).min() > 2 * STEP:
            return places


@pytest.mark.parametrize("seed", range(40))
def test_no_root_of_two_products_is_missed(seed):
    """u = Π (x − aᵢ), v = Π (y − bⱼ), mixed by a matrix: the roots are all the pairs (aᵢ, bⱼ)."""
    rng = np.random.default_rng(seed)
    a, b = apart(rng, int(rng.integers(1, 4))), apart(rng, int(rng.integers(1, 4)))
    mix = rng.normal(size=(2, 2))
    while abs(np.linalg.det(mix)) < 0.3:
        mix = rng.normal(size=(2, 2))
    levels = tuple(rng.normal(scale=0.1, size=2) * rng.integers(0, 2, size=2))

    def f(x):
        u = np.prod([x[:, 0] - one for one in a], axis=0) * 4 ** len(a)
        v = np.prod([x[:, 1] - one for one in b], axis=0) * 4 ** len(b)
        return np.stack([u, v], axis=1) @ mix.T + np.array(levels)

    right = sorted((one, two) for one in a for two in b)
    sought = seek(f, levels)
    assert found(sought) == pytest.approx(np.array(right), abs=1e-8)


@pytest.mark.parametrize("seed", range(40))
def test_no_meeting_of_a_circle_and_a_line_is_missed(seed):
    """Where it meets it at all, and neither touches nor meets it at the edge."""
    rng = np.random.default_rng(500 + seed)
    centre, radius, turn = rng.uniform(0.3, 0.7, 2), rng.uniform(0.1, 0.6), rng.uniform(0, 6.28)
    normal, away = np.array([np.cos(turn), np.sin(turn)]), rng.uniform(-0.9, 0.9) * radius
    half = np.sqrt(radius**2 - away**2) * np.array([-normal[1], normal[0]])
    right = [centre + away * normal + sign * half for sign in (1, -1)]
    right = sorted(tuple(one) for one in right if (one > 0.01).all() and (one < 0.99).all())
    out = [
        one for one in (centre + away * normal + s * half for s in (1, -1)) if (abs(one - 0.5) < 0.51).all()
    ]
    if len(out) != len(right):
        return

    def f(x):
        d = x - centre
        return np.stack([np.exp((d**2).sum(axis=1) - radius**2), d @ normal], axis=1)

    sought = seek(f, (1.0, away))
    assert found(sought) == pytest.approx(np.array(right).reshape(-1, 2), abs=1e-8)


def test_roots_at_corners_and_edges():
    sought = seek(lambda x: x, (0.0, 1.0))
    assert found(sought) == pytest.approx(np.array([[0, 1]]), abs=1e-12)
    sought = seek(lambda x: x**2, (0.25, 1.0))
    assert found(sought) == pytest.approx(np.array([[0.5, 1]]), abs=1e-9)


def test_a_jump_is_no_root_and_what_has_no_values_is_left_out():
    def jumps(x):
        return np.stack([np.where(x[:, 0] < 0.4321, -1.0, 2.0), x[:, 1]], axis=1)

    assert not seek(jumps, (0.5, 0.5)).roots

    def partly(x):
        return np.where(x[:, :1] < 0.6, np.nan, x)

    assert found(seek(partly, (0.7, 0.3))) == pytest.approx(np.array([[0.7, 0.3]]), abs=1e-11)


def test_what_cannot_be_met_says_how_near_it_comes():
    """A circle round (0.31, 0.62) that is too small, and beyond an edge."""

    def f(x):
        d = x - np.array([0.31, 0.62])
        return np.stack([3 + (d**2).sum(axis=1), 1 + d[:, 0]], axis=1)

    sought = seek(f, (2.0, 1.0))
    assert not sought.roots and sought.nearest.at == pytest.approx((0.31, 0.62), abs=1e-5)
    sought = seek(lambda x: 1 + x, (3.0, 1.4))
    assert sought.nearest.at == pytest.approx((1, 0.4), abs=1e-5)
    assert sought.nearest.value == pytest.approx((2, 1.4), abs=1e-5)


def test_slopes_are_those_of_closed_forms():
    def f(x):
        x = np.atleast_2d(x)
        return np.squeeze(np.stack([np.exp(x[:, 0]) * x[:, 1], np.sin(x[:, 0] + x[:, 1] ** 2)], axis=1))

    for at in ([0.3, 0.6], [0.0, 1.0]):
        a, b = at
        turn = np.cos(a + b**2)
        right = np.array([[np.exp(a) * b, np.exp(a)], [turn, 2 * b * turn]])
        assert slopes(f, np.array(at)) == pytest.approx(right, rel=1e-6, abs=1e-7)


def test_few_places_are_asked_and_none_twice():
    places = []

    def f(x):
        places.extend(map(tuple, x.tolist()))
        return np.stack([np.cos(5 * x[:, 0]) + x[:, 1], x[:, 0] * x[:, 1]], axis=1)

    seek(Asked(f), (0.6, 0.2))
    assert len(places) == len(set(places)) < (PARTS + 1) ** 2 + 60


def test_two_roots_in_one_cell_whose_corners_are_on_one_side():
    """A line and a bow that dips below it between two places of the grid."""
    low, high = 0.5 + 0.2 * STEP, 0.5 + 0.7 * STEP

    def f(x):
        return np.stack([x[:, 1] - 0.3, (x[:, 0] - low) * (x[:, 0] - high)], axis=1)

    assert found(seek(f, (0.0, 0.0))) == pytest.approx(np.array([[low, 0.3], [high, 0.3]]), abs=1e-8)
