"""Shapes of a law within a phase: f(τ), 0 … 1 over the share τ = 0 … 1 of the phase, with both derivatives.

    shape                 f                              greatest f'      greatest f''
    uniform               τ                              1                0, infinite at both ends
    parabolic, n = a₁/a₂  (1 + n)τ²,                     2                2(1 + n), 2(1 + n)/n; 4 where n = 1
                          1 − (1 + 1/n)(1 − τ)²
    decreasing            3τ² − 2τ³                      1.5              6
    cosine                (1 − cos πτ)/2                 π/2              π²/2
    sine                  τ − sin 2πτ/(2π)               2                2π
    polynomial            10τ³ − 15τ⁴ + 6τ⁵              1.875            10/√3
    polynomial_4567       35τ⁴ − 84τ⁵ + 70τ⁶ − 20τ⁷      2.1875           84√5/25
    modified_sine         a graph: see `modified_sine`   4π/(4 + π)       4π²/(4 + π)
    modified_trapezoid    see `modified_trapezoid`       2                8π/(2 + π)
    trapezoid             ramps of a share r             2                4/(1 − 2r); 16/3 at r = 1/8, 8 at 1/4
    stated                any graph of acceleration, or of velocity
    tabled                a curve through displacements

Source: Artobolevsky, Theory of mechanisms and machines, ch. 26; Levitsky, Cam mechanisms, ch. 2; Norton, Cam design,
ch. 3.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property, partial
from itertools import pairwise
from math import pi
from typing import Any, Literal, NamedTuple, Protocol

import numpy as np

from tmm_report.records import dataclass

Array = Any
Three = tuple[Array, Array, Array]  # a function and its first two derivatives
EDGE = 1e-12  # of a phase: a share as near as this before a break belongs to what follows it
Form = Literal["line", "sine"]
TABLED = "tabled"  # name of a shape through displacements


class Shape(Protocol):
    """`breaks`: shares within the phase, ascending, at which a piece of it ends: its acceleration, or the rate of that,
    may jump there."""

    @property
    def name(self) -> str: ...

    @property
    def breaks(self) -> tuple[float, ...]: ...

    def of(self, t: Array) -> Three:
        """f, f', f'' at shares (...); at a break those of what follows it."""

    def third(self, t: Array) -> Array:
        """The third derivative there, within the pieces: where f'' jumps it has no bound."""


# ---------------------------------------------------------------- by one formula


def _decreasing(t: Array) -> Three:
    return t * t * (3 - 2 * t), 6 * t * (1 - t), 6 - 12 * t


def _cosine(t: Array) -> Three:
    turned = np.pi * t
    return (1 - np.cos(turned)) / 2, np.pi / 2 * np.sin(turned), np.pi**2 / 2 * np.cos(turned)


def _sine(t: Array) -> Three:
    turned = 2 * np.pi * t
    return t - np.sin(turned) / (2 * np.pi), 1 - np.cos(turned), 2 * np.pi * np.sin(turned)


def _polynomial(t: Array) -> Three:
    return (
        t**3 * (10 - 15 * t + 6 * t * t),
        30 * t * t * (1 - t) ** 2,
        60 * t * (1 - t) * (1 - 2 * t),
    )


def _polynomial_4567(t: Array) -> Three:
    return (
        t**4 * (35 - 84 * t + 70 * t * t - 20 * t**3),
        140 * t**3 * (1 - t) ** 3,
        420 * t * t * (1 - t) ** 2 * (1 - 2 * t),
    )


def _uniform(t: Array) -> Three:
    return t, np.ones_like(t), np.zeros_like(t)


FORMULAS: dict[str, Callable[[Array], Three]] = {
    "uniform": _uniform,
    "decreasing": _decreasing,
    "cosine": _cosine,
    "sine": _sine,
    "polynomial": _polynomial,
    "polynomial_4567": _polynomial_4567,
}


