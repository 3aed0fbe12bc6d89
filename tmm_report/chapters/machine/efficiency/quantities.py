"""The numbers of machines joined in a tree: efficiency, loss and power of every part, derivative of the whole by it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from tmm_report.chapters.machine.efficiency.given import Joined
from tmm_report.chapters.machine.efficiency.solve import Found, Part
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

PARTS = Message(N_("parts of the machines joined: efficiency, loss, power"))
IN, OUT, LOST = NP_("index", "in"), NP_("index", "out"), NP_("index", "lost")

ETA = Quantity("eta", Symbol("eta"), "", Message(N_("efficiency")))
PSI = Quantity("psi", Symbol("psi"), "", Message(N_("loss coefficient")))
SHARE = Quantity("share", Symbol("s"), "", Message(N_("share of the input power among the parallel parts")))
OUTPUT_SHARE = Quantity(
    "output_share", Symbol("q"), "", Message(N_("share of the output power among the parallel parts"))
)
SLOPE = Quantity(
    "kappa",
    Symbol("kappa"),
    "",
    Message(N_("derivative of the efficiency of the whole by that of the part")),
)
INPUT = Quantity("P_in", Symbol("P", IN), "W", Message(N_("power at the input")))
OUTPUT = Quantity("P_out", Symbol("P", OUT), "W", Message(N_("power at the output")))
WASTE = Quantity("P_lost", Symbol("P", LOST), "W", Message(N_("power lost")))

WHOLE = Quantity("eta_whole", Symbol("eta"), "", Message(N_("efficiency of the machines joined")))
WHOLE_LOSS = Quantity("psi_whole", Symbol("psi"), "", Message(N_("loss coefficient of the machines joined")))
WHOLE_INPUT = Quantity("P_in_whole", Symbol("P", IN), "W", Message(N_("power at the input of the whole")))
WHOLE_OUTPUT = Quantity("P_out_whole", Symbol("P", OUT), "W", Message(N_("useful power of the whole")))
MISS = Quantity(
    "efficiency_imbalance",
    None,
    "",
    Message(N_("relative disagreement of the whole with the power lost in all the modules")),
)


def parts(found: Found) -> list[Part]:
    """The rows of the table: the whole first, then its parts in their order."""
    return list(found.whole.within())


def of_powers(found: Found, of: Quantity) -> Quantity:
    """A power, or its part of the input of the whole where no power is stated."""
    return of if found.stated else replace(of, unit="")


@tabulated
def tables(found: Found) -> Iterator[Table]:
    rows = parts(found)
    shares = _output_shares(found.whole)
    yield Table(
        "efficiency_parts",
        PARTS,
        (
            text_column(
                "index", Message(N_("number of a module, letter of a group")), [p.index for p in rows]
            ),
            text_column("name", Message(N_("name of the part")), [part.name for part in rows]),
            text_column("kind", Message(N_("module, series or parallel")), [_kind(part) for part in rows]),
            _column(ETA, rows, [part.efficiency for part in rows]),
            _column(PSI, rows, [part.loss for part in rows]),
            _column(SHARE, rows, [part.share for part in rows]),
            _column(OUTPUT_SHARE, rows, [shares.get(part, math.nan) for part in rows]),
            _column(of_powers(found, INPUT), rows, [part.power[0] for part in rows]),
            _column(of_powers(found, OUTPUT), rows, [part.power[1] for part in rows]),
            _column(of_powers(found, WASTE), rows, [part.lost for part in rows]),
            _column(SLOPE, rows, [part.slope for part in rows]),
        ),
    )


def _kind(part: Part) -> str:
    return part.node.kind if isinstance(part.node, Joined) else "module"


def _column(of: Quantity, rows: list[Part], values: list[float]) -> Column:
    """Numbers of the parts, each under the symbol with its index."""
    return Column(of, values, [_indexed(of.sign, part.index) for part in rows])


def _indexed(symbol: Symbol, index: str) -> Symbol:
    return replace(symbol, sub=",".join(filter(None, (symbol.sub, index))))


def _output_shares(part: Part) -> dict[Part, float]:
    """The stated shares of the output."""
    found: dict[Part, float] = {}
    for one in part.within():
        if isinstance(one.node, Joined) and one.node.by == "output":
            found |= {inner: float(inner.node.share or 0.0) for inner in one.parts}
    return found


@tabulated
def values(found: Found) -> Iterator[Value]:
    yield WHOLE.value(found.efficiency)
    yield WHOLE_LOSS.value(1 - found.efficiency)
    yield of_powers(found, WHOLE_INPUT).value(found.whole.power[0])
    yield of_powers(found, WHOLE_OUTPUT).value(found.whole.power[1])
    yield MISS.value(found.imbalance)
