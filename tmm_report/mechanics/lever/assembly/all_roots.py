"""Every way in which a group can be assembled at one position: all real roots of its loop equations.

With the conjugate vectors as unknowns of their own, y = x̄, the contours are linear in x and in y, and the rest is
bilinear: U·Ū = 1 for every direction, w·T̄ = w̄·T for every displacement w = s·T along a guide. k such equations in
k/2 + k/2 unknowns have C(k, k/2) roots: 2 of a dyad, 6 of a group of four links, 20 of six. They are found by
elimination where all of them are regular. Where two may merge, or a whole curve of them exists, all are found by
continuation from a product of linear forms with as many known roots; in projective coordinates no path runs away.
Source: Morgan, Sommese, A homotopy for solving general polynomial systems that respects m-homogeneous structures
(1987).
"""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.assembly import elimination as eliminated
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.loop_equations import Loops, newton, solve_each

Array = Any
SEEDS = (
    20,
    21,
    22,
    23,
)  # of random start systems, the next where one has lost a root: the same roots every time
CLOSED = 1e-12  # of the contours over the group's size, where two roots merge
MERGED = 1e-3  # as REAL, of a path that stops short of a double root
REAL = 1e-5  # how far from the unit circle a direction may be before Newton settles whether the root is real


def assemblies(loops: Loops, s: State) -> Array:
    """All q, (N, k), at which the group closes in the one position of `s` (arrays (1,)); N = 0 where it does not."""
    one = _repeat(s)
    system = _Bilinear(loops, s, SEEDS[0])
    roots = eliminated.roots(system.M, SEEDS[0])
    if roots is None:
        q = _continued(loops, s, one)
    else:
        q = _roots(loops, one, system, roots, np.ones(len(roots), dtype=bool))
    q = q[np.isfinite(q).all(axis=-1)]
    q[:, : loops.angles] = np.angle(np.exp(1j * q[:, : loops.angles]))
    return _distinct(q, loops.angles)


def _continued(loops: Loops, s: State, one: State) -> Array:
    """The real roots by continuation, (N, k), maybe more than once each."""
    found = []
    for seed in SEEDS:
        system = _Bilinear(loops, s, seed)
        paths, ended = _track(system)
        found.append(_roots(loops, one, system, paths, ended))
        if len(paths) == len(system.starts()) and _apart(paths[ended]):
            break
    return np.concatenate(found)


def _roots(loops: Loops, s: State, system: _Bilinear, paths: Array, ended: Array) -> Array:
    """The real roots to which paths lead, (N, k)."""
    q = system.real_roots(paths[ended], REAL)
    q = newton(loops, s, q) if len(q) else q
    merged = system.real_roots(paths[~ended], MERGED)
    return np.concatenate([q, _double_roots(loops, s, merged)]) if len(merged) else q


def _apart(ends: Array) -> bool:
    """Whether all paths end apart: where two come to one root, one has leapt from its own, and that root is lost."""
    gaps = np.abs(ends[:, None] - ends[None]).max(axis=-1) + np.diag(np.full(len(ends), np.inf))
    return bool(gaps.min(initial=np.inf) > 1e-6 * np.abs(ends).max(initial=1.0))


def _double_roots(loops: Loops, s: State, q: Array) -> Array:
    """Two roots that merge, (N, k): steps of least length, as the Jacobian is singular there; nan where none is."""
    with np.errstate(all="ignore"):
        for _ in range(40):  # each halves the distance
            residual, J = loops.closing(s, q, loops.gaps(s, q))
            q = q - (np.linalg.pinv(J, rcond=1e-9) @ residual[..., None])[..., 0]
        left = np.abs(loops.residual(s, q)).max(axis=-1)
    return np.where((left < CLOSED)[..., None], q, np.nan)


def _repeat(s: State) -> State:
    """The one position of a state as one number, so that it stands for any number of roots."""
    parts = ({k: np.ravel(x)[0] if np.ndim(x) else x for k, x in part.items()} for part in (s.o, s.r, s.u))
    return State(*parts)


def _distinct(q: Array, angles: int) -> Array:
    """Roots each once, in ascending order of their first direction."""
    kept: list[Array] = []
    for root in q[np.lexsort(np.round(q.T[::-1], 9))]:
        gaps = [
            np.abs(
                np.concatenate(
                    [np.exp(1j * root[:angles]) - np.exp(1j * r[:angles]), root[angles:] - r[angles:]]
                )
            )
            for r in kept
        ]
        if all(gap.max() > 1e-7 for gap in gaps):
            kept.append(root)
    return np.array(kept).reshape(len(kept), q.shape[-1])


