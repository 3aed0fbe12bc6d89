"""Whether a work as a whole is right in another world (see `worlds`): then its mistake is one, and is charged once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import chain
from typing import Any

import numpy as np

from tmm_report.course import Results
from tmm_report.grading import worlds
from tmm_report.grading.expected import expected, of_tables
from tmm_report.grading.worlds import Aim, World
from tmm_report.judging.diagnose.words import named
from tmm_report.judging.model import Answered, Asked, Cause, Expected, Judged, Name
from tmm_report.records import dataclass

Array = Any
Agrees = Callable[[Asked, Answered, Array], Array]
SHARE = 0.7  # of the wrong cells that must be right in the other world
FEWEST, PART, COLUMNS = 6, 0.05, 2  # cells that it must mend beyond those it spoils, part of all; columns
CERTAIN = 0.97  # of the wrong cells: nothing better need be looked for


@dataclass(frozen=True, eq=False)
class Recognised:
    """`cause`: what was done otherwise; `fits`: name of a column -> (P,) its wrong cells that are right there;
    `there`: all that can be asked of `results`, the solution with the mistake in it."""

    cause: Cause
    fits: Mapping[Name, Array]
    there: Expected
    results: Results


@dataclass(frozen=True, eq=False)
class Handed:
    """A work to be recognised. `judged`: its columns by positions, those asked; `wrong`: (P,) of bool each;
    `agrees`: where a student's numbers are those of a column with other values."""

    results: Results
    asked: Expected
    answered: Mapping[Name, Answered]
    judged: Mapping[Name, Judged]
    wrong: Mapping[Name, Array]
    agrees: Agrees
    limit: float
    floors: Mapping[Name, float]


def recognised(work: Handed, data: bool = True) -> Recognised | None:
    """The world that explains most of what is wrong; None where none explains nearly all of it."""
    best: tuple[int, Recognised] | None = None
    all_wrong = sum(int(one.sum()) for one in work.wrong.values())
    with np.errstate(all="ignore"):
        for world in _tried(work, data):
            found = _fitting(work, world, all_wrong)
            if found is not None and (best is None or found[0] > best[0]):
                best = found
            if best is not None and best[0] >= CERTAIN * all_wrong:
                break
    return best[1] if best is not None else None


def _tried(work: Handed, data: bool) -> Iterator[World]:
    some: list[Iterable[World]] = [worlds.assembled(work.results), worlds.turned(work.results)]
    if data:
        some.append(worlds.misread(work.results, _aim(work)))
    return chain.from_iterable(some)


def _fitting(work: Handed, world: World, all_wrong: int) -> tuple[int, Recognised] | None:
    there = of_tables(world.results, {name[0] for name in work.judged})
    fits: dict[Name, Array] = {}
    spoilt = right = 0
    for name, judged in work.judged.items():
        one = there.get(name)
        if one is None or len(one.values) != len(work.asked[name].values):
            return None
        agrees = work.agrees(work.asked[name], work.answered[name], one.values)
        spoilt += int((judged.ok & ~agrees).sum())
        right += int(judged.ok.sum())
        if name in work.wrong and (some := work.wrong[name] & agrees).any():
            fits[name] = some
    mended = sum(int(some.sum()) for some in fits.values())
    enough = max(FEWEST, PART * (right + all_wrong))
    if mended < SHARE * all_wrong or mended - spoilt < enough or len(fits) < COLUMNS:
        return None
    cause, there = _cause(work, world, fits, mended / all_wrong), expected(world.results)
    return mended - spoilt, Recognised(cause, fits, there, world.results)


def _cause(work: Handed, world: World, fits: Mapping[Name, Array], explains: float) -> Cause:
    mended = {
        name: np.where(some, work.asked[name].values, work.answered[name].values)
        for name, some in fits.items()
    }
    names = tuple(fits)
    what = replace(world.what, values={**world.what.values, "columns": named(names, work.asked)})
    return Cause(world.kind, names, what, world.detail, mended, explains)


def _aim(work: Handed) -> Aim:
    """The wrong cells one after another. Magnitudes are taken in the direction that is right."""
    names = [name for name, wrong in work.wrong.items() if wrong.any() and not work.asked[name].angle]
    right = [work.asked[name].values[work.wrong[name]] for name in names]
    mine = [
        np.copysign(values, own) if work.judged[name].magnitudes else values
        for name, own in zip(names, right, strict=True)
        for values in (work.answered[name].values[work.wrong[name]],)
    ]
    allowed = [
        np.maximum(work.limit / 100 * np.abs(own), work.floors[name])
        for name, own in zip(names, right, strict=True)
    ]

    tables = {name[0] for name in names}

    def read(results: Results) -> Array:
        there = of_tables(results, tables)
        cells = [
            there[name].values[work.wrong[name]]
            if name in there and len(there[name].values) == len(work.wrong[name])
            else np.full(int(work.wrong[name].sum()), np.nan)
            for name in names
        ]
        return np.concatenate(cells) if cells else np.zeros(0)

    if not names:
        return Aim(np.zeros(0), np.zeros(0), np.zeros(0), read)
    return Aim(np.concatenate(right), np.concatenate(mine), np.concatenate(allowed), read)
