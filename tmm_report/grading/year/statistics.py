"""What a year's works say together: points, hardest cells and columns, usual mistakes, copies, mixed-up variants.

found = statistics(digests)
for line in lines(found): ...
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import Any

import numpy as np

from tmm_report.grading.model import ABSENT, RIGHT, Digest, Rule
from tmm_report.grading.year.copies import Copy, Entries, copies
from tmm_report.problems import N_, Message, shown
from tmm_report.records import dataclass

Array = Any
Cell = tuple[str, str, str]

BINS = 10  # of the histogram: tenths of what the work is worth
FEW = 3  # cells and columns answered by fewer works are not called hard
NAMED = 3  # how many of a kind a line of the terminal names
_RULES = tuple(Rule)
_NUMBER_OF = {str(rule): number for number, rule in enumerate(_RULES)}


@dataclass(frozen=True)
class Who:
    """Of one work, by its id: whose it is."""

    id: str
    student: str = ""
    group: str = ""
    variant: str = ""

    @property
    def name(self) -> str:
        return f"{self.student} ({self.id})" if self.student and self.student != self.id else self.id


@dataclass(frozen=True)
class Share:
    """How a cell, or a column where `row` is None, was answered, in works' cells.

    `causes`: kinds of mistakes that were named in the column, with the number of works.
    """

    table: str
    key: str
    row: str | None
    asked: int
    right: int
    carried: int
    wrong: int
    missing: int
    causes: tuple[tuple[str, int], ...] = ()

    @property
    def part(self) -> float:
        """Part of those asked that are right, 0 … 1."""
        return self.right / self.asked if self.asked else 0.0

    @property
    def name(self) -> str:
        return self.key if not self.row else f"{self.key}, {self.row}"


@dataclass(frozen=True)
class Alike:
    """A pair worth a look: `one` has `shared` of `cells` numbers of `other`; see `copies.Copy`."""

    one: Who
    other: Who
    shared: int
    fits: int
    cells: int

    @property
    def text(self) -> Message:
        values = {"one": shown(self.one.name, 80), "other": shown(self.other.name, 80)}
        values |= {"shared": str(self.shared), "cells": str(self.cells), "fits": str(self.fits)}
        return Message(FITS if 2 * self.fits > self.shared else WRONG_FOR_BOTH, values)


FITS = N_(
    "%(one)s: %(shared)s of %(cells)s numbers compared are those of %(other)s; %(fits)s of them are right for the "
    "variant of the latter alone"
)
WRONG_FOR_BOTH = N_(
    "%(one)s and %(other)s: %(shared)s of %(cells)s numbers compared are the same and wrong for both variants"
)


@dataclass(frozen=True)
class Mixed:
    """A work whose numbers are those of the variant of `other`."""

    one: Who
    other: Who

    @property
    def text(self) -> Message:
        values = {"one": shown(self.one.name, 80), "other": shown(self.other.name, 80)}
        return Message(N_("%(one)s: the numbers of the variant of %(other)s"), values)


@dataclass(frozen=True)
class Beside:
    """A work without a mark, or with one set by hand. `why` is fit to be shown; `mark`: as set; `reckoned`: without."""

    who: Who
    why: str = ""
    mark: float | None = None
    reckoned: float | None = None

    @property
    def text(self) -> Message:
        who = shown(self.who.name, 80)
        if self.mark is None:
            return Message("%(who)s: %(why)s" if self.why else "%(who)s", {"who": who, "why": self.why})
        values = {"who": who, "mark": f"{self.mark:g}", "reckoned": "—", "why": self.why}
        if self.reckoned is not None:
            values["reckoned"] = f"{self.reckoned:g}"
        if not self.why:
            return Message(N_("%(who)s: %(mark)s, reckoned: %(reckoned)s"), values)
        return Message(N_("%(who)s: %(mark)s, reckoned: %(reckoned)s; %(why)s"), values)


@dataclass(frozen=True, eq=False)
class Statistics:
    """`parts`: (N,) points of what each work with a mark is worth, sorted, 0 … 1. `columns`, `cells`: the hardest
    first. `causes`: kinds of mistakes with the number of works. `absent`: works not handed in; `failed`: those that
    could not be marked; `by_hand`: those whose marks were set by hand."""

    parts: Array
    columns: tuple[Share, ...] = ()
    cells: tuple[Share, ...] = ()
    causes: tuple[tuple[str, int], ...] = ()
    copies: tuple[Alike, ...] = ()
    mixed: tuple[Mixed, ...] = ()
    absent: tuple[Beside, ...] = ()
    failed: tuple[Beside, ...] = ()
    by_hand: tuple[Beside, ...] = ()

    @property
    def histogram(self) -> list[int]:
        """Works in each tenth of the points; full marks stand in the last."""
        places = np.minimum((np.asarray(self.parts) * BINS + 1e-9).astype(int), BINS - 1)
        return [int(count) for count in np.bincount(np.maximum(places, 0), minlength=BINS)]

    @property
    def mean(self) -> float:
        return float(np.mean(self.parts)) if len(self.parts) else 0.0

    @property
    def quartiles(self) -> tuple[float, float, float]:
        """Lower quartile, median, upper quartile."""
        if not len(self.parts):
            return 0.0, 0.0, 0.0
        lower, median, upper = np.quantile(self.parts, (0.25, 0.5, 0.75))
        return float(lower), float(median), float(upper)


@dataclass(eq=False)
class _Gathered:
    """Works as arrays, while they are read one by one; the digests themselves are let go."""

    index: dict[Cell, int] = field(default_factory=dict)
    who: list[Who] = field(default_factory=list)
    parts: list[float] = field(default_factory=list)
    cells: list[Array] = field(default_factory=list)
    numbers: list[Array] = field(default_factory=list)
    solutions: list[Array] = field(default_factory=list)
    rules: list[Array] = field(default_factory=list)
    kinds: Counter[str] = field(default_factory=Counter)
    by_key: Counter[tuple[str, str]] = field(default_factory=Counter)
    mixed: list[tuple[str, str]] = field(default_factory=list)
    unmarked: list[Who] = field(default_factory=list)
    absent: list[Beside] = field(default_factory=list)
    failed: list[Beside] = field(default_factory=list)
    by_hand: list[Beside] = field(default_factory=list)


def statistics(digests: Iterable[Digest]) -> Statistics:
    """What all the works say together; the same whatever their order."""
    found = _Gathered()
    for digest in digests:
        _take(found, digest)
    works = _in_order(found)
    shares = _shares(found, works)
    return Statistics(
        np.sort(np.array(found.parts)),
        _hardest(share for share in shares if share.row is None),
        _hardest(share for share in shares if share.row is not None),
        tuple(sorted(found.kinds.items(), key=lambda item: (-item[1], item[0]))),
        tuple(_alike(copies(works), sorted(found.who, key=_by_id))),
        tuple(_mixed(found)),
        *(tuple(sorted(some, key=_of_id)) for some in (found.absent, found.failed, found.by_hand)),
    )


def _mixed(found: _Gathered) -> Iterator[Mixed]:
    who = {one.id: one for one in (*found.unmarked, *found.who)}
    return (Mixed(who[one], who.get(other, Who(other))) for one, other in sorted(set(found.mixed)))


def _by_id(who: Who) -> str:
    return who.id


def _of_id(one: Beside) -> str:
    return one.who.id


def _take(found: _Gathered, digest: Digest) -> None:
    """Add one work."""
    who = Who(digest.id, digest.student, digest.group, digest.variant)
    if digest.override is not None:
        reckoned = digest.points if digest.judged else None
        found.by_hand.append(Beside(who, digest.override.reason, digest.override.points, reckoned))
    elif not digest.marked:
        (found.absent if digest.state == ABSENT else found.failed).append(
            Beside(who, "; ".join(digest.failed))
        )
    if digest.marked:
        found.parts.append(digest.mark / digest.worth if digest.worth else 0.0)
    if not digest.judged:
        found.unmarked.append(who)
        return
    found.who.append(who)
    _take_cells(found, digest)
    found.kinds.update({kind for kind, _, _ in digest.causes})
    found.by_key.update({(key, kind) for kind, _, keys in digest.causes for key in keys})
    found.mixed += [(who.id, detail) for kind, detail, _ in digest.causes if kind == "variant"]


def _take_cells(found: _Gathered, digest: Digest) -> None:
    index, cells, nan = found.index, digest.cells, float("nan")
    found.cells.append(np.array([index.setdefault(cell, len(index)) for cell in cells], dtype=np.int32))
    found.numbers.append(np.array([number for number, _ in cells.values()], dtype=float))
    found.solutions.append(np.array([digest.right.get(cell, nan) for cell in cells], dtype=float))
    found.rules.append(np.array([_NUMBER_OF[rule] for _, rule in cells.values()], dtype=np.int8))


def _in_order(found: _Gathered) -> Entries:
    """The cells of all works by id: what follows must not go by the order in which works came."""
    order = sorted(range(len(found.who)), key=lambda k: found.who[k].id)
    found.rules = [found.rules[k] for k in order]
    sizes = [len(found.cells[k]) for k in order]
    empty = [np.zeros(0)]
    rules = np.concatenate([*found.rules, np.zeros(0, dtype=np.int8)])
    return Entries(
        np.repeat(np.arange(len(order)), sizes),
        np.concatenate([*(found.cells[k] for k in order), np.zeros(0, dtype=np.int32)]),
        np.concatenate([*(found.numbers[k] for k in order), *empty]),
        np.concatenate([*(found.solutions[k] for k in order), *empty]),
        np.isin(rules, [_NUMBER_OF[str(rule)] for rule in RIGHT]),
    )


def _shares(found: _Gathered, works: Entries) -> list[Share]:
    """Of every cell and of every column."""
    names = list(found.index)
    rules = np.concatenate([*found.rules, np.zeros(0, dtype=np.int8)]).astype(int)
    counts = np.bincount(works.cell * len(_RULES) + rules, minlength=len(names) * len(_RULES))
    by_cell = counts.reshape(len(names), len(_RULES))
    by_column: dict[tuple[str, str], Array] = {}
    for (table, key, _), row in zip(names, by_cell, strict=True):
        by_column[table, key] = by_column.get((table, key), 0) + row
    causes = _causes(found.by_key)
    cells = [_share(*name, row) for name, row in zip(names, by_cell, strict=True)]
    return cells + [_share(*name, None, row, causes.get(name[1], ())) for name, row in by_column.items()]


def _causes(by_key: Mapping[tuple[str, str], int]) -> dict[str, tuple[tuple[str, int], ...]]:
    """Key of a column -> kinds of mistakes with the number of works, the most frequent first."""
    found: dict[str, list[tuple[str, int]]] = {}
    for (key, kind), count in sorted(by_key.items(), key=lambda item: (-item[1], item[0])):
        found.setdefault(key, []).append((kind, count))
    return {key: tuple(kinds) for key, kinds in found.items()}


def _share(
    table: str, key: str, row: str | None, counts: Array, causes: tuple[tuple[str, int], ...] = ()
) -> Share:
    count = {rule: int(counts[number]) for number, rule in enumerate(_RULES)}
    wrong = count[Rule.OFF] + count[Rule.SIGN]
    right, carried, missing = sum(count[rule] for rule in RIGHT), count[Rule.CARRIED], count[Rule.NO_ANSWER]
    return Share(table, key, row, right + carried + wrong + missing, right, carried, wrong, missing, causes)


def _hardest(shares: Iterable[Share]) -> tuple[Share, ...]:
    """Those that enough works were asked for, by the part that is right; of equal ones by name."""
    enough = [share for share in shares if share.asked >= FEW]
    return tuple(sorted(enough, key=lambda s: (s.part, s.table, s.key, _row(s.row))))


def _row(row: str | None) -> tuple[int, str]:
    """Rows in the order of their numbers, then by name."""
    return (int(row), "") if row and row.isdecimal() and len(row) < 9 else (0, row or "")


def _alike(found: Sequence[Copy], who: Sequence[Who]) -> Iterator[Alike]:
    return (Alike(who[c.one], who[c.other], c.shared, c.fits, c.cells) for c in found)


# ---------------------------------------------------------------- for the terminal


MARKED = N_("works marked: %(marked)s, not handed in: %(absent)s, not marked: %(failed)s")


def lines(found: Statistics) -> list[Message]:
    """Five lines at most."""
    marked = len(found.parts)
    said = [Message(MARKED, {"marked": marked, "absent": len(found.absent), "failed": len(found.failed)})]
    if marked:
        lower, median, upper = (f"{100 * part:.0f}" for part in found.quartiles)
        text = N_(
            "points: mean %(mean)s %%, median %(median)s %%, half of the works from %(lower)s to %(upper)s %%"
        )
        mean = f"{100 * found.mean:.0f}"
        said.append(Message(text, {"mean": mean, "median": median, "lower": lower, "upper": upper}))
    said += [*_hard_line(found), *_copies_line(found), *_mixed_line(found)]
    return said


def _hard_line(found: Statistics) -> Iterator[Message]:
    hard = [share for share in found.columns if share.part < 1][:NAMED]
    if hard:
        names = ", ".join(f"{shown(share.key)} {100 * share.part:.0f} %" for share in hard)
        yield Message(N_("hardest columns, share of right cells: %(names)s"), {"names": names})


def _copies_line(found: Statistics) -> Iterator[Message]:
    if found.copies:
        pairs = [
            f"{shown(c.one.id)} – {shown(c.other.id)} ({c.shared}/{c.cells})" for c in found.copies[:NAMED]
        ]
        more = ", …" if len(found.copies) > NAMED else ""
        text = N_("same numbers with different variants, worth a look: %(count)s: %(pairs)s")
        yield Message(text, {"count": len(found.copies), "pairs": ", ".join(pairs) + more})


def _mixed_line(found: Statistics) -> Iterator[Message]:
    if found.mixed:
        pairs = [f"{shown(m.one.id)} → {shown(m.other.id)}" for m in found.mixed[:NAMED]]
        more = ", …" if len(found.mixed) > NAMED else ""
        text = N_("numbers of another variant: %(count)s: %(pairs)s")
        yield Message(text, {"count": len(found.mixed), "pairs": ", ".join(pairs) + more})
