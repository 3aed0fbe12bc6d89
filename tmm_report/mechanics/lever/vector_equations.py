"""The vector equations of the groups by name: which point about which, along which direction.

A dyad's closure has two sides that end in the same point, the vertex: v_B = v_A + v_BA = v_C + v_BC. A point of a
guide that just coincides with joint B is named B with the number of its link, "B4". Keys are those of the
readings and of results.json: "v_B", "v_BA", "a_BA_n", "a_BA_t", "a_B2B4_k", "a_B2B4_r", "w_2", "e_2".
A group above class II has as many branches as lead over its links from one joint to the next; they are solved together.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from tmm_report.mechanics.calculus.vectors import if_known
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.dyads import Dyad, close
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import SINGULAR, Linkage, Motion
from tmm_report.records import dataclass

Array = Any
Part = Literal["n", "t", "k", "r"]  # normal and tangential; Coriolis and relative


@dataclass(frozen=True)
class Branch:
    """One side of a dyad's vector equation.

    `start`: the point whose motion is known, None for a fixed one; `end`: the vertex. Either `link` turns about
    the joint `arm[0]`, along the arm to `arm[1]`, or the end slides along `guide`, which turns with `link`.
    """

    start: str | None
    end: str
    link: str
    pair: str  # subscript of the relative vector: BA is of B about A; a fixed start keeps its joint's name
    arm: tuple[str, str] | None = None
    guide: str | None = None

    @property
    def turns(self) -> bool:
        return self.arm is not None

    @property
    def v_key(self) -> str:
        return f"v_{self.end}" if self.start is None else f"v_{self.pair}"

    def a_key(self, part: Part) -> str:
        return f"a_{self.pair}_{part}" if self.start is not None or self.has_bend else f"a_{self.end}"

    @property
    def has_bend(self) -> bool:
        """Whether the acceleration has a normal or Coriolis part: not where a guide does not turn."""
        return self.turns or self.link != FRAME


@dataclass(frozen=True)
class Relation:
    """Both branches of one dyad; `left` is the side solved for x, `right` for y (see `dyads`)."""

    dyad: Dyad
    left: Branch
    right: Branch

    @property
    def branches(self) -> tuple[Branch, Branch]:
        return self.left, self.right

    @property
    def vertex(self) -> str:
        return self.left.end


@dataclass(frozen=True)
class System:
    """All branches of a group above class II; their vector equations are solved together."""

    group: HigherGroup
    branches: tuple[Branch, ...]

    @property
    def vertices(self) -> list[str]:
        """Points whose motion the equations give, in the order in which they are reached."""
        return list(dict.fromkeys(branch.end for branch in self.branches))


class _Names:
    """Names of relative vectors and of coinciding points in one mechanism."""

    def __init__(self, linkage: Linkage):
        self.named = set(linkage.mechanism.point_names)

    def join(self, first: str, second: str) -> str:
        """Both names in one index, told apart by a comma where they would make another point's name."""
        return f"{first},{second}" if first + second in self.named else first + second

    def turning(self, carrier: str, start: str, end: str, link: str, arm: tuple[str, str]) -> Branch:
        return Branch(_known(start, carrier), end, link, self.join(end, start), arm)

    def sliding(self, carrier: str, start: str, end: str, link: str, guide: str) -> Branch:
        moving = _known(start, carrier)
        return Branch(moving, end, link, self.join(end, moving) if moving else end, guide=guide)


def _known(point: str, carrier: str) -> str | None:
    return None if carrier == FRAME else point


def relation(linkage: Linkage, d: Dyad) -> Relation:
    """Name the vector equation of a dyad."""
    names = _Names(linkage)
    join, turning, sliding = names.join, names.turning, names.sliding
    a, b, inner = d.outer_a.name, d.outer_b.name, d.inner.name
    ca, cb = d.carrier_a, d.carrier_b
    if d.kind == 1:
        return Relation(d, turning(ca, a, inner, d.a, (a, inner)), turning(cb, b, inner, d.b, (b, inner)))
    if d.kind == 2:
        right = sliding(cb, join(inner, cb), inner, cb, b)
        return Relation(d, turning(ca, a, inner, d.a, (a, inner)), right)
    if d.kind == 3:
        vertex = join(b, d.a)
        return Relation(d, turning(ca, a, vertex, d.a, (a, b)), sliding(cb, b, vertex, d.a, inner))
    if d.kind == 4:
        left = sliding(ca, join(inner, ca), inner, ca, a)
        return Relation(d, left, sliding(cb, join(inner, cb), inner, cb, b))
    vertex = join(a, d.b)
    return Relation(d, sliding(cb, join(a, cb), vertex, cb, b), sliding(ca, a, vertex, cb, inner))


