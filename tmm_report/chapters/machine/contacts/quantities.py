"""The numbers of friction in single pairs: a table of one row for each pair, named by its place in the file."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from tmm_report.chapters.machine.contacts.solve import Found, Solved
from tmm_report.chapters.machine.contacts.terms import ETA, KINDS, TERMS, F
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, plain, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

CONE = Quantity("phi_fr", Symbol("phi", "fr"), "deg", Message(N_("angle of friction")))
PAIRS = Message(N_("single pairs with friction"))


def name(item: Solved) -> str:
    """Of a pair's table."""
    return f"contacts_{item.number}"


def terms(item: Solved) -> Mapping[str, Quantity]:
    """What the numbers of a pair are, by key."""
    own = TERMS[item.kind]
    return {key: own[key] for key in item.numbers}


@tabulated
def tables(found: Found) -> Iterator[Table]:
    yield Table("contacts", PAIRS, tuple(_listed(found)))
    for item in found.items:
        columns = [of.column([item.numbers[key]]) for key, of in terms(item).items()]
        yield Table(name(item), Message(KINDS[item.kind]), tuple(columns))


def _listed(found: Found) -> Iterator[Column]:
    yield plain("number", "", Message(N_("number of the pair")), [item.number for item in found.items])
    yield text_column("kind", Message(N_("kind of the pair")), [item.kind for item in found.items])
    yield text_column("name", Message(N_("name of the pair")), [item.name for item in found.items])
    low, high = [_ends(item)[0] for item in found.items], [_ends(item)[1] for item in found.items]
    text = Message(N_("least coefficient of the range in the table"))
    yield Quantity("f_low", Symbol("f", "min"), "", text).column(low)
    text = Message(N_("greatest coefficient of the range in the table"))
    yield Quantity("f_high", Symbol("f", "max"), "", text).column(high)
    yield F.column([item.numbers.get("f", math.nan) for item in found.items])
    yield CONE.column([_cone(item) for item in found.items])
    yield ETA.column([item.numbers.get("eta", math.nan) for item in found.items])
    locks = [str(item.locks).lower() for item in found.items]
    yield text_column("locks", Message(N_("whether the pair locks by itself")), locks)


def _cone(item: Solved) -> float:
    """Angle of friction of the pair, degrees: of a thread the reduced one."""
    if item.kind in ("screw", "crank"):
        return item.numbers.get("phi_red", math.degrees(math.atan(item.numbers["f"])))
    return item.numbers.get("phi", math.degrees(math.atan(item.numbers["f"])))


def _ends(item: Solved) -> tuple[float, float]:
    """The range of the table, where the materials are stated."""
    rough = getattr(item.of, "rough", None)
    stock = rough.stock if rough is not None else None
    return (stock.range if stock is not None else None) or (math.nan, math.nan)


@tabulated
def values(found: Found) -> Iterator[Value]:
    """The efficiency of each pair that has one."""
    for item in found.items:
        if "eta" in item.numbers:
            text = Message(N_("efficiency of pair %(n)s"), {"n": item.number})
            key = f"contacts_{item.number}_eta"
            yield Quantity(key, Symbol("eta", str(item.number)), "", text).value(item.numbers["eta"])
