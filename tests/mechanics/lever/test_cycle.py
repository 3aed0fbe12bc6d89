"""Numbering of positions, extreme positions and extremes, against closed forms."""

import dataclasses
import math

import numpy as np
import pytest
from schemes import mechanism

from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import Extreme, Slope, cycle_of, larger, least_and_greatest
from tmm_report.mechanics.lever.mechanism import Assembly, Driver, Guide, Link, Slide, ZeroAngle, ZeroExtreme
from tmm_report.problems import ProblemError

R, L, E = 0.06, 0.22, 0.02


def offset_crank(zero=None, omega=5.0, sweep=2 * math.pi, offset=E):
    scheme = mechanism(
        [
            Link("0", {"O": 0j}),
            Link("1", {"O": 0j, "A": R + 0j}),
            Link("2", {"A": 0j, "B": L + 0j}),
            Link("3", {"B": 0j}),
        ],
        [Guide("x", "0", offset * 1j, 1 + 0j)],
        [Slide("3", "x")],
    )
    driver = Driver("1", omega, zero or ZeroAngle(0.0), sweep)
    return cycle_of(assemble(dataclasses.replace(scheme, driver=driver, assembly=(Assembly("B", 1),))))


def four_bar(zero, omega=5.0):
    scheme = mechanism(
        [
            Link("0", {"O": 0j, "C": 0.2 + 0j}),
            Link("1", {"O": 0j, "A": 0.06 + 0j}),
            Link("2", {"A": 0j, "B": 0.18 + 0j}),
            Link("3", {"C": 0j, "B": 0.12 + 0j}),
        ]
    )
    driver = Driver("1", omega, zero)
    return cycle_of(assemble(dataclasses.replace(scheme, driver=driver, assembly=(Assembly("B", 1),))))


def speed(motion):
    return motion.velocity("B").real


def place(motion):
    return motion.place("B").real


@pytest.mark.parametrize("omega", [5.0, -5.0])
@pytest.mark.parametrize(("direction", "reach"), [(1 + 0j, L + R), (-1 + 0j, L - R)])
def test_position_zero_of_a_slider(omega, direction, reach):
    """Dead centres of an offset slider-crank: crank and rod in one line, sin φ = e / (l ± r)."""
    cycle = offset_crank(ZeroExtreme("B", None, direction), omega)
    phi = math.asin(E / reach) + (0 if reach > L else math.pi)
    assert math.remainder(cycle.zero - phi, 2 * math.pi) == pytest.approx(0, abs=1e-12)
    # the other dead centre is found too, turned in the sense of rotation
    other = math.asin(E / (2 * L - reach)) + (math.pi if reach > L else 0)
    turned = (cycle.sense * (other - phi)) % (2 * math.pi)
    assert cycle.roots(speed) == pytest.approx([0, turned], abs=1e-12)


@pytest.mark.parametrize("sense", [1, -1])
def test_position_zero_of_a_rocker(sense):
    """At a rocker's extremes the crank lies along the rod: the triangle O B C has the sides l ± r."""
    cycle = four_bar(ZeroExtreme(None, "3", complex(sense)))
    motion = cycle.motion(np.array([0.0]))
    assert motion.angular_velocity("3")[0] == pytest.approx(0, abs=1e-12)
    reach = 0.18 - 0.06 if sense > 0 else 0.18 + 0.06
    assert abs(motion.place("B")[0]) == pytest.approx(reach, abs=1e-12)
    opposite = four_bar(ZeroExtreme(None, "3", complex(-sense))).motion(np.array([0.0]))
    mine, other = (np.angle(m.place("B")[0] - 0.2) for m in (motion, opposite))
    assert (mine > other) == (sense > 0)


@pytest.mark.parametrize("omega", [5.0, -5.0])
def test_positions_are_counted_in_the_sense_of_rotation(omega):
    cycle = offset_crank(ZeroAngle(0.3), omega)
    phi = cycle.phi(cycle.turned(12))
    assert phi == pytest.approx(0.3 + np.sign(omega) * np.arange(12) * math.pi / 6)


