"""Numbers of many variants of one mechanism, so that all of them are solved at once and each as if it were alone.

Array arithmetic and Python's own differ in the last bit (numpy's complex product is fused). A variant that is solved
alone has plain numbers for its lengths: what is made of two of them is Python's, what is made of one and an array of
positions is numpy's. `Each` keeps that apart for V variants, so that every bit is the same.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from typing import Any, TypeVar

import numpy as np

Array = Any
T = TypeVar("T")


class Each:
    """A plain number of each of V variants. Among themselves, and with plain numbers, they are reckoned one by one;
    with an array of positions (..., P) they are an array (V, 1)."""

    __slots__ = ("_array", "items")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, items: Sequence[Any]):
        self.items = list(items)
        self._array: Array = None

    @property
    def array(self) -> Array:
        if self._array is None:
            self._array = np.array(self.items)[:, None]
        return self._array

    @property
    def shape(self) -> tuple[int, int]:
        return len(self.items), 1

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return self.array if dtype is None else self.array.astype(dtype)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        arrays = (x.array if isinstance(x, Each) else x for x in inputs)
        return getattr(ufunc, method)(*arrays, **options)

    def __eq__(self, other: object) -> bool:
        """Whether all of them are: what is left out for a number that is 0 is left out for all or for none."""
        return all(x == other for x in self.items)

    def __neg__(self) -> Each:
        return Each([-x for x in self.items])

    def __abs__(self) -> Each:
        return Each([abs(x) for x in self.items])

    def conjugate(self) -> Each:
        return Each([x.conjugate() for x in self.items])

    @property
    def real(self) -> Each:
        return Each([x.real for x in self.items])

    @property
    def imag(self) -> Each:
        return Each([x.imag for x in self.items])

    def __add__(self, other: Any) -> Any:
        return _both(operator.add, self, other)

    def __radd__(self, other: Any) -> Any:
        return _both(operator.add, other, self)

    def __sub__(self, other: Any) -> Any:
        return _both(operator.sub, self, other)

    def __rsub__(self, other: Any) -> Any:
        return _both(operator.sub, other, self)

    def __mul__(self, other: Any) -> Any:
        return _both(operator.mul, self, other)

    def __rmul__(self, other: Any) -> Any:
        return _both(operator.mul, other, self)

    def __truediv__(self, other: Any) -> Any:
        return _both(operator.truediv, self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return _both(operator.truediv, other, self)

    def __pow__(self, other: Any) -> Any:
        return _both(operator.pow, self, other)


def _both(op: Callable[[Any, Any], Any], a: Any, b: Any) -> Any:
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return op(*(x.array if isinstance(x, Each) else x for x in (a, b)))
    if not isinstance(b, Each):
        return Each([op(x, b) for x in a.items])
    return Each(
        [op(x, y) for x, y in zip(a.items, b.items, strict=True)]
        if isinstance(a, Each)
        else [op(a, y) for y in b.items]
    )


class Unlike(Exception):
    """Variants of different mechanisms."""


def together(variants: Sequence[T]) -> T:
    """Records of V variants as one, whose numbers are `Each`. Raises Unlike where anything else of them differs."""
    return _joined(variants, {})


def _joined(parts: Sequence[Any], known: dict[tuple[int, ...], Any]) -> Any:
    first = parts[0]
    if isinstance(first, float | complex):
        return Each(parts)
    if first is None or isinstance(first, str | int):
        if any(type(x) is not type(first) or x != first for x in parts):
            raise Unlike
        return first
    ids = tuple(map(id, parts))
    if ids not in known:
        known[ids] = _joined_records(parts, known)
    return known[ids]


def _joined_records(parts: Sequence[Any], known: dict[tuple[int, ...], Any]) -> Any:
    first, kind = parts[0], type(parts[0])
    if any(type(x) is not kind for x in parts):
        raise Unlike
    if is_dataclass(first):
        names = [item.name for item in fields(first)]
        return kind(**{name: _joined([getattr(x, name) for x in parts], known) for name in names})
    if any(len(x) != len(first) for x in parts):
        raise Unlike
    if isinstance(first, Mapping):
        if any(list(x) != list(first) for x in parts):
            raise Unlike
        return {key: _joined([x[key] for x in parts], known) for key in first}
    return tuple(_joined(row, known) for row in zip(*parts, strict=True))


def one(x: Any, v: int) -> Any:
    """What variant `v` has of a number, an array (..., V, P), or a mapping or tuple of them; alike of all: as it is."""
    if isinstance(x, Each):
        return x.items[v]
    if isinstance(x, np.ndarray):
        return x if x.ndim < 2 else x[..., v, 0] if x.shape[-1] == 1 else x[..., v, :]
    if isinstance(x, Mapping):
        return {key: one(value, v) for key, value in x.items()}
    return tuple(one(value, v) for value in x) if isinstance(x, tuple) else x
