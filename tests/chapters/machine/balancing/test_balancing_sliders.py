"""Slider-cranks within a mechanism: harmonics of the slider against its solved motion, Lanchester's rotors."""

import math
from dataclasses import replace

import numpy as np
import pytest
from conftest import examples, read, solved
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report import course
from tmm_report.chapters.lever.moving import Moving
from tmm_report.chapters.machine.balancing.given import Given
from tmm_report.chapters.machine.balancing.solve.whole import Found, solve
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.masses import slider_harmonics


def found_in(name: str, **links) -> Found:
    """A variant, some of its links otherwise, with nothing balanced but its sliders."""
    lever = read(name).lever
    mechanism = replace(lever.mechanism, links={**lever.mechanism.links, **links})
    given_ = replace(lever, mechanism=mechanism, readings={}, loads=None, friction=None)
    kinematics = course.solve_lever(given_).kinematics
    return solve(Given(("rotors",), rotors={"first": 0.05, "second": 0.04}), Moving(kinematics, None))


# ---------------------------------------------------------------- the series


@settings(max_examples=examples(60))
@given(st.floats(0.05, 0.6), st.floats(-0.3, 0.3))
def test_harmonics_add_up_to_the_acceleration(lam, offset):
    """Against differences of x = cos φ + cos β/λ."""
    phi, h = np.linspace(0, 2 * math.pi, 25), 1e-3

    def place(at):
        return np.cos(at) + slider_harmonics.rod_cosine(lam, at, offset) / lam

    harmonics = slider_harmonics.acceleration_harmonics(lam, 60, offset)
    # of the fourth order of the step
    second = (
        -place(phi + 2 * h) + 16 * place(phi + h) - 30 * place(phi) + 16 * place(phi - h) - place(phi - 2 * h)
    ) / 12
    assert np.allclose(harmonics.at(phi), -second / h**2, atol=2e-7)


@settings(max_examples=examples(60))
@given(st.one_of(st.floats(0.01, 0.95), st.floats(0.95, 0.9999)), st.sampled_from([2, 4, 6]))
def test_exact_coefficients_by_two_ways(lam, order):
    """Closed, and by sums over equal steps of the turn, fine enough for the kink of a rod near the crank's length."""
    phi = np.arange(8192) * (2 * np.pi / 8192)
    sums = fourier.series(slider_harmonics.rod_cosine(lam, phi), order).cosine[order]
    exact = slider_harmonics.root_exact(lam, order)
    assert exact == pytest.approx(float(sums), abs=1e-13)
    assert slider_harmonics.acceleration_exact(lam, order) == pytest.approx(order**2 * exact / lam, rel=1e-14)


@pytest.mark.parametrize("lam", [1e-4, 0.0025, 0.02])
def test_small_coefficients_of_a_long_rod_do_not_drown_in_rounding(lam):
    """Orders 4 and 6 of a rod of many cranks fall to 1e-20; the power series is as good there."""
    found = slider_harmonics.acceleration_harmonics(lam, 6)
    for order in (2, 4, 6):
        assert found.cosine[order] == pytest.approx(
            slider_harmonics.acceleration_series(lam, order, 4), rel=1e-12
        )
    assert not found.sine.any()


@settings(max_examples=examples(60))
@given(st.floats(0.05, 0.4), st.sampled_from([2, 4, 6]), st.integers(1, 3))
def test_a_term_more_brings_the_series_nearer(lam, order, terms):
    exact = slider_harmonics.acceleration_exact(lam, order)
    short, long = (slider_harmonics.acceleration_series(lam, order, n) for n in (terms, terms + 1))
    assert abs(long - exact) < abs(short - exact)


def test_first_terms_are_those_of_the_textbooks():
    lam = 0.3
    assert slider_harmonics.acceleration_series(lam, 2, 2) == pytest.approx(lam + lam**3 / 4, rel=1e-14)
    assert slider_harmonics.acceleration_series(lam, 4, 2) == pytest.approx(
        -(lam**3) / 4 - 3 * lam**5 / 16, rel=1e-14
    )
    assert slider_harmonics.acceleration_series(lam, 6, 1) == pytest.approx(9 * lam**5 / 128, rel=1e-14)
    longer = 1 / lam  # the lectures' λ = l/r
    assert slider_harmonics.root_series(lam, 2, 2) == pytest.approx(
        1 / (4 * longer**2) + 1 / (16 * longer**4), rel=1e-14
    )
    assert slider_harmonics.root_series(lam, 4, 1) == pytest.approx(-1 / (64 * longer**4), rel=1e-14)


def test_no_odd_orders_and_no_sines_without_an_offset():
    central = slider_harmonics.acceleration_harmonics(1 / 3, 7)
    aside = slider_harmonics.acceleration_harmonics(1 / 3, 7, 0.1)
    assert np.abs(central.sine).max() < 1e-13 and np.abs(central.cosine[[3, 5, 7]]).max() < 1e-13
    assert abs(aside.sine[1]) > 1e-3 and abs(aside.sine[3]) > 1e-3


# ---------------------------------------------------------------- within a mechanism


