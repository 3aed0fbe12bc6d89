"""Diagrams of linear and angular velocities of a train whose parallel axes lie in one plane as they are drawn.

The velocity of a point of a member is linear in its height above the main axis; pitch points and axes of satellites are
common to two members. A pitch point divides the distance of its axes in the ratio of the teeth.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from tmm_report.chapters.gears.train.solve.built import Built
from tmm_report.chapters.gears.train.solve.places import Places
from tmm_report.quantity.paper import round_scale
from tmm_report.records import dataclass

LETTERS = "ABCDEFGKLMNQRSTUVWXYZ"  # H is a carrier, O an axis, P the pole
WIDE, LONG, POLE = 50.0, 110.0, 40.0  # mm: velocities, angular velocities, pole distance
SAME = 1e-9


class Spot(NamedTuple):
    """A point common to two members, `y` m above the main axis, with its velocity, m/s."""

    name: str
    y: float
    members: tuple[str, str]
    v: float


@dataclass(frozen=True, eq=False)
class Plans:
    """Scales, SI units per mm; `spots`; of each body its velocity at the height 0, m/s, its speed, and the heights
    between which its line goes."""

    places: Places
    length: float
    velocity: float
    angular: float
    spots: tuple[Spot, ...]
    lines: Mapping[str, tuple[float, float, float, float]]

    @property
    def pole(self) -> float:
        """The pole distance, mm."""
        return self.velocity / (self.length * self.angular)


def plans_of(built: Built, places: Places, speed: Mapping[str, float]) -> Plans | None:
    """None where axes lie across, or a chain of satellites is bent."""
    if not places.plane:
        return None
    train = built.train
    lines = {}
    for body in train.bodies:
        first = next(m for m in train.members if m.body == body)
        y, omega = places.height[first.name], speed[first.name]
        carried = speed[first.carried_by] * y if first.carried_by else 0.0
        lines[body] = (carried - omega * y, omega, y)
    spots = tuple(_spots(built, places, lines))
    velocity = round_scale(_span(spot.v for spot in spots), WIDE)
    length = places.scale
    angular = max(round_scale(_span(speed.values()), LONG), round_scale(velocity / length, POLE))
    reached = {}
    for body, (at_zero, omega, y) in lines.items():
        names = {m.name for m in train.members if m.body == body}
        heights = [spot.y for spot in spots if names & set(spot.members)]
        ends = [*heights, y]
        reached[body] = (at_zero, omega, min(ends), max(ends))
    return Plans(places, length, velocity, angular, spots, reached)


def _span(values: Iterator[float] | Mapping[str, float] | object) -> float:
    numbers = [0.0, *values]  # type: ignore[misc]
    return max(numbers) - min(numbers)


def _spots(built: Built, places: Places, lines: Mapping[str, tuple[float, float, float]]) -> Iterator[Spot]:
    """Every pitch point, and after it the axis of its satellite."""
    letters = (one + mark for mark in ("", "1", "2") for one in LETTERS)
    train = built.train
    seen: list[float] = []
    for mesh in train.meshes:
        one, other = places.height[mesh.i], places.height[mesh.j]
        z_i, z_j = (train.by_name[name].teeth for name in (mesh.i, mesh.j))
        share = z_i / (z_i - z_j if mesh.internal else z_i + z_j)
        y = one + (other - one) * share
        yield Spot(next(letters), y, (mesh.i, mesh.j), _at(lines[built.body(mesh.i)], y))
        for name in (mesh.i, mesh.j):
            member = train.by_name[name]
            axis = places.height[name]
            if member.carried_by and all(abs(axis - place) > SAME for place in seen):
                seen.append(axis)
                v = _at(lines[built.body(member.carried_by)], axis)
                yield Spot(next(letters), axis, (name, member.carried_by), v)


def _at(line: tuple[float, float, float], y: float) -> float:
    return line[0] + line[1] * y
