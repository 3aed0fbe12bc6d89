"""Chapter 3, friction: power lost in every pair and the instantaneous efficiency.

Pivots f R (d/2) |ω_rel|, guides f N |v_rel| (Frolov (ed.), Theory of mechanisms, ch. 7), N by `rubbing.pressing`; the
reactions are those without friction, as the course takes them. `corrected` finds them with friction, where that is
asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.friction import corrected
from tmm_report.chapters.lever.friction.given import Friction, Rubbing
from tmm_report.chapters.lever.friction.rubbed import contact_of, rubbing_of, sliding_pairs
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Over, cut_at
from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.assur_groups import Pair, Structure
from tmm_report.mechanics.lever.cams.rubbing import Contact, contacts, normal_force
from tmm_report.mechanics.lever.cams.rubbing import rate as rate_of_contact
from tmm_report.mechanics.lever.extremes import refined
from tmm_report.mechanics.lever.forces.reactions import Reaction, Statics
from tmm_report.mechanics.lever.forces.reactions_with_friction import pressing, relative_rate
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

__all__ = ["FrictionFound", "Losses", "PairLoss", "rubbing_of", "solve"]

Array = Any
NOTHING = 1e-12  # of the largest reaction: a force below it is rounding
CUTS = 3  # how often panels are cut at most
APART = 1e-6  # of the period: kinks nearer than this are one


@dataclass(frozen=True, eq=False)
class PairLoss:
    """Friction in one pair at some positions: `reaction` N, `rate` the relative rad/s or m/s, `power` W; `pressing`: N,
    of a slider that tilts the sum of both its ends; `coefficient`: of friction, `sliding`: m/s; `couple`: size of the
    moment of a guide about the middle of a slider of stated length, N m, None of all else; (..., P)."""

    pair: Pair
    rubbing: Rubbing
    reaction: Array
    rate: Array
    power: Array
    pressing: Array
    coefficient: Array
    sliding: Array
    couple: Array | None = None
    contact: Contact | None = None  # of a cam pair


@dataclass(frozen=True, eq=False)
class Losses:
    """Losses of all pairs. `driving`: |M_bal ω1|, W; `efficiency`: driving / (driving + total), 0..1; `reduced`: moment
    of all the friction reduced to the driving link, N m. Where a slider or a cylinder drives, `speed` is that of its
    stroke, m/s, `driving` the power of the force along it, `reduced` a force, N, nan where it stands, and `omega` the
    rate of the phase."""

    pairs: tuple[PairLoss, ...]
    driving: Array
    omega: float
    speed: Array = None

    @cached_property
    def total(self) -> Array:
        return np.sum([loss.power for loss in self.pairs], axis=0) + np.zeros_like(self.driving)

    @cached_property
    def efficiency(self) -> Array:
        with np.errstate(invalid="ignore", divide="ignore"):
            return self.driving / (self.driving + self.total)

    @cached_property
    def reduced(self) -> Array:
        if self.speed is None:
            return self.total / abs(self.omega)
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.where(self.speed == 0, np.nan, self.total / np.abs(self.speed))


Whole = tuple[Over, Losses]


@dataclass(frozen=True, eq=False)
class Reduced:
    """Moment of all the friction reduced to the driving link over the whole cycle, against the rotation: `moment`
    (K, n), N m, at the points of `panels`, at the stated speed; `corrected`: by the reactions with friction."""

    panels: Panels
    moment: Array
    corrected: bool


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
    known: Whole | None = None  # where it was found with the correction

    @cached_property
    def whole(self) -> Whole | None:
        """Over the whole cycle, cut where the losses have kinks; None where some position has no forces."""
        return self.known or _whole(self.given, self.forces)

    @cached_property
    def reduced(self) -> Reduced | None:
        """Over the whole cycle; None where some position has no forces, or the cycle does not close."""
        return _reduced(self.whole, self.corrected.whole if self.corrected else None)

    @cached_property
    def unloaded(self) -> Reduced | None:
        """The same where the stated forces and moments do not act."""
        forces = replace(self.forces, given=replace(self.forces.given, forces=(), moments=()))
        whole = _whole(self.given, forces)
        again = _between(self.given, forces, whole) if self.given.corrected else None
        return _reduced(whole, again)

    @cached_property
    def mean_power(self) -> float:
        """Mean friction power over the cycle, W."""
        return self._mean(lambda losses: losses.total)

    @cached_property
    def mean_efficiency(self) -> float:
        """Efficiency over the cycle: mean driving power to the sum of the means."""
        driving = self._mean(lambda losses: losses.driving)
        return driving / (driving + self.mean_power) if driving > 0 else float("nan")

    @cached_property
    def work(self) -> float:
        """That friction takes over the cycle, J."""
        return self.mean_power * self.forces.kinematics.cycle.period / abs(self.table.omega)

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
    found = FrictionFound(given, table.turned, diagram.turned, at_table, at_diagram, kinetostatics)
    if not given.corrected:
        return found
    whole = _whole(given, kinetostatics)
    again = _corrected(given, kinetostatics, at_table, at_diagram, whole)
    return replace(found, corrected=again, known=whole)


def _whole(given: Friction, kinetostatics: Kinetostatics) -> Whole | None:
    """Over the cycle, with edges where two links stop to turn or to slide on one another, where a slider changes the
    face on which it is pressed or begins to tilt, and where the balancing moment passes through zero: the losses have
    kinks there."""
    over = kinetostatics.over
    if over is None:
        return None
    rates = [relative_rate(over.motion, pair) for pair in sliding_pairs(_structure(over.motion))]
    known = [over.on(rate) for rate in rates if np.any(rate)]
    reactions = over.statics.reactions.values()
    least = NOTHING * max(np.abs(one.force).max() for one in reactions)
    faces = (over.on(of) for reaction in reactions for of in _faces(given, reaction))
    # what is rounding passes through zero wherever it likes
    known += [np.where(np.abs(of) > least, of, 0.0) for of in faces]
    known += [
        over.on(normal_force(one, over.motion, over.statics)) for one in contacts(_structure(over.motion))
    ]
    known += [over.on(of) for of in _resolving(given, over.motion)]
    drives = over.balancing if over.statics.driving is None else over.on(over.statics.driving)
    kinks = np.concatenate(over.panels.roots_of(np.stack([*known, drives])))
    cuts = _apart(over.panels, kinks)
    for _ in range(CUTS):
        over = cut_at(over, cuts, kinetostatics.given, kinetostatics.kinematics)
        if over is None:
            return None
        losses = _losses(given, over.motion, over.statics)
        total = over.on(losses.total)
        # the size of a reaction that comes near to nothing is no polynomial where its components are
        finer = refined(over.panels, total[None], np.abs(total).max(keepdims=True)[0])
        if finer is over.panels:
            break
        cuts = finer.edges
    return over, losses


def _reduced(whole: Whole | None, again: corrected.Corrected | None) -> Reduced | None:
    """`again`: the same with friction in the reactions, where that is asked for and known between the positions."""
    if whole is None or not whole[0].closed:
        return None
    over, losses = whole
    total = losses.total if again is None else again.lost
    return Reduced(over.panels, over.on(total) / abs(losses.omega), again is not None)


def _corrected(
    given: Friction, kinetostatics: Kinetostatics, table: Losses, diagram: Losses, whole: Whole | None
) -> corrected.Correction:
    first, between = (table.total, diagram.total), _between(given, kinetostatics, whole)
    panels = whole[0].panels if whole is not None else None
    return corrected.solve(given, kinetostatics, first, panels, between)


def _between(given: Friction, forces: Kinetostatics, whole: Whole | None) -> corrected.Corrected | None:
    """With friction in the reactions over the whole cycle; None where it is not known."""
    if whole is None:
        return None
    return corrected.between(given, forces, whole[0], whole[1].total)


def _apart(panels: Panels, kinks: Array) -> Array:
    """Kinks without those that rounding has moved off an edge or off one another: on the sliver of a panel between them
    a derivative would be rounding."""
    near, kept = APART * panels.period, list[float]()
    for kink in np.sort(kinks):
        if np.min(np.abs(panels.edges - kink)) > near and (not kept or kink - kept[-1] > near):
            kept.append(float(kink))
    return np.array(kept)


def _faces(given: Friction, reaction: Reaction) -> Iterator[Array]:
    """What passes through zero of a guide with friction where the force that presses it has a kink."""
    rubbing = rubbing_of(given, reaction.pair)
    if rubbing is None or reaction.pair.kind != "P":
        return
    normal = cross(reaction.along, reaction.force)
    yield normal
    if rubbing.half:
        couple = reaction.moment / rubbing.half
        yield from (couple, normal - couple, normal + couple)


def _resolving(given: Friction, motion: Motion) -> Iterator[Array]:
    """What passes through zero where the coefficient of a pair, a law of its sliding, has a corner or bends much."""
    for pair in motion.linkage.structure.pairs:
        rubbing = rubbing_of(given, pair)
        if rubbing is None or rubbing.law is None:
            continue
        sliding = rubbing.arm(pair.kind) * relative_rate(motion, pair)
        for at in rubbing.law.resolving:
            for side in (at, -at):
                off = sliding - side
                yield np.where(np.abs(off) > NOTHING * at, off, 0.0)  # of a constant velocity it is rounding


def _losses(given: Friction, motion: Motion, statics: Statics) -> Losses:
    losses = []
    structure = _structure(motion)
    rubs = {pair.key for pair in sliding_pairs(structure)}
    for reaction in statics.reactions.values():
        rubbing = rubbing_of(given, reaction.pair) if reaction.pair.key in rubs else None
        if rubbing is not None:
            size = np.abs(_wide(reaction.force, motion.shape))
            presses = _wide(pressing(reaction, rubbing.half), motion.shape)
            rate = np.abs(relative_rate(motion, reaction.pair))
            arm = rubbing.arm(reaction.pair.kind)
            sliding = arm * rate
            coefficient = rubbing.at(sliding)
            power = coefficient * presses * arm * rate
            couple = np.abs(_wide(reaction.moment, motion.shape)) if rubbing.half else None
            every = np.broadcast_to(coefficient, motion.shape)
            losses.append(
                PairLoss(reaction.pair, rubbing, size, rate, power, presses, every, sliding, couple)
            )
    order = [pair.key for pair in structure.pairs]
    losses.sort(key=lambda loss: order.index(loss.pair.key))
    losses += _contact_losses(given, motion, statics)
    stroke = motion.linkage.mechanism.driver.stroke
    if stroke is None:
        omega = float(motion.omega)
        return Losses(tuple(losses), np.abs(_wide(statics.balancing, motion.shape) * omega), omega)
    speed = stroke.law.of_phase(motion.phase)[1]
    phase = float(motion.linkage.mechanism.driver.omega)
    return Losses(tuple(losses), np.abs(_wide(statics.driving * speed, motion.shape)), phase, speed)


def _contact_losses(given: Friction, motion: Motion, statics: Statics) -> list[PairLoss]:
    """Those of the cam pairs."""
    losses = []
    for contact in contacts(_structure(motion)):
        if (rubbing := contact_of(given, contact)) is None:
            continue
        rate, arm = rate_of_contact(contact, motion), rubbing.arm(contact.pair.kind)
        size = np.abs(normal_force(contact, motion, statics))
        coefficient = np.broadcast_to(rubbing.at(arm * rate), motion.shape)
        power = coefficient * size * arm * rate
        losses.append(
            PairLoss(contact.pair, rubbing, size, rate, power, size, coefficient, arm * rate, contact=contact)
        )
    return losses


def _structure(motion: Motion) -> Structure:
    return motion.linkage.structure


def _wide(x: Array, shape: tuple[int, ...]) -> Array:
    """What is the same at all positions at each of them."""
    return x if np.shape(x) == shape else np.broadcast_to(x, shape)
