"""The block `contacts` of a variant."""

import math
from collections.abc import Iterator
from typing import Annotated, Any, Literal, TypedDict

from pydantic import Discriminator, Field, Tag, model_validator

from tmm_report.chapters.machine.contacts import given as state
from tmm_report.problems import N_, Message, Problem
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import model
from tmm_report.variant.materials import Rubbed
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    Angle,
    Coefficient,
    Density,
    Distance,
    Label,
    Positive,
    Speed,
    quantity,
    whole,
)

Load = Annotated[float, quantity("force", 1e-12)]
Stress = Annotated[float, quantity("pressure", 1e-12)]
Few = Annotated[int, whole(1, 12)]


class Rough(Rubbed):
    """What every pair with friction states."""

    name: Label | None = Field(default=None, description="in the heading")

    @property
    def rough(self) -> state.Rough:
        return state.Rough(self.f, self.of)


class InclineModel(Rough):
    """A body on a plane."""

    kind: Literal["incline"]
    angle: Angle = Field(description="of the plane", examples=["12 deg"])
    load: Load = Field(examples=["2 kN"])
    force: Literal["level", "along"] = "level"

    def given(self) -> state.Contact:
        return state.Incline(self.rough, self.angle, self.load, self.force)


class WedgeModel(Rough):
    """A wedge under a load."""

    kind: Literal["wedge"]
    angle: Angle
    load: Load
    base: Coefficient | None = Field(default=None, description="coefficient on the base; left out, the same")

    def given(self) -> state.Contact:
        return state.Wedge(self.rough, self.angle, self.load, self.f if self.base is None else self.base)


class SlidersModel(Rough):
    """Two guided sliders, one driving the other over a sloping face."""

    kind: Literal["sliders"]
    between: Angle = Field(description="angle between the directions of the sliders")
    guides: Coefficient = Field(description="coefficient in the guides")
    face: Angle | None = Field(
        default=None, description="normal of the face against the driving direction; left out, the best"
    )
    load: Load | None = Field(default=None, description="on the driven slider")

    def given(self) -> state.Contact:
        return state.Sliders(self.rough, self.between, self.guides, self.face, self.load)


class TrialModel(Model):
    """A body just pulled and just pushed: its coefficient of friction and weight."""

    kind: Literal["trial"]
    name: Label | None = Field(default=None, description="in the heading")
    angle: Angle = Field(description="of the pull above the level, of the push below it")
    pull: Load
    push: Load

    def given(self) -> state.Contact:
        return state.Trial(self.angle, self.pull, self.push)


class CollarModel(Model):
    """The collar or end on which a screw turns."""

    coefficient: Coefficient
    radius: Positive = Field(description="mean radius")


class ScrewModel(Rough):
    """A screw under load."""

    kind: Literal["screw"]
    diameter: Positive = Field(description="mean, of the thread", examples=["25 mm"])
    pitch: Positive
    starts: Few = 1
    profile: Angle = Field(default=0.0, description="half the angle of the thread; 0: square")
    load: Load
    collar: CollarModel | None = None
    arm: Positive | None = Field(default=None, description="of the force of the hand")
    hand_force: Load | None = Field(default=None, description="of each hand: then the wheel is found")
    hands: Few | None = Field(default=None, description="left out, 1 on an arm, 2 on a wheel")

    @model_validator(mode="after")
    def hands_do_something(self) -> "ScrewModel":
        """Hands alone say nothing: their arm or their force is needed."""
        if self.hands is not None and self.arm is None and self.hand_force is None:
            wrong = Message(N_("the number of hands is stated, but neither their arm nor their force"))
            raise WrongValue(wrong, Message(N_("one of: %(words)s"), {"words": "arm, hand_force"}))
        return self

    def given(self) -> state.Contact:
        collar = (self.collar.coefficient, self.collar.radius) if self.collar else None
        hands = self.hands or (2 if self.hand_force is not None else 1)
        return state.Screw(
            self.rough, self.diameter, self.pitch, self.load, self.starts, self.profile, collar, self.arm,
            self.hand_force, hands,
        )  # fmt: skip


class PivotModel(Rough):
    """A pivot or collar."""

    kind: Literal["pivot"]
    outer: Positive = Field(description="radius")
    inner: Distance = 0.0
    half_cone: Angle = Field(default=math.pi / 2, description="half the angle of the cone; 90 deg: flat")
    load: Load
    speed: Speed | None = None

    def given(self) -> state.Contact:
        return state.Pivot(self.rough, self.outer, self.load, self.inner, self.half_cone, self.speed)


class BeltModel(Rough):
    """A rope or belt round a drum."""

    kind: Literal["belt"]
    wrap: Annotated[float, quantity("angle", 1e-6)] = Field(examples=["270 deg"])
    tight: Load = Field(description="the greater tension")
    groove: Angle = Field(default=math.pi / 2, description="half the angle of the groove; 90 deg: flat")
    diameter: Positive | None = None
    speed: Speed | None = None

    def given(self) -> state.Contact:
        return state.Belt(self.rough, self.wrap, self.tight, self.groove, self.diameter, self.speed)


