"""All five kinds of dyads: closure, roots, velocities and accelerations, in both roots and both senses."""

import numpy as np
import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from schemes import OMEGA, ROOTED, SCHEMES, linkage, turn

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever import motion

scale_factors = st.lists(st.floats(0.94, 1.06), min_size=6, max_size=6)


def residual(found: motion.Motion) -> float:
    """Largest gap in any pair of the mechanism, relative to its largest length; angles count by themselves."""
    scheme, s = found.linkage.mechanism, found.state

    def world(link, at):
        return s.r[link] + s.u[link] * (at - s.o[link])

    gaps = []
    for point in scheme.point_names:
        places = [world(link, scheme.links[link].points[point]) for link in scheme.links_at(point)]
        gaps += [abs(place - places[0]) for place in places[1:]]
    points = [link.points.values() for link in scheme.links.values()]
    size = max(abs(p - q) for places in points for p in places for q in places)
    angles = [abs(abs(u) - 1) for u in s.u.values()]
    for slide in scheme.slides:
        guide = scheme.guides[slide.guide]
        along = s.u[guide.link] * guide.direction
        off = cross(along, world(slide.link, slide.through) - world(guide.link, guide.through))
        gaps.append(abs(off))
        angles.append(abs(s.u[slide.link] * slide.direction - along))
    return max(*(np.max(gap) / size for gap in gaps), *(np.max(angle) for angle in angles))


def slope(value, h: float):
    """Fourth-order central difference of `value(shift)`."""
    return (8 * (value(h) - value(-h)) - (value(2 * h) - value(-2 * h))) / (12 * h)


def rate_errors(lk: motion.Linkage, h: float, omega: float = OMEGA) -> tuple[float, float]:
    """Largest error of all velocities, and of all accelerations, against differences in time; relative."""
    phi = turn()
    found = motion.solve(lk, phi, omega)
    moved = {k: motion.solve(lk, phi + k * h, omega) for k in (-2, -1, 1, 2)}

    def by_time(quantity):
        return slope(lambda shift: quantity(moved[round(shift / h)]), h) * omega

    def worst(pairs):
        size = max(np.max(np.abs(exact)) for exact, _ in pairs)
        return max(np.max(np.abs(exact - difference)) for exact, difference in pairs) / (size or 1.0)

    places = worst([(found.velocities, by_time(lambda m: m.places))])
    rates = worst([(found.accelerations, by_time(lambda m: m.velocities))])
    turns, spins = [], []
    for n in lk.mechanism.moving:
        turning = by_time(lambda m, n=n: m.turn(n))
        turns.append(
            (found.angular_velocity(n), np.imag(np.conj(found.turn(n)) * turning))
        )  # ω = Im(ū du/dt)
        spins.append((found.angular_acceleration(n), by_time(lambda m, n=n: m.angular_velocity(n))))
    return max(places, worst(turns)), max(rates, worst(spins))


@pytest.mark.parametrize(("name", "sign"), ROOTED)
@settings(max_examples=examples(15))
@given(k=scale_factors)
def test_pairs_close_and_rates_are_derivatives(name, sign, k):
    lk = linkage(SCHEMES[name](k), sign)
    found = motion.solve(lk, turn())
    assert found.closes.all()
    assert residual(found) < 1e-13
    velocity, acceleration = rate_errors(lk, 2e-3)
    assert velocity < 1e-9
    assert acceleration < 1e-8


@pytest.mark.parametrize(("name", "sign"), ROOTED)
def test_differences_converge_in_fourth_order(name, sign):
    lk = linkage(SCHEMES[name](), sign)
    errors = np.array([rate_errors(lk, h) for h in (0.04, 0.02, 0.01)])
    order = np.log2(errors[:-1] / errors[1:])
    assert np.abs(order - 4).max() < 0.2, order


@pytest.mark.parametrize(("name", "sign"), ROOTED)
def test_other_sense_of_rotation(name, sign):
    """Turning back through the same positions: velocities change sign, accelerations do not."""
    lk = linkage(SCHEMES[name](), sign)
    there, back = motion.solve(lk, turn(), OMEGA), motion.solve(lk, turn(), -OMEGA)
    np.testing.assert_allclose(back.velocities, -there.velocities, rtol=0, atol=1e-13)
    np.testing.assert_allclose(back.accelerations, there.accelerations, rtol=0, atol=1e-11)
    assert max(rate_errors(lk, 2e-3, -OMEGA)) < 1e-8


@pytest.mark.parametrize(("name", "sign"), [root for root in ROOTED if root[0] != "compound"])
def test_signs_mean_what_the_table_says(name, sign):
    lk = linkage(SCHEMES[name](), sign)
    found = motion.solve(lk, turn())
    s = found.state
    for d in lk.groups:
        A = s.world(d.carrier_a, d.outer_a.at[d.carrier_a])
        C = s.world(d.carrier_b, d.outer_b.at[d.carrier_b])
        if d.kind == 1:
            side = cross(C - A, found.place(d.inner.name) - A)
        elif d.kind == 2:
            side = dot(s.u[d.carrier_b] * d.outer_b.along[d.carrier_b], found.place(d.inner.name) - A)
        elif d.kind == 3:
            side = dot(s.u[d.a] * d.inner.along[d.a], C - A)
        else:
            continue
        assert (np.sign(side) == d.sign).all()


def test_what_does_not_close_is_nan_there_only():
    scheme = SCHEMES["four_bar"]([1.0, 0.6, 1.0, 1.0, 1.0, 1.0])
    phi = turn(360)
    found = motion.solve(linkage(scheme), phi)
    lost = ~found.closes
    # the rod and the rocker do not reach each other where |AC| > 0.18·0.6 + 0.12
    A = 0.03 + 0.01j + 0.05 * np.exp(1j * phi)
    np.testing.assert_array_equal(lost, abs(0.22 - A) > 0.18 * 0.6 + 0.12)
    assert 0 < lost.sum() < 360
    for values in (found.places, found.velocities, found.accelerations):
        assert np.isfinite(values[:, ~lost]).all()
    # the crank is not lost with the rod
    assert np.isfinite(found.place("A")).all()
    assert np.isnan(found.place("B")[lost]).all()
    alone = motion.solve(linkage(scheme), phi[~lost])
    np.testing.assert_array_equal(found.accelerations[:, ~lost], alone.accelerations)


def test_singular_position_has_sine_zero():
    """Rod and rocker of a four-bar in one line."""
    lk = linkage(SCHEMES["four_bar"]([1.0, 0.6, 1.0, 1.0, 1.0, 1.0]))
    phi = turn(20000)
    found = motion.solve(lk, phi)
    (sine,) = found.sines.values()
    assert np.nanmin(sine) < 0.02
    assert np.nanmax(sine) > 0.5
