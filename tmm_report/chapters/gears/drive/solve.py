"""Chapter of gears, the drive as a whole: stages in series, the whole ratio, speeds, torques, efficiency, diagrams.

The stages are solved each in its own room; here they become one train: the output of a stage turns with the input of
the next, and Willis' equations of all meshes are solved together, so that the stages may stand in any order and be
ordinary, planetary or differentials with a second input. Source: Artobolevsky, Theory of mechanisms and machines,
ch. VII; Frolov (ed.), Theory of mechanisms and machines, ch. 15.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from tmm_report.chapters.gears.drive.crank import Crank, Moments, doubts, moments
from tmm_report.chapters.gears.drive.plans import DriveScales, Plans, draw
from tmm_report.chapters.gears.drive.power import ahead
from tmm_report.chapters.gears.drive.power import solve as power
from tmm_report.chapters.gears.drive.power.given import Given as PowerGiven
from tmm_report.chapters.gears.drive.stages import Given as StageGiven
from tmm_report.chapters.gears.drive.stages import Stage, doubts_of, run, solve_all, working
from tmm_report.mechanics.gears.trains import Loads, Train, loads, speeds
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt, mistake
from tmm_report.quantity.paper import ACCURACY
from tmm_report.quantity.text import Amount, amounts
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving


@dataclass(frozen=True)
class Given:
    """A drive. `speed`: of the input shaft, rad/s, nan where a motor is chosen for it; `tolerance`: of the whole
    ratio, relative; `torque`: on the input shaft, N·m, None: all torques are found for 1 N·m, or for the balancing
    moment of the link that is turned; `accuracy`: m of paper; `scales`: of the diagrams; `crank`: the driving link that
    the output turns, if any;
    `friction`: whether that of its mechanism's pairs, where it is stated, loads the drive; `power`: the machine that it
    turns and the motors to choose from, None where nothing is asked of them."""

    speed: float
    stages: tuple[StageGiven, ...]
    tolerance: float = 0.04
    torque: float | None = None
    accuracy: float = ACCURACY
    scales: DriveScales = field(default_factory=DriveScales)
    crank: Crank | None = None
    friction: bool = True
    power: PowerGiven | None = None


@dataclass(frozen=True, eq=False)
class Found:
    """A solved drive. `speed`: of every member, rad/s; `loads`: torques and powers of the members that are loaded from
    outside; `plans`: the diagrams of linear and angular velocities; `moments`: of the driving link that the drive
    turns; `asked`: whether the torque at the input is that which their mean asks for, and not a stated one; `power`: of
    the shafts from the motor to the machine."""

    given: Given
    stages: tuple[Stage, ...]
    train: Train
    speed: Mapping[str, float]
    loads: Loads
    plans: Plans
    moments: Moments | None = None
    asked: bool = False
    power: power.Found | None = None

    @property
    def input(self) -> str:
        return self.stages[0].input

    @property
    def output(self) -> str:
        return self.stages[-1].output

    @property
    def ratio(self) -> float:
        """ω_input/ω_output at work, signed; inf where the output stands still."""
        return self.between(self.input, self.output)

    def between(self, one: str, other: str) -> float:
        """ω_one/ω_other, signed; inf where the other stands still."""
        below = self.speed[other]
        return self.speed[one] / below if below else math.inf

    @property
    def differential(self) -> bool:
        """Whether a stage has a second input."""
        return any(stage.second for stage in self.stages)

    @property
    def geared(self) -> float:
        """The ratio by the teeth, second inputs at rest: the product over the stages."""
        return math.prod(stage.ratio for stage in self.stages)

    @property
    def wanted(self) -> float:
        """What the assignment asks for in the place of `geared`."""
        return math.prod(stage.wanted for stage in self.stages)

    @property
    def deviation(self) -> float:
        """Of the ratio by the teeth from the wanted one, relative, signed."""
        return self.geared / self.wanted - 1

    @property
    def within(self) -> bool:
        return abs(self.deviation) <= self.given.tolerance * (1 + 1e-9)

    @property
    def efficiency(self) -> float:
        """Of the whole drive, 0..1; 0 where it locks itself."""
        return 0.0 if self.locks else float(self.loads.efficiency)

    @property
    def locks(self) -> bool:
        """Whether the losses hold the drive: it cannot be driven from this side."""
        return not self.differential and bool(self.loads.locks(self.output))

    @property
    def supplied(self) -> list[str]:
        """Members to which power is supplied from outside; of a differential the output may be one."""
        return [name for name, power in self.loads.power.items() if power > 0]

    @property
    def taken(self) -> list[str]:
        """Members from which power is taken."""
        return [name for name, power in self.loads.power.items() if power < 0]

    @property
    def arm(self) -> float:
        """Of the point whose velocity is laid off first, from the axis of the input member, m, signed."""
        return self.plans.first.y - self.plans.axes[self.input]

    @property
    def losses(self) -> float:
        """Power lost in all the meshes, W."""
        return float(sum(self.loads.loss))

    @property
    def runs(self) -> bool:
        """Whether the output turns: two inputs may hold it."""
        return bool(self.speed[self.output])

    @property
    def graphical(self) -> float:
        """The ratio at work by the segments of the plan of angular velocities."""
        return self.plans.ratio(self.input, self.output)

    @property
    def graphical_error(self) -> float:
        """(g − a)/(½ (g + a)), %, of the graphical ratio against the calculated one; nan where one is infinite."""
        g, a = self.graphical, self.ratio
        return 200 * (g - a) / (g + a) if math.isfinite(g + a) else math.nan

    @property
    def sound(self) -> bool:
        """Whether the drive has its ratio, can be driven, and every condition of its gear pairs is met."""
        return self.within and not self.locks and all(run(stage).sound for stage in self.stages)

    @property
    def doubts(self) -> tuple[Problem, ...]:
        """A driving link that is stated to turn otherwise than the output does; a ratio that is missed."""
        found, crank = [*doubts_of(self.stages), *self._missed], self.given.crank
        found += self.power.doubts() if self.power else ()
        if crank is not None and not crank.linked and self.runs:
            speed, wide = self.speed[self.output], self.given.tolerance
            found += doubts(crank, speed, self.ratio, wide)
        return tuple(found)

    @property
    def _missed(self) -> Iterator[Problem]:
        """A ratio outside the tolerance of the drive, its stages within theirs: what to state more narrowly."""
        if self.within or len(self.stages) < 2:
            return
        values = {
            "deviation": f"{100 * abs(self.deviation):.3g}",
            "stage": f"{100 * self.given.tolerance / len(self.stages):.3g}",
        }
        wrong = N_(
            "the ratios of the stages, each within its tolerance, miss that of the drive by %(deviation)s %%"
        )
        right = N_("other numbers of teeth or other diameters in the stages, or a greater tolerance")
        if any(mesh.carrier for mesh in self.train.meshes):
            right = N_(
                "tolerance: %(stage)s %% in the planetary stages, or other numbers of teeth in the pairs"
            )
        yield doubt(wrong, ("drive", "tolerance"), Message(right, values), **values)

    def summary(self) -> list[Message]:
        """The main numbers in a sentence, and one for each thing that is wrong."""
        text = N_("gear drive: teeth %(teeth)s; ratio %(ratio)s, required %(wanted)s; efficiency %(eta)s")
        numbers = {"ratio": self.geared, "wanted": self.wanted, "eta": self.efficiency}
        found = [Message(text, {"teeth": self._teeth, **amounts(numbers, 5)})]
        if not self.within:
            deviation = {"deviation": Amount(100 * self.deviation, 3)}
            found.append(
                Message(
                    N_("the ratio of the drive deviates by %(deviation)s %%: more than allowed"), deviation
                )
            )
        if self.locks:
            found.append(Message(N_("the drive is self-locking: it cannot be driven from the input shaft")))
        found += self.power.summary() if self.power else []
        return [*found, *(line for stage in self.stages for line in run(stage).summary())]

    @property
    def _teeth(self) -> str:
        toothed = (", ".join(str(m.teeth) for m in s.members if m.teeth) for s in self.stages)
        return "; ".join(filter(None, toothed)) or "—"


def output_speed(given: Given) -> float:
    """Of the output shaft, rad/s, + counter-clockwise. Raises ProblemError with the mistakes of all the stages."""
    stages = solve_all(given.stages)
    return _turned(given, stages, joined(stages))[stages[-1].output]


def solve(given: Given, moving: Moving | None = None) -> Found:
    """Solve the stages and the drive. `moving`: the lever mechanism whose driving link it may turn. Raises ProblemError
    with the mistakes of all the stages."""
    crank = given.crank is not None and (given.crank.linked or given.power is not None)
    found = moments(moving, given.friction) if crank else None
    given, plan = ahead.planned(given, found)
    stages = solve_all(given.stages)
    train = joined(stages)
    speed = _turned(given, stages, train)
    shafts = None if plan is None else power.solve(plan, stages)
    if shafts is not None:
        given = replace(given, torque=shafts.driving()[0])
    load = _loads(given, stages, train, speed)
    torque = _for_mean(found, stages, load) if found is not None and given.torque is None else None
    if torque:
        given = replace(given, torque=torque)
        load = _loads(given, stages, train, speed)
    _check_worms(stages, load)
    plans = _plans(given, stages, train, speed)
    stages = tuple(_at_work(given, stages, speed, load, shafts))
    return Found(given, stages, train, speed, load, plans, found, bool(torque), shafts)


def _check_worms(stages: Sequence[Stage], load: Loads) -> None:
    """Raises ProblemError where the power flows from a wheel to its worm, whose efficiency is that of the worm."""
    powers = iter(load.mesh_power)
    for k, stage in enumerate(stages):
        for mesh in stage.meshes:
            power = float(next(powers))
            if mesh.crosses and getattr(stage, "kind", "") == "worm" and power < 0:
                wrong = N_("the power flows backwards through the worm stage, from the wheel to the worm")
                right = Message(N_("other speeds of the inputs, or a stage of another kind"))
                raise ProblemError([mistake(wrong, ("drive", "stages", k), right)])


def _at_work(
    given: Given,
    stages: Sequence[Stage],
    speed: Mapping[str, float],
    load: Loads,
    shafts: power.Found | None,
) -> Iterator[Stage]:
    """The stages at their speeds, and under their torques where that of the input is known: what the first mesh of
    each takes from its input; with losses beside those of the stages, what the shaft hands on to it."""
    first, handed = 0, None if shafts is None else shafts.driving()
    for number, stage in enumerate(stages):
        torque = None if given.torque is None else -float(load.mesh_torque[first])
        if torque is not None and handed is not None:
            torque = math.copysign(handed[number], torque)
        yield working(stage, speed[stage.input], torque)
        first += len(stage.meshes)


def _for_mean(found: Moments, stages: Sequence[Stage], load: Loads) -> float | None:
    """Torque at the input, N·m, for which the output gives the mean moment; None: of a differential, or where the drive
    locks itself or is driven on the whole."""
    whole = float(abs(load.torque[stages[-1].output]))
    if any(stage.second for stage in stages) or bool(load.locks(stages[-1].output)) or not whole:
        return None
    return found.mean / whole if found.mean > 0 else None


def _turned(given: Given, stages: Sequence[Stage], train: Train) -> dict[str, float]:
    """Speeds of all members, rad/s."""
    return _cleaned(speeds(train, _known_speeds(given.speed, stages), ("drive",)))


def _cleaned(speed: Mapping[str, Any]) -> dict[str, float]:
    """Speeds as numbers; what is rounding beside the largest is 0, for a member that stands still."""
    noise = 1e-12 * max(abs(float(value)) for value in speed.values())
    return {name: float(value) if abs(value) > noise else 0.0 for name, value in speed.items()}


def joined(stages: Sequence[Stage]) -> Train:
    """One train: the output of each stage on one shaft with the input of the next."""
    train = Train(
        tuple(member for stage in stages for member in stage.members),
        tuple(mesh for stage in stages for mesh in stage.meshes),
    )
    for before, after in pairwise(stages):
        train = _coupled(train, before.output, after.input)
    return train


def _coupled(train: Train, one: str, other: str) -> Train:
    shaft, old = train.by_name[one].body, train.by_name[other].body
    members = tuple(replace(m, shaft=shaft) if m.body == old else m for m in train.members)
    return Train(members, train.meshes)


def _known_speeds(speed: float, stages: Sequence[Stage]) -> dict[str, float]:
    """What is given: the input, the second inputs, and 0 of the members that stand still."""
    known = {stages[0].input: speed}
    for stage in stages:
        known |= dict.fromkeys(stage.fixed, 0.0)
        known |= dict([stage.second] if stage.second else [])
    return known


def _loads(given: Given, stages: Sequence[Stage], train: Train, speed: Mapping[str, float]) -> Loads:
    """Torques of the fixed members, of the second inputs and of the output for the torque of the input."""
    torque = 1.0 if given.torque is None else given.torque
    held = [name for name in _known_speeds(given.speed, stages) if name != stages[0].input]
    return loads(train, speed, {stages[0].input: torque}, (*held, stages[-1].output), ("drive",))


def _plans(given: Given, stages: Sequence[Stage], train: Train, speed: Mapping[str, float]) -> Plans:
    known = _known_speeds(given.speed, stages)
    return draw(stages, train, known, speed, given.scales, given.accuracy)
