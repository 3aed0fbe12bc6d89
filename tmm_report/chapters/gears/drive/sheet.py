"""The diagram of linear velocities of a drive as it is drawn: points found one from another, lines through them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from tmm_report.chapters.gears.drive.places import SAME, Spot
from tmm_report.mechanics.gears.trains import Train
from tmm_report.quantity.paper import Pen, rounded


class Line(NamedTuple):
    """The line of a body in the diagram of linear velocities, mm of paper: two of its points (v, y).

    `members`: all that turn with it; `s`: its segment of the plan of angular velocities as read, mm, signed.
    """

    members: tuple[str, ...]
    ends: tuple[complex, complex]
    s: float


class Sheet:
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
        """A velocity, and those that a belt or a chain carries over from it."""
        if spot.name in self.v:
            return
        self.v[spot.name] = self.pen.place(complex(v, 0)).real
        for other in self.spots:
            if other.tied == spot.name:
                self._put(other, v * other.share)
            elif other.name == spot.tied:
                self._put(other, v / spot.share)

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
