"""Scale factors as a person chooses them, readings off a drawing, and numbers as a person writes them down."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tmm_report.problems import N_, Message, ProblemError, mistake

ROUND = (1.0, 2.0, 2.5, 4.0, 5.0)
SHEET = (149.0, 199.0)  # mm: what a drawing itself has of a portrait page, its lettering left room around it
LONGEST = 180.0  # mm: no vector of a plan is drawn longer where the scale is not stated
ACCURACY = 1e-5  # m of paper, of a drawing whose accuracy is not stated: lengths are read to it
PAPER = (
    0.1,
    5000.0,
)  # mm: what is drawn smaller cannot be seen, what is larger has no sheet; TeX ends at 5.7 m
CAD = 1e-5  # m of paper: with this accuracy or better a drawing is made by computer


def round_scale(largest: float, paper: float) -> float:
    """The smallest round scale (1, 2, 2.5, 4, 5 · 10^n) at which `largest` is at most `paper` mm long."""
    if not largest > 0:
        return 1.0
    least = largest / paper * (1 - 1e-9)
    decade = 10.0 ** math.floor(math.log10(least))
    return float(f"{min(s * d for s in ROUND for d in (decade, 10 * decade) if s * d >= least):.12g}")


def fitting_scale(width: float, height: float, sheet: tuple[float, float] = SHEET) -> float:
    """The smallest round scale at which a drawing `width` by `height`, SI, fits the sheet, mm."""
    scales = [
        round_scale(size, paper) for size, paper in zip((width, height), sheet, strict=True) if size > 0
    ]
    return max(scales, default=1.0)


def legible(scale: float, largest: float, path: tuple[str | int, ...]) -> float:
    """A stated scale, SI per mm, at which `largest` can be drawn.

    Raises ProblemError with the scales between which it can.
    """
    low, high = PAPER
    if not largest > 0 or low <= largest / scale <= high:
        return scale
    text = N_("at the scale %(scale)s the largest of what is drawn is %(size)s mm long")
    right = Message(
        N_("from %(low)s to %(high)s it can be drawn"),
        {"low": f"{largest / high:.1g}", "high": f"{largest / low:.1g}"},
    )
    raise ProblemError([mistake(text, path, right, scale=f"{scale:.4g}", size=f"{largest / scale:.3g}")])


def segment_scale(value: float, mm: float) -> float:
    """The scale at which `value` is a segment of `mm`, as it is written: five significant digits."""
    return float(f"{value / mm:.4e}")


def rounded(x: Any, step: float) -> Any:
    """`x` (real or complex, number or array) rounded half up to a multiple of `step`; unchanged for step 0."""
    if step == 0:
        return x
    if isinstance(x, float | complex):
        return _rounded(x, step)
    if np.iscomplexobj(x):
        return rounded(np.real(x), step) + 1j * rounded(np.imag(x), step)
    size = np.floor(np.abs(x) / step * (1 + 1e-12) + 0.5)
    # multiples of 0.01 come out as the decimal number, not as 59.250000000000004
    return np.copysign(np.round(size * step, 12), x) + 0.0


def _rounded(x: float | complex, step: float) -> float | complex:
    """One number rounded as an array of it is, without the cost of an array; nan stays nan."""
    if isinstance(x, complex):
        return complex(_rounded(x.real, step), _rounded(x.imag, step))
    if not math.isfinite(x):
        return x
    size = math.floor(abs(x) / step * (1 + 1e-12) + 0.5) * step
    return math.copysign(round(size * 1e12) / 1e12, x) + 0.0


def read_places(step: float) -> int:
    """Decimals of lengths that are read to `step`, mm: of 0.25 two, of 0.5 one."""
    return len(f"{step:.9f}".rstrip("0").partition(".")[2])


class Pen:
    """How exactly lines are drawn and lengths are read, mm of paper.

    By computer (accuracy 0.01 mm or better) a construction is exact and lengths are read to the accuracy; by hand
    every constructed point is placed to the accuracy as well.
    """

    def __init__(self, accuracy: float):
        self.read_step = accuracy * 1e3
        self.place_step = 0.0 if accuracy <= CAD else self.read_step

    def place(self, point: complex) -> complex:
        """Where a point, mm, is drawn."""
        return complex(rounded(point, self.place_step))

    def read(self, length: complex) -> float:
        """What is read for a drawn segment, mm."""
        return float(rounded(abs(length), self.read_step))
