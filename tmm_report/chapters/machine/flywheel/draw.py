"""Drawings of the flywheel: places of its diagrams over the cycle, the energy–mass diagram with its tangents."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.machine.flywheel.solve import Found
from tmm_report.figures.charts.plane import Frame, Spot, Trace, framed, plane
from tmm_report.figures.drawing import DASHED, NORMAL, THIN, Arc, Drawing, Item, Tag, dot, line
from tmm_report.figures.lettering import Parts, symbol
from tmm_report.mechanics.machine.flywheel.inertia import Touch

Array = Any
ASIDE = 1e-4 * math.pi / 180  # rad: how far before a jump its first value is drawn
GRID = 72  # places of a curve at least
SMOOTH = 360  # of the energy–mass curve
NUMBERED = 12  # numbers of positions beside a curve that do not crowd it


def places(found: Found) -> Array:
    """Angles at which a curve over the cycle is drawn, rad: the positions of the tables and diagrams, the edges of the
    panels, of a jump both sides. More than some hundred points would be thinned out as they are written."""
    over, sides = found.cycle.panels, found.sides
    ends = over.ends(found.cycle.moment)
    jumps = np.abs(np.roll(ends[:, 0], -1) - ends[:, 1]) > 1e-6 * np.abs(ends).max()
    before = over.edges[1:][jumps] - ASIDE
    grid = np.linspace(0.0, over.period, GRID + 1)
    parts = (over.edges, before, sides.turned, sides.drawn, *([grid] if len(sides.drawn) < GRID else []))
    x = np.sort(np.concatenate(parts))
    # of places that rounding parts the last: it is on the jump or behind it, and what is before has its own
    return x[np.append(np.diff(x) > ASIDE / 4, True)]


def extremes(found: Found, key: str) -> list[tuple[float, float]] | None:
    """Greatest and least of a curve over the cycle as points of a graph, exact between its places; None: those of its
    places, where the curve may jump."""
    of = found.cycle
    curves = {
        "M_ex": of.moment,
        "A": of.work,
        "J_II": of.varying,
        "dT_I": of.work - of.varying * found.omega**2 / 2,
        "domega": found.after.omega - found.omega,
        "omega_0": None if found.before is None else found.before.omega,
    }
    values = curves.get(key)
    if values is None:
        return None
    return [(math.degrees(at), value) for value, at in reversed(of.panels.extremes(values))]


# ---------------------------------------------------------------- the energy–mass diagram


def energy_mass(
    found: Found, labels: tuple[Parts, Parts], num: Callable[[float], str], title: str = ""
) -> Drawing:
    """T against J_II with the two tangents of Wittenbauer, their angles and the segment ab on the axis of energies."""
    over, of = found.cycle.panels, found.cycle
    x = np.linspace(0.0, over.period, SMOOTH + 1)
    curve = over.at(of.varying, x) + 1j * over.at(of.work, x)
    numbered = over.at(of.varying, found.sides.turned) + 1j * over.at(of.work, found.sides.turned)
    tangents = (found.methods["wittenbauer"].upper, found.methods["wittenbauer"].lower)
    corners = np.array([[1j * one.cut, _end(found, one)] for one in tangents])
    frame = framed([curve, corners.ravel()], scales=(found.s.number("mu_J"), found.s.number("mu_T")))
    items = [item for one in tangents for item in _tangent(frame, one, _end(found, one))]
    items += [line(frame.at(0j + 1j * frame.low.imag), frame.at(1j * frame.high.imag), NORMAL)]
    tags = [*_letters(frame, tangents), *_numbers(frame, numbered[:-1])]
    spots = [Spot(complex(one.inertia, one.work), colour="red") for one in tangents]
    # of the positions dots alone: a line of no width is one where thin lines are drawn as thin as can be
    items += [dot(frame.at(complex(point)), 0.5) for point in numbered[:-1]]
    return plane(frame, [Trace(curve)], *labels, num, spots=spots, more=items, tags=tags, title=title)


def work_curve(found: Found, num: Callable[[float], str]) -> Drawing:
    """A over the angle turned, degrees."""
    x = places(found)
    curve = np.degrees(x) + 1j * found.cycle.panels.at(found.cycle.work, x)
    return plane(framed([curve]), [Trace(curve)], ("φ, °",), ("A",), num)


def _end(found: Found, one: Touch) -> complex:
    """Where a tangent ends: a little beyond the point where it touches, never beyond the largest moment of inertia."""
    beyond = max(1.15 * one.inertia, 0.55 * float(np.max(found.cycle.varying)))
    return complex(beyond, one.cut + one.slope * beyond)


def _tangent(frame: Frame, one: Touch, end: complex) -> Iterator[Item]:
    """The line from the axis of energies, and its angle with the axis of moments of inertia there."""
    start, tip = frame.at(1j * one.cut), frame.at(end)
    yield line(start, tip, replace(NORMAL, colour="blue"))
    turn = cmath.phase(tip - start)
    yield line(start, start + 16, DASHED)
    yield Arc(start, 13.0, 0.0, turn, THIN)


def _letters(frame: Frame, tangents: Sequence[Touch]) -> Iterator[Tag]:
    for k, (one, name) in enumerate(zip(tangents, "ab", strict=True), 1):
        start = frame.at(1j * one.cut)
        turn = math.atan(one.slope * frame.x_scale / frame.y_scale)
        yield Tag((symbol(name),), (start,), prefer=-1 + 0j)
        yield Tag((symbol(f"ψ_{k}"),), (start + cmath.rect(15.0, turn / 2),), prefer=1 + 0j)


def _numbers(frame: Frame, points: Array) -> Iterator[Tag]:
    every = max(1, -(-len(points) // NUMBERED))
    for k in range(0, len(points), every):
        yield Tag((str(k),), (frame.at(complex(points[k])),))
