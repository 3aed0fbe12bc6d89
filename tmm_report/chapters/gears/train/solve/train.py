"""Chapter of a compound gear train: closed differentials, 3K, idlers, compound satellites, several inputs or outputs.

The rows of the kinematic formula are taken from the meshes; the speeds solve all of them together; torques follow from
the equilibrium of every member with the losses of the meshes by the way of the power. Source: Artobolevsky, Theory of
mechanisms and machines, ch. VII, XIV; Kudryavtsev, Planetary gearing, ch. 1–3.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any

from tmm_report.chapters.gears.train.given import GearTrain
from tmm_report.chapters.gears.train.solve.built import Built, build
from tmm_report.chapters.gears.train.solve.conditions import Conditions, judged
from tmm_report.chapters.gears.train.solve.mistakes import known_names, single
from tmm_report.chapters.gears.train.solve.places import Places, placed
from tmm_report.chapters.gears.train.solve.plans import Plans, plans_of
from tmm_report.chapters.gears.train.solve.sought import Sought, find
from tmm_report.mechanics.gears.compound.powers import Flow, backwards, flow, locked, without_losses
from tmm_report.mechanics.gears.compound.rows import (
    Row,
    Step,
    by_steps,
    order,
    row_ratio,
    rows_of,
    weighted,
)
from tmm_report.mechanics.gears.trains import Train, speeds
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt, mistake
from tmm_report.quantity.text import Amount, equalities
from tmm_report.records import dataclass

Given = GearTrain
HERE = ("train",)  # its key in the file
UNIT_SPEED = 1.0  # rad/s: of an input whose speed is not stated
NEAR_ONE = 1e-12  # a row whose ratio is 1 gives no speed of its carrier


@dataclass(frozen=True, eq=False)
class Found:
    """A solved train. `speed`: of every member, rad/s; `rows`: of the kinematic formula, `steps`: in which they give
    the ratios to the body `basis`, or the speeds from the stated ones where that is ""; None: they are solved together.
    `ideal`: powers without losses, `free`: with those of the meshes alone, `flow`: with the locking factor, too;
    `back`: efficiency with the power going in at the output; `cases`: speeds in the other motions; `plans`: diagrams of
    velocities, None where the axes do not lie in one plane."""

    given: Given
    built: Built
    speed: Mapping[str, float]
    rows: tuple[Row, ...]
    steps: tuple[Step, ...] | None
    basis: str
    ideal: Flow
    free: Flow
    flow: Flow
    back: float | None
    conditions: Conditions
    cases: tuple[Mapping[str, float], ...]
    places: Places
    plans: Plans | None = None
    sought: Sought | None = None

    @property
    def train(self) -> Train:
        return self.built.train

    @property
    def input(self) -> str:
        return self.given.input[0]

    @property
    def output(self) -> str:
        return self.given.output[0]

    @property
    def single(self) -> bool:
        """Whether one member is driven, one gives power, and all the others that are known stand still."""
        return single(self.given)

    @cached_property
    def still(self) -> set[str]:
        """Bodies that are held."""
        return {self.built.body(name) for name in known_names(self.given) if not self.speed[name]}

    @property
    def runs(self) -> bool:
        return bool(self.speed[self.output]) and bool(self.speed[self.input])

    @property
    def ratio(self) -> float:
        """ω_input/ω_output, signed; inf where the output stands still."""
        below = self.speed[self.output]
        return self.speed[self.input] / below if below else math.inf

    @property
    def lossy(self) -> bool:
        """Whether any loss is stated."""
        return any(mesh.efficiency < 1 for mesh in self.flow.train.meshes)

    @property
    def locks(self) -> bool:
        """Whether the losses hold the train, driven from its input."""
        return self.single and self.runs and bool(self.flow.loads.locks(self.output))

    @property
    def efficiency(self) -> float:
        return 0.0 if self.locks else float(self.flow.loads.efficiency)

    @property
    def locks_back(self) -> bool:
        """Whether it cannot be driven from the output."""
        return self.back is not None and self.back <= 0

    def weighted(self, row: Row) -> float:
        """The row's ratio with the losses in it."""
        eta = [mesh.efficiency for mesh in self.flow.train.meshes]
        return weighted(self.train, row, self.flow.way, eta)

    @property
    def force_ratio(self) -> float:
        """u′ = −M_output/M_input with the losses, for η = u′/u."""
        return float(-self.flow.loads.torque[self.output] / self.flow.loads.torque[self.input])

    @property
    def deviation(self) -> float | None:
        """Of the ratio from the wanted one, relative."""
        return self.ratio / self.given.find.ratio - 1 if self.given.find else None

    @property
    def sound(self) -> bool:
        return not self.locks and self.conditions.met

    @property
    def doubts(self) -> tuple[Problem, ...]:
        return tuple(self._doubts())

    def _doubts(self) -> Iterator[Problem]:
        if self.locks:
            yield doubt(N_("the train is self-locking: it cannot be driven from its input"), ("train",))
        if not self.runs and self.single:
            yield doubt(N_("at these speeds the output stands still"), ("train",))

    def summary(self) -> Iterator[Message]:
        """The main numbers in a sentence, and one for each thing that is wrong."""
        teeth = ", ".join(f"{m.name}: {m.teeth}" for m in self.train.members if m.teeth)
        if self.single and self.runs:
            text = N_("gear train: teeth %(teeth)s; ratio %(ratio)s; efficiency %(eta)s")
            values = {"teeth": teeth, "ratio": Amount(self.ratio, 5), "eta": Amount(self.efficiency)}
        else:
            text = N_("gear train: teeth %(teeth)s; speeds %(speeds)s")
            ends = (*self.given.input, *self.given.output)
            turned = {f"n_{name}": Amount(self.speed[name] * 30 / math.pi, 5, "rpm") for name in ends}
            values = {"teeth": teeth, "speeds": equalities(turned)}
        yield Message(text, values)
        if self.locks:
            yield Message(N_("the train is self-locking: it cannot be driven from its input"))
        if not self.conditions.met:
            yield Message(N_("a condition on the teeth of the train is not met"))


