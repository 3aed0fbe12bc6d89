"""Laws of the coefficient of friction by the velocity of sliding: a table, Stribeck's law."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any, ClassVar, Self

import numpy as np

from tmm_report.mechanics.calculus.laws import DOUBLES, SLIDING, Arithmetic, Law, Lines, Numbers, times
from tmm_report.records import dataclass


@dataclass(frozen=True)
class BySliding(Lines):
    """Coefficients of friction at velocities of sliding, m/s, that ascend."""

    of: ClassVar[str] = SLIDING
    speeds: Numbers
    values: Numbers

    def points(self) -> tuple[Numbers, Numbers]:
        return self.speeds, self.values

    @property
    def resolving(self) -> Numbers:
        """Velocities at which it has a corner; none of a table that is constant."""
        slopes = [0.0, *self.slope(np.array(self.speeds))]
        return tuple(
            at for at, (one, other) in zip(self.speeds, pairwise(slopes), strict=True) if at and one != other
        )


@dataclass(frozen=True)
class Stribeck(Law):
    """A coefficient of friction that falls from rest to motion and grows again with a viscous part,
    f_k + (f_s − f_k) exp(−(v/v_s)ⁿ) + k_v v. `speed`: v_s, m/s; `viscous`: k_v, s/m; `exponent`: n, 1 or 2
    (Armstrong-Hélouvry, Dupont, Canudas de Wit, Automatica 30 (1994), p. 1083)."""

    of: ClassVar[str] = SLIDING
    static: float
    kinetic: float
    speed: float
    viscous: float = 0.0
    exponent: int = 1

    def value(self, at: Any, which: Any = 0, numbers: Arithmetic = DOUBLES) -> Any:
        moving, falls, speed, viscous = (
            numbers.full(one, at)
            for one in (self.kinetic, self.static - self.kinetic, self.speed, self.viscous)
        )
        return moving + falls * numbers.exp(-((at / speed) ** self.exponent)) + viscous * at

    @property
    def resolving(self) -> Numbers:
        """Velocities between which the exponential is next to a polynomial."""
        return times((1.0, 2.5, 6.0, 14.0), self.speed)

    def scaled(self, factor: float) -> Self:
        static, kinetic, viscous = times((self.static, self.kinetic, self.viscous), factor)
        return replace(self, static=static, kinetic=kinetic, viscous=viscous)


Rubs = BySliding | Stribeck
