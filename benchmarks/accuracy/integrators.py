"""Ways to integrate the equation of motion of a machine: time and error of each, on machines of four kinds.

    python -m benchmarks.accuracy.integrators [-o docs/charts/integrators.svg] [--store]

All ways are those of `tmm_report.mechanics.rivals.run_up`. The start of a pump driven through its cycle by an
induction motor; that of a shaft whose load comes by time, carried by a stiff motor; the same so light that its time
constant is a thousandth of the run; a hoist's shaft. Errors are of angle and speed at the end, the larger one, against
DOP853 at 1e-13 from kink to kink; times are by that of the program. Printed, never asserted.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterator
from pathlib import Path

from benchmarks.measuring import stored
from benchmarks.measuring.lines import Line, Panel, draw
from benchmarks.measuring.timing import interleaved
from tmm_report import course, loading
from tmm_report.mechanics.machine.run.law import run
from tmm_report.mechanics.machine.run.motion_law import Goal
from tmm_report.mechanics.rivals.run_up import RUN_UPS, STEPS, RunUpMethod, StartUp, errors, reference

VARIANTS = Path(__file__).parents[2] / "variants"
TURNS = 5  # of the pump
ROUNDS = 5
FIXED = ("runge_kutta", "adams")

SHAFT = """
dynamics:
  parts: [{{name: rotor, inertia: {inertia} kg*m^2}}]
  motor: {{shunt: {{moment: 60 N*m, speed: 1470 rpm, no_load: 1500 rpm}}}}
  resistance: [{{by_time: [[0 s, 0 N*m], [1 s, 0 N*m], [1.02 s, 50 N*m], [1.5 s, 50 N*m], [1.52 s, 0 N*m]]}}]
  start: {{time: 1.03 s}}
"""


def machines() -> Iterator[tuple[str, StartUp]]:
    pump = course.solve(loading.load(VARIANTS / "piston_pump.yaml")).dynamics
    assert pump is not None
    found = run(pump.supplied, 0.0, Goal(angle=TURNS * 2 * math.pi))
    yield f"pump, {TURNS} turns", StartUp(pump.supplied, 0.0, float(found.t[-1]))
    for name, inertia in (("shaft, load by time", "0.05"), ("the same, light: stiff", "0.002")):
        shaft = course.solve(loading.loads(SHAFT.format(inertia=inertia))).dynamics
        assert shaft is not None
        yield name, StartUp(shaft.supplied, 0.0, 1.03)
    hoist = course.solve(loading.load(VARIANTS / "hoist_start.yaml")).dynamics
    assert hoist is not None
    yield "hoist", StartUp(hoist.supplied, 0.0, 0.5)


def ways(scene: StartUp) -> Iterator[tuple[str, RunUpMethod, int]]:
    for method in RUN_UPS:
        if method.refuses(scene) is None:
            counts = STEPS if method.key in FIXED else (0,)
            yield from ((f"{method.key} {count}" if count else method.key, method, count) for count in counts)


def measured(scene: StartUp) -> dict[str, tuple[float, float]]:
    """Of each way that arrives: its time by that of the program, and its error."""
    exact, found = reference(scene), {}
    for name, method, count in ways(scene):
        try:
            found[name] = method, count, max(errors(exact, method.run(scene, count)).values())
        except ArithmeticError as error:
            print(f"    {name}: {error}")
    rivals = {name: lambda m=m, n=n: m.run(scene, n) for name, (m, n, _) in found.items()}
    taken = interleaved(rivals, ROUNDS)
    return {name: (taken[name] / taken["program"], error) for name, (_, _, error) in found.items()}


def panel(name: str, rows: dict[str, tuple[float, float]]) -> Panel:
    families: dict[str, list[tuple[float, float]]] = {}
    for key, point in rows.items():
        families.setdefault(key.replace(" ", "_1e").split("_1e")[0], []).append(point)
    lines = [Line(family.replace("_", " "), points) for family, points in families.items()]
    limits = (None, (1e-16, 1e2))
    return Panel(name, "time : the program's", "error of angle and speed", lines, limits=limits)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("-o", dest="chart", type=Path, help="draw the chart, SVG")
    stored.add_option(parser)
    asked, figures, panels = parser.parse_args(), {}, []
    for name, scene in machines():
        print(name)
        rows = measured(scene)
        panels.append(panel(name, rows))
        for way, (time, error) in rows.items():
            figures |= {f"{name}: {way}: time": time, f"{name}: {way}: error": error}
    stored.report("integrators", figures, asked.store)
    if asked.chart:
        draw(panels, asked.chart)


if __name__ == "__main__":
    main()
