"""mechanism: `SpurGear(N, d, a, b, backlash)`, "custom tooth profile for spur gears"; shifts are not among its data."""

from __future__ import annotations

from typing import Any

from benchmarks.peers.gears.scene import POINTS, GearPair
from benchmarks.peers.peer import installed


def wheel(pair: GearPair) -> dict[str, Any]:
    from mechanism import SpurGear

    if pair.x1 or pair.x2:
        raise NotImplementedError("no profile shifts")
    gear = SpurGear(
        N=pair.z1,
        d=pair.m * pair.z1,
        a=pair.m,
        b=1.25 * pair.m,
        backlash=0,
        ignore_undercut=True,
        size=POINTS,
    )
    upright = gear.involute_points  # of a tooth on the +y axis
    return {"profile": -1j * upright, "thickness": gear.tooth_thickness}


SETTINGS = {"wheel": wheel}


def version() -> str | None:
    return installed("mechanism")
