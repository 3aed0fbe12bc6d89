"""Chapter of ordinary stages of a drive, the shape of teeth left out: belts, chains, friction wheels, idlers.

Each kind by its closed formulas (steps/); what the drive asks of a stage is that of the `Run` of drive/stages.py.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

from tmm_report.chapters.gears.ordinary import values
from tmm_report.chapters.gears.ordinary.given import (
    BeltStage,
    BevelStage,
    ChainStage,
    FrictionStage,
    Given,
    PairStage,
    TrainStage,
    WormStage,
)
from tmm_report.chapters.gears.ordinary.steps import belt, bevel, chain, friction, pair, train, worm
from tmm_report.chapters.gears.ordinary.steps.train import ANGLE
from tmm_report.mechanics.gears import trains
from tmm_report.problems import Message, Problem
from tmm_report.records import dataclass

__all__ = ["Found", "Given", "solve"]


class Kind(NamedTuple):
    """`steps`: a module with what is found of a stage at rest (`geometry`), its `members` and `meshes`, and what is
    found at the speed of its driving wheel, rad/s, and the torque on it, N·m, or None (`work`)."""

    name: str
    sheet: type[values.Numbers]
    steps: Any


KINDS: dict[type, Kind] = {
    BeltStage: Kind("belt", values.Belt, belt),
    ChainStage: Kind("chain", values.Chain, chain),
    FrictionStage: Kind("friction", values.Friction, friction),
    TrainStage: Kind("train", values.Train, train),
    PairStage: Kind("pair", values.PairOfWheels, pair),
    BevelStage: Kind("bevel", values.Bevel, bevel),
    WormStage: Kind("worm", values.Worm, worm),
}


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`: the numbers `s`; those of its work are among them where `working` gave them."""

    given: Given
    s: values.Numbers

    fixed: tuple[str, ...] = ()  # members that stand still, and a second input: none in these stages
    second: None = None

    @property
    def kind(self) -> str:
        return KINDS[type(self.given)].name

    @property
    def name(self) -> str:
        return self.given.title

    @property
    def input(self) -> str:
        return self.given.wheels[0]

    @property
    def output(self) -> str:
        return self.given.wheels[-1]

    @property
    def wanted(self) -> float:
        """The ratio that the assignment asks for."""
        return self.ratio if self.given.ratio is None else self.given.ratio

    @property
    def ratio(self) -> float:
        """ω_in/ω_out, signed."""
        return self.s.number("u")

    @property
    def efficiency(self) -> float:
        return self.given.eta

    @property
    def members(self) -> tuple[trains.Member, ...]:
        found: tuple[trains.Member, ...] = KINDS[type(self.given)].steps.members(self.s, self.given)
        return found

    @property
    def meshes(self) -> tuple[trains.Mesh, ...]:
        found: tuple[trains.Mesh, ...] = KINDS[type(self.given)].steps.meshes(self.s, self.given)
        return found

    @property
    def angles(self) -> tuple[float | None, ...]:
        """Of every mesh the angle of pressure, rad; None of what has no teeth."""
        return (ANGLE if self.kind == "train" else None,) * len(self.meshes)

    @property
    def shares(self) -> int:
        return 1

    @property
    def sized(self) -> bool:
        return self.kind != "pair"

    @property
    def side(self) -> int:
        """Where the driven axis lies in the scheme, +1 above the driving one, -1 below."""
        return 1 if isinstance(self.given, WormStage) and self.given.worm == "below" else -1

    @property
    def locks(self) -> bool:
        """Of a worm, whether its wheel cannot drive it."""
        return isinstance(self.s, values.Worm) and worm.locks(self.s)

    @property
    def sound(self) -> bool:
        return True

    @property
    def doubts(self) -> tuple[Problem, ...]:
        return chain.doubts(self.given) if isinstance(self.given, ChainStage) else ()

    def summary(self) -> list[Message]:
        """What is wrong, a line each."""
        return []


def solve(given: Given) -> Found:
    """Raises ProblemError with every mistake and what would work."""
    kind = KINDS[type(given)]
    s = kind.sheet(given.wheels, given.label)
    kind.steps.geometry(s, given)
    return Found(given, s)


def working(found: Found, speed: float, torque: float | None) -> Found:
    """The stage with its driving wheel turning at `speed`, rad/s, under the torque on it, N·m, where that is known."""
    kind = KINDS[type(found.given)]
    s = kind.sheet(found.given.wheels, found.given.label)
    kind.steps.geometry(s, found.given)
    kind.steps.work(s, found.given, speed, torque)
    return replace(found, s=s)
