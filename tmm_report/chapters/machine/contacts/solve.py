"""Chapter of friction in single pairs: planes and wedges, screws, pivots, belts, wheels, journals.

Each pair by its closed formula (mechanics/pairs/friction.py). What locks, jams or slides is told with its reason.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from tmm_report.chapters.machine.contacts import planes, turning
from tmm_report.chapters.machine.contacts.given import (
    Belt,
    BeltDrive,
    Contact,
    Crank,
    Given,
    Incline,
    Journal,
    Named,
    Pivot,
    Screw,
    Sliders,
    Trial,
    Wedge,
    Wheel,
)
from tmm_report.chapters.machine.contacts.mistakes import mistakes
from tmm_report.chapters.machine.contacts.terms import KINDS as KIND_NAMES
from tmm_report.problems import N_, Message, ProblemError
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Found", "Given", "Solved", "solve"]

KINDS: dict[type, tuple[str, Callable[[Any], dict[str, float]]]] = {
    Incline: ("incline", planes.incline),
    Wedge: ("wedge", planes.wedge),
    Sliders: ("sliders", planes.sliders),
    Trial: ("trial", planes.trial),
    Screw: ("screw", planes.screw),
    Pivot: ("pivot", turning.pivot),
    Belt: ("belt", turning.belt),
    BeltDrive: ("belt_drive", turning.belt_drive),
    Wheel: ("wheel", turning.wheel),
    Journal: ("journal", turning.journal),
    Crank: ("crank", turning.crank),
}


@dataclass(frozen=True, eq=False)
class Solved:
    """A pair, its number from 1, its kind, its numbers by key: angles in degrees (of belts in radians), the rest SI."""

    number: int
    kind: str
    of: Contact
    name: str
    numbers: Mapping[str, float]

    @property
    def locks(self) -> bool:
        """Whether the load alone cannot move it back, however great it is."""
        n = self.numbers
        match self.kind:
            case "incline":
                return n["alpha"] <= n["phi"]
            case "wedge":
                return n["alpha"] <= n["alpha_lock"]
            case "screw":
                return n.get("M_back", n["M_low"]) >= 0
            case _:
                return False

    @property
    def held(self) -> bool:
        """Of a screw, whether only its collar holds it: its thread alone would run back."""
        return self.locks and self.numbers["M_low"] < 0

    @property
    def rolls(self) -> bool:
        """Of a wheel, whether it rolls without sliding: f > k/r."""
        return self.numbers["f"] > self.numbers["f_roll"]


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`, in the order of the file."""

    given: Given
    items: tuple[Solved, ...]

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        for item in self.items:
            if "eta" in item.numbers:
                values = {
                    "n": item.number,
                    "kind": item.name or Message(KIND_NAMES[item.kind]),
                    "eta": f"{item.numbers['eta']:.4f}",
                }
                yield Message(N_("friction in pair %(n)s (%(kind)s): efficiency %(eta)s"), values)


def solve(given: Given, moving: Moving | None) -> Found:
    """Raises ProblemError with every pair that jams or cannot be. A lever mechanism has no part in it."""
    wrong = [one for k, item in enumerate(given.items) for one in mistakes(item.of, ("contacts", k))]
    if wrong:
        raise ProblemError(wrong)
    return Found(given, tuple(_solved(k, item) for k, item in enumerate(given.items, 1)))


def _solved(number: int, item: Named) -> Solved:
    kind, numbers = KINDS[type(item.of)]
    found = {key: float(value) for key, value in numbers(item.of).items()}
    return Solved(number, kind, item.of, item.name, found)
