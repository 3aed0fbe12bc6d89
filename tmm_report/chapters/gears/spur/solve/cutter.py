"""The pinion cutter of a pair: that which is stated, or a usual one for a ring, and what it leaves of the teeth."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmm_report.mechanics.gears.cutting import ByCutter, Cutter
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.records import dataclass

NOMINAL = (0.1, 0.08, 0.05, 0.038, 0.025)  # m: pitch diameters of GOST 9323, the largest that suits is usual
LARGE = (0.2, 0.16, 0.125)  # m: of modules over 8 mm
FEWEST = 10  # teeth of a cutter


@dataclass(frozen=True, eq=False)
class Cut:
    """Wheel `wheel` (0 or 1) cut by a pinion cutter: `pair` is the pair with it so cut."""

    wheel: int
    pair: Pair

    @property
    def by(self) -> ByCutter:
        cut = self.pair.cuts[self.wheel]
        assert isinstance(cut, ByCutter)
        return cut

    @property
    def free(self) -> bool:
        """Whether the cutter cuts the ring and takes nothing of it away that is needed."""
        found = self.pair.cutting[self.wheel]
        return found is not None and bool(found.trimming >= 0 and found.fouling >= 0 and found.radial >= 0)


def cutters_of(pair: Pair) -> tuple[Cut, ...]:
    """By the stated cutter every wheel that it cuts; where none is stated, a ring by a usual one, if one suits."""
    rings = [i for i in (0, 1) if pair.signs[i] < 0]
    if pair.cutter is not None:
        return tuple(Cut(i, pair) for i in rings or (0, 1))
    return tuple(cut for i in rings if (cut := _usual(pair, i)) is not None)


def _usual(pair: Pair, ring: int) -> Cut | None:
    """The ring cut by a new cutter without shift, of the largest nominal pitch diameter that takes nothing away."""
    for nominal in (*(LARGE if pair.m > 8e-3 else ()), *NOMINAL):
        z = round(nominal / float(pair.m))
        if FEWEST <= z < int((pair.z1, pair.z2)[ring]):
            with np.errstate(divide="ignore", invalid="ignore"):
                cut = Cut(ring, replace(pair, cutter=Cutter(z)))
                if cut.free:
                    return cut
    return None
