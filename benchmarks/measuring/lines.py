"""Charts of benchmarks: lines over logarithmic axes, each named at its end; the same bytes at every run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

COLOURS = ("#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8c6d00", "#777777", "#56b4e9")
DASHES: tuple[Any, ...] = (
    "-",
    (0, (5, 2)),
    (0, (1, 1)),
    (0, (6, 1, 1, 1)),
    (0, (3, 3)),
    (0, (8, 3)),
    (0, (2, 4)),
    "-",
)
MARKS = "osD^vPX*"
LEAST = 1e-17  # an error of 0 is drawn here


@dataclass(frozen=True)
class Line:
    """`points`: x and y, in any order of x that is to be joined."""

    name: str
    points: Sequence[tuple[float, float]]
    marks: bool = True


@dataclass(frozen=True)
class Panel:
    title: str
    across: str
    up: str
    lines: Sequence[Line]
    level: float | None = None  # a tolerance, drawn across
    limits: tuple[tuple[float, float] | None, tuple[float, float] | None] = (None, None)
    ticks: Sequence[int] = ()  # named on the axis across


def draw(panels: Sequence[Panel], path: Path, columns: int = 2, height: float = 3.6) -> None:
    """The same name has the same colour, dash and mark in every panel."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams |= {"svg.hashsalt": path.stem, "svg.fonttype": "none", "font.size": 8}
    import matplotlib.pyplot as plt

    rows = -(-len(panels) // columns)
    figure, axes = plt.subplots(
        rows, columns, figsize=(9.6, height * rows), layout="constrained", squeeze=False
    )
    names = list(dict.fromkeys(line.name for panel in panels for line in panel.lines))
    handles: dict[str, Any] = {}
    for panel, place in zip(panels, axes.ravel(), strict=False):
        _panel(place, panel, names, handles)
    for place in axes.ravel()[len(panels) :]:
        place.set_axis_off()
    ordered = [handles[name] for name in names if name in handles]
    ncols = 3 if max(map(len, names)) > 30 else 4
    figure.legend(handles=ordered, loc="outside lower center", ncols=ncols, frameon=False)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def _panel(place: Any, panel: Panel, names: Sequence[str], handles: dict[str, Any]) -> None:
    for line in panel.lines:
        k = names.index(line.name)
        points = [(x, max(y, LEAST) if y == y else y) for x, y in line.points]  # nan leaves a gap
        colour, dash, mark = (
            of[(k + shift * (k // 8)) % 8] for of, shift in ((COLOURS, 0), (DASHES, 3), (MARKS, 2))
        )
        handles[line.name] = place.plot(
            *zip(*points, strict=True), marker=mark if line.marks else "", linestyle=dash, color=colour,
            linewidth=1.1, markersize=4, label=line.name,
        )[0]  # fmt: skip
    if panel.level is not None:
        place.axhline(panel.level, color="#999999", linewidth=0.8)
    place.set(xscale="log", yscale="log", xlabel=panel.across, ylabel=panel.up)
    place.set_title(panel.title, fontsize=9)
    for set_limits, limits in zip((place.set_xlim, place.set_ylim), panel.limits, strict=True):
        if limits:
            set_limits(*limits)
    place.minorticks_off()
    if panel.ticks:
        place.set_xticks(panel.ticks, [str(tick) for tick in panel.ticks])
    place.grid(True, linewidth=0.3)
