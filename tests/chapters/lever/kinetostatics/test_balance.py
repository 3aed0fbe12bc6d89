"""Kinetostatics of every variant: two independent checks of the moment, reactions, travel; and what is refused."""

from dataclasses import replace

import numpy as np
import pytest
from conftest import stating, unread

from tmm_report import course
from tmm_report.chapters.lever.kinematics.given import Positions
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.mechanism import FRAME, Driver, Guide, Link, Mechanism, Slide, ZeroAngle
from tmm_report.problems import ProblemError


def test_lever_and_power_balance(results):
    """Zhukovsky's lever and the power balance against the groups, at the 12 and at the 36 positions."""
    forces = results.lever.kinetostatics
    assert len(forces.diagram.balancing) == len(forces.kinematics.diagram_turned)
    for solved in (forces.table, forces.diagram):
        assert np.isfinite(solved.balancing).all()
        assert np.abs(solved.balancing).max() > 0
        assert solved.disagreement(solved.lever).max() < 1e-10
        assert solved.disagreement(solved.power).max() < 1e-10
    assert forces.agrees


def test_both_senses_of_rotation(variant):
    """The driving link turned the other way: everything still balances and the travel is run back."""
    mechanism = variant.lever.mechanism
    driver = replace(mechanism.driver, omega=-mechanism.driver.omega)
    if driver.sweep < 6:  # a rocking driver starts from its other end
        end = driver.zero.angle - np.sign(driver.omega) * driver.sweep
        driver = replace(driver, zero=ZeroAngle(end))
    there = unread(variant)
    back = course.solve(stating(variant, mechanism=replace(mechanism, driver=driver), readings={}))
    assert max(back.lever.kinetostatics.worst_lever, back.lever.kinetostatics.worst_power) < 1e-10
    for one, other in zip(there.lever.kinematics.travels, back.lever.kinematics.travels, strict=True):
        assert other.stroke == pytest.approx(one.stroke, rel=1e-10)
        if there.lever.kinematics.cycle.closed:
            assert (other.time_ratio is None) == (one.time_ratio is None)
            assert other.time_ratio == pytest.approx(one.time_ratio or 0, rel=1e-10) or one.time_ratio is None
            np.testing.assert_allclose(other.S, one.S[::-1] - one.S[-1], atol=1e-9)
            np.testing.assert_allclose(other.V, -one.V[::-1], atol=1e-9 * np.abs(one.V).max())
            np.testing.assert_allclose(
                other.a,
                one.a[::-1],
                atol=1e-9 * max(np.abs(one.a).max(), one.stroke * there.lever.kinematics.omega**2),
            )


def test_reactions_of_the_frame_hold_all_loads(results):
    """All loads, inertia among them, the balancing moment and the reactions of the frame are in equilibrium."""
    for solved in (results.lever.kinetostatics.table, results.lever.kinetostatics.diagram):
        motion, load, given = solved.motion, solved.loading, results.lever.kinetostatics.given
        links = motion.linkage.mechanism.links
        acting = [(w, motion.place(links[n].mass_centre)) for n, w in load.gravity.items()]
        acting += [(f, motion.place(links[n].mass_centre)) for n, f in load.inertia.items()]
        acting += [(f, motion.place(one.at)) for one, f in zip(given.forces, load.forces, strict=True)]
        reactions = [r for r in solved.statics.reactions.values() if FRAME in r.pair.links]
        acting += [(r.force, r.at + 0j) for r in reactions]
        couples = [*load.couples.values(), *load.moments, *(r.moment for r in reactions)]
        driver, pivot = motion.linkage.mechanism.driver, motion.linkage.structure.driver_pair.name
        if driver.gear:  # the wheel that drives pushes in the pitch point
            push = driver.gear.force(solved.balancing, driver.omega)
            acting.append((push, motion.place(pivot) + driver.gear.pitch_point))
        else:
            couples.append(solved.balancing)
        size = max(np.abs(f).max() for f, _ in acting)
        assert np.abs(sum(f for f, _ in acting)).max() < 1e-12 * size
        moment = sum(cross(at, f) for f, at in acting) + sum(couples)
        assert np.abs(moment).max() < 1e-12 * size


