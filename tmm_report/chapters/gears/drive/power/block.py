"""The keys of a drive from the machine back to the motor, and what they may say wrong together."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import Field, Tag

from tmm_report.chapters.gears.drive.power.given import (
    Bearings,
    Coupling,
    Given,
    Machine,
    Motor,
    Shafts,
    Split,
)
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant.model import Model
from tmm_report.variant.stated import Stated
from tmm_report.variant.values import MAP, SCALAR, Efficiency, Label, Speed, by_shape, quantity

Watts = Annotated[float, quantity("power", 1e-3)]
Overload = Annotated[float, quantity("number", 0.0, 1.0, "0 … 100 %")]
WholeRatio = Annotated[float, quantity("number", 1e-3, 1e5, "0.001 … 100000")]

Output = Annotated[
    Annotated[Literal["crank", "other"], Tag(SCALAR)] | Annotated[Stated[Machine], Tag(MAP)],
    by_shape(N_("crank, other or a machine: {force: 3.2 kN, speed: 0.85 m/s, diameter: 315 mm}")),
]


class Keys(Model):
    """Those of the drive beside its stages."""

    motors: list[tuple[Label, Watts, Speed]] = Field(
        default_factory=list,
        max_length=100,
        description="name, power and speed of each; one alone is taken, of several the weakest that will do",
        examples=["[[100L4, 4 kW, 1410 rpm]]"],
    )
    overload: Overload = Field(default=0.0, description="of the motor, permitted", examples=["5 %"])
    ratio_range: tuple[WholeRatio, WholeRatio] | None = Field(
        default=None, description="of the whole drive, permitted; left out, the usual one of its stages"
    )
    needed: Literal["mean", "greatest"] = Field(
        default="mean",
        description="for which balancing moment of the driving link the motor is: the mean one, which a flywheel asks "
        "for, or the greatest",
    )
    bearings: Annotated[
        Annotated[Efficiency, Tag(SCALAR)] | Annotated[Stated[Bearings], Tag(MAP)],
        by_shape(N_("the efficiency of a pair, or {efficiency: 0.99, pairs: [0, 1, 1]}")),
    ] = Field(default=1.0, description="efficiency of a pair of bearings, one on every shaft but the motor's")
    coupling: (
        Annotated[
            Annotated[Efficiency, Tag(SCALAR)] | Annotated[Stated[Coupling], Tag(MAP)],
            by_shape(N_("the efficiency of a coupling, or {efficiency: 0.98, after: [0, 2]}")),
        ]
        | None
    ) = Field(default=None, description="efficiency of a coupling, which parts two shafts of one speed")
    split: Annotated[
        Annotated[Literal["equal"], Tag(SCALAR)] | Annotated[Stated[Split], Tag(MAP)],
        by_shape(N_("equal, or a rule: {slow: 0.88}")),
    ] = Field(default="equal", description="how the ratio is divided among the stages that have none")
    shafts: Stated[Shafts] = Field(default_factory=Shafts)


def given(model: Any) -> Given | None:
    """None where nothing is asked of a machine or of a motor."""
    machine = model.output if isinstance(model.output, Machine) else None
    if machine is None and not model.motors:
        return None
    return Given(
        machine=machine,
        motors=tuple(Motor(*one) for one in model.motors),
        overload=model.overload,
        range=model.ratio_range,
        bearings=model.bearings if isinstance(model.bearings, Bearings) else Bearings(model.bearings),
        couplings=model.coupling if isinstance(model.coupling, Coupling | None) else Coupling(model.coupling),
        split=model.split if isinstance(model.split, Split) else None,
        shafts=model.shafts,
        peak=model.needed == "greatest",
    )


def speed(model: Any) -> float:
    """Of the motor, rad/s; nan where one is chosen from several."""
    if model.speed is not None:
        return float(model.speed)
    return float(model.motors[0][2]) if len(model.motors) == 1 else math.nan


BESIDE = ("overload", "ratio_range", "needed", "bearings", "coupling", "split", "shafts")


def mistakes(model: Any, data: Any, linked: bool, link: bool) -> Iterator[Problem]:
    """`data`: the drive's mapping, with what could not be read; `linked`: whether the driving link takes the speed of
    the drive; `link`: whether there is one."""
    stated, asked = model.model_fields_set, given(model)
    if not {"speed", "motors"} & set(data) and not _paced(model, asked):
        right = Message(N_("state speed: 1450 rpm, or motors: [[100L4, 4 kW, 1410 rpm]]"))
        yield mistake(N_("how fast the drive is turned is not stated"), ("drive",), right)
    if model.speed is not None and model.motors:
        right = Message(N_("either speed or motors"))
        yield mistake(N_("the speed of the drive is that of its motor"), ("drive", "speed"), right)
    if model.ratio_range is not None and model.ratio_range[0] > model.ratio_range[1]:
        low, high = (f"{one:g}" for one in model.ratio_range)
        wrong, right = N_("the range from %(low)s to %(high)s is empty"), Message(N_("write the least first"))
        yield mistake(wrong, ("drive", "ratio_range"), right, low=low, high=high)
    if asked is None:
        for key in BESIDE:
            if key in stated:
                right = Message(
                    N_("state output: {force: 3.2 kN, speed: 0.85 m/s, diameter: 315 mm} or motors")
                )
                yield mistake(N_("nothing is asked of a motor, so this says nothing"), ("drive", key), right)
        yield from _open(model)
        return
    yield from _together(model, data, asked, linked, link)


def _paced(model: Any, asked: Given | None) -> bool:
    """Whether the speed of the machine says how fast all the shafts turn."""
    opened = any(getattr(stage, "open", False) for stage in model.stages)
    return asked is not None and asked.machine is not None and asked.machine.omega is not None and not opened


def _open(model: Any) -> Iterator[Problem]:
    for k, stage in enumerate(model.stages):
        if getattr(stage, "open", False):
            wrong = N_("the teeth of the other wheel are sought, and its ratio is stated by nothing")
            right = Message(N_("state ratio: -2, or the speed of the output and the motors"))
            yield mistake(wrong, ("drive", "stages", k, "teeth"), right)


def _together(model: Any, data: Any, asked: Given, linked: bool, link: bool) -> Iterator[Problem]:
    """What the power side says against the rest of the drive."""
    if model.torque is not None:
        right = Message(N_("leave out the torque, or the machine and the motors"))
        yield mistake(N_("the torque on the input shaft follows from the power"), ("drive", "torque"), right)
    for k, stage in enumerate(model.stages):
        if getattr(stage, "second", None) is not None:
            wrong = N_(
                "a differential divides the power between two shafts, and no one motor is found for it"
            )
            right = Message(N_("fixed in place of second, or the drive without machine and motors"))
            yield mistake(wrong, ("drive", "stages", k, "second"), right)
    crank = model.output == "crank" and link
    opened = any(getattr(stage, "open", False) for stage in model.stages)
    if linked and crank and model.motors and (len(model.motors) > 1 or opened):
        wrong = N_(
            "the driving link takes the speed of the drive, and the drive is found for the speed of the link"
        )
        right = Message(N_("state the speed of the driving link in the place of speed: drive"))
        yield mistake(wrong, ("drive", "motors"), right)
    if "needed" in model.model_fields_set and not crank:
        right = Message(N_("output: crank, with the loads of a lever mechanism"))
        yield mistake(N_("the drive turns no driving link"), ("drive", "needed"), right)
    machine = asked.machine
    written = {*data, *(data["output"] if isinstance(data.get("output"), dict) else ())}
    if machine is not None and not {"motors", "force", "torque", "power"} & written:
        wrong = N_("neither the load of the machine nor a motor is stated")
        right = Message(N_("force: 3.2 kN of the output, or motors: [[100L4, 4 kW, 1410 rpm]]"))
        yield mistake(wrong, ("drive", "output"), right)
    if asked.shafts.by == "rated" and "motors" not in data:
        right = Message(N_("motors: [[100L4, 4 kW, 1410 rpm]], or by: required"))
        yield mistake(
            N_("no motor is stated whose rated power it would be"), ("drive", "shafts", "by"), right
        )
