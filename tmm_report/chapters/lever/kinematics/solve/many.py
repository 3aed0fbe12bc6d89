"""Kinematics of many variants of one mechanism, solved together over the leading axis of their arrays.

Each finds what `solve` finds for it alone, to the last bit, whatever variants stand beside it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.checks.closure import all_closed
from tmm_report.chapters.lever.kinematics.checks.singular import Closest, Dead, nearest, sine_of, told
from tmm_report.chapters.lever.kinematics.given import Positions
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics, steps, turned_at
from tmm_report.chapters.lever.kinematics.solve.strokes import Output, driven, outputs, pointed, travel
from tmm_report.chapters.lever.structure.solve import Structure
from tmm_report.mechanics.calculus.variants import Each, one, together
from tmm_report.mechanics.lever.cams.replacing_dyad import CamDyad
from tmm_report.mechanics.lever.cycle import Cycle, Slope
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.many.cycles import extremes_of, filled, moves, roots_of, zeros
from tmm_report.mechanics.lever.motion import Linkage, Motion, apart
from tmm_report.mechanics.lever.singular import Critical, regular
from tmm_report.mechanics.lever.vector_equations import named_values
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Moved:
    """Variants solved together. `whole`: of all, its numbers `Each`; `table`, `diagram`: its motion, (V, P); `each`:
    what is found of every variant."""

    whole: Linkage
    table: Motion
    diagram: Motion
    each: tuple[Kinematics, ...]


def solve(positions: Positions, structures: Sequence[Structure]) -> tuple[list[int], Moved | None]:
    """Which of the variants can be solved together, and what is found of them. The others are solved alone: they have
    groups above class II, come near to a singular position, or have no position 0. Raises Unlike for variants of
    different topologies."""
    linkages = [structure.linkage for structure in structures]
    if any(
        not isinstance(group, Dyad) or isinstance(group, CamDyad)
        for linkage in linkages
        for group in linkage.groups
    ):
        return [], None
    whole, start, fit = _begin(linkages)
    if len(fit) < len(linkages) and fit:
        linkages = [linkages[v] for v in fit]
        whole, start, _ = _begin(linkages)
    moved = _solve(positions, whole, start, linkages) if fit else None
    if moved is None or not all_closed(moved.table, moved.diagram):
        return [], None
    return fit, moved


def _begin(linkages: Sequence[Linkage]) -> tuple[Linkage, list[float | None], list[int]]:
    """All linkages as one, the angles of position 0, and the variants that go on together."""
    whole = _with(together([_with(linkage) for linkage in linkages]), linkages[0].mechanism.driver.sweep)
    good = regular(whole, len(linkages))
    start: list[float | None] = [0.0] * len(linkages)
    if good.all():
        start = zeros(whole, linkages)
    return whole, start, [v for v, zero in enumerate(start) if good[v] and zero is not None]


def _with(linkage: Linkage, sweep: float = 0.0) -> Linkage:
    """A linkage with a number for what all variants share, and without the words by which its assembly was chosen."""
    structure, mechanism = linkage.structure, linkage.structure.mechanism
    driver = replace(mechanism.driver, sweep=sweep, period=None)
    return replace(
        linkage,
        structure=replace(structure, mechanism=replace(mechanism, driver=driver, assembly=(), sketch={})),
        groups=tuple(replace(g, told_at=None) if isinstance(g, Dyad) else g for g in linkage.groups),
    )


def _solve(
    positions: Positions, whole: Linkage, start: Sequence[float | None], linkages: Sequence[Linkage]
) -> Moved:
    cycle = Cycle(whole, Each(start))
    each = [
        Cycle(linkage, zero, tuple(Critical(group) for group in linkage.groups))
        for linkage, zero in zip(linkages, start, strict=True)
    ]
    (turned, table), (diagram_turned, diagram) = (
        steps(cycle, count) for count in (positions.table, positions.diagram)
    )
    tables, diagrams = apart(table, linkages), apart(diagram, linkages)
    lines = _outputs(linkages, diagrams)
    count = len(outputs(linkages[0]))
    lines, turning = _turning(cycle, lines, count)
    searched = _searched(cycle, each, lines, count, tables, diagrams)
    values, diagram_values = named_values(table), named_values(diagram)
    found = []
    for v, (travels, near, dead) in enumerate(searched):
        links = tuple(own for own, turns in zip(travels[count:], turning, strict=True) if turns[v])
        own = Kinematics(
            linkages[v], each[v], positions, turned, tables[v], diagram_turned, diagrams[v], travels[:count],
            links, (), (), (), (), None, turned_at(positions, each[v]),
        )  # fmt: skip
        # what it would find out of itself when it is asked
        vars(own).update(
            values=one(values, v),
            diagram_values=one(diagram_values, v),
            closest=near,
            dead=dead,
        )
        found.append(own)
    return Moved(whole, table, diagram, tuple(found))


def _outputs(linkages: Sequence[Linkage], diagrams: Sequence[Motion]) -> list[tuple[Output, ...]]:
    """The outputs of every variant, then its other driven links."""
    return [
        tuple(pointed(output, diagram) for output in (*outputs(linkage), *driven(linkage)))
        for linkage, diagram in zip(linkages, diagrams, strict=True)
    ]


def _turning(
    cycle: Cycle, lines: Sequence[tuple[Output, ...]], count: int
) -> tuple[list[tuple[Output, ...]], list[Array]]:
    """The lines without the links that turn in none of the variants; of each other link, in which variants it does."""
    driven = together(lines)[count:]
    turning = [moves(cycle, len(lines), link.velocity, link.size) for link in driven]
    kept = [k for k, turns in enumerate(turning) if np.any(turns)]
    left = [(*own[:count], *(own[count + k] for k in kept)) for own in lines]
    return left, [turning[k] for k in kept]


def _searched(
    cycle: Cycle,
    each: Sequence[Cycle],
    lines: Sequence[tuple[Output, ...]],
    count: int,
    tables: Sequence[Motion],
    diagrams: Sequence[Motion],
) -> list[tuple[Any, tuple[Closest, ...], tuple[Dead, ...]]]:
    """Of every variant its travels, the nearest positions to singular ones and the dead points of its outputs, which
    are the first `count` of its lines."""
    both = together(lines)
    sines = [sine_of(group.group.label) for group in cycle.linkage.groups]
    rates = [rate for output in both for rate in output.stops]
    still = roots_of(cycle, len(each), [*rates, *(Slope(sine) for sine in sines)])
    extremes = extremes_of(cycle, [*(value for output in both for value in output.values), *sines], still)
    dead = _dead(cycle, each, both[:count], [[own[3 * k] for k in range(count)] for own in still])
    found = []
    for v, own in enumerate(lines):
        travels = tuple(
            travel(each[v], output, tables[v], diagrams[v], still[v][3 * k], extremes[v][3 * k : 3 * k + 3])
            for k, output in enumerate(own)
        )
        least = [low for low, _ in extremes[v][3 * len(own) :]]
        near = tuple(nearest(each[v], c, at) for c, at in zip(each[v].critical, least, strict=True))
        found.append((travels, near, dead[v]))
    return found


def _dead(
    cycle: Cycle, each: Sequence[Cycle], both: Sequence[Output], stops: Sequence[Sequence[Array]]
) -> list[tuple[Dead, ...]]:
    """Dead points of every variant: where an output stops that moves at all."""
    found: list[list[Dead]] = [[] for _ in stops]
    for output, rows in zip(both, zip(*stops, strict=True), strict=True):
        moving = moves(cycle, len(rows), output.velocity, output.size)
        turned = [row if turns else row[:0] for row, turns in zip(rows, moving, strict=True)]
        motions = apart(cycle.motion(filled(turned)[0]), [own.linkage for own in each])
        for own, row, motion in zip(found, turned, motions, strict=True):
            own.append(told(output, row, motion))
    return [tuple(own) for own in found]
