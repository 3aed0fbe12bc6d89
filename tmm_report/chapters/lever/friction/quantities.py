"""The numbers of friction: coefficients, power lost in every pair, efficiency."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tmm_report.chapters.lever.friction import corrected_quantities, sliding_quantities
from tmm_report.chapters.lever.friction.solve import FrictionFound, Losses, PairLoss
from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.kinetostatics.quantities.positions import both, guide_moment, reaction
from tmm_report.i18n import NP_
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

GIVEN = Message(N_("friction in the kinematic pairs"))
LOSSES = Message(N_("friction power and instantaneous efficiency"))

JOURNAL, SLIDER = NP_("index", "jour"), NP_("index", "sld")
COEFFICIENT = Quantity("f", Symbol("f"), "", Message(N_("coefficient of friction")))
DIAMETER = Quantity("d", Symbol("d", JOURNAL), "m", Message(N_("diameter of the journal")))
LENGTH = Quantity("l", Symbol("l", SLIDER), "m", Message(N_("length of the slider")), "mm")
TOTAL = Quantity("P_fr", Symbol("P", "fr"), "W", Message(N_("power of friction in all the pairs")))
DRIVING = Quantity("P_drive", Symbol("P", "1"), "W", Message(N_("power of the balancing moment")))
REDUCED = Quantity(
    "T_fr", Symbol("M", "fr"), "N·m", Message(N_("moment of friction reduced to the driving link"))
)
ALONG = Quantity("F_fr", Symbol("F", "fr"), "N", Message(N_("force of friction reduced to the stroke")))
THRUST = Quantity("P_drive", Symbol("P", "1"), "W", Message(N_("power of the balancing force")))
EFFICIENCY = Quantity("eta", Symbol("eta"), "", Message(N_("instantaneous efficiency")))
MEAN_POWER = Quantity("P_fr_mean", None, "W", Message(N_("mean friction power")))
MEAN_EFFICIENCY = Quantity("eta_mean", None, "", Message(N_("efficiency over the cycle")))


def lost(pair: Pair, pairs: Sequence[Pair]) -> Quantity:
    """Power of friction in a pair; its index is the point or guide, of `pairs` that share one also the links."""
    of = {"pair": pair.name, "links": pair.key}
    meaning = Message(N_("friction power in pair %(pair)s of links %(links)s"), of)
    shared = [other.name for other in pairs].count(pair.name) > 1
    index = f"fr,{pair.name}" + (f",{both(*pair.links)}" if shared else "")
    return Quantity(f"P_fr_{pair.key}", Symbol("P", index), "W", meaning)


def rate(loss: PairLoss) -> Quantity:
    """Relative angular velocity of the links of a pivot, sliding velocity of those of a guide; of a cam pair the one of
    its roller, or the velocity with which the contact slides."""
    pair = loss.pair
    one, other = pair.links
    if loss.contact is not None:
        cam = loss.contact.cam
        named = {"cam": cam.cam, "follower": cam.follower}
        if loss.contact.rolls:
            meaning = Message(
                N_("angular velocity of the roller between cam %(cam)s and follower %(follower)s on its pin"),
                named,
            )
            return Quantity(f"w_roll_{cam.name}", Symbol("omega", f"{one},{other}"), "rad/s", meaning)
        meaning = Message(N_("velocity with which cam %(cam)s slides along follower %(follower)s"), named)
        return Quantity(f"v_touch_{cam.name}", Symbol("v", f"{one},{other}"), "m/s", meaning)
    if pair.kind == "P":
        meaning = Message(N_("sliding velocity of links %(one)s and %(other)s"), {"one": one, "other": other})
        return Quantity(f"v_rel_{pair.key}", Symbol("v", f"{one},{other}"), "m/s", meaning)
    text = N_("relative angular velocity of links %(one)s and %(other)s")
    meaning = Message(text, {"one": one, "other": other})
    return Quantity(f"w_rel_{pair.key}", Symbol("omega", f"{one},{other}"), "rad/s", meaning)


def borne(pair: Pair) -> Quantity:
    """Magnitude of the reaction of a pair."""
    force = reaction(*pair.links)
    return Quantity(f"R_{pair.key}", force.symbol, force.unit, force.meaning)


def couple(pair: Pair) -> Quantity:
    """Magnitude of the moment of the reaction of a guide about the middle of its slider."""
    of = guide_moment(*pair.links)
    meaning = Message(
        N_("moment of the reaction in guide %(pair)s about the middle of the slider"), {"pair": pair.name}
    )
    return Quantity(f"M_{pair.key}", of.symbol, of.unit, meaning)


def pressing(pair: Pair) -> Quantity:
    """Force that presses a slider of stated length; of all other pairs it is the reaction."""
    meaning = Message(
        N_("force that presses the slider to guide %(pair)s, links %(links)s"),
        {"pair": pair.name, "links": pair.key},
    )
    return Quantity(f"N_{pair.key}", Symbol("N", both(*pair.links)), "N", meaning)


@tabulated
def tables(found: FrictionFound) -> Iterator[Table]:
    yield _given(found.table.pairs)
    for name, losses, turned in (
        ("table", found.table, found.turned),
        ("diagram", found.diagram, found.diagram_turned),
    ):
        yield Table(f"friction_{name}", LOSSES, (*where(turned), *_losses(losses)))
    yield from sliding_quantities.tables(found.table.pairs)
    yield from corrected_quantities.materials([(loss.pair, loss.rubbing) for loss in found.table.pairs])
    if found.corrected is not None:
        yield from corrected_quantities.tables(found.corrected, (found.turned, found.diagram_turned))


def _given(losses: tuple[PairLoss, ...]) -> Table:
    pairs = [loss.pair for loss in losses]
    diameters = [math.nan if loss.rubbing.diameter is None else loss.rubbing.diameter for loss in losses]
    lengths = [loss.rubbing.length or math.nan for loss in losses]
    sliders = () if all(map(math.isnan, lengths)) else (LENGTH.column(lengths),)
    return Table(
        "friction_given",
        GIVEN,
        (
            text_column("links", Message(N_("its links")), ["–".join(pair.links) for pair in pairs]),
            text_column("name", Message(N_("point or guide")), [pair.name for pair in pairs]),
            text_column("kind", _kinds(pairs), [pair.kind for pair in pairs]),
            COEFFICIENT.column([sliding_quantities.stated_coefficient(loss.rubbing) for loss in losses]),
            DIAMETER.column(diameters),
            *sliders,
        ),
    )


def _kinds(pairs: Sequence[Pair]) -> Message:
    if any(pair.kind == "H" for pair in pairs):
        return Message(N_("R: revolute, P: prismatic, H: higher"))
    return Message(N_("R: revolute, P: prismatic"))


def _losses(losses: Losses) -> Iterator[Column]:
    pairs = [loss.pair for loss in losses.pairs]
    for loss in losses.pairs:
        yield lost(loss.pair, pairs).column(loss.power)
    yield TOTAL.column(losses.total)
    yield (DRIVING if losses.speed is None else THRUST).column(losses.driving)
    yield (REDUCED if losses.speed is None else ALONG).column(losses.reduced)
    yield EFFICIENCY.column(losses.efficiency)
    for loss in losses.pairs:
        yield borne(loss.pair).column(loss.reaction)
        if loss.couple is not None:
            yield couple(loss.pair).column(loss.couple)
            yield pressing(loss.pair).column(loss.pressing)
        yield rate(loss).column(loss.rate)
    yield from sliding_quantities.columns(losses.pairs)


@tabulated
def values(found: FrictionFound) -> Iterator[Value]:
    yield MEAN_POWER.value(found.mean_power)
    yield MEAN_EFFICIENCY.value(found.mean_efficiency)
    if sliding_quantities.laws(found.table.pairs):
        yield sliding_quantities.WORK.value(found.work)
    if found.corrected is not None:
        yield from corrected_quantities.values(found.corrected)
