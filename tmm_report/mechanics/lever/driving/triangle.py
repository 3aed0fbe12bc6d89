"""A driving slider or cylinder whose stroke the link follows by a triangle, in closed form.

    slider                       cylinder
          P                            P
        /   \\ d                      /  \\ d = s
      r/      \\                    r/     \\
      O        Q → e               O        Q (fixed)

The link OP turns about the fixed point O; its pin P is at the distance d from Q. Of a slider Q moves along its guide,
Q = Q₀ + s e, and d is the rod; of a cylinder Q is fixed, and d = s is its length. So the triangle OPQ gives the angle
of the link, and |P − Q|² = d², differentiated once and twice, its rates. Source: Artobolevsky, Theory of mechanisms
and machines, ch. 4.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.motion_laws import MotionLaw, Three
from tmm_report.mechanics.calculus.vectors import cross, dot, unit
from tmm_report.mechanics.lever.driving.stroke import Stroke, Taken
from tmm_report.records import dataclass

Array = Any
SAMPLES = 2000  # of a stroke, between which its limits are looked for
NEAR = 1e-6  # sine of an angle of the triangle below which the mechanism is in a limit position


@dataclass(frozen=True, eq=False)
class Triangle(Stroke):
    """The triangle by which the link OP, `link`, follows the stroke; lengths in m, places in the axes of the frame.

    `pin`: P from O in the axes of the link; `start`, `way`: Q₀ and e, of a cylinder Q and 0; `rod`: d, of a cylinder 0;
    `side`: +1 where P is to the left of the way from O to Q; `names`: of the points O, P, Q.
    """

    law: MotionLaw
    link: str
    pivot: complex
    pin: complex
    start: complex
    way: complex
    rod: float
    side: int
    names: tuple[str, str, str]
    by: tuple[str, ...]
    takes: tuple[Taken, ...]

    @property
    def ends(self) -> tuple[str, ...]:  # type: ignore[override]
        _, pin, far = self.names
        return (far,) if self.slides else (far, pin)

    @property
    def crank(self) -> float:
        """r, m."""
        return abs(self.pin)

    def far(self, s: Array) -> Array:
        """Q from O at strokes s, complex, m."""
        return self.start + self.way * np.asarray(s, dtype=float) - self.pivot

    def distance(self, s: Array) -> Array:
        """d = |PQ| at strokes s, m."""
        return self.rod + 0 * s if self.slides else np.asarray(s, dtype=float)

    def cosine(self, s: Array) -> Array:
        """Of the angle QOP; beyond −1 … 1 there is no such triangle."""
        far, d = np.abs(self.far(s)), self.distance(s)
        return (self.crank**2 + far**2 - d**2) / (2 * self.crank * far)

    def angle(self, s: Array) -> Array:
        """Angle of the link's x axis from that of the frame, without jumps over the stroke, rad."""
        start = self.far(self.law.at(np.zeros(1))[0])[0]
        base = np.angle(start) + np.angle(self.far(s) / start)
        return base + self.side * np.arccos(self.cosine(s)) - np.angle(self.pin)

    def arms(self, s: Array) -> tuple[Array, Array]:
        """P from O and P from Q at strokes s, complex, m."""
        p = self.pin * np.exp(1j * self.angle(s))
        return p, p - self.far(s)

    def rates(self, s: Array, v: Array, a: Array) -> Three:
        """Angle of the link, its angular velocity and acceleration at strokes s with the rates v, m/s, and a, m/s²."""
        p, c = self.arms(s)
        d, grows = self.distance(s), 0.0 if self.slides else 1.0
        arm = dot(c, 1j * p)
        omega = (d * grows * v + dot(c, self.way * v)) / arm
        turned = 1j * omega * p - self.way * v
        square = (grows * v) ** 2 + d * grows * a - np.abs(turned) ** 2
        epsilon = (square + omega**2 * dot(c, p) + dot(c, self.way * a)) / arm
        return self.angle(s), omega, epsilon

    def limit(self) -> float | None:
        """Of the strokes that the law goes over the first one, from its beginning, in which the mechanism cannot go on,
        m: P, O and Q in one line, or, of a slider, the rod across its guide, where the link stops and turns back."""
        begin = float(self.law.at(np.zeros(1))[0][0])
        for end in self.law.reach:
            s = np.linspace(begin, end, SAMPLES + 1)
            with np.errstate(invalid="ignore"):
                p, c = self.arms(s)
                sine = np.abs(cross(unit(p), unit(c)))
                along = dot(unit(c), self.way) if self.slides else np.ones(s.shape)
            lost = ~(sine > NEAR) | ~(np.abs(along) > NEAR) | (along * along[0] < 0)
            if lost.any():
                return float(s[np.flatnonzero(lost)[0]])
        return None

    def place(self, s: float) -> tuple[complex, complex]:
        """P and Q at a stroke, complex, m."""
        p, c = self.arms(np.array([s]))
        return complex(self.pivot + p[0]), complex(self.pivot + p[0] - c[0])
