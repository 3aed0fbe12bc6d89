"""Loads on the mechanism as the variant states them: forces on points, moments on links, each by its law."""

from __future__ import annotations

from typing import Literal

from tmm_report.mechanics.calculus.laws import Law
from tmm_report.records import dataclass

Motion = Literal["along", "against"]


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
    """A moment on a link. `direction`: +1 counter-clockwise, -1 clockwise, or along / against its rotation. N m.

    Its law is none of a displacement: a link has none."""

    name: str
    on: str
    direction: int | Motion
    law: Law


@dataclass(frozen=True)
class Loads:
    """Loads of the kinetostatics chapter. `gravity`: complex, m/s²; inertia comes from the links' masses."""

    gravity: complex = -9.81j
    forces: tuple[Force, ...] = ()
    moments: tuple[Moment, ...] = ()
