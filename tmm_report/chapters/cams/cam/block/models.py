"""What is stated of any cam: phases and laws, tables, a profile, the base circle and its limits, as pydantic models."""

import math
from collections.abc import Iterator, Sequence
from typing import Annotated, ClassVar, Literal, Self, get_args

from pydantic import Field, Tag, model_validator

from tmm_report.mechanics.cams.shapes import (
    Graph,
    Parabolic,
    Piece,
    Shape,
    Unfit,
    by_displacement,
    by_velocity,
    lines,
    named,
    trapezoid,
)
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.russian import english
from tmm_report.variant.values import (
    MAP,
    SCALAR,
    Angle,
    Length,
    Number,
    Point,
    Positive,
    Reads,
    by_shape,
    quantity,
    whole,
)

PhaseAngle = Annotated[float, quantity("angle", 1e-6, 2 * math.pi, "0 … 360 deg")]
REST = ("rest", "equal")  # a dwell that takes what the others leave of the turn, several of them alike
_DWELL = quantity("angle", 0.0, 2 * math.pi, "0 … 360 deg")


def _dwell(written: object) -> float | str:
    word = english(written, REST)
    return "rest" if isinstance(word, str) and word.strip() in REST else _DWELL.value(written)


DwellAngle = Annotated[
    float | Literal["rest"],
    Reads(
        _dwell,
        {"anyOf": [{"enum": [*REST]}, dict(_DWELL.schema)], "examples": ["30 deg", "rest"]},
        "angle",
    ),
]
Divisions = Annotated[int, whole(1, 48)]
PressureLimit = Annotated[float, quantity("angle", 1e-6, math.pi / 2, "0 … 90 deg")]
HalfAngle = Annotated[float, quantity("angle", 1e-6, math.pi, "0 … 180 deg")]
LawName = Literal[
    "parabolic", "decreasing", "cosine", "sine", "trapezoid", "modified_trapezoid", "modified_sine", "polynomial",
    "polynomial_4567", "uniform",
]  # fmt: skip
MOST = 48  # pieces of a graph
Width = Annotated[float, quantity("number", 1e-6, 1e6, "above 0")]


class PieceModel(Model):
    """A piece of a graph of acceleration, so many parts wide."""

    width: Width = Field(default=1.0, description="parts of the phase: the widths count against one another")
    constant: Number | None = Field(default=None, description="its ordinate")
    line: tuple[Number, Number] | None = Field(default=None, description="its ordinates at both ends")
    sine: tuple[Number, Number] | None = Field(
        default=None, description="the same: a quarter of a sine, level where the ordinate is the larger"
    )

    @model_validator(mode="after")
    def one_form(self) -> "PieceModel":
        if sum(form is not None for form in (self.constant, self.line, self.sine)) != 1:
            wrong = Message(N_("a piece of a graph has one form"))
            right = N_("{width: 2, constant: 1}, {width: 1, line: [1, -1]} or {width: 1, sine: [0, 1]}")
            raise WrongValue(wrong, Message(right))
        if self.sine is not None and self.sine[0] * self.sine[1] < 0:
            wrong = Message(N_("a quarter of a sine does not pass through zero"))
            raise WrongValue(wrong, Message(N_("two pieces: sine: [1, 0], then sine: [0, -1]")))
        return self


GraphPart = Annotated[
    Annotated[Number, Tag(SCALAR)] | Annotated[PieceModel, Tag(MAP)],
    by_shape(N_("an ordinate, such as 1.5, or a piece: {width: 2, constant: 1}")),
]


