"""The five dyads (Assur groups of class II) in closed form: positions, rates and reactions.

A dyad hangs on known links by its outer pairs. Its closure is one vector equation with two unknown numbers,

    left + x·e1 = right + y·e2      (plan of velocities, and with more known terms, of accelerations)

so one 2×2 solution serves all five kinds; sin(e1, e2) tells how near a singular position is.

    kind          a (first link)      b (second link)      x            y            root: `sign` = +1 when
    1 RRR         outer A, inner B    outer C, inner B     ω_a          ω_b          B is left of the line A → C
    2 RRP         outer A, inner B    slides on c          ω_a          s'(b on c)   B is ahead of A's foot on the guide
    3 RPR         carries the guide,  slides on a,         ω_a = ω_b    s'(b on a)   C is ahead of A's foot on the guide
                  outer A             outer C
    4 PRP         slides on c1        slides on c2         s'(a on c1)  s'(b on c2)  (one root)
    5 RPP         outer A, slides     slides on c          s'(b on c)   s'(a, b)     (one root)
                  on b
"Ahead": on the side to which the guide's direction points. c, c1, c2 are known links that carry a guide.

Statics is the transpose: the outer reaction R_a has two known moments or components, R_a × f1 = c1, R_a × f2 = c2.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 4-5, 13; Levitsky, ch. 3.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import components, cross, dual, is_zero, resolve, sine
from tmm_report.mechanics.lever.assur_groups import Group, Pair
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism, Scalar
from tmm_report.records import dataclass

Array = Any
ROUNDING = 1e-12  # square of a sine that cannot be told from 0
PARALLEL = 1e-12  # sine of two guides whose crossing would be made of rounding errors


@dataclass(eq=False)
class State:
    """Motion of the links found so far, by link name; arrays (..., P), SI.

    A link is carried by its reference point, the joint through which it was found: `o` is that point in the
    link's axes, `r` its world place, `v`, `a` its velocity and acceleration. `u` is the direction of the link's
    x axis, `w`, `e` its angular velocity and acceleration; `iw` = iω and `ie` = iε − ω² turn an arm into the
    velocity and acceleration of its end.
    """

    o: dict[str, Array] = field(default_factory=dict)
    r: dict[str, Array] = field(default_factory=dict)
    u: dict[str, Array] = field(default_factory=dict)
    v: dict[str, Array] = field(default_factory=dict)
    w: dict[str, Array] = field(default_factory=dict)
    a: dict[str, Array] = field(default_factory=dict)
    e: dict[str, Array] = field(default_factory=dict)
    iw: dict[str, Array] = field(default_factory=dict)
    ie: dict[str, Array] = field(default_factory=dict)
    phi: Array = 0.0  # angle of the driving link's x axis, rad

    def world(self, link: str, at: Array) -> Array:
        """World place of the point `at` of a link."""
        arm = at - self.o[link]
        return self.r[link] if is_zero(arm) else self.r[link] + self.u[link] * arm

    def velocity(self, link: str, arm: Array) -> Array:
        """Velocity of the point of a link at `arm` from its reference point, world axes, m/s."""
        return self.v[link] + self.iw[link] * arm

    def acceleration(self, link: str, arm: Array) -> Array:
        return self.a[link] + self.ie[link] * arm

    def turn(self, link: str, w: Array, e: Array) -> None:
        """Set a link's angular velocity and acceleration."""
        self.w[link], self.e[link] = w, e
        self.iw[link], self.ie[link] = 1j * w, 1j * e - w * w

    def turn_with(self, link: str, carrier: str) -> None:
        """A link that slides on its carrier turns as the carrier does."""
        for rate in (self.w, self.e, self.iw, self.ie):
            rate[link] = rate[carrier]

    def carry(self, link: str, v: Array, a: Array) -> None:
        """Set the motion of a link's reference point."""
        self.v[link], self.a[link] = v, a


