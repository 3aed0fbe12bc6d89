"""All roots of a bilinear system by elimination: eigenvalues of one matrix, and the proof that none is missing.

n = 2(m − 1) equations ξᵀ M_i η = 0 in projective ξ, η of m coordinates each have C(n, n/2) roots. With ξ = (s, a, λs)
in turned axes the equations, multiplied by all monomials of η of degree m − 2, are as many as the monomials of η of
degree m − 1 times (s, a): they are linear in these, and λ is an eigenvalue. Roots that Newton's method confirms as
regular, all apart and as many as there can be, are all.
Source: Sturmfels, Zelevinsky, Multigraded resultants of Sylvester type (1994); Auzinger, Stetter (1988).
"""

from __future__ import annotations

from functools import cache
from itertools import combinations_with_replacement
from math import comb
from typing import Any

import numpy as np

Array = Any
APART = 1e-5  # sine of the angle between two roots, of ξ or of η, below which they are not told apart
REGULAR = 1e-7  # least singular value of a root's Jacobian, its rows of length 1
SETTLED = 1e-11  # Newton's last step: what remains is its square
MOST = 10  # equations: from twelve on the matrix takes a gigabyte


def roots(M: Array, seed: int) -> Array | None:
    """All roots (ξ, η), (C(n, n/2), 2m), each half of length 1; None where they cannot be told apart for certain
    or are too many.

    `M`: (n, m, m). `seed`: of the axes in which ξ is turned; any will do.
    """
    if len(M) > MOST:
        return None
    with np.errstate(all="ignore"):
        M = M / np.linalg.norm(M, axis=(-2, -1), keepdims=True)
        try:
            eta = _eta(M, seed)
            xi = np.linalg.svd(_by_xi(M, eta))[2][:, -1].conj()
            xi, eta, certain = _polished(M, xi, eta)
        except np.linalg.LinAlgError:
            return None
    known = certain and _all_apart(xi, eta)
    return np.concatenate([xi, eta], axis=1) if known else None


@cache
def _products(m: int) -> tuple[Array, Array]:
    """Numbers of the monomials of degree m − 1 that monomials of degree m − 2 times η_j make, (monomials, m); and which
    of the latter are powers of one η_j, (m,)."""
    whole = {powers: n for n, powers in enumerate(combinations_with_replacement(range(m), m - 1))}
    parts = list(combinations_with_replacement(range(m), m - 2))
    index = [[whole[tuple(sorted((*part, j)))] for j in range(m)] for part in parts]
    return np.array(index), np.array([parts.index((j,) * (m - 2)) for j in range(m)])


def _eta(M: Array, seed: int) -> Array:
    """η of every root, (roots, m), as exact as the eigenvectors are."""
    n, m = M.shape[:2]
    index, pure = _products(m)
    count = comb(n, n // 2)
    random = np.random.default_rng(seed)
    turned, _ = np.linalg.qr(random.standard_normal((m, m)) + 1j * random.standard_normal((m, m)))
    rows = np.zeros((n, len(index), count, m), dtype=complex)
    rows[:, np.arange(len(index))[:, None], index] = np.swapaxes(turned.T @ M, 1, 2)[:, None]
    rows = rows.reshape(n * len(index), count, m)
    by_a = rows[..., 1:-1].reshape(len(rows), -1)
    left = np.linalg.qr(by_a, mode="complete")[0][:, by_a.shape[1] :].conj().T
    _, vectors = np.linalg.eig(np.linalg.solve(left @ rows[..., -1], left @ rows[..., 0]))
    powers = vectors.T[:, index[pure]]  # (root, j, monomials η_j^(m−2)·η)
    best = np.argmax(np.abs(np.diagonal(powers, axis1=1, axis2=2)), axis=1)
    eta = powers[np.arange(count), best]
    return eta / np.linalg.norm(eta, axis=1, keepdims=True)


def _by_xi(M: Array, eta: Array) -> Array:
    """Coefficients of ξ in the equations, (roots, n, m)."""
    return np.moveaxis(M @ eta.T, -1, 0)


def _polished(M: Array, xi: Array, eta: Array) -> tuple[Array, Array, bool]:
    """Roots by Newton's method, each on the plane across itself; whether all have settled and are regular."""
    n, m = M.shape[:2]
    J = np.zeros((len(xi), 2 * m, 2 * m), dtype=complex)
    value = np.zeros((len(xi), 2 * m, 1), dtype=complex)
    for _ in range(5):
        by_xi = _by_xi(M, eta)
        J[:, :n, :m], J[:, :n, m:] = by_xi, np.moveaxis(xi @ M, 1, 0)
        J[:, -2, :m], J[:, -1, m:] = xi.conj(), eta.conj()
        value[:, :n] = by_xi @ xi[..., None]
        step = np.linalg.solve(J, value)[..., 0]
        xi, eta = xi - step[:, :m], eta - step[:, m:]
        xi, eta = (x / np.linalg.norm(x, axis=1, keepdims=True) for x in (xi, eta))
        size = np.abs(step).max()
        if size < SETTLED or not size < 1:
            break
    J /= np.linalg.norm(J, axis=2, keepdims=True)
    least = np.linalg.svd(J, compute_uv=False)[:, -1].min()
    return xi, eta, bool(size < SETTLED and least > REGULAR)


def _all_apart(xi: Array, eta: Array) -> bool:
    """Whether no two roots are one."""
    sines = [1 - np.abs(x.conj() @ x.T) ** 2 for x in (xi, eta)]
    gaps = np.maximum(*sines) + np.eye(len(xi))
    return bool(gaps.min() > APART**2)
