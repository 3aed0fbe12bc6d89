"""Groups of class III drawn by lines through a special point of the basis link, of random mechanisms."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest
from conftest import examples
from higher_schemes import drawn
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tmm_report.chapters.lever.kinematics.quantities import rates
from tmm_report.chapters.lever.plans.drafting import Plan, Scales, acceleration_plan, velocity_plan
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import cycle_of
from tmm_report.mechanics.lever.vector_equations import named_values
from tmm_report.problems import ProblemError
from tmm_report.quantity.paper import Pen, round_scale

FINE = Pen(1e-5)  # a computer's drawing: lengths are read to 0.01 mm
LEGS = {"turning": (), "on a guide": (1,), "guide on the basis": (3,), "both": (2, 3), "two blocks": (3, 4)}


class Found(NamedTuple):
    """A position of a random mechanism, its analytical values, its plans."""

    motion: motion.Motion
    values: dict[str, np.ndarray]
    velocity: Plan
    acceleration: Plan


def plans(seed: int, sliding: tuple[int, ...]) -> Found | None:
    """None where the mechanism does not go round, or is near a singular position."""
    try:
        cycle = cycle_of(assemble(drawn("III3", seed, sliding).mechanism()))
    except ProblemError:
        return None
    if any(critical.gaps or critical.changes for critical in cycle.critical):
        return None
    found = motion.solve(cycle.linkage, np.array([0.3 + seed % 6]))
    values, named = named_values(found), rates(cycle.linkage)
    if any(sine.min() <= 0.05 for sine in found.sines.values()) or not all(
        np.isfinite(x).all() for x in values.values()
    ):
        return None

    def scale(unit: str) -> float:
        return round_scale(
            max(float(np.abs(x).max()) for key, x in values.items() if named[key].unit == unit), 150
        )

    scales = Scales(0.01, scale("m/s"), scale("m/s²"))
    velocity = velocity_plan(found, 0, scales, FINE, named)
    return Found(found, values, velocity, acceleration_plan(found, 0, scales, FINE, named, velocity))


seeds = st.integers(0, 5000)


@pytest.mark.parametrize("legs", LEGS)
@settings(max_examples=examples(8))
@given(seed=seeds)
def test_what_is_read_off_is_the_analytical_value(legs, seed):
    found = plans(seed, LEGS[legs])
    assume(found is not None and found.velocity.steps[-1].special)
    for plan in (found.velocity, found.acceleration):
        for key, number in plan.signed.items():
            exact = found.values[key][0] if key[0] in "we" else abs(found.values[key][0])
            allowed = 2 * FINE.read_step * plan.per_mm[key] + 3e-5 * abs(exact)
            # a normal acceleration is worked from a velocity that was read, its error grows with the velocity's
            allowed *= 1 if plan.kind == "v" else 4
            assert number == pytest.approx(exact, abs=allowed), (key, plan.kind)


@pytest.mark.exhaustive
@pytest.mark.parametrize("legs", ["turning", "guide on the basis"])
def test_most_mechanisms_can_be_drawn_so(legs):
    found = [one for one in (plans(seed, LEGS[legs]) for seed in range(8)) if one is not None]
    drawn_so = [one.velocity.steps[-1].special is not None for one in found]
    assert len(found) >= 3 and sum(drawn_so) >= 0.5 * len(found)
    for plan in (plan for one in found for plan in (one.velocity, one.acceleration)):
        assert all((step.special is None) != (step.projections is None) for step in plan.steps)


@pytest.mark.exhaustive
@settings(max_examples=examples(10))
@given(seed=seeds)
def test_the_special_point_is_where_the_lines_of_two_legs_cross(seed):
    """Its place on the scheme, from its place in the plan by similarity, lies on both lines."""
    found = plans(seed, ())
    assume(found is not None and found.velocity.steps[-1].special)
    velocity, special = found.velocity, found.velocity.steps[-1].special
    assert special.link == "2"
    z, third, turn = (
        velocity.vertices[special.letter],
        velocity.vertices[special.third.lower()],
        velocity.turns["2"],
    )
    place = found.motion.place(special.third)[0] - (third - z) / turn
    for line in special.lines:
        start, end = (found.motion.place(point)[0] for point in (line.ends[:2], line.ends[2:]))
        assert cross(place - start, (end - start) / abs(end - start)) == pytest.approx(0, abs=0.005)
    told = complex(*(float(x.number) for x in special.place))
    assert abs(told - place) < 0.01  # m, of a scheme at 10 mm a millimetre of paper
    drawn_lines = [stroke for stroke in velocity.strokes if stroke.role == "line"]
    assert len(drawn_lines) == 3 and drawn_lines[0].end == drawn_lines[1].end == z
