"""mechanism: loops of vectors, each position by scipy's fsolve from the one before; rates by fsolve on the same loops.

Its documentation (README, "Four Bar Linkage Example"; examples/engine.py): a vector for every side of a loop, `loops`
that returns the sums, guesses for the first position, `iterate`. fsolve runs at its default tolerance, 1.5e-8: the
package offers no other. Points on a rod are vectors along it.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from benchmarks.peers.peer import Array, Call, Found, Peer, Refused
from benchmarks.peers.scene import Rod, Scene, Slider, starts


def prepare(scene: Scene, phi: Array) -> Call:
    import matplotlib

    matplotlib.use("Agg")

    def run() -> Found:
        mechanism, joints = _mechanism(scene, phi)  # iterate leaves its state behind: a run needs a new one
        with warnings.catch_warnings(record=True) as doubts:
            warnings.simplefilter("always")
            mechanism.iterate()
        if doubts:  # fsolve says in a warning that it has not converged
            raise Refused(str(doubts[0].message))
        found: Found = {}
        for point in scene.points:
            joint = joints[point]
            found[point] = joint.x_positions + 1j * joint.y_positions
            found[f"v_{point}"] = joint.x_velocities + 1j * joint.y_velocities
            found[f"a_{point}"] = joint.x_accelerations + 1j * joint.y_accelerations
        return found

    return run


def _mechanism(scene: Scene, phi: Array) -> tuple[Any, dict[str, Any]]:
    """Unknowns: of every rod its angle, and the slider's place or the rocker's angle."""
    from mechanism import Joint, Mechanism, Vector

    joints = {name: Joint(name) for name in ("O", *scene.points)}
    crank = Vector((joints["O"], joints["A"]), r=scene.crank)
    vectors, sides = [crank], []
    for rod in scene.rods:
        whole, parts, out = _vectors(rod, joints, Vector)
        vectors += [whole, *parts.values(), *out]
        sides.append((rod, whole, parts, out))

    def loops(x: Array, i: float) -> Array:
        tip, sums = {"A": crank(i)}, np.zeros((len(sides), 2))
        for k, (rod, whole, parts, out) in enumerate(sides):
            turn, far = x[2 * k], x[2 * k + 1]
            tip[rod.end] = tip[rod.start] + whole(turn)
            for point, part in parts.items():
                tip[point] = tip[rod.start] + part(turn)
            sums[k] = tip[rod.end] - (out[0]() + out[1](far))
        return sums.flatten()

    ones = np.ones_like(phi)
    mechanism = Mechanism(
        vectors, joints["O"], loops, phi, scene.omega * ones, 0 * ones, _guesses(scene, float(phi[0]))
    )
    return mechanism, joints


def _vectors(rod: Rod, joints: dict[str, Any], vector: Any) -> tuple[Any, dict[str, Any], list[Any]]:
    """The rod, its points, and the other way round to its end: a fixed vector and the one that changes."""
    whole = vector((joints[rod.start], joints[rod.end]), r=rod.length)
    parts = {p: vector((joints[rod.start], joints[p]), r=rod.at(p)) for p in rod.points}
    foot = joints.setdefault(f"foot of {rod.end}", type(joints["O"])(f"foot of {rod.end}"))
    if isinstance(rod.out, Slider):
        up = np.pi / 2 if rod.out.offset >= 0 else -np.pi / 2
        fixed = vector((joints["O"], foot), r=abs(rod.out.offset), theta=up)
        return whole, parts, [fixed, vector((foot, joints[rod.end]), theta=0)]
    fixed = vector((joints["O"], foot), r=abs(rod.out.pivot), theta=float(np.angle(rod.out.pivot)))
    return whole, parts, [fixed, vector((foot, joints[rod.end]), r=rod.out.length)]


def _guesses(scene: Scene, phi: float) -> list[Array]:
    """Guesses of the first position: places to three digits, rates of the right size."""
    at = starts(scene, phi)
    x: list[float] = []
    for rod in scene.rods:
        x.append(float(np.angle(at[rod.end] - at[rod.start])))
        far = at[rod.end].real if isinstance(rod.out, Slider) else np.angle(at[rod.end] - rod.out.pivot)
        x.append(float(far))
    rates = np.ones(len(x)) * scene.omega
    return [np.array(x) * 1.001, rates, rates * scene.omega]


PEER = Peer("mechanism", "mechanism", prepare, missing="forces")
