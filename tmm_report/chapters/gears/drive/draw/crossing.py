"""Stages whose axes cross in the kinematic scheme of a drive (GOST 2.770): in the plane of the driving shaft, then,
beside it, the driven wheel with its axis turned parallel to that shaft, as the rest of the drive is drawn."""

from __future__ import annotations

import cmath
import math

from tmm_report.chapters.gears.drive.draw.pair import wheel
from tmm_report.chapters.gears.drive.draw.sketch import CLEAR, RIM, SIDE, Sketch
from tmm_report.chapters.gears.drive.stages import member
from tmm_report.chapters.gears.ordinary.given import WormStage
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.figures.drawing import AXIS, NORMAL, Circle, Moving, dot, line
from tmm_report.figures.schemes.crossed_axes import cone, thread
from tmm_report.figures.schemes.marks import MARK, going_round, spot, turning
from tmm_report.mechanics.gears.trains import Member

BESIDE = 8.0  # mm between the two views
BEHIND = 9.0  # of the driven shaft behind a bevel wheel
WORM = 8.0  # half the length of a worm
ROOM = 9.0  # of the worm's shaft beside it


def crossing(sketch: Sketch, stage: Found) -> float:
    """The stage drawn; gives where the input shaft ends and leaves `sketch.x` where the stage does."""
    entry, out = member(stage, stage.input), member(stage, stage.output)
    end = (
        _worm(sketch, stage, entry, out)
        if isinstance(stage.given, WormStage)
        else _cones(sketch, stage, entry)
    )
    x = sketch.x + BESIDE + RIM + SIDE
    if isinstance(stage.given, WormStage):
        sketch.items.append(
            Circle(complex(x, sketch.y(entry)), max(sketch.radius(entry) - CLEAR, 0.5), NORMAL)
        )
        sketch.items.append(line(complex(sketch.x, sketch.y(out)), complex(x, sketch.y(out)), AXIS))
    wheel(sketch, out, x, 1)
    sketch.x = x + RIM + SIDE
    sketch.shaft(x, sketch.x, sketch.y(out))
    return end


def _worm(sketch: Sketch, stage: Found, entry: Member, out: Member) -> float:
    """From the side of the wheel, which is a circle; gives where the worm's shaft ends."""
    assert isinstance(stage.given, WormStage)
    around, y = sketch.radius(out), sketch.y(entry)
    x = sketch.x + SIDE + max(around, WORM + ROOM)
    sketch.items += thread(
        complex(x, y), WORM, max(sketch.radius(entry) - CLEAR, 1.0), stage.given.hand == "right"
    )
    centre = complex(x, sketch.y(out))
    sketch.items += [Circle(centre, max(around - CLEAR, 0.5), NORMAL), dot(centre)]
    sketch.bearing(x + WORM + ROOM / 2, y)
    sketch.shaft(x + WORM, x + WORM + ROOM, y)
    sketch.shaft(x - WORM - ROOM, x - WORM, y)
    if around > 5:
        turns = -stage.given.sense if sketch.speed[entry.name] > 0 else stage.given.sense
        sketch.items += turning(centre, 0.6 * around, math.radians(-100 * turns), math.radians(200 * turns))
        spoke = line(centre + 0.7j * around, centre + 1j * max(around - CLEAR, 0.5), MARK)
        sketch.marks.append(Moving((spoke,), centre, out.name, turns))
    sketch.mark(x, y, max(sketch.radius(entry) - CLEAR, 1.0), entry.name, WORM)
    away = 1 if stage.given.worm == "above" else -1
    sketch.name(entry.name, complex(x + WORM, y + away * sketch.radius(entry)), complex(1, away))
    sketch.x = x + max(around, WORM + ROOM)
    return x - WORM - ROOM


def _cones(sketch: Sketch, stage: Found, entry: Member) -> float:
    """Both wheels in the plane of their axes, the driven shaft cut off; gives where the driving shaft ends."""
    n = stage.s.number
    one, two = (math.radians(n(key)) for key in ("delta1", "delta2"))
    mean = sketch.radius(entry) / math.sin(one)
    wide = n("b") / sketch.plans.length_scale if "b" in stage.s else 0.3 * mean
    outer, inner = mean + wide / 2, max(mean - wide / 2, 0.1)
    apex = complex(sketch.x + SIDE + outer * math.cos(one), sketch.y(entry))
    _cones_turn(sketch, stage, apex, mean, (one, two))
    for name, axis, delta in zip(stage.given.wheels, (math.pi, math.pi + one + two), (one, two), strict=True):
        sketch.items += [item.moved(apex) for item in cone(axis, delta, outer, inner, NORMAL)]
        back = apex + cmath.rect(outer * math.cos(delta), axis)
        sketch.name(name, back + cmath.rect(outer * math.sin(delta), axis + math.pi / 2), complex(-1, 1))
    sketch.items.append(
        line(apex, apex + cmath.rect(outer * math.cos(two) + BEHIND + 4, math.pi + one + two), AXIS)
    )
    right = math.cos(math.pi + one + 2 * two)
    sketch.x = apex.real + outer * max(right, 0.0) + 1.0
    return apex.real - outer * math.cos(one)


def _cones_turn(
    sketch: Sketch, stage: Found, apex: complex, mean: float, angles: tuple[float, float]
) -> None:
    """Dots at the mean radii. Both cones carry theirs in front from the edge on which they roll, or both to it."""
    edge = math.pi + angles[0]
    sense = -int(math.copysign(1, sketch.speed[stage.input]))
    for name, delta, side in zip(stage.given.wheels, angles, (1, -1), strict=True):
        axis = edge - side * delta
        centre, radius = apex + cmath.rect(mean * math.cos(delta), axis), mean * math.sin(delta)
        across = cmath.rect(1, axis + side * math.pi / 2)  # to the edge
        sketch.marks += going_round(spot(centre), radius, name, across=across, sense=sense)
