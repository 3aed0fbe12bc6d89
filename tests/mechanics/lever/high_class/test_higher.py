"""Groups above class II: drawn at random, closed, differentiated, loaded, turned, scaled, renamed, stacked."""

import dataclasses

import numpy as np
import pytest
from conftest import examples
from higher_schemes import LABELS, TOPOLOGIES, drawn
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from schemes import random_loads
from test_statics import newton_euler

from tmm_report.mechanics.calculus.roots import slope
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.assembly.all_roots import assemblies
from tmm_report.mechanics.lever.assembly.stated import assemble, ways
from tmm_report.mechanics.lever.cycle import cycle_of
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.problems import ProblemError

PHI = 0.3 + np.arange(7) * (2 * np.pi / 7)


def solved(scheme, phi=PHI):
    """Motion where the group is regular all round; else the draw is passed over."""
    cycle = cycle_of(assemble(scheme))
    assume(not any(critical.gaps or critical.changes for critical in cycle.critical))
    found = motion.solve(cycle.linkage, phi)
    assume(all(sine.min() > 0.02 for sine in found.sines.values()))
    return found


schemes = st.builds(
    drawn,
    st.sampled_from(sorted(TOPOLOGIES)),
    st.integers(0, 10_000),
    st.lists(st.integers(1, 5), max_size=2, unique=True),  # never the crank's pin
)


@pytest.mark.exhaustive
@settings(max_examples=examples(15))
@given(schemes)
def test_joints_meet_all_round(scheme):
    made = scheme.mechanism()
    try:
        found = solved(made)
    except ProblemError:  # a contour of guides alone
        assume(False)
    assert found.linkage.groups[-1].group.label == LABELS[scheme.name]
    s = found.state
    for point in made.point_names:
        places = [s.world(link, made.links[link].points[point]) for link in made.links_at(point)]
        assert max(np.abs(place - places[0]).max() for place in places) < 1e-13
    for slide in made.slides:
        guide = made.guides[slide.guide]
        t = s.u[guide.link] * guide.direction
        gap = s.world(slide.link, slide.through) - s.world(guide.link, guide.through)
        assert np.abs(cross(t, gap)).max() < 1e-13
        assert np.abs(t - s.u[slide.link] * slide.direction).max() < 1e-13


@pytest.mark.exhaustive
@settings(max_examples=examples(8))
@given(schemes)
def test_velocities_and_accelerations_are_derivatives(scheme):
    try:
        found = solved(scheme.mechanism())
    except ProblemError:
        assume(False)
    step = 0.004 * min(sine.min() for sine in found.sines.values())
    omega = found.linkage.mechanism.driver.omega
    for point in found.point_index:
        for value, rate in (("place", "velocity"), ("velocity", "acceleration")):
            of = lambda phi, point=point, value=value: getattr(motion.solve(found.linkage, phi), value)(point)  # noqa: E731
            exact = getattr(found, rate)(point)
            error = np.abs(slope(of, PHI, step) * omega - exact).max()
            assert error < 1e-8 * max(np.abs(exact).max(), omega**2)


@pytest.mark.exhaustive
@settings(max_examples=examples(10))
@given(schemes, st.integers(0, 1000))
def test_reactions_agree_with_one_system_for_all_links(scheme, seed):
    try:
        found = solved(scheme.mechanism())
    except ProblemError:
        assume(False)
    loads = random_loads(found, seed)
    ours = statics.solve(found, loads)
    for position in (0, 3):
        columns, exact = newton_euler(found, loads, position)
        size = np.abs(exact).max()
        assert abs(exact[-1] - ours.balancing[position]) < 1e-9 * size
        for key, reaction in ours.reactions.items():
            first, second = exact[columns[key] : columns[key] + 2]
            force, moment = (
                np.broadcast_to(x, found.shape)[position] for x in (reaction.force, reaction.moment)
            )
            if reaction.pair.kind == "R":
                assert abs(force - (first + 1j * second)) < 1e-9 * size
            else:
                assert abs(abs(force) - abs(first)) < 1e-9 * size and abs(moment - second) < 1e-9 * size


