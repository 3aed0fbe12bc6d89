"""What the ordinary stages of a drive state: belts; SI, rad. None has teeth whose shape is found."""

from __future__ import annotations

import math
from dataclasses import field
from functools import partial
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from tmm_report.chapters.gears.spur.given import signed_ratio
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.values import (
        Coefficient,
        Efficiency,
        Label,
        LinearMass,
        Reads,
        Span,
        SpanOrWord,
        quantity,
    )

OF_STAGE = partial(
    signed_ratio,
    limits=(0.02, 100.0),
    wrong=N_("no such stage has the ratio %(value)s"),
    right=N_("from %(low)s to %(high)s, with a minus where the shafts turn in opposite senses"),
)
RATIO = {"type": "number", "description": "minus: the shafts turn in opposite senses"}
STANDARD = "standard"


@dataclass(frozen=True)
class Ordinary:
    """What every such stage states."""

    NOT_STATED: ClassVar[tuple[str, ...]] = ("wheels", "label")
    SENSE: ClassVar[int] = 1  # of the driven shaft, the driving one turning in the sense +1

    name: Annotated[
        Label | None, Field(description="in the headings; left out, the numbers of the wheels")
    ] = field(default=None, kw_only=True)
    wheels: tuple[str, ...] = field(default=("1", "2"), kw_only=True)  # their names in the drive
    label: str = field(default="stage1", kw_only=True)  # with which its names in the results begin

    @property
    def count(self) -> int:
        """How many wheels, pulleys or the like it has."""
        return 2

    @property
    def title(self) -> str:
        return self.name or "-".join(self.wheels)

    @property
    def variety(self) -> str:
        """Its kind, and of which sort of that it is: by this the words of the note are chosen."""
        return ""

    @property
    def sense(self) -> int:
        return self.SENSE

    @property
    def chosen(self) -> dict[str, str]:
        """Numbers that are neither stated nor given by a formula: how they are chosen, in a word."""
        return {}


@dataclass(frozen=True)
class BeltStage(Ordinary):
    """A belt drive: open, crossed or of V-belts; of the two diameters and the ratio two are stated."""

    kind: Literal["belt"] = field(default="belt", kw_only=True)
    belt: Annotated[
        Literal["open", "crossed", "V"],
        Field(description="flat and open, flat and crossed, or V-belts in grooves"),
    ] = field(default="open", kw_only=True)
    ratio: Annotated[
        Annotated[float, Reads(OF_STAGE, RATIO)] | None,
        Field(
            description="of the driving pulley to the driven one; left out, that of the diameters",
            examples=[2],
        ),
    ] = field(default=None, kw_only=True)
    driving: Annotated[
        Span | None, Field(description="diameter of the driving pulley", examples=["100 mm"])
    ] = field(default=None, kw_only=True)
    driven: Annotated[
        SpanOrWord | None,
        Field(description="that of the driven one; standard: of the row, nearest to what the ratio asks for"),
    ] = field(default=None, kw_only=True)
    slip: Annotated[
        Annotated[float, quantity("number", 0.0, 0.1, "0 … 10 %")],
        Field(description="part of its velocity that the driven pulley loses", examples=["1.5 %"]),
    ] = field(default=0.0, kw_only=True)
    distance: Annotated[
        Span | None,
        Field(
            description="of the centres; left out, by the length, or by the rule 1.5 (d1 + d2), of V-belts d1 + d2"
        ),
    ] = field(default=None, kw_only=True)
    length: Annotated[
        SpanOrWord | None,
        Field(description="of the belt; left out, by the distance; standard: of the row, nearest to that"),
    ] = field(default=None, kw_only=True)
    coefficient: Annotated[
        Coefficient | None, Field(description="of friction: then the tensions are found", examples=[0.3])
    ] = field(default=None, kw_only=True)
    groove: Annotated[
        Annotated[float, quantity("angle", math.radians(20), math.radians(60), "20 … 60 deg")] | None,
        Field(description="angle between the sides of the grooves of V-belts; left out, 40 deg"),
    ] = field(default=None, kw_only=True)
    reserve: Annotated[
        Annotated[float, quantity("number", 1.0, 5.0, "1 … 5")],
        Field(description="how many times the working force the belt may carry before it slips"),
    ] = field(default=1.0, kw_only=True)
    mass: Annotated[
        LinearMass | None,
        Field(description="of a metre of the belt; left out, the centrifugal tension is neglected"),
    ] = field(default=None, kw_only=True)
    efficiency: Annotated[Efficiency | None, Field(description="left out, 0.96, of V-belts 0.95")] = field(
        default=None, kw_only=True
    )

    def __post_init__(self) -> None:
        """A crossed belt stated in a word has a minus, written or not; two of three say the third."""
        if self.crossed and self.ratio is not None:
            object.__setattr__(self, "ratio", -abs(self.ratio))
        if not self.crossed and self.ratio is not None and self.ratio < 0:
            wrong = N_("an open belt turns both pulleys in the same sense: its ratio has no minus")
            right = Message(N_("either ratio: %(ratio)s or belt: crossed"), {"ratio": f"{-self.ratio:g}"})
            raise WrongValue(Message(wrong), right)
        known = [self.driving, None if self.driven == STANDARD else self.driven, self.ratio]
        if known.count(None) > 1 or (self.driven == STANDARD and None in (self.driving, self.ratio)):
            wrong = N_("the pulleys are not determined")
            right = Message(N_("two of driving, driven and ratio, for example driving: 100 mm and ratio: 2"))
            raise WrongValue(Message(wrong), right)
        if self.groove is not None and self.belt != "V":
            right = Message(N_("either belt: V, or no groove"))
            raise WrongValue(Message(N_("a flat belt has no groove")), right)

    @property
    def variety(self) -> str:
        return f"belt {self.belt}"

    @property
    def crossed(self) -> bool:
        return self.belt == "crossed"

    @property
    def sense(self) -> int:
        return -1 if self.crossed else 1

    @property
    def chosen(self) -> dict[str, str]:
        sizes = {"d2": self.driven, "L": self.length}
        found = {key: "row" for key, size in sizes.items() if size == STANDARD}
        if self.length is not None:
            found["a"] = "by length"
        elif self.distance is None:
            found["a"] = "by rule"
        return found

    @property
    def eta(self) -> float:
        """The efficiency, stated or usual."""
        return self.efficiency or (0.95 if self.belt == "V" else 0.96)


Given = BeltStage
