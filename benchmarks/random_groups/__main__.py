"""Random mechanisms of class III and IV, answered by the program and judged by an independent search.

    python -m benchmarks.random_groups --count 11000 --seed 1 -o /tmp/random_groups

Printed, never asserted. A run that was stopped goes on where it was: each chunk has its file of verdicts.
"""

from __future__ import annotations

import argparse
import json
import pickle
import time
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

import numpy as np

from benchmarks.random_groups.draw import Batch
from benchmarks.random_groups.families import SHARES, drawn
from benchmarks.random_groups.judge import Verdict, asked, judged
from benchmarks.random_groups.search import Truth, truth
from benchmarks.random_groups.table import markdown

CHUNK = 500


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=11_000, help="mechanisms in all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--families", nargs="*", choices=SHARES, default=list(SHARES))
    parser.add_argument("--truths", type=Path, help="folder of what the search found (default: that of -o)")
    parser.add_argument("-o", type=Path, required=True, help="folder of verdicts")
    parser.add_argument("--search-only", action="store_true")
    parser.add_argument("--again", action="store_true", help="ask the wrong ones again")
    args = parser.parse_args()
    args.o.mkdir(parents=True, exist_ok=True)
    truths = args.truths or args.o
    truths.mkdir(parents=True, exist_ok=True)
    for family, k, count in _chunks(args.families, args.count):
        _chunk(args, truths, family, k, count)
    if not args.search_only:
        print(markdown([verdict for file in sorted(args.o.glob("*.json")) for verdict in read(file)]))


def _chunks(families: Sequence[str], count: int) -> list[tuple[str, int, int]]:
    """Family, number and size of every chunk, the first of all families first."""
    share = sum(SHARES[family] for family in families)
    found = []
    for n, family in enumerate(families):
        total = round(count * SHARES[family] / share)
        found += [(k, n, family, min(CHUNK, total - k * CHUNK)) for k in range(-(-total // CHUNK))]
    return [(family, k, size) for k, _, family, size in sorted(found)]


def _chunk(args: argparse.Namespace, truths: Path, family: str, k: int, count: int) -> None:
    """One chunk: search, ask, judge; what is done already stays, but for what was wrong where that is wished."""
    name, begin = f"{family}-{args.seed}-{k}-{count}", time.perf_counter()
    done = args.o / f"{name}.json"
    known = json.loads(done.read_text("utf-8")) if done.exists() else []
    lanes = [n for n in range(count) if not known or (args.again and known[n]["wrong"])]
    if not lanes:
        return
    batch, right = searched(truths / f"{name}.pickle", family, count, args.seed * 1000 + k)
    took = time.perf_counter() - begin
    if not args.search_only:
        found = known or [{} for _ in lanes]
        for lane in lanes:
            verdict = judged(batch, right, lane, asked(batch.file(lane)))
            found[lane] = asdict(verdict) | ({"file": batch.file(lane)} if verdict.wrong else {})
        part = done.with_suffix(".part")
        part.write_text(json.dumps(found), "utf-8")
        part.rename(done)
        wrong = sum(bool(v["wrong"]) for v in found)
        print(f"{name}: {wrong} of {count} wrong; ", end="")
    print(f"{name}: searched {took:.0f} s, all {time.perf_counter() - begin:.0f} s", flush=True)


def searched(file: Path, family: str, count: int, seed: int) -> tuple[Batch, Truth]:
    """A chunk drawn and searched, kept in a file."""
    if file.exists():
        return pickle.loads(file.read_bytes())  # of our own making
    batch = drawn(family, count, seed)
    found = batch, truth(batch)
    file.write_bytes(pickle.dumps(found))
    return found


def read(file: Path) -> list[Verdict]:
    """The verdicts of a chunk."""
    found = []
    for item in json.loads(file.read_text("utf-8")):
        item.pop("file", None)
        found.append(Verdict(**item | {"wrong": tuple(item["wrong"])}))
    return found


if __name__ == "__main__":
    np.seterr(all="ignore")
    main()
