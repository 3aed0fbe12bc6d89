"""kinepy: isostatic groups in closed form; velocities and inertia by central differences over the samples.

Its documentation (docs/System.md): `solve_dynamics(inputs, t)`, t the time that the samples take: the step is t over
their number. Differences leave the first and the last sample without a value, so one more is solved on either side.
Lengths are mm unless a unit system is set (docs/units.md). The torque of a driven pivot is the one on its first solid,
the frame: the crank's is the opposite.
"""

from __future__ import annotations

import contextlib
import io
import os
from typing import Any

import numpy as np

from benchmarks.peers.peer import Array, Call, Found, Peer, Refused
from benchmarks.peers.scene import Rocker, Scene, Slider, starts


def prepare(scene: Scene, phi: Array, samples: int = 1) -> Call:
    """`samples` a step between two of the positions asked for."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    with contextlib.redirect_stdout(io.StringIO()):
        from kinepy.math.calculus import derivative2_vec, derivative_vec

        step = (phi[1] - phi[0]) / samples if len(phi) > 1 else 1e-3
        inputs = phi[0] + step * np.arange(-1, (len(phi) - 1) * samples + 2)
        system, carriers = _system(scene, phi, inputs)
    dt = abs(step / scene.omega)
    asked = slice(1, -1, samples)

    def run() -> Found:
        system.solve_dynamics(inputs.copy(), dt * inputs.size)
        found: Found = {"moment": -system.named_joints["crank"].torque[asked]}
        for point, (solid, at) in carriers.items():
            place = solid.get_point(at)
            found[point] = _complex(place)[asked]
            found[f"v_{point}"] = _complex(derivative_vec(place, dt))[asked]
            found[f"a_{point}"] = _complex(derivative2_vec(place, dt))[asked]
        return found

    return run


def _complex(rows: Array) -> Array:
    return rows[0] + 1j * rows[1]


def _system(scene: Scene, phi: Array, inputs: Array) -> tuple[Any, dict[str, Any]]:
    """The system with the assembly of the first angle; point -> the solid that has it, and where."""
    import kinepy
    from kinepy import units

    units.set_unit_system(units.SI)
    system = kinepy.System()
    system.add_gravity((0.0, scene.gravity))
    solids = {"A": system.add_solid("crank")}
    carriers: dict[str, Any] = {"A": (solids["A"], (scene.crank, 0.0))}
    system.named_joints["crank"] = system.add_revolute(0, solids["A"])
    for rod in scene.rods:
        parent, at = carriers[rod.start]
        solid = system.add_solid(f"to {rod.end}", rod.mass, rod.inertia, (rod.at(rod.centre), 0.0))
        system.add_revolute(parent, solid, at, (0.0, 0.0))
        for point in (rod.end, *rod.points):
            carriers[point] = (solid, (rod.at(point), 0.0))
        _out(system, solid, rod.length, rod.end, rod.out)
    for point, force in scene.forces.items():
        samples = np.interp(
            inputs, phi[:: int(np.sign(phi[1] - phi[0]))], force[:: int(np.sign(phi[1] - phi[0]))]
        )
        system.named_sols[f"at {point}"].add_force(np.array([samples, 0 * samples]), (0.0, 0.0))
    system.pilot(system.named_joints["crank"])
    system.compile()
    _assemble(system, scene, float(phi[0]), carriers)
    return system, carriers


def _out(system: Any, solid: Any, length: float, end: str, out: Slider | Rocker) -> None:
    if isinstance(out, Slider):
        slider = system.add_solid(f"at {end}", out.mass)
        system.add_revolute(solid, slider, (length, 0.0), (0.0, 0.0))
        system.add_prismatic(0, slider, 0.0, out.offset, 0.0, 0.0)
    else:
        rocker = system.add_solid(f"at {end}", 0.0, out.inertia)
        system.add_revolute(solid, rocker, (length, 0.0), (out.length, 0.0))
        system.add_revolute(0, rocker, (out.pivot.real, out.pivot.imag), (0.0, 0.0))


def _assemble(system: Any, scene: Scene, phi: float, carriers: dict[str, Any]) -> None:
    """Turn every sign that puts its rod on the wrong side at the first angle (`change_signs` of the documentation)."""
    at, keys = starts(scene, phi), list(system._object.signs)
    for key in keys * 2:
        if _off(system, at, phi, carriers) < 1e-6 * scene.crank:
            return
        before = _off(system, at, phi, carriers)
        system.change_signs({key: -system._object.signs[key]})
        if _off(system, at, phi, carriers) > before:
            system.change_signs({key: -system._object.signs[key]})
    raise Refused("no signs put the points where they start")


def _off(system: Any, at: dict[str, complex], phi: float, carriers: dict[str, Any]) -> float:
    system.solve_kinematics(np.array([phi]))
    places = {point: _complex(solid.get_point(where))[0] for point, (solid, where) in carriers.items()}
    return sum(abs(place - at[point]) for point, place in places.items())


PEER = Peer(
    "kinepy",
    "kinepy",
    prepare,
    {f"{36 * n} samples a turn": {"samples": n} for n in (1, 10, 100)},
    "velocities and accelerations by differences only",
)
