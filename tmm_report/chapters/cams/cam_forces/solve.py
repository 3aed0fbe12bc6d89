"""Forces of a cam that stands alone: what its follower needs, what presses it to the cam, the moment of the drive, the
spring that keeps it there, the pressure in the contact.

Source: Artobolevsky, Theory of mechanisms and machines, ch. 26; Levitsky, Cam mechanisms, ch. 5.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from typing import Any, Literal, NamedTuple

import numpy as np

from tmm_report.chapters.cams.cam.given import Forces as Given
from tmm_report.chapters.cams.cam.given import SpringAsked
from tmm_report.chapters.cams.cam.solve.alone import Found as CamAlone
from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.chapters.cams.cam.solve.lifting import BESIDE
from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.mechanics.cams import spring
from tmm_report.mechanics.cams.extremes import Extreme
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.mechanics.cams.forces import Pressed
from tmm_report.mechanics.cams.turn import Loaded, Parts, Spring
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.text import amounts
from tmm_report.records import dataclass

Array = Any
NOTHING = 1e-9  # of the largest: what is rounding
Kind = Literal["chosen", "constant", "unloaded", "half"]
HALF = 0.5


class Held(NamedTuple):
    """A spring that just keeps the follower on the cam: `preload`, N or N m, `rate`, N/m or N m/rad, `greatest` force
    or moment."""

    kind: Kind
    preload: float
    rate: float
    greatest: float


@dataclass(frozen=True, eq=False)
class At:
    """At angles turned, rad, (P,): the follower, what it needs, the forces; `pressure` in the contact, Pa, or None."""

    turned: Array
    moved: tuple[Array, Array, Array]
    parts: Parts
    pressed: Pressed
    pressure: Array | None = None

    @property
    def state(self) -> list[str]:
        """Of each angle whether the cam presses, the follower has left it, or it jams."""
        words = np.where(self.pressed.jams, JAMS, np.where(self.pressed.left, LEFT, PRESSED))
        return [str(word) for word in words]


PRESSED, LEFT, JAMS = N_("the cam presses"), N_("the follower has left the cam"), N_("the follower jams")


@dataclass(frozen=True, eq=False)
class Ends:
    """Least and greatest over a phase, counted from 0: of what the follower needs and of the moment of the drive."""

    phase: int
    needed: tuple[Extreme, Extreme]
    torque: tuple[Extreme, Extreme] | None


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `cam`: the cam itself; `loaded`: with the spring that was found."""

    given: Given
    cam: CamFound
    loaded: Loaded
    table: At
    diagram: At
    asked: At
    springs: tuple[Held, ...]

    @property
    def slides(self) -> bool:
        return self.cam.slides

    @cached_property
    def over(self) -> Panels:
        return self.loaded.panels

    @cached_property
    def whole(self) -> At:
        """At the points of the panels, (K n,)."""
        return _at(self.loaded, self.over.x.ravel())

    def _on(self, values: Array) -> Array:
        return np.asarray(values).reshape(self.over.shape)

    @cached_property
    def drawn(self) -> At:
        """At the angles at which its curves are drawn: a jump stands upright."""
        edges = self.over.edges
        beside = np.clip(np.concatenate([edges - BESIDE, edges]), 0.0, FULL_TURN)
        return _at(
            self.loaded,
            np.unique(np.concatenate([self.diagram.turned, beside, np.linspace(0, FULL_TURN, 145)])),
        )

    @cached_property
    def jams(self) -> bool:
        return bool(self.whole.pressed.jams.any())

    @cached_property
    def jammed(self) -> Extreme:
        """Where least of the cam's force is left by friction, as a part of what it is without."""
        share = np.where(self.whole.parts.whole > 0, self.whole.pressed.share, 1.0)
        k = int(np.argmin(share))
        return Extreme(float(share[k]), float(self.over.x.ravel()[k]))

    @cached_property
    def leaves(self) -> tuple[tuple[float, float], ...]:
        """From and to which angles turned the follower has left the cam, rad."""
        left = self._on(self.whole.pressed.left).all(axis=1)
        edges = self.over.edges
        found: list[tuple[float, float]] = []
        for k in np.flatnonzero(left):
            begin, end = float(edges[k]), float(edges[k + 1])
            if found and found[-1][1] == begin:
                found[-1] = (found[-1][0], end)
            else:
                found.append((begin, end))
        return tuple(found)

    def ends(self, values: Array) -> tuple[Extreme, Extreme] | None:
        """Least and greatest over the turn of what is known everywhere."""
        return _ends(self.over, self._on(values))

    @cached_property
    def needed(self) -> tuple[Extreme, Extreme]:
        found = self.ends(self.whole.parts.whole)
        assert found is not None
        return found

    @cached_property
    def pressing(self) -> tuple[Extreme, Extreme] | None:
        return self.ends(self.whole.pressed.N)

    @cached_property
    def torque(self) -> tuple[Extreme, Extreme] | None:
        return self.ends(self.whole.pressed.torque)

    @cached_property
    def contact(self) -> Extreme | None:
        """The greatest pressure in the contact."""
        if self.whole.pressure is None:
            return None
        found = self.ends(self.whole.pressure)
        return None if found is None else found[1]

    @cached_property
    def mean(self) -> float:
        """Mean moment of the drive, N m; nan where it jams. What springs and inertia give back is nothing."""
        torque = self._on(self.whole.pressed.torque)
        mean = float(self.over.mean(torque))
        return 0.0 if abs(mean) < NOTHING * np.max(np.abs(torque)) else mean

    @cached_property
    def lost(self) -> float:
        """What friction takes in a turn, J."""
        return float(self.over.total(self._on(self.whole.pressed.wasted)))

    @cached_property
    def disagreement(self) -> float:
        """Of the moment of the drive by the forces and by the powers, by its largest."""
        own = self.whole
        balanced = own.parts.whole * own.moved[1] + own.pressed.wasted
        largest = float(np.nanmax(np.abs(own.pressed.torque), initial=0.0)) or 1.0
        return float(np.nanmax(np.abs(own.pressed.torque - balanced), initial=0.0)) / largest

    @cached_property
    def phases(self) -> tuple[Ends, ...]:
        """Of every rise and return."""
        found = []
        edges = np.concatenate([[0.0], np.cumsum([phase.angle for phase in self.cam.phases])])
        for k, phase in enumerate(self.cam.phases):
            if phase.law is None:
                continue
            within = (self.over.edges[:-1] >= edges[k] - NOTHING) & (
                self.over.edges[1:] <= edges[k + 1] + NOTHING
            )
            rows = np.flatnonzero(within)
            own = Panels(self.over.edges[rows[0] : rows[-1] + 2], self.over.order)
            needed = _ends(own, self._on(self.whole.parts.whole)[rows])
            torque = _ends(own, self._on(self.whole.pressed.torque)[rows])
            assert needed is not None
            found.append(Ends(k, needed, torque))
        return tuple(found)

    @cached_property
    def lifts_off(self) -> spring.Reached | None:
        """The speed at which the follower leaves the cam and where; None of one without inertia, or that never does."""
        if not self.loaded.inertia or self.loaded.groove:
            return None
        return self.loaded.lifts_off()

    @cached_property
    def needed_preload(self) -> spring.Reached | None:
        """The least preload with which the stated rate holds the follower at the stated speed."""
        if not self.loaded.inertia or self.loaded.groove or self.given.spring is not None:
            return None
        own = self.whole
        D = -(own.parts.load + own.parts.weight + own.parts.inertia)
        return spring.preload(self.over, self._on(D), self._on(own.moved[0]), self.loaded.spring.rate)

    @property
    def sound(self) -> bool:
        """Whether the follower stays on its cam, moves, and the contact bears it."""
        permitted = self.given.permitted
        return not (
            self.jams or self.leaves or (permitted and self.contact and self.contact.value > permitted)
        )

    def summary(self) -> Iterator[Message]:
        """The main numbers in a sentence."""
        if self.torque is not None:
            text = N_("forces of the cam: greatest moment of the drive %(torque)s N·m, mean %(mean)s N·m")
            yield Message(text, amounts({"torque": self.torque[1].value, "mean": self.mean}))


