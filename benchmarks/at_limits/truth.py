"""What is right of a drawn mechanism: places by circles and lines in 50 digits, rates by differences of the places.

Lengths are the typed decimals, so that an equality holds exactly. Near a change point the root is taken with the sign
that goes smoothly through it, and a limit from one side is that of the sheet on that side. Nothing is taken from the
program.
Angles `t` are turned from position 0 in the sense of rotation, rad; rates are by `t`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import mpmath
import numpy as np

from benchmarks.at_limits.draw import OMEGA, Place, Scene, Step

Array = Any
DIGITS = 50
GRID = 5760  # samples of a turn
WIDE, FINE = 5e-4, 1e-6  # rad, steps of the differences of the samples and of the refined values
FIRST = (Fraction(4, 5), Fraction(-1, 5), Fraction(4, 105), Fraction(-1, 280))  # differences of eighth order
SECOND = (Fraction(8, 5), Fraction(-1, 5), Fraction(8, 315), Fraction(-1, 560))
TURN = 2 * np.pi
WITHIN = 0.3819  # of a piece: the place whose root is taken, no meeting of round angles
ASIDE = 1e-9  # rad: samples keep off the corners, where a pin may lie on a pivot
MOST = 8  # samples that are refined
NOTHING = 1e-9  # of the angular velocity, or its square: what varies less is constant
NEAR = 0.05  # of the largest: samples as near to the greatest are refined


@dataclass(frozen=True)
class Output:
    """A "slider" by its point and the direction of its positive displacement, or a "rocker" by its link."""

    kind: str
    name: str
    direction: complex = 1.0


class Truth:
    """The motion of a scene, by `of(t, middle)`: the places at `t` on the sheets that go smoothly through `middle`."""

    def __init__(self, scene: Scene):
        self.scene = scene
        with mpmath.workdps(DIGITS):
            self.zero = mpmath.mpf(scene.zero) * mpmath.pi / 180
            base = mpmath.atan2(_real(scene.base[1]), _real(scene.base[0]))
            turn = 2 * mpmath.pi
            found = []
            for k in scene.changes:
                t = scene.sense * (base + k * mpmath.pi - self.zero)
                t -= turn * mpmath.floor(t / turn + mpmath.mpf(10) ** -30)
                found.append(abs(t) if abs(t) < mpmath.mpf(10) ** -25 else t)
        exact = scene.away == 0
        self.meetings = sorted(found) if exact else []
        self.nearly = [] if exact else [float(t) for t in found]
        # of an odd number the last of the turn is not passed; one in position 0 comes at its end
        after = [t if t > 0 else turn for t in self.meetings]
        self.corner = max(after) if len(after) % 2 else None
        self.passed = sorted(t for t in after if t != self.corner)

    # ------------------------------------------------------------ places

    def sign(self, t: Any, middle: Any, fine: bool) -> Any:
        """The sign of the first step's root: as the motion has it at `middle`, turned at each meeting from there."""
        own = (-1) ** sum(1 for x in self.passed if x < middle)
        if fine:
            full, low = 2 * mpmath.pi, middle
            crossed = sum(
                (low - x - n * full) * (t - x - n * full) < 0 for x in self.meetings for n in (-1, 0, 1)
            )
            return own * (-1) ** crossed
        low, found = np.longdouble(str(middle)), np.full(np.shape(t), own)
        for x in self.meetings:
            for n in (-1, 0, 1):
                at = np.longdouble(str(x + 2 * n * mpmath.pi))
                found = np.where((low - at) * (t - at) < 0, -found, found)
        return found

    def of(self, t: Any, middle: Any, fine: bool = True) -> dict[str, Any]:
        """Directions of links, by their names, and places of points, "point X", at `t`."""
        scene = self.scene
        number: Callable[[Any], Any] = (
            _real if fine else lambda x: np.longdouble(x.numerator) / np.longdouble(x.denominator)
        )
        root = mpmath.sqrt if fine else _sqrt
        phi = (self.zero if fine else np.longdouble(str(self.zero))) + scene.sense * t
        u = mpmath.mpc(mpmath.cos(phi), mpmath.sin(phi)) if fine else np.cos(phi) + 1j * np.sin(phi)
        at = {name: _place(place, number) for name, place in scene.fixed.items()}
        turned: dict[str, Any] = {"1": u}
        at["A"] = number(scene.crank) * u
        for n, step in enumerate(scene.steps):
            sign = step.sign * (self.sign(t, middle, fine) if n == 0 else 1)
            _STEPS[step.kind](step, at, turned, sign, number, root)
            for point, (link, place) in scene.carried.items():
                if link in (step.a, step.b) and step.kind != "RRP":
                    pivot = at[step.A if link == step.a else step.C]
                    at[point] = pivot + turned[link] * _place(place, number)
        return turned | {f"point {name}": place for name, place in at.items()}

    # ------------------------------------------------------------ rates

    def rates(self, output: Output, t: Any, middle: Any) -> tuple[Any, Any]:
        """Velocity and acceleration at t on the sheet through `middle`, in SI."""
        with mpmath.workdps(DIGITS):
            h, here = mpmath.mpf(FINE), self.of(t, middle)
            own = _coordinate(output, here, here)
            pairs = [
                [_coordinate(output, self.of(t + s * k * h, middle), here) for s in (1, -1)]
                for k in range(1, len(FIRST) + 1)
            ]
            v = sum(_real(c) * (a - b) for c, (a, b) in zip(FIRST, pairs, strict=True)) / h
            w = sum(_real(c) * (a + b - 2 * own) for c, (a, b) in zip(SECOND, pairs, strict=True)) / h**2
            return v * OMEGA, w * OMEGA**2

    # ------------------------------------------------------------ extremes

    @cached_property
    def pieces(self) -> list[tuple[Any, Any]]:
        """From position 0 to the corner and from there on; of a turn without a corner the whole."""
        full = 2 * mpmath.pi
        if self.corner is None or self.corner >= full - mpmath.mpf(10) ** -20:
            return [(mpmath.mpf(0), full)]
        return [(mpmath.mpf(0), self.corner), (self.corner, full)]

    def extremes(self, output: Output) -> tuple[Array, float]:
        """Least and greatest velocity and acceleration, (2, 2), both sides of a corner among them; stroke or swing."""
        rows: tuple[list[float], list[float]] = ([], [])
        places: list[Array] = []
        with mpmath.workdps(DIGITS):
            for start, end in self.pieces:
                middle = start + (end - start) * mpmath.mpf(WITHIN)
                t = self._grid(start, end)
                places.append(self._spread(output, t, middle))
                aside = mpmath.mpf(10) ** -18
                for x in (start + aside, end - aside):
                    for row, value in zip(rows, self.rates(output, x, middle), strict=True):
                        row.append(float(value))
                for order, row in enumerate(rows):
                    for x in self._peaks(output, t, order, middle):
                        row.append(float(self.rates(output, mpmath.mpf(str(x)), middle)[order]))
        return np.array([[min(row), max(row)] for row in rows]), _span(output, places)

    def _grid(self, start: Any, end: Any) -> Array:
        """Angles over a piece, ever nearer to what is nearly a meeting."""
        low, high = np.longdouble(str(start)) + ASIDE, np.longdouble(str(end)) - ASIDE
        even = np.linspace(low, high, max(int(GRID * float(high - low) / TURN), 40) + 1)
        if self.scene.away == 0:
            return even
        beside = np.concatenate(
            [[x + s * d for d in np.geomspace(1e-8, 4e-3, 150)] for x in self.nearly for s in (-1, 1)]
        )
        beside = np.mod(beside, TURN).astype(np.longdouble)
        return np.unique(np.concatenate([even, beside[(beside > low) & (beside < high)]]))

    def _step(self, t: Array) -> Array:
        """A step for differences at t, rad: less beside what is nearly a meeting."""
        if self.scene.away == 0:
            return np.full(t.shape, WIDE)
        wide = np.sqrt(abs(float(self.scene.away)) / float(self.scene.crank))
        off = np.abs(
            np.angle(np.exp(1j * (np.asarray(t, dtype=float)[:, None] - np.array(self.nearly))))
        ).min(axis=1)
        return np.minimum(WIDE, 0.02 * np.hypot(off, wide))

    def _places(self, output: Output, t: Array, middle: Any) -> Array:
        found = self.of(t, middle, fine=False)
        if output.kind == "rocker":
            return np.unwrap(np.angle(found[output.name]).astype(float))
        return _along(output, found[f"point {output.name}"])

    def _spread(self, output: Output, t: Array, middle: Any) -> Array:
        """Displacements over a piece, its least and greatest among them, with its ends first and last."""
        place = self._places(output, t, middle)
        more = []
        for sign in (1, -1):
            n = int(np.argmin(sign * place))
            if 0 < n < len(t) - 1:
                best = self._vertex(output, t, n, -1, sign, middle)[0]
                pair = self._places(output, np.array([t[n], best]), middle)
                more.append(place[n] + pair[1] - pair[0])
        return np.concatenate([place[:1], np.asarray(more, dtype=float), place.astype(float)])

    def _sampled(self, output: Output, t: Array, order: int, middle: Any) -> Array:
        """Velocity (0) or acceleration (1) by wide differences, to find where they are extreme; displacement (-1)."""
        if order < 0:
            return self._places(output, t, middle)
        h = self._step(t)
        here = self.of(t, middle, fine=False)
        total = 0.0 if order == 0 else 2 * -sum(map(float, SECOND)) * _coordinate(output, here, here)
        for k, c in enumerate((FIRST, SECOND)[order], start=1):
            a, b = (_coordinate(output, self.of(t + s * k * h, middle, fine=False), here) for s in (1, -1))
            total = total + np.longdouble(float(c)) * (a - b if order == 0 else a + b)
        return total / h ** (order + 1)

    def _peaks(self, output: Output, t: Array, order: int, middle: Any) -> list[Array]:
        """Angles of the least and of the greatest value inside the piece."""
        row = self._sampled(output, t, order, middle)
        found = []
        for sign in (1, -1):
            y = sign * row
            if np.ptp(row) < NOTHING * max(float(np.abs(row).max()), 1e-3):
                continue
            inner = np.flatnonzero((y[1:-1] <= y[:-2]) & (y[1:-1] <= y[2:])) + 1
            if not inner.size:
                continue
            k = inner[np.argmin(y[inner])]
            close = inner[np.argsort(y[inner], kind="stable")[:MOST]]
            close = close[y[close] <= y[k] + NEAR * np.ptp(row)]
            best = [self._vertex(output, t, n, order, sign, middle) for n in close]
            found.append(min(best, key=lambda pair: pair[1])[0])
        return found

    def _vertex(
        self, output: Output, t: Array, n: int, order: int, sign: int, middle: Any
    ) -> tuple[Any, float]:
        """The lowest point beside sample n, by parabolas ever narrower."""
        x, width = t[n], min(t[n + 1] - t[n], t[n] - t[n - 1])
        for _ in range(3):
            three = np.array([x - width, x, x + width])
            a, b, c = sign * self._sampled(output, three, order, middle)
            bend = a + c - 2 * b
            if bend <= 0:
                break
            x = x + np.clip(width * (a - c) / (2 * bend), -width, width)
            width = width / 8
        return x, float(sign * self._sampled(output, np.array([x]), order, middle)[0])


