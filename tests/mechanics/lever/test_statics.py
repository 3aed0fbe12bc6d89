"""Reactions against one linear system of Newton-Euler equations for all links at once, assembled here."""

import dataclasses

import numpy as np
import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from schemes import OMEGA, ROOTED, SCHEMES, linkage, random_loads, turn

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.mechanism import FRAME


def world(found, link, at):
    """Place of `at` of a link, from the places of its named points and its turn alone."""
    name, own = next(iter(found.linkage.mechanism.links[link].points.items()))
    return found.place(name) + found.turn(link) * (at - own)


def newton_euler(found, loads, k):
    """All reactions and the driving moment at position k: pair key -> (force, moment), moment under "driver".

    Three equations a link, moments about the world's origin: Σ F = 0, Σ M = 0 with inertia among the loads.
    """
    scheme = found.linkage.mechanism
    row = {name: 3 * index for index, name in enumerate(scheme.moving)}
    size = 3 * len(row)
    matrix, right = np.zeros((size, size)), np.zeros(size)

    def act(link, column, force, moment):
        if link != FRAME:
            matrix[row[link] : row[link] + 3, column] += force.real, force.imag, moment

    columns = {}
    column = 0
    for pair in found.linkage.structure.pairs:
        by, on = pair.links
        columns[pair.key] = column
        if pair.kind == "R":
            at = found.place(pair.name)[k]
            units = [(1 + 0j, cross(at, 1 + 0j)), (1j, cross(at, 1j))]
        else:
            slide = next(s for s in scheme.slides if {s.link, scheme.guides[s.guide].link} == set(pair.links))
            at = world(found, slide.link, slide.through)[k]
            normal = 1j * (found.turn(slide.link) * slide.direction)[k]
            units = [(normal, cross(at, normal)), (0j, 1.0)]
        for force, moment in units:
            act(on, column, force, moment)
            act(by, column, -force, -moment)
            column += 1
    act(scheme.driver.link, column, 0j, 1.0)
    assert column + 1 == size  # W = 1: as many unknowns as equations
    for name, load in loads.items():
        force, moment, r = (
            np.broadcast_to(x, found.shape)[k] for x in (load.force, load.moment, found.state.r[name])
        )
        right[row[name] : row[name] + 3] = -force.real, -force.imag, -(moment + cross(r, force))
    solution = np.linalg.solve(matrix, right)
    return columns, solution


@pytest.mark.parametrize(("name", "sign"), ROOTED)
@settings(max_examples=examples(5))
@given(k=st.lists(st.floats(0.94, 1.06), min_size=6, max_size=6), seed=st.integers(0, 1000))
def test_groups_agree_with_one_system_for_all_links(name, sign, k, seed):
    found = motion.solve(linkage(SCHEMES[name](k), sign), turn(7))
    loads = random_loads(found, seed)
    ours = statics.solve(found, loads)
    for position in range(7):
        columns, exact = newton_euler(found, loads, position)
        size = np.abs(exact).max()
        assert abs(exact[-1] - ours.balancing[position]) < 1e-10 * size
        for key, reaction in ours.reactions.items():
            force, moment = (
                np.broadcast_to(x, found.shape)[position] for x in (reaction.force, reaction.moment)
            )
            first, second = exact[columns[key] : columns[key] + 2]
            if reaction.pair.kind == "R":
                assert abs(force - complex(first, second)) < 1e-10 * size, key
            else:
                along = np.broadcast_to(reaction.along, found.shape)[position]
                assert abs(dot(force, along)) < 1e-10 * size, key  # no force along a guide
                # the guide's normal may point either way
                normal = 1j * along
                slide = next(
                    s
                    for s in found.linkage.mechanism.slides
                    if {s.link, found.linkage.mechanism.guides[s.guide].link} == set(reaction.pair.links)
                )
                other = 1j * (found.turn(slide.link) * slide.direction)[position]
                assert abs(dot(force, normal) * dot(normal, other) - first) < 1e-10 * size, key
                assert abs(moment - second) < 1e-10 * size, key


@pytest.mark.parametrize(("name", "sign"), ROOTED)
def test_frame_carries_all_loads(name, sign):
    """Reactions of the frame and the balancing moment hold all loads of the whole mechanism."""
    found = motion.solve(linkage(SCHEMES[name](), sign), turn())
    loads = random_loads(found)
    ours = statics.solve(found, loads)
    force = sum(load.force for load in loads.values())
    moment = sum(load.moment + cross(found.state.r[link] + 0j, load.force) for link, load in loads.items())
    size = sum(abs(load.force) for load in loads.values())
    for reaction in ours.reactions.values():
        if FRAME in reaction.pair.links:
            assert reaction.pair.links[0] == FRAME  # R01: of the frame on the link
            force = force + reaction.force
            moment = moment + reaction.moment + cross(reaction.at + 0j, reaction.force)
    assert (abs(force) < 1e-12 * size).all()
    assert (abs(moment + ours.balancing) < 1e-12 * size).all()


@pytest.mark.parametrize(("name", "sign"), ROOTED)
def test_balancing_moment_has_the_power_of_all_loads(name, sign):
    """Virtual power with loads that have nothing to do with inertia."""
    found = motion.solve(linkage(SCHEMES[name](), sign), turn())
    loads = random_loads(found)
    s = found.state
    power = [dot(s.v[n] + 0j, load.force) + load.moment * s.w[n] for n, load in loads.items()]
    balancing = statics.solve(found, loads).balancing
    size = sum(abs(part) for part in power).max()
    assert (abs(sum(power) + balancing * OMEGA) < 1e-11 * size).all()


def test_inertia_needs_no_gravity_to_close_the_energy_balance():
    """Over a whole turn inertia forces and weights do no work."""
    found = motion.solve(linkage(SCHEMES["compound"]()), turn(256))
    moment = statics.solve(found, statics.inertia_and_gravity(found, -9.81j)).balancing
    assert abs(moment.mean()) < 1e-10 * abs(moment).max()


def test_reaction_by_name_either_way():
    found = motion.solve(linkage(SCHEMES["four_bar"]()), turn())
    ours = statics.solve(found, random_loads(found))
    np.testing.assert_array_equal(ours.force("2", by="1"), -ours.force("1", by="2"))
    assert dataclasses.is_dataclass(ours.reactions["1-2"])


def test_offset_replaces_the_guides_moment():
    """The normal force alone, at the offset, has the moment of force and couple."""
    found = motion.solve(linkage(SCHEMES["slider_crank"]()), turn())
    reaction = statics.solve(found, random_loads(found)).reactions["0-3"]
    moved = cross(reaction.along * reaction.offset, reaction.force)
    np.testing.assert_allclose(moved, reaction.moment, rtol=1e-12, atol=1e-12)
