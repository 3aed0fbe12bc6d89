"""The block `synthesis` of a variant."""

import cmath
from collections.abc import Iterator, Mapping
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.synthesis.given import (
    KINDS,
    Body,
    CrankRocker,
    Permits,
    RockerPositions,
    SliderCrank,
    SliderPositions,
    SlottedLink,
    Synthesis,
    TurningGuide,
)
from tmm_report.chapters.lever.synthesis.refused import mm
from tmm_report.chapters.lever.synthesis.solve import design, offered
from tmm_report.mechanics.lever.stated_masses import Synthesised
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.text import for_example
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated
from tmm_report.yamlread import Path

PATH: Path = ("synthesis",)


class Block(model.Block):
    """Synthesis of a linkage from what is asked of its motion."""

    ALONE = True

    synthesis: Stated[Synthesis] | None = Field(
        default=None, description="lengths of a linkage from what is asked of its motion"
    )


class Taken(TypedDict):
    synthesis: Synthesis | None


def given(read: Read) -> Taken:
    return {"synthesis": read.block(Block).synthesis}


def numbers(read: Read) -> Mapping[str, Synthesised] | None:
    """What the mechanism may take, by the names after `synthesis.`, None where there is no synthesis, nothing
    where it has mistakes."""
    if "synthesis" not in read.data:
        return None
    written = read.block(Block).synthesis
    if written is None or read.is_broken("synthesis") or any(_clashes(written)):
        return {}
    try:
        return offered(design(written))
    except ProblemError:
        return {}


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).synthesis
    if written is None or read.is_broken("synthesis"):
        return
    if clashes := [*_clashes(written)]:
        yield from clashes
        return
    try:
        design(written)
    except ProblemError as error:
        yield from error.problems


def _clashes(written: Synthesis) -> Iterator[Problem]:
    """What is stated twice, or not at all."""
    if len(written.stated) != 1:
        right = Message(N_("exactly one of: %(words)s"), {"words": ", ".join(KINDS)})
        yield mistake(N_("the kind of the linkage must be stated by one key"), PATH, right)
        return
    asked = written.asked
    if isinstance(asked, Permits) and None not in (asked.pressure_angle, asked.transmission):
        wrong = N_("the pressure angle and the transmission angle make 90° together: one of them is stated")
        yield mistake(wrong, (*PATH, written.kind, "transmission"), Message(N_("leave one of the two")))
    match asked:
        case SliderCrank():
            yield from _of_slider_crank(asked)
        case CrankRocker():
            yield from _once(asked, ("crank", "rod", "frame"), "crank_rocker", at_most=True)
            if asked.K == 1 and asked.crank is not None:
                right = Message(N_("leave it out, or state rod or frame"))
                wrong = N_("with equal strokes the crank is half the chord of the swing: it follows")
                yield mistake(wrong, (*PATH, "crank_rocker", "crank"), right)
            if abs((asked.crank_at.conjugate() * 1j * cmath.rect(1.0, asked.middle)).real) < 1e-9:
                right = Message(N_("a side across the middle position"))
                wrong = N_("the rocker itself lies that way in the middle of its swing")
                yield mistake(wrong, (*PATH, "crank_rocker", "crank_at"), right)
        case SlottedLink() | TurningGuide():
            kind = written.kind
            if isinstance(asked, SlottedLink):
                yield from _of_slotted_link(asked)
            else:
                yield from _once(asked, ("frame", "crank"), kind)
            yield from _once(asked, ("rod", "rod_ratio"), kind, at_most=asked.permitted is not None)
            if asked.K == 1:
                wrong = N_("a slotted link has strokes of different times: K is greater than 1")
                right = Message(N_("for example, %(example)s"), {"example": "K: 1.5"})
                yield mistake(wrong, (*PATH, kind, "K"), right)
        case Body():
            yield from _of_body(asked)
        case RockerPositions():
            needed = "rocker" if asked.crank_angles is None else "frame"
            if getattr(asked, needed) is None:
                path = (*PATH, "rocker_positions", needed)
                right = for_example(f"{needed}: 300 mm")
                yield mistake(N_("the key %(key)s is missing"), path, right, key=needed)
            yield from _apart(asked.angles, (*PATH, "rocker_positions", "angles"))
        case SliderPositions():
            yield from _apart(asked.places, (*PATH, "slider_positions", "places"))
            if asked.offset is not None and asked.offset < 0 and asked.crank_angles is None:
                path = (*PATH, "slider_positions", "offset")
                right = Message(N_("its size: the extreme places are the same on either side"))
                yield mistake(N_("of extreme places the offset is not below zero"), path, right)


