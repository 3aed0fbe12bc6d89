"""Sizes by which a cut wheel is measured: span over teeth, chords, pins and balls; external and internal, helical too.

All of them follow from the thicknesses on the base circle and the base pitch, for gauges touch involutes along their
normals. Lengths in m, angles in rad; arguments broadcast. Symbols and rules: GOST 16532 (external), 19274 (internal).
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.roots import root_between
from tmm_report.mechanics.gears.involute import inv, inverse
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Gauged:
    """Wheel `i` (0, 1) of a pair as gauges meet it. `width`: of its face, None where nobody says it; `thinned`: by how
    much its teeth are thinner than those without backlash, along the arc of the pitch circle in the normal section."""

    pair: Pair
    i: int
    width: float | None = None
    thinned: float = 0.0

    @cached_property
    def ring(self) -> bool:
        return bool(self.pair.signs[self.i] < 0)

    @cached_property
    def z(self) -> int:
        return int((self.pair.z1, self.pair.z2)[self.i])

    @cached_property
    def shift(self) -> float:
        """As it is stated, above zero outwards."""
        return float((self.pair.x1, self.pair.x2)[self.i])

    @cached_property
    def beta_b(self) -> float:
        """Angle of the helix on the base cylinder."""
        return float(self.pair.beta_b)

    def of(self, key: str) -> float:
        """A size of this wheel by its name in `Pair`."""
        return float(getattr(self.pair, key)[self.i])

    @cached_property
    def s(self) -> float:
        """Thickness on the pitch circle, as it is left."""
        return self.of("s") - self.thinned / float(np.cos(self.pair.beta))

    @cached_property
    def _solid(self) -> float:
        """Arc of the base circle between the flanks that a span holds: of a tooth, of a ring's space."""
        tooth = self.of("d_b") * (
            self.s / self.of("d") + (-1 if self.ring else 1) * float(inv(self.pair.t.alpha))
        )
        return float(self.pair.p_b) - tooth if self.ring else tooth

    # ------------------------------------------------------------ involute

    @cached_property
    def involute(self) -> tuple[float, float]:
        """Least and greatest radius of curvature of the flank: where its involute begins and ends; a tooth may come to
        a point before its tip circle."""
        if self.ring:
            return self.of("rho_a"), self.of("starts")
        point = self.of("d_b") / 2 * np.tan(inverse(self._solid / self.of("d_b")))
        return max(self.of("starts"), 0.0), min(self.of("rho_a"), float(point))

    @cached_property
    def active(self) -> tuple[float, float]:
        """The same of the profile that works with the other wheel."""
        low, high = self.involute
        lower = self.of("rho_p")
        return (low, min(lower, high)) if self.ring else (max(lower, low), high)

    @cached_property
    def pointed(self) -> bool:
        """Whether the teeth end below their tip circle, from which heights are measured."""
        return self.of("s_a") <= 0

    def at(self, rho: Array) -> Array:
        """Diameter where the flank has this radius of curvature."""
        return 2 * np.hypot(self.of("d_b") / 2, rho)

    # ------------------------------------------------------------ span

    def span(self, count: Array) -> Array:
        """W over `count` teeth, between two parallel planes; of a straight ring over its spaces, by two spheres."""
        return ((count - 1) * self.pair.p_b + self._solid) * np.cos(self.beta_b)

    def span_touches(self, count: Array) -> Array:
        """Radius of curvature of the flank (transverse) where the span touches it."""
        return self.span(count) * np.cos(self.beta_b) / 2

    @cached_property
    def rule(self) -> float:
        """Number of teeth with which the span would touch half way up, at d + 2xm; nan where that is no involute."""
        rise = (self.of("d") + 2 * self.shift * self.pair.m) / self.of("d_b")
        if rise < 1:
            return float("nan")
        wanted = self.of("d_b") * float(np.sqrt(rise**2 - 1)) / np.cos(self.beta_b) ** 2
        return 1 + float((wanted - self._solid) / self.pair.p_b)

    @property
    def spannable(self) -> bool:
        """Not a helical ring, inside which planes and spheres find no normal to stand on."""
        return not (self.ring and self.pair.beta)

    def spans(self, within: tuple[float, float], narrow: bool = True) -> Array:
        """Numbers of teeth whose span touches the flanks `within` these radii of curvature, and both of them on the
        face of helical teeth unless not `narrow`."""
        if not self.spannable:
            return np.array([], dtype=int)
        count = np.arange(1, self.z // 2 + 2)
        rho = self.span_touches(count)
        fits = (within[0] < rho) & (rho < within[1])
        if narrow and self.width is not None:
            fits &= self.span(count) * abs(np.sin(self.beta_b)) < self.width
        return count[fits]

    # ------------------------------------------------------------ pins and balls

    def pin_angle(self, D: Array) -> Array:
        """Transverse profile angle on the circle of the centres of pins or balls that lie in opposite spaces."""
        wide = D / np.cos(self.beta_b)
        room = self._solid - wide if self.ring else wide + self._solid - self.pair.p_b
        return inverse(room / self.of("d_b"))

    def pin_centres(self, D: Array) -> Array:
        """Diameter of the circle of their centres."""
        return self.of("d_b") / np.cos(self.pin_angle(D))

    def pin_touches(self, D: Array) -> Array:
        """Radius of curvature of the flank where they touch it."""
        aside = D * np.cos(self.beta_b) / 2
        return self.of("d_b") / 2 * np.tan(self.pin_angle(D)) + (aside if self.ring else -aside)

    def over(self, D: Array) -> Array:
        """M over two of them, of a ring between them; with an odd number of teeth they are not opposite."""
        chord = self.pin_centres(D) * (np.cos(np.pi / (2 * self.z)) if self.z % 2 else 1.0)
        return chord - D if self.ring else chord + D

    def pin_fits(self, D: Array) -> Array:
        """Whether they touch involutes, stand out beyond the tips and do not touch the root circle."""
        rho, centres, (low, high) = self.pin_touches(D), self.pin_centres(D), self.involute
        way = -1 if self.ring else 1
        beyond = way * (centres + way * D - self.of("d_a")) > 0
        above = way * (centres - way * D - self.of("d_f")) > 0
        if self.z % 2 and not self.ring:  # an anvil reaches over the teeth beside an odd pin
            corner = np.pi / (2 * self.z) - max(self.of("s_a"), 0.0) / self.of("d_a")
            beyond &= self.over(D) > self.of("d_a") * np.cos(max(corner, 0.0))
        return (self.pin_angle(D) > 0) & (low < rho) & (rho < high) & beyond & above

    # ------------------------------------------------------------ chords

    def chord(self, d: Array) -> tuple[Array, Array]:
        """Chordal thickness on the circle of diameter d, and the distance to it from the tip; of helical teeth across
        them, on the circle that follows the ellipse of the normal section there."""
        middle, half = self._normal(d)
        sag = middle * np.sin(half / 2) ** 2
        if not self.ring:
            return middle * np.sin(half), (self.of("d_a") - d) / 2 + sag
        return middle * np.sin(half), (d - self.of("d_a")) / 2 - sag + self.tip_sag

    def _normal(self, d: Array) -> tuple[Array, Array]:
        """Diameter of curvature of the normal section of the cylinder d, and half the angle of a tooth in it."""
        turn = np.cos(np.arctan(np.tan(self.pair.beta) * d / self.of("d")))
        tooth = self.pair.thickness((d, d))[self.i] - (self.of("s") - self.s) * d / self.of("d")
        return d / turn**2, tooth * turn**3 / d

    def chord_below(self, height: float) -> float:
        """Chord where a caliper that is set to a distance from the tip stands on the tooth; nan where that is beyond
        the involutes."""
        ends = np.array([float(self.at(rho)) for rho in self.involute])
        left = self.chord(ends)[1] - height
        if not left[0] * left[1] <= 0:
            return float("nan")
        return float(self.chord(root_between(lambda d: self.chord(d)[1] - height, *ends))[0])

    @cached_property
    def tip_sag(self) -> float:
        """By how much the corners of a ring's hollow tip stand out of its middle: a caliper stands on them."""
        middle, half = self._normal(self.of("d_a"))
        return float(middle * np.sin(half / 2) ** 2) if self.ring else 0.0

    @cached_property
    def constant_chord(self) -> tuple[float, float]:
        """Between the points where the rack's flanks touch a tooth that stands in the middle of its space; and the
        distance to it from the tip."""
        s, alpha = self.s * np.cos(self.pair.beta), self.pair.rack.alpha  # in the normal section
        head = (self.of("d") - self.of("d_a") if self.ring else self.of("d_a") - self.of("d")) / 2
        return float(s * np.cos(alpha) ** 2), float(head - s * np.sin(2 * alpha) / 4 + self.tip_sag)

    @cached_property
    def chord_touches(self) -> float:
        """Radius of curvature of the flank where the constant chord ends."""
        aside = self.s * np.cos(self.pair.beta) * np.cos(self.pair.rack.alpha) * np.cos(self.beta_b) / 2
        base = self.of("d_b") * np.tan(self.pair.t.alpha) / 2
        return float(base - aside if self.ring else base + aside)
