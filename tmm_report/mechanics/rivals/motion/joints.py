"""Pairs of one kind as arrays: the links that each joins, the places of the joint in them, a guide's directions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Literal

import numpy as np

from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Joints:
    """Pairs of one kind: first row of each; its two links by number, its places in them over the size, and its
    directions in them, (count, 2)."""

    rows: Array
    index: Array
    arms: Array
    along: Array


def joints(
    pairs: Sequence[Pair], kind: Literal["R", "P"], place: Callable[[str, complex], tuple[int, complex]]
) -> Joints:
    """The pairs of a kind among all; of slides the link that carries the guide first. `place`: a link by number, and a
    place in its axes from its reference point."""
    numbers = [p for p, pair in enumerate(pairs) if pair.kind == kind]
    ends = [
        (p, link)
        for p in numbers
        for link in (
            pairs[p].links if kind == "R" else (pairs[p].other(pairs[p].slider), str(pairs[p].slider))
        )
    ]
    places = [place(link, pairs[p].at[link]) for p, link in ends]
    shape = (len(numbers), 2)
    return Joints(
        2 * np.array(numbers, dtype=int),
        np.array([link for link, _ in places], dtype=int).reshape(shape),
        np.array([at for _, at in places], dtype=complex).reshape(shape),
        np.array([pairs[p].along.get(link, 1.0) for p, link in ends], dtype=complex).reshape(shape),
    )


def line_of(slides: Joints, z: Array, U: Array) -> tuple[Array, Array, Array, Array]:
    """The conjugate of the guides' directions; B − A; arms of A in the carrier and of B in the sliding link."""
    carrier, slider = slides.index.T
    back = times(U[carrier], slides.along[:, 0]).conj()
    A, B = times(U[carrier], slides.arms[:, 0]), times(U[slider], slides.arms[:, 1])
    return back, z[slider] + B - z[carrier] - A, A, B


def spread(numbers: Array, like: Array) -> Array:
    """Numbers (K,) that multiply rows (K, ..., P)."""
    return numbers.reshape(-1, *(1,) * (like.ndim - 1))


def times(rows: Array, numbers: Array) -> Array:
    return rows * spread(numbers, rows)


def wrapped(angle: Array) -> Array:
    """An angle within ±π, rad: links keep no count of their turns."""
    return np.remainder(angle + np.pi, 2 * np.pi) - np.pi
