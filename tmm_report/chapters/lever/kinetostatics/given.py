"""Loads on the mechanism as the variant states them: forces on points, moments on links, each by its law; SI."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import KW_ONLY
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from tmm_report.mechanics.calculus.laws import (
    ByAngle,
    ByDisplacement,
    ByPosition,
    ByStrokes,
    ByTime,
    Constant,
    Curve,
    Law,
)
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Discriminator, Field, Tag

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        Angle,
        AngleForces,
        AngleMoments,
        AnglePressures,
        Direction,
        ForceValue,
        Label,
        MomentValue,
        Name,
        Part,
        Positive,
        Pressure,
        Sense,
        Side,
        StrokeForces,
        StrokeMoments,
        StrokeParts,
        StrokePressures,
        TimeForces,
        TimeMoments,
        TimePressures,
        Turning,
        by_shape,
    )

_ZERO = "the extreme of the point that the stroke is counted from"
_STROKES = (
    "name of the stroke: [[x, value], ...], one for each stroke of the point in the cycle, in the order in which they "
    "follow: the first away from the zero, the next back to it; intake, compression, power, exhaust are translated"
)
_ON = (
    "the link that takes the force, where several share the point; left out, a slider, else the first of them"
)
_BY_POSITION = (
    "one value for each position of the table; of a cycle of full turns without the last position, which is the first "
    "again"
)
OTHER_LAW = N_("a load by the speed is not offered: a constant one along or against the motion is")
_BY_TIME = "[[time from position 0, value], ...] over the whole cycle"
_ENDS = "the first and the last part of the stroke in which it is nothing"
_OF = "the greatest value, of which the others are parts; left out, they are values themselves"
_FIRST = (
    "the stroke that is under way at position 0, or begins there; left out, the first of the strokes or, where the "
    "point goes to the zero there, the last"
)


def _parts_of(greatest: float | None, curves: Iterable[Sequence[tuple[float, float]]]) -> None:
    """Values that are parts of a greatest one, where it is stated. Raises WrongValue for those above 1."""
    if (
        greatest is not None
        and max((abs(value) for curve in curves for _, value in curve), default=0) > 1 + 1e-9
    ):
        wrong = Message(N_("with the key of the values are parts of the greatest one, at most 1"))
        raise WrongValue(wrong, Message(N_("0.8, or without of: the values with their unit")))


class OfGreatest:
    """What may be stated in parts of a greatest value."""

    zero: Any
    forward: Any
    back: Any
    of: Any

    def __post_init__(self) -> None:
        _parts_of(self.of, (self.forward, self.back))

    @property
    def law(self) -> Law:
        law = ByDisplacement(complex(self.zero), tuple(self.forward), tuple(self.back))
        return law if self.of is None else law.scaled(self.of)


@dataclass(frozen=True)
class Diagram(OfGreatest):
    """An indicator diagram: force against the fraction of the stroke."""

    zero: Annotated[Side, Field(description=_ZERO)]
    forward: Annotated[StrokeForces, Field(description="[[x, force], ...] on the way from the zero")]
    back: Annotated[StrokeForces, Field(description="[[x, force], ...] on the way back")]
    of: Annotated[ForceValue | None, Field(description=_OF)] = None


@dataclass(frozen=True)
class PressureDiagram(Diagram):
    """An indicator diagram of pressure against the fraction of the stroke."""

    forward: Annotated[StrokePressures, Field(description="[[x, pressure], ...] on the way from the zero")]
    back: Annotated[StrokePressures, Field(description="[[x, pressure], ...] on the way back")]
    of: Annotated[Pressure | None, Field(description=_OF)] = None


@dataclass(frozen=True)
class StrokesDiagram:
    """An indicator diagram of a cycle of several turns: force against the fraction of the stroke, stroke by stroke."""

    zero: Annotated[Side, Field(description=_ZERO)]
    strokes: Annotated[
        dict[Label, StrokeForces],
        Field(
            description=_STROKES,
            examples=["{intake: [[0, 5 N], [1, 5 N]], compression: [[0, 9 kN], [1, 5 N]], …}"],
        ),
    ]
    first: Annotated[Label | None, Field(description=_FIRST, examples=["compression"])] = None
    of: Annotated[ForceValue | None, Field(description=_OF)] = None

    def __post_init__(self) -> None:
        _parts_of(self.of, self.strokes.values())

    @property
    def law(self) -> Law:
        names, curves = tuple(self.strokes), tuple(map(tuple, self.strokes.values()))
        law = ByStrokes(self.zero, names, curves, None if self.first is None else names.index(self.first))
        return law if self.of is None else law.scaled(self.of)


@dataclass(frozen=True)
class PressureStrokesDiagram(StrokesDiagram):
    """An indicator diagram of a cycle of several turns: pressure against the fraction of the stroke, by strokes."""

    strokes: Annotated[
        dict[Label, StrokePressures],
        Field(
            description=_STROKES,
            examples=["{intake: [[0, 0], [1, 0]], compression: [[0, 3 MPa], [1, 0]], …}"],
        ),
    ]
    of: Annotated[Pressure | None, Field(description=_OF)] = None


@dataclass(frozen=True)
class StatedCurve:
    """A curve that several loads have, in parts of the greatest value of each."""

    forward: Annotated[StrokeParts, Field(description="[[x, part], ...] on the way from the zero")]
    back: Annotated[StrokeParts, Field(description="[[x, part], ...] on the way back")]


@dataclass(frozen=True)
class StatedStrokes:
    """Curves of a cycle of several turns that several loads have, in parts of the greatest value of each."""

    strokes: Annotated[dict[Label, StrokeParts], Field(description=_STROKES)]


@dataclass(frozen=True)
class SharedDiagram:
    """A curve of `loads.curves` times the greatest value."""

    zero: Annotated[Side, Field(description=_ZERO)]
    curve: Annotated[Label, Field(description="a name of loads.curves", examples=["gas"])]
    of: Annotated[ForceValue, Field(description="the greatest value")]
    first: Annotated[Label | None, Field(description=_FIRST, examples=["compression"])] = None

    def through(self, curve: StatedCurve | StatedStrokes) -> Any:
        """The diagram that it stands for."""
        if isinstance(curve, StatedStrokes):
            return StrokesDiagram(self.zero, curve.strokes, self.first, self.of)
        return Diagram(self.zero, curve.forward, curve.back, self.of)


@dataclass(frozen=True)
class SharedPressure(SharedDiagram):
    """A curve of `loads.curves` times the greatest pressure."""

    of: Annotated[Pressure, Field(description="the greatest value")]


@dataclass(frozen=True)
class SharedSwing(SharedDiagram):
    """A curve of `loads.curves` times the greatest moment."""

    zero: Annotated[Sense, Field(description="the extreme of the link that the swing is counted from")]  # type: ignore[assignment]
    of: Annotated[MomentValue, Field(description="the greatest value")]

    def through(self, curve: StatedCurve | StatedStrokes) -> Any:
        assert isinstance(curve, StatedCurve)  # strokes are those of points
        return Swing(self.zero, curve.forward, curve.back, self.of)


def by_strokes(value: Any) -> str:
    if isinstance(value, dict) and "curve" in value:
        return "<curve>"
    return "<strokes>" if isinstance(value, dict) and {"strokes", "first"} & value.keys() else "<ways>"


@dataclass(frozen=True)
class Swing(OfGreatest):
    """A moment against the part of the link's swing."""

    zero: Annotated[Sense, Field(description="the extreme of the link that the swing is counted from")]
    forward: Annotated[StrokeMoments, Field(description="[[x, moment], ...] on the way from the zero")]
    back: Annotated[StrokeMoments, Field(description="[[x, moment], ...] on the way back")]
    of: Annotated[MomentValue | None, Field(description=_OF)] = None


