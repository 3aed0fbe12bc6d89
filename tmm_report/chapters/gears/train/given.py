"""What a compound gear train states; SI."""

from __future__ import annotations

import re
from dataclasses import field
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple

from tmm_report.problems import N_, Message, shown
from tmm_report.quantity import units
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        Distance,
        Efficiency,
        ForceValue,
        Module,
        Name,
        PositiveVelocity,
        Reads,
        SignedSpeed,
        Span,
        quantity,
        whole,
    )

MOST = 30  # wheels, meshes
LEAST_TEETH, MOST_TEETH = 6, 1000
KINDS = ("external", "internal", "bevel")
RUSSIAN = {
    "внешнее": "external",
    "внутреннее": "internal",
    "коническое": "bevel",
    "туда же": "same",
    "навстречу": "opposite",
}
_MESH = re.compile(r"\s*([^\s\-–—]{1,12})\s*[-–—]\s*([^\s\-–—]{1,12})\s*(.*)")


class Teeth(NamedTuple):
    """Of a wheel: stated where both are equal, else to be found between them."""

    low: int
    high: int

    @property
    def stated(self) -> bool:
        return self.low == self.high


class Pair(NamedTuple):
    """A stated mesh. `sense`: of a bevel pair, +1 where both wheels turn alike seen along their own axes, None: the
    usual one."""

    i: str
    j: str
    kind: str = "external"
    sense: int | None = None

    @property
    def name(self) -> str:
        return f"{self.i}-{self.j}"


def teeth(value: Any) -> Teeth:
    """40, or [20, 60] of a wheel that is sought."""
    pair = value if isinstance(value, list | tuple) else [value, value]
    if len(pair) == 2:
        low, high = (units.parse(one, "number") for one in pair)
        if low == int(low) and high == int(high) and LEAST_TEETH <= low <= high <= MOST_TEETH:
            return Teeth(int(low), int(high))
    text = N_("%(value)s is no number of teeth: from %(low)s to %(high)s")
    wrong = Message(text, {"value": shown(str(value)), "low": LEAST_TEETH, "high": MOST_TEETH})
    raise WrongValue(wrong, Message(N_("40, or [20, 60] where the teeth are sought")))


def mesh(value: Any) -> Pair:
    """1-2, 2-3 internal, 3-4 bevel, 3-4 bevel same."""
    if isinstance(value, str) and len(value) <= 60 and (match := _MESH.fullmatch(value)):
        words = match[3].strip()
        for russian, english in RUSSIAN.items():
            words = words.replace(russian, english)
        kind, _, sense = words.partition(" ")
        senses = {"": None, "same": 1, "opposite": -1}
        if (kind or "external") in KINDS and sense in senses and (kind == "bevel" or not sense):
            return Pair(match[1], match[2], kind or "external", senses[sense])
    wrong = Message(N_("%(value)s is no mesh of two wheels"), {"value": shown(str(value))})
    raise WrongValue(
        wrong, Message(N_("1-2 for an external mesh, 2-3 internal with the ring second, 4-5 bevel"))
    )


def names(value: Any) -> tuple[str, ...]:
    """A name, or a list of several."""
    several = value if isinstance(value, list | tuple) else [value]
    found = [str(one) for one in several if isinstance(one, str | int) and not isinstance(one, bool)]
    if 0 < len(found) == len(several) <= MOST and all(re.fullmatch(r"[\w'’]{1,12}", one) for one in found):
        return tuple(found)
    wrong = Message(N_("%(value)s names no members"), {"value": shown(str(value))})
    raise WrongValue(wrong, Message(N_("the name of a wheel or of a carrier, or a list of them: [3, H]")))


def counts(value: Any) -> tuple[int, ...]:
    """3, or [3, 4, 5] of which the search may choose."""
    several = value if isinstance(value, list | tuple) else [value]
    found = [units.parse(one, "number") for one in several]
    if 0 < len(found) <= 12 and all(one == int(one) and 1 <= one <= 12 for one in found):
        return tuple(sorted({int(one) for one in found}))
    wrong = Message(N_("%(value)s is no number of planet gears: from 1 to 12"), {"value": shown(str(value))})
    raise WrongValue(wrong, Message(N_("3, or [3, 4, 5] for the search")))


TEETH = {
    "type": ["integer", "array", "string"],
    "description": "teeth, or least and most of them",
    "examples": [40],
}
MESH = {"type": "string", "maxLength": 60, "examples": ["1-2", "2-3 internal"]}
NAMES = {
    "type": ["string", "integer", "array"],
    "description": "a member, or a list of them",
    "examples": ["H"],
}
COUNTS = {"type": ["integer", "array"], "description": "a number, or a list of them", "examples": [3]}


@dataclass(frozen=True)
class Losses:
    """Efficiency of each mesh with its carrier stopped, by the kind of the mesh or of one alone."""

    external: Annotated[Efficiency, Field(examples=[0.98])] = 1.0
    internal: Annotated[Efficiency, Field(examples=[0.99])] = 1.0
    bevel: Annotated[Efficiency, Field(examples=[0.97])] = 1.0
    meshes: Annotated[
        dict[str, Efficiency],
        Field(max_length=MOST, description="of single meshes, for example 1-2", examples=["{1-2: 0.98}"]),
    ] = field(default_factory=dict)


