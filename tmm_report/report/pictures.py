"""Pictures of the note: the results handed to `figures` as it draws them."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.drafting import Plan
from tmm_report.chapters.force_plans import ForcePlan
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import symbol
from tmm_report.figures.plans import PlanVector, Style, plan
from tmm_report.figures.scheme import Arrays, groups_apart, positions_scheme, scheme, standard_scale
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.motion import Motion
from tmm_report.report.formats import percent
from tmm_report.report.page import Page
from tmm_report.report.words import Words

STYLES: dict[str, Style] = {
    "absolute": "absolute", "relative": "relative", "bend": "component", "rate": "component",
    "gravity": "force", "load": "force", "inertia": "inertia", "reaction": "reaction", "component": "component",
}  # fmt: skip


class Pictures:
    def __init__(self, results: Any, page: Page, words: Words):
        self.r, self.page, self.words = results, page, words
        self.mechanism = results.variant.mechanism

    # ------------------------------------------------------------ schemes

    def one_position(self, position: int) -> Drawing:
        places, turns = self._whole
        return scheme(self.mechanism, places, turns, self.scheme_scale, position, self._zero)

    def all_positions(self, position: int) -> Drawing:
        places, turns = self._distinct
        return positions_scheme(self.mechanism, places, turns, self.scheme_scale, position % self._count, self._paths)

    def groups(self, position: int) -> Drawing:
        places, turns = self._whole
        linkage = self.r.structure.linkage.structure
        driver = self.mechanism.driver.link
        groups = [(f"I(0,{driver})", (FRAME, driver)), *((group.label, group.links) for group in linkage.groups)]
        return groups_apart(self.mechanism, places, turns, groups, position)

    @cached_property
    def scheme_scale(self) -> float:
        """m/mm: the scale of the plans' construction where the scheme of all positions fits a page at it."""
        places, turns = self._distinct
        stated = self.r.plans.length_scale
        drawn = positions_scheme(self.mechanism, places, turns, stated, 0, self._paths)
        return stated if percent(drawn) == 100 else standard_scale(self.mechanism, places, turns)

    @cached_property
    def _whole(self) -> tuple[Arrays, Arrays]:
        return self._seen(self.r.kinematics.table)

    @cached_property
    def _distinct(self) -> tuple[Arrays, Arrays]:
        """Without the last position of a full turn, which is the first."""
        places, turns = self._whole
        return tuple({k: x[: self._count] for k, x in arrays.items()} for arrays in (places, turns))

    @property
    def _count(self) -> int:
        kinematics = self.r.kinematics
        return len(kinematics.turned) - (1 if kinematics.cycle.closed else 0)

    @cached_property
    def _paths(self) -> Arrays:
        return self._seen(self.r.kinematics.diagram)[0]

    def _seen(self, motion: Motion) -> tuple[Arrays, Arrays]:
        places = {point: motion.place(point) for point in self.mechanism.point_names}
        turns = {link: motion.turn(link) for link in self.mechanism.moving}
        shape = motion.shape
        return tuple({k: np.broadcast_to(x, shape) for k, x in arrays.items()} for arrays in (places, turns))

    @property
    def _zero(self) -> complex:
        return complex(self.r.kinematics.table.turn(self.mechanism.driver.link)[0])

    # ------------------------------------------------------------ plans

    def plan(self, drawn: Plan) -> Drawing:
        """A plan of velocities or accelerations, at its scale."""
        vectors = [
            PlanVector(s.start, s.end, symbol(s.key), "coriolis" if s.key.endswith("_k") else STYLES[s.role])
            for s in drawn.strokes
        ]
        return plan(vectors, drawn.vertices, pole=drawn.pole)

    def force_plan(self, drawn: ForcePlan) -> Drawing:
        vectors = [PlanVector(s.start, s.end, symbol(s.key), STYLES[s.kind]) for s in drawn.strokes]
        return plan(vectors, {})

    def balancing(self): return self.plan(self.r.plans.drawn[0].velocity)
    losses=balancing
    def travel(self,t): return self.balancing()
    def travel_scales(self,t): return 'x'
