"""What the links weigh, worked out where the file states it by lengths and by the masses of other links.

links:
  2: {points: {A: 0, B: 0.3}, mass: 30 kg/m, inertia: m*l^2/12}
  3: {points: {B: 0}, mass: 0.5*m2}
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping

from tmm_report.chapters.lever.structure.block import models as m
from tmm_report.mechanics.lever.stated_masses import (
    LengthOf,
    Letter,
    MassOf,
    PerLength,
    Segment,
    Statement,
    lettered,
    worked,
)
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue

Places = Mapping[str, Mapping[str, complex]]
"""Of every link, the frame among them, its points in its own axes, m."""
MOST = 1e12  # kg, kg m²


class Elsewhere(WrongValue):
    """What is wrong of another link, and is told there."""


class Circular(WrongValue):
    """Masses that are stated by one another: those of `links`."""

    def __init__(self, links: tuple[str, ...]):
        wrong = N_("the masses of links %(names)s are stated by one another")
        right = Message(N_("state one of them as a number"))
        if len(links) == 1:
            wrong = N_("the mass of link %(names)s is stated by itself")
            right = Message(N_("a mass, 30 kg/m of its length, or the mass of another link: 0.3*m2"))
        super().__init__(Message(wrong, {"names": ", ".join(links)}), right)
        self.links = links


class Weights:
    """Masses, kg, and moments of inertia, kg m², of links; each is worked out when it is asked for. They raise
    WrongValue where a statement cannot be worked out."""

    def __init__(self, links: Mapping[str, m.LinkModel], places: Places):
        self.links, self.places = links, places

    def mass(self, name: str, asking: tuple[str, ...] = ()) -> float:
        """`asking`: the links whose masses are worked out by this one."""
        stated = self.links[name].mass
        if isinstance(stated, float):
            return stated
        if name in asking:
            raise Circular(asking[asking.index(name) :])
        return self._worked(stated, name, (*asking, name), "kg")

    def inertia(self, name: str) -> float:
        """As it is stated: about the mass centre, or about the point that is named."""
        stated = inertia_of(self.links[name])
        return stated if isinstance(stated, float) else self._worked(stated, name, (), "kg·m²")

    def _worked(self, stated: Statement, own: str, asking: tuple[str, ...], unit: str) -> float:
        try:
            size = float(worked(stated, lambda letter: self.size(letter, own, asking)))
        except (ZeroDivisionError, OverflowError):
            size = math.inf
        if 0 <= size <= MOST:
            return size
        wrong = N_("this comes to %(size)s %(unit)s, which no link has")
        raise WrongValue(Message(wrong, {"size": f"{size:.4g}", "unit": unit}))

    def size(self, letter: Letter, own: str, asking: tuple[str, ...] = ()) -> float:
        """What a letter in a statement of the link `own` stands for, SI."""
        if isinstance(letter, PerLength):
            return letter.value
        if isinstance(letter, LengthOf):
            letter = self.segment(letter, own)
        if isinstance(letter, Segment):
            points = self.places[letter.link]
            return abs(points[letter.second] - points[letter.first])
        link = letter.link or own
        if link not in self.links:
            right = Message(N_("one of %(words)s"), {"words": ", ".join(f"m{name}" for name in self.links)})
            raise WrongValue(Message(N_("there is no link %(name)s"), {"name": link}), right)
        try:
            return self.mass(link, asking)
        except Circular:
            raise
        except WrongValue as error:
            raise Elsewhere(error.wrong) from None

    def told(self, stated: float | Statement, own: str) -> Statement | None:
        """The statement with the names of links and points that its letters stand for; None of a plain number."""

        def named(letter: Letter) -> Letter:
            if isinstance(letter, LengthOf):
                return self.segment(letter, own)
            return MassOf(letter.link or own) if isinstance(letter, MassOf) else letter

        return None if isinstance(stated, float) else lettered(stated, named)

    def segment(self, letter: LengthOf, own: str) -> Segment:
        """The segment whose length a letter in a statement of the link `own` stands for."""
        if not letter.name:
            return self._whole(own)
        for link in (own, *self.places):
            for first, second in _halves(letter.name):
                points = self.places.get(link, {})
                if first in points and second in points:
                    return Segment(link, first, second)
            if link == own and letter.name in self.links:
                return self._whole(letter.name)
        wrong = N_("no link has two points whose names make %(name)s")
        raise WrongValue(Message(wrong, {"name": letter.name}), self._lengths(own))

    def _whole(self, name: str) -> Segment:
        """From end to end of a link that has one length."""
        points, centre = self.places.get(name, {}), self.links[name].mass_centre
        ends = [point for point in points if point != centre or len(points) <= 2]
        if len(ends) == 2:
            return Segment(name, *ends)
        wrong = N_("link %(name)s has several lengths") if ends[1:] else N_("link %(name)s has no length")
        raise WrongValue(Message(wrong, {"name": name}), self._lengths(name))

    def _lengths(self, name: str) -> Message:
        """The lengths that a statement can name: those of the link, or else of all links."""
        own = [f"l_{a}{b}" for a, b in _pairs(self.places.get(name, {}))]
        every = own or [f"l_{a}{b}" for points in self.places.values() for a, b in _pairs(points)]
        return Message(N_("one of %(words)s"), {"words": ", ".join(every[:6])})


def _halves(name: str) -> Iterator[tuple[str, str]]:
    """A name that is made of two: O1A -> (O, 1A), (O1, A)."""
    return ((name[:k], name[k:]) for k in range(1, len(name)))


def _pairs(points: Mapping[str, complex]) -> Iterator[tuple[str, str]]:
    names = list(points)
    return ((a, b) for k, a in enumerate(names) for b in names[k + 1 :])


def inertia_of(link: m.LinkModel) -> float | Statement:
    """As it is stated, about whichever point."""
    return link.inertia.value if isinstance(link.inertia, m.InertiaModel) else link.inertia


def in_the_middle(name: str, heavy: bool, centre: object, points: Mapping[str, Collection[str]]) -> str:
    """What the mass centre is called that a heavy link of two joints has in their middle where none is stated; "" where
    it has none. `points`: of every link, the frame among them; a joint is a point of several."""
    own = points[name]
    joints = [point for point in own if sum(point in others for others in points.values()) > 1]
    if not heavy or centre is not None or len(own) != 2 or len(joints) != 2:
        return ""
    middle = f"S{name}"
    return "" if middle in points or any(middle in others for others in points.values()) else middle
