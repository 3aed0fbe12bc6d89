"""Drawing of the harmonics: the field of a link's motion over the place along it and the angle of turn."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.machine.harmonics.solve import Wave
from tmm_report.figures.charts.axes import round_ticks
from tmm_report.figures.charts.plane import Frame, Num, Trace, plane
from tmm_report.figures.drawing import Drawing, Pen
from tmm_report.figures.lettering import Parts
from tmm_report.figures.placing import Tag
from tmm_report.mechanics.calculus import harmonics as fourier

Array = Any
POINTS = 720  # of a line over the turn
LEVELS = 9
ENDS = 1e-9  # of the link: a place that is one of its ends
ABOVE, BELOW = Pen(0.3), Pen(0.25, "blue", (2.0, 1.0))


def turns(wave: Wave) -> bool:
    """Whether the link turns, by more than rounding: of one that does not all points move alike."""
    along = wave.places[1] - wave.places[0]
    return bool(np.abs(along - along.mean()).max() > ENDS * np.abs(along).max())


def field(wave: Wave, axis: str, labels: tuple[Parts, Parts], num: Num) -> Drawing:
    """Lines of equal deviation of x or y from its mean, mm, over φ and ξ; `labels`: what is written at these axes.

    Between the ends the place is linear in ξ, so the line of a level is ξ = (level − p)/(q − p), p and q being those of
    the ends.
    """
    p, q = (_smooth(end.real if axis == "x" else end.imag) for end in wave.places)
    turned = np.linspace(0.0, 360.0, len(p))
    means = p[:-1].mean(), q[:-1].mean()
    p, q = 1e3 * (p - means[0]), 1e3 * (q - means[1])
    frame = Frame(0j, 360 + 1j, 3.0, 0.02)
    traces, tags = [], []
    for level in round_ticks(float(min(p.min(), q.min())), float(max(p.max(), q.max())), LEVELS):
        line = _line(turned, p, q, level)
        if not np.isfinite(line).any():
            continue
        traces.append(Trace(line, pen=BELOW if level < 0 else ABOVE))
        for piece in _pieces(line):
            at = frame.at(complex(piece[len(piece) // 2]))
            tags.append(Tag((num(level),), (at,), gap=0.6, size=2.6, colour="blue" if level < 0 else "black"))
    return plane(frame, traces, *labels, num, tags=tags)


def _smooth(values: Array) -> Array:
    """The samples at `POINTS` places or more, the first repeated at the end."""
    fine = fourier.refined(values, max(1, -(-POINTS // len(values))))
    return np.append(fine, fine[0])


def _line(turned: Array, p: Array, q: Array, level: float) -> Array:
    """φ + iξ of a level, nan where it leaves the link; it ends on the ends of the link exactly."""
    apart = q - p
    known = np.abs(apart) > 1e-9 * np.abs(apart).max()
    with np.errstate(divide="ignore", invalid="ignore"):
        xi = np.where(known, (level - p) / apart, np.nan)
    xi = np.where(np.abs(xi) < ENDS, 0.0, np.where(np.abs(xi - 1) < ENDS, 1.0, xi))
    found: list[complex] = []
    for k in range(len(xi) - 1):
        piece = _clipped(turned[k], xi[k], turned[k + 1], xi[k + 1]) if apart[k] * apart[k + 1] > 0 else None
        if piece is None:
            found.append(complex(np.nan))
        else:
            found += piece if not found or found[-1] != piece[0] else piece[1:]
    return np.array(found)


def _pieces(line: Array) -> Iterator[Array]:
    """The unbroken parts of a line that are long enough to bear a figure."""
    for part in np.split(line, np.flatnonzero(np.isnan(line))):
        known = part[np.isfinite(part)]
        if len(known) > 2:
            yield known


def _clipped(x0: float, y0: float, x1: float, y1: float) -> list[complex] | None:
    """The part of a segment between y = 0 and y = 1; None where there is none."""
    if not (np.isfinite(y0) and np.isfinite(y1)) or min(y0, y1) > 1 or max(y0, y1) < 0:
        return None
    ends = []
    for x, y, other_x, other_y in ((x0, y0, x1, y1), (x1, y1, x0, y0)):
        bound = min(max(y, 0.0), 1.0)
        at = x if bound == y else x + (bound - y) / (other_y - y) * (other_x - x)
        ends.append(complex(at, bound))
    return ends
