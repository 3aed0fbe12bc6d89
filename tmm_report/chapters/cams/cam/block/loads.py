"""What loads the follower of a cam that stands alone, and what rubs: the keys of `cam` that the chapter of its forces
takes."""

from typing import Annotated, Literal

from pydantic import Field, Tag, model_validator

from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.russian import english
from tmm_report.variant.values import (
    MAP,
    SCALAR,
    Angle,
    AngleForces,
    AngleMoments,
    ForceValue,
    Length,
    MomentValue,
    Positive,
    Reads,
    StrokeForces,
    StrokeMoments,
    TurnAngle,
    by_shape,
    quantity,
)

SMALLEST = "smallest"
Coefficient = Annotated[float, quantity("number", 0.0, 2.0, "0 … 2")]
Kilograms = Annotated[float, quantity("mass", 0.0)]
Inertia = Annotated[float, quantity("inertia", 0.0)]
Gravity = Annotated[float, quantity("acceleration", 0.0)]
Reserve = Annotated[float, quantity("number", 1.0, 10.0, "1 … 10")]
Permitted = Annotated[float, quantity("pressure", 1e5, 1e11, "0.1 … 100 000 MPa")]
Ratio = Annotated[float, quantity("number", 0.0, 1.0, "0 … 1")]


def _of(kind: str) -> Reads:
    """A value, or the word that leaves it to be found."""
    own = quantity(kind, 0.0)

    def read(written: object) -> float | str:
        word = english(written, (SMALLEST,))
        return SMALLEST if isinstance(word, str) and word.strip() == SMALLEST else own.value(written)

    return Reads(read, {"anyOf": [{"enum": [SMALLEST]}, dict(own.schema)], "examples": [SMALLEST]}, kind)


Rate = Annotated[float | Literal["smallest"], _of("stiffness")]
TurnRate = Annotated[float | Literal["smallest"], _of("torsional stiffness")]
Preload = Annotated[float | Literal["smallest"], _of("force")]
TurnPreload = Annotated[float | Literal["smallest"], _of("moment")]


class ForceLaw(Model):
    """A load on a sliding follower against its lift, by one law."""

    constant: ForceValue | None = None
    rise: ForceValue | None = Field(default=None, description="while it rises and stands high")
    return_: ForceValue | None = Field(default=None, alias="return", description="on the way back and low")
    by_angle: AngleForces | None = Field(default=None, description="[[angle of the cam, force], ...], a turn")
    forward: StrokeForces | None = Field(default=None, description="[[part of the lift, force], ...], rising")
    back: StrokeForces | None = Field(default=None, description="the same on the way back")

    @model_validator(mode="after")
    def one_law(self) -> "ForceLaw":
        _one_law(self)
        return self


class MomentLaw(Model):
    """A load on a swinging follower against its lift, by one law."""

    constant: MomentValue | None = None
    rise: MomentValue | None = Field(default=None, description="while it rises and stands high")
    return_: MomentValue | None = Field(default=None, alias="return", description="on the way back and low")
    by_angle: AngleMoments | None = Field(
        default=None, description="[[angle of the cam, moment], ...], a turn"
    )
    forward: StrokeMoments | None = Field(
        default=None, description="[[part of the swing, moment], ...], rising"
    )
    back: StrokeMoments | None = Field(default=None, description="the same on the way back")

    @model_validator(mode="after")
    def one_law(self) -> "MomentLaw":
        _one_law(self)
        return self


def _one_law(stated: ForceLaw | MomentLaw) -> None:
    ways = [
        stated.constant is not None,
        stated.rise is not None or stated.return_ is not None,
        stated.by_angle is not None,
        stated.forward is not None or stated.back is not None,
    ]
    if sum(ways) != 1:
        wrong = Message(N_("the load's magnitude must be stated by one law"))
        words = "constant, rise and return, by_angle, forward and back"
        raise WrongValue(wrong, Message(N_("exactly one of: %(words)s"), {"words": words}))
    if (stated.forward is None) != (stated.back is None):
        wrong = Message(N_("the load is stated for one way alone"))
        raise WrongValue(
            wrong, Message(N_("both: forward: [[0, 100 N], [1, 400 N]], back: [[0, 0], [1, 0]]"))
        )


