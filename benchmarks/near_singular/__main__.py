"""Error against distance to a singular position over twelve decades, for every method of motion and forces.

    python -m benchmarks.near_singular [-o FOLDER] [--store]     needs mpmath and matplotlib; a minute or two

Writes near_singular.svg and near_singular_ours.svg (default: docs/charts), prints how many conditioning bounds each
method is off, and the program's own at every distance. Distances are of the scenes in `scenes.py`.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from benchmarks.measuring import stored
from benchmarks.near_singular import chart
from benchmarks.near_singular.runs import KINDS, OWN, Run, methods, run
from benchmarks.near_singular.scenes import SCENES

CHARTS = Path(__file__).parents[2] / "docs" / "charts"
DECADES = range(13)
LEFT_OUT = ("fourier", "parallelogram")  # a swing is no period; one scene is a parallelogram


def measure() -> list[Run]:
    others = tuple(key for key in methods() if key not in (OWN, *LEFT_OUT))
    found: list[Run] = []
    for scene in SCENES:
        for power in DECADES:
            found += run(scene, 10.0**-power, (OWN,)) + run(scene, 10.0**-power, others, 1)
            if power:
                found += run(scene, 3.0 * 10.0**-power, (OWN,))
        print(f"  {scene}", flush=True)
    return found


def figures(runs: Sequence[Run]) -> dict[str, float]:
    """The program's worst factor over the bound by scene and kind; other methods' worst errors at d = 1e-3 and 1e-6."""
    found: dict[str, float] = {}
    for scene in SCENES:
        own = [one for one in runs if one.scene == scene and one.method == OWN and one.misses]
        for kind in KINDS:
            times = [one.misses[kind].times for one in own if one.misses]
            found[f"{scene} : {kind}, bounds"] = float(np.nanmax(times))
    for key in dict.fromkeys(one.method for one in runs):
        for distance in (1e-3, 1e-6):
            kinds = ("force",) if key.startswith("forces") else ("velocity", "acceleration")
            some = [
                one.misses[kind].error
                for one in runs
                for kind in kinds
                if one.method == key and np.isclose(one.distance, distance) and one.misses
            ]
            if np.isfinite(some).any():
                found[f"{key} : worst error at {distance:.0e}"] = float(np.nanmax(some))
    return found


def table(runs: Sequence[Run]) -> None:
    """The program, by scene and distance: errors in bounds, and relative."""
    print(
        f"\n{'scene':24}{'distance':>10}{'closeness':>11}"
        + "".join(f"{kind + ', bounds':>22}" for kind in KINDS)
    )
    for one in sorted(runs, key=lambda one: (list(SCENES).index(one.scene), -one.distance)):
        if one.method == OWN:
            cells = [
                "refused" if one.misses is None or not np.isfinite(one.misses[kind].times)
                else f"{one.misses[kind].times:.2f} ({one.misses[kind].error:.0e})"
                for kind in KINDS
            ]  # fmt: skip
            print(
                f"{one.scene:24}{one.distance:10.0e}{one.closeness:11.1e}"
                + "".join(f"{c:>22}" for c in cells)
            )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", dest="folder", type=Path, default=CHARTS, help="folder of the charts")
    stored.add_option(parser)
    options = parser.parse_args()
    runs = measure()
    table(runs)
    chart.by_method(runs, options.folder / "near_singular.svg")
    chart.factors(runs, options.folder / "near_singular_ours.svg")
    stored.report("near_singular", figures(runs), options.store)


if __name__ == "__main__":
    main()
