"""The single numbers of a chapter, each by a second way: what a `test_<chapter>_twice` names for every printed formula.

A formula is evaluated where it is printed, so print and result agree even where both are wrong; the second way shares
no expression with it: mechanics' own numpy, or another law.
"""

from collections.abc import Iterable, Mapping

import numpy as np

from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Book, Table
from tmm_report.quantity.sheet import Sheet
from tmm_report.quantity.units import factor


def disagreements(
    s: Sheet, ways: Mapping[str, float | None], tolerance: float = 1e-9, formed: bool = False
) -> list[str]:
    """Of the formulas that a sheet prints: those that no second way is named for, and those that it contradicts; of a
    formula with a number of its own, found more exactly, both are held. The second ways are in the units of the
    results, or as `formed`, of the formulas; angles in radians."""
    told = []
    for key in (key for key in s.DECLARED if s.has_formula(key)):
        if ways.get(key) is None:
            told.append(f"{key}: no second way")
            continue
        formula, size = s.formula(key), abs(ways[key]) or 1.0
        of = s.declared(key)
        share = factor(of.unit, of.formed) if of.formed not in ("", "deg") and not formed else 1.0
        for number in (s.var(key).number / share, float(formula.value) / share):
            if not np.isclose(number, ways[key], rtol=tolerance, atol=tolerance * min(size, 1.0)):
                told.append(f"{key}: {number!r}, by the second way {ways[key]!r}")
    return told


def rows_disagreements(
    tables: Iterable[Table], formulas: Iterable[Formula], tolerance: float = 1e-9
) -> list[str]:
    """Of formulas of the rows of tables: those that the table, made by numpy, contradicts, noise beside `scale`."""
    book, told = Book.of(tables), []
    for formula in formulas:
        ref = formula.ref
        table = book.tables[ref.table]
        row = list(table["key"].values).index(ref.key) if ref.by else ref.row
        column = table[ref.by or ref.key]
        number = column.number(row)
        value = float(formula.value)
        if formula.unit == "deg":
            value, number = value % (2 * np.pi), np.radians(column.number(row, "deg")) % (2 * np.pi)
        if not np.isclose(value, number, rtol=tolerance, atol=tolerance * (formula.scale or 0.0)):
            told.append(f"{ref.table}.{ref.key}[{row}]: {value!r}, in the table {number!r}")
    return told
