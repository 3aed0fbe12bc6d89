"""Groups of class III and IV: following a group over the turn, then 36 and 3600 positions; a mechanism of dyads beside.

    python benchmarks/higher.py

Printed, never asserted. "first" follows the group from the sketch all round and solves 36 positions; "again" solves
further positions from the nodes kept.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from timing import interleaved

from tmm_report.course import load
from tmm_report.mechanics import motion
from tmm_report.mechanics.assembly import assemble

VARIANTS = Path(__file__).parents[1] / "variants"
NAMES = ("compressor", "quick_return", "press")  # dyads alone, class III, class IV


def main() -> None:
    few, many = (np.arange(n) * (2 * np.pi / n) for n in (36, 3600))
    print("variant         first, ms    36 again, ms    3600 again, ms")
    for name in NAMES:
        mechanism = load(VARIANTS / f"{name}.yaml").lever.mechanism
        linkage = assemble(mechanism)
        motion.solve(linkage, few)
        taken = interleaved(
            {
                "first": lambda m=mechanism: motion.solve(assemble(m), few),
                "few": lambda x=linkage: motion.solve(x, few),
                "many": lambda x=linkage: motion.solve(x, many),
            },
            10,
        )
        ms = {key: 1e3 * seconds for key, seconds in taken.items()}
        print(f"{name:14} {ms['first']:10.1f}    {ms['few']:12.2f}    {ms['many']:14.1f}")


if __name__ == "__main__":
    main()
