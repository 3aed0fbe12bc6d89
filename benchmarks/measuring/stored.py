"""Figures of benchmarks, kept as JSON and set against the last stored run.

A figure is a ratio or an error, which hold on another machine; seconds stand beside a ratio only. Nothing is judged:
what has grown is printed, and a person decides.
"""

from __future__ import annotations

import argparse
import json
import platform
from collections.abc import Mapping
from pathlib import Path

RESULTS = Path(__file__).parents[1] / "results"


def add_option(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--store", action="store_true", help="keep the figures as benchmarks/results/NAME.json"
    )


def report(name: str, figures: Mapping[str, float], store: bool = False) -> None:
    """Print the figures beside those stored last; with `store` keep them."""
    path = RESULTS / f"{name}.json"
    last = json.loads(path.read_text("utf-8"))["figures"] if path.exists() else {}
    width = max(map(len, figures), default=0)
    print(f"\n{name}: {'figure':<{width}}{'now':>12}{'stored':>12}{'now : stored':>14}")
    for figure, value in figures.items():
        print(f"{'':{len(name) + 2}}{figure:<{width}}{value:12.4g}", end="")
        before = last.get(figure)
        print("" if before is None else f"{before:12.4g}{value / before if before else float('nan'):14.2f}")
    if store:
        kept = {
            "machine": machine(),
            "figures": {key: float(f"{value:.4g}") for key, value in figures.items()},
        }
        RESULTS.mkdir(exist_ok=True)
        path.write_text(json.dumps(kept, indent=1, ensure_ascii=False) + "\n", "utf-8")


def machine() -> dict[str, str]:
    """What the figures were measured on; no name of a host."""
    import numpy

    return {
        "python": platform.python_version(),
        "numpy": numpy.__version__,
        "system": f"{platform.system()} {platform.machine()}",
        "processor": _processor(),
    }


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    if info.exists():
        for line in info.read_text("utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return platform.processor()
