"""A condition that a mechanism must meet, and what is in hand."""

from __future__ import annotations

from tmm_report.records import dataclass

EXACT = 1e-9  # relative: a margin of rounding is none


@dataclass(frozen=True)
class Condition:
    """A condition of sound wheels: `value` must be no less than `limit`, or no greater where not `least`.

    `key`: undercut, pointing, contact, interference, fouling, sliding …; `wheel`: its number, "" for the pair.
    `unit`: of print, "mm" or "deg"; the numbers are pure or in SI.
    """

    key: str
    wheel: str
    value: float
    limit: float
    unit: str = ""
    least: bool = True

    @property
    def margin(self) -> float:
        """What is in hand; negative where the condition fails."""
        return self.value - self.limit if self.least else self.limit - self.value

    @property
    def met(self) -> bool:
        return self.margin >= -EXACT * max(abs(self.limit), 1e-3)
