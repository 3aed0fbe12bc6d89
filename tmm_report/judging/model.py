"""What is said of a person's numbers: what is asked, what was answered, how each cell was judged, what went wrong."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.problems import Message, Problem
from tmm_report.quantity.model import OfQuantity, Quantity
from tmm_report.records import dataclass

Array = Any

Name = tuple[str, str]
"""Where a column of numbers stands in results.json: (table, key); ("", key) of a single value."""


@dataclass(frozen=True, eq=False)
class Asked(OfQuantity):
    """A column of numbers of the solution that a student may be asked for.

    `values`: (P,) in the quantity's unit. `rows`: the label of each row: "0" … "12" in tables by positions, the wheel
    or member in tables of things, "" of a single value. `chapter`: the room that found it. `by_position`: whether rows
    are positions of the driving link. `angle`: compared on the circle. `whole`: whole numbers, which are right or
    wrong. `signed`: its sign says a direction (a column of magnitudes has none).
    """

    table: str
    quantity: Quantity
    values: Array
    rows: tuple[str, ...]
    chapter: str
    by_position: bool = False
    angle: bool = False
    whole: bool = False
    signed: bool = True

    @property
    def name(self) -> Name:
        return self.table, self.quantity.key

    @cached_property
    def largest(self) -> float:
        """Greatest magnitude of the column; 0 of one without numbers."""
        return float(np.nanmax(np.abs(self.values), initial=0.0))


Expected = Mapping[Name, Asked]
"""All that can be asked of a solved variant, in the order of the note."""


@dataclass(frozen=True, eq=False)
class Answered:
    """A student's numbers for one column asked.

    `values`: (P,) in the unit of the quantity asked, nan where there is no number. `given`: (P,) of bool, where
    something stands in the cell, a number or not. `texts`: what stood there, fit for a message. `places`:
    "file:line:column" of each cell, "" where there is none. `unit`: as the student stated it, "" for none.
    """

    values: Array
    given: Array
    texts: tuple[str, ...]
    places: tuple[str, ...]
    unit: str = ""


@dataclass(frozen=True, eq=False)
class Answers:
    """What one student handed in. `scales`: his own plans' scales by key (mu_l, mu_v, mu_a, mu_F), SI units per mm.

    `notes`: what was wrong in the file and could be passed over (an unknown column, a cell that is no number).
    """

    id: str
    columns: Mapping[Name, Answered]
    scales: Mapping[str, float] = field(default_factory=dict)
    notes: tuple[Problem, ...] = ()


class Rule(StrEnum):
    """What decided a cell."""

    LIMIT = "limit"  # right: the difference is within the limit
    FLOOR = "floor"  # right: within what can be read off the plan
    ZERO = "zero"  # right: both are nothing within what can be read off
    EXACT = "exact"  # right: a whole number, and the same
    CARRIED = "carried"  # follows rightly from the student's own wrong value
    OFF = "off"  # wrong: beyond limit and floor
    SIGN = "sign"  # wrong: the opposite sign
    NO_ANSWER = "no answer"  # missing, or no number
    NOT_ASKED = "not asked"  # the solution itself has no number there


RIGHT = (Rule.LIMIT, Rule.FLOOR, Rule.ZERO, Rule.EXACT)


@dataclass(frozen=True, eq=False)
class Judged:
    """One column judged: `delta`, % as the course prints it, signed, nan where signs are opposite or one is missing;
    `rules`: (P,) of Rule; `magnitudes`: the student gave magnitudes, which were compared with magnitudes."""

    delta: Array
    rules: tuple[Rule, ...]
    magnitudes: bool = False

    @cached_property
    def ok(self) -> Array:
        """(P,) of bool: right, or carried forward rightly is not among these."""
        return np.array([rule in RIGHT for rule in self.rules], dtype=bool)

    @cached_property
    def asked(self) -> Array:
        """(P,) of bool: where there is something to be answered."""
        return np.array([rule is not Rule.NOT_ASKED for rule in self.rules], dtype=bool)


@dataclass(frozen=True, eq=False)
class Cause:
    """A likely mistake that explains whole columns.

    `kind`: one of KINDS. `names`: the columns it explains. `what`: the sentence for student and teacher. `detail`: what
    was found: positions shifted by, factor, the other column's key, the other variant's id. `mended`: name -> the
    student's values with the mistake undone, (P,), in the unit asked: judged again they give the marks that he would
    have had. `explains`: part of the answered cells that are right once it is undone, 0 … 1.
    """

    kind: str
    names: tuple[Name, ...]
    what: Message
    detail: str = ""
    mended: Mapping[Name, Array] = field(default_factory=dict)
    explains: float = 0.0


OF_WHOLE = (  # of the work: recognised by solving the mechanism with the mistake in it, or
    "sense",  # by another positive sense held throughout
    "assembly",  # the other one
    "datum",  # another number than the assignment's
)
KINDS = (
    "sign",  # the opposite sign all along
    "modulus",  # magnitudes where a sign is asked
    "mm for m",
    "rpm for rad/s",
    "turns for radians",  # revolutions a second for rad/s
    "speed",  # what follows from ω: n taken for it
    "degrees for radians",
    "power of ten",
    "factor",  # 2 or 1/2
    "scale",  # one free factor: the scale of the plan
    "mass for weight",
    "weight for mass",  # times g
    "coriolis",  # without its 2
    "radius for diameter",
    "shifted",  # positions shifted
    "reversed",  # positions counted the other way round
    "rows",  # two positions in each other's place
    "swapped",  # two columns in each other's place
    "component",  # the normal component for the tangential one, or the other way round
    "variant",  # the numbers of another variant
    *OF_WHOLE,
)
