"""What results.json says of a printed number."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from tmm_report.lint.page import Number


class Known:
    """Equal values of one key are one quantity, wherever they stand."""

    def __init__(self, values: Mapping[str, Any], tables: Mapping[str, Mapping[str, Any]]):
        self.values, self.tables = values, tables

    @classmethod
    def of(cls, document: Any) -> Known:
        """What results.json holds. Raises ValueError, TypeError or LookupError for what is none."""
        tables = {name: _by_key(table["columns"]) for name, table in dict(document["tables"]).items()}
        for columns in tables.values():
            if not all(isinstance(column["values"], list) for column in columns.values()):
                raise TypeError
        return cls(_by_key(document["values"]), tables)

    def identity(self, number: Number) -> tuple[Any, ...]:
        """The same of two numbers that are of one quantity."""
        value = self.value(number)
        if value is None:
            return (*number.column, number.row, number.size)
        return number.key, number.unit, f"{abs(value) if number.size else value:.12g}"

    def value(self, number: Number) -> float | None:
        """Its number in the results, None where it cannot be found there."""
        if not number.table:
            found = self.values.get(number.key, {}).get(number.by or "value")
        elif number.by:
            return None
        else:
            found = self._of_row(self.tables.get(number.table, {}), number.key, number.row)
        return found if isinstance(found, float) and math.isfinite(found) else None

    def unit(self, number: Number) -> str | None:
        """The unit in which it is printed, None where the results do not tell."""
        if number.unit:
            return number.unit
        columns = self.tables.get(number.table, {})
        if not number.table:
            found = self.values.get(number.key, {}).get("unit") if not number.by else None
        elif number.by:
            found = columns.get(number.by, {}).get("unit") or self._of_quantity(columns, number.key)
        else:
            found = columns.get(number.key, {}).get("unit") or self._of_row(columns, "unit", number.row)
        return found if isinstance(found, str) else None

    @staticmethod
    def _of_row(columns: Mapping[str, Any], key: str, row: str) -> Any:
        own = columns.get(key, {}).get("values", ())
        rows = columns["position"]["values"] if "position" in columns else range(len(own))
        at = next((k for k, one in enumerate(rows) if str(one) == row), len(own))
        return own[at] if at < len(own) else None

    @staticmethod
    def _of_quantity(columns: Mapping[str, Any], key: str) -> Any:
        """The unit of a table of which each row is a quantity."""
        keys = columns.get("key", {}).get("values", ())
        units = columns.get("unit", {}).get("values", ())
        return next((unit for one, unit in zip(keys, units, strict=False) if one == key), None)


def _by_key(records: Any) -> dict[str, Any]:
    found = {record["key"]: record for record in records if isinstance(record, dict)}
    if len(found) > len(records) or not all(isinstance(key, str) for key in found):
        raise TypeError
    return found
