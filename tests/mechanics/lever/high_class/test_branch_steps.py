"""Steps along a branch on curves with closed answers, and the motion of the links before a group between its angles."""

import sys
from functools import cache
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

sys.path.append(str(Path(__file__).parents[4]))
from benchmarks.random_groups.draw import draw
from tmm_report.loading import loads
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import cycle_of
from tmm_report.mechanics.lever.high_class.branch.crossing import ahead
from tmm_report.mechanics.lever.high_class.branch.curve import Curve, Node
from tmm_report.mechanics.lever.high_class.branch.known import PANELS, KnownPart
from tmm_report.mechanics.lever.high_class.branch.trace import trace


class Cubic(Curve):
    """φ = q³/3 − m·q: it turns back by 4/3·m^1.5 where m > 0."""

    def __init__(self, m):
        self.m, self.spread, self._last = m, 4.0, np.array([0.0, 1.0])
        self.known = SimpleNamespace(is_known=lambda phi: True)

    def at(self, z):
        q, phi = z
        return np.array([phi - q**3 / 3 + self.m * q]), np.array([[self.m - q * q, 1.0]])

    def begin(self):
        q = -1.5
        return self.node(np.array([q, q**3 / 3 - self.m * q]), np.array([0.0, 1.0]))


@pytest.mark.parametrize("m", [1e-1, 1e-3, 1e-5, 1e-7])
def test_a_curve_that_turns_back_ends_at_its_extreme(m):
    found = trace(Cubic(m), Cubic(m).begin(), 1, 2.0)
    assert found.nodes[-1].phi == pytest.approx(2 / 3 * m**1.5, abs=1e-15)
    assert found.nodes[-1].z[0] == pytest.approx(-np.sqrt(m), rel=1e-6)


@pytest.mark.parametrize("m", [1e-11, 1e-12, 1e-14, 0.0, -1e-12, -1e-5, -1e-1])
def test_one_that_turns_back_by_less_than_rounding_goes_on(m):
    """4/3·(1e-11)^1.5 is 4e-17 rad: no driver angle is without an assembly."""
    found = trace(Cubic(m), Cubic(m).begin(), 1, 2.0)
    assert found.nodes[-1].z[0] > 1.0 and not found.blocked


def test_a_step_is_predicted_to_the_fourth_order():
    """On a circle, from two nodes: half the step leaves about a sixteenth of the error."""

    def at(s):
        turn = np.array([np.cos(s), np.sin(s)])
        return Node(turn, np.array([-turn[1], turn[0]]), None, None, None, 1.0)

    errors = [np.abs(ahead(at(-h), at(0.0), h) - at(h).z).max() for h in (0.2, 0.1, 0.05)]
    assert errors[0] < 3e-3
    assert all(12 < one / other < 20 for one, other in pairwise(errors))


# ---------------------------------------------------------------- the links before


@cache
def before(lane):
    """The known part of a group behind a dyad that does not exist all round."""
    batch = draw("dyad-III", 24, 3)
    group = assemble(loads(batch.file(lane)).lever.mechanism).groups[-1]
    return KnownPart(group.loops, group.known[0])


@pytest.mark.exhaustive
@pytest.mark.parametrize("lane", [10, 4, 18])
def test_between_its_angles_the_known_part_is_what_is_solved_there(lane):
    known = before(lane)
    phi = np.random.default_rng(lane).uniform(-7, 7, 1500)
    values, rates, _ = known.solved(phi)
    for k, angle in enumerate(phi):
        lost = not np.isfinite(values[:, k]).all()
        value, rate = known.at(float(angle))
        assert known.is_known(float(angle)) is not lost
        if not lost:
            np.testing.assert_allclose(value, values[:, k], rtol=0, atol=3e-14 * known.size)
            largest = max(1.0, np.abs(rates[:, k]).max())
            np.testing.assert_allclose(rate, rates[:, k], rtol=0, atol=1e-9 * largest)


def test_a_panel_beside_a_singular_position_is_divided_and_most_of_its_parts_are_exact():
    known = before(10)
    assert 0.3 * PANELS < known.exact.sum() < PANELS
    lost = np.isnan(known.off)
    beside = np.flatnonzero(~known.exact & ~lost)
    assert beside.size
    parts = np.array([known._refined(panel)[1].mean() for panel in beside])
    assert parts.max() == 1.0


@cache
def changing(number: int):
    """A group whose assemblies meet, and its motion over a turn."""
    found = cycle_of(assemble(loads(draw("III-P", 82, 3000).file(number)).lever.mechanism))
    group = found.linkage.groups[-1]
    assert group.changes
    return group, found.motion(found.turned(360)).state


CHANGING = (10, 64, 80)


@pytest.mark.parametrize("number", CHANGING)
def test_beside_a_change_point_the_links_still_meet(number):
    """Rates there are limits of their neighbours; poses are those solved, exact to rounding over the closeness."""
    group, state = changing(number)
    assert group.closeness(state).min() < 2e-3
    assert np.abs(group.loops.residual(state, group.loops.read(state))).max() < 3e-15


@pytest.mark.parametrize("number", CHANGING)
def test_beside_a_change_point_joints_on_known_links_move_as_these_do(number):
    """To the last bit: such a joint is no limit of its neighbours."""
    group, state = changing(number)
    joints = [(link, joint) for link, joint in group.references.items() if joint in group.group.outer]
    assert joints
    for link, joint in joints:
        known = next(one for one in joint.links if one != link)
        for own, other in zip(moved(state, link, joint), moved(state, known, joint), strict=True):
            np.testing.assert_array_equal(*np.broadcast_arrays(own, other))


def moved(state, link, joint):
    """Place, velocity and acceleration of a joint as a point of a link."""
    arm = state.u[link] * (joint.at[link] - state.o[link])
    return state.world(link, joint.at[link]), state.velocity(link, arm), state.acceleration(link, arm)
