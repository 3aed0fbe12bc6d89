"""The key `cam` as a pydantic model: a cam that stands alone, as a course's sheet states it."""

from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from tmm_report.chapters.cams.cam.block.loads import LoadedModel
from tmm_report.chapters.cams.cam.block.models import CamStated
from tmm_report.chapters.cams.cam.given import Follower
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.russian import english
from tmm_report.variant.values import Length, Positive, Reads, Turn, quantity, whole

Count = Annotated[int, whole(12, 360)]
FREE, CHOSEN, DRIVE = "free", "chosen", "drive"
_LENGTH, _POSITIVE, _SPEED = quantity("length"), quantity("length", 1e-9), quantity("speed")


def _free(stated: Reads, left: str = FREE, example: str = "12 mm") -> Reads:
    """A number, or the word that leaves it to be found."""

    def read(written: object) -> float | str:
        word = english(written, (left,))
        return left if isinstance(word, str) and word.strip() == left else stated.value(written)

    return Reads(
        read,
        {"anyOf": [{"enum": [left]}, dict(stated.schema)], "examples": [example, left]},
        stated.dimension,
    )


Distance = Annotated[float | Literal["free"], _free(_POSITIVE)]
Roller = Annotated[float | Literal["chosen"], _free(_POSITIVE, CHOSEN)]
Offset = Annotated[float | Literal["free"], _free(_LENGTH)]
CamSpeed = Annotated[float | Literal["drive"], _free(_SPEED, DRIVE, "150 rpm")]


class CamAloneModel(LoadedModel, CamStated):
    """A cam with its follower: a translating one has a lift, a swinging one a swing."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(
            ("knife", "edge", "flat"), N_("of a cam alone it is said by follower: knife or flat")
        ),
    }

    follower: Follower | None = Field(
        default=None, description="how it touches the cam; left out, by a roller where that is stated"
    )
    roller: Roller | None = Field(
        default=None,
        description="radius of the roller; chosen: the greatest that the rules allow, in whole millimetres",
    )
    shaft: Positive | None = Field(
        default=None,
        description="diameter of the cam's shaft, by which the smallest base circle is limited too",
        examples=["30 mm"],
    )
    pitch_base: Positive | None = Field(
        default=None,
        description="instead of base: least radius of the centre profile (pitch curve), of the roller's centre",
        examples=["50 mm"],
    )
    offset: Offset | None = Field(
        default=None,
        description="of the line of a translating follower from the cam's axis; above zero where it lessens the "
        "pressure angle of the rise; free: that of the smallest cam",
    )
    arm: Positive | None = Field(
        default=None, description="of a swinging follower: from its pivot to the roller's centre or the edge"
    )
    centre_distance: Distance | None = Field(
        default=None,
        description="of a swinging follower: from the cam's axis to its pivot; free: that of the smallest cam",
    )
    face_offset: Length | None = Field(
        default=None,
        description="of the flat face of a swinging follower from its pivot, above zero towards the cam; left out, 0",
    )
    side: Literal["against", "with", "left", "right"] | None = Field(
        default=None,
        description="which way a swinging follower lifts: against or with the cam's rotation; on which side of the "
        "axis the line of a translating one passes: against the rotation (the surface of the cam comes up there), with "
        "it, left, right",
    )
    rotation: Turn = Field(default="counter-clockwise", description="the sense in which the cam turns")
    speed: CamSpeed | None = Field(
        default=None,
        description="of the cam, rad/s or rpm, negative: clockwise; drive: that of the drive's output shaft",
    )
    cutter: Positive | None = Field(
        default=None, description="radius of the cutter, for the path of its centre", examples=["6 mm"]
    )
    positions: Count = Field(default=12, description="equal parts of the turn: 12, 24, 36 …")

    @property
    def faced(self) -> bool:
        return self.follower == "flat"

    @property
    def sought(self) -> bool:
        """Whether the base circle is the smallest: that is so, too, of a task of forces alone, which states none."""
        none = self.base is None and self.pitch_base is None and not self.profile
        return self.base == "smallest" or (none and self.loaded and not self.faced)

    @property
    def driven(self) -> bool:
        """Whether the drive is to give its speed."""
        return self.speed == DRIVE

    @property
    def swinging(self) -> bool:
        stated = (self.swing, self.arm, self.centre_distance)
        return bool(self.swings) or any(one is not None for one in stated)

    @model_validator(mode="after")
    def one_follower(self) -> "CamAloneModel":
        if self.follower is None and self.roller is None and not self.loaded:
            wrong = Message(N_("how the follower touches the cam is not stated"))
            raise WrongValue(wrong, Message(N_("roller: 10 mm, or follower: knife, or follower: flat")))
        if self.roller is not None and self.follower in ("knife", "flat"):
            wrong = Message(N_("the follower has a roller, or a knife edge or a flat face, one of them"))
            raise WrongValue(wrong, Message(N_("leave one of the two")))
        if self.follower == "roller" and self.roller is None:
            wrong = Message(N_("the radius of the roller is missing"))
            raise WrongValue(wrong, Message(N_("roller: 10 mm")))
        return self

    @model_validator(mode="after")
    def one_base(self) -> "CamAloneModel":
        if self.base is not None and self.pitch_base is not None:
            wrong = Message(N_("the base circle is stated twice: of the profile and of the pitch curve"))
            raise WrongValue(wrong, Message(N_("leave one of the two")))
        return self
