"""Motion by time: dφ/dt = ω, dω/dt = (M − J′ω²/2)/J with moments of all kinds.

From rest and to rest LSODA steps in time. A cycle in which the machine neither starts, stops nor arrives is passed in
one go by collocation in the angle (`steady.advanced`), which costs a tenth of the same accuracy by steps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import count, pairwise
from math import cos, nextafter
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.laws import TIME
from tmm_report.mechanics.machine.reduced import LOST, Plant, level, pointwise
from tmm_report.mechanics.machine.run.by_angle import running_at
from tmm_report.mechanics.machine.run.motion_law import MOST, SAMPLES, STEPPED, TURNS, Goal, NeverReached, Run
from tmm_report.mechanics.machine.run.steady import advanced, moment_at
from tmm_report.records import dataclass

Array = Any
RELATIVE, ABSOLUTE = 1e-11, 1e-13
PER_TURN = 24  # samples
PILOT = 8.0
MOST_CALLS = 100_000  # evaluations of the moments: a machine so stiff for its load is not followed
ENOUGH = 200  # times the time that the mean moment would need
FOLLOWED = 3_000_000  # values of T in all cycles that are passed: fewer cycles of an inertia of many breaks
AWAY = 2.0  # times the speed at the beginning: who is to slow down and is that fast will not


@dataclass(frozen=True, eq=False)
class Piece:
    """From the time `start` to `end`: φ, ω and dω/dt at times (Q,), each (Q,); `last`: φ and ω at the end; `works`
    of the laws, J."""

    start: float
    end: float
    at: Callable[[Array], tuple[Array, Array, Array]]
    last: tuple[float, float]
    works: dict[str, float]
    steps: int = 0
    arrived: bool = False


def by_time(plant: Plant, start: float, goal: Goal, phi: float = 0.0) -> Run:
    """Raises NeverReached."""
    every = list(_pieces(plant, start, goal, phi))
    # one that meets its goal where it begins has no length, and no slopes
    pieces = [one for one in every if one.end > one.start] or every
    first, last = pieces[0], pieces[-1]
    turns = (last.last[0] - phi) / plant.panels.period
    count = int(min(max(1, -(-PER_TURN * turns // SAMPLES)) * SAMPLES, MOST))
    t = np.linspace(first.start, last.end, count + 1)
    k = np.clip(np.searchsorted([one.start for one in pieces], t, side="right") - 1, 0, len(pieces) - 1)
    found = np.concatenate(
        [np.array(pieces[i].at(t[k == i])) for i in range(len(pieces)) if (k == i).any()], axis=1
    )
    found[:2, 0], found[:2, -1] = (phi, start), last.last
    works = {key: sum(piece.works[key] for piece in pieces) for key in first.works}
    steps = sum(piece.steps for piece in pieces)
    return Run(plant, "time", t, found[0], found[1], works | plant.works(phi, last.last[0]), steps, found[2])


def _pieces(plant: Plant, start: float, goal: Goal, phi: float) -> Iterator[Piece]:
    """The first up to the end of its cycle, whole cycles, the last one; of moments by time from kink to kink."""
    longest = goal.time if goal.time is not None else _span(plant, start, goal)
    if TIME in plant.of or plant.even:
        yield from _between_kinks(plant, start, goal, phi, longest)
        return
    piece = _stepped(plant, (0.0, longest), (phi, start), goal, phi, _next(plant, phi))
    yield piece
    if piece.arrived:
        return
    for passed in _cycles(plant, piece, goal, phi):
        piece = passed
        yield piece
    end = longest if goal.time is not None else piece.end + longest
    yield _stepped(plant, (piece.end, end), piece.last, goal, phi, None)


def _between_kinks(plant: Plant, start: float, goal: Goal, phi: float, longest: float) -> Iterator[Piece]:
    """A step must not leap over a load that acts for a short time: none leads from one side of a kink to the other."""
    first = waits(plant, phi) if start == 0 else 0.0
    if goal.time is None:  # until after the last change
        longest += max((x for one in plant.laws for x in one.breaks(TIME)), default=0.0)
    if first >= longest:
        raise NeverReached("stall", 0.0, phi)
    breaks = sorted({x for one in plant.laws for x in one.breaks(TIME) if first < x < longest})
    state = (phi, start)
    for begin, end in pairwise([first, *breaks, longest]):
        piece = _stepped(plant, (begin, end), state, goal, phi, None, end == longest)
        yield piece
        if piece.arrived:
            return
        state = piece.last


def waits(plant: Plant, phi: float) -> float:
    """Time for which a machine stands still before it starts, s: until what drives at rest is more than what resists,
    by which it is held. Raises NeverReached where that is never so."""
    kinked = {x for one in plant.laws for x in one.breaks(TIME) if x > 0}
    times = sorted({0.0, *kinked, *(nextafter(x, 0.0) for x in kinked)})  # both sides of a jump
    moments = [plant.places(phi)[2] + sum(float(one.at(0.0, t)) for one in plant.laws) for t in times]
    k = next((k for k, moment in enumerate(moments) if moment > 0), None)
    if k is None:
        raise NeverReached("stall", 0.0, phi)
    if k == 0:
        return 0.0
    return times[k - 1] - moments[k - 1] * (times[k] - times[k - 1]) / (moments[k] - moments[k - 1])


def _next(plant: Plant, phi: float) -> float:
    """The end of the cycle that is run through."""
    return (np.floor(phi / plant.panels.period + 1e-9) + 1) * plant.panels.period


# ---------------------------------------------------------------- cycle by cycle


def _cycles(plant: Plant, before: Piece, goal: Goal, phi: float) -> Iterator[Piece]:
    """The cycles that are passed in one go, one by one; each is looked for near the one before it."""
    (angle, omega), t, J = before.last, before.end, float(plant.places(0.0)[0])
    known: list[Array] = []
    for _ in range(min(TURNS, FOLLOWED // plant.panels.x.size)):
        kinetic = J * omega**2 / 2
        energy = _passing(plant, kinetic, known)
        if energy is None:
            return
        piece = _passed(plant, energy, kinetic, t, angle)
        if _arrives(plant, energy, goal, angle - phi, piece.end):
            return
        yield piece
        t, (angle, omega) = piece.end, piece.last
        known = [energy + J * omega**2 / 2 - kinetic]
    raise NeverReached("long", omega, angle - phi)


def _passing(plant: Plant, kinetic: float, known: list[Array]) -> Array | None:
    """T over a cycle, looked for from the one before, from a constant speed (a motor that holds it) and from the work
    of the loads (one that does not)."""
    panels = plant.panels
    even = plant.inertia * (kinetic / float(plant.places(0.0)[0]))
    swinging = np.maximum(kinetic + panels.running(plant.placed - plant.mean_moment), kinetic / 20)
    guesses = (one for one in (*known, even, swinging) if (one > 0).all())
    found = (advanced(plant, one, kinetic) for one in guesses)
    return next((one for one in found if one is not None), None)


def _arrives(plant: Plant, energy: Array, goal: Goal, turned: float, end: float) -> bool:
    """Whether the goal may lie within this cycle."""
    panels, omega = plant.panels, np.sqrt(2 * energy / plant.inertia)
    if goal.time is not None:
        return goal.time <= end
    if goal.angle is not None:
        return goal.angle <= turned + panels.period
    to = goal.speed if goal.near is None else goal.near
    off = panels.ends(omega - to)
    return bool(off.min() <= 0 <= off.max() or np.ptp(np.sign(omega - to)) > 0)


def _passed(plant: Plant, energy: Array, energy0: float, t: float, angle: float) -> Piece:
    """A whole cycle. Of a thousand only T is kept, the rest found again for the few that are sampled."""
    panels = plant.panels
    omega = np.sqrt(2 * energy / plant.inertia)
    moment = moment_at(plant, omega)
    last = float(np.sqrt(2 * (energy0 + panels.total(moment)) / plant.places(0.0)[0]))
    end = t + float(panels.total(1 / omega))

    def at(times: Array) -> tuple[Array, Array, Array]:
        omega, since, places = np.sqrt(2 * energy / plant.inertia), times - t, panels.x.ravel()
        slow, rates = 1 / omega, omega * panels.slope(omega)
        known = panels.running(slow).ravel()
        x = np.interp(since, [0.0, *known, end - t], [0.0, *places, panels.period])
        for _ in range(3):
            x = np.clip(x - (running_at(panels, slow, x) - since) * panels.at(omega, x), 0.0, panels.period)
        inner = np.minimum(x, panels.period * (1 - 1e-15))
        return angle + x, panels.at(omega, inner), panels.at(rates, inner)

    works = {one.key: float(panels.total(one.at(omega))) for one in plant.laws}
    if plant.passing is not None:
        works[LOST] = float(panels.total(moment - plant.acted(omega)))
    return Piece(t, end, at, (angle + panels.period, last), works)


# ---------------------------------------------------------------- step by step


def _stepped(
    plant: Plant,
    span: tuple[float, float],
    state: tuple[float, float],
    goal: Goal,
    phi: float,
    to: float | None,
    last: bool = True,
) -> Piece:
    """Unknowns φ, ω and the work of each law; it ends where the goal is met, or at the angle `to`, or, if it is not the
    `last`, at the end of the span."""
    from tmm_report.mechanics.calculus.ode import integrate

    laws = plant.laws
    keys = [*(one.key for one in laws), *([LOST] if plant.passing is not None else [])]
    unknowns = np.array([*state, *(0.0 for _ in keys), 0.0])
    events = _events(plant, goal, phi, state, to)
    found = integrate(
        _rate(plant, phi, nextafter(span[1], span[0])),
        unknowns,
        span,
        events=events,
        relative=RELATIVE,
        absolute=ABSOLUTE,
    )
    angle, omega = float(found.y[0, -1]), float(found.y[1, -1])
    stops = goal.speed is not None and goal.speed == 0
    if found.ended == 0 and not stops:
        raise NeverReached("stall", 0.0, angle)
    wanted = 0 if stops else None if goal.time is not None else 1
    arrived = found.ended == wanted and (last or wanted is not None)
    if not arrived and last and (to is None or found.ended is None or abs(angle - to) > 1e-6):
        raise NeverReached("long", omega, angle - phi)
    works = {key: float(found.y[2 + k, -1]) for k, key in enumerate(keys)}
    end = float(found.x[-1])

    def at(times: Array) -> tuple[Array, Array, Array]:
        y = found.at(times)
        return y[0], y[1], _slope(found.at, times, span[0], end)

    return Piece(span[0], end, at, (angle, omega), works, found.steps, arrived)


def _rate(plant: Plant, begin: float, end: float) -> Callable[[float, Array], list[float]]:
    """The last unknown is a pilot, sin 8φ/8: on a stretch without a load it keeps the steps from leaping over the next
    load. Where nothing depends on the angle it stands still. `end`: the last time before a jump, at which its later
    side would hold already."""
    places, laws, pilots, passing = plant.places, plant.laws, 0.0 if plant.even else 1.0, plant.passing
    calls = count()

    def rate(t: float, y: Array) -> list[float]:
        phi, omega = float(y[0]), float(y[1])
        if next(calls) > MOST_CALLS:
            raise NeverReached("long", omega, phi - begin)
        J, slope, moment = places(phi)
        moments = [float(one.at(omega, min(t, end))) for one in laws]
        left = moment + sum(moments) - slope * omega * omega / 2
        epsilon = left / J
        if passing is not None:
            epsilon = float(passing.acceleration(left, J))
            moments.append(J * epsilon - left)
        return [omega, epsilon, *(m * omega for m in moments), pilots * omega * cos(PILOT * phi)]

    return rate


def _slope(at: Callable[[Array], Array], t: Array, start: float, end: float) -> Array:
    """dω/dt by differences of fourth order of the integrator's own polynomial."""
    h = 1e-5 * (end - start)
    inner = np.clip(t, start + 2 * h, end - 2 * h)
    near, far = at(inner + h)[1] - at(inner - h)[1], at(inner + 2 * h)[1] - at(inner - 2 * h)[1]
    return (8 * near - far) / (12 * h)


