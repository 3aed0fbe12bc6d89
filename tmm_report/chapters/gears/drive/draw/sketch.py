"""The conventional signs (GOST 2.770) of which the kinematic scheme of a drive is made, mm of paper."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field

from tmm_report.chapters.gears.drive.plans import Plans
from tmm_report.figures.drawing import NORMAL, THICK, Item, Moves, Moving, Tag, line
from tmm_report.figures.lettering import symbol
from tmm_report.figures.schemes.marks import MARK, going_round, ground, turning
from tmm_report.mechanics.gears.trains import Member
from tmm_report.records import dataclass

RIM = 3.0  # half the length of a rim
CLEAR = 0.45  # of a rim from its pitch line: two rims in mesh stand apart by twice as much
DISC = 11.0  # from a row to the web of a turning ring
SIDE = 2.0  # free space beside a stage
CROSS = 0.9


@dataclass
class Sketch:
    """What is drawn so far; `x`: how far along the shafts the drawing has come."""

    plans: Plans
    speed: Mapping[str, float]
    items: list[Item] = field(default_factory=list)
    tags: list[Tag] = field(default_factory=list)
    marks: list[Moving] = field(default_factory=list)  # for the screen: one of every member is in sight
    x: float = 0.0

    @property
    def moves(self) -> Moves | None:
        return Moves(tuple(self.marks), ()) if self.marks else None

    def y(self, member: Member) -> float:
        """The height of a member's axis."""
        return self.plans.axes[member.name] / self.plans.length_scale

    def radius(self, member: Member) -> float:
        return member.radius / self.plans.length_scale

    def shaft(self, start: float, end: float, y: float) -> None:
        if abs(end - start) > 1e-6:
            self.items.append(line(complex(start, y), complex(end, y), THICK))

    def cross(self, x: float, y: float) -> None:
        """A wheel that sits fast on its shaft."""
        for arm in (CROSS * (1 + 1j), CROSS * (1 - 1j)):
            self.items.append(line(complex(x, y) - arm, complex(x, y) + arm, NORMAL))

    def rim(self, x: float, y: float, reach: float = RIM) -> None:
        self.items.append(line(complex(x - reach, y), complex(x + reach, y), THICK))

    def mark(self, x: float, y: float, half: float, name: str, reach: float = RIM, side: int = 0) -> None:
        """Marks of what turns about y; `side`: of what is drawn on one side of its axis alone, ±1."""
        along = line(complex(x - reach, y), complex(x + reach, y), MARK)
        self.marks += going_round(along, half, name, side)

    def web(self, x: float, start: float, end: float) -> None:
        self.items.append(line(complex(x, start), complex(x, end), NORMAL))

    def name(self, text: str, at: complex, prefer: complex) -> None:
        self.tags.append(Tag((symbol(text),), (at,), prefer=prefer))

    def bearing(self, x: float, y: float) -> None:
        """A shaft's bearing in the frame."""
        for side in (1j, -1j):
            start, end = complex(x - 2.5, y) + 1.1 * side, complex(x + 2.5, y) + 1.1 * side
            self.items += ground(start, end, side)

    def turns(self, x: float, y: float, name: str) -> None:
        """The arrow of rotation about a shaft with the symbol of its speed."""
        omega = self.speed[name]
        if omega:
            sweep = math.copysign(math.radians(200), omega)
            start = math.radians(-100) if omega > 0 else math.radians(100)
            self.items += turning(complex(x, y), 3.2, start, sweep)
        self.tags.append(Tag((symbol(f"ω_{name}"),), (complex(x + 2, y + 3.5),), prefer=1 + 1j))
