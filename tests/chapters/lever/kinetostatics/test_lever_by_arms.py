"""Zhukovsky's lever by arms read off the turned plan: agrees with the power balance to the drawing's accuracy."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from conftest import FILES, read, stating, unread

from tmm_report import course
from tmm_report.chapters.lever.force_plans.lever import Lever
from tmm_report.loading import loads

NAMES = [path.stem for path in FILES]
ROUNDING = 5e-5  # five digits of every force and of every product


@cache
def solved(name: str, accuracy: float = 1e-5) -> course.Results:
    ready = read(name)
    if accuracy == ready.lever.drawing.accuracy:
        return unread(ready)
    drawing = replace(ready.lever.drawing, accuracy=accuracy)
    return course.solve(stating(ready, drawing=drawing, readings={}))


def slack(lever: Lever, found: course.Results) -> float:
    """N m: every arm is off by a reading, every point of a hand's plan by some steps."""
    step = found.lever.plans.accuracy
    steps = 0.5 if step <= 0.0101 else 6.0
    forces = sum(abs(arm.vector) for arm in lever.arms)
    products = sum(abs(arm.moment) for arm in lever.arms)
    pa = lever.driving.arm
    crank = abs(lever.balance[-1].written / lever.balance[-2].written) if lever.balance[-2].written else 0.0
    own = abs(lever.balance[-1].written) * steps * step / pa
    return crank / pa * (forces * 1.5 * steps * step + ROUNDING * products) + own + 1e-9


BY_HAND = ["compressor", "shaper", "whitworth", "jaw_crusher", "sewing", "v_engine"]


@pytest.mark.parametrize(("name", "accuracy"), [*((n, 1e-5) for n in NAMES), *((n, 1e-4) for n in BY_HAND)])
def test_the_lever_agrees_with_the_power_balance(name, accuracy):
    found = solved(name, accuracy)
    for lever in found.lever.force_plans.levers:
        exact = found.lever.kinetostatics.table.power[lever.position]
        assert abs(lever.balance[-1].written - exact) <= slack(lever, found)


@pytest.mark.parametrize("name", NAMES)
def test_every_force_plan_with_a_plan_of_velocities_has_a_lever(name):
    found = solved(name).lever
    turned, sweep = found.kinematics.turned, found.kinematics.cycle.sweep
    drawn = {round(turned[one.position] % sweep, 9) for one in found.plans.drawn}
    wanted = [d.position for d in found.force_plans.drawn if round(turned[d.position] % sweep, 9) in drawn]
    assert [lever.position for lever in found.force_plans.levers] == wanted


@pytest.mark.parametrize("name", NAMES)
def test_the_moments_about_the_pole_are_the_powers(name):
    """F·h by the turned plan, times the scale of velocities, is the force's power: row by row."""
    found = solved(name).lever
    for lever in found.force_plans.levers:
        motion = found.kinematics.cycle.motion(found.kinematics.turned[lever.position : lever.position + 1])
        for arm in (arm for arm in lever.arms if arm.pair is None):
            velocity = complex(np.ravel(motion.velocity(arm.point))[0])
            power = (arm.vector * velocity.conjugate()).real
            sense = -1 if lever.turn.imag > 0 else 1
            reading = abs(arm.vector) * (0.006 * lever.plan.scale + ROUNDING * abs(velocity)) + 1e-9
            assert abs(sense * arm.moment * lever.plan.scale - power) <= 2 * reading


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_a_crank_with_a_weight_alone(rotation):
    """One force on the crank at the right: its moment is its own arm times the force, whichever way it turns."""
    text = f"""\
mechanism:
  frame: {{O: [0, 0], C: [300 mm, 0]}}
  links:
    1: {{points: {{O: 0, A: 100 mm}}}}
    2: {{points: {{A: 0, B: 300 mm}}}}
    3: {{points: {{C: 0, B: 250 mm}}}}
  driver: {{link: 1, speed: 60 rpm, rotation: {rotation}}}
  assembly: {{B: left}}
loads:
  forces: [{{name: load, at: A, direction: down, constant: 50 N}}]
positions: {{plans: [0], force_plan: 0}}
"""
    text = text.replace("  assembly: {B: left}\n", "  sketch: {A: [100 mm, 0], B: [250 mm, 240 mm]}\n")
    (lever,) = course.solve(loads(text)).lever.force_plans.levers
    assert lever.balance[-1].written == pytest.approx(5.0, rel=1e-4)
    assert lever.driving.vector == pytest.approx(50j, rel=1e-4)
