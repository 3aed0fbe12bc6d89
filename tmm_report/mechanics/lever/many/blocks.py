"""Many variants or many positions a block at a time, so that memory stays small.

for part, found in blocks(linkage, phi):
    kept[part] = statics.solve(found, ...).balancing
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Sequence
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any, TypeVar

import numpy as np

from tmm_report.mechanics.lever.motion import Linkage, Motion, solve

Array = Any
T = TypeVar("T")
BLOCK = 8192  # positions: some 8 MB for a mechanism of two groups, at any number of variants


def blocks(linkage: Linkage, phi: Array, size: int = BLOCK) -> Iterator[tuple[slice, Motion]]:
    """Which variants of a stack (V, 1), or which positions (P,) of one variant, and their motion: some `size` positions
    each. Every number is that of the whole solved at once, to the last bit."""
    shape = np.broadcast_shapes(linkage.axes, np.shape(phi))
    if len(shape) == 1:
        for part in _parts(shape[0], size):
            yield part, solve(linkage, phi[part])
        return
    if shape[0] * shape[-1] <= size:
        yield slice(0, shape[0]), solve(linkage, phi)
        return
    cut = _Cut(linkage, shape[0])
    for part in _parts(shape[0], max(1, size // shape[-1])):
        angles = phi[part] if np.ndim(phi) == 2 and len(phi) == shape[0] else phi
        yield part, solve(cut.rows(linkage, part, {}), angles)


def _parts(count: int, size: int) -> Iterator[slice]:
    return (slice(start, start + size) for start in range(0, count, size))


class _Cut:
    """Cuts the rows of some variants out of a record of a stack: out of its arrays (V, 1), and what holds any."""

    def __init__(self, x: Any, count: int):
        self.count = count
        self.holds: dict[int, bool] = {}  # by identity, whether there is such an array in it
        self.look(x)

    def look(self, x: Any) -> bool:
        if isinstance(x, np.ndarray):
            return x.ndim == 2 and x.shape[0] == self.count
        if isinstance(x, str | float | complex | int | np.generic | None):
            return False
        if id(x) not in self.holds:
            self.holds[id(x)] = False  # of what holds itself
            self.holds[id(x)] = any(list(map(self.look, _inside(x))))  # all are looked at
        return self.holds[id(x)]

    def rows(self, x: T, part: slice, known: dict[int, Any]) -> T:
        """A record with the rows of some variants; what was one record is one again."""
        if isinstance(x, np.ndarray):
            return x[part] if self.look(x) else x  # type: ignore[return-value]
        if not self.holds.get(id(x), False):
            return x
        if id(x) not in known:
            own = [self.rows(value, part, known) for value in _inside(x)]
            known[id(x)] = _with(x, own)
        return known[id(x)]


def _inside(x: Any) -> Iterable[Any]:
    if isinstance(x, dict):
        return x.values()
    return x if isinstance(x, tuple | list) else [getattr(x, name) for name in _fields(x.__class__)]


def _with(x: Any, inside: Sequence[Any]) -> Any:
    """A record of the same kind with other contents, in the order of `_inside`."""
    if isinstance(x, dict):
        return dict(zip(x, inside, strict=True))
    return type(x)(inside) if isinstance(x, tuple | list) else type(x)(*inside)


@cache
def _fields(kind: Hashable) -> tuple[str, ...]:
    """Names of a record's fields; of anything else none."""
    return tuple(item.name for item in fields(kind)) if is_dataclass(kind) else ()
