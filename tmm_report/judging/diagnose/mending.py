"""A student's numbers with a mistake undone."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.judging.diagnose.candidates import Claim, Mistake
from tmm_report.judging.diagnose.single import ROTATION, senses
from tmm_report.judging.model import Answers, Asked, Expected, Name

Array = Any


def mended(
    mistake: Mistake,
    name: Name,
    claim: Claim,
    answers: Answers,
    expected: Expected,
    order: Mistake | None = None,
) -> Array:
    """(P,) in the unit asked, nan where there is no answer. `order`: a mistake in the order of positions besides.

    Of numbers that belong to another question (another component, another variant) his own answer cannot be known: a
    cell that is right there counts as right here.
    """
    column, right = answers.columns[name], expected[name].values
    mine = np.where(column.given, column.values, np.nan)
    if order is not None:
        mine = _in_order(order, expected[name], mine)
    match mistake.kind:
        case "sign":
            return -mine
        case "modulus":
            return np.copysign(mine, right)
        case "shifted" | "reversed":
            return _in_order(mistake, expected[name], mine)
        case "swapped":
            other = answers.columns[mistake.names[mistake.names[0] == name]]
            return np.where(other.given, other.values, np.nan)
        case "component" | "variant":
            return np.where(claim.fits, right, mine)
        case _:
            return mine / mistake.by


def _in_order(mistake: Mistake, asked: Asked, mine: Array) -> Array:
    """Every number in the row of the position that it belongs to; the last row is the first again."""
    here = np.arange(len(mine) - 1)
    once = mine[:-1].copy()
    once[0] = mine[0] if np.isfinite(mine[0]) else mine[-1]
    order = -here if mistake.kind == "reversed" else here - int(mistake.by)
    undone = once[order % len(once)] * (senses(asked) if mistake == ROTATION else 1.0)
    first = undone[0] if np.isfinite(mine[0]) or not np.isfinite(mine[-1]) else np.nan
    return np.array([first, *undone[1:], undone[0] if np.isfinite(mine[-1]) else np.nan])
