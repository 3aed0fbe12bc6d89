"""The regimes of the machine in motion: how it starts, the steady motion to which it comes, how it runs down."""

from __future__ import annotations

import math

import numpy as np

from tmm_report.chapters.machine.dynamics import refusals
from tmm_report.chapters.machine.dynamics.given import Coast, Given, Start
from tmm_report.chapters.machine.dynamics.plant import MOTOR, Whole
from tmm_report.mechanics.calculus.laws import TIME, BySpeed
from tmm_report.mechanics.machine.characteristics import Kloss, Linear, Power
from tmm_report.mechanics.machine.reduced import LOST, Plant, level
from tmm_report.mechanics.machine.run.law import run
from tmm_report.mechanics.machine.run.motion_law import Goal, NeverReached, Run
from tmm_report.mechanics.machine.run.steady import NotSteady, Steady, at_mean_speed, periodic

CLOSED = 1e-9  # of the works of a cycle

# ---------------------------------------------------------------- start-up


def starts(plant: Plant, start: Start) -> None:
    """Raises ProblemError where what drives at rest does not overcome what resists."""
    when = _strongest(plant)
    moments = [
        float(plant.panels.at(one.values, np.array([start.at]))[0]) for one in plant.acting if one.by_angle
    ]
    moments += [float(one.at(0.0, when)) for one in plant.laws]
    drive, load = sum(m for m in moments if m > 0), -sum(m for m in moments if m < 0)
    if drive <= load + 1e-9 * max(drive, load):
        refusals.too_weak(drive, load)


def _strongest(plant: Plant) -> float:
    """The time at which most is left to drive a machine at rest, s."""
    kinked = [x for one in plant.laws for x in one.breaks(TIME)]
    times = [0.0, *kinked, *(math.nextafter(x, 0.0) for x in kinked)]  # both sides of a jump
    return max(times, key=lambda t: float(plant.net(0.0, t)))


def start_up(plant: Plant, start: Start, steady: Steady | None) -> Run:
    goal = _goal(plant, start, steady)
    _goes_on(plant, start, goal, steady)
    try:
        return run(plant, start.begin, goal, start.at)
    except NeverReached as never:
        raise refusals.never("start", never, goal.speed) from None


def _goes_on(plant: Plant, start: Start, goal: Goal, steady: Steady | None) -> None:
    """Raises ProblemError where the speed at the end is that at the beginning, or is passed there."""
    if goal.near is not None:
        to = float(plant.panels.at(goal.near, np.array([start.at]))[0])
    elif goal.speed is not None:
        to = goal.speed
    else:
        return
    rising = to > start.begin
    passed = is_open(start) and steady is not None and rising != (steady.mean > start.begin)
    if passed or abs(to - start.begin) <= 1e-9 * to:
        raise refusals.already(start.begin, to)


def _goal(plant: Plant, start: Start, steady: Steady | None) -> Goal:
    if start.speed is not None or start.time is not None or start.angle is not None:
        return Goal(start.speed, start.time, start.angle)
    if steady is None:
        raise refusals.endless()
    if not plant.of:
        raise refusals.never_steady()
    share = 1 - start.within if start.begin < steady.mean else 1 + start.within
    if plant.even:
        return Goal(speed=share * steady.mean)
    return Goal(near=share * steady.omega)


# ---------------------------------------------------------------- steady motion


def steady_motion(given: Given, machine: Whole, plant: Plant, start: Start | None) -> Steady | None:
    if given.steady is False or "time" in plant.of:
        return None
    try:
        if "speed" in plant.of:
            return _by_speed(plant, start.begin if start else _running(plant, given), given)
        return _closed(given, machine, plant)
    except NotSteady as stops:
        raise refusals.not_steady(stops.phi) from None


def _by_speed(plant: Plant, begin: float, given: Given) -> Steady | None:
    speed = balance(plant, begin)
    if speed == 0 and not plant.even:
        # from a place where little resists it may start, though the mean moment would not let it
        speed = balance(plant, _running(plant, given))
    if speed:
        return periodic(plant, speed)
    if _only_runs_down(given):
        return None
    if given.steady or given.start is None or is_open(given.start):
        raise refusals.no_level(float(plant.net(begin)), speed)
    return None


