"""Marks of a thousand students on two processes: `tmm-report grade` against a plain loop that only solves the variants.

    python -m benchmarks.speed.marks [N]

Every student has a variant of the compressor and hands in 29 columns at 12 positions, as CSV; every tenth has
made a mistake in one of them, every fiftieth has solved the variant of his neighbour. Printed, never asserted.
"""

from __future__ import annotations

import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter

import numpy as np

from benchmarks.speed.thousand import JOBS, variants
from tmm_report import load, solve
from tmm_report.grading.expected import expected
from tmm_report.intake.writing import csv_bytes

KEYS = (
    "S_B", "V_B", "A_B", "S_D", "V_D", "A_D", "v_A", "v_B", "v_C", "v_D", "v_BA", "v_DC", "w_2", "w_4", "a_B", "a_D",
    "a_BA_n", "a_BA_t", "e_2", "e_4", "G_2", "F_I2", "F_I4", "M_I2", "R_12", "R_24", "R_03", "R_05", "M_bal",
)  # fmt: skip
READ = 0.3 / 50  # of a column's largest number


def main(count: int) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        alone = _year(folder, count)
        command = [
            sys.executable,
            "-m",
            "tmm_report",
            "grade",
            "variants",
            "answers",
            "-o",
            "marks",
            "--jobs",
            str(JOBS),
        ]
        began = perf_counter()
        subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
        taken = perf_counter() - began
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        print(f"{count} works marked on {JOBS} processes: {taken:.1f} s; the largest process {peak:.0f} MB")
        print(
            f"a plain loop that loads and solves the variants, nothing else: {alone:.1f} s, {alone / taken:.2f} of it"
        )


def _year(folder: Path, count: int) -> float:
    """Write variants and answers; how long loading and solving the variants took."""
    (folder / "variants").mkdir()
    (folder / "answers").mkdir()
    rng, before, solving = np.random.default_rng(5), None, 0.0
    for k, text in enumerate(variants(count, drive=False)):
        file = folder / "variants" / f"st{k:05}.yaml"
        file.write_text(text, "utf-8")
        began = perf_counter()
        results = solve(load(file))
        solving += perf_counter() - began
        right = {one.key: one for one in expected(results).values() if one.table.endswith("_table")}
        columns = {key: _read(right[key].values[:12], rng) for key in KEYS}
        if k % 10 == 3:
            columns[KEYS[k // 10 % len(KEYS)]] *= (-1, 1000, 1.3, 0.5)[k // 10 % 4]
        own, before = columns, columns if before is None or k % 50 != 7 else before
        handed = before if k % 50 == 7 else own
        rows = [["position", *handed], *([n, *(column[n] for column in handed.values())] for n in range(12))]
        (folder / "answers" / f"st{k:05}.csv").write_bytes(csv_bytes(rows, ","))
        before = own
    return solving


def _read(right: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    read = right + rng.uniform(-READ, READ, len(right)) * np.abs(right).max()
    return np.array([float(f"{x:.4g}") for x in read])


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1000)
