"""The quick benchmarks one after another, each figure beside the last stored run. Nothing fails on what they say.

    python -m benchmarks.compare            # a minute
    python -m benchmarks.compare --store    # keep the figures as benchmarks/results/NAME.json

A benchmark that breaks is told and passed over.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path

from benchmarks.measuring import stored

ROOT = Path(__file__).parents[1]
QUICK = (("compressor_36",), ("higher",), ("cold_start", "--rounds", "3"))
SECONDS = 120  # of one of them, at most


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    stored.add_option(parser)
    options = ["--store"] if parser.parse_args().store else []
    for name, *few in QUICK:
        print(f"\n# {name}", flush=True)
        try:
            subprocess.run(
                [sys.executable, "-m", f"benchmarks.speed.{name}", *([] if options else few), *options],
                cwd=ROOT,
                timeout=SECONDS,
                check=True,
            )
        except (subprocess.SubprocessError, OSError) as error:
            print(f"{name}: {error}", flush=True)


if __name__ == "__main__":
    main()
