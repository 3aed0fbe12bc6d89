"""Families of drawn mechanisms and how many of a run each gets."""

from __future__ import annotations

import numpy as np

from benchmarks.random_groups.draw import Batch, draw
from benchmarks.random_groups.near import near

SHARES = {  # of a run of 11 000: 10 000 of class III, 1000 of class IV
    "III-RRR": 2200, "III-RRR-L": 1700, "III-S": 1100, "III-S-L": 700, "III-S2": 750, "III-S2-L": 600,
    "dyad-III": 600, "III-dyad": 250, "III-P": 300, "III-RRR-N": 1000, "III-S-N": 500, "III-S2-N": 300,
    "IV": 350, "IV-L": 200, "IV-S": 150, "IV-P": 50, "IV-N": 250,
}  # fmt: skip


def drawn(family: str, count: int, seed: int) -> Batch:
    """A chunk of a family."""
    with np.errstate(all="ignore"):
        if family.endswith("-N"):
            return near(family, family[:-2], count, seed)
        return draw(family, count, seed)
