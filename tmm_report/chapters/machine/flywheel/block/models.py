"""The keys of the block `flywheel`."""

import math
import re
from typing import Annotated, Any, Literal

from pydantic import Field

from tmm_report.chapters.machine.flywheel.given import USUAL, Disc, Motor, Punch, Rim, Wheel
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity import units
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.stated import Stated
from tmm_report.variant.values import (
    Density,
    Flag,
    Inertia,
    MomentValue,
    Number,
    Positive,
    Reads,
    Scale,
    Speed,
    quantity,
    whole,
)

MOST_TURNS = 24


def _delta(value: Any) -> float:
    """1/30 or 0.0333: a number between nothing and one."""
    match = (
        re.fullmatch(r"\s*(-?[0-9]{1,4})\s*/\s*([0-9]{1,6})\s*", value) if isinstance(value, str) else None
    )
    if match and not int(match[2]):
        text = N_("%(value)s: nothing can be divided by zero")
        raise WrongValue(Message(text, {"value": shown(value)}), Message(N_("for example, 1/30")))
    found = int(match[1]) / int(match[2]) if match else units.parse(value, "number")
    if found < 0:
        text = N_("%(value)s: the greatest speed is never below the least")
        raise WrongValue(Message(text, {"value": shown(value)}), Message(N_("for example, 1/30")))
    if found == 0:
        text = N_("%(value)s: without any unevenness the flywheel would be infinitely heavy")
        raise WrongValue(Message(text, {"value": shown(value)}), Message(N_("for example, 1/30")))
    if found >= 1:
        text = N_("%(value)s is no unevenness of a steady motion: the speed would vary by as much as it is")
        raise WrongValue(Message(text, {"value": shown(value)}), Message(N_("for example, 1/30")))
    return found


_DELTA = {"type": ["number", "string"], "description": "a number or a fraction", "examples": ["1/30"]}
Delta = Annotated[float, Reads(_delta, _DELTA)]
Turns = Annotated[int, whole(1, MOST_TURNS)]
Count = Annotated[int, whole(8, 72)]
Turned = Annotated[float, quantity("angle", 0.0, 2 * math.pi * MOST_TURNS, "0 … 360 deg of every turn")]
Order = Annotated[float, quantity("number", 0.01, 24.0, "0.01 … 24")]
SignedInertia = Annotated[float, quantity("inertia")]
PositiveWork = Annotated[float, quantity("work", 1e-9)]


class Wave(Model):
    """A harmonic of the angle turned: cos·cos(order φ) + sin·sin(order φ)."""

    order: Order = Field(description="1: one wave in a turn", examples=[2])


class Harmonic(Wave):
    """A harmonic of a moment: cos·cos(order φ) + sin·sin(order φ)."""

    cos: MomentValue = 0.0
    sin: MomentValue = 0.0


class MomentModel(Model):
    """A moment on the main link over the cycle, by one law."""

    constant: MomentValue | None = None
    table: list[tuple[Turned, MomentValue]] | None = Field(
        default=None,
        min_length=2,
        max_length=1000,
        description="[[angle turned, moment], ...], linear between",
    )
    mean: MomentValue | None = Field(default=None, description="with harmonics: the mean moment")
    harmonics: list[Harmonic] | None = Field(default=None, min_length=1, max_length=50)


class InertiaHarmonic(Wave):
    """A harmonic of a moment of inertia: cos·cos(order φ) + sin·sin(order φ)."""

    cos: SignedInertia = 0.0
    sin: SignedInertia = 0.0


class InertiaModel(Model):
    """Reduced moment of inertia of the machine without the flywheel, by one law."""

    constant: Inertia | None = None
    table: list[tuple[Turned, Inertia]] | None = Field(
        default=None,
        min_length=2,
        max_length=1000,
        description="[[angle turned, inertia], ...], linear between; of one turn, it repeats in every turn",
    )
    mean: Inertia | None = Field(default=None, description="with harmonics: the mean inertia")
    harmonics: list[InertiaHarmonic] | None = Field(default=None, min_length=1, max_length=50)


class AreasModel(Model):
    """Areas of a turning-moment diagram above (+) and below (−) the mean moment, in their order."""

    values: list[Number] = Field(min_length=2, max_length=100)
    scale: PositiveWork = Field(
        default=1.0, description="work that a unit of area stands for", examples=["3141.6 J"]
    )


class MaterialModel(Model):
    """Of the wheel, by its numbers."""

    density: Density
    speed: Annotated[float, quantity("velocity", 1e-3)] = Field(
        description="allowed at the rim", examples=["35 m/s"]
    )


class FlywheelModel(Model):
    """A flywheel for a wanted unevenness. Beside a lever mechanism loads, inertia and speed are the mechanism's."""

    machine: Literal[tuple(USUAL)] | None = Field(  # type: ignore[valid-type]
        default=None, description="kind of machine, whose usual unevenness is told"
    )
    delta: Delta | None = Field(default=None, description="coefficient of non-uniformity", examples=["1/30"])
    speeds: tuple[Speed, Speed] | None = Field(
        default=None,
        description="least and greatest speed, in place of delta",
        examples=["[200 rpm, 225 rpm]"],
    )
    wheel: Stated[Wheel] | None = Field(
        default=None, description="in place of delta: what unevenness it leaves"
    )
    speed: Speed | None = Field(default=None, description="mean speed of the main link", examples=["200 rpm"])
    motor: Stated[Motor] | None = None
    turns: Turns | None = Field(default=None, description="turns of a cycle; left out, one")
    driving: MomentModel | None = Field(
        default=None, description="left out, the constant that closes the cycle"
    )
    resisting: MomentModel | None = Field(
        default=None, description="left out, the constant that closes the cycle"
    )
    areas: AreasModel | None = Field(default=None, description="in place of the moments")
    punch: Stated[Punch] | None = Field(default=None, description="in place of the moments")
    inertia: InertiaModel | None = Field(default=None, description="of the machine without the flywheel")
    own: Inertia = Field(
        default=0.0, description="of what turns with the main link and is not in the mechanism's masses"
    )
    shaft: Literal["main", "motor"] = Field(default="main", description="that carries the flywheel")
    ratio: Scale | None = Field(
        default=None, description="speed of the flywheel's shaft to that of the main link"
    )
    disc: Stated[Disc] | None = None
    rim: Stated[Rim] | None = None
    radius_of_gyration: Positive | None = Field(
        default=None, description="in place of disc or rim: gives the mass"
    )
    material: Literal["cast iron", "steel"] | MaterialModel = "steel"
    positions: Count | None = Field(default=None, description="of the table over the cycle; left out, 24")
    friction: Flag | None = Field(
        default=None,
        description="false: the friction of the mechanism's pairs is left out of the resistances",
    )
