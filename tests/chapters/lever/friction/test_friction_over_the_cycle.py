"""Friction over a whole cycle: means against a dense sum, its moment reduced to the driving link."""

import numpy as np
import pytest
from conftest import solved
from exhaustive import many

from tmm_report.chapters.lever.friction import quantities as q
from tmm_report.chapters.lever.friction.solve import rubbing_of
from tmm_report.chapters.lever.kinetostatics.solve.positions import at, stated
from tmm_report.mechanics.lever.forces.reactions_with_friction import relative_rate

NAMES = ("crank_rocker", "press", "engine_four_stroke")


def dense(found, count=36000):
    """Power of friction and of the balancing moment half way between equal steps, by no panels."""
    forces = found.forces
    turned = (np.arange(count) + 0.5) * (forces.kinematics.cycle.period / count)
    motion = forces.kinematics.cycle.motion(turned)
    one = at(forces.given, motion, turned, stated(forces.given, forces.kinematics, motion, turned))
    lost = np.zeros(count)
    for reaction in one.statics.reactions.values():
        if rubbing := rubbing_of(found.given, reaction.pair):
            arm = (rubbing.diameter or 0.0) / 2 if reaction.pair.kind == "R" else 1.0
            rate = np.abs(relative_rate(motion, reaction.pair))
            lost += rubbing.coefficient * np.abs(reaction.force) * arm * rate
    return lost, np.abs(one.balancing * motion.omega)


@pytest.mark.parametrize("name", many(NAMES))
def test_means_are_those_of_the_whole_cycle(name):
    """And not of the diagram positions, which pass over what jumps between them."""
    found = solved(name).lever.friction
    lost, driving = dense(found)
    assert found.mean_power == pytest.approx(lost.mean(), rel=2e-5)
    assert found.mean_efficiency == pytest.approx(driving.mean() / (driving.mean() + lost.mean()), rel=2e-5)


def test_efficiency_by_moments_is_that_by_powers():
    for name in NAMES:
        found, omega = solved(name).lever.friction, abs(solved(name).lever.kinematics.omega)
        moment = np.abs(solved(name).lever.kinetostatics.table.balancing)
        reduced = found.table.reduced
        np.testing.assert_allclose(reduced * omega, found.table.total, rtol=1e-12)
        np.testing.assert_allclose(found.table.efficiency, moment / (moment + reduced), rtol=1e-9)


@pytest.mark.parametrize("name", [*NAMES, "shaper", "v_engine"])
def test_no_two_columns_of_the_losses_have_one_symbol(name):
    for table in q.tables(solved(name).lever.friction):
        signs = [column.symbol() for column in table.columns if column.quantity.symbol is not None]
        assert len(signs) == len(set(signs)), table.name
