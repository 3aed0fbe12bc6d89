"""Diagrams of linear and angular velocities of a drive, constructed on paper and read off.

All axes lie in one plane; y is measured along it from the axis of the input shaft. The velocity of a point of a member
is linear in y, so that two points give the member's line: the velocity of the driving member is laid off, points in
mesh and axes of satellites are common to two members, fixed axes and fixed wheels give zeros.

        y │  .B   the line of a satellite passes through A and C
          │.' .A
        O └────── v

Rays from the pole P parallel to the lines cut off on a straight line at the pole distance H segments s that are
in proportion to the angular velocities. Source: Artobolevsky, Theory of mechanisms and machines, ch. VII.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from tmm_report.chapters.drive.stages import Stage, member
from tmm_report.chapters.plans.solve import Comparison
from tmm_report.mechanics.trains import FRAME, Member, Mesh, Train
from tmm_report.quantity.paper import Pen, round_scale, rounded

# mm: the scheme's height, the largest velocity, the plan of angular velocities
TALL, WIDE, LONG = 150.0, 90.0, 155.0
POLE = 60.0  # mm: the largest pole distance
LETTERS = "ABCDEFGKLMNQRSTUVWXYZ"  # names of points; H is a carrier, O an axis, P the pole
SAME = 1e-9  # m: points nearer than this are one


@dataclass(frozen=True)
class Scales:
    """Of paper: `length` m/mm, `velocity` (m/s)/mm, `angular` (rad/s)/mm; None: round, to fit the paper."""

    length: float | None = None
    velocity: float | None = None
    angular: float | None = None


class Spot(NamedTuple):
    """A named point common to two members: a pitch point or the axis of a satellite. `y` m from the main axis."""

    name: str
    y: float
    members: tuple[str, str]
    axis: bool


class Line(NamedTuple):
    """The line of a body in the diagram of linear velocities, mm of paper: two of its points (v, y).

    `members`: all that turn with it; `s`: its segment of the plan of angular velocities as read, mm, signed.
    """

    members: tuple[str, ...]
    ends: tuple[complex, complex]
    s: float


@dataclass(frozen=True, eq=False)
class Plans:
    """The constructed diagrams. `velocity`: of the spots by name, mm as read, signed; `axes`: m, y of each member's
    axis; `sides`: of each stage, +1 where its satellites stand above the main axis; `first`: the spot of the input
    member whose velocity is laid off; `accuracy` mm."""

    length_scale: float
    velocity_scale: float
    angular_scale: float
    accuracy: float
    axes: Mapping[str, float]
    sides: tuple[int, ...]
    spots: tuple[Spot, ...]
    velocity: Mapping[str, float]
    lines: tuple[Line, ...]
    first: Spot
    comparison: tuple[Comparison, ...] = ()

    @property
    def pole(self) -> float:
        """The pole distance H, mm."""
        return self.velocity_scale / (self.length_scale * self.angular_scale)

    def segment(self, member: str) -> float:
        """The segment s of a member in the plan of angular velocities, mm, signed."""
        return next(line.s for line in self.lines if member in line.members)

    def ratio(self, one: str, other: str) -> float:
        """The ratio of two members' speeds by their segments; inf where the second is zero."""
        below = self.segment(other)
        return self.segment(one) / below if below else float("inf")


def draw(
    stages: Sequence[Stage],
    train: Train,
    known: Mapping[str, float],
    speed: Mapping[str, float],
    scales: Scales,
    accuracy: float,
) -> Plans:
    """Construct and read the diagrams from the speeds `known` alone, rad/s; `speed`, of all the members, serves to
    choose the scales and to compare. `accuracy`: m of paper."""
    sides, axes = placed(stages)
    spots = tuple(_spots(stages, axes))
    analytic = {spot.name: _velocity(spot, train.by_name, axes, speed) for spot in spots}
    chosen = _chosen(scales, _height(stages, axes, sides), analytic.values(), speed.values())
    pen = Pen(accuracy)
    sheet = _Sheet(train, axes, spots, chosen, pen)
    sheet.construct(known)
    velocity = {spot.name: float(rounded(sheet.v[spot.name], pen.read_step)) for spot in spots}
    plans = Plans(
        chosen["length"],
        chosen["velocity"],
        chosen["angular"],
        pen.read_step,
        axes,
        sides,
        spots,
        velocity,
        tuple(sheet.lines()),
        sheet.farthest(stages[0].input),
    )
    return replace(plans, comparison=tuple(_compared(plans, analytic, speed)))


