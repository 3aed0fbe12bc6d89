"""What the parts of the block `dynamics` say wrong of one another and of the mechanism."""

import math
from collections.abc import Iterator
from itertools import pairwise

from tmm_report.chapters.lever.kinematics.block import turns_of
from tmm_report.chapters.lever.kinetostatics.block.tied import of_torsion
from tmm_report.chapters.lever.structure.block import names, no_point, of_friction, stated
from tmm_report.chapters.machine.dynamics.block.models import DynamicsModel, PartModel
from tmm_report.chapters.machine.dynamics.block.motors import MotorModel, ResistanceModel
from tmm_report.chapters.machine.dynamics.given import Spring
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.quantity.text import number
from tmm_report.variant.gaps import not_all_round
from tmm_report.variant.model import Read
from tmm_report.yamlread import Path

Curve = tuple[Path, list[tuple[float, float]] | None]


def check(written: DynamicsModel, read: Read) -> Iterator[Problem]:
    alone = not stated(read)
    if alone and not read.is_broken("dynamics"):
        yield from _of_a_machine_alone(written)
    if not alone:
        yield from _of_a_mechanism(written)
    yield from of_friction(written.friction, not alone, ("dynamics", "friction"), read)
    for index, part in enumerate(written.parts):
        yield from _of_part(part, ("dynamics", "parts", index), written)
    for index, spring in enumerate(written.springs):
        yield from _of_spring(spring, ("dynamics", "springs", index), read, alone)
    yield from _of_torsions(written, read, alone)
    yield from _of_regimes(written)
    yield from _of_curves(written)
    turn = 2 * math.pi * (1 if alone else turns_of(read))
    yield from _of_angles(written, (alone and written.period) or turn)


def _of_a_machine_alone(written: DynamicsModel) -> Iterator[Problem]:
    heavy = any(
        part.turned or (part.carried and (part.velocity or part.radius or part.offset))
        for part in written.parts
    )
    if not heavy and not written.varying_inertia:
        right = Message(N_("state inertia or mass of the parts"))
        yield mistake(N_("nothing in the machine has a moment of inertia or a mass"), ("dynamics",), right)
    if not (written.motor or written.parts or written.resistance or written.springs):
        right = Message(N_("state a motor, parts with moments or weights, or a resistance"))
        yield mistake(N_("nothing acts on the machine"), ("dynamics",), right)


def _of_a_mechanism(written: DynamicsModel) -> Iterator[Problem]:
    """Keys of a machine alone."""
    for key in ("period", "varying_inertia"):
        if getattr(written, key) is not None:
            text = N_("the cycle and the moment of inertia are those of the mechanism")
            yield mistake(text, ("dynamics", key), Message(N_("leave the key out")))


def _of_part(part: PartModel, path: Path, written: DynamicsModel) -> Iterator[Problem]:
    if part.on and written.motor is None:
        yield mistake(
            N_("there is no motor on whose shaft it could be"), (*path, "on"), Message(N_("state the motor"))
        )
    elif part.on and ("ratio" in part.model_fields_set or part.offset):
        right = Message(N_("leave out ratio and offset"))
        yield mistake(N_("the shaft of the motor has the ratio of the motor"), (*path, "on"), right)
    ways = sum(x is not None for x in (part.velocity, part.radius)) + bool(part.offset)
    if part.radius_of_gyration is not None and not (part.mass and not part.inertia and not ways):
        text = N_(
            "a radius of gyration goes with the mass of what turns on this shaft, and with nothing else"
        )
        right = Message(N_("mass: 60 kg, radius_of_gyration: 200 mm; what moves along is a part of its own"))
        yield mistake(text, (*path, "radius_of_gyration"), right)
    elif (part.carried or part.force) and ways != 1:
        right = Message(N_("exactly one of: %(words)s"), {"words": "velocity, radius, offset"})
        yield mistake(N_("it is not said how the mass moves with the main shaft"), path, right)
    if part.velocity is not None and written.speed is None:
        right = Message(N_("state speed of the main shaft in the block dynamics"))
        yield mistake(
            N_("the velocity is stated for an unknown speed of the main shaft"), (*path, "velocity"), right
        )
    if part.offset and (part.ratio != 1 or part.moves != "level"):
        right = Message(N_("leave out ratio and moves"))
        yield mistake(N_("an offset mass turns with the main shaft itself"), (*path, "offset"), right)
    if part.ratio == 0 and (part.turned or part.moment or part.radius):
        yield mistake(N_("a shaft that stands still has no part in the motion"), (*path, "ratio"))


