"""Motion by speed: J is constant and the moment one of the speed alone, dt = J dω/M, dφ = J ω dω/M."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.laws import SPEED
from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.mechanics.calculus.roots import bisected
from tmm_report.mechanics.machine.reduced import LOST, Plant
from tmm_report.mechanics.machine.run.motion_law import SAMPLES, NeverReached, Run

Array = Any


def by_speed(plant: Plant, start: float, end: float, phi: float = 0.0) -> Run:
    """The moment is of one sign from one speed to the other, else NeverReached."""
    J = float(plant.inertia.flat[0])
    edges, grid = _edges(plant, start, end)
    pieces = Panels(edges)
    way = np.sign(end - start) or 1.0
    omega = start + way * pieces.x
    moment = plant.accelerating(omega) + np.zeros(omega.shape)
    _drives(plant, start, end, np.concatenate([omega.ravel(), [start, end]]), way)
    slowness = J * way / moment  # dt/d|Δω|
    places = np.searchsorted(edges, np.abs(grid - start))

    def running(values: Array) -> Array:
        return pieces.running_edges(values)[places]

    works = {
        one.key: float(
            pieces.total((one.at(omega) if one.law else plant.panels.mean(one.values)) * omega * slowness)
        )
        for one in plant.acting
    }
    if plant.passing is not None:
        works[LOST] = float(pieces.total((moment - plant.net(omega)) * omega * slowness))
    return Run(plant, "speed", running(slowness), phi + running(omega * slowness), grid, works)


def _edges(plant: Plant, start: float, end: float) -> tuple[Array, Array]:
    """Edges of the pieces, as distances from `start`, and the speeds that are listed, which are among them."""
    grid = np.linspace(start, end, SAMPLES + 1)
    breaks = np.array([*(x for one in plant.laws for x in one.breaks(SPEED)), *_turns(plant, grid)])
    low, high = min(start, end), max(start, end)
    inner = breaks[(breaks > low) & (breaks < high)] if breaks.size else breaks
    distances = distinct(np.abs(np.concatenate([grid, inner]) - start))
    return distances, grid


def _turns(plant: Plant, grid: Array) -> list[float]:
    """Speeds at which the power of a geared part turns: the moment is bent there."""
    if plant.passing is None:
        return []
    moment, found = plant.net(grid) + np.zeros(len(grid)), []
    for wanted in plant.passing.moments(float(plant.inertia.flat[0])):
        off = moment - wanted
        for k in np.nonzero(off[:-1] * off[1:] < 0)[0]:
            found.append(_meets(plant, wanted, grid[k], grid[k + 1], np.sign(off[k])))
    return found


def _meets(plant: Plant, wanted: float, low: float, high: float, sign: float) -> float:
    """The speed at which the moment is the wanted one; before it, it differs from that by the sign."""
    falls = low > high
    one, other = bisected(
        lambda omega: (sign * (float(plant.net(omega)) - wanted) > 0) != falls, *sorted((low, high))
    )
    return float((one + other) / 2)


def _drives(plant: Plant, start: float, end: float, omega: Array, way: float) -> None:
    """Raises NeverReached where the moment turns its sign on the way."""
    moment = plant.net(omega) * way
    if (moment <= 0).any():
        off = omega[moment <= 0]
        nearest = float(off[np.argmin(np.abs(off - start))])
        raise NeverReached("away" if nearest == start and plant.net(start) else "level", nearest)
