"""Where the points of the links are, worked out where the file states a length by another: `S2: 0.4*l_AB`."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping

from tmm_report.chapters.lever.structure.block import models as m
from tmm_report.chapters.lever.structure.block.synthesised import Elsewhere, Taken, one_of, taken
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.stated_masses import (
    LengthOf,
    Letter,
    Segment,
    Statement,
    Synthesised,
    lettered,
    letters,
    worked,
)
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue

LONGEST = 1e6  # m
Points = Mapping[str, complex]
"""Of a link, in its own axes, m."""


class Circular(WrongValue):
    """What is stated of `links` by one another."""

    def __init__(self, links: tuple[str, ...], wrong: str, right: str):
        super().__init__(Message(wrong, {"names": ", ".join(links)}), Message(right))
        self.links = links


class Geometry:
    """Points of the links; those of a link are worked out when they are first asked for. They raise WrongValue where a
    triangle does not close or a statement cannot be worked out."""

    def __init__(self, links: Mapping[str, m.LinkModel], frame: Points, synthesis: Taken = None):
        self.links, self.frame, self.synthesis = links, frame, synthesis
        self._known: dict[str, Points] = {}

    def points(self, name: str, asking: tuple[str, ...] = ()) -> Points:
        """`asking`: the links whose points are worked out by these."""
        if name == FRAME:
            return self.frame
        if name not in self._known:
            if name in asking:
                wrong = N_("the lengths of links %(names)s are stated by one another")
                raise Circular(asking[asking.index(name) :], wrong, N_("state one of them as a number"))
            placed: dict[str, complex] = {}
            for point in self.links[name].points:
                placed[point] = self.place(name, point, placed, asking)
            self._known[name] = placed
        return self._known[name]

    def places(self) -> dict[str, Points]:
        """Of every link, the frame among them."""
        return {FRAME: self.frame, **{name: self.points(name) for name in self.links}}

    def place(self, name: str, point: str, placed: Points, asking: tuple[str, ...] = ()) -> complex:
        """Of a point in the axes of its link; `placed`: the link's points before it."""
        points = self.links[name].points
        if isinstance(points, list):
            return 0j
        written = points[point]
        if isinstance(written, m.Triangle):
            sides = {end: self._size(side, name, placed, asking) for end, side in written.from_.items()}
            return triangle(sides, written.side, placed)
        if isinstance(written, m.Corner):
            return _corner(written, self._size(written.distance, name, placed, asking), placed)
        parts = written if isinstance(written, tuple) else (written,)
        return complex(*(self._size(part, name, placed, asking) for part in parts))

    def _size(self, stated: float | Statement, own: str, placed: Points, asking: tuple[str, ...]) -> float:
        if isinstance(stated, float):
            return stated

        def length(letter: Letter) -> float:
            if isinstance(letter, Synthesised):
                return taken(letter, self.synthesis).number
            assert isinstance(letter, LengthOf)  # the grammar of lengths has no other
            found = self.segment(letter, own, placed, (*asking, own))
            points = placed if found.link == own else self._others(found.link, (*asking, own))
            return abs(points[found.second] - points[found.first])

        try:
            size = float(worked(stated, length))
        except (ZeroDivisionError, OverflowError):
            size = math.inf
        if abs(size) <= LONGEST:
            return size
        raise WrongValue(Message(N_("this comes to %(size)s m, which no link has"), {"size": f"{size:.4g}"}))

    def _others(self, name: str, asking: tuple[str, ...]) -> Points:
        """Points of another link: what is wrong of them is told there."""
        try:
            return self.points(name, asking)
        except Circular:
            raise
        except WrongValue as error:
            raise Elsewhere(error.wrong) from None

    def segment(self, letter: LengthOf, own: str, placed: Points, asking: tuple[str, ...] = ()) -> Segment:
        """The segment that a letter names in a statement of the link `own`, some of whose points are placed."""
        halves = list(_halves(letter.name))
        if ends := next((ends for ends in halves if ends[0] in placed and ends[1] in placed), None):
            return Segment(own, *ends)
        complete = len(placed) == len(self.links[own].points)
        name = letter.name or (own if complete else "")
        if name in self.links and (name != own or complete):
            return self._whole(name, placed if name == own else self._others(name, asking))
        for link in (FRAME, *self.links):
            named = self.frame if link == FRAME else self.links[link].points
            for first, second in halves:
                if link != own and first in named and second in named:
                    return Segment(link, first, second)
        if not name:
            wrong = Message(N_("of a length that follows from another it must be said from which"))
            raise WrongValue(wrong, Message(N_("a number of other lengths, such as 0.4*l_AB")))
        wrong = Message(N_("no link has two points whose names make %(name)s"), {"name": name})
        before = [f"l_{a}{b}" for a, b in _pairs(placed)]
        raise WrongValue(wrong, one_of(before) if before else Message(N_("give its place above")))

    def _whole(self, name: str, points: Points) -> Segment:
        """From end to end of a link that has one length."""
        centre = self.links[name].mass_centre
        ends = [point for point in points if point != centre or len(points) <= 2]
        if len(ends) == 2:
            return Segment(name, *ends)
        wrong = N_("link %(name)s has several lengths") if ends[1:] else N_("link %(name)s has no length")
        others = [points] if ends[1:] else [self.frame, *self._known.values()]
        lengths = [f"l_{a}{b}" for of in others for a, b in _pairs(of)]
        raise WrongValue(Message(wrong, {"name": name}), one_of(lengths))

    def stated(self, name: str) -> dict[str, Statement]:
        """Points of a link whose places are stated by other lengths, and how, with the segments that are named."""
        points, placed = self.links[name].points, dict[str, complex]()
        found = dict[str, Statement]()
        if isinstance(points, list):
            return found
        for point, written in points.items():
            if not isinstance(written, float | tuple | m.Triangle | m.Corner):
                found[point] = lettered(written, lambda letter: self._named(letter, name, placed))
            placed[point] = self.points(name)[point]
        return found

    def _named(self, letter: Letter, own: str, placed: Points) -> Letter:
        if isinstance(letter, Synthesised):
            return taken(letter, self.synthesis)
        return self.segment(letter, own, placed) if isinstance(letter, LengthOf) else letter


