"""Published examples of the harmonics of a slider: the short formula of the rod's cosine, coefficients of λ = 1/3."""

import math

import pytest
from cases import agrees, case
from notes import VARIANTS

from tmm_report import course, loading
from tmm_report.mechanics.masses import slider_harmonics


def test_short_formula_of_the_rods_cosine():
    """The error of 1 − x/2 for √(1 − x) where the crank stands across the guide."""
    of = case("nptel-cosbeta")["inputs"]
    phi = math.radians(of["theta_deg"])
    exact, short = (
        slider_harmonics.rod_cosine(of["lam"], phi),
        slider_harmonics.rod_cosine_short(of["lam"], phi),
    )
    agrees("nptel-cosbeta", error_percent=100 * (short / exact - 1))


def coefficients(lam):
    """By three ways: product of binomial series, sums over a turn, power series in λ with many terms."""
    harmonics = slider_harmonics.acceleration_harmonics(lam, 6)
    return [
        [slider_harmonics.acceleration_exact(lam, k) for k in (2, 4, 6)],
        [float(harmonics.cosine[k]) for k in (2, 4, 6)],
        [slider_harmonics.acceleration_series(lam, k, 40) for k in (2, 4, 6)],
    ]


@pytest.mark.parametrize("way", range(3))
def test_coefficients_of_a_third(way):
    name = "own-slider-harmonics-1-3"
    lam = case(name)["inputs"]["lam"]
    agrees(name, **dict(zip(("A2", "A4", "A6"), coefficients(lam)[way], strict=True)))


def test_compressor_of_a_third_says_them_in_its_results():
    """The compressor has r/l = 100/300."""
    found = course.solve(loading.load(VARIANTS / "compressor.yaml")).balancing
    table = next(
        t for t in course.room("balancing", "quantities").tables(found) if t.name == "slider_harmonics_3"
    )
    by_order = dict(zip(table["order"].values, table["A"].values, strict=True))
    agrees("own-slider-harmonics-1-3", A2=by_order[2], A4=by_order[4], A6=by_order[6])