def _only_runs_down(given: Given) -> bool:
    """Whether no steady motion is wanted: the machine is let go at a speed, or nothing drives it."""
    coast = given.coast
    alone = coast is not None and given.start is None and not given.steady
    return alone and coast is not None and (coast.begin is not None or given.motor is None)


def _running(plant: Plant, given: Given) -> float:
    """A speed at which the machine is driven on, where it is not said how it started: the stated one, else the first,
    rad/s. A motor too weak to start under its load may drive it once it runs."""
    if given.speed is not None and plant.net(given.speed) > 0:
        return given.speed
    speeds = np.linspace(0.0, _fastest(given), 2000)
    drives = plant.net(speeds) > 0
    return float(speeds[int(np.argmax(drives))]) if drives.any() else 0.0


def _fastest(given: Given) -> float:
    """Speed of the main shaft beyond which no motor drives, rad/s."""
    motor = given.motor
    match motor.own if motor else None:
        case Kloss(synchronous=top) | Linear(no_load=top):
            return top / (motor.ratio if motor else 1.0)
        case BySpeed(speeds=speeds):
            return speeds[-1] / (motor.ratio if motor else 1.0)
    return 2 * given.speed if given.speed else 0.0


def stated_top(given: Given) -> float:
    """Speed of the main shaft up to which characteristics say something where no regime does, rad/s."""
    fans = [one.law.speed for one in given.resistances if isinstance(one.law, Power)]
    curves = [one.law.speeds[-1] for one in given.resistances if isinstance(one.law, BySpeed)]
    return _fastest(given) or max([*fans, *curves], default=0.0) or 1.0


def is_open(start: Start) -> bool:
    return start.speed is None and start.time is None and start.angle is None


def balance(plant: Plant, begin: float) -> float | None:
    """The speed to which the mean moment brings the machine from the speed `begin`; 0: to a stop; None: to none."""
    if float(plant.net(begin)) > 0:
        return level(plant.net, begin)
    grid = np.linspace(begin, 0.0, 400)
    moments = plant.net(grid)
    if not (moments > 0).any():
        return 0.0
    low = float(grid[int(np.argmax(moments > 0))])
    return level(plant.net, low)


def _closed(given: Given, machine: Whole, plant: Plant) -> Steady | None:
    """Without a dependence on speed the motion is steady where the work of the cycle is nil, at any mean speed: the one
    that is stated."""
    of = machine.machine
    if of is None and not given.steady:
        return None
    works = [float(plant.panels.total(one.values)) for one in plant.acting]
    size = sum(float(plant.panels.total(np.abs(one.values))) for one in plant.acting)
    speed = given.speed or (of.omega if of else 0.0)
    found = at_mean_speed(plant, speed) if speed and plant.passing is not None else None
    if found is not None:
        works.append(found.works[LOST])
    if abs(sum(works)) > CLOSED * (size or 1.0):
        if given.steady is None and given.start is not None and not is_open(given.start):
            return None
        raise refusals.not_closed(sum(works), MOTOR in [one.key for one in plant.acting])
    if not speed:
        raise refusals.no_speed()
    return found or at_mean_speed(plant, speed)


# ---------------------------------------------------------------- run-down


def run_down(machine: Whole, coast: Coast, steady: Steady | None) -> Run:
    if coast.begin is None and steady is None:
        raise refusals.coast_from()
    plant = machine.plant(coast.motor, coast.brake or 0.0, coast.load)
    begin = coast.begin
    if begin is None and steady is not None:
        begin = steady.speed(0.0)
    if coast.speed >= float(begin or 0.0):
        raise refusals.not_slower()
    try:
        return run(plant, float(begin or 0.0), Goal(speed=coast.speed))
    except NeverReached as never:
        raise refusals.never("coast", never, coast.speed) from None