class SpringModel(Model):
    """The spring of a sliding follower; what is to be the smallest is found."""

    rate: Rate | None = Field(default=None, examples=["15 N/mm"])
    preload: Preload | None = Field(default=None, description="in the lowest position", examples=["40 N"])
    compression: Length | None = Field(
        default=None, description="in its place: by how much it is pressed then"
    )
    ratio: Ratio | None = Field(
        default=None, description="instead of both: preload by the greatest force, of the smallest that hold"
    )
    reserve: Reserve = Field(default=1.0, description="K: so many times the inertia is held", examples=[1.3])

    @model_validator(mode="after")
    def whole(self) -> "SpringModel":
        _whole(self, self.compression, "compression")
        return self


class TorsionModel(Model):
    """The torsion spring of a swinging follower."""

    rate: TurnRate | None = Field(default=None, examples=["20 N*m/rad"])
    preload: TurnPreload | None = Field(
        default=None, description="in the lowest position", examples=["4 N*m"]
    )
    turned: Angle | None = Field(default=None, description="in its place: by how much it is turned then")
    ratio: Ratio | None = Field(
        default=None, description="instead of both: preload by the greatest moment, of the smallest that hold"
    )
    reserve: Reserve = Field(default=1.0, description="K: so many times the inertia is held", examples=[1.3])

    @model_validator(mode="after")
    def whole(self) -> "TorsionModel":
        _whole(self, self.turned, "turned")
        return self


def _whole(stated: SpringModel | TorsionModel, pressed: float | None, key: str) -> None:
    given = {"key": key}
    if stated.ratio is not None and (stated.rate, stated.preload, pressed) != (None, None, None):
        wrong = Message(N_("a ratio leaves rate and preload to be found"))
        raise WrongValue(wrong, Message(N_("leave out the rate and the preload, or the ratio")))
    if stated.preload is not None and pressed is not None:
        wrong = Message(N_("the preload is stated twice"))
        raise WrongValue(wrong, Message(N_("preload or %(key)s, one of them"), given))
    if pressed is not None and not isinstance(stated.rate, float):
        wrong = Message(N_("a spring that is pressed by a length needs its rate"))
        raise WrongValue(wrong, Message(N_("rate: 15 N/mm")))
    if pressed is not None and pressed < 0:
        raise WrongValue(Message(N_("the spring of a cam is pressed, not drawn")), None)
    if stated.ratio is None and (stated.rate is None or (stated.preload is None and pressed is None)):
        wrong = Message(N_("a spring needs its rate and its preload"))
        right = N_("rate: 15 N/mm, preload: 40 N (or compression: 2.5 mm); what is to be found: smallest")
        raise WrongValue(wrong, Message(right))


def _smallest(written: object) -> str:
    word = english(written, (SMALLEST,))
    if word != SMALLEST:
        raise WrongValue(
            Message(N_("a spring is stated by its parts")),
            Message(N_("smallest, or {rate: 15 N/mm, preload: 40 N}")),
        )
    return SMALLEST


Word = Annotated[Literal["smallest"], Reads(_smallest, {"enum": [SMALLEST]})]
_SPRING = by_shape(N_("smallest, or {rate: 15 N/mm, preload: 40 N}"))
Spring = Annotated[Annotated[Word, Tag(SCALAR)] | Annotated[SpringModel, Tag(MAP)], _SPRING]
Torsion = Annotated[Annotated[Word, Tag(SCALAR)] | Annotated[TorsionModel, Tag(MAP)], _SPRING]
_LOAD = by_shape(N_("a constant load, such as 200 N, or {rise: 400 N, return: 50 N}"))
Load = Annotated[Annotated[ForceValue, Tag(SCALAR)] | Annotated[ForceLaw, Tag(MAP)], _LOAD]
MomentLoad = Annotated[Annotated[MomentValue, Tag(SCALAR)] | Annotated[MomentLaw, Tag(MAP)], _LOAD]


class GuideModel(Model):
    """The guide of a sliding follower, which touches it at both ends."""

    length: Positive = Field(examples=["80 mm"])
    overhang: Positive = Field(description="from the roller's centre, or the face, to its nearer end")
    friction: Coefficient = Field(description="coefficient", examples=[0.1])
    shortens: bool = Field(
        default=False,
        description="true: the overhang is that of the lowest position and lessens with the lift",
    )


