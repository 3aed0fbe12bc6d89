"""Other programs beside ours: the compressor's 36 positions and a spur pair; errors, times, cold starts.

    python -m benchmarks.peers -o docs --store --gears /path/to/python

Writes peers.md and charts/peers.svg into the folder. What has to be installed: requirements.txt beside this file. A
program that is not installed is left out with a word; py_gearworks may live in an environment of its own (`--gears`).
"""

from __future__ import annotations

import argparse
import os
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from benchmarks.measuring import stored
from benchmarks.peers import chart, cold, judge, page, scenes, table
from benchmarks.peers.gears import run as gears
from benchmarks.peers.gears.scene import POINTS
from benchmarks.peers.scene import angles, compressor, reference


def main() -> None:
    options = _options()
    peers = {key: scenes.PEERS[key] for key in scenes.installed()}
    for key in scenes.PEERS.keys() - peers.keys():
        print(f"{key} is not installed: left out")
    scene = compressor()
    phi = angles(scene)
    with scenes.quiet():
        rows = judge.measured(peers, scene, phi, reference(scene, phi))
    starts = cold.ratios(peers, options.rounds)
    versions, pairs = _gears(options.gears)
    tables = {"levers": table.levers(rows), "cold": table.cold(starts), "gears": table.gears(pairs)}
    versions = {key: peer.version() or "" for key, peer in peers.items()} | versions
    options.folder.mkdir(parents=True, exist_ok=True)
    (options.folder / "peers.md").write_text(page.text(tables, versions, POINTS), "utf-8")
    chart.draw(rows, options.folder / "charts" / "peers.svg")
    print("\n\n".join(tables.values()))
    stored.report("peers", table.figures(rows, starts, pairs), options.store)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", dest="folder", type=Path, required=True, help="folder for peers.md and charts/")
    parser.add_argument("--rounds", type=int, default=5, help="fresh processes of each program")
    parser.add_argument("--gears", metavar="PYTHON", help="interpreter that has py_gearworks")
    stored.add_option(parser)
    return parser.parse_args()


def _gears(python: str | None) -> tuple[dict[str, str], dict]:
    """Measured here, and, of programs that another interpreter has, there; ours is measured beside both."""
    versions, found = gears.versions(), gears.measured()
    if python:
        theirs, measured = gears.elsewhere(python)
        versions |= theirs
        for pair, rows in measured.items():
            found[pair] |= {name: row for name, row in rows.items() if not name.startswith("ours")}
    return versions, found


if __name__ == "__main__":
    main()
