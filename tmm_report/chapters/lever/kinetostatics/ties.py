"""Springs and viscous dampers between two points as the variant states them, and the forces of their ends; SI."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import KW_ONLY, field
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from tmm_report.chapters.lever.kinetostatics.given import Force, Moment, Towards
from tmm_report.mechanics.calculus.laws import ByLength, ByRate, ByTurn, Law
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        Angle,
        Distance,
        ForceValue,
        MomentValue,
        Name,
        Position,
        Positive,
        quantity,
    )

_BETWEEN = "its two points: of moving links, or one of them fixed"
_ON = (
    "point -> the link that takes the force there, where several share it; left out, the frame, a slider, else the "
    "first of them"
)
_PRELOAD = (
    "in place of free_length: the force at position 0, or where at_length or at_position says; above zero it draws the "
    "points together, below zero it presses them apart"
)
LINEAR = N_("springs and dampers are linear: c (l − l0) and b dl/dt")


@dataclass(frozen=True)
class Tie:
    """What acts along the line of two points with a force on each, one against the other."""

    LETTER: ClassVar = ""  # of its coefficient, by which it is called

    _: KW_ONLY
    name: Annotated[
        CalledBy | None,
        Field(description="for the tables; left out, c1, c2, … or b1, b2, …", examples=["return spring"]),
    ] = None
    between: Annotated[tuple[Name, Name], Field(description=_BETWEEN, examples=["[B, K]"])]
    on: Annotated[dict[Name, Name], Field(description=_ON, examples=["{B: 3}"])] = field(default_factory=dict)

    @property
    def law(self) -> Law:
        """Its force, above zero where it draws the points together."""
        raise NotImplementedError


@dataclass(frozen=True)
class Spring(Tie):
    """A linear spring between two points: c (l − l0) along their line."""

    LETTER: ClassVar = "c"
    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("by_length", "by_displacement"), LINEAR),
        "length": N_("the length without force is free_length, that under a preload at_length"),
    }

    _: KW_ONLY
    stiffness: Annotated[float, quantity("stiffness", 1e-9)]
    free_length: Annotated[Distance | None, Field(description="without any force")] = None
    preload: Annotated[ForceValue | None, Field(description=_PRELOAD, examples=["150 N"])] = None
    at_length: Annotated[Positive | None, Field(description="length under the preload")] = None
    at_position: Annotated[Position | None, Field(description="position of the table under the preload")] = (
        None
    )

    def __post_init__(self) -> None:
        if (self.free_length is None) == (self.preload is None):
            both = N_("a spring has a free length or a preload, not both")
            neither = N_("a spring needs its free length or a preload")
            right = Message(
                N_("either free_length: 240 mm or preload: 150 N, which is the force at position 0")
            )
            raise WrongValue(Message(neither if self.preload is None else both), right)
        places = sum(one is not None for one in (self.at_length, self.at_position))
        if places > (self.preload is not None):
            wrong = Message(
                N_("at_length and at_position say where a spring has its preload, one of them is enough")
            )
            raise WrongValue(wrong, Message(N_("one of them, as in {preload: 150 N, at_length: 260 mm}")))

    @property
    def free(self) -> float | None:
        """Length without any force, m; None where the motion must be known for it: a preload at a position."""
        if self.free_length is not None:
            return self.free_length
        return None if self.at_length is None else self.free_of(self.at_length)

    def free_of(self, length: Any) -> Any:
        """l₀ = l − P/c: free length of a spring that is so long under its preload, m."""
        return length - (self.preload or 0.0) / self.stiffness

    @property
    def law(self) -> Law:
        """Its free length is nan where the motion tells it."""
        return ByLength(self.stiffness, math.nan if self.free is None else self.free)


@dataclass(frozen=True)
class Damper(Tie):
    """A viscous damper between two points: b dl/dt along their line."""

    LETTER: ClassVar = "b"
    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("by_speed", "by_velocity", "stiffness"), LINEAR),
        "electromagnetic": N_(
            "an electromagnetic damper is a viscous one: viscosity, its force by the velocity"
        ),
    }

    _: KW_ONLY
    viscosity: Annotated[float, quantity("damping", 1e-9)]

    @property
    def law(self) -> Law:
        return ByRate(self.viscosity)


@dataclass(frozen=True)
class End(Force):
    """The force of a spring or damper on one of its points; `of`: how the tie is called, c1, b2, ….

    `stated` along its direction is the force of the tie itself: above zero where it draws the points together."""

    _: KW_ONLY
    direction: Any = None
    tie: Tie
    of: str

    def __post_init__(self) -> None:
        """Its magnitude is stated by the tie."""

    @property
    def law(self) -> Law:  # type: ignore[override]
        return self.tie.law

    @property
    def way(self) -> Towards:
        one, other = self.tie.between
        return Towards(other if self.at == one else one)


def ends(ties: Sequence[Tie], fixed: Sequence[str]) -> Iterator[End]:
    """The forces of ties on moving links, in their order; `fixed`: points of the frame, which takes its own itself but
    where a link is said to take it."""
    for k, tie in enumerate(ties, 1):
        for point in tie.between:
            if point not in fixed or point in tie.on:
                yield End(name=tie.name, at=point, on=tie.on.get(point), tie=tie, of=f"{tie.LETTER}{k}")


def apart(forces: Sequence[Force]) -> tuple[list[Force], list[list[int]]]:
    """The forces that are stated by themselves, and of every tie in its order the numbers of its ends among all."""
    tied: dict[str, list[int]] = {}
    for k, force in enumerate(forces):
        if isinstance(force, End):
            tied.setdefault(force.of, []).append(k)
    return [force for force in forces if not isinstance(force, End)], list(tied.values())


def together(forces: Sequence[Force]) -> list[list[int]]:
    """Numbers of the forces whose powers are told as one: each by itself, both ends of a tie together."""
    own, tied = apart(forces)
    return [*([k] for k in range(len(own))), *tied]


@dataclass(frozen=True)
class Between:
    """A spring or damper for who draws it: its `letter` and number, its two points, the moving links that take its
    force."""

    letter: str
    number: int
    points: tuple[str, str]
    links: tuple[str, ...]


@dataclass(frozen=True)
class TorsionSpring:
    """A linear torsion spring between two links, or a link and the frame: c (α₀ − φ), φ turned from position 0."""

    LETTER: ClassVar = "k"
    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        "between": N_("a torsion spring turns links against one another: links: [3, 0]"),
        "at_position": N_("the preload of a torsion spring is that at position 0"),
    }

    _: KW_ONLY
    name: Annotated[
        CalledBy | None, Field(description="for the tables; left out, k1, k2, …", examples=["torsion bar"])
    ] = None
    links: Annotated[
        tuple[Name, Name],
        Field(
            description="the link that takes its moment, and the one that takes the opposite",
            examples=["[3, 0]"],
        ),
    ]
    stiffness: Annotated[float, quantity("torsional stiffness", 1e-9)]
    preload: Annotated[
        MomentValue | None,
        Field(description="its moment on the first link at position 0, above zero counter-clockwise"),
    ] = None
    free_angle: Annotated[
        Angle | None,
        Field(
            description="in place of preload: where the first link, turned so far from position 0, has no moment"
        ),
    ] = None

    def __post_init__(self) -> None:
        if (self.preload is None) == (self.free_angle is None):
            both = N_("a torsion spring has a free angle or a preload, not both")
            neither = N_("a torsion spring needs its preload or its free angle")
            right = Message(N_("either preload: 5 N*m, its moment at position 0, or free_angle: 20 deg"))
            raise WrongValue(Message(neither if self.preload is None else both), right)

    @property
    def free(self) -> float:
        """α₀ = M₀/c: angle from position 0 at which it has no moment, rad."""
        return (self.preload or 0.0) / self.stiffness if self.free_angle is None else self.free_angle


@dataclass(frozen=True)
class Twist(Moment):
    """The moment of a torsion spring on one of its links, `other` is the other one; `of`: how it is called, k1."""

    _: KW_ONLY
    direction: Any = 1
    tie: TorsionSpring
    of: str
    other: str

    def __post_init__(self) -> None:
        """Its magnitude is stated by the spring."""

    @property
    def first(self) -> bool:
        """Whether its link is the first of the spring's."""
        return self.on == self.tie.links[0]

    @property
    def law(self) -> ByTurn:  # type: ignore[override]
        return ByTurn(self.tie.stiffness, self.tie.free if self.first else -self.tie.free)


def twists(springs: Sequence[TorsionSpring], frame: str) -> Iterator[Twist]:
    """The moments of torsion springs on moving links, in their order."""
    for k, tie in enumerate(springs, 1):
        of = f"{tie.LETTER}{k}"
        for on, other in (tie.links, tie.links[::-1]):
            if on != frame:
                yield Twist(name=tie.name or of, on=on, tie=tie, of=of, other=other)
