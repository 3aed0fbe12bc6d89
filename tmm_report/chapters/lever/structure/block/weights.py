"""What the links weigh, worked out where the file states it by lengths and by the masses of other links.

links:
  2: {points: {A: 0, B: 0.3}, mass: 30 kg/m, inertia: m*l^2/12}
  3: {points: {B: 0}, mass: 0.5*m2}
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping

from tmm_report.chapters.lever.structure.block import models as m
from tmm_report.chapters.lever.structure.block.geometry import Circular, Geometry
from tmm_report.chapters.lever.structure.block.synthesised import Elsewhere, taken
from tmm_report.mechanics.lever.stated_masses import (
    LengthOf,
    Letter,
    MassOf,
    PerLength,
    Segment,
    Statement,
    Synthesised,
    lettered,
    worked,
)
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue

MOST = 1e12  # kg, kg m²


class Weights:
    """Masses, kg, and moments of inertia, kg m², of links; each is worked out when it is asked for. They raise
    WrongValue where a statement cannot be worked out."""

    def __init__(self, geometry: Geometry):
        self.geometry, self.links = geometry, geometry.links

    def mass(self, name: str, asking: tuple[str, ...] = ()) -> float:
        """`asking`: the links whose masses are worked out by this one."""
        stated = self.links[name].mass
        if isinstance(stated, float):
            return stated
        if name in asking:
            links = asking[asking.index(name) :]
            if links == (name,):
                wrong = N_("the mass of link %(names)s is stated by itself")
                right = N_("a mass, 30 kg/m of its length, or the mass of another link: 0.3*m2")
                raise Circular(links, wrong, right)
            wrong = N_("the masses of links %(names)s are stated by one another")
            raise Circular(links, wrong, N_("state one of them as a number"))
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
        if isinstance(letter, Synthesised):
            return taken(letter, self.geometry.synthesis).number
        if isinstance(letter, LengthOf):
            letter = self.geometry.segment(letter, own, self.geometry.points(own))
        if isinstance(letter, Segment):
            points = self.geometry.points(letter.link)
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
                return self.geometry.segment(letter, own, self.geometry.points(own))
            if isinstance(letter, Synthesised):
                return taken(letter, self.geometry.synthesis)
            return MassOf(letter.link or own) if isinstance(letter, MassOf) else letter

        return None if isinstance(stated, float) else lettered(stated, named)


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
