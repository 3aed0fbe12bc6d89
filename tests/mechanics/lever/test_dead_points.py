"""Dead points to the last digit: up to a corner, beside limits and change points, and by twos within a step."""

from __future__ import annotations

import numpy as np
import pytest
import schemes
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.brackets import dips, lowest
from tmm_report.mechanics.lever.assur_groups import decompose
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.lever.mechanism import Guide, Link, Slide
from tmm_report.mechanics.lever.motion import linkage_of


def four_bar(crank: float, rod: float, rocker: float, frame: float, sign: int) -> Cycle:
    links = [
        Link("0", {"O": 0j, "C": frame + 0j}),
        Link("1", {"O": 0j, "A": crank + 0j}),
        Link("2", {"A": 0j, "B": rod + 0j}),
        Link("3", {"C": 0j, "B": rocker + 0j}),
    ]
    return cycle_of(linkage_of(decompose(schemes.mechanism(links)), [sign]))


def slider_crank(crank: float, rod: float, offset: float, sign: int = 1) -> Cycle:
    links = [
        Link("0", {"O": 0j}),
        Link("1", {"O": 0j, "A": crank + 0j}),
        Link("2", {"A": 0j, "B": rod + 0j}),
        Link("3", {"B": 0j}),
    ]
    made = schemes.mechanism(links, [Guide("x", "0", 1j * offset, 1 + 0j)], [Slide("3", "x")])
    return cycle_of(linkage_of(decompose(made), [sign]))


def velocity(motion):
    return motion.velocity("B").real


def in_line(crank: float, rod: float, rocker: float, frame: float, sign: int) -> np.ndarray:
    """Where crank and rod lie in one line and the rocker reaches their end, by the law of cosines."""
    found = []
    for far, way in ((crank + rod, 0.0), (abs(crank - rod), 0.0 if crank > rod else np.pi)):
        cosine = (far**2 + frame**2 - rocker**2) / (2 * far * frame)
        for angle in (np.arccos(cosine), -np.arccos(cosine)) if abs(cosine) < 1 else ():
            turned = np.mod(angle + way, 2 * np.pi)
            A, B = crank * np.exp(1j * turned), far * np.exp(1j * angle)
            if np.sign(((frame - A).conjugate() * (B - A)).imag) == sign:
                found.append(turned)
    return np.sort(found)


@pytest.mark.parametrize(
    "crank", [0.05, 0.09, 0.099, 0.0999, 0.09999, 0.099999, 0.0999999, 0.09999999, 0.0999999999]
)
def test_the_slider_turns_back_in_the_corner_in_which_the_rod_just_passes(crank):
    """The rod just reaches across the guide at 270°: the slider comes there and goes back at once."""
    cycle = slider_crank(crank, 0.1, 0.1 - crank)
    first, corner = cycle.roots(velocity)
    assert first == pytest.approx(np.arcsin((0.1 - crank) / (0.1 + crank)), abs=1e-9)
    assert corner == pytest.approx(3 * np.pi / 2, abs=1e-7)


@pytest.mark.parametrize("crank", [0.05, 0.09, 0.0999, 0.0999999])
@pytest.mark.parametrize("less", [1e-4, 1e-6])
def test_a_little_beside_the_corner_the_dead_point_is_where_crank_and_rod_fold(crank, less):
    offset = (0.1 - crank) * (1 - less)
    _, folded = slider_crank(crank, 0.1, offset).roots(velocity)
    assert folded == pytest.approx(np.pi + np.arcsin(offset / (0.1 - crank)), abs=1e-7)


@pytest.mark.parametrize("sign, end", [(1, 1), (-1, 1)])
def test_both_sides_of_a_corner_count_among_the_extremes(sign, end):
    """On one side of it the slider has the speed (1 + √(l/r))·r·ω, on the other (√(l/r) − 1)·r·ω, both away from it."""
    crank, rod = 0.0999, 0.1
    cycle = slider_crank(crank, rod, rod - crank, sign)
    greatest = cycle.extremes(velocity, lambda m: m.acceleration("B").real)[end]
    assert greatest.value == pytest.approx(schemes.OMEGA * crank * (1 + np.sqrt(rod / crank)), rel=1e-6)
    assert greatest.turned == pytest.approx(3 * np.pi / 2, abs=1e-6)
    assert cycle.corners == pytest.approx([3 * np.pi / 2], abs=1e-7)


LENGTHS = st.floats(0.3, 3.0)


@pytest.mark.exhaustive
@settings(max_examples=60, deadline=None)
@given(
    LENGTHS,
    LENGTHS,
    LENGTHS,
    LENGTHS,
    st.sampled_from([1, -1]),
    st.integers(0, 5),
    st.floats(-10, -2),
    st.booleans(),
)
def test_dead_points_of_four_bars_near_kites_and_parallelograms(a, b, c, d, sign, kind, power, less):
    """Against the law of cosines, from ordinary ones to those a hair beside a change point."""
    beside = (-1 if less else 1) * 10**power
    if kind == 1:
        c = a + b - d + beside
    elif kind == 2:
        d = a + b - c + beside
    elif kind == 3:
        d = a + c - b + beside
    elif kind == 4:
        b, c = d, a * (1 + beside)
    elif kind == 5:
        d, c = a * (1 + beside), b
    assume(min(a, b, c, d) > 0.05 and abs(a - b) > 1e-3)
    cycle = four_bar(a, b, c, d, sign)
    assume(not any(one.changes for one in cycle.critical))  # its two assemblies can then not be told apart
    found, wanted = cycle.roots(lambda motion: motion.angular_velocity("3")), in_line(a, b, c, d, sign)
    assert len(found) == len(wanted)
    off = np.abs(np.angle(np.exp(1j * (np.array(found) - wanted))))
    assert off.max(initial=0.0) < 1e-6


@pytest.mark.parametrize("apart", [3e-3, 1e-4, 1e-5])
@pytest.mark.parametrize("middle", [0.1234, 0.0, 3.0])
def test_two_roots_nearer_than_a_step_of_the_search(apart, middle):
    """cos(φ − middle) comes to its top just above a level: no sign changes between the steps."""
    cycle = four_bar(0.5, 2.0, 1.5, 2.2, 1)
    level = 2 * np.sin(apart / 2) ** 2  # 1 − cos

    def rate(motion):
        return np.cos(motion.phi - middle) - 1 + level

    found = np.sort(np.angle(np.exp(1j * (cycle.roots(rate) - middle))))
    assert found == pytest.approx([-apart, apart], rel=1e-2)


def test_a_top_below_the_level_has_no_roots():
    cycle = four_bar(0.5, 2.0, 1.5, 2.2, 1)
    assert cycle.roots(lambda motion: np.cos(motion.phi - 0.3) - 1 - 1e-9).size == 0


def test_the_lowest_point_of_a_dip():
    x = np.array([[0.0], [0.5], [1.2]])
    at, value = lowest(lambda x: (x - 0.7) ** 2 + 1e-12, x, (x - 0.7) ** 2 + 1e-12)
    assert at == pytest.approx([0.7], abs=1e-6) and value == pytest.approx([1e-12], rel=0.1)


def test_only_what_comes_near_zero_beside_its_neighbours_is_a_dip():
    values = np.array([3.0, 2.0, 1.0, 2.0, 3.0, 1.0, 0.01, 1.0, 3.0])
    assert np.flatnonzero(dips(values, 1e-9)).tolist() == [6]
    assert np.flatnonzero(dips(-values, 1e-9)).tolist() == [6]
    assert not dips(1e-12 * values, 1e-9).any()
