"""The numbers of a spur stage that anyone can read: single ones and tables."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.gears.spur import loosening, qualities
from tmm_report.chapters.gears.spur.solve.pair import Found
from tmm_report.chapters.gears.spur.steps import stage
from tmm_report.chapters.gears.spur.values import Points
from tmm_report.mechanics.gears.limits.condition import Condition
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, text_column
from tmm_report.quantity.sheet import Q, Row, columns
from tmm_report.quantity.symbols import Symbol, segment
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.wheel_words import of_wheel

WHEELS = N_("dimensions of the wheels of pair %(name)s")
CONDITIONS = N_("conditions of pair %(name)s")
SLIDING = N_("specific sliding of pair %(name)s along the line of action")
POINTS = N_("specific sliding of pair %(name)s at the points of the line of action")
PHASE = N_(
    "two pairs of teeth of pair %(name)s in contact: the points of contact K1, K2 and a point T of their path"
)
VELOCITIES = N_("velocities of the point of contact of pair %(name)s")
READINGS = N_("values read off the drawing of pair %(name)s against calculation")
CONTOUR = N_(
    "shifts of pair %(name)s in the blocking contour: those chosen and the nearest that meet every limit"
)
LACKS = N_("limits of the blocking contour that the shifts of pair %(name)s break")

INSPECTION = N_("by what the wheels of pair %(name)s are measured")
CUTTER = N_("wheels of pair %(name)s cut by a pinion cutter")

SI = {"mm": "m", "deg": "deg", "": ""}  # unit of print of a condition -> that of the results
POINT = N_("A, B: ends of the active part; C, D: ends of two-pair contact; P: the pitch point")
NUMBER_OF_WHEEL = Message(N_("number of the wheel"))
UNIT_OF_ROW = Message(N_("unit of the numbers in the row"))


def book(found: Found, prefix: str) -> Book:
    """All of the stage; every name begins with `prefix`."""
    return Book.of(tables(found, prefix), values(found, prefix))


@tabulated
def values(found: Found, prefix: str) -> Iterator[Value]:
    """The single numbers of the pair; every key begins with `prefix`."""
    made = stage(found, prefix)
    yield from made.s.values()
    yield from made.drawn.values()
    if made.loosened:
        yield from made.loosened.values()
    if made.divided:
        yield from made.divided.values()


@tabulated
def tables(found: Found, prefix: str) -> Iterator[Table]:
    """The wheels, conditions, specific sliding over the line of action, readings of the drawing, blocking contour."""
    made = stage(found, prefix)
    cut = [found.given.wheels[i] for i in found.cut_wheels]
    parts: dict[str, tuple[str, Iterable[Column]]] = {
        "wheels": (WHEELS, _rows(found.given.wheels, made.wheels)),
        "inspection": (INSPECTION, _rows(found.given.wheels, made.gauges)),
        "conditions": (CONDITIONS, _conditions(found)),
        "sliding": (SLIDING, _sliding(found)),
        "readings": (READINGS, _readings(found)),
        "contour": (CONTOUR, _contour(found)),
        "points": (POINTS, _points(found)),
        **({"velocities": (VELOCITIES, _velocities(found))} if found.motion else {}),
        **({"phase": (PHASE, _phase(found))} if found.phase else {}),
        **({} if found.contour.feasible else {"lacks": (LACKS, _lacks(found))}),
        **({"cutter": (CUTTER, _rows(cut, made.tools))} if cut else {}),
    }
    if found.backlash and found.backlash.limits:
        parts["limits"] = loosening.LIMITS, loosening.limits(made, found.backlash)
    if found.quality:
        parts |= {key: (meaning, of) for key, meaning, of in qualities.tables(made, found.quality)}
    told = {"name": found.name, "wheel": found.given.wheels[0]}
    for key, (meaning, table) in parts.items():
        yield Table(f"{prefix}_{key}", Message(meaning, told), tuple(table))


def degrees(unit: str, value: Any) -> Any:
    """An angle in the unit of the results; other values as they are."""
    return np.degrees(value) if unit == "deg" else value


# ---------------------------------------------------------------- wheels


def _rows(names: Sequence[str], rows: Sequence[Row]) -> Iterator[Column]:
    yield text_column("wheel", NUMBER_OF_WHEEL, list(names))
    yield from columns(rows)


# ---------------------------------------------------------------- conditions


def _conditions(found: Found) -> Iterator[Column]:
    of = found.conditions
    units, symbols = [SI[c.unit] for c in of], [_symbol(c, found) for c in of]
    yield text_column("condition", Message(N_("name of the condition")), [c.key for c in of])
    yield text_column("wheel", NUMBER_OF_WHEEL, [c.wheel for c in of])
    yield text_column("unit", UNIT_OF_ROW, units)
    for key, meaning in (("value", N_("value")), ("limit", N_("limit")), ("margin", N_("margin"))):
        numbers = [float(degrees(c.unit, getattr(c, key))) for c in of]
        yield Column(Quantity(key, None, "", Message(meaning)), numbers, symbols, units)
    met = Quantity("met", None, "", Message(N_("1 where the condition is met")))
    yield met.column([int(c.met) for c in of])


def _symbol(c: Condition, found: Found) -> Symbol:
    """What a condition is about."""
    helical, short = bool(found.pair.beta > 0), found.cut_short
    symbols = {
        "undercut": Symbol("x"), "pointing": Symbol("s", "na" if helical else "a"),
        "contact": Symbol("epsilon", "alpha"), "interference": Symbol("rho", "m" if short else "p"),
        "fouling": Symbol("Delta", "phi"), "sliding": Symbol("lambda", "p"), "space": Symbol("e", "f"),
        "radial": Symbol("Delta", "r"), "trimming": Symbol("Delta", "rho"),
        "cutter fouling": Symbol("Delta", "phi0"), "feed": Symbol("Delta", "r0"),
    }  # fmt: skip
    return of_wheel(symbols[c.key], c.wheel)


# ---------------------------------------------------------------- line of action


def _each(of: Q, found: Found, numbers: Sequence[Any]) -> Iterator[Column]:
    """A column for each wheel, by its name."""
    for name, own in zip(found.given.wheels, numbers, strict=False):
        yield of.of(name, wheel=name).column(own)


def _sliding(found: Found) -> Iterator[Column]:
    at = found.path.along
    yield from _each(Points.rho, found, [at.rho])
    yield from _each(Points.lambda_, found, (at.first, at.second))


def _points(found: Found) -> Iterator[Column]:
    path = found.path
    yield text_column("point", Message(POINT), list(path.points))
    yield from _each(Points.rho, found, (path.at.rho, path.mates))
    yield from _each(Points.lambda_, found, (path.at.first, path.at.second))


def _velocities(found: Found) -> Iterator[Column]:
    motion, points = found.motion, list(found.path.points)
    assert motion is not None
    yield text_column("point", Message(POINT), points)
    yield from _each(Points.v_tau, found, motion.across)
    yield from _each(Points.v, found, motion.whole)
    yield Points.v_sl.column(motion.sliding)


def _phase(found: Found) -> Iterator[Column]:
    phase = found.phase
    assert phase is not None
    text = N_("K1, K2: where two pairs of teeth touch; T: where the conjugate points t1 and t2 touch")
    yield text_column("point", Message(text), list(phase.points))
    yield from _each(Points.rho, found, phase.rho)
    yield from _each(Points.r, found, phase.radii)


# ---------------------------------------------------------------- drawing of the mesh


READ_SYMBOLS = {
    "angle": Symbol("phi", "gamma"), "pitch": Symbol("tau"), "ratio": Symbol("epsilon", "alpha"),
}  # fmt: skip


def _readings(found: Found) -> Iterator[Column]:
    """Lengths in m, angles in rad."""
    rows, names = found.readings, found.given.wheels
    units = ["m" if row.wheel is None else "" if row.key == "ratio" else "rad" for row in rows]
    wheels = ["" if row.wheel is None else names[row.wheel] for row in rows]
    computed = [_read_symbol(row.key, wheel) for row, wheel in zip(rows, wheels, strict=True)]
    read = [replace(s, sub="gr") if row.key == "ratio" else s for s, row in zip(computed, rows, strict=True)]
    graph = Quantity("graph", None, "", Message(N_("by the drawing, SI")))
    analytic = Quantity("analytic", None, "", Message(N_("by calculation, SI")))
    delta = Quantity("delta", Symbol("delta"), "%", Message(N_("difference of the methods")))
    yield text_column("key", Message(N_("quantity")), [row.key for row in rows])
    yield text_column("wheel", NUMBER_OF_WHEEL, wheels)
    yield Column(graph, [row.drawn for row in rows], read, units)
    yield Column(analytic, [row.computed for row in rows], computed, units)
    yield delta.column([100 * row.error for row in rows])
    yield text_column("unit", UNIT_OF_ROW, units)


def _read_symbol(key: str, wheel: str) -> Symbol:
    """A segment is named by its ends; the contact ratio is one for both wheels."""
    if not wheel:
        return segment(key)
    return READ_SYMBOLS[key] if key == "ratio" else of_wheel(READ_SYMBOLS[key], wheel)


# ---------------------------------------------------------------- blocking contour


def _contour(found: Found) -> Iterator[Column]:
    of = found.contour
    points = {"chosen": of.chosen, "nearest": of.nearest, "same_distance": of.same_distance}
    missing = complex(np.nan, np.nan)
    shifts = np.array([missing if x is None else x for x in points.values()])
    meaning = N_("chosen; the nearest that meets every limit; the nearest of the same centre distance")
    yield text_column("point", Message(meaning), list(points))
    yield from _each(Points.x, found, (shifts.real, shifts.imag))
    yield Points.step.column(np.abs(shifts - of.chosen))


def _lacks(found: Found) -> Iterator[Column]:
    """Thicknesses and radii in modules, angles in degrees."""
    of = found.contour.lacks
    units = ["deg" if lack.limit.kind in ("fouling", "cutter fouling") else "" for lack in of]
    wheels = [found.given.wheels[lack.limit.wheel - 1] if lack.limit.wheel else "" for lack in of]
    numbers = ((lack.value, lack.limit.bound, lack.lack) for lack in of)
    value, bound, wanting = zip(*numbers, strict=True)
    yield text_column("limit", Message(N_("name of the limit")), [lack.limit.kind for lack in of])
    yield text_column("wheel", NUMBER_OF_WHEEL, wheels)
    yield text_column("unit", UNIT_OF_ROW, units)
    for key, meaning, column in (
        ("value", N_("value"), value), ("bound", N_("limit"), bound), ("lack", N_("what is lacking"), wanting),
    ):  # fmt: skip
        shown = [float(degrees(unit, x)) for unit, x in zip(units, column, strict=True)]
        yield Column(Quantity(key, None, "", Message(meaning)), shown, units=units)
