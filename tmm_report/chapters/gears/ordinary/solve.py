"""Chapter of ordinary stages of a drive, without the shape of teeth: belts.

Each kind by its closed formulas (steps/); what the drive asks of a stage is that of the `Run` of drive/stages.py.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

from tmm_report.chapters.gears.ordinary import values
from tmm_report.chapters.gears.ordinary.given import BeltStage, Given
from tmm_report.chapters.gears.ordinary.steps import belt
from tmm_report.mechanics.gears import trains
from tmm_report.problems import Message, Problem
from tmm_report.records import dataclass

__all__ = ["Found", "Given", "solve"]


class Kind(NamedTuple):
    """`geometry`: what is found of a stage at rest; `work`: at the speed of its driving wheel, rad/s, and the torque on
    it, N·m, or None."""

    name: str
    sheet: type[values.Numbers]
    geometry: Callable[[Any, Any], None]
    work: Callable[[Any, Any, float, float | None], None]


KINDS: dict[type, Kind] = {
    BeltStage: Kind("belt", values.Belt, belt.geometry, belt.work),
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
        one, two = self.given.wheels
        n = self.s.number
        return (
            trains.Member(one, "wheel", radius=n("d1") / 2),
            trains.Member(two, "wheel", radius=n("d2") / 2, distance=n("a")),
        )

    @property
    def meshes(self) -> tuple[trains.Mesh, ...]:
        one, two = self.given.wheels
        same = self.given.sense > 0
        return (trains.Mesh(one, two, "", same, self.efficiency, size=abs(self.ratio), apart=True),)

    @property
    def angles(self) -> tuple[float | None, ...]:
        """Of every mesh the angle of pressure, rad; None of what has no teeth."""
        return (None,) * len(self.meshes)

    @property
    def shares(self) -> int:
        return 1

    @property
    def sound(self) -> bool:
        return True

    @property
    def doubts(self) -> tuple[Problem, ...]:
        return ()

    def summary(self) -> list[Message]:
        """What is wrong, a line each."""
        return []


def solve(given: Given) -> Found:
    """Raises ProblemError with every mistake and what would work."""
    kind = KINDS[type(given)]
    s = kind.sheet(given.wheels, given.label)
    kind.geometry(s, given)
    return Found(given, s)


def working(found: Found, speed: float, torque: float | None) -> Found:
    """The stage with its driving wheel turning at `speed`, rad/s, under the torque on it, N·m, where that is known."""
    kind = KINDS[type(found.given)]
    s = kind.sheet(found.given.wheels, found.given.label)
    kind.geometry(s, found.given)
    kind.work(s, found.given, speed, torque)
    return replace(found, s=s)
