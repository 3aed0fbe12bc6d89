"""Loads on the mechanism as the variant states them: laws of magnitude, forces on points, moments on links."""

from __future__ import annotations

from typing import Literal

from tmm_report.records import dataclass

Motion = Literal["along", "against"]
Curve = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Constant:
    value: float


@dataclass(frozen=True)
class ByPosition:
    """Magnitudes at the table positions, linear between them: 0..N-1 of a cycle of full turns, whose last position is
    position 0 again; 0..N where the driving link turns over a part of a turn."""

    values: tuple[float, ...]


@dataclass(frozen=True)
class ByAngle:
    """Magnitudes at angles of turn from position 0 in the sense of rotation, rad; linear between them, and from the
    last to the first of the next cycle."""

    angles: tuple[float, ...]
    values: tuple[float, ...]


@dataclass(frozen=True)
class ByDisplacement:
    """Indicator diagram: magnitude against x = displacement / stroke of the loaded point, 0 <= x <= 1.

    x counts from the extreme position of the point in `zero` (unit complex); `forward` is the stroke away from
    it, `back` the return. Each is a tuple of (x, value), linear between. They hold in every turn.
    """

    zero: complex
    forward: Curve
    back: Curve


@dataclass(frozen=True)
class ByStrokes:
    """Indicator diagram of a cycle of several turns: a curve for each stroke, in the order in which they follow; x as
    above. The first goes away from the extreme position in `zero`, the second back, and so on.

    `first`: number of the stroke that is under way at position 0 of the mechanism, or begins there; None: of the first
    and the last stated the one that goes the way in which the point goes there.
    """

    zero: complex
    names: tuple[str, ...]
    curves: tuple[Curve, ...]
    first: int | None = None


TurnLaw = Constant | ByPosition | ByAngle
Law = TurnLaw | ByDisplacement | ByStrokes  # an indicator diagram is of a point


@dataclass(frozen=True)
class Force:
    """A force on a named point. `direction`: unit complex, fixed, or along / against the point's motion. N.

    `on`: the link that takes it, where several share the point; None: see `acting.loaded_link`.
    """

    name: str
    at: str
    direction: complex | Motion
    law: Law
    on: str | None = None


@dataclass(frozen=True)
class Moment:
    """A moment on a link. `direction`: +1 counter-clockwise, -1 clockwise, or along / against its rotation. N m."""

    name: str
    on: str
    direction: int | Motion
    law: TurnLaw


@dataclass(frozen=True)
class Loads:
    """Loads of the kinetostatics chapter. `gravity`: complex, m/s²; inertia comes from the links' masses."""

    gravity: complex = -9.81j
    forces: tuple[Force, ...] = ()
    moments: tuple[Moment, ...] = ()