class _Bilinear:
    """The bilinear system xᵀ M_i y = 0 in homogeneous ξ and η, x = N ξ, y = N̄ η, and its start system."""

    def __init__(self, loops: Loops, s: State, seed: int):
        self.loops = loops
        shape = (1,)
        contours = slice(0, len(loops.closures))
        known = loops._known(s, contours, shape, 0)[:, 0] / loops.size
        units = loops.units[contours].reshape(len(known), loops.angles, -1)[..., 0] / loops.size
        A = np.concatenate([units, loops.slides[contours], known[:, None]], axis=1)
        # every x of the contours, the homogeneous 1 being its last entry
        _, _, right = np.linalg.svd(A)
        self.N = right[len(known) :].conj().T
        self._t = [1.0 if isinstance(g.root, int) else np.ravel(s.u[g.root])[0] for g in loops.guides]
        self.M = np.array([self._equation(i) for i in range(loops.angles + len(loops.guides))])
        random = np.random.default_rng(seed)
        n, size = self.M.shape[0], self.N.shape[1]
        normal = random.standard_normal
        self.alpha, self.beta = (normal((n, size)) + 1j * normal((n, size)) for _ in range(2))
        self.patch = normal((2, size)) + 1j * normal((2, size))
        self.gamma = np.exp(1j * random.uniform(0, 2 * np.pi))

    def _equation(self, i: int) -> Array:
        """Coefficients of ξ η of U·Ū = 1, or of w·T̄ = w̄·T."""
        count = len(self.N)
        m = np.zeros((count, count), dtype=complex)
        if i < self.loops.angles:
            m[i, i], m[-1, -1] = 1.0, -1.0
        else:
            p = i - self.loops.angles
            guide = self.loops.guides[p]
            column = guide.root if isinstance(guide.root, int) else count - 1
            t = self._t[p] * np.ravel(guide.turn)[0]
            m[i, column], m[column, i] = np.conj(t), -t
        return self.N.T @ m @ self.N.conj()

    def starts(self) -> Array:
        """Roots of the start system Π (α_i·ξ)(β_i·η), (paths, 2·size)."""
        n, size = self.alpha.shape
        last = np.eye(size)[-1]
        roots = []
        for chosen in combinations(range(n), size - 1):
            others = [i for i in range(n) if i not in chosen]
            xi = np.linalg.solve(np.vstack([self.alpha[list(chosen)], self.patch[0]]), last)
            eta = np.linalg.solve(np.vstack([self.beta[others], self.patch[1]]), last)
            roots.append(np.concatenate([xi, eta]))
        return np.array(roots)

    def at(self, z: Array, t: Array) -> tuple[Array, Array, Array]:
        """The homotopy (1 − t)·γ·start + t·target at z (paths, 2·size): value, its Jacobian, its slope by t."""
        size = self.N.shape[1]
        xi, eta = z[:, :size], z[:, size:]
        a, b = xi @ self.alpha.T, eta @ self.beta.T
        My = np.einsum("ijk,pk->pij", self.M, eta)
        xM = np.einsum("ijk,pj->pik", self.M, xi)
        start, target = self.gamma * a * b, np.einsum("pij,pj->pi", My, xi)
        t = t[:, None]
        value = (1 - t) * start + t * target
        weight, t2 = self.gamma * (1 - t)[..., None], t[..., None]
        by_xi = weight * b[..., None] * self.alpha + t2 * My
        by_eta = weight * a[..., None] * self.beta + t2 * xM
        J = np.concatenate([by_xi, by_eta], axis=2)
        patch = np.zeros((2, 2 * size), dtype=complex)
        patch[0, :size], patch[1, size:] = self.patch
        J = np.concatenate([J, np.broadcast_to(patch, (len(z), 2, 2 * size))], axis=1)
        on_patch = np.stack([xi @ self.patch[0] - 1, eta @ self.patch[1] - 1], axis=1)
        slope = np.concatenate([target - start, np.zeros((len(z), 2))], axis=1)
        return np.concatenate([value, on_patch], axis=1), J, slope

    def real_roots(self, z: Array, allowed: float) -> Array:
        """q of the end points that are finite and real, (N, k), to a few digits: `allowed` part of their size."""
        size = self.N.shape[1]
        x, y = z[:, :size] @ self.N.T, z[:, size:] @ self.N.conj().T
        finite = (np.abs(x[:, -1]) > 1e-8 * np.abs(x).max(axis=1)) & (
            np.abs(y[:, -1]) > 1e-8 * np.abs(y).max(axis=1)
        )
        x, y = x[finite] / x[finite][:, -1:], y[finite] / y[finite][:, -1:]
        scale = np.maximum(np.abs(x).max(axis=1), 1.0)
        real = np.abs(x - y.conj()).max(axis=1) <= allowed * scale
        return self._q(x[real])

    def _q(self, x: Array) -> Array:
        angles = self.loops.angles
        theta = np.angle(x[:, :angles])
        rows = []
        for p, guide in enumerate(self.loops.guides):
            turning = np.exp(1j * theta[:, guide.root]) if isinstance(guide.root, int) else 1.0
            t = turning * self._t[p] * np.ravel(guide.turn)[0]
            rows.append((x[:, angles + p] * np.conj(t)).real)
        return np.concatenate([theta, np.array(rows).reshape(len(rows), len(x)).T], axis=1)


def _track(system: _Bilinear) -> tuple[Array, Array]:
    """End points of all paths from t = 0 to 1, (paths, 2·size), and which came to 1, the others stop just short of it:
    Heun's predictor, Newton's corrector, own steps."""
    z = system.starts()
    t, step = np.zeros(len(z)), np.full(len(z), 0.02)
    while np.any(going := (t < 1) & (step > 1e-9)):
        h = np.minimum(step[going], 1 - t[going])
        start, now = z[going], t[going]
        first = _slope(system, start, now)
        second = _slope(system, start + h[:, None] * first, now + h)
        found, size = _correct(system, start + h[:, None] * (first + second) / 2, now + h)
        good = size < 1e-7 * np.abs(found).max(axis=1)
        z[going] = np.where(good[:, None], found, start)
        t[going] = np.where(good, now + h, now)
        step[going] = np.where(good, np.minimum(step[going] * 1.6, 0.1), step[going] / 2)
    near = t > 1 - 1e-6
    return z[near], t[near] >= 1


def _slope(system: _Bilinear, z: Array, t: Array) -> Array:
    _, J, slope = system.at(z, t)
    return -solve_each(J, slope)


def _correct(system: _Bilinear, z: Array, t: Array, steps: int = 3) -> tuple[Array, Array]:
    """Newton's steps at fixed t, and the size of the last."""
    for _ in range(steps):
        value, J, _ = system.at(z, t)
        change = solve_each(J, value)
        z = z - change
    size = np.abs(change).max(axis=1)
    return z, np.where(np.isfinite(size), size, np.inf)
