"""Mistakes of loads that are right in themselves: names, numbers of values, angles and strokes of the cycle."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from tmm_report.chapters.lever.kinematics.block import table_of, turns_of
from tmm_report.chapters.lever.kinetostatics.block import tied
from tmm_report.chapters.lever.kinetostatics.block.models import LoadsModel
from tmm_report.chapters.lever.kinetostatics.block.stroke_parts import curves
from tmm_report.chapters.lever.kinetostatics.given import (
    Carried,
    Force,
    Moment,
    SharedDiagram,
    SharedSwing,
    StatedCurve,
    StatedStrokes,
    StrokesDiagram,
)
from tmm_report.chapters.lever.structure import block as structure
from tmm_report.chapters.lever.structure.block import FRAME, Names, names, no_link, no_point
from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.quantity.text import Typed
from tmm_report.quantity.units import DIMENSIONS
from tmm_report.variant.errors import near
from tmm_report.variant.gaps import not_all_round, not_to_the_end
from tmm_report.variant.model import Read
from tmm_report.variant.values import Measured
from tmm_report.yamlread import Path

TURN = 2 * math.pi
BEYOND = 1e-4  # of the cycle: a time of its end that is rounded


def check(written: LoadsModel, read: Read) -> Iterator[Problem]:
    known = names(read.data)
    yield from _curves(written, read)
    for index, force in enumerate(written.forces):
        if force:
            yield from _loaded(force.at, ("loads", "forces", index, "at"), known)
            yield from _taken(force, ("loads", "forces", index, "on"), known)
            if isinstance(force.direction, Carried):
                yield from _moving(
                    force.direction.link, ("loads", "forces", index, "direction", "link"), known
                )
            yield from _one_each(force, ("loads", "forces", index), read)
            yield from _over_its_time(force, ("loads", "forces", index), read)
            yield from _over_the_cycle(force, ("loads", "forces", index), read)
            yield from _strokes(force, ("loads", "forces", index), written, read)
            yield from _whole_strokes(force, ("loads", "forces", index))
    for index, moment in enumerate(written.moments):
        if moment:
            yield from _turned(moment.on, ("loads", "moments", index, "on"), known)
            yield from _one_each(moment, ("loads", "moments", index), read)
            yield from _over_its_time(moment, ("loads", "moments", index), read)
            yield from _over_the_cycle(moment, ("loads", "moments", index), read)
            yield from _whole_strokes(moment, ("loads", "moments", index))
    yield from tied.check(written, read)


def _curves(written: LoadsModel, read: Read) -> Iterator[Problem]:
    """Curves of several loads: whole ones, that are there and are of use."""
    used, stated = set(), set(written.curves)
    if any(path[:2] == ("loads", "curves") for path in read.broken):  # one with a mistake is there, too
        stated |= {str(name) for name in read.data["loads"]["curves"]}
    for kind, loads in (("forces", written.forces), ("moments", written.moments)):
        for index, load in enumerate(loads):
            if load and isinstance(load.by_displacement, SharedDiagram):
                used.add(load.by_displacement.curve)
                path: Path = ("loads", kind, index, "by_displacement", "curve")
                shared = isinstance(written.curves.get(load.by_displacement.curve), StatedStrokes)
                if shared and isinstance(load.by_displacement, SharedSwing):
                    text = N_(
                        "a moment goes by a curve of two ways, forward and back: strokes are those of points"
                    )
                    yield mistake(text, path)
                if load.by_displacement.curve not in stated:
                    right = near(load.by_displacement.curve, sorted(stated))
                    yield mistake(
                        N_("there is no curve %(name)s"), path, right, name=load.by_displacement.curve
                    )
    for name, curve in written.curves.items():
        here: Path = ("loads", "curves", name)
        if name not in used:
            yield mistake(N_("no load has the curve %(name)s"), here, name=name)
        for way, points in curves(curve).items():
            if not isinstance(points, Measured):  # judged when the stroke is known
                yield from not_to_the_end(points, (*here, *way), 1.0)
            if max(abs(value) for _, value in points) > 1 + 1e-9:
                text = N_("the values of a curve are parts of the greatest one, at most 1")
                yield mistake(text, (*here, *way))


def _moving(link: str, path: Path, known: Names) -> Iterator[Problem]:
    yield from no_link(link, path, known)
    if link == FRAME:
        text = N_("the frame does not turn: a direction that it carries is a fixed one")
        yield mistake(text, path, Message(N_("direction: 60 deg")))


def _loaded(name: str, path: Path, known: Names) -> Iterator[Problem]:
    yield from no_point(name, path, known)
    moving = list(dict.fromkeys(p for link, points in known.points.items() if link != FRAME for p in points))
    if name in known.all_points and name not in moving:
        text = N_("the point %(name)s is on the frame only: a force there loads no moving link")
        yield mistake(text, path, near(name, moving), name=name)


def _taken(force: Force, path: Path, known: Names) -> Iterator[Problem]:
    """The link that takes a force moves and has its point."""
    if force.on is None:
        return
    on = [link for link, points in known.points.items() if link != FRAME and force.at in points]
    if force.on == FRAME:
        text = N_("the frame takes every force: there it loads no moving link")
        yield mistake(text, path, near(force.on, on))
    elif force.on not in known.points:
        yield from no_link(force.on, path, known)
    elif force.at in known.all_points and force.on not in on:
        text = N_("the point %(name)s is not on link %(link)s")
        yield mistake(text, path, near(force.on, on), name=force.at, link=force.on)


def _turned(link: str, path: Path, known: Names) -> Iterator[Problem]:
    yield from no_link(link, path, known)
    if link == FRAME:
        moving = [name for name in known.points if name != FRAME]
        text = N_("the frame takes every moment: there it loads no moving link")
        yield mistake(text, path, near(link, moving))


def _one_each(load: Force | Moment, path: Path, read: Read) -> Iterator[Problem]:
    """A value for each position of the table that has loads of its own, where they are stated by position."""
    steps, closed = table_of(read), _full_turns(read)
    if load.by_position is None or steps is None or closed is None:
        return
    count = steps if closed else steps + 1
    if len(load.by_position) != count:
        right = N_("one value for each of the positions 0 … %(last)s")
        if closed:
            right = N_(
                "one value for each of the positions 0 … %(last)s: position %(count)s is position 0 again"
            )
        text, told = (
            N_("%(found)s values, %(count)s positions"),
            Message(right, {"last": count - 1, "count": count}),
        )
        yield mistake(text, (*path, "by_position"), told, found=len(load.by_position), count=count)


def _full_turns(read: Read) -> bool | None:
    """Whether the driving link makes full turns; None where its range is wrong or part of a block with mistakes."""
    driver = read.block(structure.Block).mechanism.driver
    if ("mechanism", "driver", "range") in read.broken:
        return None
    if driver is not None:
        return structure.swept(read) >= TURN - 1e-12
    return None if "range" in _driver(read) else True


def _driver(read: Read) -> Mapping[str, Any]:
    """What the file says of the driving link, right or wrong."""
    written: Any = read.data
    for key in ("mechanism", "driver"):
        written = written.get(key) if isinstance(written, Mapping) else None
    return written if isinstance(written, Mapping) else {}


def _over_the_cycle(load: Force | Moment, path: Path, read: Read) -> Iterator[Problem]:
    """Angles of turn within the cycle, and not those of its first turn alone."""
    values, turns = load.by_angle, turns_of(read)
    for index, (turned, _) in enumerate(values or ()):
        if turned > turns * TURN * (1 + 1e-12):
            text = N_("%(value)s is out of range: %(name)s from %(limits)s is expected")
            here = (*path, "by_angle", index, 0)
            name, limits = Message(DIMENSIONS["angle"].name), Typed(f"0 … {360 * turns} deg")
            yield mistake(text, here, value=shown(_written(read, here)), name=name, limits=limits)
    if values and len(values) > 1 and turns > 1 and values[-1][0] <= TURN * (1 + 1e-12):
        text = N_("the law ends within the first turn, the cycle has %(turns)s turns, %(angle)s deg")
        right = Message(N_("state it to the end of the cycle, or of the last change in it"))
        yield mistake(text, (*path, "by_angle"), right, turns=turns, angle=360 * turns)
        return
    driver = read.block(structure.Block).mechanism.driver
    if _full_turns(read):
        yield from not_all_round(values, (*path, "by_angle"), turns * TURN)
    elif driver is not None:
        yield from not_to_the_end(values, (*path, "by_angle"), structure.swept(read), math.radians(1))


def _over_its_time(load: Force | Moment, path: Path, read: Read) -> Iterator[Problem]:
    """Times within the cycle, and not those of a part of it alone."""
    driver = read.block(structure.Block).mechanism.driver
    built, path = structure.driver(read), (*path, "by_time")
    if load.by_time is None or driver is None or driver.speed == "drive" or built is None:
        return
    if "dynamics" in read.data:
        text = N_(
            "a load by the time has no place in dynamics, where the driving link comes to a position at any time"
        )
        yield mistake(text, path, Message(N_("by_angle, or without the block dynamics")))
        return
    period = built.sweep * built.turns / abs(built.omega)
    for index, (time, _) in enumerate(load.by_time):
        if time > period * (1 + BEYOND):
            text = N_("%(value)s is beyond the cycle, which takes %(time)s s")
            here = (*path, index, 0)
            yield mistake(text, here, value=shown(_written(read, here)), time=f"{period:.6g}")
            return
    if built.law.returns if built.law else built.sweep >= TURN - 1e-12:
        yield from not_all_round(load.by_time, path, period, "s")
    else:
        yield from not_to_the_end(load.by_time, path, period)


def _whole_strokes(load: Force | Moment, path: Path) -> Iterator[Problem]:
    """Each curve of an indicator diagram says what acts over the whole stroke."""
    diagram = load.by_displacement
    if diagram is None:
        return
    path = (*path, "by_displacement")
    if isinstance(diagram, SharedDiagram):
        return
    for key, curve in curves(diagram).items():
        if not isinstance(curve, Measured):
            yield from not_to_the_end(curve, (*path, *key), 1.0)


def _of_strokes(load: Force) -> Any:
    """What the strokes of a load are stated by: a curve that it shares with others, or itself."""
    diagram = load.by_displacement
    return diagram.curve if isinstance(diagram, SharedDiagram) else id(load)


def _written(read: Read, path: Path) -> Any:
    """What stands in the file at a path."""
    found: Any = read.data
    for part in path:
        found = found[part]
    return found


def _strokes(load: Force, path: Path, written: LoadsModel, read: Read) -> Iterator[Problem]:
    """A curve for each stroke of the cycle: a point makes an even number of them in a turn."""
    diagram = load.by_displacement
    path, turns = (*path, "by_displacement"), turns_of(read)
    stated: Path = (*path, "strokes")
    if isinstance(diagram, SharedDiagram):
        curve = written.curves.get(diagram.curve)
        if isinstance(curve, StatedCurve) and diagram.first is not None:
            text = N_("the curve %(name)s has two ways and no strokes: none of them is the first")
            yield mistake(text, (*path, "first"), name=diagram.curve)
        if not isinstance(curve, StatedStrokes):
            return
        stated = ("loads", "curves", diagram.curve, "strokes")
    elif not isinstance(diagram, StrokesDiagram):
        return
    # by what is written: a curve with a mistake is still a stroke, and a cycle that is wrong in itself has no number
    names = [str(name) for name in _written(read, stated)]
    count = len(names)
    driver = read.block(structure.Block).mechanism.driver
    if structure.swept(read) < TURN * (1 - 1e-12):
        right = Message(N_("state the curves of the two ways: forward and back"))
        yield mistake(N_("the driving link makes no full turn: no strokes follow"), stated, right)
        return
    first = next(one for one in written.forces if one and _of_strokes(one) == _of_strokes(load))
    if load is first and (count == 0 or (driver is not None and count % (2 * turns))):
        text = N_("%(found)s strokes are stated, the cycle has %(count)s")
        right = Message(N_("a curve for each stroke of the cycle, in the order in which they follow"))
        yield mistake(text, stated, right, found=count, count=2 * turns)
    if diagram.first is not None and diagram.first not in names:
        text = N_("there is no stroke %(name)s")
        yield mistake(text, (*path, "first"), near(diagram.first, names), name=diagram.first)