@dataclass(frozen=True)
class WorkingStroke:
    """The stroke in which a constant load acts; it is nothing on the way back."""

    zero: Annotated[Side, Field(description="the extreme from which the stroke goes")]
    ends: Annotated[Part, Field(description=_ENDS)] = 0.0

    def of(self, size: float) -> Law:
        return ByDisplacement(self.zero, _but_at_ends(size, self.ends), ((0.0, 0.0), (1.0, 0.0)))


@dataclass(frozen=True)
class WorkingSwing:
    """The way of its link in which a constant moment acts; it is nothing on the way back."""

    zero: Annotated[Sense, Field(description="the extreme from which the link swings")]
    ends: Annotated[Part, Field(description=_ENDS)] = 0.0

    def of(self, size: float) -> Law:
        return ByDisplacement(complex(self.zero), _but_at_ends(size, self.ends), ((0.0, 0.0), (1.0, 0.0)))


def _but_at_ends(size: float, ends: float) -> Curve:
    """Constant, and nothing in the first and the last part of the stroke; a jump is two places a bit apart."""
    if not ends:
        return (0.0, size), (1.0, size)
    on, off = ends, 1.0 - ends
    return (
        (0.0, 0.0), (on, 0.0), (math.nextafter(on, 1), size), (off, size), (math.nextafter(off, 1), 0.0), (1.0, 0.0),
    )  # fmt: skip


