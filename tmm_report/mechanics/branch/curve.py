"""A group's branch as a curve F(z) = 0 in z = (q, φ), followed by its arc length.

Where the links stretch to their limit the driver's angle turns back along the curve, while the curve itself runs on
smoothly: with the bordered Jacobian

    A = [∂F/∂q  ∂F/∂φ; tᵀ],   t the direction of the curve,

nothing is singular there. A is singular only where two branches cross.
Source: Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems (1977).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from tmm_report.mechanics.branch.known import Known, KnownPart
from tmm_report.mechanics.loops import Loops

Array = Any


@dataclass(frozen=True, eq=False)
class Node:
    """A point of a curve: `z` (k + 1), unit tangent `t`, ∂F/∂z `D` (k, k + 1).

    The bordered Jacobian there is A = U·S·Vᵀ: `left` is S^(−½)·Uᵀ without the column of the border, `right` V·S^(−½),
    `beta` the norm of A⁻¹.
    """

    z: Array
    t: Array
    D: Array
    left: Array
    right: Array
    beta: float

    def change(self, D: Array) -> float:
        """How far ∂F/∂z has changed, as a part of what makes A singular: A + (D − D₀) = U·S^½·(1 + M)·S^½·Vᵀ, and
        1 + M is regular while ‖M‖ < 1."""
        M = self.left @ (D - self.D) @ self.right
        return float(np.sqrt(np.sum(M * M)))

    @property
    def phi(self) -> float:
        return float(self.z[-1])


class Curve:
    """The contours of one group as functions of z, over `size`."""

    def __init__(self, loops: Loops, known: Known):
        count = len(loops.closures)
        self.loops, self.count, self.angles = loops, count, loops.angles
        self.known = KnownPart(loops, known)
        self.units = loops.units[:count].reshape(count, loops.angles, -1)[..., 0] / loops.size
        self.slides = loops.slides[:count]
        self.on_known = self.known.guides
        self.on_own = [p for p in range(len(loops.guides)) if p not in self.on_known]
        self.roots = [int(loops.guides[p].root) for p in self.on_own]
        self.turns = np.array(
            [complex(np.ravel(loops.guides[p].turn)[0]) for p in self.on_own], dtype=complex
        )
        self.spread = self._bends()

    def _bends(self) -> float:
        """Bound of the second derivatives of the contours by z: the arms, and the part of the crank, over `size`."""
        arms = np.abs(self.units)
        turned = (
            np.nanmax(np.abs(self.known.quintics[:, 2, : self.count]), initial=0.0) * 2 / self.known.step**2
        )
        turned = min(float(turned), 10.0 * max(1.0, float(arms.max(initial=0.0))))
        return float(np.sqrt(np.sum(arms**2) + 2 * np.sum(self.slides**2) + turned**2))

    def at(self, z: Array) -> tuple[Array, Array]:
        """F (k,) and ∂F/∂z (k, k + 1) at one point; nan where the links before the group do not exist."""
        n = self.angles
        known, rates = self.known.at(float(z[-1]))
        U = np.exp(1j * z[:n])
        arms = self.units * U
        F, by_phi, by_angle = known[: self.count] + arms.sum(axis=1), rates[: self.count], 1j * arms
        D = np.empty((2 * self.count, len(z)))
        if len(self.slides[0]):
            F, by_phi, columns = self._sliding(z, U, known, rates, F, by_phi, by_angle)
            D[: self.count, n:-1], D[self.count :, n:-1] = columns.real, columns.imag
        D[: self.count, :n], D[self.count :, :n] = by_angle.real, by_angle.imag
        D[: self.count, -1], D[self.count :, -1] = by_phi.real, by_phi.imag
        return np.concatenate([F.real, F.imag]), D

    def _sliding(
        self, z: Array, U: Array, known: Array, rates: Array, F: Array, by_phi: Array, by_angle: Array
    ) -> tuple[Array, Array, Array]:
        """F, ∂F/∂φ with the vectors along the guides; ∂F/∂θ of their turning is added to `by_angle`."""
        T = np.empty(self.slides.shape[1], dtype=complex)
        T[self.on_known], T[self.on_own] = known[self.count :], U[self.roots] * self.turns
        s = z[self.angles : -1]
        W = self.slides * (s * T)
        for p, root in zip(self.on_own, self.roots, strict=True):
            by_angle[:, root] += 1j * W[:, p]
        moved = self.slides[:, self.on_known] @ (s[self.on_known] * rates[self.count :])
        return F + W.sum(axis=1), by_phi + moved, self.slides * T

    def is_known(self, phi: float) -> bool:
        """Whether the links before the group exist at a driver angle, and have finite rates."""
        return bool(np.isfinite(sum(part.sum() for part in self.known.at(phi))))

    # ------------------------------------------------------------ nodes

    def node(self, z: Array, along: Array, D: Array | None = None) -> Node | None:
        """The point z with the tangent in the sense of `along`; None where the curve has none."""
        if D is None:
            _, D = self.at(z)
        if not np.isfinite(D).all():
            return None
        last = np.zeros(len(z))
        last[-1] = 1.0
        try:
            t = np.linalg.solve(np.vstack([D, along]), last)
            t /= np.sqrt(t @ t)
            U, sines, Vt = np.linalg.svd(np.vstack([D, t]))
        except np.linalg.LinAlgError:
            return None
        if not sines[-1] > 0:
            return None
        half = 1 / np.sqrt(sines)
        return Node(z, t, D, half[:, None] * U[:-1].T, Vt.T * half, float(1 / sines[-1]))

    def start(self, phi: float, q: Array, way: int) -> Node | None:
        """The point q at driver angle phi, rad, with the tangent along which the angle rises (way +1) or falls."""
        z = np.append(q, phi)
        _, D = self.at(z)
        if not np.isfinite(D).all():
            return None
        along = np.linalg.svd(D)[2][-1]
        return self.node(z, along if along[-1] * way > 0 else -along, D)

    def closed(self, z: Array, plane: Array, beta: float = 1.0) -> tuple[Array, Array] | None:
        """The point of the curve in the plane through z across `plane`, and ∂F/∂z just beside it, by Newton's
        method; None where it does not settle. `beta`: norm of A⁻¹ near it, which makes rounding errors grow."""
        A = np.empty((len(z), len(z)))
        A[-1] = plane
        right = np.zeros(len(z))
        settled = max(1e-10, 1e-15 * beta)
        before = np.inf
        for _ in range(8):
            F, D = self.at(z)
            if not np.isfinite(D).all():
                return None
            A[:-1], right[:-1] = D, F
            try:
                step = np.linalg.solve(A, right)
            except np.linalg.LinAlgError:
                return None
            z = z - step
            size = np.abs(step).max()
            if size < settled:  # what remains is its square
                return z, D
            if size > 2 * before:
                break
            before = size
        return (z, D) if size < 10 * settled else None
