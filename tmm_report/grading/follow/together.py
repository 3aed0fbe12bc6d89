"""Rates of a group above class II, whose branches are solved together, from the student's rates before it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.grading.follow.known import Known, derived_together
from tmm_report.mechanics.lever import from_read_values
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.vector_equations import Branch

if TYPE_CHECKING:
    from tmm_report.grading.follow.rates import Rates

Array = Any


def solved_together(rates: Rates, group: HigherGroup, branches: Sequence[Branch]) -> Mapping[str, Known]:
    """Vertices and relative motions of the branches by their keys, angular rates by "link " + name."""
    ends = list(dict.fromkeys(branch.end for branch in branches))
    rights = [rates.right_rate(link) for link in group.links]
    rights += [rates.right(end) for end in ends] + [rates.right_relative(branch) for branch in branches]
    found = derived_together(
        rights, lambda *_: _solved(rates, group, branches, ends), *_inputs(rates, group, branches)
    )
    keys = [f"link {link}" for link in group.links]
    keys += [f"{rates.letter}_{end}" for end in ends] + [rates.relative_key(branch) for branch in branches]
    return dict(zip(keys, found, strict=True))


def _carriers(group: HigherGroup) -> dict[str, Pair]:
    """Link before the group -> a pair by which the group hangs on it, a pivot rather than a guide."""
    pairs = sorted(group.group.outer, key=lambda pair: pair.kind == "R")
    return {link: pair for pair in pairs for link in pair.links if link not in group.links}


def _inputs(rates: Rates, group: HigherGroup, branches: Sequence[Branch]) -> list[Known]:
    carriers = _carriers(group)
    inputs = [rates.poses.known((*group.links, *carriers))]
    for link, pair in carriers.items():
        inputs.append(rates.spins[link])
        point = pair.name if pair.kind == "R" else rates.scheme.bases.get(link)
        inputs.append(rates.of(point))
    if rates.velocities is not None:
        inputs += [rates.velocities.links[link] for link in group.links]
        inputs += [rates.bends[b.pair] for b in branches if b.has_bend]
        inputs += [rates.velocities.relatives[b.v_key] for b in branches if not b.turns]
    return inputs


def _solved(rates: Rates, group: HigherGroup, branches: Sequence[Branch], ends: Sequence[str]) -> list[Array]:
    s = _known(rates, group)
    rate = from_read_values.velocities(s, group)
    if rates.velocities is not None:
        from_read_values.accelerations(s, group, _own_rate(rates, group, branches, rate))
    rate_of = s.velocity if rates.letter == "v" else s.acceleration
    links = [(s.w if rates.letter == "v" else s.e)[link] for link in group.links]
    at = {end: _at(rates, group, branches, s, end) for end in ends}
    vertices = {end: rate_of(link, arm) for end, (link, arm) in at.items()}
    return [*links, *vertices.values(), *_relatives(rates, branches, s, vertices)]


def _known(rates: Rates, group: HigherGroup) -> State:
    """Poses of all links, rates of those that carry the group: each moves so that the joint has the student's rate."""
    s = rates.poses.state()
    for link, pair in _carriers(group).items():
        _carry(rates, s, link, pair, rates.letter)
    return s


def _carry(rates: Rates, s: State, link: str, pair: Pair, letter: str) -> None:
    w = rates if letter == "v" else rates.velocities
    assert w is not None
    s.turn(link, w.links[link].value, rates.links[link].value if letter == "a" else 0.0)
    s.carry(link, _translation(w, s, link, pair), _translation(rates, s, link, pair) if letter == "a" else 0j)


def _translation(rates: Rates, s: State, link: str, pair: Pair) -> Array:
    """The motion of a carrier's reference point that gives its joint the student's motion."""
    point = pair.name if pair.kind == "R" else rates.scheme.bases.get(link)
    if point is None or point == "":
        return 0j
    local = rates.poses.link(link).points.get(point)
    arm = rates.poses.place(rates.scheme.joint(point)).value - s.r[link] if local is None else 0j
    arm = arm if local is None else s.u[link] * (local - s.o[link])
    return rates.of(point).value - rates.spins[link].value * arm


def _own_rate(rates: Rates, group: HigherGroup, branches: Sequence[Branch], rate: Array) -> Array:
    """Rates of q with the student's normal accelerations, angular velocities and relative velocities."""
    loops, velocities, rate = group.loops, rates.velocities, rate.copy()
    assert velocities is not None
    for root in range(loops.angles):
        links = [link for link in group.links if loops.directions[link].root == root]
        rate[..., root] = _own_turning(rates, branches, links, velocities.links[links[0]].value)
    for column, (pair, guide) in enumerate(zip(loops.sliding, loops.guides, strict=True), start=loops.angles):
        turn = guide.root
        w = rate[..., turn] if isinstance(turn, int) else velocities.links[turn].value
        for branch in branches:
            if branch.guide == pair.name and branch.link in pair.links:
                rate[..., column] = _own_sliding(rates, branch, pair, w) / loops.size
    return rate


def _own_turning(rates: Rates, branches: Sequence[Branch], links: Sequence[str], w: Array) -> Array:
    """ω of links that turn alike by the student's normal acceleration, with the sign of his ω."""
    for branch in branches:
        if branch.link in links and branch.arm is not None and (bend := rates.bends[branch.pair]).sources:
            arm = rates.poses.arm(branch.link, *branch.arm).value
            return np.copysign(np.sqrt(np.abs(bend.value / arm)), w)
    return w


def _own_sliding(rates: Rates, branch: Branch, pair: Pair, w: Array) -> Array:
    """Speed along a guide that turns with `w`, of what slides on it; by the student's Coriolis acceleration, where he
    gives it."""
    assert rates.velocities is not None
    carrier = pair.other(pair.slider)
    along = rates.poses.u[carrier].value * pair.along[carrier]
    speed = (along.conjugate() * rates.velocities.relatives[branch.v_key].value).real
    if branch.has_bend and rates.sheet.gives(*(f"{branch.a_key('k')}{part}" for part in ("", "_x", "_y"))):
        by_coriolis = np.copysign(np.abs(rates.bends[branch.pair].value / (2 * w)), speed)
        speed = np.where(np.isfinite(by_coriolis), by_coriolis, speed)
    return speed if branch.link == carrier else -speed


def _at(
    rates: Rates, group: HigherGroup, branches: Sequence[Branch], s: State, end: str
) -> tuple[str, Array]:
    """A link of the group that has a vertex, and the vertex's arm about the link's reference point."""
    for link in group.links:
        if end in (points := rates.poses.link(link).points):
            return link, s.u[link] * (points[end] - s.o[link])
    link = next(branch.link for branch in branches if branch.end == end)
    return link, rates.poses.place(rates.scheme.joint(end)).value - s.r[link]


def _relatives(
    rates: Rates, branches: Sequence[Branch], s: State, vertices: Mapping[str, Array]
) -> Iterator[Array]:
    for branch in branches:
        if branch.arm is not None and rates.relative_key(branch) != f"{rates.letter}_{branch.end}":
            rate = (s.w if rates.letter == "v" else s.e)[branch.link]
            yield 1j * rate * rates.poses.arm(branch.link, *branch.arm).value
        elif branch.start is None:
            yield vertices[branch.end]
        else:
            start = vertices.get(branch.start, rates.of(branch.start).value)
            bend = rates.bends[branch.pair].value if rates.letter == "a" and branch.has_bend else 0j
            yield vertices[branch.end] - start - bend
