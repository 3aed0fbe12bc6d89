"""The governor drawn to scale at the middle of its lift, with both stops in thin lines."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.figures.dimensions import span
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THICK,
    THIN,
    Arc,
    Circle,
    Drawing,
    Item,
    Pen,
    Tag,
    dot,
    line,
    polygon,
    polyline,
)
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.mechanics.machine.governor.equilibrium import Arms, BellCrank
from tmm_report.records import dataclass

Array = Any
SIZE = 125.0  # mm, of the larger side
SCALES = (1, 2, 2.5, 4, 5, 10)  # of drawings, times a power of ten
PALE = Pen(0.18, "grey")
BALL, SLEEVE, SHAFT = (
    3.6,
    4.0,
    1.6,
)  # radius of a ball, half height of the sleeve, half width of the shaft, mm


@dataclass(frozen=True)
class Places:
    """The right half at one place of the sleeve, m from the axis and the fixed pivot: `bars` as polylines, joints, the
    ball, and where the sleeve carries the arm."""

    bars: tuple[tuple[complex, ...], ...]
    joints: tuple[complex, ...]
    ball: complex
    sleeve: complex


def places(found: DirectFound, row: int) -> Places:
    """At a row of the table."""
    geometry = found.given.geometry
    return _crank(found, geometry, row) if isinstance(geometry, BellCrank) else _arms(found, geometry, row)


def _arms(found: DirectFound, arms: Arms, row: int) -> Places:
    balls = found.table.balls
    tilt = {name: float(angle[row]) for name, angle in balls.tilt.items()}
    pivot = complex(arms.upper_offset, 0)
    hanging = complex(np.sin(tilt["alpha"]), -np.cos(tilt["alpha"]))
    pin = pivot + arms.upper * hanging
    sleeve = complex(arms.lower_offset, (pin - arms.lower * complex(0, np.cos(tilt["beta"]))).imag)
    ball, beyond = pin, []
    if arms.distance is not None:
        ball = pivot + arms.distance * hanging
        beyond = [(pin, ball)]
    elif arms.extension is not None:
        ball = pin + arms.extension * complex(np.sin(tilt["gamma"]), np.cos(tilt["gamma"]))
        beyond = [(pin, ball)]
    return Places(((pivot, pin), (pin, sleeve), *beyond), (pivot, pin, sleeve), ball, sleeve)


def _crank(found: DirectFound, crank: BellCrank, row: int) -> Places:
    """Level arms are drawn as they stand all the same: upright at half the lift, where no fulcrum is stated."""
    radii = found.table.balls.r
    r, upright = float(radii[row]), crank.fulcrum
    if upright is None:
        upright = float(radii[0] + radii[-1]) / 2
    sin = min(1.0, max(-1.0, (r - upright) / crank.ball_arm))
    cos = float(np.sqrt(1 - sin**2))
    fulcrum = complex(upright, 0)
    ball = fulcrum + crank.ball_arm * complex(sin, cos)
    end = fulcrum + crank.sleeve_arm * complex(-cos, sin)
    return Places(((ball, fulcrum, end),), (fulcrum, end), ball, end)


# --- the drawing


def scheme(found: DirectFound, title: str = "") -> Drawing:
    """Both halves; the dimensions that the formulas name."""
    scale = drawn_scale(found)
    middle, ends = places(found, found.middle), (places(found, 0), places(found, -1))
    items: list[Item] = []
    for end in ends:
        items += _half(end, scale, PALE, PALE)
    items += [*_half(middle, scale, THICK, NORMAL), *_middle(found, middle, ends, scale)]
    return Drawing(tuple(items), title).labelled(list(_tags(found, middle, ends, scale)))


def drawn_scale(found: DirectFound) -> float:
    """mm of paper for a metre: a scale of drawings by which the governor fits."""
    every = [z for row in (0, found.middle, -1) for z in _points(places(found, row))]
    wide = 2 * max(z.real for z in every)
    tall = max(z.imag for z in every) - min(z.imag for z in every)
    rough = SIZE / (1e3 * max(wide, tall))
    first = int(np.floor(np.log10(rough)))
    powers = [10.0**power for power in range(first - 1, first + 3)]
    fitting = [one for power in powers for step in SCALES if (one := power / step) <= rough]
    return 1e3 * max(fitting)


def _points(at: Places) -> Iterator[complex]:
    yield from (z for bar in at.bars for z in bar)
    yield at.ball


def _mirrored(z: complex) -> complex:
    return complex(-z.real, z.imag)


def _half(at: Places, scale: float, pen: Pen, thin: Pen) -> list[Item]:
    """Bars, joints and balls, and the same across the axis."""
    items: list[Item] = []
    for side in (lambda z: scale * z, lambda z: scale * _mirrored(z)):
        items += [polyline([side(z) for z in bar], pen) for bar in at.bars]
        items += [Circle(side(at.ball), BALL, thin, "pale" if pen is THICK else "")]
        if pen is THICK:
            items += [Circle(side(joint), 1.1, NORMAL, "white") for joint in at.joints if joint != at.ball]
    return items


def _middle(found: DirectFound, at: Places, ends: tuple[Places, Places], scale: float) -> list[Item]:
    """Shaft, sleeve and spring."""
    every = [scale * z for place in (at, *ends) for z in _points(place)]
    low = min(z.imag for z in every) - 14
    crank = isinstance(found.given.geometry, BellCrank)
    top = (max(z.imag for z in every) if crank else 0.0) + 10
    sleeve = scale * at.sleeve
    items: list[Item] = [line(complex(0, low), complex(0, top), AXIS)]
    items += [line(complex(x, low + 3), complex(x, top - 3), THIN) for x in (-SHAFT, SHAFT)]
    half = max(sleeve.real, 5.0)
    body = [complex(sign * half, sleeve.imag + up) for sign, up in ((-1, -2), (1, -2), (1, 0), (-1, 0))]
    block = [complex(sign * 5.0, sleeve.imag + up) for sign, up in ((-1, -7), (1, -7), (1, 0), (-1, 0))]
    items += [polygon(block, NORMAL, "white"), polygon(body, NORMAL, "white")]
    items += _crosshead(found, at, scale)
    if found.weights.stiffness or found.weights.preload:
        collar = top - 6 if crank else -4.0
        items += _spring(sleeve.imag + 1, collar)
    return items


def _crosshead(found: DirectFound, at: Places, scale: float) -> list[Item]:
    """What carries the fixed pivots."""
    pivot = scale * (at.joints[0])
    if abs(pivot.real) < 0.5:
        return [dot(pivot)]
    left, right = _mirrored(pivot), pivot
    if not isinstance(found.given.geometry, BellCrank):
        return [line(left, right, NORMAL)]
    drop = -8j  # the fulcrums stand on brackets of a cross-piece
    return [line(left, left + drop), line(right, right + drop), line(left + drop, right + drop)]


def _spring(low: float, high: float) -> list[Item]:
    """A zigzag about the shaft between the sleeve and a collar."""
    turns = 7
    ys = np.linspace(low, high, 2 * turns + 1)
    left = [complex(4.0 * (-1) ** k, float(y)) for k, y in enumerate(ys)]
    collar = line(complex(-5.5, high), complex(5.5, high), NORMAL)
    return [polyline(left, NORMAL), collar]


# --- letters


def _tags(found: DirectFound, at: Places, ends: tuple[Places, Places], scale: float) -> Iterator[Tag]:
    geometry = found.given.geometry
    ball = scale * at.ball
    yield Tag((Symbol("m"),), (ball,), BALL + 1, 1 + 0j)
    yield Tag((Symbol("m", "0"),), (scale * at.sleeve - 4j,), 6, 1 + 0j)
    names = ("a", "b") if isinstance(geometry, BellCrank) else ("l_1", "l_2")
    if isinstance(geometry, BellCrank):
        top, corner, end = at.bars[0]
        bars = [(top, corner), (corner, end)]
    else:
        bars = [(bar[0], bar[1]) for bar in at.bars[:2]]
    for name, (one, other) in zip(names, bars, strict=True):
        base, _, sub = name.partition("_")
        parts: Parts = (Symbol(base, sub),)
        yield Tag(parts, (scale * (one + other) / 2,), 1.6, 1 + 0j)
    if not isinstance(geometry, BellCrank) and len(at.bars) > 2:
        yield Tag((Symbol("b" if geometry.extension else "L"),), (scale * sum(at.bars[2]) / 2,), 1.6, 1 + 0j)


def dimensioned(found: DirectFound, title: str = "") -> Drawing:
    """The scheme with the radius of the ball, the lift and the angles of the arms."""
    scale = drawn_scale(found)
    drawing = scheme(found, title)
    at, ends = places(found, found.middle), (places(found, 0), places(found, -1))
    bottom = drawing.box[1]
    ball = scale * at.ball
    items: list[Item] = [line(ball, complex(ball.real, bottom - 6), THIN)]
    items += span(complex(0, bottom - 4), complex(ball.real, bottom - 4))
    left = drawing.box[0]
    low, high = (scale * end.sleeve.imag for end in ends)
    for y in (low, high):
        items.append(line(complex(-5.0, y), complex(left - 4, y), PALE))
    items += span(complex(left - 2, low), complex(left - 2, high))
    letters = [
        Tag((Symbol("r"),), (complex(ball.real / 2, bottom - 4),), 1.0, 1j),
        Tag((Symbol("h"),), (complex(left - 2, (low + high) / 2),), 1.2, -1 + 0j),
        *_angles(found, at, scale, items),
    ]
    return Drawing((*drawing.items, *items), title).labelled(letters)


def _angles(found: DirectFound, at: Places, scale: float, items: list[Item]) -> Iterator[Tag]:
    """Arcs between the arms and the vertical."""
    geometry, tilt = found.given.geometry, found.table.balls.tilt
    corners = {"theta": (at.joints[0], 1.0)} if isinstance(geometry, BellCrank) else {}
    if not isinstance(geometry, BellCrank):
        corners = {"alpha": (at.joints[0], -1.0), "beta": (at.joints[2], 1.0)}
    for name, (corner, up) in corners.items():
        angle, centre = float(tilt[name][found.middle]), scale * corner
        if abs(angle) < 0.05:
            continue
        start = up * np.pi / 2
        end = start - up * angle
        items.append(line(centre, centre + 17j * up, AXIS))
        items.append(Arc(centre, 12.0, start, end, THIN))
        at_middle = centre + 14.0 * np.exp(1j * (start + end) / 2)
        letter = {"alpha": "α", "beta": "β", "theta": "θ"}[name]
        yield Tag((Symbol(letter),), (complex(at_middle),), 0.3)
