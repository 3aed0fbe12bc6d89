"""Chapter of the speed governor: centrifugal by itself, in a loop with its machine, with a servomotor; a brake."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmm_report.chapters.machine.governor.given import Given
from tmm_report.chapters.machine.governor.solve import brake
from tmm_report.chapters.machine.governor.solve import by_itself as direct
from tmm_report.chapters.machine.governor.solve import in_loop as loop
from tmm_report.chapters.machine.governor.solve.brake import BrakeFound
from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.chapters.machine.governor.solve.in_loop import LoopFound
from tmm_report.problems import N_, Message
from tmm_report.quantity.text import amounts
from tmm_report.quantity.units import factor
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Found", "Given", "solve"]


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`; None of what is not asked for."""

    given: Given
    direct: DirectFound | None
    loop: LoopFound | None
    brake: BrakeFound | None

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        if self.direct is not None:
            yield _of_direct(self.direct)
            if self.direct.word in FALLS:
                yield Message(FALLS[self.direct.word])
        if self.loop is not None:
            said = N_("governor with its machine: stable"), N_("governor with its machine: unstable")
            yield Message(said[not self.loop.stable])
        if self.brake is not None:
            text = N_("centrifugal brake: contact at %(contact)s rpm, held speed %(held)s rpm")
            speeds = {key: self.brake.s[key].number("rpm") for key in ("contact", "held")}
            yield Message(text, amounts(speeds))


FALLS = {
    "unstable": N_("the governor is unstable: its speed falls as the sleeve rises"),
    "partly": N_(
        "the governor is unstable over a part of its lift: there its speed falls as the sleeve rises"
    ),
    "flat": N_("the governor is flat: one speed holds the sleeve at every lift"),
}


def _of_direct(found: DirectFound) -> Message:
    text = N_("centrifugal governor: %(low)s … %(high)s rpm, non-uniformity %(delta)s")
    low, high = (omega * factor("rad/s", "rpm") for omega in found.ends)
    return Message(text, amounts({"low": low, "high": high, "delta": found.s.number("delta")}))


def solve(given: Given, moving: Moving | None) -> Found:
    """`moving`: the solved lever mechanism, which a governor does not need. Raises ProblemError."""
    governor = direct.solve(given) if given.centrifugal else None
    servo = given.servo.in_loop if given.servo else None
    machine = loop.solve(given.machine, servo, governor) if given.machine and governor else None
    return Found(given, governor, machine, brake.solve(given.brake) if given.brake else None)
