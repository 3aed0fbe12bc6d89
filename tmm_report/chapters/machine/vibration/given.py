"""What is given of vibration and its isolation, as the block states it, SI."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING, Annotated, ClassVar

from tmm_report.problems import N_
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        Angle,
        Damping,
        FixedDirection,
        Length,
        Positive,
        PositiveInertia,
        PositiveMass,
        Scale,
        SignedSpeed,
        Speed,
        TorsionalDamping,
        Velocity,
        quantity,
        whole,
    )

WHIRLS = N_(
    "a shaft that whirls: its disc as mass, the stiffness of the shaft at it (48EI/l³ in the middle), unbalance: "
    "{mass: that of the disc, radius: the eccentricity}; the critical speed is the natural frequency"
)
CURVES = [0.0, 0.1, 0.25, 0.5, 1.0]


@dataclass(frozen=True)
class Unbalance:
    """A mass off the axis of a shaft."""

    mass: PositiveMass
    radius: Positive


@dataclass(frozen=True)
class Foundation:
    """The mass that the isolators stand on and its own springs."""

    mass: PositiveMass
    stiffness: Annotated[float, quantity("stiffness", 1e-9)]
    damping: Damping = 0.0

    @property
    def inertia(self) -> float:
        return self.mass


@dataclass(frozen=True)
class TurningFoundation:
    """The disc that the shaft ends in and its own shaft."""

    inertia: PositiveInertia
    stiffness: Annotated[float, quantity("torsional stiffness", 1e-9)]
    damping: TorsionalDamping = 0.0


@dataclass(frozen=True)
class Absorber:
    """A mass hung on the machine by springs."""

    mass: PositiveMass | None = None
    clear: Annotated[
        tuple[Scale, Scale] | None,
        Field(description="parts of the working frequency between which no natural one may lie"),
    ] = None
    springs: Annotated[Annotated[int, whole(1, 1000)], Field(description="how many hold the mass")] = 1
    arm: ClassVar[None] = None

    @property
    def inertia(self) -> float | None:
        return self.mass


@dataclass(frozen=True)
class TurningAbsorber:
    """A disc hung on the main one by springs."""

    inertia: PositiveInertia | None = None
    clear: Annotated[
        tuple[Scale, Scale] | None,
        Field(description="parts of the working frequency between which no natural one may lie"),
    ] = None
    springs: Annotated[Annotated[int, whole(1, 1000)], Field(description="how many hold the disc")] = 1
    arm: Annotated[Positive | None, Field(description="of the springs, from the axis")] = None


@dataclass(frozen=True)
class Start:
    """How the motion begins."""

    displacement: Length = 0.0
    velocity: Velocity = 0.0

    @property
    def place(self) -> float:
        return self.displacement

    @property
    def rate(self) -> float:
        return self.velocity


@dataclass(frozen=True)
class TurningStart:
    """How the motion begins."""

    angle: Angle = 0.0
    speed: SignedSpeed = 0.0

    @property
    def place(self) -> float:
        return self.angle

    @property
    def rate(self) -> float:
        return self.speed


@dataclass(frozen=True, eq=False)
class Common:
    """What both kinds state alike."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("damper", "dampers", "electromagnetic", "electromagnetic_damper", "eddy_current"),
        N_(
            "every damper here is a viscous one, an electromagnetic (eddy-current) one too, whose force is in "
            "proportion to the velocity: damping, its coefficient, or damping_ratio"
        ),
    ) | dict.fromkeys(("shaft", "eccentricity", "diameter", "length", "E"), WHIRLS)

    name: Annotated[CalledBy | None, Field(description="of the machine, in the heading")] = None
    isolators: Annotated[
        Annotated[int, whole(1, 1000)],
        Field(description="equal springs with their dampers, side by side"),
    ] = 1
    damping_ratio: Annotated[
        Annotated[float, quantity("number", 0.0, 10.0, "0 … 10")] | None,
        Field(description="in parts of the critical damping"),
    ] = None
    transmissibility: Annotated[
        Annotated[float, quantity("number", 1e-6, 0.999999, "0 … 1")] | None,
        Field(description="force on the base by the exciting force that is wanted"),
    ] = None
    speed: Annotated[Speed | None, Field(description="of the excitation", examples=["750 rpm"])] = None
    curves: Annotated[
        list[Annotated[float, quantity("number", 0.0, 10.0, "0 … 10")]],
        Field(min_length=1, max_length=5, description="damping ratios of the curves drawn"),
    ] = field(default_factory=CURVES.copy)


@dataclass(frozen=True, eq=False)
class Linear(Common):
    """A machine on isolators and what shakes it."""

    mass: Annotated[PositiveMass, Field(examples=["1200 kg"])] = field(kw_only=True)
    stiffness: Annotated[
        Annotated[float, quantity("stiffness", 1e-9)] | None, Field(description="of each isolator")
    ] = None
    deflection: Annotated[
        Positive | None,
        Field(description="of the isolators under the weight, in place of the stiffness", examples=["5 mm"]),
    ] = None
    damping: Annotated[Damping | None, Field(description="of each isolator")] = None
    force: Annotated[Annotated[float, quantity("force", 1e-12)] | None, Field(description="amplitude")] = None
    unbalance: Unbalance | None = None
    base: Annotated[Positive | None, Field(description="amplitude of the motion of the base")] = None
    mechanism: Annotated[
        FixedDirection | None,
        Field(description="direction along which the shaking force of the mechanism is taken"),
    ] = None
    friction: Annotated[
        Annotated[float, quantity("force", 1e-12)] | None, Field(description="dry, in place of the dampers")
    ] = None
    foundation: Foundation | None = None
    absorber: Absorber | None = None
    start: Start = Start()
    turning: ClassVar[bool] = False

    @property
    def inertia(self) -> float:
        return self.mass

    @property
    def shaken(self) -> float | None:
        """Amplitude of the force."""
        return self.force

    @property
    def free(self) -> bool:
        """Whether nothing shakes it: it is let go and vibrates freely."""
        return self.force is self.unbalance is self.base is self.mechanism is None


@dataclass(frozen=True, eq=False)
class Turning(Common):
    """A disc that swings on a shaft."""

    inertia: Annotated[PositiveInertia, Field(examples=["0.12 kg*m^2"])] = field(kw_only=True)
    stiffness: Annotated[
        Annotated[float, quantity("torsional stiffness", 1e-9)] | None, Field(description="of the shaft")
    ] = None
    damping: TorsionalDamping | None = None
    moment: Annotated[Annotated[float, quantity("moment", 1e-12)] | None, Field(description="amplitude")] = (
        None
    )
    base: Annotated[
        Annotated[float, quantity("angle", 1e-12)] | None,
        Field(description="amplitude of the swing of the shaft's other end"),
    ] = None
    friction: Annotated[
        Annotated[float, quantity("moment", 1e-12)] | None, Field(description="dry, in place of the damper")
    ] = None
    foundation: TurningFoundation | None = None
    absorber: TurningAbsorber | None = None
    start: TurningStart = TurningStart()
    turning: ClassVar[bool] = True
    deflection: ClassVar[None] = None
    unbalance: ClassVar[None] = None
    mechanism: ClassVar[None] = None

    @property
    def shaken(self) -> float | None:
        """Amplitude of the moment."""
        return self.moment

    @property
    def free(self) -> bool:
        """Whether nothing shakes it: it is let go and vibrates freely."""
        return self.moment is self.base is None


Given = Linear | Turning
