"""The known part of a group's contours as a function of the driver's angle, quick at one angle.

The links before a group are solved all at once on a grid over the turn; between its angles a quintic by values and
two derivatives is as exact as the solution (h⁶/46080 of the sixth derivative, h = 0.5°). Where it is not, beside
singular positions of the links before, they are solved at the angle itself.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.dyads import State
from tmm_report.mechanics.loops import Loops

Array = Any
Known = Callable[
    [Array], State
]  # driver angles (P,) -> the links before the group, rates by the driver's angle

PANELS = 720
FULL_TURN = 2 * np.pi
ASIDE = 0.3819660113  # of a panel: no angle of the grid falls on a round one, where change points like to be
EXACT = 1e-14  # part of the largest value by which a quintic may be off


class KnownPart:
    """Vectors of the contours that the links before the group give, over `size`, and unit directions of the guides on
    known links; both with their derivatives by the driver's angle."""

    def __init__(self, loops: Loops, known: Known):
        self.loops, self.known = loops, known
        self.guides = [p for p, guide in enumerate(loops.guides) if isinstance(guide.root, str)]
        self.step = FULL_TURN / PANELS
        self.first = -ASIDE * self.step
        nodes = self.first + self.step * np.arange(PANELS + 1)
        rows = self.solved(nodes)
        self.quintics = _quintics(rows, self.step)
        between = self.solved(nodes[:-1] + self.step / 2)[0]
        value = np.tensordot(0.5 ** np.arange(6), self.quintics, axes=1)
        off = np.abs(value - between).max(axis=0, initial=0.0)
        with np.errstate(invalid="ignore"):
            self.exact = off <= EXACT * max(1.0, float(np.nanmax(np.abs(rows[0]), initial=0.0)))
        self.quintics = np.moveaxis(self.quintics, -1, 0)  # (panel, power, vector)

    def solved(self, phi: Array) -> Array:
        """Values, first and second derivatives at driver angles (P,), (3, vectors, P); nan where there are none."""
        loops = self.loops
        with np.errstate(all="ignore"):
            s = self.known(phi)
            contours = [loops._known(s, loops._contours, phi.shape, order) / loops.size for order in range(3)]
            turns = [_directions(s, loops, self.guides, phi.shape, order) for order in range(3)]
        return np.array([np.concatenate(pair) for pair in zip(contours, turns, strict=True)])

    def at(self, phi: float) -> tuple[Array, Array]:
        """Values and first derivatives at one driver angle, (vectors,) each."""
        if not np.isfinite(phi):
            none = np.full(self.quintics.shape[-1], np.nan, dtype=complex)
            return none, none
        x = (phi - self.first) % FULL_TURN / self.step
        panel = min(int(x), PANELS - 1)
        if not self.exact[panel]:
            values, rates, _ = self.solved(np.array([phi]))[:, :, 0]
            return values, rates
        t = x - panel
        c = self.quintics[panel]
        value = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))))
        rate = c[1] + t * (2 * c[2] + t * (3 * c[3] + t * (4 * c[4] + 5 * t * c[5])))
        return value, rate / self.step

    def exists(self, phi: Array) -> Array:
        """Whether the links before the group can be assembled at driver angles (P,)."""
        return np.isfinite(self.solved(phi)[0]).all(axis=0)


def _directions(s: State, loops: Loops, guides: list[int], shape: tuple[int, ...], order: int) -> Array:
    """Directions of the guides on known links, or their derivatives, (guides, P)."""
    rows = []
    for p in guides:
        link, turn = str(loops.guides[p].root), loops.guides[p].turn
        rate = (1.0, s.iw.get(link), s.ie.get(link))[order]
        rows.append(np.broadcast_to(rate * s.u[link] * turn, shape))
    return np.array(rows, dtype=complex).reshape(len(guides), *shape)


def _quintics(rows: Array, h: float) -> Array:
    """Coefficients by powers of t = 0 … 1 over the panels, (6, vectors, panels), from values and two derivatives."""
    y, d, e = rows[0], h * rows[1], h * h * rows[2]
    with np.errstate(invalid="ignore"):
        rise = y[:, 1:] - y[:, :-1]
        a, b, c, f = d[:, :-1], d[:, 1:], e[:, :-1], e[:, 1:]
        return np.array(
            [
                y[:, :-1],
                a,
                c / 2,
                10 * rise - 6 * a - 4 * b - 1.5 * c + 0.5 * f,
                -15 * rise + 8 * a + 7 * b + 1.5 * c - f,
                6 * rise - 3 * a - 3 * b - 0.5 * (c - f),
            ]
        )
