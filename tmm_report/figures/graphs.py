"""Graphs with axes over the driver's angle: panels one above another, written as SVG and PDF.

matplotlib is imported inside the functions, for it takes longer to load than a note to solve; pyplot never is.
The text of the SVG stays text: it is selectable, small, and set in the reader's own sans-serif font.
"""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.quantity.text import ZERO

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

WIDTH = 165.0  # mm
PANEL = 48.0  # height of a panel, mm
LEFT, RIGHT, ABOVE, BELOW = 20.0, 4.0, 6.0, 12.0  # margins for the figures and labels, mm
MM = 1 / 25.4  # inches
OFF, TALL = 5.0, 9.0  # of a value written by an extreme: how far it stands off, its height, points

# told apart without colour: by dashes and by markers
LOOKS: tuple[dict[str, Any], ...] = (
    {"color": "#000000", "linestyle": "-", "marker": "o"},
    {"color": "#1B4F9C", "linestyle": (0, (6, 2)), "marker": "s"},
    {"color": "#B3261E", "linestyle": (0, (6, 2, 1, 2)), "marker": "^"},
    {"color": "#1E6B3A", "linestyle": (0, (1.5, 1.5)), "marker": "D"},
    {"color": "#7F5A00", "linestyle": (0, (8, 2, 1, 2, 1, 2)), "marker": "v"},
)
SETTINGS: dict[Any, Any] = {
    "font.family": ["DejaVu Sans", "sans-serif"],
    "font.size": 8.5,
    "axes.linewidth": 0.6,
    "axes.unicode_minus": True,
    "lines.linewidth": 1.1,
    "lines.markersize": 3.2,
    "svg.fonttype": "none",
    "pdf.fonttype": 42,
    "path.simplify": False,
}


@dataclass(frozen=True, eq=False)
class Curve:
    """One curve: `values` (P,) in the unit of its panel's label; `name` goes into the legend where there is one.

    `extremes`: the points to mark as (x, value); None: the greatest and the least of `values`.
    `scale`: the natural size of the quantity, beside which a curve that is nothing but rounding is seen to be one.
    """

    values: np.ndarray
    name: str = ""
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


@dataclass(frozen=True, eq=False)
class Graph:
    """A finished graph; the same data give the same bytes."""

    figure: Figure
    salt: str
    title: str = ""

    def svg(self) -> str:
        """One `svg` element to stand inside a page: its ids are its own, nothing is fetched."""
        text = self._written("svg", {"Date": None, "Creator": None, "Format": None, "Type": None}).decode()
        return _inline(text, self.title)

    def pdf(self) -> bytes:
        return self._written("pdf", {"CreationDate": None, "Creator": None, "Producer": None})

    def _written(self, kind: str, metadata: dict[str, None]) -> bytes:
        from matplotlib import rc_context

        out = io.BytesIO()
        with rc_context(SETTINGS | {"svg.hashsalt": self.salt}):
            self.figure.savefig(out, format=kind, metadata=metadata)
        return out.getvalue()


def graph(
    curves: Sequence[Curve],
    x: np.ndarray,
    xlabel: str,
    ylabels: Sequence[str],
    *,
    step: float = 30.0,
    positions: int = 0,
    comma: bool = False,
    join: bool = True,
    title: str = "",
) -> Graph:
    """Curves over `x` (P,), degrees, a panel for each of `ylabels`, sharing x.

    `step`: degrees between ticks; `positions`: how many positions a turn is numbered with over the top, 0: none;
    `comma`: decimal comma; `join`: thin lines join the extremes of all panels; `title` is for who cannot see it.
    """
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    curves = [curve.settled() for curve in curves]
    with rc_context(SETTINGS):
        figure = Figure(figsize=(WIDTH * MM, _height(len(ylabels)) * MM))
        FigureCanvasAgg(figure)
        panels = figure.subplots(
            len(ylabels), 1, sharex=True, squeeze=False, gridspec_kw=_layout(len(ylabels))
        )[:, 0]
        for number, (axes, label) in enumerate(zip(panels, ylabels, strict=True)):
            _panel(axes, [curve for curve in curves if curve.panel == number], x, label, comma)
        _x_axis(panels[-1], x, xlabel, step, comma)
        if positions:
            _numbers(panels[0], x, positions)
        if join:
            _joined(list(panels), [curve for curve in curves if len(ylabels) > 1], x)
        return Graph(figure, _salt(curves, x, (xlabel, *ylabels, title)), title)


def _height(panels: int) -> float:
    """Height of the sheet, mm."""
    return PANEL * panels + ABOVE + BELOW


def _layout(panels: int) -> dict[str, float]:
    """Margins as shares of the sheet; laid out by hand, for matplotlib's own layout takes half of its time."""
    tall = _height(panels)
    edges = {
        "left": LEFT / WIDTH,
        "right": 1 - RIGHT / WIDTH,
        "bottom": BELOW / tall,
        "top": 1 - ABOVE / tall,
    }
    return {**edges, "hspace": 0.07}


