"""Tables and values of a spur stage."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.spur import contour as blocking
from tmm_report.chapters.spur.mesh import mesh_of
from tmm_report.chapters.spur.solve import Found
from tmm_report.chapters.spur.wheel_words import DIAMETERS, TEETH
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, Value, plain, plain_value

WHEELS = N_("dimensions of the wheels of pair %(name)s")
CONDITIONS = N_("conditions of pair %(name)s")
SLIDING = N_("specific sliding of pair %(name)s along the line of action")
READINGS = N_("values read off the drawing of pair %(name)s against calculation")
CONTOUR = N_(
    "shifts of pair %(name)s in the blocking contour: those chosen and the nearest that meet every limit"
)

# attribute of the pair, unit, meaning; one number for each wheel
DIMENSIONS = (
    *((key, "m", meaning) for key, meaning in (DIAMETERS | TEETH).items()),
    ("alpha_a", "deg", N_("profile angle at the tip")),
    ("rho_a", "m", N_("radius of curvature of the profile at the tip")),
    ("rho_p", "m", N_("radius of curvature at the lower point of the active profile")),
    ("root_sliding", "", N_("specific sliding at the lower point of the active profile")),
    ("tip_sliding", "", N_("specific sliding at the tip")),
)
# attribute of the pair, unit, meaning; one number for the pair
VALUES = (
    ("ratio", "", N_("ratio of the angular velocities")),
    ("a", "m", N_("reference centre distance")),
    ("a_w", "m", N_("centre distance")),
    ("alpha_w", "deg", N_("operating pressure angle")),
    ("x_sum", "", N_("sum of the shift coefficients (of an internal pair, their difference)")),
    ("y", "", N_("coefficient of the shift of the centres")),
    ("shortening", "", N_("coefficient of the shortening of the tips")),
    ("p", "m", N_("pitch")),
    ("p_b", "m", N_("base pitch")),
    ("p_w", "m", N_("pitch on the working circles")),
    ("backlash", "m", N_("backlash on the working circles")),
    ("line", "m", N_("theoretical line of action, between its points of contact with the base circles")),
    ("active", "m", N_("active part of the line of action")),
    ("eps", "", N_("contact ratio")),
    ("two_pairs", "", N_("share of the time in which two pairs are in mesh")),
)


def values(found: Found, prefix: str) -> Iterator[Value]:
    """The single numbers of the pair."""
    for key, unit, meaning in VALUES:
        number = float(_in(unit, getattr(found.pair, key)))
        yield plain_value(f"{prefix}_{key}", number, unit, Message(meaning))


def tables(found: Found, prefix: str) -> Iterator[Table]:
    """The wheels, conditions, specific sliding over the line of action, readings of the drawing, blocking contour."""
    name = {"name": found.name}
    yield Table(f"{prefix}_wheels", Message(WHEELS, name), tuple(_wheels(found)))
    yield Table(f"{prefix}_conditions", Message(CONDITIONS, name), tuple(_conditions(found)))
    yield Table(f"{prefix}_sliding", Message(SLIDING, name), tuple(_sliding(found)))
    yield Table(f"{prefix}_readings", Message(READINGS, name), tuple(_readings(found)))
    yield Table(f"{prefix}_contour", Message(CONTOUR, name), tuple(_contour(found)))


def _in(unit: str, value: Any) -> Any:
    return np.degrees(value) if unit == "deg" else value


def _wheels(found: Found) -> Iterator[Column]:
    pair = found.pair
    yield plain("wheel", "", Message(N_("number of the wheel")), list(found.given.wheels))
    yield plain("z", "", Message(N_("number of teeth")), list(found.teeth.z))
    yield plain("x", "", Message(N_("shift coefficient")), [float(pair.x1), float(pair.x2)])
    yield plain("x_rule", "", Message(N_("least shift by the rule")), list(found.rule_shifts))
    yield plain("x_min", "", Message(N_("exact least shift")), [float(x) for x in pair.x_min])
    for key, unit, meaning in DIMENSIONS:
        numbers = [float(_in(unit, value)) for value in getattr(pair, key)]
        yield plain(key, unit, Message(meaning), numbers)


def _conditions(found: Found) -> Iterator[Column]:
    of = found.conditions
    yield plain("condition", "", Message(N_("name of the condition")), [c.key for c in of])
    yield plain("wheel", "", Message(N_("number of the wheel")), [c.wheel for c in of])
    yield plain("unit", "", Message(N_("unit of the numbers in the row")), [_SI[c.unit] for c in of])
    for key, meaning in (("value", N_("value")), ("limit", N_("limit")), ("margin", N_("what is in hand"))):
        numbers = [float(_in(c.unit, getattr(c, key))) for c in of]
        yield plain(key, "", Message(meaning), numbers)
    yield plain("met", "", Message(N_("1 where the condition is met")), [int(c.met) for c in of])


_SI = {"mm": "m", "deg": "deg", "": ""}  # lengths stand in the results in metres


def _sliding(found: Found) -> Iterator[Column]:
    at = found.sliding()
    one, two = found.given.wheels
    curvature = N_("radius of curvature of the profile of wheel %(wheel)s at the point of contact")
    yield plain(f"rho_{one}", "m", Message(curvature, {"wheel": one}), at.rho)
    for name, numbers in ((one, at.first), (two, at.second)):
        meaning = Message(N_("specific sliding of wheel %(wheel)s"), {"wheel": name})
        yield plain(f"lambda_{name}", "", meaning, numbers)


def _readings(found: Found) -> Iterator[Column]:
    """Lengths in m, angles in rad."""
    rows = mesh_of(found).readings
    wheels = ["" if row.wheel is None else found.given.wheels[row.wheel] for row in rows]
    yield plain("key", "", Message(N_("quantity")), [row.key for row in rows])
    yield plain("wheel", "", Message(N_("number of the wheel")), wheels)
    yield plain("graph", "", Message(N_("by the drawing, SI")), [row.drawn for row in rows])
    yield plain("analytic", "", Message(N_("by calculation, SI")), [row.computed for row in rows])
    yield plain("delta", "%", Message(N_("difference of the methods")), [100 * row.error for row in rows])


def _contour(found: Found) -> Iterator[Column]:
    of = blocking.solve(found)
    points = {"chosen": of.chosen, "nearest": of.nearest, "same_distance": of.nearest_at_distance}
    missing = complex(np.nan, np.nan)
    shifts = np.array([missing if x is None else x for x in points.values()])
    meaning = N_("chosen; the nearest that meets every limit; the nearest of the same centre distance")
    yield plain("point", "", Message(meaning), list(points))
    for name, numbers in zip(found.given.wheels, (shifts.real, shifts.imag), strict=True):
        about = Message(N_("shift coefficient of wheel %(wheel)s"), {"wheel": name})
        yield plain(f"x_{name}", "", about, numbers)
    yield plain("step", "", Message(N_("distance from the chosen shifts")), np.abs(shifts - of.chosen))
