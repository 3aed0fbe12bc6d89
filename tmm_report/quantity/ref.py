"""Where a printed number stands in the results, and how HTML says so."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import NamedTuple


class Ref(NamedTuple):
    """Where a printed number stands in the results.

    Without a table it is one of the single values. `row`: the row of the table, in tables by positions the number of
    the position; in a table of which each row is a quantity, `key` finds the row and `by` names the column. `unit`:
    the unit of print where it is not that of the results. `size`: printed without its sign.
    """

    key: str
    row: int | None = None
    table: str = ""
    by: str = ""
    unit: str = ""
    size: bool = False


@lru_cache(maxsize=65536)
def attributes(ref: Ref) -> str:
    """The data attributes of an HTML element that holds the number: q, k, t, by, u, abs; " " in front."""
    from html import escape  # it brings a table of two thousand names; results.json needs none

    named = (
        ("q", ref.key), ("k", ref.row), ("t", ref.table), ("by", ref.by), ("u", ref.unit),
        ("abs", 1 if ref.size else None),
    )  # fmt: skip
    return "".join(f' data-{name}="{escape(str(value))}"' for name, value in named if value not in (None, ""))


_DATA = re.compile(r' data-[a-z]+="[^"]*"')


def without_attributes(text: str) -> str:
    return _DATA.sub("", text) if " data-" in text else text


def read_alike(one: str, other: str) -> bool:
    """Whether two formulas read the same, wherever their numbers stand in the results; of most the tags differ."""
    if one.count("<") != other.count("<"):
        return False
    bare, also = (without_attributes(text).replace(' form="prefix"', "") for text in (one, other))
    return bare == also
