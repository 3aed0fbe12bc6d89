"""What ordinary stages state whose axes cross: bevel wheels and worms; SI, rad."""

from __future__ import annotations

import math
from dataclasses import field
from typing import TYPE_CHECKING, Annotated, Literal

from tmm_report.chapters.gears.ordinary.parallel import OF_STAGE, RATIO, Ordinary, teeth_of, with_teeth
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field, Tag

    from tmm_report.variant.values import (
        LIST,
        SCALAR,
        Coefficient,
        Efficiency,
        Module,
        Reads,
        Span,
        Tooth,
        by_shape,
        quantity,
        whole,
    )


@dataclass(frozen=True)
class BevelStage(Ordinary):
    """A pair of bevel wheels, whose axes meet: by its pitch cones, the shape of the teeth is not found."""

    kind: Literal["bevel"] = field(default="bevel", kw_only=True)
    ratio: Annotated[
        Annotated[float, Reads(OF_STAGE, RATIO)] | None,
        Field(
            description="left out, that of the teeth; its sign is set by the unfolding of the axes",
            examples=[2.5],
        ),
    ] = field(default=None, kw_only=True)
    teeth: Annotated[
        Annotated[Tooth, Tag(SCALAR)] | Annotated[tuple[Tooth, Tooth], Tag(LIST)],
        by_shape(N_("of both wheels: [20, 50], or of the driving one beside a ratio: 20")),
        Field(description="of both wheels, or of the driving one beside a ratio", examples=["[20, 50]"]),
    ] = field(kw_only=True)
    module: Annotated[Module | None, Field(description="outer, transverse", examples=["4 mm"])] = field(
        default=None, kw_only=True
    )
    mean_module: Annotated[Module | None, Field(description="in place of it: half way along the teeth")] = (
        field(default=None, kw_only=True)
    )
    shaft_angle: Annotated[
        Annotated[float, quantity("angle", math.radians(20), math.radians(150), "20 … 150 deg")],
        Field(description="between the axes"),
    ] = field(default=math.pi / 2, kw_only=True)
    width: Annotated[Span | None, Field(description="of the teeth; left out, 0.285 of the cone distance")] = (
        field(default=None, kw_only=True)
    )
    alpha: Annotated[
        Annotated[float, quantity("angle", math.radians(10), math.radians(35), "10 … 35 deg")],
        Field(description="profile angle, for the forces"),
    ] = field(default=math.radians(20), kw_only=True)
    efficiency: Annotated[Efficiency | None, Field(description="left out, 0.96")] = field(
        default=None, kw_only=True
    )

    def __post_init__(self) -> None:
        if self.ratio is not None:
            object.__setattr__(self, "ratio", -abs(self.ratio))
        with_teeth(self.teeth, self.ratio)
        if (self.module is None) == (self.mean_module is None):
            wrong = N_("the size of the teeth is stated by one module")
            raise WrongValue(Message(wrong), Message(N_("module (outer) or mean_module")))

    @property
    def z(self) -> tuple[int, int]:
        return teeth_of(self.teeth, self.ratio)

    @property
    def sense(self) -> int:
        """The driven axis is turned about the common tangent till both are parallel: as of an outer pair."""
        return -1

    @property
    def variety(self) -> str:
        return "bevel"

    @property
    def eta(self) -> float:
        return self.efficiency or 0.96

    @property
    def chosen(self) -> dict[str, str]:
        found = {} if isinstance(self.teeth, tuple) else {"z2": "whole"}
        return found if self.width is not None else {**found, "psi": "usual width"}