class PhaseModel(Model):
    """A part of the cam's turn: the follower rises, stands or returns."""

    rise: PhaseAngle | None = Field(default=None, description="the angle of a rise", examples=["120 deg"])
    dwell: DwellAngle | None = Field(
        default=None,
        description="the angle of a dwell; rest, or equal of several: what the other phases leave of the turn",
    )
    return_: PhaseAngle | None = Field(default=None, alias="return", description="the angle of a return")
    law: LawName | None = Field(default=None, description="the law of a rise or a return")
    ratio: Annotated[float, quantity("number", 0.05, 20.0, "0.05 … 20")] | None = Field(
        default=None,
        description="of the parabolic law: a1/a2, of its acceleration to its deceleration",
        examples=[1.8],
    )
    ramp: Annotated[float, quantity("number", 1e-3, 0.25, "0.001 … 0.25")] | None = Field(
        default=None,
        description="of the trapezoid: each of its four slopes, a share of the phase; left out, 1/8",
    )
    acceleration: list[GraphPart] | None = Field(
        default=None, min_length=2, max_length=MOST,
        description="instead of a law its graph to any scale: pieces, or ordinates at equal parts of the phase",
    )  # fmt: skip
    velocity: list[Number] | None = Field(
        default=None, min_length=3, max_length=MOST,
        description="instead of a law ordinates of velocity to any scale at equal parts of the phase",
    )  # fmt: skip
    displacement: list[Number] | None = Field(
        default=None, min_length=4, max_length=MOST,
        description="instead of a law displacements, to any scale, at equal parts of the phase, its ends "
        "among them; of a return they fall. A smooth curve goes through them, at rest at both ends",
    )  # fmt: skip
    divisions: Divisions | None = Field(
        default=None,
        description="of a cam: into so many equal parts the phase is divided, with a table over them",
    )

    @model_validator(mode="after")
    def one_kind(self) -> "PhaseModel":
        if sum(angle is not None for angle in (self.rise, self.dwell, self.return_)) != 1:
            wrong = Message(N_("a phase is a rise, a dwell or a return, one of them"))
            raise WrongValue(wrong, Message(N_("{rise: 120 deg, law: sine} or {dwell: 30 deg}")))
        graphs = (self.acceleration, self.velocity, self.displacement)
        ways = [way for way in (self.law, *graphs) if way is not None]
        if len(ways) != (self.dwell is None):
            wrong = Message(N_("a rise and a return have a law, a dwell has none"))
            right = Message(
                N_("{rise: 120 deg, law: sine}; laws: %(words)s; or a graph, acceleration: [0, 1, 0, -1, 0]"),
                {"words": ", ".join(get_args(LawName))},
            )
            raise WrongValue(wrong, right)
        for key, law in (("ratio", "parabolic"), ("ramp", "trapezoid")):
            if getattr(self, key) is not None and self.law != law:
                wrong = Message(N_("%(key)s belongs to the law %(law)s"), {"key": key, "law": law})
                raise WrongValue(wrong, Message(N_("leave one of the two")))
        self.shape()
        return self

    def shape(self) -> Shape | None:
        """The shape of its law; None of a dwell. Raises WrongValue for a graph that is none of a rise."""
        try:
            return self._shape()
        except Unfit as error:
            text, right = UNFIT[str(error)]
            raise WrongValue(Message(text), Message(right)) from None

    def _shape(self) -> Shape | None:
        if self.displacement is not None:
            way = -1.0 if self.return_ is not None else 1.0
            return by_displacement([way * y for y in self.displacement])
        if self.velocity is not None:
            return by_velocity(self.velocity)
        if self.acceleration is not None:
            return Graph(tuple(_pieces(self.acceleration)))
        if self.ratio is not None:
            return Parabolic(self.ratio)
        if self.ramp is not None:
            return trapezoid(self.ramp)
        return named(self.law) if self.law else None


