"""Whether a cam can be made: the outer wall of its groove, the hollows that a cutter enters."""

from __future__ import annotations

from typing import Any

from tmm_report.mechanics.cams.cam import Cam

Array = Any


def undercut(cam: Cam, groove: bool, cutter: float | None, phi: Array) -> str:
    """What cannot be made, by the angles of the cam's x axis: "outer" where the pitch curve is more hollow than the
    roller, so that the outer wall has a cusp; "cutter" where the profile is more hollow than
    the cutter; else nothing."""
    touch = cam.contact(phi)
    pitch, own = touch.radius, cam.radius_at(touch)
    hollow = -pitch[pitch < 0]
    if groove and hollow.size and hollow.min() <= (cam.roller or 0.0):
        return "outer"
    concave = -own[own < 0]
    return "cutter" if cutter is not None and concave.size and concave.min() < cutter else ""
