"""Error against time, both axes logarithmic: one mark a run and quantity, settings of a program joined."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from benchmarks.peers.judge import Row
from benchmarks.peers.scene import KINDS

MARKS = dict(zip(KINDS, "os^D", strict=True))
LEAST = 1e-17  # an error of 0 is drawn here


def draw(rows: Sequence[Row], path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams |= {"svg.hashsalt": "peers", "svg.fonttype": "none", "font.size": 9}
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7.2, 5), layout="constrained")
    peers = list(dict.fromkeys(row.peer for row in rows))
    for k, peer in enumerate(peers):
        own = [row for row in rows if row.peer == peer]
        for family in dict.fromkeys(map(_family, own)):
            for kind in KINDS:
                _series(axes, [row for row in own if _family(row) == family], kind, f"C{k}")
    colours = [axes.plot([], [], "-", color=f"C{k}", linewidth=3)[0] for k in range(len(peers))]
    marks = [axes.plot([], [], mark, color="0.3")[0] for mark in MARKS.values()]
    axes.add_artist(axes.legend(colours, peers, loc="upper left", bbox_to_anchor=(1, 1), frameon=False))
    axes.legend(marks, KINDS, loc="lower left", bbox_to_anchor=(1, 0), frameon=False)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("time of the table of 36 positions : ours")
    axes.set_ylabel("largest error, relative to the largest value")
    axes.grid(True, which="major", linewidth=0.4)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def _family(row: Row) -> str:
    """The setting without the number of its steps or samples."""
    return re.sub(r"\d+ (?=steps|samples)", "", row.setting)


def _series(axes: Any, rows: Sequence[Row], kind: str, colour: str) -> None:
    """The runs of one program by time; lines join runs that differ in a number alone."""
    points = sorted(
        (row.ratio, max(off, LEAST))
        for row in rows
        if (off := row.errors.get(kind)) is not None and row.ratio > 0
    )
    if points:
        axes.plot(
            *zip(*points, strict=True),
            MARKS[kind] + "-",
            color=colour,
            linewidth=0.6,
            markersize=5,
            alpha=0.85,
        )
