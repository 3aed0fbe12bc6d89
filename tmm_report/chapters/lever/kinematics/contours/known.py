"""What the contours take as known: points, poses of links, lines of guides, as expressions of formulas."""

from __future__ import annotations

from tmm_report.chapters.lever.kinematics.contours.nodes import times, total
from tmm_report.quantity.formula import Expr, cos, sin
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Spot:
    """A point: its name and coordinates; velocity and acceleration, None where they are zero."""

    name: str
    x: Expr
    y: Expr
    v: tuple[Expr, Expr] | None = None
    a: tuple[Expr, Expr] | None = None


@dataclass(frozen=True, eq=False)
class Pose:
    """A link: one of its points, at `origin` in its axes; its direction: `angle` is that of its direction `zero`, rad
    in its axes; ω and ε, None of a link that does not turn."""

    base: Spot
    origin: complex
    angle: Expr | None
    zero: float
    w: Expr | None
    e: Expr | None


@dataclass(frozen=True, eq=False)
class Line:
    """A guide's line fixed to a known link: through `at`, at the angle `beta` to the x axis; ω and ε of the link."""

    guide: str
    at: Spot
    beta: Expr
    w: Expr | None
    e: Expr | None

    def place(self, s: Expr, axis: int) -> Expr:
        """Coordinate of what is at the distance s along it."""
        return total([(1, (self.at.x, self.at.y)[axis]), (1, s * (cos, sin)[axis](self.beta))])

    def carried(self, s: Expr, axis: int) -> list[tuple[int, Expr | None]]:
        """Terms of the velocity of what is at the distance s, s being kept."""
        turned = times(s, self.w, (sin, cos)[axis](self.beta))
        return [(1, self.at.v and self.at.v[axis]), ((-1, 1)[axis], turned)]

    def bent(self, s: Expr, rate: Expr, axis: int) -> list[tuple[int, Expr | None]]:
        """Terms of the acceleration of what is at the distance s, without s″."""
        own, other = (cos, sin)[axis](self.beta), (sin, cos)[axis](self.beta)
        sign = (-1, 1)[axis]
        return [
            (1, self.at.a and self.at.a[axis]),
            (sign, times(s, self.e, other)),
            (-1, times(s, self.w and self.w**2, own)),
            (sign, times(2 * rate, self.w, other) if self.w is not None else None),
        ]
