"""A slider of stated length that tilts in its guide: one rule for the losses of the first approximation, for those of
the corrected reactions and for the mean over the cycle; the flank of a gear that friction turns over."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from conftest import solved

from tmm_report import course, loading
from tmm_report.chapters.lever.friction import solve as friction
from tmm_report.chapters.lever.friction.solve import rubbing_of
from tmm_report.chapters.lever.kinetostatics.solve.positions import at, resultants, stated
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.forces import reactions_with_friction
from tmm_report.mechanics.lever.forces.reactions import Load

CASES = Path(__file__).parents[3] / "cases/mechanics"
BESIDE = """
language: en
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 50 mm}}
    2: {points: {A: 0, B: 200 mm}}
    3: {points: {B: 0, T: [0, HEIGHT]}, slides: {guide: x, at: B}}
  driver: {link: 1, speed: 60 rpm, rotation: counter-clockwise}
  assembly: {B: right}
loads:
  gravity: 0
  forces: [{at: T, direction: against motion, constant: 1000 N}]
friction: {guides: {coefficient: 0.1, length: LENGTH}}
positions: {table: 24, diagram: 72}
"""


def beside(height: str, length: str):
    text = BESIDE.replace("HEIGHT", height).replace("LENGTH", length)
    return course.solve(loading.loads(text)).lever


def by_hand(given, motion, reactions):
    """Power of friction by the rule as the documents have it, each end of a slider's faces by itself: two forces at the
    distance l with the sum N and the moment M are N/2 ± M/l; of one face they press the other with their sum alone."""
    lost = np.zeros(motion.shape)
    for one in reactions.values():
        if (of := rubbing_of(given, one.pair)) is None:
            continue
        rate = np.abs(reactions_with_friction.relative_rate(motion, one.pair))
        if one.pair.kind == "R":
            lost += of.coefficient * np.abs(one.force) * of.diameter / 2 * rate
        else:
            normal = cross(one.along, one.force)
            assert np.abs(dot(one.along, one.force)).max() < 1e-9 * np.abs(one.force).max()
            turn = one.moment / of.length if of.length else 0 * normal
            lost += of.coefficient * (np.abs(normal / 2 + turn) + np.abs(normal / 2 - turn)) * rate
    return lost


def dense(lever, count=36000):
    """Half way between equal steps, by no panels."""
    forces, cycle = lever.kinetostatics, lever.kinematics.cycle
    turned = (np.arange(count) + 0.5) * (cycle.period / count)
    motion = cycle.motion(turned)
    found = at(forces.given, motion, turned, stated(forces.given, lever.kinematics, motion, turned))
    return by_hand(lever.given.friction, motion, found.statics.reactions), found


def test_a_force_beside_the_guide_presses_both_ends():
    """Closed form: the couple is F h, each end bears F h/l, the loss is f 2 F h/l |v|."""
    lever = beside("150 mm", "100 mm")
    found = lever.friction.table
    (guide,) = found.pairs
    moving = guide.rate > 1e-9
    np.testing.assert_allclose(guide.pressing[moving], 2 * 1000 * 0.15 / 0.1, rtol=1e-9)
    np.testing.assert_allclose(guide.power, 0.1 * 2 * 1000 * 0.15 / 0.1 * guide.rate, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(found.total, guide.power)


def test_a_long_slider_does_not_tilt():
    long, plain = (beside("15 mm", length).friction.table for length in ("10 m", "100 m"))
    np.testing.assert_array_equal(long.pairs[0].pressing, long.pairs[0].reaction)
    np.testing.assert_array_equal(long.total, plain.total)


@pytest.mark.parametrize("name", ["", "_corrected_true"])
def test_an_offset_slider_with_a_load_far_from_its_guide(name):
    lever = course.solve(loading.load(CASES / f"friction_length_ignored{name}.yaml")).lever
    found = lever.friction
    guide = next(loss for loss in found.table.pairs if loss.pair.key == "0-3")
    assert guide.power[0] == pytest.approx(49.592, abs=5e-4)
    assert found.table.efficiency[0] == pytest.approx(0.78305, abs=5e-6)
    assert found.table.reduced[0] == pytest.approx(6.2419, abs=5e-5)
    solved_table = lever.kinetostatics.table
    lost = by_hand(found.given, solved_table.motion, solved_table.statics.reactions)
    np.testing.assert_allclose(found.table.total, lost, rtol=1e-11)
    if found.corrected:
        first = found.corrected.table.first
        np.testing.assert_allclose(first, solved_table.balancing + lost / solved_table.motion.omega)


@pytest.mark.exhaustive
def test_means_over_the_cycle_of_sliders_that_tilt():
    """With the kinks where a slider begins to tilt and where it is pressed on its other face: some 1e-7 of a sum over
    36 000 positions is its own."""
    for lever in (
        course.solve(loading.load(CASES / "friction_length_ignored.yaml")).lever,
        beside("10 mm", "100 mm"),
        solved("shaper").lever,
    ):
        lost, _ = dense(lever)
        assert lever.friction.mean_power == pytest.approx(lost.mean(), rel=1e-6)
        reduced = lever.friction.reduced
        if not reduced.corrected:
            power = reduced.panels.mean(reduced.moment) * abs(lever.kinematics.omega)
            assert power == pytest.approx(lost.mean(), rel=1e-6)


def test_the_kinks_of_the_losses_are_edges():
    """As exact as the rounding of a double where a sum over equal steps has lost four digits."""
    lever = beside("10 mm", "100 mm")  # 2 F h/l is 200 N, and the normal force up to 258 N
    over, losses = lever.friction.whole
    finer = replace(lever.kinetostatics.given)  # the same on twice as many panels
    halves = (over.panels.edges[1:] + over.panels.edges[:-1]) / 2
    again = friction.cut_at(over, halves, finer, lever.kinematics)
    twice = friction._losses(lever.given.friction, again.motion, again.statics)
    mean = over.panels.mean(over.on(losses.total))
    assert again.panels.mean(again.on(twice.total)) == pytest.approx(mean, rel=1e-12)


def test_both_tables_are_of_one_rule():
    """Of next to no friction the corrected losses are those of the first approximation, tilting and all."""
    lever = course.solve(loading.load(CASES / "friction_length_ignored.yaml")).lever
    small = {
        key: replace(of, coefficient=1e-7 * of.coefficient)
        for key, of in {"pivots": lever.given.friction.pivots, "guides": lever.given.friction.guides}.items()
    }
    given = replace(lever.given.friction, joints={}, corrected=True, **small)
    found = friction.solve(given, lever.kinetostatics)
    for loss, other in zip(found.table.pairs, found.corrected.table.pairs, strict=True):
        np.testing.assert_allclose(other.pressing, loss.pressing, rtol=1e-5)
        np.testing.assert_allclose(other.power, loss.power, rtol=1e-5, atol=1e-9 * found.table.total.max())


# ---------------------------------------------------------------- the gear of the driving link

GEARED = """
language: en
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 50 mm}}
    2: {points: {A: 0, B: 200 mm}}
    3: {points: {B: 0}, slides: {guide: x, at: B}}
  driver: {link: 1, speed: 60 rpm, rotation: ROTATION, gear: {radius: 80 mm, at: 30 deg}}
  assembly: {B: right}
