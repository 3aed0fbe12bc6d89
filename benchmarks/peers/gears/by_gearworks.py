"""py_gearworks: `SpurGear`, `mesh_to` for the distance, `get_contact_ratio`; flanks by `involute_curve_at_z`."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.peers.gears.scene import POINTS, GearPair
from benchmarks.peers.peer import installed


def both(pair: GearPair) -> dict[str, Any]:
    import py_gearworks as pgw

    first, second = (
        pgw.SpurGear(number_of_teeth=z, module=pair.m, profile_shift=x, dedendum_coefficient=1.25)
        for z, x in ((pair.z1, pair.x1), (pair.z2, pair.x2))
    )
    profile = _flank(first)
    second.mesh_to(first)
    distance = float(np.linalg.norm(second.center - first.center))
    return {
        "profile": profile,
        "distance": distance,
        "contact ratio": float(pgw.get_contact_ratio(first, second)),
    }


def _flank(gear: Any) -> Any:
    """Points of one flank, turned so that the tooth lies on the +x axis, as it is made."""
    curve, placed = gear.involute_curve_at_z(0.0)
    points = np.array([placed(curve(t)) for t in np.linspace(0.0, 1.0, POINTS)])
    return points[:, 0] + 1j * points[:, 1]


SETTINGS = {"pair": both}


def version() -> str | None:
    return installed("py_gearworks")
