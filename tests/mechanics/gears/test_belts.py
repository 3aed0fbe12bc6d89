"""Belts about two pulleys: the length against the outline measured point by point, the distance against the length."""

import math

import numpy as np
import pytest

from tmm_report.mechanics.gears import belts

PULLEYS = [
    (one, other, times * (one + other), crossed)
    for one, other in ((0.1, 0.2), (0.25, 0.09), (0.15, 0.15))
    for times in (0.55, 1.0, 3.0)
    for crossed in (False, True)
]


def hull(one: float, other: float, distance: float, steps: int = 200_000) -> float:
    """Length of the convex outline of two circles: by Cauchy's formula the integral of their support function."""
    phi = np.linspace(0, 2 * np.pi, steps, endpoint=False)
    support = np.maximum(one / 2, distance * np.cos(phi) + other / 2)
    return float(support.mean() * 2 * np.pi)


def crossing(one: float, other: float, distance: float, steps: int = 200_000) -> float:
    """Both strands of a crossed belt and the arcs: a strand goes from a point of the one circle to that of the other
    straight across, and is square to both radii there."""
    phi = np.linspace(0, np.pi / 2, steps)
    way = distance - (one + other) / 2 * np.exp(1j * phi)
    at = phi[np.argmin(np.abs(np.real(way * np.exp(-1j * phi))))]
    return float(2 * abs(distance - (one + other) / 2 * np.exp(1j * at)) + (one + other) * (np.pi - at))


@pytest.mark.parametrize(("one", "other", "distance", "crossed"), PULLEYS)
def test_the_length_is_that_of_the_outline(one, other, distance, crossed):
    measured = (crossing if crossed else hull)(one, other, distance)
    assert belts.length(one, other, distance, crossed) == pytest.approx(
        measured, rel=1e-8 if not crossed else 1e-4
    )


def test_the_distance_gives_the_length_back_thousands_of_times():
    random = np.random.default_rng(5)
    for one, other, gap, crossed in zip(
        random.uniform(0.03, 1, 3000), random.uniform(0.03, 1, 3000), random.uniform(1.001, 8, 3000),
        random.random(3000) < 0.4, strict=True,
    ):  # fmt: skip
        distance = gap * (one + other) / 2
        belt = belts.length(one, other, distance, bool(crossed))
        assert belts.distance(one, other, belt, bool(crossed)) == pytest.approx(distance, rel=1e-12)


def test_a_belt_that_is_too_short_has_no_distance():
    assert math.isnan(belts.distance(0.1, 0.3, 0.9, False)) and math.isnan(
        belts.distance(0.1, 0.1, 0.3, False)
    )
    assert math.isnan(belts.distance(0.1, 0.1, 0.6, True))
    assert math.isnan(belts.length(0.1, 0.5, 0.1, False))


@pytest.mark.parametrize("crossed", [False, True])
def test_a_belt_about_pulleys_that_would_meet_has_no_distance(crossed):
    """Of pulleys of 100 and 200 mm those that touch are 150 mm apart."""
    touching = belts.length(0.1, 0.2, (0.1 + 0.2) / 2, crossed)
    assert math.isnan(belts.distance(0.1, 0.2, touching * 0.999, crossed))
    assert belts.distance(0.1, 0.2, touching * 1.001, crossed) > 0.15


@pytest.mark.parametrize(
    ("size", "row"),
    [(0.197, 0.2), (1.2775, 1.25), (1.06, 1.0), (9.6, 10.0), (0.0995, 0.1), (335.0, 315.0), (336.0, 355.0)],
)
def test_preferred_numbers(size, row):
    assert belts.preferred(size) == row
