"""Many variants solved at once: those of one topology have their motion and forces found together.

Over the leading axis of the arrays (V, P) a motion of many variants costs hardly more than that of one. Every variant
finds what `course.solve` finds for it, to the last bit, whatever variants stand beside it: a batch that is taken up
again gives the same files as one that was never broken off.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterator, Mapping, Sequence
from typing import Any

from tmm_report.backwards import solve
from tmm_report.chapters.lever.kinematics.solve import many as kinematics
from tmm_report.chapters.lever.kinetostatics.solve import many as kinetostatics
from tmm_report.chapters.lever.structure import solve as structure
from tmm_report.course import LeverGiven, Moved, Results, Variant
from tmm_report.mechanics.calculus.variants import Unlike
from tmm_report.mechanics.lever.mechanism import Mechanism, ZeroAngle
from tmm_report.problems import ProblemError

LARGEST = 32  # variants in one stack: more are hardly faster, and take more memory
PLACES = 12_800  # positions in one stack
LEAST = 3  # fewer are sooner solved one by one

Solved = Results | ProblemError


def solve_many(variants: Sequence[Variant]) -> list[Solved]:
    """What is found of every variant, in their order; of a variant with mistakes these. Results as `course.solve`."""
    return list(solve_each(variants))


def solve_each(variants: Sequence[Variant]) -> Iterator[Solved]:
    """`solve_many` one after another: what is not kept by the caller is gone before the next is finished."""
    alike: dict[Hashable, list[int]] = defaultdict(list)
    for k, variant in enumerate(variants):
        if variant.lever is not None and variant.lever.way is None and variant.find is None:
            alike[topology(variant.lever)].append(k)
    stacks = {k: stack for numbers in alike.values() for stack in _stacks(variants, numbers) for k in stack}
    moved: dict[int, Moved] = {}
    for k, variant in enumerate(variants):
        if k in stacks and k not in moved:
            moved |= _moved(variants, [other for other in stacks[k] if stacks.pop(other)])
        yield _solved(variant, moved.pop(k, None))


def _stacks(variants: Sequence[Variant], numbers: Sequence[int]) -> Iterator[Sequence[int]]:
    """Numbers of variants of one topology, so many at a time as memory allows: fewer of those with many positions."""
    lever = variants[numbers[0]].lever
    assert lever is not None
    positions = max(lever.positions.table, lever.positions.diagram)
    size = min(LARGEST, max(1, PLACES // positions))
    return (numbers[start : start + size] for start in range(0, len(numbers), size))


def _solved(variant: Variant, moved: Moved | None) -> Solved:
    try:
        return solve(variant, moved, solve_each)
    except ProblemError as error:
        return error


def _moved(variants: Sequence[Variant], numbers: Sequence[int]) -> dict[int, Moved]:
    """Motion and forces of variants of one topology, by their numbers; without those that are solved alone."""
    given = {k: lever for k in numbers if (lever := variants[k].lever) is not None}
    links = _structures(given) if len(given) >= LEAST else {}
    if len(links) < LEAST:
        return {}
    own = list(links)
    try:
        fit, motion = kinematics.solve(given[own[0]].positions, [links[k] for k in own])
        if motion is None:
            return {}
        own = [own[v] for v in fit]
        forces = _forces([given[k] for k in own], motion)
    except (ProblemError, Unlike, ArithmeticError):  # of whom, is told when each is solved alone
        return {}
    return {
        k: Moved(links[k], found, force) for k, found, force in zip(own, motion.each, forces, strict=True)
    }


def _structures(given: Mapping[int, LeverGiven]) -> dict[int, structure.Structure]:
    """Structures of variants of one topology, without those that have mistakes. What other driving links would make of
    the mechanism is found of the first and is the same of all: no number takes part in it."""
    found: dict[int, structure.Structure] = {}
    for k, lever in given.items():
        try:
            found[k] = structure.solve(lever.mechanism)
        except ProblemError:
            continue
        first = next(iter(found.values()))
        vars(found[k])["alternatives"] = first.alternatives
    return found


def _forces(given: Sequence[LeverGiven], motion: kinematics.Moved) -> Sequence[Any]:
    loads = [lever.loads for lever in given if lever.loads is not None]
    if not loads:
        return [None] * len(given)
    return kinetostatics.solve(loads, motion.each, motion.table, motion.diagram)


# ---------------------------------------------------------------- what is alike


def topology(given: LeverGiven) -> Hashable:
    """What variants that are solved together have in common: all but the numbers, and of these whether they are 0 or
    equal, as an arm of no length is left out of the reckoning."""
    positions = given.positions
    return (
        positions.table,
        positions.diagram,
        positions.instants,
        _of_mechanism(given.mechanism),
        _of_loads(given),
    )


def _of_mechanism(mechanism: Mechanism) -> Hashable:
    driver, zero = mechanism.driver, mechanism.driver.zero
    begin = "angle" if isinstance(zero, ZeroAngle) else (zero.point, zero.link, zero.direction)
    links = tuple(
        (name, *link.points, link.mass_centre, link.mass == 0, link.inertia == 0, _alike(mechanism, name))
        for name, link in mechanism.links.items()
    )
    guides = tuple((guide.name, guide.link) for guide in mechanism.guides.values())
    slides = tuple((slide.link, slide.guide) for slide in mechanism.slides)
    # solved one by one
    geared = id(mechanism) if mechanism.meshes else id(driver.gear) if driver.gear else None
    by_law = id(driver.law) if driver.law else None
    return (
        driver.link,
        driver.omega > 0,
        driver.sweep,
        driver.turns,
        geared,
        by_law,
        begin,
        links,
        guides,
        slides,
    )


def _alike(mechanism: Mechanism, link: str) -> Hashable:
    """Of all places in a link's axes, the origin the first, the first that is equal."""
    places = [
        0,
        *mechanism.links[link].points.values(),
        *(guide.through for guide in mechanism.guides.values() if guide.link == link),
        *(slide.through for slide in mechanism.slides if slide.link == link),
    ]
    return tuple(places.index(place) for place in places), tuple(type(place) for place in places)


def _of_loads(given: LeverGiven) -> Hashable:
    if given.loads is None:
        return None
    return tuple((force.at, force.on) for force in given.loads.forces), tuple(
        m.on for m in given.loads.moments
    )