def system(linkage: Linkage, group: HigherGroup) -> System:
    """Name the vector equations of a group above class II: each of its links from the pivot through which it is found
    (or, where a guide carries it, from the first of its pivots) to its other pivots, and every guide."""
    names = _Names(linkage)
    pairs = (*group.group.outer, *group.group.inner)
    pivots = {link: [p.name for p in pairs if p.kind == "R" and link in p.links] for link in group.links}
    bases = {link: _base(group, link, pivots[link]) for link in group.links}
    fixed = set(linkage.mechanism.links[FRAME].points)

    def turning(link: str, end: str, to: str) -> Branch:
        base = bases[link]
        return names.turning(FRAME if base in fixed else link, base, end, link, (base, to))

    branches = [
        turning(link, to, to)
        for link in group.links
        for to in dict.fromkeys(pivots[link])
        if to != bases[link]
    ]
    for pair in pairs:
        if pair.kind == "P" and (point := _slider_point(pair, pivots, bases)):
            carrier, slider = pair.other(pair.slider), str(pair.slider)
            if slider not in group.links:  # the guide is in the group, what slides on it is known
                slider, carrier = carrier, slider
            coinciding = names.join(point, carrier)
            if carrier in group.links and bases[carrier]:
                branches.append(turning(carrier, coinciding, point))
            branches.append(names.sliding(carrier, coinciding, point, carrier, pair.name))
    return System(group, tuple(branches))


def _base(group: HigherGroup, link: str, pivots: list[str]) -> str:
    reference = group.references[link]
    return reference.name if reference.kind == "R" else next(iter(pivots), "")


def _slider_point(pair: Pair, pivots: dict[str, list[str]], bases: dict[str, str]) -> str:
    """The pivot of the sliding link by which its motion along a guide is told; of a guide on a known slider, that of
    the guide's link."""
    for link in (str(pair.slider), pair.other(pair.slider)):
        if pivots.get(link):
            return pivots[link][0]
    return ""


def relations(linkage: Linkage) -> list[Relation | System]:
    return [relation(linkage, g) if isinstance(g, Dyad) else system(linkage, g) for g in linkage.groups]


def moving_points(linkage: Linkage) -> list[str]:
    """Named points that move, in the order in which their links are found."""
    order = linkage.structure.order
    fixed = linkage.mechanism.links[FRAME].points
    carriers = linkage.carriers
    return [
        p
        for link in order
        for p in linkage.mechanism.links[link].points
        if carriers[p] == link and p not in fixed
    ]


def driving_pin(linkage: Linkage) -> str | None:
    """The driving link's joint by which its rates are drawn, rather than another of its points; None without any."""
    pair = linkage.structure.driver_pair
    mechanism = linkage.mechanism
    points = [p for p in mechanism.links[mechanism.driver.link].points if p != pair.name]
    return next((p for p in points if len(mechanism.links_at(p)) > 1), points[0] if points else None)


def turns_with(group: Dyad | HigherGroup) -> dict[str, str | None]:
    """Link of a group -> the link found before it that turns alike, None where its rotation is found with the group."""
    if isinstance(group, Dyad):
        a = None if group.kind <= 3 else group.carrier_a if group.kind == 4 else group.carrier_b
        b = None if group.kind == 1 else group.a if group.kind == 3 else group.carrier_b
        return {group.a: a, group.b: b}
    first: dict[int | str, str] = {}
    found: dict[str, str | None] = {}
    for link in group.links:
        root = group.loops.directions[link].root
        found[link] = root if isinstance(root, str) else first.get(root)
        first.setdefault(root, link)
    return found


def turning_links(linkage: Linkage) -> list[str]:
    """Links that can turn, the driving link first; a slider on a fixed guide cannot."""
    turning = {FRAME: False, linkage.mechanism.driver.link: True}
    turning |= {wheel.link: not wheel.slides for wheel in linkage.structure.wheels}
    for group in linkage.groups:
        for link, source in turns_with(group).items():
            turning[link] = source is None or turning[source]
        turning |= {wheel.link: not wheel.slides for wheel in group.group.wheels}
    return [link for link, turns in turning.items() if turns]


