"""The table of contents: a variant (all that is given), its results (all that is found), and the order of solving."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from tmm_report.chapters.force_plans import solve as force_plans
from tmm_report.chapters.friction import solve as friction
from tmm_report.chapters.given import Drawing, Friction, Loads, Positions, Readings, Title
from tmm_report.chapters.kinematics import solve as kinematics
from tmm_report.chapters.kinetostatics import solve as kinetostatics
from tmm_report.chapters.plans import solve as plans
from tmm_report.chapters.structure import solve as structure
from tmm_report.languages import DEFAULT, DecimalSign
from tmm_report.mechanics.mechanism import Mechanism

if TYPE_CHECKING:  # the gear chapters are loaded only for a variant that has gears
    from tmm_report.chapters.drive import solve as drive
    from tmm_report.chapters.eccentric import solve as eccentric


@dataclass(frozen=True, eq=False)
class Variant:
    """Everything a variant states, checked, in SI. A chapter whose block is None is not solved.

    A variant has a lever mechanism, a gear drive, an eccentric epicyclic mechanism, or several of them.
    """

    mechanism: Mechanism = None  # type: ignore[assignment]  # None, and the lever's chapters are not asked for it
    title: Title = field(default_factory=Title)
    language: str = DEFAULT  # a code of the table of languages
    decimal_sign: DecimalSign = "comma"
    positions: Positions = field(default_factory=Positions)
    allow_partial: bool = False  # a mechanism that exists over part of the cycle only is meant so
    drawing: Drawing = field(default_factory=Drawing)
    readings: Readings = field(default_factory=dict)
    loads: Loads | None = None
    friction: Friction | None = None
    drive: drive.Given | None = None
    eccentric: eccentric.Given | None = None
    places: Mapping[tuple[str | int, ...], tuple[int, int]] = field(default_factory=dict, repr=False)
    """Where each key of the file stands: path -> (line, column), for mistakes found only in solving."""
    file: str = ""


@dataclass(frozen=True, eq=False)
class Results:
    """Everything found, in the order of the note. A chapter that the variant does not ask for is None.

    Structure, kinematics and plans are those of the lever mechanism: None where `has_mechanism` is False.
    """

    variant: Variant
    structure: structure.Structure = None  # type: ignore[assignment]
    kinematics: kinematics.Kinematics = None  # type: ignore[assignment]
    plans: plans.Plans = None  # type: ignore[assignment]
    kinetostatics: kinetostatics.Kinetostatics | None = None
    force_plans: force_plans.ForcePlans | None = None
    friction: friction.FrictionFound | None = None
    drive: drive.Found | None = None
    eccentric: eccentric.Found | None = None

    @property
    def has_mechanism(self) -> bool:
        """Whether there is a lever mechanism."""
        return self.structure is not None

    @property
    def partial(self) -> bool:
        """Whether the mechanism closes over part of the cycle only and the variant does not mean it so."""
        return self.has_mechanism and bool(self.kinematics.gaps) and not self.variant.allow_partial


def solve(variant: Variant) -> Results:
    """Solve a variant chapter by chapter. Raises ProblemError with what cannot be solved and why."""
    lever = _lever(variant) if variant.mechanism is not None else Results(variant)
    return replace(lever, **_gears(variant))


def _lever(variant: Variant) -> Results:
    """The chapters of the lever mechanism."""
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


def _gears(variant: Variant) -> dict[str, Any]:
    """The chapters of gears that are asked for."""
    found: dict[str, Any] = {}
    if variant.drive is not None:
        from tmm_report.chapters.drive import solve as drive

        found["drive"] = drive.solve(variant.drive)
    if variant.eccentric is not None:
        from tmm_report.chapters.eccentric import solve as eccentric

        found["eccentric"] = eccentric.solve(variant.eccentric)
    return found
