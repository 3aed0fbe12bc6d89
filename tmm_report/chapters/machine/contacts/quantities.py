"""The numbers of friction in single pairs: a table of one row for each pair, named by its place in the file."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from tmm_report.chapters.machine.contacts.given import Rough
from tmm_report.chapters.machine.contacts.solve import Found, Solved
from tmm_report.chapters.machine.contacts.values import KINDS, Listed
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, plain, text_column
from tmm_report.quantity.sheet import columns
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

PAIRS = Message(N_("single pairs with friction"))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    yield Table("contacts", PAIRS, tuple(_listed(found)))
    for item in found.items:
        yield Table(item.s.table, Message(KINDS[item.kind]), tuple(columns([item.s])))


def _listed(found: Found) -> Iterator[Column]:
    items = found.items
    yield plain("number", "", Message(N_("number of the pair")), [item.number for item in items])
    yield text_column("kind", Message(N_("kind of the pair")), [item.kind for item in items])
    yield text_column("name", Message(N_("name of the pair")), [item.of.name or "" for item in items])
    yield Listed.f_low.column([_ends(item)[0] for item in items])
    yield Listed.f_high.column([_ends(item)[1] for item in items])
    yield Listed.f.column([item.s.number("f") for item in items])
    yield Listed.phi_fr.column([_cone(item) for item in items])
    yield Listed.eta.column([item.s.number("eta") if "eta" in item.s else math.nan for item in items])
    locks = [str(item.locks).lower() for item in items]
    yield text_column("locks", Message(N_("whether the pair locks by itself")), locks)


def _cone(item: Solved) -> float:
    """Angle of friction of the pair, degrees: of a thread the reduced one; a crank calls its own angle so."""
    key = "phi_red" if item.kind == "screw" else "phi"
    if key in item.s and item.kind != "crank":
        return item.s.number(key)
    return math.degrees(math.atan(item.s.number("f")))


def _ends(item: Solved) -> tuple[float, float]:
    """The range of the table, where the materials are stated."""
    stock = item.of.stock if isinstance(item.of, Rough) else None
    return (stock.range if stock is not None else None) or (math.nan, math.nan)


SOUGHT = (
    "eta",
    "M_screw",
    "T_1",
    "T_2",
    "P",
    "M_wear",
    "M_drum",
    "F_in",
)  # what is looked for first, of any pair


def headline(found: Found) -> Iterator[Value]:
    """Of each pair with friction what it has of these; its number stands behind the meaning."""
    for item in found.items:
        for key in (one for one in SOUGHT if one in item.s):
            own = item.s.named(key)
            text = Message(N_("%(what)s, pair %(n)s"), {"what": own.meaning, "n": item.number})
            yield replace(item.s[key], quantity=replace(own, key=f"{item.s.table}_{key}", meaning=text))


@tabulated
def values(found: Found) -> Iterator[Value]:
    """The efficiency of each pair that has one."""
    for item in found.items:
        if "eta" in item.s:
            text = Message(N_("efficiency of pair %(n)s"), {"n": item.number})
            key = f"{item.s.table}_eta"
            yield Quantity(key, Symbol("eta", str(item.number)), "", text).value(item.s.number("eta"))
