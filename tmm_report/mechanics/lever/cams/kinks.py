"""Where the motion of a mechanism with cams is not smooth: the ends of a law's phases, the points of a stated profile.

There accelerations or their rates jump. Integrals over the cycle step from one such angle to the next, and a derivative
is taken within the piece that begins there.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.cams.cam import ByLaw
from tmm_report.mechanics.cams.follower_laws import EDGE, FULL_TURN
from tmm_report.mechanics.cams.kinks import kinks
from tmm_report.mechanics.lever.mechanism import Mechanism

Array = Any
NODES = 11  # of the polynomial through the values of a piece
HALF = 0.03  # rad: half the width of the piece used
NEAR = 0.1  # rad from a break: there a derivative is taken within its piece


def breaks(mechanism: Mechanism) -> Array:
    """Angles of the driving link's x axis at which the motion is not smooth, rad, ascending within a turn."""
    found = [phi for cam in mechanism.cams for phi in kinks(cam)]
    return distinct(np.mod(np.array(found, dtype=float), FULL_TURN))


def law_sense(mechanism: Mechanism) -> int:
    """The sense in which the laws go over the cam's angle: at the end of a phase the next one holds."""
    return next((cam.given.sense for cam in mechanism.cams if isinstance(cam.given, ByLaw)), 1)


def slope_within(of: Callable[[Array], Array], phi: Array, sense: int, edges: Array) -> tuple[Array, Array]:
    """d of/dφ at the angles that lie near a break, from values of the piece that each lies in (at a break of the one
    that begins there, in the sense of rotation); which these are, (P,) of bool. `of`: (N, P) -> (N, P)."""
    x = sense * np.asarray(phi, dtype=float)
    at = distinct(np.mod(sense * edges, FULL_TURN))
    here = np.mod(x + EDGE, FULL_TURN)
    k = np.searchsorted(at, here, side="right")
    before = np.where(k > 0, at[k - 1], at[-1] - FULL_TURN)
    after = np.where(k < len(at), at[k % len(at)], at[0] + FULL_TURN)
    return slope_between(of, phi, sense, np.maximum(here - EDGE - before, 0.0), after - here)


def slope_between(
    of: Callable[[Array], Array], phi: Array, sense: int, behind: Array, ahead: Array
) -> tuple[Array, Array]:
    """The same of pieces that begin so far behind the angles and end so far ahead of them in the sense of rotation,
    rad, (P,)."""
    x = sense * np.asarray(phi, dtype=float)
    low, high = -np.minimum(behind, HALF), np.minimum(ahead, HALF)
    half, middle = (high - low) / 2, (high + low) / 2
    nodes = np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)
    values = of(sense * (x + middle + half * nodes[:, None]))
    fit = np.linalg.solve(np.polynomial.chebyshev.chebvander(nodes, NODES - 1), values)
    rate = np.polynomial.chebyshev.chebval(-middle / half, np.polynomial.chebyshev.chebder(fit), tensor=False)
    return sense * rate / half, (behind < NEAR) | (ahead < NEAR)
