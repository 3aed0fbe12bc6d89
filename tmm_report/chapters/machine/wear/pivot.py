"""Wear of a pivot along its circumference: journal and bushing cut into sectors, each in its own axes."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.solve.positions import Solved
from tmm_report.chapters.machine.wear import steps
from tmm_report.chapters.machine.wear.mistakes import believable
from tmm_report.chapters.machine.wear.values import Pivot
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.forces.reactions_with_friction import relative_rate
from tmm_report.mechanics.pairs import wear
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.machine.wear.block import PivotModel

Array = Any
MEMBERS = ("journal", "bushing")


@dataclass(frozen=True, eq=False)
class Member:
    """The journal or the bushing of the link `link`: `k`, 1/Pa; `centre`: angle of the middle of the contact in its
    axes, rad, (P,); `path`: Σ p|ds| of the sectors over a cycle, Pa m;
    `depth`: of the sectors after all cycles, m, (N,)."""

    name: str
    link: str
    k: float
    centre: Array
    path: Array
    depth: Array

    @property
    def greatest(self) -> float:
        return float(self.depth.max())

    @property
    def worst(self) -> int:
        """Number of the sector worn most, from 0."""
        return int(np.argmax(self.depth))


@dataclass(frozen=True, eq=False)
class PivotFound:
    """`force`: size of the reaction, N; `rate`: ω_rel, rad/s; `slide`: r|ω_rel|Δt of each position, m, (P,);
    `pressure`: mean over the path on the projection of the journal, Pa; `period`: of a cycle, s; `s`: the single
    numbers."""

    s: Pivot
    given: PivotModel
    pair: Pair
    period: float
    force: Array
    rate: Array
    slide: Array
    pressure: float
    members: tuple[Member, Member]

    @property
    def radius(self) -> float:
        return self.given.diameter / 2

    @property
    def centres(self) -> Array:
        """Angles of the middles of the sectors from the x axis of the link, rad, (N,)."""
        return 2 * np.pi * (np.arange(self.given.sectors) + 0.5) / self.given.sectors

    @property
    def rubbed(self) -> float:
        """∫ R|ds| over a cycle, N m."""
        return float(np.sum(self.force * self.slide))

    @cached_property
    def spread(self) -> float:
        """By how much the pressures exceed the force."""
        return wear.spread(self.given.half_arc, self.given.law)

    def volume(self, of: Member) -> float:
        """m³."""
        return float(of.depth.sum()) * self.radius * self.given.width * 2 * np.pi / self.given.sectors

    @property
    def worst(self) -> Member:
        return max(self.members, key=lambda one: one.greatest)

    @property
    def life(self) -> float | None:
        """Cycles until the stated limit."""
        limit = self.given.limit
        return None if limit is None else limit / self.worst.greatest * self.given.cycles


def solve(given: PivotModel, solved: Solved, cycle: Cycle, index: int) -> PivotFound:
    """Raises ProblemError: no such pivot, more than one, a pivot that does not turn, a wear of nothing or out of all
    proportion."""
    path = ("wear", "pivots", index)
    pair = _pair(given, solved, path)
    motion, reaction = solved.motion, solved.statics.reactions[pair.key]
    on_journal = np.broadcast_to(reaction.force, motion.shape) * (1 if given.journal == pair.links[1] else -1)
    if not np.isfinite(on_journal).all():
        raise ProblemError([mistake(N_("the reaction of the pivot is not known at every position"), path)])
    force = np.abs(on_journal)
    rate = np.broadcast_to(relative_rate(motion, pair), force.shape)
    turned = np.abs(rate / motion.omega) * (cycle.period / len(force))
    slide = given.diameter / 2 * turned
    if not np.sum(force * slide) > 0:
        raise ProblemError([mistake(N_("nothing rubs in the pivot %(name)s"), path, name=given.pivot)])
    pressure = wear.mean_over_path(force, slide, force > 0) / (given.diameter * given.width)
    links = given.journal, pair.other(given.journal)
    members = tuple(
        _member(given, solved, name, link, k.at(pressure), (on_journal, slide))
        for name, link, k in zip(MEMBERS, links, given.members, strict=True)
    )
    believable(max(one.greatest for one in members), given.diameter, path)
    period = cycle.period / abs(float(motion.omega))
    s = Pivot(prefix=f"wear_pivot_{index + 1}")
    found = PivotFound(s, given, pair, period, force, rate, slide, pressure, (members[0], members[1]))
    steps.pivot(s, found)
    return found


def _pair(given: PivotModel, solved: Solved, path: tuple[str | int, ...]) -> Pair:
    pairs = [p for p in solved.motion.linkage.structure.pairs if p.kind == "R" and p.name == given.pivot]
    found = [p for p in pairs if given.journal in p.links and given.bushing in (None, p.other(given.journal))]
    if len(found) != 1:
        words = ", ".join(p.key for p in pairs)
        text = N_("the pivot %(name)s of these links is not one revolute pair")
        right = Message(N_("pairs there: %(words)s"), {"words": words})
        raise ProblemError([mistake(text, (*path, "journal"), right, name=given.pivot)])
    return found[0]


def _member(
    given: PivotModel, solved: Solved, name: str, link: str, k: float, load: tuple[Array, Array]
) -> Member:
    """The journal touches the bushing on the side away from the force upon it."""
    on_journal, slide = load
    centre = np.angle(-on_journal / solved.motion.turn(link))
    path = wear.pressure_path(
        given.half_arc,
        given.law,
        given.diameter / 2,
        given.width,
        np.abs(on_journal),
        slide,
        centre,
        given.sectors,
    )
    return Member(name, link, k, centre, path, given.cycles * k * path)
