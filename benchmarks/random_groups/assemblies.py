"""All assemblies at given driver angles: every real root of one trigonometric polynomial in one direction.

With the direction of one link fixed, the rest is two linear equations and a circle: of class III circles are
subtracted from one of them and place the link, of class IV they give the other direction's cosine and sine. What is
left over, free of divisions, is a trigonometric polynomial of degree 3, known by its values at few directions; its
roots are those of a polynomial of degree 6 in exp(iθ), and all are found at once as eigenvalues.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.random_groups.curve import at_angle
from benchmarks.random_groups.equations import Equations

Array = Any
DEGREE = 3
REAL = 1e-3  # how far from the unit circle a root may lie before Newton's method tells whether it is real


def assemblies(eq: Equations, known: Array) -> list[Array]:
    """x of all assemblies of every lane, (N, n) each, at the angles `known` (L, k): φ, of a dyad before its rod too."""
    samples = np.exp(2j * np.pi * np.arange(4 * DEGREE) / (4 * DEGREE))
    values = _left_over(eq, known, np.broadcast_to(samples, (len(eq), samples.size)))[0]
    parts = np.fft.fft(values, axis=1) / samples.size
    order = np.arange(-DEGREE, DEGREE + 1)
    polynomial = parts[:, order]  # ascending powers of u, times u³
    roots = _roots(polynomial)
    near = np.abs(np.abs(roots) - 1) < REAL
    return [
        _polished(eq.of(np.array([lane])), known[lane], roots[lane][near[lane]]) for lane in range(len(eq))
    ]


def _roots(polynomial: Array) -> Array:
    """Roots of polynomials (L, 2·DEGREE + 1), ascending, as eigenvalues of their companions."""
    count, size = polynomial.shape[0], 2 * DEGREE
    companion = np.zeros((count, size, size), dtype=complex)
    companion[:, np.arange(1, size), np.arange(size - 1)] = 1
    last = polynomial[:, -1]
    last = np.where(np.abs(last) < 1e-14 * np.abs(polynomial).max(axis=1), 1e-14, last)
    companion[:, :, -1] = -polynomial[:, :-1] / last[:, None]
    return np.linalg.eigvals(companion)


def _polished(eq: Equations, known: Array, roots: Array) -> Array:
    """Closed assemblies, each once."""
    if not roots.size:
        return np.zeros((0, eq.unknowns))
    u = roots / np.abs(roots)
    _, found = _left_over(eq, known[None], u[None])
    guess = np.concatenate([np.broadcast_to(known, (len(u), known.size)), found[0]], axis=1)
    lanes = np.zeros(len(u), dtype=int)
    x = _settled(eq.of(lanes), guess, known[0])
    x = x[np.isfinite(x).all(axis=1)]
    kept: list[Array] = []
    for one in x:
        if all(_apart(one, other, eq.angles) > 1e-7 for other in kept):
            kept.append(one)
    return np.array(kept).reshape(len(kept), eq.unknowns)


def _settled(eq: Equations, guess: Array, phi: float) -> Array:
    return at_angle(eq, guess, np.full(len(guess), phi), steps=30, far=0.1)


def _apart(x: Array, y: Array, angles: int) -> float:
    turned = np.abs(np.exp(1j * x[:angles]) - np.exp(1j * y[:angles]))
    return float(max(turned.max(), np.abs(x - y)[angles:].max(initial=0.0)))


def apart(x: Array, others: Array, angles: int) -> Array:
    """Distance of x from each of the others, angles compared as directions."""
    return np.array([_apart(x, other, angles) for other in others])


def _left_over(eq: Equations, known: Array, u: Array) -> tuple[Array, Array]:
    """The left-over equation at directions u (L, S), and the unknowns after `known` there, (L, S, n − k)."""
    return (_class_three if eq.moves else _class_four)(eq, known, u)


def _class_three(eq: Equations, known: Array, u: Array) -> tuple[Array, Array]:
    k = known.shape[1]
    z = np.exp(1j * known)
    own = (eq.arms[:, :, :k] * z[:, None]).sum(axis=2) + eq.at
    legs = [i for i in range(len(eq.turns)) if eq.body[i]]
    *others, base = legs  # the last is a circle in every scheme

    def without_p(i: int) -> Array:
        return own[:, i, None] + eq.arms[:, i, k, None] * u

    normals, sides = [], []
    for i in others:
        v = without_p(i) - without_p(base)
        if eq.turns[i] == -2:
            normals.append(v)
            sides.append((eq.length[:, i, None] ** 2 - eq.length[:, base, None] ** 2 - np.abs(v) ** 2) / 2)
        else:
            T = eq.along[:, i, None] * (u if eq.turns[i] >= 0 else np.ones_like(u))
            normals.append(1j * T)
            sides.append(eq.length[:, i, None] - (T.conj() * v).imag)
    determinant, top = _two_lines(normals, sides)
    value = np.abs(top) ** 2 - (eq.length[:, base, None] * determinant) ** 2
    with np.errstate(all="ignore"):
        p = top / determinant - without_p(base)
    return value, np.stack([np.angle(u), p.real, p.imag], axis=2)


def _class_four(eq: Equations, known: Array, u: Array) -> tuple[Array, Array]:
    z = np.exp(1j * known)
    normals, sides = [], []
    for i in range(2):
        g = eq.at[:, i, None] + (eq.arms[:, i, 0] * z[:, 0])[:, None] + eq.arms[:, i, 2, None] * u
        b = -eq.arms[:, i, 1, None]
        if eq.turns[i] == -2:  # |g − b·w| = l
            normals.append(g * b.conj())
            sides.append((np.abs(g) ** 2 + np.abs(b) ** 2 - eq.length[:, i, None] ** 2) / 2)
        else:  # Im(conj(t w)·(g − b w)) = l
            t = eq.along[:, i, None]
            normals.append(-1j * t.conj() * g)
            sides.append(eq.length[:, i, None] + (t.conj() * b).imag)
    determinant, top = _two_lines(normals, sides)
    value = np.abs(top) ** 2 - determinant**2
    with np.errstate(all="ignore"):
        w = top / determinant
    return value, np.stack([np.angle(w), np.angle(u)], axis=2)


def _two_lines(normals: list[Array], sides: list[Array]) -> tuple[Array, Array]:
    """q with Re(conj(n)·q) = k for two n and k, as determinant and determinant times q."""
    (one, two), (k, m) = normals, sides
    determinant = (one.conj() * two).imag
    return determinant, 1j * (m * one - k * two)
