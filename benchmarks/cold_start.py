"""Wall time of a cold `solve --format json` against a bare interpreter that imports the libraries it stands on.

    python benchmarks/cold_start.py             # this checkout
    python benchmarks/cold_start.py CHECKOUT    # and another one, say of the commit before, taking turns with it

Fresh processes taking turns; medians. Printed, never asserted. Bytecode is cached in a folder of the run's own, filled
by the round that warms up, as pip does for an installed package.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

from timing import interleaved

ROOT = Path(__file__).parents[1]
ROUNDS = 15


def run(folder: str, *arguments: str, checkout: Path = ROOT) -> None:
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    environment["PYTHONPYCACHEPREFIX"] = str(Path(folder, "bytecode"))
    environment["PYTHONPATH"] = str(checkout)
    subprocess.run(
        [sys.executable, *arguments], cwd=checkout, env=environment, check=True, capture_output=True
    )


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        solve = ("-m", "tmm_report", "solve", "variants/compressor.yaml", "--format", "json", "-o", folder)
        rivals = {
            "bare": lambda: run(folder, "-c", "import numpy, pydantic, yaml, typer"),
            "solve": lambda: run(folder, *solve),
            "help": lambda: run(folder, "-m", "tmm_report", "--help"),
        }
        for other in (Path(name).resolve() for name in sys.argv[1:2]):
            rivals["other"] = partial(run, folder, *solve, checkout=other)
        taken = interleaved(rivals, ROUNDS)
    for name, seconds in taken.items():
        print(f"{name:<6}{1e3 * seconds:8.0f} ms{seconds / taken['bare']:7.2f}")


if __name__ == "__main__":
    main()