def _ends(panels: Panels, values: Array) -> tuple[Extreme, Extreme] | None:
    """Least and greatest over panels; None where something is not known."""
    if not np.isfinite(values).all():
        return None
    (low, at), (high, there) = panels.extremes(values)
    return Extreme(low, at), Extreme(high, there)


def solve(given: Given, cam: CamAlone) -> Found:
    loaded, springs = given.loaded, tuple[Held, ...]()
    if given.spring is not None:
        springs = tuple(_springs(given, given.spring))
        loaded = replace(loaded, spring=Spring(springs[0].preload, springs[0].rate))
    turned, drawn = (np.arange(count + 1) * (FULL_TURN / count) for count in (given.table, given.diagram))
    table, diagram, asked = (_at(loaded, x) for x in (turned, drawn, np.array(given.asked)))
    return Found(given, cam.cams[0], loaded, table, diagram, asked, springs)


def _at(loaded: Loaded, turned: Array) -> At:
    lifted, parts, pressed = loaded.whole(turned)
    pressure = loaded.pressure(turned, pressed.N) if loaded.contact else None
    return At(turned, lifted, parts, pressed, pressure)


def _springs(given: Given, asked: SpringAsked) -> Iterator[Held]:
    """The spring that is chosen, then others that just hold. Raises ProblemError where none does."""
    loaded = given.loaded
    over = loaded.panels
    parts, S, h = loaded.parts(over.x), loaded.lifted(over.x)[0], loaded.lift
    D = -(asked.reserve * parts.inertia + parts.load + parts.weight)
    if asked.rate is not None:
        least = spring.preload(over, D, S, asked.rate).value
        chosen = Held("chosen", least, asked.rate, least + asked.rate * h)
    elif asked.preload is not None:
        found = spring.rate(over, D, S, asked.preload)
        if found is None:
            raise ProblemError([_weak(given, asked.preload)])
        chosen = Held("chosen", asked.preload, found.value, asked.preload + found.value * h)
    elif asked.ratio is not None:
        chosen = _of_ratio("chosen", given, over, D, S, asked.ratio)
    else:
        own = spring.smallest(over, D, S, h)
        chosen = Held("chosen", own.preload, own.rate, own.greatest)
    yield chosen
    most = max(over.extremes(D)[1][0], 0.0)
    yield Held("constant", most, 0.0, most)
    yield _of_ratio("half", given, over, D, S, HALF)
    steep = spring.rate(over, D, S, 0.0)
    if steep is not None:
        yield Held("unloaded", 0.0, steep.value, steep.value * h)


def _of_ratio(kind: Kind, given: Given, over: Panels, D: Array, S: Array, ratio: float) -> Held:
    found = spring.of_ratio(over, D, S, given.loaded.lift, ratio)
    if found is None:
        raise ProblemError([_weak(given, 0.0)])
    return Held(kind, ratio * found.value, (1 - ratio) * found.value / given.loaded.lift, found.value)


def _weak(given: Given, preload: float) -> Any:
    key = "spring" if given.loaded.slides else "torsion"
    text = N_(
        "no rate holds the follower with the preload %(preload)s: it is lifted off where the spring is not yet drawn"
    )
    unit = "N" if given.loaded.slides else "N·m"
    right = Message(N_("a larger preload, or preload: smallest with a rate"))
    return mistake(text, ("cam", key), right, preload=f"{preload:.4g} {unit}")
