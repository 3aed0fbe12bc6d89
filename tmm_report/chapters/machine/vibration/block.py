"""The block `vibration` of a variant."""

from collections.abc import Iterator
from typing import Annotated, Any, TypedDict

from pydantic import Discriminator, Field, Tag

from tmm_report.chapters.lever.structure.block import stated as has_mechanism
from tmm_report.chapters.machine.vibration.given import CURVES, Absorber, Foundation, Unbalance
from tmm_report.chapters.machine.vibration.given import Given as Stated
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    Angle,
    Damping,
    FixedDirection,
    Label,
    Length,
    Positive,
    PositiveInertia,
    PositiveMass,
    Scale,
    SignedSpeed,
    Speed,
    TorsionalDamping,
    Velocity,
    quantity,
    whole,
)

Count = Annotated[int, whole(1, 1000)]
Ratio = Annotated[float, quantity("number", 0.0, 10.0, "0 … 10")]
Isolation = Annotated[float, quantity("number", 1e-6, 0.999999, "0 … 1")]
PositiveStiffness = Annotated[float, quantity("stiffness", 1e-9)]
PositiveTorsion = Annotated[float, quantity("torsional stiffness", 1e-9)]
PositiveForce = Annotated[float, quantity("force", 1e-12)]
PositiveMoment = Annotated[float, quantity("moment", 1e-12)]
EXCITATIONS = ("force", "moment", "unbalance", "base", "mechanism")


class UnbalanceModel(Model):
    """A mass off the axis of a shaft."""

    mass: PositiveMass
    radius: Positive


class FoundationModel(Model):
    """The mass that the isolators stand on and its own springs."""

    mass: PositiveMass
    stiffness: PositiveStiffness
    damping: Damping = 0.0


class TurningFoundationModel(Model):
    """The disc that the shaft ends in and its own shaft."""

    inertia: PositiveInertia
    stiffness: PositiveTorsion
    damping: TorsionalDamping = 0.0


class AbsorberModel(Model):
    """A mass hung on the machine by springs."""

    mass: PositiveMass | None = None
    clear: tuple[Scale, Scale] | None = Field(
        default=None, description="parts of the working frequency between which no natural one may lie"
    )
    springs: Count = 1


class TurningAbsorberModel(Model):
    """A disc hung on the main one by springs."""

    inertia: PositiveInertia | None = None
    clear: tuple[Scale, Scale] | None = Field(
        default=None, description="parts of the working frequency between which no natural one may lie"
    )
    springs: Count = 1
    arm: Positive | None = Field(default=None, description="of the springs, from the axis")


class StartModel(Model):
    """How the motion begins."""

    displacement: Length = 0.0
    velocity: Velocity = 0.0


class TurningStartModel(Model):
    """How the motion begins."""

    angle: Angle = 0.0
    speed: SignedSpeed = 0.0


class Common(Model):
    """What both kinds state alike."""

    name: Label | None = Field(default=None, description="of the machine, in the heading")
    isolators: Count = Field(default=1, description="equal springs with their dampers, side by side")
    damping_ratio: Ratio | None = Field(default=None, description="in parts of the critical damping")
    transmissibility: Isolation | None = Field(
        default=None, description="force on the base by the exciting force that is wanted"
    )
    speed: Speed | None = Field(default=None, description="of the excitation", examples=["750 rpm"])
    curves: list[Ratio] = Field(
        default=list(CURVES), min_length=1, max_length=5, description="damping ratios of the curves drawn"
    )


class LinearModel(Common):
    """A machine on isolators and what shakes it."""

    mass: PositiveMass = Field(examples=["1200 kg"])
    stiffness: PositiveStiffness | None = Field(default=None, description="of each isolator")
    damping: Damping | None = Field(default=None, description="of each isolator")
    force: PositiveForce | None = Field(default=None, description="amplitude")
    unbalance: UnbalanceModel | None = None
    base: Positive | None = Field(default=None, description="amplitude of the motion of the base")
    mechanism: FixedDirection | None = Field(
        default=None, description="direction along which the shaking force of the mechanism is taken"
    )
    friction: PositiveForce | None = Field(default=None, description="dry, in place of the dampers")
    foundation: FoundationModel | None = None
    absorber: AbsorberModel | None = None
    start: StartModel = Field(default_factory=StartModel)


