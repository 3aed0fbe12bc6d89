"""Forces of a whole cycle at the angles at which they are drawn: near enough for a smooth curve, with all jumps."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.mechanics.lever.extremes import JUMP, inside
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
    from tmm_report.chapters.lever.kinetostatics.solve.whole_cycle import Over

Array = Any
STEP = np.radians(2.5)
BESIDE = 2e-4  # rad: the values beside a jump stand so little beside it, a hundredth of a millimetre on paper
APART = 1e-6  # rad: nearer places are one


@dataclass(frozen=True, eq=False)
class Sampled:
    """`turned`: angles, rad, ascending, (Q,); each is the place `place` of panel `panel`, which beside a jump is the
    jump. `known`: which of the angles are the diagram positions, whose values are taken as they are: at a jump they may
    be neither of its sides. `over`: None where only the diagram positions are known."""

    turned: Array
    panel: Array
    place: Array
    known: Array
    over: Over | None

    def of(self, on: Array, diagram: Array) -> Array:
        """Of a function of the panels (K, n), or (K n,) in a row, (Q,); `diagram`: at the diagram positions."""
        if self.over is None:
            return np.broadcast_to(diagram, self.turned.shape)
        values = self.over.on(on) if np.shape(on) != self.over.panels.shape else on
        found = inside(self.over.panels, values[None], 0 * self.panel, self.panel, self.place)
        diagram = np.broadcast_to(diagram, self.known.shape)
        found[self.known] = np.where(np.isfinite(diagram), diagram, found[self.known])
        return found


def sampled(found: Kinetostatics) -> Sampled:
    over, kinematics = found.over, found.kinematics
    if over is None:
        none = np.zeros(0, int)
        return Sampled(kinematics.diagram_turned, none, none, none, None)
    edges, period = over.panels.edges, over.panels.period
    even = np.linspace(0.0, period, round(period / STEP) + 1)
    peaks = [one.turned for one in over.moment] + [one.turned for two in over.sizes.values() for one in two]
    wanted = [kinematics.diagram_turned, kinematics.turned, even, edges, peaks]
    turned = _apart(np.clip(np.concatenate(wanted), 0.0, period))
    panel = np.clip(np.searchsorted(edges, turned + APART, side="right") - 1, 0, len(edges) - 2)
    at = _jumps(over)
    after = at % (len(edges) - 1)  # the end of a closed cycle is its beginning
    beside = np.concatenate([edges[at] - BESIDE, edges[after] + BESIDE])
    turned, panel = np.append(turned, beside), np.concatenate([panel, at - 1, after])
    place = np.append(turned[: len(turned) - len(beside)], np.concatenate([edges[at], edges[after]]))
    order = np.argsort(turned, kind="stable")
    turned, panel, place = turned[order], panel[order], place[order]
    known = np.abs(turned[:, None] - kinematics.diagram_turned).argmin(axis=0)
    return Sampled(turned, panel, np.clip(place, edges[panel], edges[panel + 1]), known, over)


def _apart(turned: Array) -> Array:
    turned = np.sort(turned)
    return turned[np.diff(turned, prepend=-1.0) > APART]


def _jumps(over: Over) -> Array:
    """Numbers of the edges, of 1 … K, at which a force or a load jumps; K is the end of the cycle."""
    forces = np.array(list(over.reactions.values()))
    rows = [
        over.balancing[None],
        forces.real,
        forces.imag,
        *(over.on(one)[None] for one in over.loading.stated),
    ]
    ends = over.panels.ends(np.concatenate(rows))
    after, before = np.roll(ends[..., 0], -1, axis=-1), ends[..., 1]
    jumps = (np.abs(after - before) > JUMP * np.abs(ends).max(axis=(-2, -1))[:, None]).any(axis=0)
    if not over.closed:
        jumps[-1] = False
    return np.flatnonzero(jumps) + 1
