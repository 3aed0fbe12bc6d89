"""The numbers of what lowers the shaking moment: wheels geared to the links, weights in antiphase, harmonics."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from tmm_report.chapters.machine.balancing.given import COUPLES, INERTIA
from tmm_report.chapters.machine.balancing.solve.cases import Case
from tmm_report.chapters.machine.balancing.solve.counterweights import half_turn
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.chapters.machine.balancing.values import Couples, MomentHarmonics, Wheels
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, text_column
from tmm_report.quantity.sheet import Q
from tmm_report.quantity.symbols import Symbol

WHEELS = Message(N_("wheels geared to the links against the shaking moment"))
COUPLED = Message(N_("pairs of weights in antiphase against the harmonics of the shaking moment"))
HARMONICS = Message(N_("harmonics of the shaking moment, before and after it is balanced"))
NOTHING = 1e-11  # of the largest: a harmonic that is rounding


def tables(found: Found) -> Iterator[Table]:
    cases = {case.name: case for case in found.cases if case.base is not None}
    if INERTIA in cases and cases[INERTIA].wheels:
        yield _wheels(cases[INERTIA])
    if cases:
        yield _harmonics(found, list(cases.values()))
    if COUPLES in cases:
        yield _couples(cases[COUPLES])


def _named(of: Q, values: Sequence[float], symbols: Sequence[Symbol]) -> Column:
    return Column(of.quantity, np.array(values), list(symbols))


def _wheels(case: Case) -> Table:
    links = [one.link for one in case.wheels]
    return Table(
        "geared_inertia",
        WHEELS,
        (
            text_column("link", Message(N_("link")), links),
            _named(Wheels.i, [one.ratio for one in case.wheels], [Symbol("i", link) for link in links]),
            _named(
                Wheels.J, [one.inertia for one in case.wheels], [Symbol("J", f"w{link}") for link in links]
            ),
        ),
    )


def _harmonics(found: Found, cases: Sequence[Case]) -> Table:
    highest = found.given.highest
    base = cases[0].base
    assert base is not None
    states = (found.original, base, cases[-1])
    sizes = [fourier.series(case.cycle.moment, highest).amplitude[1:] for case in states]
    largest = max(size.max() for size in sizes)
    kept = [np.where(size <= NOTHING * largest, 0.0, size) for size in sizes]
    columns = (MomentHarmonics.M, MomentHarmonics.M_before, MomentHarmonics.M_after)
    return Table(
        "moment_harmonics",
        HARMONICS,
        (
            MomentHarmonics.order.column(list(range(1, highest + 1))),
            *(of.column(size) for of, size in zip(columns, kept, strict=True)),
        ),
    )


def _couples(case: Case) -> Table:
    rows = case.couples

    def named(of: Q, values: Sequence[float]) -> Column:
        return _named(of, values, [Symbol(of.quantity.sign.base, "c", f"({one.order})") for one in rows])

    angles = [math.degrees(half_turn(one.angle)) if one.moment else math.nan for one in rows]
    return Table(
        "antiphase_weights",
        COUPLED,
        (
            Couples.order.column([one.order for one in rows]),
            named(Couples.M, [one.amplitude for one in rows]),
            named(Couples.U, [one.moment for one in rows]),
            named(Couples.alpha, angles),
            named(Couples.d, [one.distance for one in rows]),
            named(Couples.r, [one.radius for one in rows]),
            named(Couples.m, [one.mass for one in rows]),
        ),
    )
