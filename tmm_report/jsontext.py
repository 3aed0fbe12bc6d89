"""JSON as `json.dumps(indent=1)` writes it, faster.

The library indents in Python, an item at a time, and writes without indents in C: lists of plain values, which most of
a result is, are written in C with the line break as their separator.
"""

from __future__ import annotations

import json
from functools import cache
from json.encoder import encode_basestring as _text
from typing import Any


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
        return _framed(
            "{}", [f"{_text(key)}: {indented(item, depth + 1)}" for key, item in value.items()], depth
        )
    if {dict, list}.isdisjoint(map(type, value)):
        return _framed("[]", [_encoder(depth + 1).encode(value)[1:-1]], depth)
    return _framed("[]", [indented(item, depth + 1) for item in value], depth)


def _framed(brackets: str, items: list[str], depth: int) -> str:
    indent = "\n" + " " * (depth + 1)
    return brackets[0] + indent + f",{indent}".join(items) + indent[:-1] + brackets[1]
