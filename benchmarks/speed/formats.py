"""CPU time and size of every format of a note, each against the page in HTML of the same variant in the same run.

    python -m benchmarks.speed.formats [NAME ...] [--rounds N] [--store]

The results are solved before; the formats take turns (html docx tex … html docx tex …), medians of CPU seconds, those
of TeX's own process with it. "pdf, typst" is the note set by Typst's wheel, "pdf, tex" by pdflatex; what is not
installed is left out.
"""

from __future__ import annotations

import argparse
import resource
from collections.abc import Callable
from pathlib import Path
from statistics import median

from benchmarks.measuring import stored
from tmm_report import load, render, solve
from tmm_report.commands.by_typst import NoTypst, typeset
from tmm_report.commands.files import for_typst
from tmm_report.commands.pdf import NoTex, compiled

ROOT = Path(__file__).parents[2]
NAMES = ("shaper", "compressor")
MADE = ("html", "tex", "docx", "json", "sheets")  # by this program alone


def cpu() -> float:
    """CPU seconds of this process and of those that it has waited for."""
    used = [resource.getrusage(of) for of in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)


def ways(name: str) -> dict[str, Callable[[], int]]:
    """By format what makes it; each returns the size of what it has made, bytes."""
    results = solve(load(ROOT / "variants" / f"{name}.yaml"))

    def made(fmt: str) -> Callable[[], int]:
        return lambda: sum(map(len, render(results, fmt).values()))

    found = {fmt: made(fmt) for fmt in MADE}
    found["pdf, typst"] = lambda: len(typeset(for_typst(results)))
    found["pdf, tex"] = lambda: len(compiled(render(results, "tex"))["note.pdf"])
    return found


def measured(name: str, rounds: int) -> dict[str, tuple[float, int]]:
    """CPU seconds and bytes by format."""
    every = ways(name)
    times: dict[str, list[float]] = {}
    sizes: dict[str, int] = {}
    for turn in range(rounds + 1):
        for fmt, make in every.items():
            began = cpu()
            try:
                sizes[fmt] = make()
            except (NoTypst, NoTex):
                continue
            if turn:
                times.setdefault(fmt, []).append(cpu() - began)
    return {fmt: (median(taken), sizes[fmt]) for fmt, taken in times.items()}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("names", nargs="*", default=NAMES, help="ready variants")
    parser.add_argument("--rounds", type=int, default=5, help="turns taken")
    stored.add_option(parser)
    options = parser.parse_args()
    ratios: dict[str, float] = {}
    for name in options.names:
        found = measured(name, options.rounds)
        page, _ = found["html"]
        print(f"\n| {name} | CPU s | : HTML | MB |\n|---|---|---|---|")
        for fmt, (seconds, size) in found.items():
            print(f"| {fmt} | {seconds:.2f} | {seconds / page:.2f} | {size / 1e6:.2f} |")
            ratios[f"{name}, {fmt} : html"] = seconds / page
    stored.report("formats", ratios, options.store)


if __name__ == "__main__":
    main()
