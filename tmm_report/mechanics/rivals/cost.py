"""What a method costs, by a table: the same on every machine, so that a choice by it is the same everywhere.

Measured once by `python -m benchmarks.speed.costs`, which makes the table anew; the microseconds are those of one
machine, only their ratios count. The table is also the list of the methods' names, known without loading them.
"""

from __future__ import annotations

from typing import NamedTuple


class Cost(NamedTuple):
    """µs: of a call, of each moving link, and of each moving link at each position."""

    call: float
    link: float
    position: float

    def of(self, links: int, count: int) -> float:
        """µs for `count` equal steps of the cycle."""
        return self.call + links * (self.link + self.position * (count + 1))


CLOSED = "groups"  # the program's own way
MOTION: dict[str, Cost] = {
    "groups": Cost(1.1, 18.0, 0.046),
    "newton": Cost(2500.0, 40.0, 50.0),
    "root_finder": Cost(2600.0, 0.0, 100.0),
    "constraints": Cost(0.0, 0.0, 290.0),
    "constraints_corrected": Cost(0.0, 0.0, 500.0),
    "constraints_dop853": Cost(31000.0, 0.0, 6.3),
    "drawing_0.01": Cost(840.0, 190.0, 1.0),
    "drawing_0.1": Cost(1100.0, 190.0, 1.3),
    "drawing_0.5": Cost(750.0, 270.0, 1.2),
    "differences": Cost(140.0, 15.0, 0.11),
    "spline": Cost(350.0, 0.0, 0.097),
    "fourier": Cost(140.0, 29.0, 0.069),
    "parallelogram": Cost(2.7, 13.0, 0.026),
}
# of mechanisms with a group above class II, which is followed round by its sheet and not solved in closed form
FOLLOWED: dict[str, Cost] = {
    "groups": Cost(26.0, 130.0, 0.53),
    "newton": Cost(140.0, 710.0, 59.0),
    "root_finder": Cost(130.0, 640.0, 150.0),
    "constraints": Cost(0.0, 0.0, 400.0),
    "constraints_corrected": Cost(0.0, 0.0, 590.0),
    "constraints_dop853": Cost(1400.0, 6900.0, 3.5),
    "drawing_0.01": Cost(96.0, 480.0, 2.8),
    "drawing_0.1": Cost(120.0, 620.0, 2.6),
    "drawing_0.5": Cost(130.0, 640.0, 1.1),
    "differences": Cost(22.0, 110.0, 0.38),
    "spline": Cost(26.0, 130.0, 0.38),
    "fourier": Cost(23.0, 120.0, 0.37),
    "parallelogram": Cost(3.2, 16.0, 0.026),
}
FORCES: dict[str, Cost] = {
    "groups": Cost(36.0, 68.0, 0.17),
    "system": Cost(0.0, 130.0, 0.47),
    "virtual_work": Cost(51.0, 47.0, 0.095),
    "drawing_0.01": Cost(0.0, 250.0, 0.16),
    "drawing_0.1": Cost(140.0, 240.0, 0.33),
    "drawing_0.5": Cost(0.0, 260.0, 0.25),
}
NAMES = tuple(MOTION)  # by which a variant names the method of the motion
