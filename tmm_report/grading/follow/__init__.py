"""Follow-through: what each quantity would be, rightly computed from the student's own values of what it depends on.

One pass in the order of the course: places, velocities, accelerations, loads, reactions group by group, the balancing
moment. At each step the student's own numbers, where he gives them, take the place of those computed, so an error is
carried to what depends on it and to nothing else. Every formula by which a quantity can be found is an alternative.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from typing import Any

import numpy as np

from tmm_report.course import LeverFound, Results
from tmm_report.grading.follow.forces import Forces
from tmm_report.grading.follow.places import Poses, Travelling
from tmm_report.grading.follow.rates import Rates
from tmm_report.grading.follow.scheme import Scheme, scheme
from tmm_report.grading.follow.sheet import Follow, Sheet, column

__all__ = ["Follow", "carried"]

Array = Any


def carried(
    results: Results, given: Mapping[str, Array], wanted: Container[str] | None = None
) -> Mapping[str, tuple[Follow, ...]]:
    """What follows from a student's numbers, key -> alternatives, in the order of computation; every key that is known
    is there, or of the `wanted` ones alone.

    `given`: keys of the tables by positions -> the student's numbers (P,) in the units of the results, nan where he
    gave none; other keys and columns of another length are passed over. Nothing follows where there is no lever
    mechanism, or one with higher pairs, whose law no number of the tables carries on.
    """
    lever = results.lever
    if lever is None or lever.given.mechanism.cams or lever.given.mechanism.meshes:
        return {}
    shape = lever.kinematics.table.shape
    own = {key: values for key, one in given.items() if (values := column(one)).shape == shape}
    sheet = Sheet({key: values for key, values in own.items() if np.isfinite(values).any()}, wanted)
    steps = scheme(lever.kinematics.linkage)
    with np.errstate(all="ignore"):  # what cannot be found is nan, and then nothing follows
        poses = _followed(lever, steps, sheet)
        if poses.elsewhere:
            # what he says of the places may be a slip of the pen, and the rest be worked from the right ones
            rest = {key: values for key, values in sheet.given.items() if key not in poses.keys}
            _followed(lever, steps, sheet.without(rest))
    return sheet.follows()


def _followed(lever: LeverFound, steps: Scheme, sheet: Sheet) -> Poses:
    """Note on the sheet all that follows from its numbers."""
    found = lever.kinematics
    travels = tuple(
        Travelling(t.output.kind == "slider", t.output.name, t.output.direction, t.S)
        for t in (*found.travels, *found.links)
    )
    poses = Poses(found.table, sheet, travels)
    velocities = Rates("v", sheet, steps, poses, found.values)
    accelerations = Rates("a", sheet, steps, poses, found.values, velocities)
    if lever.kinetostatics is not None:
        Forces(sheet, poses, velocities, accelerations, lever.kinetostatics)
    return poses
