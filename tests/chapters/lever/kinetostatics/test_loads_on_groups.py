"""What the loading schemes and the equations of moments stand on: centres of percussion, components, links, mm."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from conftest import FILES, read, stating, unread

from tmm_report import course
from tmm_report.chapters.lever.force_plans.drafting.plan import ForceDrawn, ForcePlan
from tmm_report.mechanics.calculus.vectors import cross

NAMES = [path.stem for path in FILES]


@cache
def solved(name: str, accuracy: float = 1e-5) -> course.Results:
    ready = read(name)
    if accuracy == ready.lever.drawing.accuracy:
        return unread(ready)
    drawing = replace(ready.lever.drawing, accuracy=accuracy)
    return course.solve(stating(ready, drawing=drawing, readings={}))


def drawn(name: str, accuracy: float = 1e-5) -> tuple[ForceDrawn, ...]:
    return solved(name, accuracy).lever.force_plans.drawn


def groups(name: str) -> list[ForcePlan]:
    return [plan for one in drawn(name) for plan in one.plans[:-1]]


@pytest.mark.parametrize("name", NAMES)
def test_the_one_force_has_the_moment_of_force_and_couple(name):
    """About any place: the inertia force through K is the inertia force in S with the couple."""
    for one in drawn(name):
        couples = {couple.key: couple.value for _, couple in one.couples}
        own = {force.key: force for _, force in one.acting}
        moved = {force.key: force for plan in one.plans for loads in plan.loads.values() for force in loads}
        for reduced in one.reduced:
            key = f"F_I{reduced.link}"
            couple = couples[f"M_I{reduced.link}"]
            for about in (0j, 0.3 - 0.2j):
                both = cross(own[key].at - about, own[key].vector) + couple
                single = cross(moved[key].at - about, moved[key].vector)
                assert single == pytest.approx(both, abs=1e-9 * (abs(couple) + reduced.force))


@pytest.mark.parametrize("name", NAMES)
def test_forces_of_a_group_and_of_each_link_close(name):
    """Loads and what holds them add up to nothing, as drawn, on every link that is shown alone."""
    for plan in groups(name):
        for link in plan.links:
            total = sum(force.vector for force in plan.loads[link])
            parts = [one for one in plan.held if one.link == link]
            total += sum(one.vector for one in parts)
            assert abs(total) <= 0.2 * plan.scale


@pytest.mark.parametrize("name", NAMES)
def test_moments_of_each_link_close(name):
    """With the forces where the scheme shows them; a guide's reaction acts at its offset, or with its moment."""
    found = solved(name).lever
    for one in found.force_plans.drawn:
        for plan in one.plans[:-1]:
            for link in plan.links:
                parts = [held for held in plan.held if held.link == link]
                about = parts[0].at
                moments = [cross(force.at - about, force.vector) for force in plan.loads[link]]
                moments += [couple.value for couple in plan.couples[link]]
                moments += [cross(held.at - about, held.vector) + held.couple for held in parts]
                arms = [abs(x.at - about) for x in (*plan.loads[link], *parts)]
                forces = [abs(x.vector) for x in (*plan.loads[link], *parts)]
                reading = (sum(forces) * found.plans.length_scale + max(arms) * plan.scale) * 0.05
                assert abs(sum(moments)) <= reading + 1e-3 * max(map(abs, moments))


@pytest.mark.parametrize("name", NAMES)
def test_a_component_with_a_minus_is_turned_round_and_no_other(name):
    for plan in groups(name):
        worked = {f.result: f.written for f in plan.moments}
        for one in (one for one in plan.held if one.kind == "component" and one.key.endswith("_t")):
            assert one.turned == (worked[one.quantity.sign] < 0)


@pytest.mark.parametrize("name", NAMES)
def test_the_equation_stands_in_the_order_of_the_polygon(name):
    """Head to tail, the vectors of the equation, one after another, end where they began."""
    for plan in (plan for one in drawn(name) for plan in one.plans):
        by_sign = {}
        for stroke in plan.strokes:
            by_sign.setdefault(stroke.quantity.sign, stroke)
        laid = [by_sign[term.symbol] for term in plan.equation.sides[0] if term.symbol in by_sign]
        for one, following in zip(laid, [*laid[1:], laid[0]], strict=True):
            assert abs(following.start - one.end) < 0.01


@pytest.mark.parametrize("name", NAMES)
def test_the_inner_reaction_closes_the_polygon_of_its_link(name):
    for plan in groups(name):
        strokes = {stroke.quantity.sign: stroke for stroke in plan.strokes}
        for single in plan.singles:
            vectors = [strokes[term.symbol] for term in single.equation.sides[0] if term.symbol in strokes]
            assert abs(sum(v.end - v.start for v in vectors)) < 1e-6
            assert single.equation.sides[0][-1].symbol == single.closing.sign


@pytest.mark.parametrize("name", ["compressor", "shaper", "quick_return"])
def test_by_hand_arms_and_lengths_stand_in_millimetres(name):
    """The same tangential component to the accuracy of the drawing; ΣM in N mm of paper, times the scale N m."""
    by_hand, fine = drawn(name, 1e-4), drawn(name)
    for one, other in zip(by_hand, fine, strict=True):
        for plan, exact in zip(one.plans[:-1], other.plans[:-1], strict=True):
            units = {formula.unit for formula in plan.moments if formula.result.base == "SigmaM"}
            assert units <= {"N·mm"}
            scale = max(abs(force.vector) for loads in plan.loads.values() for force in loads)
            for formula, same in zip(plan.moments, exact.moments, strict=True):
                factor = found_scale(name) if formula.unit == "N·mm" else 1.0
                size = scale * (0.5e-3 if formula.unit == "N·mm" else 0.05)
                assert abs(formula.written * factor - same.written) <= size + 0.02 * abs(same.written)
        assert one.balancing == pytest.approx(other.balancing, rel=0.05)


def found_scale(name: str) -> float:
    return solved(name).lever.plans.length_scale


@pytest.mark.parametrize("name", NAMES)
def test_plans_without_a_stated_scale_fit_a_page(name):
    if solved(name).variant.lever.drawing.force is not None:
        pytest.skip("the variant states its scales")
    for plan in (plan for one in drawn(name) for plan in one.plans):
        places = np.array([z for stroke in plan.strokes for z in (stroke.start, stroke.end)])
        assert np.ptp(places.real) <= 149.5 and np.ptp(places.imag) <= 199.5