@dataclass(frozen=True)
class Carried:
    """A direction that a link carries with it."""

    link: Annotated[Name, Field(description="the link", examples=["2"])]
    angle: Annotated[Angle, Field(description="from the x axis of the link, counter-clockwise")] = 0.0


@dataclass(frozen=True)
class Towards:
    """The direction from a point towards another, of the forces of springs and dampers."""

    point: str


LAWS: Mapping[str, Callable[[Any], Law]] = {
    "constant": Constant,
    "components": lambda parts: Constant(abs(complex(*parts))),
    "by_position": lambda values: ByPosition(tuple(values)),
    "by_angle": ByAngle.through,
    "by_time": ByTime.through,
    "by_displacement": lambda diagram: diagram.law,
}
"""The keys of which a load has one, and what is stated there as a law."""


class ByOneLaw:
    """What states its magnitude by one of the laws, and the stroke in which it acts, if it is not the whole cycle."""

    stroke: Any = None

    def __post_init__(self) -> None:
        keys = [key for key in LAWS if hasattr(self, key)]
        if sum(getattr(self, key) is not None for key in keys) != 1:
            wrong = Message(N_("the load's magnitude must be stated by one law"))
            raise WrongValue(wrong, Message(N_("exactly one of: %(words)s"), {"words": ", ".join(keys)}))
        same = any(getattr(self, key, None) is not None for key in ("constant", "components"))
        if self.stroke is not None and not same:
            wrong = Message(N_("a load of one stroke is constant there"))
            raise WrongValue(wrong, Message(N_("constant with stroke, or by_displacement without it")))

    @property
    def _stated(self) -> Law:
        stated = ((made, getattr(self, key, None)) for key, made in LAWS.items())
        return next(made(value) for made, value in stated if value is not None)

    @cached_property
    def law(self) -> Law:
        found = self._stated
        return (
            found if self.stroke is None or not isinstance(found, Constant) else self.stroke.of(found.amount)
        )


@dataclass(frozen=True)
class Force(ByOneLaw):
    """A force on a named point."""

    LETTER: ClassVar = "F"  # of those without a name
    NOT_OFFERED: ClassVar[Mapping[str, str]] = dict.fromkeys(("by_velocity", "by_speed"), OTHER_LAW)

    _: KW_ONLY
    name: Annotated[CalledBy | None, Field(description="for the tables; left out, F1, F2, …")] = None
    at: Annotated[Name, Field(description="the point", examples=["B"])]
    on: Annotated[Name | None, Field(description=_ON, examples=["5"])] = None
    direction: Annotated[
        Annotated[Direction, Tag("<scalar>")] | Annotated[Carried, Tag("<map>")],
        by_shape("right, an angle (30 deg), along motion, or {link: 2, angle: 60 deg}"),
    ]
    constant: ForceValue | None = None
    stroke: Annotated[
        WorkingStroke | None, Field(description="in which the constant force acts, left out, always")
    ] = None
    by_position: Annotated[list[ForceValue] | None, Field(description=_BY_POSITION)] = None
    by_angle: Annotated[
        AngleForces | None, Field(description="[[angle of rotation, force], ...] over the whole cycle")
    ] = None
    by_time: Annotated[
        TimeForces | None,
        Field(description=_BY_TIME, examples=["[[0 s, 0 N], [0.1 s, 300 N], [0.25 s, 0 N]]"]),
    ] = None
    by_displacement: (
        Annotated[
            Annotated[Diagram, Tag("<ways>")]
            | Annotated[StrokesDiagram, Tag("<strokes>")]
            | Annotated[SharedDiagram, Tag("<curve>")],
            Discriminator(by_strokes),
        ]
        | None
    ) = None

    @property
    def way(self) -> complex | Carried | Towards | str:
        """The direction, unit complex; carried by a link; to another point; "along" or "against" the motion."""
        return self.direction


