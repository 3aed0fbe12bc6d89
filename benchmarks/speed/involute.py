"""Inverse involute: every method's error from 0 to 90°, its time, and ours against numpy's tangent of as many numbers.

    python -m benchmarks.speed.involute [-o docs/charts/involute.svg] [--store]

The methods are those of `tmm_report.mechanics.rivals.involutes`; the reference is mpmath's root in 40 digits. Printed,
never asserted. Times are of angles spread evenly over 1e-6 rad … 89.99°, so most need the iteration.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from benchmarks.measuring import stored
from benchmarks.measuring.lines import Line, Panel, draw
from benchmarks.measuring.timing import interleaved
from tmm_report.mechanics.gears.involute import inv, inverse
from tmm_report.mechanics.rivals.involutes import INVOLUTES

SIZES = (1, 100, 10_000, 1_000_000)
TARGET = 300.0  # ns
DECADES = np.logspace(-12, np.log10(np.pi / 4), 61)  # rad from 0 or from π/2
MANY = 10_000
DIGITS = 60  # α³/3 of the smallest angle must not be lost


def times() -> dict[str, float]:
    figures = {}
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
        ratio = ns["inverse"] / ns["tan"]
        print(f"{size:8} {ns['inverse']:14.1f} {ns['inv']:10.1f} {ns['tan']:10.1f} {ratio:16.1f}")
        figures[f"{size} elements: inverse : tan"] = ratio
    print(f"target: under {TARGET:g} ns an element in an array")
    v = inv(np.linspace(1e-6, np.radians(89.99), MANY))
    taken = interleaved({one.key: lambda m=one: m.run(v, 0) for one in INVOLUTES}, 5)
    own = taken[INVOLUTES[0].key]
    return figures | {f"{MANY} elements: {key} : ours": one / own for key, one in taken.items()}


def reference(from_right: bool) -> tuple[np.ndarray, list]:
    """inv α as doubles, and the angles whose involutes these doubles are, or what they lack of π/2."""
    import mpmath

    with mpmath.workdps(DIGITS):
        alpha = [mpmath.pi / 2 - mpmath.mpf(x) if from_right else mpmath.mpf(x) for x in DECADES.tolist()]
        v = [float(mpmath.tan(a) - a) for a in alpha]
        exact = [_angle(a, w) for a, w in zip(alpha, v, strict=True)]
    return np.array(v), exact


def _angle(alpha, v: float):
    """By Newton's method: the double v is within 1e-16 of inv α."""
    import mpmath

    for _ in range(4):
        t = mpmath.tan(alpha)
        alpha -= (t - alpha - mpmath.mpf(v)) / t**2
    return alpha


def errors() -> dict[str, tuple[list[float], list[float]]]:
    """Of each method relative errors at the distances from 0 and from 90°; nan where it says that it found nothing."""
    import mpmath

    found: dict[str, tuple[list[float], list[float]]] = {one.key: ([], []) for one in INVOLUTES}
    for side, from_right in enumerate((False, True)):
        v, exact = reference(from_right)
        for one in INVOLUTES:
            with mpmath.workdps(DIGITS), np.errstate(all="ignore"):
                pairs = zip(one.run(v, 0).tolist(), exact, strict=True)
                found[one.key][side].extend(
                    float(abs(mpmath.mpf(own) - true) / true) if np.isfinite(own) else float("nan")
                    for own, true in pairs
                )
    return found


def summary(found: dict[str, tuple[list[float], list[float]]]) -> dict[str, float]:
    figures = {}
    for key, sides in found.items():
        for name, row in zip(("from 0 to 45°", "from 45° to 90°"), sides, strict=True):
            figures[f"{key}: worst error {name}"] = float(np.nanmax([0.0, *row]))
            figures[f"{key}: found nothing {name}"] = float(np.isnan(row).mean())
    return figures


def chart(found: dict[str, tuple[list[float], list[float]]], path: Path) -> None:
    panels = []
    for side, across in enumerate(("α, rad", "90° − α, rad")):
        lines = [
            Line(one.title, list(zip(DECADES.tolist(), found[one.key][side], strict=True)), marks=False)
            for one in INVOLUTES
        ]
        panels.append(Panel("", across, "relative error of α", lines, limits=(None, (1e-17, 10.0))))
    draw(panels, path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", dest="chart", type=Path, help="draw the chart, SVG")
    stored.add_option(parser)
    asked, found = parser.parse_args(), errors()
    stored.report("involute", times() | summary(found), asked.store)
    if asked.chart:
        chart(found, asked.chart)


if __name__ == "__main__":
    main()
