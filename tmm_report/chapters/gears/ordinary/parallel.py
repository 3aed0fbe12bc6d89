"""What ordinary stages state whose axes are parallel (but cones of friction): belts, chains, friction wheels, idlers;
SI, rad."""

from __future__ import annotations

import math
from dataclasses import field
from functools import partial
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from tmm_report.chapters.gears.spur.given import signed_ratio, with_rest
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field, Tag

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        LIST,
        SCALAR,
        Coefficient,
        Efficiency,
        LinearMass,
        Module,
        Reads,
        Span,
        SpanOrWord,
        Tooth,
        ToothOrRest,
        by_shape,
        quantity,
        whole,
    )

OF_STAGE = partial(
    signed_ratio,
    limits=(0.02, 100.0),
    wrong=N_("no such stage has the ratio %(value)s"),
    right=N_("from %(low)s to %(high)s, with a minus where the shafts turn in opposite senses"),
)
RATIO = {"type": "number", "description": "minus: the shafts turn in opposite senses"}
STANDARD = "standard"
FEWEST, MOST = 6, 1000  # teeth of a wheel
DRAWN = 3e-3  # module with which wheels are drawn whose own is not stated, m


@dataclass(frozen=True)
class Ordinary:
    """What every such stage states."""

    NOT_STATED: ClassVar[tuple[str, ...]] = ("wheels", "label")
    SENSE: ClassVar[int] = 1  # of the driven shaft, the driving one turning in the sense +1

    name: Annotated[
        CalledBy | None, Field(description="in the headings; left out, the numbers of the wheels")
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
        if self.distance is None and not isinstance(self.length, float):
            found["a" if self.length is None else "a_about"] = "by rule"
        return found

    @property
    def eta(self) -> float:
        """The efficiency, stated or usual."""
        return self.efficiency or (0.95 if self.belt == "V" else 0.96)


@dataclass(frozen=True)
class ChainStage(Ordinary):
    """A roller chain on two sprockets; the number of its links is whole and even unless it is stated."""

    kind: Literal["chain"] = field(default="chain", kw_only=True)
    ratio: Annotated[
        Annotated[float, Reads(OF_STAGE, RATIO)] | None,
        Field(description="left out, that of the teeth", examples=[2.5]),
    ] = field(default=None, kw_only=True)
    teeth: Annotated[
        Annotated[Tooth, Tag(SCALAR)] | Annotated[tuple[Tooth, Tooth], Tag(LIST)],
        by_shape(N_("of both sprockets: [25, 60], or of the driving one beside a ratio: 25")),
        Field(description="of both sprockets, or of the driving one beside a ratio", examples=["[25, 60]"]),
    ] = field(kw_only=True)
    pitch: Annotated[
        Annotated[float, quantity("length", 1e-3, 0.2, "1 … 200 mm")],
        Field(description="of the chain", examples=["19.05 mm"]),
    ] = field(kw_only=True)
    distance: Annotated[
        Span | None, Field(description="of the centres, wished for; left out, by the links, or 40 pitches")
    ] = field(default=None, kw_only=True)
    links: Annotated[
        Annotated[int, whole(10, 2000)] | None,
        Field(description="how many the chain has; left out, an even number by the distance"),
    ] = field(default=None, kw_only=True)
    slack: Annotated[
        Annotated[float, quantity("number", 0.0, 0.02, "0 … 2 %")],
        Field(description="part by which the distance is made shorter, so that the chain sags"),
    ] = field(default=0.003, kw_only=True)
    mass: Annotated[
        LinearMass | None,
        Field(description="of a metre of the chain; left out, the centrifugal tension is neglected"),
    ] = field(default=None, kw_only=True)
    efficiency: Annotated[Efficiency | None, Field(description="left out, 0.93")] = field(
        default=None, kw_only=True
    )

    def __post_init__(self) -> None:
        positive(self.ratio, N_("a chain turns both sprockets in the same sense: its ratio has no minus"))
        with_teeth(self.teeth, self.ratio)
        if self.links is not None and self.distance is not None:
            wrong = N_("the centre distance and the number of links are both stated")
            raise WrongValue(Message(wrong), Message(N_("one of them: the other follows")))

    @property
    def z(self) -> tuple[int, int]:
        return teeth_of(self.teeth, self.ratio)

    @property
    def variety(self) -> str:
        return "chain"

    @property
    def eta(self) -> float:
        return self.efficiency or 0.93

    @property
    def chosen(self) -> dict[str, str]:
        found = {} if isinstance(self.teeth, tuple) else {"z2": "whole"}
        if self.links is None:
            found["links"] = "even"
        if self.distance is None and self.links is None:
            found["a_about"] = "forty pitches"
        return found


@dataclass(frozen=True)
class FrictionStage(Ordinary):
    """Two friction wheels pressed together; of the two diameters and the ratio two are stated."""

    kind: Literal["friction"] = field(default="friction", kw_only=True)
    contact: Annotated[
        Literal["external", "internal", "bevel"],
        Field(
            description="cylinders side by side, or one within a ring; cones, whose diameters are the mean ones"
        ),
    ] = field(default="external", kw_only=True)
    shaft_angle: Annotated[
        Annotated[float, quantity("angle", math.radians(20), math.radians(150), "20 … 150 deg")] | None,
        Field(description="between the axes of cones; left out, 90 deg"),
    ] = field(default=None, kw_only=True)
    ratio: Annotated[
        Annotated[float, Reads(OF_STAGE, RATIO)] | None,
        Field(description="left out, that of the diameters", examples=[-2.5]),
    ] = field(default=None, kw_only=True)
    driving: Annotated[
        Span | None, Field(description="diameter of the driving wheel", examples=["80 mm"])
    ] = field(default=None, kw_only=True)
    driven: Annotated[Span | None, Field(description="that of the driven one", examples=["200 mm"])] = field(
        default=None, kw_only=True
    )
    slip: Annotated[
        Annotated[float, quantity("number", 0.0, 0.1, "0 … 10 %")],
        Field(description="part of its velocity that the driven wheel loses", examples=["2 %"]),
    ] = field(default=0.0, kw_only=True)
    coefficient: Annotated[
        Coefficient | None,
        Field(description="of friction: then the pressing force is found", examples=[0.15]),
    ] = field(default=None, kw_only=True)
    reserve: Annotated[
        Annotated[float, quantity("number", 1.0, 5.0, "1 … 5")],
        Field(description="how many times the working force the wheels carry before they slip"),
    ] = field(default=1.25, kw_only=True)
    width: Annotated[Span | None, Field(description="of the line of contact: then the force on a metre")] = (
        field(default=None, kw_only=True)
    )
    efficiency: Annotated[Efficiency | None, Field(description="left out, 0.95")] = field(
        default=None, kw_only=True
    )

    def __post_init__(self) -> None:
        if self.contact == "internal":
            positive(
                self.ratio, N_("wheels in inner contact turn in the same sense: their ratio has no minus")
            )
        elif self.ratio is not None:
            object.__setattr__(self, "ratio", -abs(self.ratio))
        if [self.driving, self.driven, self.ratio].count(None) > 1:
            right = N_("two of driving, driven and ratio, for example driving: 100 mm and ratio: 2")
            raise WrongValue(Message(N_("the friction wheels are not determined")), Message(right))
        if self.shaft_angle is not None and self.contact != "bevel":
            right = N_("either contact: bevel, or no shaft_angle")
            raise WrongValue(Message(N_("the axes of cylinders are parallel")), Message(right))

    @property
    def sense(self) -> int:
        return 1 if self.contact == "internal" else -1

    @property
    def variety(self) -> str:
        return f"friction {self.contact}"

    @property
    def eta(self) -> float:
        return self.efficiency or 0.95


@dataclass(frozen=True)
class TrainStage(Ordinary):
    """A row of wheels on axes that stand still: between the driving and the driven wheel there are idlers."""

    kind: Literal["train"] = field(default="train", kw_only=True)
    ratio: Annotated[
        Annotated[float, Reads(OF_STAGE, RATIO)] | None,
        Field(
            description="left out, that of the teeth; its sense follows from the number of wheels",
            examples=[3],
        ),
    ] = field(default=None, kw_only=True)
    teeth: Annotated[
        Annotated[Tooth, Tag(SCALAR)] | Annotated[tuple[Tooth, Tooth], Tag(LIST)],
        by_shape(
            N_("of the driving and the driven wheel: [20, 60], or of the driving one beside a ratio: 20")
        ),
        Field(
            description="of the driving and the driven wheel, or of the driving one beside a ratio",
            examples=["[20, 60]"],
        ),
    ] = field(kw_only=True)
    idlers: Annotated[
        tuple[Tooth, ...],
        Field(min_length=1, max_length=8, description="teeth of the wheels between", examples=["[30]"]),
    ] = field(kw_only=True)
    module: Annotated[Module, Field(examples=["4 mm"])] = field(kw_only=True)
    mesh: Annotated[
        Literal["external", "internal"],
        Field(description="of the last two wheels: internal, the driven wheel is a ring"),
    ] = field(default="external", kw_only=True)
    efficiency: Annotated[Efficiency | None, Field(description="of each mesh; left out, 0.98")] = field(
        default=None, kw_only=True
    )

    def __post_init__(self) -> None:
        """The sense is that of the meshes, whatever sign is written of the ratio."""
        if self.ratio is not None:
            object.__setattr__(self, "ratio", self.sense * abs(self.ratio))
        with_teeth(self.teeth, self.ratio)

    @property
    def z(self) -> tuple[int, ...]:
        """Of all the wheels in their order."""
        one, last = teeth_of(self.teeth, self.ratio)
        return (one, *self.idlers, last)

    @property
    def count(self) -> int:
        return 2 + len(self.idlers)

    @property
    def sense(self) -> int:
        external = len(self.idlers) + (self.mesh == "external")
        return -1 if external % 2 else 1

    @property
    def variety(self) -> str:
        return f"train {self.mesh}"

    @property
    def chosen(self) -> dict[str, str]:
        return {} if isinstance(self.teeth, tuple) else {"z2": "whole"}

    @property
    def of_mesh(self) -> float:
        """The efficiency of each mesh."""
        return self.efficiency or 0.98

    @property
    def eta(self) -> float:
        return self.of_mesh ** (len(self.idlers) + 1)


@dataclass(frozen=True)
class PairStage(Ordinary):
    """A pair of toothed wheels on fixed axes of which no module is stated: no more than its ratio is found."""

    kind: Literal["spur"] = field(default="spur", kw_only=True)
    ratio: Annotated[
        Annotated[float, Reads(OF_STAGE, RATIO)] | None,
        Field(description="left out, that of the teeth", examples=[-3]),
    ] = field(default=None, kw_only=True)
    teeth: Annotated[
        tuple[ToothOrRest, ToothOrRest],
        Field(description="one of both may be the rest", examples=["[20, 60]", "[20, rest]"]),
    ] = field(kw_only=True)
    mesh: Annotated[
        Literal["external", "internal"] | None,
        Field(description="left out, by the sign of the ratio, else external"),
    ] = field(default=None, kw_only=True)
    efficiency: Annotated[Efficiency | None, Field(description="left out, 0.98")] = field(
        default=None, kw_only=True
    )

    def __post_init__(self) -> None:
        """The sense is that of the mesh, whatever sign the ratio has; the rest is found where there is a ratio."""
        if self.mesh is not None and self.ratio is not None:
            object.__setattr__(self, "ratio", self.sense * abs(self.ratio))
        object.__setattr__(self, "teeth", with_rest(self.teeth, self.ratio))
        if self.sense > 0 and self.teeth[0] == self.teeth[1]:
            wrong = Message(N_("a ring cannot have as many teeth as its pinion"))
            raise WrongValue(wrong, Message(N_("give the ring more teeth than the pinion")))

    @property
    def open(self) -> bool:
        """Whether its ratio is what the drive leaves it."""
        return 0 in self.teeth

    @property
    def sense(self) -> int:
        internal = self.mesh == "internal" or (
            self.mesh is None and self.ratio is not None and self.ratio > 0
        )
        return 1 if internal else -1

    @property
    def variety(self) -> str:
        return "pair internal" if self.sense > 0 else "pair external"

    @property
    def eta(self) -> float:
        return self.efficiency or 0.98


def positive(ratio: float | None, wrong: str) -> None:
    """Raises WrongValue for a minus where both shafts turn in the same sense."""
    if ratio is not None and ratio < 0:
        raise WrongValue(Message(wrong), Message(N_("ratio: %(ratio)s"), {"ratio": f"{-ratio:g}"}))


def with_teeth(teeth: int | tuple[int, int], ratio: float | None) -> None:
    """Raises WrongValue where the teeth of one wheel are stated and no ratio, or one of wheels that are not made."""
    if isinstance(teeth, tuple):
        return
    if ratio is None:
        wrong = N_("neither the ratio nor the teeth of both wheels are stated")
        right = Message(N_("teeth: [%(one)s, …], or a ratio beside it"), {"one": teeth})
        raise WrongValue(Message(wrong), right)
    if not FEWEST <= (z := round(teeth * abs(ratio))) <= MOST:
        wrong = N_("this ratio asks for a driven wheel of %(z)s teeth")
        right = Message(N_("from %(low)s to %(high)s teeth"), {"low": FEWEST, "high": MOST})
        raise WrongValue(Message(wrong, {"z": z}), right)


def teeth_of(teeth: int | tuple[int, int], ratio: float | None) -> tuple[int, int]:
    """Of both wheels; of the driven one the whole number nearest to what the ratio asks for."""
    if isinstance(teeth, tuple):
        return teeth
    return teeth, round(teeth * abs(ratio or 1.0))
