"""A turn of a cam: what its chapter needs to know of how it is turned, whether alone or by a lever mechanism."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.cams.cam import Cam
from tmm_report.mechanics.cams.follower_laws import EDGE, FULL_TURN
from tmm_report.mechanics.cams.kinks import kinks
from tmm_report.records import dataclass

Array = Any
BEFORE = 3 * EDGE  # rad before a break: the piece that ends there


@dataclass(frozen=True, eq=False)
class Turn:
    """Angles turned from position 0 in the sense of rotation, rad: `table` and `diagram` positions, (P,), the last the
    end of the cycle; `breaks`, ascending within the `sweep`: where a phase of a law begins or is half over.

    `phi`: the angle of the cam's x axis by the angle turned; `numbered`, `distinct`: how many positions are numbered
    under a diagram, and how many have places of their own; `omega`: rad/s, None where no speed is stated.
    """

    sense: int
    sweep: float
    phi: Callable[[Array], Array]
    table: Array
    diagram: Array
    breaks: Array
    numbered: int
    distinct: int
    omega: float | None = None


def breaks_of(cams: Iterable[Cam], sense: int, zero: float, sweep: float) -> Array:
    """Angles turned, rad, ascending, at which the laws of cams have breaks; `zero`: the angle of the x axis in
    position 0."""
    angles = distinct(np.mod(np.array([phi for cam in cams for phi in kinks(cam)], dtype=float), FULL_TURN))
    found = np.mod(sense * (angles - zero), FULL_TURN)
    found = distinct(np.where(FULL_TURN - found < BEFORE, 0.0, found))
    return found[found <= sweep]


def whole_turn(cam: Cam, sense: int, table: int, diagram: int, omega: float | None = None) -> Turn:
    """Of a cam that stands alone, from where its x axis lies along that of the frame."""
    turned, drawn = (np.arange(count + 1) * (FULL_TURN / count) for count in (table, diagram))
    breaks = breaks_of([cam], sense, 0.0, FULL_TURN)
    return Turn(sense, FULL_TURN, lambda x: sense * np.asarray(x), turned, drawn, breaks, table, table, omega)
