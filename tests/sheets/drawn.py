"""Sheets of shipped variants, and what is measured on them from their lines alone."""

from __future__ import annotations

from functools import cache
from itertools import chain

from conftest import solved

from tmm_report import sheets
from tmm_report.commands.files import translator
from tmm_report.figures.primitives import Box
from tmm_report.figures.sheets.sheet import Block, Sheet

# of all five kinds, of several sheets, alone, without a lever mechanism
VARIANTS = (
    "compressor",
    "hoist_drive",
    "cam_press",
    "engine_balance",
    "shaper_project",
    "valve_cam",
    "rotor",
)


@cache
def sheets_of(name: str) -> tuple[Sheet, ...]:
    results = solved(name)
    return tuple(sheets.composed(results, translator(results.variant)))


@cache
def files_of(name: str) -> dict[str, bytes]:
    results = solved(name)
    return sheets.render(results, translator(results.variant))


def ink(block: Block) -> Box:
    """What the lines of a picture and of its letters take, by all of their points."""
    strokes = chain.from_iterable(item.outline() for item in block.items)
    letters = chain.from_iterable(one.path.strokes for one in block.letters)
    points = list(chain.from_iterable(chain(strokes, letters)))
    x, y = [z.real for z in points], [z.imag for z in points]
    return min(x), min(y), max(x), max(y)


def said(block: Block) -> str:
    """A title on one line; of a symbol its letters alone."""
    words = (
        "".join(one if isinstance(one, str) else f"{one.base}_{one.sub}" for one in word)
        for word in block.title
    )
    return " ".join(words)
