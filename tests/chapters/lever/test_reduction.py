"""Reduced moments: equality of energy and of power, the derivative, the balancing moment of the force analysis."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from conftest import read, solved, stating
from notes import VARIANTS

from tmm_report import course
from tmm_report.chapters.lever.kinematics.given import Positions
from tmm_report.chapters.lever.kinetostatics.solve.positions import external_power, kinetic_energy
from tmm_report.problems import ProblemError

FINE = 720


@pytest.fixture
def reduced(variant) -> course.LeverFound:
    """Every ready mechanism that has masses, reduced."""
    if not any(link.mass or link.inertia for link in variant.lever.mechanism.links.values()):
        pytest.skip("nothing to reduce")
    return course.solve_lever(stating(variant, reduction=True, readings={}).lever)


def test_energy_of_the_links_is_that_of_the_reduced_disc(reduced):
    motion = reduced.kinematics.diagram
    energy = reduced.reduction.diagram.whole_inertia * motion.omega**2 / 2
    assert np.allclose(energy, kinetic_energy(motion), rtol=1e-12, equal_nan=True)


def test_power_of_the_loads_is_that_of_the_reduced_moment(reduced):
    found = reduced.kinetostatics
    if found is None:
        assert reduced.reduction.diagram.moments == ()
        return
    solved_ = found.diagram
    power = external_power(found.given, solved_.motion, solved_.loading)
    ours = reduced.reduction.diagram.whole_moment * solved_.motion.omega
    scale = np.nanmax(np.abs(power), initial=1e-300)
    assert np.allclose(ours, power, rtol=0, atol=1e-12 * scale, equal_nan=True)


def test_balancing_moment_follows_from_both(reduced):
    if reduced.kinetostatics is not None:
        assert reduced.reduction.disagreement < 1e-9


@pytest.mark.parametrize("name", ["compressor", "piston_pump", "shaper", "whitworth"])
def test_slope_is_the_derivative(name):
    """Of a periodic smooth function the trigonometric interpolation is exact to rounding."""
    given = replace(solved(name).variant.lever, reduction=True, readings={}, loads=None, friction=None)
    given = replace(given, positions=Positions(table=12, diagram=FINE, plans=(), force_plan=()))
    found = course.solve_lever(given).reduction.diagram
    inertia, slope = found.whole_inertia[:-1], found.slope[:-1]
    spectrum = np.fft.rfft(inertia) * 1j * np.arange(FINE // 2 + 1)
    spectrum[-1] = 0
    sense = math.copysign(1, given.mechanism.driver.omega)
    assert np.allclose(np.fft.irfft(spectrum, FINE) * sense, slope, rtol=0, atol=1e-8 * np.abs(slope).max())


def test_parts_add_up(reduced):
    one = reduced.reduction.table
    assert np.allclose(sum(one.inertia.values()), one.whole_inertia, rtol=1e-14, equal_nan=True)
    assert all(np.nanmin(part) >= 0 for part in one.inertia.values())


def test_nothing_to_reduce_is_told():
    text = VARIANTS.joinpath("crank_rocker.yaml").read_text(encoding="utf-8")
    light = re.sub(r"\b(mass|mass_centre|inertia): [^,}\n]*,? ?", "", text.split("\nloads:")[0])
    with pytest.raises(ProblemError) as error:
        course.loads(light + "\nreduction: true\n")
    assert [problem.path for problem in error.value.problems] == [("reduction",)]


def test_plans_of_velocities_give_the_same_inertia_to_their_accuracy():
    """Ratios are read to a hundredth of a millimetre of some hundred."""
    found = solved("piston_pump").lever.reduction
    assert [one.position for one in found.plans] == [
        d.position for d in solved("piston_pump").lever.plans.drawn
    ]
    for one in found.plans:
        assert one.graph != one.exact == found.table.whole_inertia[one.position]
        assert one.graph == pytest.approx(one.exact, rel=1e-3)
        assert one.delta == pytest.approx(100 * (one.graph / one.exact - 1), rel=1e-2)


@pytest.mark.exhaustive
def test_the_speed_for_which_a_plan_is_drawn_does_not_matter():
    """Ten times the speed at ten times the scale: the same lengths, the same ratios."""
    variant = read("piston_pump")
    mechanism = variant.lever.mechanism
    fast = replace(mechanism, driver=replace(mechanism.driver, omega=10 * mechanism.driver.omega))
    slow, quick = (
        course.solve(
            stating(
                variant, mechanism=one, drawing=replace(variant.lever.drawing, velocity=scale), readings={}
            )
        )
        for one, scale in ((mechanism, 0.02), (fast, 0.2))
    )
    for one, other in zip(slow.lever.reduction.plans, quick.lever.reduction.plans, strict=True):
        assert one.graph == pytest.approx(other.graph, rel=1e-12)
        assert dict(one.centres) == pytest.approx(dict(other.centres), rel=1e-12)
