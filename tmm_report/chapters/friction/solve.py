"""Chapter 3, friction: power lost in every pair and the instantaneous efficiency.

Pivots f R (d/2) |ω_rel|, guides f R |v_rel| (Frolov (ed.), Theory of mechanisms, ch. 7); the reactions are those
without friction, as the course takes them. `corrected` finds them with friction, where that is asked for.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.friction import corrected
from tmm_report.chapters.friction.given import Friction, Rubbing
from tmm_report.chapters.kinetostatics.solve import Kinetostatics, Solved
from tmm_report.mechanics.rubbing import relative_rate
from tmm_report.mechanics.structure import Pair

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
    """Losses of all pairs. `driving`: |M_bal ω1|, W; `efficiency`: driving / (driving + total), 0..1."""

    pairs: tuple[PairLoss, ...]
    driving: Array

    @cached_property
    def total(self) -> Array:
        return np.sum([loss.power for loss in self.pairs], axis=0) + np.zeros_like(self.driving)

    @cached_property
    def efficiency(self) -> Array:
        with np.errstate(invalid="ignore", divide="ignore"):
            return self.driving / (self.driving + self.total)


@dataclass(frozen=True, eq=False)
class FrictionFound:
    """Found by `solve`: losses at the table positions 0..N and the diagram positions. `given`: by pair name."""

    given: Friction
    turned: Array  # angles of the table positions, rad
    diagram_turned: Array
    table: Losses
    diagram: Losses
    corrected: corrected.Correction | None = None

    @cached_property
    def mean_power(self) -> float:
        """Mean friction power over the cycle, W (the last diagram position of a full turn repeats the first)."""
        return float(np.nanmean(self.diagram.total[:-1]))

    @cached_property
    def mean_efficiency(self) -> float:
        """Efficiency over the cycle: mean driving power to the sum of the means."""
        driving = float(np.nanmean(self.diagram.driving[:-1]))
        return driving / (driving + self.mean_power) if driving > 0 else float("nan")


def solve(given: Friction, kinetostatics: Kinetostatics) -> FrictionFound:
    table, diagram = kinetostatics.table, kinetostatics.diagram
    losses = _losses(given, table), _losses(given, diagram)
    return FrictionFound(
        given, table.turned, diagram.turned, *losses, _corrected(given, kinetostatics, *losses)
    )


def _corrected(
    given: Friction, kinetostatics: Kinetostatics, table: Losses, diagram: Losses
) -> corrected.Correction | None:
    if not given.corrected:
        return None
    first = table.total, diagram.total
    return corrected.solve(lambda pair: rubbing_of(given, pair), kinetostatics, first)


def rubbing_of(given: Friction, pair: Pair) -> Rubbing | None:
    """Friction of a pair: its own, else that of all pivots or guides; None where nothing is stated."""
    return given.joints.get(pair.name) or (given.pivots if pair.kind == "R" else given.guides)


def _losses(given: Friction, solved: Solved) -> Losses:
    losses = []
    for reaction in solved.statics.reactions.values():
        rubbing = rubbing_of(given, reaction.pair)
        if rubbing is not None:
            size = np.abs(np.broadcast_to(reaction.force, solved.motion.shape))
            rate = np.abs(relative_rate(solved.motion, reaction.pair))
            arm = (rubbing.diameter or 0.0) / 2 if reaction.pair.kind == "R" else 1.0
            losses.append(
                PairLoss(reaction.pair, rubbing, size, rate, rubbing.coefficient * size * arm * rate)
            )
    order = [pair.key for pair in solved.motion.linkage.structure.pairs]
    losses.sort(key=lambda loss: order.index(loss.pair.key))
    omega = solved.motion.state.w[solved.motion.linkage.mechanism.driver.link]
    return Losses(tuple(losses), np.abs(solved.balancing * omega))
