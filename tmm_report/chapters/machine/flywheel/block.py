"""The block `flywheel` of a variant: what its parts say wrong of one another and of the mechanism."""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.structure.block import of_friction
from tmm_report.chapters.lever.structure.block import stated as has_mechanism
from tmm_report.chapters.machine.flywheel.given import Flywheel, Inertia, Moment, Wave
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.gaps import not_all_round
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated
from tmm_report.yamlread import Path

HERE: Path = ("flywheel",)
MECHANISM = ("speed", "turns", "driving", "resisting", "areas", "punch", "inertia", "positions")


class Block(model.Block):
    """The flywheel."""

    ALONE = True

    flywheel: Stated[Flywheel] | None = Field(default=None, description="the flywheel of the machine")


class Given(TypedDict):
    flywheel: Flywheel | None


def given(read: Read) -> Given:
    return {"flywheel": read.block(Block).flywheel}


def mistakes(read: Read) -> Iterator[Problem]:
    written, mechanism = read.block(Block).flywheel, has_mechanism(read)
    if written is None:
        return
    yield from _one_of(read, ("delta", "speeds", "wheel"))
    shapes = [key for key in ("disc", "rim", "radius_of_gyration") if getattr(written, key) is not None]
    if len(shapes) > 1:
        text = N_("the wheel has several shapes: %(keys)s")
        yield mistake(text, (*HERE, shapes[1]), Message(N_("state one of them")), keys=", ".join(shapes))
    if written.wheel and written.methods:
        text = N_("a stated wheel is not sought, so that no method for it is worked out")
        yield mistake(text, (*HERE, "methods"), Message(N_("leave methods or wheel out")))
    yield from _shafts(written)
    yield from _wheels(written)
    yield from _speeds(written)
    yield from of_friction(written.friction, mechanism, (*HERE, "friction"), read)
    if mechanism:
        yield from _beside_a_mechanism(written, read)
    else:
        yield from _alone(written, read)


def _says(read: Read, key: str) -> bool:
    """Whether the block has the key, right or wrong: what is wrong in itself is said there, not that it is missing."""
    written = read.data.get("flywheel")
    return isinstance(written, Mapping) and written.get(key) is not None


def _one_of(read: Read, keys: tuple[str, ...]) -> Iterator[Problem]:
    found = [key for key in keys if _says(read, key)]
    if len(found) != 1:
        text = N_("the unevenness must be stated in one way, here in %(count)s")
        right = Message(N_("exactly one of: %(words)s"), {"words": ", ".join(keys)})
        yield mistake(text, HERE, right, count=len(found))


def _shafts(written: Flywheel) -> Iterator[Problem]:
    if written.shaft == "motor" and written.motor is None:
        text = N_("the flywheel stands on the motor's shaft, but there is no motor")
        yield mistake(text, (*HERE, "shaft"), Message(N_("state motor: {power: 5.5 kW, speed: 960 rpm}")))
    if written.shaft == "motor" and written.ratio is not None:
        text = N_("the ratio of the motor's shaft follows from the speeds of the motor and of the machine")
        yield mistake(text, (*HERE, "ratio"), Message(N_("leave ratio or shaft out")))


def _wheels(written: Flywheel) -> Iterator[Problem]:
    if (w := written.wheel) is None:
        return
    whole, parts = w.inertia is not None, [w.mass is not None, w.radius_of_gyration is not None]
    if whole == all(parts) or (any(parts) and not all(parts)):
        text = N_("the wheel is stated by its inertia, or by its mass and radius of gyration together")
        yield mistake(text, (*HERE, "wheel"), Message(N_("for example, wheel: {inertia: 12 kg*m^2}")))


def _speeds(written: Flywheel) -> Iterator[Problem]:
    if written.speeds and not written.speeds[0] < written.speeds[1]:
        text = N_("the first speed must be less than the second: the least and the greatest")
        yield mistake(text, (*HERE, "speeds"))
    if written.speeds and written.speed is not None:
        text = N_("the mean speed follows from the least and the greatest")
        yield mistake(text, (*HERE, "speed"), Message(N_("leave speed or speeds out")))


def _beside_a_mechanism(written: Flywheel, read: Read) -> Iterator[Problem]:
    for key in MECHANISM:
        if getattr(written, key) is not None:
            text = N_("%(key)s follows from the mechanism of this variant")
            yield mistake(text, (*HERE, key), Message(N_("take the key out")), key=key)
    if written.speeds:
        text = N_("the mean speed is that of the driving link: only the unevenness can be wanted")
        yield mistake(text, (*HERE, "speeds"), Message(N_("state delta in place of speeds")))
    if "loads" not in read.data:
        text = N_("without loads there is nothing for a flywheel to even out")
        yield mistake(text, HERE, Message(N_("state loads")))


