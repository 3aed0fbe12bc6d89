"""Warm time of the compressor's HTML note without its gear drive, against its graphs on matplotlib's own axes.

    python -m benchmarks.speed.html_note    # this checkout
    python -m benchmarks.speed.html_note CHECKOUT     # and another one, say of the commit before, taking turns with it

A process of its own for each turn of a checkout: it renders once to warm up, then ten times, and its median counts.
Printed, never asserted.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from statistics import median

ROOT = Path(__file__).parents[2]
TURNS = 5
CHILD = """
import io, tempfile
from pathlib import Path
import yaml
from matplotlib.figure import Figure
from benchmarks.measuring.timing import interleaved
from tmm_report import load, render, solve

data = yaml.safe_load(Path("variants/compressor.yaml").read_text("utf-8"))
data = {key: value for key, value in data.items() if key not in ("drive", "flywheel", "balancing")}
with tempfile.TemporaryDirectory() as folder:
    file = Path(folder, "compressor.yaml")
    file.write_text(yaml.safe_dump(data, allow_unicode=True), "utf-8")
    results = solve(load(str(file)))

def axes():
    for panels in (3, 3, 1, 2):
        figure = Figure(figsize=(6.5, 1.9 * panels + 0.7))
        for panel in figure.subplots(panels, 1, sharex=True, squeeze=False)[:, 0]:
            panel.plot(range(37), range(37), marker="o", markevery=3)
            panel.grid(True)
        figure.savefig(io.BytesIO(), format="svg")

taken = interleaved({"note": lambda: render(results, "html"), "axes": axes}, 10)
print(taken["note"], taken["axes"])
"""


def turn(checkout: Path) -> tuple[float, float]:
    """Medians of a fresh process, s: of the note and of the bare axes."""
    done = subprocess.run(
        [sys.executable, "-c", CHILD],
        cwd=checkout,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, (checkout, ROOT)))},
        check=True,
        capture_output=True,
        text=True,
    )
    note, axes = map(float, done.stdout.split())
    return note, axes


def main() -> None:
    checkouts = [ROOT, *(Path(name).resolve() for name in sys.argv[1:2])]
    turns: dict[Path, list[tuple[float, float]]] = {checkout: [] for checkout in checkouts}
    for _ in range(TURNS):
        for checkout in checkouts:
            turns[checkout].append(turn(checkout))
    notes = {checkout: median(note for note, _ in found) for checkout, found in turns.items()}
    for checkout, found in turns.items():
        share = median(note / axes for note, axes in found)
        times = f"{notes[checkout] / notes[ROOT]:7.2f}   {share:5.2f} of matplotlib's axes alone"
        print(f"{checkout.name:<16}{1e3 * notes[checkout]:8.0f} ms{times}")


if __name__ == "__main__":
    main()
