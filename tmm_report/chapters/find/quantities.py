"""The numbers of a question asked backwards: the unknowns, the demanded numbers, the roots, the course over the range.

Of two unknowns and two demands the names of the second end with 2.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.find.closed import closed_value, wanted_value
from tmm_report.chapters.find.given import Unknown
from tmm_report.chapters.find.letters import plain, sought
from tmm_report.chapters.find.pair import Both
from tmm_report.chapters.find.solve import Found
from tmm_report.chapters.find.target import Target
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.units import DIMENSIONS

LOW, HIGH = NP_("index", "min"), NP_("index", "max")
ROOTS = Message(N_("values of the unknown at which the demand is met"))
PAIRS = Message(N_("values of the unknowns at which both demands are met"))
COURSE = Message(N_("the demanded number over the range of the unknown"))
GRID = Message(N_("the demanded numbers over the ranges of the unknowns"))
LOST = Message(N_("parts of the range in which the variant has no such number"))
JUMPS = Message(N_("values of the unknown at which the demanded number jumps over the wanted one"))
NUMBER = Quantity("number", Symbol("j"), "", Message(N_("number of the root")))
COUNT = Quantity("find_count", Symbol("k"), "", Message(N_("number of roots in the range")))
SOLVED = Quantity("find_solved", Symbol("N"), "", Message(N_("how many values were tried")))


# --- what they are


def demanded(of: Target, key: str) -> Quantity:
    """As the chapter declares it that it is a number of."""
    symbol = of.quantity.symbol or Symbol("y")
    return Quantity(
        key, symbol, of.quantity.unit, Message(N_("%(of)s"), {"of": of.quantity.meaning}), of.quantity.shown
    )


def residual(of: Target, key: str, which: str = "") -> Quantity:
    meaning = Message(N_("%(of)s, less what is wanted"), {"of": of.quantity.meaning})
    return Quantity(key, Symbol("Delta", which), of.quantity.unit, meaning)


def rate(of: Target, by: Unknown, key: str, which: str = "") -> Quantity:
    """`which`: numbers of the demand and of the unknown, where there are two."""
    above, below = of.quantity.unit, plain(DIMENSIONS[by.dimension].unit)
    over = f"({above})" if "/" in above or "·" in above else above
    under = f"({below})" if "/" in below or "·" in below else below
    unit = f"{over or 1}/{under}" if below else above
    text = N_("change of the demanded number for a unit of the unknown")
    if which:
        text = N_("change of demanded number %(demand)s for a unit of unknown %(unknown)s")
    meaning = Message(text, dict(zip(("demand", "unknown"), which, strict=False)))
    return Quantity(key, Symbol("S", which), unit, meaning)


# --- single numbers


@tabulated
def values(found: Found | Both) -> Iterator[Value]:
    yield from _of_both(found) if isinstance(found, Both) else _of_one(found)


def _of_one(found: Found) -> Iterator[Value]:
    of, target, letter = found.given.unknown, found.target, found.letter
    yield sought(of, letter, "find_x").value(found.size(found.chosen.at))
    yield from _range(of, letter)
    yield demanded(target, "find_y").value(found.chosen.value)
    if math.isfinite(found.level):
        yield wanted_value(target, found.level)
        yield residual(target, "find_residual").value(found.chosen.value - found.level)
    k = found.sought.roots.index(found.chosen) if found.chosen in found.sought.roots else -1
    if k >= 0 and math.isfinite(found.slopes[k]):
        yield rate(target, of, "find_rate").value(found.slopes[k])
    if found.closed is not None:
        yield from _by_formula(
            closed_value(of, letter, found.closed.number), found.size(found.chosen.at), k >= 0
        )
    yield COUNT.value(float(len(found.sought.roots)))
    yield SOLVED.value(float(found.solved))


def _by_formula(value: Value, x: float, found: bool, last: str = "", which: str = "") -> Iterator[Value]:
    """What a formula gives, and by how much the root, where there is one, differs from it."""
    yield value
    if found and x:
        text = N_("difference of the root from what the formula gives, of the root")
        off = Quantity(f"find_closed_off{last}", Symbol("epsilon", which), "%", Message(text))
        yield off.value(100 * (x - value.value) / x)


def _range(of: Unknown, letter: Quantity | None, last: str = "", which: str = "") -> Iterator[Value]:
    low, high = N_("least value of the range of %(name)s"), N_("greatest value of the range of %(name)s")
    yield sought(of, letter, f"find_low{last}", low, LOW, which).value(of.size(of.low))
    yield sought(of, letter, f"find_high{last}", high, HIGH, which).value(of.size(of.high))


def _of_both(found: Both) -> Iterator[Value]:
    given, sizes = found.given, found.sizes(found.chosen.at)
    for k, of in enumerate(given.unknowns):
        last, which = _ends(k)
        yield sought(of, found.letters[k], f"find_x{last}", which=which).value(sizes[k])
        yield from _range(of, found.letters[k], last, which)
    for k, target in enumerate(found.targets):
        last, which = _ends(k)
        yield demanded(target, f"find_y{last}").value(found.chosen.value[k])
        yield wanted_value(target, found.levels[k], last)
        yield residual(target, f"find_residual{last}", which).value(found.chosen.value[k] - found.levels[k])
    for k, form in found.closed:
        last, which = _ends(k)
        value = closed_value(given.unknowns[k], found.letters[k], form.number, last, which)
        yield from _by_formula(value, sizes[k], found.sound, last, which)
    yield COUNT.value(float(len(found.sought.roots)))
    yield SOLVED.value(float(found.solved))


def _ends(k: int) -> tuple[str, str]:
    """Of the key, of the index."""
    return "2" if k else "", str(k + 1)


# --- tables


@tabulated
def tables(found: Found | Both) -> Iterator[Table]:
    yield from _tables_of_both(found) if isinstance(found, Both) else _tables_of_one(found)


def _tables_of_one(found: Found) -> Iterator[Table]:
    of, target, letter, over = found.given.unknown, found.target, found.letter, found.sought
    x, y = sought(of, letter, "x"), demanded(target, "y")
    if over.roots and math.isfinite(found.level):
        at = np.array([root.value for root in over.roots])
        columns = [
            NUMBER.column(np.arange(1, len(at) + 1)),
            x.column(np.array([found.size(root.at) for root in over.roots])),
            y.column(at),
            residual(target, "residual").column(at - found.level),
        ]
        if np.isfinite(found.slopes).any():
            columns.append(rate(target, of, "rate").column(np.array(found.slopes)))
        yield Table("find_roots", ROOTS, tuple(columns))
    places = np.array([found.size(part) for part in over.x.tolist()])
    yield Table("find_course", COURSE, (x.column(places), y.column(over.f)))
    if over.jumps:
        yield Table("find_jumps", JUMPS, (x.column(np.array([found.size(part) for part in over.jumps])),))
    if over.lost:
        ends = np.array([[found.size(part) for part in pair] for pair in over.lost])
        begin = sought(of, letter, "begin", N_("where it begins, %(name)s"), LOW)
        end = sought(of, letter, "end", N_("where it ends, %(name)s"), HIGH)
        yield Table("find_lost", LOST, (begin.column(ends[:, 0]), end.column(ends[:, 1])))


def _tables_of_both(found: Both) -> Iterator[Table]:
    given, roots = found.given, found.sought.roots
    ends = [_ends(k) for k in range(2)]
    x = [
        sought(of, found.letters[k], f"x{ends[k][0]}", which=ends[k][1])
        for k, of in enumerate(given.unknowns)
    ]
    y = [demanded(of, f"y{ends[k][0]}") for k, of in enumerate(found.targets)]
    if roots:
        at = np.array([found.sizes(root.at) for root in roots])
        made = np.array([root.value for root in roots])
        columns = [NUMBER.column(np.arange(1, len(roots) + 1))]
        columns += [x[k].column(at[:, k]) for k in range(2)]
        columns += [y[k].column(made[:, k]) for k in range(2)]
        columns += [
            residual(of, f"residual{ends[k][0]}", ends[k][1]).column(made[:, k] - found.levels[k])
            for k, of in enumerate(found.targets)
        ]
        columns += [
            rate(of, by, f"rate_{k + 1}{j + 1}", f"{k + 1}{j + 1}").column(found.slopes[:, k, j])
            for k, of in enumerate(found.targets)
            for j, by in enumerate(given.unknowns)
        ]
        yield Table("find_roots", PAIRS, tuple(columns))
    places = np.array([found.sizes(one) for one in found.sought.x.reshape(-1, 2).tolist()])
    numbers = found.sought.f.reshape(-1, 2)
    grid = [*(x[k].column(places[:, k]) for k in range(2)), *(y[k].column(numbers[:, k]) for k in range(2))]
    yield Table("find_course", GRID, tuple(grid))
