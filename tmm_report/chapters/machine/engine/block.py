"""The block `engine` of a variant."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.machine.engine.given import Engine
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated

PATH = ("engine",)
LAYOUTS = ("cylinders", "inline", "vee", "opposed", "radial")
LONGEST = 0.9  # the largest r/l that is solved


class Block(model.Block):
    """Balance of an engine of several cylinders."""

    ALONE = True

    engine: Stated[Engine] | None = Field(
        default=None, description="balance of an engine of several cylinders"
    )


class Taken(TypedDict):
    engine: Engine | None


def given(read: Read) -> Taken:
    return {"engine": read.block(Block).engine}


# --- mistakes


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).engine
    if written is None:
        return
    # what is wrong in itself is missing here: nothing is said of what belongs with it
    broken = {path[1] for path in read.broken if path[:1] == PATH and len(path) > 1}
    laid = not broken.intersection(LAYOUTS)
    if laid:
        yield from _layout(written)
    yield from _sizes(written)
    if "counterweights" not in broken:
        yield from _counterweights(written)
    if laid and "firing" not in broken:
        yield from _firing(written)


def _layout(written: Engine) -> Iterator[Problem]:
    stated = [key for key in LAYOUTS if getattr(written, key) is not None]
    if len(stated) != 1:
        text = N_("the layout of the cylinders must be stated by one key")
        yield mistake(text, PATH, Message(N_("exactly one of: %(words)s"), {"words": ", ".join(LAYOUTS)}))
    names = [one.name for one in written.laid]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield mistake(N_("two cylinders are named %(name)s"), (*PATH, "cylinders"), name=name)


def _sizes(written: Engine) -> Iterator[Problem]:
    if written.crank_radius > LONGEST * written.rod_length:
        text = N_(
            "the connecting rod is too short: with the crank radius at %(ratio)s of it the crank hardly turns over"
        )
        ratio = f"{written.crank_radius / written.rod_length:.3g}"
        right = Message(
            N_("a connecting rod at least %(least)s mm long"),
            {"least": f"{1e3 * written.crank_radius / LONGEST:.4g}"},
        )
        yield mistake(text, (*PATH, "rod_length"), right, ratio=ratio)
    if written.rod and written.rod.centre > written.rod_length:
        text = N_("the mass centre of the connecting rod lies beyond its piston pin")
        right = Message(N_("a distance from the crankpin up to the length of the rod"))
        yield mistake(text, (*PATH, "rod", "centre"), right)


def _counterweights(written: Engine) -> Iterator[Problem]:
    weight = written.counterweights
    if weight is None:
        return
    stated = sum(one is not None for one in (weight.share, weight.radius, weight.mass))
    if stated != 2:
        text = N_("of a counterweight two of share, radius and mass are stated, the third is found")
        yield mistake(text, (*PATH, "counterweights"), Message(N_("share: 0.5, radius: 60 mm")))


def _firing(written: Engine) -> Iterator[Problem]:
    names = {one.name for one in written.laid}
    order = written.firing
    if order is not None and names and sorted(order) != sorted(names):
        text = N_("the order of firing must name every cylinder once")
        right = Message(
            N_("the cylinders are %(names)s"), {"names": ", ".join(sorted(names, key=lambda n: (len(n), n)))}
        )
        yield mistake(text, (*PATH, "firing"), right)
