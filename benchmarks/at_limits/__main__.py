"""Extremes of random mechanisms at the limits of Grashof's kind, held against places in 50 digits.

    python -m benchmarks.at_limits --count 2000 --seed 1 -o /tmp/at_limits         # goes on where it was stopped
    python -m benchmarks.at_limits --count 300 --away 1e-3 -o /tmp/near_limits     # so many mm beside a limit

Printed, never asserted. `--part 1/2` and `--part 2/2` share the work between two processes.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from dataclasses import asdict
from fractions import Fraction
from pathlib import Path

from benchmarks.at_limits.draw import FAMILIES, draw
from benchmarks.at_limits.judge import Verdict, judged


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=2000, help="mechanisms in all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--away", type=Fraction, default=Fraction(0), help="mm beside the limit")
    parser.add_argument("--part", default="1/1", help="which share of them")
    parser.add_argument("-o", type=Path, required=True, help="folder of verdicts")
    args = parser.parse_args()
    args.o.mkdir(parents=True, exist_ok=True)
    part, parts = map(int, args.part.split("/"))
    families = list(FAMILIES)
    for n in range(args.count):
        number, family = divmod(n, len(families))
        file = args.o / f"{args.seed}-{n}.json"
        if n % parts == part - 1 and not file.exists():
            scene = draw(families[family], number, args.seed, args.away)
            verdict = judged(scene)
            file.write_text(
                json.dumps(asdict(verdict) | ({"file": scene.text} if verdict.wrong else {})), "utf-8"
            )
    print(table([read(file) for file in sorted(args.o.glob("*.json"))]))


def read(file: Path) -> Verdict:
    item = json.loads(file.read_text("utf-8"))
    item.pop("file", None)
    return Verdict(**item | {"wrong": tuple(item["wrong"])})


def table(verdicts: Sequence[Verdict]) -> str:
    """Right of drawn, and the largest errors of the largest velocity, acceleration and stroke of what is right."""
    rows = ["| family | right of drawn | V | A | stroke |", "|---|---|---|---|---|"]
    for family in (*FAMILIES, "all"):
        own = [v for v in verdicts if family in (v.family, "all")]
        if own:
            good = [v for v in own if not v.wrong]
            worst = [max((getattr(v, key) for v in good), default=0.0) for key in "VAH"]
            cells = [family, f"{len(good)} of {len(own)}", *(f"{x:.0e}" for x in worst)]
            rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows)


if __name__ == "__main__":
    main()