def test_travel_of_outputs(results):
    """S is zero in position 0, V and a are its derivatives by signs and extremes hold all positions."""
    for t in results.lever.kinematics.travels:
        assert t.S[0] == 0
        low, high = t.near.value, t.far.value
        assert t.stroke == pytest.approx(high - low)
        assert t.stroke > 0
        slack = 1e-9 * t.stroke
        assert (t.diagram_S >= low - slack).all() and (t.diagram_S <= high + slack).all()
        for values, (least, most) in ((t.diagram_V, t.V_extremes), (t.diagram_a, t.a_extremes)):
            slack = 1e-9 * max(np.abs(values).max(), t.stroke * results.lever.kinematics.omega**2)
            assert (values >= least.value - slack).all() and (values <= most.value + slack).all()
        if results.lever.kinematics.cycle.closed:
            turns = abs(t.S[-1]) > 1e-6 * t.stroke  # a driven crank does not come back
            still = len(results.lever.kinematics.cycle.roots(t.output.velocity))
            assert (t.time_ratio is None) == (
                turns or still != 2
            )  # of more strokes than two there is no ratio
            assert turns or abs(t.diagram_V[:-1].mean()) < 0.02 * np.abs(t.diagram_V).max()
            assert t.time_ratio is None or t.time_ratio >= 1


def test_position_0_is_the_stated_extreme(results):
    """Where the variant states an extreme for position 0, the point or rocker stands still there."""
    zero = results.variant.lever.mechanism.driver.zero
    motion = results.lever.kinematics.table
    if getattr(zero, "point", None):
        speed = np.abs(motion.velocity(zero.point))
    elif getattr(zero, "link", None):
        speed = np.abs(motion.angular_velocity(zero.link))
    else:
        return
    assert speed[0] < 1e-12 * speed.max()


def shortened(compressor, length):
    variant = compressor.variant
    links = dict(variant.lever.mechanism.links)
    links["4"] = replace(links["4"], points={**links["4"].points, "D": length + 0j})
    # beside the limit forces are so large that they take a scale of their own
    drawing = replace(variant.lever.drawing, force=None)
    mechanism = replace(variant.lever.mechanism, links=links)
    return stating(variant, mechanism=mechanism, drawing=drawing, readings={})


def test_positions_that_do_not_close_are_left_out_and_named(compressor):
    found = course.solve(shortened(compressor, 0.05))
    assert found.lever.partial
    meant = replace(found.lever.given, allow_partial=True)
    assert not replace(found.lever, given=meant).partial
    (gap,) = found.lever.kinematics.gaps
    text = str(gap.text)
    assert gap.group == "II2(4,5)" and "rod CD = 50 mm cannot reach guide x for " in text
    assert "the rod needs at least " in text
    missing = found.lever.kinematics.missing
    assert missing and np.isnan(found.lever.kinematics.table.place("D")[list(missing)]).all()
    others = [k for k in range(13) if k not in missing]
    assert np.isfinite(found.lever.kinematics.table.place("D")[others]).all()
    assert found.lever.kinetostatics.agrees


def test_group_that_never_closes(compressor):
    with pytest.raises(ProblemError, match="rod AB = 300 mm cannot reach guide x at any position"):
        links = shortened(compressor, 0.001)
        guide = replace(links.lever.mechanism.guides["x"], through=10j)
        course.solve(stating(links, mechanism=replace(links.lever.mechanism, guides={"x": guide})))


def test_straight_yoke_displacement_has_one_sign():
    """Both ends of the stroke equally far from position 0: the guide's direction tells which is positive."""
    for angle in np.linspace(-3, 3, 13):
        u = np.exp(1j * angle)
        links = {
            "0": Link("0", {"O": 0j}),
            "1": Link("1", {"O": 0j, "A": 0.1 + 0j}),
            "2": Link("2", {"A": 0j}),
            "3": Link("3", {"E": 0j}),
        }
        guides = {"x": Guide("x", "0", 0j, u), "s": Guide("s", "3", 0j, 1j)}
        driver = Driver("1", 1.0, ZeroAngle(np.pi / 2 + angle))
        yoke = Mechanism(links, driver, guides, (Slide("2", "s"), Slide("3", "x")))
        found = course.solve(course.Variant(course.LeverGiven(yoke, Positions(plans=()))))
        (travel,) = found.lever.kinematics.travels
        assert travel.S[3] == pytest.approx(-0.1)
        assert travel.S[9] == pytest.approx(0.1)
