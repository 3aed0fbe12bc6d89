"""Near singular positions the program loses what conditioning takes, and no more: every kind of dyad, and class III.

The truth is of closed formulas in 130 digits (for class III of Newton's method in 60), the bound is by how much every
quantity changes when each number of the mechanism is rounded once (`benchmarks/near_singular/bound.py`).
"""

from __future__ import annotations

import numpy as np
import pytest
from exhaustive import many

from benchmarks.near_singular import ours
from benchmarks.near_singular.bound import EPS, bounded
from benchmarks.near_singular.closed import chain
from benchmarks.near_singular.runs import COUNT
from benchmarks.near_singular.scenes import OMEGA, SCENES
from tmm_report.chapters.lever.kinematics.checks.digits_left import digits_left
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.motion import SINGULAR

DISTANCES = (0.3, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12)
QUICK = ("rod = crank", "links in line", "flat yoke")
FACTOR = 10  # times the conditioning bound


def solved(name: str, distance: float, jitter: int = 1):
    scene = SCENES[name]
    cycle = scene.cycle(distance, jitter)
    found = cycle.motion(cycle.once(COUNT))
    values = ours.exact(scene, cycle, float(found.phi[-1]))
    with np.errstate(all="ignore"):
        return found, values, ours.misses(values, ours.found(scene, found))


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", many(sorted(SCENES, key=lambda name: name not in QUICK), len(QUICK)))
def test_places_rates_and_forces_are_within_ten_bounds(name):
    for distance in DISTANCES if name != "stretched triad" else DISTANCES[2:4]:
        found, _, misses = solved(name, distance)
        closeness = min(sine[-1] for sine in found.sines.values())
        for kind, miss in misses.items():
            if np.isnan(miss.times):  # a refusal: where the links are in line, or guides parallel to rounding
                assert closeness <= SINGULAR, (distance, kind)
            else:
                assert miss.times <= FACTOR, (distance, kind, miss)


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    "name", many(["rod = crank", "links in line", "tangent slot", "flat yoke", "parallel guides"], 2)
)
def test_the_digits_that_are_told_are_there(name):
    for distance in (1e-2, 1e-4, 1e-7):
        found, _, misses = solved(name, distance)
        told = digits_left(min(sine[-1] for sine in found.sines.values()))
        for kind in ("velocity", "acceleration", "force"):
            assert not misses[kind].error > 10.0**-told, (distance, kind)


def test_the_bound_of_a_root_that_merges_goes_with_one_over_the_distance():
    """B's place of a slider-crank is l·s along its guide, s² = 1 − (r/l)²: ε/s² of s, so ε/s of B."""
    conditions = []
    for distance in (1e-4, 1e-8):
        _, values, _ = solved("rod = crank", distance)
        conditions.append(
            float(values["acceleration", "2"].bound / abs(values["acceleration", "2"].exact) / EPS)
        )
    assert conditions[1] / conditions[0] == pytest.approx(1e4, rel=1e-2)


def test_the_exact_motion_is_that_of_doubles_far_from_singular_positions():
    found, values, _ = solved("links in line", 1.0)
    assert complex(values["velocity", "B"].exact) == pytest.approx(found.velocity("B")[-1], rel=1e-13)
    assert float(values["acceleration", "3"].exact) == pytest.approx(
        found.angular_acceleration("3")[-1], rel=1e-13
    )


def test_a_condition_number_of_one():
    """A point of the crank: its velocity is ω·r, off by what its arm and its angle are off."""
    cycle = SCENES["rod = crank"].cycle(0.5)
    m = cycle.linkage.mechanism

    def solve(mechanism, phi):
        pose = chain(mechanism, [1]).motion(phi, mechanism.driver.omega)
        return {("velocity", "A"): pose["1"].velocity(mechanism.links["1"].points["A"])}

    value = bounded(m, 1.0, solve)["velocity", "A"]
    assert abs(value.exact) == pytest.approx(OMEGA * abs(m.links["1"].points["A"]), rel=1e-15)
    # the arm's length and direction, √2; the angle, 1 rad; the rounding of the value itself
    assert value.condition == pytest.approx(np.sqrt(2) + 1 + 1, rel=1e-6)


def test_a_loss_in_the_solver_would_be_seen(monkeypatch):
    """A rod turned by a billionth of a radian: ten bounds are not kept."""
    usual = motion.Dyad.place

    def blunt(d, s):
        usual(d, s)
        s.u[d.a] = s.u[d.a] * np.exp(1e-9j)

    monkeypatch.setattr(motion.Dyad, "place", blunt)
    assert solved("links in line", 1e-2)[2]["velocity"].times > FACTOR
