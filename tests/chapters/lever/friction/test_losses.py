"""Friction: power in every pair by the textbook's formulas, and the efficiency."""

import re

import numpy as np
import pytest
from conftest import path_of

from tmm_report import render, solve
from tmm_report.chapters.lever.friction import solve as friction
from tmm_report.chapters.lever.friction.given import Friction, Rubbing
from tmm_report.loading import loads
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.pairs.coefficients import BySliding, Stribeck

STEP = 1e-4


def rubbing_speed(results, loss) -> np.ndarray:
    """Relative speed in a pair at the table positions: turning by angular velocities, sliding by a difference."""
    motion, cycle = results.lever.kinematics.table, results.lever.kinematics.cycle
    one, other = loss.pair.links
    if loss.pair.kind == "R":
        return np.abs(motion.angular_velocity(one) - motion.angular_velocity(other))
    scheme = motion.linkage.mechanism
    guide = scheme.guides[loss.pair.name]
    slide = next(s for s in scheme.slides if s.guide == loss.pair.name and s.link in loss.pair.links)

    def along(turned):
        """Place of the slider along its guide, seen from the guide's link, m."""
        s = cycle.motion(turned).state
        at = s.r[slide.link] + s.u[slide.link] * (slide.through - s.o[slide.link])
        seen = (at - s.r[guide.link]) / s.u[guide.link] + s.o[guide.link]
        return np.real((seen - guide.through) * np.conj(guide.direction)) + 0 * turned

    turned = results.lever.kinematics.turned
    slope = (along(turned + STEP) - along(turned - STEP)) / (2 * STEP)
    return np.abs(slope * results.lever.kinematics.omega)


def rubs(coefficient, sliding):
    """A coefficient: a number, a table of the velocity of sliding, or Stribeck's law of it."""
    match coefficient:
        case BySliding(speeds=speeds, values=values):
            return np.interp(sliding, speeds, values)
        case Stribeck(static=rest, kinetic=moving, speed=fall, viscous=viscous, exponent=n):
            return moving + (rest - moving) / np.exp((sliding / fall) ** n) + viscous * sliding
    return coefficient


def test_power_by_hand(results):
    """f·R·(d/2)·|ω| in pivots, f·N·|v| in guides, every pair of the mechanism once; N: the reaction, and of a slider of
    stated length that its moment tilts the forces at both its ends, 2·|M|/l."""
    found, given = results.lever.friction, results.variant.lever.friction
    forces = results.lever.kinetostatics.table.statics
    total = 0.0
    for loss in found.table.pairs:
        name = loss.pair.name
        stated = given.joints.get(name) or (given.pivots if loss.pair.kind == "R" else given.guides)
        arm = (stated.diameter or 0) / 2 if loss.pair.kind == "R" else 1.0
        reaction = np.abs(forces.force(loss.pair.links[1], by=loss.pair.links[0]))
        tilt = 2 * np.abs(forces.reactions[loss.pair.key].moment) / stated.length if stated.length else 0.0
        rate = rubbing_speed(results, loss)
        power = rubs(stated.coefficient, arm * rate) * np.maximum(reaction, tilt) * arm * rate
        np.testing.assert_allclose(loss.power, power, rtol=1e-6, atol=1e-6 * np.abs(power).max() + 1e-12)
        total = total + power
    np.testing.assert_allclose(found.table.total, total, rtol=1e-6)
    stated_pairs = [p for p in results.lever.structure.pairs if given.guides or p.kind == "R"]
    assert [loss.pair.key for loss in found.table.pairs] == [pair.key for pair in stated_pairs]


def test_efficiency(results):
    found = results.lever.friction
    for losses in (found.table, found.diagram):
        assert (losses.total > 0).any()
        assert (losses.efficiency[np.isfinite(losses.efficiency)] <= 1).all()
        assert (losses.efficiency[np.isfinite(losses.efficiency)] >= 0).all()
    driving = np.abs(results.lever.kinetostatics.table.balancing * results.lever.kinematics.omega)
    np.testing.assert_allclose(found.table.efficiency, driving / (driving + found.table.total))
    assert 0 < found.mean_efficiency < 1
    # of the whole cycle, not of the positions of the diagrams
    assert found.mean_power == pytest.approx(found.diagram.total[:-1].mean(), rel=0.1)


