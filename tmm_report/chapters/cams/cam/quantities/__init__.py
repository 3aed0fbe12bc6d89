"""The numbers of a cam, alone or one of the pairs of a lever mechanism: sizes, phases, the law, pressure angles,
coordinates of the profile."""

from tmm_report.chapters.cams.cam.quantities.names import (
    acceleration,
    displacement,
    first,
    letter,
    named,
    pressure,
    second,
    velocity,
)
from tmm_report.chapters.cams.cam.quantities.sizes import base, lift, values
from tmm_report.chapters.cams.cam.quantities.tables import (
    ANGLE,
    ASKED_BEND,
    BEGINS,
    BEND,
    BETA,
    FORMS,
    KINDS,
    NEXT,
    RATIO,
    REACHED,
    SHARE,
    SHOCKS,
    SLOPE,
    START,
    WIDTH,
    WITHIN,
    asked_S,
    asked_slope,
    demands,
    law_word,
    tables,
)

MOTION_OF = (displacement, first, second, velocity, acceleration, pressure)
"""What makes the quantities of the motion by positions, in their order."""

__all__ = [
    "ANGLE", "ASKED_BEND", "BEGINS", "BEND", "BETA", "FORMS", "KINDS", "MOTION_OF", "NEXT", "RATIO", "REACHED", "SHARE",
    "SHOCKS", "SLOPE", "START", "WIDTH", "WITHIN", "acceleration", "asked_S", "asked_slope", "base", "demands",
    "displacement", "first", "law_word", "letter", "lift", "named", "pressure", "second", "tables", "values",
    "velocity",
]  # fmt: skip
