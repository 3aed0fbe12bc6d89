"""The law by which the driving link moves, where it does not turn uniformly: its model and what it becomes."""

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Annotated

from pydantic import Field, model_validator

from tmm_report.chapters.cams.cam.block import laws as cam_laws
from tmm_report.chapters.cams.cam.block.models import PhaseModel
from tmm_report.mechanics.calculus.motion_laws import (
    FULL_TURN,
    Harmonic,
    MotionLaw,
    Phased,
    Polynomial,
    Tabulated,
    accelerated,
    time_of,
)
from tmm_report.mechanics.cams.follower_laws import Phases
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import cycle_of
from tmm_report.mechanics.lever.mechanism import Driver, Mechanism, ZeroAngle
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import Angle, Number, Period, SignedSpeed, Speed, Time, quantity

AngularAcceleration = Annotated[float, quantity("angular acceleration")]
TurnedBy = Annotated[float, quantity("angle", -FULL_TURN, FULL_TURN, "−360 … 360 deg")]
KINDS = ("acceleration", "harmonic", "polynomial", "angles", "phases")
MOST_TURNS = 2  # in one period: the searches over it go in steps of half a degree of a turn
MOST_PERIODS = 6  # of a harmonic, in which the driving link makes whole turns
LEAST = 1e-9  # rad/s and rad/s²: what is less does not move


class HarmonicModel(Model):
    """A harmonic of the angle about its mean motion: A sin(Ω t + α)."""

    amplitude: Angle = Field(description="A", examples=["35 deg"])
    frequency: Speed | None = Field(
        default=None, description="Ω; left out, that of the mean speed", examples=["8 rad/s"]
    )
    phase: Angle = Field(default=0.0, description="α", examples=["90 deg"])

    @model_validator(mode="after")
    def moves(self) -> "HarmonicModel":
        if abs(self.amplitude) < LEAST:
            right = Message(N_("speed: 100 rpm instead of law"))
            raise WrongValue(Message(N_("a harmonic without an amplitude is none")), right)
        return self


class LawModel(Model):
    """The angle of the driving link by the time from position 0: one of the kinds, from `angle` on."""

    angle: Angle = Field(default=0.0, description="of the driving link's x axis about which the law goes")
    speed: SignedSpeed | None = Field(
        default=None,
        description="at the beginning of a constant acceleration; the mean one beside a harmonic",
        examples=["12 rad/s"],
    )
    time: Period | None = Field(
        default=None,
        description="over which the law goes; a constant acceleration goes on for one turn where it is left out",
        examples=["2 s"],
    )
    acceleration: AngularAcceleration | None = Field(default=None, description="a constant one")
    harmonic: HarmonicModel | None = Field(default=None, examples=["{amplitude: 35 deg, frequency: 8 rad/s}"])
    polynomial: list[Number] | None = Field(
        default=None,
        min_length=1,
        max_length=12,
        description="rad/s, rad/s², … by t, t², … over the time",
        examples=[[0, 3, -1]],
    )
    angles: list[tuple[Time, Angle]] | None = Field(
        default=None, min_length=4, max_length=1000, description="times from 0 and angles, a cubic spline"
    )
    phases: list[PhaseModel] = Field(
        default=[], max_length=24, description="rise, dwell and return as of a cam, over the time"
    )
    swing: TurnedBy | None = Field(
        default=None, description="of the phases, negative: clockwise", examples=["60 deg"]
    )

    @model_validator(mode="after")
    def one_kind(self) -> "LawModel":
        if sum(bool(getattr(self, kind)) or getattr(self, kind) == 0.0 for kind in KINDS) != 1:
            wrong = Message(N_("the law of the driving link is not stated in one way"))
            right = N_(
                "one of acceleration: 5 rad/s^2; harmonic: {amplitude: 35 deg, frequency: 8 rad/s}; polynomial; "
                "angles; phases"
            )
            raise WrongValue(wrong, Message(right))
        wants = {"polynomial": "time", "phases": "time"}
        kind = next(name for name in KINDS if getattr(self, name) not in (None, []))
        foreign = {
            "speed": kind not in ("acceleration", "harmonic"),
            "time": kind in ("harmonic", "angles"),
            "swing": kind != "phases",
        }
        for key, alien in foreign.items():
            if alien and getattr(self, key) is not None:
                told = {"key": key, "kind": kind}
                raise WrongValue(
                    Message(N_("%(key)s is nothing of the law %(kind)s: it says it itself"), told)
                )
        for key in filter(None, (wants.get(kind), "swing" if kind == "phases" else None)):
            if getattr(self, key) is None:
                told = {"key": key, "kind": kind}
                raise WrongValue(Message(N_("the law %(kind)s needs the key %(key)s"), told))
        built = build(self)
        if built.fastest < LEAST:
            raise WrongValue(Message(N_("by this law the driving link does not move")))
        low, high = built.reach
        if high - low > MOST_TURNS * FULL_TURN * (1 + 1e-9):
            wrong = Message(N_("the law goes over more than %(most)s turns"), {"most": MOST_TURNS})
            raise WrongValue(wrong, Message(N_("state the part of it that is asked, by its time")))
        return self


def build(model: LawModel) -> MotionLaw:
    """Raises WrongValue for what cannot be built."""
    if model.acceleration is not None:
        return _accelerated(model)
    if model.harmonic is not None:
        return _harmonic(model, model.harmonic)
    if model.polynomial is not None:
        return Polynomial((model.angle, *model.polynomial), float(model.time or 0.0))
    if model.angles is not None:
        return _tabulated(model.angles)
    phases = cam_laws.turn_of(model.phases, back=False, divided=False)
    return Phased(Phases(phases, float(model.swing or 0.0)), model.angle, float(model.time or 0.0))


