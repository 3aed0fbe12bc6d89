"""Chapter of friction in single pairs: planes and wedges, screws, pivots, belts, wheels, journals.

Each pair by its closed formula (mechanics/pairs/friction.py). What locks, jams or slides is told with its reason.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from tmm_report.chapters.machine.contacts import steps, values
from tmm_report.chapters.machine.contacts.given import (
    Belt,
    BeltDrive,
    Contact,
    Crank,
    Given,
    Incline,
    Journal,
    Pivot,
    Screw,
    Sliders,
    Trial,
    Wedge,
    Wheel,
)
from tmm_report.chapters.machine.contacts.mistakes import mistakes
from tmm_report.problems import N_, Message, ProblemError
from tmm_report.quantity.sheet import Row
from tmm_report.quantity.text import Amount
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Found", "Given", "Solved", "solve"]

KINDS: dict[type, tuple[str, type[Row], Callable[[Any, Any], None]]] = {
    Incline: ("incline", values.Incline, steps.incline),
    Wedge: ("wedge", values.Wedge, steps.wedge),
    Sliders: ("sliders", values.Sliders, steps.sliders),
    Trial: ("trial", values.Trial, steps.trial),
    Screw: ("screw", values.Screw, steps.screw),
    Pivot: ("pivot", values.Pivot, steps.pivot),
    Belt: ("belt", values.Belt, steps.belt),
    BeltDrive: ("belt_drive", values.BeltDrive, steps.belt_drive),
    Wheel: ("wheel", values.Wheel, steps.wheel),
    Journal: ("journal", values.Journal, steps.journal),
    Crank: ("crank", values.Crank, steps.crank),
}


@dataclass(frozen=True, eq=False)
class Solved:
    """A pair, its number from 1, its kind, its numbers."""

    number: int
    kind: str
    of: Contact
    s: Row

    @property
    def locks(self) -> bool:
        """Whether the load alone cannot move it back, however great it is."""
        n = self.s.number
        match self.kind:
            case "incline":
                return n("alpha") <= n("phi")
            case "wedge":
                return n("alpha") <= n("alpha_lock")
            case "screw":
                return n("M_back" if "M_back" in self.s else "M_low") >= 0
            case _:
                return False

    @property
    def held(self) -> bool:
        """Of a screw, whether only its collar holds it: its thread alone would run back."""
        return self.locks and self.s.number("M_low") < 0

    @property
    def rolls(self) -> bool:
        """Of a wheel, whether it rolls without sliding: f > k/r."""
        return self.s.number("f") > self.s.number("f_roll")


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`, in the order of the file."""

    given: Given
    items: tuple[Solved, ...]

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        for item in self.items:
            if "eta" in item.s:
                said = {
                    "n": item.number,
                    "kind": item.of.name or Message(values.KINDS[item.kind]),
                    "eta": Amount(item.s.number("eta")),
                }
                yield Message(N_("friction in pair %(n)s (%(kind)s): efficiency %(eta)s"), said)


def solve(given: Given, moving: Moving | None) -> Found:
    """Raises ProblemError with every pair that jams or cannot be. A lever mechanism has no part in it."""
    wrong = [one for k, item in enumerate(given.items) for one in mistakes(item, ("contacts", k))]
    if wrong:
        raise ProblemError(wrong)
    return Found(given, tuple(_solved(k, item) for k, item in enumerate(given.items, 1)))


def _solved(number: int, of: Contact) -> Solved:
    kind, sheet, step = KINDS[type(of)]
    s = sheet(f"contacts_{number}", 0)
    step(s, of)
    return Solved(number, kind, of, s)