def _coordinate(output: Output, found: Mapping[str, Any], middle: Mapping[str, Any]) -> Any:
    """An angle from the middle, rad, or a displacement, m."""
    if output.kind == "rocker":
        ratio = found[output.name] / middle[output.name]
        return mpmath.arg(ratio) if isinstance(ratio, mpmath.mpc) else np.arctan2(ratio.imag, ratio.real)
    return _along(output, found[f"point {output.name}"])


def _along(output: Output, place: Any) -> Any:
    return (place.real * output.direction.real + place.imag * output.direction.imag) / 1000


def _span(output: Output, places: list[Array]) -> float:
    """Stroke or swing over the turn; a jump of half a turn goes back."""
    if output.kind == "rocker" and len(places) == 2:
        first, second = places
        jump = float(np.angle(np.exp(1j * (second[0] - first[-1]))))
        if abs(abs(jump) - np.pi) < 1e-6:
            jump = -np.copysign(np.pi, (first[-1] - first[0]) + (second[-1] - second[0]))
        places = [first, second - second[0] + first[-1] + jump]
    whole = np.concatenate(places)
    return float(whole.max() - whole.min())


def _real(x: Any) -> Any:
    return mpmath.mpf(x.numerator) / x.denominator


def _place(place: Place, number: Callable[[Any], Any]) -> Any:
    x, y = number(place[0]), number(place[1])
    return mpmath.mpc(x, y) if isinstance(x, mpmath.mpf) else x + 1j * y