@pytest.mark.exhaustive
@settings(max_examples=examples(10))
@given(schemes, st.floats(-3, 3), st.sampled_from([1e-6, 1e-3, 1.0, 1e3]))
def test_turn_scale_and_names_change_nothing(scheme, angle, scale):
    turn = complex(np.exp(1j * angle))
    names = {"1": "crank", "2": "z", "3": "y", "4": "x", "5": "w", "P3": "Q", "g2": "guide", "g4": "a"}
    try:
        found = solved(scheme.mechanism())
    except ProblemError:
        assume(False)
    other = solved(scheme.mechanism(turn, scale, names))
    for point in found.point_index:
        same = names.get(point, point)
        for rate in ("place", "velocity", "acceleration"):
            one, two = getattr(found, rate)(point), getattr(other, rate)(same)
            size = np.abs(one).max() + 1.0
            assert np.abs(two - one * turn * scale).max() < 1e-9 * size * scale


@pytest.mark.parametrize("name", sorted(TOPOLOGIES))
def test_stack_equals_loop_of_singles(name):
    base = drawn(name, 3)
    factors = np.array([1.0, 1.01, 0.99])

    def stretched(factor):
        """One link of the group made longer, in the sketch and in the mechanism."""
        places = list(base.places)
        places[-1] = places[-1] * factor
        return dataclasses.replace(base, places=places).mechanism()

    singles = [stretched(float(factor)) for factor in factors]
    together = stretched(factors[:, None])
    together = dataclasses.replace(together, sketch=singles[0].sketch)
    found = motion.solve(assemble(together), PHI)
    assert found.shape == (3, len(PHI))
    loads = statics.inertia_and_gravity(found, -9.81j)
    forces = statics.solve(found, loads)
    for row, single in enumerate(singles):
        alone = motion.solve(assemble(dataclasses.replace(single, sketch=singles[0].sketch)), PHI)
        for values in ("places", "velocities", "accelerations"):
            np.testing.assert_allclose(
                getattr(found, values)[:, row], getattr(alone, values), rtol=0, atol=1e-10
            )
        expected = statics.solve(alone, statics.inertia_and_gravity(alone, -9.81j))
        np.testing.assert_allclose(forces.balancing[row], expected.balancing, rtol=1e-8, atol=1e-8)


# ---------------------------------------------------------------- all assemblies


@settings(max_examples=examples(15))
@given(schemes)
def test_every_assembly_closes_and_the_drawn_one_is_among_them(scheme):
    made = scheme.mechanism()
    try:
        linkage = assemble(made)
    except ProblemError:
        assume(False)
    group = linkage.groups[-1]
    assert isinstance(group, HigherGroup)
    found = assemblies(group.loops, group.known[0](np.array([0.0])))
    most = {4: 6, 6: 20}[len(group.links)]
    assert 1 <= len(found) <= most
    for way in ways(made, 0.0):
        for link in made.links.values():
            own, world = np.array(list(link.points.values())), np.array([way.places[p] for p in link.points])
            lengths = [np.abs(np.subtract.outer(x, x)) for x in (own, world)]
            assert np.abs(lengths[0] - lengths[1]).max() < 1e-9
    misses = [max(abs(way.places[p] - at) for p, at in made.sketch.items()) for way in ways(made, 0.0)]
    assert min(misses) < 1e-7


@pytest.mark.parametrize("seed", range(8))
def test_count_of_assemblies_by_scanning_one_leg(seed):
    """Class III with revolute pairs, counted another way: the first leg is turned through a full circle, the basis then
    hangs as a four-bar's rod on it and the second leg, and the third leg must fit."""
    scheme = drawn("III3", seed)
    p1, p4, p5, b, c, d = scheme.places
    leg = p1 + (b - p1) * np.exp(1j * np.linspace(0.1, 0.1 + 2 * np.pi, 200_001))
    count = 0
    for sign in (1, -1):
        gap = p4 - leg
        distance = np.abs(gap)
        rod, rocker = abs(c - b), abs(c - p4)
        x = (distance**2 + rod**2 - rocker**2) / (2 * distance)
        with np.errstate(invalid="ignore"):
            bc = gap / distance * (x + 1j * sign * np.sqrt(rod**2 - x * x))
        miss = np.abs(leg + bc * (d - b) / (c - b) - p5) - abs(d - p5)
        count += int(np.sum(miss[:-1] * miss[1:] < 0))
    linkage = assemble(scheme.mechanism())
    group = linkage.groups[-1]
    assert count == len(assemblies(group.loops, group.known[0](np.array([0.0]))))