THIRD: dict[str, Callable[[Array], Array]] = {
    "uniform": np.zeros_like,
    "decreasing": lambda t: np.full_like(t, -12.0),
    "cosine": lambda t: -(pi**3) / 2 * np.sin(pi * t),
    "sine": lambda t: 4 * pi**2 * np.cos(2 * pi * t),
    "polynomial": lambda t: 60 * (1 - 6 * t + 6 * t * t),
    "polynomial_4567": lambda t: 840 * t * (1 - t) * (1 - 5 * t + 5 * t * t),
}


@dataclass(frozen=True)
class Whole:
    """One formula of `FORMULAS` over the whole phase."""

    name: str

    @property
    def breaks(self) -> tuple[float, ...]:
        return ()

    def of(self, t: Array) -> Three:
        return FORMULAS[self.name](np.asarray(t, dtype=float))

    def third(self, t: Array) -> Array:
        return THIRD[self.name](np.asarray(t, dtype=float))


@dataclass(frozen=True)
class Parabolic:
    """Constant acceleration, then constant deceleration; `ratio` n = a₁/a₂ of their sizes."""

    ratio: float = 1.0

    @property
    def name(self) -> str:
        return "parabolic"

    @property
    def switch(self) -> float:
        """The share of the phase that the acceleration takes."""
        return 1 / (1 + self.ratio)

    @property
    def breaks(self) -> tuple[float, ...]:
        return (self.switch,)

    def of(self, t: Array) -> Three:
        t, up, down = np.asarray(t, dtype=float), 1 + self.ratio, 1 + 1 / self.ratio
        first = t < self.switch - EDGE
        left = 1 - t
        return (
            np.where(first, up * t * t, 1 - down * left**2),
            np.where(first, 2 * up * t, 2 * down * left),
            np.where(first, 2 * up, -2 * down),
        )

    def third(self, t: Array) -> Array:
        return np.zeros(np.shape(t))


# ---------------------------------------------------------------- by a graph of acceleration


class Piece(NamedTuple):
    """A piece of a graph: so many parts wide, from one ordinate to another of the same sign by a straight line, or by a
    quarter of a sine that is level where the ordinate is the larger in size."""

    width: float
    start: float
    end: float
    form: Form = "line"


class Laid(NamedTuple):
    """A piece in its place: f, f', f'' where it begins, f'' where it ends, its share of the phase."""

    at: float
    width: float
    form: Form
    f: float
    slope: float
    start: float
    end: float


class Unfit(ValueError):
    """A graph that is no law of a rise; the first argument says why: "one sign", "turns back"; "no lift", "falls back",
    "swings back" of displacements."""