@dataclass(frozen=True, eq=False)
class Dyad:
    """A dyad with its links in the order of the table above and its root.

    `sign` is stated for the driver angle `told_at`, rad. At the driver angles `changes` the two roots meet, and there
    the motion goes smoothly on to the other sign; at `corner` they meet and the sign stays. `size`: greatest distance
    A-C of kind 3 over the cycle, m. `held`: the sign at each of the positions that are being solved, where it is told
    one by one.
    """

    group: Group
    kind: int
    a: str
    b: str
    outer_a: Pair
    outer_b: Pair
    inner: Pair
    sign: int = 1
    changes: tuple[float, ...] = ()
    corner: float | None = None
    told_at: float | None = None
    sense: int = 1  # of the driving link's rotation
    size: Scalar = None
    held: Array = None

    @cached_property
    def carrier_a(self) -> str:
        return self.outer_a.other(self.a)

    @cached_property
    def carrier_b(self) -> str:
        return self.outer_b.other(self.b)

    @cached_property
    def arm_a(self) -> Scalar:
        """From the outer joint of link a to the inner one, in the link's axes, m."""
        return self.inner.at[self.a] - self.outer_a.at[self.a]

    @cached_property
    def arm_b(self) -> Scalar:
        return self.inner.at[self.b] - self.outer_b.at[self.b]

    @property
    def links(self) -> tuple[str, str]:
        return self.a, self.b

    @cached_property
    def references(self) -> dict[str, Pair]:
        """The joints that are the reference points of a and of b (see `State`)."""
        of_a = self.inner if self.kind == 4 else self.outer_a
        of_b = self.outer_b if self.kind in (1, 3) else self.inner
        return {self.a: of_a, self.b: of_b}

    def root(self, phi: Array) -> Array:
        """The sign at driver angles `phi`, rad."""
        if self.held is not None:
            return self.held
        if not self.changes:
            return self.sign
        passed = np.searchsorted(self._changes_after, np.mod(phi - (self.told_at or 0.0), 2 * np.pi))
        return np.where(passed % 2 == 0, self.sign, -self.sign)

    @cached_property
    def _changes_after(self) -> Array:
        """Change points as angles from `told_at`, ascending; one at `told_at` itself comes before what is told."""
        after = np.mod(np.array(self.changes) - (self.told_at or 0.0), 2 * np.pi)
        at_once = np.minimum(after, 2 * np.pi - after) < 1e-9
        return np.sort(np.where(at_once, 2 * np.pi if self.sense > 0 else 0.0, after))

    def place(self, s: State) -> None:
        place(s, self)
        for wheel in self.group.wheels:
            wheel.place(s)

    def move(self, s: State) -> None:
        move(s, self)
        for wheel in self.group.wheels:
            wheel.move(s)

    def closeness(self, s: State) -> Array:
        """How far from a singular position, 1 … 0, (..., P)."""
        return singularity(s, self)

    @property
    def meetings(self) -> tuple[float, ...]:
        """Driver angles at which the two assemblies meet, the corner among them, rad."""
        return self.changes if self.corner is None else (*self.changes, self.corner)

    @property
    def two_roots(self) -> bool:
        return self.kind <= 3

    @property
    def joint(self) -> str | None:
        """Name of the inner revolute joint, if it is one."""
        return self.inner.name if self.inner.kind == "R" else None


def dyad(mechanism: Mechanism, group: Group, sign: int = 1) -> Dyad:
    """Order the links of a group of class II as the table above has them."""
    first, second = group.links
    of = {link: next(pair for pair in group.outer if link in pair.links) for link in group.links}
    inner = group.inner[0]
    if group.kind in (2, 5):
        swap = of[first].kind == "P"
    else:  # RPR: the carrier of the guide first; RRR, PRP: as described
        swap = inner.kind == "P" and mechanism.guides[inner.name].link == second
    a, b = (second, first) if swap else (first, second)
    return Dyad(group, group.kind or 0, a, b, of[a], of[b], inner, sign)


# ---------------------------------------------------------------- positions


def place(s: State, d: Dyad) -> None:
    """Add the poses of both links to the state.

    A position that cannot be assembled is nan; the caller holds back numpy's warnings of it.
    """
    _PLACE[d.kind](s, d)


def _outer(s: State, pair: Pair, carrier: str) -> Array:
    return s.world(carrier, pair.at[carrier])


