"""Charts of errors against the distance to a singular position."""

from __future__ import annotations

import re
from collections.abc import Sequence
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.near_singular.runs import OWN, Run
from benchmarks.near_singular.scenes import SCENES

STYLES: dict[str, tuple[str, Any, float, str]] = {  # method -> colour, dash, width, name
    "groups": ("#000000", "-", 1.8, "closed form by groups (the program)"),
    "newton": ("#0072b2", (0, (5, 2)), 1.2, "Newton on the constraint equations"),
    "root_finder": ("#009e73", (0, (1, 1)), 1.4, "general root finder"),
    "constraints": ("#d55e00", (0, (6, 1, 1, 1)), 1.1, "integration (RK4)"),
    "constraints_dop853": ("#a03030", (0, (9, 2, 2, 2)), 1.0, "integration (DOP853, 1e-10)"),
    "differences": ("#cc79a7", (0, (3, 3)), 1.1, "differences of the table"),
    "drawing_0.1": ("#777777", (0, (2, 4)), 1.2, "drawing, 0.1 mm"),
}
SHOWN = ("rod = crank", "links in line", "equal rod", "short arm", "parallel guides", "stretched triad")


def _pyplot(salt: str) -> Any:
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams |= {
        "svg.hashsalt": salt, "svg.fonttype": "none", "font.size": 8, "font.family": "sans-serif",
    }  # fmt: skip
    import matplotlib.pyplot as plt

    return plt


def by_method(runs: Sequence[Run], to: Path) -> None:
    """Relative error of accelerations by every method, six scenes, with the bound and what the program tells."""
    plt = _pyplot("near_singular")
    figure, panels = plt.subplots(2, 3, figsize=(9.6, 6.6), sharex=True, sharey=True, layout="constrained")
    for panel, name in zip(panels.ravel(), SHOWN, strict=True):
        here = [one for one in runs if one.scene == name]
        own = sorted((one for one in here if one.method == OWN), key=lambda one: one.distance)
        x = [one.distance for one in own]
        panel.fill_between(
            x, 1e-18, [one.bounds["acceleration"] for one in own], color="#e4e4e4", linewidth=0
        )
        told = [10 * 2.0**-52 / max(one.closeness, 1e-300) ** 2 for one in own]
        panel.plot(x, told, color="#000000", linewidth=0.7, linestyle=(0, (1, 3)))
        for key, (colour, dash, width, _) in STYLES.items():
            some = sorted((one for one in here if one.method == key), key=lambda one: one.distance)
            points = [(one.distance, one.misses["acceleration"].error) for one in some if one.misses]
            points = [(d, max(error, 1e-17)) for d, error in points if np.isfinite(error)]
            if points:
                panel.plot(*zip(*points, strict=True), color=colour, linestyle=dash, linewidth=width)
        panel.set(xscale="log", yscale="log", xlim=(1e-12, 1), ylim=(1e-17, 30))
        panel.set_title(SCENES[name].title, fontsize=8.5)
        panel.set_xlabel(SCENES[name].of, fontsize=8)
        panel.set_yticks([1e-16, 1e-12, 1e-8, 1e-4, 1])
        panel.minorticks_off()
        panel.grid(True, linewidth=0.3)
    for panel in panels[:, 0]:
        panel.set_ylabel("relative error of accelerations")
    used = {one.method for one in runs}
    lines = [
        plt.Line2D([], [], color=colour, linestyle=dash, linewidth=width, label=label)
        for key, (colour, dash, width, label) in STYLES.items()
        if key in used
    ]
    lines += [
        plt.Rectangle(
            (0, 0), 1, 1, color="#e4e4e4", label="below the conditioning bound: ε × condition number"
        ),
        plt.Line2D(
            [],
            [],
            color="#000000",
            linestyle=(0, (1, 3)),
            linewidth=0.7,
            label="told by the program: 10 ε/s²",
        ),
    ]
    figure.legend(handles=lines, loc="outside lower center", ncols=3, fontsize=8, frameon=False)
    _save(figure, to)


def factors(runs: Sequence[Run], to: Path) -> None:
    """The program's errors in conditioning bounds, every scene, every kind."""
    plt = _pyplot("near_singular_factors")
    figure, panels = plt.subplots(1, 4, figsize=(9.6, 3.2), sharex=True, sharey=True, layout="constrained")
    for panel, kind in zip(panels, ("place", "velocity", "acceleration", "force"), strict=True):
        for name in SCENES:
            own = sorted(
                (one for one in runs if one.scene == name and one.method == OWN and one.misses),
                key=lambda one: one.distance,
            )
            points = [(one.distance, one.misses[kind].times) for one in own if one.misses]
            points = [(d, max(f, 1e-3)) for d, f in points if np.isfinite(f)]
            if points:
                panel.plot(*zip(*points, strict=True), linewidth=0.8, color="#0072b2", alpha=0.7)
        panel.axhline(1, color="#000000", linewidth=0.8)
        panel.axhline(10, color="#d55e00", linewidth=1.2, linestyle=(0, (4, 2)))
        panel.set(xscale="log", yscale="log", xlim=(1e-12, 1), ylim=(1e-3, 30))
        panel.minorticks_off()
        panel.set_title(
            {"place": "places", "force": "forces"}.get(
                kind, kind[:-1] + "ies" if kind[-1] == "y" else kind + "s"
            )
        )
        panel.set_xlabel("distance to the singular position", fontsize=8)
        panel.grid(True, linewidth=0.3)
    panels[0].set_ylabel("error : conditioning bound")
    panels[0].text(2e-12, 12.5, "10: the promise", fontsize=7.5, color="#d55e00")
    _save(figure, to)


def _save(figure: Any, to: Path) -> None:
    """As SVG, its coordinates to a tenth of a point."""
    to.parent.mkdir(parents=True, exist_ok=True)
    text = StringIO()
    figure.savefig(text, format="svg", metadata={"Date": None, "Creator": None})
    short = re.sub(r"(?<=\d\.\d)\d+", "", text.getvalue())
    short = re.sub(r"<!--.*?-->|; stroke-linejoin: miter|; stroke-linecap: (butt|square)", "", short)
    to.write_text(re.sub(r"\n\s+", "\n", short), "utf-8")
