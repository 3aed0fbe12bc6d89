"""The stroke of a driving slider or cylinder by the time: its model and the law that it becomes."""

import math
from itertools import pairwise
from typing import Annotated

from pydantic import Field, model_validator

from tmm_report.chapters.cams.cam.block import laws as cam_laws
from tmm_report.chapters.cams.cam.block.models import PhaseModel
from tmm_report.mechanics.calculus.motion_laws import (
    Harmonic,
    MotionLaw,
    Phased,
    Pieces,
    Polynomial,
    RunUp,
    Tabulated,
    accelerated,
    time_of,
)
from tmm_report.mechanics.cams.follower_laws import Phases
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.values import Length, Number, Period, Positive, Speed, Time, Velocity, quantity

Along = Annotated[float, quantity("acceleration")]
KINDS = ("acceleration", "accelerations", "harmonic", "polynomial", "lengths", "phases")
SLIGHT = 1e-12  # of the time of running up and down: a rounding
MOVES = N_("from and to that differ, or a speed or an acceleration")
LEAST = 1e-9  # m/s and m/s²: what is less does not move
WANTS = {"polynomial": ("time",), "phases": ("time", "rise")}
OF = {
    "": ("speed", "to", "time", "run_up", "run_down"),
    "acceleration": ("speed", "to", "time"),
    "accelerations": ("speed",),
    "harmonic": (),
    "polynomial": ("time",),
    "lengths": (),
    "phases": ("time", "rise"),
}
"""Beside which kind of law which of the other keys may stand; of constant speed the kind is empty."""


class SwayModel(Model):
    """A harmonic of the stroke about its middle: A sin(Ω t + α)."""

    amplitude: Positive = Field(description="A", examples=["40 mm"])
    frequency: Speed = Field(description="Ω", examples=["8 rad/s"])
    phase: Annotated[float, quantity("angle")] = Field(default=0.0, description="α", examples=["90 deg"])


class StrokeModel(Model):
    """The place of a driving slider along its guide, or the length of a cylinder, by the time from position 0."""

    from_: Length | None = Field(
        default=None,
        alias="from",
        description="at the beginning; of a harmonic the middle; of lengths it is theirs",
        examples=["1.10 m"],
    )
    speed: Velocity | None = Field(
        default=None, description="constant, or at the beginning of an acceleration", examples=["0.15 m/s"]
    )
    to: Length | None = Field(default=None, description="where it ends, instead of the time")
    time: Period | None = Field(default=None, description="over which the law goes", examples=["3 s"])
    run_up: Period | None = Field(
        default=None,
        description="beside the constant speed: how long it is run up to from rest",
        examples=["0.4 s"],
    )
    run_down: Period | None = Field(
        default=None, description="beside the constant speed: how long it is run down to rest at the end"
    )
    acceleration: Along | None = Field(default=None, description="a constant one", examples=["0.4 m/s^2"])
    accelerations: list[tuple[Period, Along]] | None = Field(
        default=None,
        min_length=1,
        max_length=40,
        description="one after another: how long, and which",
        examples=[[["0.4 s", "0.375 m/s^2"], ["2.6 s", 0]]],
    )
    harmonic: SwayModel | None = None
    polynomial: list[Number] | None = Field(
        default=None, min_length=1, max_length=12, description="m/s, m/s², … by t, t², … over the time"
    )
    lengths: list[tuple[Time, Length]] | None = Field(
        default=None, min_length=4, max_length=1000, description="times from 0 and strokes, a cubic spline"
    )
    phases: list[PhaseModel] = Field(
        default=[], max_length=24, description="rise, dwell and return as of a cam, over the time"
    )
    rise: Positive | None = Field(default=None, description="of the phases", examples=["120 mm"])

    @property
    def kind(self) -> str:
        """The key of the law; of constant speed none."""
        return next((key for key in KINDS if getattr(self, key) not in (None, [])), "")

    @model_validator(mode="after")
    def one_kind(self) -> "StrokeModel":
        if sum(getattr(self, key) not in (None, []) for key in KINDS) > 1:
            right = N_(
                "one of speed alone, acceleration, accelerations, harmonic, polynomial, lengths, phases"
            )
            raise WrongValue(Message(N_("the law of the stroke is not stated in one way")), Message(right))
        kind = self.kind
        for key in ("speed", "to", "time", "rise", "run_up", "run_down"):
            if getattr(self, key) is not None and key not in OF[kind]:
                told = {"key": key, "kind": kind or "speed"}
                raise WrongValue(
                    Message(N_("%(key)s is nothing of the law %(kind)s: it says it itself"), told)
                )
        for key in WANTS.get(kind, ()):
            if getattr(self, key) is None:
                told = {"key": key, "kind": kind}
                raise WrongValue(Message(N_("the law %(kind)s needs the key %(key)s"), told))
        if (self.from_ is None) != (kind == "lengths"):
            text = (
                N_("the strokes of a table say where it begins: from is left out")
                if kind == "lengths"
                else N_("the stroke needs the key from: where it begins")
            )
            raise WrongValue(
                Message(text), Message(N_("for example, {from: 1.10 m, speed: 0.15 m/s, time: 3 s}"))
            )
        if not build(self).fastest >= LEAST:
            raise WrongValue(Message(N_("by this law nothing moves")), Message(MOVES))
        return self