def _refer(s: State, d: Dyad, r_a: Array, u_a: Array, r_b: Array, u_b: Array) -> None:
    """Place both links by their reference points."""
    s.o[d.a], s.r[d.a], s.u[d.a] = d.references[d.a].at[d.a], r_a, u_a
    s.o[d.b], s.r[d.b], s.u[d.b] = d.references[d.b].at[d.b], r_b, u_b


def _place_rrr(s: State, d: Dyad) -> None:
    p, q = d.arm_a, d.arm_b
    A, C = _outer(s, d.outer_a, d.carrier_a), _outer(s, d.outer_b, d.carrier_b)
    # B from A, in axes with x along A → C: the circles |p| and |q| meet at x = (|AC|² + |p|² − |q|²) / 2|AC|
    AC = C - A
    distance = np.abs(AC)
    pp = abs(p) ** 2
    x = (distance * distance + (pp - abs(q) ** 2)) / (2 * distance)
    AB = AC * ((x + 1j * _signed_root(s, d, pp - x * x, pp)) / distance)
    _refer(s, d, A, AB / p, C, (AB - AC) / q)


def _guide_line(s: State, outer: Pair, carrier: str, link: str, arm: Scalar) -> tuple[Array, Array, Array]:
    """Direction t of an outer guide, the sliding link's u, and a point of the line on which the end of its arm runs."""
    t = s.u[carrier] * outer.along[carrier]
    u = t * outer.along[link].conjugate()
    return t, u, _outer(s, outer, carrier) + u * arm


def _place_rrp(s: State, d: Dyad) -> None:
    A = _outer(s, d.outer_a, d.carrier_a)
    t, u, G = _guide_line(s, d.outer_b, d.carrier_b, d.b, d.arm_b)
    # in axes along the guide: B − A = x + ih, h the distance of A from the line, |x + ih| = |p|
    h = cross(t, G - A)
    pp = abs(d.arm_a) ** 2
    AB = t * (_signed_root(s, d, pp - h * h, pp) + 1j * h)
    _refer(s, d, A, AB / d.arm_a, A + AB, u)


def _offset(d: Dyad) -> Scalar:
    """Constant distance h of C from the parallel to the guide through A: the line lies the same way from both, m."""
    return cross(d.inner.along[d.a], d.arm_a) - cross(d.inner.along[d.b], d.arm_b)


def _signed_root(s: State, d: Dyad, square: Array, scale: Array) -> Array:
    """±√square by the dyad's sign; nan where it is negative, but at a change point rounding may make it so."""
    if d.meetings:
        square = np.where((square < 0) & (square > -ROUNDING * scale), 0.0, square)
    return d.root(s.phi) * np.sqrt(square)


def _place_rpr(s: State, d: Dyad) -> None:
    A, C = _outer(s, d.outer_a, d.carrier_a), _outer(s, d.outer_b, d.carrier_b)
    along_a, along_b = d.inner.along[d.a], d.inner.along[d.b]
    h = _offset(d)
    AC = C - A
    distance2 = AC.real**2 + AC.imag**2
    t = AC / (_signed_root(s, d, distance2 - h * h, distance2) + 1j * h)
    _refer(s, d, A, t * along_a.conjugate(), C, t * along_b.conjugate())


def _place_prp(s: State, d: Dyad) -> None:
    t1, u1, G1 = _guide_line(s, d.outer_a, d.carrier_a, d.a, d.arm_a)
    t2, u2, G2 = _guide_line(s, d.outer_b, d.carrier_b, d.b, d.arm_b)
    B = G1 + _along(G2 - G1, t1, -t2) * t1
    _refer(s, d, B, u1, B, u2)


def _place_rpp(s: State, d: Dyad) -> None:
    A = _outer(s, d.outer_a, d.carrier_a)
    t2 = s.u[d.carrier_b] * d.outer_b.along[d.carrier_b]
    u_b = t2 * d.outer_b.along[d.b].conjugate()
    t1 = u_b * d.inner.along[d.b]
    u_a = t1 * d.inner.along[d.a].conjugate()
    # b slides on its outer guide until its inner guide line passes through that of a
    G = _outer(s, d.outer_b, d.carrier_b) + u_b * d.arm_b
    _refer(s, d, A, u_a, G + _along(A + u_a * d.arm_a - G, t2, t1) * t2, u_b)


