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
from tmm_report.mechanics.cams.cam import ByLaw, Cam, Sliding
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
        return self._smooth.extremes(self._lift(self._smooth.x)[0])[0][0]

    @cached_property
    def _smooth(self) -> Panels:
        return panels(FULL_TURN, self.breaks)

    def _lift(self, turned: Array) -> tuple[Array, Array, Array]:
        return lift_of(self.cam, self.phi(turned), self.sense)

    def lifted(self, turned: Array) -> tuple[Array, Array, Array]:
        """S, S', S'' by the angle turned in the sense of rotation; m or rad."""
        q, first, second = self._lift(turned)
        return q - self.low, first, second

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

    def acting(self, turned: Array) -> Array:
        """The load, N or N m, against the lift."""
        turned = np.asarray(turned, dtype=float)
        if self.load.of == laws.TRAVEL:
            S = self.lifted(turned)[0]
            return self.load.value(np.clip(S / self.lift, 0.0, 1.0), self._back(turned))
        return self.load.value(np.mod(turned, FULL_TURN))

    def _back(self, turned: Array) -> Array:
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
        return (self.lifted(turned)[1] < 0).astype(int)

    def parts(self, turned: Array) -> Parts:
        S, _, second = self.lifted(turned)
        return Parts(
            self.acting(turned) + 0 * S,
            self._weight(turned) + 0 * S,
            self.spring.preload + self.spring.rate * S,
            self.inertia * self.omega**2 * second,
        )

    def _weight(self, turned: Array) -> Array:
        motion = self.cam.motion
        if isinstance(motion, Sliding):
            return -self.mass * dot(self.gravity, motion.along)
        return -self.mass * motion.side * cross(self._centre(turned), self.gravity)

    def _centre(self, turned: Array) -> Array:
        """Of one that swings, its centre of mass from the pivot, world axes."""
        return self.centre * self.cam.turn(self.cam.moved(self.phi(turned))[0].z)

    def _beside(self, turned: Array) -> Array:
        """What bears on the pivot of one that swings beside the cam: weight and inertia of its mass."""
        if self.slides or not self.mass:
            return 0j
        q = self.cam.moved(self.phi(turned))[0]
        moves = (1j * q.dd - q.d**2) * self._centre(turned) * self.omega**2
        return self.mass * (self.gravity - moves)

    # ------------------------------------------------------------ the forces

    def at(self, turned: Array) -> Pressed:
        """Forces at angles turned, (P,)."""
        Q = self.parts(turned).whole
        needs = Needs(Q, self._beside(turned))
        S = self.lifted(turned)[0]
        return pressed(self.cam, self.phi(turned), self.sense, needs, self.rubs, S, self.groove)

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
        S, slope, _ = self.lifted(first.x)
        turning = [np.where(ways(slope) == 0, 0.0, slope), self.parts(first.x).whole]
        motion = self.cam.motion
        if isinstance(motion, Sliding):
            here = touching(self.cam, self.phi(first.x), self.sense, self.rubs)
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
        parts = self.parts(over.x)
        holds = parts.load + parts.weight + parts.spring
        return lifts_off(over, holds, self.inertia, self.lifted(over.x)[2])


def _passing(over: Panels, values: Array) -> Array:
    """Where a function passes through zero by more than rounding."""
    least = 1e-12 * np.max(np.abs(values), initial=0.0)
    return over.roots(np.where(np.abs(values) > least, values, 0.0)) if least > 0 else np.zeros(0)