def test_extremes_and_stroke():
    cycle = offset_crank()
    low, high = cycle.extremes(place, speed)
    assert high.value == pytest.approx(math.sqrt((L + R) ** 2 - E**2), rel=1e-14)
    assert low.value == pytest.approx(math.sqrt((L - R) ** 2 - E**2), rel=1e-14)
    assert high.turned == pytest.approx(math.asin(E / (L + R)), abs=1e-12)


def test_extremes_of_the_highest_derivative_by_slope():
    """A centred crank with a long rod: a = −ω²(r cos φ + …) is greatest at φ = π."""
    cycle = offset_crank(offset=0.0)
    acceleration = lambda motion: motion.acceleration("B").real  # noqa: E731
    low, high = cycle.extremes(acceleration, Slope(acceleration))
    assert low.value == pytest.approx(-25 * R * (1 + R / L), rel=1e-12)
    assert low.turned == pytest.approx(0, abs=1e-6)
    fine = acceleration(cycle.motion(np.linspace(0, 2 * math.pi, 20001)))
    assert high.value == pytest.approx(fine.max(), rel=1e-7)
    assert high.value >= fine.max() * (1 - 1e-12)


@pytest.mark.parametrize("shift", [0.0, 0.5, 0.25])
def test_roots_on_the_grid_of_the_search(shift):
    """A root may lie exactly on a bracket's edge: it is found, and found once."""
    step = 2 * math.pi / 720
    start = math.asin(0.0) - 100 * step - shift * step
    cycle = offset_crank(ZeroAngle(start), offset=0.0)
    assert cycle.roots(speed) == pytest.approx(
        [(100 + shift) * step, math.pi + (100 + shift) * step], abs=1e-12
    )


def test_range_with_a_root_in_the_middle():
    """A rocking driver symmetric about a dead centre: the stroke is from its ends to the middle."""
    cycle = offset_crank(ZeroAngle(-0.5), sweep=1.0, offset=0.0)
    assert not cycle.closed
    assert cycle.roots(speed) == pytest.approx([0.5], abs=1e-12)
    low, high = cycle.extremes(place, speed)
    assert (high.value, high.turned) == pytest.approx((R + L, 0.5), rel=1e-12)
    assert low.turned in (0.0, 1.0)
    assert cycle.turned(4) == pytest.approx([0, 0.25, 0.5, 0.75, 1.0])


@pytest.mark.parametrize(
    "zero", [ZeroExtreme("O", None, 1 + 0j), ZeroExtreme("B", None, 1j), ZeroExtreme(None, "3", 1 + 0j)]
)
def test_what_does_not_move_has_no_extreme_position(zero):
    """A fixed point, a slider across its guide (whose rate is rounding, full of sign changes), a slider's turn."""
    with pytest.raises(ProblemError) as caught:
        offset_crank(zero)
    (problem,) = caught.value.problems
    assert problem.path == ("mechanism", "driver", "zero")
    assert "has no extreme position" in problem.text()


def test_roots_of_a_constant():
    cycle = offset_crank()
    assert cycle.roots(lambda motion: np.ones(motion.shape)).size == 0
    assert cycle.roots(lambda motion: np.zeros(motion.shape)).size == 0


def test_of_equal_extremes_the_first_is_named():
    """Two greatest values that differ by a bit, and the end of the turn beside its beginning."""
    values = np.array([np.nextafter(2.0, 3.0), -1.0, 2.0, -1.0 - 1e-15, np.nan])
    turned = np.array([5.0, 6.28, 1.0, 0.0, 3.0])
    low, high = least_and_greatest(values, turned)
    assert (low.turned, high.turned) == (0.0, 1.0)
    assert larger((Extreme(-2.0, 4.0), Extreme(np.nextafter(2.0, 3.0), 5.0))).turned == 4.0
    assert larger((Extreme(-2.0, 4.0), Extreme(2.1, 5.0))).turned == 5.0


def test_all_rates_together_are_each_alone():
    """What is found in one go is what is found one at a time."""
    cycle = offset_crank()
    acceleration = lambda motion: motion.acceleration("B").real  # noqa: E731
    rates = [speed, acceleration, Slope(acceleration)]
    for together, rate in zip(cycle.roots_of(rates), rates, strict=True):
        assert together == pytest.approx(cycle.roots(rate), abs=1e-9)
        assert len(together) == 2
