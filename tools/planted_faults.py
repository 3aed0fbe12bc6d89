"""Plant wrong outputs one at a time and see that a test notices: `python tools/planted_faults.py [part of a name ...]`.

Every fault of tools/faults.py is an edit in a copy of the program; the tests of the page and those that the fault names
run there on one or two variants. A fault that makes no test fail that did not fail before survives: its name is printed
and the exit code is 1; so it is where an edit does not find its text. Golden texts are left out, for they only say
that something changed (`--golden` lets them look too), but of the faults of words, which they alone hold.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import SimpleQueue

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "tools")]
import faults  # noqa: E402
import faults_balance  # noqa: E402
import faults_cures  # noqa: E402
import faults_edges  # noqa: E402
import faults_exact  # noqa: E402
import faults_methods  # noqa: E402
import faults_motion  # noqa: E402
import faults_note  # noqa: E402
import faults_words  # noqa: E402
from faults import Fault  # noqa: E402

FAULTS = (
    *faults.FAULTS,
    *faults_motion.FAULTS,
    *faults_balance.FAULTS,
    *faults_note.FAULTS,
    *faults_edges.FAULTS,
    *faults_cures.FAULTS,
    *faults_methods.FAULTS,
    *faults_exact.FAULTS,
    *faults_words.faults(ROOT),
)

COPIED = (
    "tmm_report",
    "templates",
    "variants",
    "tests",
    "tools",
    "benchmarks",
    "pyproject.toml",
    "README.md",
    "docs",
)
TEXTS = "test_golden_text.py"
GEARS_BESIDE, LEVERS_BESIDE = "tables/test_other_gears.py", "tables/test_other_levers.py"
WINGS = {"gears": "gears", "machine": "machine", "masses": "machine", "pairs": "machine/pairs"}
PAPER = "drawings/test_measured_on_paper.py"
GEARS = ("hoist_drive", "eccentric")  # variants whose faults gears of no variant may notice: they cost time
FAILED = re.compile(r"^(?:FAILED|ERROR) (\S+)", re.M)


class Misplaced(LookupError):
    """An edit that does not find its text exactly once."""


def copy(folder: Path) -> Path:
    """The program without its history and caches."""
    for name in COPIED:
        source, target = ROOT / name, folder / name
        if source.is_dir():
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__", ".*cache"))
        elif source.exists():
            shutil.copy(source, target)
    return folder


def failing(
    folder: Path, fault: Fault, golden: bool, one: bool = False, only: frozenset[str] | None = None
) -> frozenset[str]:
    """The tests that fail in a copy, those that cannot even be collected among them, or `one` of them, or of those that
    are named; of a fault of words only the approved texts are asked."""
    if only is not None and not only:
        return only
    # the exhaustive ones too: the variants are chosen here; who noticed the last fault is asked first
    command = [sys.executable, "-m", "pytest", "-q", "-m", "", "--tb=no", "-rfE", "--assert=plain"]
    command += ["-x", "--failed-first"] if one else ["-p", "no:cacheprovider"]
    found = frozenset[str]()
    for asked in [sorted(only)] if only else _asked(fault, golden):
        added = {"PYTHONPATH": str(folder), "PAGE_VARIANTS": fault.variants}
        done = subprocess.run(
            command + asked, cwd=folder, env=os.environ | added, capture_output=True, text=True
        )
        if done.returncode not in (0, 1, 2, 5) and not FAILED.search(done.stdout):
            return frozenset({f"pytest ended with {done.returncode}: {done.stdout[-300:]}"})
        found |= frozenset(FAILED.findall(done.stdout))
        if found and one:
            break
    return found


def _asked(fault: Fault, golden: bool) -> list[list[str]]:
    """The tests that look at a fault, cheap ones apart from those that set a note in LaTeX and print it."""
    if fault.words:
        return [[f"tests/page/{TEXTS}"]]
    twice = [one for one in _second_ways(fault.file) if one not in fault.tests]
    left = [LEVERS_BESIDE, *([] if fault.variants in GEARS else [GEARS_BESIDE]), *([] if golden else [TEXTS])]
    cheap = [
        *fault.tests,
        *twice,
        "tests/page",
        *(f"--ignore=tests/page/{other}" for other in [*left, PAPER]),
    ]
    return [cheap, [f"tests/page/{PAPER}"]]


def _second_ways(file: str) -> list[str]:
    """The tests of second ways of the chapter that a file is of, or of the chapters of its wing of mechanics: a formula
    is evaluated where it is printed, so that the page alone does not know a wrong one."""
    at = Path(file).parts
    if at[1] == "chapters":
        asked = f"tests/chapters/**/test_{at[3]}_twice.py"
    elif at[1] == "mechanics" and at[2] in WINGS:
        asked = f"tests/chapters/{WINGS[at[2]]}/**/test_*_twice.py"
    else:
        return []
    return sorted(str(one.relative_to(ROOT)) for one in ROOT.glob(asked))


def planted(folder: Path, fault: Fault) -> bytes:
    """Make the edit; the text as it was. Raises Misplaced."""
    path = folder / fault.file
    data, old = (path.read_bytes() if path.exists() else b""), fault.old.encode()
    if data.count(old) != 1:
        raise Misplaced(f"its text stands {data.count(old)} times in {fault.file}")
    path.write_bytes(data.replace(old, fault.new.encode()))
    return data


def placed(fault: Fault) -> bool:
    """Whether an edit finds its text in the program as it is."""
    path = ROOT / fault.file
    return path.exists() and path.read_bytes().count(fault.old.encode()) == 1


class Planter:
    """Copies of the program, one for each worker."""

    def __init__(self, folders: list[Path], golden: bool):
        self.golden = golden
        self.passes: set[tuple[str, str]] = set()  # tests that pass without a fault, each with its variants
        self.free: SimpleQueue[Path] = SimpleQueue()
        for folder in folders:
            self.free.put(folder)

    def told(self, fault: Fault) -> tuple[Fault, list[str], str]:
        """A fault, the tests that notice it, and what is wrong with the edit.

        The first test that fails is asked once without a fault: it notices only what it does not say anyway. All tests
        are asked both ways where it fails there too.
        """
        folder = self.free.get()
        try:
            first = self.failing_with(fault, folder, one=True)
            asked = {(test, fault.variants) for test in first}
            if not asked <= self.passes and failing(folder, fault, self.golden, only=first):
                first = self.failing_with(fault, folder) - failing(folder, fault, self.golden)
            else:
                self.passes |= asked
            return fault, sorted(first), ""
        except Misplaced as misplaced:
            return fault, [], str(misplaced)
        finally:
            self.free.put(folder)

    def failing_with(self, fault: Fault, folder: Path, one: bool = False) -> frozenset[str]:
        text = planted(folder, fault)
        try:
            return failing(folder, fault, self.golden, one=one)
        finally:
            (folder / fault.file).write_bytes(text)


def run(faults: list[Fault], jobs: int, golden: bool) -> Iterator[tuple[Fault, list[str], str]]:
    with tempfile.TemporaryDirectory() as temporary, ThreadPoolExecutor(jobs) as pool:
        folders = [copy(Path(temporary) / f"copy{k}") for k in range(jobs)]
        yield from pool.map(Planter(folders, golden).told, faults)


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", help="parts of names: only these faults")
    parser.add_argument("--jobs", type=int, default=1, help="copies that are tested at the same time")
    parser.add_argument("--golden", action="store_true", help="golden texts look too")
    parser.add_argument("--check", action="store_true", help="only see that every edit finds its text")
    options = parser.parse_args(arguments)
    chosen = [f for f in FAULTS if not options.names or any(part in f.name for part in options.names)]
    if options.check:
        lost = [fault for fault in chosen if not placed(fault)]
        for fault in lost:
            print(f"misplaced: {fault.name}: {fault.file}")
        print(f"{len(chosen)} faults, {len(lost) or 'none'} misplaced")
        return 1 if lost else 0
    survivors = []
    for fault, noticed, misplaced in run(chosen, options.jobs, options.golden):
        by = ", ".join(sorted({test.split("::")[-1].split("[")[0] for test in noticed}))
        print(f"{misplaced or by or 'SURVIVED'} <- {fault.name}", flush=True)
        survivors += [] if noticed else [fault.name]
    print(f"{len(chosen)} planted, {len(chosen) - len(survivors)} noticed")
    print("survivors: " + "; ".join(survivors) if survivors else "no survivor")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
