"""Loop equations of an Assur group of any class: positions, rates and how near a singular position is.

Unknown are the directions of the group's links and the displacements along its guides, k numbers for k links; links
joined by guides turn alike and share one direction. Every pair that is not needed to place a link closes a
contour, k/2 of them, and each contour is one complex equation, linear in the unknown vectors:

    known + Σ arm_c·U_c + Σ ±s_p·T_p = 0,      U_c = exp(iθ_c),  T_p the direction of a guide

Velocities and accelerations are linear: J q' = −(the same with the unknown rates put 0), one Jacobian for both.
Source: Levitsky, Theory of mechanisms and machines, ch. 3; Artobolevsky, ch. 4-5 (groups of class III and IV).
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.vector_contours import Contours, Direction, Form, known_part

Array = Any
__all__ = ["Direction", "Form", "Loops", "newton", "solve_each"]


class Vectors(NamedTuple):
    """Unit directions U (angles, ..., P); of the guides T and s·T (guides, ..., P), the latter W in m."""

    U: Array
    T: Array
    W: Array


class Loops(Contours):
    """The contours of one group. `q` everywhere is (..., P, k): directions, rad, then displacements over `size`."""

    # ------------------------------------------------------------ positions

    def vectors(self, s: State, q: Array) -> Vectors:
        """The vectors of the unknown directions and guides at q."""
        numbers = _first(q)
        U = np.empty((self.angles, *q.shape[:-1]), dtype=complex)
        U.real, U.imag = np.cos(numbers[: self.angles]), np.sin(numbers[: self.angles])
        T = self._along(s, U)
        return Vectors(U, T, self.size * numbers[self.angles :] * T)

    def _along(self, s: State, U: Array) -> Array:
        """Unit directions of the guides, (guides, ..., P)."""
        T = np.empty((len(self.guides), *U.shape[1:]), dtype=complex)
        for p, guide in enumerate(self.guides):
            T[p] = (U[guide.root] if isinstance(guide.root, int) else s.u[guide.root]) * guide.turn
        return T

    def placed(self, s: State) -> Vectors:
        """The vectors of links already placed in the state."""
        shape = np.broadcast_shapes(*(np.shape(s.u[link]) for link in self.group.links))
        U = np.empty((self.angles, *shape), dtype=complex)
        for link in self.group.links:
            of = self.directions[link]
            if isinstance(of.root, int):
                U[of.root] = s.u[link] / of.turn
        T = self._along(s, U)
        W = np.empty(T.shape, dtype=complex)
        for p, pair in enumerate(self.sliding):
            W[p] = self._displacement(s, pair, T[p]) * T[p]
        return Vectors(U, T, W)

    def _displacement(self, s: State, pair: Pair, t: Array) -> Array:
        """How far the slider stands along the guide of direction `t`, m."""
        slider = str(pair.slider)
        carrier = pair.other(slider)
        gap = s.world(slider, pair.at[slider]) - s.world(carrier, pair.at[carrier])
        return dot(t, gap)

    def read(self, s: State) -> Array:
        """q of links already placed in the state, (..., P, k): the inverse of `place`."""
        at = self.placed(s)
        slides = [self._displacement(s, pair, at.T[p]) for p, pair in enumerate(self.sliding)]
        q = np.empty((*at.U.shape[1:], self.angles + len(slides)))
        for c, u in enumerate(at.U):
            q[..., c] = np.angle(u)
        for p, x in enumerate(slides, start=self.angles):
            q[..., p] = x / self.size
        return q

    def _arms(self, U: Array, rows: slice) -> Array:
        """Coefficients times U, (rows, angles, ..., P)."""
        units = self.units[rows]
        own = units.shape[2:]
        return units.reshape(*units.shape[:2], *(1,) * (U.ndim - 1 - len(own)), *own) * U

    def _slid(self, W: Array, rows: slice) -> Array:
        """Coefficients times vectors of the guides, (rows, guides, ..., P)."""
        signs = self.slides[rows]
        return signs.reshape(*signs.shape, *(1,) * (W.ndim - 1)) * W

    def _sum(self, U: Array, W: Array, rows: slice) -> Array:
        total = self._arms(U, rows).sum(axis=1)
        return total + self._slid(W, rows).sum(axis=1) if len(W) else total

    def _known(self, s: State, rows: slice, shape: tuple[int, ...], order: int) -> Array:
        """The known part of the rows, or its first or second derivative, (rows, ..., P)."""
        forms = self._rows[rows]
        found = np.empty((len(forms), *shape), dtype=complex)
        for k, form in enumerate(forms):
            found[k] = known_part(s, form, order)
        return found

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
        at = self.vectors(s, q)
        arms, slid = self._arms(at.U, self._contours), self._slid(at.W, self._contours)
        residual = gaps + arms.sum(axis=1)
        if len(slid[0]):
            residual += slid.sum(axis=1)
        return self._real(residual), self._columns(at, arms, slid)

    def _real(self, contours: Array) -> Array:
        """Complex (k/2, ..., P), m -> real (..., P, k) over `size`."""
        return _last(np.concatenate([contours.real, contours.imag])) / self.size

    def jacobian(self, s: State, q: Array) -> Array:
        """∂residual/∂q, (..., P, k, k)."""
        return self._jacobian(self.vectors(s, q))

    def _jacobian(self, at: Vectors) -> Array:
        return self._columns(at, self._arms(at.U, self._contours), self._slid(at.W, self._contours))

    def _columns(self, at: Vectors, arms: Array, slid: Array) -> Array:
        """The Jacobian: a column for every direction, and what turns with it, and for every displacement."""
        n, rows, k = self.angles, len(arms), self.angles + len(self.guides)
        turned = arms / self.size
        for p, guide in enumerate(self.guides):
            if isinstance(guide.root, int):
                turned[:, guide.root] += slid[:, p] / self.size
        J = np.empty((2 * rows, k, *arms.shape[2:]))
        J[:rows, :n], J[rows:, :n] = -turned.imag, turned.real
        if k > n:
            along = self._slid(at.T, self._contours)
            J[:rows, n:], J[rows:, n:] = along.real, along.imag
        return _last(J, 2)

    def place(self, s: State, q: Array) -> None:
        """Add the poses of the links to the state."""
        at = self.vectors(s, q)
        r = self._known(s, self._links, q.shape[:-1], 0) + self._sum(at.U, at.W, self._links)
        for k, link in enumerate(self.group.links):
            of = self.directions[link]
            s.o[link], s.r[link] = self.origins[link], r[k]
            s.u[link] = (at.U[of.root] if isinstance(of.root, int) else s.u[of.root]) * of.turn

    # ------------------------------------------------------------ rates

    def known_rate(self, s: State, q: Array) -> Array:
        """First derivative of the contours by time with q kept, (..., P, k)."""
        return self._known_rate(s, self.vectors(s, q))

    def _known_rate(self, s: State, at: Vectors) -> Array:
        known = self._known(s, self._contours, at.U.shape[1:], 1)
        return self._real(known + self._slid(self._turning(s, at.W), self._contours).sum(axis=1))

    def _turning(self, s: State, W: Array) -> Array:
        """Derivative of s·T with s kept, of guides on known links; 0 of the others."""
        turning = np.zeros_like(W)
        for p, guide in enumerate(self.guides):
            if isinstance(guide.root, str):
                turning[p] = s.iw[guide.root] * W[p]
        return turning

    def bend(self, s: State, q: Array, rate: Array) -> Array:
        """Second derivative of the contours by time with q' = `rate` and q'' = 0, (..., P, k)."""
        return self._bend(s, self.vectors(s, q), rate)

    def _bend(self, s: State, at: Vectors, rate: Array) -> Array:
        U, W = self._second(s, at, rate, None)
        contours = self._known(s, self._contours, at.U.shape[1:], 2) + self._sum(U, W, self._contours)
        return self._real(contours)

    def _second(self, s: State, at: Vectors, rate: Array, second: Array | None) -> tuple[Array, Array]:
        """Second derivatives of U and of s·T; `second` None stands for 0."""
        zero = np.zeros_like(rate) if second is None else second
        (w, v), (e, a) = self._parts(rate), self._parts(zero)
        iw, ie = 1j * w, 1j * e - w * w
        W = np.empty_like(at.W)
        for p, guide in enumerate(self.guides):
            root = guide.root
            turn, bend = (iw[root], ie[root]) if isinstance(root, int) else (s.iw[root], s.ie[root])
            W[p] = a[p] * at.T[p] + 2 * v[p] * turn * at.T[p] + bend * at.W[p]
        return ie * at.U, W

    def _parts(self, rate: Array) -> tuple[Array, Array]:
        """Rates of the directions and, in m, of the displacements, (..., P) each."""
        first = _first(rate)
        return first[: self.angles], self.size * first[self.angles :]

    def move(self, s: State) -> None:
        """Add the rates of the links, already placed, to the state."""
        at = self.placed(s)
        shape = at.U.shape[1:]
        J = self._jacobian(at)
        rate = -solve_each(J, self._known_rate(s, at))
        second = -solve_each(J, self._bend(s, at, rate))
        (w, v), e = self._parts(rate), self._parts(second)[0]
        iw, dW = 1j * w, v * at.T + self._turning(s, at.W)
        for p, guide in enumerate(self.guides):
            if isinstance(guide.root, int):
                dW[p] += iw[guide.root] * at.W[p]
        velocities = self._known(s, self._links, shape, 1) + self._sum(iw * at.U, dW, self._links)
        for link in self.group.links:
            root = self.directions[link].root
            if isinstance(root, int):
                s.turn(link, w[root], e[root])
            else:
                s.turn_with(link, root)
        bent = self._sum(*self._second(s, at, rate, second), self._links)
        accelerations = self._known(s, self._links, shape, 2) + bent
        for k, link in enumerate(self.group.links):
            s.carry(link, velocities[k], accelerations[k])

    def closeness(self, s: State, q: Array) -> Array:
        """Smallest singular value of the Jacobian with columns of length 1, (..., P): 0 in a singular position."""
        J = self.jacobian(s, q)
        lost = ~np.isfinite(J).all(axis=(-2, -1))
        J = np.where(lost[..., None, None], 0.0, J / np.linalg.norm(J, axis=-2, keepdims=True))
        return np.where(lost, np.nan, np.linalg.svd(J, compute_uv=False)[..., -1])


def _first(x: Array) -> Array:
    """(..., k) -> (k, ...)."""
    return x.transpose(x.ndim - 1, *range(x.ndim - 1))


def _last(x: Array, axes: int = 1) -> Array:
    """(k, ...) -> (..., k), or so many axes at once."""
    return x.transpose(*range(axes, x.ndim), *range(axes))


def solve_each(A: Array, b: Array) -> Array:
    """Solve A x = b for every position, (..., P, k); nan where A is singular or not finite."""
    if np.isfinite(A).all() and np.isfinite(b).all():
        try:
            return np.linalg.solve(A, b[..., None])[..., 0]
        except np.linalg.LinAlgError:  # one singular position raises for the whole stack
            pass
    lost = ~(np.isfinite(A).all(axis=(-2, -1)) & np.isfinite(b).all(axis=-1))
    A = np.where(lost[..., None, None], np.eye(A.shape[-1]), A)
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
