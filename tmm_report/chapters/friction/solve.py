"""Chapter 3, friction: power lost in every pair and the instantaneous efficiency.

Pivots f R (d/2) |ω_rel|, guides f R |v_rel| (Frolov (ed.), Theory of mechanisms, ch. 7); the reactions are those
without friction, as the course takes them. `corrected` finds them with friction, where that is asked for.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.friction import corrected
from tmm_report.chapters.friction.given import Friction, Rubbing
from tmm_report.chapters.kinetostatics.solve import Kinetostatics, Over, cut_at
from tmm_report.mechanics.motion import Motion
from tmm_report.mechanics.rubbing import relative_rate
from tmm_report.mechanics.statics import Statics
from tmm_report.mechanics.structure import Pair
from tmm_report.records import dataclass

__all__ = ["FrictionFound", "Losses", "PairLoss", "rubbing_of", "solve"]

Array = Any


@dataclass(frozen=True, eq=False)
class PairLoss:
    """Friction in one pair at some positions: `reaction` N, `rate` the relative rad/s or m/s, `power` W; (..., P)."""

    pair: Pair
    rubbing: Rubbing
    reaction: Array
    rate: Array
    power: Array


@dataclass(frozen=True, eq=False)
class Losses:
    """Losses of all pairs. `driving`: |M_bal ω1|, W; `efficiency`: driving / (driving + total), 0..1; `reduced`: moment
    of all the friction reduced to the driving link, N m."""

    pairs: tuple[PairLoss, ...]
    driving: Array
    omega: float

    @cached_property
    def total(self) -> Array:
        return np.sum([loss.power for loss in self.pairs], axis=0) + np.zeros_like(self.driving)

    @cached_property
    def efficiency(self) -> Array:
        with np.errstate(invalid="ignore", divide="ignore"):
            return self.driving / (self.driving + self.total)

    @cached_property
    def reduced(self) -> Array:
        return self.total / abs(self.omega)


@dataclass(frozen=True, eq=False)
class FrictionFound:
    """Found by `solve`: losses at the table positions 0..N and the diagram positions. `given`: by pair name."""

    given: Friction
    turned: Array  # angles of the table positions, rad
    diagram_turned: Array
    table: Losses
    diagram: Losses
    forces: Kinetostatics  # without friction
    corrected: corrected.Correction | None = None

    @cached_property
    def whole(self) -> tuple[Over, Losses] | None:
        """Over the whole cycle, cut where the losses have kinks; None where some position has no forces."""
        return _whole(self.given, self.forces)

    @cached_property
    def mean_power(self) -> float:
        """Mean friction power over the cycle, W."""
        return self._mean(lambda losses: losses.total)

    @cached_property
    def mean_efficiency(self) -> float:
        """Efficiency over the cycle: mean driving power to the sum of the means."""
        driving = self._mean(lambda losses: losses.driving)
        return driving / (driving + self.mean_power) if driving > 0 else float("nan")

    def _mean(self, of: Callable[[Losses], Array]) -> float:
        """Over the whole cycle; of the diagram positions where some position has no forces (the last of a full turn
        repeats the first); nan of a mechanism that makes no cycle."""
        if self.forces.kinematics.gaps:
            return float("nan")
        if self.whole is None:
            return float(np.nanmean(of(self.diagram)[:-1]))
        over, losses = self.whole
        return float(over.panels.mean(over.on(of(losses))))


def solve(given: Friction, kinetostatics: Kinetostatics) -> FrictionFound:
    table, diagram = kinetostatics.table, kinetostatics.diagram
    at_table, at_diagram = (_losses(given, solved.motion, solved.statics) for solved in (table, diagram))
    again = _corrected(given, kinetostatics, at_table, at_diagram)
    return FrictionFound(given, table.turned, diagram.turned, at_table, at_diagram, kinetostatics, again)


def _whole(given: Friction, kinetostatics: Kinetostatics) -> tuple[Over, Losses] | None:
    """Over the cycle, with edges where two links stop to turn or to slide on one another and where the balancing moment
    passes through zero: the losses have kinks there."""
    over = kinetostatics.over
    if over is None:
        return None
    rates = [relative_rate(over.motion, pair) for pair in over.motion.linkage.structure.pairs]
    known = [over.on(rate) for rate in rates if np.any(rate)]
    kinks = [over.panels.roots(of) for of in (*known, over.balancing)]
    finer = cut_at(over, np.concatenate(kinks), kinetostatics.given, kinetostatics.kinematics)
    return None if finer is None else (finer, _losses(given, finer.motion, finer.statics))


def _corrected(
    given: Friction, kinetostatics: Kinetostatics, table: Losses, diagram: Losses
) -> corrected.Correction | None:
    if not given.corrected:
        return None
    whole = _whole(given, kinetostatics)
    over = (whole[0], whole[1].total) if whole is not None else None
    first = table.total, diagram.total
    return corrected.solve(lambda pair: rubbing_of(given, pair), kinetostatics, first, over)


def rubbing_of(given: Friction, pair: Pair) -> Rubbing | None:
    """Friction of a pair: its own, else that of all pivots or guides; None where nothing is stated."""
    return given.joints.get(pair.name) or (given.pivots if pair.kind == "R" else given.guides)


def _losses(given: Friction, motion: Motion, statics: Statics) -> Losses:
    losses = []
    for reaction in statics.reactions.values():
        rubbing = rubbing_of(given, reaction.pair)
        if rubbing is not None:
            size = np.abs(np.broadcast_to(reaction.force, motion.shape))
            rate = np.abs(relative_rate(motion, reaction.pair))
            arm = (rubbing.diameter or 0.0) / 2 if reaction.pair.kind == "R" else 1.0
            losses.append(
                PairLoss(reaction.pair, rubbing, size, rate, rubbing.coefficient * size * arm * rate)
            )
    order = [pair.key for pair in motion.linkage.structure.pairs]
    losses.sort(key=lambda loss: order.index(loss.pair.key))
    omega = float(motion.omega)
    return Losses(tuple(losses), np.abs(np.broadcast_to(statics.balancing, motion.shape) * omega), omega)