@dataclass(frozen=True)
class WormStage(Ordinary):
    """A worm that drives its wheel, axes at right angles; the shape of thread and teeth is not found."""

    kind: Literal["worm"] = field(default="worm", kw_only=True)
    ratio: Annotated[
        Annotated[float, Reads(OF_STAGE, RATIO)] | None,
        Field(
            description="left out, that of the teeth; its sign follows from hand and place of the worm",
            examples=[20],
        ),
    ] = field(default=None, kw_only=True)
    starts: Annotated[int, whole(1, 8), Field(description="of the worm's thread, z1")] = field(kw_only=True)
    teeth: Annotated[
        Annotated[int, whole(12, 400)] | None,
        Field(description="of the wheel, z2; left out, by the ratio", examples=[40]),
    ] = field(default=None, kw_only=True)
    module: Annotated[Module, Field(description="axial, of the worm", examples=["5 mm"])] = field(
        kw_only=True
    )
    q: Annotated[
        Annotated[float, quantity("number", 5.0, 30.0, "5 … 30")],
        Field(description="diameter of the worm in modules", examples=[10]),
    ] = field(kw_only=True)
    friction_angle: Annotated[
        Annotated[float, quantity("angle", 0.0, math.radians(45), "0 … 45 deg")] | None,
        Field(description="reduced, of the thread", examples=["1.8 deg"]),
    ] = field(default=None, kw_only=True)
    coefficient: Annotated[
        Coefficient | None, Field(description="of friction, reduced: in place of the angle", examples=[0.03])
    ] = field(default=None, kw_only=True)
    efficiency: Annotated[Efficiency | None, Field(description="in place of the friction: of the stage")] = (
        field(default=None, kw_only=True)
    )
    splash: Annotated[
        Annotated[float, quantity("number", 0.5, 1.0, "0.5 … 1")],
        Field(description="factor of the losses beside the mesh: splashing of the oil", examples=[0.96]),
    ] = field(default=1.0, kw_only=True)
    hand: Annotated[Literal["right", "left"], Field(description="of the worm's thread")] = field(
        default="right", kw_only=True
    )
    worm: Annotated[Literal["above", "below"], Field(description="where the worm lies, by the wheel")] = (
        field(default="above", kw_only=True)
    )
    alpha: Annotated[
        Annotated[float, quantity("angle", math.radians(10), math.radians(35), "10 … 35 deg")],
        Field(description="profile angle, for the forces"),
    ] = field(default=math.radians(20), kw_only=True)

    def __post_init__(self) -> None:
        if self.ratio is not None:
            object.__setattr__(self, "ratio", self.sense * abs(self.ratio))
        if self.teeth is None and self.ratio is None:
            wrong = N_("neither the ratio nor the teeth of the wheel are stated")
            raise WrongValue(Message(wrong), Message(N_("teeth: 40, or ratio: 20")))
        if not 12 <= self.z[1] <= 400:
            wrong = N_("this ratio asks for a driven wheel of %(z)s teeth")
            right = Message(N_("from %(low)s to %(high)s teeth"), {"low": 12, "high": 400})
            raise WrongValue(Message(wrong, {"z": self.z[1]}), right)
        if [self.friction_angle, self.coefficient, self.efficiency].count(None) != 2:
            words = {"words": "friction_angle, coefficient, efficiency"}
            wrong = N_("the losses of a worm must follow from one statement")
            raise WrongValue(Message(wrong), Message(N_("exactly one of: %(words)s"), words))

    @property
    def z(self) -> tuple[int, int]:
        return self.starts, self.teeth or round(self.starts * abs(self.ratio or 1.0))

    @property
    def sense(self) -> int:
        """The wheel's axis is turned about the line of centres till both are parallel, the side of the wheel that faces
        the reader then looks to the output."""
        return 1 if (self.hand == "right") == (self.worm == "above") else -1

    @property
    def variety(self) -> str:
        return "worm"

    @property
    def lead(self) -> float:
        """Lead angle, rad."""
        return math.atan(self.starts / self.q)

    @property
    def rubs(self) -> float:
        """Reduced angle of friction, rad."""
        if self.efficiency is not None:
            of_mesh = min(1.0, self.efficiency / self.splash)
            return math.atan(math.tan(self.lead) / of_mesh) - self.lead
        return math.atan(self.coefficient) if self.coefficient is not None else self.friction_angle or 0.0

    @property
    def eta(self) -> float:
        return self.splash * math.tan(self.lead) / math.tan(self.lead + self.rubs)

    @property
    def chosen(self) -> dict[str, str]:
        return {} if self.teeth is not None else {"z2": "whole"}
