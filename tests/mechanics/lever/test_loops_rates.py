"""Rates of groups above class II with guides, on the group's own links and on those before it, held against finite
differences of the places."""

from functools import cache

import numpy as np
import pytest
from higher_schemes import drawn

from tmm_report.mechanics.calculus.roots import slope
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.assembly.stated import assemble

PHI = 0.3 + np.arange(7) * (2 * np.pi / 7)
MADE = [  # group, seed, sliding pairs
    ("III3", 1, (1,)), ("III3", 1, (3,)), ("III3", 1, (4,)), ("III3", 1, (1, 4)), ("IV2", 0, (1, 5)),
    ("IV2", 2, (2, 4)), ("III4", 1, (1, 6)),
]  # fmt: skip


@cache
def linkage(name, seed, sliding):
    return assemble(drawn(name, seed, sliding).mechanism())


@pytest.mark.parametrize("scheme", MADE)
@pytest.mark.parametrize(("value", "rate"), [("place", "velocity"), ("velocity", "acceleration")])
def test_points_move_as_their_places_change(scheme, value, rate):
    of = linkage(*scheme)
    found = motion.solve(of, PHI)
    assert found.closes.all() and all(sine.min() > 0.02 for sine in found.sines.values())
    omega = of.mechanism.driver.omega
    for point in found.point_index:
        exact = getattr(found, rate)(point)
        moved = slope(lambda phi, point=point: getattr(motion.solve(of, phi), value)(point), PHI, 2e-4)
        np.testing.assert_allclose(
            moved * omega, exact, rtol=0, atol=1e-8 * max(np.abs(exact).max(), omega**2)
        )


@pytest.mark.parametrize("scheme", MADE)
def test_what_is_read_from_placed_links_is_what_placed_them(scheme):
    of = linkage(*scheme)
    s = motion.solve(of, PHI).state
    loops = of.groups[-1].loops
    q = loops.read(s)
    at, again = loops.placed(s), loops.vectors(s, q)
    for one, other in zip(at, again, strict=True):
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-14)
    assert np.abs(loops.residual(s, q)).max() < 1e-14


@pytest.mark.parametrize("scheme", MADE)
def test_the_jacobian_is_the_slope_of_the_residual(scheme):
    of = linkage(*scheme)
    s = motion.solve(of, PHI).state
    loops = of.groups[-1].loops
    q, J = loops.read(s), loops.jacobian(s, loops.read(s))
    for n in range(q.shape[-1]):
        aside = np.eye(q.shape[-1])[n] * 1e-6
        moved = (loops.residual(s, q + aside) - loops.residual(s, q - aside)) / 2e-6
        np.testing.assert_allclose(J[..., n], moved, rtol=0, atol=1e-8)
