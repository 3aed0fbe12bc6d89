"""What methods cost: the table by which `method: auto` and the note's chapter count, measured anew.

    python -m benchmarks.speed.costs            prints the tables beside those that are shipped
    python -m benchmarks.speed.costs --write    puts them into tmm_report/mechanics/rivals/cost.py

CPU time of warm runs over mechanisms of 1 to 11 moving links at 12, 36 and 100 steps; by least squares, relative, so
much for a call, a link, a link at a position, none of them below zero.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

from tmm_report import load
from tmm_report.course import room, solve_lever
from tmm_report.mechanics.rivals import cost
from tmm_report.mechanics.rivals.forces import FORCES
from tmm_report.mechanics.rivals.motion.every import MOTIONS

ROOT = Path(__file__).parents[2]
VARIANTS = (
    "crank_rocker",
    "shaper",
    "grain_screen",
    "compressor",
    "jaw_crusher",
    "v_engine",
)
FOLLOWED = ("press", "quick_return")  # with a group above class II
COUNTS = (12, 36, 100)
SECONDS = 0.1  # CPU time that a method is given at each mechanism and count
Row = tuple[int, int, float]  # links, steps, µs


def least(run: Callable[[], object]) -> float:
    """The least CPU time of a run, µs: what else the machine does only adds to it."""
    run()
    best, spent = np.inf, 0.0
    while spent < SECONDS:
        times = max(1, int(0.01 / best)) if np.isfinite(best) and best > 0 else 1
        start = process_time()
        for _ in range(times):
            run()
        taken = process_time() - start
        best, spent = min(best, taken / times), spent + taken
    return 1e6 * best


def measured() -> dict[str, dict[str, list[Row]]]:
    """Rows of every method of the motion, of the same above class II, and of the forces."""
    motion, forces = _rows(VARIANTS)
    return {"MOTION": motion, "FOLLOWED": _rows(FOLLOWED)[0], "FORCES": forces}


def _rows(names: Sequence[str]) -> tuple[dict[str, list[Row]], dict[str, list[Row]]]:
    """Of the motion and of the forces."""
    motion: dict[str, list[Row]] = {}
    forces: dict[str, list[Row]] = {}
    for name in names:
        lever = load(ROOT / "variants" / f"{name}.yaml").lever
        assert lever is not None
        found = solve_lever(lever)
        cycle = found.kinematics.cycle
        _measure(motion, MOTIONS, cycle, cycle)
        if lever.loads is not None:
            scene = room("methods", "scene").scene(lever.loads, found.kinematics)
            _measure(forces, FORCES, scene, cycle)
    return motion, forces


def _measure(rows: dict[str, list[Row]], methods: Any, scene: Any, cycle: Any) -> None:
    links = len(cycle.linkage.mechanism.moving)
    for method in methods:
        if method.refuses(scene) is not None:
            continue
        for count in COUNTS:
            try:
                with np.errstate(all="ignore"):
                    taken = least(lambda: method.run(scene, count))  # noqa: B023
            except ArithmeticError:
                continue
            rows.setdefault(method.key, []).append((links, count, taken))


def fitted(rows: list[Row]) -> cost.Cost:
    """Least relative squares; what comes out below zero is left out, one by one."""
    links, counts, taken = (np.array(column, dtype=float) for column in zip(*rows, strict=True))
    parts = np.stack([np.ones_like(links), links, links * (counts + 1)], axis=1) / taken[:, None]
    kept = [0, 1, 2]
    while True:
        found, *_ = np.linalg.lstsq(parts[:, kept], np.ones_like(taken), rcond=None)
        if (found >= 0).all() or len(kept) == 1:
            break
        kept.pop(int(np.argmin(found)))
    whole = np.zeros(3)
    whole[kept] = np.maximum(found, 0.0)
    return cost.Cost(*(float(f"{x:.2g}") for x in whole))


def written(name: str, table: Mapping[str, cost.Cost]) -> str:
    rows = "".join(f'    "{key}": Cost({", ".join(map(repr, one))}),\n' for key, one in table.items())
    return f"{name}: dict[str, Cost] = {{\n{rows}}}\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--write", action="store_true", help="put the tables into cost.py")
    write = parser.parse_args().write
    path = Path(cost.__file__)
    text = path.read_text("utf-8")
    for name, rows in measured().items():
        shipped = getattr(cost, name)
        table = {key: fitted(own) for key, own in rows.items()}
        table |= {key: one for key, one in shipped.items() if key not in table}
        for key, one in table.items():
            print(f"{name:8}{key:24}{one!s:60} shipped {tuple(shipped.get(key, ()))}")
        text = re.sub(rf"{name}: dict\[str, Cost\] = {{\n.*?\n}}\n", written(name, table), text, flags=re.S)
    if write:
        path.write_text(text, "utf-8")


if __name__ == "__main__":
    main()