def named_values(motion: Motion) -> dict[str, Array]:
    """Every velocity, acceleration and angular rate of the note by its key; (..., P), SI.

    Vectors are complex; angular values are real, + counter-clockwise.
    """
    values: dict[str, Array] = {}
    for point in moving_points(motion.linkage):
        # of a point at the place of a fixed pivot both are the number 0
        values[f"v_{point}"] = np.asarray(motion.velocity(point), complex)
        values[f"a_{point}"] = np.asarray(motion.acceleration(point), complex)
    if motion.phase is not None:
        values |= _of_driving_pin(motion)
    for r in relations(motion.linkage):
        if isinstance(r, System) or (r.dyad.changes and r.dyad.kind <= 2):
            # in change points the vector equation itself says nothing: the values are those of the links' motion
            values |= _motion_values(motion, r)
        else:
            values |= _branch_values(motion, r)
    for link in turning_links(motion.linkage):
        values[f"w_{link}"] = motion.angular_velocity(link)
        values[f"e_{link}"] = motion.angular_acceleration(link)
    return values


def _of_driving_pin(motion: Motion) -> dict[str, Array]:
    """Normal and tangential acceleration of the driving link's pin, where that link does not turn uniformly."""
    pin, pivot = driving_pin(motion.linkage), motion.linkage.structure.driver_pair.name
    if pin is None:
        return {}
    link = motion.linkage.mechanism.driver.link
    arm = motion.place(pin) - motion.place(pivot)
    w, e = motion.angular_velocity(link), motion.angular_acceleration(link)
    return {f"a_{pin}{pivot}_n": -(w**2) * arm, f"a_{pin}{pivot}_t": 1j * e * arm}


def _branch_values(motion: Motion, r: Relation) -> dict[str, Array]:
    with np.errstate(invalid="ignore", divide="ignore"):
        c = close(motion.state, r.dyad)
    out: dict[str, Array] = {}
    sides = (
        (r.left, c.v_left, c.left.e, c.x, c.a_left, c.bend_left, c.xx),
        (r.right, c.v_right, c.right.e, c.y, c.a_right, c.bend_right, c.yy),
    )
    for branch, v_start, e, x, a_start, bend, xx in sides:
        if branch.start is not None:
            out[f"v_{branch.start}"], out[f"a_{branch.start}"] = v_start, a_start
        out[f"v_{branch.end}"], out[f"a_{branch.end}"] = v_start + x * e, a_start + bend + xx * e
        out[branch.v_key] = x * e
        if branch.has_bend:
            out[branch.a_key("n" if branch.turns else "k")] = bend
        out[branch.a_key("t" if branch.turns else "r")] = xx * e
    # a position whose rates are left out as singular has none here either
    known = np.isfinite(np.broadcast_to(motion.state.w[r.dyad.a], motion.shape))
    if r.dyad.changes:
        known = known & (motion.sines[r.dyad.group.label] > SINGULAR)
    return {key: if_known(known, value) for key, value in out.items()}


def _motion_values(motion: Motion, r: Relation | System) -> dict[str, Array]:
    """Values of the branches from the motion of their links."""
    out: dict[str, Array] = {}
    for branch in r.branches:
        out |= _turning_values(motion, branch) if branch.turns else _sliding_values(motion, branch)
    return out


def _turning_values(motion: Motion, branch: Branch) -> dict[str, Array]:
    s = motion.state
    start, to = (motion.place(point) for point in branch.arm or ())
    arm = to - start
    normal, tangential = -(s.w[branch.link] ** 2) * arm, 1j * s.e[branch.link] * arm
    out = {}
    if branch.end != (branch.arm or ("", ""))[1]:  # the point of the link that coincides with the joint
        reach = to - s.r[branch.link]
        out[f"v_{branch.end}"] = s.velocity(branch.link, reach)
        out[f"a_{branch.end}"] = s.acceleration(branch.link, reach)
    out[branch.v_key] = s.iw[branch.link] * arm
    return out | {branch.a_key("n"): normal, branch.a_key("t"): tangential}


def _sliding_values(motion: Motion, branch: Branch) -> dict[str, Array]:
    s, carrier = motion.state, branch.link
    v, a = motion.velocity(branch.end), motion.acceleration(branch.end)
    if branch.start is None:
        return {}
    reach = motion.place(branch.end) - s.r[carrier]
    v_start, a_start = s.velocity(carrier, reach), s.acceleration(carrier, reach)
    coriolis = 2 * s.iw[carrier] * (v - v_start)
    return {
        f"v_{branch.start}": v_start,
        f"a_{branch.start}": a_start,
        branch.v_key: v - v_start,
        branch.a_key("k"): coriolis,
        branch.a_key("r"): a - a_start - coriolis,
    }
