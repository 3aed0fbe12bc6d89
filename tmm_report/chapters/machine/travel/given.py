"""What is given of a machine whose main link slides."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from tmm_report.mechanics.machine.characteristics import Characteristic
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import Inertia, Length, Positive, Stiffness

G = 9.81  # m/s²


@dataclass(frozen=True)
class Wheel:
    """A wheel that the main link turns: a pinion on its rack, a pulley whose rope it pulls."""

    inertia: Inertia
    radius: Annotated[Positive, Field(description="at which the main link turns it")]
    name: CalledBy | None = None


@dataclass(frozen=True)
class Spring:
    """A spring along the guide, from the frame to the main link."""

    stiffness: Stiffness
    free: Annotated[Length, Field(description="place of the main link at which the spring is free")]
    name: CalledBy | None = None


@dataclass(frozen=True, eq=False)
class Force:
    """`kind`: of its law, which is one of the place, the time or the speed; `drives`: with the motion, else against
    it."""

    kind: str
    law: Characteristic
    drives: bool
    name: str = ""

    @property
    def sign(self) -> float:
        return 1.0 if self.drives else -1.0


@dataclass(frozen=True, eq=False)
class Given:
    """SI. `begin`, `end`: places of the main link along its guide, None: those of the stroke that drives the mechanism;
    `speed`: at the beginning, along the motion; `mass`: of the main link, with a mechanism what moves with it besides;
    `rise`: angle of the motion above the horizontal, rad, for the weight of this mass, None: it has none."""

    begin: float | None = None
    end: float | None = None
    speed: float = 0.0
    mass: float = 0.0
    rise: float | None = None
    gravity: float = G
    wheels: tuple[Wheel, ...] = ()
    forces: tuple[Force, ...] = ()
    springs: tuple[Spring, ...] = ()
    name: str = ""