def mentioned(written: object) -> set[str]:
    """Names of points that the place of another one is stated by, with what else its letters could be read as."""
    if isinstance(written, m.Triangle):
        return {*written.from_, *(name for side in written.from_.values() for name in mentioned(side))}
    if isinstance(written, m.Corner):
        ends = (written.about, written.to)
        return {*mentioned(written.distance), *(name for name in ends if name is not None)}
    if isinstance(written, tuple):
        return {name for part in written for name in mentioned(part)}
    if isinstance(written, float):
        return set()
    names = [letter.name for letter in letters(written) if isinstance(letter, LengthOf)]  # type: ignore[arg-type]
    return {half for name in names for ends in _halves(name) for half in ends}


def _pairs(points: Points) -> Iterator[tuple[str, str]]:
    names = list(points)
    return ((a, b) for k, a in enumerate(names) for b in names[k + 1 :])


def _halves(name: str) -> Iterator[tuple[str, str]]:
    """A name that is made of two: O1A -> (O, 1A), (O1, A)."""
    return ((name[:k], name[k:]) for k in range(1, len(name)))


def _corner(written: m.Corner, distance: float, placed: Points) -> complex:
    """By a distance, m, and an angle. Raises WrongValue for a point that is not placed yet."""
    ends = [name for name in (written.about, written.to) if name is not None]
    _before(ends, placed)
    start = placed[written.about] if written.about is not None else next(iter(placed.values()), 0j)
    way = placed[written.to] - start if written.to is not None else 1 + 0j
    if not way:
        text = N_("the angle is counted from a direction: it leads from one point to another")
        raise WrongValue(Message(text), Message(N_("a point other than that of the distance")))
    return start + distance * way / abs(way) * cmath.exp(1j * written.angle)


def _before(names: Iterable[str], placed: Points) -> None:
    for name in names:
        if name not in placed:
            wrong = N_("the point %(name)s is not placed on this link before")
            raise WrongValue(Message(wrong, {"name": name}), Message(N_("give its place above")))


def triangle(sides: Mapping[str, float], side: str, placed: Points) -> complex:
    """The third corner: `along` the side from the first point and `off` it, left of it positive.

    `sides`: its distances from two points. Raises WrongValue for a corner that is not placed yet and for lengths that
    make no triangle.
    """
    (first, from_first), (second, from_second) = sides.items()
    _before((first, second), placed)
    base = placed[second] - placed[first]
    along = (from_first**2 - from_second**2 + abs(base) ** 2) / (2 * abs(base)) if base else math.inf
    square = from_first**2 - along**2
    if not square >= -1e-9 * abs(base) ** 2:
        values = {"a": first, "b": second, "length": f"{abs(base):.6g}"}
        wrong = N_("the triangle does not close: %(a)s and %(b)s are %(length)s m apart")
        right = Message(N_("the longest side must be shorter than the other two together"))
        raise WrongValue(Message(wrong, values), right)
    off = math.sqrt(max(square, 0.0)) * (1 if side == "left" else -1)
    return placed[first] + base / abs(base) * complex(along, off)
