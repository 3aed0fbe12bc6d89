"""Drawing of the choice of method: errors of the methods against their costs."""

from __future__ import annotations

import math
from collections.abc import Callable

from tmm_report.chapters.lever.methods.solve import Family
from tmm_report.figures.charts.logs import Series, loglog
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import Parts
from tmm_report.mechanics.rivals.choice import FLOOR, rounded
from tmm_report.mechanics.rivals.counts import Counted
from tmm_report.mechanics.rivals.model import Trial
from tmm_report.mechanics.rivals.trials import by_method, full, worst

TALL = 75.0  # mm: of the chart of errors by the number of positions
BELOW = 1e-3  # of the admitted error: smaller ones stand on the lower edge, so that the others do not crowd


def chart(
    family: Family, accuracy: Parts, xlabel: Parts, ylabel: Parts, name: Callable[[Trial], str]
) -> Drawing:
    """The worst error of every method that finds all kinds against its cost, a point for each number of positions."""
    series = []
    for own in by_method(family.rows):
        points = [_point(family, one) for one in own]
        front = [k for k, one in enumerate(own) if family.rows.index(one) in family.front]
        series.append(Series(points, (name(own[0]),), tuple(front)))
    return loglog(series, xlabel, ylabel, level=max(family.accuracy, FLOOR), named=accuracy)


def by_counts(
    found: Counted, accuracy: Parts, xlabel: Parts, ylabel: Parts, name: Callable[[str], Parts]
) -> Drawing:
    """Errors of what is taken from a table against its number of positions; those are full that are admitted."""
    series, least = [], max(FLOOR, BELOW * found.accuracy)
    for key, errors in found.errors.items():
        points = [
            complex(n, max(least, rounded(error))) for n, error in zip(found.counts, errors, strict=True)
        ]
        good = [k for k, error in enumerate(errors) if error <= found.accuracy]
        series.append(Series(points, name(key), tuple(good)))
    return loglog(
        series, xlabel, ylabel,
        level=max(found.accuracy, FLOOR), named=accuracy, stairs=False, xticks=found.counts, tall=TALL,
    )  # fmt: skip


def _point(family: Family, one: Trial) -> complex:
    if not full(one.errors, family.kinds):
        return complex(math.nan, math.nan)
    return complex(one.seconds / family.unit, worst(one.errors))
