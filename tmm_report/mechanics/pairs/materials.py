"""Coefficients of friction by the materials of a pair: the course's table, dry and semi-fluid, in motion and at rest.

Source: the table of the course (V. A. Yudin, L. V. Petrokas, Theory of mechanisms and machines, friction in pairs).
"""

from __future__ import annotations

import re
from typing import Literal

from tmm_report.problems import N_, Message
from tmm_report.records import dataclass

Range = tuple[float, float]  # from, to; equal where the table gives one number
Lubrication = Literal["dry", "semi-fluid"]
State = Literal["moving", "rest"]

STEEL, IRON, BRONZE = N_("steel"), N_("cast iron"), N_("bronze")
_SPELT = {
    "steel": STEEL, "сталь": STEEL, "cast iron": IRON, "cast-iron": IRON, "чугун": IRON,
    "bronze": BRONZE, "бронза": BRONZE,
}  # fmt: skip

# pair -> (dry, semi-fluid) in motion, then at rest; None where the table has a dash
TABLE: dict[tuple[str, str], dict[State, tuple[Range | None, Range | None]]] = {
    (STEEL, STEEL): {"moving": ((0.15, 0.15), (0.05, 0.10)), "rest": ((0.17, 0.17), (0.10, 0.12))},
    (STEEL, IRON): {"moving": ((0.18, 0.18), (0.07, 0.15)), "rest": ((0.30, 0.30), None)},
    (IRON, IRON): {"moving": ((0.15, 0.15), (0.07, 0.12)), "rest": (None, (0.18, 0.18))},
    (STEEL, BRONZE): {"moving": ((0.15, 0.15), (0.10, 0.15)), "rest": ((0.16, 0.16), (0.10, 0.15))},
    (IRON, BRONZE): {"moving": ((0.20, 0.20), (0.07, 0.15)), "rest": (None, None)},
    (BRONZE, BRONZE): {"moving": ((0.15, 0.20), (0.05, 0.10)), "rest": (None, (0.10, 0.10))},
}
_COLUMN: dict[Lubrication, int] = {"dry": 0, "semi-fluid": 1}


@dataclass(frozen=True)
class Stock:
    """Two materials of the table with what lies between them. `moving`, `rest`: the ranges of the table, None for a
    dash; `state`: which of them is asked for."""

    one: str
    other: str
    lubrication: Lubrication
    state: State = "moving"

    @property
    def moving(self) -> Range | None:
        return TABLE[self.one, self.other]["moving"][_COLUMN[self.lubrication]]

    @property
    def rest(self) -> Range | None:
        return TABLE[self.one, self.other]["rest"][_COLUMN[self.lubrication]]

    @property
    def range(self) -> Range | None:
        return self.rest if self.state == "rest" else self.moving


def mean(of: Range) -> float:
    """The middle of a range, to the digits of the table."""
    return round((of[0] + of[1]) / 2, 6)


def materials(text: str) -> tuple[str, str] | None:
    """The two materials of "steel–bronze", "чугун-сталь", in the order of the table; None where one is unknown."""
    parts = re.split(r"\s*[–—/+]\s*|\s+-\s+|(?<!cast)-", " ".join(text.lower().split()))
    found = [_SPELT.get(part) for part in parts]
    if len(found) != 2 or None in found:
        return None
    one, other = found
    key = (str(one), str(other))
    return key if key in TABLE else (key[1], key[0])


def stock(text: str, lubrication: Lubrication, state: State = "moving") -> Stock | tuple[Message, Message]:
    """The materials with their coefficients, or what is wrong and what would be right: unknown names, a dash."""
    pair = materials(text)
    if pair is None:
        wrong = Message(N_("%(value)s: no such pair of materials in the table"), {"value": text[:40]})
        return wrong, Message(N_("two of steel, cast iron, bronze with a dash between: steel–bronze"))
    found = Stock(*pair, lubrication, state)
    return found if found.range is not None else _dash(found)


def stated(
    coefficient: float | None, materials: str | None, lubrication: Lubrication, state: State
) -> float | Stock | tuple[Message, Message]:
    """A coefficient that is stated itself, or the materials it is taken of; or what is wrong and what would be right:
    none and both, unknown materials, a dash of the table."""
    if materials is not None and coefficient is None:
        return stock(materials, lubrication, state)
    if coefficient is not None and materials is None:
        return coefficient
    wrong = Message(N_("the friction must be stated by its coefficient or by the materials"))
    return wrong, Message(N_("exactly one of: %(words)s"), {"words": "coefficient, materials"})


def _dash(of: Stock) -> tuple[Message, Message]:
    named: dict[str, object] = {"one": Message(of.one), "other": Message(of.other)}
    text = (
        N_("the table has no coefficient of %(one)s on %(other)s at rest, semi-fluid friction")
        if of.lubrication == "semi-fluid"
        else N_("the table has no coefficient of %(one)s on %(other)s at rest, dry friction")
    )
    return Message(text, named), _known(of)


def _known(of: Stock) -> Message:
    """What the table has of the pair instead: of the other lubrication at rest, else in motion."""
    beside = TABLE[of.one, of.other]["rest"][1 - _COLUMN[of.lubrication]]
    if beside is None:
        moving = mean(of.moving or (0.0, 0.0))
        return Message(N_("there is one in motion, %(f)s; or state the coefficient"), {"f": f"{moving:g}"})
    text = (
        N_("there is one for dry friction at rest, %(f)s; or state the coefficient")
        if of.lubrication == "semi-fluid"
        else N_("there is one for semi-fluid friction at rest, %(f)s; or state the coefficient")
    )
    return Message(text, {"f": f"{mean(beside):g}"})
