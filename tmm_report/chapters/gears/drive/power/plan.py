"""From the machine back to the motor, before the stages that have no ratio yet are solved: needed power, motor, ratios.

Sources: Dunaev, Lelikov, Design of units and machine parts, ch. 1; Sheinblit, Course design of machine parts, ch. 1-2.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

from tmm_report.chapters.gears.drive.power.given import Given, Machine
from tmm_report.mechanics.machine import power_chain
from tmm_report.mechanics.machine.power_chain import Judged
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.records import dataclass

USUAL = {"spur": (2.0, 6.3)}  # of one stage of the kind; where no range of the whole ratio is stated
RPM = 30 / math.pi


@dataclass(frozen=True)
class Known:
    """A stage as the plan sees it. `ratio`: sizes of ω_in/ω_out, asked for (`wanted`) and found, None of a stage that
    has none yet; `teeth`: of that, its driving and its driven wheel's, 0 of the one that is sought."""

    kind: str
    efficiency: float
    wanted: float | None = None
    ratio: float | None = None
    teeth: tuple[int, int] = (0, 0)


@dataclass(frozen=True)
class Link:
    """What brings the power from one shaft to the next: a stage by its number from 0, or a coupling."""

    kind: Literal["stage", "coupling"]
    efficiency: float
    stage: int = -1


@dataclass(frozen=True)
class Need:
    """What the machine needs. `power`: useful, W; `omega`: of its shaft, rad/s; None of what nothing says. `wanted`:
    whether that speed is asked for, and not what the drive gives."""

    power: float | None = None
    omega: float | None = None
    wanted: bool = True


@dataclass(frozen=True, eq=False)
class Plan:
    """`pairs`: of bearings of every shaft; `eta`: from the motor to the useful power; `required`: of the motor, W;
    `judged`: every motor of the list, `chosen`: the one that is taken; `range`: of the whole ratio, `usual`: not
    stated; `speed`: of the motor, rad/s; `u`: the whole ratio for it; `rest`: what the stages with a ratio leave of it;
    `shares`: the ratios of the others by their numbers; `exact`: the teeth of their sought wheels before rounding,
    `teeth`: the teeth of both wheels."""

    given: Given
    stages: tuple[Known, ...]
    need: Need
    links: tuple[Link, ...]
    pairs: tuple[int, ...]
    eta: float
    required: float | None
    speed: float
    range: tuple[float, float] | None = None
    usual: bool = False
    judged: tuple[Judged, ...] = ()
    chosen: int | None = None
    u: float | None = None
    rest: float | None = None
    shares: dict[int, float] | None = None
    exact: dict[int, float] | None = None
    teeth: dict[int, tuple[int, int]] | None = None

    @property
    def bearings(self) -> list[float]:
        """Efficiency of all the pairs of every shaft."""
        return [self.given.bearings.efficiency**pairs for pairs in self.pairs]


def make(given: Given, stages: Sequence[Known], speed: float | None, need: Need, tolerance: float) -> Plan:
    """`speed`: of the motor where the drive states it, rad/s; `need`: of the driving link, else that of the machine is
    found here; `tolerance`: of the whole ratio, relative. Raises ProblemError with what is missing, or where no motor
    will do."""
    links = tuple(_links(given, stages))
    pairs = _pairs(given, len(links) + 1)
    own = given.machine.efficiency if given.machine else 1.0
    bearings = [given.bearings.efficiency**one for one in pairs]
    eta = own * float(power_chain.efficiency([one.efficiency for one in links], bearings))
    if eta <= 0:
        wrong = N_("with the losses of its stages the drive locks itself, and no motor can turn it")
        raise ProblemError([mistake(wrong, ("drive", "stages"))])
    opened = [k for k, one in enumerate(stages) if one.ratio is None]
    wanted = math.prod(one.wanted for one in stages if one.wanted is not None)
    stated = speed if speed is not None else given.motors[0].speed if len(given.motors) == 1 else None
    if stated is None and not given.motors and given.machine is not None and given.machine.omega is not None:
        stated = given.machine.omega * _whole(
            stages
        )  # no motor is looked for: the machine says how fast all turns
    if given.machine is not None:
        need = _need(given.machine, None if opened or stated is None else stated / _whole(stages))
    required = None if need.power is None else need.power / eta
    range_, usual = _range(given, stages, opened, wanted, tolerance)
    judged, chosen = _motor(given, required, need, range_)
    motor = stated if chosen is None else given.motors[chosen].speed
    assert motor is not None
    plan = Plan(given, tuple(stages), need, links, pairs, eta, required, motor, range_, usual, judged, chosen)
    return _divided(plan, opened, wanted)


