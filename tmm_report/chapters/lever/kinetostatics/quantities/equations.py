"""The equations of equilibrium of a group at one position, with numbers: what is solved together for its reactions.

Of each link ΣFx = 0, ΣFy = 0 and ΣM = 0 about a named point, of each guide that its force is normal to it. The numbers
of the unknowns are put in for the residual. A second way to the reactions: the
conditions are taken from the loads and places alone, not from the order in which a dyad is solved.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.quantities.driving_gear import WAY as ANGLE_OF_LINE
from tmm_report.chapters.lever.kinetostatics.quantities.driving_stroke import FORCE as DRIVING
from tmm_report.chapters.lever.kinetostatics.quantities.positions import (
    BALANCING_MOMENT,
    BASE_RADIUS,
    FORCE,
    both,
    forces,
    guide_moment,
    inertia_couple,
    inertia_force,
    moments,
    reaction,
    reaction_angle,
    weight,
)
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import loaded_link
from tmm_report.mechanics.lever.forces.reactions import Reaction
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Var, cos, sin
from tmm_report.quantity.model import Quantity, variable
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.ways import Input, Known, Line
from tmm_report.quantity.written import Equation, Unknown
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved

OF_GROUP = N_(
    "Equations of equilibrium of group %(group)s at this position, in symbols and with numbers, "
    "solved together for its "
    "reactions:"
)
OF_DRIVER = N_(
    "Equations of equilibrium of the driving link %(link)s at this position, in symbols and with numbers:"
)
OF_WHEEL = N_(
    "Equations of equilibrium of link %(link)s, which a mesh moves, at this position, in symbols and with numbers:"
)
OF_MESH = N_("the force in the teeth of %(point)s lies on the line of action:")
OF_RAIL = N_("the friction in %(point)s acts along the rail:")
OF_LINK = N_("link %(link)s: ΣF_x = 0, ΣF_y = 0, ΣM = 0 about point %(point)s:")
OF_GUIDE = N_("guide %(guide)s bears no force along itself:")
OF_TEETH = N_("the force in the teeth lies on the line of action:")
SOLUTION = N_("Solution:")
REST = Quantity(
    "rest",
    Symbol("max|Σ|"),
    "",
    Message(N_("what the numbers of the solution leave of the equations at most")),
)


Signed = tuple[int, Expr]


@dataclass(frozen=True, eq=False)
class Push:
    """A force on a link: its components, its point's name and place."""

    x: Var
    y: Var
    point: str
    at: complex
    sign: int = 1


@dataclass(frozen=True, eq=False)
class System:
    """Equations = 0, with what is said before them, and the unknowns with their numbers."""

    lines: list[tuple[Message, list[Expr]]]
    unknown: dict[str, Input]

    @property
    def equations(self) -> list[Expr]:
        return [one for _, several in self.lines for one in several]

    def told(self, head: Message) -> Iterator[Line]:
        yield head
        for said, equations in self.lines:
            yield said
            for one in equations:
                yield Equation(one, numbers=False)
                yield Equation(one)
        yield Message(SOLUTION)
        yield from self.unknown.values()
        yield Input(REST, max(abs(float(one.value)) for one in self.equations), "", REST.symbol)


def worked(found: Kinetostatics, q: Known) -> Iterator[Line]:
    """The equations from which a reaction or the balancing moment follows, where there is one."""
    solved = found.diagram if q.fine else found.table
    index = q.row or 0
    links, head = _solved_with(solved, q.own)
    if q.own == BALANCING_MOMENT.key and solved.statics.driving is not None:
        return  # a reduced moment acts on no link
    if links and np.isfinite(solved.balancing[index]) and _known(solved, links, index):
        yield from system(found, solved, links, index).told(head)


def _solved_with(solved: Solved, key: str) -> tuple[Sequence[str], Message]:
    """The links whose equations are solved together for a number, by its key."""
    linkage = solved.motion.linkage
    driver = linkage.mechanism.driver.link
    for found in solved.statics.reactions.values():
        index = both(*found.pair.links)
        of = reaction(*found.pair.links)
        if key in (of.key, *(one.key for one in of.components), f"alpha_{index}", f"M_{index}", f"x_{index}"):
            for group in linkage.groups:
                if found.pair in (*group.group.outer, *group.group.inner):
                    return group.group.links, Message(OF_GROUP, {"group": group.group.label})
            for wheel in linkage.structure.coupled:
                if found.pair.key in (wheel.bearing.key, wheel.contact.key):
                    return [wheel.link], Message(OF_WHEEL, {"link": wheel.link})
    return [driver], Message(OF_DRIVER, {"link": driver})


def _known(solved: Solved, links: Sequence[str], index: int) -> bool:
    of = [one for one in solved.statics.reactions.values() if set(one.pair.links).intersection(links)]
    return all(np.isfinite(_at(one.force, index)) for one in of)


