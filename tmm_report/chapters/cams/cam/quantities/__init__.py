"""The numbers of a cam, alone or one of the pairs of a lever mechanism: sizes, phases, the law, pressure angles,
coordinates of the profile."""

from collections.abc import Iterator

from tmm_report.chapters.cams.cam.quantities import making, sizes
from tmm_report.chapters.cams.cam.quantities import tables as of_pairs
from tmm_report.chapters.cams.cam.quantities.cad_outlines import cad_outlines
from tmm_report.chapters.cams.cam.quantities.names import (
    acceleration,
    displacement,
    first,
    letter,
    lowest_sign,
    named,
    pressure,
    second,
    velocity,
)
from tmm_report.chapters.cams.cam.quantities.sizes import base, lift
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
)
from tmm_report.chapters.cams.cam.solve.found import Cams
from tmm_report.quantity.model import Table, Value
from tmm_report.quantity.tabulated import tabulated

HEADLINE = (
    "cam_base",
    "cam_lift",
    "cam_alpha_rise",
    "cam_alpha_return",
    "cam_rho",
)  # what is looked for first

MOTION_OF = (displacement, first, second, velocity, acceleration, pressure)
"""What makes the quantities of the motion by positions, in their order."""


@tabulated
def tables(found: Cams) -> Iterator[Table]:
    yield from of_pairs.tables(found)
    for made in found.made:
        yield from making.tables(made)


@tabulated
def values(found: Cams) -> Iterator[Value]:
    yield from sizes.values(found)
    for made in found.made:
        yield from making.values(made)


__all__ = [
    "ANGLE", "ASKED_BEND", "BEGINS", "BEND", "BETA", "FORMS", "KINDS", "MOTION_OF", "NEXT", "RATIO", "REACHED", "SHARE",
    "SHOCKS", "SLOPE", "START", "WIDTH", "WITHIN", "acceleration", "asked_S", "asked_slope", "base", "cad_outlines",
    "demands", "displacement", "first", "law_word", "letter", "lift",
    "lowest_sign", "named", "pressure", "second", "tables", "values",
    "velocity",
]  # fmt: skip
