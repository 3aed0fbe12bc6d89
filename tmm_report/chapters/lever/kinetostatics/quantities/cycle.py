"""The numbers of a whole cycle: extremes of the forces, works of the loads, where the engine must drive."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from tmm_report.mechanics.lever.extremes import Peak, Peaks
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.works import Work, Works

EXTREMES = Message(N_("extremes of the balancing moment and of the reactions over the whole cycle"))
WORKS = Message(N_("work of the loads over the cycle"))
SENSES = Message(N_("angles over which the balancing moment has one sense"))

AT = N_("angle of rotation at which it is reached")
SIDE = N_("the side of a jump on which it is reached; nothing where nothing jumps")
LEAST = Quantity("least", None, "", Message(N_("its least value")))
LEAST_AT = Quantity("least_at", Symbol("phi"), "deg", Message(AT))
GREATEST = Quantity("greatest", None, "", Message(N_("its greatest value")))
GREATEST_AT = Quantity("greatest_at", Symbol("phi"), "deg", Message(AT))
SIDES = {-1: "before", 0: "", 1: "after"}

DRIVING = Quantity("driving", Symbol("A", "+"), "J", Message(N_("work of the load where it drives")))
RESISTING = Quantity("resisting", Symbol("A", "−"), "J", Message(N_("work of the load where it resists")))
WHOLE = Quantity("work", Symbol("A"), "J", Message(N_("work of the load over the cycle")))
MEAN_POWER = Quantity(
    "P_bal_mean", Symbol("P", "m"), "W", Message(N_("mean power of the balancing moment over the cycle"))
)
WORKS_SUM = Quantity(
    "works_sum",
    None,
    "",
    Message(N_("sum of the work of all loads over the cycle, relative to the largest share")),
)


class Row(NamedTuple):
    """A quantity whose extremes are told."""

    quantity: Quantity
    peaks: Peaks


def extremes_table(rows: Sequence[Row]) -> Table:
    """One row a quantity: its key finds it."""
    low, high = [row.peaks[0] for row in rows], [row.peaks[1] for row in rows]
    signs, units = [row.quantity.sign for row in rows], [row.quantity.unit for row in rows]
    return Table(
        "force_extremes",
        EXTREMES,
        (
            text_column("key", Message(N_("quantity")), [row.quantity.key for row in rows]),
            text_column("unit", Message(N_("its unit")), units),
            Column(LEAST, [one.value for one in low], signs, units),
            LEAST_AT.column([math.degrees(one.turned) for one in low]),
            text_column("least_side", Message(SIDE), _sides(low)),
            Column(GREATEST, [one.value for one in high], signs, units),
            GREATEST_AT.column([math.degrees(one.turned) for one in high]),
            text_column("greatest_side", Message(SIDE), _sides(high)),
        ),
    )


def _sides(peaks: Sequence[Peak]) -> list[str]:
    return [SIDES[one.side] for one in peaks]


def works_tables(found: Works, named: Sequence[tuple[Quantity, Work]]) -> Iterator[Table]:
    """Of the loads one row each; of the senses of the balancing moment one row each."""
    done = [work for _, work in named]
    yield Table(
        "works",
        WORKS,
        (
            text_column("load", Message(N_("load")), [quantity.key for quantity, _ in named]),
            text_column("drives_at", Message(N_("positions at which it drives")), [at(w, 1) for w in done]),
            text_column(
                "resists_at", Message(N_("positions at which it resists")), [at(w, -1) for w in done]
            ),
            DRIVING.column([work.driving for work in done]),
            RESISTING.column([work.resisting for work in done]),
            WHOLE.column([work.whole for work in done]),
        ),
    )
    zones = found.zones
    begin = Message(N_("angle of rotation at which the sense begins to hold"))
    end = Message(N_("angle of rotation to which it holds"))
    yield Table(
        "moment_senses",
        SENSES,
        (
            Quantity("from", Symbol("phi"), "deg", begin).column([math.degrees(z.start) for z in zones]),
            Quantity("to", Symbol("phi"), "deg", end).column([math.degrees(z.end) for z in zones]),
            text_column(
                "sense",
                Message(N_("along: in the sense of rotation of the driving link; against: opposite")),
                ["along" if zone.drives else "against" for zone in zones],
            ),
            Quantity(
                "work", Symbol("A"), "J", Message(N_("work of the balancing moment between these angles"))
            ).column([zone.work for zone in zones]),
        ),
    )


def works_values(found: Works) -> Iterator[Value]:
    yield MEAN_POWER.value(found.power)
    yield WORKS_SUM.value(abs(found.whole) / found.size if found.size > 0 else 0.0)


def at(work: Work, sign: int) -> str:
    """The positions 0..N-1 at which the power of a load has a sign: "1–4, 9"."""
    return ranges([k for k, one in enumerate(work.signs[:-1]) if one == sign])


def ranges(numbers: Sequence[int]) -> str:
    """Ascending whole numbers, neighbours joined: "1–4, 9"."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    joined = (str(a) if a == b else f"{a}, {b}" if b == a + 1 else f"{a}–{b}" for a, b in runs)
    return ", ".join(joined)
