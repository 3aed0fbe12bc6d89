"""A cam and its follower: the law over the turn, the pressure angle, the profile of the cam; of a cam that stands alone
and of the pairs of a lever mechanism alike.

Source: Artobolevsky, Theory of mechanisms and machines, ch. 26; Frolov (ed.), Theory of mechanisms, ch. 15.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tmm_report.chapters.cams.cam.solve.lifting import (
    FINE,
    Lifted,
    drawn_at,
    lifted,
    lowest,
    searched,
    side_of,
)
from tmm_report.chapters.cams.cam.solve.turn import BEFORE, Turn
from tmm_report.mechanics.cams.arcs import ArcLaw
from tmm_report.mechanics.cams.cam import ByLaw, Cam, Sliding
from tmm_report.mechanics.cams.extremes import Extreme, greatest
from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Kind, Phase, Phases
from tmm_report.mechanics.cams.shapes import Graph, Laid, Shape
from tmm_report.mechanics.cams.sizes.rules import Limits, roller_limits
from tmm_report.mechanics.cams.sizes.searched import greatest_at
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.cams.cam.solve.making import Making

Array = Any
Ends = tuple[Extreme, Extreme]
BELOW = 1e-3  # of the lift: a spline that goes below its table by less does not
STILL = 1e-6  # of the cam: so near its axis a centre of curvature is on it
FLAT = 1e3  # of the cam: what has a greater radius of curvature is not hollow
EQUAL = 1e-9  # of a size: two that differ by less are one
KINDS: tuple[Kind, Kind] = ("rise", "return")
SHOCK = 1e-6  # of the largest: a derivative that differs by less on both sides of a break does not jump


@dataclass(frozen=True)
class Sample:
    """A table position of which a law is written out: the phase it is in, how far, rad, and that as a share of it."""

    position: int
    phase: Phase
    within: float
    share: float


@dataclass(frozen=True)
class PieceOf:
    """A piece of the graph of acceleration by which a phase, counted from 0, goes."""

    phase: int
    laid: Laid


@dataclass(frozen=True)
class Shock:
    """At an angle turned, rad, the first or the second derivative of the displacement jumps, by so much. It is `hard`
    where the first one does: the acceleration there is without bound."""

    turned: float
    first: float
    second: float
    hard: bool


@dataclass(frozen=True, eq=False)
class Divided:
    """A phase, counted from 0, at the ends of its equal parts."""

    phase: int
    lifted: Lifted


@dataclass(frozen=True, eq=False)
class CamFound:
    """Found of one cam pair; `letters`: names of the cam's axis and of the pivot of a follower that swings.

    `rise`, `back`: the greatest pressure angles of the rises and of the returns, rad;
    `least`: least radius of curvature where the profile is convex, m; `ends`: least and greatest displacement and
    derivatives, m or rad; `low`: the coordinate from which displacements count, times its sense."""

    cam: Cam
    turn: Turn
    letters: tuple[str, str]
    low: float
    table: Lifted
    diagram: Lifted
    rise: Extreme
    back: Extreme
    least: Extreme
    ends: tuple[Ends, Ends, Ends]
    shaft: float | None = None  # diameter of the cam's, m
    groove: bool = False  # whether the roller runs between two walls

    def at(self, turned: Array) -> Lifted:
        """At angles turned from position 0, rad."""
        return lifted(self.cam, self.turn, turned, self.low)

    @cached_property
    def drawn(self) -> Lifted:
        """At the angles at which its curves are drawn."""
        return self.at(drawn_at(self.turn))

    @cached_property
    def shocks(self) -> tuple[Shock, ...]:
        """Where the law of phases has shocks."""
        if not self.phases:
            return ()
        turned = self.turn.breaks
        after, before = self.at(turned), self.at(np.mod(turned - BEFORE, FULL_TURN))
        first, second = after.first - before.first, after.second - before.second
        largest = [max(abs(end.value) for end in ends) for ends in self.ends[1:]]
        hard, soft = np.abs(first) > SHOCK * largest[0], np.abs(second) > SHOCK * largest[1]
        return tuple(
            Shock(float(turned[k]), float(first[k]) if hard[k] else 0.0, float(second[k]), bool(hard[k]))
            for k in np.flatnonzero(hard | soft)
        )

    @property
    def slides(self) -> bool:
        return isinstance(self.cam.motion, Sliding)

    @property
    def sense(self) -> int:
        return self.turn.sense

    @property
    def law(self) -> ByLaw | None:
        """The stated law; None where the profile is stated."""
        return self.cam.given if isinstance(self.cam.given, ByLaw) else None

    @property
    def pieced(self) -> ArcLaw | None:
        """The law of a cam of base circle, flanks and nose."""
        return self.law.law if self.law and isinstance(self.law.law, ArcLaw) else None

    @property
    def phases(self) -> tuple[Phase, ...]:
        return self.law.law.phases if self.law and isinstance(self.law.law, Phases) else ()

    @cached_property
    def samples(self) -> tuple[Sample, ...]:
        """The first table position of every law of a rise and of a return that is strictly within its phase."""
        found: dict[tuple[str, Shape | None], Sample] = {}
        for position, turned in enumerate(self.table.turned):
            sample = self._sample(position, float(turned))
            if sample is not None:
                found.setdefault((sample.phase.kind, sample.phase.law), sample)
        return tuple(found.values())

    def _sample(self, position: int, turned: float) -> Sample | None:
        if not self.phases or self.law is None:
            return None
        edges = np.cumsum([0.0, *(phase.angle for phase in self.phases)])
        theta = float(np.mod(self.law.theta(self.phi(turned)), FULL_TURN))
        k = min(int(np.searchsorted(edges, theta, side="right")) - 1, len(self.phases) - 1)
        phase, within = self.phases[k], theta - float(edges[k])
        share = within / phase.angle
        if phase.law is None:
            return None
        inside = min(abs(share - one) for one in (0.0, 1.0, *phase.law.breaks)) > 1e-6
        return Sample(position, phase, within, share) if inside else None

    @cached_property
    def pieces(self) -> tuple[PieceOf, ...]:
        """Of all phases that go by a graph."""
        return tuple(
            PieceOf(k, laid)
            for k, phase in enumerate(self.phases)
            if isinstance(phase.law, Graph)
            for laid in phase.law.laid
        )

    def number_of(self, sample: Sample) -> int:
        """The piece, among `pieces`, in which a sample is."""
        assert isinstance(sample.phase.law, Graph)
        first = next(k for k, one in enumerate(self.pieces) if self.phases[one.phase] is sample.phase)
        return first + sample.phase.law.piece_at(sample.share)

    @property
    def alike(self) -> bool:
        """Whether a swinging follower rises in the sense in which the cam turns."""
        return side_of(self.cam) * self.sense > 0

    @property
    def start(self) -> float:
        """Of a follower that slides its lowest distance from the foot of the perpendicular from the cam's axis, m; of
        one that swings the lowest angle between its arm and the line of the pivots, rad."""
        if self.slides:
            return self.low
        towards = side_of(self.cam) * float(np.angle(-self.pivot))
        return float(np.mod(self.low - towards + np.pi, FULL_TURN) - np.pi)

    def phi(self, turned: Array) -> Array:
        """Angles of the cam's x axis."""
        return self.turn.phi(turned)

    @property
    def pivot(self) -> complex:
        """Of a swinging follower's pivot from the cam's axis, m."""
        return complex(getattr(self.cam.motion, "pivot", 0j))

    @cached_property
    def resting(self) -> tuple[int, ...]:
        """Table positions in which the follower dwells and the centre of curvature is on the axis of the cam."""
        away = np.abs(self.cam.contact(self.phi(self.table.turned)).centre)
        resting = np.flatnonzero(away < STILL * self.cam.size)
        return tuple(int(k) for k in resting if k < self.turn.distinct)

    @property
    def below(self) -> bool:
        """Whether a law stated by a table goes below the base circle between its angles."""
        low, high = self.ends[0]
        return self.law is not None and not self.phases and low.value < -BELOW * high.value

    @cached_property
    def roller_limits(self) -> Limits | None:
        """By the rules of guides; None without a roller, and of a profile that is nowhere convex."""
        if not self.cam.roller or not np.isfinite(self.least.value):
            return None
        hollow = np.inf if self.hollow is None else self.hollow.value
        return roller_limits(self.pitch_base, self.least.value + self.cam.roller, hollow)

    @cached_property
    def hollow(self) -> Extreme | None:
        """In a groove the least radius of curvature of the pitch curve where it is concave, m, which its outer wall
        follows; None where it is nowhere."""
        if not self.groove:
            return None

        def deep(turned: Array) -> Array:
            radius = self.cam.contact(self.phi(turned)).radius
            return np.where(radius < 0, radius, -np.inf)[None]

        (found,) = greatest(deep, searched(self.turn))
        return Extreme(-found.value, found.turned) if -found.value < FLAT * self.cam.size else None

    @cached_property
    def jerk(self) -> Extreme | None:
        """The greatest size of the third derivative of the displacement within the pieces of a law by phases, m or rad,
        at an angle turned, rad."""
        law = self.law
        if law is None or not isinstance(law.law, Phases):
            return None
        third = law.law.third
        found = greatest_at(law.law, lambda theta: np.abs(third(theta)))
        return Extreme(found.b, float(np.mod(found.theta - self._begins, FULL_TURN)))

    @property
    def exceeds(self) -> bool:
        """Whether the pressure angle of a rise is above the limit."""
        return self.rise.value > self.cam.limit + 1e-9

    @property
    def exceeds_back(self) -> bool:
        """Whether that of a return is above its limit."""
        return self.cam.back is not None and self.back.value > self.cam.back + 1e-9

    @property
    def pitch_base(self) -> float:
        """Least radius of the pitch curve; of an edge or a flat face that of the profile, m."""
        return self.cam.base + (self.cam.roller or 0.0)

    @property
    def offset(self) -> float:
        """Of a sliding follower, m, above zero where it lessens the pressure angle of a rise."""
        return float(self.sense * getattr(self.cam.motion, "offset", 0.0))

    @property
    def lift(self) -> float:
        """Greatest displacement, m or rad: that of the law's phases, else what is reached."""
        if self.law is not None and isinstance(self.law.law, Phases):
            return self.law.law.lift
        return self.ends[0][1].value

    @cached_property
    def leaning(self) -> dict[Kind, Ends]:
        """Of the rises and of the returns the least and the greatest pressure angle with its sign, both ends of a phase
        counted as it has them; of a law by phases."""
        found: dict[Kind, list[Ends]] = {}
        for k, phase in enumerate(self.phases):
            if phase.law is not None:
                found.setdefault(phase.kind, []).append(
                    self._over(k, lambda own, phi: self.sense * own.pressure(phi))
                )
        return {
            kind: (min((low for low, _ in ends), key=_value), max((high for _, high in ends), key=_value))
            for kind, ends in found.items()
        }

    @cached_property
    def moving(self) -> Extreme | None:
        """The least radius of curvature of the profile where it is convex and the follower moves, m; None where
        there is none."""

        def convex(own: Cam, phi: Array) -> Array:
            radius = own.own_radius(phi)
            return np.where(radius > 0, radius, np.inf)

        ends = [self._over(k, convex)[0] for k, phase in enumerate(self.phases) if phase.law is not None]
        least = min(ends, key=_value, default=None)
        return least if least is not None and np.isfinite(least.value) else None

    def _over(self, k: int, of: Callable[[Cam, Array], Array]) -> Ends:
        """The least and the greatest over phase `k`, of a function of the cam as the phase has it and of the angle of
        its x axis."""
        own, law = self._within(k)
        assert isinstance(law.law, Phases)
        low, high = law.law.edges[k], law.law.edges[k + 1]
        inside = [theta for theta in law.law.breaks if low < theta < high]
        fine = np.unique(np.concatenate([np.linspace(low, high, FINE // 4), inside]))

        def both(theta: Array) -> Array:
            values = of(own, law.start + law.sense * theta)
            return np.array([-values, values])

        least, most = greatest(both, fine)
        return tuple(  # type: ignore[return-value]
            Extreme(sign * one.value, float(np.mod(one.turned - self._begins, FULL_TURN)))
            for sign, one in ((-1, least), (1, most))
        )

    def _within(self, k: int) -> tuple[Cam, ByLaw]:
        """The cam with its law as phase `k` has it, and the law."""
        law = self.law
        assert law is not None and isinstance(law.law, Phases)
        return replace(self.cam, given=replace(law, law=law.law.within(k))), law

    @property
    def _begins(self) -> float:
        """The angle of the law in position 0, rad."""
        return float(self.law.theta(self.phi(0.0))) if self.law else 0.0

    @cached_property
    def divided(self) -> tuple[Divided, ...]:
        """The phases that are to be divided into equal parts, at the ends of these."""
        return tuple(self._divided(k, phase) for k, phase in enumerate(self.phases) if phase.parts)

    def _divided(self, k: int, phase: Phase) -> Divided:
        own, law = self._within(k)
        assert isinstance(law.law, Phases)
        turned = law.law.edges[k] + np.linspace(0.0, phase.angle, phase.parts + 1) - self._begins
        return Divided(k, lifted(own, self.turn, turned, self.low))

    @cached_property
    def face(self) -> Ends:
        """Of a flat face the outermost contacts along it, m from the follower's point; of one that swings from its
        pivot."""

        def along(turned: Array) -> Array:
            phi = self.phi(turned)
            q, b = self.cam.moved(phi)
            at = self.cam.touched(q, b).at - (b.z if self.slides else self.pivot)
            place = np.real(at * np.conj(self.cam.turn(q.z) * self.cam.face))
            return np.array([-place, place])

        least, most = greatest(along, searched(self.turn))
        return Extreme(-least.value, least.turned), most

    @property
    def alone(self) -> bool:
        """Whether it is no part of a lever mechanism: its numbers need no name then."""
        return not self.cam.name


@dataclass(frozen=True, eq=False)
class Cams:
    """What is found of cams that turn together; `made`: of one that stands alone, how it is made."""

    cams: tuple[CamFound, ...]
    made: tuple[Making, ...] = ()


class Sampled(NamedTuple):
    """The cam pairs of a lever mechanism, and the table position of which formulas are written out."""

    found: Cams
    sample: int


def _value(end: Extreme) -> float:
    return end.value


def pair(cam: Cam, turn: Turn, letters: tuple[str, str]) -> CamFound:
    """What is found of one pair over a turn of its cam."""
    low = lowest(cam, turn)
    table, diagram = (lifted(cam, turn, x, low) for x in (turn.table, turn.diagram))
    found = CamFound(cam, turn, letters, low, table, diagram, *_extremes(cam, turn, low))
    if turn.sweep < FULL_TURN - BEFORE or not found.leaning:
        return found
    rise, back = (_largest(found.leaning[kind]) for kind in KINDS)
    return replace(found, rise=rise, back=back)  # the ends of the phases counted


def _largest(ends: Ends) -> Extreme:
    """The one of the larger size, without its sign; of equal ones the first."""
    least, most = ends
    first, second = sorted((Extreme(-least.value, least.turned), most), key=lambda end: end.turned)
    return second if second.value > first.value * (1 + EQUAL) else first


def _extremes(cam: Cam, turn: Turn, low: float) -> tuple[Extreme, Extreme, Extreme, tuple[Ends, Ends, Ends]]:
    """The greatest pressure angles of the rises and of the returns, the least radius of curvature, the ends of the
    displacement and of its derivatives."""

    def of(turned: Array) -> Array:
        here = lifted(cam, turn, turned, low)
        angle, rate = np.abs(here.alpha), here.first
        moves = 1e-9 * (cam.size if isinstance(cam.motion, Sliding) else 1.0)
        rising, falling = np.where(rate > moves, angle, 0.0), np.where(rate < -moves, angle, 0.0)
        convex = np.where(here.curvature > 0, -here.curvature, -np.inf)
        moved = (here.S, here.first, here.second)
        return np.array([rising, falling, convex, *(way * x for x in moved for way in (-1, 1))])

    rise, back, sharp, *ends = greatest(of, searched(turn))
    S, first, second = (
        (Extreme(-least.value, least.turned), most) for least, most in zip(ends[::2], ends[1::2], strict=True)
    )
    return rise, back, Extreme(-sharp.value, sharp.turned), (S, first, second)
