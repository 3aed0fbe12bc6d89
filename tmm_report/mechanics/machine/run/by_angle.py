"""Motion by angle: the moment is one of the angle alone, J ω²/2 = T0 + ∫M dφ, dt = dφ/ω."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.mechanics.calculus.roots import newton
from tmm_report.mechanics.machine.reduced import Plant
from tmm_report.mechanics.machine.run.motion_law import SAMPLES, TURNS, Goal, NeverReached, Run

Array = Any


def by_angle(plant: Plant, start: float, goal: Goal, phi: float = 0.0) -> Run:
    """The energy integral, over as many cycles as it takes."""
    panels, moment = plant.panels, plant.placed
    first = float(plant.places(phi)[0]) * start**2 / 2 - _work(plant, 0.0, phi)

    def energy(x: Array) -> Array:
        """T at any angles turned."""
        turns = np.floor_divide(x, panels.period)
        inside = running_at(panels, moment, x - turns * panels.period)
        return first + turns * float(panels.total(moment)) + inside

    if goal.time is not None:
        return _timed(plant, start, goal.time, phi, energy)
    end = (
        phi + goal.angle if goal.angle is not None else _arrival(plant, first, phi, start, goal.speed or 0.0)
    )
    stop = _first(plant, first, phi, start, 0.0)
    if stop is not None and stop < end - 1e-9:
        raise NeverReached("stall", 0.0, stop)
    return _sampled(plant, phi, end, energy)


def _work(plant: Plant, start: float, end: float) -> float:
    return sum(plant.works(start, end).values())


def running_at(panels: Panels, values: Array, x: Array) -> Array:
    """Integral from 0 to each place within the period, by the integral of the panel's own polynomial."""
    x = np.asarray(x, dtype=float)
    k = np.clip(np.searchsorted(panels.edges, x.ravel(), side="right") - 1, 0, panels.shape[0] - 1)
    left = panels.edges[k]
    unit = Panels(np.array([0.0, 1.0]), panels.order)
    away = x.ravel() - left
    inner = panels.at(
        values, np.minimum(left[:, None] + away[:, None] * unit.x[0], panels.edges[k + 1][:, None])
    )
    weights = unit.total(np.eye(panels.order)[:, None, :])
    return (panels.running_edges(values)[k] + away * (inner @ weights)).reshape(x.shape)


def _arrival(plant: Plant, first: float, phi: float, start: float, speed: float) -> float:
    found = _first(plant, first, phi, start, speed)
    if found is None:
        stop = _first(plant, first, phi, start, 0.0) if speed else None
        if stop is not None:
            raise NeverReached("stall", 0.0, stop)
        raise NeverReached("away", start)
    return found


def _first(plant: Plant, first: float, phi: float, start: float, speed: float) -> float | None:
    """The first angle beyond `phi` at which the speed is met, by cycles; None where there is none."""
    panels = plant.panels
    wanted = plant.inertia * speed**2 / 2
    swing = panels.running(plant.placed) - wanted
    gain, at_edge = float(panels.total(plant.placed)), float(plant.places(0.0)[0]) * speed**2 / 2
    (least, _), (greatest, _) = panels.extremes(swing)
    turn = int(np.floor_divide(phi, panels.period))
    for n in range(turn, turn + TURNS):
        base = first + n * gain
        noise = 1e-12 * max(abs(base), abs(gain), at_edge)
        if base + least <= noise and base + greatest >= -noise:
            roots = panels.roots(swing + base)  # on an edge of two panels, too
            roots = roots[roots > 0]  # where the cycle begins again there is a jump and no root
            if abs(base + gain - at_edge) <= noise:  # on the edge between two cycles
                roots = np.append(roots, panels.period)
            later = roots[roots + n * panels.period > phi + 1e-9 * panels.period]
            if later.size:
                return float(later[0] + n * panels.period)
        passed = (gain >= 0 and base + least > noise) or (gain <= 0 and base + greatest < -noise)
        if passed or (gain == 0 and n > turn):
            return None
    return None


def _sampled(plant: Plant, phi: float, end: float, energy: Callable[[Array], Array]) -> Run:
    """Samples at equal angles."""
    grid = np.linspace(phi, end, SAMPLES + 1)
    kinetic = energy(grid)
    if (kinetic < -1e-9 * float(np.abs(kinetic).max())).any():  # it does not even begin to move
        raise NeverReached("stall", 0.0, phi)
    kinetic = np.maximum(kinetic, 0.0)
    rests = kinetic <= 1e-10 * float(kinetic.max())
    omega = np.where(rests, 0.0, np.sqrt(2 * kinetic / plant.panels.at(plant.inertia, grid)))
    t = _times(plant, grid, (bool(rests[0]), bool(rests[-1])), energy)
    return Run(plant, "angle", t, grid, omega, plant.works(phi, end))


FINE = 24  # Gauss points of the integral of time
FEW = 4  # cycles: of more, those within are passed as a whole


