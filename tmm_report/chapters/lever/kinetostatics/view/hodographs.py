"""Hodographs of the reactions in pivots, and indicator diagrams: curves that are not over the angle of turn."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import Force, Moment, Piston
from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.solve.drawn_cycle import Array, Sampled
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.kinetostatics.view.diagrams import reaction
from tmm_report.figures.charts.plane import Frame, Trace, framed, plane
from tmm_report.figures.drawing import Drawing, Item, Tag
from tmm_report.figures.lettering import Parts
from tmm_report.mechanics.calculus.laws import Diagram
from tmm_report.mechanics.lever.forces.reactions import Reaction
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.paper import round_scale
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import CycleGraphs

Num = Callable[[float], str]
FIELD = (60.0, 56.0)  # mm: between the axes of a hodograph
SHEET = (160.0, 100.0)  # mm: of the hodographs of one figure, a row: small ones find room on more pages
BETWEEN = 6.0  # mm: from one to the next
INDICATED = (100.0, 70.0)  # mm: of an indicator diagram
CLOSE = 4.0  # mm: nearer positions are not numbered both


class Hodograph(NamedTuple):
    """Of the reaction `of` in pivot `pair`; `scale`: N for a millimetre."""

    of: Quantity
    pair: str
    scale: float
    drawing: Drawing


def hodographs(found: Kinetostatics, at: Sampled, graphs: CycleGraphs, num: Num) -> list[Hodograph]:
    """Of every pivot, in the order of the reactions."""
    pairs = found.diagram.statics.reactions.items()
    return [_hodograph(found, at, key, one, graphs, num) for key, one in pairs if one.pair.kind == "R"]


def sheets(drawn: Sequence[Hodograph]) -> list[tuple[Drawing, list[Hodograph]]]:
    """Hodographs side by side and under one another, as many on a sheet as fit: each sheet with what it shows."""
    rows: list[list[Hodograph]] = []
    for one in drawn:
        if rows and sum(x.drawing.size[0] + BETWEEN for x in rows[-1]) + one.drawing.size[0] <= SHEET[0]:
            rows[-1].append(one)
        else:
            rows.append([one])
    found: list[list[list[Hodograph]]] = []
    for row in rows:
        if found and sum(_tall(x) + BETWEEN for x in found[-1]) + _tall(row) <= SHEET[1]:
            found[-1].append(row)
        else:
            found.append([row])
    return [(_sheet(of), [one for row in of for one in row]) for of in found]


def _tall(row: Sequence[Hodograph]) -> float:
    return max(one.drawing.size[1] for one in row)


def _sheet(rows: Sequence[Sequence[Hodograph]]) -> Drawing:
    """Rows from the top down, each from the left."""
    items: list[Item] = []
    top = 0.0
    for row in rows:
        left = 0.0
        for one in (shown.drawing for shown in row):
            corner = complex(one.box[0], one.box[3])
            items += one.moved(complex(left, top) - corner).items
            left += one.size[0] + BETWEEN
        top -= _tall(row) + BETWEEN
    return Drawing(tuple(items))


def _hodograph(
    found: Kinetostatics, at: Sampled, key: str, one: Reaction, graphs: CycleGraphs, num: Num
) -> Hodograph:
    force, of = reaction(found, at, key), q.reaction(*one.pair.links)
    frame = _frame([force, _around(force)], FIELD, equal=True)
    x, y = (graphs.axis(part) for part in of.components)
    tags = _numbers(found, frame, np.broadcast_to(one.force, found.diagram.motion.shape), key)
    return Hodograph(of, one.pair.name, frame.x_scale, plane(frame, [Trace(force)], x, y, num, tags=tags))


def _around(force: Array) -> Array:
    """Places that keep the field of a reaction of nearly one direction from being a line."""
    known = force[np.isfinite(force)]
    low, high = known.real.min() + 1j * known.imag.min(), known.real.max() + 1j * known.imag.max()
    spare = 0.2 * max(abs(high - low), abs(high) * 1e-6, abs(low) * 1e-6)
    return (low + high) / 2 + spare * np.array([1 + 1j, -1 - 1j])


def _numbers(found: Kinetostatics, frame: Frame, diagram: Array, key: str) -> list[Tag]:
    """Numbers of the positions beside the curve, where they do not crowd."""
    table = np.broadcast_to(found.table.statics.reactions[key].force, found.table.motion.shape)
    own = table[:-1] if found.kinematics.cycle.closed else table
    middle = np.nanmean(diagram)
    told: list[complex] = []
    tags: list[Tag] = []
    for k, force in enumerate(own):
        place = frame.at(complex(force))
        if np.isfinite(force) and all(abs(place - other) >= CLOSE for other in told):
            told.append(place)
            away = complex(force - middle)
            tags.append(Tag((str(k),), (place,), 0.8, away / abs(away) if away else 0j, 2.4))
    return tags


def _frame(curves: Sequence[Array], field: tuple[float, float], equal: bool) -> Frame:
    """A frame at round scales."""
    fitted = framed(curves, equal=equal, field=field)
    x, y = round_scale(fitted.x_scale, 1.0), round_scale(fitted.y_scale, 1.0)
    return framed(curves, scales=(x, y), field=field)


# ---------------------------------------------------------------- indicator diagrams


class Indicated(NamedTuple):
    """A stated load by the stroke, of a pressure its indicator diagram; `scale`: N or N·m for a millimetre."""

    of: Quantity
    name: str
    pressed: bool
    scale: float
    drawing: Drawing


def indicated(
    found: Kinetostatics, graphs: CycleGraphs, num: Num, word: Callable[[str], str]
) -> Iterator[Indicated]:
    """Of every load that is stated by displacement: it against the part of the stroke or swing travelled. `word`: the
    strokes in the language of the note."""
    forces, moments = found.given.forces, found.given.moments
    loads: list[tuple[Quantity, str, Force | Moment]] = [
        *zip(q.forces(forces), q.names(forces), forces, strict=True),
        *zip(q.moments(moments), q.names(moments), moments, strict=True),
    ]
    for of, called, load in loads:
        if isinstance(load.law, Diagram):
            named = [word(name) for name, _ in load.law.named()]
            curves = [np.array([complex(x, y) for x, y in curve]) for _, curve in load.law.named()]
            frame = _frame([*curves, np.array([0j, 1 + 0j])], INDICATED, equal=False)
            traces = [Trace(z, (name,)) for name, z in zip(named, curves, strict=True)]
            x: Parts = graphs.letter(Symbol("x"))
            pressed = isinstance(load, Piston)
            yield Indicated(of, called, pressed, frame.y_scale, plane(frame, traces, x, graphs.axis(of), num))
