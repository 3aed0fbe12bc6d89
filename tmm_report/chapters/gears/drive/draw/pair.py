"""A pair with fixed axes in the kinematic scheme of a drive."""

from __future__ import annotations

from tmm_report.chapters.gears.drive.draw.sketch import CLEAR, DISC, RIM, SIDE, Sketch
from tmm_report.chapters.gears.drive.stages import member
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.figures.drawing import THICK, line
from tmm_report.mechanics.gears.trains import Member


def pair(sketch: Sketch, stage: spur.Found) -> float:
    """The pair drawn; gives where the input shaft ends and leaves `sketch.x` where the stage does."""
    entry, out = member(stage, stage.input), member(stage, stage.output)
    x = sketch.x + (DISC if entry.kind == "ring" else RIM) + SIDE
    start, end = (wheel(sketch, one, x, side) for one, side in ((entry, -1), (out, 1)))
    sketch.x = x + (DISC if out.kind == "ring" else RIM) + SIDE
    sketch.shaft(end, sketch.x, sketch.y(out))
    return start


def wheel(sketch: Sketch, one: Member, x: float, side: int) -> float:
    """A wheel, or a ring open on one side, with both halves; gives where its web stands on the shaft."""
    y, r = sketch.y(one), sketch.radius(one)
    ring = one.kind == "ring"
    half, web = (r + CLEAR, x + side * DISC) if ring else (r - CLEAR, x)
    for up in (half, -half):
        if ring:
            sketch.items.append(line(complex(x - side * RIM, y + up), complex(web, y + up), THICK))
        else:
            sketch.rim(x, y + up)
    sketch.mark(x, y, half, one.name)
    sketch.web(web, y - half, y + half)
    sketch.cross(web, y)
    away = 1 if y + half > 0 and not ring else -1
    sketch.name(one.name, complex(x + (RIM if not ring else 0), y + away * half), complex(1, away))
    return web
