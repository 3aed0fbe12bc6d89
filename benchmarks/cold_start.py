"""Wall time of a cold `solve --format json` against a bare interpreter that imports the libraries it stands on.

    python benchmarks/cold_start.py

Fresh processes taking turns; medians. Printed, never asserted. Bytecode is cached in a folder of the run's own, filled
by the round that warms up, as pip does for an installed package.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from timing import interleaved

ROOT = Path(__file__).parents[1]
ROUNDS = 15


def run(folder: str, *arguments: str) -> None:
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    environment["PYTHONPYCACHEPREFIX"] = str(Path(folder, "bytecode"))
    subprocess.run([sys.executable, *arguments], cwd=ROOT, env=environment, check=True, capture_output=True)


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        solve = ("-m", "tmm_report", "solve", "variants/compressor.yaml", "--format", "json", "-o", folder)
        taken = interleaved(
            {
                "bare": lambda: run(folder, "-c", "import numpy, pydantic, yaml, typer"),
                "solve": lambda: run(folder, *solve),
                "help": lambda: run(folder, "-m", "tmm_report", "--help"),
            },
            ROUNDS,
        )
    for name, seconds in taken.items():
        print(f"{name:<6}{1e3 * seconds:8.0f} ms{seconds / taken['bare']:7.2f}")


if __name__ == "__main__":
    main()
