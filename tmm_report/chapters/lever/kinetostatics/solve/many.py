"""Kinetostatics of many variants of one mechanism, solved together; each finds what `solve` finds for it alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.kinetostatics.solve.positions import (
    Kinetostatics,
    Loading,
    Solved,
    Stated,
    at,
    stated,
)
from tmm_report.mechanics.calculus.variants import Each, one
from tmm_report.mechanics.lever.forces.reactions import Statics
from tmm_report.mechanics.lever.motion import Motion

Array = Any


def solve(
    given: Sequence[Loads], each: Sequence[Kinematics], table: Motion, diagram: Motion
) -> list[Kinetostatics]:
    """The forces of every variant, whose motions `table` and `diagram` are of all, (V, P); their loads act on the same
    points and links. Raises ProblemError as soon as one has a mistake: then each must be solved alone."""
    gravity: Any = Each([loads.gravity for loads in given])
    whole = replace(given[0], gravity=gravity)
    with np.errstate(invalid="ignore", divide="ignore"):
        tables = _apart(whole, given, each, table, [(k.table, k.turned) for k in each])
        diagrams = _apart(whole, given, each, diagram, [(k.diagram, k.diagram_turned) for k in each])
    return [Kinetostatics(*row) for row in zip(given, each, tables, diagrams, strict=True)]


def _apart(
    whole: Loads,
    given: Sequence[Loads],
    each: Sequence[Kinematics],
    motion: Motion,
    own: Sequence[tuple[Motion, Array]],
) -> list[Solved]:
    """Solved together at one set of positions, then each by itself; `own`: of each its motion and angles turned."""
    laws = [stated(loads, k, *at_own) for loads, k, at_own in zip(given, each, own, strict=True)]
    found = at(whole, motion, own[0][1], _stacked(laws))
    return [_one(found, v, k, *own[v]) for v, k in enumerate(each)]


def _stacked(laws: Sequence[Stated]) -> Stated:
    """The stated loads of all variants, (V, P) each."""
    forces, moments = (
        [
            (np.array([vector for vector, _ in rows]), np.array([along for _, along in rows]))
            for rows in zip(*(law[kind] for law in laws), strict=True)
        ]
        for kind in (0, 1)
    )
    return forces, moments


def _one(found: Solved, v: int, kinematics: Kinematics, motion: Motion, turned: Array) -> Solved:
    """What is found of variant `v`."""
    load = Loading(**{item.name: one(getattr(found.loading, item.name), v) for item in fields(Loading)})
    numbers = {name: one(getattr(found, name), v) for name in ("powers", "lever", "power", "scale")}
    return Solved(motion, turned, load, _statics(found.statics, v, kinematics), **numbers)


def _statics(found: Statics, v: int, kinematics: Kinematics) -> Statics:
    pairs = {pair.key: pair for pair in kinematics.linkage.structure.pairs}
    reactions: Mapping[str, Any] = {
        key: replace(
            whole,
            pair=pairs[key],
            **{name: one(getattr(whole, name), v) for name in ("force", "moment", "at", "along")},
        )
        for key, whole in found.reactions.items()
    }
    driving = None if found.driving is None else one(found.driving, v)
    return Statics(reactions, one(found.balancing, v), driving)
