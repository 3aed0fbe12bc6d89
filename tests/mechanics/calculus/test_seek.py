"""All places where a function is at a level: against functions whose roots are known."""

import math

import numpy as np
import pytest

from tmm_report.mechanics.calculus.seek import PARTS, Asked, best, seek, slopes

STEP = 1 / PARTS


def apart(rng, count):
    """Places of 0 … 1, each more than a step of the grid from the others and from the ends."""
    while True:
        places = np.sort(rng.uniform(0.02, 0.98, count))
        if count < 2 or np.diff(places).min() > 1.01 * STEP:
            return places


def found(sought):
    return np.array([root.at for root in sought.roots])


@pytest.mark.parametrize("seed", range(40))
def test_no_root_of_a_polynomial_is_missed(seed):
    rng = np.random.default_rng(seed)
    roots = apart(rng, int(rng.integers(1, 9)))
    size = 10 ** rng.uniform(-6, 6)
    level = size * rng.normal(scale=0.01)

    def f(x):
        return level + size * np.prod([x - root for root in roots], axis=0)

    sought = seek(f, level)
    assert len(sought.roots) == len(roots) and not sought.jumps and not sought.lost
    slope = size * np.array([np.prod([a - b for b in roots if b != a]) for a in roots])
    rounding = 4e-16 * abs(level) / np.abs(slope)  # the level hides what is smaller
    assert np.all(np.abs(found(sought) - roots) <= 2e-12 + 4 * rounding)


@pytest.mark.parametrize("seed", range(30))
def test_no_root_of_a_sine_is_missed(seed):
    rng = np.random.default_rng(1000 + seed)
    rate, lag, level = rng.uniform(1, 0.45 * PARTS * math.pi), rng.uniform(0, 6.28), rng.uniform(-0.2, 0.2)
    turn = np.arange(-10, 60) * 2 * math.pi
    angles = np.sort(np.concatenate([turn + math.asin(level), turn + math.pi - math.asin(level)]))
    roots = (angles - lag) / rate
    roots = roots[(roots > 0) & (roots < 1)]
    sought = seek(lambda x: np.sin(rate * x + lag), level)
    assert len(sought.roots) == len(roots)
    assert np.allclose(found(sought), roots, rtol=0, atol=1e-11)


@pytest.mark.parametrize("seed", range(40))
def test_a_monotone_function_has_its_one_root(seed):
    rng = np.random.default_rng(2000 + seed)
    power, root, size = rng.uniform(0.2, 5), rng.uniform(0, 1), 10 ** rng.uniform(-9, 9)
    sought = seek(lambda x: size * (x**power - root**power), 0.0)
    (only,) = sought.roots
    assert only.at == pytest.approx(root, abs=1e-11) and not only.touches


@pytest.mark.parametrize("at", [0.3, 0.5, 0.123456789])
def test_a_level_that_is_only_touched(at):
    (root,) = seek(lambda x: 2 + (x - at) ** 2, 2.0).roots
    assert root.touches and root.at == pytest.approx(at, abs=1e-5)
    (root,) = seek(lambda x: -3 + np.abs(x - at), -3.0).roots
    assert root.touches and root.at == pytest.approx(at, abs=1e-9)


def test_two_roots_within_one_step_of_the_grid():
    roots = [0.5 + 0.2 * STEP, 0.5 + 0.7 * STEP]
    sought = seek(lambda x: (x - roots[0]) * (x - roots[1]), 0.0)
    assert found(sought) == pytest.approx(roots, abs=1e-11) and not any(r.touches for r in sought.roots)


def test_a_jump_and_a_pole_are_no_roots():
    sought = seek(lambda x: np.where(x < 0.4321, -1.0, 2.0) + 0.1 * x, 0.0)
    assert not sought.roots and sought.jumps == pytest.approx([0.4321], abs=1e-9)
    sought = seek(lambda x: 1 / (x - 0.377), 0.0)
    assert not sought.roots and sought.jumps == pytest.approx([0.377], abs=1e-9)
    sought = seek(lambda x: 1 / (x - 0.377), 100.0)
    assert found(sought) == pytest.approx([0.387], abs=1e-11) and sought.jumps == pytest.approx(
        [0.377], abs=1e-9
    )


def test_a_root_beside_the_edge_of_what_has_values():
    """sqrt(x − a) = b between the edge and the next place of the grid."""
    a = 0.5 + 0.3 * STEP
    sought = seek(lambda x: np.sqrt(np.where(x >= a, x - a, np.nan)), 0.05)
    assert found(sought) == pytest.approx([a + 0.0025], abs=1e-11)
    ((low, high),) = sought.lost
    assert low == 0 and high == pytest.approx(a, abs=1e-9)


def test_roots_at_the_ends_and_at_places_of_the_grid():
    assert found(seek(lambda x: x, 0.0)) == pytest.approx([0])
    assert found(seek(lambda x: x, 1.0)) == pytest.approx([1])
    assert found(seek(lambda x: (x - 0.25) * (x - 0.75), 0.0)) == pytest.approx([0.25, 0.75])


def test_a_part_of_the_range_at_the_level_is_told_by_its_ends():
    sought = seek(lambda x: np.clip(x, 0.25, 0.75), 0.25)
    assert found(sought) == pytest.approx([0, 0.25])


def test_what_cannot_be_met_says_how_near_it_comes():
    sought = seek(lambda x: 3 + (x - 0.31) ** 2, 1.0)
    assert not sought.roots and sought.nearest.at == pytest.approx(0.31, abs=STEP)


@pytest.mark.parametrize("at", [0.0, 0.37, 0.81, 1.0])
def test_the_best_value(at):
    sought = best(lambda x: 5 - (x - at) ** 2 + 0.0 * x, "greatest")
    assert sought.nearest.at == pytest.approx(at, abs=1e-6) and sought.nearest.value == pytest.approx(5)
    sought = best(lambda x: np.where(np.abs(x - 0.5) < 0.1, np.nan, np.abs(x - at)), "least")
    assert sought.nearest.value == pytest.approx(0, abs=1e-9)


def test_of_several_peaks_the_highest():
    sought = best(lambda x: np.sin(20 * x) + 0.1 * x, "greatest")
    x = np.linspace(0, 1, 400001)
    assert sought.nearest.value == pytest.approx(np.max(np.sin(20 * x) + 0.1 * x), abs=1e-9)


def test_slopes_are_those_of_closed_forms():
    x = np.array([0.0, 0.3, 0.77, 1.0])
    assert slopes(np.exp, x) == pytest.approx(np.exp(x), rel=1e-7)
    assert slopes(np.exp, x)[1:3] == pytest.approx(np.exp(x[1:3]), rel=1e-11)


def test_few_places_are_asked_and_none_twice():
    places = []

    def f(x):
        places.extend(x.tolist())
        return np.cos(9 * x)

    seek(Asked(f), 0.1)
    assert len(places) == len(set(places)) < 110
