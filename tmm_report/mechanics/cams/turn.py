"""A loaded follower over a turn of its cam: what it needs, part by part, and the forces that follow, between all kinks.

    Q = P + G + F₀ + cS + mω²S''          of one that swings: moments, J in place of m, the angle in place of S

The turn is cut where the law's acceleration, the load or its direction of friction may jump, so that work, extremes and
where the follower leaves its cam are found to rounding.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus import laws
from tmm_report.mechanics.calculus.panels import Panels, panels
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.cams.cam import ByLaw, Cam, Moved, Sliding
from tmm_report.mechanics.cams.contact_pressure import Material, curvature, hertz
from tmm_report.mechanics.cams.follower_laws import EDGE, FULL_TURN, Phases
from tmm_report.mechanics.cams.forces import Needs, Pressed, Rubs, bears, lift_of, pressed, touching, ways
from tmm_report.mechanics.cams.kinks import kinks
from tmm_report.mechanics.cams.spring import Reached, lifts_off
from tmm_report.records import dataclass

Array = Any


class Spring(NamedTuple):
    """`preload`: in the lowest position, N or N m; `rate`, N/m or N m/rad."""

    preload: float
    rate: float


class Parts(NamedTuple):
    """What the follower needs, part by part, (P,): load, weight, spring, inertia; N or N m along the lift."""

    load: Array
    weight: Array
    spring: Array
    inertia: Array

    @property
    def whole(self) -> Array:
        return self.load + self.weight + self.spring + self.inertia


class Whole(NamedTuple):
    """`lifted`: S, S', S'' by the angle turned."""

    lifted: tuple[Array, Array, Array]
    parts: Parts
    pressed: Pressed


class Contact(NamedTuple):
    """`width` of the contact, m; the materials of cam and follower."""

    width: float
    cam: Material
    follower: Material


