"""The pinion cutter of a pair: that which is stated, or a usual one for a ring, and what it leaves of the teeth."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.mechanics.gears.cutting import ByCutter, Cutter
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.solve.pair import Found

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


def columns_of(found: Found) -> Iterator[Column]:
    """A row for each wheel."""
    cuts, names = found.cutters, found.given.wheels
    of = [cut.by for cut in cuts]
    wheels = [cut.wheel for cut in cuts]
    pairs = [cut.pair for cut in cuts]
    yield text_column("wheel", Message(N_("number of the wheel")), [names[i] for i in wheels])
    rows = (
        ("z0", Symbol("z", "0"), "", N_("number of teeth of the pinion cutter"), [one.tool.z for one in of]),
        ("x0", Symbol("x", "0"), "", N_("shift coefficient of the pinion cutter"), [one.tool.x for one in of]),
        (
            "inv_alpha_w0", Symbol("inv α", "w0"), "",
            N_("involute function of the operating angle in cutting"), [np.tan(one.alpha) - one.alpha for one in of],
        ),
        (
            "alpha_w0", Symbol("alpha", "w0"), "deg",
            N_("operating angle in cutting"), [np.degrees(one.alpha) for one in of],
        ),
        (
            "a_w0", Symbol("a", "w0"), "m",
            N_("distance of the axes in cutting"), [abs(one.distance) for one in of],
        ),
        (
            "d_0", Symbol("d", "0"), "m", N_("pitch diameter of the pinion cutter"),
            [one.tool.z * one.m for one in of],
        ),
        ("d_a0", Symbol("d", "a0"), "m", N_("tip diameter of the pinion cutter"), [2 * one.tip for one in of]),
        ("d_b0", Symbol("d", "b0"), "m", N_("base diameter of the pinion cutter"), [2 * one.base for one in of]),
        (
            "d_f0", Symbol("d", "f"), "m",
            N_("root diameter as the pinion cutter leaves it"), [abs(one.root) for one in of],
        ),
        (
            "rho_l0", Symbol("rho", "l"), "m",
            N_("radius of curvature where the pinion cutter leaves the involute"), [abs(one.start) for one in of],
        ),
        (
            "clearance0", Symbol("c"), "m", N_("radial clearance at the root"),
            [float(pair.clearance[i]) for i, pair in zip(wheels, pairs, strict=True)],
        ),
    )  # fmt: skip
    for key, symbol, unit, meaning, numbers in rows:
        yield Quantity(key, symbol, unit, Message(meaning)).column([float(number) for number in numbers])
