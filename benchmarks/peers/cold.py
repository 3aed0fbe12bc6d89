"""Cold start: a fresh process imports a peer, builds the compressor and solves its 36 positions once.

python -m benchmarks.peers.cold KEY [MODULE]      as if the module were not installed
"""

from __future__ import annotations

import contextlib
import io
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

from benchmarks.peers.peer import Peer
from benchmarks.peers.turns import in_turns, of_children

ROOT = Path(__file__).parents[2]


def ratios(peers: dict[str, Peer], rounds: int = 5) -> dict[str, float]:
    """CPU time of a fresh process of every peer, in its first setting, to ours; processes take turns."""
    rivals: dict[str, Callable[[], None]] = {key: partial(_process, key) for key in peers}
    if "pylinkage" in peers:
        rivals["pylinkage without numba"] = partial(_process, "pylinkage", "numba")
    taken = in_turns(rivals, rounds, of_children)
    return {key: taken[key] / taken["ours"] for key in rivals}


def _process(*words: str) -> None:
    command = [sys.executable, "-m", "benchmarks.peers.cold", *words]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)


def main(key: str, without: str = "") -> None:
    if without:
        sys.modules[without] = None  # type: ignore[assignment]
    from importlib import import_module

    from benchmarks.peers.scene import angles, compressor

    room = "ours" if key == "ours" else f"programs.by_{key}"
    peer: Peer = import_module(f"benchmarks.peers.{room}").PEER
    scene = compressor()
    setting = {"fast": False} if without else next(iter(peer.settings.values()))
    with contextlib.redirect_stdout(io.StringIO()):
        peer.prepare(scene, angles(scene), **setting)()


if __name__ == "__main__":
    main(*sys.argv[1:])
