"""A point carried by a link whose pose is known: its place, velocity and acceleration as sums of known terms."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.kinematics.contours.known import Pose
from tmm_report.chapters.lever.kinematics.contours.nodes import times, total
from tmm_report.quantity.formula import Expr, Var, cos, sin
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.contours.worked import Bench


@dataclass(frozen=True, eq=False)
class Moved:
    """A point carried by a link whose pose is known: at `arm`, m, in the link's axes, from the pose's own point."""

    bench: Bench
    pose: Pose
    base: str
    point: str
    arm: complex

    @cached_property
    def length(self) -> Var | None:
        size = abs(self.arm)
        return self.bench.length(self.base, self.point, size) if size else None

    @cached_property
    def angle(self) -> Expr:
        return self.bench.turned(self.pose, self.base + self.point, self.arm)

    def _reach(self, *factors: Expr | None, axis: int) -> Expr | None:
        if self.length is None:
            return None
        return times(self.length, *factors, (cos, sin)[axis](self.angle))

    def place(self, axis: int) -> Expr:
        base = (self.pose.base.x, self.pose.base.y)[axis]
        return total([(1, None if _nothing(base) else base), (1, self._reach(axis=axis))])

    def velocity(self, axis: int) -> Expr:
        base = self.pose.base.v
        return total([(1, base and base[axis]), ((-1, 1)[axis], self._reach(self.pose.w, axis=1 - axis))])

    def acceleration(self, axis: int) -> Expr:
        base, w = self.pose.base.a, self.pose.w
        square = w**2 if w is not None else None
        return total(
            [
                (1, base and base[axis]),
                (-1, self._reach(square, axis=axis) if square is not None else None),
                ((-1, 1)[axis], self._reach(self.pose.e, axis=1 - axis) if self.pose.e is not None else None),
            ]
        )


def _nothing(expression: Expr) -> bool:
    """Whether it is a coordinate 0 of a fixed point: a sum goes without it."""
    return isinstance(expression, Var) and not np.any(expression.number)