UNFIT = {
    "one sign": (
        N_("a graph of acceleration lies on both sides of zero: the follower speeds up, then slows down"),
        N_("ordinates of both signs, such as [0, 1, 0, -1, 0]"),
    ),
    "turns back": (
        N_("by this graph the follower turns back within the phase"),
        N_("for a return too the graph is that of a rise: first above zero, the velocity nowhere below it"),
    ),
    "no lift": (
        N_("these displacements begin and end at the same place"),
        N_("from the lowest to the highest, such as [0, 3, 10, 17, 20]"),
    ),
    "falls back": (
        N_("by these displacements the follower turns back within the phase"),
        N_("in a rise none is smaller than the one before, in a return none larger"),
    ),
    "swings back": (
        N_("the smooth curve through these displacements turns back between them"),
        N_("more of them, or less unlike steps; where the follower stands still, a dwell"),
    ),
}


def _pieces(stated: Sequence[PieceModel | float]) -> Iterator[Piece]:
    """Raises WrongValue of pieces among ordinates."""
    ordinates = [one for one in stated if not isinstance(one, PieceModel)]
    pieces = [one for one in stated if isinstance(one, PieceModel)]
    if ordinates and pieces:
        wrong = Message(N_("a graph is stated by ordinates or by pieces"))
        raise WrongValue(wrong, Message(N_("write an ordinate as a piece: {width: 1, constant: 2}")))
    if ordinates:
        yield from lines(ordinates)
    for one in pieces:
        if one.line is not None:
            yield from lines(one.line, [one.width])
        elif one.sine is not None:
            yield Piece(one.width, *one.sine, "sine")
        else:
            yield Piece(one.width, float(one.constant or 0.0), float(one.constant or 0.0))


class CircleModel(Model):
    """A circular cam."""

    radius: Positive
    at: Point = Field(
        description="its centre from the cam's pivot, in the cam's axes", examples=["[15 mm, 0]"]
    )


class TangentModel(Model):
    """A tangent cam: straight flanks that touch the base circle and the nose."""

    NEEDED: ClassVar[int] = 2
    SIZES: ClassVar[tuple[str, ...]] = ("nose", "lift", "half_angle", "distance")

    base: Positive = Field(description="radius of the base circle, the least of the cam", examples=["32 mm"])
    nose: Positive | None = Field(default=None, description="radius of the nose", examples=["10 mm"])
    lift: Positive | None = Field(default=None, description="from the base circle to the tip of the nose")
    half_angle: HalfAngle | None = Field(
        default=None,
        description="half angle of action (of ascent), from the beginning of the lift to the tip",
    )
    distance: Positive | None = Field(default=None, description="of the nose's centre from the cam's axis")

    @property
    def sizes(self) -> dict[str, float]:
        """Those that are stated beside the base circle."""
        return {key: getattr(self, key) for key in self.SIZES if getattr(self, key) is not None}

    @model_validator(mode="after")
    def enough(self) -> Self:
        wrong = Message(
            N_(
                "beside the base circle %(needed)s of these sizes make the cam, and %(stated)s are stated: %(sizes)s"
            ),
            {"needed": str(self.NEEDED), "stated": str(len(self.sizes)), "sizes": ", ".join(self.SIZES)},
        )
        if len(self.sizes) != self.NEEDED:
            raise WrongValue(wrong, Message(N_("nose and lift, for example: nose: 10 mm, lift: 16 mm")))
        if set(self.sizes) == {"nose", "lift", "distance"}:
            text = N_("of the nose, the lift and the distance of its centre two make the third, and no flank")
            raise WrongValue(
                Message(text), Message(N_("the flank or the half angle in place of one of them"))
            )
        return self


class ArcsModel(TangentModel):
    """A cam of circular arcs: base circle, two flanks, the nose."""

    NEEDED: ClassVar[int] = 3
    SIZES: ClassVar[tuple[str, ...]] = (*TangentModel.SIZES, "flank")

    flank: Positive | None = Field(default=None, description="radius of the flanks", examples=["120 mm"])


