"""A driving slider or cylinder of any mechanism, solved by reversing the motion.

Let a link that turns about a fixed point be the main one: by the groups behind it every position has its stroke,

    cylinder  s = |P − Q|,  s s′ = d·d′,  s s″ + s′² = d′² + d·d″  with d = P − Q
    slider    s = d·e,      s′ = d′·e,    s″ = d″·e                with d = P − Q₀

where the dashes are derivatives by the angle φ of that link. This position function is reversed, φ = φ(s), from the
beginning of the stroke on to where s′ is nothing or the link comes to its own limit, and

    ω = v/s′,  ε = (a − s″ω²)/s′.

Source: Artobolevsky, Theory of mechanisms and machines, ch. 4 (analogues); ch. 2 (choice of the main link).
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.motion_laws import MotionLaw, Three
from tmm_report.mechanics.calculus.roots import bracketed
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.driving.stroke import Stroke, Taken
from tmm_report.mechanics.lever.motion import Linkage, Motion, solve
from tmm_report.records import dataclass

Array = Any
FULL_TURN = 2 * np.pi
STEPS = 1440  # of a turn of the link, between which the stroke turns back once at most
ZOOM = 200  # parts of the last step towards a limit, again and again
TRIES = 60  # of Newton's method in a bracket
NEAR = 1e-6  # rad from a limit
SLIGHT = 1e-13  # rad, of a step of Newton's method: the next would be the square of it
SAME = 1e-9  # of the stroke, by which a root may miss it


@dataclass(frozen=True, eq=False)
class Relative:
    """d = P − Q and its derivatives by the time, or by the angle in a motion at 1 rad/s; complex, (..., P)."""

    place: Array
    velocity: Array
    acceleration: Array


@dataclass(frozen=True, eq=False)
class Branch:
    """The position function from a limit of the stroke to the next: angles, rad, by ascending strokes, m. `turns`:
    whether at the lower and at the upper end the stroke itself turns back, and not the link."""

    phi: Array
    s: Array
    turns: tuple[bool, bool]

    def holds(self, phi: float) -> bool:
        """Whether an angle, but for whole turns, belongs to it."""
        low, high = sorted((self.phi[0], self.phi[-1]))
        return bool(np.mod(phi - low, FULL_TURN) <= high - low)


@dataclass(frozen=True, eq=False)
class PositionFunction:
    """s(φ) of a mechanism with a link as the main one. `ends`: see `Stroke`; `start`, `way`: of a slider the point that
    its guide is stated by and the direction of the guide, of a cylinder 0."""

    linkage: Linkage
    ends: tuple[str, ...]
    start: complex
    way: complex

    def relative(self, motion: Motion) -> Relative:
        """The end that moves away, as seen from the other one."""
        *base, point = self.ends
        parts = [motion.place(point) - self.start, motion.velocity(point), motion.acceleration(point)]
        for other in base:
            for k, of in enumerate((motion.place, motion.velocity, motion.acceleration)):
                parts[k] = parts[k] - of(other)
        return Relative(*parts)

    def of(self, motion: Motion) -> Three:
        """s, s′, s″ of a motion at 1 rad/s: m, m/rad, m/rad²."""
        d = self.relative(motion)
        if self.way:
            return dot(d.place, self.way), dot(d.velocity, self.way), dot(d.acceleration, self.way)
        s = np.abs(d.place)
        with np.errstate(invalid="ignore", divide="ignore"):
            first = dot(d.place, d.velocity) / s
            second = (np.abs(d.velocity) ** 2 + dot(d.place, d.acceleration) - first**2) / s
        return s, first, second

    def at(self, phi: Array) -> Three:
        """At angles of the link, rad; nan where the mechanism cannot be assembled."""
        return self.of(solve(self.linkage, np.asarray(phi, dtype=float), 1.0))

    def roots(self, stroke: float) -> Array:
        """Angles of a turn at which it has a value, rad, ascending."""
        phi = np.linspace(0.0, FULL_TURN, STEPS + 1) + 1e-4  # so that no usual angle is a sample
        off = self.at(phi)[0] - stroke
        k = np.flatnonzero(off[:-1] * off[1:] < 0)
        if not k.size:
            return np.zeros(0)
        found, left = bracketed(lambda x: self.at(x)[0] - stroke, phi[k], phi[k + 1], off[k], np.zeros(1))
        return found[np.abs(left) <= SAME * max(abs(stroke), 1e-3)]  # the others are jumps to the other side

    def branch(self, begin: float) -> Branch | None:
        """On which an angle lies; None in a limit itself."""
        sign = float(np.sign(self.at(np.array([begin]))[1][0]))
        if not abs(sign) > 0:
            return None
        sides = [self._side(begin, way, sign) for way in (-1, 1)]
        (before, turns_before), (after, turns_after) = sides
        phi, turns = np.concatenate([before[::-1], [begin], after]), (turns_before, turns_after)
        if sign < 0:
            phi, turns = phi[::-1], turns[::-1]
        return Branch(phi, self.at(phi)[0], turns)

    def _side(self, begin: float, way: int, sign: float) -> tuple[Array, bool]:
        """From a beginning on, without it, to where the derivative changes its sign or nothing closes."""
        phi = begin + way * np.arange(STEPS) * (FULL_TURN / STEPS)
        found, turns = [begin], True
        for _ in range(5):
            s, slope, _ = self.at(phi)
            grows = np.concatenate(
                [[True], np.diff(s) * sign * way > 0]
            )  # but where it jumps to the other side
            lost = np.flatnonzero(~(slope * sign > 0) | ~grows)
            last = max(lost[0] - 1, 0) if lost.size else phi.size - 1
            found += [x for x in phi[1 : last + 1] if x != found[-1]]
            if not lost.size:
                break
            turns = bool(np.isfinite(slope[last + 1]))
            phi = np.linspace(phi[last], phi[last + 1], ZOOM + 1)
        return np.array(found[1:]), turns


@dataclass(frozen=True, eq=False)
class Reversed(Stroke):
    """`function`: s(φ) of the link `link`; `begin`: its angle at the beginning of the law, rad."""

    law: MotionLaw
    link: str
    function: PositionFunction
    begin: float
    by: tuple[str, ...]
    takes: tuple[Taken, ...]

    @property
    def ends(self) -> tuple[str, ...]:  # type: ignore[override]
        return self.function.ends

    @property
    def way(self) -> complex:  # type: ignore[override]
        return self.function.way

    @cached_property
    def branch(self) -> Branch:
        found = self.function.branch(self.begin)
        assert found is not None, "a stroke begins in no limit position"
        return found

    def angle(self, s: Array) -> Array:
        """Angle of the link at strokes s, rad; nan beyond the limits."""
        s, of = np.asarray(s, dtype=float), self.branch
        k = np.clip(np.searchsorted(of.s, s), 1, of.s.size - 1)
        low, high = of.phi[k - 1], of.phi[k]
        width = of.s[k] - of.s[k - 1]
        x = low + (high - low) * np.where(width > 0, (s - of.s[k - 1]) / np.where(width > 0, width, 1.0), 0.5)
        x = np.where((s >= of.s[0]) & (s <= of.s[-1]), x, np.nan)
        for _ in range(TRIES):
            value, slope, _ = self.function.at(x)
            low, high = np.where(value < s, x, low), np.where(value < s, high, x)
            step = x - (value - s) / slope
            step = np.where((step - low) * (step - high) <= 0, step, (low + high) / 2)
            moved, x = np.abs(step - x), np.where(np.isnan(x), x, step)
            if not np.any(moved > SLIGHT):
                break
        return x

    def rates(self, s: Array, v: Array, a: Array) -> Three:
        """Angle of the link, its angular velocity and acceleration at strokes s with the rates v, m/s, and a, m/s²."""
        phi = self.angle(s)
        _, first, second = self.function.at(phi)
        omega = v / first
        return phi, omega, (a - second * omega**2) / first

    @property
    def closes(self) -> bool:
        """Whether the whole mechanism can be assembled all over the law, so far as samples tell."""
        phi = self.angle(np.linspace(*self.law.reach, STEPS + 1))
        return bool(solve(self.function.linkage, phi, 1.0).closes.all())

    def limit(self) -> float | None:
        """Of the strokes that the law goes over one beyond which the mechanism cannot go on, m; None: it can."""
        of = self.branch
        ends = of.s[[0, -1]]
        for stroke in self.law.reach:
            off = np.abs(of.phi[[0, -1]] - self.angle(np.array([stroke])))  # nan beyond them
            if not off.min() > NEAR:
                return float(ends[np.argmin(np.abs(ends - stroke))])
        return None
