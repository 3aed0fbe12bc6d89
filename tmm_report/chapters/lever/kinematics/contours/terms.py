"""Of what the contours of groups above class II consist, and what is written out of such a group."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.contours.known import Spot
from tmm_report.chapters.lever.kinematics.contours.worked import Bench
from tmm_report.mechanics.lever.assur_groups import Group, Pair
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.written import Equation
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Slide:
    """An unknown displacement along a guide: s and its derivatives; the guide's angle; `turns`: the number of the
    unknown direction with which it turns, None where it is carried by a known link, whose ω and ε are `w`, `e`."""

    s: Var
    first: Var
    second: Var
    beta: Expr
    turns: int | None
    w: Expr | None
    e: Expr | None


@dataclass(frozen=True, eq=False)
class Segment:
    """A vector of constant length: that of an unknown direction `turns`, or (None) fixed to a known link."""

    length: Expr
    angle: Expr
    turns: int | None
    w: Expr | None
    e: Expr | None


@dataclass(frozen=True, eq=False)
class Contour:
    """The terms of a closed contour."""

    points: list[tuple[int, Spot]]
    segments: list[tuple[int, Segment]]
    slides: list[tuple[int, Slide]]


@dataclass(frozen=True, eq=False)
class WrittenSystem:
    """What is written out of a group above class II. `unknowns`: their values in the position; `rates`, `bends`: the
    unknowns of both linear systems; `rows`: keys of the coefficients and of the right sides, a row an equation."""

    group: Group
    lead: list[Formula]
    equations: tuple[Equation, ...]
    unknowns: list[Var]
    residuals: list[Formula]
    coefficients: list[Formula]
    rates: list[Var]
    bends: list[Var]
    rows: list[list[str]]
    points: list[Formula]


def pairs(
    points: Mapping[str, complex], origin: complex, turn: complex, arm: complex
) -> Iterator[tuple[str, str]]:
    """Points of a link that are `arm` apart: contours go through a link's origin, so its are the first; "" of an origin
    without a name."""
    apart = 1e-9 * abs(arm)
    own = next((name for name, at in points.items() if abs(at - origin) <= apart), "")
    for name, at in points.items():
        if abs(turn * (at - origin) - arm) <= apart:
            yield own, name
        if abs(turn * (origin - at) - arm) <= apart:
            yield name, own
    for one, a in points.items():
        yield from ((one, other) for other, b in points.items() if abs(turn * (b - a) - arm) <= apart)


def slid(bench: Bench, pair: Pair, slider: str, carrier: str) -> tuple[Array, Array, Array]:
    """s = t·(r_b − r_c) along the guide and its derivatives, from the motion of both links."""
    s = bench.motion.state
    t = s.u[carrier] * pair.along[carrier]
    here, there = (
        (s.world(link, pair.at[link]), s.u[link] * (pair.at[link] - s.o[link])) for link in (slider, carrier)
    )
    gap = here[0] - there[0]
    v = s.velocity(slider, here[1]) - s.velocity(carrier, there[1])
    a = s.acceleration(slider, here[1]) - s.acceleration(carrier, there[1])
    w = s.w[carrier]
    own = np.conj(t)
    distance = np.real(own * gap)
    first = np.real(own * v)
    return distance, first, np.real(own * a) + w * w * distance + 0.0
