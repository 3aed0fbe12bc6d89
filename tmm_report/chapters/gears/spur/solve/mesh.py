"""The mesh on paper, in millimetres: where its wheels and points stand.

The pitch point is at 0, the line of centres goes upwards, wheel `small` (of an internal pair the pinion) is below it
and turns counter-clockwise where it drives. Contact moves along the line of action from A to B.
"""

from __future__ import annotations

import cmath
import math
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.gears import tooth_outlines
from tmm_report.mechanics.gears.involute import inv
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.mechanics.gears.tooth_outlines import Wheel
from tmm_report.records import dataclass

Array = Any

TOOTH = 40.0  # mm: the teeth are drawn at least so high
COLUMN = 20.0  # mm: beside the teeth, for the labels of the circles
EDGE = 1.0  # mm: how far circles run past the teeth
# millimetres of paper for one of the wheels: the scales of GOST 2.302
SCALES = (
    0.01, 0.02, 0.025, 0.04, 0.05, 0.1, 0.2, 0.25, 0.4, 0.5, 1, 2, 2.5, 4, 5, 10, 20, 40, 50, 100, 200, 400, 500, 1000,
)  # fmt: skip
TALL = 60.0  # mm: the ordinates of the graph of specific sliding are no longer
ROUND = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0)
FINE = 2e-3  # mm of paper: how true the curves are


def round_scale(largest: float) -> float:
    """1/mm: the smallest round scale at which the ordinate of a value is no longer than TALL."""
    power = 10.0 ** math.floor(math.log10(largest / TALL))
    return next(n * power for n in ROUND if n * power >= largest / TALL * (1 - 1e-9))


@dataclass(frozen=True)
class Proof:
    """Of the outlines over a full pitch: largest overlap, m², smallest clearance, m, and contact ratio, counted."""

    overlap: float
    clearance: float
    ratio: float


