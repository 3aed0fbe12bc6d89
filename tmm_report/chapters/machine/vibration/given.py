"""What is given of vibration and its isolation."""

from __future__ import annotations

from tmm_report.records import dataclass

CURVES = (0.0, 0.1, 0.25, 0.5, 1.0)


@dataclass(frozen=True)
class Unbalance:
    """A mass off the axis of a shaft, kg and m."""

    mass: float
    radius: float


@dataclass(frozen=True)
class Foundation:
    """What the isolators stand on, itself on springs: kg, N/m, N s/m, or kg m², N m/rad, N m s/rad."""

    inertia: float
    stiffness: float
    damping: float = 0.0


@dataclass(frozen=True)
class Absorber:
    """A mass hung on the machine: its `inertia`, or the parts of the working frequency between which no natural one may
    lie; on `springs` springs, those of a turning one at `arm` from the axis, m."""

    inertia: float | None = None
    clear: tuple[float, float] | None = None
    springs: int = 1
    arm: float | None = None


@dataclass(frozen=True, eq=False)
class Given:
    """A mass, kg, or with `turning` a disc, kg m², on `isolators` equal springs and dampers.

    `stiffness`, `damping`: of each; `ratio`: ζ in place of the damping; `wanted`: force ratio to be reached, for which
    the stiffness is chosen where none is stated. One of these shakes it: `force`, amplitude, N or N m; `unbalance`;
    `base`, amplitude of the base's motion, m or rad; `direction` along which the mechanism's shaking force is taken.
    `omega`: of the excitation, rad/s, None with the mechanism's. `friction`: dry, in place of the damper, N or N m;
    `place`, `speed`: at the start; `curves`: ζ of the curves drawn.
    """

    inertia: float
    turning: bool = False
    isolators: int = 1
    stiffness: float | None = None
    damping: float | None = None
    ratio: float | None = None
    wanted: float | None = None
    force: float | None = None
    unbalance: Unbalance | None = None
    base: float | None = None
    direction: complex | None = None
    omega: float | None = None
    friction: float | None = None
    foundation: Foundation | None = None
    absorber: Absorber | None = None
    place: float = 0.0
    speed: float = 0.0
    curves: tuple[float, ...] = CURVES
    name: str = ""

    @property
    def free(self) -> bool:
        """Whether nothing shakes it: it is let go and vibrates freely."""
        return self.force is self.unbalance is self.base is self.direction is None
