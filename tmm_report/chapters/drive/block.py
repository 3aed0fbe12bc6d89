"""The `drive` block of a variant: the drive itself and its stages by `kind`; wheels are numbered through the drive."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import count
from typing import Annotated, Any, TypedDict, assert_never

from pydantic import Discriminator, Field, Tag

from tmm_report.chapters.drive import solve as drive
from tmm_report.chapters.drive.plans import Scales
from tmm_report.chapters.planetary import block as planetary
from tmm_report.chapters.planetary import solve as solve_planetary
from tmm_report.chapters.planetary.block import PlanetaryModel
from tmm_report.chapters.plans import block as plans
from tmm_report.chapters.spur import block as spur
from tmm_report.chapters.spur import solve as solve_spur
from tmm_report.chapters.spur.block import SpurModel
from tmm_report.problems import N_, Problem
from tmm_report.quantity.paper import ACCURACY
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import Scale, Speed, quantity

Tolerance = Annotated[float, quantity("number", 0.0, 0.2, "0 … 20 %")]
Torque = Annotated[float, quantity("moment", 1e-12)]  # the input drives: else there is no efficiency


def _kind(value: Any) -> str:
    kind = value.get("kind") if isinstance(value, dict) else getattr(value, "kind", None)
    return f"<{kind}>"


StageModel = Annotated[
    Annotated[SpurModel, Tag("<spur>")] | Annotated[PlanetaryModel, Tag("<planetary>")],
    Discriminator(
        _kind, custom_error_type="shape", custom_error_message=N_("begin with kind: spur or kind: planetary")
    ),
]


class DriveScalesModel(Model):
    """Scales of the drive's diagrams, SI units per mm of paper; what is left out is chosen."""

    length: Scale | None = Field(default=None, description="m/mm, of the kinematic scheme")
    velocity: Scale | None = Field(default=None, description="(m/s)/mm, of the diagram of linear velocities")
    angular: Scale | None = Field(default=None, description="(rad/s)/mm, of the plan of angular velocities")


class DriveModel(Model):
    """A gear drive: stages in series in the order of the power."""

    speed: Speed = Field(description="of the input shaft, rad/s or rpm", examples=["3000 rpm"])
    tolerance: Tolerance = Field(default=0.04, description="allowed deviation of the whole ratio")
    torque: Torque | None = Field(
        default=None, description="on the input shaft; left out, torques are found for 1 N·m"
    )
    stages: list[StageModel] = Field(min_length=1, max_length=8, description="in the order of the power")
    scales: DriveScalesModel = Field(default_factory=DriveScalesModel)


class Block(model.Block):
    """A gear drive."""

    ALONE = True

    drive: DriveModel | None = Field(default=None, description="a gear drive")


class Given(TypedDict):
    drive: drive.Given | None


def given(read: Read) -> Given:
    written, accuracy = read.block(Block).drive, read.block(plans.Block).drawing.accuracy
    return {"drive": build(written, accuracy) if written else None}


def mistakes(read: Read) -> Iterator[Problem]:
    yield from ()


def build(model: DriveModel, accuracy: float = ACCURACY) -> drive.Given:
    """The drive's Given; `accuracy`: of the drawing, m of paper."""
    names = numbered(model.stages)
    stages = tuple(_stage(stage, wheels, accuracy) for stage, wheels in zip(model.stages, names, strict=True))
    scales = Scales(model.scales.length, model.scales.velocity, model.scales.angular)
    return drive.Given(model.speed, stages, model.tolerance, model.torque, accuracy, scales)


def _stage(
    model: SpurModel | PlanetaryModel, wheels: tuple[str, ...], accuracy: float
) -> solve_spur.Given | solve_planetary.Given:
    match model:
        case SpurModel():
            return spur.build(model, wheels, accuracy)
        case PlanetaryModel():
            return planetary.build(model, wheels)
        case _:
            assert_never(model)


def numbered(stages: Sequence[SpurModel | PlanetaryModel]) -> list[tuple[str, ...]]:
    """Names of each stage's members: 1-2-3-H, of a double row 1-2-2'-3-H, then 4-5 …; several carriers H1, H2 …"""
    numbers = map(str, count(1))
    several = sum(isinstance(stage, PlanetaryModel) for stage in stages) > 1
    carriers = (f"H{k}" for k in count(1)) if several else iter("H")
    found: list[tuple[str, ...]] = []
    for stage in stages:
        first, second = next(numbers), next(numbers)
        match stage:
            case SpurModel():
                found.append((first, second))
            case PlanetaryModel():
                row = (second,) if stage.scheme == "sun-ring" else (second, second + "'")
                found.append((first, *row, next(numbers), next(carriers)))
            case _:
                assert_never(stage)
    return found
