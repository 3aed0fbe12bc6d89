"""Loop equations of an Assur group of any class: positions, rates and how near a singular position is.

Unknown are the directions of the group's links and the displacements along its guides, k numbers for k links; links
joined by guides turn alike and share one direction. Every pair that is not needed to place a link closes a
contour, k/2 of them, and each contour is one complex equation, linear in the unknown vectors:

    known + Σ arm_c·U_c + Σ ±s_p·T_p = 0,      U_c = exp(iθ_c),  T_p the direction of a guide

Velocities and accelerations are linear: J q' = −(the same with the unknown rates put 0), one Jacobian for both.
Source: Levitsky, Theory of mechanisms and machines, ch. 3; Artobolevsky, ch. 4-5 (groups of class III and IV).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.dyads import State
from tmm_report.mechanics.mechanism import Scalar
from tmm_report.mechanics.structure import Group, Pair
from tmm_report.problems import N_, Message, ProblemError, mistake

Array = Any
Root = int | str  # what a direction turns with: an unknown direction by number, or a known link by name


@dataclass(frozen=True, eq=False)
class Direction:
    """A direction fixed to an unknown direction U_c or to a known link: U_c·turn, or u_link·turn."""

    root: Root
    turn: Scalar


@dataclass(frozen=True, eq=False)
class Form:
    """A vector linear in the unknown vectors: Σ points of known links + Σ vectors fixed to known links + Σ
    units[c]·U_c + Σ slides[p]·s_p·T_p."""

    points: tuple[tuple[int, str, Scalar], ...] = ()  # ±1, known link, place in its axes
    vectors: tuple[tuple[str, Scalar], ...] = ()
    units: tuple[tuple[int, Scalar], ...] = ()
    slides: tuple[tuple[int, int], ...] = ()

    def __add__(self, other: Form) -> Form:
        return Form(
            self.points + other.points,
            self.vectors + other.vectors,
            self.units + other.units,
            self.slides + other.slides,
        )

    def __neg__(self) -> Form:
        return Form(
            tuple((-sign, link, at) for sign, link, at in self.points),
            tuple((link, -arm) for link, arm in self.vectors),
            tuple((c, -arm) for c, arm in self.units),
            tuple((p, -sign) for p, sign in self.slides),
        )


class Loops:
    """The contours of one group. `q` everywhere is (..., P, k): directions, rad, then displacements over `size`."""

    def __init__(self, group: Group):
        self.group = group
        self.sliding = tuple(pair for pair in (*group.outer, *group.inner) if pair.kind == "P")
        self.directions = _directions(group)
        self.angles = 1 + max(
            (d.root for d in self.directions.values() if isinstance(d.root, int)), default=-1
        )
        self.guides = tuple(self._guide(pair) for pair in self.sliding)
        self.origins: dict[str, Scalar] = {}
        self.places: dict[str, Form] = {}
        self.references: dict[str, Pair] = {}
        self.closures = self._build()

    # ------------------------------------------------------------ building

    def _guide(self, pair: Pair) -> Direction:
        """Direction of a guide as seen from the group."""
        link = next(end for end in pair.links if end in self.directions)
        of = self.directions[link]
        return Direction(of.root, of.turn * pair.along[link])

    def _build(self) -> tuple[Form, ...]:
        """Place the links one from another, outer pairs first; the pairs left over close the contours."""
        waiting = [*self.group.outer, *self.group.inner]
        while len(self.places) < len(self.group.links):
            pair = next(p for p in waiting if self._open_end(p) is not None)
            waiting.remove(pair)
            child = str(self._open_end(pair))
            self.origins[child], self.references[child] = pair.at[child], pair
            gap = self._gap(pair, child)
            self.places[child] = self._point(pair.other(child), pair.at[pair.other(child)]) + gap
        return tuple(self._closure(pair) for pair in waiting)

    def _open_end(self, pair: Pair) -> str | None:
        """The link that the pair can place from its other end; None where both or neither are placed."""
        known = [end not in self.group.links or end in self.places for end in pair.links]
        return pair.links[known.index(False)] if sum(known) == 1 else None

    def _point(self, link: str, at: Scalar) -> Form:
        if link not in self.group.links:
            return Form(points=((1, link, at),))
        return self.places[link] + self._fixed(link, at - self.origins[link])

    def _fixed(self, link: str, arm: Scalar) -> Form:
        """A vector fixed to a link of the group."""
        of = self.directions[link]
        if isinstance(of.root, str):
            return Form(vectors=((of.root, of.turn * arm),))
        return Form(units=((of.root, of.turn * arm),))

    def _gap(self, pair: Pair, end: str) -> Form:
        """From the other link's joint to that of `end`: nothing in a pivot, ±s·T along a guide."""
        if pair.kind == "R":
            return Form()
        return Form(slides=((self.sliding.index(pair), 1 if end == pair.slider else -1),))

    def _closure(self, pair: Pair) -> Form:
        one, other = pair.links
        return self._point(one, pair.at[one]) + self._gap(pair, other) + -self._point(other, pair.at[other])

    @cached_property
    def _rows(self) -> tuple[Form, ...]:
        """The contours, then the places of the links."""
        return (*self.closures, *(self.places[link] for link in self.group.links))

    @cached_property
    def units(self) -> Array:
        """Coefficients of U, (rows, angles) or (rows, angles, V, 1), m."""
        rows = [
            [sum((arm for c, arm in form.units if c == n), 0j) for n in range(self.angles)]
            for form in self._rows
        ]
        shape = np.broadcast_shapes(*(np.shape(x) for row in rows for x in row))
        rows = [[np.broadcast_to(x, shape) for x in row] for row in rows]
        return np.array(rows, dtype=complex).reshape(len(self._rows), self.angles, *shape)

    @cached_property
    def slides(self) -> Array:
        """Coefficients of s·T, (rows, guides)."""
        count = len(self.sliding)
        rows = [[sum(sign for p, sign in form.slides if p == n) for n in range(count)] for form in self._rows]
        return np.array(rows, dtype=float).reshape(len(self._rows), count)

    @cached_property
    def size(self) -> float:
        """The longest arm of the group, m: its measure of length."""
        arms = [pair.at[link] for pair in (*self.group.outer, *self.group.inner) for link in pair.links]
        sizes = (np.max(np.abs(x), initial=0.0) for x in (self.units, *arms))
        return float(next((size for size in sizes if size > 0), 1.0))

    @cached_property
    def turns_with(self) -> Array:
        """1 where a guide (row) turns with an unknown direction (column)."""
        rows = [[float(guide.root == c) for c in range(self.angles)] for guide in self.guides]
        return np.array(rows).reshape(len(self.guides), self.angles)

    # ------------------------------------------------------------ positions

    def vectors(self, s: State, q: Array) -> tuple[Array, Array, Array]:
        """U (angles, ..., P), T and s·T (guides, ..., P), the last in m."""
        shape = q.shape[:-1]
        U = np.exp(1j * np.moveaxis(q[..., : self.angles], -1, 0))
        slides = self.size * np.moveaxis(q[..., self.angles :], -1, 0)
        if not self.guides:
            none = np.zeros((0, *shape), dtype=complex)
            return U, none, none
        rows = [
            np.broadcast_to((U[g.root] if isinstance(g.root, int) else s.u[g.root]) * g.turn, shape)
            for g in self.guides
        ]
        T = np.array(rows, dtype=complex).reshape(len(rows), *shape)
        return U, T, slides * T

    def _arms(self, U: Array, rows: slice = slice(None)) -> Array:
        """Coefficients times U, (rows, angles, ..., P)."""
        units = self.units[rows]
        own = units.shape[2:]
        units = units.reshape(*units.shape[:2], *(1,) * (U.ndim - 1 - len(own)), *own)
        return units * U

    def _sum(self, U: Array, W: Array, rows: slice) -> Array:
        return self._arms(U, rows).sum(axis=1) + np.tensordot(self.slides[rows], W, axes=1)

    def _known(self, s: State, rows: slice, shape: tuple[int, ...], order: int) -> Array:
        """The known part of the rows, or its first or second derivative, (rows, ..., P)."""
        return np.array([np.broadcast_to(_known(s, form, order), shape) for form in self._rows[rows]])

    @property
    def _contours(self) -> slice:
        return slice(0, len(self.closures))

    @property
    def _links(self) -> slice:
        return slice(len(self.closures), None)

    def residual(self, s: State, q: Array) -> Array:
        """By how much the contours do not close, over `size`, (..., P, k)."""
        return self.closing(s, q, self.gaps(s, q))[0]

    def gaps(self, s: State, q: Array) -> Array:
        """The known part of the contours, which does not change with q, (k/2, ..., P), m."""
        return self._known(s, self._contours, q.shape[:-1], 0)

    def closing(self, s: State, q: Array, gaps: Array) -> tuple[Array, Array]:
        """The residual and the Jacobian at q."""
        U, T, W = self.vectors(s, q)
        arms, sliding = self._arms(U, self._contours), self._sliding(W)
        residual = gaps + arms.sum(axis=1) + (sliding * W).sum(axis=1)
        return self._real(residual), self._jacobian(arms, sliding, T, W)

    def _real(self, contours: Array) -> Array:
        """Complex (k/2, ..., P), m -> real (..., P, k) over `size`."""
        return np.moveaxis(np.concatenate([contours.real, contours.imag]), 0, -1) / self.size

    def jacobian(self, s: State, q: Array) -> Array:
        """∂residual/∂q, (..., P, k, k)."""
        U, T, W = self.vectors(s, q)
        return self._jacobian(self._arms(U, self._contours), self._sliding(W), T, W)

    def _sliding(self, W: Array) -> Array:
        """Coefficients of s·T in the contours, to be multiplied by arrays like W."""
        return self.slides[self._contours].reshape(len(self.closures), -1, *(1,) * (W.ndim - 1))

    def _jacobian(self, arms: Array, sliding: Array, T: Array, W: Array) -> Array:
        if not len(W):
            columns = 1j * arms / self.size
            return np.moveaxis(np.concatenate([columns.real, columns.imag]), (0, 1), (-2, -1))
        turned = np.moveaxis(np.tensordot(sliding * W, self.turns_with, axes=(1, 0)), -1, 1)
        columns = np.concatenate([1j * (arms + turned) / self.size, sliding * T], axis=1)
        return np.moveaxis(np.concatenate([columns.real, columns.imag]), (0, 1), (-2, -1))

    def place(self, s: State, q: Array) -> None:
        """Add the poses of the links to the state."""
        U, _, W = self.vectors(s, q)
        r = self._known(s, self._links, q.shape[:-1], 0) + self._sum(U, W, self._links)
        for k, link in enumerate(self.group.links):
            of = self.directions[link]
            s.o[link], s.r[link] = self.origins[link], r[k]
            s.u[link] = (U[of.root] if isinstance(of.root, int) else s.u[of.root]) * of.turn

    def read(self, s: State) -> Array:
        """q of links already placed in the state, (..., P, k): the inverse of `place`."""
        shape = np.broadcast_shapes(*(np.shape(s.u[link]) for link in self.group.links))
        q = np.empty((*shape, self.angles + len(self.sliding)))
        for link in self.group.links:
            of = self.directions[link]
            if isinstance(of.root, int):
                q[..., of.root] = np.angle(s.u[link] / of.turn)
        for p, pair in enumerate(self.sliding):
            slider = str(pair.slider)
            carrier = pair.other(slider)
            t = s.u[carrier] * pair.along[carrier]
            gap = s.world(slider, pair.at[slider]) - s.world(carrier, pair.at[carrier])
            q[..., self.angles + p] = (t.conjugate() * gap).real / self.size
        return q

    # ------------------------------------------------------------ rates

    def known_rate(self, s: State, q: Array) -> Array:
        """First derivative of the contours by time with q kept, (..., P, k)."""
        _, _, W = self.vectors(s, q)
        shape = q.shape[:-1]
        moving = self._turning(s, W, order=1)
        rate = self._known(s, self._contours, shape, 1) + np.tensordot(
            self.slides[self._contours], moving, axes=1
        )
        return self._real(rate)

    def bend(self, s: State, q: Array, rate: Array) -> Array:
        """Second derivative of the contours by time with q' = `rate` and q'' = 0, (..., P, k)."""
        U, W = self._second(s, q, rate, None)
        contours = self._known(s, self._contours, q.shape[:-1], 2) + self._sum(U, W, self._contours)
        return self._real(contours)

    def _turning(self, s: State, W: Array, order: int) -> Array:
        """Derivative of s·T with s kept, of guides on known links; 0 of the others."""
        rates = [0.0 if isinstance(g.root, int) else (s.iw, s.ie)[order - 1][g.root] for g in self.guides]
        return np.array([np.broadcast_to(x, W.shape[1:]) for x in rates]).reshape(W.shape) * W

    def _second(self, s: State, q: Array, rate: Array, second: Array | None) -> tuple[Array, Array]:
        """Second derivatives of U and of s·T; `second` None stands for 0."""
        U, T, W = self.vectors(s, q)
        zero = np.zeros_like(rate) if second is None else second
        w, e = (np.moveaxis(x[..., : self.angles], -1, 0) for x in (rate, zero))
        v, a = (self.size * np.moveaxis(x[..., self.angles :], -1, 0) for x in (rate, zero))
        iw, ie = 1j * w, 1j * e - w * w
        turn = [
            (iw[g.root], ie[g.root]) if isinstance(g.root, int) else (s.iw[g.root], s.ie[g.root])
            for g in self.guides
        ]
        first = np.array([np.broadcast_to(x, W.shape[1:]) for x, _ in turn]).reshape(W.shape)
        bent = np.array([np.broadcast_to(x, W.shape[1:]) for _, x in turn]).reshape(W.shape)
        return ie * U, a * T + 2 * v * first * T + bent * W

    def move(self, s: State, q: Array) -> None:
        """Add the rates of the links to the state."""
        U, T, W = self.vectors(s, q)
        shape = q.shape[:-1]
        J = self.jacobian(s, q)
        rate = -solve_each(J, self.known_rate(s, q))
        second = -solve_each(J, self.bend(s, q, rate))
        w, e = (np.moveaxis(x[..., : self.angles], -1, 0) for x in (rate, second))
        iwU = 1j * w * U
        dW = self.size * np.moveaxis(rate[..., self.angles :], -1, 0) * T
        dW = dW + self._turning(s, W, 1) + np.tensordot(self.turns_with, 1j * w, axes=1) * W
        v = self._known(s, self._links, shape, 1) + self._sum(iwU, dW, self._links)
        for link in self.group.links:
            root = self.directions[link].root
            if isinstance(root, int):
                s.turn(link, w[root], e[root])
            else:
                s.turn_with(link, root)
        a = self._known(s, self._links, shape, 2) + self._sum(*self._second(s, q, rate, second), self._links)
        for k, link in enumerate(self.group.links):
            s.carry(link, v[k], a[k])

    def closeness(self, s: State, q: Array) -> Array:
        """Smallest singular value of the Jacobian with columns of length 1, (..., P): 0 in a singular position."""
        J = self.jacobian(s, q)
        lost = ~np.isfinite(J).all(axis=(-2, -1))
        J = np.where(lost[..., None, None], 0.0, J / np.linalg.norm(J, axis=-2, keepdims=True))
        return np.where(lost, np.nan, np.linalg.svd(J, compute_uv=False)[..., -1])