def _of_spring(spring: Spring, path: Path, read: Read, alone: bool) -> Iterator[Problem]:
    pin, point = (
        spring.radius is not None and spring.apart is not None,
        spring.at is not None and spring.to is not None,
    )
    if pin == point or (point and alone):
        right = Message(
            N_("at and to of a point of the mechanism, or radius and apart of a pin of the main shaft")
        )
        yield mistake(N_("it is not said where the spring is fixed"), path, right)
    elif point:
        yield from no_point(str(spring.at), (*path, "at"), names(read.data))


def _of_torsions(written: DynamicsModel, read: Read, alone: bool) -> Iterator[Problem]:
    for index, spring in enumerate(written.torsion_springs):
        path = ("dynamics", "torsion_springs", index)
        if alone:
            text = N_("a torsion spring turns links of a mechanism against one another, and there is none")
            right = Message(N_("a mechanism, or the moment of the spring by_angle under resistance"))
            yield mistake(text, path, right)
        else:
            yield from of_torsion(spring, path, names(read.data))


def _of_regimes(written: DynamicsModel) -> Iterator[Problem]:
    start, coast = written.start, written.coast
    if start and sum(x is not None for x in (start.speed, start.time, start.angle)) > 1:
        right = Message(N_("at most one of: %(words)s"), {"words": "speed, time, angle"})
        yield mistake(N_("the end of the start-up is stated twice"), ("dynamics", "start"), right)
    if coast and coast.begin is not None and coast.speed >= coast.begin:
        right = Message(N_("a speed below that at the beginning"))
        yield mistake(
            N_("the machine is to coast to a speed that is not lower"), ("dynamics", "coast", "speed"), right
        )
    for key, regime in (("start", start), ("coast", coast)):
        if regime and regime.motor == "reversed" and written.motor is None:
            right = Message(N_("state the motor"))
            yield mistake(N_("there is no motor to reverse"), ("dynamics", key, "motor"), right)


def _of_curves(written: DynamicsModel) -> Iterator[Problem]:
    """The points of tables ascend; two of the same time are a jump."""
    curves: list[Curve] = [(("varying_inertia",), written.varying_inertia)]
    for path, laws in _laws(written):
        curves += [((*path, "by_speed"), laws.by_speed), ((*path, "by_time"), laws.by_time)]
    for where, pairs in curves:
        firsts = [x for x, _ in pairs or ()]
        twice = where[-1] == "by_time"  # two values at one time are a jump
        falls = any(a > b if twice else a >= b for a, b in pairwise(firsts))
        if falls or any(a >= b for a, b in zip(firsts, firsts[2:], strict=False)):
            yield mistake(N_("the first numbers of the pairs must ascend"), ("dynamics", *where))


def _laws(written: DynamicsModel) -> Iterator[tuple[Path, MotorModel | ResistanceModel]]:
    if written.motor is not None:
        yield ("motor",), written.motor
    yield from ((("resistance", k), one) for k, one in enumerate(written.resistance))


def _of_angles(written: DynamicsModel, period: float) -> Iterator[Problem]:
    """Points by angle lie within one cycle; two of the same angle are a jump of a moment, which an inertia has not."""
    curves: list[Curve] = [((*path, "by_angle"), laws.by_angle) for path, laws in _laws(written)]
    inertias = written.varying_inertia
    for where, pairs in [(("varying_inertia",), inertias), *curves]:
        if not pairs:
            continue
        long = pairs[-1][0] - pairs[0][0] - period
        if pairs is not inertias and any(a > b for (a, _), (b, _) in pairwise(pairs)):
            yield mistake(N_("the first numbers of the pairs must ascend"), ("dynamics", *where))
        elif long > 1e-9 * period:
            text = N_("the points reach over more than one cycle, which is %(angle)s degrees")
            yield mistake(text, ("dynamics", *where), angle=number(math.degrees(period), 6, "."))
        elif pairs is inertias and long > -1e-9 * period and pairs[-1][1] != pairs[0][1]:
            right = Message(N_("the same moment of inertia at the end of the cycle as at its beginning"))
            yield mistake(N_("the moment of inertia jumps from cycle to cycle"), ("dynamics", *where), right)
        else:
            yield from not_all_round(pairs, ("dynamics", *where), period)
