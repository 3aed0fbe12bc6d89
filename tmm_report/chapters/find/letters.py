"""How an unknown is called: as the variant's own number is that is equal to it all over its range, else x."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from tmm_report.chapters.find.asking import Sample
from tmm_report.chapters.find.given import Given, Unknown
from tmm_report.chapters.find.target import Chapter
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.units import DIMENSIONS, factor

SOUGHT = NP_("index", "seek")
NAMED = N_("%(of)s: the unknown number %(name)s")
ALIKE = 1e-12  # relative: what differs by more is another number
ROWS = 40  # of a table: in a longer one no number is stated

Key = tuple[str, str, int]


def letters(given: Given, samples: Sequence[Sample]) -> tuple[Quantity | None, ...]:
    """One an unknown; None where the results have no such number with a letter, or there is but one sample."""
    if len(samples) < 2:
        return (None,) * len(given.unknowns)
    sizes = [given.sizes(parts) for parts, _ in samples]
    return tuple(
        _letter(one, [size[k] for size in sizes], [chapters for _, chapters in samples])
        for k, one in enumerate(given.unknowns)
    )


def _letter(
    unknown: Unknown, sizes: Sequence[float], results: Sequence[Sequence[Chapter]]
) -> Quantity | None:
    unit = plain(DIMENSIONS[unknown.dimension].unit)
    found = [
        dict(_equal(size, unit, unknown, chapters)) for size, chapters in zip(sizes, results, strict=True)
    ]
    both = [key for key in found[0] if all(key in one for one in found[1:])]
    own = str(unknown.path[-1])
    both.sort(key=lambda key: not key[1].endswith(own))  # that is called as the key of the file goes first
    return found[0][both[0]] if both else None


def _equal(
    size: float, unit: str, unknown: Unknown, chapters: Sequence[Chapter]
) -> Iterator[tuple[Key, Quantity]]:
    """The numbers of the block's own chapter that are equal to one, of all chapters where it has none."""
    block = unknown.path[0]
    names = [name for name, _, _ in chapters]
    for name, tables, values in chapters:
        if block in names and name != block:
            continue
        for value in values:
            if _same(value.value, size, unit, value.quantity):
                yield ("", value.key, 0), value.quantity
        for table in tables:
            if len(table) > ROWS:
                continue
            for column in table.columns:
                if column.quantity.symbol is None or column.units:
                    continue
                for row, number in enumerate(column.values):
                    if _same(number, size, unit, column.quantity):
                        letter = replace(column.quantity, symbol=column.symbol(row))
                        yield (table.name, column.key, row), letter


def _same(number: object, size: float, unit: str, of: Quantity) -> bool:
    if of.symbol is None or isinstance(number, str):
        return False
    try:
        scale = factor(unit, of.unit) if unit != of.unit else 1.0
    except KeyError:
        return False
    return math.isclose(float(number), size * scale, rel_tol=ALIKE)  # type: ignore[arg-type]


def sought(
    of: Unknown, letter: Quantity | None, key: str, text: str = "", end: str = "", which: str = ""
) -> Quantity:
    """An unknown in SI, by the letter that the variant's own numbers have for it; printed in the unit of its range,
    where that is one of those that notes print."""
    unit, own = plain(DIMENSIONS[of.dimension].unit), plain(of.unit)
    try:
        factor(unit, own)
    except KeyError:
        own = ""
    meaning = Message(text or N_("unknown number %(name)s"), {"name": of.name})
    if letter is not None and not text:
        meaning = Message(NAMED, {"name": of.name, "of": letter.meaning})
    symbol = _indexed(letter.sign, end) if letter else Symbol("x", _joined(which, end or SOUGHT))
    return Quantity(key, symbol, unit, meaning, own if own not in ("", unit) else "")


def _indexed(symbol: Symbol, end: str) -> Symbol:
    return replace(symbol, sub=_joined(symbol.sub, end)) if end else symbol


def _joined(*indices: str) -> str:
    return ",".join(filter(None, indices))


def plain(unit: str) -> str:
    """A unit as the results write it."""
    return "" if unit == "1" else unit.replace("*", "·").replace("^2", "²").replace("^3", "³")