# --- where the members stand


def placed(stages: Sequence[Stage]) -> tuple[tuple[int, ...], dict[str, float]]:
    """The side of each stage and the y of every member's axis, m.

    A planetary stage stands above the input shaft, else below its own axis; the driven shaft of a pair below.
    """
    main, sides, axes = 0.0, [], {}
    for stage in stages:
        planetary = any(one.kind == "carrier" for one in stage.members)
        side = 1 if planetary and main == 0 and 1 not in sides else -1
        sides.append(side)
        start = member(stage, stage.input).distance
        for one in stage.members:
            axes[one.name] = main + side * (one.distance - start)
        main = axes[stage.output]
    return tuple(sides), axes


def _height(stages: Sequence[Stage], axes: Mapping[str, float], sides: Sequence[int]) -> float:
    """How tall the scheme is, m; of a planetary stage's ring only the half with the satellite is drawn."""
    reach = [0.0]
    for stage, side in zip(stages, sides, strict=True):
        for one in stage.members:
            if one.kind != "carrier":
                reach.append(axes[one.name] + side * one.radius)
                halved = one.kind == "ring" and one.name not in (stage.input, stage.output)
                reach.append(axes[one.name] - (0 if halved else side * one.radius))
    return max(reach) - min(reach)


def _spots(stages: Sequence[Stage], axes: Mapping[str, float]) -> Iterator[Spot]:
    """Points of every stage: each mesh's pitch point, and after it the axis of its satellite."""
    letters = iter(_letters())
    for stage in stages:
        by_name = {one.name: one for one in stage.members}
        seen: list[float] = []
        for mesh in stage.meshes:
            yield Spot(next(letters), _contact(mesh, by_name, axes), (mesh.i, mesh.j), False)
            for wheel in (by_name[mesh.i], by_name[mesh.j]):
                y = axes[wheel.name]
                if wheel.carried_by != FRAME and all(abs(y - other) > SAME for other in seen):
                    seen.append(y)
                    yield Spot(next(letters), y, (wheel.name, wheel.carried_by), True)


def _letters() -> Iterator[str]:
    yield from LETTERS
    for number in range(1, 1000):
        yield from (f"{letter}{number}" for letter in LETTERS)


def _contact(mesh: Mesh, by_name: Mapping[str, Member], axes: Mapping[str, float]) -> float:
    """y of the pitch point: it divides the line of centres in the ratio of the radii, outside it if internal."""
    ri, rj = by_name[mesh.i].radius, by_name[mesh.j].radius
    return axes[mesh.i] + (axes[mesh.j] - axes[mesh.i]) * ri / (ri - rj if mesh.internal else ri + rj)


def _velocity(
    spot: Spot, by_name: Mapping[str, Member], axes: Mapping[str, float], speed: Mapping[str, float]
) -> float:
    """Analytical velocity of a spot, m/s: of the axis of the first wheel there and about it."""
    wheel = by_name[spot.members[0]]
    turned = 0.0 if spot.axis else speed[wheel.name] * (spot.y - axes[wheel.name])
    carried = (
        speed[wheel.carried_by] * (axes[wheel.name] - axes[wheel.carried_by]) if wheel.carried_by else 0.0
    )
    return float(turned + carried)


# --- the construction


