"""What is given of friction in single pairs: planes and wedges, screws, pivots, belts, wheels, journals; SI, rad."""

from __future__ import annotations

from math import cos, pi
from typing import Literal

from tmm_report.mechanics.pairs.materials import Stock
from tmm_report.records import dataclass


@dataclass(frozen=True)
class Rough:
    """A coefficient of friction; `stock`: the materials it was taken of, None where it is stated itself."""

    f: float
    stock: Stock | None = None


@dataclass(frozen=True)
class Incline:
    """A body on a plane that slopes by `angle`, moved by a level force or by one along the plane."""

    rough: Rough
    angle: float
    load: float
    force: Literal["level", "along"] = "level"


@dataclass(frozen=True)
class Wedge:
    """A wedge driven on a level base under a load that is guided upright. `base`: coefficient on the base."""

    rough: Rough
    angle: float
    load: float
    base: float


@dataclass(frozen=True)
class Sliders:
    """Two guided sliders whose directions are `between` each other; one drives the other over a sloping face.
    `guides`: coefficient in the guides; `face`: angle of its normal with the driving direction, None: the best."""

    rough: Rough
    between: float
    guides: float
    face: float | None = None
    load: float | None = None


@dataclass(frozen=True)
class Trial:
    """A body just pulled by one force above the level and just pushed by another below it: what are f and weight."""

    angle: float
    pull: float
    push: float


@dataclass(frozen=True)
class Screw:
    """A screw under load. `profile`: half the angle of the thread, 0 of a square one; `collar`: coefficient and mean
    radius; `arm`: of the force of each of `hands`, or `hand_force` of each on a wheel, whose diameter is then found."""

    rough: Rough
    diameter: float
    pitch: float
    load: float
    starts: int = 1
    profile: float = 0.0
    collar: tuple[float, float] | None = None
    arm: float | None = None
    hand_force: float | None = None
    hands: int = 1


@dataclass(frozen=True)
class Pivot:
    """A pivot or collar, flat (`half_cone` 90°) or conical, from radius `inner` to `outer`."""

    rough: Rough
    outer: float
    load: float
    inner: float = 0.0
    half_cone: float = pi / 2
    speed: float | None = None


@dataclass(frozen=True)
class Belt:
    """A rope or belt round a drum over the angle `wrap`. `groove`: half its angle; `tight`: the greater tension."""

    rough: Rough
    wrap: float
    tight: float
    groove: float = pi / 2
    diameter: float | None = None
    speed: float | None = None


@dataclass(frozen=True)
class BeltDrive:
    """An open flat belt. Pulleys of `driving` and `driven` diameter at `distance`; `speed` of the driving one;
    `stress`: allowed in the belt; `density`: of the belt, None: centrifugal forces are neglected."""

    rough: Rough
    driving: float
    driven: float
    distance: float
    speed: float
    width: float
    thickness: float
    stress: float
    density: float | None = None


@dataclass(frozen=True)
class Wheel:
    """A wheel under `load`. `arm`: of rolling resistance, k; `pull`: level force at its axle, where one is stated."""

    rough: Rough
    radius: float
    arm: float
    load: float
    pull: float | None = None


@dataclass(frozen=True)
class Journal:
    """A journal under `load` in its bearing."""

    rough: Rough
    diameter: float
    load: float
    speed: float | None = None


@dataclass(frozen=True)
class Crank:
    """A slider-crank in one position, driven by a force on its slider: `turned` from the dead point. `journals`:
    diameters of shaft, crankpin and wrist pin."""

    rough: Rough
    force: float
    crank: float
    rod: float
    turned: float
    journals: tuple[float, float, float]

    @property
    def swing(self) -> int:
        """+1 while the rod swings out, −1 while it swings back past 90°: so the wrist pin turns its force."""
        return 1 if cos(self.turned) > 0 else -1


Contact = (
    Incline | Wedge | Sliders | Trial | Screw | Pivot | Belt | BeltDrive | Wheel | Journal | Crank
)  # fmt: skip


@dataclass(frozen=True)
class Named:
    """A pair with the name that the file gives it, "" where it gives none."""

    of: Contact
    name: str = ""


@dataclass(frozen=True, eq=False)
class Given:
    """The pairs in the order of the file."""

    items: tuple[Named, ...] = ()