loads:
  gravity: 0
  forces: [{at: B, direction: left, constant: 1000 N}]
friction: {pivots: {coefficient: 0.1, diameter: 60 mm}, guides: {coefficient: 0.2}, corrected: true}
positions: {table: 24, diagram: 72}
"""


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_the_teeth_press_the_flank_of_the_whole_moment(rotation):
    """Where the load drives, friction alone would press the other flank. Friction of the found reactions is put on the
    links: the force analysis gives these reactions again, that of the bearing beside the gear among them."""
    lever = course.solve(loading.loads(GEARED.replace("ROTATION", rotation))).lever
    given, before = lever.given.friction, lever.kinetostatics.table
    found, motion = lever.friction.corrected.table, before.motion
    loads = dict(resultants(lever.kinetostatics.given, motion, before.loading))
    for loss in found.pairs:
        of, rate = rubbing_of(given, loss.pair), reactions_with_friction.signed_rate(motion, loss.pair)
        sense = np.where(np.abs(rate) < 1e-9 * np.abs(rate).max(), 0.0, np.sign(rate))
        brake = -of.coefficient * loss.pressing * sense
        for sign, link in zip((-1, 1), loss.pair.links, strict=True):
            if link in loads and loss.pair.kind == "R":
                turn = sign * brake * of.diameter / 2
                loads[link] = Load(loads[link].force, loads[link].moment + turn)
            elif link in loads:  # through the middle of the slider
                loads[link] = Load(loads[link].force + sign * brake, loads[link].moment)
    again = statics.solve(motion, loads)
    assert (found.moment < 0).any() and (found.moment > 0).any()
    np.testing.assert_allclose(again.balancing, found.moment, rtol=1e-9, atol=1e-9)
    for loss in found.pairs:
        force = again.reactions[loss.pair.key].force
        if loss.pair.kind == "R":
            np.testing.assert_allclose(force, loss.reaction, rtol=1e-9, atol=1e-6)
