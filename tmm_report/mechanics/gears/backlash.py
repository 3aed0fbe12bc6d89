"""Backlash of a pair: by its centre distance, and by what its teeth are thinned. Lengths in m, angles in rad.

Exact, where guides take j = 2 f tan α: what the distance gives follows from the involutes at the angle it gives.
Source: Bolotovsky, Involute gears: a reference book, part 1; GOST 1643, the names of the deviations alone.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Loose:
    """A pair at a centre distance `a_w` with teeth thinned by `thinned` altogether, along the arcs of the pitch circles
    in the normal section."""

    pair: Pair
    a_w: float
    thinned: float

    @property
    def moved(self) -> Pair:
        """The same wheels at this distance: their tips stay as they were cut."""
        return replace(self.pair, a_w=self.a_w)

    @property
    def by_distance(self) -> float:
        """Between teeth that are not thinned, along the working circles."""
        return float(self.moved.backlash)

    @property
    def circumferential(self) -> float:
        """j_wt, along the working circles: arcs grow with the diameters."""
        p = self.moved
        wider = np.cos(p.t.alpha) / np.cos(p.alpha_w)
        return self.by_distance + float(self.thinned / np.cos(p.beta) * wider)

    @property
    def normal(self) -> float:
        """j_n, along the line of action in the normal section."""
        p = self.moved
        return float(self.circumferential * np.cos(p.alpha_w) * np.cos(p.beta_b))

    @property
    def turns(self) -> tuple[float, float]:
        """By what angle each wheel turns freely while the other is held."""
        one, two = (2 * self.circumferential / float(d) for d in self.moved.d_w)
        return one, two


def closest(pair: Pair, deviation: float) -> float:
    """Centre distance within ± `deviation` at which the least backlash is left: the shortest, of a ring the longest."""
    return float(pair.a_w) + (deviation if pair.internal else -deviation)


def thinning_for(pair: Pair, a_w: float, normal: float) -> float:
    """By how much the teeth of both wheels together are to be thinned for the normal backlash at a centre distance; not
    below 0."""
    bare = Loose(pair, a_w, 0.0)
    each = Loose(pair, a_w, 1e-6).normal - bare.normal  # the backlash is linear in it
    return max((normal - bare.normal) / each * 1e-6, 0.0)