def solve(given: Given) -> Found:
    """Raises ProblemError: of speeds or torques that are not determined, of teeth that cannot be found."""
    sought = find(given) if given.sought else None
    if sought and given.efficiency is not None:
        sought = replace(sought, efficiency=tuple(_efficiencies(given, sought)))
    teeth = sought.teeth if sought else {name: one.low for name, one in given.wheels.items()}
    built = build(given, teeth)
    speed = turned(built, stated_speeds(given, built))
    rows = rows_of(built.train, built.outer, given.fixed)
    flows = _flows(given, built, speed, rows)
    places = placed(built)
    basis, steps = _plan(built, rows, speed)
    return Found(
        given,
        built,
        speed,
        rows,
        steps,
        basis,
        *flows,
        back=_back(given, built, flows[2].train, speed),
        conditions=judged(built, rows, sought.satellites if sought else given.satellites),
        cases=tuple(turned(built, case, k) for k, case in enumerate(_cases(given))),
        places=places,
        plans=plans_of(built, places, speed),
        sought=sought,
    )


# --- speeds


def stated_speeds(given: Given, built: Built) -> dict[str, float]:
    """By name: of held members 0, of the others as stated, of the wheels of a car by its road."""
    found = dict.fromkeys(given.fixed, 0.0) | dict(given.speeds)
    if (road := given.road) is not None:
        one = 2 * road.speed / road.wheel
        share = road.track / (2 * road.radius) if road.radius else 0.0
        found |= {given.output[0]: one * (1 + share), given.output[1]: one * (1 - share)}
    if given.input[0] in known_names(given) and given.input[0] not in found:
        found[given.input[0]] = UNIT_SPEED if given.speed is None else given.speed
    return found


def turned(built: Built, known: Mapping[str, float], case: int | None = None) -> dict[str, float]:
    """Speeds of all members, rad/s; what is rounding beside the largest is 0."""
    path: tuple[str | int, ...] = ("train",) if case is None else ("train", "cases", case)
    found = speeds(built.train, known, path)
    noise = 1e-12 * max(abs(float(value)) for value in found.values())
    return {name: float(value) if abs(value) > noise else 0.0 for name, value in found.items()}


def _cases(given: Given) -> Iterator[dict[str, float]]:
    """What is held stays held."""
    for case in given.cases:
        yield dict.fromkeys(given.fixed, 0.0) | dict(case)


def _plan(
    built: Built, rows: tuple[Row, ...], speed: Mapping[str, float]
) -> tuple[str, tuple[Step, ...] | None]:
    """What the speeds are referred to, and the steps: of one input and one output the ratios to the output, or to
    another body where that gives none; of several inputs from the stated speeds."""
    known = {built.body(name) for name in known_names(built.given)}
    still = {body for body in known if not speed[_member(built, body)]}
    ends = [built.body(name) for name in (built.outputs[0], built.inputs[0])]
    if single(built.given):
        others = [body for row in rows for body in row.bodies]
        for basis in dict.fromkeys([*ends, *others]):
            if basis in still or not speed[_member(built, basis)]:
                continue
            steps = order(rows, {basis, *still})
            if steps is not None and _regular(built, steps, {basis: 1.0}, still):
                return basis, steps
    elif (steps := order(rows, known)) is not None:
        start = {body: speed[_member(built, body)] for body in known - still}
        if _regular(built, steps, start, still):
            return "", steps
    return "", None


