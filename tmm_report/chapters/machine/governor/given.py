"""What is given of the speed governor, SI."""

from __future__ import annotations

from typing import Literal

from tmm_report.mechanics.machine.governor.brake import Brake
from tmm_report.mechanics.machine.governor.equilibrium import Geometry, Weights
from tmm_report.mechanics.machine.governor.stability import Servo
from tmm_report.records import dataclass


@dataclass(frozen=True)
class Choice:
    """What is not stated but chosen: a `spring` for the speeds at both ends of the lift, the mass of the `balls` or
    of the `sleeve` for the speed at its middle; of the governor's shaft, rad/s."""

    what: Literal["spring", "balls", "sleeve"]
    speeds: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Direct:
    """A centrifugal governor: `lowest` radius of the pins of the arms, or of the balls of a bell crank, and the
    highest, or the lift of the sleeve; dry friction on the sleeve, N, its damper, N s/m; `effort_for`: the relative
    change of the speed for which the effort is stated."""

    geometry: Geometry
    weights: Weights
    lowest: float
    highest: float | None = None
    lift: float | None = None
    friction: float = 0.0
    damping: float = 0.0
    choice: Choice | None = None
    effort_for: float = 0.01


@dataclass(frozen=True)
class Throttle:
    """Force on the sleeve that moves it, N; the insensitivity ε that it may cost."""

    force: float = 0.0
    insensitivity: float | None = None


@dataclass(frozen=True)
class Plant:
    """The machine: inertia, moment at full supply and mean speed, its fall with the speed, the same of the load,
    whose step is from `before` to `after`; speed of the governor by that of the machine; least supply. `time`: of the
    response."""

    inertia: float
    torque: float
    before: float
    after: float
    slope: float = 0.0
    load_slope: float = 0.0
    ratio: float = 1.0
    least: float = 0.0
    throttle: Throttle = Throttle()
    time: float | None = None


@dataclass(frozen=True)
class Brakes:
    """A centrifugal brake, the moment that drives it and the inertia that it holds."""

    brake: Brake
    moment: float
    inertia: float | None = None


@dataclass(frozen=True, eq=False)
class Given:
    """Of a centrifugal governor, with the machine that it governs; of a brake. `servo`: between sleeve and throttle."""

    direct: Direct | None = None
    plant: Plant | None = None
    servo: Servo | None = None
    brake: Brakes | None = None
    name: str = ""
