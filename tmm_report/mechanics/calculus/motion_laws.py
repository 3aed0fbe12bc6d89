"""Laws of motion by the time: the angle of a driving link, rad, with both its derivatives.

    law          q(t)
    Harmonic     q₀ + v t + A sin(Ω t + α)
    Polynomial   c₀ + c₁ t + c₂ t² + …; with c₂ = ε/2 and no more, constant acceleration
    Tabulated    the cubic spline through stated points
    Phased       q₀ and what a cam's phases of rise, dwell and return lift
    Pieces       q₀ + v t, then stated accelerations one after another

A law is stated over one `period`; where it ends as it began, but for whole turns, it repeats. What a search over a
cycle needs of angles it asks of the phase θ = 2π t/T, which goes once round as the law does.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any, Protocol

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.roots import bracketed
from tmm_report.records import dataclass

Array = Any
Three = tuple[Array, Array, Array]  # an angle, rad, and its first two derivatives by the time
FULL_TURN = 2 * np.pi
SAME = 1e-9  # of a turn, or of the greatest speed: a law that ends as near as this to its beginning repeats
NEXT = 1e-9 / FULL_TURN  # of the period: a time as near as this before a break belongs to what follows it
SAMPLES = 1440  # steps of a period between which a law turns back once at most


class MotionLaw:
    """One law. `period`: s, over which it goes; `breaks`: times within it at which the acceleration may jump, s."""

    period: float
    breaks: tuple[float, ...] = ()

    def at(self, t: Array) -> Three:
        """At times from 0 to the period, (..., P), s."""
        raise NotImplementedError

    def of_phase(self, theta: Array) -> Three:
        """At phases θ = 2π t/T, rad: the angle and its derivatives by the time."""
        theta = np.asarray(theta, dtype=float)
        whole = np.floor(theta / FULL_TURN) if self.returns else 0.0 * theta
        # the end of the period itself belongs to it, but where it is the beginning again
        q, v, a = self.at((theta - whole * FULL_TURN) * (self.period / FULL_TURN))
        return q + whole * self.advance, v, a

    def moved(self, by: float) -> MotionLaw:
        """The same law about another place, m or rad."""
        raise NotImplementedError

    @cached_property
    def advance(self) -> float:
        """How far it goes on in a period, rad."""
        start, end = (float(self.at(np.array([t]))[0][0]) for t in (0.0, self.period))
        return end - start

    @cached_property
    def returns(self) -> bool:
        """Whether it ends as it began, but for whole turns, with the same speed."""
        ends = self.at(np.array([0.0, self.period]))[1]
        turns = self.advance / FULL_TURN
        return abs(turns - round(turns)) < SAME and abs(ends[1] - ends[0]) <= SAME * self.fastest

    @cached_property
    def fastest(self) -> float:
        """Greatest speed, rad/s."""
        return float(np.abs(self._sampled[1][1]).max())

    @cached_property
    def stops(self) -> Array:
        """Times at which it turns back, ascending, s."""
        t, (_, v, _) = self._sampled
        at = np.flatnonzero(v[:-1] * v[1:] < 0)
        found = bracketed(lambda x: self.at(x)[1], t[at], t[at + 1], v[at], np.zeros(1))[0] if at.size else []
        return distinct(np.concatenate([found, t[np.abs(v) <= 1e-12 * np.abs(v).max()]]))

    @cached_property
    def reach(self) -> tuple[float, float]:
        """Least and greatest angle, rad."""
        q = self.at(np.concatenate([self._sampled[0], self.stops]))[0]
        return float(q.min()), float(q.max())

    @cached_property
    def _sampled(self) -> tuple[Array, Three]:
        t = np.union1d(np.linspace(0.0, self.period, SAMPLES + 1), np.array(self.breaks))
        return t, self.at(t)

    def _crossings(self, level: Array, low: Array, high: Array, starts: Array) -> Array:
        """Times between `low` and `high` at which it comes to the `level`, below or above which it is at `low`."""
        return bracketed(lambda t: self.at(t)[0] - level, low, high, starts, np.zeros(1))[0]

    def times_at(self, place: float) -> Array:
        """Times, ascending, s, at which it comes to a place, m or rad; where it rests there, at the first."""
        t = np.union1d(self._sampled[0], self.stops)
        off = self.at(t)[0] - place
        off[np.abs(off) <= SAME * max(map(abs, self.reach))] = 0.0
        k = np.flatnonzero(off[:-1] * off[1:] < 0)
        found = self._crossings(np.full(k.size, place), t[k], t[k + 1], off[k]) if k.size else np.zeros(0)
        on = (off == 0) & np.concatenate([[True], off[:-1] != 0])
        return distinct(np.concatenate([found, t[on]]))

    def turned_by(self, angle: float) -> float:
        """When it has gone on by an angle, rad, from the beginning, s; nan of one that turns back, or does not come so
        far."""
        low, high = self.reach
        if high - low > abs(self.advance) + SAME * FULL_TURN:
            return math.nan
        start = float(self.at(np.zeros(1))[0][0])
        found = self.times_at(start + math.copysign(angle, self.advance))
        return float(found[0]) if len(found) else math.nan

    def when(self, angles: Sequence[float] | Array) -> Array:
        """Phases, ascending, rad, at which the link makes one of some angles, or that but for whole turns."""
        t = np.union1d(self._sampled[0], self.stops)
        q = self.at(t)[0]
        found: list[Array] = []
        for angle in np.ravel(angles):
            turns = (q - angle) / FULL_TURN
            on = np.floor(turns)
            k = np.flatnonzero(on[:-1] != on[1:])
            level = angle + FULL_TURN * np.maximum(on[k], on[k + 1])
            if k.size:
                found.append(self._crossings(level, t[k], t[k + 1], q[k] - level))
            found.append(t[:1][np.abs(turns[:1] - np.round(turns[:1])) < SAME])
        times = np.concatenate(found) if found else np.zeros(0)
        phases = times * (FULL_TURN / self.period)
        return distinct(np.mod(phases, FULL_TURN) if self.returns else phases)


@dataclass(frozen=True, eq=False)
class Harmonic(MotionLaw):
    """q₀ + v t + A sin(Ω t + α): rad, rad/s, rad, rad/s, rad. Its period is that of the harmonic, or so many `times`
    that as bring a whole number of turns."""

    start: float
    speed: float
    amplitude: float
    frequency: float
    lead: float = 0.0
    times: int = 1

    @property
    def period(self) -> float:  # type: ignore[override]
        return self.times * FULL_TURN / self.frequency

    def at(self, t: Array) -> Three:
        x, size = self.frequency * t + self.lead, self.amplitude
        return (
            self.start + self.speed * t + size * np.sin(x),
            self.speed + size * self.frequency * np.cos(x),
            -size * self.frequency**2 * np.sin(x),
        )

    def moved(self, by: float) -> Harmonic:
        return replace(self, start=self.start + by)


@dataclass(frozen=True, eq=False)
class Polynomial(MotionLaw):
    """Σ c_k t^k over a stated time: rad, rad/s, rad/s² …, the lowest power first."""

    coefficients: tuple[float, ...]
    period: float
    breaks: tuple[float, ...] = ()

    @property
    def uniform(self) -> bool:
        """Whether the acceleration is constant."""
        return len(self.coefficients) == 3

    def at(self, t: Array) -> Three:
        own = np.polynomial.Polynomial(self.coefficients)
        return own(t), own.deriv()(t), own.deriv(2)(t)

    def moved(self, by: float) -> Polynomial:
        start, *others = self.coefficients
        return replace(self, coefficients=(start + by, *others))


@dataclass(frozen=True, eq=False)
class Tabulated(MotionLaw):
    """The cubic spline through angles at ascending times from 0, s and rad: of a table that ends as it began, but for
    whole turns, the periodic one, else that without a kink beside either end. Source: de Boor, A practical guide to
    splines, ch. 4."""

    times: tuple[float, ...]
    angles: tuple[float, ...]

    @property
    def period(self) -> float:  # type: ignore[override]
        return self.times[-1]

    @property
    def breaks(self) -> tuple[float, ...]:  # type: ignore[override]
        return self.times[:-1]

    @cached_property
    def _spline(self) -> Any:
        from scipy.interpolate import CubicSpline  # loaded only for a driving link stated by a table

        t, q = np.array(self.times), np.array(self.angles)
        turns = (q[-1] - q[0]) / FULL_TURN
        if abs(turns - round(turns)) >= SAME:
            return CubicSpline(t, q), 0.0
        steady = (q[-1] - q[0]) / t[-1]
        even = q - steady * t
        even[-1] = even[0]
        return CubicSpline(t, even, bc_type="periodic"), steady

    def at(self, t: Array) -> Three:
        spline, steady = self._spline
        t = np.asarray(t, dtype=float)
        return spline(t) + steady * t, spline(t, 1) + steady, spline(t, 2)

    def moved(self, by: float) -> Tabulated:
        return replace(self, angles=tuple(angle + by for angle in self.angles))


class Lifts(Protocol):
    """A follower's law over a turn: of the angle its lift and both derivatives by it; `lift`: the greatest, rad."""

    @property
    def lift(self) -> float: ...

    @property
    def breaks(self) -> tuple[float, ...]: ...

    def of(self, theta: Array) -> Three: ...


