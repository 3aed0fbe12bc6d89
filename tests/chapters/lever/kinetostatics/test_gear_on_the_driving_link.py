"""A driving link turned by a gear: stated, solved at all positions, drawn in its force plan."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from html import unescape

import numpy as np
import pytest
from conftest import read, stating

from tmm_report import course
from tmm_report.chapters.lever.kinetostatics.view.driving_gear import GearView
from tmm_report.i18n import Translator
from tmm_report.loading import loads
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.forces.force_on_crank_gear import GearDrive
from tmm_report.problems import ProblemError
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page
from tmm_report.stack import solve_many

TEXT = """\
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 300 mm}}
    3: {points: [B], slides: x}
  driver: {link: 1, speed: 60 rpm, gear: GEAR}
  assembly: {B: right}
loads:
  forces: [{name: load, at: B, direction: against motion, constant: 100 N}]
positions: {plans: [2], force_plan: 2}
"""
GEAR = "{radius: 60 mm, alpha_w: 20 deg, at: -90 deg}"


@cache
def solved(gear: str = GEAR) -> course.Results:
    return course.solve(loads(TEXT.replace("GEAR", gear)))


@pytest.mark.parametrize("flank", ["either", "driving"])
def test_the_crank_is_in_equilibrium_under_the_force_of_the_teeth(flank):
    """R21 in A, R01 in O and F_bal in the pitch point: forces and moments add up to nothing at every position."""
    found = solved(GEAR.replace("}", f", flank: {flank}}}")).lever
    table, gear = found.kinetostatics.table, found.given.mechanism.driver.gear
    teeth = gear.force(table.balancing, found.kinematics.omega)
    on_crank = table.statics.force("1", "2")
    total = teeth + on_crank + table.statics.force("1", "0")
    moment = cross(gear.pitch_point, teeth) + cross(table.motion.place("A"), on_crank)
    size = np.nanmax(np.abs(on_crank))
    assert np.nanmax(np.abs(total)) <= 1e-9 * size
    assert np.nanmax(np.abs(moment)) <= 1e-9 * size


def test_through_a_coupling_it_stays_a_moment():
    with_gear = solved().lever
    without = course.solve(loads(TEXT.replace(", gear: GEAR", ""))).lever
    assert without.given.mechanism.driver.gear is None
    assert without.kinetostatics.table.balancing == pytest.approx(with_gear.kinetostatics.table.balancing)
    held = [one.kinetostatics.table.statics.force("1", "0") for one in (without, with_gear)]
    assert np.max(np.abs(held[0] - held[1])) > 1.0


@pytest.mark.parametrize("name", ["compressor", "whitworth", "quick_return"])
def test_the_force_plan_of_the_driving_link_gives_the_force_and_the_reaction(name):
    ready = read(name)
    gear = GearDrive(0.05, np.radians(20), np.radians(30))
    driver = replace(ready.lever.mechanism.driver, gear=gear)
    mechanism = replace(ready.lever.mechanism, driver=driver)
    found = course.solve(stating(ready, mechanism=mechanism, readings={})).lever
    for drawn in found.force_plans.drawn:
        plan = drawn.plans[-1]
        (teeth,) = (held for held in plan.held if held.key == "F_bal")
        exact = gear.force(found.kinetostatics.table.balancing[drawn.position], found.kinematics.omega)
        assert abs(teeth.vector - exact) <= 2e-3 * abs(exact) + 0.05 * plan.scale
        assert all(c.ok for c in drawn.comparison)


def test_extremes_of_the_force_are_those_of_the_moment():
    from tmm_report.chapters.lever.kinetostatics.quantities import positions as quantities

    found = solved().lever
    values = {value.key: value for value in quantities.values(found.kinetostatics)}
    low, high = found.kinetostatics.extremes
    arm = found.given.mechanism.driver.gear.base_radius
    assert values["F_bal_min"].value * arm == pytest.approx(low.value)
    assert values["F_bal_max"].value * arm == pytest.approx(high.value)
    assert values["F_bal_max"].at == high.turned


def test_the_last_position_of_a_range_has_its_own_loads_and_teeth():
    """A cycle that is closed ends in position 0 again, a range does not: what holds at its end is told too."""
    pulled = TEXT.replace("GEAR", GEAR.replace("}", ", flank: driving}")).replace(
        "direction: against motion, constant: 100 N",
        "direction: left, by_angle: [[0, -9], [95 deg, -9], [96 deg, 9]]",
    )
    whole = pulled.replace("[96 deg, 9]", "[96 deg, 9], [360 deg, 9]")  # a full turn is told all round
    part = pulled.replace("60 rpm", "60 rpm, zero: {angle: 20 deg}, range: 100 deg")
    shut, open_ = (course.solve(loads(text)).lever for text in (whole, part))
    page = Page(Html(), Translator("en"), Numbering())
    view = GearView(open_.kinetostatics, 0, page)
    force = view.book.tables["gear_table"]["F_bal"].values
    assert view.parting == [k for k in range(13) if force[k] < 0] and 12 in view.parting
    assert (open_.kinetostatics.positions, shut.kinetostatics.positions) == (13, 12)
    assert 12 not in GearView(shut.kinetostatics, 0, page).parting


@pytest.mark.parametrize("turns", ["60 rpm", "60 rpm, rotation: clockwise"])
@pytest.mark.parametrize("flank", ["either", "driving"])
def test_an_extreme_force_is_told_where_it_is_reached_with_the_side_of_a_jump(flank, turns):
    text = TEXT.replace("GEAR", GEAR.replace("}", f", flank: {flank}}}")).replace("60 rpm", turns)
    jumps = "direction: left, by_angle: [[0, 10], [70 deg, 90], [70 deg, -60], [360 deg, -60]]"
    found = course.solve(loads(text.replace("direction: against motion, constant: 100 N", jumps))).lever
    view = GearView(found.kinetostatics, 0, Page(Html(), Translator("en"), Numbering()))
    told = {end: unescape(re.sub("<[^>]*>", "", view.extreme_at(end))) for end in ("min", "max")}
    for end, text in told.items():
        assert float(text.split("°")[0]) == pytest.approx(np.degrees(view.book[f"F_bal_{end}"].at), abs=0.06)
    assert [text for text in told.values() if text.endswith("before the jump")] == ["70° before the jump"]


@pytest.mark.parametrize(
    ("gear", "said"),
    [
        ("{radius: 60 mm, alpha_w: 50 deg, at: 0 deg}", "no teeth are in mesh"),
        ("{radius: 60 mm, alpha_w: -20 deg, at: 0 deg}", "no teeth are in mesh"),
        ("{radius: 60 mm}", "at"),
        ("{radius: -60 mm, at: 0 deg}", "radius"),
        ("{radius: 0 mm, at: 0 deg}", "radius"),
        ("{radius: 60 mm, at: 0 deg, flank: both}", "flank"),
        ("yes", "gear"),
    ],
)
def test_a_gear_that_cannot_be_is_told(gear, said):
    with pytest.raises(ProblemError) as error:
        loads(TEXT.replace("GEAR", gear))
    assert any(said in f"{p.wrong.text} {'/'.join(map(str, p.path))}" for p in error.value.problems)


def test_of_many_variants_each_has_its_own_gear():
    texts = [GEAR.replace("60 mm", f"{radius} mm") for radius in (50, 60, 70, 80)]
    variants = [loads(TEXT.replace("GEAR", text)) for text in texts]
    for variant, found in zip(variants, solve_many(variants), strict=True):
        alone = course.solve(variant).lever.kinetostatics.table.statics.force("1", "0")
        assert np.array_equal(found.lever.kinetostatics.table.statics.force("1", "0"), alone, equal_nan=True)