@dataclass(frozen=True)
class Graph:
    """A graph of acceleration to any scale: widths are made shares of the phase; the ordinates below zero are scaled so
    that the follower comes to rest (positive and negative areas equal), then all so that f(1) = 1. With `begin`, a
    velocity on the scale of the ordinates, nothing comes to rest of itself: the ordinates are slopes of a graph of
    velocity and are all scaled alike. Raises Unfit."""

    pieces: tuple[Piece, ...]
    name: str = "stated"
    begin: float | None = None

    def __post_init__(self) -> None:
        laid = self.laid
        ends = [one.slope for one in laid] + [_end(laid[-1])[1]]
        if min(ends) < -1e-12 * max(ends):
            raise Unfit("turns back")

    @cached_property
    def laid(self) -> tuple[Laid, ...]:
        whole = sum(one.width for one in self.pieces)
        pieces = [Piece(w / whole, a, b, form) for w, a, b, form in self.pieces]
        if self.begin is None:
            areas = [_area(one) for one in pieces]
            above, below = sum(x for x in areas if x > 0), -sum(x for x in areas if x < 0)
            if not (above > 0 and below > 0):
                raise Unfit("one sign")
            pieces = [
                one if x > 0 else _scaled(one, above / below) for one, x in zip(pieces, areas, strict=True)
            ]
        laid = _laid(pieces, self.begin or 0.0, 1.0)
        lift = _end(laid[-1])[0]
        if not lift > 0:
            raise Unfit("turns back")
        return _laid(pieces, self.begin or 0.0, 1 / lift)

    @property
    def breaks(self) -> tuple[float, ...]:
        return tuple(one.at for one in self.laid[1:])

    def piece_at(self, t: float) -> int:
        """Number of the piece to which a share belongs."""
        return int(np.searchsorted(np.array(self.breaks) - EDGE, t, side="right"))

    def of(self, t: Array) -> Three:
        t = np.asarray(t, dtype=float)
        number = np.searchsorted(np.array(self.breaks) - EDGE, t, side="right")
        found = tuple(np.zeros(t.shape) for _ in range(3))
        for k, one in enumerate(self.laid):
            for whole, part in zip(found, within(one, t - one.at), strict=True):
                np.copyto(whole, part, where=number == k)
        return found  # type: ignore[return-value]

    def third(self, t: Array) -> Array:
        t = np.asarray(t, dtype=float)
        number = np.searchsorted(np.array(self.breaks) - EDGE, t, side="right")
        found = np.zeros(t.shape)
        for k, one in enumerate(self.laid):
            np.copyto(found, _rate(one, t - one.at), where=number == k)
        return found


def within(one: Laid, x: Array) -> Three:
    """f, f', f'' of a piece, x of the phase after its beginning."""
    f, slope = one.f + one.slope * x, one.slope
    if one.form == "line":
        rate = (one.end - one.start) / one.width
        bend = one.start + rate * x
        return f + (one.start / 2 + rate * x / 6) * x * x, slope + (one.start + rate * x / 2) * x, bend
    k, size = quarter(one)
    c, s = np.cos(k * x), np.sin(k * x)
    if rising(one):
        bend = one.start + size * s
        return (
            f + one.start * x * x / 2 + size / k * (x - s / k),
            slope + one.start * x + size / k * (1 - c),
            bend,
        )
    return (
        f + one.end * x * x / 2 + size / k**2 * (1 - c),
        slope + one.end * x + size / k * s,
        one.end + size * c,
    )


def _rate(one: Laid, x: Array) -> Array:
    """The derivative of the acceleration of a piece."""
    if one.form == "line":
        return np.full(np.shape(x), (one.end - one.start) / one.width)
    k, size = quarter(one)
    return size * k * np.cos(k * x) if rising(one) else -size * k * np.sin(k * x)


def rising(one: Piece | Laid) -> bool:
    """Whether the ordinate of a quarter of a sine grows in size."""
    return abs(one.end) > abs(one.start)


def quarter(one: Piece | Laid) -> tuple[float, float]:
    """Of a quarter of a sine: π/2 over its width; by how much its end of the smaller size is passed."""
    return pi / 2 / one.width, one.end - one.start if rising(one) else one.start - one.end


def _area(one: Piece) -> float:
    if one.form == "line":
        return one.width * (one.start + one.end) / 2
    low, high = sorted((one.start, one.end), key=abs)
    return one.width * (low + (high - low) * 2 / pi)


def _scaled(one: Piece, by: float) -> Piece:
    return Piece(one.width, one.start * by, one.end * by, one.form)


def _laid(pieces: Sequence[Piece], begin: float, by: float) -> tuple[Laid, ...]:
    """Pieces end to end, all ordinates `by` so many times as large."""
    found: list[Laid] = []
    at, f, slope = 0.0, 0.0, begin * by
    for width, start, end, form in pieces:
        found.append(Laid(at, width, form, f, slope, start * by, end * by))
        f, slope = _end(found[-1])
        at += width
    return tuple(found)


def _end(one: Laid) -> tuple[float, float]:
    """f and f' where a piece ends."""
    f, slope, _ = within(one, one.width)
    return float(f), float(slope)


