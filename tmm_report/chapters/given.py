"""What a variant asks of the lever-mechanism chapters, beside the mechanism itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from tmm_report.chapters.kinetostatics.loads import Force, Moment


@dataclass(frozen=True)
class Title:
    """The title page; empty fields are left out of it."""

    institution: str = ""
    department: str = ""
    course: str = ""
    topic: str = ""
    student: str = ""
    group: str = ""
    variant: str = ""
    teacher: str = ""
    city: str = ""
    year: str = ""


@dataclass(frozen=True)
class Positions:
    """How many positions the tables and diagrams have, and which table positions are drawn."""

    table: int = 12
    diagram: int = 36
    plans: tuple[int, ...] = (1,)
    force_plan: tuple[int, ...] = (1,)


@dataclass(frozen=True)
class Drawing:
    """How plans are drawn. Scales are SI units per mm of paper; None: chosen as a person would choose."""

    accuracy: float = 1e-5  # m of paper: lengths are read to this
    length: float | None = None  # m/mm
    velocity: float | None = None  # (m/s)/mm
    acceleration: float | None = None  # (m/s²)/mm
    force: float | Mapping[str, float] | None = None  # N/mm, one for all or by group, "2-3"


@dataclass(frozen=True)
class Loads:
    """Loads of the kinetostatics chapter. `gravity`: complex, m/s²; inertia comes from the links' masses."""

    gravity: complex = -9.81j
    forces: tuple[Force, ...] = ()
    moments: tuple[Moment, ...] = ()


@dataclass(frozen=True)
class Rubbing:
    """A pair's friction coefficient and, for a pivot, its journal diameter, m."""

    coefficient: float
    diameter: float | None = None


@dataclass(frozen=True)
class Friction:
    """Friction of all pivots, of all guides, and of single joints named by their point or guide."""

    pivots: Rubbing | None = None
    guides: Rubbing | None = None
    joints: Mapping[str, Rubbing] = field(default_factory=dict)


Readings = Mapping[int, Mapping[str, float]]  # table position -> symbol key ("v_BA", "e_2") -> SI value
