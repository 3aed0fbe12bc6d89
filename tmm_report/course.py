"""The table of contents: a variant (all that is given), its results (all that is found), and the order of solving."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from tmm_report.chapters import force_plans, friction, kinematics, kinetostatics, plans, structure
from tmm_report.chapters.given import Drawing, Friction, Loads, Positions, Readings, Title
from tmm_report.mechanics.mechanism import Mechanism


@dataclass(frozen=True, eq=False)
class Variant:
    """Everything a variant states, checked, in SI. A chapter whose block is None is not solved."""

    mechanism: Mechanism
    title: Title = field(default_factory=Title)
    language: Literal["ru", "en"] = "ru"
    decimal_sign: Literal["comma", "point"] = "comma"
    positions: Positions = field(default_factory=Positions)
    allow_partial: bool = False  # a mechanism that exists over part of the cycle only is meant so
    drawing: Drawing = field(default_factory=Drawing)
    readings: Readings = field(default_factory=dict)
    loads: Loads | None = None
    friction: Friction | None = None
    places: Mapping[tuple[str | int, ...], tuple[int, int]] = field(default_factory=dict, repr=False)
    """Where each key of the file stands: path -> (line, column), for mistakes found only in solving."""
    file: str = ""


@dataclass(frozen=True, eq=False)
class Results:
    """Everything found, in the order of the note. A chapter that the variant does not ask for is None."""

    variant: Variant
    structure: structure.Structure
    kinematics: kinematics.Kinematics
    plans: plans.Plans
    kinetostatics: kinetostatics.Kinetostatics | None
    force_plans: force_plans.ForcePlans | None
    friction: friction.FrictionFound | None

    @property
    def partial(self) -> bool:
        """Whether the mechanism does not close over part of the cycle and the variant does not say that it is meant so."""
        return bool(self.kinematics.gaps) and not self.variant.allow_partial


def solve(variant: Variant) -> Results:
    """Solve a variant chapter by chapter. Raises ProblemError with what cannot be solved and why."""
    drawing, positions = variant.drawing, variant.positions
    found_structure = structure.solve(variant.mechanism)
    found_kinematics = kinematics.solve(positions, found_structure)
    found_plans = plans.solve(drawing, positions.plans, variant.readings, found_kinematics)
    found_forces = kinetostatics.solve(variant.loads, found_kinematics) if variant.loads is not None else None
    found_force_plans = found_friction = None
    if found_forces is not None:
        found_force_plans = force_plans.solve(drawing, positions.force_plan, found_forces, found_plans)
        if variant.friction is not None:
            found_friction = friction.solve(variant.friction, found_forces)
    return Results(
        variant,
        found_structure,
        found_kinematics,
        found_plans,
        found_forces,
        found_force_plans,
        found_friction,
    )