def _times(plant: Plant, grid: Array, rests: tuple[bool, bool], energy: Callable[[Array], Array]) -> Array:
    """Time from the first of the angles to each, (P,)."""
    period, low, high = plant.panels.period, float(grid[0]), float(grid[-1])
    first, last = np.ceil(low / period) + 1, np.floor(high / period) - 1
    if plant.even or last - first < FEW:
        return _through(plant, grid, rests, energy)
    begin, end = first * period, last * period
    before = np.append(grid[grid < begin], begin)
    after = np.concatenate([[end], grid[grid > end]])
    head = _through(plant, before, (rests[0], False), energy)
    at, whole = _cycles(plant, grid[(grid >= begin) & (grid <= end)], int(first), int(last), energy)
    tail = _through(plant, after, (False, rests[1]), energy)
    return np.concatenate([head[:-1], head[-1] + at, head[-1] + whole + tail[1:]])


def _through(plant: Plant, grid: Array, rests: tuple[bool, bool], energy: Callable[[Array], Array]) -> Array:
    """By Gauss's formula between the angles and the edges of the panels. Where the machine starts from rest or comes to
    rest 1/ω is infinite as 1/√x and its integral is not: there √x is the variable."""
    panels, low, high = plant.panels, float(grid[0]), float(grid[-1])
    edges = grid
    if not plant.even:
        turns = np.arange(np.floor(low / panels.period), np.ceil(high / panels.period) + 1)
        marks = (turns[:, None] * panels.period + panels.edges[:-1]).ravel()
        edges = distinct(np.concatenate([grid, marks[(marks > low) & (marks < high)]]))
    unit = Panels(np.array([0.0, 1.0]), FINE)
    u, weights = unit.x[0], unit.total(np.eye(FINE)[:, None, :])
    a, b = edges[:-1, None], edges[1:, None]
    x, stretch = a + (b - a) * u, b - a + 0 * u
    for resting, rest, side, here in (
        (rests[0], low, 1.0, (a + b <= low + high) | (not rests[1])),
        (rests[1], high, -1.0, (a + b > low + high) | (not rests[0])),
    ):
        near, far = (np.sqrt(np.maximum(side * (one - rest), 0.0)) for one in (a, b))
        root = near + (far - near) * u
        if resting:
            x = np.where(here, rest + side * root**2, x)
            stretch = np.where(here, 2 * side * root * (far - near), stretch)
    kinetic = np.maximum(energy(x), 1e-300)
    each = (stretch * np.sqrt(panels.at(plant.inertia, x) / (2 * kinetic))) @ weights
    return np.concatenate([[0.0], np.cumsum(np.add.reduceat(each, np.searchsorted(edges, grid[:-1])))])


def _cycles(
    plant: Plant, grid: Array, first: int, last: int, energy: Callable[[Array], Array]
) -> tuple[Array, float]:
    """Time from the beginning of the cycle `first` to angles within the cycles up to `last`, (Q,), and to their end: by
    the points of the panels, which are the same in each."""
    panels, numbers = plant.panels, np.arange(first, last + 1)
    start = energy(numbers * panels.period)
    kinetic = start[:, None, None] + panels.running(plant.placed)
    slow = np.sqrt(plant.inertia / (2 * np.maximum(kinetic, 1e-300)))
    begins = np.concatenate([[0.0], np.cumsum(panels.total(slow))])
    n = np.clip(np.floor(grid / panels.period + 1e-12).astype(int), first, last - 1) - first
    inside = np.clip(grid - numbers[n] * panels.period, 0.0, panels.period)
    k = np.clip(np.searchsorted(panels.edges, inside, side="right") - 1, 0, panels.shape[0] - 1)
    unit = Panels(np.array([0.0, 1.0]), panels.order)
    away = inside - panels.edges[k]
    x = panels.edges[k][:, None] + away[:, None] * unit.x[0]
    rest = np.sqrt(panels.at(plant.inertia, x) / (2 * energy(x + numbers[n][:, None] * panels.period)))
    part = away * (rest @ unit.total(np.eye(panels.order)[:, None, :]))
    edges = panels.running_edges(slow)
    return begins[n] + edges[n, k] + part, float(begins[last - first])


def _timed(plant: Plant, start: float, time: float, phi: float, energy: Callable[[Array], Array]) -> Run:
    """The angle at which the time is over, by Newton's method: dt/dφ = 1/ω."""
    inertia = float(plant.places(phi)[0])
    high = max(start * time + abs(float(plant.places(phi)[2])) * time**2 / (2 * inertia), 1e-6)
    for _ in range(60):
        if (energy(phi + np.linspace(0, high, 200)[1:]) <= 0).any():
            raise NeverReached("stall", 0.0, phi + high)
        if _sampled(plant, phi, phi + high, energy).t[-1] >= time:
            break
        high = 2 * high

    def left(turned: float) -> tuple[float, float]:
        found = _sampled(plant, phi, phi + turned, energy)
        omega = float(found.omega[-1])
        return time - float(found.t[-1]), -1 / omega if omega else 0.0

    return _sampled(plant, phi, phi + newton(left, 0.0, high, high), energy)
