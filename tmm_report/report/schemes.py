"""Schemes of a lever mechanism in the note: one position, all positions, its groups taken apart."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from tmm_report.figures.drawing import Drawing
from tmm_report.figures.scheme import Arrays, groups_apart, positions_scheme, scheme, standard_scale
from tmm_report.mechanics.mechanism import FRAME, Mechanism
from tmm_report.mechanics.motion import Motion
from tmm_report.mechanics.structure import Group
from tmm_report.quantity.formula import Var
from tmm_report.report.diagrams import scale_of
from tmm_report.report.formats import percent


class Schemes:
    """`table`, `paths`: the motion at the table positions and at those by which paths are drawn; `count`: distinct
    table positions; `length_scale`: m/mm of the plans' construction."""

    def __init__(self, mechanism: Mechanism, table: Motion, paths: Motion, count: int, length_scale: float):
        self.mechanism, self.table, self.paths = mechanism, table, paths
        self.count, self.length_scale = count, length_scale

    def one(self, position: int) -> Drawing:
        places, turns = self._whole
        zero = complex(self.table.turn(self.mechanism.driver.link)[0])
        return scheme(self.mechanism, places, turns, self.scale, position, zero)

    def all(self, position: int) -> Drawing:
        """All positions, one of them drawn in full."""
        places, turns = self._distinct
        return positions_scheme(
            self.mechanism, places, turns, self.scale, position % self.count, self._traced
        )

    def groups(self, groups: Sequence[Group], position: int) -> Drawing:
        places, turns = self._whole
        driver = self.mechanism.driver.link
        named = [(f"I(0,{driver})", (FRAME, driver)), *((group.label, group.links) for group in groups)]
        return groups_apart(self.mechanism, places, turns, named, position)

    def scale_var(self) -> Var:
        """mu_l with the scale at which the schemes are drawn."""
        return scale_of("mu_l", self.scale, "m/mm")

    @cached_property
    def scale(self) -> float:
        """m/mm: the scale of the plans' construction where the scheme of all positions fits a page at it."""
        places, turns = self._distinct
        drawn = positions_scheme(self.mechanism, places, turns, self.length_scale, 0, self._traced)
        if percent(drawn) == 100:
            return self.length_scale
        return standard_scale(self.mechanism, places, turns)

    @cached_property
    def _whole(self) -> tuple[Arrays, Arrays]:
        return self._seen(self.table)

    @cached_property
    def _distinct(self) -> tuple[Arrays, Arrays]:
        """Without the last position of a full turn, which is the first."""
        places, turns = ({k: x[: self.count] for k, x in arrays.items()} for arrays in self._whole)
        return places, turns

    @cached_property
    def _traced(self) -> Arrays:
        return self._seen(self.paths)[0]

    def _seen(self, motion: Motion) -> tuple[Arrays, Arrays]:
        places = {point: motion.place(point) for point in self.mechanism.point_names}
        turns = {link: motion.turn(link) for link in self.mechanism.moving}
        places, turns = ({k: np.broadcast_to(x, motion.shape) for k, x in a.items()} for a in (places, turns))
        return places, turns
