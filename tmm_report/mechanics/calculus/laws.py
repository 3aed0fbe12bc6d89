"""Laws: how a force, a pressure, a moment or a moment of inertia goes over what it is stated over.

    | of         | argument                                            | laws                                          |
    | ---------- | --------------------------------------------------- | --------------------------------------------- |
    | `NOTHING`  | none                                                | Constant                                      |
    | `ANGLE`    | angle turned from position 0 in the sense of        | ByAngle, Harmonics                            |
    |            | rotation, rad                                       |                                               |
    | `POSITION` | number of the position                              | ByPosition                                    |
    | `TRAVEL`   | displacement of a point by its stroke, 0 … 1, and   | ByDisplacement, ByStrokes                     |
    |            | which curve of the diagram holds                    |                                               |
    | `TIME`     | s                                                   | ByTime                                        |
    | `SPEED`    | rad/s; of what slides m/s                           | BySpeed, and the motors' of `characteristics` |
    | `STROKE`   | place of what slides along its guide, m             | ByPlace                                       |
    | `LENGTH`   | distance of two points, m                           | ByLength                                      |
    | `TURN`     | how far two links have turned against one another, rad | ByTurn                                     |
    | `RATE`     | its derivative by the time, m/s                     | ByRate                                        |
    | `SLIDING`  | size of the velocity of sliding, m/s                | those of `pairs.coefficients`                 |

A law says its value anywhere, in doubles or in other numbers (`Arithmetic`), and its breaks; between them it is a
polynomial of degree `order`, or smooth (None). tests/mechanics/calculus/test_laws.py holds every law to that.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar, NamedTuple, Protocol, Self

import numpy as np

from tmm_report.records import dataclass

Array = Any
Numbers = tuple[float, ...]
Curve = tuple[tuple[float, float], ...]
NOTHING, ANGLE, POSITION, TRAVEL, TIME, SPEED = "", "angle", "position", "travel", "time", "speed"
LENGTH, RATE, STROKE, TURN, SLIDING = "length", "rate", "stroke", "turn", "sliding"


class Break(NamedTuple):
    """A place on the axis of a law, of its curve `which`, at which it has a corner, or a jump where the values `before`
    and `after` differ. At a jump the value after it holds."""

    at: float
    before: float
    after: float
    which: int = 0


class Arithmetic(Protocol):
    """The numbers in which a law is evaluated: what they are beside +, −, ·, /."""

    def full(self, amount: float, at: Any) -> Any:
        """The same number at every place."""

    def cos(self, x: Any) -> Any: ...

    def sin(self, x: Any) -> Any: ...

    def exp(self, x: Any) -> Any: ...

    def lines(self, at: Any, x: Array, y: Array, period: float | None) -> Any:
        """Straight lines between points that ascend, at two of the same place the later one: constant beyond them, or
        within one `period` and the last joined to the first of the next one."""

    def one_of(self, values: Sequence[Any], which: Any) -> Any:
        """Of each place the value of the curve that holds there."""


class Doubles:
    """Doubles and arrays of them."""

    @staticmethod
    def full(amount: float, at: Array) -> Array:
        return amount if np.ndim(at) == 0 else np.full(np.shape(at), amount)

    cos, sin, exp = np.cos, np.sin, np.exp

    @staticmethod
    def lines(at: Array, x: Array, y: Array, period: float | None) -> Array:
        # numpy's own `period` puts the two values of a jump, and of an end that is not the beginning, the wrong way
        # round
        if period is None:
            return np.interp(at, x, y)
        places, values = np.append(x, x[0] + period), np.append(y, y[0])
        return np.interp(x[0] + np.mod(np.asarray(at) - x[0], period), places, values)

    @staticmethod
    def one_of(values: Sequence[Array], which: Array) -> Array:
        return np.take_along_axis(np.array(values), np.asarray(which)[None], axis=0)[0]


DOUBLES = Doubles()


class Law:
    """One law. `order`: degree of the polynomial that it is between its breaks; None: it is none, but smooth."""

    of: ClassVar[str]
    order: ClassVar[int | None] = None

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        """At places of its axis, (..., P); `which`: the curve that holds there, of a law that has several."""
        raise NotImplementedError

    def breaks(self, end: float | None = None) -> tuple[Break, ...]:
        """Those of one period of a law that repeats, or all from 0 to `end`."""
        return ()

    def at(self, omega: Array, phi: Array = 0.0, t: Array = 0.0) -> Array:
        """Of a machine that turns: its speed, rad/s, angle turned, rad, and time, s."""
        return self.value(omega if self.of == SPEED else t if self.of == TIME else phi)

    @property
    def widest(self) -> float:
        """How wide an interval without breaks may be, on which Gauss's formula integrates the law to all digits."""
        return math.inf

    def repeating(self, period: float) -> Law:
        """The same law, if it is one of the angle, repeated with every period, rad."""
        return self

    def scaled(self, factor: float) -> Self:
        """A pressure on an area as a force."""
        raise NotImplementedError