def _whole(stages: Sequence[Known]) -> float:
    return math.prod(one.ratio or 1.0 for one in stages)


def _links(given: Given, stages: Sequence[Known]) -> list[Link]:
    found: list[Link] = []
    after = _after(given, stages)
    for k in range(len(stages) + 1):
        if k:
            found.append(Link("stage", stages[k - 1].efficiency, k - 1))
        if given.couplings is not None:
            found += [Link("coupling", given.couplings.efficiency)] * after.count(k)
    return found


def _after(given: Given, stages: Sequence[Known]) -> tuple[int, ...]:
    """Behind which stages couplings stand."""
    if given.couplings is None:
        return ()
    if given.couplings.after is None:
        return (len(stages),) if stages[0].kind in ("belt", "chain", "friction") else (0,)
    if max(given.couplings.after) > len(stages):
        wrong = N_("a coupling stands behind stage %(number)s, and the drive has %(count)s")
        right = Message(N_("0 behind the motor, 1 behind the first stage, …"))
        values = {"number": max(given.couplings.after), "count": len(stages)}
        raise ProblemError([mistake(wrong, ("drive", "coupling", "after"), right, **values)])
    return given.couplings.after


def _pairs(given: Given, shafts: int) -> tuple[int, ...]:
    pairs = given.bearings.pairs
    if pairs is None:
        return (0, *[1] * (shafts - 1))
    if len(pairs) != shafts:
        wrong = N_("pairs of bearings of %(found)s shafts are stated, and the drive has %(count)s")
        right = Message(N_("a number for every shaft along the power flow, that of the motor first"))
        path = ("drive", "bearings", "pairs")
        raise ProblemError([mistake(wrong, path, right, found=len(pairs), count=shafts)])
    return pairs


def _need(machine: Machine, turned: float | None) -> Need:
    """`turned`: how the drive turns the machine's shaft, rad/s, where that is known and its speed is not stated."""
    wanted = machine.omega is not None
    omega = machine.omega if wanted else turned
    if machine.power is not None:
        return Need(machine.power, omega, wanted)
    torque = machine.torque
    if machine.force is not None and machine.radius is not None:
        torque = machine.force * machine.radius
    if torque is not None and omega is None:
        wrong = N_("how fast the machine works is not known, so its load says no power")
        right = Message(
            N_("state speed: 0.85 m/s of the output, or the ratios of all the stages and the motor's speed")
        )
        raise ProblemError([mistake(wrong, ("drive", "output"), right)])
    return Need(None if torque is None or omega is None else torque * omega, omega, wanted)


def _range(
    given: Given, stages: Sequence[Known], opened: Sequence[int], wanted: float, tolerance: float
) -> tuple[tuple[float, float] | None, bool]:
    """Of the whole ratio as stated; else of the stages without a ratio the usual one, of the others their own. Where
    all have one, the drive's own within its tolerance."""
    if given.range is not None:
        return given.range, False
    if not opened:
        whole = _whole(stages)
        return (whole * (1 - tolerance), whole * (1 + tolerance)), False
    low, high = (math.prod(USUAL[stages[k].kind][side] for k in opened) for side in (0, 1))
    return (wanted * low, wanted * high), True


