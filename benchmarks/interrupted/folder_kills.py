"""`tmm-report solve` killed again and again while it writes into one folder: is the folder ever of two minds?

    python -m benchmarks.interrupted.folder_kills    # 100 kills
    python -m benchmarks.interrupted.folder_kills 300 7        # as many, by another seed

Two variants take turns in one folder. Half of the kills fall anywhere in the run, half while the folder is changed,
which a run shows by its `.tmm-report.part`. After each, the folder as it stands, and as the next run finds it, is held
against both notes, file by file.
"""

from __future__ import annotations

import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

from tmm_report.commands.whole import LIST, NEW, PART, finish

ROOT = Path(__file__).parents[2]
NAMES = ("crank_rocker", "whitworth")


def started(name: str, folder: Path) -> subprocess.Popen[bytes]:
    command = [
        sys.executable,
        "-m",
        "tmm_report",
        "solve",
        str(ROOT / "variants" / f"{name}.yaml"),
        "-o",
        str(folder),
    ]
    return subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def tree(folder: Path) -> dict[str, bytes]:
    files = (file for file in folder.rglob("*") if file.is_file())
    found = {file.relative_to(folder).as_posix(): file.read_bytes() for file in files}
    return {name: text for name, text in found.items() if name.split("/")[0] not in (LIST, PART, NEW)}


def killed(running: subprocess.Popen[bytes], folder: Path, moments: random.Random, whole: float) -> None:
    """Somewhere in the run, or a few milliseconds after the folder is first touched."""
    if moments.random() < 0.5:
        time.sleep(moments.uniform(0, whole))
    else:
        while running.poll() is None and not (folder / PART).exists():
            time.sleep(0.0002)
        time.sleep(moments.uniform(0, 0.02))
    running.send_signal(signal.SIGKILL)
    running.wait()


def main() -> None:
    kills, seed = (int(word) for word in (*sys.argv[1:3], *("100", "1")[len(sys.argv[1:3]) :]))
    moments, seen = random.Random(seed), Counter[str]()
    with tempfile.TemporaryDirectory() as place:
        notes, whole = [], 0.0
        for name in NAMES:
            began = time.perf_counter()
            assert started(name, Path(place, name)).wait() == 0
            whole = time.perf_counter() - began
            notes.append(tree(Path(place, name)))
        folder = Path(place, "note")
        shutil.copytree(Path(place, NAMES[0]), folder)
        for k in range(kills):
            killed(started(NAMES[(k + 1) % 2], folder), folder, moments, whole)
            seen["as it stands: " + ("one note" if tree(folder) in notes else "being finished")] += 1
            finish(folder)
            found = tree(folder)
            seen["next run finds: " + (NAMES[notes.index(found)] if found in notes else "MIXED")] += 1
            seen["parts left"] += any(".part" in path.name for path in folder.rglob("*"))
    for what, count in sorted(seen.items()):
        print(f"{count:5}  {what}")


if __name__ == "__main__":
    main()