@dataclass(frozen=True)
class Vector(Force):
    """A constant force on a named point by its components."""

    NOT_STATED: ClassVar[tuple[str, ...]] = (
        "direction", "constant", "by_position", "by_angle", "by_time", "by_displacement",
    )  # fmt: skip
    NOT_OFFERED: ClassVar[Mapping[str, str]] = dict.fromkeys(
        NOT_STATED, N_("the components state the force and its direction")
    )

    _: KW_ONLY
    direction: complex = 1.0 + 0j
    components: Annotated[
        tuple[ForceValue, ForceValue],
        Field(description="constant, along x and y", examples=["[400 N, -2600 N]"]),
    ]

    @property
    def way(self) -> complex:
        whole = complex(*self.components)
        return whole / abs(whole) if whole else 1.0 + 0j


@dataclass(frozen=True)
class Piston(Force):
    """A pressure on a piston at a named point."""

    _: KW_ONLY
    piston_diameter: Annotated[Positive, Field(description="the values of the law are then pressures")]
    constant: Pressure | None = None
    by_position: Annotated[list[Pressure] | None, Field(description=_BY_POSITION)] = None
    by_angle: Annotated[
        AnglePressures | None, Field(description="[[angle of rotation, pressure], ...] over the whole cycle")
    ] = None
    by_time: Annotated[
        TimePressures | None,
        Field(description=_BY_TIME, examples=["[[0 s, 0 MPa], [0.1 s, 2 MPa], [0.25 s, 0 MPa]]"]),
    ] = None
    by_displacement: (
        Annotated[
            Annotated[PressureDiagram, Tag("<ways>")]
            | Annotated[PressureStrokesDiagram, Tag("<strokes>")]
            | Annotated[SharedPressure, Tag("<curve>")],
            Discriminator(by_strokes),
        ]
        | None
    ) = None

    @cached_property
    def law(self) -> Law:
        return super().law.scaled(math.pi / 4 * self.piston_diameter**2)


@dataclass(frozen=True)
class Moment(ByOneLaw):
    """A moment on a link."""

    LETTER: ClassVar = "M"
    NOT_OFFERED: ClassVar[Mapping[str, str]] = dict.fromkeys(("by_velocity", "by_speed"), OTHER_LAW)

    _: KW_ONLY
    name: Annotated[CalledBy | None, Field(description="for the tables; left out, M1, M2, …")] = None
    on: Annotated[Name, Field(description="the link", examples=["3"])]
    direction: Annotated[
        Turning, Field(description="which way it turns; along or against the motion of the link")
    ]
    constant: MomentValue | None = None
    stroke: Annotated[
        WorkingSwing | None, Field(description="in which the constant moment acts; left out, always")
    ] = None
    by_position: Annotated[list[MomentValue] | None, Field(description=_BY_POSITION)] = None
    by_angle: Annotated[
        AngleMoments | None, Field(description="[[angle of rotation, moment], ...] over the whole cycle")
    ] = None
    by_time: Annotated[
        TimeMoments | None,
        Field(description=_BY_TIME, examples=["[[0 s, 0 N*m], [0.1 s, 30 N*m], [0.25 s, 0 N*m]]"]),
    ] = None
    by_displacement: Annotated[
        Annotated[
            Annotated[Swing, Tag("<ways>")] | Annotated[SharedSwing, Tag("<curve>")],
            Discriminator(by_strokes),
        ]
        | None,
        Field(description="against the part of the swing of the link"),
    ] = None


@dataclass(frozen=True)
class Loads:
    """Loads of the kinetostatics chapter. `gravity`: complex, m/s²; inertia comes from the links' masses. `forces`:
    those of springs and dampers (`ties.End`) stand after the others."""

    gravity: complex = -9.81j
    forces: tuple[Force, ...] = ()
    moments: tuple[Moment, ...] = ()
