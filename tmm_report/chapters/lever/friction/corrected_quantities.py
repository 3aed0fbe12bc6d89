"""The numbers of the force analysis with friction: reactions, balancing moment, efficiency; the materials."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from tmm_report.chapters.lever.friction.corrected import Corrected, Correction, Loss
from tmm_report.chapters.lever.friction.given import Rubbing
from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.kinetostatics.quantities.positions import BALANCING_MOMENT, both
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.pairs.materials import Range
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol

MATERIALS = Message(N_("materials of the kinematic pairs and the coefficients of the table"))
MOMENTS = Message(N_("balancing moment and efficiency corrected for friction"))
REACTIONS = Message(N_("reactions corrected for friction"))

FR, BAL = "fr", "bal"
LOW = Quantity("f_low", Symbol("f", "min"), "", Message(N_("least coefficient of the range in the table")))
HIGH = Quantity(
    "f_high", Symbol("f", "max"), "", Message(N_("greatest coefficient of the range in the table"))
)
REST_LOW = Quantity("f_rest_low", None, "", Message(N_("least coefficient at rest in the table")))
REST_HIGH = Quantity("f_rest_high", None, "", Message(N_("greatest coefficient at rest in the table")))
CONE = Quantity("phi_fr", Symbol("phi", FR), "deg", Message(N_("angle of friction")))

FIRST = Quantity(
    "M_first",
    Symbol("M", f"{BAL},I"),
    "N·m",
    Message(N_("balancing moment with friction, first approximation")),
)
MOMENT = Quantity(
    "M_bal_fr", Symbol("M", f"{BAL},{FR}"), "N·m", Message(N_("balancing moment corrected for friction"))
)
LOST = Quantity(
    "P_fr_corrected",
    Symbol("P'", FR),
    "W",
    Message(N_("power of friction in all the pairs by the corrected reactions")),
)
EFFICIENCY = Quantity(
    "eta_corrected", Symbol("eta'"), "", Message(N_("instantaneous efficiency by the corrected reactions"))
)
# what the axes of the diagram show: the moment and the efficiency of each way
ANY_MOMENT = replace(BALANCING_MOMENT, symbol=Symbol("M"))
ANY_EFFICIENCY = replace(EFFICIENCY, symbol=Symbol("eta", FR))
MISS = Quantity(
    "friction_disagreement",
    None,
    "",
    Message(N_("relative disagreement of the force analysis with friction and the power balance")),
)
GROWTH = Quantity(
    "M_growth",
    None,
    "",
    Message(N_("ratio of the largest balancing moment with friction to the largest without")),
)
MEAN_POWER = Quantity("P_fr_corrected_mean", None, "W", Message(N_("mean corrected friction power")))
MEAN_EFFICIENCY = Quantity(
    "eta_corrected_mean", None, "", Message(N_("efficiency over the cycle by the corrected reactions"))
)
STEPS = Quantity("friction_steps", None, "", Message(N_("steps of Newton's method for the reactions")))


def corrected_reaction(pair: Pair) -> Quantity:
    """Reaction of a pair with friction; of a guide what is normal to it."""
    one, other = pair.links
    text = (
        N_("normal reaction of link %(one)s on link %(other)s corrected for friction")
        if pair.kind == "P"
        else N_("reaction of link %(one)s on link %(other)s corrected for friction")
    )
    index = both(one, other)
    meaning = Message(text, {"one": one, "other": other})
    return Quantity(f"R_{index}_fr", Symbol("R", index, FR), "N", meaning)


def corrected_loss(pair: Pair, pairs: Sequence[Pair]) -> Quantity:
    """Its index is the point or guide, of `pairs` that share one also the links."""
    meaning = Message(
        N_("corrected friction power in pair %(pair)s of links %(links)s"),
        {"pair": pair.name, "links": pair.key},
    )
    shared = [other.name for other in pairs].count(pair.name) > 1
    index = f"{FR},{pair.name}" + (f",{both(*pair.links)}" if shared else "")
    return Quantity(f"P_fr_corrected_{pair.key}", Symbol("P'", index), "W", meaning)


def corrected_pressing(pair: Pair) -> Quantity:
    meaning = Message(
        N_("force that presses the links of pair %(pair)s, %(links)s, corrected for friction"),
        {"pair": pair.name, "links": pair.key},
    )
    return Quantity(f"N_fr_{pair.key}", Symbol("N", both(*pair.links), FR), "N", meaning)


def corrected_couple(pair: Pair) -> Quantity:
    """Moment of the reaction of a guide about the middle of its slider."""
    meaning = Message(
        N_("moment of the reaction in guide %(pair)s about the middle of the slider, corrected for friction"),
        {"pair": pair.name},
    )
    index = both(*pair.links)
    return Quantity(f"M_{index}_fr", Symbol("M", index, FR), "N·m", meaning)


# ---------------------------------------------------------------- tables


def materials(pairs: Sequence[tuple[Pair, Rubbing]]) -> Iterator[Table]:
    """The table of the pairs whose materials are stated; none where there are none."""
    known = [(pair, of, of.stock) for pair, of in pairs if of.stock is not None]
    if not known:
        return
    stocks = [stock for _, _, stock in known]
    moving, rest = [_ends(stock.range) for stock in stocks], [_ends(stock.rest) for stock in stocks]
    yield Table(
        "friction_materials",
        MATERIALS,
        (
            text_column("name", Message(N_("point or guide")), [pair.name for pair, _, _ in known]),
            text_column("links", Message(N_("its links")), ["–".join(pair.links) for pair, _, _ in known]),
            text_column("materials", Message(N_("materials")), [f"{s.one}–{s.other}" for s in stocks]),
            text_column("lubrication", Message(N_("dry or semi-fluid")), [s.lubrication for s in stocks]),
            LOW.column([low for low, _ in moving]),
            HIGH.column([high for _, high in moving]),
            CONE.column([math.degrees(math.atan(of.at(0.0))) for _, of, _ in known]),
            REST_LOW.column([low for low, _ in rest]),
            REST_HIGH.column([high for _, high in rest]),
        ),
    )


def _ends(of: Range | None) -> tuple[float, float]:
    return (math.nan, math.nan) if of is None else of


def tables(found: Correction, turned: Sequence[object]) -> Iterator[Table]:
    for name, one, at in zip(("table", "diagram"), (found.table, found.diagram), turned, strict=True):
        yield Table(f"friction_corrected_{name}", MOMENTS, (*where(at), *_moments(one)))
        yield Table(f"friction_reactions_{name}", REACTIONS, (*where(at), *_reactions(one.pairs)))


def _moments(one: Corrected) -> Iterator[Column]:
    yield FIRST.column(one.first)
    yield MOMENT.column(one.moment)
    yield LOST.column(one.lost)
    yield EFFICIENCY.column(one.efficiency)
    yield MISS.column(one.disagreement)


def _reactions(pairs: Sequence[Loss]) -> Iterator[Column]:
    for loss in pairs:
        yield from corrected_reaction(loss.pair).vector(loss.reaction)
        if loss.couple is not None:
            yield corrected_couple(loss.pair).column(loss.couple)
    every = [loss.pair for loss in pairs]
    for loss in pairs:
        yield corrected_pressing(loss.pair).column(loss.pressing)
        yield corrected_loss(loss.pair, every).column(loss.power)


def values(found: Correction) -> Iterator[Value]:
    yield MEAN_POWER.value(found.mean_power)
    yield MEAN_EFFICIENCY.value(found.mean_efficiency)
    yield GROWTH.value(found.growth)
    yield STEPS.value(max(found.table.steps, found.diagram.steps))
    yield MISS.value(found.worst)
