"""Which groups have a parallelogram among their links, told by the lengths alone, and what closes them then."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import permutations, product
from typing import Any

from tmm_report.mechanics.lever.assur_groups import Group, Pair, Structure
from tmm_report.mechanics.lever.dyads import State
from tmm_report.records import dataclass

Array = Any
EQUAL = 1e-12  # of two sides, relative
Turn = tuple[str, complex]  # "x", "y" or a known link, and the factor that makes of its direction a link's
Joint = dict[str, complex]  # of a pivot the links that it joins, and its place in the axes of each, m
Side = tuple[str, complex]  # a link and a side of the contour in its axes, m


@dataclass(frozen=True)
class Gap:
    """A vector d: points of known links with their signs, and vectors fixed to known links."""

    points: tuple[tuple[int, str, complex], ...]
    vectors: tuple[tuple[str, complex], ...] = ()

    def of(self, s: State, order: int) -> Array:
        """d, or its first or second derivative by time, (..., P)."""
        total: Array = 0j
        for sign, link, at in self.points:
            arm = s.u[link] * (at - s.o[link])
            total = total + sign * (
                s.r[link] + arm if order == 0 else (s.velocity, s.acceleration)[order - 1](link, arm)
            )
        for link, arm in self.vectors:
            turned = s.u[link] * arm
            total = total + (turned if order == 0 else (s.iw, s.ie)[order - 1][link] * turned)
        return total


@dataclass(frozen=True, eq=False)
class Parallel:
    """A group that a parallelogram makes elementary.

    `sides`: the two that must be parallel. `turns`: how every link turns. `hung`: the pivot and the link by which
    each is placed, in order. `gap`: d of the triangle X + Y = d or X + s·T = d, None where there is none to close;
    `x`, `y`: |X|, |Y|, m; `guide`: the known link with T, and T in its axes.
    """

    sides: tuple[Side, Side]
    turns: Mapping[str, Turn]
    hung: tuple[tuple[str, str, Pair], ...]
    gap: Gap | None = None
    x: float = 0.0
    y: float = 0.0
    guide: tuple[str, complex] | None = None


def recognised(structure: Structure, group: Group) -> Parallel | None:
    """The parallelogram of a group, None where it has none. Where a pivot joins more than two links, the group hangs
    on each of them."""
    joints = _joints(structure, _before(structure, group))
    hangings = product(*(_hangings(pair, group, joints) for pair in group.outer))
    found = (_told(joints, replace(group, outer=outer)) for outer in hangings)
    return next((parallel for parallel in found if parallel is not None), None)


def _told(joints: list[Joint], group: Group) -> Parallel | None:
    if group.kind is not None:
        return _of_dyad(joints, group) if group.kind == 1 else None
    if len(group.links) != 4:
        return None
    return _of_class_iv(group) if group.order == 2 else _of_class_iii(group)


def _before(structure: Structure, group: Group) -> set[str]:
    """The links that move as is known before the group."""
    earlier = structure.groups[: structure.groups.index(group)]
    return {*structure.driver_pair.links, *(link for one in earlier for link in one.links)}


def _joints(structure: Structure, links: set[str]) -> list[Joint]:
    """The pivots among these links, each with all links that it joins."""
    found: list[Joint] = []
    for pair in structure.pairs:
        if pair.kind == "R" and links.issuperset(pair.links):
            own = {link: complex(at) for link, at in pair.at.items()}
            same = [joint for joint in found if joint.items() & own.items()]
            merged = {link: at for joint in (*same, own) for link, at in joint.items()}
            found = [merged, *(joint for joint in found if joint not in same)]
    return found


def _hangings(pair: Pair, group: Group, joints: list[Joint]) -> list[Pair]:
    """An outer pair, and the same pivot with every other link that is known before."""
    inside, outside = sorted(pair.links, key=lambda link: link not in group.links)
    if pair.kind != "R":
        return [pair]
    place = outside, complex(pair.at[outside])
    shared = next((joint for joint in joints if place in joint.items()), {})
    others = ((link, at) for link, at in shared.items() if link != outside)
    at_inside = {inside: pair.at[inside]}
    return [pair, *(replace(pair, links=(link, inside), at={link: at} | at_inside) for link, at in others)]


def _equal(one: complex, other: complex) -> bool:
    return abs(abs(one) - abs(other)) <= EQUAL * max(abs(one), abs(other))


def _parallel(one: complex, other: complex, rod: complex, second: complex) -> bool:
    """Whether opposite sides are equal and none is nothing."""
    return _equal(one, other) and _equal(rod, second) and 0 not in (one, rod)


def _side(link: str, start: Pair, end: Pair) -> complex:
    return complex(end.at[link] - start.at[link])


def _between(pairs: tuple[Pair, ...], one: str, other: str) -> Pair | None:
    """The pivot of two links."""
    return next((p for p in pairs if p.kind == "R" and {one, other} == set(p.links)), None)


def _of_dyad(joints: list[Joint], group: Group) -> Parallel | None:
    """Dyad RRR between two links that have a pivot O in common: O A B C."""
    (a, b), inner = group.links, group.inner[0]
    of_a, of_b = (next(p for p in group.outer if link in p.links) for link in (a, b))
    p, q = of_a.other(a), of_b.other(b)
    common = next((joint for joint in joints if p in joint and q in joint), None)
    if common is None or p == q:
        return None
    rod, base = _side(a, of_a, inner), complex(of_b.at[q] - common[q])
    crank, rocker = complex(of_a.at[p] - common[p]), _side(b, of_b, inner)
    if not _parallel(rod, base, crank, rocker):
        return None
    turns = {a: (q, base / rod), b: (p, crank / rocker)}
    return Parallel(((a, rod), (q, base)), turns, ((a, p, of_a), (b, q, of_b)))


def _of_class_iv(group: Group) -> Parallel | None:
    """A contour of four links, e and f with the outer joints, rods g and h between them; e has a pivot there."""
    ends = [(next(end for end in pair.links if end in group.links), pair) for pair in group.outer]
    rods = [link for link in group.links if link not in [end for end, _ in ends]]
    if len(rods) != 2:
        return None
    for (e, of_e), (f, of_f) in permutations(ends):
        joints = [_between(group.inner, body, rod) for rod in rods for body in (e, f)]
        if of_e.kind == "R" and None not in joints:
            return _class_iv_of(group, (e, of_e), (f, of_f), rods, [j for j in joints if j is not None])
    return None


def _class_iv_of(
    group: Group, first: tuple[str, Pair], last: tuple[str, Pair], rods: list[str], joints: list[Pair]
) -> Parallel | None:
    (e, of_e), (f, of_f), (g, h), (C, D, E, F) = first, last, rods, joints
    side, opposite, rod, second = _side(e, C, E), _side(f, D, F), _side(g, C, D), _side(h, E, F)
    if not _parallel(side, opposite, rod, second):
        return None
    alike = opposite / side  # of e's direction to f's
    known, c = of_e.other(e), of_f.other(f)
    arm_e, arm_f = alike * (C.at[e] - of_e.at[e]), D.at[f] - of_f.at[f]
    hung = ((e, known, of_e), (g, e, C), (h, e, E), (f, g, D))
    turns: dict[str, Turn] = {g: ("x", 1 / rod), h: ("x", 1 / second)}
    points = ((1, c, of_f.at[c]), (-1, known, of_e.at[known]))
    sides = (e, side), (f, opposite)
    if of_f.kind == "R":
        m = complex(arm_e - arm_f)
        if m == 0:
            return None
        turns |= {f: ("y", 1 / m), e: ("y", alike / m)}
        return Parallel(sides, turns, hung, Gap(points), abs(rod), abs(m))
    turn = complex(of_f.along[c] / of_f.along[f])
    turns |= {f: (c, turn), e: (c, turn * alike)}
    gap = Gap(points, ((c, complex(turn * (arm_f - arm_e))),))
    return Parallel(sides, turns, hung, gap, abs(rod), guide=(c, complex(of_f.along[c])))


def _of_class_iii(group: Group) -> Parallel | None:
    """A basis link with three legs, two of them parallel between it and one known link."""
    basis = next((link for link in group.links if all(link in pair.links for pair in group.inner)), None)
    if basis is None:
        return None
    found = (_class_iii_of(group, basis, legs) for legs in _legs(group, basis))
    return next((parallel for parallel in found if parallel is not None), None)


Leg = tuple[str, Pair, Pair]  # link, its inner and its outer pair


def _legs(group: Group, basis: str) -> Iterator[tuple[Leg, Leg, Leg]]:
    legs = [
        (link, inner, outer)
        for inner in group.inner
        for link in [inner.other(basis)]
        for outer in group.outer
        if link in outer.links
    ]
    for order in permutations(legs, 3):
        if order[0][0] < order[1][0]:
            yield order


def _class_iii_of(group: Group, b: str, legs: tuple[Leg, Leg, Leg]) -> Parallel | None:
    (g, C, P), (h, E, Q), (k, F, H) = legs
    base = P.other(g)
    if {pair.kind for pair in (C, E, P, Q)} != {"R"} or Q.other(h) != base:
        return None
    side, opposite = _side(b, C, E), _side(base, P, Q)
    leg, second = _side(g, P, C), _side(h, Q, E)
    if not _parallel(side, opposite, leg, second):
        return None
    alike = opposite / side  # of the basis link's direction to the known link's
    turns: dict[str, Turn] = {g: ("x", 1 / leg), h: ("x", 1 / second), b: (base, alike)}
    hung = ((g, base, P), (h, base, Q), (b, g, C))
    sides = (b, side), (base, opposite)
    c = H.other(k)
    reach = ((base, complex(-alike * (F.at[b] - C.at[b]))),)
    points = ((1, c, H.at[c]), (-1, base, P.at[base]))
    if H.kind == F.kind == "R":
        m = _side(k, F, H)
        turns[k] = ("y", 1 / m)
        return Parallel(sides, turns, (*hung, (k, b, F)), Gap(points, reach), abs(leg), abs(m)) if m else None
    if H.kind == "P" and F.kind == "R":  # the third leg slides on a known guide
        turn = complex(H.along[c] / H.along[k])
        turns[k] = (c, turn)
        gap = Gap(points, (*reach, (c, -turn * complex(H.at[k] - F.at[k]))))
        return Parallel(sides, turns, (*hung, (k, b, F)), gap, abs(leg), guide=(c, complex(H.along[c])))
    if H.kind == "R" and F.kind == "P":  # it slides on the basis link
        turn = complex(alike * F.along[b] / F.along[k])
        turns[k] = (base, turn)
        gap = Gap(points, (*reach, (base, turn * complex(F.at[k] - H.at[k]))))
        return Parallel(
            sides, turns, (*hung, (k, c, H)), gap, abs(leg), guide=(base, complex(alike * F.along[b]))
        )
    return None
