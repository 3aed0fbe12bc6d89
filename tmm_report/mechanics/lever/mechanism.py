"""What a planar mechanism is: links with points in their own axes, guides, pairs and the driving link.

A link's axes are its own: a point's place in them is one complex number, m. The frame is link "0"; its axes
are the axes of the drawing (x to the right, y up). Lengths may be arrays of shape (V, 1) instead of numbers:
then one Mechanism stands for V variants of the same scheme and everything solved from it is (V, P).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.calculus.motion_laws import MotionLaw
    from tmm_report.mechanics.cams.cam import Cam
    from tmm_report.mechanics.lever.driving.stroke import Stroke
    from tmm_report.mechanics.lever.forces.force_on_crank_gear import GearDrive
    from tmm_report.mechanics.lever.stated_masses import Statement
    from tmm_report.mechanics.lever.wheels.mesh import Mesh

FRAME = "0"

Scalar = Any  # a number, or an array (V, 1) of numbers, one a variant


@dataclass(frozen=True)
class Said:
    """How the assignment states what a link weighs and measures, where it is by lengths and other masses: None of plain
    numbers."""

    mass: Statement | None = None
    inertia: Statement | None = None
    middle: tuple[str, str] | None = None  # the joints midway between which the mass centre is taken
    # of points whose places on the link's axis are stated by other lengths
    places: Mapping[str, Statement] = field(default_factory=dict)
    # of fixed points: name and "x" or "y" -> how that coordinate follows from a synthesis
    coordinates: Mapping[tuple[str, str], Statement] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Link:
    """A rigid link. `points`: name -> place in the link's axes, complex, m. SI throughout."""

    name: str
    points: Mapping[str, Scalar]
    mass: Scalar = 0.0
    mass_centre: str | None = None  # the name of one of `points`
    inertia: Scalar = 0.0  # about the mass centre, kg m²
    # a point and the moment of inertia about it, where that is stated
    stated: tuple[str, float] | None = None
    said: Said | None = None


@dataclass(frozen=True, eq=False)
class Guide:
    """A straight guide carried by `link` (the frame or a moving one): a line in that link's axes."""

    name: str
    link: str
    through: Scalar  # a point of the line, complex, m
    direction: Scalar  # unit complex


@dataclass(frozen=True, eq=False)
class Slide:
    """A prismatic pair: `link` slides along `guide`. The same line, seen in the sliding link's axes."""

    link: str
    guide: str
    through: Scalar = 0.0  # the point of the sliding link that lies on the guide, complex, m
    direction: Scalar = 1.0  # unit complex: the guide's direction in the sliding link's axes


@dataclass(frozen=True)
class ZeroAngle:
    """Position 0 is where the driving link's x axis makes this angle with the x axis, rad."""

    angle: float


@dataclass(frozen=True)
class ZeroExtreme:
    """Position 0 is an extreme position: of `point` in `direction` (unit complex), or, with `direction`
    +1 (counter-clockwise) or -1 (clockwise), of the rocker `link`."""

    point: str | None = None
    link: str | None = None
    direction: complex = 1.0


@dataclass(frozen=True, eq=False)
class Driver:
    """The driving link turns about a fixed point at constant `omega`, rad/s, + counter-clockwise, or by a `law` of the
    time: then `omega` is that of the phase 2π t/T, which goes once round with the law, and angles "turned" are phases.
    Where a slider or a cylinder drives, `stroke`, it is the link that turns as the stroke says, the first to be known.
    """

    link: str
    omega: Scalar
    zero: ZeroAngle | ZeroExtreme = ZeroAngle(0.0)
    sweep: float = 2 * np.pi  # how far it turns, rad; less than a full turn for a rocker
    turns: int = 1  # full turns in a cycle: the motion repeats with each of them, the loads with the cycle
    gear: GearDrive | None = None  # by which it is turned; None: a moment on its shaft
    period: float | None = None  # time of one turn, s, where the speed is stated by it
    law: MotionLaw | None = None
    stroke: Stroke | None = None

    @property
    def goes_round(self) -> bool:
        """Whether a cycle is one of full turns, all in one sense: not a swing, nor a law that does not repeat."""
        if self.law is not None:
            return self.law.returns and abs(self.law.advance) > 1.0
        return bool(self.sweep >= 2 * np.pi - 1e-12)