@dataclass(frozen=True)
class Constant(Law):
    """What does not change; of a resistance, dry friction."""

    of: ClassVar[str] = NOTHING
    order: ClassVar[int | None] = 0
    amount: float

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        return numbers.full(self.amount, at)

    def scaled(self, factor: float) -> Self:
        return replace(self, amount=self.amount * factor)


@dataclass(frozen=True)
class Wave:
    """cos·cos(order φ) + sin·sin(order φ)."""

    order: float
    cos: float
    sin: float


@dataclass(frozen=True)
class Harmonics(Law):
    """A mean and waves over the angle."""

    of: ClassVar[str] = ANGLE
    mean: float
    waves: tuple[Wave, ...]

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        terms = (
            one.cos * numbers.cos(one.order * at) + one.sin * numbers.sin(one.order * at)
            for one in self.waves
        )
        return sum(terms, numbers.full(self.mean, at))

    @property
    def widest(self) -> float:
        """A quarter of the shortest wave."""
        return math.pi / (2 * max(one.order for one in self.waves))

    def scaled(self, factor: float) -> Self:
        waves = tuple(Wave(one.order, one.cos * factor, one.sin * factor) for one in self.waves)
        return replace(self, mean=self.mean * factor, waves=waves)


# ---------------------------------------------------------------- straight lines between points


class Lines(Law):
    """Straight lines between points that ascend; two of the same place are a jump. Beyond them the first and the last
    value, or with a `period` the line from the last to the first of the next one."""

    order: ClassVar[int | None] = 1
    values: Numbers
    period: float | None = None

    def points(self) -> tuple[Numbers, Numbers]:
        """Places and values."""
        raise NotImplementedError

    @cached_property
    def corners(self) -> tuple[Array, Array]:
        """The same as arrays, made once: an integrator asks for one value at a time."""
        x, y = self.points()
        return np.array(x), np.array(y)

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        return numbers.lines(at, *self.corners, self.period)

    def slope(self, at: Array) -> Array:
        """Derivative; at a break that after it."""
        x, y = self.corners
        if self.period is not None:
            at = x[0] + np.mod(np.asarray(at) - x[0], self.period)
            x, y = np.append(x, x[0] + self.period), np.append(y, y[0])
        piece = np.searchsorted(x, at, side="right")
        before, after = np.clip(piece - 1, 0, len(x) - 1), np.clip(piece, 0, len(x) - 1)
        wide = x[after] - x[before]
        return np.where(wide > 0, (y[after] - y[before]) / np.where(wide > 0, wide, 1.0), 0.0)

    def breaks(self, end: float | None = None) -> tuple[Break, ...]:
        x, y = self.points()
        found = _corners(zip(x, y, strict=True))
        if self.period is None:
            return tuple(found)
        if (
            len(found) > 1 and found[-1].at >= x[0] + self.period
        ):  # the end is the beginning of the next period
            found[0] = found[0]._replace(before=found.pop().before)
        turns = range(1 if end is None else math.ceil(end / self.period - 1e-9))
        return tuple(_moved(one, turn * self.period) for turn in turns for one in found)

    def scaled(self, factor: float) -> Self:
        return replace(self, values=times(self.values, factor))  # type: ignore[type-var]  # each of them is one


def _corners(points: Iterable[tuple[float, float]], which: int = 0) -> list[Break]:
    """Of points that ascend; those of the same place are one."""
    found: list[Break] = []
    for at, value in points:
        if found and found[-1].at == at:
            found[-1] = found[-1]._replace(after=value)
        else:
            found.append(Break(at, value, value, which))
    return found


def _moved(one: Break, by: float) -> Break:
    return one._replace(at=one.at + by)


@dataclass(frozen=True)
class ByAngle(Lines):
    """Values at angles turned, rad. A law of a cycle is stated without its period, which the mechanism knows."""

    of: ClassVar[str] = ANGLE
    angles: Numbers
    values: Numbers
    period: float | None = None

    @classmethod
    def through(cls, points: Iterable[Sequence[float]], period: float | None = None) -> ByAngle:
        angles, values = zip(*points, strict=True)
        return cls(angles, values, period)

    def points(self) -> tuple[Numbers, Numbers]:
        return self.angles, self.values

    def repeating(self, period: float) -> ByAngle:
        return replace(self, period=period)


@dataclass(frozen=True)
class ByPosition(Lines):
    """Values at the positions of the table: 0 … N−1 of a cycle of full turns, whose last position is position 0 again;
    0 … N where the driving link turns over a part of a turn."""

    of: ClassVar[str] = POSITION
    values: Numbers

    def points(self) -> tuple[Numbers, Numbers]:
        return tuple(map(float, range(len(self.values)))), self.values

    def by_angle(self, step: float) -> ByAngle:
        """The same over the angle turned; `step`: from position to position, rad."""
        return ByAngle(tuple((np.arange(len(self.values)) * step).tolist()), self.values)


