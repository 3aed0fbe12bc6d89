"""Blocking contour: its lines, its region, and the nearest feasible point."""

import pickle

import numpy as np
import pytest

from tmm_report.mechanics.calculus.isolines import isolines
from tmm_report.mechanics.calculus.polygons import inside
from tmm_report.mechanics.gears import meshing
from tmm_report.mechanics.gears.limits.blocking_contour import Blocking
from tmm_report.mechanics.gears.limits.pair import limits_of
from tmm_report.mechanics.gears.meshing import Rack

REFERENCE = Blocking(14, 28, 0.006, Rack())
CASES = [REFERENCE, Blocking(12, 12, 1.0, Rack()), Blocking(20, 60, 1.0, Rack(), internal=True),
         Blocking(17, 40, 1.0, Rack(), 0.3)]  # fmt: skip
CHOSEN = 3 / 17 + 0.5625j

VALUES = {
    "undercut": lambda pair, i: (pair.x1, pair.x2)[i],
    "pointing": lambda pair, i: pair.s_na[i] / pair.m,
    "contact": lambda pair, i: pair.eps,
    "space": lambda pair, i: pair.spaces[i] / pair.m,
    "tips": lambda pair, i: (pair.d_a[i] - pair.d_b[i]) / pair.m,
    "interference": lambda pair, i: pair.interference[i] / pair.m,
    "fouling": lambda pair, i: pair.fouling,
    "sliding": lambda pair, i: pair.root_sliding[0] - pair.root_sliding[1],
    "distance": lambda pair, i: pair.x_sum,
}


@pytest.mark.parametrize("case", CASES)
def test_every_point_of_a_line_has_its_level(case):
    wrong = []
    for line in case.lines(case.window(CHOSEN), CHOSEN):
        points = np.concatenate(line.pieces)
        off = VALUES[line.kind](case.pair(points), line.wheel - 1) - line.level
        if np.abs(off).max() > (1e-9 if line.kind != "sliding" else 1e-7):
            wrong.append((line.kind, line.wheel, line.level, np.abs(off).max()))
    assert wrong == []


def test_all_the_lines_the_course_asks_for_are_there():
    kinds = {
        (line.kind, line.wheel, line.level) for line in REFERENCE.lines(REFERENCE.window(CHOSEN), CHOSEN)
    }
    wanted = {
        ("undercut", 1),
        ("undercut", 2),
        ("interference", 1),
        ("interference", 2),
        ("sliding", 0),
        ("distance", 0),
    }
    assert wanted <= {kind[:2] for kind in kinds}
    assert {("pointing", 1, level) for level in (0.0, 0.25, 0.3)} <= kinds
    assert {("contact", 0, level) for level in (1.0, 1.05, 1.2)} <= kinds


@pytest.mark.parametrize("case", CASES)
def test_the_region_holds_the_feasible_points_and_no_others(case):
    low, high = window = case.window(CHOSEN)
    rng = np.random.default_rng(4)
    points = low + (high - low).real * rng.random(3000) + 1j * (high - low).imag * rng.random(3000)
    margin = case.margin(points)
    clear = np.abs(margin) > 2e-2
    held = np.any([inside(points, piece[:-1]) for piece in case.region(window)], axis=0)
    assert (held == (margin > 0))[clear].all() and held.any()


@pytest.mark.parametrize("case", CASES)
def test_the_boundary_is_exact_and_has_corners(case):
    low, high = window = case.window(CHOSEN)
    corners = 0
    for piece in case.region(window):
        assert piece[0] == piece[-1]
        sides = [(piece - low).real, (piece - low).imag, (high - piece).real, (high - piece).imag]
        within = piece[np.min(sides, axis=0) > 1e-9]
        assert np.abs(case.margin(within)).max() < 1e-9
        corners += np.count_nonzero(np.sort(case._margins(within), axis=0)[1] < 1e-9)
    assert corners >= 3


