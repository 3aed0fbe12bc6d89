"""Flywheel: its moment of inertia for a wanted unevenness by several methods and exactly, the motion without it and
with it, its dimensions.

The wanted value is that of the exact solution; the methods of the textbooks stand beside it. (Artobolevsky, Theory of
mechanisms and machines, ch. 16, 19; Frolov (ed.), Theory of mechanisms, ch. 4; Khurmi, Gupta, Theory of machines,
ch. 16)
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.moving import Moving, friction_doubts
from tmm_report.chapters.machine.flywheel.given import USUAL, Given, Gyration
from tmm_report.chapters.machine.flywheel.loads import Sides, mean_speed, sides
from tmm_report.chapters.machine.flywheel.sizes import Sizes, sized
from tmm_report.mechanics.machine.flywheel.inertia import METHODS, Cycle, Method
from tmm_report.mechanics.machine.flywheel.motion import Integrated, Turning, integrated, turning
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.paper import round_scale
from tmm_report.records import dataclass

__all__ = ["Found", "Given", "solve"]

Array = Any
SHEET = 110.0  # mm: the energy–mass diagram is drawn at round scales within it
LEAST = 1e-12  # of the work of the moments: an excess work below it is rounding


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `omega`: mean speed of the main link, rad/s; `delta`: the unevenness wanted, or that of the
    flywheel that is stated; `methods`: by name, where one is wanted; `fly`: moment of inertia of the flywheel as
    reduced to the main link, kg m², 0 where none is needed; `before`: without it, None where the machine would come to
    a stand; `after`: with it; `proof`: the same motion integrated step by step; `sizes`: None where none is needed."""

    given: Given
    sides: Sides
    omega: float
    delta: float
    methods: dict[str, Method]
    fly: float
    before: Turning | None
    after: Turning
    proof: Integrated
    sizes: Sizes | None
    lever: bool

    @property
    def cycle(self) -> Cycle:
        return self.sides.cycle

    @property
    def exact(self) -> Method:
        return self.methods["exact"]

    @property
    def needless(self) -> bool:
        """Whether the machine runs evenly enough without a flywheel."""
        return self.fly == 0

    @cached_property
    def excess(self) -> float:
        """The greatest excess work: the swing of A over the cycle, J."""
        (low, _), (high, _) = self.cycle.swing
        return high - low

    @cached_property
    def work(self) -> float | None:
        """What the driving side gives over a cycle, J; None where only the excess is stated."""
        if self.sides.driving is None:
            return None
        return float(self.cycle.panels.total(self.sides.driving))

    @property
    def moment(self) -> float | None:
        """Mean driving moment, N m."""
        return None if self.work is None else self.work / self.cycle.panels.period

    @property
    def power(self) -> float | None:
        """Mean power of the driving side, W."""
        return None if self.moment is None else self.moment * self.omega

    @property
    def needed(self) -> float | None:
        """What the motor must give, losses of its transmission among it, W."""
        motor = self.given.motor
        if self.power is None or motor is None or self.sides.balancing == "resisting":
            return None
        return self.power / motor.efficiency

    @cached_property
    def estimate(self) -> float:
        """δ = A_ex/(J_r ω_m²) with the flywheel and the mean of the varying inertia in J_r."""
        return self.excess / ((self.after.fixed + self.cycle.mean_inertia) * self.omega**2)

    @property
    def diagram(self) -> bool:
        """Whether there is an energy–mass diagram: of a constant moment of inertia it is an upright line."""
        return bool(self.methods) and self.varies

    @property
    def varies(self) -> bool:
        """Whether the machine's moment of inertia varies with the angle."""
        return bool(np.any(self.cycle.varying))

    @property
    def gyration(self) -> float | None:
        """Radius of gyration, where the wheel is known by it, m."""
        if self.given.wheel:
            return self.given.wheel.gyration
        return self.given.shape.radius if isinstance(self.given.shape, Gyration) else None

    @property
    def usual(self) -> tuple[float, float] | None:
        """The unevenness usual for machines of the kind."""
        return USUAL.get(self.given.machine)

    @cached_property
    def scales(self) -> tuple[float, float]:
        """Of the energy–mass diagram: kg m² and J for a millimetre, round."""
        tangents = [self.methods["wittenbauer"].upper, self.methods["wittenbauer"].lower]
        cuts = [tangent.cut for tangent in tangents]
        (low, _), (high, _) = self.cycle.swing
        inertia = max(float(np.max(self.cycle.varying)), 1e-300)
        tall = max(high, *cuts) - min(low, *cuts)
        return round_scale(inertia, SHEET), round_scale(tall, SHEET)

    @property
    def doubts(self) -> Iterator[Problem]:
        return friction_doubts(self.sides.machine, "flywheel")

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        text = N_(
            "flywheel: J = %(J)s kg·m² for the unevenness %(delta)s; measured in the integrated motion: %(found)s"
        )
        if self.given.wheel:
            text = N_(
                "flywheel: with J = %(J)s kg·m² the unevenness is %(delta)s; measured in the motion: %(found)s"
            )
        if self.needless:
            text = N_(
                "flywheel: none is needed for the unevenness %(delta)s; measured in the motion: %(found)s"
            )
        values = {"J": f"{self.fly:.4g}", "delta": f"{self.delta:.4g}", "found": f"{self.proof.delta:.4g}"}
        yield Message(text, values)