class TurningModel(Common):
    """A disc that swings on a shaft."""

    inertia: PositiveInertia = Field(examples=["0.12 kg*m^2"])
    stiffness: PositiveTorsion | None = Field(default=None, description="of the shaft")
    damping: TorsionalDamping | None = None
    moment: PositiveMoment | None = Field(default=None, description="amplitude")
    base: Annotated[float, quantity("angle", 1e-12)] | None = Field(
        default=None, description="amplitude of the swing of the shaft's other end"
    )
    friction: PositiveMoment | None = Field(default=None, description="dry, in place of the damper")
    foundation: TurningFoundationModel | None = None
    absorber: TurningAbsorberModel | None = None
    start: TurningStartModel = Field(default_factory=TurningStartModel)


def _kind(value: Any) -> str:
    turning = isinstance(value, dict) and "mass" not in value and ("inertia" in value or "moment" in value)
    return "<turning>" if turning or isinstance(value, TurningModel) else "<linear>"


AnyModel = Annotated[
    Annotated[LinearModel, Tag("<linear>")] | Annotated[TurningModel, Tag("<turning>")], Discriminator(_kind)
]


class Block(model.Block):
    """Vibration and its isolation."""

    ALONE = True

    vibration: AnyModel | None = Field(default=None, description="vibration and its isolation")


class Given(TypedDict):
    vibration: Stated | None


def given(read: Read) -> Given:
    written = read.block(Block).vibration
    return {"vibration": _given(written) if written else None}


def _given(written: LinearModel | TurningModel) -> Stated:
    common = {
        "isolators": written.isolators,
        "stiffness": written.stiffness,
        "damping": written.damping,
        "ratio": written.damping_ratio,
        "wanted": written.transmissibility,
        "base": written.base,
        "omega": written.speed,
        "friction": written.friction,
        "curves": tuple(written.curves),
        "name": written.name or "",
    }
    return _linear(written, common) if isinstance(written, LinearModel) else _turning(written, common)


def _linear(written: LinearModel, common: dict[str, Any]) -> Stated:
    stand, hung, off = written.foundation, written.absorber, written.unbalance
    return Stated(
        inertia=written.mass,
        force=written.force,
        unbalance=Unbalance(off.mass, off.radius) if off else None,
        direction=written.mechanism,
        foundation=Foundation(stand.mass, stand.stiffness, stand.damping) if stand else None,
        absorber=Absorber(hung.mass, hung.clear, hung.springs) if hung else None,
        place=written.start.displacement,
        speed=written.start.velocity,
        **common,
    )


def _turning(written: TurningModel, common: dict[str, Any]) -> Stated:
    stand, hung = written.foundation, written.absorber
    return Stated(
        inertia=written.inertia,
        turning=True,
        force=written.moment,
        foundation=Foundation(stand.inertia, stand.stiffness, stand.damping) if stand else None,
        absorber=Absorber(hung.inertia, hung.clear, hung.springs, hung.arm) if hung else None,
        place=written.start.angle,
        speed=written.start.speed,
        **common,
    )


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).vibration
    if written is None:
        return
    yield from _excited(written, read)
    yield from _sprung(written)
    yield from _single(written)
    if written.absorber is not None:
        yield from _hung(written.absorber)