@dataclass(frozen=True, eq=False)
class Mesh:
    """A pair as it is drawn: wheels 0 and 1 of `pair`. `places`: radii of curvature of wheel 0 at A, C, P, D, B, m."""

    pair: Pair
    places: dict[str, float]

    @cached_property
    def small(self) -> int:
        """The wheel that is drawn below the pitch point: wheel 1, but never the ring."""
        return int(self.pair.signs[0] < 0)

    @cached_property
    def scale(self) -> float:
        """Millimetres of paper for 1 mm: the smallest standard scale at which the teeth are high enough."""
        height = 1e3 * float(np.min(self.pair.height))
        return next(k for k in SCALES if k * height >= TOOTH or k == SCALES[-1])

    @property
    def half_width(self) -> float:
        """Of the drawing, mm: three pitches of the working circles are seen."""
        return EDGE + self.length(1.5 * float(self.pair.p_w))

    def seen(self, name: str) -> bool:
        """Whether a point of the line of action is on the drawing: N1 and N2 may lie beyond its edge."""
        return abs(self.points[name].real) <= self.reach

    @property
    def reach(self) -> float:
        """How far from the line of centres the line of action is seen, mm: as far as the labels of the circles."""
        return self.half_width + COLUMN

    @property
    def mm(self) -> float:
        """Millimetres of paper for 1 m."""
        return 1e3 * self.scale

    def length(self, metres: float) -> float:
        return float(metres) * self.mm

    def radius(self, diameters: tuple[Array, Array], i: int) -> float:
        """Half of one of the pair's diameters on paper, mm."""
        return self.length(diameters[i]) / 2

    @cached_property
    def proof(self) -> Proof:
        """By the outlines over a full pitch: as long as ten solutions, so it is made when it is asked for."""
        wheels = self.wheels[self.small], self.wheels[1 - self.small]
        distance = float(self.pair.a_w)
        shared, apart = tooth_outlines.over_pitch(*wheels, distance)
        return Proof(float(shared.max()), float(apart.min()), tooth_outlines.contact_ratio(*wheels, distance))

    # ------------------------------------------------------------ wheels

    @cached_property
    def wheels(self) -> tuple[Wheel, Wheel]:
        """Outlines in metres."""
        return self._wheel(0), self._wheel(1)

    def _wheel(self, i: int) -> Wheel:
        p, fine = self.pair, FINE / self.mm
        z, x = int((p.z1, p.z2)[i]), float((p.x1, p.x2)[i]) * math.cos(p.beta)
        tip, root, size = float(p.d_a[i]) / 2, float(p.d_f[i]) / 2, float(p.m_t)
        if p.signs[i] < 0:
            return tooth_outlines.ring(z, size, x, p.t, tip, root, tolerance=fine)
        return tooth_outlines.external(z, size, x, p.t, tip, tolerance=fine)

    def centre(self, i: int) -> complex:
        """Centre of a wheel on paper, mm."""
        below = i == self.small or self.pair.internal
        return (-1j if below else 1j) * self.radius(self.pair.d_w, i)

    def turn(self, i: int, place: float = 0.0) -> float:
        """Turn of a wheel whose flank touches at `place`, m along the line of action from the pitch point, rad."""
        wheel, small = self.wheels[i], self.wheels[self.small]
        half = float(small.base_angle - inv(self.pair.alpha_w))
        turned = place / small.base - half
        if i != self.small:
            turned = float(tooth_outlines.touching_turn(small, wheel, float(self.pair.a_w), turned))
        return math.pi / 2 + turned

    def outline(self, i: int, place: float = 0.0) -> Array:
        return self.centre(i) + self.mm * self.wheels[i].outline * cmath.exp(1j * self.turn(i, place))

    def flank(self, i: int, radii: Array, place: float = 0.0, tooth: int = 0) -> Array:
        """Points of the working flank that touches at `place`, or some teeth on, at `radii` in m; mm of paper."""
        wheel = self.wheels[i]
        own = wheel.flank(radii, tooth + int(wheel.internal), -1 if wheel.internal else 1)
        return self.centre(i) + self.mm * own * cmath.exp(1j * self.turn(i, place))

    # ------------------------------------------------------------ line of action

    @property
    def along(self) -> complex:
        """Unit vector of the line of action, from N of the wheel below to the pitch point and beyond."""
        return 1j * 1j * cmath.exp(-1j * float(self.pair.alpha_w))

    def place(self, name: str) -> float:
        """Of A, C, P, D, B: m along the line of action from the pitch point."""
        return self.places[name] - self.places["P"]

    @cached_property
    def points(self) -> dict[str, complex]:
        """N1, N2 and the points of the line of action on paper, mm."""
        ends = {f"N{i + 1}": self.centre(i) + self._foot(i) for i in (0, 1)}
        return ends | {name: self.length(self.place(name)) * self.along for name in self.places}

    def _foot(self, i: int) -> complex:
        """From the centre of a wheel to the point where the line of action touches its base circle."""
        up = -1 if i != self.small and not self.pair.internal else 1
        return up * 1j * self.radius(self.pair.d_b, i) * cmath.exp(-1j * float(self.pair.alpha_w))

    @property
    def sense(self) -> int:
        """+1 where the wheel below turns counter-clockwise as the contact goes from A to B."""
        return 1 if self.place("B") > self.place("A") else -1

    def on_working_circle(self, i: int, place: float = 0.0, tooth: int = 0) -> complex:
        """Where the working flank of a wheel, as drawn by its chords, crosses the working circle; mm of paper."""
        working = float(self.pair.d_w[i]) / 2
        radii = np.linspace(max(self.wheels[i].base, 0.97 * working), 1.03 * working, 17)
        drawn = self.flank(i, radii, place, tooth)
        far = np.abs(drawn - self.centre(i)) - self.radius(self.pair.d_w, i)
        k = int(np.flatnonzero(far[:-1] * far[1:] <= 0)[0])
        return complex(drawn[k] - far[k] * (drawn[k + 1] - drawn[k]) / (far[k + 1] - far[k]))
