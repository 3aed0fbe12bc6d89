"""A linkage of dyads written as straight lines of numpy: the general solver is run once with marks for arrays.

scheme = straight(linkage)
found = motion.solve(scheme, phi)       # the same as of `linkage`, to the last bit, in half the time
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.variants import Each
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.forces.reactions import Load, Reaction
from tmm_report.mechanics.lever.forces.tape.run import Straight
from tmm_report.mechanics.lever.forces.tape.source import Stage, Written, written
from tmm_report.mechanics.lever.forces.tape.tape import Mark, Tape, Untraceable
from tmm_report.mechanics.lever.motion import Linkage, Motion, drive

Array = Any


def straight(linkage: Linkage) -> Linkage:
    """The linkage with its straight lines; as it was, where it has wheels or a group above class II or is a stack."""
    if linkage.mechanism.meshes or not all(isinstance(g, Dyad) for g in linkage.groups) or _is_stack(linkage):
        return linkage
    try:
        return replace(linkage, straight=_straight(linkage))
    except Untraceable:
        return linkage


def _is_stack(linkage: Linkage) -> bool:
    m = linkage.mechanism
    numbers = [m.driver.omega, *(x for link in m.links.values() for x in (link.mass, link.inertia))]
    numbers += [at for link in m.links.values() for at in link.points.values()]
    numbers += [x for guide in m.guides.values() for x in (guide.through, guide.direction)]
    numbers += [x for slide in m.slides for x in (slide.through, slide.direction)]
    return any(isinstance(x, Each) for x in numbers)


class _Marked(Motion):
    """A motion of marks: shapes are not known yet, and positions are taken for none of them singular."""

    @property
    def sines(self) -> dict[str, Array]:  # type: ignore[override]
        return {group.group.label: np.float64(1.0) for group in self.linkage.groups}

    def _whole(self, x: Array) -> Array:
        return x


class _Recorder:
    """A tape cut into stages; a line may use those of stages that are run before it."""

    def __init__(self) -> None:
        self.tape = Tape()
        self.stages: list[Stage] = []
        self.done = 0  # lines of the stages ended

    def end(self, name: str, given: Iterable[Mark], results: Iterable[Any]) -> None:
        """End a stage: what it was given and what is wanted of it."""
        lines = [line for line in self.tape.lines[self.done :] if line.op != "given"]
        self.done = len(self.tape.lines)
        marks = [x.line for x in results if isinstance(x, Mark)]
        self.stages.append(Stage(name, [mark.line for mark in given], lines, marks))


def _straight(linkage: Linkage) -> Straight:
    r = _Recorder()
    moved, state, points = _motion(r, linkage)
    loads = _loads(r, moved)
    sines = {group.group.label: group.closeness(moved.state) for group in linkage.groups}
    r.end("sines", [], sines.values())
    reactions, driven = _forces(r, moved, list(loads))
    places = _Places(written(r.stages))
    return Straight(
        linkage.structure,
        linkage.groups,
        places.written,
        places.blank,
        {name: {link: places.of(x) for link, x in links.items()} for name, links in state.items()},
        {point: places.all(rates) for point, rates in points.items()},
        {label: places.of(x) for label, x in sines.items()},
        {link: places.all((load.force, load.moment)) for link, load in loads.items()},
        {x.pair.key: (x.pair, *places.all((x.force, x.moment, x.at, x.along))) for x in reactions},
        places.all((driven.force, driven.moment, moved.state.r[linkage.mechanism.driver.link])),
    )


def _motion(
    r: _Recorder, linkage: Linkage
) -> tuple[Motion, dict[str, dict[str, Any]], dict[str, tuple[Any, ...]]]:
    """The motion at marks for angles; its state by fields, and place, velocity, acceleration of every point."""
    phi = r.tape.given(real=True)
    s = drive(linkage, phi)
    for group in linkage.groups:
        group.place(s)
        group.move(s)
    state = {name: dict(getattr(s, name)) for name in ("o", "r", "u", "v", "w", "a", "e")}
    moved = _Marked(linkage, phi, linkage.mechanism.driver.omega, s, ())
    points = {p: (moved.place(p), moved.velocity(p), moved.acceleration(p)) for p in linkage.arms}
    r.end(
        "motion", [phi], [x for part in (*map(dict.values, state.values()), *points.values()) for x in part]
    )
    return moved, state, points


def _loads(r: _Recorder, moved: Motion) -> dict[str, Load]:
    """Inertia and gravity. They need not be asked for, so no later stage may use their lines."""
    known = dict(r.tape.known)
    gravity: Any = r.tape.given()
    loads = statics.inertia_and_gravity(moved, gravity)
    r.end("loads", [gravity], [x for load in loads.values() for x in (load.force, load.moment)])
    r.tape.known = known
    return loads


def _forces(r: _Recorder, moved: Motion, links: Sequence[str]) -> tuple[list[Reaction], Load]:
    """Reactions under marks for the loads of the links, and what is left on the driving link."""
    given = {link: Load(r.tape.given(), r.tape.given()) for link in links}
    found, rest = statics.by_groups(moved, given)
    reactions, driven = list(found.values()), rest[moved.linkage.mechanism.driver.link]
    r.end(
        "forces",
        [part for load in given.values() for part in (load.force, load.moment)],
        [part for x in (*reactions, driven) for part in vars(x).values()],
    )
    return reactions, driven


class _Places:
    """Where results stand: lines where they are written, plain numbers behind them."""

    def __init__(self, written: Written):
        self.written = written
        self.blank: list[Any] = [None] * len(written.places)

    def of(self, x: Any) -> int:
        if isinstance(x, Mark):
            return self.written.places[x.line]
        self.blank.append(x)
        return len(self.blank) - 1

    def all(self, parts: Sequence[Any]) -> tuple[int, ...]:
        return tuple(map(self.of, parts))