def _panel(axes: Axes, curves: Sequence[Curve], x: np.ndarray, label: str, comma: bool) -> None:
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    lines = []
    for curve, look in zip(curves, cycle(LOOKS), strict=False):
        lines += axes.plot(x, curve.values, markevery=max(1, len(x) // 12), **look)
        axes.plot(*_apart(_extremes(curve, x)), "o", mfc="white", mec=look["color"], ms=5, ls="none")
    axes.set_ylabel(label, parse_math=False)
    axes.yaxis.set_label_coords(-(LEFT - 4) / (WIDTH - LEFT - RIGHT), 0.5)
    axes.axhline(0, color="black", linewidth=0.6)
    axes.grid(True, color="#D0D0D0", linewidth=0.4)
    axes.margins(y=0.16)
    if not any(np.nan_to_num(curve.values).any() for curve in curves):
        axes.set_ylim(-1, 1)  # left to itself, the axis of a line of zeros is ruled in rounding errors
    for curve, look in zip(curves, cycle(LOOKS), strict=False):
        _write_extremes(axes, curve, x, look["color"], comma)
    axes.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 4, 5, 10]))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: _figure(value, comma)))
    if any(curve.name for curve in curves):
        _legend(axes, lines, [curve.name for curve in curves])


def _legend(axes: Axes, lines: Sequence[Line2D], names: Sequence[str]) -> None:
    # the blank: matplotlib passes over a name that begins with "_"
    legend = axes.legend(lines, [f" {name}" for name in names], fontsize=8, framealpha=0.85, handlelength=3.5)
    for text in legend.get_texts():
        text.set_parse_math(False)


def _extremes(curve: Curve, x: np.ndarray) -> list[tuple[float, float]]:
    if curve.extremes is not None:
        return list(curve.extremes)
    if not np.isfinite(curve.values).any():
        return []
    picks = (int(np.nanargmax(curve.values)), int(np.nanargmin(curve.values)))
    return [(float(x[k]), float(curve.values[k])) for k in picks]


def _apart(points: Sequence[tuple[float, float]]) -> tuple[list[float], list[float]]:
    return [at for at, _ in points], [value for _, value in points]


def _write_extremes(axes: Axes, curve: Curve, x: np.ndarray, colour: str, comma: bool) -> None:
    """The value over a greatest and under a least; the limits of the axes are set before."""
    points = _extremes(curve, x)
    middle = float(np.nanmean(curve.values)) if points else 0.0
    for at, value in points:
        text, up = _figure(value, comma), value >= middle
        reach = 0.0065 * len(text) * (x[-1] - x[0])  # half of its width
        side = int(at - x[0] < reach) - int(x[-1] - at < reach)  # at an edge of the panel, inwards
        axes.annotate(
            text,
            (at, value),
            xytext=(4 * side, _off(axes, value, up) * (1 if up else -1)),
            textcoords="offset points",
            ha=("center", "left", "right")[side],
            va="bottom" if up else "top",
            fontsize=8,
            color=colour,
            parse_math=False,
            bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 0.4},
        )


def _off(axes: Axes, value: float, up: bool) -> float:
    """How far from its extreme a value is written, points: beyond the line of zero rather than across it."""
    low, high = axes.get_ylim()
    zero = abs(value) / (high - low) * axes.bbox.height * 72 / axes.figure.dpi
    return zero + 2 if up == (value < 0) and OFF - 2 < zero < OFF + TALL else OFF


def _figure(value: float, comma: bool) -> str:
    """A number of at most four significant digits, with a true minus."""
    text = f"{value:.4g}"
    if "e" in text:
        text = f"{value:.0f}" if abs(value) >= 1 else text
    text = ("0" if float(text) == 0 else text).replace("-", "−")
    return text.replace(".", ",") if comma else text


def _x_axis(axes: Axes, x: np.ndarray, label: str, step: float, comma: bool) -> None:
    from matplotlib.ticker import FuncFormatter

    axes.set_xlim(float(x[0]), float(x[-1]))
    axes.set_xticks(np.arange(np.ceil(x[0] / step) * step, x[-1] + step / 1000, step))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: _figure(value, comma)))
    axes.set_xlabel(label, parse_math=False)


def _numbers(axes: Axes, x: np.ndarray, positions: int) -> None:
    """Numbers of the positions over the top panel; a full turn ends where it began, at 0."""
    places = np.arange(0, x[-1] - x[0] + 1e-6, 360 / positions)
    top = axes.secondary_xaxis("top")
    top.set_xticks(x[0] + places, labels=[str(k % positions) for k in range(len(places))])
    top.tick_params(length=2, labelsize=8)


def _joined(panels: Sequence[Axes], curves: Sequence[Curve], x: np.ndarray) -> None:
    """Thin upright lines through all panels at the extremes: the zeros of the derivative below them."""
    for at in sorted({round(at, 6) for curve in curves for at, _ in _extremes(curve, x)}):
        for axes in panels:
            axes.axvline(at, color="#606060", linewidth=0.5, linestyle=(0, (4, 3)))


def _salt(curves: Sequence[Curve], x: np.ndarray, words: Sequence[str]) -> str:
    """Ids made with it are the graph's own, and the same for the same data."""
    digest = sha256(np.ascontiguousarray(x, float).tobytes() + "\0".join(words).encode())
    for curve in curves:
        digest.update(np.ascontiguousarray(curve.values, float).tobytes())
    return digest.hexdigest()[:16]


def _inline(text: str, title: str) -> str:
    """Drops what only a file needs (prologue) and every id that nothing refers to; names the picture."""
    from tmm_report.figures.lettering import xml_text

    text = text[text.index("<svg") :].strip()
    used = set(re.findall(r"#([\w.-]+)", text))
    text = re.sub(r' id="([\w.-]+)"', lambda match: match[0] if match[1] in used else "", text)
    head, body = text.split(">", 1)
    return f'{head} role="img"><title>{xml_text(title)}</title>{body}'
