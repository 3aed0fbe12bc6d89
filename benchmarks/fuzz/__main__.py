"""Mutated or generated variants, each read, solved and some rendered: a note or a refusal in words must come out.

    python -m benchmarks.fuzz --count 20000 --render 2000 --seed 1 --jobs 1 -o /tmp/fuzz
    python -m benchmarks.fuzz --generated --count 20000 --seed 1 --jobs 1 -o /tmp/generated

A mutation changes the text or the data of a ready variant or a sample; a generated variant is drawn from the schema of
the format, and every one that solves is rendered. Wrong are an exception, a warning of numpy, more
than 20 s of one core, more than 500 MB, a message without its words or values. Each finding is kept with its text.
Printed, never asserted; the same seed makes the same cases.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from random import Random
from zlib import crc32

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "tests" / "variant")]

from benchmarks.fuzz import data, texts  # noqa: E402
from benchmarks.fuzz.generated import whole  # noqa: E402
from benchmarks.fuzz.judge import Outcome, tried  # noqa: E402
from benchmarks.fuzz.report import Report  # noqa: E402
from benchmarks.fuzz.workers import outcomes  # noqa: E402
from tmm_report.yamlread import loads as yaml  # noqa: E402


class Cases:
    """Case k of a seed: a text, the same whenever it is asked for."""

    def __init__(self, seed: int):
        files = sorted(
            [
                *ROOT.glob("variants/*.yaml"),
                *ROOT.glob("tests/samples/*.yaml"),
                *ROOT.glob("tests/edges/*.yaml"),
            ]
        )
        self.seed, self.texts = seed, {file.stem: file.read_text("utf-8") for file in files}
        self.data = {name: yaml(text).data for name, text in self.texts.items()}

    def text(self, k: int) -> tuple[str, str]:
        """The text, and how it came about."""
        random = Random(f"{self.seed} {k}")
        name = random.choice(list(self.texts))
        if random.random() < 0.5:
            made, how = texts.mutated(self.texts[name], random, list(self.texts.values()))
        else:
            made, how = data.mutated(self.data[name], random, list(self.data.values()))
        return made, f"{name}: {how}"


class Generated:
    """Case k of a seed, drawn from the schema."""

    def __init__(self, seed: int):
        self.seed = seed

    def text(self, k: int) -> tuple[str, str]:
        return whole.text(f"{self.seed} {k}"), "generated"


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=20_000, help="cases")
    parser.add_argument("--render", type=int, default=2_000, help="how many of the solved ones are rendered")
    parser.add_argument("--generated", action="store_true", help="drawn from the schema, all rendered")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--jobs", type=int, default=1, help="processes at once")
    parser.add_argument("-o", type=Path, required=True, help="folder of findings")
    asked = parser.parse_args()
    numbers, ready = range(asked.first, asked.first + asked.count), Cases(asked.seed)
    _warm(ready)
    cases = Generated(asked.seed) if asked.generated else ready
    for job in range(1, asked.jobs):
        if os.fork() == 0:
            _run(cases, numbers[job :: asked.jobs], asked, f"-{job}")
            os._exit(0)
    _run(cases, numbers[:: asked.jobs], asked, "")
    for _ in range(1, asked.jobs):
        os.wait()


def _run(cases: Cases | Generated, numbers: Sequence[int], asked: argparse.Namespace, name: str) -> None:
    """These cases, and what is found of them."""
    report = Report(asked.o, name)
    share = _share(asked)

    def case(k: int) -> Outcome:
        made, _ = cases.text(k)
        return tried(made, rendered=crc32(f"{k}".encode()) % 1000 < 1000 * share)

    for k, outcome in outcomes(numbers, case):
        report.add(k, outcome, *cases.text(k))
    report.close()


def _share(asked: argparse.Namespace) -> float:
    """Which part of the cases is rendered if it solves: about three of ten do."""
    if asked.generated:
        return 1.0
    return min(1.0, asked.render / max(1, asked.count) / 0.28)


def _warm(cases: Cases) -> None:
    """Everything is imported and every template compiled before the first fork."""
    for name in ("compressor", "engine_four_stroke", "governor_servo", "eccentric", "forging_machine_wear"):
        tried(cases.texts[name], rendered=True)


if __name__ == "__main__":
    main()