def test_the_rule_of_the_course_lacks_what_the_reference_pair_lacks():
    (lack,) = REFERENCE.lacks(CHOSEN)
    assert (lack.limit.kind, lack.limit.wheel) == ("undercut", 1)
    assert lack.lack == pytest.approx(0.18116 - 0.17647, abs=1e-5)
    exact = float(meshing.least_shift(14, Rack()))
    assert REFERENCE.nearest(CHOSEN) == pytest.approx(exact + 0.5625j, abs=1e-9)
    assert REFERENCE.nearest_at_distance(CHOSEN) == pytest.approx(
        exact + 1j * (CHOSEN.real + CHOSEN.imag - exact), abs=1e-9
    )


def test_the_nearest_point_may_be_a_corner():
    exact = float(meshing.least_shift(12, Rack()))
    assert CASES[1].nearest(0j) == pytest.approx(exact * (1 + 1j), abs=1e-9)
    assert CASES[1].nearest_at_distance(0j) is None


@pytest.mark.exhaustive
@pytest.mark.parametrize("x", [0.9 - 0.5j, -0.4 + 1.2j, 1.3 + 1.3j, 0.2 - 0.9j])
def test_no_feasible_point_is_nearer(x):
    found = REFERENCE.nearest(x)
    assert REFERENCE.margin(np.array(found)) > -1e-9
    reach = abs(found - x) * (1 - 1e-6)
    ring = x + reach * np.sqrt(np.linspace(0, 1, 60))[:, None] * np.exp(2j * np.pi * np.linspace(0, 1, 720))
    assert (REFERENCE.margin(ring) < 0).all()


def test_a_feasible_point_is_its_own_nearest():
    assert REFERENCE.lacks(0.4 + 0.4j) == () and REFERENCE.nearest(0.4 + 0.4j) == 0.4 + 0.4j


@pytest.mark.parametrize(
    "blocking", [Blocking(14, 28, 6e-3, Rack()), Blocking(20, 60, 4e-3, Rack(), internal=True)]
)
def test_a_point_is_feasible_where_no_margin_is_negative(blocking):
    plane = grid(3.0, 61)
    good = blocking.feasible(plane)
    assert good.any()
    np.testing.assert_array_equal(good, blocking.margin(plane) >= 0)


def test_no_region_at_all():
    case = Blocking(6, 6, 1.0, Rack(), least_ratio=1.5)
    assert case.nearest(0j) is None and case.region(case.window(0j)) == ()
    assert case.nearest_at_distance(0j) is None


def test_shifts_without_a_centre_distance_lack_everything():
    lacks = REFERENCE.lacks(-1.5 - 1.5j)
    assert [lack.limit.kind for lack in lacks] == ["undercut", "undercut", "mesh"]
    assert all(lack.lack > 0.5 for lack in lacks)


# ---------------------------------------------------------------- isolines


def grid(half, count):
    x = np.linspace(-half, half, count)
    return x + 1j * x[:, None]


@pytest.mark.parametrize("case", CASES)
def test_limits_are_pickled_with_the_results_that_keep_them(case):
    pair = case.pair(CHOSEN)
    limits = limits_of(pair, 0.25, 1.2, sliding=3.0)
    assert len(limits) > 10
    back = pickle.loads(pickle.dumps(limits))
    margins = [[float(limit.margin(pair)) for limit in them] for them in (limits, back)]
    np.testing.assert_array_equal(*margins)


def test_a_circle_is_one_closed_chain_on_the_circle():
    (chain,) = isolines(lambda z: np.abs(z) - 1, grid(2, 40))
    assert chain[0] == chain[-1] and np.abs(np.abs(chain) - 1).max() < 1e-12
    assert abs(np.sum((chain[:-1].conj() * chain[1:]).imag) / 2) == pytest.approx(np.pi, rel=5e-3)


def test_two_branches_through_one_cell_are_kept_apart():
    chains = isolines(lambda z: z.real * z.imag - 1e-4, grid(1, 4))
    assert len(chains) == 2
    assert {np.sign(chain.real).min() for chain in chains} == {-1.0, 1.0}


def test_no_line_is_drawn_where_the_function_is_unknown():
    (chain,) = isolines(lambda z: np.where(z.real > 0.1, z.imag, np.nan), grid(1, 41))
    assert chain.real.min() > 0.1 and chain.real.max() == 1.0
    assert isolines(lambda z: np.abs(z) + 1, grid(1, 5)) == ()
