"""Lines on which a function of the plane is 0: marching squares, with every crossing of a grid's side found exactly."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.roots import interpolated

Array = Any
NOISE = 1e-12  # of the function: a root is left where it is this small
NARROW = 1e-10  # of a side of the grid: about a jump nothing is sought closer


def isolines(f: Callable[[Array], Array], grid: Array, values: Array | None = None) -> tuple[Array, ...]:
    """Chains of points x + iy on f = 0, each (N,), closed ones ending where they began.

    `grid` (R, C) complex: rows up, columns to the right. `f` takes points of any shape; where it is nan no line is
    drawn. `values`: those of f on the grid, if they are known.
    """
    values = f(grid) if values is None else values
    ends = _crossed(values)
    if not len(ends[0]):
        return ()
    points = _roots(f, grid.ravel()[ends[0]], grid.ravel()[ends[1]], values.ravel()[ends[0]])
    number = {(int(a), int(b)): k for k, (a, b) in enumerate(zip(*ends, strict=True))}
    return tuple(points[chain] for chain in _chained(_links(values, number)))


def _crossed(values: Array) -> tuple[Array, Array]:
    """Flat indices of both ends of the grid's sides on which the sign changes."""
    index = np.arange(values.size).reshape(values.shape)
    sides = [(index[:, :-1], index[:, 1:]), (index[:-1], index[1:])]
    starts, stops = (np.concatenate([side[k].ravel() for side in sides]) for k in (0, 1))
    flat = values.ravel()
    known = np.isfinite(flat[starts]) & np.isfinite(flat[stops])
    changes = known & ((flat[starts] > 0) != (flat[stops] > 0))
    return starts[changes], stops[changes]


def _roots(f: Callable[[Array], Array], start: Array, stop: Array, at_start: Array) -> Array:
    low, high, noise = np.zeros(len(start)), np.ones(len(start)), np.full(len(start), NOISE)
    part, _ = interpolated(lambda t: f(start + t * (stop - start)), low, high, at_start, noise, NARROW)
    return start + part * (stop - start)


def _links(values: Array, number: dict[tuple[int, int], int]) -> list[tuple[int, int]]:
    """Pairs of crossings joined through a cell; two lines through one cell are kept apart by its middle."""
    rows, columns = values.shape
    links = []
    cells = {cell for a, b in number for cell in _beside(a, b, rows, columns)}
    for row, column in sorted(cells):
        k = row * columns + column
        sides = ((k, k + 1), (k + 1, k + columns + 1), (k + columns, k + columns + 1), (k, k + columns))
        met = [number[side] for side in sides if side in number]
        if len(met) == 2:
            links.append((met[0], met[1]))
        elif len(met) == 4:  # bottom, right, top, left
            middle = values[row : row + 2, column : column + 2].mean()
            same = (middle > 0) == (values[row, column] > 0)
            links += [(met[0], met[1]), (met[2], met[3])] if same else [(met[0], met[3]), (met[1], met[2])]
    return links


def _beside(a: int, b: int, rows: int, columns: int) -> list[tuple[int, int]]:
    """The cells on both sides of a side of the grid, by their lower left corners."""
    row, column = divmod(a, columns)
    cells = [(row, column), (row - 1, column) if b == a + 1 else (row, column - 1)]
    return [(r, c) for r, c in cells if 0 <= r < rows - 1 and 0 <= c < columns - 1]


def _chained(links: list[tuple[int, int]]) -> list[list[int]]:
    """Links joined end to end, open chains first."""
    ways: dict[int, list[int]] = defaultdict(list)
    for a, b in links:
        ways[a].append(b)
        ways[b].append(a)
    chains = []
    for start in sorted(ways, key=lambda k: (len(ways[k]) != 1, k)):
        while ways[start]:
            chains.append(_followed(ways, start))
    return chains


def _followed(ways: dict[int, list[int]], start: int) -> list[int]:
    chain = [start]
    while ways[chain[-1]]:
        step = ways[chain[-1]].pop()
        ways[step].remove(chain[-1])
        chain.append(step)
    return chain