def _motor(
    given: Given, required: float | None, need: Need, range_: tuple[float, float] | None
) -> tuple[tuple[Judged, ...], int | None]:
    """Every motor judged, and the one taken: the only one is, whatever is to be said of it."""
    motors = [(motor.power, motor.speed) for motor in given.motors]
    if not motors:
        return (), None
    low, high = range_ or (1e-12, 1e12)
    if need.omega is None or not need.wanted or required is None:
        if len(motors) > 1:
            wrong = N_("what the machine needs is not stated, so no motor of the list can be chosen")
            right = Message(
                N_("the load and the speed of the output, or one motor alone, whose limits are then found")
            )
            raise ProblemError([mistake(wrong, ("drive", "motors"), right)])
        return (), 0
    judged = tuple(power_chain.judge(motors, required, need.omega, given.overload, low, high))
    if len(motors) == 1:
        return judged, 0
    if (best := power_chain.chosen(motors, judged, low, high)) is None:
        raise ProblemError([_none(given, required, need.omega, range_)])
    return judged, best


def _none(given: Given, required: float, omega: float, range_: tuple[float, float] | None) -> Problem:
    wrong = N_("no motor of the list will do: %(power)s kW are needed")
    right = Message(N_("a motor with more power, or overload: 5 %%"))
    values = {"power": f"{required / 1000:.4g}"}
    if range_ is not None:
        wrong = N_("no motor of the list will do: %(power)s kW are needed at %(low)s to %(high)s rpm")
        right = Message(N_("other motors, or a wider ratio_range"))
        values |= {key: f"{one * omega * RPM:.4g}" for key, one in zip(("low", "high"), range_, strict=True)}
    return mistake(wrong, ("drive", "motors"), right, **values)


def _divided(plan: Plan, opened: Sequence[int], wanted: float) -> Plan:
    """With the ratio divided among the stages that have none."""
    if plan.need.omega is None or not plan.need.wanted:
        if opened:
            wrong = N_("the ratio of the stage is stated by nothing")
            right = Message(N_("state its ratio, or speed: 0.85 m/s of the output and the motor"))
            raise ProblemError([mistake(wrong, ("drive", "stages", opened[0]), right)])
        return plan
    u = plan.speed / plan.need.omega
    if not opened:
        return replace(plan, u=u)
    rest = u / wanted
    shares = dict(zip(opened, _shares(plan.given, rest, len(opened)), strict=True))
    exact, teeth = {}, {}
    for k, share in shares.items():
        one, two = plan.stages[k].teeth
        exact[k] = one * share if one else two / share
        found = math.floor(exact[k] + 0.5)
        teeth[k] = (one, found) if one else (found, two)
        if not 6 <= found <= 1000:
            wrong = N_(
                "the division leaves the stage the ratio %(ratio)s, and its other wheel %(teeth)s teeth"
            )
            right = Message(N_("another split, other teeth, or other ratios of the stages that have one"))
            path = ("drive", "stages", k, "teeth")
            raise ProblemError([mistake(wrong, path, right, ratio=f"{share:.4g}", teeth=found)])
    return replace(plan, u=u, rest=rest, shares=shares, exact=exact, teeth=teeth)


def _shares(given: Given, rest: float, count: int) -> list[float]:
    rule = given.split
    if rule is None:
        return [float(one) for one in power_chain.shares(rest, count)]
    if rule.step is not None:
        return [float(one) for one in power_chain.shares(rest, count, rule.step)]
    if count != 2:
        wrong = N_("the rule divides the ratio between two stages, and %(count)s have none")
        right = Message(N_("split: {step: 1.25}, or stated ratios of the other stages"))
        raise ProblemError([mistake(wrong, ("drive", "split"), right, count=count)])
    slow = rule.slow is not None
    factor = rule.slow if slow else rule.fast
    return [float(one) for one in power_chain.by_root(rest, float(factor or 1.0), slow)]
