"""Forces that the satellites of an eccentric mechanism hand on to the axes of sun and ring.

A satellite turns freely on its axis, so the circumferential forces of its two meshes are equal; the radial ones,
F tan α, press it away from the sun and away from the ring. Arrays (S,) over the satellites, SI.
"""

from __future__ import annotations

from typing import Any

import numpy as np

Array = Any


def on_axes(phi1: Array, phi3: Array, force: Array, sense: float, alpha: float) -> tuple[complex, complex]:
    """Of the sun and of the ring, complex N. `phi1`, `phi3`: directions of the satellites from both axes, rad; `force`:
    circumferential, N; `sense`: of the moment on the sun, + or −, counter-clockwise."""
    n1, n3 = np.exp(1j * np.asarray(phi1)), np.exp(1j * np.asarray(phi3))
    from_sun = sense * 1j * n1 + np.tan(alpha) * n1  # on the satellite, for a force of 1
    from_ring = sense * 1j * n3 - np.tan(alpha) * n3
    return complex(-(force * from_sun).sum()), complex(-(force * from_ring).sum())
