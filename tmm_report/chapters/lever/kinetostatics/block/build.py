"""The block `loads` -> Loads."""

from __future__ import annotations

import math

from tmm_report.chapters.lever.kinetostatics.block import models as m
from tmm_report.chapters.lever.kinetostatics.given import Force, Loads, Moment, Motion
from tmm_report.mechanics.calculus.laws import ByAngle, ByDisplacement, ByPosition, ByStrokes, Constant, Law
from tmm_report.variant.values import SENSES, SIDES

_TURNS: dict[str, int | Motion] = {**SENSES, "along motion": "along", "against motion": "against"}


def loads(written: m.LoadsModel) -> Loads:
    gravity = written.gravity
    pull = gravity.value * gravity.direction if isinstance(gravity, m.GravityModel) else gravity * -1j
    forces = [_force(one, index) for index, one in enumerate(written.forces, 1) if one]
    moments = [_moment(one, index) for index, one in enumerate(written.moments, 1) if one]
    return Loads(pull, tuple(forces), tuple(moments))


def _force(written: m.ForceModel | m.PistonModel, index: int) -> Force:
    law = _law(written)
    if isinstance(written, m.PistonModel):
        law = law.scaled(math.pi / 4 * written.piston_diameter**2)
    return Force(written.name or f"F{index}", written.at, written.direction, law, written.on)


def _moment(written: m.MomentModel, index: int) -> Moment:
    return Moment(written.name or f"M{index}", written.on, _TURNS[written.direction], _law(written))


def _law(written: m.ForceModel | m.PistonModel | m.MomentModel) -> Law:
    """The one law by which a load is stated."""
    if not isinstance(written, m.MomentModel) and written.by_displacement is not None:
        return _indicated(written.by_displacement)
    if written.by_angle is not None:
        return ByAngle.through(written.by_angle)
    if written.by_position is not None:
        return ByPosition(tuple(written.by_position))
    assert written.constant is not None  # `_one_law` wants one of them
    return Constant(written.constant)


def _indicated(diagram: m.Indicator) -> ByDisplacement | ByStrokes:
    zero = SIDES[diagram.zero]
    if isinstance(diagram, m.Diagram | m.PressureDiagram):
        return ByDisplacement(zero, tuple(diagram.forward), tuple(diagram.back))
    names, curves = tuple(diagram.strokes), tuple(map(tuple, diagram.strokes.values()))
    return ByStrokes(zero, names, curves, names.index(diagram.first) if diagram.first is not None else None)
