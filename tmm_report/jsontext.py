"""JSON as `json.dumps(indent=1)` writes it, faster.

The library indents in Python, an item at a time, and writes without indents in C: lists of plain values, which most of
a result is, are written in C with the line break as their separator. Numbers of ordinary size are written by the Rust
of pydantic, ten times faster than Python's `repr` and with the same digits: the fewest that tell a number apart.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from functools import cache
from json.encoder import encode_basestring as _text
from typing import Any

import numpy as np

Array = Any
ALIKE = 1e-4, 1e16  # sizes of numbers that are written without a power of ten


Pieces = list[bytes]
"""Written JSON in pieces, UTF-8: nothing long is copied before all of it is joined."""


@cache
def _encoder(depth: int) -> json.JSONEncoder:
    """What writes a value whose items stand `depth` spaces from the margin."""
    return json.JSONEncoder(ensure_ascii=False, allow_nan=False, separators=(f",\n{' ' * depth}", ": "))


def indented(value: Any, depth: int = 0) -> str:
    """The text of dicts with text keys, lists, numbers, texts, None. Raises ValueError for nan and infinity."""
    if isinstance(value, str):
        return _text(value)
    if not value or not isinstance(value, dict | list):
        return _encoder(0).encode(value)
    if isinstance(value, dict):
        return _framed("{}", members_of(value, depth), depth)
    if {dict, list}.isdisjoint(map(type, value)):
        return _framed("[]", [_encoder(depth + 1).encode(value)[1:-1]], depth)
    return _framed("[]", [indented(item, depth + 1) for item in value], depth)


def members_of(items: dict[str, Any], depth: int) -> list[str]:
    """The keys of a dict at a depth, each with what it holds."""
    return [f"{_text(key)}: {indented(item, depth + 1)}" for key, item in items.items()]


def _framed(brackets: str, items: list[str], depth: int) -> str:
    indent = "\n" + " " * (depth + 1)
    return f"{brackets[0]}{indent}{f',{indent}'.join(items)}{indent[:-1]}{brackets[1]}"


def framed(brackets: bytes, items: Sequence[Pieces], depth: int) -> Pieces:
    """Written items between two brackets, a line each, as a dict or a list at a depth has them."""
    if not items:
        return [brackets]
    indent = b"\n" + b" " * (depth + 1)
    pieces, between = [], brackets[:1] + indent
    for item in items:
        pieces.append(between)
        pieces += item
        between = b"," + indent
    return [*pieces, indent[:-1] + brackets[1:]]


def number_lists(rows: Sequence[Array], depth: int) -> Iterator[bytes]:
    """Lists of numbers, each (P,) with a P of its own, at a depth; nan and infinity are null, no zero has a sign."""
    cells = _numbers(np.concatenate(rows)) if rows else []
    indent = b"\n" + b" " * (depth + 1)
    between, start = b"," + indent, 0
    for row in rows:
        end = start + len(row)
        yield b"[%b%b%b]" % (indent, between.join(cells[start:end]), indent[:-1]) if end > start else b"[]"
        start = end


def _numbers(x: Array) -> Pieces:
    """Each of the numbers (N,) as `repr` writes it; null for nan and infinity."""
    from pydantic_core import to_json

    x = x + 0.0  # no negative zero
    numbers, sizes = x.tolist(), np.abs(x)
    cells = to_json(numbers, inf_nan_mode="null")[1:-1].split(b",") if numbers else []
    other = (sizes < ALIKE[0]) & (sizes > 0) | (sizes >= ALIKE[1]) & (sizes < np.inf)
    for k in np.flatnonzero(other).tolist():
        cells[k] = repr(numbers[k]).encode()
    return cells