class ProfileModel(Model):
    """The cam's own profile in its axes, from its pivot."""

    circle: CircleModel | None = None
    points: list[Point] | None = Field(default=None, description="at least 8, all round", max_length=1000)
    polar: list[tuple[Angle, Positive]] | None = Field(
        default=None, description="pairs of polar angle and radius, at least 8", max_length=1000
    )

    tangent: TangentModel | None = Field(
        default=None,
        description="a symmetrical cam with straight flanks, which begins to lift where a law would",
    )
    arcs: ArcsModel | None = Field(default=None, description="the same with flanks that are arcs")

    @model_validator(mode="after")
    def one_way(self) -> "ProfileModel":
        ways = (self.circle, self.points, self.polar, self.tangent, self.arcs)
        if sum(part is not None for part in ways) != 1:
            wrong = Message(N_("a profile is stated in one way"))
            raise WrongValue(wrong, Message(N_("circle, points, polar, tangent or arcs")))
        return self

    @property
    def pieced(self) -> TangentModel | None:
        """Of base circle, flanks and nose."""
        return self.tangent or self.arcs


def _base(written: object) -> float | Literal["smallest"]:
    return "smallest" if written == "smallest" else _RADIUS.value(written)


_RADIUS = quantity("length", 1e-9)
Base = Annotated[
    float | Literal["smallest"],
    Reads(
        _base,
        {"anyOf": [{"enum": ["smallest"]}, dict(_RADIUS.schema)], "examples": ["40 mm", "smallest"]},
        "length",
    ),
]


Step = Annotated[float, quantity("length", 1e-6, 0.1, "0.001 … 100 mm")]


class CamStated(Model):
    """What is stated of a cam and of its follower's law, whatever they are parts of."""

    base: Base | None = Field(
        default=None, description="least radius of the profile; smallest: by the permitted pressure angles"
    )
    round: Step | None = Field(
        default=None, description="to which the smallest radius is rounded up: that of the pitch curve of a roller",
        examples=["1 mm"],
    )  # fmt: skip
    lift: Positive | None = Field(default=None, description="of a sliding follower", examples=["30 mm"])
    swing: PhaseAngle | None = Field(default=None, description="of a swinging follower", examples=["20 deg"])
    phases: list[PhaseModel] = Field(default=[], max_length=24, description="the law, phase by phase")
    lifts: list[tuple[Angle, Length]] = Field(
        default=[], max_length=1000, description="the law as a table: cam angle, lift of a sliding follower"
    )
    swings: list[tuple[Angle, Angle]] = Field(
        default=[], max_length=1000, description="the law as a table: cam angle, swing"
    )
    profile: ProfileModel | None = Field(default=None, description="the cam itself, instead of a law")
    pressure_angle_limit: PressureLimit | None = Field(
        default=None, description="left out, 30 deg of a sliding, 45 deg of a swinging follower"
    )
    return_angle_limit: PressureLimit | None = Field(
        default=None, description="of the return; left out, none: a spring or a weight drives it"
    )
    least_curvature: Positive | None = Field(
        default=None,
        description="of the profile under a flat face, for its smallest base circle",
        examples=["5 mm"],
    )

    @property
    def faced(self) -> bool:
        """Whether the follower touches by a flat face."""
        return False

    @model_validator(mode="after")
    def one_law(self) -> Self:
        ways = [self.phases, self.lifts, self.swings, self.profile]
        if sum(bool(way) for way in ways) != 1:
            wrong = Message(N_("the follower's law is not stated in one way"))
            right = Message(N_("phases with lift or swing, a table lifts or swings, or the cam's profile"))
            raise WrongValue(wrong, right)
        return self

    @model_validator(mode="after")
    def rounds(self) -> Self:
        if self.round is not None and self.base != "smallest":
            wrong = Message(N_("only the smallest base circle is rounded"))
            raise WrongValue(wrong, Message(N_("base: smallest, or leave out round")))
        if self.least_curvature is not None and (self.base != "smallest" or not self.faced):
            wrong = Message(N_("the least curvature is of the smallest base circle under a flat face"))
            raise WrongValue(wrong, Message(N_("leave it out")))
        return self
