"""The `drive` block of a variant: the drive itself and its stages by `kind`; wheels are numbered through the drive."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import count, islice
from typing import Annotated, Any, TypedDict, assert_never

from pydantic import Discriminator, Field, Tag

from tmm_report.chapters.gears.drive import solve as drive
from tmm_report.chapters.gears.drive.crank import SPEED as CRANK_SPEED
from tmm_report.chapters.gears.drive.crank import Crank
from tmm_report.chapters.gears.drive.plans import DriveScales
from tmm_report.chapters.gears.drive.power import block as power
from tmm_report.chapters.gears.drive.stages import Given as StageGiven
from tmm_report.chapters.gears.ordinary.given import (
    BeltStage,
    BevelStage,
    ChainStage,
    FrictionStage,
    Ordinary,
    PairStage,
    TrainStage,
    WormStage,
)
from tmm_report.chapters.gears.planetary import block as planetary
from tmm_report.chapters.gears.planetary.block import PlanetaryModel
from tmm_report.chapters.gears.spur import block as spur
from tmm_report.chapters.gears.spur.given import Spur
from tmm_report.chapters.lever.plans import block as plans
from tmm_report.chapters.lever.structure import block as structure
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt, mistake
from tmm_report.quantity.paper import ACCURACY
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated
from tmm_report.variant.values import Flag, Speed, quantity

Tolerance = Annotated[float, quantity("number", 0.0, 0.2, "0 … 20 %")]
Torque = Annotated[float, quantity("moment", 1e-12)]  # the input drives: else there is no efficiency


CAM_SPEED = ("cam", "speed")
SLOWEST = 1e-9  # of the input's speed: a slower output stands still


OF_PAIR = {"kind", "name", "ratio", "teeth", "mesh", "efficiency"}


def _kind(value: Any) -> str:
    if isinstance(value, PairStage) or (isinstance(value, dict) and _without_size(value)):
        return "<pair>"
    kind = value.get("kind") if isinstance(value, dict) else getattr(value, "kind", None)
    return f"<{kind}>"


def _without_size(stage: Mapping[str, Any]) -> bool:
    """Whether it is a pair of wheels of which the teeth are stated, and nothing of their size."""
    return stage.get("kind") == "spur" and "teeth" in stage and stage.keys() <= OF_PAIR


StageModel = Annotated[
    Annotated[Stated[Spur], Tag("<spur>")]
    | Annotated[PlanetaryModel, Tag("<planetary>")]
    | Annotated[Stated[BeltStage], Tag("<belt>")]
    | Annotated[Stated[ChainStage], Tag("<chain>")]
    | Annotated[Stated[FrictionStage], Tag("<friction>")]
    | Annotated[Stated[TrainStage], Tag("<train>")]
    | Annotated[Stated[PairStage], Tag("<pair>")]
    | Annotated[Stated[BevelStage], Tag("<bevel>")]
    | Annotated[Stated[WormStage], Tag("<worm>")],
    Discriminator(
        _kind,
        custom_error_type="shape",
        custom_error_message=N_(
            "begin with kind: spur, planetary, belt, chain, friction, train, bevel or worm"
        ),
    ),
]


class DriveModel(power.Keys):
    """A gear drive: stages in series in the order of the power."""

    speed: Speed | None = Field(
        default=None,
        description="of the input shaft, rad/s or rpm; left out, that of the motor",
        examples=["3000 rpm"],
    )
    tolerance: Tolerance = Field(default=0.04, description="allowed deviation of the whole ratio")
    torque: Torque | None = Field(
        default=None, description="on the input shaft; left out, torques are found for 1 N·m"
    )
    stages: list[StageModel] = Field(min_length=1, max_length=8, description="in the order of the power")
    scales: Stated[DriveScales] = Field(default_factory=DriveScales)
    output: power.Output = Field(
        default="crank",
        description="what the output shaft turns: the driving link, something else, or a machine by its load and speed",
    )
    friction: Flag | None = Field(
        default=None, description="false: the friction of the mechanism's pairs does not load the drive"
    )


class Block(model.Block):
    """A gear drive."""

    ALONE = True

    drive: DriveModel | None = Field(default=None, description="a gear drive")


class Given(TypedDict):
    drive: drive.Given | None


def given(read: Read) -> Given:
    written, accuracy = read.block(Block).drive, read.block(plans.Block).drawing.accuracy
    if written is None:
        return {"drive": None}
    return {"drive": _turning(build(written, accuracy), written, _crank(read))}


def _crank(read: Read) -> Crank | None:
    """The driving link of the lever mechanism, where there is one."""
    driver = read.block(structure.Block).mechanism.driver
    if driver is None or driver.link is None or "mechanism" not in read.data:
        return None
    stated = driver.model_fields_set
    linked = read.says(CRANK_SPEED, "drive")
    built = None if driver.speed == "drive" else structure.driver(read)
    omega = math.nan if built is None else built.omega
    # of a linked one the sense may have been filled in by the drive itself
    turned = "rotation" in (read.data["mechanism"].get("driver") or {}) and "rotation" in stated
    key = "period" if driver.period is not None else "speed"
    return Crank(driver.link, float(omega), linked, turned, key)


def _has_link(read: Read) -> bool:
    """Whether there is a driving link that the drive may turn."""
    driver = read.block(structure.Block).mechanism.driver
    return driver is not None and driver.link is not None and "mechanism" in read.data


def _turning(found: drive.Given, model: DriveModel, crank: Crank | None) -> drive.Given:
    """With the driving link that the output turns; of a linked one whose sense is stated, the input turns to suit."""
    found = replace(found, friction=model.friction is not False)
    if crank is None or model.output != "crank":
        return found
    if crank.linked and crank.turned and math.isfinite(crank.omega):
        sign = math.prod(_sense(stage) for stage in model.stages)
        found = replace(found, speed=math.copysign(found.speed, sign * crank.omega))
    return replace(found, crank=crank)


def _sense(stage: StageModel) -> float:
    """Of the output of a stage, its input turning in the sense +1."""
    return math.copysign(1.0, stage.ratio) if isinstance(stage, PlanetaryModel) else float(stage.sense)


def geared(read: Read) -> Read:
    """The blocks with the speed of the drive's output in the place of `speed: drive`. Raises ProblemError.

    The sense of rotation is that of the output, the input turning counter-clockwise; where a sense is stated the input
    turns so that the output has it (`given`).
    """
    model = read.block(structure.Block).mechanism
    driver = model.driver
    found = given(read)["drive"]
    if driver is None or driver.speed != "drive" or found is None:
        return read
    speed = drive.output_speed(found)
    if not abs(speed) > SLOWEST * abs(found.speed):
        wrong = N_("the output of the drive stands still, so the driving link has no speed")
        right = Message(N_("state the speed of the driving link, or other stages"))
        raise ProblemError([mistake(wrong, CRANK_SPEED, right)])
    taken: dict[str, Any] = {"speed": abs(speed)}
    if "rotation" not in driver.model_fields_set:
        taken["rotation"] = "counter-clockwise" if speed > 0 else "clockwise"
    moved = model.model_copy(update={"driver": driver.model_copy(update=taken)})
    return replace(read, blocks={**read.blocks, structure.Block: structure.Block(mechanism=moved)})


def geared_cam(read: Read) -> Read:
    """The blocks with the output's speed in the place of `speed: drive` of the cam. Raises ProblemError."""
    from tmm_report.chapters.cams.cam import block as cam

    stated, model = read.block(cam.Block).cam, read.block(Block).drive
    found = given(read)["drive"]
    if stated is None or not stated.driven or model is None or found is None:
        return read
    right = Message(N_("state the speed of the cam"))
    if not math.isfinite(found.speed) or any(getattr(stage, "open", False) for stage in model.stages):
        wrong = N_(
            "the motor or the stages of the drive are chosen only when it is solved: the cam has no speed yet"
        )
        raise ProblemError([mistake(wrong, CAM_SPEED, right)])
    output = drive.output_speed(found)
    if not abs(output) > SLOWEST * abs(found.speed):
        wrong = N_("the output of the drive stands still, so the cam has no speed")
        raise ProblemError([mistake(wrong, CAM_SPEED, right)])
    sense = "counter-clockwise" if output > 0 else "clockwise"
    if "rotation" in stated.model_fields_set and stated.rotation != sense:
        wrong = N_("the output of the drive turns the other way, its input turning counter-clockwise")
        right = Message(N_("leave out rotation, or a speed of the cam that is its own"))
        raise ProblemError([mistake(wrong, ("cam", "rotation"), right)])
    turned = stated.model_copy(update={"speed": abs(output), "rotation": sense})
    made = replace(read, blocks={**read.blocks, cam.Block: cam.Block(cam=turned)})
    if told := [*cam.mistakes(made)]:
        raise ProblemError(told)
    return made


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).drive
    if written is None:
        return
    yield from power.mistakes(written, read.data["drive"], read.says(CRANK_SPEED, "drive"), _has_link(read))
    if read.says(CRANK_SPEED, "drive") and written.output != "crank":
        wrong = N_("the driving link takes the speed of the drive, and the drive turns something else")
        right = Message(N_("either speed: drive in the driver or output: other in the drive"))
        yield mistake(wrong, ("drive", "output"), right)
    yield from structure.of_friction(written.friction, structure.stated(read), ("drive", "friction"), read)
    yield from _tolerances(written)


