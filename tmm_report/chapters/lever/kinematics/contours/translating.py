"""Groups in which a parallelogram keeps a link from turning: its closed form, in place of the contours.

Of a contour of four pivots whose opposite sides are equal, and which does not cross, opposite sides stay parallel.
Where the side opposite to a link's belongs to a link that does not turn, the link only translates: ω = ε = 0, and all
its points have the velocity and acceleration of one. The other two sides turn alike. Of a dyad that is all; of a group
of class IV whose slider is on a fixed guide one rod with that slider is left, a dyad of its own.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.kinematics.contours.dyads_turning import rrp
from tmm_report.chapters.lever.kinematics.contours.equations import (
    BEARING,
    Written,
    arg,
    bearing,
    inner_point,
    inner_rates,
    quantity,
)
from tmm_report.chapters.lever.kinematics.contours.known import Pose
from tmm_report.chapters.lever.kinematics.contours.nodes import Bearing
from tmm_report.chapters.lever.kinematics.contours.worked import Bench
from tmm_report.chapters.lever.kinematics.solve import points_and_links as q
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.assur_groups import Group, Pair
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.quantity.formula import Expr, Formula, Number, Var, cos, sin
from tmm_report.quantity.symbols import Symbol
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.rivals.motion.contours import Turn


@dataclass(frozen=True, eq=False)
class Translating:
    """What is written out of such a group.

    `links`: those that only translate; `corners`, `sides`: of the parallelogram, the equal sides one after the other;
    `angle`: of the side of the first link, the same at every position; `by`: the link that keeps it from turning, "" of
    the frame; `at`: the joint that moves as all points of that link; `lead`: of its place and rates; `rest`: what is
    left of the group, as a dyad; `turned`: the two links that turn alike, with `alike`, the first one's angle, rates.
    """

    group: Group
    links: tuple[str, ...]
    corners: tuple[str, ...]
    sides: tuple[Var, ...]
    angle: Var
    by: str
    at: str
    turned: tuple[str, str]
    lead: list[Formula]
    rest: Written | None
    alike: list[Formula]
    points: list[Formula] = field(default_factory=list)


def write(bench: Bench, group: Dyad | HigherGroup) -> Translating | None:
    """None of a group that has no such link."""
    if isinstance(group, Dyad) and group.kind != 1:
        return None
    from tmm_report.mechanics.rivals.motion.parallelogram import elementary  # few variants have such groups

    own = elementary(bench.found.cycle).get(group.group)
    if own is None:
        return None
    hung = {link: (parent, pair) for link, parent, pair in own.parallel.hung}
    if isinstance(group, Dyad):
        return _of_dyad(bench, group, hung, own.parallel.turns)
    return _of_class_iv(bench, group, hung, own.parallel.turns) if group.group.order == 2 else None


Hung = dict[str, tuple[str, Pair]]


def _stands(bench: Bench, link: str) -> bool:
    """Whether a link does not turn."""
    return link == FRAME or (link in bench.poses and bench.poses[link].w is None)


# ---------------------------------------------------------------- a dyad of three pivots


def _of_dyad(bench: Bench, d: Dyad, hung: Hung, turns: Mapping[str, Turn]) -> Translating | None:
    """Link t between the pivots A, of the link p that turns, and B; link o between C, of what stands, and B."""
    t = next((link for link in d.links if _stands(bench, hung[d.b if link == d.a else d.a][0])), None)
    if t is None:
        return None
    o = d.b if t == d.a else d.a
    (p, at_a), (base, at_c), B = hung[t], hung[o], d.inner
    if p not in bench.poses or bench.poses[p].w is None:
        return None
    rod, rocker = complex(B.at[t] - at_a.at[t]), complex(B.at[o] - at_c.at[o])
    crank = rocker * turns[o][1]  # in the axes of p
    pivot = _named(bench, p, complex(at_a.at[p]) - crank)
    A, C, inner = bench.spot(at_a.name), bench.spot(at_c.name), B.name
    length, second = bench.length(A.name, inner, abs(rod)), bench.length(C.name, inner, abs(rocker))
    fixed, turning = bench.length(pivot, C.name, abs(rod)), bench.length(pivot, A.name, abs(crank))
    sides = (length, fixed, turning, second)
    phi = _constant(bench, A.name + inner, turns[t], rod)
    place = inner_point(bench, inner, (A.x + length * cos(phi), A.y + length * sin(phi)))
    lead = bench.taken()
    lead += _still(bench, t)
    _like(bench, inner, A.name)
    lead += bench.taken()
    angle = bench.own(bearing(C.name + inner), Bearing(place.y - C.y, place.x - C.x))
    w, e = _turns_as(bench, o, p)
    bench.poses[t] = Pose(A, complex(at_a.at[t]), phi, arg(rod), None, None)
    bench.poses[o] = Pose(C, complex(at_c.at[o]), angle, arg(rocker), w, e)
    corners = (pivot, A.name, inner, C.name)
    return Translating(
        d.group,
        (t,),
        corners,
        sides,
        phi,
        base if base != FRAME else "",
        A.name,
        (o, p),
        lead,
        None,
        bench.taken(),
    )


def _named(bench: Bench, link: str, place: complex) -> str:
    """The point of a link at a place in its axes."""
    points = bench.mechanism.links[link].points
    return min(points, key=lambda name: abs(points[name] - place))


def _constant(bench: Bench, ends: str, turn: Turn, side: complex) -> Var:
    """The angle of a side that turns as a link that does not turn, rad."""
    link, factor = turn
    stands = 1.0 if link == FRAME else np.ravel(bench.motion.turn(link))
    direction = np.ravel(stands * factor * side)
    of = quantity(f"phi_{ends}", Symbol("phi", ends), "deg", BEARING, of=ends)
    return bench.constant(of, float(np.angle(direction[np.argmax(np.isfinite(direction))])))


def _still(bench: Bench, link: str) -> list[Formula]:
    """ω = 0 and ε = 0, beside what the solver has found."""
    for letter in "we":
        bench.solved(
            "rates_table", q.link_rate(letter, link), Number(0), bench.found.values[f"{letter}_{link}"]
        )
    return bench.taken()


def _like(bench: Bench, point: str, other: str) -> None:
    """A point of a link that only translates moves as another of its points."""
    for letter in "va":
        x, y = bench.rate(letter, other)
        inner_rates(bench, letter, point, [[(1, x)], [(1, y)]])


def _turns_as(bench: Bench, link: str, other: str) -> tuple[Expr, Expr]:
    """ω and ε of a link that turns as another."""
    pose, found = bench.poses[other], []
    for letter, rate in (("w", pose.w), ("e", pose.e)):
        values = bench.found.values[f"{letter}_{link}"]
        expression = rate if rate is not None else Number(0)
        found.append(bench.solved("rates_table", q.link_rate(letter, link), expression, values))
    return found[0], found[1]


# ---------------------------------------------------------------- a group of class IV with a slider on a fixed guide


def _of_class_iv(
    bench: Bench, group: HigherGroup, hung: Hung, turns: Mapping[str, Turn]
) -> Translating | None:
    """Link e hangs on a known link; rods g and h join it with f, which slides along a guide that stands."""
    e = next(link for link, (parent, _) in hung.items() if parent not in group.group.links)
    known, of_e = hung[e]
    f = next(link for link in hung if hung[link][0] not in (known, e))
    g = hung[f][0]
    h = next(link for link in hung if link not in (e, f, g))
    C, D, E = hung[g][1], hung[f][1], hung[h][1]
    F = next(pair for pair in group.group.inner if set(pair.links) == {f, h})
    of_f = next(pair for pair in group.group.outer if f in pair.links)
    if of_f.kind != "P" or not _stands(bench, of_f.other(f)):
        return None
    side = complex(E.at[e] - C.at[e])
    angle = _constant(bench, C.name + E.name, turns[e], side)
    bench.poses[e] = Pose(bench.spot(of_e.name), complex(of_e.at[e]), angle, arg(side), None, None)
    sides = (
        bench.length(C.name, E.name, abs(side)),
        bench.length(D.name, F.name, abs(F.at[f] - D.at[f])),
        bench.length(C.name, D.name, abs(D.at[g] - C.at[g])),
        bench.length(E.name, F.name, abs(F.at[h] - E.at[h])),
    )
    lead = _still(bench, e)
    for point in (C.name, E.name):
        if point != of_e.name:
            bench.point_of(e, point)
    lead += bench.taken()
    rest = rrp(bench, _left(bench, group, (g, f), (C, of_f, D)))
    bench.point_of(f, F.name)
    w, eps = _turns_as(bench, h, g)
    ends = E.name + F.name
    above, ahead = bench.spot(F.name), bench.spot(E.name)
    turned = bench.own(bearing(ends), Bearing(above.y - ahead.y, above.x - ahead.x))
    bench.poses[h] = Pose(ahead, complex(E.at[h]), turned, arg(F.at[h] - E.at[h]), w, eps)
    corners = (C.name, D.name, F.name, E.name)
    return Translating(
        group.group, (e, f), corners, sides, angle, f, of_e.name, (h, g), lead, rest, bench.taken()
    )


def _left(bench: Bench, group: HigherGroup, links: tuple[str, str], pairs: tuple[Pair, Pair, Pair]) -> Dyad:
    """A rod and the slider as a dyad, in the assembly that the motion has."""
    (rod, slider), (outer, guide, inner) = links, pairs
    d = Dyad(group.group, 2, rod, slider, outer, guide, inner)
    carrier = guide.other(slider)
    along = bench.motion.turn(carrier) * guide.along[carrier]
    reach = dot(along, bench.motion.place(inner.name) - bench.motion.place(outer.name))
    return replace(d, held=np.where(reach >= 0, 1.0, -1.0))
