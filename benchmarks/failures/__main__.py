"""The table of failures: every failing scene by every method, by the program and by other programs.

    python -m benchmarks.failures [-o docs/stability.md] [--peers PYTHON] [--store]     needs mpmath; some minutes

Each scene is run, and each cell judged against closed formulas in many digits: right, an honest refusal, or wrong
without a word. `-o`: a page between whose marks the tables are put. `--peers`: the interpreter in which other programs
are installed (benchmarks/peers/requirements.txt); without it they are left out.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from benchmarks.failures import columns, others, page
from benchmarks.failures.judge import REFUSED, RIGHT, WRONG, Cell
from benchmarks.failures.scenes import SCENES
from benchmarks.measuring import stored

MOTION = {
    columns.OURS: "the program", "groups": "groups alone", "newton": "Newton, guarded", "plain_newton": "Newton, plain",
    "root_finder": "root finder", "constraints": "integration, RK4", "constraints_corrected": "RK4, corrected",
    "constraints_dop853": "DOP853", "parallelogram": "parallelogram", "drawing_0.01": "drawing 0.01 mm",
    "drawing_0.1": "drawing 0.1 mm", "differences": "differences", "spline": "spline", "fourier": "Fourier",
}  # fmt: skip
FORCE = {
    "groups": "groups", "system": "one system", "virtual_work": "virtual work", "drawing_0.01": "drawing 0.01 mm",
    "drawing_0.1": "drawing 0.1 mm",
}  # fmt: skip
START = {
    "program": "the program", "runge_kutta": "RK4, 400 steps", "adams": "Adams, 400 steps", "lsoda_1e-7": "LSODA 1e-7",
    "dop853_1e-7": "DOP853 1e-7", "radau_1e-7": "Radau 1e-7",
}  # fmt: skip
INVOLUTE = {
    "series_and_halley": "the program", "newton_involute": "Newton", "halley_involute": "Halley",
    "bisection": "bisection", "series": "five terms",
}  # fmt: skip


def motion() -> dict[str, dict[str, Cell]]:
    rows = {}
    for key, scene in SCENES.items():
        cells = {columns.OURS: columns.ours(key)}
        cells |= {method.key: columns.by_method(key, method) for method in columns.motion_methods()}
        rows[scene.title] = cells
        print(f"{scene.title:60}{cells[columns.OURS].text}", flush=True)
    return rows


def forces() -> dict[str, dict[str, Cell]]:
    return {
        scene.title: {method.key: columns.by_force_method(key, method) for method in columns.force_methods()}
        for key, scene in SCENES.items()
    }


def spoken() -> dict[str, tuple[Cell, list[str]]]:
    """The program's sentences, without those that every solution has."""
    plain = ("largest difference of the graph", "checks of the balancing moment", "I(0,1)", "no polygons")
    found = {}
    for key, scene in SCENES.items():
        one = columns.solved(key)
        lines = [line for line in one.lines if not line.startswith(plain)]
        found[scene.title] = (columns.ours(key), [*lines, *(f"in the note: {x}" for x in columns.noted(one))])
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", dest="page", type=Path, help="a page between whose marks the tables are put")
    parser.add_argument("--peers", type=Path, help="interpreter in which other programs are installed")
    stored.add_option(parser)
    options = parser.parse_args()
    tables = {"motion": (motion(), MOTION), "forces": (forces(), FORCE)}
    tables["start-ups"] = (dict(others.start_ups()), START)
    tables["involutes"] = (dict(others.involutes()), INVOLUTE)
    if peers := columns.peers(options.peers):
        titles = {key: scene.title for key, scene in SCENES.items()}
        rows = {titles[key]: {peer: peers[peer][key] for peer in peers} for key in next(iter(peers.values()))}
        tables["peers"] = (rows, {peer: peer for peer in peers})
    figures: dict[str, float] = {}
    for name, (rows, heads) in tables.items():
        for column, of in page.counts(rows, heads).items():
            for verdict in (RIGHT, REFUSED, WRONG):
                figures[f"{name} : {heads[column]} : {verdict}"] = of.get(verdict, 0)
    if options.page:
        made = {name: page.table(rows, heads) for name, (rows, heads) in tables.items()}
        page.put(options.page, made | {"said": page.said(spoken())})
    stored.report("failures", figures, options.store)
    if figures[f"motion : {MOTION[columns.OURS]} : {WRONG}"]:
        raise SystemExit("the program is wrong without a word")


if __name__ == "__main__":
    main()
