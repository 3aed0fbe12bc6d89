"""Dimensions of the flywheel on its shaft: a disc, a rim on spokes, or the mass for a known radius of gyration."""

from __future__ import annotations

import math

from tmm_report.chapters.machine.flywheel.given import Disc, Given, Gyration, Rim
from tmm_report.mechanics.machine.flywheel.inertia import disc, disc_width, hoop_stress, rim, rim_height
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

HIGHEST = 0.6  # of the mean diameter: a rim that leaves room for spokes and a hub
WIDEST = 2.0  # of the diameter: what is wider is no disc


@dataclass(frozen=True)
class Sizes:
    """SI. `ratio`: of the speeds of the wheel's shaft and of the main link; `inertia`: on the wheel's shaft;
    `diameter`: of the disc, or the rim's mean one; `height`, `width` of the section, of a disc only the width; `outer`:
    the largest diameter; `mass`: of the disc or the rim; `speed` of the rim where the machine is fastest; `stress` in
    it; `fastest`: ω_max of the wheel's shaft. None: not known of a wheel of known radius of gyration."""

    ratio: float
    inertia: float
    mass: float
    fastest: float
    diameter: float | None = None
    height: float | None = None
    width: float | None = None
    outer: float | None = None
    speed: float | None = None
    stress: float | None = None
    limit: float | None = None  # the largest diameter that the rim's speed allows, m

    @property
    def bursts(self) -> bool:
        """Whether the rim is faster than its material commonly allows."""
        return self.outer is not None and self.limit is not None and self.outer > self.limit * (1 + 1e-9)


def sized(given: Given, fly: float, omega: float, greatest: float) -> Sizes | None:
    """`fly`: moment of inertia as reduced to the main link, kg m²; `greatest`: its greatest speed, rad/s. Raises
    ProblemError where the stated shape cannot have it."""
    if fly == 0:
        return None
    ratio = _ratio(given, omega)
    inertia, fastest = fly / ratio**2, greatest * ratio
    if given.wheel:
        mass = given.wheel.mass
        return Sizes(ratio, inertia, mass, fastest) if mass is not None else None
    if isinstance(given.shape, Gyration):
        return Sizes(ratio, inertia, inertia / given.shape.radius**2, fastest)
    size = _disc if isinstance(given.shape, Disc) else _rim
    diameter, height, width, mass = size(given, inertia)
    _has_room(given, inertia, diameter, height, width)
    outer = diameter + (height or 0.0)
    speed, allowed = fastest * outer / 2, given.material.limit
    stress = hoop_stress(given.material.density, speed)
    limit = 2 * allowed / fastest
    return Sizes(ratio, inertia, mass, fastest, diameter, height, width, outer, speed, stress, limit)


def _has_room(given: Given, inertia: float, diameter: float, height: float | None, width: float) -> None:
    """Raises ProblemError for what is no wheel: a rim with no room for spokes and hub in it, a disc that is a shaft."""
    density, shape = given.material.density, given.shape
    if isinstance(shape, Rim) and height is not None and height > HIGHEST * diameter * (1 + 1e-9):
        text = N_(
            "the rim would be %(height)s mm high at a mean diameter of %(diameter)s mm: spokes have no room"
        )
        least = rim(inertia * (1 - shape.spokes), HIGHEST, shape.width, density)
        values = {"height": f"{1e3 * height:.4g}", "diameter": f"{1e3 * diameter:.4g}"}
        key = "height" if shape.diameter is None else "diameter"
        raise ProblemError([mistake(text, ("flywheel", "rim", key), _larger(least), **values)])
    if isinstance(shape, Disc) and width > WIDEST * diameter * (1 + 1e-9):
        text = N_(
            "the disc would be %(width)s mm wide at a diameter of %(diameter)s mm: that is a shaft, no wheel"
        )
        values = {"width": f"{1e3 * width:.4g}", "diameter": f"{1e3 * diameter:.4g}"}
        key = "width" if shape.diameter is None else "diameter"
        right = _larger(disc(inertia, WIDEST, density))
        raise ProblemError([mistake(text, ("flywheel", "disc", key), right, **values)])


def _larger(least: float) -> Message:
    return Message(N_("a diameter of %(least)s mm or more"), {"least": f"{math.ceil(1e3 * least)}"})


def _ratio(given: Given, omega: float) -> float:
    if given.shaft == "motor" and given.motor:
        return given.motor.speed / omega
    return given.ratio or 1.0


def _disc(given: Given, inertia: float) -> tuple[float, float | None, float, float]:
    """Diameter, no height, width, mass: J = mD²/8."""
    shape, density = given.shape, given.material.density
    assert isinstance(shape, Disc)
    if shape.diameter is not None:
        diameter = shape.diameter
        width = disc_width(inertia, diameter, density)
    else:
        diameter = disc(inertia, shape.width, density)
        width = shape.width * diameter
    return diameter, None, width, 8 * inertia / diameter**2


def _rim(given: Given, inertia: float) -> tuple[float, float | None, float, float]:
    """Mean diameter, height, width, mass of the rim, which has what spokes and hub leave: J = m(D² + h²)/4."""
    shape, density = given.shape, given.material.density
    assert isinstance(shape, Rim)
    own = inertia * (1 - shape.spokes)
    if shape.diameter is not None:
        diameter = shape.diameter
        height = rim_height(own, diameter, shape.width, density)
    else:
        diameter = rim(own, shape.height, shape.width, density)
        height = shape.height * diameter
    width = shape.width * height
    return diameter, height, width, math.pi * density * diameter * height * width
