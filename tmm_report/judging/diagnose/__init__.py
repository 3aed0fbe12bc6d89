"""Naming the mistake: which usual mistake, undone, makes a student's wrong columns right.

Mistakes are tried on whole columns, all of them at once, and joined over the whole work: a mistake in the order of
the positions, in a unit or in the sense of rotation usually hits many columns alike, and one cause that explains them
all is likelier than one for each. A column that is right is never touched.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from tmm_report.judging.diagnose import pairs, rows, single, variants
from tmm_report.judging.diagnose.candidates import Candidate, Candidates, Mistake
from tmm_report.judging.diagnose.choose import chosen
from tmm_report.judging.diagnose.columns import Stack, only, stacks, wrong
from tmm_report.judging.diagnose.mending import mended
from tmm_report.judging.diagnose.variants import Others, prepared
from tmm_report.judging.diagnose.words import sentence
from tmm_report.judging.model import Answers, Cause, Expected, Judged, Name

__all__ = ["Others", "diagnose", "prepared"]


def diagnose(
    answers: Answers,
    expected: Expected,
    judged: Mapping[Name, Judged],
    *,
    limit: float = 5.0,
    others: Mapping[str, Expected] | Others | None = None,
    floors: Mapping[Name, float] | None = None,
) -> list[Cause]:
    """The likely mistakes, the one that explains most first; no column is explained by two.

    `judged`: the columns as they were judged as given. `limit`: per cent. `others`: the other variants by their ids;
    `prepared(...)` of them saves time where many works are compared. `floors`: what was judged with, by column, where
    it was not the default floor.
    """
    with np.errstate(all="ignore"):
        answered = stacks(answers, expected, judged, limit, floors or {})
        suspects = list(wrong(answered))
        if not suspects:
            return []
        first = chosen(_tried(answered, suspects, expected, others))
        order = next((one.mistake for one in first if one.mistake.kind in ("shifted", "reversed")), None)
        second = _besides(first, order, suspects) if order is not None else []
        causes = [cause for one in first for cause in _causes(one, answers, expected)]
        causes += [cause for one in second for cause in _causes(one, answers, expected, order)]
        left = {name for one in (*first, *second) for name in one.claims}
        return causes + list(_exchanges(suspects, left, answers, expected))


def _tried(
    answered: list[Stack],
    suspects: list[Stack],
    expected: Expected,
    others: Mapping[str, Expected] | Others | None,
) -> Candidates:
    found = Candidates()
    for stack in suspects:
        single.signs(stack, found)
        single.factors(stack, found)
        single.scales(stack, found)
        single.orders(stack, found)
        pairs.swaps(stack, found)
        pairs.components(stack, found, expected)
    if others:
        ready = others if isinstance(others, Others) else prepared(others)
        variants.another(answered, suspects, ready, found)
    return found


def _besides(first: list[Candidate], order: Mistake, suspects: list[Stack]) -> list[Candidate]:
    """What else is wrong in columns that stand in the wrong order too: a sign, a unit or a factor."""
    explained = {name for one in first for name in one.claims}
    found = Candidates()
    for stack in suspects:
        left = np.array([one.name not in explained and single.goes_round(one) for one in stack.asked])
        if left.any():
            rest = only(stack, left)
            moved = replace(rest, right=single.reordered(rest, order))
            single.signs(moved, found)
            single.factors(moved, found)
            single.scales(moved, found)
    return chosen(found)


def _exchanges(
    suspects: list[Stack], explained: set[Name], answers: Answers, expected: Expected
) -> Iterator[Cause]:
    """Two rows in each other's place, in columns that nothing else explains."""
    for stack in suspects:
        left = np.array([one.name not in explained for one in stack.asked])
        if left.any() and (swap := rows.exchanged(only(stack, left))) is not None:
            i, j = swap.one, swap.other
            mended = {}
            for name in swap.names:
                column = answers.columns[name]
                values = np.where(column.given, column.values, np.nan)
                values[[i, j]] = values[[j, i]]
                mended[name] = values
            names = tuple(name for name in expected if name in mended)
            labels = expected[names[0]].rows
            detail = f"{labels[i]}, {labels[j]}"
            what = sentence(Mistake("rows", detail), names, expected)
            yield Cause("rows", names, what, detail, mended, swap.right / swap.wrong)


def _causes(
    one: Candidate, answers: Answers, expected: Expected, order: Mistake | None = None
) -> list[Cause]:
    """A mistake; a factor below 0 is one of two, the opposite sign the other."""
    cause = _cause(one, answers, expected, order)
    if one.mistake.by >= 0 or one.mistake.kind == "shifted":
        return [cause]
    return [cause, replace(cause, kind="sign", detail="", what=sentence(single.SIGN, cause.names, expected))]


def _cause(one: Candidate, answers: Answers, expected: Expected, order: Mistake | None = None) -> Cause:
    names = tuple(name for name in expected if name in one.claims)
    right = sum(int(claim.fits.sum()) for claim in one.claims.values())
    mistake = one.mistake
    return Cause(
        mistake.kind,
        names,
        sentence(mistake, names, expected),
        mistake.detail,
        {name: mended(mistake, name, one.claims[name], answers, expected, order) for name in names},
        right / sum(claim.answered for claim in one.claims.values()),
    )
