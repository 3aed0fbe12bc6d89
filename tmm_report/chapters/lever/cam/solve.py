"""Cam pairs of a lever mechanism: the follower's law over the cycle, the pressure angle, the profile of the cam.

Source: Artobolevsky, Theory of mechanisms and machines, ch. 26; Frolov (ed.), Theory of mechanisms, ch. 15.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.cam.lifting import (
    BEFORE,
    Lifted,
    breaks_of,
    drawn_at,
    greatest,
    lifted,
    lowest,
    searched,
    side_of,
)
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.mechanics.cams.cam import ByLaw, Cam, Sliding
from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Phase, Phases
from tmm_report.mechanics.cams.shapes import Graph, Laid, Shape
from tmm_report.mechanics.lever.cams.replacing_dyad import rests
from tmm_report.mechanics.lever.cycle import Extreme
from tmm_report.records import dataclass

Array = Any
Ends = tuple[Extreme, Extreme]
BELOW = 1e-3  # of the lift: a spline that goes below its table by less does not
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
class CamFound:
    """Found of one cam pair. `rise`, `back`: the greatest pressure angles of the rises and of the returns, rad;
    `least`: least radius of curvature where the profile is convex, m; `ends`: least and greatest displacement and
    derivatives, m or rad; `low`: the coordinate from which displacements count, times its sense."""

    cam: Cam
    kinematics: Kinematics
    low: float
    table: Lifted
    diagram: Lifted
    rise: Extreme
    back: Extreme
    least: Extreme
    ends: tuple[Ends, Ends, Ends]

    def at(self, turned: Array) -> Lifted:
        """At angles turned from position 0, rad."""
        return lifted(self.cam, self.kinematics, turned, self.low)

    @cached_property
    def drawn(self) -> Lifted:
        """At the angles at which its curves are drawn."""
        return self.at(drawn_at(self.kinematics))

    @cached_property
    def shocks(self) -> tuple[Shock, ...]:
        """Where the law of phases has shocks."""
        if not self.phases:
            return ()
        turned = breaks_of(self.kinematics)
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
        return self.kinematics.cycle.sense

    @property
    def law(self) -> ByLaw | None:
        """The stated law; None where the profile is stated."""
        return self.cam.given if isinstance(self.cam.given, ByLaw) else None

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
        return self.kinematics.cycle.phi(turned)

    @property
    def pivot(self) -> complex:
        """Of a swinging follower's pivot from the cam's axis, m."""
        return complex(getattr(self.cam.motion, "pivot", 0j))

    @cached_property
    def resting(self) -> tuple[int, ...]:
        """Table positions in which the follower dwells and the centre of curvature is on the axis of the cam."""
        resting = np.flatnonzero(rests(self.kinematics.table, self.cam))
        return tuple(int(k) for k in resting if k < self.kinematics.distinct)

    @property
    def below(self) -> bool:
        """Whether a law stated by a table goes below the base circle between its angles."""
        low, high = self.ends[0]
        return self.law is not None and not self.phases and low.value < -BELOW * high.value

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


@dataclass(frozen=True, eq=False)
class Cams:
    """Found by `solve`: one a cam pair."""

    cams: tuple[CamFound, ...]


def solve(kinematics: Kinematics) -> Cams | None:
    """None of a mechanism without cam pairs."""
    cams = kinematics.linkage.mechanism.cams
    return Cams(tuple(_solve(cam, kinematics) for cam in cams)) if cams else None


def _solve(cam: Cam, kinematics: Kinematics) -> CamFound:
    low = lowest(cam, kinematics)
    table, diagram = (lifted(cam, kinematics, x, low) for x in (kinematics.turned, kinematics.diagram_turned))
    return CamFound(cam, kinematics, low, table, diagram, *_extremes(cam, kinematics, low))


def _extremes(
    cam: Cam, kinematics: Kinematics, low: float
) -> tuple[Extreme, Extreme, Extreme, tuple[Ends, Ends, Ends]]:
    """The greatest pressure angles of the rises and of the returns, the least radius of curvature, the ends of the
    displacement and of its derivatives."""

    def of(turned: Array) -> Array:
        here = lifted(cam, kinematics, turned, low)
        angle, rate = np.abs(here.alpha), here.first
        moves = 1e-9 * (cam.size if isinstance(cam.motion, Sliding) else 1.0)
        rising, falling = np.where(rate > moves, angle, 0.0), np.where(rate < -moves, angle, 0.0)
        convex = np.where(here.curvature > 0, -here.curvature, -np.inf)
        moved = (here.S, here.first, here.second)
        return np.array([rising, falling, convex, *(way * x for x in moved for way in (-1, 1))])

    rise, back, sharp, *ends = greatest(of, searched(kinematics))
    S, first, second = (
        (Extreme(-least.value, least.turned), most) for least, most in zip(ends[::2], ends[1::2], strict=True)
    )
    return rise, back, Extreme(-sharp.value, sharp.turned), (S, first, second)
