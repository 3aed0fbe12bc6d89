"""Graphs with axes over the driver's angle or any other quantity: panels one above another, in mm of paper.

The layout is made here, by `axes`; `sheet` puts it on paper, `peaks` finds the places of the values at extremes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import cycle

import numpy as np

from tmm_report.figures.charts import sheet
from tmm_report.figures.charts.axes import (
    GAP,
    PAPER,
    RIGHT,
    TICK,
    Hand,
    Panel,
    Values,
    figure,
    scales_of,
    value_ticks,
    values_of,
)
from tmm_report.figures.charts.sheet import LOOKS, Look
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import Parts, Scale, scales_along
from tmm_report.quantity.text import ZERO
from tmm_report.records import dataclass

Letters = Parts | str
HAND = Hand()
WIDEST = 20.0  # mm: of the figures beside an axis, until they are known


@dataclass(frozen=True, eq=False)
class Curve:
    """One curve: `values` (P,) in the unit of its panel's label; `name` stands over the panel where there is one.

    `extremes`: the points to mark as (x, value); None: the greatest and the least of `values`.
    `scale`: the natural size of the quantity, beside which a curve that is nothing but rounding is seen to be one.
    """

    values: np.ndarray
    name: Letters = ""
    panel: int = 0
    extremes: Sequence[tuple[float, float]] | None = None
    scale: float = 0.0

    def settled(self) -> Curve:
        """The curve without the noise of computation: what is noise is 0, a constant has no extremes."""
        noise = ZERO * max(self.scale, np.nanmax(np.abs(self.values), initial=0.0))
        values = np.where(np.abs(self.values) <= noise, 0.0, self.values)
        if not np.nanmax(values, initial=-np.inf) - np.nanmin(values, initial=np.inf) > noise:
            return replace(self, values=values, extremes=())
        ends = self.extremes and [(at, value if abs(value) > noise else 0.0) for at, value in self.extremes]
        return replace(self, values=values, extremes=ends)

    def marked(self, x: np.ndarray) -> list[tuple[float, float]]:
        """The points to mark: those given, or the greatest and the least."""
        if self.extremes is not None:
            return list(self.extremes)
        if not np.isfinite(self.values).any():
            return []
        picks = (int(np.nanargmax(self.values)), int(np.nanargmin(self.values)))
        return [(float(x[k]), float(self.values[k])) for k in picks]


@dataclass(frozen=True, eq=False)
class Graph:
    """A graph laid out on its sheet; the same data give the same bytes. Words as in `graph`."""

    curves: Sequence[Curve]
    x: np.ndarray
    xlabel: Parts
    ylabels: Sequence[Parts]
    panels: Sequence[Panel]
    step: float
    positions: int
    comma: bool
    join: bool
    title: str
    bounds: Sequence[float] = ()
    hand: Hand = HAND

    @property
    def size(self) -> tuple[float, float]:
        """Width and height, mm."""
        top = self.panels[0]
        rows = sheet.rows(top, self.ylabels[0], self.of(0), self.hand)
        return top.right + RIGHT, top.top + self.hand.row * rows + self.over

    @property
    def over(self) -> float:
        """Height of the numbers of the positions, and of the regimes, over the top panel, mm."""
        return _over(self.positions, self.bounds, self.hand)

    def of(self, number: int) -> list[tuple[Curve, Look]]:
        """The curves of a panel and how each is drawn."""
        curves = [curve for curve in self.curves if curve.panel == number]
        return list(zip(curves, cycle(LOOKS), strict=False))

    @property
    def scales(self) -> tuple[Scale, ...]:
        """What 1 mm along the axis of x and along that of each panel stands for."""
        of_values = zip(self.ylabels, (panel.y_scale for panel in self.panels), strict=True)
        return scales_along([(self.xlabel, self.panels[0].x_scale), *of_values])

    @cached_property
    def drawing(self) -> Drawing:
        return sheet.drawn(self)

    def by(self, hand: Hand, times: float = 1.0) -> Graph:
        """The same curves `times` as large, with other letters."""
        laid = [replace(one, wide=times * one.wide, tall=times * one.tall) for one in self.panels]
        axes = [_axis([curve for curve, _ in self.of(k)], self.x) for k in range(len(laid))]
        laid = [axis.roomy(one, hand.spare) for axis, one in zip(axes, laid, strict=True)]
        laid = [replace(one, left=_left(laid, self.comma, hand)) for one in laid]
        heads = [
            hand.row * sheet.rows(panel, name, self.of(k), hand)
            for k, (panel, name) in enumerate(zip(laid, self.ylabels, strict=True))
        ]
        return replace(self, panels=_upwards(laid, heads, hand), hand=hand)


def graph(
    curves: Sequence[Curve],
    x: np.ndarray,
    xlabel: Letters,
    ylabels: Sequence[Letters],
    *,
    wide: float | Callable[[float], float] | None = None,
    step: float | Callable[[float], float] = 30.0,
    positions: int = 0,
    comma: bool = False,
    join: bool = True,
    title: str = "",
    bounds: Sequence[float] = (),
) -> Graph:
    """Curves over `x` (P,), ascending, a panel for each of `ylabels`, sharing x; values at round scales.

    `wide`: length of the axis of x, mm, or what it is by the room for it; None: all of that. `step`: of x between
    ticks, or what it is by that length; `positions`: how many positions the cycle is numbered with over the top, 0:
    none; `comma`: decimal comma; `join`: thin lines join the extremes of all panels; `title` is for who cannot see it;
    `bounds`: of what follows one another along x, numbered by Roman figures: uprights with their x over the top.
    """
    x, curves = np.asarray(x, float), [curve.settled() for curve in curves]
    names = [_parts(label) for label in ylabels]
    own = [[curve for curve in curves if curve.panel == number] for number in range(len(names))]
    axes = [_axis(of, x) for of in own]
    bare = Panel(0.0, 1.0, (float(x[0]), float(x[-1])), (0.0, 1.0), WIDEST, _wide(wide, WIDEST))
    heads = [
        HAND.row * sheet.rows(bare, name, list(zip(of, cycle(LOOKS), strict=False)), HAND)
        + (_over(positions, bounds, HAND) if k == 0 else 0.0)
        for k, (name, of) in enumerate(zip(names, own, strict=True))
    ]
    laid = _stacked(bare, axes, heads)
    left = _left(laid, comma, HAND)
    laid = [replace(panel, left=left, wide=_wide(wide, left)) for panel in laid]
    step = step(laid[0].wide) if callable(step) else step
    return Graph(
        curves, x, _parts(xlabel), names, laid, step, positions, comma, join and len(names) > 1, title, bounds
    )


def _wide(stated: float | Callable[[float], float] | None, left: float) -> float:
    room = PAPER - left - RIGHT
    return stated(room) if callable(stated) else room if stated is None else stated


def _parts(text: Letters) -> Parts:
    return (text,) if isinstance(text, str) else text


def _axis(curves: Sequence[Curve], x: np.ndarray) -> Values:
    """What an axis holds: the curves, and the extremes given, which may lie between their points."""
    marked = [value for curve in curves for _, value in curve.marked(x)]
    return values_of(np.concatenate([np.array(marked), *(curve.values for curve in curves)]), marked)


def _left(laid: Sequence[Panel], comma: bool, hand: Hand) -> float:
    """Width of the widest figure beside an axis with its tick, mm."""
    texts = [figure(value, comma) for panel in laid for value in value_ticks(panel)]
    return max(hand.wide((text,), hand.figure) for text in texts) + TICK + 1.8


def _over(positions: int, bounds: Sequence[float], hand: Hand) -> float:
    """Height of what is numbered over the top panel, mm."""
    return (hand.numbers if positions else 0.0) + (hand.regimes if len(bounds) else 0.0)


def _stacked(bare: Panel, axes: Sequence[Values], heads: Sequence[float]) -> list[Panel]:
    """The panels one above another, from the top of the sheet down."""
    scales = scales_of(axes, HAND.below + sum(heads) + GAP * (len(axes) - 1))
    sized = [
        replace(bare, tall=axis.tall(scale), y=axis.range(scale))
        for axis, scale in zip(axes, scales, strict=True)
    ]
    return _upwards(sized, heads, HAND)


def _upwards(panels: Sequence[Panel], heads: Sequence[float], hand: Hand) -> list[Panel]:
    """The panels, which are told from the top, on their heights."""
    laid: list[Panel] = []
    bottom = hand.below
    for panel, head in reversed(list(zip(panels, heads, strict=True))):
        laid.append(replace(panel, bottom=bottom))
        bottom = laid[-1].top + head + GAP
    return laid[::-1]
