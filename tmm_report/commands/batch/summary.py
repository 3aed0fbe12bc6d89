"""`summary.csv`: a line a variant, for spreadsheets. It is written as it is read, however many lines it has."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from itertools import chain
from pathlib import Path

from tmm_report.commands.batch.record import STATUSES, TITLE, problems
from tmm_report.i18n import Translator
from tmm_report.intake.writing import csv_lines
from tmm_report.running.journal import Record, read

FILE = "summary.csv"
MOST = 40  # columns of numbers: variants of many schemes have many strokes
DIGITS = 10  # of a number
LAST = "disagreement"
Cell = str | float | int | None


def write(journal: Path, output: Path, tr: Translator) -> Path:
    """Raises OSError."""
    heads = _numbers(record for _, record in read(journal))
    rows = chain([_head(heads)], (_row(record, heads, tr) for _, record in read(journal)))
    target, part = output / FILE, output / f".{FILE}.part"
    part.unlink(missing_ok=True)  # a link that somebody put there leads elsewhere
    with part.open("xb") as stream:
        stream.writelines(csv_lines(rows, tr.decimal))
    os.replace(part, target)
    return target


def _numbers(records: Iterable[Record]) -> list[tuple[str, str]]:
    """Key and unit of every number that a record has, as they come; how well checks agree is last."""
    found: dict[tuple[str, str], None] = {}
    for record in records:
        for key, (_, unit) in record.get("numbers", {}).items():
            if len(found) < MOST:
                found.setdefault((key, unit))
    return sorted(found, key=lambda head: head[0] == LAST)


def _head(heads: Iterable[tuple[str, str]]) -> list[Cell]:
    numbers = (f"{key}, {unit}" if unit else key for key, unit in heads)
    return ["id", "status", *TITLE, "formula", *numbers, "messages"]


def _row(record: Record, heads: Iterable[tuple[str, str]], tr: Translator) -> list[Cell]:
    return [
        record["id"],
        record["status"],
        *(record.get(name, "") for name in (*TITLE, "formula")),
        *_values(record, heads),
        " | ".join(problem.text(tr.gettext) for problem in problems(record)),
    ]


def _values(record: Record, heads: Iterable[tuple[str, str]]) -> Iterator[Cell]:
    numbers = record.get("numbers", {})
    for key, unit in heads:
        value, own = numbers.get(key, (None, unit))
        yield float(f"{value:.{DIGITS}g}") if own == unit and value is not None else None


def counts(journal: Path) -> dict[str, int]:
    """How many variants came out how."""
    found = dict.fromkeys(STATUSES, 0)
    for _, record in read(journal):
        found[record["status"]] += 1
    return found