class _Sheet:
    """Points (v, y) of each body, mm of paper, found one from another as they are drawn."""

    def __init__(
        self,
        train: Train,
        axes: Mapping[str, float],
        spots: Sequence[Spot],
        scales: Mapping[str, float],
        pen: Pen,
    ):
        self.train, self.axes, self.spots, self.scales, self.pen = train, axes, spots, scales, pen
        self.v: dict[str, float] = {}
        self.ends: dict[str, tuple[complex, complex]] = {}

    def construct(self, known: Mapping[str, float]) -> None:
        """Lay off what is known, then draw the line of every body of which two points are there."""
        for name, omega in known.items():
            self._lay_off(name, omega)
        while missing := [body for body in self.train.bodies if body not in self.ends]:
            ready = [(body, ends) for body in missing if (ends := self._two_points(body))]
            if not ready:
                raise ValueError(f"the diagram has no two points of the members {missing}")
            for body, ends in ready:
                self._draw(body, ends)

    def _lay_off(self, name: str, omega: float) -> None:
        """The velocity of the spot of the member farthest from its axis; the axis itself stands still."""
        spot = self.farthest(name)
        arm = spot.y - self.axes[name]
        self._put(spot, omega * arm / self.scales["velocity"])

    def farthest(self, name: str) -> Spot:
        """The spot of a member that is farthest from its axis."""
        spots = self._of(self.train.by_name[name].body)
        return max(spots, key=lambda spot: abs(spot.y - self.axes[name]))

    def _put(self, spot: Spot, v: float) -> None:
        self.v.setdefault(spot.name, self.pen.place(complex(v, 0)).real)

    def _of(self, body: str) -> list[Spot]:
        """The spots that belong to a body."""
        names = {member.name for member in self.train.members if member.body == body}
        return [spot for spot in self.spots if names & set(spot.members)]

    def _two_points(self, body: str) -> tuple[complex, complex] | None:
        """The two known points of the body that are farthest apart: an axis that stands still is one."""
        member = next(m for m in self.train.members if m.body == body)
        points = [complex(0, self._paper(self.axes[member.name]))] if not member.carried_by else []
        points += [
            complex(self.v[spot.name], self._paper(spot.y)) for spot in self._of(body) if spot.name in self.v
        ]
        low, high = min(points, key=_height_of, default=0j), max(points, key=_height_of, default=0j)
        return (low, high) if high.imag - low.imag > SAME else None

    def _paper(self, y: float) -> float:
        """A height on paper, mm."""
        return self.pen.place(complex(0, y / self.scales["length"])).imag

    def _draw(self, body: str, ends: tuple[complex, complex]) -> None:
        self.ends[body] = ends
        for spot in self._of(body):
            self._put(spot, _at(ends, self._paper(spot.y)).real)

    def lines(self) -> Iterator[Line]:
        """The line of every body with its segment, cut off by the ray from the pole."""
        pole = self.scales["velocity"] / (self.scales["length"] * self.scales["angular"])
        for body in self.train.bodies:
            low, high = self.ends[body]
            slope = (high - low).real / (high - low).imag
            names = tuple(member.name for member in self.train.members if member.body == body)
            s = self.pen.place(complex(pole * slope, 0)).real
            yield Line(names, self.ends[body], float(rounded(s, self.pen.read_step)))


def _height_of(point: complex) -> float:
    return point.imag


def _at(ends: tuple[complex, complex], y: float) -> complex:
    """The point of a line at a height."""
    low, high = ends
    return complex(low.real + (high - low).real * (y - low.imag) / (high - low).imag, y)


# --- scales and comparison


def _chosen(
    scales: Scales, tall: float, velocities: Iterable[float], speeds: Iterable[float]
) -> dict[str, float]:
    """The stated scales, or round ones that fit the paper, the pole distance too."""
    length = scales.length or round_scale(tall, TALL)
    velocity = scales.velocity or round_scale(_span(velocities), WIDE)
    angular = max(round_scale(_span(speeds), LONG), round_scale(velocity / length, POLE))
    return {"length": length, "velocity": velocity, "angular": scales.angular or angular}


def _span(values: Iterable[float]) -> float:
    """From the least to the largest, zero among them."""
    values = [0.0, *values]
    return max(values) - min(values)


def _compared(
    plans: Plans, analytic: Mapping[str, float], speed: Mapping[str, float]
) -> Iterator[Comparison]:
    """Magnitudes by the diagrams against the analytical ones: velocities of the spots, then angular velocities."""
    scale, step = plans.velocity_scale, plans.accuracy
    for name, v in plans.velocity.items():
        yield Comparison(f"v_{name}", abs(v) * scale, abs(analytic[name]), scale * step)
    scale = plans.angular_scale
    for line in plans.lines:
        name = line.members[0]
        yield Comparison(f"w_{name}", abs(line.s) * scale, abs(speed[name]), scale * step)