def _alone(written: Flywheel, read: Read) -> Iterator[Problem]:
    if not any(_says(read, key) for key in ("speed", "speeds", "motor")):
        text = N_("the mean speed of the machine is not stated")
        yield mistake(text, HERE, Message(N_("state speed: 200 rpm")))
    moments = [key for key in ("driving", "resisting") if _says(read, key)]
    others = [key for key in ("areas", "punch") if _says(read, key)]
    if not moments and not others:
        text = N_("no moment is stated: there is nothing for a flywheel to even out")
        right = Message(N_("one of: %(words)s"), {"words": "resisting, driving, areas, punch"})
        yield mistake(text, HERE, right)
    if len(others) + bool(moments) > 1:
        text = N_("the load is stated in several ways: %(keys)s")
        keys = ", ".join([*moments, *others])
        yield mistake(text, (*HERE, others[0]), Message(N_("state one of them")), keys=keys)
    yield from _strokes(written)
    if written.areas and _varies(written.inertia):
        text = N_("areas do not say at which angle they are: the inertia must be constant with them")
        yield mistake(text, (*HERE, "inertia"))
    if written.punch and _varies(written.inertia):
        text = N_(
            "the cycle from stroke to stroke is no whole number of turns: the inertia must be constant with it"
        )
        yield mistake(text, (*HERE, "inertia", "table"))
    for key in ("driving", "resisting", "inertia"):
        if (law := getattr(written, key)) is not None:
            yield from _one_law(law, (*HERE, key), written, read)


def _varies(inertia: Inertia | None) -> bool:
    return inertia is not None and bool(inertia.table or inertia.harmonics)


def _strokes(written: Flywheel) -> Iterator[Problem]:
    if (punch := written.punch) is None:
        return
    if punch.time >= punch.period:
        text = N_("a stroke takes as long as it is from stroke to stroke: nothing is left to store energy in")
        yield mistake(text, (*HERE, "punch", "time"), Message(N_("a time less than period")))
    if written.turns is not None:
        text = N_("the cycle is from stroke to stroke: its turns follow from the speed")
        yield mistake(text, (*HERE, "turns"), Message(N_("take the key out")))


def _one_law(law: Moment | Inertia, path: Path, written: Flywheel, read: Read) -> Iterator[Problem]:
    laws = [
        law.constant is not None,
        law.table is not None,
        law.harmonics is not None or law.mean is not None,
    ]
    broken = any(wrong[: len(path)] == path for wrong in read.broken)
    if sum(laws) != 1 and not broken:
        text = N_("it must be stated by one law")
        words = "constant, table, mean + harmonics"
        yield mistake(text, path, Message(N_("exactly one of: %(words)s"), {"words": words}))
    if law.table:
        yield from _ascending(law.table, (*path, "table"), written)
    waves: Sequence[Wave] = law.harmonics or ()
    for index, one in enumerate(waves):
        turns = written.turns or 1
        if abs(one.order * turns - round(one.order * turns)) > 1e-9:
            text = N_("a harmonic of order %(order)s does not repeat with a cycle of %(turns)s turns")
            right = Message(N_("a whole number of waves in the cycle"))
            values = {"order": f"{one.order:g}", "turns": turns}
            yield mistake(text, (*path, "harmonics", index, "order"), right, **values)


def _ascending(table: list[tuple[float, float]], path: Path, written: Flywheel) -> Iterator[Problem]:
    angles = [x for x, _ in table]
    most = 2 * math.pi * (written.turns or 1)
    jumps = all(a < c for a, c in zip(angles, angles[2:], strict=False))
    if any(a > b for a, b in pairwise(angles)) or not jumps:
        yield mistake(N_("the first numbers of the pairs must ascend"), path)
    if angles[-1] > most * (1 + 1e-12):
        text = N_("the angle %(angle)s deg is beyond the cycle of %(turns)s turns")
        right = Message(N_("state turns, or angles up to %(most)s deg"), {"most": f"{math.degrees(most):g}"})
        values = {"angle": f"{math.degrees(angles[-1]):g}", "turns": written.turns or 1}
        yield mistake(text, path, right, **values)
        return
    if written.punch is None:
        turn = 2 * math.pi
        each = path[-2] == "inertia" and angles[-1] <= turn * (1 + 1e-12)  # it repeats in every turn
        yield from not_all_round(table, path, turn if each else most)