def _excited(written: LinearModel | TurningModel, read: Read) -> Iterator[Problem]:
    """One excitation, with its frequency."""
    stated = [key for key in EXCITATIONS if getattr(written, key, None) is not None]
    start = ("displacement", "velocity") if isinstance(written, LinearModel) else ("angle", "speed")
    if not stated and any(getattr(written.start, key) for key in start):
        yield from _free(written)
        return
    if len(stated) != 1:
        words = ", ".join(key for key in EXCITATIONS if key in type(written).model_fields)
        right = Message(N_("exactly one of: %(words)s"), {"words": words})
        if not stated:
            words = f"{words}, start: {{{start[0]}: {'5 mm' if start[0] == 'displacement' else '5 deg'}}}"
            right = Message(N_("exactly one of: %(words)s"), {"words": words})
        yield mistake(N_("what shakes the machine must be stated once"), ("vibration",), right)
        return
    if stated == ["mechanism"] and not has_mechanism(read):
        right = Message(N_("describe the mechanism, or state the amplitude: force"))
        wrong = N_("there is no mechanism whose shaking force could be taken")
        yield mistake(wrong, ("vibration", "mechanism"), right)
    elif stated == ["mechanism"] and written.speed is not None:
        wrong = N_("the frequency of the shaking force is that of the driving link")
        yield mistake(wrong, ("vibration", "speed"), Message(N_("leave it out")))
    elif stated != ["mechanism"] and written.speed is None:
        right = Message(N_("for example, %(example)s"), {"example": "speed: 750 rpm"})
        yield mistake(N_("the frequency of the excitation is missing"), ("vibration",), right)


FORCED = ("speed", "transmissibility", "friction", "foundation", "absorber")


def _free(written: LinearModel | TurningModel) -> Iterator[Problem]:
    """Of a free vibration: what is followed under a force alone."""
    for key in FORCED:
        if getattr(written, key) is not None:
            words = ", ".join(one for one in EXCITATIONS if one in type(written).model_fields)
            right = Message(N_("leave it out, or state one of: %(words)s"), {"words": words})
            yield mistake(N_("nothing shakes the machine: its vibration is free"), ("vibration", key), right)


def _sprung(written: LinearModel | TurningModel) -> Iterator[Problem]:
    """A stiffness, or what it is chosen for; a damping stated once."""
    if written.stiffness is None and written.transmissibility is None:
        right = Message(N_("state stiffness, or transmissibility for which it is chosen"))
        yield mistake(N_("nothing says how stiff the isolators are"), ("vibration",), right)
    if written.damping is not None and written.damping_ratio is not None:
        right = Message(N_("damping of each isolator, or damping_ratio of the whole"))
        yield mistake(N_("the damping is stated twice"), ("vibration", "damping_ratio"), right)
    if written.stiffness is None and written.damping is not None:
        right = Message(N_("state damping_ratio"))
        wrong = N_("a stiffness to be chosen needs the damping in parts of the critical one")
        yield mistake(wrong, ("vibration", "damping"), right)


def _single(written: LinearModel | TurningModel) -> Iterator[Problem]:
    """What is followed under one sinusoidal force on the machine alone."""
    right = Message(N_("leave it out, or state the amplitude of a force on the machine"))
    if written.friction is not None and (written.base is not None or getattr(written, "mechanism", None)):
        yield mistake(
            N_("dry friction is followed under one sinusoidal force"), ("vibration", "friction"), right
        )
    if written.foundation is not None and written.base is not None:
        wrong = N_("the motion of the base is stated: it has no springs of its own")
        yield mistake(wrong, ("vibration", "foundation"), Message(N_("leave it out")))


def _hung(written: AbsorberModel | TurningAbsorberModel) -> Iterator[Problem]:
    own = written.mass if isinstance(written, AbsorberModel) else written.inertia
    if (own is None) == (written.clear is None):
        right = Message(N_("exactly one of: %(words)s"), {"words": "mass, clear"})
        if isinstance(written, TurningAbsorberModel):
            right = Message(N_("exactly one of: %(words)s"), {"words": "inertia, clear"})
        yield mistake(
            N_("the absorber's mass must follow from one statement"), ("vibration", "absorber"), right
        )
    if written.clear is not None and not written.clear[0] < 1 < written.clear[1]:
        right = Message(N_("for example, %(example)s"), {"example": "clear: [0.8, 1.2]"})
        wrong = N_("the working frequency, 1, must lie between the two parts")
        yield mistake(wrong, ("vibration", "absorber", "clear"), right)