def _apart(both: list[float], path: Path) -> Iterator[Problem]:
    if both[0] == both[1]:
        yield mistake(N_("both positions are one"), path, Message(N_("two different ones")))


def _of_slotted_link(asked: SlottedLink) -> Iterator[Problem]:
    """Its swing is stated by the time ratio, by itself, or by the crank and the distance of the pivots."""
    path = (*PATH, "slotted_link")
    stated = [key for key in ("K", "swing") if getattr(asked, key) is not None]
    lengths = [key for key in ("frame", "crank") if getattr(asked, key) is not None]
    if len(stated) == 1:
        yield from _once(asked, ("frame", "crank"), "slotted_link")
    elif stated or len(lengths) < 2:
        wrong = N_("crank, distance between the pivots and swing follow from two of them")
        right = Message(N_("K or swing, with crank or frame; or crank and frame"))
        yield mistake(wrong, path, right)
    elif (asked.crank or 0.0) >= (asked.frame or 0.0):
        wrong = N_("with so long a crank the slotted link turns all round: turning_guide is such a mechanism")
        yield mistake(
            wrong, (*path, "crank"), Message(N_("less than %(limit)s"), {"limit": mm(asked.frame or 0.0)})
        )


def _of_body(asked: Body) -> Iterator[Problem]:
    path = (*PATH, "body")
    two = len(asked.positions) == 2
    if two and asked.crank is None:
        right = for_example("crank: 100 mm")
        yield mistake(N_("two positions leave both pivots free: the crank must be stated"), path, right)
    for key in ("crank", "rocker", "crank_pivot", "rocker_pivot"):
        if not two and getattr(asked, key) is not None:
            wrong = N_("three positions determine the linkage: this follows")
            yield mistake(wrong, (*path, key), Message(N_("leave it out, or state two positions")))


def _once(asked: object, keys: tuple[str, ...], kind: str, at_most: bool = False) -> Iterator[Problem]:
    stated = [key for key in keys if getattr(asked, key) is not None]
    if len(stated) > 1 or (not stated and not at_most):
        right = Message(N_("exactly one of: %(words)s"), {"words": ", ".join(keys)})
        wrong = N_("a length of the linkage must be stated once")
        yield mistake(wrong, (*PATH, kind, *stated[1:2]), right)


def _of_slider_crank(asked: SliderCrank) -> Iterator[Problem]:
    path = (*PATH, "slider_crank")
    right = Message(
        N_(
            "stroke, alone or with mean_speed, which give the speed; or mean_speed: 0.8 m/s and speed: 120 rpm"
        )
    )
    if asked.stroke is None and asked.mean_speed is None:
        yield mistake(N_("the stroke must be stated once"), path, right)
    elif asked.stroke is None and asked.speed is None:
        yield mistake(N_("the mean speed and the speed of the crank go together"), path, right)
    elif asked.stroke is not None and asked.speed is not None:
        wrong = N_("of the stroke, the mean speed and the speed of the crank one follows from the two others")
        yield mistake(wrong, (*path, "speed"), right)
    if asked.offset is not None and asked.offset_ratio is not None:
        yield mistake(N_("the offset is stated twice"), (*path, "offset_ratio"), Message(N_("leave it out")))
    if asked.K > 1:
        if asked.offset_ratio is not None:
            wrong = N_("the time ratio follows from the ratios of the sides")
            yield mistake(wrong, (*path, "K"), Message(N_("leave out K, or offset_ratio")))
        elif asked.offset is not None and asked.ratio is not None:
            wrong = N_("stroke, time ratio and offset determine the linkage: its ratio follows")
            yield mistake(wrong, (*path, "ratio"), Message(N_("leave it out")))
    elif asked.ratio is None and (asked.permitted is None or asked.offset or asked.offset_ratio):
        right = Message(N_("ratio: 4, or pressure_angle: 12 deg of a slider in line with the crank"))
        yield mistake(N_("nothing says how long the rod is"), path, right)
