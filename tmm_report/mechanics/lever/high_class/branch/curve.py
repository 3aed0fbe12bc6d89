"""A group's branch as a curve F(z) = 0 in z = (q, φ), followed by its arc length.

Where the links stretch to their limit the driver's angle turns back along the curve, while the curve itself runs on
smoothly: with the bordered Jacobian

    A = [∂F/∂q  ∂F/∂φ; tᵀ],   t the direction of the curve,

nothing is singular there. A is singular only where two branches cross.
Source: Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems (1977).
"""

from __future__ import annotations

from math import cos, isfinite, sin, sqrt
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.high_class.branch.known import Known, KnownPart
from tmm_report.mechanics.lever.loop_equations import Direction, Loops
from tmm_report.records import dataclass

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
        return sqrt(np.vdot(M, M))

    @property
    def phi(self) -> float:
        return float(self.z[-1])


class Curve:
    """The contours of one group as functions of z, over `size`.

    One point at a time is asked for, where a numpy call costs more than its arithmetic: sums are Python's own.
    """

    def __init__(self, loops: Loops, known: Known):
        count = len(loops.closures)
        self.loops, self.count, self.angles = loops, count, loops.angles
        self.known = KnownPart(loops, known)
        self.units = loops.units[:count].reshape(count, loops.angles, -1)[..., 0] / loops.size
        self.slides = loops.slides[:count]
        arms, signs = self.units.tolist(), self.slides.tolist()
        self.contours = [
            ([(c, x) for c, x in enumerate(row) if x], [(p, x) for p, x in enumerate(signs[i]) if x])
            for i, row in enumerate(arms)
        ]
        on_known = {p: count + n for n, p in enumerate(self.known.guides)}
        self.guides = [_guide(guide, on_known.get(p, -1)) for p, guide in enumerate(loops.guides)]
        self.spread = self._bends()
        self._last = np.eye(2 * count + 1)[-1]

    def _bends(self) -> float:
        """Bound of the second derivatives of the contours by z: the arms, and the part of the crank, over `size`."""
        arms = np.abs(self.units)
        turned = (
            np.nanmax(np.abs(self.known.quintics[:, : self.count, 2]), initial=0.0) * 2 / self.known.step**2
        )
        turned = min(float(turned), 10.0 * max(1.0, float(arms.max(initial=0.0))))
        return float(np.sqrt(np.sum(arms**2) + 2 * np.sum(self.slides**2) + turned**2))

    def at(self, z: Array) -> tuple[Array, Array]:
        """F (k,) and ∂F/∂z (k, k + 1) at one point; nan where the links before the group do not exist."""
        values = z.tolist()
        if not all(map(isfinite, values)):
            return np.full(2 * self.count, np.nan), np.full((2 * self.count, len(z)), np.nan)
        known, rates = self.known.at(values[-1])
        U = [complex(cos(x), sin(x)) for x in values[: self.angles]]
        T = [U[root] * turn if root >= 0 else known[n] for root, turn, n in self.guides]
        rows = [self._row(i, values, U, T, known, rates) for i in range(self.count)]
        both = np.array(rows)
        both = np.concatenate([both.real, both.imag])
        return both[:, -1], both[:, :-1]

    def _row(
        self,
        i: int,
        values: list[float],
        U: list[complex],
        T: list[complex],
        known: list[complex],
        rates: list[complex],
    ) -> list[complex]:
        """∂/∂z of one contour, and the contour itself."""
        gap, by_phi = known[i], rates[i]
        row = [0j] * len(values)
        arms, slides = self.contours[i]
        for c, arm in arms:
            vector = arm * U[c]
            gap += vector
            row[c] = 1j * vector
        for p, sign in slides:
            root, _, n = self.guides[p]
            s = values[self.angles + p]
            row[self.angles + p] = sign * T[p]
            gap += s * sign * T[p]
            if root >= 0:
                row[root] += 1j * s * sign * T[p]
            else:
                by_phi += s * sign * rates[n]
        row[-1] = by_phi
        return [*row, gap]

    # ------------------------------------------------------------ nodes

    def node(self, z: Array, along: Array, D: Array | None = None) -> Node | None:
        """The point z with the tangent in the sense of `along`; None where the curve has none."""
        if D is None:
            _, D = self.at(z)
        A = np.empty((len(z), len(z)))
        A[:-1], A[-1] = D, along
        try:
            t = np.linalg.solve(A, self._last)
            t /= sqrt(t @ t)
            A[-1] = t
            U, sines, Vt = np.linalg.svd(A)
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
            A[:-1], right[:-1] = D, F
            try:
                step = np.linalg.solve(A, right)
            except np.linalg.LinAlgError:
                return None
            sizes = [abs(x) for x in step.tolist()]
            if not isfinite(sum(sizes)):
                return None
            z, size = z - step, max(sizes)
            if size < settled:  # what remains is its square
                return z, D
            if size > 2 * before:
                break
            before = size
        return (z, D) if size < 10 * settled else None


def _guide(guide: Direction, known: int) -> tuple[int, complex, int]:
    """The unknown direction with which a guide turns, −1 of a known link; its turn; its number in the known part."""
    root = guide.root if isinstance(guide.root, int) else -1
    return root, complex(np.ravel(guide.turn)[0]), known
