"""The contours of the finished cams in their axes, mm, for a drawing that machines read."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.cams.cam.quantities.names import named
from tmm_report.chapters.cams.cam.solve.found import Cams
from tmm_report.mechanics.cams.follower_laws import FULL_TURN

Array = Any
FINE = 721  # points of a curve, the last the first again
LAYERS = {"outer": "OUTER_WALL", "cut": "CUTTER", "cut_outer": "CUTTER_OUTER"}


def cad_outlines(found: Cams) -> Iterator[tuple[str, Mapping[str, Sequence[Array | float]]]]:
    """Name of a drawing and its layers: closed curves as points, (P,) x + iy, and circles about the axis as radii."""
    for k, one in enumerate(found.cams):
        cam, turned = one.cam, np.linspace(0.0, FULL_TURN, FINE)[:-1]
        phi = one.phi(turned)
        layers: dict[str, list[Array | float]] = {
            "PROFILE": [1e3 * cam.profile(phi)],
            "BASE": [1e3 * cam.base],
        }
        if cam.roller:
            layers["PITCH"] = [1e3 * cam.pitch(phi)]
        if found.made:
            curves = found.made[k].curves(turned)
            for name, layer in LAYERS.items():
                if (points := getattr(curves, name)) is not None:
                    layers[layer] = [1e3 * points]
        yield named(one, "cam"), layers
