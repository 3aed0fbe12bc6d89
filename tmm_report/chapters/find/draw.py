"""The demanded number over the range of the unknown, with what is wanted and the roots; of two unknowns, the lines on
which each demand is met."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from tmm_report.figures.charts.axes import axis_scale
from tmm_report.figures.charts.plane import Frame, Spot, Trace, framed, plane
from tmm_report.figures.drawing import Drawing, Pen
from tmm_report.figures.lettering import Parts
from tmm_report.mechanics.calculus.isolines import isolines

Array = Any
FIELD = (120.0, 70.0)  # mm
SPAN = 4.0  # of the middle half of the values: what is farther off is a pole's
PENS = (Pen(0.45, "blue"), Pen(0.45, "red", (3.0, 1.2)))
LEVEL = Pen(0.35, "red", (3.0, 1.2))


def course(
    x: Array,
    y: Array,
    jumps: Sequence[float],
    level: float,
    roots: Sequence[tuple[float, float, str]],
    axes: tuple[Parts, Parts],
    num: Callable[[float], str],
    wanted: Parts,
) -> Drawing:
    """`roots`: place, value, and what is written beside."""
    curve = _broken(x, _within(y, level), jumps)
    ends = [complex(x[0], y0) for y0 in (np.nanmin(curve.imag), np.nanmax(curve.imag))]
    line = np.array([complex(x[0], level), complex(x[-1], level)])
    lines = [line] if np.isfinite(level) else []
    frame = _spread(framed([curve, np.array(ends), *lines], zero=False, field=FIELD), x)
    traces = [Trace(curve), *(Trace(one, wanted, LEVEL) for one in lines)]
    spots = [Spot(complex(at, value), (text,) if text else (), "red") for at, value, text in roots]
    return plane(frame, traces, axes[0], axes[1], num, spots=spots)


def meeting(
    places: Array,
    rest: Array,
    roots: Sequence[tuple[complex, str]],
    axes: tuple[Parts, Parts],
    names: Sequence[Parts],
    num: Callable[[float], str],
) -> Drawing:
    """`places`: of the grid, (P, Q, 2), by both unknowns; `rest`: there, what the demanded numbers are less what is
    wanted."""
    z = places[..., 0] + 1j * places[..., 1]
    low, high = z[0, 0], z[-1, -1]
    frame = Frame(low, high, *map(axis_scale, ((high - low).real, (high - low).imag), FIELD))
    traces = [Trace(_zeros(z, rest[..., k]), names[k], PENS[k]) for k in (0, 1)]
    spots = [Spot(at, (text,) if text else (), "black") for at, text in roots]
    return plane(frame, traces, axes[0], axes[1], num, spots=spots)


def _zeros(z: Array, f: Array) -> Array:
    """Where a function is nought, which goes straight between the places of the grid; a gap behind each line."""
    parts = np.array(f.shape) - 1

    def between(points: Array) -> Array:
        """At points of the grid's own numbers, i + ij."""
        at = np.stack([points.real, points.imag], axis=-1)
        i, j = np.moveaxis(np.clip(np.floor(at).astype(int), 0, parts - 1), -1, 0)
        u, v = points.real - i, points.imag - j
        corners = (
            (i, j, (1 - u) * (1 - v)),
            (i, j + 1, (1 - u) * v),
            (i + 1, j, u * (1 - v)),
            (i + 1, j + 1, u * v),
        )
        return sum(
            np.where(part == 0, 0.0, f[a, b] * part) for a, b, part in corners
        )  # nan may stand beside a side

    numbers = np.arange(f.shape[0]) + 1j * np.arange(f.shape[1])[:, None]
    low, width = z[0, 0], z[-1, -1] - z[0, 0]
    lines = [
        low + line.real / parts[0] * width.real + 1j * line.imag / parts[1] * width.imag
        for line in isolines(between, numbers, f.T)
    ]
    return np.concatenate([part for line in lines for part in (line, [complex(np.nan, np.nan)])] or [[]])


def _spread(frame: Frame, x: Array) -> Frame:
    """The field from end to end of the range."""
    width = float(x[-1] - x[0])
    return Frame(
        complex(x[0], frame.low.imag),
        complex(x[-1], frame.high.imag),
        axis_scale(width, FIELD[0]),
        frame.y_scale,
    )


def _within(y: Array, level: float) -> Array:
    """Without what runs off to infinity."""
    low, middle, high = np.nanpercentile(y, [25, 50, 75])
    reach = SPAN * (high - low) + (abs(level - middle) if np.isfinite(level) else 0.0)
    return np.where(np.abs(y - middle) <= reach, y, np.nan) if reach else y


def _broken(x: Array, y: Array, jumps: Sequence[float]) -> Array:
    """The curve, x + iy, broken where it jumps."""
    curve = x + 1j * y
    at = np.searchsorted(x, np.array(jumps))
    return np.insert(curve, at, complex(np.nan, np.nan)) if len(jumps) else curve
