"""Constraints of drawn mechanisms as equations, many mechanisms of one scheme at once, a lane each.

Unknown is x = (φ, angles of links, place of one link): the driver's angle is an unknown like the others. Every leg is
one equation: the ends of a rod keep their distance, or a point keeps its distance from a line,

    circle   (|w|² − l²)/2 = 0,        w = Σ_j arm_j·exp(i x_j) + body·p + at
    line     Im(T̄·w) − l = 0,          T = along·exp(i x_turns), or `along` itself

Lengths are parts of the longest arm of the lane. Nothing here or beside is taken from the program that is judged.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

Array = Any


@dataclass(frozen=True, eq=False)
class Equations:
    """m equations of L mechanisms in n = m + 1 unknowns: `angles` of them angles, then two of p where `moves`."""

    arms: Array  # (L, m, angles), complex
    at: Array  # (L, m), complex
    length: Array  # (L, m): of the rod, or distance from the line
    along: Array  # (L, m), unit complex; not used by circles
    body: Array  # (m,) of 0 and 1: whether p takes part
    turns: tuple[int, ...]  # (m,): the angle that the line turns with, −1 where it is fixed, −2 of a circle
    moves: bool

    def __len__(self) -> int:
        return len(self.at)

    @property
    def angles(self) -> int:
        return int(self.arms.shape[2])

    @property
    def unknowns(self) -> int:
        return self.angles + 2 * self.moves

    @property
    def circle(self) -> Array:
        return np.array(self.turns) == -2

    def of(self, lanes: Array) -> Equations:
        """Some of the lanes."""
        arms, at, length, along = (x[lanes] for x in (self.arms, self.at, self.length, self.along))
        return replace(self, arms=arms, at=at, length=length, along=along)

    def exact(self) -> Equations:
        """The same numbers in long doubles."""
        return replace(
            self,
            arms=self.arms.astype(np.clongdouble),
            at=self.at.astype(np.clongdouble),
            length=self.length.astype(np.longdouble),
            along=self.along.astype(np.clongdouble),
        )

    def vectors(self, x: Array) -> tuple[Array, Array, Array]:
        """exp(i x) (L, angles), w (L, m), T (L, m) with 0 for circles."""
        z = np.exp(1j * x[:, : self.angles])
        w = (self.arms * z[:, None]).sum(axis=2) + self.at
        if self.moves:
            w = w + self.body * (x[:, -2] + 1j * x[:, -1])[:, None]
        turning = np.ones_like(w)
        for i, j in enumerate(self.turns):
            if j >= 0:
                turning[:, i] = z[:, j]
            elif j == -2:
                turning[:, i] = 0
        return z, w, self.along * turning

    def value(self, x: Array) -> Array:
        """By how much they do not hold, (L, m)."""
        _, w, T = self.vectors(x)
        line = (T.conj() * w).imag - self.length
        return np.where(self.circle, (np.abs(w) ** 2 - self.length**2) / 2, line)

    def rates(self, x: Array) -> Array:
        """Jacobian, (L, m, n)."""
        z, w, T = self.vectors(x)
        dw = 1j * self.arms * z[:, None]
        if self.moves:
            ones = np.broadcast_to(self.body, w.shape)[..., None]
            dw = np.concatenate([dw, ones, 1j * ones], axis=2)
        J = np.where(self.circle[:, None], (w.conj()[..., None] * dw).real, (T.conj()[..., None] * dw).imag)
        for i, j in enumerate(self.turns):
            if j >= 0:
                J[:, i, j] -= (T[:, i].conj() * w[:, i]).real
        return J

    def bend(self, x: Array, t: Array) -> Array:
        """Second derivative in the direction t, (L, m)."""
        z, w, T = self.vectors(x)
        turn = t[:, None, : self.angles]
        first = (1j * self.arms * z[:, None] * turn).sum(axis=2)
        if self.moves:
            first = first + self.body * (t[:, -2] + 1j * t[:, -1])[:, None]
        second = -(self.arms * z[:, None] * turn**2).sum(axis=2)
        own = np.zeros_like(w.real)
        for i, j in enumerate(self.turns):
            if j >= 0:
                own[:, i] = t[:, j]
        line = (T.conj() * (second - 2j * own * first - own**2 * w)).imag
        return np.where(self.circle, np.abs(first) ** 2 + (w.conj() * second).real, line)

    def bound(self, x: Array) -> Array:
        """Bound of each equation's second derivative near x, (L, m)."""
        _, w, _ = self.vectors(x)
        size = np.abs(self.arms)
        square, most = (size**2).sum(axis=2) + self.body, size.max(axis=2)
        near = np.abs(w) + 0.2
        circle = square + near * most
        turning = np.array(self.turns) >= 0
        line = most + np.where(turning, 2 * np.sqrt(square) + near, 0.0)
        return np.where(self.circle, circle, line)


def solved(A: Array, b: Array) -> Array:
    """A x = b of every lane, (L, n), by elimination with pivots in the precision of the numbers."""
    if A.dtype != np.longdouble:
        return np.linalg.solve(A, b[..., None])[..., 0]
    A, b, n = A.copy(), b.copy(), A.shape[1]
    lane = np.arange(len(A))
    for k in range(n):
        pivot = k + np.argmax(np.abs(A[:, k:, k]), axis=1)
        for rows in (A, b):
            rows[lane, k], rows[lane, pivot] = rows[lane, pivot].copy(), rows[lane, k].copy()
        factor = A[:, k + 1 :, k] / A[:, k, k][:, None]
        A[:, k + 1 :] -= factor[..., None] * A[:, k][:, None]
        b[:, k + 1 :] -= factor * b[:, k][:, None]
    x = np.zeros_like(b)
    for k in reversed(range(n)):
        x[:, k] = (b[:, k] - (A[:, k, k + 1 :] * x[:, k + 1 :]).sum(axis=1)) / A[:, k, k]
    return x
