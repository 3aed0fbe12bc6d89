"""Mistakes seen only beside another column: two columns swapped, one component given for the other."""

from __future__ import annotations

import re
from itertools import combinations

import numpy as np

from tmm_report.judging.diagnose.candidates import Candidates, Mistake, enough
from tmm_report.judging.diagnose.columns import Stack
from tmm_report.judging.judge import default_floor
from tmm_report.judging.model import Asked, Expected, Name

_PART = re.compile(r"(.+_)([nt])(_[xy])?")
_OTHER = {"n": "t", "t": "n"}


def swaps(stack: Stack, found: Candidates) -> None:
    """Two columns in each other's place: each must fit where the other stands."""
    fit = stack.fit(stack.mine[:, None], stack.right[None], stack.floor[None])
    firm, _ = enough(stack, fit, np.array(True))
    both = firm & firm.T
    for c, d in combinations(range(len(stack.asked)), 2):
        one, other = stack.asked[c], stack.asked[d]
        if both[c, d] and partner(one.name) != other.name:
            mistake = Mistake("swapped", names=(one.name, other.name), cost=0.5)
            found.claim(mistake, stack, fit, c, d)
            found.claim(mistake, stack, fit, d, c)


def components(stack: Stack, found: Candidates, expected: Expected) -> None:
    """The normal component given for the tangential one, or the other way round; in one column or in both."""
    partners = [_partner(one, expected) for one in stack.asked]
    known = np.array([one is not None for one in partners])
    if not known.any():
        return
    aims = np.array(
        [own.values if one is None else one.values for one, own in zip(partners, stack.asked, strict=True)]
    )
    floors = np.array([[default_floor(one or own)] for one, own in zip(partners, stack.asked, strict=True)])
    fit = stack.fit(stack.mine[:, None], aims[:, None], floors[:, None])
    firm, _ = enough(stack, fit, np.array(False))
    for c in np.flatnonzero(firm[:, 0] & known):
        name = stack.asked[c].name
        pair = tuple(sorted((name, partner(name) or name)))
        found.claim(Mistake("component", names=pair, cost=0.3), stack, fit, int(c), 0)


def partner(name: Name) -> Name | None:
    """The other component of the same vector: a_BA_t of a_BA_n."""
    match = _PART.fullmatch(name[1])
    return (name[0], f"{match[1]}{_OTHER[match[2]]}{match[3] or ''}") if match else None


def _partner(asked: Asked, expected: Expected) -> Asked | None:
    other = expected.get(partner(asked.name) or ("", ""))
    return other if other is not None and other.unit == asked.unit else None
