"""pylinkage: dyads on coordinates, step by step; of two solutions the one nearer to the last place is taken.

Its documentation (README, "Which API should I use?"): components, actuators, dyads and `simulation.Linkage`. Rates:
`set_input_velocity`, then `step_with_derivatives`, or, compiled where numba is installed, `step_fast_with_kinematics`.
A crank turns by its own angle a step before a place is given, so it starts one step behind the first angle.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.peers.peer import Array, Call, Found, Peer, Refused
from benchmarks.peers.scene import Scene, Slider, starts


def prepare(scene: Scene, phi: Array, fast: bool = True) -> Call:
    linkage, crank, order = _linkage(scene, phi)
    linkage.set_input_velocity(crank, omega=scene.omega, alpha=0.0)
    start = linkage.get_coords()

    def run() -> Found:
        linkage.set_coords(start)
        if fast:
            places, velocities, accelerations = linkage.step_fast_with_kinematics(len(phi), 1.0)
        else:
            steps = list(linkage.step_with_derivatives(len(phi), 1.0))
            places, velocities, accelerations = (
                np.array(rows, dtype=float) for rows in zip(*steps, strict=True)
            )
        return _named(order, places, velocities, accelerations)

    return run


def places(scene: Scene, phi: Array) -> Call:
    """Places alone, by `Linkage.step`, which raises its own `UnbuildableError`."""
    from pylinkage.exceptions import UnbuildableError

    linkage, _, order = _linkage(scene, phi)
    start = linkage.get_coords()

    def run() -> Found:
        linkage.set_coords(start)
        try:
            steps = np.array(list(linkage.step(len(phi), 1.0)), dtype=float)
        except UnbuildableError as error:
            raise Refused(str(error)) from error
        return {name: steps[:, k, 0] + 1j * steps[:, k, 1] for name, k in order.items()}

    return run


def _named(order: dict[str, int], places: Array, velocities: Array, accelerations: Array) -> Found:
    found: Found = {}
    for name, k in order.items():
        for kind, rows in (("", places), ("v_", velocities), ("a_", accelerations)):
            found[kind + name] = rows[:, k, 0] + 1j * rows[:, k, 1]
    return found


def _linkage(scene: Scene, phi: Array) -> tuple[Any, Any, dict[str, int]]:
    """The linkage one step before the first angle, its crank, and which component a point is."""
    from pylinkage.actuators import Crank
    from pylinkage.components import Ground
    from pylinkage.dyads import FixedDyad, RRPDyad, RRRDyad
    from pylinkage.simulation import Linkage

    step = float(phi[1] - phi[0]) if len(phi) > 1 else 1e-3
    before = float(phi[0]) - step
    origin = Ground(0.0, 0.0, name="O")
    crank = Crank(origin, scene.crank, angular_velocity=step, initial_angle=before, name="A")
    at, parts = starts(scene, float(phi[0])), [origin, crank]
    outputs = {"A": crank.output}
    for rod in scene.rods:
        hint = (at[rod.end].real, at[rod.end].imag)
        if isinstance(rod.out, Slider):
            ends = [Ground(x, rod.out.offset, name=f"{rod.end}{k}") for k, x in enumerate((0.0, 1.0))]
            end = RRPDyad(outputs[rod.start], *ends, rod.length, *hint, name=rod.end)
        else:
            ends = [Ground(rod.out.pivot.real, rod.out.pivot.imag, name=f"pivot of {rod.end}")]
            end = RRRDyad(outputs[rod.start], *ends, rod.length, rod.out.length, *hint, name=rod.end)
        parts += [*ends, end]
        outputs[rod.end] = end
        for point in rod.points:
            middle = FixedDyad(outputs[rod.start], end, rod.at(point), 0.0, name=point)
            parts.append(middle)
            outputs[point] = middle
    linkage = Linkage(parts)
    linkage.set_coords([(part.x, part.y) for part in parts])
    order = {part.name: k for k, part in enumerate(parts)}
    return linkage, crank, {point: order[point] for point in scene.points}


PEER = Peer(
    "pylinkage",
    "pylinkage",
    prepare,
    {"step_fast_with_kinematics": {"fast": True}, "step_with_derivatives": {"fast": False}},
    "forces",
)
