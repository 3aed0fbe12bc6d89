"""The block `loads` -> Loads."""

from __future__ import annotations

import math
from collections.abc import Sequence

from tmm_report.chapters.lever.kinetostatics.block import models as m
from tmm_report.chapters.lever.kinetostatics.given import (
    ByAngle,
    ByDisplacement,
    ByPosition,
    ByStrokes,
    Constant,
    Curve,
    Force,
    Law,
    Loads,
    Moment,
    Motion,
    TurnLaw,
)
from tmm_report.variant.values import SENSES, SIDES

_TURNS: dict[str, int | Motion] = {**SENSES, "along motion": "along", "against motion": "against"}


def loads(written: m.LoadsModel) -> Loads:
    gravity = written.gravity
    pull = gravity.value * gravity.direction if isinstance(gravity, m.GravityModel) else gravity * -1j
    forces = [_force(one, index) for index, one in enumerate(written.forces, 1) if one]
    moments = [_moment(one, index) for index, one in enumerate(written.moments, 1) if one]
    return Loads(pull, tuple(forces), tuple(moments))


def _force(written: m.ForceModel | m.PistonModel, index: int) -> Force:
    law = _force_law(written)
    return Force(written.name or f"F{index}", written.at, written.direction, law, written.on)


def _moment(written: m.MomentModel, index: int) -> Moment:
    return Moment(written.name or f"M{index}", written.on, _TURNS[written.direction], _law(written))


def _force_law(written: m.ForceModel | m.PistonModel) -> Law:
    area = math.pi / 4 * written.piston_diameter**2 if isinstance(written, m.PistonModel) else 1.0
    if written.by_displacement is not None:
        return _indicated(written.by_displacement, area)
    return _law(written, area)


def _indicated(diagram: m.Indicator, area: float) -> ByDisplacement | ByStrokes:
    """An indicator diagram; `area` turns pressures into forces."""

    def forces(curve: Sequence[tuple[float, float]]) -> Curve:
        return tuple((x, y * area) for x, y in curve)

    zero = SIDES[diagram.zero]
    if isinstance(diagram, m.Diagram | m.PressureDiagram):
        return ByDisplacement(zero, forces(diagram.forward), forces(diagram.back))
    names = tuple(diagram.strokes)
    first = names.index(diagram.first) if diagram.first is not None else None
    return ByStrokes(zero, names, tuple(map(forces, diagram.strokes.values())), first)


def _law(written: m.ForceModel | m.PistonModel | m.MomentModel, area: float = 1.0) -> TurnLaw:
    """The one law of those that forces and moments have both; `area` turns pressures into forces."""
    if written.by_angle is not None:
        return ByAngle(tuple(x for x, _ in written.by_angle), tuple(y * area for _, y in written.by_angle))
    if written.by_position is not None:
        return ByPosition(tuple(y * area for y in written.by_position))
    assert written.constant is not None  # `_one_law` wants one of them
    return Constant(written.constant * area)
