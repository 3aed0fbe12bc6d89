"""Runs the gear peers that this interpreter has and prints JSON: pair -> peer -> errors and time beside ours.

python -m benchmarks.peers.gears.run
"""

from __future__ import annotations

import json
import subprocess
import warnings
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from benchmarks.peers.gears import by_freecad, by_gearworks, by_mechanism, ours
from benchmarks.peers.gears.scene import PAIRS, GearPair, errors
from benchmarks.peers.turns import in_turns

ROOT = Path(__file__).parents[3]
PEERS = {"ours": ours, "mechanism": by_mechanism, "py_gearworks": by_gearworks, "FreeCAD": by_freecad}


def versions() -> dict[str, str]:
    """Of the peers that are installed beside ours."""
    found = {key: peer.version() for key, peer in PEERS.items()}
    return {key: version for key, version in found.items() if version is not None}


def measured(rounds: int = 15) -> dict[str, dict[str, dict[str, Any]]]:
    """Pair -> "peer, what of it" -> errors and the ratio of its time to ours of the same, or what is missing."""
    present = {"ours", *versions()}
    peers = {key: peer for key, peer in PEERS.items() if key in present}
    return {title: _pair(pair, peers, rounds) for title, pair in PAIRS.items()}


def _pair(pair: GearPair, peers: dict[str, Any], rounds: int) -> dict[str, dict[str, Any]]:
    calls: dict[str, Callable[[], Any]] = {}
    found: dict[str, dict[str, Any]] = {}
    kinds: dict[str, str] = {}
    for key, peer in peers.items():
        for kind, solve in peer.SETTINGS.items():
            name = f"{key}, {kind}"
            try:
                found[name] = {"errors": errors(solve(pair), pair)}
                calls[name], kinds[name] = partial(solve, pair), kind
            except NotImplementedError as missing:
                found[name] = {"missing": str(missing)}
    taken = in_turns(calls, rounds)
    for name, seconds in taken.items():
        found[name]["ratio"] = seconds / taken[f"ours, {kinds[name]}"]
    return found


def elsewhere(python: str) -> tuple[dict[str, str], dict[str, Any]]:
    """Versions and measurements of the peers that another interpreter has, by its own process."""
    command = [python, "-m", "benchmarks.peers.gears.run"]
    done = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    answer = json.loads(done.stdout.splitlines()[-1])
    return answer["versions"], answer["measured"]


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    print(json.dumps({"versions": versions(), "measured": measured()}))
