"""A chapter's or a stage's own tables and values, found without the prefix of their names."""

from __future__ import annotations

from tmm_report.quantity.model import Book, Table, Value
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Part:
    """`prefix`: with which the names begin in the results. Raises KeyError for a name that is not there."""

    prefix: str
    book: Book

    def __getitem__(self, key: str) -> Value:
        """A single value."""
        return self.book[f"{self.prefix}_{key}"]

    def table(self, name: str) -> Table:
        return self.book.tables[f"{self.prefix}_{name}"]
