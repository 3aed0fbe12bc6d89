"""How many positions a course needs: what is taken from tables of 12 … 400 positions, against the exact.

    python -m benchmarks.accuracy.positions [-o docs/charts] [--store]     positions.svg, integrals.svg

Every lever mechanism of `variants/` by `chapters/lever/methods/counting`; and the rules for integrals of a smooth
function
and of one with kinks, the reduced moment of inertia and the reduced moment of the loads of the compressor.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from benchmarks.measuring import stored
from benchmarks.measuring.lines import Line, Panel, draw
from tmm_report import course, load
from tmm_report.chapters.lever.kinetostatics.solve.positions import breaks, loading
from tmm_report.chapters.lever.methods.counting import MEANINGS, counting, wanted
from tmm_report.chapters.lever.moving import Moving, inertia_parts, powers
from tmm_report.mechanics.rivals.counts import COUNTS, USUAL, counted
from tmm_report.mechanics.rivals.integrals import INTEGRALS, Sampled, exact

VARIANTS = Path(__file__).parents[2] / "variants"
SHOWN = ("compressor", "crank_rocker", "shaper")
MORE = (*COUNTS, 200, 400)
RULES = {"smooth: reduced moment of inertia": 0, "with kinks: reduced moment of the loads": 1}


def movings() -> Iterator[tuple[str, Moving]]:
    for path in sorted(VARIANTS.glob("*.yaml")):
        lever = course.solve(load(path)).lever
        if lever is not None and not lever.kinematics.gaps:
            yield path.stem, Moving(lever.kinematics, lever.kinetostatics, lever.friction)


def table(name: str, moving: Moving) -> dict[str, float]:
    """Printed: the errors, in percent; the least count that is enough for what a course is content with."""
    found = counting(moving)
    assert found is not None
    print(f"\n{name}: {found.recommended or f'more than {COUNTS[-1]}'} positions for {USUAL:.0%}")
    for key, row in found.errors.items():
        print(f"    {MEANINGS[key]:<60}" + "".join(f"{100 * error:10.3f}" for error in row))
    worst = {n: max(row[k] for row in found.errors.values()) for k, n in enumerate(COUNTS)}
    enough = {f"{name}: enough": float(found.recommended)} if found.recommended else {}
    return enough | {f"{name}: worst error at {n}": worst[n] for n in (12, 36, 100)}


def positions(shown: dict[str, Moving], path: Path) -> None:
    panels = []
    for name, moving in shown.items():
        found = counted(tuple(wanted(moving)), counts=MORE)
        lines = [Line(MEANINGS[key], list(zip(MORE, row, strict=True))) for key, row in found.errors.items()]
        panels.append(
            Panel(
                name.replace("_", " "), "positions", "relative error", lines, USUAL, (None, (1e-9, 1.0)), MORE
            )
        )
    draw(panels, path, columns=3)


def functions(moving: Moving) -> tuple[Sampled, Sampled]:
    """The reduced moment of inertia, and the reduced moment of the loads, over the cycle."""
    kinematics, forces = moving.kinematics, moving.forces
    assert forces is not None
    cycle = kinematics.cycle

    def inertia(x: np.ndarray) -> np.ndarray:
        return sum(part for _, part in inertia_parts(cycle.motion(x)))

    def moment(x: np.ndarray) -> np.ndarray:
        motion = cycle.motion(x)
        load = loading(forces.given, kinematics, motion, x)
        return sum(part for _, part in powers(forces.given, motion, load)) / abs(motion.omega)

    return Sampled(inertia, cycle.period), Sampled(moment, cycle.period, breaks(forces.given, kinematics))


def integrals(moving: Moving, path: Path | None) -> dict[str, float]:
    counts, panels, figures = (6, 8, 12, 18, 24, 36, 48, 72, 100, 144, 200, 288, 360), [], {}
    for name, scene in zip(RULES, functions(moving), strict=True):
        whole, lines = float(exact(scene)), []
        for rule in INTEGRALS[1:]:
            row = [abs(float(rule.run(scene, n)) / whole - 1) for n in counts]
            lines.append(Line(rule.title, list(zip(counts, row, strict=True))))
            figures |= {f"{name}: {rule.key}: error at {n}": row[counts.index(n)] for n in (12, 36, 72)}
        panels.append(
            Panel(
                name,
                "positions",
                "relative error of the integral",
                lines,
                limits=(None, (1e-17, 1.0)),
                ticks=(6, 12, 24, 36, 72, 144, 360),
            )
        )
    if path:
        draw(panels, path)
    return figures


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", dest="folder", type=Path, help="draw the charts into this folder")
    stored.add_option(parser)
    asked, figures, all_of_them = parser.parse_args(), {}, dict(movings())
    for name, moving in all_of_them.items():
        figures |= table(name, moving)
    if asked.folder:
        positions({name: all_of_them[name] for name in SHOWN}, asked.folder / "positions.svg")
    figures |= integrals(all_of_them["compressor"], asked.folder and asked.folder / "integrals.svg")
    stored.report("positions", figures, asked.store)


if __name__ == "__main__":
    main()
