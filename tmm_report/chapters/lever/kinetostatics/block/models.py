"""The block `loads` as a pydantic model; what states a load is a record of `given`."""

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar

from pydantic import Discriminator, Field, Tag

from tmm_report.chapters.lever.kinetostatics.given import (
    Force,
    Moment,
    Piston,
    StatedCurve,
    StatedStrokes,
    Vector,
    by_strokes,
)
from tmm_report.chapters.lever.kinetostatics.ties import Damper, Spring, TorsionSpring
from tmm_report.problems import N_
from tmm_report.variant.model import Model
from tmm_report.variant.stated import Stated
from tmm_report.variant.values import MAP, SCALAR, Acceleration, FixedDirection, Label, by_shape


class GravityModel(Model):
    """The acceleration of free fall and where it points."""

    value: Acceleration = 9.81
    direction: FixedDirection = -1j


def _force_kind(value: Any) -> str:
    if not isinstance(value, dict):
        return "<force>"
    return "<piston>" if "piston_diameter" in value else "<vector>" if "components" in value else "<force>"


AnyForce = Annotated[
    Annotated[Stated[Force], Tag("<force>")]
    | Annotated[Stated[Piston], Tag("<piston>")]
    | Annotated[Stated[Vector], Tag("<vector>")],
    Discriminator(_force_kind),
]

AnyCurve = Annotated[
    Annotated[Stated[StatedCurve], Tag("<ways>")] | Annotated[Stated[StatedStrokes], Tag("<strokes>")],
    Discriminator(by_strokes),
]

Gravity = Annotated[
    Annotated[Acceleration, Tag(SCALAR)] | Annotated[GravityModel, Tag(MAP)],
    by_shape(N_("9.81 m/s^2, or {value: 9.81 m/s^2, direction: down}")),
]


class LoadsModel(Model):
    """What acts on the mechanism. Inertia comes from the masses of the links."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("spring", "damper"), N_("springs and dampers stand in lists: springs, dampers")),
        **dict.fromkeys(
            ("torsional_springs", "torsion_spring"),
            N_("springs that turn links stand in the list torsion_springs"),
        ),
        "torsional_dampers": N_(
            "dampers that turn links are not offered: a moment on a link by_displacement is"
        ),
    }

    gravity: Gravity = Field(
        default=9.81, description="downwards unless {value, direction}; 0 switches it off"
    )
    curves: dict[Label, AnyCurve] = Field(
        default={},
        max_length=60,
        description="curves that several loads have, by their names",
        examples=["{gas: {forward: [[0, 1], [1, 0.1]], back: [[0, 0], [1, 1]]}}"],
    )
    # None: the hole of a load that is wrong in itself; what is solved has none, and is another record therefore
    forces: list[AnyForce | None] = Field(default=[])
    moments: list[Stated[Moment] | None] = Field(default=[])
    springs: list[Stated[Spring] | None] = Field(
        default=[], max_length=24, description="between two points each"
    )
    dampers: list[Stated[Damper] | None] = Field(
        default=[], max_length=24, description="between two points each"
    )

    torsion_springs: list[Stated[TorsionSpring] | None] = Field(
        default=[], max_length=24, description="between two links each, or a link and the frame"
    )

    @property
    def pull(self) -> complex:
        """Gravity as a vector, m/s²."""
        g = self.gravity
        return g.value * g.direction if isinstance(g, GravityModel) else g * -1j