@dataclass(frozen=True)
class Road:
    """A car on a curve, by which both outputs turn: the first wheel is the outer one."""

    speed: Annotated[PositiveVelocity, Field(description="of the car", examples=["36 km/h"])]
    wheel: Annotated[Span, Field(description="diameter of the wheels", examples=["640 mm"])]
    track: Annotated[Distance, Field(description="between the wheels of the axle", examples=["1450 mm"])] = (
        0.0
    )
    radius: Annotated[
        Annotated[float, quantity("length", 0.1)] | None,
        Field(description="of the curve to the middle of the axle; left out, straight on", examples=["18 m"]),
    ] = None


@dataclass(frozen=True)
class Rope:
    """What the drum on the output winds."""

    drum: Annotated[Span, Field(description="diameter of the drum", examples=["400 mm"])]
    force: Annotated[ForceValue, Field(description="in the rope", examples=["9 kN"])]


@dataclass(frozen=True)
class Wanted:
    """What the sought teeth are to give."""

    ratio: Annotated[
        Annotated[float, quantity("number")],
        Field(description="speed of the input to that of the output, − where their senses differ"),
    ]
    tolerance: Annotated[
        Annotated[float, quantity("number", 1e-6, 0.5, "0.0001 … 50 %")], Field(description="of the ratio")
    ] = 0.04
    shifted: Annotated[
        Annotated[int, whole(0, 3)],
        Field(description="by how many teeth profile shift may open a mesh to the common centre distance"),
    ] = 0

    def __post_init__(self) -> None:
        if not self.ratio:
            raise WrongValue(Message(N_("a ratio of 0 has no train")), Message(N_("for example, −60")))


@dataclass(frozen=True, eq=False)
class GearTrain:
    """A gear train of any scheme: wheels, the meshes between them, carriers with their planet gears."""

    name: Annotated[CalledBy | None, Field(description="in the heading")] = field(default=None, kw_only=True)
    wheels: Annotated[
        dict[Name, Annotated[Teeth, Reads(teeth, TEETH)]],
        Field(
            min_length=2, max_length=MOST,
            description="teeth by the names of the wheels; wheels that differ by primes are one shaft: 3 and 3'",
        ),
    ]  # fmt: skip
    meshes: Annotated[
        list[Annotated[Pair, Reads(mesh, MESH, names=True)]],
        Field(min_length=1, max_length=MOST, description="1-2, 2-3 internal (the ring second), 4-5 bevel"),
    ]
    input: Annotated[tuple[str, ...], Reads(names, NAMES, names=True)]
    output: Annotated[tuple[str, ...], Reads(names, NAMES, names=True)]
    carriers: Annotated[
        dict[Name, Annotated[tuple[str, ...], Reads(names, NAMES, names=True)]],
        Field(max_length=6, description="of each carrier the wheels whose axes it carries"),
    ] = field(default_factory=dict)
    joined: Annotated[
        list[Annotated[tuple[str, ...], Reads(names, NAMES, names=True)]],
        Field(max_length=MOST, description="members that turn as one, besides those that differ by primes"),
    ] = field(default_factory=list)
    fixed: Annotated[tuple[str, ...], Reads(names, NAMES, names=True)] = ()
    speed: Annotated[SignedSpeed | None, Field(description="of the first input", examples=["1440 rpm"])] = (
        None
    )
    speeds: Annotated[
        dict[Name, SignedSpeed],
        Field(
            max_length=MOST, description="of other members whose speed is known: the second input, the output"
        ),
    ] = field(default_factory=dict)
    torque: Annotated[
        Annotated[float, quantity("moment", 1e-12)] | None, Field(description="on the first input")
    ] = None
    power: Annotated[
        Annotated[float, quantity("power", 1e-9)] | None, Field(description="of the first input")
    ] = None
    output_torque: Annotated[
        Annotated[float, quantity("moment", 1e-12)] | None,
        Field(description="that the first output overcomes"),
    ] = None
    output_power: Annotated[
        Annotated[float, quantity("power", 1e-9)] | None, Field(description="of the first output")
    ] = None
    rope: Annotated[Rope | None, Field(description="wound by the drum on the output")] = None
    efficiency: Annotated[
        Losses | None, Field(description="of the meshes; left out, there are no losses")
    ] = None
    locking: Annotated[
        Annotated[float, quantity("number", 1.0, 20.0, "1 … 20")] | None,
        Field(
            description="torque of the slower output to that of the faster one, for its share without friction"
        ),
    ] = None
    road: Annotated[Road | None, Field(description="how the two outputs turn as wheels of a car")] = None
    cases: Annotated[
        list[dict[Name, SignedSpeed]],
        Field(max_length=12, description="other motions by their known speeds: {1: 900 rpm, 5: 0 rpm}"),
    ] = field(default_factory=list)
    module: Annotated[Module | None, Field(description="of all the wheels")] = None
    modules: Annotated[dict[Name, Module], Field(max_length=MOST, description="of single wheels")] = field(
        default_factory=dict
    )
    satellites: Annotated[tuple[int, ...], Reads(counts, COUNTS)] = ()
    find: Annotated[Wanted | None, Field(description="the ratio for which the teeth are sought")] = None

    @property
    def sought(self) -> bool:
        """Whether some teeth are to be found."""
        return any(not one.stated for one in self.wheels.values())


Given = GearTrain
Load = Literal["torque", "power", "output_torque", "output_power", "rope"]
LOADS: tuple[Load, ...] = ("torque", "power", "output_torque", "output_power", "rope")