def build(model: StrokeModel) -> MotionLaw:
    """The law of the stroke, m. Raises WrongValue for what cannot be built."""
    start = model.from_ or 0.0
    match model.kind:
        case "acceleration":
            return _accelerated(model, start)
        case "accelerations":
            times, values = zip(*(model.accelerations or []), strict=True)
            return Pieces(start, model.speed or 0.0, times, values)
        case "harmonic":
            sway = model.harmonic
            assert sway is not None
            return Harmonic(start, 0.0, sway.amplitude, sway.frequency, sway.phase)
        case "polynomial":
            return Polynomial((start, *(model.polynomial or ())), float(model.time or 0.0))
        case "lengths":
            return _tabulated(model.lengths or [])
        case "phases":
            phases = cam_laws.turn_of(model.phases, back=False, divided=False)
            return Phased(Phases(phases, float(model.rise or 0.0)), start, float(model.time or 0.0))
    return _uniform(model, start)


def _one_end(model: StrokeModel) -> None:
    """Where the law ends is stated once."""
    if (model.to is None) == (model.time is None):
        wrong = Message(N_("where the stroke ends must be stated once"))
        raise WrongValue(wrong, Message(N_("either to: 0.60 m or time: 3 s")))


def _uniform(model: StrokeModel, start: float) -> MotionLaw:
    _one_end(model)
    if model.speed is None or abs(model.speed) < LEAST:
        wrong = Message(N_("the stroke needs a speed or a law"))
        raise WrongValue(wrong, Message(N_("for example, {from: 1.10 m, speed: 0.15 m/s, time: 3 s}")))
    speed, time = model.speed, model.time
    if model.to is not None:
        if speed < 0 < model.to - start:
            raise WrongValue(Message(N_("with this speed the stroke never comes to its end")))
        speed = math.copysign(speed, model.to - start)
        time = (model.to - start) / speed
        if not time > 0:
            raise WrongValue(Message(N_("by this law nothing moves")), Message(MOVES))
        time += ((model.run_up or 0.0) + (model.run_down or 0.0)) / 2
    up, down = model.run_up or 0.0, model.run_down or 0.0
    if not up and not down:
        return Polynomial((start, speed), float(time or 0.0))
    steady = float(time or 0.0) - up - down
    if steady < -SLIGHT * (up + down):
        wrong = Message(N_("before the speed is run up to the stroke would be at its end"))
        raise WrongValue(
            wrong, Message(N_("a shorter run_up or run_down, a longer time or stroke, or a lower speed"))
        )
    pieces = [(up, speed / up if up else 0.0), (steady, 0.0), (down, -speed / down if down else 0.0)]
    times, values = zip(*((t, a) for t, a in pieces if t > SLIGHT * (up + down)), strict=True)
    return RunUp(start, 0.0 if up else speed, times, values, speed, up, down)


def _accelerated(model: StrokeModel, start: float) -> MotionLaw:
    _one_end(model)
    speed, acceleration = model.speed or 0.0, float(model.acceleration or 0.0)
    if abs(acceleration) < LEAST:
        right = Message(N_("speed instead of it"))
        raise WrongValue(Message(N_("an acceleration of 0 is constant speed")), right)
    time = model.time
    if model.to is not None:
        time = time_of(model.to - start, speed, acceleration)
        if not time > 0:
            raise WrongValue(Message(N_("with this speed the stroke never comes to its end")))
    return accelerated(start, speed, acceleration, float(time or 0.0))


def _tabulated(stated: list[tuple[float, float]]) -> MotionLaw:
    times, places = zip(*stated, strict=True)
    if times[0] != 0 or any(b <= a for a, b in pairwise(times)):
        raise WrongValue(Message(N_("the times of the strokes must ascend, from 0 on")))
    return Tabulated(tuple(times), tuple(places))