def _sqrt(x: Array) -> Array:
    return np.sqrt(np.maximum(x, 0))


def _rrr(step: Step, at: dict[str, Any], turned: dict[str, Any], sign: Any, number: Any, root: Any) -> None:
    p, q = number(step.p), number(step.q)
    A, C = at[step.A], at[step.C]
    gap = C - A
    d2 = gap.real**2 + gap.imag**2
    # by factors: (d² − (p − q)²)((p + q)² − d²) is 16 squares of the triangle's area
    area = root((d2 - (p - q) ** 2) * ((p + q) ** 2 - d2))
    along = (d2 + p * p - q * q) / 2
    B = A + gap * (along + 1j * sign * area / 2) / d2
    at[step.B] = B
    turned[step.a], turned[step.b] = (B - A) / p, (B - C) / q


def _rrp(step: Step, at: dict[str, Any], turned: dict[str, Any], sign: Any, number: Any, root: Any) -> None:
    p, t = number(step.p), _place(step.along, number)
    gap = (at[step.C] - at[step.A]) * t.conjugate()
    h = gap.imag
    B = at[step.A] + t * (sign * root((p - h) * (p + h)) + 1j * h)
    at[step.B] = B
    turned[step.a] = (B - at[step.A]) / p


def _rpr(step: Step, at: dict[str, Any], turned: dict[str, Any], sign: Any, number: Any, root: Any) -> None:
    h = number(step.q)
    gap = at[step.A] - at[step.C]
    s = sign * root(gap.real**2 + gap.imag**2 - h * h)
    turned[step.b] = gap / (s + 1j * h)
    turned[step.a] = turned[step.b]


_STEPS: dict[str, Callable[..., None]] = {"RRR": _rrr, "RRP": _rrp, "RPR": _rpr}