def test_no_friction_loses_nothing(results):
    found = friction.solve(Friction(Rubbing(0.0, 0.05), Rubbing(0.0)), results.lever.kinetostatics)
    assert not found.table.total.any()
    assert found.mean_efficiency == 1
    assert len(found.table.pairs) == len(results.lever.structure.pairs)


def test_friction_of_no_pair(results):
    found = friction.solve(Friction(), results.lever.kinetostatics)
    assert found.table.pairs == ()
    assert found.table.total.shape == found.table.driving.shape
    assert found.mean_power == 0


def test_power_is_proportional_to_coefficient_and_diameter(compressor):
    once = friction.solve(Friction(Rubbing(0.1, 0.04)), compressor.lever.kinetostatics)
    twice = friction.solve(Friction(Rubbing(0.05, 0.16)), compressor.lever.kinetostatics)
    np.testing.assert_allclose(twice.table.total, 2 * once.table.total, rtol=1e-14)
    assert all(loss.pair.kind == "R" for loss in once.table.pairs)


def test_a_joints_own_friction_wins(compressor):
    own = Friction(Rubbing(0.1, 0.04), Rubbing(0.1), {"C": Rubbing(0.3, 0.06), "x": Rubbing(0.2)})
    found = {
        loss.pair.name: loss.rubbing
        for loss in friction.solve(own, compressor.lever.kinetostatics).table.pairs
    }
    assert found["C"] == Rubbing(0.3, 0.06)
    assert found["x"] == Rubbing(0.2)
    assert found["A"] == Rubbing(0.1, 0.04)


def test_compressor_position_7(compressor):
    """Pivot D of position 7 by the printed numbers: R54 = 279.17 N, ω4 = 26.524 rad/s, f = 0.1, d = 50 mm."""
    (loss,) = (loss for loss in compressor.lever.friction.table.pairs if loss.pair.name == "D")
    assert FRAME not in loss.pair.links
    assert loss.power[7] == pytest.approx(0.1 * 279.17 * 0.025 * 26.524, rel=1e-4)


RUBBING = "friction:\n  pivots: {coefficient: 0.08, diameter: 30 mm}\n"
GUIDES = "  guides: {coefficient: %s}\n"
ONE_APART = RUBBING + "  joints:\n    B: {coefficient: 0.12, diameter: 30 mm}\n"


@pytest.mark.parametrize(
    ("name", "given", "depth", "told"),
    [
        ("crank_rocker", RUBBING, "course", ["f = 0.08", "d = 0.03"]),
        ("crank_rocker", RUBBING, "full", []),
        ("crank_rocker", ONE_APART, "course", []),
        ("slider_crank_offset", RUBBING + GUIDES % 0.1, "short", ["f = 0.08", "f = 0.1", "d = 0.03"]),
        ("slider_crank_offset", RUBBING + GUIDES % 0.08, "short", ["f = 0.08", "d = 0.03"]),
    ],
)  # fmt: skip
def test_what_is_one_for_all_pairs_is_told_in_words(name, given, depth, told):
    text = path_of(name).read_text("utf-8")
    text = re.sub(r"(?ms)^friction:.*?(?=^\S)", "", text) + "\n" + given
    note = render(solve(loads(text)), "html", "en", depth)["note.html"].decode()
    said = re.search(r"<p>The coefficient of friction .*?</p>", note)
    assert ("Friction in the kinematic pairs</p>" in note) == (not told) == (said is None)
    if said:
        values = re.findall(r"<mi>([fd])</mi>.*?<mn[^>]*>([\d.]+)</mn>", said[0])
        assert [f"{letter} = {value}" for letter, value in values] == told