@dataclass(frozen=True, eq=False)
class Loaded:
    """A follower with its loads. `sense`: of rotation, +1 counter-clockwise; `omega`: rad/s; `begin`: the cam's x axis
    where angles turned count from, rad. `inertia`: kg of one that slides, kg m² about its pivot of one that swings;
    `mass`, kg, with `centre` of it from the pivot (of one that swings, in its own axes, m): of its weight under
    `gravity`, m/s², complex, and of what its pivot bears. `load`: against the lift; of the angle turned from `begin`,
    or of the part of the lift. `groove`: the cam holds the follower by a second wall."""

    cam: Cam
    sense: int
    omega: float
    begin: float = 0.0
    inertia: float = 0.0
    mass: float = 0.0
    centre: complex = 0j
    gravity: complex = 0j
    load: laws.Law = laws.Constant(0.0)
    spring: Spring = Spring(0.0, 0.0)
    rubs: Rubs = Rubs()
    groove: bool = False
    contact: Contact | None = None

    @property
    def slides(self) -> bool:
        return isinstance(self.cam.motion, Sliding)

    def phi(self, turned: Array) -> Array:
        return self.begin + self.sense * np.asarray(turned)

    @cached_property
    def low(self) -> float:
        """The coordinate in the sense of the lift from which displacements count."""
        given = self.cam.given
        if isinstance(given, ByLaw):
            return given.side * given.low
        return self._smooth.extremes(lift_of(self.cam, self._moved(self._smooth.x)[0], self.sense)[0])[0][0]

    @cached_property
    def _smooth(self) -> Panels:
        return panels(FULL_TURN, self.breaks)

    def _moved(self, turned: Array) -> tuple[Moved, Moved]:
        return self.cam.moved(self.phi(turned))

    def lifted(self, turned: Array) -> tuple[Array, Array, Array]:
        """S, S', S'' by the angle turned in the sense of rotation; m or rad."""
        return self._lifted(self._moved(turned)[0])

    def _lifted(self, q: Moved) -> tuple[Array, Array, Array]:
        S, first, second = lift_of(self.cam, q, self.sense)
        return S - self.low, first, second

    @cached_property
    def lift(self) -> float:
        """The greatest displacement, m or rad."""
        given = self.cam.given
        if isinstance(given, ByLaw):
            return given.law.lift
        return self._smooth.extremes(self.lifted(self._smooth.x)[0])[1][0]

    @cached_property
    def breaks(self) -> Array:
        """Angles turned at which the acceleration or its rate may jump, rad."""
        return np.mod(self.sense * (np.array([*kinks(self.cam)]) - self.begin), FULL_TURN)

    # ------------------------------------------------------------ what the follower needs

    def _acting(self, turned: Array, S: Array, first: Array) -> Array:
        """The load, N or N m, against the lift."""
        if self.load.of == laws.TRAVEL:
            return self.load.value(np.clip(S / self.lift, 0.0, 1.0), self._back(turned, first))
        return self.load.value(np.mod(turned, FULL_TURN))

    def _back(self, turned: Array, first: Array) -> Array:
        """1 on the way back, and in the low dwell after it; 0 on the way out and in the high dwell."""
        given = self.cam.given
        if isinstance(given, ByLaw) and isinstance(given.law, Phases):
            law = given.law
            theta = np.mod(given.theta(self.phi(turned)) + EDGE, FULL_TURN)
            k = np.clip(np.searchsorted(law.edges, theta, side="right") - 1, 0, len(law.phases) - 1)
            kinds = [phase.kind for phase in law.phases]
            last, found = next((one for one in reversed(kinds) if one != "dwell"), "return"), []
            for kind in kinds:
                last = last if kind == "dwell" else kind
                found.append(last == "return")
            return np.array(found, dtype=int)[k]
        return (first < 0).astype(int)

    def parts(self, turned: Array) -> Parts:
        return self._parts(turned, self._moved(turned)[0])

    def _parts(self, turned: Array, q: Moved) -> Parts:
        S, first, second = self._lifted(q)
        return Parts(
            self._acting(np.asarray(turned, dtype=float), S, first) + 0 * S,
            self._weight(q) + 0 * S,
            self.spring.preload + self.spring.rate * S,
            self.inertia * self.omega**2 * second,
        )

    def _weight(self, q: Moved) -> Array:
        motion = self.cam.motion
        if isinstance(motion, Sliding):
            return -self.mass * dot(self.gravity, motion.along)
        return -self.mass * motion.side * cross(self._centre(q), self.gravity)

    def _centre(self, q: Moved) -> Array:
        """Of one that swings, its centre of mass from the pivot, world axes."""
        return self.centre * self.cam.turn(q.z)

    def _beside(self, q: Moved) -> Array:
        """What bears on the pivot of one that swings beside the cam: weight and inertia of its mass."""
        if self.slides or not self.mass:
            return 0j
        moves = (1j * q.dd - q.d**2) * self._centre(q) * self.omega**2
        return self.mass * (self.gravity - moves)

    # ------------------------------------------------------------ the forces

    def at(self, turned: Array) -> Pressed:
        """Forces at angles turned, (P,)."""
        return self.whole(turned).pressed

    def whole(self, turned: Array) -> Whole:
        """Motion, what is needed and forces at angles turned, (P,)."""
        moved = self._moved(turned)
        lifted, parts = self._lifted(moved[0]), self._parts(turned, moved[0])
        needs = Needs(parts.whole, self._beside(moved[0]))
        found = pressed(self.cam, moved, self.sense, needs, self.rubs, lifted[0], self.groove)
        return Whole(lifted, parts, found)

    def pressure(self, turned: Array, N: Array) -> Array:
        """Pressure in the contact, Pa, where the cam presses."""
        assert self.contact is not None
        outer = (N < 0) & self.groove
        pressing = np.where(outer, -N, np.maximum(N, 0.0))
        curved = curvature(self.cam, self.phi(turned), outer)
        return hertz(pressing, self.contact.width, curved, self.contact.cam, self.contact.follower)

    @cached_property
    def panels(self) -> Panels:
        """Over a turn, with edges where the load jumps, where the follower turns back, where what bears on the guide
        changes its side, and where the cam ceases to press."""
        marks = [*self.breaks, *self._load_breaks()]
        first = panels(FULL_TURN, marks)
        moved = self._moved(first.x)
        S, slope, _ = self._lifted(moved[0])
        turning = [np.where(ways(slope) == 0, 0.0, slope), self._parts(first.x, moved[0]).whole]
        motion = self.cam.motion
        if isinstance(motion, Sliding):
            here = touching(self.cam, moved, self.sense, self.rubs)
            ends = bears(motion, here, self.rubs.guide, S)
            turning += [] if ends is None else [*ends]
        roots = [root for function in turning for root in _passing(first, function)]
        return panels(FULL_TURN, [*first.edges[:-1], *roots])

    def _load_breaks(self) -> list[float]:
        if self.load.of == laws.ANGLE:
            return [one.at for one in self.load.breaks(FULL_TURN)]
        if self.load.of != laws.TRAVEL:
            return []
        S = self.lifted(self._smooth.x)[0]
        return [
            float(root)
            for one in self.load.breaks()
            if 0 < one.at < 1
            for root in self._smooth.roots(S - one.at * self.lift)
        ]

    def lifts_off(self) -> Reached | None:
        """At which speed, rad/s, and where the follower leaves the cam."""
        over = self.panels
        q = self._moved(over.x)[0]
        parts = self._parts(over.x, q)
        holds = parts.load + parts.weight + parts.spring
        return lifts_off(over, holds, self.inertia, self._lifted(q)[2])


def _passing(over: Panels, values: Array) -> Array:
    """Where a function passes through zero by more than rounding."""
    least = 1e-12 * np.max(np.abs(values), initial=0.0)
    return over.roots(np.where(np.abs(values) > least, values, 0.0)) if least > 0 else np.zeros(0)
