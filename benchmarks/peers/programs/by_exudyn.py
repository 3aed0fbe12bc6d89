"""exudyn: rigid bodies in the plane with maximal coordinates, joints as constraints, integrated in time.

Its documentation (examples SliderCrank.py): ObjectRigidBody2D, ObjectJointRevolute2D, a slider as MassPoint2D held by a
CoordinateConstraint, generalized-alpha of index 3. The crank is turned by a ConnectorCoordinate with
`offsetUserFunction` (symbolic, so that no Python is called), whose multiplier is the moment of the drive; forces are
set in `PreStepUserFunction`, once a step. It starts from consistent places and velocities. `steps` to a position;
sensors keep every position asked for.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from benchmarks.peers.peer import Array, Call, Found, Peer, Refused
from benchmarks.peers.scene import Rocker, Scene, Slider, starts


def prepare(scene: Scene, phi: Array, steps: int = 100, index2: bool = False) -> Call:
    """`index2`: trapezoidal rule with constraints of velocities, the example's other way; else generalized-alpha."""
    os.environ.setdefault("EXUDYN_MODULE", "fast")  # its build without checks of ranges
    import exudyn as exu

    model = _Model(scene, phi)
    settings, span = exu.SimulationSettings(), abs((phi[-1] - phi[0]) / scene.omega)
    time = settings.timeIntegration
    time.numberOfSteps, time.endTime = steps * (len(phi) - 1), span
    time.newton.relativeTolerance, time.newton.absoluteTolerance = 1e-10, 1e-13
    time.newton.useModifiedNewton = True
    time.generalizedAlpha.spectralRadius = 0.5  # both of the example
    time.generalizedAlpha.useNewmark = time.generalizedAlpha.useIndex2Constraints = index2
    time.generalizedAlpha.computeInitialAccelerations = True
    time.verboseMode = 0
    solution = settings.solutionSettings
    solution.writeSolutionToFile = False
    solution.sensorsWritePeriod = span / (len(phi) - 1)

    def run() -> Found:
        try:
            model.set_loads(model.mbs, 0.0)
            model.mbs.SolveDynamic(settings)
        except Exception as error:
            raise Refused(str(error).strip().splitlines()[-1]) from error
        return model.found(len(phi))

    return run


