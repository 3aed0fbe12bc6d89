"""The block `vibration` of a variant."""

from collections.abc import Iterator, Mapping
from dataclasses import fields
from typing import Annotated, Any, ClassVar, TypedDict

from pydantic import Discriminator, Field, Tag

from tmm_report.chapters.lever.structure.block import stated as has_mechanism
from tmm_report.chapters.machine.vibration.given import (
    WHIRLS,
    Absorber,
    Given,
    Linear,
    Turning,
    TurningAbsorber,
)
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.quantity.text import for_example
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated

EXCITATIONS = ("force", "moment", "unbalance", "base", "mechanism")
FIELDS = {kind: [field.name for field in fields(kind)] for kind in (Linear, Turning)}


def _kind(value: Any) -> str:
    turning = isinstance(value, dict) and "mass" not in value and ("inertia" in value or "moment" in value)
    return "<turning>" if turning or isinstance(value, Turning) else "<linear>"


Either = Annotated[
    Annotated[Stated[Linear], Tag("<linear>")] | Annotated[Stated[Turning], Tag("<turning>")],
    Discriminator(_kind),
]


class Block(model.Block):
    """Vibration and its isolation."""

    ALONE = True
    NOT_OFFERED: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("critical_speed", "whirling", "whirl", "jeffcott", "критическая_скорость"), WHIRLS
    )

    vibration: Either | None = Field(default=None, description="vibration and its isolation")


class Taken(TypedDict):
    vibration: Given | None


def given(read: Read) -> Taken:
    return {"vibration": read.block(Block).vibration}


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).vibration
    if written is None:
        return
    yield from _excited(written, read)
    yield from _sprung(written)
    yield from _single(written)
    if written.absorber is not None:
        yield from _hung(written.absorber)


def _excited(written: Given, read: Read) -> Iterator[Problem]:
    """One excitation, with its frequency."""
    stated = [key for key in EXCITATIONS if getattr(written, key, None) is not None]
    start = ("displacement", "velocity") if isinstance(written, Linear) else ("angle", "speed")
    if not stated and any(getattr(written.start, key) for key in start):
        yield from _free(written)
        return
    if len(stated) != 1:
        words = ", ".join(key for key in EXCITATIONS if key in FIELDS[type(written)])
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
        right = for_example("speed: 750 rpm")
        yield mistake(N_("the frequency of the excitation is missing"), ("vibration",), right)


FORCED = ("speed", "transmissibility", "friction", "foundation", "absorber")


def _free(written: Given) -> Iterator[Problem]:
    """Of a free vibration: what is followed under a force alone."""
    for key in FORCED:
        if getattr(written, key) is not None:
            words = ", ".join(one for one in EXCITATIONS if one in FIELDS[type(written)])
            right = Message(N_("leave it out, or state one of: %(words)s"), {"words": words})
            yield mistake(N_("nothing shakes the machine: its vibration is free"), ("vibration", key), right)


def _sprung(written: Given) -> Iterator[Problem]:
    """A stiffness, or what it is chosen for; a damping stated once."""
    deflection = written.deflection
    if deflection is not None and written.stiffness is not None:
        right = Message(N_("one of them: the other follows"))
        yield mistake(
            N_("the stiffness and the deflection are both stated"), ("vibration", "deflection"), right
        )
    if written.stiffness is None and written.transmissibility is None and deflection is None:
        right = Message(N_("state stiffness, or transmissibility for which it is chosen"))
        yield mistake(N_("nothing says how stiff the isolators are"), ("vibration",), right)
    if written.damping is not None and written.damping_ratio is not None:
        right = Message(N_("damping of each isolator, or damping_ratio of the whole"))
        yield mistake(N_("the damping is stated twice"), ("vibration", "damping_ratio"), right)
    if written.stiffness is None and deflection is None and written.damping is not None:
        right = Message(N_("state damping_ratio"))
        wrong = N_("a stiffness to be chosen needs the damping in parts of the critical one")
        yield mistake(wrong, ("vibration", "damping"), right)


def _single(written: Given) -> Iterator[Problem]:
    """What is followed under one sinusoidal force on the machine alone."""
    right = Message(N_("leave it out, or state the amplitude of a force on the machine"))
    if written.friction is not None and (written.base is not None or getattr(written, "mechanism", None)):
        yield mistake(
            N_("dry friction is followed under one sinusoidal force"), ("vibration", "friction"), right
        )
    if written.foundation is not None and written.base is not None:
        wrong = N_("the motion of the base is stated: it has no springs of its own")
        yield mistake(wrong, ("vibration", "foundation"), Message(N_("leave it out")))


def _hung(written: Absorber | TurningAbsorber) -> Iterator[Problem]:
    if (written.inertia is None) == (written.clear is None):
        right = Message(N_("exactly one of: %(words)s"), {"words": "mass, clear"})
        if isinstance(written, TurningAbsorber):
            right = Message(N_("exactly one of: %(words)s"), {"words": "inertia, clear"})
        yield mistake(
            N_("the absorber's mass must follow from one statement"), ("vibration", "absorber"), right
        )
    if written.clear is not None and not written.clear[0] < 1 < written.clear[1]:
        right = Message(N_("for example, %(example)s"), {"example": "clear: [0.8, 1.2]"})
        wrong = N_("the working frequency, 1, must lie between the two parts")
        yield mistake(wrong, ("vibration", "absorber", "clear"), right)
