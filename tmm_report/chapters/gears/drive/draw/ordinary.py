"""Ordinary stages in the kinematic scheme of a drive (GOST 2.770): belts, chains, friction wheels, trains."""

from __future__ import annotations

from tmm_report.chapters.gears.drive.draw.crossing import crossing
from tmm_report.chapters.gears.drive.draw.pair import wheel
from tmm_report.chapters.gears.drive.draw.sketch import DISC, RIM, SIDE, Sketch
from tmm_report.chapters.gears.drive.stages import member
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.figures.drawing import DASHED, NORMAL, THICK, line
from tmm_report.mechanics.gears.trains import Member

STRAND = 1.6  # half the width of a belt as it is drawn between the pulleys
FACE = 2.6  # half the length of a friction wheel and of a pulley


def ordinary(sketch: Sketch, stage: Found) -> float:
    """The stage drawn; gives where the input shaft ends and leaves `sketch.x` where the stage does."""
    if stage.meshes[0].crosses:
        return crossing(sketch, stage)
    entry, out = member(stage, stage.input), member(stage, stage.output)
    x = sketch.x + (DISC if entry.kind == "ring" else RIM) + SIDE
    end = x
    match stage.kind:
        case "train" | "pair":
            end = _train(sketch, stage, x)
        case "friction":
            for one in (entry, out):
                end = _roller(sketch, one, x, 1 if one is out else -1)
        case _:  # a belt, a chain
            for one in (entry, out):
                _pulley(sketch, one, x)
            _strands(sketch, entry, out, x, stage)
    start = x - DISC if entry.kind == "ring" else x
    sketch.x = x + (DISC if out.kind == "ring" else RIM) + SIDE
    sketch.shaft(end, sketch.x, sketch.y(out))
    return start


def _pulley(sketch: Sketch, one: Member, x: float) -> None:
    """Its outline, a cross where it sits fast on its shaft."""
    y, half = sketch.y(one), sketch.radius(one)
    for edge in (y + half, y - half):
        sketch.rim(x, edge, FACE)
    for side in (-FACE, FACE):
        sketch.items.append(line(complex(x + side, y - half), complex(x + side, y + half), NORMAL))
    sketch.mark(x, y, half, one.name, FACE)
    sketch.cross(x, y)
    _named(sketch, one, x + FACE, y, half)


def _named(sketch: Sketch, one: Member, x: float, y: float, half: float) -> None:
    away = 1 if y >= 0 else -1
    sketch.name(one.name, complex(x, y + away * half), complex(1, away))


def _strands(sketch: Sketch, entry: Member, out: Member, x: float, stage: Found) -> None:
    """Both strands from the far side of one pulley to that of the other, past their faces; a crossed belt crosses, a
    chain is dashed."""
    top, bottom = sorted((entry, out), key=sketch.y, reverse=True)
    start, end = sketch.y(top) - sketch.radius(top), sketch.y(bottom) + sketch.radius(bottom)
    pen = DASHED if stage.kind == "chain" else NORMAL
    for side in (-STRAND, STRAND):
        foot = complex(x - side if stage.given.sense < 0 else x + side, end)
        sketch.items.append(line(complex(x + side, start), foot, pen))


def _roller(sketch: Sketch, one: Member, x: float, side: int) -> float:
    """A smooth wheel, or a ring open on one side; gives where it sits on its shaft."""
    if one.kind == "ring":
        return wheel(sketch, one, x, side)
    _pulley(sketch, one, x)
    return x


def _train(sketch: Sketch, stage: Found, x: float) -> float:
    """The wheels one below the other, the idlers on pins in the frame; gives where the last sits on its shaft."""
    end = x
    for one in stage.members:
        end = wheel(sketch, one, x, 1)
        if one.name not in (stage.input, stage.output):
            y = sketch.y(one)
            sketch.items.append(line(complex(x - RIM - 3, y), complex(x + RIM + 3, y), THICK))
            sketch.bearing(x - RIM - 1.5, y)
            sketch.bearing(x + RIM + 1.5, y)
    return end