def doubts(read: Read) -> Iterator[Problem]:
    """What is odd of the stages and is solved all the same."""
    written = read.block(Block).drive
    for k, stage in enumerate(written.stages if written else ()):
        if isinstance(stage, Spur):
            yield from spur.doubts(stage, ("drive", "stages", k))
        elif isinstance(stage, PairStage) and power.given(written) is None:
            wrong = N_("no module is stated, so of the pair no more than the ratio is found")
            yield doubt(wrong, ("drive", "stages", k), Message(N_("state module: 4 mm for its geometry")))


def _tolerances(written: DriveModel) -> Iterator[Problem]:
    """A stage that may miss its ratio by more than the whole drive."""
    for k, stage in enumerate(written.stages):
        if not isinstance(stage, PlanetaryModel) or stage.tolerance is None or stage.teeth is not None:
            continue
        if "tolerance" in written.model_fields_set and stage.tolerance > written.tolerance * (1 + 1e-9):
            wrong = N_("the stage may miss its ratio by %(stage)s %%, and the whole drive by %(drive)s %%")
            right = Message(
                N_("a tolerance of the stage up to %(drive)s %%, or the same for the drive"),
                {"drive": f"{100 * written.tolerance:.4g}"},
            )
            values = {"stage": f"{100 * stage.tolerance:.4g}", "drive": f"{100 * written.tolerance:.4g}"}
            yield mistake(wrong, ("drive", "stages", k, "tolerance"), right, **values)