def solve(given: Given, moving: Moving | None) -> Found:
    """`moving`: the solved lever mechanism, where the variant has one. Raises ProblemError."""
    omega = abs(moving.kinematics.omega) if moving else mean_speed(given)
    found = sides(given, moving, omega)
    _strong(given, found, omega)
    _swings(found)
    methods, delta, fly = _wanted(given, found.cycle, omega)
    before = turning(found.cycle, found.cycle.own, omega)
    after = turning(found.cycle, found.cycle.own + fly, omega)
    if after is None:
        text = N_("with this flywheel the machine comes to a stand once a cycle: its energy is too small")
        raise ProblemError([mistake(text, ("flywheel", "wheel"), Message(N_("state a heavier wheel")))])
    delta = after.delta if delta is None else delta
    start = math.sqrt(
        2 * after.start / (after.fixed + float(found.cycle.panels.ends(found.cycle.varying)[0, 0]))
    )
    proof = integrated(found.cycle, after.fixed, start)
    shape = sized(given, fly, omega, after.greatest)
    return Found(given, found, omega, delta, methods, fly, before, after, proof, shape, moving is not None)


def _wanted(given: Given, cycle: Cycle, omega: float) -> tuple[dict[str, Method], float | None, float]:
    """The methods for the wanted unevenness and the flywheel by the exact one; or the flywheel that is stated."""
    if given.wheel:
        return {}, None, given.wheel.inertia
    delta = given.delta
    if given.speeds:
        least, greatest = given.speeds
        delta = 2 * (greatest - least) / (greatest + least)
    assert delta is not None  # the block asks for one of the three
    found = {one.key: one for one in (method(cycle, delta, omega) for method in METHODS)}
    fly = found["exact"].inertia - cycle.own
    return found, delta, max(fly, 0.0)


def _swings(found: Sides) -> None:
    """Raises ProblemError for a machine without inertia of its own whose moments balance at every angle."""
    cycle = found.cycle
    moment = np.max(np.abs(cycle.moment if found.driving is None else found.driving))
    (low, _), (high, _) = cycle.swing
    if cycle.own + np.max(cycle.varying) == 0 and high - low <= LEAST * moment * cycle.panels.period:
        text = N_(
            "the excess moment is nothing all over the cycle: there is nothing for a flywheel to even out"
        )
        raise ProblemError([mistake(text, ("flywheel",), Message(N_("state a load that varies")))])


def _strong(given: Given, found: Sides, omega: float) -> None:
    """Raises ProblemError for a motor whose nominal power is less than the mean power of the cycle."""
    if given.motor is None or found.driving is None or found.balancing == "resisting":
        return  # nothing is said of the motor's own moment, or it is stated, or an engine drives
    power = float(found.cycle.panels.mean(found.driving)) * omega / given.motor.efficiency
    if power > given.motor.power * (1 + 1e-3):
        text = N_(
            "the motor is too weak: the cycle takes %(needed)s kW on the average, the motor gives %(power)s kW; a "
            "flywheel only lends energy within a cycle, it gives none"
        )
        values = {"needed": f"{power / 1e3:.4g}", "power": f"{given.motor.power / 1e3:.4g}"}
        if found.machine is not None and found.machine.rubs:
            text = N_(
                "the motor is too weak: the cycle takes %(needed)s kW on the average, %(friction)s kW of it for the "
                "friction in the pairs, the motor gives %(power)s kW; a flywheel only lends energy within a cycle, it "
                "gives none"
            )
            values["friction"] = f"{found.machine.friction_power / given.motor.efficiency / 1e3:.4g}"
        right = Message(N_("state a motor of %(needed)s kW or more"), {"needed": f"{power / 1e3:.4g}"})
        raise ProblemError([mistake(text, ("flywheel", "motor", "power"), right, **values)])