def _directions(group: Group) -> dict[str, Direction]:
    """Direction of every link: links joined by guides turn alike. Raises ProblemError for a contour of guides alone."""
    found: dict[str, Direction] = {}
    sliding = [pair for pair in (*group.outer, *group.inner) if pair.kind == "P"]

    def spread() -> None:
        while pair := next(
            (p for p in sliding if any(end in found or end not in group.links for end in p.links)), None
        ):
            sliding.remove(pair)
            known = next(end for end in pair.links if end in found or end not in group.links)
            other = pair.other(known)
            of = found.get(known, Direction(known, 1.0))
            if other in found:
                raise ProblemError([_only_guides(pair, group)])
            found[other] = Direction(of.root, of.turn * pair.along[known] / pair.along[other])

    spread()
    count = 0
    for link in group.links:
        if link not in found:
            found[link] = Direction(count, 1.0)
            count += 1
            spread()
    return found


def _only_guides(pair: Pair, group: Group) -> Any:
    text = N_("links %(links)s are joined in a contour by sliding pairs alone: a translation stays free")
    right = Message(N_("make one of the pairs a pivot"))
    return mistake(text, ("mechanism", "guides", pair.name), right, links=", ".join(group.links))


def _known(s: State, form: Form, order: int) -> Array:
    """The known part of a form, or its first or second derivative."""
    total: Array = 0j
    for sign, link, at in form.points:
        if order == 0:
            total = total + sign * s.world(link, at)
        else:
            rate = s.velocity if order == 1 else s.acceleration
            total = total + sign * rate(link, s.u[link] * (at - s.o[link]))
    for link, arm in form.vectors:
        total = total + (1.0, s.iw.get(link), s.ie.get(link))[order] * s.u[link] * arm
    return total


