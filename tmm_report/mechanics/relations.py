"""The vector equations of the dyads by name: which point about which, along which direction.

A dyad's closure has two sides that end in the same point, the vertex: v_B = v_A + v_BA = v_C + v_BC. A point of a
guide that just coincides with joint B is named B with the number of its link, "B4". Keys are those of the
readings and of results.json: "v_B", "v_BA", "a_BA_n", "a_BA_t", "a_B2B4_k", "a_B2B4_r", "w_2", "e_2".
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from tmm_report.mechanics.dyads import Dyad, close
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.motion import Linkage, Motion

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
    def vertex(self) -> str:
        return self.left.end


def relation(linkage: Linkage, d: Dyad) -> Relation:
    """Name the vector equation of a dyad."""

    named = set(linkage.mechanism.point_names)

    def join(first: str, second: str) -> str:
        """Both names in one index, told apart by a comma where they would make another point's name."""
        return f"{first},{second}" if first + second in named else first + second

    def known(point: str, carrier: str) -> str | None:
        return None if carrier == FRAME else point

    def turning(carrier: str, start: str, end: str, link: str, arm: tuple[str, str]) -> Branch:
        return Branch(known(start, carrier), end, link, join(end, start), arm)

    def sliding(carrier: str, start: str, end: str, link: str, guide: str) -> Branch:
        moving = known(start, carrier)
        return Branch(moving, end, link, join(end, moving) if moving else end, guide=guide)

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


def relations(linkage: Linkage) -> list[Relation]:
    return [relation(linkage, d) for d in linkage.dyads]


def moving_points(linkage: Linkage) -> list[str]:
    """Named points that move, in the order in which their links are found."""
    order = [linkage.mechanism.driver.link, *(link for d in linkage.dyads for link in (d.a, d.b))]
    fixed = linkage.mechanism.links[FRAME].points
    carriers = linkage.carriers
    return [
        p
        for link in order
        for p in linkage.mechanism.links[link].points
        if carriers[p] == link and p not in fixed
    ]


def turning_links(linkage: Linkage) -> list[str]:
    """Links that can turn, the driving link first; a slider on a fixed guide cannot."""
    turning = {FRAME: False, linkage.mechanism.driver.link: True}
    for d in linkage.dyads:
        turning[d.a] = d.kind <= 3 or turning[d.carrier_a if d.kind == 4 else d.carrier_b]
        turning[d.b] = d.kind == 1 or turning[d.a if d.kind == 3 else d.carrier_b]
    return [link for link, turns in turning.items() if turns]


def named_values(motion: Motion) -> dict[str, Array]:
    """Every velocity, acceleration and angular rate of the note by its key; (..., P), SI.

    Vectors are complex; angular values are real, + counter-clockwise.
    """
    values: dict[str, Array] = {}
    for point in moving_points(motion.linkage):
        values[f"v_{point}"], values[f"a_{point}"] = motion.velocity(point), motion.acceleration(point)
    for r in relations(motion.linkage):
        values |= _branch_values(motion, r)
    for link in turning_links(motion.linkage):
        values[f"w_{link}"] = motion.angular_velocity(link)
        values[f"e_{link}"] = motion.angular_acceleration(link)
    return values


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
    return {key: np.where(known, value, np.nan) for key, value in out.items()}