class PinModel(Model):
    """A journal with friction: of a roller, of the pivot of a swinging follower."""

    diameter: Positive | None = Field(default=None, examples=["8 mm"])
    radius: Positive | None = None
    friction: Coefficient = Field(description="coefficient", examples=[0.1])

    @model_validator(mode="after")
    def one_size(self) -> "PinModel":
        if (self.diameter is None) == (self.radius is None):
            wrong = Message(N_("the size of a journal is stated in one way"))
            raise WrongValue(wrong, Message(N_("diameter: 8 mm, or radius: 4 mm")))
        return self

    @property
    def half(self) -> float:
        return self.radius if self.radius is not None else (self.diameter or 0.0) / 2


STOCK = {"steel": (2.1e11, 0.3), "cast iron": (1.1e11, 0.25), "bronze": (1.1e11, 0.33)}
"""Young's modulus, Pa, and Poisson's ratio (Birger, Shorr, Iosilevich, Strength of machine parts)."""


class MaterialModel(Model):
    """A material by its elasticity."""

    young: Annotated[float, quantity("pressure", 1e8, 2e12, "0.1 … 2000 GPa")] = Field(
        description="modulus E", examples=["210 GPa"]
    )
    poisson: Annotated[float, quantity("number", 0.0, 0.5, "0 … 0.5")] = 0.3


def _stock(written: object) -> str:
    word = english(written, tuple(STOCK))
    if word not in STOCK:
        text = N_("steel, cast iron, bronze, or {young: 210 GPa, poisson: 0.3}")
        raise WrongValue(Message(N_("no such material in the table")), Message(text))
    return str(word)


Stock = Annotated[str, Reads(_stock, {"enum": [*STOCK]})]
Material = Annotated[
    Annotated[Stock, Tag(SCALAR)] | Annotated[MaterialModel, Tag(MAP)],
    by_shape(N_("steel, cast iron, bronze, or {young: 210 GPa, poisson: 0.3}")),
]


class ContactModel(Model):
    """What the pressure in the contact depends on."""

    width: Positive = Field(description="of the cam under the roller or the face", examples=["12 mm"])
    cam: Material = Field(default="steel", description="left out, steel")
    follower: Material = Field(default="steel", description="of the roller or the face; left out, steel")
    permitted: Permitted | None = Field(default=None, description="permitted pressure", examples=["800 MPa"])


class LoadedModel(Model):
    """Of a follower under its loads."""

    mass: Kilograms | None = Field(default=None, description="of the follower with its roller")
    inertia: Inertia | None = Field(default=None, description="of a swinging follower, about its pivot")
    mass_centre: Length | None = Field(
        default=None, description="of a swinging follower: how far its mass is from the pivot, along the arm"
    )
    gravity: Gravity | None = Field(
        default=None,
        description="the weight counts, downwards; left out, it does not",
        examples=["9.81 m/s^2"],
    )
    load: Load | None = Field(default=None, description="on a sliding follower, against its lift")
    moment: MomentLoad | None = Field(default=None, description="on a swinging follower, against its lift")
    spring: Spring | None = Field(
        default=None, description="of a sliding follower: smallest: the least that holds it on the cam"
    )
    torsion: Torsion | None = Field(default=None, description="the torsion spring of a swinging follower")
    guide: GuideModel | None = Field(default=None, description="of a sliding follower, with friction")
    pin: PinModel | None = Field(default=None, description="of the roller, with friction")
    pivot: PinModel | None = Field(default=None, description="of a swinging follower, with friction")
    face_friction: Coefficient | None = Field(
        default=None, description="coefficient, of an edge or a flat face on the cam"
    )
    contact: ContactModel | None = Field(default=None, description="for the pressure in the contact")
    closure: Literal["force", "groove"] = Field(
        default="force",
        description="groove: the cam holds the roller by a second wall, which is found, and pulls it, too",
    )
    at: list[TurnAngle] = Field(
        default=[],
        max_length=100,
        description="angles of the cam at which forces are asked",
        examples=["[100 deg]"],
    )

    @property
    def loaded(self) -> bool:
        """Whether the file asks for forces."""
        keys = set(LoadedModel.model_fields) - {"closure"}
        return bool(keys & self.model_fields_set)
