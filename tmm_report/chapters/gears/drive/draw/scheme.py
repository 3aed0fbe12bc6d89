"""Kinematic scheme of a gear drive in its conventional signs (GOST 2.770): stages side by side along their shafts.

A wheel is a rim (a bar along the shaft) on a web, a cross where it sits fast on its shaft; a ring's rim lies
outside its pitch line; hatching is the frame. Of a planetary stage the half with one satellite is drawn. Across the
shafts the scheme is to the scale of `plans`, along them it is not; mm of paper.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import assert_never

from tmm_report.chapters.gears.drive.draw.ordinary import ordinary
from tmm_report.chapters.gears.drive.draw.pair import pair
from tmm_report.chapters.gears.drive.draw.planetary import planetary
from tmm_report.chapters.gears.drive.draw.sketch import Sketch
from tmm_report.chapters.gears.drive.plans import Plans
from tmm_report.chapters.gears.drive.stages import Stage, member
from tmm_report.chapters.gears.ordinary import solve as ordinary_stage
from tmm_report.chapters.gears.planetary.solve import stage as planetary_stage
from tmm_report.chapters.gears.spur.solve import pair as spur

COUPLING = 9.0  # of shaft between two stages
START = 4.0  # of shaft more at the ends of the drive


def scheme(stages: Sequence[Stage], plans: Plans, speed: Mapping[str, float]) -> Sketch:
    """The whole drive from its input shaft at the left."""
    sketch = Sketch(plans, speed)
    for k, stage in enumerate(stages):
        entry = member(stage, stage.input)
        if k == 0:
            sketch.turns(2.0, sketch.y(entry), entry.name)
        start = sketch.x
        lead = START if k == 0 else 0.0
        sketch.bearing(start + lead + COUPLING / 2, sketch.y(entry))
        sketch.x += lead + COUPLING
        sketch.shaft(start, _drawn(sketch, stage), sketch.y(entry))
    exit_ = member(stages[-1], stages[-1].output)
    sketch.bearing(sketch.x + COUPLING / 2, sketch.y(exit_))
    sketch.shaft(sketch.x, sketch.x + COUPLING + START, sketch.y(exit_))
    sketch.turns(sketch.x + COUPLING + START - 2, sketch.y(exit_), exit_.name)
    return sketch


def _drawn(sketch: Sketch, stage: Stage) -> float:
    """The stage drawn; gives where the input shaft ends and leaves `sketch.x` where the stage does."""
    match stage:
        case spur.Found():
            return pair(sketch, stage)
        case planetary_stage.Found():
            return planetary(sketch, stage)
        case ordinary_stage.Found():
            return ordinary(sketch, stage)
        case _:
            assert_never(stage)
