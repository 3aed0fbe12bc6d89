"""Reactions, balancing moment and efficiency corrected for friction.

The first approximation takes the power of friction from the reactions without it. Here friction loads the links, so
that reactions and friction belong to one another. The power balance with friction is the second way to the moment.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.friction.given import Friction, Rubbing
from tmm_report.chapters.lever.friction.rubbed import contact_of, rubbing_of, sliding_pairs
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Over, Solved, resultants
from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.cams import rubbing
from tmm_report.mechanics.lever.cams.rubbing import Contact
from tmm_report.mechanics.lever.cycle import larger
from tmm_report.mechanics.lever.extremes import peaks
from tmm_report.mechanics.lever.forces import reactions_with_friction
from tmm_report.mechanics.lever.forces.reactions_with_friction import Rub, Rubbed
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any
STILL = 1e-9  # of the greatest relative rate of all pairs of the kind, below which two links stand still


@dataclass(frozen=True, eq=False)
class Loss:
    """A pair with friction in its reaction: `reaction` of `links[0]` on `links[1]`, complex N (of a guide the part
    normal to it); `pressing`: N, of a slider that tilts the sum of both its ends; `power`: W; `couple`: moment of a
    guide about the middle of a slider of stated length, N m, None of all else; (..., P)."""

    pair: Pair
    reaction: Array
    pressing: Array
    power: Array
    couple: Array | None = None


@dataclass(frozen=True, eq=False)
class Corrected:
    """At one set of positions: `pairs` in the order of the structure; `without`: balancing moment without friction;
    `first`: with the power of friction of the reactions without it; `moment`: of the force analysis with friction, N m;
    `steps`: of Newton's method."""

    pairs: tuple[Loss, ...]
    without: Array
    first: Array
    moment: Array
    omega: float
    steps: int

    @cached_property
    def lost(self) -> Array:
        """Power of friction in all pairs, W."""
        return np.sum([loss.power for loss in self.pairs], axis=0) + np.zeros_like(self.without)

    @cached_property
    def balanced(self) -> Array:
        """The balancing moment by the power balance with friction, N m."""
        return self.without + self.lost / self.omega

    @cached_property
    def driving(self) -> Array:
        return np.abs(self.without * self.omega)

    @cached_property
    def efficiency(self) -> Array:
        with np.errstate(invalid="ignore", divide="ignore"):
            return self.driving / (self.driving + self.lost)

    @cached_property
    def disagreement(self) -> Array:
        """Of both ways to the moment, by the largest moment of the positions."""
        largest = np.nanmax(np.abs(self.moment), initial=0.0)
        return np.abs(self.moment - self.balanced) / (largest or 1.0)


@dataclass(frozen=True, eq=False)
class Correction:
    """At the table positions 0..N, at the diagram positions and, on `panels`, over the whole cycle; None where it is
    known at these positions alone."""

    table: Corrected
    diagram: Corrected
    panels: Panels | None = None
    whole: Corrected | None = None
    partial: bool = False  # a mechanism that makes no cycle has no means

    @cached_property
    def worst(self) -> float:
        return float(max(np.nanmax(one.disagreement, initial=0.0) for one in (self.table, self.diagram)))

    @cached_property
    def mean_power(self) -> float:
        return self._mean(lambda one: one.lost)

    @cached_property
    def mean_efficiency(self) -> float:
        driving = self._mean(lambda one: one.driving)
        return driving / (driving + self.mean_power) if driving > 0 else float("nan")

    @cached_property
    def growth(self) -> float:
        """The largest balancing moment with friction to the largest without."""
        one, other = self._largest(lambda one: one.moment), self._largest(lambda one: one.without)
        return float(one / other) if other > 0 else float("nan")

    def _mean(self, of: Callable[[Corrected], Array]) -> float:
        """Over the whole cycle; of the diagram positions where it is not known."""
        if self.partial:
            return float("nan")
        if self.panels is None or self.whole is None:
            return float(np.nanmean(of(self.diagram)[:-1]))
        return float(self.panels.mean(of(self.whole).reshape(self.panels.shape)))

    def _largest(self, of: Callable[[Corrected], Array]) -> float:
        """Magnitude, over the whole cycle; of the diagram positions where it is not known."""
        if self.panels is None or self.whole is None:
            return float(np.nanmax(np.abs(of(self.diagram))))
        values = np.broadcast_to(of(self.whole), self.panels.x.size).reshape(1, *self.panels.shape)
        return abs(larger(peaks(self.panels, values)[0]).value)


def solve(
    given: Friction,
    found: Kinetostatics,
    first: tuple[Array, Array],
    panels: Panels | None,
    whole: Corrected | None,
) -> Correction:
    """`first`: power of friction without correction at the table and the diagram
    positions; `panels`, `whole`: the whole cycle, by `between`. Raises ProblemError where the mechanism jams."""
    table, diagram = (
        _corrected(given, found, solved, power)
        for solved, power in zip((found.table, found.diagram), first, strict=True)
    )
    if not any(np.nanmax(loss.pressing, initial=0.0) > 0 for loss in diagram.pairs):
        raise ProblemError([_idle()])
    return Correction(table, diagram, panels, whole, bool(found.kinematics.gaps))


