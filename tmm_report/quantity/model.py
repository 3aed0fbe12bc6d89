"""What a table of results is: named columns, each with its key, unit and meaning; and single values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmm_report.problems import Message


@dataclass(frozen=True, eq=False)
class Column:
    """One column: a key, a unit ("" for pure numbers and text), what it means, and its values."""

    key: str
    unit: str
    meaning: Message
    values: Any  # (P,) numbers, or a list of texts


@dataclass(frozen=True, eq=False)
class Table:
    name: str
    meaning: Message
    columns: tuple[Column, ...]


@dataclass(frozen=True)
class Value:
    """A single number; `at`: the angle turned from position 0 at which it holds, rad."""

    key: str
    value: float
    unit: str
    meaning: Message
    at: float | None = None
