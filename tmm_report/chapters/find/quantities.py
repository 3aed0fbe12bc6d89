"""The numbers of a question asked backwards: the unknown, the demanded number, the roots, the course over the range."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tmm_report.chapters.find.solve import Found
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.units import DIMENSIONS, factor

X, SOUGHT, WANTED = Symbol("x"), NP_("index", "seek"), NP_("index", "want")
ROOTS = Message(N_("values of the unknown at which the demand is met"))
COURSE = Message(N_("the demanded number over the range of the unknown"))
LOST = Message(N_("parts of the range in which the variant has no such number"))
JUMPS = Message(N_("values of the unknown at which the demanded number jumps over the wanted one"))


def plain(unit: str) -> str:
    """A unit as the results write it."""
    return "" if unit == "1" else unit.replace("*", "·").replace("^2", "²").replace("^3", "³")


def unknown(
    found: Found, key: str = "x", text: str = N_("unknown number %(name)s"), end: str = ""
) -> Quantity:
    """In SI; printed in the unit of its range, where that is one of those that notes print."""
    of = found.given.unknown
    unit, own = plain(DIMENSIONS[of.dimension].unit), plain(of.unit)
    symbol = Symbol("x", end or SOUGHT)
    try:
        factor(unit, own)
    except KeyError:
        own = ""
    shown = own if own not in ("", unit) else ""
    return Quantity(key, symbol, unit, Message(text, {"name": of.name}), shown)


def demanded(found: Found, key: str = "y", text: str = N_("%(of)s"), sub: str = "") -> Quantity:
    """As the chapter declares it that it is a number of."""
    of = found.target.quantity
    symbol = of.symbol or Symbol("y")
    symbol = replace(symbol, sub=sub) if sub else symbol
    return Quantity(key, symbol, of.unit, Message(text, {"of": of.meaning}), of.shown)


def residual(found: Found, key: str) -> Quantity:
    of = found.target.quantity
    meaning = Message(N_("%(of)s, less what is wanted"), {"of": of.meaning})
    return Quantity(key, Symbol("Delta"), of.unit, meaning)


def rate(found: Found, key: str) -> Quantity:
    of, by = found.target.quantity.unit, unknown(found).unit
    over = f"({of})" if "/" in of or "·" in of else of
    under = f"({by})" if "/" in by or "·" in by else by
    unit = f"{over or 1}/{under}" if by else of
    meaning = Message(N_("change of the demanded number for a unit of the unknown"))
    return Quantity(key, Symbol("S"), unit, meaning)


@tabulated
def values(found: Found) -> Iterator[Value]:
    of = found.given.unknown
    yield unknown(found, "find_x").value(found.size(found.chosen.at))
    yield unknown(found, "find_low", N_("least value of the range of %(name)s"), NP_("index", "min")).value(
        of.size(of.low)
    )
    yield unknown(
        found, "find_high", N_("greatest value of the range of %(name)s"), NP_("index", "max")
    ).value(of.size(of.high))
    yield demanded(found, "find_y").value(found.chosen.value)
    if math.isfinite(found.level):
        yield demanded(found, "find_wanted", N_("%(of)s, as it is wanted"), WANTED).value(found.level)
        yield residual(found, "find_residual").value(found.chosen.value - found.level)
    k = found.sought.roots.index(found.chosen) if found.chosen in found.sought.roots else -1
    if k >= 0 and math.isfinite(found.slopes[k]):
        yield rate(found, "find_rate").value(found.slopes[k])
    yield Quantity("find_count", Symbol("k"), "", Message(N_("number of roots in the range"))).value(
        float(len(found.sought.roots))
    )
    yield Quantity("find_solved", Symbol("N"), "", Message(N_("how many values were tried"))).value(
        float(found.solved)
    )


@tabulated
def tables(found: Found) -> Iterator[Table]:
    x, y, sought = unknown(found), demanded(found), found.sought
    if sought.roots and math.isfinite(found.level):
        at = np.array([root.value for root in sought.roots])
        number = Quantity("number", Symbol("k"), "", Message(N_("number of the root")))
        columns = [
            number.column(np.arange(1, len(at) + 1)),
            x.column(np.array([found.size(root.at) for root in sought.roots])),
            y.column(at),
            residual(found, "residual").column(at - found.level),
        ]
        if np.isfinite(found.slopes).any():
            columns.append(rate(found, "rate").column(np.array(found.slopes)))
        yield Table("find_roots", ROOTS, tuple(columns))
    over = np.array([found.size(part) for part in sought.x.tolist()])
    yield Table("find_course", COURSE, (x.column(over), y.column(sought.f)))
    if sought.jumps:
        yield Table("find_jumps", JUMPS, (x.column(np.array([found.size(part) for part in sought.jumps])),))
    if sought.lost:
        ends = np.array([[found.size(part) for part in pair] for pair in sought.lost])
        begin = unknown(found, "begin", N_("where it begins, %(name)s"), NP_("index", "min"))
        end = unknown(found, "end", N_("where it ends, %(name)s"), NP_("index", "max"))
        yield Table("find_lost", LOST, (begin.column(ends[:, 0]), end.column(ends[:, 1])))
