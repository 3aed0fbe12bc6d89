"""Schemes of a lever mechanism in the note: one position, all positions, its groups taken apart."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from tmm_report.figures.drawing import Drawing
from tmm_report.figures.schemes.scheme import (
    GROUPS_PAGE,
    PAGE,
    Arrays,
    Drawn,
    groups_apart,
    in_text,
    positions_scheme,
    scheme,
)
from tmm_report.figures.schemes.strokes import Stroke
from tmm_report.figures.schemes.ties import Tie
from tmm_report.mechanics.lever.assur_groups import Group
from tmm_report.mechanics.lever.cams.replacing_dyad import standing
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism
from tmm_report.mechanics.lever.motion import Motion


class Schemes:
    """`table`, `paths`: the motion at the table positions and at those by which paths are drawn; `count`: distinct
    table positions; `scale`: m/mm, that of the plans' construction; `ties`: springs and dampers."""

    def __init__(
        self,
        mechanism: Mechanism,
        table: Motion,
        paths: Motion,
        count: int,
        scale: float,
        ties: Sequence[Tie] = (),
    ):
        self.mechanism, self.table, self.paths = mechanism.real, table, paths
        self.count, self.scale, self.ties = count, scale, ties

    def one(self, position: int) -> Drawing:
        return self._drawn(position, self.scale)

    def _drawn(self, position: int, scale: float) -> Drawing:
        places, turns = self._whole
        zero = complex(self.table.turn(self.mechanism.driver.link)[0])
        return scheme(self.mechanism, places, turns, scale, position, zero, ties=self.ties)

    def in_text(self, position: int, small: bool = False) -> Drawn:
        """One position at the scale of the schemes, or at a coarser one where it does not fit the text at it."""
        places, _ = self._whole
        here = {point: place[position : position + 1] for point, place in places.items()}
        return in_text(lambda mu: self._drawn(position, mu), self.scale, here, GROUPS_PAGE, small)

    def all_in_text(self, position: int, strokes: Sequence[Stroke] = ()) -> Drawn:
        """All positions, at a coarser scale than that of the construction where they do not fit the text at it."""
        return in_text(lambda mu: self.all(position, strokes, mu), self.scale, self._distinct[0], PAGE)

    def all(self, position: int, strokes: Sequence[Stroke] = (), scale: float = 0.0) -> Drawing:
        """All positions, one of them drawn in full; working `strokes` are marked. `scale`: another one, m/mm."""
        places, turns = self._distinct
        centres = [link.mass_centre for link in self.mechanism.links.values() if link.mass_centre]
        return positions_scheme(
            self.mechanism,
            places,
            turns,
            scale or self.scale,
            position % self.count,
            self._traced,
            centres,
            strokes,
            ties=self.ties,
        )

    def groups(self, groups: Sequence[Group], position: int, small: bool = False) -> Drawn:
        """The groups apart at the scale of the schemes, or at a coarser one where they do not fit a page at it."""
        mechanism, places, turns, k = self._replaced(position)
        return groups_apart(mechanism, places, turns, self._named(groups), k, self.scale, small)

    def _replaced(self, position: int) -> tuple[Mechanism, Arrays, Arrays, int]:
        """The mechanism, its places and turns, and the position in them: where there are cam pairs, of the mechanism in
        which links replace them in this one position."""
        if not self.mechanism.cams:
            return self.mechanism, *self._whole, position
        motion = standing(self.table, position)
        mechanism = motion.linkage.mechanism
        return mechanism, *_seen(mechanism, motion), 0

    def _named(self, groups: Sequence[Group]) -> list[tuple[str, Sequence[str]]]:
        driver = self.mechanism.driver.link
        return [(f"I(0,{driver})", (FRAME, driver)), *((group.label, group.links) for group in groups)]

    @cached_property
    def _whole(self) -> tuple[Arrays, Arrays]:
        return _seen(self.mechanism, self.table)

    @cached_property
    def _distinct(self) -> tuple[Arrays, Arrays]:
        """Without the last position of a full turn, which is the first."""
        places, turns = ({k: x[: self.count] for k, x in arrays.items()} for arrays in self._whole)
        return places, turns

    @cached_property
    def _traced(self) -> Arrays:
        return _seen(self.mechanism, self.paths)[0]


def _seen(mechanism: Mechanism, motion: Motion) -> tuple[Arrays, Arrays]:
    places = {point: motion.place(point) for point in mechanism.point_names}
    turns = {link: motion.turn(link) for link in mechanism.moving}
    places, turns = ({k: np.broadcast_to(x, motion.shape) for k, x in a.items()} for a in (places, turns))
    return places, turns