def system(found: Kinetostatics, solved: Solved, links: Sequence[str], index: int) -> System:
    """The equations of equilibrium of some links that are solved together."""
    return _Writer(found, solved, links, index).written()


class _Writer:
    def __init__(self, found: Kinetostatics, solved: Solved, links: Sequence[str], index: int):
        self.found, self.solved, self.links, self.index = found, solved, links, index
        self.motion = solved.motion
        linkage = self.motion.linkage
        self.driver, self.stroke = linkage.mechanism.driver.link, linkage.mechanism.driver.stroke
        groups = [g.group for g in linkage.groups if set(g.group.links) == set(links)]
        moved = [one for one in linkage.structure.coupled if [one.link] == list(links)]
        self.own = {p.key for g in groups for p in (*g.outer, *g.inner)}
        self.own |= {key for one in moved for key in (one.bearing.key, one.contact.key)}
        self.own = self.own or {linkage.structure.driver_pair.key}
        self.unknown: dict[str, Input] = {}

    def written(self) -> System:
        lines = [self._link(link) for link in self.links]
        lines += [
            self._guide(one) for one in self._reactions() if one.pair.kind == "P" and one.pair.key in self.own
        ]
        lines += [
            self._mesh(one) for one in self._reactions() if one.pair.kind == "H" and one.pair.key in self.own
        ]
        gear = self.motion.linkage.mechanism.driver.gear
        if gear is not None and self.driver in self.links:
            lines.append(self._teeth(gear))
        return System(lines, self.unknown)

    def _reactions(self) -> list[Reaction]:
        every = self.solved.statics.reactions.values()
        return [one for one in every if set(one.pair.links).intersection(self.links)]

    # ------------------------------------------------------------ one link

    def _link(self, link: str) -> tuple[Message, list[Expr]]:
        pushes = [*self._loads(link), *self._pushes(link)]
        about, centre = self._centre(link)
        x: list[Signed] = [(one.sign, one.x) for one in pushes]
        y: list[Signed] = [(one.sign, one.y) for one in pushes]
        apart = (one for one in pushes if abs(one.at - centre) > 0)
        turning = [term for one in apart for term in self._moment(one, about, centre)]
        turning += self._couples(link)
        if link == self.driver and self.stroke is None:
            gear = self.motion.linkage.mechanism.driver.gear
            if gear is not None:
                fx, fy = self._gear(gear)
                x, y = [*x, (1, fx)], [*y, (1, fy)]
            turning.append(
                (1, self._unknown(BALANCING_MOMENT, float(_at(self.solved.balancing, self.index))))
            )
        said = Message(OF_LINK, {"link": link, "point": about})
        return said, [_sum(terms) for terms in (x, y, turning) if terms]

    def _centre(self, link: str) -> tuple[str, complex]:
        """The point about which moments are taken: a pivot of the link, or else where its guide bears it."""
        of = [one for one in self._reactions() if link in one.pair.links]
        one = next((r for r in of if r.pair.kind == "R" and r.pair.key in self.own), of[0])
        return self._name(one, link), complex(_at(one.at, self.index))

    def _name(self, one: Reaction, link: str) -> str:
        """Of the point at which a reaction acts."""
        if one.pair.kind in "RH":
            return one.pair.name
        slider = one.pair.slider or link
        points = self.motion.linkage.mechanism.links[slider].points
        at = complex(one.pair.at[slider])
        return next((name for name, place in points.items() if abs(place - at) < 1e-12), one.pair.name)

    def _moment(self, push: Push, about: str, centre: complex) -> Iterator[Signed]:
        """(x − x₀) F_y − (y − y₀) F_x of a force."""
        for sign, force, axis in ((push.sign, push.y, "x"), (-push.sign, push.x, "y")):
            here, there = (push.at.real, centre.real) if axis == "x" else (push.at.imag, centre.imag)
            if here != there and not _nothing(force):
                yield sign, (_place(axis, push.point, here) - _place(axis, about, there)) * force

    # ------------------------------------------------------------ what acts

    def _pushes(self, link: str) -> Iterator[Push]:
        """The reactions of its pairs: those of its group unknown, the others found before."""
        for one in self._reactions():
            if link not in one.pair.links:
                continue
            x, y = reaction(*one.pair.links).components
            force = complex(_at(one.force, self.index))
            make = self._unknown if one.pair.key in self.own else variable
            sign = -1 if one.pair.links[0] == link else 1
            at = complex(_at(one.at, self.index))
            yield Push(make(x, force.real), make(y, force.imag), self._name(one, link), at, sign)

    def _loads(self, link: str) -> Iterator[Push]:
        load, given, of = self.solved.loading, self.found.given, self.motion.linkage.mechanism.links[link]
        for quantity, known in ((weight(link), load.gravity), (inertia_force(link), load.inertia)):
            if link in known:
                yield self._push(quantity, known[link], str(of.mass_centre))
        for quantity, stated, force in zip(forces(given.forces), given.forces, load.forces, strict=True):
            if loaded_link(self.motion, stated) == link:
                yield self._push(quantity, force, stated.at)
        if self.stroke is not None:
            along = self.stroke.along(self.motion)
            for taken in self.stroke.takes:
                if taken.link == link:
                    force = self.solved.statics.driving * along
                    yield replace(self._push(DRIVING, force, taken.point), sign=taken.sign)

    def _push(self, of: Quantity, force: Any, point: str) -> Push:
        x, y = of.components
        number = complex(_at(force, self.index))
        place = complex(_at(self.motion.place(point), self.index))
        return Push(variable(x, number.real), variable(y, number.imag), point, place)

    def _couples(self, link: str) -> list[Signed]:
        load, given = self.solved.loading, self.found.given
        found: list[Signed] = []
        if link in load.couples:
            found.append((1, variable(inertia_couple(link), float(_at(load.couples[link], self.index)))))
        for quantity, stated, couple in zip(moments(given.moments), given.moments, load.moments, strict=True):
            if stated.on == link:
                found.append((1, variable(quantity, float(_at(couple, self.index)))))
        for one in self._reactions():
            if one.pair.kind == "P" and link in one.pair.links:
                of, number = guide_moment(*one.pair.links), float(np.real(_at(one.moment, self.index)))
                moment = self._unknown(of, number) if one.pair.key in self.own else variable(of, number)
                found.append((-1 if one.pair.links[0] == link else 1, moment))
        return found

    def _gear(self, gear: Any) -> tuple[Var, Var]:
        moment, omega = self.solved.balancing, self.motion.linkage.mechanism.driver.omega
        force = complex(_at(gear.force(moment, omega), self.index))
        x, y = FORCE.components
        return self._unknown(x, force.real), self._unknown(y, force.imag)

    def _teeth(self, gear: Any) -> tuple[Message, list[Expr]]:
        """F r_b = |M| along the line of action."""
        moment = float(_at(self.solved.balancing, self.index))
        fx, fy = self._gear(gear)
        line = complex(float(fx.number), float(fy.number))
        alpha = Var(ANGLE_OF_LINE.sign, float(np.angle(line)), "deg")
        radius = variable(BASE_RADIUS, float(gear.base_radius))
        of = self._unknown(BALANCING_MOMENT, moment)
        sizes = [(fx, cos), (fy, sin)]
        bodies = [f * radius - of * g(alpha) if moment > 0 else f * radius + of * g(alpha) for f, g in sizes]
        return Message(OF_TEETH), bodies

    def _guide(self, one: Reaction) -> tuple[Message, list[Expr]]:
        along = complex(_at(one.along, self.index))
        beta = Var(Symbol("beta", one.pair.name), float(np.angle(along)), "deg")
        force = complex(_at(one.force, self.index))
        x, y = reaction(*one.pair.links).components
        body = self._unknown(x, force.real) * cos(beta) + self._unknown(y, force.imag) * sin(beta)
        return Message(OF_GUIDE, {"guide": one.pair.name}), [body]

    def _mesh(self, one: Reaction) -> tuple[Message, list[Expr]]:
        force = complex(_at(one.force, self.index))
        x, y = reaction(*one.pair.links).components
        alpha = Var(reaction_angle(*one.pair.links).sign, float(np.angle(force)), "deg")
        body = self._unknown(x, force.real) * sin(alpha) - self._unknown(y, force.imag) * cos(alpha)
        coupled = self.motion.linkage.structure.coupled
        rolls = any(wheel.mesh.rolls for wheel in coupled if wheel.contact.key == one.pair.key)
        return Message(OF_RAIL if rolls else OF_MESH, {"point": one.pair.name}), [body]

    def _unknown(self, of: Quantity, number: float) -> Unknown:
        self.unknown.setdefault(of.key, Input(of, number, of.unit, of.symbol))
        return Unknown(of.sign, number, of.unit, None, None, of.meaning)


def _place(axis: str, point: str, number: float) -> Var:
    return Var(Symbol(axis, point), number, "m")


def _at(values: Any, index: int) -> Any:
    """The number at a position of an array (P,), or of what is the same at all."""
    array = np.asarray(values)
    return array.reshape(-1)[index if array.size > 1 else 0]


def _sum(terms: list[Signed]) -> Expr:
    """Their sum without what is nothing at this position, and is no unknown."""
    some = [one for one in terms if not _nothing(one[1])] or terms[:1]
    sign, first = some[0]
    total = first if sign > 0 else -first
    for sign, one in some[1:]:
        total = total + one if sign > 0 else total - one
    return total


def _nothing(one: Expr) -> bool:
    return isinstance(one, Var) and not isinstance(one, Unknown) and float(one.number) == 0.0