@pytest.mark.parametrize("name", ["compressor", "slider_crank_offset", "v_engine", "compressor_inline"])
def test_sum_of_the_orders_is_the_solved_acceleration(name):
    """Whatever the guide's direction, the sense of rotation, the offset, the names."""
    found = found_in(name)
    assert found.cranks
    for crank in found.cranks:
        motion = found.kinematics.table
        phi = crank.angle(found.kinematics.turned)
        harmonics = slider_harmonics.acceleration_harmonics(crank.lam, 40, crank.offset / crank.l)
        ours = -crank.r * motion.omega**2 * harmonics.at(phi)
        solved_ = dot(motion.acceleration(crank.joint), crank.along)
        assert np.allclose(ours, solved_, rtol=0, atol=1e-10 * np.abs(solved_).max())


def test_a_mechanism_without_a_slider_crank_has_none():
    assert not found_in("crank_rocker").cranks
    assert not found_in("piston_pump").cranks


def test_offset_is_of_the_guide_from_the_pivot():
    """20 mm above the pivot, the crank turning counter-clockwise; below, if it turned clockwise."""
    crank = found_in("slider_crank_offset").cranks[0]
    assert crank.offset == pytest.approx(0.02, rel=1e-12)
    assert (crank.pivot, crank.pin, crank.joint) == ("O", "A", "B")


# ---------------------------------------------------------------- Lanchester


@pytest.mark.parametrize("name", ["compressor", "compressor_inline"])
def test_remainder_is_of_the_fourth_order(name):
    found = found_in(name)
    for crank, remains in zip(found.cranks, found.cycle_remains, strict=True):
        left = fourier.series(remains.second, 6).amplitude
        assert left[:4].max() < 1e-10 * np.abs(remains.exact).max()
        expected = crank.mass * crank.r * found.kinematics.omega**2
        assert left[4] == pytest.approx(
            expected * abs(slider_harmonics.acceleration_exact(crank.lam, 4)), rel=1e-9
        )


def test_offset_leaves_the_third_order():
    remains = found_in("slider_crank_offset").cycle_remains[0]
    left = fourier.series(remains.second, 6).amplitude
    assert left[1:3].max() < 1e-10 * np.abs(remains.exact).max() < left[3]


def test_rotors_are_those_of_the_lecture():
    """m_I = m_B r/(2 r_I), m_II = λ A₂ m_B r/(2 r_II) with λ = l/r and A₂ the lecture's."""
    found = found_in("compressor")
    crank = found.cranks[0]
    longer, lectures = 1 / crank.lam, slider_harmonics.root_exact(crank.lam, 2)
    values = {value.key: value.value for value in course.room("balancing", "quantities").values(found)}
    assert values["slider_m_I_3"] == pytest.approx(crank.mass * crank.r / (2 * 0.05), rel=1e-12)
    assert values["slider_m_II_3"] == pytest.approx(
        longer * lectures * crank.mass * crank.r / (2 * 0.04), rel=1e-10
    )


def test_two_pairs_of_rotors_make_the_first_and_second_order():
    """2 m_I r_I ω² cos φ and 2 m_II r_II (2ω)² cos 2φ, summed as turning vectors."""
    found = found_in("compressor")
    crank, omega = found.cranks[0], found.kinematics.omega
    phi = crank.angle(found.kinematics.turned)
    pairs = [
        crank.product(k) * (k * omega) ** 2 * (np.exp(1j * k * phi) + np.exp(-1j * k * phi)) for k in (1, 2)
    ]
    remains = found.remains[0]
    assert np.allclose(
        remains.exact - remains.second, sum(pairs).real, rtol=0, atol=1e-9 * crank.force(omega, 1)
    )
    assert np.abs(sum(pairs).imag).max() < 1e-9 * crank.force(omega, 1)  # nothing across the guide


def test_a_single_cylinder_with_lanchester_and_a_crank_counterweight_shakes_by_the_fourth_order():
    """An in-line slider-crank with its rod's centre between its joints: all four rotors, by the whole force."""
    lever = read("slider_crank_offset").lever
    rod = lever.mechanism.links["2"]
    guides = {name: replace(guide, through=0j) for name, guide in lever.mechanism.guides.items()}
    straight = replace(rod, points={**rod.points, "S2": 0.08 + 0j})
    mechanism = replace(lever.mechanism, links={**lever.mechanism.links, "2": straight}, guides=guides)
    kinematics = course.solve_lever(replace(lever, mechanism=mechanism, readings={}, loads=None)).kinematics
    found = solve(Given(("rotors",), rotors={"first": 0.05, "second": 0.04}), Moving(kinematics, None))
    left = np.abs(fourier.turning(found.cases[-1].cycle.force, 5))
    size = found.original.force_max.value
    assert np.delete(left, [1, 9]).max() < 1e-10 * size  # all but ±4
    assert left[1] > 1e-4 * size and left[9] == pytest.approx(left[1], rel=1e-9)


def test_reciprocating_mass_is_the_slider_with_its_share_of_the_rod():
    found = found_in("compressor")
    assert found.cranks[0].mass == found.substituted.sliding["3"]
    assert solved("compressor").lever is not None
    # half of rod 2, a quarter of what rod 4 leaves at C, and the piston
    assert found.cranks[0].mass == pytest.approx(0.75 + 0.775 * 0.25 + 0.6, rel=1e-12)
