"""Plant wrong outputs one at a time and see that a test notices: `python tools/planted_faults.py [part of a name ...]`.

Every fault of tools/faults.py is an edit in a copy of the program; the tests of the page and those that the fault names
run there on one or two variants. The test that noticed a fault last (tools/noticed.txt, which every run keeps up) is
asked alone, and all others where it passes. A fault that makes no test fail that did not fail before survives: its name
is printed and the exit code is 1; so it is where an edit does not find its text. Golden texts are left out, for they
only say that something changed (`--golden` lets them look too), but of the faults of words, which they alone hold.
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
from contextlib import contextmanager
from itertools import count
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
from plants import cams as faults_cams  # noqa: E402
from plants import docsite as faults_docsite  # noqa: E402
from plants import gears as faults_gears  # noqa: E402
from plants import interactive as faults_interactive  # noqa: E402
from plants import lint as faults_lint  # noqa: E402
from plants import living as faults_living  # noqa: E402
from plants import note as faults_depth  # noqa: E402
from plants import paper as faults_paper  # noqa: E402
from plants import stages as faults_stages  # noqa: E402
from plants import text as faults_text  # noqa: E402
from plants import typst as faults_typst  # noqa: E402
from plants import word as faults_word  # noqa: E402

FAULTS = (
    *faults.FAULTS,
    *faults_motion.FAULTS,
    *faults_balance.FAULTS,
    *faults_cams.FAULTS,
    *faults_docsite.FAULTS,
    *faults_note.FAULTS,
    *faults_depth.FAULTS,
    *faults_paper.FAULTS,
    *faults_interactive.FAULTS,
    *faults_lint.FAULTS,
    *faults_living.FAULTS,
    *faults_gears.FAULTS,
    *faults_stages.FAULTS,
    *faults_text.FAULTS,
    *faults_typst.FAULTS,
    *faults_word.FAULTS,
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
    "CONTRIBUTING.md",
    "CHANGELOG.md",
    "docs",
)
TEXTS = "test_golden_text.py"
GEARS_BESIDE, LEVERS_BESIDE = "tables/test_other_gears.py", "tables/test_other_levers.py"
WINGS = {"gears": "gears", "machine": "machine", "masses": "machine", "pairs": "machine/pairs"}
PAPER = "drawings/test_measured_on_paper.py"
GEARS = ("hoist_drive", "eccentric")  # variants whose faults gears of no variant may notice: they cost time
FAILED = re.compile(r"^(?:FAILED|ERROR) (\S+?(?:\[.*?\])?)(?: - .*)?$", re.M)
LOST = re.compile(r"^ERROR: not found: (.+)$", re.M)
SURVIVED, ARROW = "SURVIVED", " <- "
NOTICED = ROOT / "tools" / "noticed.txt"
HEAD = "# Tests, each with the faults that it noticed last: tools/planted_faults.py asks it first, and writes this.\n"


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


def failing(folder: Path, fault: Fault, asked: list[str], first: bool = False) -> frozenset[str]:
    """The tests that fail in a copy, those that cannot even be collected among them, or the `first` of them."""
    # the exhaustive ones too: the variants are chosen here; who noticed the last fault is asked first
    command = [sys.executable, "-m", "pytest", "-q", "-m", "", "--tb=no", "-rfE", "--assert=plain"]
    command += ["--hypothesis-seed=0", *(["-x", "--failed-first"] if first else ["-p", "no:cacheprovider"])]
    env = os.environ | {"PYTHONPATH": str(folder), "PAGE_VARIANTS": fault.variants, "COLUMNS": "80"}
    env.pop("PYTHONDONTWRITEBYTECODE", "")  # all but the text with the fault is compiled once
    done = subprocess.run(command + asked, cwd=folder, env=env, capture_output=True, text=True)
    found = frozenset(FAILED.findall(done.stdout))
    if done.returncode in (0, 1, 2, 5) or found:
        return found
    lost = set(LOST.findall(done.stdout + done.stderr))
    if lost:  # tests that have another name since, or that a fault takes the name of
        left = [test for test in asked if not any(one.endswith(f"/{test}") for one in lost)]
        if len(left) < len(asked):
            return frozenset(asked) - set(left) | (failing(folder, fault, left, first) if left else set())
    return frozenset(asked[:1])  # nothing can be run


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
    if at[1] == "chapters":  # of a wing, or, as `find`, of none
        chapter = Path(at[3] if len(at) > 3 else at[2]).stem
        asked = f"tests/chapters/**/test_{chapter}_twice.py"
    elif at[1] == "mechanics" and at[2] in WINGS:
        asked = f"tests/chapters/{WINGS[at[2]]}/**/test_*_twice.py"
    else:
        return []
    return sorted(str(one.relative_to(ROOT)) for one in ROOT.glob(asked))


@contextmanager
def planted(folder: Path, fault: Fault) -> Iterator[None]:
    """The edit is made, and taken back. Raises Misplaced."""
    path = folder / fault.file
    data, old = (path.read_bytes() if path.exists() else b""), fault.old.encode()
    if data.count(old) != 1:
        raise Misplaced(f"its text stands {data.count(old)} times in {fault.file}")
    try:
        _written(path, data.replace(old, fault.new.encode()))
        yield
    finally:
        _written(path, data)


WRITINGS = count(1)


def _written(path: Path, data: bytes) -> None:
    """Each writing at another second, or Python takes what it compiled of a text as long."""
    path.write_bytes(data)
    os.utime(path, (second := next(WRITINGS), second))


def placed(fault: Fault) -> bool:
    """Whether an edit finds its text in the program as it is."""
    path = ROOT / fault.file
    return path.exists() and path.read_bytes().count(fault.old.encode()) == 1


def remembered(text: str) -> dict[str, str]:
    """Of every fault the test that noticed it last."""
    found, test = {}, ""
    for line in text.splitlines():
        if line.startswith("  "):
            found[line.strip()] = test
        elif not line.startswith("#"):
            test = line
    return found


def written(noticed: dict[str, str]) -> str:
    tests = sorted({*noticed.values()})
    return HEAD + "".join(
        f"{test}\n" + "".join(f"  {name}\n" for name in sorted(noticed) if noticed[name] == test)
        for test in tests
    )


class Planter:
    """Copies of the program, one for each worker, and who noticed what in earlier runs."""

    def __init__(self, folders: list[Path], golden: bool, noticed: dict[str, str]):
        self.golden, self.noticed = golden, noticed
        self.passes: set[tuple[str, str]] = set()  # tests that pass without a fault, each with its variants
        self.free: SimpleQueue[Path] = SimpleQueue()
        for folder in folders:
            self.free.put(folder)

    def ready(self, faults: list[Fault]) -> None:
        """Which of the tests that noticed these faults pass on their variants without one: one run of all of them."""
        folder, variants = self.free.get(), faults[0].variants
        asked = sorted({self.noticed[fault.name] for fault in faults if fault.name in self.noticed})
        failed = failing(folder, faults[0], asked) if asked else frozenset()
        self.passes |= {(test, variants) for test in asked if test not in failed}
        self.free.put(folder)

    def told(self, fault: Fault) -> tuple[Fault, list[str], str]:
        """A fault, the tests that notice it, and what is wrong with the edit."""
        folder = self.free.get()
        try:
            if likely := self.likely(fault):
                with planted(folder, fault):
                    if found := failing(folder, fault, likely, first=True):
                        return fault, sorted(found), ""
            return fault, sorted(self.found(fault, folder)), ""
        except Misplaced as misplaced:
            return fault, [], str(misplaced)
        finally:
            self.free.put(folder)

    def likely(self, fault: Fault) -> list[str]:
        """The test that noticed a fault last; of a new one, those that noticed others of its file."""
        beside = (one.name for one in FAULTS if one.file == fault.file and one.name in self.noticed)
        names = [fault.name] if fault.name in self.noticed else beside
        tests = dict.fromkeys(self.noticed[name] for name in names)
        return [test for test in tests if (test, fault.variants) in self.passes][-6:]

    def found(self, fault: Fault, folder: Path) -> frozenset[str]:
        """The first test that notices a fault, of all that look at it.

        It is asked once without a fault: it notices only what it does not say anyway. All tests are asked both ways
        where it fails there too.
        """
        for asked in _asked(fault, self.golden):
            with planted(folder, fault):
                first = failing(folder, fault, asked, first=True)
            tests = {(test, fault.variants) for test in first}
            if not tests <= self.passes and failing(folder, fault, sorted(first)):
                with planted(folder, fault):
                    first = failing(folder, fault, asked)
                first -= failing(folder, fault, asked)
            else:
                self.passes |= tests
            if first:
                return first
        return frozenset()


def run(
    faults: list[Fault], jobs: int, golden: bool, noticed: dict[str, str]
) -> Iterator[tuple[Fault, list[str], str]]:
    with tempfile.TemporaryDirectory() as temporary, ThreadPoolExecutor(jobs) as pool:
        planter = Planter([copy(Path(temporary) / f"copy{k}") for k in range(jobs)], golden, noticed)
        every = {fault.variants for fault in faults}
        list(pool.map(planter.ready, ([one for one in faults if one.variants == v] for v in sorted(every))))
        yield from pool.map(planter.told, faults)


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", help="parts of names: only these faults")
    parser.add_argument("--jobs", type=int, default=1, help="copies that are tested at the same time")
    parser.add_argument("--golden", action="store_true", help="golden texts look too")
    parser.add_argument("--check", action="store_true", help="only see that every edit finds its text")
    parser.add_argument("--resume", type=Path, help="a file of outcomes: what it says noticed is passed over")
    options = parser.parse_args(arguments)
    chosen = [f for f in FAULTS if not options.names or any(part in f.name for part in options.names)]
    if options.check:
        lost = [fault for fault in chosen if not placed(fault)]
        for fault in lost:
            print(f"misplaced: {fault.name}: {fault.file}")
        print(f"{len(chosen)} faults, {len(lost) or 'none'} misplaced")
        return 1 if lost else 0
    noticed = remembered(NOTICED.read_text("utf-8")) if NOTICED.exists() else {}
    noticed = {fault.name: noticed[fault.name] for fault in FAULTS if fault.name in noticed}
    before = options.resume.read_text("utf-8") if options.resume and options.resume.exists() else ""
    done = {line.partition(ARROW)[2] for line in before.splitlines() if not line.startswith(SURVIVED)}
    survivors = []
    left = [fault for fault in chosen if fault.name not in done]
    for fault, tests, misplaced in run(left, options.jobs, options.golden, noticed):
        by = ", ".join(sorted({test.split("::")[-1].split("[")[0] for test in tests}))
        line = f"{by or ' '.join([SURVIVED, misplaced]).strip()}{ARROW}{fault.name}"
        print(line, flush=True)
        if options.resume:
            with options.resume.open("a", encoding="utf-8") as file:
                file.write(f"{line}\n")
        survivors += [] if tests else [fault.name]
        if tests and noticed.get(fault.name) not in tests:
            noticed[fault.name] = tests[0]
            NOTICED.write_text(written(noticed), "utf-8")
    print(f"{len(chosen)} planted, {len(chosen) - len(survivors)} noticed")
    print("survivors: " + "; ".join(survivors) if survivors else "no survivor")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