def _events(
    plant: Plant, goal: Goal, phi: float, state: tuple[float, float], to: float | None
) -> list[Callable[[float, Array], float]]:
    """The first: the machine stops; the second: the goal is met; then, at the angle `to`, or where it will not be."""
    start = state[1]
    floor = -1e-9 if start == 0 else 0.0  # a start from rest is no stop
    events: list[Callable[[float, Array], float]] = [lambda t, y: float(y[1]) - floor]
    if goal.speed:
        events.append(lambda t, y: float(y[1]) - float(goal.speed or 0.0))
    elif goal.angle is not None:
        events.append(lambda t, y: float(y[0]) - phi - float(goal.angle or 0.0))
    elif goal.near is not None:
        near = pointwise(plant.panels, (goal.near,))
        events.append(lambda t, y: float(y[1]) - near(float(y[0]))[0])
    most = STEPPED if goal.time is None else TURNS
    end = state[0] + most * plant.panels.period if to is None else to
    if not plant.even:
        events.append(lambda t, y: float(y[0]) - end)
    if goal.speed is not None and goal.speed < start:
        events.append(lambda t, y: float(y[1]) - AWAY * start)
    return events


def _span(plant: Plant, start: float, goal: Goal) -> float:
    """A time that is surely enough, s: that which the moment left on an average needs to bring the speed there, many
    times over."""
    if goal.angle is not None or goal.speed == start:  # from rest to rest, somewhere within the cycle
        fast = level(plant.net, start) or start
        return 1e3 * (goal.angle or plant.panels.period) / max(fast, start, 1e-6)
    to = float(goal.near.max()) if goal.near is not None else goal.speed or 0.0
    left = float(np.abs(plant.net(np.linspace(start, to, 50))).mean()) or 1.0
    return ENOUGH * float(plant.inertia.max()) * abs(to - start) / left + 1e-6
