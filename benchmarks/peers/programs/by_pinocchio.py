"""pinocchio: a tree of joints, loops closed by point constraints; Newton on them, rates from their Jacobian.

Its documentation (examples/constant-length-constraint-kinematics.py, simulation-closed-kinematic-chains.py): the crank
is driven, the other joints are solved for by Newton with `calc` and `jacobian` of the constraint, each position from
the one before; a velocity is admissible if the Jacobian takes it to zero. The moment: inverse dynamics of the tree
(`rnea`) less what the constraints' forces do, which the joints that nobody drives determine.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.peers.peer import Array, Call, Found, Peer, Refused
from benchmarks.peers.scene import Scene, Slider, starts

CLOSED = 1e-14  # of a loop, of the crank
ITERATIONS = 50


def prepare(scene: Scene, phi: Array) -> Call:
    tree = _Tree(scene, float(phi[0]))

    def run() -> Found:
        found = {f"{kind}{p}": np.zeros(len(phi), complex) for p in scene.points for kind in ("", "v_", "a_")}
        found["moment"] = np.zeros(len(phi))
        q = tree.start.copy()
        for k, angle in enumerate(phi):
            q[0] = angle
            q, jacobian = tree.closed(q)
            v, a = tree.rates(q, jacobian)
            found["moment"][k] = tree.moment(q, v, a, {p: f[k] for p, f in scene.forces.items()})
            for point, values in tree.points().items():
                for kind, value in zip(("", "v_", "a_"), values, strict=True):
                    found[kind + point][k] = value
        return found

    return run


class _Tree:
    """Joints: the crank; of every rod its pivot, then its slider or its rocker's pivot."""

    def __init__(self, scene: Scene, phi: float) -> None:
        import pinocchio as pin

        self.pin, self.scene, self.model = pin, scene, pin.Model()
        self.model.gravity.linear = np.array([0.0, scene.gravity, 0.0])
        crank = self.model.addJoint(0, pin.JointModelRZ(), pin.SE3.Identity(), "crank")
        self.carriers: dict[str, tuple[int, float]] = {"A": (crank, scene.crank)}
        self.ends: dict[str, int] = {}
        at = starts(scene, phi)
        turns, start, self.loops = {"A": phi}, [phi], []
        for rod in scene.rods:
            parent, where = self.carriers[rod.start]
            joint = self.model.addJoint(parent, pin.JointModelRZ(), self._at(where), f"to {rod.end}")
            self._mass(joint, rod.mass, rod.at(rod.centre), rod.inertia)
            total = float(np.angle(at[rod.end] - at[rod.start]))
            turns |= dict.fromkeys((rod.end, *rod.points), total)
            self.carriers |= {point: (joint, rod.at(point)) for point in (rod.end, *rod.points)}
            if isinstance(rod.out, Slider):
                other, far, value = self._slider(rod.end, rod.out), 0.0, at[rod.end].real
            else:
                other = self.model.addJoint(0, pin.JointModelRZ(), self._at(rod.out.pivot), f"at {rod.end}")
                self._mass(other, 0.0, 0.0, rod.out.inertia)
                far, value = rod.out.length, float(np.angle(at[rod.end] - rod.out.pivot))
            start += [total - turns[rod.start], value]
            self.ends[rod.end] = other
            self.loops.append((joint, self._at(rod.length), other, self._at(far)))
        self.start = np.array(start)
        self.data = self.model.createData()
        kind = pin.PointAnchorConstraintModel
        self.constraints = [kind(self.model, *loop) for loop in self.loops]
        self.constraint_data = [c.createData() for c in self.constraints]
        self.nothing = np.zeros(self.model.nv)
        self.outer = pin.StdVec_Force()
        self.outer.extend([pin.Force.Zero() for _ in range(self.model.njoints)])
        self.places = {point: (joint, self._at(arm)) for point, (joint, arm) in self.carriers.items()}

    def _at(self, place: complex) -> Any:
        return self.pin.SE3(np.eye(3), np.array([complex(place).real, complex(place).imag, 0.0]))

    def _mass(self, joint: int, mass: float, centre: float, inertia: float) -> None:
        about = np.diag([0.0, 0.0, inertia])
        self.model.appendBodyToJoint(
            joint, self.pin.Inertia(mass, np.array([centre, 0.0, 0.0]), about), self.pin.SE3.Identity()
        )

    def _slider(self, end: str, out: Slider) -> int:
        joint = int(self.model.addJoint(0, self.pin.JointModelPX(), self._at(1j * out.offset), f"at {end}"))
        self._mass(joint, out.mass, 0.0, 0.0)
        return joint

    def _calc(self, q: Array, v: Array) -> tuple[Array, Array]:
        """Rows of the constraints in the plane: their Jacobian, and their acceleration at no joint acceleration."""
        pin = self.pin
        pin.forwardKinematics(self.model, self.data, q, v, self.nothing)
        pin.computeJointJacobians(self.model, self.data, q)
        rows, drift = [], []
        for model, data in zip(self.constraints, self.constraint_data, strict=True):
            model.calc(self.model, self.data, data)
            rows.append(model.jacobian(self.model, self.data, data)[:2])
            drift.append(data.constraint_acceleration_error[:2])
        return np.concatenate(rows), np.concatenate(drift)

    def closed(self, q: Array) -> tuple[Array, Array]:
        """Newton on the loops, the crank's angle kept; with the Jacobian there."""
        for _ in range(ITERATIONS):
            jacobian, _ = self._calc(q, self.nothing)
            miss = np.concatenate([d.constraint_position_error[:2] for d in self.constraint_data])
            if np.max(np.abs(miss)) < CLOSED * self.scene.crank:
                return q, jacobian
            step = np.concatenate([[0.0], -np.linalg.solve(jacobian[:, 1:], miss)])
            if np.max(np.abs(step)) < 1e-15:
                return q, jacobian
            q = self.pin.integrate(self.model, q, step)
        raise Refused(
            f"Newton has not closed the loops in {ITERATIONS} steps (left: {np.max(np.abs(miss)):.1e} m)"
        )

    def rates(self, q: Array, jacobian: Array) -> tuple[Array, Array]:
        """Velocities and accelerations of all joints at the crank's constant speed."""
        omega = self.scene.omega
        v = np.concatenate([[omega], np.linalg.solve(jacobian[:, 1:], -jacobian[:, 0] * omega)])
        jacobian, drift = self._calc(q, v)
        a = np.concatenate([[0.0], np.linalg.solve(jacobian[:, 1:], -drift)])
        self.jacobian = jacobian
        return v, a

    def moment(self, q: Array, v: Array, a: Array, forces: dict[str, float]) -> float:
        """Inverse dynamics of the tree; the constraints' forces from the joints that have no drive."""
        for point, force in forces.items():
            self.outer[self.ends[point]] = self.pin.Force(np.array([force, 0.0, 0.0]), np.zeros(3))
        needed = self.pin.rnea(self.model, self.data, q, v, a, self.outer)
        held = np.linalg.solve(self.jacobian[:, 1:].T, needed[1:])
        self.pin.forwardKinematics(self.model, self.data, q, v, a)
        return float(needed[0] - self.jacobian[:, 0] @ held)

    def points(self) -> dict[str, tuple[complex, ...]]:
        """Place, velocity, acceleration of every point at what was given to forwardKinematics last."""
        frame, found = self.pin.LOCAL_WORLD_ALIGNED, {}
        for point, (joint, at) in self.places.items():
            place = self.data.oMi[joint].act(at.translation)
            rates = [
                kind(self.model, self.data, joint, at, frame).linear
                for kind in (self.pin.getFrameVelocity, self.pin.getFrameClassicalAcceleration)
            ]
            found[point] = tuple(complex(x[0], x[1]) for x in (place, *rates))
        return found


PEER = Peer("pinocchio", "pin", prepare)
