"""FreeCAD's own gear (PartDesign's fcgear, `CreateExternalGear`): flanks as Bézier curves near the involute.

It needs no FreeCAD to run, for what builds the wire is handed to it: here a builder that keeps the curves of the first
tooth. Found in the folder that Debian's freecad-common has it in, or in that of PEERS_FREECAD (…/Mod/PartDesign).
"""

from __future__ import annotations

import gzip
import os
import sys
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.peers.gears.scene import POINTS, GearPair

FOLDER = Path(os.environ.get("PEERS_FREECAD", "/usr/share/freecad/Mod/PartDesign"))


def wheel(pair: GearPair) -> dict[str, Any]:
    """Flank of wheel 1, points spread evenly over the parameters of its two curves."""
    if str(FOLDER) not in sys.path:
        sys.path.append(str(FOLDER))
    from fcgear import involute

    if pair.x1 or pair.x2:
        raise NotImplementedError("no profile shifts")
    wire = _FirstFlank()
    involute.CreateExternalGear(wire, pair.m, pair.z1, 20.0)
    t = np.linspace(0.0, 1.0, POINTS // 2)
    return {"profile": np.concatenate([_bezier(curve, t) for curve in wire.curves])}


class _FirstFlank:
    """Builder of a wire as `CreateExternalGear` asks for: it draws from where the last piece ended."""

    def __init__(self) -> None:
        self.theta, self.at = 0.0, (0.0, 0.0)
        self.curves: list[list[complex]] = []

    def move(self, point: Any) -> None:
        self.at = point

    line = move

    def arc(self, point: Any, radius: float, sweep: int) -> None:
        self.at = point

    def curve(self, *points: Any) -> None:
        if len(self.curves) < 2:
            self.curves.append([complex(*point) for point in (self.at, *points)])
        self.at = points[-1]

    def close(self) -> None:
        """The wire is of no use here."""


def _bezier(points: list[complex], t: np.ndarray) -> np.ndarray:
    """De Casteljau's scheme."""
    level = [np.full(t.shape, point) for point in points]
    while len(level) > 1:
        level = [(1 - t) * one + t * other for one, other in pairwise(level)]
    return level[0]


def version() -> str | None:
    """Of the Debian package whose folder it is."""
    if not (FOLDER / "fcgear" / "involute.py").exists():
        return None
    log = FOLDER.parents[2] / "doc" / "freecad-common" / "changelog.Debian.gz"
    return gzip.decompress(log.read_bytes()).decode().split("(")[1].split("+")[0] if log.exists() else ""


SETTINGS = {"wheel": wheel}
