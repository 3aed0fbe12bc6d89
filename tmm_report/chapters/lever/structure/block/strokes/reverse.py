"""A driving slider or cylinder that is no triangle: which link is made the main one, and where its motion begins."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.lever.structure.block.strokes.parts import (
    DRIVER,
    Refused,
    chosen,
    cylinder_links,
    on_frame,
    pivot_of,
    straight,
)
from tmm_report.mechanics.calculus.motion_laws import MotionLaw
from tmm_report.mechanics.lever.assembly.stated import assemble, keys_of, sketch_angle
from tmm_report.mechanics.lever.assur_groups import ROMAN, Structure, decompose
from tmm_report.mechanics.lever.driving.reversed import PositionFunction, Reversed
from tmm_report.mechanics.lever.driving.stroke import Taken
from tmm_report.mechanics.lever.dyads import dyad
from tmm_report.mechanics.lever.mechanism import FRAME, Assembly, Driver, Mechanism
from tmm_report.mechanics.lever.motion import solve
from tmm_report.problems import N_, Message, ProblemError
from tmm_report.records import dataclass

Array = Any
SAME = 1e-6  # of the greatest of some places: what differs by less is on no side
ASSEMBLY = ("mechanism", "assembly")
WORDS = (("up", "down", 1j), ("right", "left", 1 + 0j))


@dataclass(frozen=True)
class Drive:
    """What drives, as `Stroke` says; `key`: under which it is stated."""

    ends: tuple[str, ...]
    start: complex
    way: complex
    by: tuple[str, ...]
    takes: tuple[Taken, ...]
    key: str


def reversed_of(
    whole: Mechanism, law: MotionLaw, slider: str | None, cylinder: tuple[str, str]
) -> tuple[Reversed, tuple[Assembly, ...]]:
    """The stroke with the first link by which it can be followed, and what is then stated of the groups.

    Raises Refused, or the ProblemError of the mechanism itself.
    """
    drive = _slider(whole, slider) if slider is not None else _cylinder(whole, cylinder)
    tries = [Try(whole, law, drive, link) for link in _main_links(whole, drive)]
    if not tries:
        text = N_("no link turns about a fixed point: a mechanism of such links is not driven by a stroke")
        right = N_(
            "a link that is pivoted to the frame: of an elliptic trammel the crank to the middle of its rod, in place "
            "of one of the sliders"
        )
        raise Refused(Message(text), Message(right), (*DRIVER, drive.key))
    for step in (Try.take_apart, Try.put_together, Try.begin, Try.go):
        tries = _passed(tries, step)
    first = tries[0]
    return first.stroke, tuple(first.mechanism.assembly)


def moves_dyads(whole: Mechanism, link: str) -> bool:
    """Whether no group above class II is left where a link is the main one; what is no mechanism is told later."""
    try:
        return decompose(replace(whole, driver=Driver(link, 1.0))).mechanism_class <= 2
    except ProblemError:
        return True


def _passed(tries: Sequence[Try], step: Callable[[Try], None]) -> list[Try]:
    """Those that take the step; what keeps the first one from it, or the one that gets farthest, is raised where none
    does."""
    passed: list[Try] = []
    errors: list[Refused | ProblemError] = []
    for one in tries:
        try:
            step(one)
        except (Refused, ProblemError) as error:
            errors.append(error)
        else:
            passed.append(one)
    if not passed:
        raise max(errors, key=lambda error: getattr(error, "reached", 0.0))
    return passed


# ---------------------------------------------------------------- what drives


def _slider(built: Mechanism, slider: str) -> Drive:
    slide, guide = on_frame(built, slider)
    point = next(name for name, at in built.links[slider].points.items() if at == slide.through)
    return Drive(
        (point,), complex(guide.through), complex(guide.direction), (slider,), (Taken(slider, point, 1),), "slider"
    )  # fmt: skip


def _cylinder(built: Mechanism, between: tuple[str, str]) -> Drive:
    fixed = built.links[FRAME].points
    start, end = sorted(between, key=lambda point: point not in fixed)
    barrel, rod = cylinder_links(built, start, end)
    takes = [Taken(rod or _carrier(built, end), end, 1)]
    if start not in fixed or barrel:
        takes.append(Taken(barrel or _carrier(built, start), start, -1))
    own = tuple(one for one in (barrel, rod) if one)
    return Drive((start, end), 0j, 0j, own, tuple(takes), "cylinder")


def _carrier(built: Mechanism, point: str) -> str:
    """Of the links at a point one that is pivoted to the frame, else the first."""
    links = built.links_at(point)
    return next((link for link in links if pivot_of(built, link)), links[0])


def _main_links(built: Mechanism, drive: Drive) -> list[str]:
    """The links that turn about fixed points, those of the cylinder itself last."""
    turning = [link for link in built.moving if pivot_of(built, link)]
    return sorted(turning, key=lambda link: link in drive.by)


# ---------------------------------------------------------------- one main link, step by step


class Try:
    """A link tried as the main one. Every step raises Refused or ProblemError where it cannot be taken."""

    def __init__(self, whole: Mechanism, law: MotionLaw, drive: Drive, link: str):
        self.law, self.drive, self.link = law, drive, link
        self.mechanism = replace(whole, driver=Driver(link, 1.0))
        self.structure: Structure
        self.own: list[Assembly] = []  # that tell of the main link, and of no group
        self.function: PositionFunction
        self.stroke: Reversed

    def take_apart(self) -> None:
        """Its groups are dyads."""
        self.structure = decompose(self.mechanism)
        if self.structure.mechanism_class > 2:
            group = max(self.structure.groups, key=lambda group: group.group_class)
            text = N_(
                "whichever link that turns about a fixed point the motion is found from, a group above class II is "
                "left (from link %(link)s, %(group)s): such a mechanism is not driven by a stroke"
            )
            told = {"link": self.link, "group": f"{ROMAN[group.group_class]}({','.join(group.links)})"}
            right = Message(
                N_("link: %(link)s, speed: … for a link that turns uniformly"), {"link": self.link}
            )
            raise Refused(Message(text, told), right, (*DRIVER, self.drive.key))

    def put_together(self) -> None:
        """Its groups in their assemblies."""
        dyads = [dyad(self.mechanism, group) for group in self.structure.groups]
        keys = {key for one in dyads if one.two_roots for key in keys_of(one)}
        stated = list(self.mechanism.assembly)
        self.own = [one for one in stated if one.key not in keys and one.key in self.mechanism.point_names]
        kept = [one for one in stated if one not in self.own]
        straightened = straight(self.mechanism, self.drive.by)
        if straightened and not {one.key for one in kept} & {*_of_group(straightened.key, dyads)}:
            kept.append(straightened)
        self.mechanism = replace(self.mechanism, assembly=tuple(kept))
        drive = self.drive
        self.function = PositionFunction(assemble(self.mechanism), drive.ends, drive.start, drive.way)

    def begin(self) -> None:
        """The angle of the main link where the stroke begins."""
        stroke = float(self.law.at(np.zeros(1))[0][0])
        roots = self.function.roots(stroke)
        motion = solve(self.function.linkage, roots, 1.0)
        roots = roots[motion.closes]
        told = {"s": f"{stroke * 1e3:.6g}"}
        if not roots.size:
            text = N_("the mechanism cannot be assembled where the stroke begins, at %(s)s mm")
            raise Refused(Message(text, told), self._strokes(), (*DRIVER, "stroke"))
        begin = self._one_of(roots)
        if self.function.branch(begin) is None:
            text = N_("at %(s)s mm, where the stroke begins, the mechanism is in a limit position")
            raise Refused(Message(text, told), self._strokes(), (*DRIVER, "stroke"))
        drive = self.drive
        self.stroke = Reversed(self.law, self.link, self.function, begin, drive.by, drive.takes)

    def go(self) -> None:
        """The law leads through no limit."""
        met = self.stroke.limit()
        if met is None:
            return
        branch = self.stroke.branch
        told = {"s": f"{met * 1e3:.6g}", "link": self.link}
        if branch.turns[0 if met == branch.s[0] else 1]:
            text = N_(
                "the stroke cannot go beyond %(s)s mm, where it is at its extreme: ds/dφ of link %(link)s vanishes, "
                "and the mechanism cannot go on"
            )
        else:
            text = N_(
                "at %(s)s mm of the stroke link %(link)s, from which the motion is found, comes to its own limit and "
                "would turn back"
            )
        before = Message(N_("a stroke that ends before it"))
        right = before if self.drive.way else _between(branch.s[0], branch.s[-1])
        refused = Refused(Message(text, told), right, (*DRIVER, "stroke"))
        refused.reached = abs(met - float(self.law.at(np.zeros(1))[0][0]))
        raise refused

    def _strokes(self) -> Message:
        """Between which strokes it can be."""
        s = self.function.at(np.linspace(0.0, 2 * np.pi, 1441))[0]
        if self.drive.way or not np.isfinite(s).any():  # a place of a slider may have no bounds
            return Message(N_("another beginning of the stroke, or other lengths"))
        return _between(np.nanmin(s), np.nanmax(s))

    # ------------------------------------------------------------ of several beginnings

    def _one_of(self, roots: Array) -> float:
        """The beginning that is stated by the key assembly, or by the sketch. Raises Refused."""
        motion = solve(self.function.linkage, roots, 1.0)
        places = {point: motion.place(point) for point in self.mechanism.point_names}
        left = np.arange(roots.size)
        for one in self.own:
            left = self._stated(one, places, left)
        if left.size > 1 and (sketched := sketch_angle(self.mechanism, self.structure)) is not None:
            branches = [self.function.branch(float(roots[k])) for k in left]
            left = left[[branch is not None and branch.holds(sketched) for branch in branches]]
        if left.size == 1:
            return float(roots[left[0]])
        text = N_(
            "where the stroke begins the mechanism can stand in %(count)s ways, and the variant does not say in which"
        )
        told = {"count": left.size or roots.size}
        raise Refused(Message(text, told), self._how_to_state(places, roots), ASSEMBLY)

    def _stated(self, one: Assembly, places: dict[str, Array], left: Array) -> Array:
        """Which of those left have a point on its stated side."""
        sides = [
            chosen(one, complex(places[one.key][k]), {p: complex(z[k]) for p, z in places.items()})
            for k in left
        ]
        if any(side is None for side in sides):
            text = N_("this does not tell where %(point)s lies when the stroke begins")
            right = Message(N_("up, down, left, right, or left of P-Q: of the line from point P to point Q"))
            raise Refused(Message(text, {"point": one.key}), right, (*ASSEMBLY, one.key))
        most = 1.0 if isinstance(one.choice, tuple) else max(side for side in sides if side is not None)
        kept = left[[side is not None and abs(side - most) <= SAME * max(abs(most), 1e-3) for side in sides]]
        if not kept.size:
            text = N_("where the stroke begins the mechanism cannot stand so that %(point)s is on this side")
            raise Refused(Message(text, {"point": one.key}), None, (*ASSEMBLY, one.key))
        return kept

    def _how_to_state(self, places: dict[str, Array], roots: Array) -> Message:
        for point, low, high in self._told_apart(places, roots):
            text = N_("assembly: {%(point)s: %(high)s} or {%(point)s: %(low)s}: where that point lies then")
            return Message(text, {"point": point, "low": low, "high": high})
        return Message(
            N_("sketch: rough places of points of link %(link)s in one position"), {"link": self.link}
        )

    def _told_apart(self, places: dict[str, Array], roots: Array) -> Iterator[tuple[str, str, str]]:
        """Points of the main link by whose places two beginnings differ, and the words for both."""
        for point in self.mechanism.links[self.link].points:
            for high, low, way in WORDS if roots.size == 2 else ():
                off = (np.conj(way) * places[point]).real
                if abs(off[0] - off[1]) > SAME * np.abs(places[point]).max():
                    yield point, low, high


def _of_group(key: str, dyads: Sequence[Any]) -> list[str]:
    """All names of the group that one of them names."""
    return next((names for names in map(keys_of, dyads) if key in names), [])


def _between(low: float, high: float) -> Message:
    told = {"low": f"{low * 1e3:.6g}", "high": f"{high * 1e3:.6g}"}
    return Message(N_("a stroke between %(low)s and %(high)s mm"), told)