class _Model:
    """The assembled system and its sensors."""

    def __init__(self, scene: Scene, phi: Array) -> None:
        import exudyn as exu
        from exudyn import itemInterface as item

        self.item, self.kinds = item, exu.OutputVariableType
        self.container = exu.SystemContainer()
        self.mbs = self.container.AddSystem()
        self.scene, self.at = scene, starts(scene, float(phi[0]))
        self.times = np.abs((phi - phi[0]) / scene.omega)
        self.sensors: dict[str, Any] = {}
        self.loads: dict[str, Any] = {}
        self.kept: list[Any] = []
        self.frame = self.mbs.AddObject(item.ObjectGround())
        self.ground = self.mbs.AddNode(item.NodePointGround())
        self.none = self.mbs.AddMarker(item.MarkerNodeCoordinate(nodeNumber=self.ground, coordinate=0))
        carriers = {"A": self._crank(float(phi[0]))}
        for rod in scene.rods:
            arm = self.at[rod.end] - self.at[rod.start]
            own, turn = rod.at(rod.centre), float(np.angle(arm))
            along = arm / rod.length * own
            w = self.at[f"w_{rod.end}"].real
            speed = self.at[f"v_{rod.start}"] + 1j * w * along
            body, _ = self._body(rod.mass, rod.inertia, self.at[rod.start] + along, turn, speed, w)
            self._weight(body, rod.mass)
            self._pin(carriers[rod.start], (body, -own))
            carriers |= {point: (body, rod.at(point) - own) for point in (rod.end, *rod.points)}
            self._out(rod.end, rod.out, carriers)
        for point in scene.points:
            self._watch(point, *carriers[point])
        if self.loads:
            self.mbs.SetPreStepUserFunction(self.set_loads)
        self.mbs.Assemble()

    def _body(
        self, mass: float, inertia: float, at: complex, turn: float, v: complex, w: float
    ) -> tuple[Any, Any]:
        start, speed = [at.real, at.imag, turn], [v.real, v.imag, w]
        node = self.mbs.AddNode(
            self.item.NodeRigidBody2D(referenceCoordinates=start, initialVelocities=speed)
        )
        body = self.item.ObjectRigidBody2D(physicsMass=mass, physicsInertia=inertia, nodeNumber=node)
        return self.mbs.AddObject(body), node

    def _crank(self, phi: float) -> tuple[Any, float]:
        omega = self.scene.omega
        body, node = self._body(0.0, 0.0, 0j, phi, 0j, omega)
        self._pin((self.frame, 0j), (body, 0.0))
        turn = self.mbs.AddMarker(self.item.MarkerNodeCoordinate(nodeNumber=node, coordinate=2))
        drive = self.item.ObjectConnectorCoordinate(
            markerNumbers=[self.none, turn],
            offset=1.0,
            offsetUserFunction=self._symbolic(lambda mbs, t, itemNumber, lOffset: omega * t, ""),
            offsetUserFunction_t=self._symbolic(lambda mbs, t, itemNumber, lOffset: omega + 0 * t, "_t"),
        )
        self._sense(
            "moment", self.item.SensorObject, self.kinds.Force, objectNumber=self.mbs.AddObject(drive)
        )
        return body, self.scene.crank

    def _symbolic(self, function: Any, rate: str) -> Any:
        """A function of time that the solver evaluates without Python; kept alive as its documentation asks."""
        from exudyn.advancedUtilities import CreateSymbolicUserFunction

        name, kind = f"offsetUserFunction{rate}", "ObjectConnectorCoordinate"
        made = CreateSymbolicUserFunction(self.mbs, function, name, itemTypeName=kind)
        self.kept.append(made)
        return made

    def _out(self, end: str, out: Slider | Rocker, carriers: dict[str, Any]) -> None:
        at, v = self.at[end], self.at[f"v_{end}"]
        if isinstance(out, Rocker):
            arm = at - out.pivot
            w = float((v / (1j * arm)).real)
            body, _ = self._body(0.0, out.inertia, out.pivot, float(np.angle(arm)), 0j, w)
            self._pin((self.frame, out.pivot), (body, 0.0))
            self._pin(carriers[end], (body, out.length))
            return
        node = self.mbs.AddNode(
            self.item.NodePoint2D(referenceCoordinates=[at.real, at.imag], initialVelocities=[v.real, v.imag])
        )
        mass = self.mbs.AddObject(self.item.ObjectMassPoint2D(physicsMass=out.mass, nodeNumber=node))
        self._pin(carriers[end], (mass, 0.0))
        across = self.mbs.AddMarker(self.item.MarkerNodeCoordinate(nodeNumber=node, coordinate=1))
        self.mbs.AddObject(self.item.ObjectConnectorCoordinate(markerNumbers=[self.none, across]))
        self._load(end, mass, out.mass)

    def _load(self, end: str, body: Any, mass: float) -> None:
        marker = self.mbs.AddMarker(self.item.MarkerBodyPosition(bodyNumber=body))
        if end in self.scene.forces:
            load = self.mbs.AddLoad(
                self.item.LoadForceVector(markerNumber=marker, loadVector=[0.0, 0.0, 0.0])
            )
            self.loads[end] = load
        self._weight(body, mass)

    def set_loads(self, mbs: Any, t: float) -> bool:
        """Forces at the end of a step, between two positions in proportion."""
        at = t / self.times[1]
        k = min(int(at), len(self.times) - 2)
        for end, load in self.loads.items():
            before, after = self.scene.forces[end][k : k + 2]
            mbs.SetLoadParameter(load, "loadVector", [float(before + (after - before) * (at - k)), 0.0, 0.0])
        return True

    def _weight(self, body: Any, mass: float) -> None:
        if self.scene.gravity and mass:
            marker = self.mbs.AddMarker(self.item.MarkerBodyMass(bodyNumber=body))
            self.mbs.AddLoad(
                self.item.LoadMassProportional(markerNumber=marker, loadVector=[0.0, self.scene.gravity, 0.0])
            )

    def _pin(self, one: tuple[Any, complex], other: tuple[Any, complex]) -> None:
        markers = [
            self.mbs.AddMarker(
                self.item.MarkerBodyPosition(
                    bodyNumber=body, localPosition=[complex(at).real, complex(at).imag, 0.0]
                )
            )
            for body, at in (one, other)
        ]
        self.mbs.AddObject(self.item.ObjectJointRevolute2D(markerNumbers=markers))

    def _watch(self, point: str, body: Any, at: float) -> None:
        for kind, name in (("", "Position"), ("v_", "Velocity"), ("a_", "Acceleration")):
            where = {"bodyNumber": body, "localPosition": [at, 0.0, 0.0]}
            self._sense(kind + point, self.item.SensorBody, getattr(self.kinds, name), **where)

    def _sense(self, name: str, kind: Any, output: Any, **where: Any) -> None:
        self.sensors[name] = self.mbs.AddSensor(
            kind(**where, storeInternal=True, writeToFile=False, outputVariableType=output)
        )

    def found(self, count: int) -> Found:
        """The kept values of every sensor; fewer than asked for are a refusal."""
        rows = {name: self.mbs.GetSensorStoredData(sensor) for name, sensor in self.sensors.items()}
        if any(len(row) < count for row in rows.values()):
            raise Refused(f"stopped after {min(map(len, rows.values()))} positions")
        return {
            name: -row[:count, 1] if name == "moment" else row[:count, 1] + 1j * row[:count, 2]
            for name, row in rows.items()
        }


PEER = Peer(
    "exudyn",
    "exudyn",
    prepare,
    {f"{n} steps a position": {"steps": n} for n in (10, 100)}
    | {f"index 2, {n} steps a position": {"steps": n, "index2": True} for n in (10, 100)},
)