def solve_each(A: Array, b: Array) -> Array:
    """Solve A x = b for every position, (..., P, k); nan where A is singular or not finite."""
    lost = ~(np.isfinite(A).all(axis=(-2, -1)) & np.isfinite(b).all(axis=-1))
    A = np.where(lost[..., None, None], np.eye(A.shape[-1]), A)
    try:
        x = np.linalg.solve(A, b[..., None])[..., 0]
    except np.linalg.LinAlgError:  # one singular position raises for the whole stack
        lost = lost | (np.linalg.det(A) == 0)
        x = np.linalg.solve(np.where(lost[..., None, None], np.eye(A.shape[-1]), A), b[..., None])[..., 0]
    return np.where(lost[..., None], np.nan, x)


def newton(loops: Loops, s: State, q: Array, steps: int = 8) -> Array:
    """Close the contours from `q`, (..., P, k); nan where the iteration does not settle."""
    gaps = loops.gaps(s, q)
    for _ in range(steps):
        residual, J = loops.closing(s, q, gaps)
        step = solve_each(J, residual)
        q = q - step
        if not np.any(np.abs(step) > 1e-9):  # what remains is its square
            break
    size = np.abs(step).max(axis=-1)
    return np.where((size < 1e-6)[..., None], q, np.nan)
