"""The efficiency of what is joined from those of its parts, and what follows of the whole."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import reduce
from operator import add, mul
from typing import TYPE_CHECKING

from tmm_report.chapters.machine.efficiency.given import Given, Joined
from tmm_report.chapters.machine.efficiency.values import Parts, Values, unstated
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.model import Column, Table, text_column

if TYPE_CHECKING:
    from tmm_report.chapters.machine.efficiency.solve import Part

PARTS = Message(N_("parts of the machines joined: efficiency, loss, power"))


def parts(whole: Part, stated: bool) -> Table:
    """The whole first, then its parts in their order; `stated`: whether a power is."""
    rows = list(whole.within())
    return Table("efficiency_parts", PARTS, tuple(_columns(rows, Parts({} if stated else unstated(Parts)))))


def _columns(rows: Sequence[Part], s: Parts) -> Iterator[Column]:
    yield text_column("index", Message(N_("number of a module, letter of a group")), [p.index for p in rows])
    yield text_column("name", Message(N_("name of the part")), [part.name for part in rows])
    kinds = [part.node.kind if isinstance(part.node, Joined) else "module" for part in rows]
    yield text_column("kind", Message(N_("module, series or parallel")), kinds)
    numbers = {
        "eta": [part.efficiency for part in rows],
        "psi": [part.loss for part in rows],
        "share": [part.share for part in rows],
        "output_share": _output_shares(rows),
        "P_in": [part.power[0] for part in rows],
        "P_out": [part.power[1] for part in rows],
        "P_lost": [part.lost for part in rows],
        "kappa": [part.slope for part in rows],
    }
    for key, column in numbers.items():
        of = s.quantity(key)
        symbols = [replace(of.sign, sub=",".join(filter(None, (of.sign.sub, part.index)))) for part in rows]
        yield Column(of, column, symbols)


def _output_shares(rows: Sequence[Part]) -> list[float]:
    """The stated shares of the output, nan of other parts."""
    found = [math.nan] * len(rows)
    for one in rows:
        if isinstance(one.node, Joined) and one.node.by == "output":
            for inner in one.parts:
                found[inner.row] = float(inner.node.share or 0.0)
    return found


def joined(part: Part, table: Table) -> Expr:
    """The efficiency of a group by those of its parts."""
    assert isinstance(part.node, Joined)
    etas = [table.var("eta", inner.row) for inner in part.parts]
    if part.node.kind == "series":
        return reduce(mul, etas)
    key = "share" if part.node.by == "input" else "output_share"
    shares = [table.var(key, inner.row) for inner in part.parts]
    if part.node.by == "input":
        return reduce(add, map(mul, shares, etas))
    return 1 / reduce(add, (s / eta for s, eta in zip(shares, etas, strict=True)))


def whole(given: Given, of: Part, table: Table) -> Values:
    s = Values({} if given.stated else unstated(Values))
    s.eta_whole = joined(of, table) if of.parts else of.efficiency
    s.psi_whole = 1 - s.eta_whole
    s.P_in_whole = given.input if given.output is None else None
    s.P_out_whole = given.output
    if given.output is not None:
        s.P_in_whole = s.P_out_whole / s.eta_whole
    elif given.input is not None:
        s.P_out_whole = s.P_in_whole * s.eta_whole
    else:
        s.P_in_whole, s.P_out_whole = of.power
    return s
