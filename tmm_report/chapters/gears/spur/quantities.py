"""Every number of a spur stage that anyone can read: its key, symbol, unit and meaning."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.gears.spur.solve.cutter import columns_of
from tmm_report.chapters.gears.spur.solve.pair import Found
from tmm_report.chapters.gears.spur.values import values
from tmm_report.mechanics.gears.limits.condition import Condition
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol, segment
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.wheel_words import DIAMETERS, TEETH, dimension, of_wheel

__all__ = ["book", "tables", "values"]

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

CUTTER = N_("wheels of pair %(name)s cut by a pinion cutter")

SI = {"mm": "m", "deg": "deg", "": ""}  # unit of print of a condition -> that of the results
POINT = N_("A, B: ends of the active part; C, D: ends of two-pair contact; P: the pitch point")
NUMBER_OF_WHEEL = Message(N_("number of the wheel"))
UNIT_OF_ROW = Message(N_("unit of the numbers in the row"))

# one number for each wheel, by its attribute of the pair
DIMENSIONS = (
    *map(dimension, DIAMETERS | TEETH),
    Quantity("alpha_a", Symbol("alpha", "a"), "deg", Message(N_("profile angle at the tip"))),
    Quantity("rho_a", Symbol("rho", "a"), "m", Message(N_("radius of curvature of the profile at the tip"))),
    Quantity(
        "rho_p",
        Symbol("rho", "p"),
        "m",
        Message(N_("radius of curvature at the lower point of the active profile")),
    ),
    Quantity(
        "root_sliding",
        Symbol("lambda", "p"),
        "",
        Message(N_("specific sliding at the lower point of the active profile")),
    ),
    Quantity("tip_sliding", Symbol("lambda", "a"), "", Message(N_("specific sliding at the tip"))),
)
# the same where the contact is shorter than between the tip circles
SHORT = (
    Quantity(
        "rho_m",
        Symbol("rho", "m"),
        "m",
        Message(N_("radius of curvature where the tip circle of the other wheel meets the line of action")),
    ),
    Quantity(
        "rho_u",
        Symbol("rho", "u"),
        "m",
        Message(N_("radius of curvature at the upper point of the active profile")),
    ),
)


def book(found: Found, prefix: str) -> Book:
    """All of the stage; every name begins with `prefix`."""
    return Book.of(tables(found, prefix), values(found, prefix))


@tabulated
def tables(found: Found, prefix: str) -> Iterator[Table]:
    """The wheels, conditions, specific sliding over the line of action, readings of the drawing, blocking contour."""
    parts = {
        "wheels": (WHEELS, _wheels), "conditions": (CONDITIONS, _conditions), "sliding": (SLIDING, _sliding),
        "readings": (READINGS, _readings), "contour": (CONTOUR, _contour), "points": (POINTS, _points),
        **({"velocities": (VELOCITIES, _velocities)} if found.motion else {}),
        **({"phase": (PHASE, _phase)} if found.phase else {}),
        **({} if found.contour.feasible else {"lacks": (LACKS, _lacks)}),
        **({"cutter": (CUTTER, columns_of)} if found.cutters else {}),
    }  # fmt: skip
    for key, (meaning, columns) in parts.items():
        yield Table(f"{prefix}_{key}", Message(meaning, {"name": found.name}), tuple(columns(found)))


def degrees(unit: str, value: Any) -> Any:
    """An angle in the unit of the results; other values as they are."""
    return np.degrees(value) if unit == "deg" else value


# ---------------------------------------------------------------- wheels


def _wheels(found: Found) -> Iterator[Column]:
    pair, names = found.pair, found.given.wheels
    shift, least = Symbol("x"), Symbol("x", "min")
    rows: tuple[tuple[Quantity, Sequence[Any]], ...] = (
        (Quantity("z", Symbol("z"), "", Message(N_("number of teeth"))), found.teeth.z),
        (Quantity("x", shift, "", Message(N_("shift coefficient"))), (float(pair.x1), float(pair.x2))),
        (Quantity("x_rule", None, "", Message(N_("least shift by the rule"))), found.rule_shifts),
        (Quantity("x_min", least, "", Message(N_("exact least shift"))), [float(x) for x in pair.x_min]),
        *(
            (of, [float(degrees(of.unit, x)) for x in getattr(pair, of.key)])
            for of in (*DIMENSIONS, *(SHORT if found.cut_short else ()))
        ),
        (
            Quantity(
                "rho_l", Symbol("rho", "l"), "m", Message(N_("radius of curvature where the involute begins"))
            ),
            found.starts,
        ),
    )
    yield text_column("wheel", NUMBER_OF_WHEEL, list(names))
    for of, numbers in rows:
        yield Column(of, list(numbers), [of_wheel(of.symbol, name) for name in names] if of.symbol else ())


# ---------------------------------------------------------------- conditions


def _conditions(found: Found) -> Iterator[Column]:
    of = found.conditions
    units, symbols = [SI[c.unit] for c in of], [_symbol(c, found) for c in of]
    yield text_column("condition", Message(N_("name of the condition")), [c.key for c in of])
    yield text_column("wheel", NUMBER_OF_WHEEL, [c.wheel for c in of])
    yield text_column("unit", UNIT_OF_ROW, units)
    for key, meaning in (("value", N_("value")), ("limit", N_("limit")), ("margin", N_("what is in hand"))):
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


def _sliding(found: Found) -> Iterator[Column]:
    at, (one, two) = found.path.along, found.given.wheels
    yield _curvature(one).column(at.rho)
    for name, numbers in ((one, at.first), (two, at.second)):
        yield _slip(name).column(numbers)


def _points(found: Found) -> Iterator[Column]:
    path, (one, two) = found.path, found.given.wheels
    yield text_column("point", Message(POINT), list(path.points))
    for of, numbers in (
        (_curvature(one), path.at.rho), (_curvature(two), path.mates),
        (_slip(one), path.at.first), (_slip(two), path.at.second),
    ):  # fmt: skip
        yield of.column(numbers)


def _velocities(found: Found) -> Iterator[Column]:
    motion, points, wheels = found.motion, list(found.path.points), found.given.wheels
    assert motion is not None
    yield text_column("point", Message(POINT), points)
    across = N_("velocity of the point of the tooth of wheel %(wheel)s across the line of action")
    whole = N_("velocity of the point of the tooth of wheel %(wheel)s")
    for name, numbers in zip(wheels, motion.across, strict=True):
        yield _velocity(f"v_tau_{name}", "τ", name, across).column(numbers)
    for name, numbers in zip(wheels, motion.whole, strict=True):
        yield _velocity(f"v_{name}", "", name, whole).column(numbers)
    sliding = Message(N_("velocity of sliding, above zero where the driving wheel is the faster"))
    yield Quantity("v_sl", Symbol("V", "slide"), "m/s", sliding).column(motion.sliding)


def _phase(found: Found) -> Iterator[Column]:
    phase, wheels = found.phase, found.given.wheels
    assert phase is not None
    text = N_("K1, K2: where two pairs of teeth touch; T: where the conjugate points t1 and t2 touch")
    yield text_column("point", Message(text), list(phase.points))
    for name, numbers in zip(wheels, phase.rho, strict=True):
        yield _curvature(name).column(numbers)
    far = N_("distance of the point from the axis of wheel %(wheel)s")
    for name, numbers in zip(wheels, phase.radii, strict=True):
        yield Quantity(f"r_{name}", Symbol("r", name), "m", Message(far, {"wheel": name})).column(numbers)


def _velocity(key: str, index: str, wheel: str, meaning: str) -> Quantity:
    return Quantity(key, Symbol("V", index + wheel), "m/s", Message(meaning, {"wheel": wheel}))


def _curvature(wheel: str) -> Quantity:
    text = N_("radius of curvature of the profile of wheel %(wheel)s at the point of contact")
    return Quantity(f"rho_{wheel}", Symbol("rho", wheel), "m", Message(text, {"wheel": wheel}))


def _slip(wheel: str) -> Quantity:
    text = Message(N_("specific sliding of wheel %(wheel)s"), {"wheel": wheel})
    return Quantity(f"lambda_{wheel}", Symbol("lambda", wheel), "", text)


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
    for name, numbers in zip(found.given.wheels, (shifts.real, shifts.imag), strict=True):
        about = Message(N_("shift coefficient of wheel %(wheel)s"), {"wheel": name})
        yield Quantity(f"x_{name}", Symbol("x", name), "", about).column(numbers)
    step = Quantity("step", None, "", Message(N_("distance from the chosen shifts")))
    yield step.column(np.abs(shifts - of.chosen))


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
        ("value", N_("value"), value), ("bound", N_("limit"), bound), ("lack", N_("what is wanting"), wanting),
    ):  # fmt: skip
        shown = [float(degrees(unit, x)) for unit, x in zip(units, column, strict=True)]
        yield Column(Quantity(key, None, "", Message(meaning)), shown, units=units)
