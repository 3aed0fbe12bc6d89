"""What is given of the flywheel: the loads of a machine that stands alone, the wanted unevenness, the wheel's shape."""

from __future__ import annotations

from dataclasses import field
from typing import Literal

from tmm_report.mechanics.calculus.laws import Constant, Law
from tmm_report.problems import N_
from tmm_report.records import dataclass

Shaft = Literal["main", "motor"]


@dataclass(frozen=True)
class Areas:
    """Works of the excess moment between its passages through zero, J, in their order over the cycle."""

    works: tuple[float, ...]


@dataclass(frozen=True)
class Punch:
    """A working stroke of `time`, s, that takes `work`, J, every `period`, s, at a constant power of the motor."""

    work: float
    period: float
    time: float


@dataclass(frozen=True)
class Motor:
    """Nominal power, W, and speed, rad/s; `inertia` of its rotor, kg m²; `efficiency` of the transmission."""

    power: float
    speed: float
    inertia: float = 0.0
    efficiency: float = 1.0


@dataclass(frozen=True)
class Wheel:
    """A flywheel that is there already: its moment of inertia, kg m²; or its mass, kg, and radius of gyration, m."""

    inertia: float
    mass: float | None = None
    gyration: float | None = None


@dataclass(frozen=True)
class Disc:
    """A solid disc: `width` is b/D; a stated diameter, m, leaves the width to be found."""

    width: float = 0.2
    diameter: float | None = None


@dataclass(frozen=True)
class Rim:
    """A rim on spokes: `height` is h/D of the mean diameter D, `width` b/h; a stated D, m, leaves h to be found.
    `spokes`: the part of the moment of inertia that is in spokes and hub."""

    height: float = 0.1
    width: float = 1.5
    diameter: float | None = None
    spokes: float = 0.1


@dataclass(frozen=True)
class Gyration:
    """Of the wheel only its radius of gyration is known, m: the mass follows."""

    radius: float


Shape = Disc | Rim | Gyration


@dataclass(frozen=True)
class Material:
    """Density, kg/m³, and the speed of the rim that is commonly allowed, m/s."""

    name: str
    density: float
    limit: float


CAST_IRON = Material(N_("cast iron"), 7200.0, 35.0)
STEEL = Material(N_("steel"), 7850.0, 70.0)
MATERIALS = {one.name: one for one in (CAST_IRON, STEEL)}

USUAL: dict[str, tuple[float, float]] = {  # kind of machine -> usual δ, from fine to coarse
    N_("AC generator"): (1 / 300, 1 / 200),
    N_("DC generator"): (1 / 200, 1 / 100),
    N_("internal combustion engine"): (1 / 100, 1 / 80),
    N_("piston compressor"): (1 / 100, 1 / 50),
    N_("machine tool"): (1 / 50, 1 / 20),
    N_("pump"): (1 / 30, 1 / 5),
    N_("crusher"): (1 / 20, 1 / 5),
}


@dataclass(frozen=True)
class Given:
    """SI. Of `delta`, `speeds` (least, greatest) and `wheel` one is stated. Beside a lever mechanism there are neither
    loads, nor `inertia`, nor `speed`: they are the mechanism's. `own`: constant moment of inertia of the machine that
    turns with the main link besides; `ratio`: speed of the flywheel's shaft to that of the main link; `friction`:
    whether that of the mechanism's pairs, where it is stated, is among the resistances."""

    delta: float | None = None
    speeds: tuple[float, float] | None = None
    wheel: Wheel | None = None
    machine: str = ""
    speed: float | None = None
    motor: Motor | None = None
    turns: float = 1.0
    driving: Law | None = None
    resisting: Law | None = None
    areas: Areas | None = None
    punch: Punch | None = None
    inertia: Law = field(default_factory=lambda: Constant(0.0))
    own: float = 0.0
    shaft: Shaft = "main"
    ratio: float | None = None
    shape: Shape = field(default_factory=Disc)
    material: Material = STEEL
    positions: int = 24
    friction: bool = True