def _member(built: Built, body: str) -> str:
    return next(member.name for member in built.train.members if member.body == body)


def _regular(built: Built, steps: tuple[Step, ...], start: Mapping[str, float], still: set[str]) -> bool:
    """Whether no step divides by nought."""
    for step in steps:
        if step.body == step.row.carrier and abs(1 - row_ratio(built.train, step.row)) < NEAR_ONE:
            return False
    found = by_steps(steps, start, lambda row: row_ratio(built.train, row), still)
    return all(math.isfinite(one) for one in found.values())


# --- torques


def _efficiencies(given: Given, sought: Sought) -> Iterator[float]:
    """Of every solution, 0 where it locks itself."""
    for row in range(len(sought.candidates.ratio)):
        built = build(given, sought.candidates.set(row))
        speed = turned(built, stated_speeds(given, built))
        found = _flow(given, built, built.train, speed)
        yield 0.0 if bool(found.loads.locks(given.output[0])) else float(found.loads.efficiency)


def _flows(
    given: Given, built: Built, speed: Mapping[str, float], rows: tuple[Row, ...]
) -> tuple[Flow, Flow, Flow]:
    """Without losses, with those of the meshes, with the locking factor besides."""
    train = shut = built.train
    if given.locking is not None:
        ends = {built.body(one) for one in given.output}
        row = next(row for row in rows if row.carrier and {row.a, row.b} == ends)
        shut = locked(train, row, given.locking)
        inside = {link.mesh for link in row.links}
        meshes = tuple(
            replace(mesh, efficiency=1.0) if k in inside else mesh for k, mesh in enumerate(train.meshes)
        )
        train = Train(train.members, meshes)
    whole = _flow(given, built, shut, speed)
    free = whole if train is shut else _flow(given, built, train, speed)
    return _flow(given, built, without_losses(train), speed), free, whole


def _flow(given: Given, built: Built, train: Train, speed: Mapping[str, float]) -> Flow:
    name, torque = _load(given, speed)
    sought = [one for one in dict.fromkeys(built.outer) if built.body(one) != built.body(name)]
    found = flow(train, speed, {name: torque}, sought, HERE)
    if not bool(found.loads.settled):
        raise ProblemError([mistake(N_("the torques of the train are not determined by equilibrium"), HERE)])
    return found


def _load(given: Given, speed: Mapping[str, float]) -> tuple[str, float]:
    """The member of known torque, and the torque, N·m: along the motion on the input, against it on the output."""
    one, other = given.input[0], given.output[0]
    torque: float | None = given.torque
    name, sense = one, 1.0
    if given.output_torque is not None or given.rope is not None or given.output_power is not None:
        name, sense = other, -1.0
        torque = given.output_torque
        if given.rope is not None:
            torque = abs(given.rope.force) * given.rope.drum / 2
    power = given.power if name == one else given.output_power
    if power is not None:
        if not speed[name]:
            key = "power" if name == one else "output_power"
            right = Message(N_("a torque, or speeds at which the member turns"))
            raise ProblemError(
                [
                    mistake(
                        N_("member %(name)s stands still and has no power"), ("train", key), right, name=name
                    )
                ]
            )
        torque = power / abs(speed[name])
    return name, sense * math.copysign(1.0 if torque is None else torque, speed[name] or 1.0)


def _back(given: Given, built: Built, train: Train, speed: Mapping[str, float]) -> float | None:
    """Of a train with one input and one output and with losses."""
    lossless = all(mesh.efficiency == 1 for mesh in train.meshes)
    if not single(given) or lossless or not speed[given.output[0]] or not speed[given.input[0]]:
        return None
    return backwards(train, speed, given.output[0], (*given.fixed, given.input[0]))


def shares(of: Flow, body: str) -> dict[str, float]:
    """Of the members of a body, in parts of what it gives or takes outside, else of the power supplied."""
    branches = of.branches(body)
    outside: Any = sum(
        float(power) for name, power in of.loads.power.items() if of.train.by_name[name].body == body
    )
    whole = abs(outside) or of.supplied
    sign = -1.0 if outside > 0 else 1.0
    return {name: sign * power / whole for name, power in branches.items()} if whole else {}