def build(model: DriveModel, accuracy: float = ACCURACY) -> drive.Given:
    """The drive's Given; `accuracy`: of the drawing, m of paper."""
    names = numbered(model.stages)
    allowed = tolerance(model)
    stages = tuple(
        _stage(stage, wheels, f"stage{number}", accuracy, allowed)
        for number, (stage, wheels) in enumerate(zip(model.stages, names, strict=True), 1)
    )
    asked = power.given(model)
    return drive.Given(
        speed=power.speed(model),
        stages=stages,
        tolerance=allowed,
        torque=model.torque,
        accuracy=accuracy,
        scales=model.scales,
        power=asked,
    )


def tolerance(model: DriveModel) -> float:
    """Of the whole ratio: as stated, else the usual one, or that of a stage which states a wider one."""
    if "tolerance" in model.model_fields_set:
        return model.tolerance
    stages = [stage.tolerance or 0.0 for stage in model.stages if isinstance(stage, PlanetaryModel)]
    return max([model.tolerance, *stages])


def _stage(
    model: StageModel, wheels: tuple[str, ...], label: str, accuracy: float, allowed: float
) -> StageGiven:
    """`label`: with which the stage's names in the results begin."""
    match model:
        case Spur():
            return replace(model, wheels=(wheels[0], wheels[1]), accuracy=accuracy)
        case PlanetaryModel():
            return planetary.build(model, wheels, allowed)
        case Ordinary():
            return replace(model, wheels=wheels, label=label)
        case _:
            assert_never(model)


def numbered(stages: Sequence[StageModel]) -> list[tuple[str, ...]]:
    """Names of each stage's members: 1-2-3-H, of a double row 1-2-2'-3-H, then 4-5 …; several carriers H1, H2 …"""
    numbers = map(str, count(1))
    several = sum(isinstance(stage, PlanetaryModel) for stage in stages) > 1
    carriers = (f"H{k}" for k in count(1)) if several else iter("H")
    found: list[tuple[str, ...]] = []
    for stage in stages:
        match stage:
            case Spur():
                found.append((next(numbers), next(numbers)))
            case PlanetaryModel():
                first, second = next(numbers), next(numbers)
                row = (second,) if stage.scheme == "sun-ring" else (second, second + "'")
                found.append((first, *row, next(numbers), next(carriers)))
            case Ordinary():
                found.append(tuple(islice(numbers, stage.count)))
            case _:
                assert_never(stage)
    return found