def _along(gap: Array, t1: Array, t2: Array) -> Array:
    """x of gap = x·t1 + y·t2, t1 and t2 unit: nan where they are parallel and their lines never meet."""
    x, _ = resolve(gap, t1, t2)
    return np.where(np.abs(cross(t1, t2)) > PARALLEL, x, np.nan)


_PLACE: dict[int, Callable[[State, Dyad], None]] = {
    1: _place_rrr,
    2: _place_rrp,
    3: _place_rpr,
    4: _place_prp,
    5: _place_rpp,
}


# ---------------------------------------------------------------- rates


@dataclass(frozen=True, eq=False)
class Side:
    """One side of a dyad's vector equation: from a joint whose motion is known, along an unknown vector.

    `joint`: world place, a point of the known link `carrier`; `e`: the unknown vector per unit of its number;
    `follows`: the link whose angular velocity turns a sliding direction (Coriolis), None where the unknown is
    itself an angular velocity and `e` is perpendicular to the arm.
    """

    joint: Array
    carrier: str
    e: Array
    follows: str | None = None

    def known(self, s: State) -> tuple[Array, Array]:
        """Velocity and acceleration of the joint."""
        if self.carrier == FRAME:
            return 0.0, 0.0
        arm = self.joint - s.r[self.carrier]
        return s.velocity(self.carrier, arm), s.acceleration(self.carrier, arm)

    def curvature(self, s: State, rate: Array) -> Array:
        """The known part of the relative acceleration: normal, iω·(iω·AB), or Coriolis, 2iω·s'·t."""
        if self.follows is None:
            return (rate * rate) * (1j * self.e)
        return 0.0 if self.follows == FRAME else (2 * rate) * s.iw[self.follows] * self.e


def sides(s: State, d: Dyad) -> tuple[Side, Side]:
    """Both sides of the closure: left joint's motion + x·e_left = right joint's motion + y·e_right."""
    A = s.r[d.a]  # its outer joint, but of kind 4 the inner one (see `place`)
    if d.kind == 4:
        return _sliding(s, d.outer_a, A, d.carrier_a), _sliding(s, d.outer_b, A, d.carrier_b)
    if d.kind == 5:  # b slides on c by x, a on b by −y; all three turn alike
        t1 = s.u[d.b] * d.inner.along[d.b]
        return _sliding(s, d.outer_b, A, d.carrier_b), Side(A, d.carrier_a, -t1, d.carrier_b)
    B = s.r[d.b]  # the inner joint of kind 2, the outer one of kinds 1 and 3
    if d.kind == 3:
        return Side(A, d.carrier_a, 1j * (B - A)), Side(B, d.carrier_b, -s.u[d.a] * d.inner.along[d.a], d.a)
    left = Side(A, d.carrier_a, s.u[d.a] * (1j * d.arm_a))
    if d.kind == 2:
        return left, _sliding(s, d.outer_b, B, d.carrier_b)
    return left, Side(B, d.carrier_b, s.u[d.b] * (1j * d.arm_b))


def _sliding(s: State, guide: Pair, joint: Array, carrier: str) -> Side:
    return Side(joint, carrier, s.u[carrier] * guide.along[carrier], carrier)


@dataclass(frozen=True, eq=False)
class Closure:
    """Both sides of a dyad's vector equations with their numbers, vectors in m/s and m/s², (..., P).

    Velocities: v_left + x·e_left = v_right + y·e_right; accelerations: a_left + bend_left + xx·e_left = the same
    of the right side, `bend` being the normal or Coriolis part.
    """

    left: Side
    right: Side
    v_left: Array
    v_right: Array
    x: Array
    y: Array
    a_left: Array
    a_right: Array
    bend_left: Array
    bend_right: Array
    xx: Array
    yy: Array


def close(s: State, d: Dyad) -> Closure:
    """Solve a placed dyad's velocities and accelerations."""
    left, right = sides(s, d)
    basis = dual(left.e, right.e)
    (v_left, a_left), (v_right, a_right) = left.known(s), right.known(s)
    x, y = components(v_right - v_left, *basis)
    if d.kind == 3:  # the guide turns with a, whose ω is x
        s.iw[d.a] = 1j * x
    bend_left, bend_right = left.curvature(s, x), right.curvature(s, y)
    xx, yy = components(a_right + bend_right - (a_left + bend_left), *basis)
    return Closure(left, right, v_left, v_right, x, y, a_left, a_right, bend_left, bend_right, xx, yy)


