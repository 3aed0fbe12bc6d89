"""The known part of a group's contours as a function of the driver's angle, quick at one angle.

The links before a group are solved all at once on a grid over the turn; between its angles a quintic by values and
two derivatives is as exact as the solution (h⁶/46080 of the sixth derivative, h = 0.5°). Where it is not, h is a 16th
of it; next to singular positions of the links before they are solved at the angle itself.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.loop_equations import Loops

Array = Any
Known = Callable[
    [Array], State
]  # driver angles (P,) -> the links before the group, rates by the driver's angle

PANELS = 720
FULL_TURN = 2 * np.pi
ASIDE = 0.3819660113  # of a panel: no angle of the grid falls on a round one, where change points like to be
FINER = 16  # parts of a panel whose quintic is off
EXACT = 1e-14  # part of the largest value by which a quintic may be off
NOISY = 1e-12  # the same where rounding of the solution is what it is off by


class KnownPart:
    """Vectors of the contours that the links before the group give, over `size`, and unit directions of the guides on
    known links; both with their derivatives by the driver's angle."""

    def __init__(self, loops: Loops, known: Known):
        self.loops, self.known = loops, known
        self.guides = [p for p, guide in enumerate(loops.guides) if isinstance(guide.root, str)]
        self.step = FULL_TURN / PANELS
        self.first = -ASIDE * self.step
        self.quintics, self.off, self.size = self._table(self.first, self.step, PANELS)
        self.exact = self.off <= EXACT * self.size
        self._finer: dict[int, tuple[Array, Array]] = {}

    def _table(self, first: float, step: float, count: int) -> tuple[Array, Array, float]:
        """Quintics (panel, vector, power), by how much each is off in its middle, and the largest value."""
        nodes = first + step * np.arange(count + 1)
        rows = self.solved(nodes)
        quintics = _quintics(rows, step)
        between = self.solved(nodes[:-1] + step / 2)[0]
        middle = sum(
            0.5**k * quintics[k] for k in range(len(quintics))
        )  # not by tensordot, which wakes threads
        off = np.abs(middle - between).max(axis=0, initial=0.0)
        with np.errstate(invalid="ignore"):
            size = max(1.0, float(np.nanmax(np.abs(rows[0]), initial=0.0)))
        return np.transpose(quintics, (2, 1, 0)), off, size

    def solved(self, phi: Array) -> Array:
        """Values, first and second derivatives at driver angles (P,), (3, vectors, P); nan where there are none."""
        loops = self.loops
        with np.errstate(all="ignore"):
            s = self.known(phi)
            contours = [loops._known(s, loops._contours, phi.shape, order) / loops.size for order in range(3)]
            turns = [_directions(s, loops, self.guides, phi.shape, order) for order in range(3)]
        return np.array([np.concatenate(pair) for pair in zip(contours, turns, strict=True)])

    def at(self, phi: float) -> tuple[list[complex], list[complex]]:
        """Values and first derivatives at one driver angle, rad, one a vector."""
        found = self._panel(phi)
        if found is None:
            values, rates, _ = self.solved(np.array([phi]))[:, :, 0].tolist()
            return values, rates
        quintics, t, step = found
        values, rates = [], []
        for a, b, c, d, e, f in quintics.tolist():
            values.append(a + t * (b + t * (c + t * (d + t * (e + t * f)))))
            rates.append((b + t * (2 * c + t * (3 * d + t * (4 * e + 5 * t * f)))) / step)
        return values, rates

    def _panel(self, phi: float) -> tuple[Array, float, float] | None:
        """The quintics that are exact at a driver angle, where in their panel it is, 0 … 1, and the panel's width; None
        where there are none."""
        x = (phi - self.first) % FULL_TURN / self.step
        panel = min(int(x), PANELS - 1)
        if self.exact[panel]:
            return self.quintics[panel], x - panel, self.step
        if panel not in self._finer:
            self._finer[panel] = self._refined(panel)
        quintics, exact = self._finer[panel]
        x = FINER * (x - panel)
        part = min(int(x), FINER - 1)
        return (quintics[part], x - part, self.step / FINER) if exact[part] else None

    def _refined(self, panel: int) -> tuple[Array, Array]:
        """Quintics over the parts of a panel, and which of them are exact: to rounding, or as the solution itself is,
        which shows in that they are off by no less."""
        quintics, off, _ = self._table(self.first + panel * self.step, self.step / FINER, FINER)
        rounded = (off <= NOISY * self.size) & (self.off[panel] < FINER * off)
        return quintics, (off <= EXACT * self.size) | rounded

    def is_known(self, phi: float) -> bool:
        """Whether the links before the group exist at a driver angle, and have finite rates."""
        return self._panel(phi) is not None or bool(np.isfinite(self.solved(np.array([phi]))[:2]).all())

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