def begun(built: Mechanism) -> Mechanism:
    """The mechanism whose law begins in position 0 as it is stated. Raises ProblemError where there is none."""
    driver = built.driver
    if driver.law is None or driver.stroke is not None:
        return built
    if isinstance(driver.zero, ZeroAngle):
        angle = float(driver.zero.angle)
    else:
        try:
            linkage = assemble(replace(built, driver=Driver(driver.link, 1.0, driver.zero)))
        except ProblemError:  # what is to be put together is told, or shown, by who asks for it
            return built
        angle = cycle_of(linkage).zero
    law = driver.law.moved(angle - float(driver.law.of_phase(0.0)[0]))
    return replace(built, driver=replace(driver, law=law))


def _accelerated(model: LawModel) -> MotionLaw:
    speed, acceleration = model.speed or 0.0, float(model.acceleration or 0.0)
    if abs(acceleration) < LEAST:
        right = Message(N_("speed: 100 rpm instead of law"))
        raise WrongValue(Message(N_("an acceleration of 0 is constant speed")), right)
    if model.time is not None:
        return accelerated(model.angle, speed, acceleration, model.time)
    time = time_of(math.copysign(FULL_TURN, speed or acceleration), speed, acceleration)
    if math.isnan(time):
        angle = math.degrees(speed**2 / abs(acceleration) / 2)
        stops = {"time": f"{-speed / acceleration:.6g}", "angle": f"{angle:.6g}"}
        wrong = Message(
            N_("the driving link stops after %(time)s s, having turned %(angle)s°: no full turn"), stops
        )
        raise WrongValue(wrong, Message(N_("time: %(time)s s, or shorter"), stops))
    return accelerated(model.angle, speed, acceleration, time)


def _harmonic(model: LawModel, own: HarmonicModel) -> MotionLaw:
    speed = model.speed or 0.0
    frequency = abs(speed) if own.frequency is None else own.frequency
    if frequency < LEAST:
        raise WrongValue(Message(N_("the harmonic needs the key %(key)s"), {"key": "frequency"}))
    turns = speed / frequency
    ratio = Fraction(turns).limit_denominator(MOST_PERIODS)
    if abs(turns - ratio) > 1e-9 * max(abs(turns), 1.0):
        wrong = Message(
            N_("the mean motion makes no whole number of turns in 1 … %(most)s periods of the harmonic"),
            {"most": MOST_PERIODS},
        )
        raise WrongValue(wrong, Message(N_("speed: 0, or the frequency a whole number of times the speed")))
    return Harmonic(model.angle, speed, own.amplitude, frequency, own.phase, ratio.denominator)


def _tabulated(stated: list[tuple[float, float]]) -> MotionLaw:
    times, angles = zip(*stated, strict=True)
    if times[0] != 0 or any(b <= a for a, b in pairwise(times)):
        raise WrongValue(Message(N_("the times of the angles must ascend, from 0 on")))
    return Tabulated(tuple(times), tuple(angles))


ONLY = (
    "flywheel", "dynamics", "friction", "harmonics", "methods", "method", "wear", "balancing", "engine", "press",
)  # fmt: skip
"""What reckons with a driving link that turns uniformly."""
ALONG_STROKE = ("friction", "reduction")
"""What goes along a stroke instead."""
TRAVELS = Message(N_("travel: how the slider or the cylinder moves under stated forces"))
CURES = {
    "flywheel": TRAVELS,
    "dynamics": TRAVELS,
    "drive": Message(N_("leave this block out: nothing turns all round for gears to drive")),
    "balancing": Message(N_("leave this block out: the inertia forces of the links stand among the loads")),
    "harmonics": Message(N_("leave this block out: a stroke is no turn to be taken apart into harmonics")),
    "press": Message(N_("leave this block out: the force along the stroke stands among the forces")),
}
"""Where a stroke drives what to do without these."""


def mistakes(read: Read) -> Iterator[Problem]:
    """What does not go together with a law of the driving link, or with a stroke by which something drives."""
    stroke = "stroke" in read.data["mechanism"].get("driver", {})
    right = Message(N_("leave one of the two out: with speed the driving link turns uniformly"))
    text = N_("%(key)s reckons with a uniformly turning driving link, and a law is stated")
    if stroke:
        right = Message(N_("leave this block out"))
        text = N_("%(key)s reckons with a uniformly turning driving link, and a stroke drives")
    only = [one for one in (*ONLY, "drive") if one not in ALONG_STROKE] if stroke else ONLY
    for key in only:
        if key in read.data and read.data[key] not in (None, False):
            yield mistake(text, (key,), CURES.get(key, right) if stroke else right, key=key)
    asked = read.data.get("reduction")
    if isinstance(asked, dict) and not stroke:
        text = N_(
            "the reduction to link %(link)s reckons with a uniformly turning driving link, and a law is stated"
        )
        whole = Message(N_("reduction: true, to the driving link"))
        yield mistake(text, ("reduction", "link"), whole, link=asked.get("link", ""))
    mechanism = read.data["mechanism"]
    if mechanism.get("cams"):
        yield mistake(text, ("mechanism", "cams"), right, key="cams")
    friction = read.data.get("friction")
    if stroke and isinstance(friction, dict) and friction.get("corrected"):
        told = N_(
            "reactions with friction in them are found where the driving link turns uniformly, and a stroke drives"
        )
        cure = Message(N_("leave corrected out: the power of friction is that of the reactions without it"))
        yield mistake(told, ("friction", "corrected"), cure)
