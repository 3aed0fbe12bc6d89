"""This program: the flank of a wheel as cut, the pair in mesh."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.peers.gears.scene import POINTS, GearPair
from benchmarks.peers.peer import installed
from tmm_report.mechanics.gears import tooth_outlines
from tmm_report.mechanics.gears.meshing import meshed
from tmm_report.mechanics.gears.rack import Rack

RACK = Rack()


def wheel(pair: GearPair) -> dict[str, Any]:
    """The flank of wheel 1 and its thickness."""
    cut = tooth_outlines.flank(pair.z1, pair.m, pair.x1, RACK)
    half = tooth_outlines.base_half_angle(pair.z1, pair.x1, RACK.alpha)
    rise = np.linspace(cut.rise, np.sqrt((cut.top / cut.base) ** 2 - 1), POINTS)
    return {"profile": tooth_outlines.involute(cut.base, half, rise), "thickness": _meshed(pair).s[0]}


def both(pair: GearPair) -> dict[str, Any]:
    found = _meshed(pair)
    return wheel(pair) | {"distance": float(found.a_w), "contact ratio": float(found.eps)}


def _meshed(pair: GearPair) -> Any:
    return meshed(pair.z1, pair.z2, pair.m, RACK, 0.0, pair.x1, pair.x2, shortened=False)


SETTINGS = {"pair": both, "wheel": wheel}


def version() -> str | None:
    return installed("tmm-report")
