"""The least teeth of a ring without shift: by the rule of the course, and exactly beside its satellite."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.gears.planetary.solve.stage import Found
from tmm_report.mechanics.gears.pair_sizes import ring_rule
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol

LEAST_RING = Quantity(
    "z_least",
    Symbol("z", "min"),
    "",
    Message(N_("least teeth of a ring without shift that does not interfere with its satellite")),
)


def ring_values(found: Found, prefix: str) -> Iterator[Value]:
    if (rule := ring_rule(found.given.task.rack)) is not None:
        meaning = Message(N_("least teeth of a ring without shift by the rule of the course"))
        yield Quantity(f"{prefix}_ring_rule", None, "", meaning).value(rule)
