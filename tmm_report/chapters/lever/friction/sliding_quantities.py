"""The numbers of coefficients that depend on the sliding: the laws as stated, velocities and coefficients."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tmm_report.chapters.lever.friction.given import Rubbing
from tmm_report.chapters.lever.friction.solve import PairLoss
from tmm_report.chapters.lever.kinetostatics.quantities.positions import both
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.pairs.coefficients import BySliding, Rubs, Stribeck
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol

STRIBECK = Message(N_("coefficients of friction by Stribeck's law"))
POINTS = Message(N_("coefficients of friction at velocities of sliding"))
PAIRS = Message(N_("points or guides"))

STATIC = Quantity("f_s", Symbol("f", "s"), "", Message(N_("coefficient of friction at rest")))
KINETIC = Quantity(
    "f_k", Symbol("f", "k"), "", Message(N_("coefficient of friction that is neared in motion"))
)
FALL = Quantity(
    "v_s", Symbol("v", "s"), "m/s", Message(N_("velocity of sliding by which the coefficient falls"))
)
VISCOUS = Quantity("k_v", Symbol("k", "v"), "s/m", Message(N_("viscous part of the coefficient of friction")))
EXPONENT = Quantity("n", Symbol("n"), "", Message(N_("exponent of Stribeck's law")))
SPEED = Quantity("v", Symbol("v"), "m/s", Message(N_("velocity of sliding")))
COEFFICIENT = Quantity("f", Symbol("f"), "", Message(N_("coefficient of friction")))
WORK = Quantity(
    "E_fr", Symbol("E", "fr"), "J", Message(N_("energy that friction takes in all the pairs over the cycle"))
)


def _index(pair: Pair, pairs: Sequence[Pair]) -> str:
    """The point or guide, of pairs that share one also the links."""
    shared = [other.name for other in pairs].count(pair.name) > 1
    return pair.name + (f",{both(*pair.links)}" if shared else "")


def coefficient(pair: Pair, pairs: Sequence[Pair]) -> Quantity:
    meaning = Message(
        N_("coefficient of friction in pair %(pair)s of links %(links)s at its velocity of sliding"),
        {"pair": pair.name, "links": pair.key},
    )
    return Quantity(f"f_{pair.key}", Symbol("f", _index(pair, pairs)), "", meaning)


def sliding(pair: Pair) -> Quantity:
    """Of the surface of a journal; of a guide it is its own relative velocity."""
    meaning = Message(
        N_("velocity of sliding on the journal of pivot %(pair)s of links %(links)s"),
        {"pair": pair.name, "links": pair.key},
    )
    return Quantity(f"v_sl_{pair.key}", Symbol("v", ",".join(pair.links)), "m/s", meaning)


def columns(losses: Sequence[PairLoss]) -> Iterator[Column]:
    """Velocity of sliding and coefficient of every pair whose coefficient is a law."""
    pairs = [loss.pair for loss in losses]
    for loss in losses:
        if loss.rubbing.law is None:
            continue
        if loss.pair.kind == "R":
            yield sliding(loss.pair).column(loss.sliding)
        yield coefficient(loss.pair, pairs).column(loss.coefficient)


def laws(losses: Sequence[PairLoss]) -> dict[Rubs, list[str]]:
    """Every law once, with the points and guides of its pairs."""
    found: dict[Rubs, list[str]] = {}
    for loss in losses:
        if loss.rubbing.law is not None:
            names = found.setdefault(loss.rubbing.law, [])
            names += [] if loss.pair.name in names else [loss.pair.name]
    return found


def tables(losses: Sequence[PairLoss]) -> Iterator[Table]:
    """What is stated of the laws; none where there are none."""
    stated = laws(losses)
    curves = [(law, names) for law, names in stated.items() if isinstance(law, Stribeck)]
    if curves:
        own = [law for law, _ in curves]
        yield Table(
            "friction_stribeck",
            STRIBECK,
            (
                _names([names for _, names in curves]),
                STATIC.column([law.static for law in own]),
                KINETIC.column([law.kinetic for law in own]),
                FALL.column([law.speed for law in own]),
                VISCOUS.column([law.viscous for law in own]),
                EXPONENT.column([law.exponent for law in own]),
            ),
        )
    points = [
        (names, *point)
        for law, names in stated.items()
        if isinstance(law, BySliding)
        for point in zip(*law.points(), strict=True)
    ]
    if points:
        names, speeds, values = zip(*points, strict=True)
        yield Table(
            "friction_points",
            POINTS,
            (
                _names(names),
                Column(SPEED, speeds, [Symbol("v", "", f"({row})") for row in range(1, len(points) + 1)]),
                Column(
                    COEFFICIENT, values, [Symbol("f", "", f"({row})") for row in range(1, len(points) + 1)]
                ),
            ),
        )


def _names(rows: Sequence[Sequence[str]]) -> Column:
    return text_column("names", PAIRS, [", ".join(names) for names in rows])


def stated_coefficient(of: Rubbing) -> float:
    """The number stated; nan of a law."""
    return math.nan if of.law is not None else float(of.at(0.0))