@dataclass(frozen=True)
class Assembly:
    """Which of two roots a dyad takes.

    `key` names the group: its inner point ("B") or its links ("2-3"). `choice`: +1 or -1 (see `dyads`), a unit
    complex number, the side of the guide on which the inner joint lies, or ("left" | "right", P, Q): the inner
    joint lies on that side of the line from point P to point Q.
    """

    key: str
    choice: int | complex | tuple[Literal["left", "right"], str, str]


@dataclass(frozen=True, eq=False)
class Mechanism:
    """A mechanism as its drawing describes it; nothing about Assur groups is declared.

    `links` holds the frame under "0" and the moving links in the order of the description. Points with the same
    name on several links are revolute pairs. `sketch`: rough places of points in some one position, m.
    """

    links: Mapping[str, Link]
    driver: Driver
    guides: Mapping[str, Guide] = field(default_factory=dict)
    slides: Sequence[Slide] = ()
    assembly: Sequence[Assembly] = ()
    sketch: Mapping[str, complex] = field(default_factory=dict)
    cams: tuple[Cam, ...] = ()
    meshes: tuple[Mesh, ...] = ()  # gear pairs and racks

    @property
    def real(self) -> Mechanism:
        """The mechanism as it is built: with its cam pairs, without the links and points that replace them."""
        if not self.cams:
            return self
        put, lines = {cam.name for cam in self.cams}, {cam.guide for cam in self.cams}
        centres = {cam.centre for cam in self.cams}
        links = {
            name: replace(link, points={p: at for p, at in link.points.items() if p not in centres})
            for name, link in self.links.items()
            if name not in put
        }
        guides = {name: guide for name, guide in self.guides.items() if name not in lines}
        slides = tuple(slide for slide in self.slides if slide.link not in put)
        return replace(self, links=links, guides=guides, slides=slides)

    @property
    def moving(self) -> list[str]:
        return [name for name in self.links if name != FRAME]

    def links_at(self, point: str) -> list[str]:
        """Names of the links that share the point, in the order of the description."""
        return list(self._links_of.get(point, ()))

    @property
    def point_names(self) -> list[str]:
        return list(self._links_of)

    @cached_property
    def _links_of(self) -> dict[str, list[str]]:
        """The links of each point, in the order of the description."""
        found: dict[str, list[str]] = {}
        for name, link in self.links.items():
            for point in link.points:
                found.setdefault(point, []).append(name)
        return found

    @cached_property
    def shared(self) -> tuple[str, ...]:
        """The points that several links have."""
        return tuple(point for point, links in self._links_of.items() if len(links) > 1)

    @cached_property
    def shared_by(self) -> dict[str, tuple[int, ...]]:
        """Of each link the places in `shared` of the points that it has in common with others."""
        return {
            name: tuple(k for k, point in enumerate(self.shared) if point in link.points)
            for name, link in self.links.items()
        }


def pick(mechanism: Mechanism, v: int) -> Mechanism:
    """One variant, by number, of a mechanism whose numbers are arrays (V, 1)."""

    def one(x: Any) -> Any:
        return x[v, 0].item() if isinstance(x, np.ndarray) and x.ndim == 2 else x

    links = {
        name: replace(
            link,
            points={point: one(at) for point, at in link.points.items()},
            mass=one(link.mass),
            inertia=one(link.inertia),
        )
        for name, link in mechanism.links.items()
    }
    guides = {
        name: replace(g, through=one(g.through), direction=one(g.direction))
        for name, g in mechanism.guides.items()
    }
    slides = [replace(s, through=one(s.through), direction=one(s.direction)) for s in mechanism.slides]
    gear = mechanism.driver.gear
    if gear is not None:
        gear = replace(gear, radius=one(gear.radius), pressure=one(gear.pressure), at=one(gear.at))
    driver = replace(mechanism.driver, omega=one(mechanism.driver.omega), gear=gear)
    return replace(mechanism, links=links, guides=guides, slides=slides, driver=driver)