@dataclass(frozen=True)
class ByTime(Lines):
    """Values at times, s."""

    of: ClassVar[str] = TIME
    times: Numbers
    values: Numbers

    @classmethod
    def through(cls, points: Iterable[Sequence[float]]) -> ByTime:
        times, values = zip(*points, strict=True)
        return cls(times, values)

    def by_angle(self, omega: float) -> ByAngle:
        """The same over the angle turned at a constant speed, rad/s."""
        return ByAngle(tuple(time * omega for time in self.times), self.values)

    def points(self) -> tuple[Numbers, Numbers]:
        return self.times, self.values


@dataclass(frozen=True)
class BySpeed(Lines):
    """Values at speeds, rad/s."""

    of: ClassVar[str] = SPEED
    speeds: Numbers
    values: Numbers

    def points(self) -> tuple[Numbers, Numbers]:
        return self.speeds, self.values


@dataclass(frozen=True)
class ByPlace(Lines):
    """Values at places along a stroke, m."""

    of: ClassVar[str] = STROKE
    places: Numbers
    values: Numbers

    def points(self) -> tuple[Numbers, Numbers]:
        return self.places, self.values


def times(values: Numbers, factor: float) -> Numbers:
    return tuple(value * factor for value in values)


# ---------------------------------------------------------------- springs and dampers


@dataclass(frozen=True)
class ByLength(Law):
    """A linear spring: what draws its points together, c (l − l₀), N; `stiffness`, N/m, `free`: length, m."""

    of: ClassVar[str] = LENGTH
    order: ClassVar[int | None] = 1
    stiffness: float
    free: float

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        return self.stiffness * (at - self.free)

    def scaled(self, factor: float) -> Self:
        return replace(self, stiffness=self.stiffness * factor)


@dataclass(frozen=True)
class ByRate(Law):
    """A viscous damper: what it has against being drawn out, b l′, N; `viscosity`, N s/m."""

    of: ClassVar[str] = RATE
    order: ClassVar[int | None] = 1
    viscosity: float

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        return self.viscosity * at

    def scaled(self, factor: float) -> Self:
        return replace(self, viscosity=self.viscosity * factor)


@dataclass(frozen=True)
class ByTurn(Law):
    """A torsion spring: its moment along the turn, c (α₀ − φ), N m; `stiffness`, N m/rad, `free`: angle, rad."""

    of: ClassVar[str] = TURN
    order: ClassVar[int | None] = 1
    stiffness: float
    free: float

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        return self.stiffness * (self.free - at)

    def scaled(self, factor: float) -> Self:
        return replace(self, stiffness=self.stiffness * factor)


# ---------------------------------------------------------------- indicator diagrams


class Diagram(Law):
    """A curve for each way, or each stroke, of a point: value against x = displacement / stroke, straight lines between
    the points. x counts from the point's extreme position in the direction `zero`, a unit complex number."""

    of: ClassVar[str] = TRAVEL
    order: ClassVar[int | None] = 1
    zero: complex

    def named(self) -> tuple[tuple[str, Curve], ...]:
        """The curves by their names, in the order in which they follow; every other one goes away from the zero."""
        raise NotImplementedError

    @cached_property
    def corners(self) -> tuple[tuple[Array, Array], ...]:
        return tuple((x, y) for x, y in (np.array(curve).T for _, curve in self.named()))

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        return numbers.one_of([numbers.lines(at, x, y, None) for x, y in self.corners], which)

    def breaks(self, end: float | None = None) -> tuple[Break, ...]:
        return tuple(one for k, (_, curve) in enumerate(self.named()) for one in _corners(curve, k))


@dataclass(frozen=True)
class ByDisplacement(Diagram):
    """`forward` is the stroke away from the zero, `back` the return, in every turn."""

    zero: complex
    forward: Curve
    back: Curve

    def named(self) -> tuple[tuple[str, Curve], ...]:
        return ("forward", self.forward), ("back", self.back)

    def scaled(self, factor: float) -> Self:
        return replace(self, forward=_raised(self.forward, factor), back=_raised(self.back, factor))


@dataclass(frozen=True)
class ByStrokes(Diagram):
    """A cycle of several turns: a curve for each stroke, in the order in which they follow. The first goes away from
    the zero, the second back, and so on.

    `first`: number of the stroke that is under way at position 0 of the mechanism, or begins there; None: of the first
    and the last stated the one that goes the way in which the point goes there.
    """

    zero: complex
    names: tuple[str, ...]
    curves: tuple[Curve, ...]
    first: int | None = None

    def named(self) -> tuple[tuple[str, Curve], ...]:
        return tuple(zip(self.names, self.curves, strict=True))

    def scaled(self, factor: float) -> Self:
        return replace(self, curves=tuple(_raised(curve, factor) for curve in self.curves))


def _raised(curve: Curve, factor: float) -> Curve:
    return tuple((x, y * factor) for x, y in curve)
