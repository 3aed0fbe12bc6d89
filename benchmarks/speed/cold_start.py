"""Wall time of a cold `solve` against a bare interpreter that imports the libraries it stands on.

    python -m benchmarks.speed.cold_start [--store]   # this checkout
    python -m benchmarks.speed.cold_start CHECKOUT    # and another one, say of the commit before, taking turns with it

Fresh processes taking turns; medians. Bytecode is cached in a folder of the run's own, filled by the round that
warms up, as pip does for an installed package. "names": `import numpy, pydantic, yaml, typer`, which puts
most of pydantic off; "bare": what a program that has one block and one command of its own cannot do without.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

from benchmarks.measuring import stored
from benchmarks.measuring.timing import interleaved

ROOT = Path(__file__).parents[2]
ROUNDS = 15
NAMES = "import numpy, pydantic, yaml, typer"
BARE = """
import numpy, yaml, typer
from pydantic import BaseModel
class Block(BaseModel):
    speed: float
app = typer.Typer()
@app.command()
def solve(file: str) -> None:
    Block.model_validate(yaml.safe_load(file))
app(["speed: 3"])
"""
NOTES = {"html": "crank_rocker", "html, gear drive": "compressor", "html, class III": "quick_return"}


def run(folder: str, *arguments: str, checkout: Path = ROOT) -> None:
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    environment["PYTHONPYCACHEPREFIX"] = str(Path(folder, "bytecode"))
    environment["PYTHONPATH"] = str(checkout)
    subprocess.run(
        [sys.executable, *arguments], cwd=checkout, env=environment, check=True, capture_output=True
    )


def solve(folder: str, variant: str, fmt: str) -> tuple[str, ...]:
    return "-m", "tmm_report", "solve", f"variants/{variant}.yaml", "--format", fmt, "-o", folder


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("checkout", nargs="?", type=Path, help="another checkout, taking turns")
    parser.add_argument("--rounds", type=int, default=ROUNDS, help="turns taken")
    stored.add_option(parser)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rivals = {
            "names": partial(run, folder, "-c", NAMES),
            "bare": partial(run, folder, "-c", BARE),
            "json": partial(run, folder, *solve(folder, "compressor", "json")),
            "help": partial(run, folder, "-m", "tmm_report", "--help"),
        }
        for name, variant in NOTES.items():
            rivals[name] = partial(run, folder, *solve(folder, variant, "html"))
        if options.checkout:
            other = options.checkout.resolve()
            rivals["json of the other"] = partial(
                run, folder, *solve(folder, "compressor", "json"), checkout=other
            )
        taken = interleaved(rivals, options.rounds)
    for name, seconds in taken.items():
        print(f"{name:<20}{1e3 * seconds:8.0f} ms")
    stored.report(
        "cold_start",
        {f"{name} : bare": seconds / taken["bare"] for name, seconds in taken.items() if name != "bare"},
        options.store,
    )


if __name__ == "__main__":
    main()
