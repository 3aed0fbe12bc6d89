"""Tables and values of a spur stage."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.spur import Found
from tmm_report.problems import N_, Message
from tmm_report.tables.model import Column, Table, Value

WHEELS = N_("dimensions of the wheels of pair %(name)s")
CONDITIONS = N_("conditions of pair %(name)s")
SLIDING = N_("specific sliding of pair %(name)s along the line of action")

# attribute of the pair, unit, meaning; one number for each wheel
DIMENSIONS = (
    ("d", "m", N_("pitch diameter")),
    ("d_b", "m", N_("base diameter")),
    ("d_w", "m", N_("working diameter")),
    ("d_f", "m", N_("root diameter")),
    ("d_a", "m", N_("tip diameter")),
    ("height", "m", N_("height of the teeth")),
    ("s", "m", N_("thickness on the pitch circle")),
    ("s_b", "m", N_("thickness on the base circle")),
    ("s_w", "m", N_("thickness on the working circle")),
    ("s_a", "m", N_("thickness on the tip circle")),
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
        yield Value(f"{prefix}_{key}", number, unit, Message(meaning))


def tables(found: Found, prefix: str) -> Iterator[Table]:
    """The wheels, the conditions with what is in hand, the specific sliding over the line of action."""
    name = {"name": found.name}
    yield Table(f"{prefix}_wheels", Message(WHEELS, name), tuple(_wheels(found)))
    yield Table(f"{prefix}_conditions", Message(CONDITIONS, name), tuple(_conditions(found)))
    yield Table(f"{prefix}_sliding", Message(SLIDING, name), tuple(_sliding(found)))


def _in(unit: str, value: Any) -> Any:
    return np.degrees(value) if unit == "deg" else value


def _wheels(found: Found) -> Iterator[Column]:
    pair = found.pair
    yield Column("wheel", "", Message(N_("number of the wheel")), list(found.given.wheels))
    yield Column("z", "", Message(N_("number of teeth")), list(found.teeth.z))
    yield Column("x", "", Message(N_("shift coefficient")), [float(pair.x1), float(pair.x2)])
    yield Column("x_rule", "", Message(N_("least shift by the rule")), list(found.rule_shifts))
    yield Column("x_min", "", Message(N_("exact least shift")), [float(x) for x in pair.x_min])
    for key, unit, meaning in DIMENSIONS:
        numbers = [float(_in(unit, value)) for value in getattr(pair, key)]
        yield Column(key, unit, Message(meaning), numbers)


def _conditions(found: Found) -> Iterator[Column]:
    of = found.conditions
    yield Column("condition", "", Message(N_("name of the condition")), [c.key for c in of])
    yield Column("wheel", "", Message(N_("number of the wheel")), [c.wheel for c in of])
    yield Column("unit", "", Message(N_("unit of the numbers in the row")), [_SI[c.unit] for c in of])
    for key, meaning in (("value", N_("value")), ("limit", N_("limit")), ("margin", N_("what is in hand"))):
        numbers = [float(_in(c.unit, getattr(c, key))) for c in of]
        yield Column(key, "", Message(meaning), numbers)
    yield Column("met", "", Message(N_("1 where the condition is met")), [int(c.met) for c in of])


_SI = {"mm": "m", "deg": "deg", "": ""}  # lengths stand in the results in metres


def _sliding(found: Found) -> Iterator[Column]:
    at = found.sliding()
    one, two = found.given.wheels
    curvature = N_("radius of curvature of the profile of wheel %(wheel)s at the point of contact")
    yield Column(f"rho_{one}", "m", Message(curvature, {"wheel": one}), at.rho)
    for name, numbers in ((one, at.first), (two, at.second)):
        meaning = Message(N_("specific sliding of wheel %(wheel)s"), {"wheel": name})
        yield Column(f"lambda_{name}", "", meaning, numbers)
