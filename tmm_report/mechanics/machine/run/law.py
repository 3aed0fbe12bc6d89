"""The motion of a machine from one state to another, in the cheapest way that its moments allow (see `motion_law`)."""

from __future__ import annotations

from tmm_report.mechanics.machine.reduced import Plant
from tmm_report.mechanics.machine.run.by_angle import by_angle
from tmm_report.mechanics.machine.run.by_speed import by_speed
from tmm_report.mechanics.machine.run.by_time import by_time
from tmm_report.mechanics.machine.run.motion_law import Goal, Run


def run(plant: Plant, start: float, goal: Goal, phi: float = 0.0) -> Run:
    """The motion from the speed `start`, rad/s, at the angle `phi` turned. Raises NeverReached."""
    if plant.even and "time" not in plant.of and goal.speed is not None:
        return by_speed(plant, start, goal.speed, phi)
    if not plant.of and plant.passing is None:
        return by_angle(plant, start, goal, phi)
    return by_time(plant, start, goal, phi)
