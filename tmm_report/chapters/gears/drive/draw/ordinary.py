"""Ordinary stages in the kinematic scheme of a drive (GOST 2.770): belts."""

from __future__ import annotations

from tmm_report.chapters.gears.drive.draw.sketch import RIM, SIDE, Sketch
from tmm_report.chapters.gears.drive.stages import member
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.figures.drawing import NORMAL, line
from tmm_report.mechanics.gears.trains import Member

STRAND = 1.6  # half the width of the belt as it is drawn between the pulleys


def ordinary(sketch: Sketch, stage: Found) -> float:
    """The stage drawn; gives where the input shaft ends and leaves `sketch.x` where the stage does."""
    entry, out = member(stage, stage.input), member(stage, stage.output)
    x = sketch.x + RIM + SIDE
    for wheel in (entry, out):
        _pulley(sketch, wheel, x)
    _belt(sketch, entry, out, x, stage.given.sense < 0)
    sketch.x = x + RIM + SIDE
    sketch.shaft(x, sketch.x, sketch.y(out))
    return x


def _pulley(sketch: Sketch, wheel: Member, x: float) -> None:
    """Its rims above and below its shaft, its web, a cross where it sits fast."""
    y, half = sketch.y(wheel), sketch.radius(wheel)
    for edge in (y + half, y - half):
        sketch.rim(x, edge)
    for side in (-RIM, RIM):
        sketch.items.append(line(complex(x + side, y - half), complex(x + side, y + half), NORMAL))
    sketch.cross(x, y)
    sketch.name(
        wheel.name, complex(x + RIM, y + (half if y >= 0 else -half)), complex(1, 1 if y >= 0 else -1)
    )


def _belt(sketch: Sketch, entry: Member, out: Member, x: float, crossed: bool) -> None:
    """Both strands from the far side of one pulley to that of the other, past their faces; a crossed belt crosses."""
    top, bottom = sorted((sketch.y(entry), sketch.y(out)), reverse=True)
    tall = {sketch.y(wheel): sketch.radius(wheel) for wheel in (entry, out)}
    start, end = top - tall[top], bottom + tall[bottom]
    for side in (-STRAND, STRAND):
        foot = complex(x - side if crossed else x + side, end)
        sketch.items.append(line(complex(x + side, start), foot, NORMAL))