@dataclass(frozen=True, eq=False)
class Phased(MotionLaw):
    """The phases of a cam's law over the time of one cycle, from an angle `start` on, rad."""

    lifts: Lifts
    start: float
    period: float

    @property
    def breaks(self) -> tuple[float, ...]:  # type: ignore[override]
        return tuple(one * self.period / FULL_TURN for one in self.lifts.breaks)

    def at(self, t: Array) -> Three:
        rate = FULL_TURN / self.period
        s, d, dd = self.lifts.of(np.asarray(t, dtype=float) * rate)
        return self.start + s, d * rate, dd * rate**2

    def moved(self, by: float) -> Phased:
        return replace(self, start=self.start + by)


@dataclass(frozen=True, eq=False)
class Pieces(MotionLaw):
    """Constant accelerations, each over its own time, s, from a place and a speed on."""

    start: float
    speed: float
    times: tuple[float, ...]
    accelerations: tuple[float, ...]

    @cached_property
    def _begun(self) -> tuple[Array, Array, Array]:
        """Times at which the pieces begin, the last end among them, and the place and speed there."""
        durations, a = np.array(self.times), np.array(self.accelerations)
        t = np.concatenate([[0.0], np.cumsum(durations)])
        v = self.speed + np.concatenate([[0.0], np.cumsum(a * durations)])
        q = self.start + np.concatenate([[0.0], np.cumsum((v[:-1] + a * durations / 2) * durations)])
        return t, q, v

    @property
    def period(self) -> float:  # type: ignore[override]
        return float(self._begun[0][-1])

    @property
    def breaks(self) -> tuple[float, ...]:  # type: ignore[override]
        return tuple(float(t) for t in self._begun[0][1:-1])

    def at(self, t: Array) -> Three:
        """At a break the acceleration is that after it."""
        begins, q, v = self._begun
        t = np.asarray(t, dtype=float)
        k = np.searchsorted(begins - NEXT * self.period, t, side="right") - 1
        k = np.clip(k, 0, len(self.times) - 1)
        a, gone = np.array(self.accelerations)[k], t - begins[k]
        return q[k] + (v[k] + a * gone / 2) * gone, v[k] + a * gone, a


@dataclass(frozen=True, eq=False)
class RunUp(Pieces):
    """A constant speed, `steady`, run up to from rest evenly in the time `up` and down to rest in the time `down`, s; 0
    where it is there from the beginning, or to the end."""

    steady: float = 0.0
    up: float = 0.0
    down: float = 0.0


def accelerated(start: float, speed: float, acceleration: float, time: float) -> Polynomial:
    """With constant acceleration: rad, rad/s, rad/s², over a time, s."""
    return Polynomial((start, speed, acceleration / 2), time)


def time_of(angle: float, speed: float, acceleration: float) -> float:
    """When a link that turns with constant acceleration has turned by an angle, s; nan where it stops before. The form
    without cancellation, for a small acceleration too."""
    square = speed**2 + 2 * acceleration * angle
    return 2 * angle / (speed + math.copysign(math.sqrt(square), angle)) if square >= 0 else math.nan
