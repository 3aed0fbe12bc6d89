"""The numbers of the mechanism balanced on its foundation: shaking, counterweights, substituted masses, harmonics."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import chain

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.machine.balancing.quantities import against_moment, weights
from tmm_report.chapters.machine.balancing.quantities import slider_cranks as sliders
from tmm_report.chapters.machine.balancing.solve.cases import Case, Shaken
from tmm_report.chapters.machine.balancing.solve.counterweights import half_turn
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.chapters.machine.balancing.values import Cases, Harmonics, Rotors, Shaking, force, moment
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, Value, text_column
from tmm_report.quantity.sheet import Q
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

SHAKING = Message(N_("shaking force and shaking moment of the mechanism as it is"))
BALANCED = Message(N_("shaking force and shaking moment left by each way of balancing, by its number"))
CASES = Message(N_("ways of balancing and what each leaves over the cycle"))
HARMONICS = Message(
    N_("harmonics of the shaking force: vectors that turn with the driving link and against it")
)
ROTORS = Message(N_("pairs of counter-rotating weights against harmonics of the shaking force"))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    sets = (("table", found.kinematics.turned), ("diagram", found.kinematics.diagram_turned))
    for name, turned in sets:
        of: Shaken = getattr(found.original, name)
        shaken = (*Shaking.F_shake.quantity.vector(of.force), Shaking.M_shake.column(of.moment))
        yield Table(f"shaking_{name}", SHAKING, (*where(turned), *shaken))
        if found.cases:
            left = (
                column for k, case in enumerate(found.cases, 1) for column in _left(k, getattr(case, name))
            )
            yield Table(f"balanced_{name}", BALANCED, (*where(turned), *left))
    yield _cases(found.every)
    yield from weights.counterweights(found.cases)
    if found.substituted.splits:
        yield weights.splits(found)
    yield from against_moment.tables(found)
    yield _harmonics(found)
    yield _rotors(found)
    yield from sliders.tables(found)


def _left(number: int, of: Shaken) -> Iterator[Column]:
    yield from force(number).vector(of.force)
    yield moment(number).column(of.moment)


def _cases(every: Sequence[Case]) -> Table:
    peaks = [case.force_max for case in every]
    return Table(
        "balancing_cases",
        CASES,
        (
            Cases.case.column(list(range(len(every)))),
            text_column("method", weights.METHOD, [case.name for case in every]),
            Cases.F_max.column(np.array([peak.value for peak in peaks])),
            Cases.F_max_at.column(np.array([math.degrees(peak.turned) for peak in peaks])),
            Cases.left.column(np.array([peak.value / peaks[0].value for peak in peaks])),
            Cases.F_rms.column(np.array([case.force_rms for case in every])),
            Cases.M_max.column(np.array([case.moment_max.value for case in every])),
            Cases.M_left.column(_by_first([case.moment_max.value for case in every])),
            Cases.M_rms.column(np.array([case.moment_rms for case in every])),
            Cases.m_total.column(np.array([case.mass for case in every])),
        ),
    )


def _by_first(sizes: list[float]) -> np.ndarray:
    return np.array(sizes) / sizes[0] if sizes[0] else np.full(len(sizes), np.nan)


# ---------------------------------------------------------------- harmonics of the force


def _harmonics(found: Found) -> Table:
    highest = len(found.harmonics) // 2
    forward, backward = found.harmonics[highest + 1 :], found.harmonics[:highest][::-1]
    size = np.abs(found.harmonics).max()
    F_with, alpha_with = Harmonics.F_with, Harmonics.alpha_with
    F_against, alpha_against = Harmonics.F_against, Harmonics.alpha_against
    parts = ((F_with, alpha_with, forward), (F_against, alpha_against, backward))
    columns = chain.from_iterable(
        (of.column(_sizes(values, size)), at.column(_angles(values, size))) for of, at, values in parts
    )
    return Table(
        "shaking_harmonics", HARMONICS, (Harmonics.order.column(list(range(1, highest + 1))), *columns)
    )


def _sizes(values: np.ndarray, size: float) -> np.ndarray:
    found = np.abs(values)
    return np.where(found <= 1e-11 * size, 0.0, found)


def _angles(values: np.ndarray, size: float) -> np.ndarray:
    """Degrees, −180 … 180; none where there is no force."""
    return np.where(np.abs(values) <= 1e-11 * size, np.nan, np.degrees(half_turn(np.angle(values))))


def _rotors(found: Found) -> Table:
    rows, asked = found.rotors, bool(found.given.radii)
    signs = [f"({one.order})".replace("-", "−") for one in rows]  # an index would be that of a link

    def named(of: Q, values: list[float]) -> Column:
        quantity = of.quantity
        return Column(quantity, np.array(values), [Symbol(quantity.sign.base, sup=sign) for sign in signs])

    return Table(
        "lanchester_rotors",
        ROTORS,
        (
            Rotors.order.column([one.order for one in rows]),
            named(Rotors.mr, [one.moment for one in rows]),
            named(Rotors.alpha, [math.degrees(one.angle) if one.moment else math.nan for one in rows]),
            named(Rotors.r, [one.radius if asked else math.nan for one in rows]),
            named(Rotors.m, [one.mass if asked else math.nan for one in rows]),
        ),
    )


# ---------------------------------------------------------------- single numbers


@tabulated
def values(found: Found) -> Iterator[Value]:
    yield from found.s.values()
    for slider in found.sliders:
        yield from slider.values()