class BeltDriveModel(Rough):
    """An open belt drive."""

    kind: Literal["belt drive"]
    driving: Positive | None = Field(default=None, description="diameter of the driving pulley")
    driven: Positive | None = Field(default=None, description="diameter of the driven pulley")
    distance: Positive
    speed: Speed = Field(description="of the driving pulley")
    driven_speed: Speed | None = Field(default=None, description="in place of one of the diameters")
    width: Positive
    thickness: Positive
    stress: Stress = Field(description="allowed in the belt", examples=["1.4 MPa"])
    density: Density | None = Field(
        default=None, description="left out, centrifugal forces are neglected", examples=["1000 kg/m^3"]
    )

    @model_validator(mode="after")
    def two_of_three(self) -> "BeltDriveModel":
        """Two of both diameters and the driven speed give the third."""
        if [self.driving, self.driven, self.driven_speed].count(None) != 1:
            wrong = Message(N_("the pulleys need two of their diameters and the driven speed"))
            raise WrongValue(
                wrong, Message(N_("two of: %(words)s"), {"words": "driving, driven, driven_speed"})
            )
        return self

    def given(self) -> state.Contact:
        slow = self.driven_speed / self.speed if self.driven_speed else 1.0
        driving = self.driving or (self.driven or 0.0) * slow
        driven = self.driven or driving / slow
        return state.BeltDrive(
            self.rough, driving, driven, self.distance, self.speed, self.width, self.thickness, self.stress,
            self.density,
        )  # fmt: skip


class WheelModel(Rough):
    """A rolling wheel."""

    kind: Literal["wheel"]
    radius: Positive
    arm: Positive = Field(description="of rolling resistance, k", examples=["0.5 mm"])
    load: Load
    pull: Load | None = Field(default=None, description="level force at the axle")

    def given(self) -> state.Contact:
        return state.Wheel(self.rough, self.radius, self.arm, self.load, self.pull)


class JournalModel(Rough):
    """A journal in its bearing."""

    kind: Literal["journal"]
    diameter: Positive
    load: Load
    speed: Speed | None = None

    def given(self) -> state.Contact:
        return state.Journal(self.rough, self.diameter, self.load, self.speed)


class JournalsModel(Model):
    """Diameters of the journals of a slider-crank."""

    shaft: Positive
    crank_pin: Positive
    wrist_pin: Positive


class CrankModel(Rough):
    """A slider-crank with friction circles."""

    kind: Literal["crank"]
    force: Load = Field(description="on the slider")
    crank: Positive
    rod: Positive
    angle: Angle = Field(description="of the crank from its dead point")
    journals: JournalsModel

    def given(self) -> state.Contact:
        journals = self.journals.shaft, self.journals.crank_pin, self.journals.wrist_pin
        return state.Crank(self.rough, self.force, self.crank, self.rod, self.angle, journals)


def _kind(value: Any) -> str:
    kind = value.get("kind") if isinstance(value, dict) else getattr(value, "kind", None)
    return f"<{kind}>"


AnyContact = Annotated[
    Annotated[InclineModel, Tag("<incline>")]
    | Annotated[WedgeModel, Tag("<wedge>")]
    | Annotated[SlidersModel, Tag("<sliders>")]
    | Annotated[TrialModel, Tag("<trial>")]
    | Annotated[ScrewModel, Tag("<screw>")]
    | Annotated[PivotModel, Tag("<pivot>")]
    | Annotated[BeltModel, Tag("<belt>")]
    | Annotated[BeltDriveModel, Tag("<belt drive>")]
    | Annotated[WheelModel, Tag("<wheel>")]
    | Annotated[JournalModel, Tag("<journal>")]
    | Annotated[CrankModel, Tag("<crank>")],
    Discriminator(
        _kind,
        custom_error_type="shape",
        custom_error_message=N_(
            "begin with kind: incline, wedge, sliders, trial, screw, pivot, belt, belt drive, wheel, journal or crank"
        ),
    ),
]


class Block(model.Block):
    """Friction in single pairs: planes, wedges, screws, pivots, belts, wheels."""

    ALONE = True
    HOLES = frozenset({("contacts",)})

    # None: the hole of a pair that is wrong in itself
    contacts: list[AnyContact | None] | None = Field(
        default=None, description="friction in single pairs", min_length=1, max_length=40
    )


class Given(TypedDict):
    contacts: state.Given | None


def given(read: Read) -> Given:
    written = read.block(Block).contacts
    items = tuple(state.Named(one.given(), one.name or "") for one in written or () if one)
    return {"contacts": state.Given(items) if written else None}


def mistakes(read: Read) -> Iterator[Problem]:
    yield from ()
