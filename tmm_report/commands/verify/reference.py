"""References of a variant: exact numbers as texts of 40 digits, read as two doubles that add up to them.

`verification/<variant>.json` is made by tools/references.py:

    positions   numbers of those table positions whose numbers are kept
    limits      what may be wrong of a number at each of them, relative to the largest of its row: 1e-12 but near
                singular positions
    rows        [kind, name, largest of all table positions (of the kind, where that is next to nothing), [number at
                each position kept]]; a vector is a pair [x, y], null is a number that does not exist
    values      [key of a single value of results.json or "table/column/row", number, what it is judged by: itself, or
                the larger number of which it is a difference]

`verification/involute.json` has values alone, of functions: "inv(0.35)".
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from decimal import Context, Decimal
from pathlib import Path
from typing import Any

import numpy as np

from tmm_report.mechanics.rivals.model import Pair
from tmm_report.records import dataclass

Array = Any
DIGITS = Context(prec=100)


@dataclass(frozen=True, eq=False)
class Row:
    """A kind of quantity of something named, (P,): `exact` nan where there is none; `size`: by which it is judged."""

    kind: str
    name: str
    size: float
    exact: Pair

    def errors(self, found: Array) -> Array:
        """Of numbers found (P,), relative to the size: infinite where one is missing, or is there and should not be."""
        none, lost = np.isnan(self.exact.high), ~np.isfinite(found)
        with np.errstate(invalid="ignore"):
            off = np.abs((found - self.exact.high) - self.exact.low) / (self.size or 1.0)
        return np.where(none & lost, 0.0, np.where(none | lost, np.inf, off))


@dataclass(frozen=True, eq=False)
class Reference:
    positions: tuple[int, ...]
    limits: Array
    rows: tuple[Row, ...]
    values: tuple[Row, ...]


def read(path: Path) -> Reference:
    """Raises FileNotFoundError for a variant that has none."""
    data = json.loads(path.read_text("utf-8"))
    rows = (Row(kind, name, float(size), _row(numbers)) for kind, name, size, numbers in data["rows"])
    limits = np.array([float(x) for x in data["limits"]])
    values = (Row("value", key, float(size), _row([number])) for key, number, size in data["values"])
    return Reference(tuple(data["positions"]), limits, tuple(rows), tuple(values))


def _row(numbers: Sequence[Any]) -> Pair:
    parts = [_halves(x) for x in numbers]
    return Pair(np.array([high for high, _ in parts]), np.array([low for _, low in parts]))


def _halves(number: Any) -> tuple[Any, Any]:
    """High and low part of a text, of a pair of texts, or of nothing."""
    if number is None:
        return np.nan, np.nan
    if isinstance(number, list):
        (x, dx), (y, dy) = (_halves(part) for part in number)
        return complex(x, y), complex(dx, dy)
    high = float(number)
    return high, float(DIGITS.subtract(Decimal(number), Decimal(high)))
