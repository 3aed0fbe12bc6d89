"""All assemblies by elimination: as many as there can be, the same as by continuation, or none of them is claimed."""

from math import comb

import numpy as np
import pytest
from conftest import examples
from higher_schemes import drawn
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.lever.assembly import all_roots as found_by
from tmm_report.mechanics.lever.assembly import elimination as eliminated
from tmm_report.mechanics.lever.assur_groups import decompose
from tmm_report.mechanics.lever.loop_equations import Loops
from tmm_report.mechanics.lever.motion import Linkage, drive

SEED = 20


def system(name, seed, sliding=()):
    """A drawn group's loops, its one position and its bilinear equations."""
    structure = decompose(drawn(name, seed, sliding).mechanism())
    (group,) = structure.groups
    assert group.kind is None
    loops, s = Loops(group), drive(Linkage(structure, ()), np.array([0.0]))
    return loops, s, found_by._Bilinear(loops, s, SEED)


def random_system(n, seed):
    m = n // 2 + 1
    random = np.random.default_rng(seed)
    return random.standard_normal((n, m, m)) + 1j * random.standard_normal((n, m, m))


@pytest.mark.parametrize("n", [2, 4, 6, 8])
def test_every_root_solves_the_equations_and_there_are_as_many_as_can_be(n):
    M = random_system(n, n)
    roots = eliminated.roots(M, SEED)
    assert len(roots) == comb(n, n // 2)
    xi, eta = np.split(roots, 2, axis=1)
    assert np.abs(np.einsum("ra,iab,rb->ri", xi, M, eta)).max() < 1e-13
    np.testing.assert_allclose(np.linalg.norm(xi, axis=1), 1, rtol=1e-14)


def test_two_equations_in_the_plane_are_a_quadratic():
    """n = 2: det(ξᵀM₁ | ξᵀM₂) = 0, solved by the formula."""
    M = random_system(2, 7)
    a, b, c = np.polyfit([-1, 0, 1], [np.linalg.det(np.array([1, x]) @ M) for x in (-1.0, 0.0, 1.0)], 2)
    expected = np.sort_complex((-b + np.array([1, -1]) * np.sqrt(b * b - 4 * a * c)) / (2 * a))
    roots = eliminated.roots(M, SEED)
    np.testing.assert_allclose(np.sort_complex(roots[:, 1] / roots[:, 0]), expected, rtol=1e-11)


@pytest.mark.exhaustive
@settings(max_examples=examples(25))
@given(
    name=st.sampled_from(("III3", "IV2")),
    seed=st.integers(0, 10**6),
    sliding=st.sets(st.integers(0, 5), max_size=2),
)
def test_they_are_those_of_continuation(name, seed, sliding):
    loops, s, equations = system(name, seed, tuple(sorted(sliding)))
    roots = eliminated.roots(equations.M, SEED)
    assume(roots is not None)
    one = found_by._repeat(s)
    by_elimination = found_by._roots(loops, one, equations, roots, np.ones(len(roots), dtype=bool))
    by_continuation = found_by._continued(loops, s, one)
    first, second = (
        found_by._distinct(q[np.isfinite(q).all(axis=1)], loops.angles)
        for q in (by_elimination, by_continuation)
    )
    assert len(first) == len(second)
    turned = [np.exp(1j * q[:, : loops.angles]) for q in (first, second)]
    nearest = np.abs(turned[0][:, None] - turned[1]).max(axis=2).min(axis=1)
    assert nearest.max(initial=0.0) < 1e-8


def test_a_group_of_six_links_has_the_same_assemblies_both_ways():
    loops, s, equations = system("III4", 0)
    roots = eliminated.roots(equations.M, SEED)
    assert len(roots) == 20
    continued = found_by._distinct(found_by._continued(loops, s, found_by._repeat(s)), loops.angles)
    assert len(found_by.assemblies(loops, s)) == len(continued) > 0


def test_two_roots_that_are_one_are_not_claimed():
    """Of ξᵀ M η with M = x yᵀ a root is ξ ⟂ x or η ⟂ y: two alike equations make every root double, or a whole line."""
    random = np.random.default_rng(3)
    x, y = random.standard_normal((2, 4, 3))
    M = x[:, :, None] * y[:, None, :] + 0j
    assert len(eliminated.roots(M, SEED)) == 6
    M[1] = M[0]
    assert eliminated.roots(M, SEED) is None
    x[1], y[1] = x[0], y[0] + 1e-9 * y[2]
    assert eliminated.roots(x[:, :, None] * y[:, None, :] + 0j, SEED) is None


def test_what_is_not_finite_has_no_roots():
    M = random_system(4, 1)
    M[2, 1, 1] = np.nan
    assert eliminated.roots(M, SEED) is None


def test_where_elimination_cannot_tell_the_assembly_is_still_found():
    """Three sliding pairs push roots together at infinity."""
    loops, s, equations = system("III3", 11, (0, 1, 2))
    assert eliminated.roots(equations.M, SEED) is None
    ways = found_by.assemblies(loops, s)
    assert len(ways)
    residual = loops.residual(found_by._repeat(s), ways)
    assert np.abs(residual).max() < 1e-12


def test_a_root_found_twice_hides_another_and_none_is_claimed(monkeypatch):
    M = random_system(4, 2)
    eta = eliminated._eta(M, SEED)
    assert len(eliminated.roots(M, SEED)) == 6
    eta[3] = eta[1]
    monkeypatch.setattr(eliminated, "_eta", lambda M, seed: eta)
    assert eliminated.roots(M, SEED) is None


def test_a_start_from_which_newton_does_not_settle_is_no_root(monkeypatch):
    M = random_system(4, 2)
    eta = np.roll(eliminated._eta(M, SEED), 1, axis=1)
    monkeypatch.setattr(eliminated, "_eta", lambda M, seed: eta)
    monkeypatch.setattr(eliminated, "_all_apart", lambda xi, eta: True)
    assert eliminated.roots(M, SEED) is None


def test_a_dozen_equations_are_left_to_continuation():
    assert eliminated.roots(random_system(12, 1), SEED) is None