def lines(ordinates: Sequence[float], widths: Iterable[float] | None = None) -> tuple[Piece, ...]:
    """Straight lines through ordinates at equal parts, or at stated ones; a line through zero is cut there."""
    found: list[Piece] = []
    for width, (a, b) in zip(widths or [1.0] * (len(ordinates) - 1), pairwise(ordinates), strict=True):
        if a * b < 0:
            cut = a / (a - b)
            found += [Piece(width * cut, a, 0.0), Piece(width * (1 - cut), 0.0, b)]
        else:
            found.append(Piece(width, a, b))
    return tuple(found)


def by_velocity(ordinates: Sequence[float]) -> Graph:
    """Straight lines of velocity through ordinates at equal parts of the phase. Raises Unfit."""
    step = 1.0 / (len(ordinates) - 1)
    pieces = tuple(Piece(step, slope, slope) for slope in ((b - a) / step for a, b in pairwise(ordinates)))
    return Graph(pieces, begin=ordinates[0])


def by_displacement(ordinates: Sequence[float]) -> Graph:
    """The smooth curve through ordinates of displacement at equal parts of the phase, at rest at both ends: the clamped
    cubic spline, whose acceleration goes straight between them. Raises Unfit.

    Source: de Boor, A practical guide to splines, ch. 4.
    """
    steps = np.diff(np.asarray(ordinates, dtype=float))
    if np.min(steps) < 0:
        raise Unfit("falls back")
    if not np.max(steps) > 0:
        raise Unfit("no lift")
    steps, n = steps / np.sum(steps), len(ordinates)
    A = 4.0 * np.eye(n) + np.eye(n, k=1) + np.eye(n, k=-1)
    A[0, 0] = A[-1, -1] = 2.0
    bends = np.linalg.solve(A, 6.0 * (n - 1) ** 2 * np.diff(steps, prepend=0.0, append=0.0))
    bends[np.abs(bends) < EDGE * np.abs(bends).max()] = 0.0
    try:
        return Graph(lines(bends.tolist()), name=TABLED)
    except Unfit:
        raise Unfit("swings back") from None


def trapezoid(ramp: float) -> Graph:
    """Acceleration and deceleration by trapezoids, each of four ramps a share `ramp` of the phase; 1/4: triangles."""
    level = 0.5 - 2 * ramp
    up = [Piece(ramp, 0.0, 1.0), *([Piece(level, 1.0, 1.0)] if level > 0 else []), Piece(ramp, 1.0, 0.0)]
    return Graph((*up, *(Piece(w, -a, -b) for w, a, b, _ in up)), name="trapezoid")


def modified_trapezoid() -> Graph:
    """Trapezoids whose ramps, an eighth each, are quarters of a sine."""
    up = (Piece(1, 0, 1, "sine"), Piece(2, 1, 1), Piece(1, 1, 0, "sine"))
    return Graph((*up, *(Piece(w, -a, -b, form) for w, a, b, form in up)), name="modified_trapezoid")


def modified_sine() -> Graph:
    """Quarters of a sine over an eighth at both ends, half a wave between."""
    return Graph(
        (Piece(1, 0, 1, "sine"), Piece(3, 1, 0, "sine"), Piece(3, 0, -1, "sine"), Piece(1, -1, 0, "sine")),
        name="modified_sine",
    )


RAMP = 1 / 8  # of the phase: of a trapezoid unless stated
NAMED: dict[str, Callable[[], Shape]] = {
    "parabolic": Parabolic,
    **{name: partial(Whole, name) for name in FORMULAS},
    "trapezoid": partial(trapezoid, RAMP),
    "modified_trapezoid": modified_trapezoid,
    "modified_sine": modified_sine,
}


def named(name: str) -> Shape:
    """The shape that is known by its name."""
    return NAMED[name]()