def move(s: State, d: Dyad) -> None:
    """Add the rates of both links to the state."""
    c = close(s, d)
    _turn(s, d, c.x, c.y, c.xx, c.yy)
    _carry(s, d, c)


def _turn(s: State, d: Dyad, x: Array, y: Array, xx: Array, yy: Array) -> None:
    """Angular rates of both links from the two unknowns and their derivatives."""
    if d.kind <= 3:
        s.turn(d.a, x, xx)
    else:
        s.turn_with(d.a, d.carrier_a if d.kind == 4 else d.carrier_b)
    if d.kind == 1:
        s.turn(d.b, y, yy)
    else:
        s.turn_with(d.b, d.a if d.kind == 3 else d.carrier_b)


def _carry(s: State, d: Dyad, c: Closure) -> None:
    """Motion of the links' reference points: joints of the known links, or the joint on the right side's guide."""
    left, right = (c.v_left, c.a_left), (c.v_right, c.a_right)
    if d.kind in (1, 3):
        s.carry(d.a, *left)
        s.carry(d.b, *right)
    elif d.kind == 5:
        s.carry(d.a, *right)
        # the equation gives the point of b that is at A
        v, a = c.v_left + c.x * c.left.e, c.a_left + c.bend_left + c.xx * c.left.e
        arm = s.r[d.b] - s.r[d.a]
        s.carry(d.b, v + s.iw[d.b] * arm, a + s.ie[d.b] * arm)
    else:
        end = c.v_right + c.y * c.right.e, c.a_right + c.bend_right + c.yy * c.right.e
        s.carry(d.a, *(left if d.kind == 2 else end))
        s.carry(d.b, *end)


def singularity(s: State, d: Dyad) -> Array:
    """Sine of the angle between the two unknown directions: 0 in a singular position of the dyad, (..., P).

    Of kind 3, where the guide of a link that A and C come near to loses its direction too: how long the guide is
    between A and C, over its greatest distance `size`.
    """
    if d.kind == 3 and d.size is not None:
        return np.sqrt(np.maximum(margin(s, d), 0.0))
    left, right = sides(s, d)
    return sine(left.e, right.e)


def margin(s: State, d: Dyad) -> Array:
    """Square of the sine, negative where the dyad cannot be assembled: smooth through the limit, (..., P).

    Needs the poses of the known links only. Kinds 4 and 5 can always be assembled but where their guides are parallel.
    """
    if d.kind > 3:
        second = s.u[d.carrier_b] * d.outer_b.along[d.carrier_b]
        if d.kind == 4:
            first = s.u[d.carrier_a] * d.outer_a.along[d.carrier_a]
        else:
            first = second * d.outer_b.along[d.b].conjugate() * d.inner.along[d.b]
        return cross(first, second) ** 2
    A = _outer(s, d.outer_a, d.carrier_a)
    if d.kind == 2:
        t, _, G = _guide_line(s, d.outer_b, d.carrier_b, d.b, d.arm_b)
        return 1 - (cross(t, G - A) / abs(d.arm_a)) ** 2
    AC = _outer(s, d.outer_b, d.carrier_b) - A
    distance2 = AC.real**2 + AC.imag**2
    if d.kind == 3:
        return (distance2 - _offset(d) ** 2) / (distance2 if d.size is None else d.size**2)
    p, q = abs(d.arm_a), abs(d.arm_b)
    return 1 - ((p * p + q * q - distance2) / (2 * p * q)) ** 2


def reach(s: State, d: Dyad) -> Array:
    """What a dyad's lengths must bridge, (..., P), m: |AC| of kinds 1 and 3, of kind 2 A's distance from the guide."""
    A = _outer(s, d.outer_a, d.carrier_a)
    if d.kind == 2:
        t, _, G = _guide_line(s, d.outer_b, d.carrier_b, d.b, d.arm_b)
        return np.abs(cross(t, G - A))
    return np.abs(_outer(s, d.outer_b, d.carrier_b) - A)
