"""Plans are constructions: they agree with the analytical values within the drawing's accuracy, and no better."""

from dataclasses import replace
from functools import cache
from itertools import combinations

import numpy as np
import pytest
from conftest import read, stating
from exhaustive import many

from tmm_report import course
from tmm_report.chapters.lever.plans.solve import Comparison, Drawn
from tmm_report.quantity.paper import CAD

# How many reading steps a value may be off. At 0.01 mm the construction is exact and a value is read once, rounded
# to half a step; the numbers written by hand (five digits) add up to a step more. At 0.1 and 0.5 mm every point of
# the scheme and of the plan is placed to the accuracy too (up to 0.7 step each way): see `steps`.
EXACT = 2.0
MOST = 12.0
DOT = 8.0  # mm of paper: shorter links are drawn with no direction to speak of
FORCE_STEPS = {1e-5: 4.0, 1e-4: 6.0, 5e-4: 6.0}


@cache
def drawn(variant, accuracy) -> course.Results:
    """All table positions drawn, loads as they are."""
    every = tuple(range(variant.lever.positions.table))
    positions = replace(variant.lever.positions, plans=every, force_plan=every)
    drawing = replace(variant.lever.drawing, accuracy=accuracy)
    return course.solve(stating(variant, positions=positions, drawing=drawing, readings={}))


def steps(found: course.Results, d: Drawn) -> float:
    """How many reading steps a value of these plans may be off.

    Points of the plan add up to some 4 steps. The ends of a link of L mm, drawn off by a step, turn its line by 1/L:
    the end of a vector of V mm moves by V/L steps, by V/(L s) where the lines that give it cross at an angle of sine s.
    It hardly comes to that; how much it may come to grows with links that are but dots on the sheet.
    """
    if found.lever.plans.accuracy <= CAD * 1e3:
        return EXACT
    strokes = (*d.velocity.strokes, *d.acceleration.strokes)
    longest = max(abs(stroke.end - stroke.start) for stroke in strokes)
    sine = min(sines[d.position] for sines in found.lever.kinematics.table.sines.values())
    arm = shortest_arm(found)
    return min(MOST * max(1.0, DOT / arm), 4.0 + longest / (arm * sine))


def shortest_arm(found: course.Results) -> float:
    """The shortest distance between two joints of a moving link, mm of paper."""
    mechanism = found.variant.lever.mechanism
    places = (
        [z for point, z in mechanism.links[link].points.items() if len(mechanism.links_at(point)) > 1]
        for link in mechanism.moving
    )
    arms = (abs(p - q) for joints in places for p, q in combinations(joints, 2))
    return min((arm for arm in arms if arm > 0), default=np.inf) / found.lever.plans.length_scale


def plan_errors(found: course.Results) -> dict[tuple[int, str], float]:
    """Error of every plan value in reading steps."""
    return {
        (d.position, c.key): abs(c.graph - c.analytic) / c.floor
        for d in found.lever.plans.drawn
        for c in d.comparison
        if c.floor
    }


def force_errors(found: course.Results) -> dict[tuple[int, str], float]:
    """Error of every reaction in steps of the coarsest force plan it went through, of moments in their own; a gear's
    force is the moment by its base radius, and the pivot of its link feels a step of both."""
    errors = {}
    driver = found.variant.lever.mechanism.driver
    for d in found.lever.force_plans.drawn:
        coarsest = max(plan.scale for plan in d.plans) * found.lever.plans.accuracy
        of_moment = next(c.floor for c in d.comparison if c.key == "M_bal")
        for c in d.comparison:
            step = of_moment if c.key == "M_bal" else coarsest
            if driver.gear is not None and c.key == f"R_0{driver.link}":
                step += of_moment / float(driver.gear.base_radius)
            errors[d.position, c.key] = abs(c.graph - c.analytic) / step
    return errors


@pytest.mark.parametrize("accuracy", many(FORCE_STEPS))
def test_plans_agree_with_the_analytical_values(variant, accuracy):
    found = drawn(variant, accuracy)
    assert len(found.lever.plans.drawn) == len(found.lever.force_plans.drawn) == variant.lever.positions.table
    allowed = {d.position: steps(found, d) for d in found.lever.plans.drawn}
    wrong = {key: x for key, x in plan_errors(found).items() if not x <= allowed[key[0]]}
    wrong |= {key: x for key, x in force_errors(found).items() if not x <= FORCE_STEPS[accuracy]}
    assert not wrong


@pytest.mark.exhaustive
def test_a_coarser_pencil_draws_worse(variant):
    """Errors grow with the accuracy: at 0.5 mm this is a drawing, not the analytical values printed again."""

    def size(accuracy):
        found = drawn(variant, accuracy)
        errors = [plan_errors(found), force_errors(found)]
        return [float(np.mean(list(e.values()))) * accuracy for e in errors]

    fine, middle, coarse = (np.array(size(accuracy)) for accuracy in FORCE_STEPS)
    assert (middle > 4 * fine).all()
    assert (coarse > 2.5 * middle).all()


def test_design_positions_are_within_the_limit(results):
    assert results.lever.plans.worst < 1.0  # of a plan that shares its scale with larger ones
    assert not results.lever.plans.singular
    assert results.lever.plans.accuracy == pytest.approx(0.01)
    assert results.lever.force_plans.worst < 2.0


def test_every_value_of_the_plans_is_compared(results):
    """No velocity or acceleration of the mechanism is left out, but for what is given: the driving link's turn."""
    for d in results.lever.plans.drawn:
        per_mm = {**d.velocity.per_mm, **d.acceleration.per_mm}
        assert set(per_mm) == set(results.lever.kinematics.values)
        given = {key for key, value in per_mm.items() if value == 0}
        assert {key[0] for key in given} <= {"w", "e"}
        assert {c.key for c in d.comparison} == set(per_mm) - given


def test_every_reaction_is_compared(results):
    for d in results.lever.force_plans.drawn:
        analytic = sorted(round(c.analytic, 6) for c in d.comparison if c.key.startswith("R_"))
        forces = results.lever.kinetostatics.table.statics.reactions.values()
        exact = [
            abs(np.broadcast_to(r.force, results.lever.kinetostatics.table.motion.shape)[d.position])
            for r in forces
        ]
        assert analytic == pytest.approx(sorted(exact), abs=1e-6)


@pytest.mark.parametrize(
    ("graph", "analytic", "delta", "ok"),
    [
        (1.02, 0.98, 4.0, True), (0.98, 1.02, -4.0, True), (1.1, 0.9, 20.0, False), (1.0, 1.0, 0.0, True),
        (0.0, 0.0, None, True),  # 0/0 is no error
        (0.01, 0.0, None, True), (0.004, 0.01, None, True),  # nothing can be read below the floor
        (0.02, 0.0, 200.0, False),  # read where there is nothing
        (0.019, 0.01, 62.07, True),  # one step off near zero is as good as it gets
    ],
)  # fmt: skip
def test_comparison(graph, analytic, delta, ok):
    compared = Comparison("v_B", graph, analytic, floor=0.01)
    assert compared.delta == (None if delta is None else pytest.approx(delta, abs=0.005))
    assert compared.ok == ok


def test_what_cannot_be_read_off_is_not_the_greatest_difference():
    """A value of two reading steps is 27 % off, and right; that is not the accuracy of the plans."""
    plans = drawn(read("knuckle_press"), 1e-5).lever.plans
    rows = [c for d in plans.drawn for c in d.comparison if c.delta is not None]
    assert max(abs(c.delta) for c in rows) > 20 and all(c.ok for c in rows)
    assert plans.unreadable and plans.worst < 2