def between(given: Friction, found: Kinetostatics, over: Over, first: Array) -> Corrected | None:
    """Over the whole cycle; None where it jams between the positions, as it does close beside a change point, of
    whose two ways none is without great reactions."""
    try:
        return _corrected(given, found, over, first)
    except ProblemError:
        return None


def _corrected(given: Friction, found: Kinetostatics, solved: Solved | Over, first: Array) -> Corrected:
    motion = solved.motion
    pairs = sliding_pairs(motion.linkage.structure)
    rates = {pair.key: reactions_with_friction.signed_rate(motion, pair) for pair in pairs}
    senses = _senses(pairs, rates)
    rubs = [
        _rub(pair, stated, senses[pair.key], rates[pair.key])
        for pair in pairs
        if (stated := rubbing_of(given, pair))
    ]
    touched = list(_touched(given, motion))
    if not rubs and not touched:
        raise ProblemError([_idle()])
    every = [*rubs, *(one for _, one in touched)]
    rubbed = reactions_with_friction.solve(motion, resultants(found.given, motion, solved.loading), every)
    if rubbed.jammed.any():
        raise ProblemError([_jams(rubbed, solved.turned)])
    omega = float(motion.state.w[motion.linkage.mechanism.driver.link])
    losses = (*_losses(rubs, rubbed, rates), *_contact_losses(touched, motion, rubbed))
    moment = np.broadcast_to(rubbed.statics.balancing, motion.shape)
    without = np.broadcast_to(solved.statics.balancing, motion.shape)
    return Corrected(losses, without, without + first / omega, moment, omega, rubbed.steps)


def _senses(pairs: Sequence[Pair], rates: Mapping[str, Array]) -> dict[str, Array]:
    """Of the relative motion in each pair; 0 where its links stand still: for a moment, or all the time as two links
    that both move without turning, whose rate is noise."""
    greatest = {kind: [np.abs(rates[p.key]).ravel() for p in pairs if p.kind == kind] for kind in ("R", "P")}
    least = {kind: STILL * np.nanmax(np.concatenate([np.zeros(1), *of])) for kind, of in greatest.items()}
    return {p.key: np.where(np.abs(rates[p.key]) <= least[p.kind], 0.0, np.sign(rates[p.key])) for p in pairs}


def _rub(pair: Pair, stated: Rubbing, sense: Array, rate: Array) -> Rub:
    arm = stated.arm(pair.kind)
    coefficient = stated.at(arm * rate)
    return Rub(pair, coefficient, sense, arm, stated.half if pair.kind == "P" else None)


def _losses(rubs: Sequence[Rub], rubbed: Rubbed, rates: Mapping[str, Array]) -> list[Loss]:
    """The power that friction takes is that of what it does against the relative motion."""
    reactions = rubbed.statics.reactions
    return [
        Loss(
            rub.pair,
            reactions[rub.pair.key].force,
            rubbed.pressing[rub.pair.key],
            -rubbed.friction[rub.pair.key] * rates[rub.pair.key],
            reactions[rub.pair.key].moment if rub.half else None,
        )
        for rub in rubs
    ]


def _touched(given: Friction, motion: Motion) -> Iterator[tuple[Contact, Rub]]:
    """The cam pairs that rub."""
    for contact in rubbing.contacts(motion.linkage.structure):
        if stated := contact_of(given, contact):
            arm = stated.arm(contact.pair.kind)
            coefficient = stated.at(arm * rubbing.rate(contact, motion))
            yield contact, rubbing.rub(contact, motion, coefficient, arm)


def _contact_losses(touched: Sequence[tuple[Contact, Rub]], motion: Motion, rubbed: Rubbed) -> Iterator[Loss]:
    """A roller's pin bears the whole force of the contact; a face is pressed by what is normal to it."""
    for contact, made in touched:
        own = rubbed.statics.reactions[contact.presses.key]
        sign = 1 if own.pair.links[1] == contact.cam.follower else -1
        size = rubbed.pressing[own.pair.key]
        on_follower = sign * own.force + size * rubbing.across(contact, made)
        presses = np.abs(on_follower) if contact.rolls else size
        power = -rubbed.friction[own.pair.key] * rubbing.rate(contact, motion)
        told = sign if contact.rolls else 1
        yield Loss(contact.pair, told * on_follower, presses, power)


def _idle() -> Problem:
    text = N_("no force presses a pair whose friction is stated, so there is nothing to correct")
    right = Message(N_("state friction of pairs that the mechanism has, and forces, masses or gravity"))
    return mistake(text, ("friction", "corrected"), right)


def _jams(rubbed: Rubbed, turned: Array) -> Problem:
    """Names the worst position."""
    worst = int(np.argmin(rubbed.borne))
    text = N_(
        "the mechanism jams where the driving link has turned by %(angle)s°: friction grows with the reactions faster "
        "than any driving moment overcomes it; it moves with %(part)s of the stated friction at most"
    )
    right = Message(N_("take smaller coefficients or journals, or longer guides"))
    angle, part = f"{np.degrees(turned[worst]):.4g}", f"{rubbed.borne[worst]:.2f}"
    return mistake(text, ("friction",), right, angle=angle, part=part)
