"""Inverse involute: time of an element, and against numpy's tangent of as many numbers.

    python benchmarks/involute.py

Printed, never asserted. The angles are spread evenly over 1e-6 rad … 89.99°, so most need the iteration.
"""

from __future__ import annotations

import numpy as np
from timing import interleaved

from tmm_report.mechanics.involute import inv, inverse

SIZES = (1, 100, 10_000, 1_000_000)
TARGET = 300.0  # ns


def main() -> None:
    print("elements    inverse, ns    inv, ns    tan, ns    inverse : tan")
    for size in SIZES:
        alpha = np.linspace(1e-6, np.radians(89.99), size)
        v = inv(alpha)
        rivals = {
            "inverse": lambda v=v: inverse(v),
            "inv": lambda a=alpha: inv(a),
            "tan": lambda a=alpha: np.tan(a),
        }
        taken = interleaved(rivals, 15 if size > 1000 else 300)
        ns = {name: 1e9 * seconds / size for name, seconds in taken.items()}
        print(
            f"{size:8} {ns['inverse']:14.1f} {ns['inv']:10.1f} {ns['tan']:10.1f} {ns['inverse'] / ns['tan']:16.1f}"
        )
    print(f"target: under {TARGET:g} ns an element in an array")


if __name__ == "__main__":
    main()
